"""What a frame shows of a running track."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.audience import Combine
from ropewalk.live.counterparts import counterparts
from ropewalk.live.energy_off import weigh
from ropewalk.live.frame import Picture, Shape, combined, turns_of
from ropewalk.live.seen import Seen
from ropewalk.live.touch import WrapLook, Wraps, room_of, touch_now
from ropewalk.live.track import Track
from ropewalk.lowering.elastic_tables import put_under_tension
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block


class Compared:
    """Where nodes of further variants lie among those of the first, and its wraps; kept while it holds."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, int], Floats | None] = {}
        self.look = WrapLook()  # of the first variant

    def source(self, first: Simulation, other: Simulation) -> Floats | None:
        """Return places of the nodes of `other` among those of `first`; None where they are the same."""
        key = (id(first.layout), id(other.layout))
        if key not in self._known:
            if len(self._known) > 100:
                self._known.clear()
            same = [(s.start, s.nodes) for s in first.layout.ropes] == [
                (s.start, s.nodes) for s in other.layout.ropes
            ]
            self._known[key] = None if same else counterparts(other, first)
        return self._known[key]


def combiner(tracks: Sequence[Track]) -> Combine:
    """Return what combines two frames of these tracks, the older of which was not sent."""
    return partial(combined, [shape_of(track) for track in tracks])


def shape_of(track: Track) -> Shape:
    """Return what a track's frames hold."""
    layout = track.simulation.layout
    touch = room_of(track.simulation.scene, layout)
    return Shape(layout.nodes, len(layout.anchor_names), touch)


def pictures(
    tracks: Sequence[Track], compared: Compared, *, playing: bool = False
) -> list[Picture]:
    """Return the pictures of all variants; wraps are told of the first, while it plays a little late."""
    look = partial(compared.look.of, playing=playing)
    first = picture(tracks[0], look=look)
    main = tracks[0].simulation
    more = [picture(track, first, compared.source(main, track.simulation)) for track in tracks[1:]]
    return [first, *more]


def picture(
    track: Track,
    first: Picture | None = None,
    source: Floats | None = None,
    look: Callable[[Simulation, Block], Wraps] | None = None,
) -> Picture:
    """Return the picture of a track now.

    Args:
        track: what to show.
        first: the picture of the first variant, to measure the difference to.
        source: for each node of this variant, where it lies among the nodes of the first.
        look: finds its wraps; without it none are told.
    """
    simulation = track.simulation
    block = simulation.recording()
    recording, wraps = block.recording, look(simulation, block) if look else None
    state = simulation.arrays
    positions, speed = state.x.T, np.sqrt(np.einsum("kn,kn->n", state.v, state.v))
    live = (state.stiffness > 0.0) & (state.rest_length >= 0.0)
    tension = np.where(live, recording.tension[0], 0.0)
    energy = recording.energy[0]
    lost, put_in, error = track.books(recording)
    weigh(track, recording)
    heights = positions @ np.array(track.scene.up)
    now = Seen.instant(tension, speed, heights, recording.reaction[0])
    seen = track.shown.widened(now, live)
    scalars = {
        "time": simulation.time,
        "dt": track.dt,
        "kinetic": float(energy[0]),
        "gravity": float(energy[1]) - track.first_gravity,
        "elastic": float(energy[2:].sum()),
        "lost": lost,
        "put_in": put_in,
        "energy_error": error,
        **track.balance.scalars,
        "tension_max": float(seen.greatest_tension.max(initial=0.0)),
        "strain_max": _largest_strain(simulation, recording.elastic_tension[0]),
        "low": float(seen.least_height.min()),
        "high": float(seen.greatest_height.max()),
        "touching": _touching(simulation, heights),
        **turns_of(recording.wheel[0]),
    }
    if first is not None:
        late = first.scalars["time"] - simulation.time  # its steps may end a little before
        scalars |= _difference(positions + late * state.v.T, first.positions, source)
    held = state.held.astype(np.float64)
    anchors = np.concatenate(
        [state.anchor_x, state.anchor_v, recording.reaction[0], held[:, None]], axis=1
    )
    rubbed = track.rubbed.until(simulation, recording.books[0])
    touch = touch_now(simulation, block, wraps, rubbed)
    return Picture(scalars, positions, tension, speed, anchors, track.hands.grabs, seen, touch)


def _largest_strain(simulation: Simulation, tension: Floats) -> float:
    state = simulation.arrays
    alive = state.stiffness * state.rest_length > 0.0
    strain, soft = np.zeros_like(tension), np.zeros_like(tension)
    stiff = state.stiffness[alive] * state.rest_length[alive]
    strain[alive] = tension[alive] / stiff
    if simulation.system.elastic.time.size:
        stretch = strain * state.rest_length
        put_under_tension(simulation.system, state, tension, stretch, soft)
        strain[alive] = stretch[alive] / state.rest_length[alive]
    return float(strain.max(initial=0.0))


def _touching(simulation: Simulation, heights: Floats) -> float:
    ground = simulation.system.node.ground
    return float(np.count_nonzero(heights < ground.height)) if ground.active else 0.0


def _difference(here: Floats, there: Floats, source: Floats | None) -> dict[str, float]:
    if source is not None:
        low = np.floor(source).astype(np.int64)
        share = (source - low)[:, None]
        high = np.minimum(low + 1, len(there) - 1)
        there = there[low] * (1.0 - share) + there[high] * share
    if there.shape != here.shape:
        return {"difference": float("nan"), "difference_max": float("nan")}
    away = np.linalg.norm(here - there, axis=1)
    return {
        "difference": float(np.sqrt((away**2).mean())),
        "difference_max": float(away.max(initial=0.0)),
    }
