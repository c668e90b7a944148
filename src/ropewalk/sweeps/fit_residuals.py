"""Predictions of a scene against measurements, as a function of the values that are fitted."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.errors import InputError
from ropewalk.record.note_kinds import BEYOND_LIMITER, kinds_in
from ropewalk.scene import Scene, SceneError
from ropewalk.sweeps.batch import REST, RUN
from ropewalk.sweeps.fit_ranges import Scale, unit_of_path
from ropewalk.sweeps.function import SweepFunction
from ropewalk.sweeps.measurements import Measurement
from ropewalk.sweeps.misfit import ROUNDING, size_of
from ropewalk.sweeps.workshop import Workshop

_STEP = 1e-4  # of the differences, as a share of the range
LOST = 1e6  # least residual of a run that broke, in standard deviations


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
        self._scene, self.measurements = scene, found
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
        self.progress: Callable[[int], None] = lambda evaluations: None
        self.lost = LOST
        self.reason = ""  # of the first run that broke
        self.without: tuple[str, ...] = ()  # what has no value in a run that ended well

    @cached_property
    def units(self) -> tuple[str, ...]:
        """The units of the parameters, "" of what has none."""
        return tuple(unit_of_path(self._scene, path) for path in self.paths)

    def by_path(self, share: Floats) -> dict[str, float]:
        """Return the parameters at shares (D,) of their ranges, by path."""
        return dict(zip(self.paths, self.values(share[None])[0].tolist(), strict=True))

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
        rows = []
        for number, row in enumerate(table.tolist()):
            rows.append(self._row(row, number, kept))
            self.evaluations += 1
            self.progress(self.evaluations)
        return np.stack(rows)

    def _row(self, row: list[float], number: int, kept: dict[str, dict[str, Floats]]) -> Floats:
        parts = ({name: a[number] for name, a in kept[what].items()} for what in (RUN, REST))
        runs, rests = parts
        try:
            scene = self._workshop.scene(row)
            found = [m.predicted(runs, rests, scene) for m in self.measurements]
        except InputError:  # of the measurement, not of these values
            raise
        except (SceneError, ArithmeticError, RuntimeError, ValueError) as error:
            self.reason = self.reason or str(error)
            return np.full(self.size, math.nan)
        if not any(self._broke(number)):
            lacks = [
                m.name
                for m, one in zip(self.measurements, found, strict=True)
                if np.isnan(one).any()
            ]
            self.without = tuple(dict.fromkeys((*self.without, *lacks)))
        return np.concatenate(found)

    def _broke(self, number: int) -> Iterator[bool]:
        """Yield whether a row's run broke, and whether it has no rest."""
        for function in self._functions.values():
            yield bool(function.last.reason[number])

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
