"""What a sweep keeps of every run: `tension.max`, `positions[-1]`, `sag.max[time]`, `reactions[-1, left]`.

QUANTITY[frame, ...]      some of it: a frame, then a place along each further dimension (`:` is all)
QUANTITY.REDUCER          one number over time and along the rope; vectors count by their size
QUANTITY.REDUCER[dims]    the same, but not over the dimensions named here

Where runs keep what every step reached, `max` and `min` are of all steps, not of the recorded frames.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.lowering.layout import Span
from ropewalk.record.books import told
from ropewalk.record.extremes import had_rope
from ropewalk.record.quantities import BY_NAME
from ropewalk.record.result import Result
from ropewalk.scene import SceneError
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.sweeps.derived import DERIVED, names_along
from ropewalk.words.nearest import nearest

DEFAULT = ("tension.max", "reactions.max", "positions[-1]")
_FORM = re.compile(r"(\w+)\s*(?:\[([^\[\]]*)\])?\s*(?:\.\s*(\w+)\s*(?:\[([^\[\]]*)\])?)?")
_OF_ROPE = ("tension", "elastic_tension", "stretch", "utilisation", "safety_factor")
#: Dimensions that a reducer goes over; anchors, ropes and forms of energy stay apart.
_REDUCED = ("time", "node", "segment")
# NaN stands where there is no rope; a run with others is broken, and not asked.
_REDUCERS: dict[str, tuple[str, Callable[..., Any]]] = {
    "max": ("largest", np.nanmax),
    "min": ("least", np.nanmin),
    "mean": ("mean", np.nanmean),
    "std": ("standard deviation of the", np.nanstd),
    "range": ("largest less least", lambda a, axis: np.nanmax(a, axis) - np.nanmin(a, axis)),
}


_ON_BODIES = "greatest_surface_forces"
#: Of ropes that move by themselves each has its largest at a time of its own.
_SUMS = " (at most, where ropes move by themselves: the sum of what each does)"
#: What of the steps between two frames tells the largest or least of a quantity.
_OF_STEPS = {
    ("tension", "max"): "greatest_tension",
    ("tension", "min"): "least_tension",
    ("utilisation", "max"): "greatest_tension",
    ("safety_factor", "min"): "greatest_tension",
    ("stretch", "max"): "greatest_stretch",
    ("speed", "max"): "greatest_speed",
    ("height", "max"): "greatest_height",
    ("height", "min"): "least_height",
    ("reactions", "max"): "greatest_reactions",
    ("moments", "max"): "greatest_moments",
    ("energy_error", "max"): "energy_errors",
    ("obstacle_load", "max"): _ON_BODIES,
    ("axle_load", "max"): _ON_BODIES,
}


def over(long_name: str) -> str:
    """Return what a variable is the largest, least or mean over, by its name in words; "" of neither."""
    found = long_name.rpartition(", over ")[2] if ", over " in long_name else ""
    return found.removeprefix("the ")


@dataclass(frozen=True)
class Kept:
    """One thing kept of every run; makes one variable of the answer."""

    text: str
    name: str
    quantity: str
    picks: tuple[Any, ...] | None  # a number, a label or None (all) per dimension
    reducer: str | None
    but: tuple[str, ...] = ()  # dimensions that the reducer leaves alone

    @property
    def unit(self) -> str:
        """Unit of the quantity."""
        return _about(self.quantity)[1]

    @property
    def long_name(self) -> str:
        """What the variable is, in words."""
        words = _about(self.quantity)[2]
        if self.reducer is None:
            return words + (f" ({self.text})" if self.picks is not None else "")
        what = f"{_REDUCERS[self.reducer][0]} {words}"
        what += f" ({self.text})" if self.picks is not None else ""  # a part of it alone
        time_too = "time" not in self.but and self._frame() is None
        if time_too and self.of_steps == _ON_BODIES:
            what += _SUMS
        seen = "over all steps" if self.of_steps is not None else "over the recorded frames"
        return f"{what}, {seen}" if time_too else what

    def words(self, at_rest: bool, every_step: bool) -> str:
        """Return what the variable is, in words, of runs that keep what `every_step` reached, or do not.

        An equilibrium has neither steps nor frames.
        """
        if every_step and not at_rest:
            return self.long_name
        name = self.long_name.replace(_SUMS, "")
        if at_rest:
            return f"{name.rpartition(', over')[0] or name}, at rest"
        return name.replace(", over all steps", ", over the recorded frames")

    @property
    def of_steps(self) -> str | None:
        """The recorded quantity that has this of every step; None: there is none, or a frame is asked for."""
        along = len(self.picks) < 3 or self.picks[2] is None if self.picks else True
        if self.reducer is None or self._frame() is not None or not along:
            return None
        return _OF_STEPS.get((self.quantity, self.reducer))

    @property
    def counts_along_ropes(self) -> bool:
        """Whether it is of single nodes or segments, by their places in a result's arrays."""
        dims = _about(self.quantity)[0]
        picked = dict(zip(dims, self.picks or (), strict=False))
        along = [dim for dim in dims if dim in ("node", "segment")]
        gone = self.reducer is not None
        return any(picked.get(dim) is not None or not gone or dim in self.but for dim in along)

    def _frame(self) -> Any:
        return self.picks[0] if self.picks else None

    def of(self, result: Result) -> tuple[Floats, tuple[str, ...]]:
        """Return the value of one run and its dimensions. Raises LookupError for a place not there."""
        dims, _, _ = _about(self.quantity)
        derived = DERIVED.get(self.quantity)
        if self.of_steps is not None and self.of_steps in result.source.names:
            array, dims = result.read(self.of_steps), BY_NAME[self.of_steps].dims
            if "bound" in dims:  # the least and the greatest: the size is the larger one's
                array, dims = np.fmax.reduce(np.abs(array), axis=1), dims[:1]
            if derived is not None:
                array, dims = derived.of_steps(result, array), derived.dims
        elif derived is not None:
            array = derived.of(result)
        elif self.quantity in result.source.names:
            array = told(result, self.quantity, result.read(self.quantity))
        else:
            raise KeyError(f"the runs have no {self.quantity}; there is {_known(result)}")
        whole = dims
        if self.picks is not None:
            array, dims = self._picked(result, array, dims)
        if self.reducer is None:
            return array, dims
        if self.quantity in _OF_ROPE:  # none where there is no rope
            there = result.live if self.of_steps is None else had_rope(result)
            if self.picks is not None:
                there = self._picked(result, there, whole)[0]
            array = np.where(there, array, np.nan)
        return self._reduced(array, dims)

    def _picked(
        self, result: Result, array: NDArray[Any], dims: tuple[str, ...]
    ) -> tuple[NDArray[Any], tuple[str, ...]]:
        assert self.picks is not None
        where: list[Any] = []
        all_dims = dims
        names = names_along(result.layout, result.scene)
        for pick, dim, size in zip(self.picks, all_dims, array.shape, strict=False):
            if pick is None:
                where.append(slice(None))
                continue
            if isinstance(pick, str):
                if pick not in names.get(dim, ()):
                    known = ", ".join(names.get(dim, ())) or "numbers only"
                    raise KeyError(f"there is no {dim} {pick!r}; there is {known}")
                pick = names[dim].index(pick)
            if not -size <= pick < size:
                raise IndexError(f"there is no {dim} {pick}: there are {size}")
            if dim == "segment":
                _refuse_gap(result.layout.ropes, pick, size)
            where.append(pick)
        left = tuple(
            dim
            for number, dim in enumerate(all_dims)
            if number >= len(self.picks) or self.picks[number] is None
        )
        return array[tuple(where)], left

    def _reduced(self, array: Floats, dims: tuple[str, ...]) -> tuple[Floats, tuple[str, ...]]:
        assert self.reducer is not None
        if "axis" in dims:
            array = np.linalg.norm(array, axis=dims.index("axis"))
            dims = tuple(dim for dim in dims if dim != "axis")
        over = tuple(i for i, dim in enumerate(dims) if dim in _REDUCED and dim not in self.but)
        made = _over(_REDUCERS[self.reducer][1], array, over)
        left = tuple(dim for i, dim in enumerate(dims) if i not in over)
        return np.asarray(made, dtype=np.float64), left


def _refuse_gap(spans: Sequence[Span], pick: int, size: int) -> None:
    """Refuse the place between the segments of two ropes, where nothing is. Raises IndexError."""
    for before, after in pairwise(spans):
        if pick % size == before.last:
            rule = (
                f"segment {pick} lies between ropes {before.name} and {after.name}, where there is none: "
                f"{before.name} ends with segment {before.last - 1}, {after.name} begins with {after.first}"
            )
            raise IndexError(rule)


def _over(reduce: Callable[..., Any], array: Floats, axes: tuple[int, ...]) -> Any:
    """Reduce over axes; NaN, without a warning, where there is nothing but NaN."""
    none = np.asarray(np.isnan(array).all(axis=axes, keepdims=True))
    if not none.any():
        return reduce(array, axis=axes)
    made = reduce(np.where(none, 0.0, array), axis=axes)
    return np.where(none.squeeze(axes), np.nan, made)


def _about(quantity: str) -> tuple[tuple[str, ...], str, str]:
    if quantity in DERIVED:
        derived = DERIVED[quantity]
        return derived.dims, derived.unit, derived.long_name
    recorded = BY_NAME[quantity]
    return recorded.dims, recorded.unit, recorded.long_name


def _known(result: Result) -> str:
    return ", ".join((*result.source.names, *DERIVED))


def parse(text: str) -> Kept:
    """Return what a text such as `tension.max` asks for. Raises SceneError."""
    found = _FORM.fullmatch(text.strip())
    if found is None:
        rule = "must be written as tension.max, positions[-1], sag.max[time] or reactions[-1, left]"
        raise SceneError([Fault("keep", text, rule)])
    quantity, picks, reducer, but = found.groups()
    known = [*BY_NAME, *DERIVED]
    if quantity not in known:
        rule = f"there is no quantity {quantity!r}; {nearest(quantity, known)}"
        raise SceneError([Fault("keep", text, rule)])
    dims = _about(quantity)[0]
    if reducer is not None and reducer not in _REDUCERS:
        rule = f"there is no reducer {reducer!r}; {nearest(reducer, list(_REDUCERS))}"
        raise SceneError([Fault("keep", text, rule)])
    left = tuple(part.strip() for part in but.split(",")) if but is not None else ()
    for dim in left:
        if dim not in dims:
            rule = f"{quantity} has no dimension {dim!r}; {nearest(dim, dims)}"
            raise SceneError([Fault("keep", text, rule)])
    places = _places(text, picks, dims) if picks is not None else None
    return Kept(text.strip(), _name(text), quantity, places, reducer, left)


def _places(text: str, picks: str, dims: Sequence[str]) -> tuple[Any, ...]:
    parts = [part.strip() for part in picks.split(",")]
    if len(parts) > len(dims):
        rule = f"has more places than dimensions: {', '.join(dims)}"
        raise SceneError([Fault("keep", text, rule)])
    return tuple(_place(part) for part in parts)


def _place(part: str) -> Any:
    if part in (":", ""):
        return None
    return int(part) if re.fullmatch(r"[-+]?\d+", part) else part


def _name(text: str) -> str:
    """Return the variable's name: `tension_max`, `positions_last`, `positions_all_last`."""
    text = re.sub(r"(?<=[\[,])\s*:?\s*(?=[\],])", "all", text)
    text = re.sub(r"-1(?=\s*[\],])", "last", text)
    text = re.sub(r"-(\d)", r"m\1", text)
    return re.sub(r"\W+", "_", text).strip("_")


def make_keep(keep: Sequence[str] | str | None, anchored: bool) -> tuple[Kept, ...]:
    """Return what is to be kept, each once; by default the maxima and the last frame. Raises SceneError."""
    if keep is None:
        keep = [text for text in DEFAULT if anchored or not text.startswith("reactions")]
    if isinstance(keep, str):
        keep = [keep]
    if not isinstance(keep, Iterable) or isinstance(keep, Mapping):
        rule = 'must be a text such as "tension.max", or a list of them'
        raise SceneError([Fault("keep", keep, rule)])
    made, faults = [], []
    for text in keep:
        try:
            made.append(parse(str(text)))
        except SceneError as error:
            faults += error.faults
    asked: dict[str, Kept] = {}
    for kept in made:
        first = asked.setdefault(kept.name, kept)
        if replace(first, text=kept.text) != kept:
            rule = f"would get the name {kept.name}, which {first.text} has"
            faults.append(Fault("keep", kept.text, rule))
    if not made and not faults:
        faults.append(Fault("keep", NO_VALUE, "is empty: name at least one thing to keep"))
    if faults:
        raise SceneError(faults)
    return tuple(asked.values())
