"""What a frame tells of contacts: forces of obstacles and of ropes, wraps, and what friction has done."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.lowering import Layout
from ropewalk.record.contacts import Lying, lying, seen_at, touching
from ropewalk.record.quantities import has_rope
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import Block
from ropewalk.simulation.rope_contacts import slots

MOST_PAIRS = 100  # contacts of ropes on ropes in a frame: the strongest
MOST_WRAPS = 12  # stretches of ropes on obstacles in a frame: those that carry most
PAIR, WRAP = 5, 8  # numbers of each
_RUB, _MOTOR = ENTRIES.index("friction"), ENTRIES.index("motor")
_STRAIGHT = 1e-3  # [rad] a rope that turns by less lies straight
_MOST = 1e30  # of the ratio at slip, which a rope wound many times has beyond all numbers
_OFTEN = 0.1  # [s] between two looks for wraps while it plays ...
_SHARE = 20.0  # ... and so many times what the last one took


class Room(NamedTuple):
    """How much of it a variant's frames hold."""

    forces: bool = False  # of obstacles, on every node
    pairs: int = 0
    wraps: int = 0
    surfaces: int = 0


NO_ROOM = Room()


class Touch(NamedTuple):
    """What ropes touch at one time. Rows that are not in use begin with -1."""

    force: Floats | None  # (n, 3) of obstacles on nodes [N]; None where there are none
    pairs: (
        Floats  # (p, 5) place on each of two ropes: segment and share of it; force on the first [N]
    )
    # (w, 8) rope, obstacle, first and last node, angle [rad], tensions before and after [N], and the
    # logarithm of their ratio at slip [1]
    wraps: Floats
    rubbed: (
        Floats  # (k,) what friction of every surface has done on the ropes [J]; NaN where unknown
    )
    scalars: dict[str, float]

    @property
    def room(self) -> Room:
        """What it takes."""
        sizes = (len(self.pairs), len(self.wraps), len(self.rubbed))
        return Room(self.force is not None, *sizes)


NOTHING = Touch(None, np.zeros((0, PAIR)), np.zeros((0, WRAP)), np.zeros(0), {})


def wound_on(scene: Scene) -> list[int]:
    """Return the obstacles about which a rope can turn: all but planes."""
    return [o for o, body in enumerate(scene.obstacles) if body.kind != "plane"]


def room_of(scene: Scene, layout: Layout, *, pairs: bool = True) -> Room:
    """Return what frames of a scene hold; without `pairs` those of ropes on ropes are not known."""
    most = min(MOST_PAIRS, slots(layout.segments))
    return Room(
        bool(scene.obstacles),
        most if pairs and scene.contact is not None else 0,
        MOST_WRAPS if wound_on(scene) else 0,
        len(layout.surfaces),
    )


def pair_rows(kept: Floats, room: int) -> tuple[Floats, dict[str, float]]:
    """Return the strongest contacts of ropes, (room, 5), and how many there are with what force in all [N].

    `kept` (slots, 8) has a row for each, as `simulation.rope_contacts` writes them.
    """
    kept = kept[np.isfinite(kept[:, 0])]
    size = np.linalg.norm(kept[:, 5:8], axis=1)
    told = {"rope_contacts": float(len(kept)), "rope_contact_force": float(size.sum())}
    if len(kept) > room:
        kept = kept[np.sort(np.argsort(-size, kind="stable")[:room])]
    found = np.full((room, PAIR), -1.0)
    found[: len(kept), :2] = kept[:, :2] + np.clip(kept[:, 2:4], 0.0, 1.0)
    found[: len(kept), 2:] = kept[:, 5:8]
    return found, told


def wrap_rows(wraps: Sequence[Lying], room: int) -> tuple[Floats, float]:
    """Return the wraps that carry most, (room, 8), in the order of the ropes, and how many there are."""
    there = [wrap for wrap in wraps if wrap.angle > _STRAIGHT]
    strong = sorted(there, key=lambda wrap: -max(wrap.before, wrap.after))[:room]
    found = np.full((room, WRAP), -1.0)
    kept = sorted(strong, key=lambda wrap: (wrap.rope, wrap.first))
    for row, wrap in zip(found, kept, strict=False):
        row[:4] = wrap.rope, wrap.obstacle, wrap.first, wrap.last
        row[4:] = wrap.angle, wrap.before, wrap.after, math.log(min(wrap.at_slip, _MOST))
    return found, float(len(there))


class Wraps(NamedTuple):
    """Stretches of ropes on obstacles, and when they were found so [s]."""

    rows: tuple[Lying, ...] = ()
    time: float = 0.0


class WrapLook:
    """The wraps of a simulation that goes on, found no more often than they may cost."""

    def __init__(self) -> None:
        self._of: Simulation | None = None
        self._found = Wraps()
        self._next = 0.0  # on the clock [s]

    def of(self, simulation: Simulation, block: Block, *, playing: bool) -> Wraps:
        """Return the wraps of now; while it plays those that were found last, where that is not long ago."""
        now = time.perf_counter()
        fresh = self._found.time == simulation.time or (playing and now < self._next)
        if self._of is simulation and fresh:
            return self._found
        self._of, self._found = simulation, wraps_now(simulation, block)
        self._next = now + max(_OFTEN, _SHARE * (time.perf_counter() - now))
        return self._found


def wraps_now(simulation: Simulation, block: Block) -> Wraps:
    """Return the wraps of a simulation, of which `block` is the present frame."""
    scene, layout, state = simulation.scene, simulation.layout, simulation.arrays
    recording = block.recording
    force = recording.contact[0] if block.obstacles is None else block.obstacles[0]
    lengths = [rope.segment_length for rope in scene.ropes]
    there = has_rope(layout, state.rest_length[None], lengths)[0] & (state.stiffness > 0.0)
    wheels = recording.wheel[0] if layout.pulleys else None
    table, only, t = simulation.system.node.obstacle, wound_on(scene), simulation.time
    if not only or not force.any():
        return Wraps((), t)
    then, span = seen_at(simulation.model, t)  # as those of a recorded run
    contacts = touching(table, state.x, state.v, force, there, wheels, then, only, span)
    return Wraps(tuple(lying(scene, layout, contacts, recording.tension[0], only)), t)


def touch_now(simulation: Simulation, block: Block, wraps: Wraps | None, rubbed: Floats) -> Touch:
    """Return what ropes of a simulation touch; `wraps` None where they are not to be told.

    `block` is the present frame, `rubbed` what friction of every surface has done [J].
    """
    room = room_of(simulation.scene, simulation.layout)
    force = block.recording.contact[0] if block.obstacles is None else block.obstacles[0]
    pairs = None if block.pairs is None else block.pairs[0]
    return touch_of(room, force.T, pairs, wraps, simulation.time, rubbed)


def touch_of(
    room: Room,
    force: Floats,
    pairs: Floats | None,
    wraps: Wraps | None,
    time: float,
    rubbed: Floats,
) -> Touch:
    """Return what there is room for, of forces (n, 3) [N], contacts (slots, 8), wraps and friction's work."""
    told: dict[str, float] = {}
    rows = np.full((room.pairs, PAIR), -1.0)
    if room.pairs and pairs is not None:
        rows, told = pair_rows(pairs, room.pairs)
    turned, told["wraps"] = wrap_rows(() if wraps is None else wraps.rows, room.wraps)
    told["wrap_age"] = 0.0 if wraps is None else time - wraps.time
    return Touch(force if room.forces else None, rows, turned, rubbed, told)


class Rubbed:
    """What friction of each surface has done on ropes since a session began [J]."""

    def __init__(self, simulation: Simulation) -> None:
        """Begin now."""
        self._before = simulation.recording().recording.books[0].copy()

    def until(self, simulation: Simulation, books: Floats) -> Floats:
        """Return it by surface, (k,), from the present books; NaN without a ledger."""
        count = len(simulation.layout.surfaces)
        if not simulation.ledger:
            return np.full(count, np.nan)
        found: Floats = books[:count, _RUB] - self._before[:count, _RUB]
        return found

    def taken(self, simulation: Simulation, books: Floats) -> float:
        """Return what friction has taken until now of what the ropes had [J], from the present books."""
        count = len(simulation.layout.surfaces)
        bodies = len(simulation.scene.obstacles)
        return float(taken_by(books[:count] - self._before[:count], bodies))


def taken_by(books: Floats, bodies: int) -> Floats:
    """Return what friction has taken of what ropes had [J], (...), of books of surfaces (..., k, 5).

    Of obstacles without what their motors give where that is less: what lies still on a belt loses nothing.
    """
    rub, motor = books[..., _RUB], books[..., _MOTOR]
    on_bodies = rub[..., :bodies].sum(axis=-1)
    driven = on_bodies + motor[..., :bodies].sum(axis=-1)
    least = np.minimum(np.abs(on_bodies), np.abs(driven))
    found: Floats = np.maximum(least, np.abs(rub[..., bodies:].sum(axis=-1)))
    return found
