"""What a page may ask for: every command as a strict model. See docs/reference/live-protocol.md."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from ropewalk.live.parameters import refusal
from ropewalk.scene import Fault, SceneError

FAR = 1e6  # [m], [m/s]: no place and no speed that a hand gives is larger
LONGEST_TEXT = 200_000
MOST_VARIANTS = 4
LARGEST_ID = 2**53


def _number(value: Any) -> Any:
    """Take whole numbers for numbers, but neither true nor text."""
    if isinstance(value, int) and not isinstance(value, bool):
        return float(value) if abs(value) < 1e300 else math.inf
    return value


Number = Annotated[float, BeforeValidator(_number), Field(strict=True, allow_inf_nan=False)]
Coordinate = Annotated[Number, Field(ge=-FAR, le=FAR)]
Vector = tuple[Coordinate, Coordinate, Coordinate]
Pace = Annotated[Number, Field(ge=0.0, le=100.0)]  # simulated seconds in one of the user's
Index = Annotated[int, Field(strict=True, ge=0, le=100_000_000)]
Name = Annotated[str, Field(strict=True, max_length=100)]
Id = Annotated[int, Field(strict=True, ge=0, le=LARGEST_ID)]
Value = bool | int | float | str | list[Any] | None


class Command(BaseModel):
    """What all commands have."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    type: str
    id: Id | None = None


class Ack(Command):
    type: Literal["ack"]
    frame: Index


class Play(Command):
    type: Literal["play"]


class Pause(Command):
    type: Literal["pause"]


class Step(Command):
    type: Literal["step"]
    count: Annotated[int, Field(strict=True, ge=1, le=10_000)] = 1


class Speed(Command):
    type: Literal["speed"]
    value: Annotated[Number, Field(ge=0.01, le=4.0)]


class Reset(Command):
    type: Literal["reset"]
    all: bool = False


class Set(Command):
    type: Literal["set"]
    name: Name
    value: Value
    rope: Name | None = None
    variant: Annotated[int, Field(strict=True, ge=0, lt=MOST_VARIANTS)] | None = None


class Move(Command):
    type: Literal["move"]
    anchor: Name
    velocity: Vector


class Drag(Command):
    type: Literal["drag"]
    anchor: Name
    target: Vector
    pace: Pace = 1.0


class Drop(Command):
    type: Literal["drop"]
    anchor: Name


class Obstacle(Command):
    """A hand leads an obstacle to a place, or turns it; `begin` in the first command of a stroke."""

    type: Literal["obstacle"]
    obstacle: Name
    target: Vector | None = None
    angle: Annotated[Number, Field(ge=-FAR, le=FAR)] | None = None
    pace: Pace = 1.0
    begin: Annotated[bool, Field(strict=True)] = True


class Grab(Command):
    type: Literal["grab"]
    node: Index
    target: Vector
    pace: Pace = 1.0
    limit: Annotated[Number, Field(gt=0.0, le=1e12)] | None = None


class LetGo(Command):
    type: Literal["let_go"]
    node: Index | None = None
    velocity: Vector | None = None


class Pin(Command):
    type: Literal["pin"]
    node: Index


class Unpin(Command):
    type: Literal["unpin"]
    anchor: Name | None = None
    node: Index | None = None


class Cut(Command):
    type: Literal["cut"]
    segment: Index


class Untie(Command):
    type: Literal["untie"]
    joint: Name


class Tie(Command):
    type: Literal["tie"]
    node: Index
    other: Index


class Knot(Command):
    """What a session does by itself where points that are to be tied have met, or do not meet."""

    type: Literal["knot"]


class Load(Command):
    type: Literal["load"]
    node: Index
    mass: Number


class Kick(Command):
    type: Literal["kick"]
    node: Index
    velocity: Vector


class SceneCommand(Command):
    type: Literal["scene"]
    preset: Name | None = None
    toml: Annotated[str, Field(max_length=LONGEST_TEXT)] | None = None
    address: Annotated[str, Field(max_length=LONGEST_TEXT)] | None = None


class Variant(BaseModel):
    """A copy to compare with: what is different in it."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    label: Annotated[str, Field(max_length=80)] = ""
    changes: Annotated[dict[Name, Value], Field(max_length=30)]


class Compare(Command):
    type: Literal["compare"]
    variants: Annotated[list[Variant], Field(max_length=MOST_VARIANTS - 1)]


class Back(Command):
    type: Literal["back"]
    seconds: Annotated[Number, Field(ge=0.0, le=1e6)] | None = None


class Undo(Command):
    type: Literal["undo"]


class Remedy(Command):
    type: Literal["remedy"]
    remedy: Literal["back", "step", "implicit", "on"]


class Listen(Command):
    type: Literal["listen"]
    on: Annotated[bool, Field(strict=True)]


class Save(Command):
    type: Literal["save"]


COMMANDS: dict[str, type[Command]] = {
    str(model.model_fields["type"].annotation.__args__[0]): model  # type: ignore[union-attr]
    for model in (
        Ack, Play, Pause, Step, Speed, Reset, Set, Move, Drag, Drop, Obstacle, Grab, LetGo, Pin, Unpin, Cut,
        Untie, Tie, Knot, Load, Kick, SceneCommand, Compare, Back, Undo, Remedy, Listen, Save,
    )
}  # fmt: skip
# Those that change the simulation, and so are kept in a session's log.
PHYSICAL = frozenset(
    [
        "speed",
        "reset",
        "set",
        "move",
        "drag",
        "drop",
        "obstacle",
        "grab",
        "let_go",
        "pin",
        "unpin",
        "cut",
        "untie",
        "tie",
        "knot",
        "load",
        "kick",
        "scene",
        "compare",
        "back",
        "undo",
        "remedy",
    ]
)


def parse(data: Any) -> Command:
    """Return the command of a message. Raises SceneError with every fault and what is allowed."""
    if not isinstance(data, dict):
        raise refusal("message", data, "must be a JSON object")
    kind = data.get("type")
    if not isinstance(kind, str) or kind not in COMMANDS:
        raise refusal("type", kind, "must be one of " + ", ".join(COMMANDS))
    try:
        return COMMANDS[kind].model_validate(data)
    except ValidationError as error:
        raise SceneError([_fault(item) for item in error.errors(include_url=False)]) from None


def _fault(item: Any) -> Fault:
    """One of pydantic's errors in the words of the scene's."""
    path = "".join(f"[{at}]" if isinstance(at, int) else f".{at}" for at in item["loc"])
    context = item.get("ctx") or {}
    low, high = context.get("ge", context.get("gt")), context.get("le", context.get("lt"))
    rule = str(item["msg"])
    if item["type"] == "missing":
        rule = "is needed"
    elif item["type"] == "extra_forbidden":
        rule = "unknown key"
    elif low is not None:
        rule = f"must be at least {low:g}"
    elif high is not None:
        rule = f"must be at most {high:g}"
    return Fault(path.lstrip("."), item["input"], rule)
