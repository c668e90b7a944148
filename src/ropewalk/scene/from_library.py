"""Ropes of the library in a scene: a name stands for the numbers, which are then the scene's own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ropewalk.library import LibraryRope, UnknownRope, rope
from ropewalk.library.catalogue import nearest
from ropewalk.scene.base import refuse
from ropewalk.scene.changing import NEEDED, brings_diameter
from ropewalk.scene.faults import Fault
from ropewalk.scene.guess import guess_words

_FROM_SOURCES = (
    *("mass_per_length", "axial_damping", "relaxing_EA", "relaxation_time", "EI"),
    "breaking_load",
)


def entry(name: str) -> tuple[LibraryRope, str]:
    """Return the entry of a name such as "dynamic-single-9.8:static", and its use.

    Raises UnknownRope; ValueError for a use that the entry has not.
    """
    bare, _, use = name.partition(":")
    found = rope(bare)
    found.material_numbers(use)
    return found, use


def filled(data: Any) -> Any:
    """Fill a material's mapping from the library that it names, where it is not whole by itself.

    A whole one stays as it is, so that a scene read again has the numbers that it had, whatever the
    library has by then.
    """
    if not isinstance(data, Mapping) or not data.get("library"):
        return data
    if not isinstance(data["library"], str):
        return data
    if all(key in data for key in NEEDED):
        return _marked(dict(data))
    found, use = _known(data["library"], "library")
    return _marked(found.material_numbers(use) | dict(data))


def _marked(data: dict[str, Any]) -> dict[str, Any]:
    """Mark the numbers that are guesses of the library that a material names, where none are marked."""
    if "guess" in data or "guessed" in data:
        return data
    try:
        found, use = entry(data["library"])
    except (UnknownRope, ValueError):
        return data
    numbers = {field: found.numbers.get(key) for field, key in _keys(use).items()}
    marks = [
        {"of": field, "value": one.value, "low": one.low, "high": one.high}
        for field, one in numbers.items()
        if one is not None and one.guessed and data.get(field) == one.value
    ]
    return data | ({"guess": marks} if marks else {})


def _keys(use: str) -> dict[str, str]:
    """Return which number of the library a field of a material is."""
    return {"EA": "EA_static" if use else "EA"} | {key: key for key in _FROM_SOURCES}


def with_diameter(data: Any) -> Any:
    """Take a name, or a rope of the library, as a rope's `made_of`, with the diameter that it has."""
    if not isinstance(data, Mapping):
        return data
    made_of = data.get("made_of")
    if isinstance(made_of, LibraryRope):
        made_of = made_of.name
    if isinstance(made_of, str):
        made_of = {"library": made_of}
        found, _ = _known(made_of["library"], "made_of")
    elif isinstance(made_of, Mapping) and isinstance(made_of.get("library"), str):
        if not brings_diameter(made_of):
            return data
        found, _ = _known(made_of["library"], "made_of.library")
    else:
        return data
    made_of = {"kind": "material", **made_of}
    return {"diameter": found.diameter, **data, "made_of": made_of}


def _known(name: str, path: str) -> tuple[LibraryRope, str]:
    try:
        return entry(name)
    except UnknownRope:
        rule = f"no such rope in the library; {nearest(name.partition(':')[0])}"
    except ValueError as error:
        rule = str(error).partition(" - ")[2]
    refuse([Fault(path, name, rule)])
    raise AssertionError(name)


def origin(made_of: Any) -> dict[str, Any] | None:
    """Return where a material's numbers are from, or None where it names no rope of the library.

    Numbers that are not the library's, changed in the scene or in a later library, are in `changed`.
    """
    name = getattr(made_of, "library", "")
    if not name:
        return None
    try:
        found, use = entry(name)
    except (UnknownRope, ValueError):
        return {"library": name, "known": False}
    given = found.material_numbers(use)
    about: dict[str, Any] = {"library": name, "title": found.title, "numbers": {}, "changed": []}
    for field, key in _keys(use).items():
        value = getattr(made_of, field)
        if value == given.get(field, type(made_of).model_fields[field].default):
            if field in given:
                about["numbers"][field] = found.numbers[key].as_dict()
        elif key in found.numbers and value == found.numbers[key].value:
            about["numbers"][field] = found.numbers[key].as_dict()  # a guess that was asked for
        else:
            about["changed"].append(field)
    return about


def origin_words(made_of: Any) -> str:
    """Return the same as a sentence without its full stop, with all that is guessed, or ""."""
    about, guessed = origin(made_of), guess_words(made_of)
    changed: list[str] = []
    if about is None:
        text = "given by its numbers" if guessed else ""
    elif not about.get("known", True):
        text = f"said to be {about['library']}, which this library has not"
    else:
        text, changed = f"{about['library']} of the library", about["changed"]
    text += f"; guessed: {guessed}" if guessed else ""
    return text + (f"; changed here: {', '.join(changed)}" if changed else "")
