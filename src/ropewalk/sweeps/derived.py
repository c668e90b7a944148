"""What a sweep can keep besides what a run records: quantities that are made from recorded ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Layout
from ropewalk.record.body_loads import body_loads
from ropewalk.record.contacts import WrapHistory, wrap_history
from ropewalk.record.extremes import shares
from ropewalk.record.parted import count_parted
from ropewalk.record.pressed_rows import loads_of_steps
from ropewalk.record.quantities import labels
from ropewalk.record.result import Result
from ropewalk.scene import Scene


@dataclass(frozen=True)
class Derived:
    """A quantity made from recorded ones: (time, ...) with dimensions, unit and a name in words."""

    dims: tuple[str, ...]
    unit: str
    long_name: str
    of: Callable[[Result], Floats]
    of_steps: Callable[[Result, Floats], Floats] = lambda _, array: array  # of what steps reached


def _safety(result: Result, tension: Floats) -> Floats:
    """Return breaking loads over tensions, (frames, segments) [1]; inf where nothing pulls."""
    use = shares(result, tension)
    found = np.where(np.isnan(use), np.nan, np.inf)
    np.divide(1.0, use, out=found, where=use > 0.0)
    return found


def _stretch(result: Result) -> Floats:
    length = np.linalg.norm(np.diff(result.positions, axis=1), axis=2)
    found: Floats = np.full_like(length, np.nan)
    np.divide(length, result.rest_length, out=found, where=result.live)
    return found


def _sag(result: Result) -> Floats:
    """Largest drop of each rope below the straight line between its ends, along gravity.

    What lies beyond an end, seen from above, is measured from that end: a line that is nearly upright
    would come from far above.
    """
    up = np.asarray(result.scene.up)
    found = np.zeros((result.frames, len(result.layout.ropes)))
    for column, span in enumerate(result.layout.ropes):
        points = result.positions[:, span.first : span.last + 1]  # with what winches pay out
        from_first = points - points[:, :1]
        heights = from_first @ up
        level = from_first - heights[..., None] * up
        end = level[:, -1]
        across2 = (end**2).sum(axis=1)
        rise = heights[:, -1]
        upright = across2 <= 1e-18 * (from_first[:, -1] ** 2).sum(axis=1)
        share = np.einsum("fni,fi->fn", level, end) / np.where(upright, 1.0, across2)[:, None]
        share = np.clip(share, 0.0, 1.0)
        chord = np.where(upright[:, None], np.minimum(rise, 0.0)[:, None], share * rise[:, None])
        found[:, column] = np.maximum((chord - heights).max(axis=1), 0.0)
    return found


def _parted(result: Result) -> Floats:
    return count_parted(result.partings, result.time, result.plan.method).astype(np.float64)


#: Dimensions along which values have names of their own, and stay apart in tables.
BY_LABEL = ("anchor", "rope", "obstacle", "pulley", "wrap")


def names_along(layout: Layout, scene: Scene) -> dict[str, tuple[str, ...]]:
    """Return the names along the dimensions that are counted by names, of recorded and derived quantities.

    A wrap is that of a rope on an obstacle, by the obstacle's name; of several ropes `rope on obstacle`.
    """
    ropes = tuple(span.name for span in layout.ropes)
    bodies = tuple(body.name for body in scene.obstacles)
    alone = len(ropes) == 1
    wraps = tuple(body if alone else f"{rope} on {body}" for rope in ropes for body in bodies)
    return labels(layout) | {"rope": ropes, "obstacle": bodies, "wrap": wraps}


def _obstacle_load(result: Result) -> Floats:
    names = [body.name for body in result.scene.obstacles]
    return body_loads(result, range(result.frames), _some(names, "obstacle"))


def _axle_load(result: Result) -> Floats:
    names = _some(result.layout.pulleys, "obstacle that turns freely")
    return body_loads(result, range(result.frames), names)


def _obstacle_load_of_steps(result: Result, force: Floats) -> Floats:
    names = [body.name for body in result.scene.obstacles]
    return loads_of_steps(result, force, _some(names, "obstacle"))


def _axle_load_of_steps(result: Result, force: Floats) -> Floats:
    names = _some(result.layout.pulleys, "obstacle that turns freely")
    return loads_of_steps(result, force, names)


def _wraps(result: Result, of: Callable[[WrapHistory], Floats]) -> Floats:
    """Return something of all wraps, (frames, wraps); one rope's on all obstacles after another's."""
    bodies = _some([body.name for body in result.scene.obstacles], "obstacle")
    each = [
        of(wrap_history(result, span.name, body)) for span in result.layout.ropes for body in bodies
    ]
    return np.stack(each, axis=1)


def _some(names: Sequence[str], what: str) -> Sequence[str]:
    if not names:
        raise KeyError(f"the runs have no {what}")
    return names


def _larger_over_smaller(wrap: WrapHistory) -> Floats:
    """Return ratios, (frames,) [1]; NaN where either side pulls nothing, as where a rope's end lies there."""
    ratio, found = wrap.ratio, np.full_like(wrap.ratio, np.nan)
    both = ratio > 0.0
    found[both] = np.fmax(ratio[both], 1.0 / ratio[both])
    return found


DERIVED: dict[str, Derived] = {
    "speed": Derived(
        ("time", "node"), "m/s", "speed", lambda r: np.linalg.norm(r.velocities, axis=2)
    ),
    "height": Derived(
        ("time", "node"), "m", "height along up", lambda r: r.positions @ np.asarray(r.scene.up)
    ),
    "stretch": Derived(("time", "segment"), "1", "length over unstretched length", _stretch),
    "utilisation": Derived(
        ("time", "segment"),
        "1",
        "tension over breaking load",
        lambda r: shares(r, r.tension),
        shares,
    ),
    "safety_factor": Derived(
        ("time", "segment"),
        "1",
        "breaking load over tension",
        lambda r: _safety(r, r.tension),
        _safety,
    ),
    "sag": Derived(("time", "rope"), "m", "drop below the line between the rope's ends", _sag),
    "total_energy": Derived(("time",), "J", "total energy", lambda r: r.energy["total"]),
    "energy_error": Derived(
        ("time",),
        "J",
        "size of the energy that no law accounts for",
        lambda r: np.abs(r.energy_error),
    ),
    "segments_parted": Derived(("time",), "1", "segments that have parted so far", _parted),
    "obstacle_load": Derived(
        ("time", "obstacle"),
        "N",
        "force of the ropes on an obstacle, without its own weight",
        _obstacle_load,
        _obstacle_load_of_steps,
    ),
    "axle_load": Derived(
        ("time", "pulley"),
        "N",
        "force of the ropes on the axle of a pulley, without its own weight",
        _axle_load,
        _axle_load_of_steps,
    ),
    "wrap_angle": Derived(
        ("time", "wrap"),
        "rad",
        "angle by which a rope turns on an obstacle",
        lambda r: _wraps(r, lambda wrap: wrap.angle),
    ),
    "wrap_ratio": Derived(
        ("time", "wrap"),
        "1",
        "larger tension over the smaller one beside what of a rope lies on an obstacle",
        lambda r: _wraps(r, _larger_over_smaller),
    ),
}
