"""The library's files: one TOML file for each family, and one of sources."""

from __future__ import annotations

import difflib
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from ropewalk.library.entry import LABEL_UNITS, QUALITIES, UNITS, LibraryRope, Number

_SOURCES = "sources.toml"


class UnknownRope(LookupError):  # noqa: N818 - it is what happened, not a mistake
    """The library has no rope of that name."""


def rope(name: str) -> LibraryRope:
    """Return the rope of the library called `name`; the command `ropewalk ropes` lists all.

    Raises UnknownRope, naming the nearest one.
    """
    known = _all()
    if name not in known:
        raise UnknownRope(f'rope: "{name}" - no such rope in the library; {nearest(name)}')
    return known[name]


def nearest(name: str) -> str:
    """Return what to say of a name that is not known."""
    found = difflib.get_close_matches(str(name).lower(), names(), n=3, cutoff=0.5)
    if found:
        return "did you mean " + " or ".join(f'"{one}"' for one in found) + "?"
    return "the command `ropewalk ropes` lists all"


def names() -> list[str]:
    """Return the names of all ropes, family by family."""
    return list(_all())


def families() -> list[str]:
    """Return the families, in the order of the list."""
    return list(dict.fromkeys(one.family for one in _all().values()))


def search(words: str) -> list[LibraryRope]:
    """Return the ropes in whose name, title, family or note all of these words stand."""
    wanted = words.lower().split()
    return [
        one
        for one in _all().values()
        if all(word in f"{one.name} {one.title} {one.family} {one.note}".lower() for word in wanted)
    ]


def sources() -> Mapping[str, str]:
    """Return the sources by their tags."""
    return MappingProxyType(_table(_SOURCES))


@cache
def _table(name: str) -> dict[str, Any]:
    return tomllib.loads((files("ropewalk.library") / "ropes" / name).read_text(encoding="utf-8"))


@cache
def _all() -> dict[str, LibraryRope]:
    folder = files("ropewalk.library") / "ropes"
    tables = [_table(f.name) for f in folder.iterdir() if f.name not in (_SOURCES, "__init__.py")]
    found: dict[str, LibraryRope] = {}
    for table in sorted(tables, key=lambda table: int(table["order"])):
        for name, entry in table["rope"].items():
            found[name] = _entry(name, entry, table)
    return found


def _entry(name: str, entry: Mapping[str, Any], table: Mapping[str, Any]) -> LibraryRope:
    """One rope; what it does not say itself is as the table's `[common]` has it."""
    given = {**table.get("common", {}), **entry}
    return LibraryRope(
        name=name,
        title=given["title"],
        family=given.get("family", table["family"]),
        numbers={key: _number(given[key]) for key in UNITS if key in given},
        label={key: _number(one) for key, one in given.get("label", {}).items()},
        note=given.get("note", ""),
    )


def _number(given: Mapping[str, Any]) -> Number:
    return Number(**given)


def faults(table: Mapping[str, Any]) -> list[str]:
    """Return what is wrong with a family's table: keys, qualities, sources, ranges of guesses."""
    found = []
    known = {*UNITS, "title", "family", "label", "note"}
    groups = {"common": table.get("common", {}), **table["rope"]}
    for name, entry in groups.items():
        found += [f"{name}.{key}: unknown" for key in set(entry) - known]
        numbers = {key: entry[key] for key in UNITS if key in entry}
        numbers |= {f"label.{key}": one for key, one in entry.get("label", {}).items()}
        found += [
            f"{name}.label.{key}: unknown" for key in set(entry.get("label", {})) - {*LABEL_UNITS}
        ]
        for key, one in numbers.items():
            found += [f"{name}.{key}: {fault}" for fault in _number_faults(one)]
    return found


def _number_faults(one: Mapping[str, Any]) -> list[str]:
    found = []
    if one.get("quality") not in QUALITIES:
        found.append("no known quality")
    if not one.get("source"):
        found.append("no source")
    tags = str(one.get("source", "")).replace(",", " ").split()
    found += [f"no source {tag}" for tag in tags if tag not in sources()]
    if one.get("quality") == "guess":
        low, high = one.get("low"), one.get("high")
        if low is None or high is None or not low <= one["value"] <= high or low == high:
            found.append("a guess needs a range around it")
    return found
