"""Finding one's way in the scene models: which field stands where, and what it is called."""

from __future__ import annotations

import types
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

from pydantic import AliasChoices, BaseModel
from pydantic.fields import FieldInfo

from ropewalk.scene.faults import join

ModelType = type[BaseModel]
M = TypeVar("M", bound=ModelType)
_roots: list[ModelType] = []


def root_of_paths(model: M) -> M:
    """Say of a model that all paths begin at it: a decorator of `Scene`, which knows its parts itself."""
    _roots[:] = [model]
    return model


@dataclass(frozen=True)
class Kind:
    """What a field holds: one or more models (told apart by ``kind``), or plain values."""

    models: tuple[ModelType, ...]
    listed: bool
    optional: bool


def toml_name(name: str, field: FieldInfo) -> str:
    """The key of a field in TOML."""
    alias = field.validation_alias
    return str(alias.choices[0]) if isinstance(alias, AliasChoices) else name


@cache
def keys(model: ModelType) -> dict[str, FieldInfo]:
    """The fields of a model by their keys in TOML."""
    return {toml_name(name, field): field for name, field in model.model_fields.items()}


def section_with(model: ModelType, key: str) -> str:
    """Return the path of the first table below a model's that has a key which the model has not, or "".

    Every scene has ropes: below a scene itself their tables are looked through too, as "rope" and
    "rope.made_of". "kind" is in too many tables for one to be meant.
    """
    if key == "kind":
        return ""
    for name, field in keys(model).items():
        kind = kind_of(field)
        if not kind.listed and any(key in keys(one) for one in kind.models):
            return name
    if model in _roots:
        (rope,) = kind_of(keys(model)["rope"]).models
        inner = section_with(rope, key)
        return "rope" if key in keys(rope) else join("rope", inner) if inner else ""
    return ""


def kind_of(field: FieldInfo) -> Kind:
    """What a field holds."""
    return _kind(field.annotation)


def _kind(annotation: Any) -> Kind:
    models: list[ModelType] = []
    listed = optional = False
    if get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    members = _union(annotation)
    for member in members:
        if member is type(None):
            optional = True
        elif isinstance(member, type) and issubclass(member, BaseModel):
            models.append(member)
        elif get_origin(member) is tuple:
            inner = _kind(get_args(member)[0])
            listed, models = True, models + list(inner.models)
        elif get_origin(member) is Annotated:
            inner = _kind(member)
            listed, models = listed or inner.listed, models + list(inner.models)
    return Kind(tuple(models), listed, optional)


def _union(annotation: Any) -> tuple[Any, ...]:
    if get_origin(annotation) in (Union, types.UnionType):
        return get_args(annotation)
    return (annotation,)


def tag(model: ModelType) -> str | None:
    """The ``kind`` of a model that has one."""
    field = model.model_fields.get("kind")
    return None if field is None else str(field.default)


def by_tag(models: Sequence[ModelType], wanted: object) -> ModelType | None:
    """The model whose ``kind`` is the wanted one; a single model needs none."""
    if len(models) == 1:
        return models[0]
    return next((model for model in models if tag(model) == wanted), None)


def siblings(model: ModelType) -> tuple[ModelType, ...]:
    """All the models that may stand where this one stands: the kinds of its union."""
    for _, owner in all_sections():
        for field in owner.model_fields.values():
            models = kind_of(field).models
            if model in models:
                return models
    return (model,)


@dataclass(frozen=True)
class Place:
    """Where pydantic found a fault: the path in TOML, the field, the model that has it."""

    path: str
    field: FieldInfo | None
    owner: ModelType


def place(root: ModelType, location: Sequence[int | str]) -> Place:
    """Translate a pydantic location, in which the tags of unions stand as steps of their own."""
    path, owner, field = "", root, None
    models: tuple[ModelType, ...] = (root,)
    for step in location:
        if isinstance(step, int):
            path += f"[{step}]"
            continue
        if len(models) > 1:
            chosen = by_tag(models, step)
            if chosen is not None:
                models, owner = (chosen,), chosen
                continue
        if len(models) == 1:
            owner = models[0]
            field = keys(owner).get(step) or owner.model_fields.get(step)
            name = toml_name(step, field) if field is not None else step
            path = join(path, name)
            models = kind_of(field).models if field is not None else ()
            continue
        break  # a step inside a plain value (a branch of a union): it names no key
    return Place(path, field, owner)


@cache
def sections(root: ModelType, prefix: str = "") -> tuple[tuple[str, ModelType], ...]:
    """Every model below the root with its path in TOML, lists written as ``rope``."""
    found = [(prefix, root)]
    for key, field in keys(root).items():
        for model in kind_of(field).models:
            found += sections(model, join(prefix, key))
    return tuple(found)


def all_sections() -> tuple[tuple[str, ModelType], ...]:
    """Every model of a scene with its path in TOML; none before there is a scene."""
    return sections(_roots[0]) if _roots else ()
