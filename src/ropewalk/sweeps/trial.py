"""What is found out before a sweep begins: faults at its corners, the shapes of what is kept."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ropewalk.build import Model
from ropewalk.core.arrays import Floats
from ropewalk.record.facts import Facts
from ropewalk.record.quantities import labels, recorded
from ropewalk.record.rest import rest_result
from ropewalk.record.result import Result
from ropewalk.record.source import Memory
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.errors import NO_VALUE, Fault, show
from ropewalk.simulation import Simulation
from ropewalk.statics import NoRest
from ropewalk.sweeps.batch import REST
from ropewalk.sweeps.keep import Kept
from ropewalk.sweeps.parameters import Parameter
from ropewalk.sweeps.plan import Variable
from ropewalk.sweeps.workshop import Workshop

_MOST_CORNERS = 64
#: Reliable ends of a distribution that has none of its own.
_TAIL = 0.001
_TOLD = 20  # faults


@dataclass(frozen=True)
class Trial:
    """What is kept, with its dimensions, and the labels along them."""

    variables: tuple[Variable, ...]
    coordinates: dict[str, dict[str, Any]]
    model: Model  # of the first corner


def corners(parameters: Sequence[Parameter]) -> Iterator[list[Any]]:
    """Yield the corners of the values, at most 64 of them: every least and largest value is in some."""
    ends = [_ends(parameter) for parameter in parameters]
    if 2 ** len(ends) <= _MOST_CORNERS:
        yield from (list(corner) for corner in itertools.product(*ends))
        return
    middle = [pair[0] for pair in ends]
    yield middle
    yield [pair[-1] for pair in ends]
    for place, pair in enumerate(ends[: _MOST_CORNERS - 2]):
        yield [*middle[:place], pair[-1], *middle[place + 1 :]]


def _ends(parameter: Parameter) -> tuple[Any, ...]:
    if parameter.values is not None:
        if parameter.kind == "text":
            return tuple(dict.fromkeys(parameter.values))[:8]
        return tuple(dict.fromkeys((min(parameter.values), max(parameter.values))))
    if isinstance(parameter.spread, tuple):
        return tuple(dict.fromkeys(parameter.spread))
    low, high = (float(parameter.spread.ppf(share)) for share in (_TAIL, 1.0 - _TAIL))
    return (round(low), round(high)) if parameter.kind == "int" else (low, high)


def refuse_values(workshop: Workshop, parameters: Sequence[Parameter], rows: Any = ()) -> None:
    """Refuse values that no scene can have, each by itself, and given runs. Raises SceneError."""
    faults: dict[str, Fault] = {}
    base = [_ends(parameter)[0] for parameter in parameters]
    for place, parameter in enumerate(parameters):
        values = parameter.values if parameter.values is not None else _ends(parameter)
        for value in dict.fromkeys(values):
            _note(workshop, parameters, [*base[:place], value, *base[place + 1 :]], faults)
            if len(faults) >= _TOLD:
                break
    if faults:
        raise SceneError(faults.values())


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
    scene: Scene, parameters: Sequence[Parameter], keep: Sequence[Kept], what: str
) -> Trial:
    """Build the corners of a sweep without running them.

    Raises SceneError with every fault of every corner, each with the values of its corner.
    """
    workshop = Workshop(scene, [p.path for p in parameters], [p.kind for p in parameters])
    refuse_values(workshop, parameters)
    faults: list[Fault] = []
    found: list[tuple[Model, list[tuple[tuple[str, ...], tuple[int, ...]]]]] = []
    for corner in corners(parameters):
        try:
            model = workshop.model(corner)
            found.append((model, _shapes(model, keep, what)))
        except (SceneError, NoRest) as error:
            where = ", ".join(
                f"{p.path}={show(v)}" for p, v in zip(parameters, corner, strict=True)
            )
            told = (
                error.faults if isinstance(error, SceneError) else [Fault("", NO_VALUE, str(error))]
            )
            faults += [
                Fault(fault.path, fault.value, f"{fault.rule} (with {where})") for fault in told
            ]
            if len(faults) >= _TOLD:
                break
    if faults:
        raise SceneError(faults)
    return _trial(found, keep)


def _shapes(
    model: Model, keep: Sequence[Kept], what: str
) -> list[tuple[tuple[str, ...], tuple[int, ...]]]:
    """Return dimensions and sizes of what is kept of a model's run."""
    if what == REST:
        result, frames = rest_result(model), 1
    else:
        simulation = Simulation(model)
        names = tuple(q.name for q in recorded(model.layout, bool(model.scene.winches)))
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
    found: list[tuple[Model, list[tuple[tuple[str, ...], tuple[int, ...]]]]], keep: Sequence[Kept]
) -> Trial:
    first = found[0][0]
    times = [_times(model) for model, _ in found]
    same = all(
        len(time) == len(times[0]) and np.allclose(time, times[0], rtol=1e-9, atol=0.0)
        for time in times
    )
    variables = []
    for place, kept in enumerate(keep):
        dims = tuple("frame" if d == "time" and not same else d for d in found[0][1][place][0])
        sizes = tuple(
            np.max([shapes[place][1] for _, shapes in found], axis=0).astype(int).tolist()
        )
        variables.append(Variable(kept.name, kept.text, dims, sizes, kept.unit, kept.long_name))
    used = {dim for variable in variables for dim in variable.dims}
    coordinates = {dim: about for dim, about in _labels(first).items() if dim in used}
    if "time" in used:
        about = {"units": "s", "long_name": "time"}
        coordinates["time"] = {"values": times[0].tolist(), "attributes": about}
    return Trial(tuple(variables), coordinates, first)


def _times(model: Model) -> Floats:
    plan = model.plan
    return np.float64(1.0) * np.arange(plan.frames + 1) * plan.steps_per_frame * plan.dt


def _labels(model: Model) -> dict[str, dict[str, Any]]:
    names = labels(model.layout) | {"rope": tuple(span.name for span in model.layout.ropes)}
    return {
        dim: {"values": list(values), "attributes": {"long_name": dim}}
        for dim, values in names.items()
        if values
    }
