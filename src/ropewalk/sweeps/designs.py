"""Which runs a sweep makes: a grid, a sample, or given runs, as columns of values."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.scene import SceneError
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.sweeps.labels import Label
from ropewalk.sweeps.parameters import FLOAT, INT, Parameter
from ropewalk.sweeps.whole import is_whole
from ropewalk.words.nearest import nearest

DESIGNS = ("sobol", "lhs", "halton", "random")
GRID, GIVEN = "grid", "given"
#: Groups of D + 2 runs that Sobol indices are made of; `runs` is a multiple of that.
SALTELLI = "saltelli"
#: Most runs of one sweep.
MOST_RUNS = 100_000_000
_PIECE = 65536  # runs whose values are made at a time; a power of two, as Sobol's points like it

Columns = list[NDArray[Any]]


@dataclass(frozen=True)
class Design:
    """All runs of a sweep, in order."""

    kind: str  # GRID, GIVEN or one of DESIGNS
    parameters: tuple[Parameter, ...]
    runs: int
    seed: int | None = None
    labels: tuple[Label, ...] = ()  # of given runs

    @property
    def drawn(self) -> bool:
        """Whether the values come from spreads and a seed."""
        return self.kind in (*DESIGNS, SALTELLI)

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the grid's dimensions; (runs,) of any other design."""
        if self.kind != GRID:
            return (self.runs,)
        return tuple(len(parameter.values or ()) for parameter in self.parameters)

    def pieces(self) -> Iterator[Columns]:
        """Yield the values of all runs, some at a time: one array per parameter, then per label.

        The pieces of a sample are those of the whole sample, so memory does not grow with it.
        """
        if self.drawn:
            yield from self._sampled()
            return
        for start in range(0, self.runs, _PIECE):
            numbers = np.arange(start, min(start + _PIECE, self.runs))
            if self.kind == GRID:
                places: Sequence[NDArray[Any]] = np.unravel_index(numbers, self.shape)
            else:
                places = [numbers] * len(self.parameters)
            pairs = zip(self.parameters, places, strict=True)
            made = [column(p, p.values or ())[place] for p, place in pairs]
            yield [*made, *(column(label, label.values)[numbers] for label in self.labels)]

    def _sampled(self) -> Iterator[Columns]:
        width = len(self.parameters)
        if self.kind == SALTELLI:
            whole = saltelli(width, self.runs // (width + 2), self.seed)
            points: Iterator[NDArray[np.float64]] = (
                whole[at : at + _PIECE] for at in range(0, self.runs, _PIECE)
            )
        else:
            points = _unit_points(self.kind, width, self.runs, self.seed)
        for unit in points:
            yield [spread_over(p, unit[:, i]) for i, p in enumerate(self.parameters)]


def saltelli(width: int, samples: int, seed: int | None) -> NDArray[np.float64]:
    """Return Saltelli's points of the unit cube, (samples * (width + 2), width).

    Source: Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, as SALib makes them.
    """
    from SALib.sample import sobol

    names = [f"x{i}" for i in range(width)]
    problem = {"num_vars": width, "names": names, "bounds": [[0.0, 1.0]] * width}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of sizes that are no powers of two
        made: NDArray[np.float64] = sobol.sample(
            problem, samples, calc_second_order=False, seed=seed
        )
    return made


def plain_rows(kind: str, width: int) -> slice:
    """Return which runs are a sample of the spreads of `width` parameters, each value drawn once.

    Of Saltelli's groups that is the first of each: the others repeat its values, some of them.
    """
    return slice(None, None, width + 2 if kind == SALTELLI else None)


def make_design(
    parameters: tuple[Parameter, ...],
    samples: int | None,
    design: str,
    seed: int | None,
    given: bool,
    labels: tuple[Label, ...] = (),
) -> Design:
    """Return the design that was asked for. Raises SceneError when it fits not together."""
    faults: list[Fault] = []
    if design not in DESIGNS:
        rule = f"must be one of {', '.join(DESIGNS)}; {nearest(design, DESIGNS)}"
        faults.append(Fault("design", design, rule))
    if samples is not None and not (is_whole(samples, 1) and samples <= MOST_RUNS):
        rule = f"must be a whole number from 1 to {MOST_RUNS}"
        faults.append(Fault("samples", samples, rule))
    if seed is not None and not is_whole(seed, 0):
        faults.append(Fault("seed", seed, "must be a whole number from 0 on"))
    spread = [parameter.path for parameter in parameters if parameter.spread is not None]
    if samples is None and spread:
        rule = "is a range or a distribution: say how many samples to draw (samples=256; --samples 256)"
        faults += [Fault(path, NO_VALUE, rule) for path in spread]
    if given and samples is not None:
        rule = "leave it out: a table gives the runs themselves"
        faults.append(Fault("samples", samples, rule))
    if faults:
        raise SceneError(faults)
    if given:
        lengths = {len(parameter.values or ()) for parameter in parameters}
        assert len(lengths) == 1
        return Design(GIVEN, parameters, lengths.pop(), labels=labels)
    if samples is None:
        runs = math.prod(len(parameter.values or ()) for parameter in parameters)
        if runs > MOST_RUNS:
            rule = f"makes {runs:.3g} runs; at most {MOST_RUNS:g} are possible"
            raise SceneError([Fault("vary", NO_VALUE, rule)])
        return Design(GRID, parameters, runs)
    if seed is None:
        seed = int(np.random.SeedSequence().generate_state(1)[0])
    if design == "sobol" and samples & (samples - 1):
        better = 1 << (int(samples) - 1).bit_length()
        warnings.warn(
            f"samples: {samples} is no power of two; Sobol's points fill the space evenly only for "
            f"powers of two: take {better // 2} or {better}",
            stacklevel=4,
        )
    return Design(design, parameters, int(samples), seed)


def column(parameter: Parameter | Label, values: Sequence[Any]) -> NDArray[Any]:
    """Return values as the array that a parameter's column is."""
    dtype: Any = {FLOAT: np.float64, INT: np.int64}.get(parameter.kind, object)
    made: NDArray[Any] = np.empty(len(values), dtype=dtype)
    made[:] = values
    return made


def spread_over(parameter: Parameter, unit: NDArray[np.float64]) -> NDArray[Any]:
    """Return a parameter's values for points of the unit interval.

    A distribution takes them by its inverse, a range linearly, a list in equal parts.
    """
    unit = np.clip(unit, 2.0**-60, 1.0 - 2.0**-53)
    if parameter.values is not None:
        count = len(parameter.values)
        picked = np.minimum((unit * count).astype(int), count - 1)
        return np.asarray(column(parameter, parameter.values)[picked])
    if not isinstance(parameter.spread, tuple):
        found = np.asarray(parameter.spread.ppf(unit), dtype=np.float64)
        return np.rint(found).astype(np.int64) if parameter.kind == INT else found
    low, high = parameter.spread
    if parameter.kind == INT:
        return np.asarray(low + np.floor(unit * (high - low + 1)), dtype=np.int64)
    return np.asarray(low + unit * (high - low), dtype=np.float64)


def _unit_points(
    kind: str, width: int, runs: int, seed: int | None
) -> Iterator[NDArray[np.float64]]:
    """Yield points of the unit cube, (n, width), `runs` in all."""
    generator = np.random.default_rng(seed)
    if kind == "lhs":  # in one piece: every point depends on all
        from scipy.stats import qmc

        points = qmc.LatinHypercube(width, rng=generator).random(runs)
        for start in range(0, runs, _PIECE):
            yield points[start : start + _PIECE]
        return
    draw: Any = generator
    if kind != "random":
        from scipy.stats import qmc

        draw = {"sobol": qmc.Sobol, "halton": qmc.Halton}[kind](width, rng=generator)
    for start in range(0, runs, _PIECE):
        size = min(_PIECE, runs - start)
        if kind == "random":
            yield draw.random((size, width))
        else:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", UserWarning)  # of sizes: said already
                yield draw.random(size)
