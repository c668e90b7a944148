"""Fitting a scene's values to measurements: least squares, intervals, what a measurement cannot tell."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module
from typing import Any

import numpy as np

from ropewalk.api import SceneLike, as_scene, told_of
from ropewalk.core.arrays import Floats
from ropewalk.display.bar import Bar
from ropewalk.record.errors import InputError
from ropewalk.scene import Scene
from ropewalk.sweeps import measurements
from ropewalk.sweeps.basins import Found, find
from ropewalk.sweeps.cutting import cut_words
from ropewalk.sweeps.fit_ranges import make_scales
from ropewalk.sweeps.fit_residuals import NotFitted, Residuals
from ropewalk.sweeps.identify import Findings, identify, verdict, with_turns
from ropewalk.sweeps.measurements import Measurement, as_measurements
from ropewalk.sweeps.misfit import misfit
from ropewalk.sweeps.parameters import short_names
from ropewalk.sweeps.profile import profile_intervals
from ropewalk.sweeps.whole import refuse_unless_whole

__all__ = ["Calibrate", "Calibration", "NotFitted", "calibrate"]

_PLOTS = "ropewalk.plots.residuals"  # a layer above this one, so it is looked up when it is needed


@dataclass(frozen=True)
class Calibration:
    """A fit.

    Attributes:
        scene: with the fitted values.
        values: by path.
        intervals: by path, from the covariance: (low, high) at `level`.
        profile: the same from the profile likelihood; empty when it was not asked for.
        correlation: of the values, (D, D) [1].
        words: whether the model fits, what the measurement tells and what it does not.
        residuals: predicted less measured, by measurement, in its unit.
        spread: standard deviation of the residuals over their errors [1], the root of the reduced
            chi-square: about 1 for errors as stated. Without them it is in the measurement's unit.
        evaluations: runs (or equilibria) made.
        others: values, by path, of other places that fit as well, outside the intervals.
    """

    scene: Scene
    values: dict[str, float]
    intervals: dict[str, tuple[float, float]]
    profile: dict[str, tuple[float, float]]
    correlation: Floats
    words: tuple[str, ...]
    measurements: tuple[Measurement, ...]
    predicted: tuple[Floats, ...]
    spread: float
    level: float
    evaluations: int
    units: dict[str, str] = field(default_factory=dict)
    others: tuple[dict[str, float], ...] = ()

    @property
    def residuals(self) -> dict[str, Floats]:
        """Predicted less measured, by measurement, in its unit."""
        pairs = zip(self.measurements, self.predicted, strict=True)
        return {m.name: p - m.values for m, p in pairs}

    def plot(self) -> Any:
        """Draw the residuals; a Figure."""
        return import_module(_PLOTS).residuals(self)

    def __repr__(self) -> str:
        count = sum(m.values.size for m in self.measurements)
        lines = [f"Fitted to {count} number{'s' * (count != 1)}:"]
        for path, value in self.values.items():
            low, high = self.profile.get(path) or self.intervals[path]
            unit = self.units.get(path, "")
            about = f"{100 * self.level:g} % from {low:.5g} to {high:.5g}"
            about = "interval not known" if math.isnan(low) else about
            lines.append(f"  {path} = {value:.6g} {unit} ({about})")
        return "\n".join([*lines, *(f"  {text}" for text in self.words)])


def calibrate(
    scene: SceneLike,
    measured: Any,
    ranges: Mapping[str, tuple[float, float]],
    *,
    level: float = 0.9,
    starts: int = 8,
    seed: int = 0,
    profile: bool = True,
    on: Any = "here",
    workers: int | None = None,
    progress: Callable[[int], Any] | bool = True,
) -> Calibration:
    """Fit values of a scene to measurements by least squares.

    Args:
        scene: scene, preset's name, or scene file: how it was measured.
        measured: one or several of `rw.calibrate.sag`, `shape`, `pull_test`, `droop`, `swing`, `track` and
            `kept`, or a mapping from what a sweep keeps to (values, error); a list of two numbers is refused
            there, as it may be two values: ([120.0, 121.0], None).
        ranges: by path, (low, high); far apart ones are searched by factors.
        level: of the intervals [1].
        starts: places to start from besides the scene's own values, made the next power of two; followed are
            those that are better than their neighbours, and of several values at least the best four, then
            what is better along the range of each from the best fit.
        seed: of the starts.
        profile: also make intervals by profile likelihood, which takes more runs.
        on, workers: as of `sweep`; the differences of a step are made side by side.
        progress: a function called with the number of evaluations so far; True: told on a terminal.

    Errors are given for all measurements or for none; then they are estimated from what the fit leaves.
    A fixed `run.time_step` is best: with "auto" the number of steps jumps as values change.

    Raises SceneError, InputError, NotFitted.
    """
    loaded = as_scene(scene)
    found = as_measurements(measured)
    _refuse(found, level, starts, seed)
    with told_of(scene):
        scales = make_scales(loaded, ranges)
        residuals = Residuals(loaded, found, scales, {"on": on, "workers": workers})
    with _Progress(residuals, progress):
        try:
            return _fit(loaded, residuals, (starts, seed), level, profile)
        finally:
            residuals.close()


class _Progress:
    """Tells how many evaluations a fit has made; how many there will be nobody knows."""

    def __init__(self, residuals: Residuals, progress: Callable[[int], Any] | bool) -> None:
        self._bar = Bar("calibrate", shown=progress is True)
        self._call = progress if callable(progress) else None
        residuals.progress = self._told

    def _told(self, evaluations: int) -> None:
        self._bar.say(f"{evaluations} evaluation{'s' * (evaluations != 1)}")
        if self._call is not None:
            self._call(evaluations)

    def __enter__(self) -> None:
        self._bar.__enter__()

    def __exit__(self, *error: Any) -> None:
        self._bar.__exit__(*error)


def _fit(
    scene: Scene, residuals: Residuals, starts: tuple[int, int], level: float, profile: bool
) -> Calibration:
    """Search, and ask what the fit is worth. Raises NotFitted."""
    found = find(residuals, _own_start(residuals, scene), *starts)
    share, names = found.share, short_names(residuals.paths)
    jacobian, left = residuals.jacobian(share), residuals.one(share)
    findings = identify(jacobian, left, residuals.known, level, names)
    findings, turns = with_turns(findings, names, lambda i: _moves(residuals, share, left, i))
    near = _ends(share, findings)
    far: list[tuple[float, float]] = []
    if profile and np.isfinite(findings.deviation).all():
        far = profile_intervals(residuals.one, residuals.jacobian, share, findings)
    unknown = (math.nan, math.nan)
    known = [unknown if turn else pair for pair, turn in zip(far or near, turns, strict=True)]
    ends = far or known
    rise = findings.quantile**2 * findings.variance + 2.0 * residuals.nothing
    others = found.others(ends, 2.0 * residuals.nothing if math.isnan(rise) else rise)
    words = [*findings.words, *(_as_well(residuals, names, place) for place in others)]
    predicted = residuals.predicted(share[None])[0]
    residuals.refuse_beyond_limiter()
    fitted = _fitted(scene, residuals, share)
    cut = cut_words(residuals, fitted, share, predicted, jacobian, known)
    words = [*verdict(words, ends, names, found.tried, cut.beyond)]
    told = replace(findings, words=(*cut.words, *words))
    intervals = residuals.intervals(near), residuals.intervals(far)
    return _answer(fitted, residuals, found, told, intervals, others, (level, predicted))


def _fitted(scene: Scene, residuals: Residuals, share: Floats) -> Scene:
    """Return the scene with the values at shares of their ranges."""
    from ropewalk.scene.overrides import Places

    return Places(scene, residuals.paths).scene(residuals.values(share[None])[0].tolist())


def _as_well(residuals: Residuals, names: Sequence[str], place: Floats) -> str:
    """Say that another place fits as well."""
    pairs = zip(names, residuals.values(place[None])[0], residuals.units, strict=True)
    listed = ", ".join(f"{name} = {value:.6g} {unit}".rstrip() for name, value, unit in pairs)
    return (
        f"Another place fits as well: {listed}. The measurement does not tell which of them it is, and no "
        "interval reaches from one to the other: narrow the range, or measure something else besides."
    )


def _moves(residuals: Residuals, share: Floats, left: Floats, place: int) -> float:
    """Return how much the residuals change at most along the range of a value, less rounding."""
    table = np.tile(share, (3, 1))
    table[:, place] = 0.0, 0.5, 1.0
    squares = ((residuals.found(table) - left) ** 2).sum(axis=1)
    return float(squares[np.isfinite(squares)].max(initial=0.0)) - 8.0 * residuals.nothing


def _refuse(found: tuple[Measurement, ...], level: float, starts: int, seed: int) -> None:
    """Refuse what no fit can be made of. Raises InputError."""
    if len({m.error is None for m in found}) > 1:
        missing = ", ".join(m.name for m in found if m.error is None)
        raise InputError(
            "error", missing, "is missing: give errors for all measurements, or for none"
        )
    units = {m.unit for m in found}
    if found[0].error is None and len(units) > 1:
        rule = f"is needed: numbers in {', '.join(sorted(units))} cannot be weighed otherwise"
        raise InputError("error", None, rule)
    if not (isinstance(level, (int, float)) and 0.0 < level < 1.0):
        raise InputError("level", level, "must be between 0 and 1")
    refuse_unless_whole("starts", starts, 0)
    refuse_unless_whole("seed", seed, 0)


def _own_start(residuals: Residuals, scene: Scene) -> Floats:
    """The scene's own values where they are within the ranges, else the middle."""
    from ropewalk.scene.overrides import Places

    places, found = Places(scene, residuals.paths), []
    for number, scale in enumerate(residuals.scales):
        value = places.value(number)
        inside = isinstance(value, (int, float)) and scale.low <= value <= scale.high
        found.append(scale.share(float(value)) if inside else 0.5)
    return np.array([found])


def _ends(share: Floats, findings: Findings) -> list[tuple[float, float]]:
    """Return the intervals of the covariance as shares of the ranges, cut at their ends."""
    half = findings.quantile * findings.deviation
    ends = np.clip([share - half, share + half], 0.0, 1.0)  # NaN stays
    return [(float(low), float(high)) for low, high in ends.T]


def _answer(
    fitted: Scene,
    residuals: Residuals,
    found: Found,
    findings: Findings,
    intervals: tuple[dict[str, Any], dict[str, Any]],
    others: Sequence[Floats],
    facts: tuple[float, Floats],
) -> Calibration:
    (level, predicted), measured = facts, residuals.measurements
    row = residuals.values(found.share[None])[0].tolist()
    cuts = np.cumsum([m.values.size for m in measured])[:-1]
    parts = np.split(predicted, cuts)
    words = [*misfit(measured, parts, len(row)), *findings.words]
    if found.worse:
        words.append(
            f"{found.worse} of {found.tried} starts ended in a worse place; take more starts to be sure."
        )
    for path, part in zip(residuals.paths, found.share, strict=True):
        if part < 1e-3 or part > 1.0 - 1e-3:
            words.append(
                f"{path} ends at the end of its range; widen it if that is no natural limit."
            )
    return Calibration(
        scene=fitted,
        values=dict(zip(residuals.paths, row, strict=True)),
        intervals=intervals[0],
        profile=intervals[1],
        correlation=findings.correlation,
        words=tuple(words),
        measurements=measured,
        predicted=tuple(parts),
        spread=findings.spread,
        level=level,
        evaluations=residuals.evaluations,
        units=dict(zip(residuals.paths, residuals.units, strict=True)),
        others=tuple(residuals.by_path(place) for place in others),
    )


class Calibrate:
    """`rw.calibrate(scene, measured, ranges)` fits; `sag`, `shape`, ... make what was measured."""

    __call__ = staticmethod(calibrate)
    sag: Callable[..., Measurement] = staticmethod(measurements.sag)
    shape: Callable[..., Measurement] = staticmethod(measurements.shape)
    pull_test: Callable[..., Measurement] = staticmethod(measurements.pull_test)
    droop: Callable[..., Measurement] = staticmethod(measurements.droop)
    swing: Callable[..., Measurement] = staticmethod(measurements.swing)
    track: Callable[..., Measurement] = staticmethod(measurements.track)
    kept: Callable[..., Measurement] = staticmethod(measurements.kept)

    def __repr__(self) -> str:
        return "<ropewalk.calibrate: fits a scene to measurements; see help(ropewalk.calibrate.__call__)>"
