"""What can be measured of a rope, and what a scene gives in its place.

Every measurement says what it needs of the runs (`keep`) or of the equilibria (`rest`), or works on the scene
itself, and returns the values that the scene predicts where numbers were measured.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ropewalk.core.arrays import Floats
from ropewalk.lowering import build
from ropewalk.lowering.layout import make_layout
from ropewalk.record.errors import InputError, RunError
from ropewalk.scene import Material, Scene
from ropewalk.scene.sheet_numbers import given
from ropewalk.sweeps.keep import parse
from ropewalk.sweeps.whole import refuse_unless_whole
from ropewalk.words.nearest import nearest

AXES = "xyz"


@dataclass(frozen=True)
class Measurement:
    """Numbers that were measured, in one unit; `error` is their standard deviation, None: not known."""

    name: str
    unit: str
    values: Floats  # (m,)
    error: float | None = None
    keep: tuple[str, ...] = ()  # of runs
    rest: tuple[str, ...] = ()  # of equilibria
    at: Floats | None = None  # (m,) where or when, for the plot
    at_name: str = "number"

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        """Return what one run (or equilibrium) of `scene` gives in place of `values`, (m,)."""
        raise NotImplementedError


def _array(name: str, values: ArrayLike) -> Floats:
    """Return plain numbers as an array. Raises InputError for texts, and for numbers with units."""
    try:
        found = np.asarray(values)
        if found.dtype.kind in "biuf" and not hasattr(values, "dimensionality"):
            return found.astype(np.float64)
    except (TypeError, ValueError):
        pass
    raise InputError(name, values, "must be plain numbers, in SI units")


def _numbers(name: str, values: ArrayLike) -> Floats:
    found = np.atleast_1d(_array(name, values))
    if not found.size or not np.isfinite(found).all():
        raise InputError(name, values, "must be finite numbers, at least one")
    return found


def _nodes_of(name: str, scene: Scene, rope: str | None) -> slice:
    """Return where the nodes of the measured rope lie among all; of several it needs a name."""
    names = [one.name for one in scene.ropes]
    if rope is None and len(names) > 1:
        rule = f"must name one of the scene's ropes, {', '.join(names)}"
        raise InputError(f"{name}.rope", None, rule)
    if rope is not None and rope not in names:
        raise InputError(f"{name}.rope", rope, f"there is no such rope; {nearest(rope, names)}")
    span = make_layout(scene).span(rope)
    return slice(span.start, span.end + 1)


def _error(name: str, error: float | None) -> float | None:
    plain = isinstance(error, int | float | np.number) and not isinstance(error, bool)
    if error is not None and not (plain and 0.0 < error < np.inf):
        raise InputError(
            f"{name}.error", error, "must be a positive standard deviation, or left out"
        )
    return error


@dataclass(frozen=True)
class _Kept(Measurement):
    """Whatever a sweep can keep of a run or an equilibrium, as one number."""

    variable: str = ""

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        found = np.ravel((kept if self.keep else rest)[self.variable])
        if found.size not in (1, self.values.size):
            rule = (
                f"the scene gives {found.size} numbers for it: measure as many, or keep one of them"
            )
            raise InputError(self.name, f"{self.values.size} measured", rule)
        return np.broadcast_to(found, self.values.shape)  # one may be measured often


def kept(
    what: str, values: ArrayLike, error: float | None = None, *, rest: bool = False
) -> Measurement:
    """Numbers of anything that a sweep keeps, such as "tension.max" [N] or "reactions.max" [N].

    As many as the scene gives for it; of what is one number, several are measured again and again.
    """
    asked = parse(what)
    keep, at_rest = ((), (what,)) if rest else ((what,), ())
    found = np.ravel(_numbers(what, values))
    return _Kept(what, asked.unit, found, _error(what, error), keep, at_rest, variable=asked.name)


def sag(values: ArrayLike, error: float | None = None) -> Measurement:
    """Sag of the hanging rope at rest below the line between its ends [m], measured once or often."""
    found = _numbers("sag", values)
    return _Kept("sag", "m", found, _error("sag", error), rest=("sag[-1]",), variable="sag_last")


@dataclass(frozen=True)
class _Droop(Measurement):
    node: int = -1
    rope: str | None = None

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        heights = rest["positions_last"] @ np.asarray(scene.up)
        heights = heights[_nodes_of("droop", scene, self.rope)]
        if not -len(heights) <= self.node < len(heights):
            rule = f"there is no such node: there are {len(heights)}, from 0 or from the end, -1"
            raise InputError("droop.node", self.node, rule)
        return np.full(self.values.shape, heights[0] - heights[self.node])


def droop(
    values: ArrayLike, error: float | None = None, *, node: int = -1, rope: str | None = None
) -> Measurement:
    """How far a node hangs at rest below the rope's first one [m], as of an overhanging clamped rope.

    Of several ropes in the scene `rope` names the one.
    """
    found = _numbers("droop", values)
    refuse_unless_whole("droop.node", node)
    return _Droop(
        "droop", "m", found, _error("droop", error), rest=("positions[-1]",), node=node, rope=rope
    )


@dataclass(frozen=True)
class _PullTest(Measurement):
    forces: Floats | None = None
    length: float | None = None  # [m] of the piece that was pulled
    rope: str | None = None

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        names = [rope.name for rope in scene.ropes]
        if self.rope is not None and self.rope not in names:
            raise InputError(
                "pull_test.rope", self.rope, f"there is no such rope; {nearest(self.rope, names)}"
            )
        rope = scene.ropes[0] if self.rope is None else scene.rope_named(self.rope)
        if not isinstance(rope.made_of, Material):
            raise InputError("pull_test", rope.name, "needs a rope of a material (EA)")
        assert self.forces is not None
        size = rope.length_unstretched if self.length is None else self.length
        curve = rope.made_of.curve
        if curve is not None:
            return np.asarray(curve.strain_at(self.forces) * size)
        return self.forces * size / rope.made_of.EA


def pull_test(
    forces: ArrayLike,
    elongations: ArrayLike,
    error: float | None = None,
    *,
    length: float | str | None = None,
    rope: str | None = None,
) -> Measurement:
    """Elongations [m] of a piece of the rope under forces [N]; `length` [m] of the piece, or the rope's.

    The law of stretch gives them without a run: force times length over EA.
    """
    pulled, found = _numbers("forces", forces), _numbers("elongations", elongations)
    if length is not None:
        length = given("pull_test.length", length, "m")
    if pulled.shape != found.shape:
        raise InputError(
            "pull_test", f"{pulled.size} and {found.size}", "needs as many forces as elongations"
        )
    return _PullTest(
        "pull test", "m", found, _error("pull test", error), at=pulled, at_name="force [N]",
        forces=pulled, length=length, rope=rope,
    )  # fmt: skip


@dataclass(frozen=True)
class _Swing(Measurement):
    mode: int = 1

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        from ropewalk.vibration import modes

        found = modes(build(scene, stepped=False), count=self.mode).frequencies
        if self.mode > len(found):
            raise InputError("swing.mode", self.mode, f"there are {len(found)} modes")
        return np.full(self.values.shape, 1.0 / found[self.mode - 1])


def swing(periods: ArrayLike, error: float | None = None, *, mode: int = 1) -> Measurement:
    """Period of a small swing about rest [s], once or often; `mode` counts the natural modes, slowest 1."""
    found = _numbers("periods", periods)
    refuse_unless_whole("swing.mode", mode, 1)
    return _Swing("swing", "s", found, _error("swing", error), mode=mode)


@dataclass(frozen=True)
class _Shape(Measurement):
    points: Floats | None = None  # (k, 3), NaN in an axis that was not measured
    rope: str | None = None

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        assert self.points is not None
        own = rest["positions_last"][_nodes_of("shape", scene, self.rope)]
        return offsets(own, self.points, np.asarray(scene.up))


def shape(
    points: ArrayLike, error: float | None = None, *, axes: str = "xyz", rope: str | None = None
) -> Measurement:
    """Points on the rope at rest [m], (k, 3) or, of a photograph, (k, 2) along two `axes`.

    What is compared is the distance of each point from the rope, across it: one number a point in a plane,
    two in space. Where along the rope a point lies need not be known. Of several ropes in the scene `rope`
    names the one.
    """
    found = _array("shape", points)
    if found.ndim != 2 or found.shape[1] != len(axes) or set(axes) - set(AXES) or len(axes) < 2:
        rule = f"must be k x {len(axes)} numbers, one column for each of the axes {axes!r}"
        raise InputError("shape", " x ".join(map(str, found.shape)), rule)
    _numbers("shape", found)
    full = np.full((len(found), 3), np.nan)
    full[:, [AXES.index(axis) for axis in axes]] = found
    count = len(found) * (len(axes) - 1)
    return _Shape(
        "shape", "m", np.zeros(count), _error("shape", error), rest=("positions[-1]",), points=full,
        at_name="point", rope=rope,
    )  # fmt: skip


def offsets(rope: Floats, points: Floats, up: Floats) -> Floats:
    """Return how far points lie from a polyline (n, 3), across it: (k,) in a plane, (2 k,) in space.

    Nearest point of every segment, ends included. Axes that are NaN in `points` were not measured.
    """
    seen = np.isfinite(points[0])
    a, d = rope[:-1][:, seen], np.diff(rope, axis=0)[:, seen]
    p = points[:, seen]
    length2 = np.maximum((d**2).sum(axis=1), 1e-300)
    share = np.clip(((p[:, None] - a) * d).sum(axis=2) / length2, 0.0, 1.0)
    gap = p[:, None] - a - share[..., None] * d
    nearest = np.argmin((gap**2).sum(axis=2), axis=1)
    rows = np.arange(len(p))
    gap, t = gap[rows, nearest], d[nearest] / np.sqrt(length2[nearest])[:, None]
    if seen.sum() == 2:
        return np.asarray(t[:, 0] * gap[:, 1] - t[:, 1] * gap[:, 0])
    normal = up - (t @ up)[:, None] * t
    flat = np.linalg.norm(normal, axis=1) < 1e-6  # a rope along gravity has no normal in its plane
    normal[flat] = np.cross(t[flat], np.roll(up, 1))
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    return np.concatenate([(gap * normal).sum(axis=1), (gap * np.cross(t, normal)).sum(axis=1)])


def _frame_interval(scene: Scene) -> float:
    """Return the time between two frames of a run [s]: exact steps need not fit into the one asked for."""
    exact = scene.run.steps == "exact"
    return build(scene).plan.frame_interval if exact else scene.run.frame_interval


@dataclass(frozen=True)
class _Track(Measurement):
    node: int = -1
    axes: tuple[int, ...] = (0, 1, 2)

    def predicted(
        self, kept: Mapping[str, Floats], rest: Mapping[str, Floats], scene: Scene
    ) -> Floats:
        from scipy.interpolate import CubicHermiteSpline

        assert self.at is not None
        if len(scene.ropes) > 1:
            rule = "follows a node of the only rope of a scene: leave the others out of it"
            raise InputError("track", ", ".join(rope.name for rope in scene.ropes), rule)
        x, v = (kept[parse(text).name] for text in self.keep)
        times = np.arange(len(x)) * _frame_interval(scene)
        if self.at.max() > times[-1] + 1e-9:
            rule = f"[s] lies beyond the last frame, at {times[-1]:g} s; make run.duration longer"
            raise InputError("track", float(self.at.max()), rule)
        spline = CubicHermiteSpline(times, x, v)  # the run knows its velocities, too
        points = spline(self.at[: len(self.at) // len(self.axes)])
        return np.asarray(points[:, list(self.axes)].T.ravel())


def track(
    source: str | Path | ArrayLike,
    error: float | None = None,
    *,
    node: int = -1,
    axes: str = "xyz",
) -> Measurement:
    """A node followed in time, as of a video: a CSV file with a head `time,x,z`, or rows of such numbers.

    Times [s] from the run's start, places [m] along the `axes` (a file's head names them). The scene has one
    rope.
    """
    if isinstance(source, (str, Path)):
        rows, axes = _read_track(Path(source))
    else:
        rows = _array("track", source)
    if rows.ndim != 2 or rows.shape[1] != 1 + len(axes) or set(axes) - set(AXES):
        rule = f"must be rows of time and {', '.join(axes)}"
        raise InputError("track", " x ".join(map(str, rows.shape)), rule)
    _numbers("track", rows)
    if (rows[:, 0] < 0.0).any():
        raise InputError("track", float(rows[:, 0].min()), "times count from the run's start, 0")
    return _Track(
        "track", "m", rows[:, 1:].T.ravel(), _error("track", error),
        keep=(f"positions[:, {node}]", f"velocities[:, {node}]"),
        at=np.tile(rows[:, 0], len(axes)), at_name="time [s]",
        node=node, axes=tuple(AXES.index(axis) for axis in axes),
    )  # fmt: skip


def _read_track(path: Path) -> tuple[Floats, str]:
    """Return the rows and axes of a file of tracked points. Raises RunError."""
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            lines = [row for row in csv.reader(file) if row]
    except OSError as error:
        raise RunError(path, f"cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error):
        raise RunError(path, "is not a text file (UTF-8) of rows with commas") from None
    head = [name.strip().lower() for name in lines[0]] if lines else []
    if head[:1] != ["time"] or not head[1:] or set(head[1:]) - set(AXES):
        raise RunError(path, "must begin with a head such as time,x,z")
    if len(set(head)) < len(head):
        raise RunError(path, f"must name each column once in its head, not {','.join(head)}")
    for number, row in enumerate(lines[1:], start=1):
        if len(row) != len(head):
            rule = f"must hold {len(head)} numbers a line, as its head does: row {number} has {len(row)}"
            raise RunError(path, rule)
    try:
        rows = np.array([[float(cell) for cell in row] for row in lines[1:]])
        return rows.reshape(len(rows), len(head)), "".join(head[1:])
    except ValueError as error:
        raise RunError(path, f"must hold {len(head)} numbers a line: {error}") from None


def _as_kept(name: str, what: Any) -> Measurement:
    if isinstance(what, list) and len(what) == 2 and all(np.ndim(part) == 0 for part in what):
        value, other = what
        rule = f"write ({value}, {other}) for a value and its error, or ([{value}, {other}], None) for two"
        raise InputError(name, what, rule)
    return kept(name, *(what if isinstance(what, tuple) else (what,)))


def as_measurements(measured: Any) -> tuple[Measurement, ...]:
    """Return measurements from one, several, or a mapping from what is kept to (values, error).

    A list of two numbers is refused there: it may be a value and its error, or two values.
    """
    if isinstance(measured, Measurement):
        return (measured,)
    if isinstance(measured, Mapping):
        return tuple(_as_kept(name, what) for name, what in measured.items())
    if (
        isinstance(measured, Sequence)
        and measured
        and all(isinstance(m, Measurement) for m in measured)
    ):
        return tuple(measured)
    rule = (
        "must be measurements such as rw.calibrate.sag(1.2, error=0.01), or a mapping such as "
        '{"tension.max": (120.0, 2.0)}'
    )
    raise InputError("measured", type(measured).__name__, rule)
