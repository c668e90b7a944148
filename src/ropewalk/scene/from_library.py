"""Ropes of the library in a scene: a name stands for the numbers, which are then the scene's own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ropewalk.library import LibraryRope, UnknownRope, rope
from ropewalk.library.catalogue import nearest
from ropewalk.library.entry import UNITS
from ropewalk.scene.base import refuse
from ropewalk.scene.faults import Fault
from ropewalk.words.prefixes import prefixed

#: What a material always has; where one of them is missing, the library gives it.
_NEEDED = ("EA", "mass_per_length")
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
    if all(key in data for key in _NEEDED) or not isinstance(data["library"], str):
        return data
    found, use = _known(data["library"], "library")
    return found.material_numbers(use) | dict(data)


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
        if all(key in made_of for key in _NEEDED) or not made_of["library"]:
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
    keys = {"EA": "EA_static" if use else "EA"} | {key: key for key in _FROM_SOURCES}
    about: dict[str, Any] = {"library": name, "title": found.title, "numbers": {}, "changed": []}
    for field, key in keys.items():
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
    """Return the same as a sentence without its full stop, or ""."""
    about = origin(made_of)
    if about is None:
        return ""
    if not about.get("known", True):
        return f"said to be {about['library']}, which this library has not"
    guessed = [
        f"{key} ({prefixed(one['low'], UNITS[key])} to {prefixed(one['high'], UNITS[key])})"
        for key, one in about["numbers"].items()
        if one["quality"] == "guess"
    ]
    text = f"{about['library']} of the library"
    text += f"; guessed there: {', '.join(guessed)}" if guessed else ""
    return text + (f"; changed here: {', '.join(about['changed'])}" if about["changed"] else "")
