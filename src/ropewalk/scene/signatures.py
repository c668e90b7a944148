"""Signatures and docstrings of scene models, made from their fields: name, type, unit, default, meaning."""

from __future__ import annotations

import inspect
import types
from collections.abc import Iterator
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from ropewalk.words.annotations import Bare


def signature(model: type[BaseModel]) -> inspect.Signature:
    """The signature of a model in Python; its `kind` needs not be given."""
    return inspect.Signature(
        [
            inspect.Parameter(
                name,
                inspect.Parameter.KEYWORD_ONLY,
                default=inspect.Parameter.empty if field.is_required() else _default(field),
                annotation=Bare(_type(field.annotation)),
            )
            for name, field in _given(model)
        ]
    )


def docstring(model: type[BaseModel], about: str) -> str:
    """The docstring of a model: what it is, then every field."""
    lines = [inspect.cleandoc(about), ""]
    fields = list(_given(model))
    if fields:
        lines += ["Args:", *(f"    {name}{_meaning(field)}" for name, field in fields), ""]
    return "\n".join([*lines, "Raises SceneError, with every fault named at once."])


def _given(model: type[BaseModel]) -> Iterator[tuple[str, FieldInfo]]:
    return ((name, field) for name, field in model.model_fields.items() if name != "kind")


def _meaning(field: FieldInfo) -> str:
    extra = field.json_schema_extra
    unit = f" ({extra['unit']})" if isinstance(extra, dict) and "unit" in extra else ""
    usual = "needed" if field.is_required() else f"default {_default(field)!r}"
    return f"{unit}: {str(field.description).rstrip('.')}; {usual}."


def _default(field: FieldInfo) -> Any:
    default = field.default
    if isinstance(default, BaseModel):
        return Bare(f"{type(default).__name__}()")
    return default


def _type(annotation: Any) -> str:
    """What may be given, in words of Python."""
    origin = get_origin(annotation)
    if origin is Annotated:
        return _type(get_args(annotation)[0])
    if origin in (Union, types.UnionType):
        return " | ".join(dict.fromkeys(_type(member) for member in get_args(annotation)))
    if origin is Literal:
        return " | ".join(repr(value) for value in get_args(annotation))
    if origin is tuple:
        inside = get_args(annotation)
        return f"Sequence[{_type(inside[0])}]"
    return "None" if annotation is type(None) else str(annotation.__name__)
