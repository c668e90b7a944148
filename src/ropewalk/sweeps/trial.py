"""What is found out before a sweep begins: faults at its corners, the shapes of what is kept."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.record.facts import Facts
from ropewalk.record.quantities import recorded
from ropewalk.record.rest import rest_result
from ropewalk.record.result import Result
from ropewalk.record.source import Memory
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault, show
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest
from ropewalk.sweeps.batch import REST
from ropewalk.sweeps.derived import names_along
from ropewalk.sweeps.designs import GIVEN, Design
from ropewalk.sweeps.keep import Kept
from ropewalk.sweeps.parameters import TEXT, Parameter, spread_in_words
from ropewalk.sweeps.sweep_plan import Variable
from ropewalk.sweeps.workshop import Workshop

_MOST_CORNERS = 64
_MOST_PAIRS = 512
_MOST_VALUES = 256
_MOST_TEXTS = 256
_TOLD = 20  # faults


#: A model, with dimensions and sizes of what is kept of it.
_Tried = tuple[Model, list[tuple[tuple[str, ...], tuple[int, ...]]]]


@dataclass(frozen=True)
class Trial:
    """What is kept, with its dimensions, and the labels along them."""

    variables: tuple[Variable, ...]
    coordinates: dict[str, dict[str, Any]]
    model: Model  # of the first corner


def corners(ends: Sequence[Sequence[Any]]) -> Iterator[list[Any]]:
    """Yield the corners of the values; of more than 64 every end by itself, and up to 512 pairs of ends."""
    if math.prod(map(len, ends)) <= _MOST_CORNERS:
        yield from (list(corner) for corner in itertools.product(*ends))
        return
    base = [values[0] for values in ends]
    yield base
    yield [values[-1] for values in ends]
    for place, values in enumerate(ends):
        for value in values[1:]:
            yield [*base[:place], value, *base[place + 1 :]]
    yield from itertools.islice(_pairs(ends), _MOST_PAIRS)


def _pairs(ends: Sequence[Sequence[Any]]) -> Iterator[list[Any]]:
    """Yield the corners in which two parameters are at other ends than the first: most faults are of two."""
    for one, other in itertools.combinations(range(len(ends)), 2):
        for a, b in itertools.product(ends[one][1:], ends[other][1:]):
            corner = [values[0] for values in ends]
            corner[one], corner[other] = a, b
            yield corner


def _ends(parameter: Parameter, drawn: Sequence[Any] | None) -> tuple[Any, ...]:
    """Return least and largest of a parameter's values, or of those that were drawn; all texts."""
    values = parameter.values if drawn is None else drawn
    assert values is not None
    if parameter.kind == TEXT:
        return tuple(dict.fromkeys(values))[:_MOST_TEXTS]
    wrong = [value for value in values if value != value][:1]  # NaN is neither least nor largest
    return tuple(dict.fromkeys((*wrong, min(values), max(values))))


def _drawn_ends(design: Design) -> list[tuple[Any, ...]]:
    """Return the ends of the values that a sample has drawn."""
    found: list[tuple[Any, ...]] = [() for _ in design.parameters]
    for piece in design.pieces():
        found = [
            _ends(parameter, (*known, *column.tolist()))
            for parameter, known, column in zip(design.parameters, found, piece, strict=True)
        ]
    return found


def _outer_rows(parameters: Sequence[Parameter]) -> Iterator[list[Any]]:
    """Yield those of given runs in which a value is least or largest, and one for every text."""
    columns = [parameter.values or () for parameter in parameters]
    picked = {
        column.index(end)
        for parameter, column in zip(parameters, columns, strict=True)
        for end in _ends(parameter, None)
    }
    yield from ([column[row] for column in columns] for row in sorted(picked))


def value_faults(
    workshop: Workshop, parameters: Sequence[Parameter], ends: Sequence[Sequence[Any]]
) -> dict[str, Fault]:
    """Return what is wrong with values that no scene can have, each by itself.

    Of very many numbers the least, the largest and some between: each costs a tenth of a short run.
    """
    faults: dict[str, Fault] = {}
    base = [values[0] for values in ends]
    for place, parameter in enumerate(parameters):
        values = parameter.values if parameter.values is not None else ends[place]
        before = len(faults)
        distinct = list(dict.fromkeys(values))
        if parameter.kind != TEXT and len(distinct) > _MOST_VALUES:
            between = distinct[:: -(-len(distinct) // _MOST_VALUES)]
            distinct = list(dict.fromkeys((*_ends(parameter, distinct), *between)))
        for value in distinct:
            found: dict[str, Fault] = {}
            _note(workshop, parameters, [*base[:place], value, *base[place + 1 :]], found)
            for text, fault in found.items():
                faults.setdefault(text, _of_draw(fault, parameter, value))
            if len(faults) >= before + _TOLD:
                break
    return faults


def _of_draw(fault: Fault, parameter: Parameter, value: Any) -> Fault:
    """Return a fault of a value that was drawn with where it comes from."""
    spread = parameter.spread
    if spread is None or isinstance(spread, tuple) or fault.value != value:
        return fault
    drawn = (
        f"it was drawn from {spread_in_words(spread)}: take one that ends there, such as truncnorm"
    )
    rule = f"{fault.rule}; {drawn}"
    return replace(fault, rule=rule)


def _note(
    workshop: Workshop,
    parameters: Sequence[Parameter],
    row: list[Any],
    faults: dict[str, Fault],
) -> None:
    try:
        workshop.scene(row)
    except SceneError as error:
        for fault in error.faults:
            faults.setdefault(str(fault), fault)


def try_out(
    scene: Scene,
    parameters: Sequence[Parameter],
    keep: Sequence[Kept],
    what: str,
    design: Design | None = None,
) -> Trial:
    """Build the corners of a sweep without running them.

    Of given runs they are those in which a value is least or largest.

    Raises SceneError with every fault of every corner, each with the values of its corner.
    """
    paths, types = [p.path for p in parameters], [p.kind for p in parameters]
    workshop = Workshop(scene, paths, types, stepped=what != REST)
    drawn = design is not None and design.drawn
    ends = _drawn_ends(design) if design and drawn else [_ends(p, None) for p in parameters]
    given = design is not None and design.kind == GIVEN
    alone = {} if given else value_faults(workshop, parameters, ends)
    faults: dict[str, Fault] = dict(alone)
    found: list[_Tried] = []
    for corner in _outer_rows(parameters) if given else corners(ends):
        try:
            found.append(_tried(workshop, corner, keep, what))
        except (SceneError, NoRest) as error:
            for fault, here in _with_values(error, parameters, corner):
                if str(fault) not in alone:
                    faults[str(here)] = here
            if len(faults) >= len(alone) + _TOLD:
                break
    if faults:
        raise SceneError(faults.values())
    for corner in corners(ends) if given else ():  # only for the largest sizes: no run of the table
        with suppress(SceneError, NoRest):
            found.append(_tried(workshop, corner, keep, what))
    _warn_of_drums([model for model, _ in found], keep)
    return _trial(found, keep, what, parameters)


def _warn_of_drums(models: Sequence[Model], keep: Sequence[Kept]) -> None:
    """Warn where places along ropes are not the same ones in all runs: winches wind more rope or less."""
    spare = {tuple((r.spare_start, r.spare_end) for r in model.layout.ropes) for model in models}
    moved = [kept.text for kept in keep if kept.counts_along_ropes]
    if len(spare) > 1 and moved:
        warnings.warn(
            f"keep: nodes and segments of {', '.join(moved)} are not the same ones in all runs: they count "
            "from what lies on a winch's drum on, and these runs wind more rope or less",
            stacklevel=6,
        )


def _tried(workshop: Workshop, corner: list[Any], keep: Sequence[Kept], what: str) -> _Tried:
    model = workshop.model(corner)
    return model, _shapes(model, keep, what)


def _with_values(
    error: SceneError | NoRest, parameters: Sequence[Parameter], corner: list[Any]
) -> list[tuple[Fault, Fault]]:
    """Return the faults of a corner, each also with its values."""
    pairs = zip(parameters, corner, strict=True)
    where = ", ".join(f"{p.path}={show(value)}" for p, value in pairs)
    told = error.faults if isinstance(error, SceneError) else [Fault("", NO_VALUE, str(error))]
    return [(f, Fault(f.path, f.value, f"{f.rule} (with {where})")) for f in told]


def _shapes(
    model: Model, keep: Sequence[Kept], what: str
) -> list[tuple[tuple[str, ...], tuple[int, ...]]]:
    """Return dimensions and sizes of what is kept of a model's run."""
    if what == REST:
        result, frames = rest_result(model), 1
    else:
        simulation = Simulation(model)
        with np.errstate(all="ignore"):
            simulation.advance_steps(1)  # compiles its kernels, before there are workers that would
        names = tuple(q.name for q in recorded(model.layout, model.scene))
        source = Memory([simulation.recording()], names)
        result = Result(simulation.scene, model.layout, source, Facts(model.plan))
        frames = model.plan.frames + 1
    made = []
    for kept in keep:
        try:
            array, dims = _at_start(kept, frames).of(result)
        except LookupError as error:
            raise SceneError([Fault("keep", kept.text, str(error).strip("'\""))]) from None
        sizes = zip(dims, array.shape, strict=True)
        made.append((dims, tuple(frames if dim == "time" else size for dim, size in sizes)))
    return made


def _at_start(kept: Kept, frames: int) -> Kept:
    """The same thing of frame 0, after a check that there is the frame it asks for."""
    if not kept.picks or not isinstance(kept.picks[0], int):
        return kept
    frame = kept.picks[0]
    if not -frames <= frame < frames:
        raise IndexError(f"there is no frame {frame}: there are {frames}")
    return replace(kept, picks=(0, *kept.picks[1:]))


def _trial(
    found: list[_Tried], keep: Sequence[Kept], what: str, parameters: Sequence[Parameter]
) -> Trial:
    first = found[0][0]
    times = [np.zeros(1) if what == REST else _times(model) for model, _ in found]
    same = all(
        len(time) == len(times[0]) and np.allclose(time, times[0], rtol=1e-9, atol=0.0)
        for time in times
    ) and (what == REST or not _rounded_between([model for model, _ in found], parameters))
    every_step = all(model.scene.run.extremes for model, _ in found)
    variables = []
    for place, kept in enumerate(keep):
        dims = tuple("frame" if d == "time" and not same else d for d in found[0][1][place][0])
        sizes = tuple(
            np.max([shapes[place][1] for _, shapes in found], axis=0).astype(int).tolist()
        )
        words = kept.words(at_rest=what == REST, every_step=every_step)
        variables.append(Variable(kept.name, kept.text, dims, sizes, kept.unit, words))
    used = {dim for variable in variables for dim in variable.dims}
    coordinates = {dim: about for dim, about in _labels(first).items() if dim in used}
    if "time" in used:
        about = {"units": "s", "long_name": "time"}
        coordinates["time"] = {"values": times[0].tolist(), "attributes": about}
    return Trial(tuple(variables), coordinates, first)


def _rounded_between(models: Sequence[Model], parameters: Sequence[Parameter]) -> bool:
    """Tell whether runs between the corners may have frames at other times though the corners do not.

    With exact steps a frame is rounded to a whole number of them, by every step otherwise.
    """
    if all(model.scene.run.steps != "exact" for model in models):
        return False
    varied = (p for p in parameters if p.path.removeprefix("run.") in ("time_step", "frame_rate"))
    return any(p.values is None or len(set(p.values)) > 2 for p in varied)


def _times(model: Model) -> Floats:
    plan = model.plan
    return np.float64(1.0) * np.arange(plan.frames + 1) * plan.steps_per_frame * plan.dt


def _labels(model: Model) -> dict[str, dict[str, Any]]:
    names = names_along(model.layout, model.scene)
    return {
        dim: {"values": list(values), "attributes": {"long_name": dim}}
        for dim, values in names.items()
        if values
    }
