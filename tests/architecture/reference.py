"""What the public names are, and what their docstrings leave out."""

from __future__ import annotations

import ast
import functools
import inspect
import re
import textwrap
from collections.abc import Iterator
from typing import Any

import ropewalk as rw
from ropewalk.analysis.check import Check
from ropewalk.hands.drum import WinchHandle
from ropewalk.hands.hand import AnchorHandle
from ropewalk.live.cell import Replay
from ropewalk.live.view import View
from ropewalk.record.drawing import Plots
from ropewalk.record.rope_view import RopeView
from ropewalk.statics import Statics
from ropewalk.theory import Cable, Hung, Parabola
from ropewalk.vibration.drawing import ModePlots
from ropewalk.vibration.motion import Motion

NAMES = sorted({*rw.__all__, "open"} - {"__version__"})
# Classes that the public names hand out.
HANDED_OUT = (
    AnchorHandle, Cable, Check, Hung, ModePlots, Motion, Parabola, Plots, Replay, RopeView, Statics,
    View, WinchHandle,
)  # fmt: skip

UNIT = re.compile(r"\[(1|1/[a-z]+|[a-zA-Z][a-zA-Z0-9^/ -]*)\]|`1/s`")
SHAPE = re.compile(r"\([\w +]+,( ?[\w.]+,?)*\)")
NUMBERS = re.compile(r"\bfloat\b|Floats|ArrayLike")


def described() -> Iterator[tuple[str, Any]]:
    """Yield every public name, and every public member of a class, with the object."""
    things = {name: getattr(rw, name) for name in NAMES}
    things |= {kind.__name__: kind for kind in HANDED_OUT}
    for name, thing in things.items():
        yield name, thing
        if inspect.isclass(thing):
            for member, function in members(thing).items():
                yield f"{name}.{member}", function


def members(kind: type) -> dict[str, Any]:
    """Return the functions behind the public methods and properties that this package gave a class."""
    found: dict[str, Any] = {}
    for owner in kind.__mro__:
        if not owner.__module__.startswith("ropewalk"):
            continue
        for name, value in vars(owner).items():
            function = getattr(value, "fget", None) or getattr(value, "__func__", value)
            if isinstance(value, functools.cached_property):
                function = value.func
            if not name.startswith("_") and inspect.isfunction(function):
                found.setdefault(name, function)
    return found


def gaps(thing: Any) -> list[str]:
    """Name what a docstring does not say: units, shapes, arguments, what is raised."""
    text = inspect.getdoc(thing) or ""
    if not text:
        return ["there is no docstring"]
    if not inspect.isfunction(inspect.unwrap(thing)):
        return []
    found = []
    signature = inspect.signature(thing)
    returned = str(signature.return_annotation)
    if NUMBERS.search(returned) and not UNIT.search(text):
        found.append(f"no unit of the {returned} returned")
    if "Floats" in returned and not SHAPE.search(text):
        found.append("no shape of the array returned")
    for parameter in signature.parameters.values():
        if parameter.name in ("self", "cls"):
            continue
        if NUMBERS.search(str(parameter.annotation)) and not UNIT.search(text):
            found.append(f"no unit of {parameter.name}")
        if not re.search(rf"\b{parameter.name}\b", text):
            found.append(f"nothing about {parameter.name}")
    return found + [
        f"does not say that it raises {name}" for name in raised(thing) if name not in text
    ]


def raised(function: Any) -> set[str]:
    """Return the names of the errors that a function raises itself."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(inspect.unwrap(function))))
    calls = [node.exc for node in ast.walk(tree) if isinstance(node, ast.Raise)]
    named = {ast.unparse(call.func) for call in calls if isinstance(call, ast.Call)}
    return {name for name in named if name.isidentifier()}
