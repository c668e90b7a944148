"""The ground that all scene models stand on: strict frozen models, numbers with units."""

from __future__ import annotations

import inspect
import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, TypeVar, dataclass_transform

from pydantic import (
    AfterValidator,
    AliasChoices,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    Strict,
    ValidationError,
    model_validator,
)
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError

from ropewalk.scene.changing import displaced, replaced
from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.limits import HUGE, TINY
from ropewalk.scene.model_table import as_table
from ropewalk.scene.sentences import faults_of
from ropewalk.scene.signatures import docstring, signature
from ropewalk.scene.units import WrongUnit, in_unit

if TYPE_CHECKING:
    from typing import Self

    from pydantic._internal._model_construction import ModelMetaclass as _PydanticMeta
else:
    _PydanticMeta = type(BaseModel)

#: What a part of a scene may be called.
NAME = r"^[^\W\d_][\w-]*$"


def in_python(value: Any) -> Any:
    """Take a numpy number or array as the Python value it stands for; refuse a wrong unit."""
    if isinstance(value, WrongUnit):
        raise PydanticCustomError("unit", "{rule}", {"rule": value.rule, "given": value.given})
    kind = type(value)
    if kind.__module__ != "builtins" and any(one.__module__ == "numpy" for one in kind.__mro__):
        return value.tolist()
    return value


def _listed(value: Any) -> Any:
    """Take a list, tuple or array; a single model stands for a list of one."""
    value = in_python(value)
    if isinstance(value, BaseModel):
        return (value,)
    if isinstance(value, (set, frozenset, Mapping, str)) or not isinstance(value, Iterable):
        raise PydanticCustomError("tuple_type", "a list is needed")
    return tuple(value)


def _triple(value: Any) -> Any:
    """Take a list of three."""
    value = in_python(value)
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise PydanticCustomError("vector", "three numbers are needed")
    return tuple(value)


def _huge_or_inf(value: float) -> float:
    """Refuse numbers above ``HUGE`` other than inf."""
    if HUGE < value < math.inf:
        rule = f"must be at most {HUGE:g}, or inf for links that do not stretch"
        raise PydanticCustomError("too_stiff", rule)
    return value


if TYPE_CHECKING:  # what may be given; what is stored is a tuple
    Number = float
    Stiffness = float
    Whole = int
    Flag = bool
    Text = str
    Vector = Sequence[float]
    Many = Sequence
else:
    _T = TypeVar("_T")
    _list = BeforeValidator(_listed)
    Number = Annotated[float, BeforeValidator(in_python), Strict()]
    Stiffness = Annotated[Number, AfterValidator(_huge_or_inf)]
    Whole = Annotated[int, BeforeValidator(in_python), Strict()]
    Flag = Annotated[bool, BeforeValidator(in_python), Strict()]
    Text = Annotated[str, Strict()]
    _Bounded = Annotated[Number, Field(ge=-HUGE, le=HUGE, allow_inf_nan=False)]
    Vector = Annotated[tuple[_Bounded, _Bounded, _Bounded], BeforeValidator(_triple)]
    Many = Annotated[tuple[_T, ...], _list]


def quantity(description: str, unit: str, *, default: Any = ..., **rules: Any) -> Any:
    """A finite number with a unit, of a magnitude of at most ``HUGE``."""
    bounds = {"ge": -HUGE, "le": HUGE, "allow_inf_nan": False} | rules
    return Field(default, description=description, json_schema_extra={"unit": unit}, **bounds)


def positive(description: str, unit: str, *, default: Any = ..., **rules: Any) -> Any:
    """A number greater than zero with a unit."""
    return quantity(description, unit, default=default, **({"gt": 0, "ge": TINY} | rules))


def stiffness(description: str, unit: str) -> Any:
    """A number greater than zero with a unit, or inf."""
    return positive(description, unit, le=None, allow_inf_nan=None)


def not_negative(description: str, unit: str, *, default: Any = ...) -> Any:
    """A number of at least zero with a unit."""
    return quantity(description, unit, default=default, ge=0)


def stop_time() -> Any:
    """The time at which a motion, a turn or a winch stops [s]; by default never."""
    text = "Time at which it stops (inf: never)"
    return quantity(text, "s", default=math.inf, ge=0, le=math.inf, allow_inf_nan=True)


def vector(description: str, unit: str, *, default: Any = ...) -> Any:
    """Three finite numbers x, y, z with a unit."""
    return Field(default, description=description, json_schema_extra={"unit": unit})


def node_number() -> Any:
    """The number of a node of a rope."""
    text = "Node, counted from 0 at the rope's start; negative counts back from its end"
    return Field(description=text, json_schema_extra={"unit": "1"})


def listed(description: str, toml: str, python: str, *, default: tuple[()]) -> Any:
    """A list of tables, ``[[toml]]`` in a file and ``python=[...]`` in Python."""
    return Field(
        default=default,
        description=description,
        validation_alias=AliasChoices(toml, python),
        serialization_alias=toml,
    )


@cache
def units_of(model: type[BaseModel]) -> dict[str, str]:
    """Return the units of a model's quantities, by name."""
    pairs = ((name, unit_of(field)) for name, field in model.model_fields.items())
    return {name: unit for name, unit in pairs if unit is not None}


def unit_of(field: FieldInfo) -> str | None:
    """Return the unit of a field; None of a count, and of what is no quantity."""
    extra = field.json_schema_extra
    unit = extra.get("unit") if isinstance(extra, Mapping) else None
    return unit if field.annotation is not int and isinstance(unit, str) else None


def refuse(faults: Iterable[Fault]) -> None:
    """Raise, inside a pydantic validator, all the faults found (paths relative to the model)."""
    found = list(faults)
    if found:
        text = "; ".join(str(fault).replace("{", "{{").replace("}", "}}") for fault in found)
        raise PydanticCustomError("faults", text, {"faults": found})


# Type checkers take these for fields, and one without `default=` for a field that must be given.
@dataclass_transform(
    kw_only_default=True,
    frozen_default=True,
    field_specifiers=(
        Field, quantity, positive, stiffness, not_negative, vector, node_number, listed
    ),
)  # fmt: skip
class _Sentences(_PydanticMeta):
    """Turns pydantic's errors into SceneError where a model is made by calling its class.

    A metaclass and not ``__init__``: pydantic then keeps its direct way to nested models,
    and reports all their faults together.
    """

    if not TYPE_CHECKING:

        def __call__(cls, *args: Any, **data: Any) -> Any:  # noqa: N805
            try:
                return super().__call__(*args, **data)
            except ValidationError as error:
                raise cls._scene_error(error, data, None) from None


class Model(BaseModel, metaclass=_Sentences):
    """A frozen, validated part of a scene; equal when all fields are equal.

    Raises:
        SceneError: on creation, naming every faulty field at once.
    """

    model_config = ConfigDict(
        frozen=True, extra="forbid", populate_by_name=True, use_attribute_docstrings=False
    )

    @model_validator(mode="before")
    @classmethod
    def _without_units(cls, data: Any) -> Any:
        """Take quantities with a unit, such as "12 mm", as numbers in the field's own unit."""
        if not isinstance(data, Mapping):
            return data
        units, changed = units_of(cls), dict(data)
        for name, value in data.items():
            if name in units and not isinstance(value, bool | int | float):
                changed[name] = in_unit(value, units[name])
        return changed

    #: What the model is, without its fields.
    about: ClassVar[str] = ""

    @classmethod
    def __pydantic_init_subclass__(cls, **options: Any) -> None:
        cls.about = inspect.cleandoc(cls.__doc__ or "")
        cls.__doc__ = docstring(cls, cls.about)
        cls.__signature__ = signature(cls)

    @classmethod
    def __get_pydantic_json_schema__(cls, core_schema: Any, handler: Any) -> Any:
        """The JSON Schema, whose properties have meanings of their own."""
        made = handler.resolve_ref_schema(handler(core_schema))
        return made | {"description": cls.about}

    @classmethod
    def model_validate(cls, obj: Any, **options: Any) -> Self:
        """Make the model from a mapping ``obj`` (as TOML gives it).

        ``options`` are pydantic's; ``context={"folder": ...}`` says what file names are relative to.

        Raises:
            SceneError: with every fault of the mapping.
        """
        try:
            return super().model_validate(obj, **options)
        except ValidationError as error:
            raise cls._scene_error(error, obj, options.get("context")) from None

    def derived(self) -> frozenset[str]:
        """Names of fields that follow from others, which files leave out."""
        return frozenset()

    def table(self) -> dict[str, Any]:
        """The model as nested dicts and lists with TOML keys, defaults left out."""
        return as_table(self)

    def as_said(self) -> dict[str, Any]:
        """The same table, without what follows from other values and is asked anew when they change."""
        return self.table()

    def replace(self, **changes: Any) -> Self:
        """A validated copy with some fields changed: ``changes`` gives them by name.

        A path reaches deeper, as ``--set`` does on the command line:
        ``scene.replace(**{"rope.made_of.spring_constant": 200.0})`` (every rope), ``"rope[1].segments"``
        or ``"rope.left.segments"`` (one of them), ``"run.duration"``.

        Another rope of the library, named as ``made_of``, brings its diameter along (a `Material` has none);
        another ``library`` of a material, or another ``file``, takes the numbers of the old one away.

        Raises:
            SceneError: when a path leads nowhere, or the changed model is faulty.
        """
        if any("." in name or "[" in name for name in changes):
            return replaced(self, changes)
        kept = {name: getattr(self, name) for name in self.model_fields_set}
        for key, value in changes.items():
            for other in displaced(kept, key, value):
                del kept[other]
        return type(self)(**(kept | changes))

    @classmethod
    def _scene_error(cls, error: ValidationError, data: Any, context: Any) -> SceneError:
        faults = faults_of(cls, error)
        known = {fault.path for fault in faults}
        more = cls._more_faults(data, context)
        return SceneError(faults + [fault for fault in more if fault.path not in known])

    @classmethod
    def _more_faults(cls, data: Any, context: Any) -> list[Fault]:
        """Faults that pydantic did not get to, because it stops at the first faulty level."""
        return []
