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
from ropewalk.record.errors import InputError
from ropewalk.record.note_kinds import BEYOND_LIMITER, kinds_in
from ropewalk.scene import Scene, SceneError
from ropewalk.sweeps import measurements
from ropewalk.sweeps.batch import REST, RUN
from ropewalk.sweeps.fit_ranges import Scale, make_scales
from ropewalk.sweeps.function import SweepFunction
from ropewalk.sweeps.identify import Findings, identify, verdict
from ropewalk.sweeps.measurements import Measurement, as_measurements
from ropewalk.sweeps.misfit import ROUNDING, misfit, size_of
from ropewalk.sweeps.parameters import short_names
from ropewalk.sweeps.profile import profile_intervals
from ropewalk.sweeps.whole import refuse_unless_whole
from ropewalk.sweeps.workshop import Workshop

_PLOTS = "ropewalk.plots.residuals"  # a layer above this one, so it is looked up when it is needed
_STEP = 1e-4  # of the differences, as a share of the range
_LOST = 1e6  # least residual of a run that broke, in standard deviations


class NotFitted(RuntimeError):  # noqa: N818 - it is what happened, not a mistake
    """No start led to a fit: all runs broke, or the best rests beyond a stretch limiter."""


class Residuals:
    """Predicted less measured, in standard deviations, as a function of shares of the ranges."""

    def __init__(
        self,
        scene: Scene,
        found: tuple[Measurement, ...],
        scales: Mapping[str, Scale],
        options: Any,
    ) -> None:
        self.measurements = found
        self.paths, self.scales = tuple(scales), tuple(scales.values())
        self._workshop = Workshop(scene, self.paths, ["float"] * len(self.paths))
        keep = tuple(dict.fromkeys(text for m in found for text in m.keep))
        rest = tuple(dict.fromkeys(text for m in found for text in m.rest))
        self._functions = {
            what: SweepFunction(scene, self.paths, texts, what=what, **options)
            for what, texts in ((RUN, keep), (REST, rest))
            if texts
        }
        self.weights = np.concatenate(
            [np.full(m.values.size, 1.0 / (m.error or 1.0)) for m in found]
        )
        self.known = found[0].error is not None
        self.size = self.weights.size
        self.nothing = 1e-6 * self.size  # half a sum of squares that tells no two fits apart
        if not self.known:  # then they are in the measurement's unit
            rounding = [(ROUNDING * size_of(m)) ** 2 * m.values.size for m in found]
            self.nothing = 0.5 * sum(rounding)
        self.evaluations = 0
        self.lost = _LOST
        self.reason = ""  # of the first run that broke

    def values(self, shares: Floats) -> Floats:
        """Return the parameters (N, D) at shares of their ranges."""
        columns = [scale.value(shares[:, i]) for i, scale in enumerate(self.scales)]
        return np.stack(columns, axis=1)

    def predicted(self, shares: Floats) -> Floats:
        """Return the predictions (N, m) side by side; NaN for a run that breaks."""
        table = self.values(np.atleast_2d(shares))
        kept: dict[str, dict[str, Floats]] = {RUN: {}, REST: {}}
        for what, function in self._functions.items():
            kept[what] = function.runs(table)
            self.reason = self.reason or next(filter(None, function.last.reason), "")
        self.evaluations += len(table)
        return np.stack([self._row(row, number, kept) for number, row in enumerate(table.tolist())])

    def _row(self, row: list[float], number: int, kept: dict[str, dict[str, Floats]]) -> Floats:
        parts = ({name: a[number] for name, a in kept[what].items()} for what in (RUN, REST))
        runs, rests = parts
        try:
            scene = self._workshop.scene(row)
            return np.concatenate([m.predicted(runs, rests, scene) for m in self.measurements])
        except InputError:  # of the measurement, not of these values
            raise
        except (SceneError, RuntimeError, ValueError) as error:
            self.reason = self.reason or str(error)
            return np.full(self.size, math.nan)

    def found(self, shares: Floats) -> Floats:
        """Return the residuals (N, m); NaN for a run that breaks."""
        measured = np.concatenate([m.values for m in self.measurements])
        return np.asarray((self.predicted(shares) - measured) * self.weights)

    def many(self, shares: Floats) -> Floats:
        """Return the residuals (N, m), those of a run that breaks very large."""
        found = self.found(shares)
        return np.where(np.isfinite(found), found, self.lost)

    def one(self, share: Floats) -> Floats:
        """Return the residuals (m,) of one set of values."""
        return np.asarray(self.many(share[None])[0])

    def jacobian(self, share: Floats) -> Floats:
        """Return their derivatives (m, D), by central differences made side by side.

        The place of exact tangents through the implicit solve, when there are any.
        """
        low, high = np.maximum(share - _STEP, 0.0), np.minimum(share + _STEP, 1.0)
        width = len(share)
        table = np.tile(share, (2 * width, 1))
        at = np.arange(width)
        table[at, at], table[width + at, at] = low, high
        found = self.many(table)
        return np.asarray(((found[width:] - found[:width]) / (high - low)[:, None]).T)

    def intervals(self, ends: Sequence[tuple[float, float]]) -> dict[str, tuple[float, float]]:
        """Return intervals of shares in the parameters' units, by path; nothing for no intervals."""
        parts = zip(self.paths, self.scales, ends, strict=False)
        return {path: (float(s.value(low)), float(s.value(high))) for path, s, (low, high) in parts}

    def refuse_beyond_limiter(self) -> None:
        """Raise NotFitted where the equilibrium last predicted is not that of the scene with its limiter."""
        function = self._functions.get(REST)
        notes = function.last.notes if function is not None else []
        if any(BEYOND_LIMITER in kinds_in(text) for text in notes):
            raise NotFitted(
                "the best fit rests beyond the stretch limiter, which takes no part in rest: its values are "
                "those of a rope without one. Fit ranges within which it does not act, or a scene without it"
            )

    def close(self) -> None:
        """End the clusters that were started."""
        for function in self._functions.values():
            function.close()


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
) -> Calibration:
    """Fit values of a scene to measurements by least squares.

    Args:
        scene: scene, preset's name, or scene file: how it was measured.
        measured: one or several of `rw.calibrate.sag`, `shape`, `pull_test`, `droop`, `swing`, `track` and
            `kept`, or a mapping from what a sweep keeps to (values, error); a list of two numbers is refused
            there, as it may be two values: ([120.0, 121.0], None).
        ranges: by path, (low, high); far apart ones are searched by factors.
        level: of the intervals [1].
        starts: places to start from besides the scene's own values, made the next power of two; the best
            three are followed.
        seed: of the starts.
        profile: also make intervals by profile likelihood, which takes more runs.
        on, workers: as of `sweep`; the differences of a step are made side by side.

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
    try:
        share, same = _search(residuals, loaded, starts, seed)
        jacobian = residuals.jacobian(share)
        left = residuals.one(share)
        known = residuals.known
        findings = identify(jacobian, left, known, level, short_names(residuals.paths))
        near = _ends(share, findings)
        far: list[tuple[float, float]] = []
        if profile and np.isfinite(findings.deviation).all():
            far = profile_intervals(residuals.one, residuals.jacobian, share, findings)
        told = verdict(findings.words, far or near, short_names(residuals.paths))
        intervals = residuals.intervals(near), residuals.intervals(far)
        return _answer(
            loaded, residuals, share, replace(findings, words=told), intervals, (same, level)
        )
    finally:
        residuals.close()


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


def _search(
    residuals: Residuals, scene: Scene, starts: int, seed: int
) -> tuple[Floats, tuple[int, int]]:
    """Return the best fit, and how many of the starts that were followed led to it."""
    from scipy.optimize import least_squares
    from scipy.stats import qmc

    width = len(residuals.paths)
    points = qmc.Sobol(width, rng=np.random.default_rng(seed)).random_base2(
        max(1, math.ceil(math.log2(max(starts, 2))))
    )
    own = _own_start(residuals, scene)
    table = np.concatenate([own, points])
    found = residuals.found(table)
    costs = (found**2).sum(axis=1)
    order = [i for i in np.argsort(costs) if np.isfinite(costs[i])][:3]
    if not order:
        raise NotFitted(
            "every start broke: no run ended well anywhere in the ranges that were tried; "
            f"the first: {residuals.reason or 'no number came of it'}"
        )
    # A run that breaks must never look better than one that only lies far off.
    residuals.lost = max(_LOST, 10.0 * float(np.abs(found[np.isfinite(found)]).max()))
    # In units of where they begin: gtol is absolute, and would take a small unit's start for the end.
    size = math.sqrt(float(costs[order].max())) or 1.0
    fits = [
        least_squares(
            lambda share: residuals.one(share) / size, np.clip(table[i], 1e-6, 1.0 - 1e-6),
            lambda share: residuals.jacobian(share) / size,
            bounds=(0.0, 1.0), xtol=1e-10, ftol=1e-12, gtol=1e-12, max_nfev=60,
        )
        for i in order
    ]  # fmt: skip
    best = min(fits, key=lambda fit: float(fit.cost))
    near = 0.01 * float(best.cost) + residuals.nothing / size**2
    same = sum(float(fit.cost) <= float(best.cost) + near for fit in fits)
    return np.asarray(best.x), (same, len(fits))


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
    scene: Scene,
    residuals: Residuals,
    share: Floats,
    findings: Findings,
    intervals: tuple[dict[str, Any], dict[str, Any]],
    facts: tuple[tuple[int, int], float],
) -> Calibration:
    from ropewalk.scene.overrides import Places

    (same, tried), level = facts
    row = residuals.values(share[None])[0].tolist()
    places = Places(scene, residuals.paths)
    extras = [places.field(number)[0].json_schema_extra for number in range(len(row))]
    units = [str(e.get("unit", "")) if isinstance(e, Mapping) else "" for e in extras]
    predicted = residuals.predicted(share[None])[0]
    residuals.refuse_beyond_limiter()
    cuts = np.cumsum([m.values.size for m in residuals.measurements])[:-1]
    parts = np.split(predicted, cuts)
    words = [*misfit(residuals.measurements, parts, len(row)), *findings.words]
    if same < tried:
        words.append(
            f"{tried - same} of {tried} starts ended in a worse place; take more starts to be sure."
        )
    for path, part in zip(residuals.paths, share, strict=True):
        if part < 1e-3 or part > 1.0 - 1e-3:
            words.append(
                f"{path} ends at the end of its range; widen it if that is no natural limit."
            )
    return Calibration(
        scene=places.scene(row),
        values=dict(zip(residuals.paths, row, strict=True)),
        intervals=intervals[0],
        profile=intervals[1],
        correlation=findings.correlation,
        words=tuple(words),
        measurements=residuals.measurements,
        predicted=tuple(parts),
        spread=findings.spread,
        level=level,
        evaluations=residuals.evaluations,
        units=dict(zip(residuals.paths, units, strict=True)),
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
