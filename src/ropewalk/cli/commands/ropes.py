"""`ropewalk ropes`: the rope library."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import print_json, print_table, say
from ropewalk.cli.failures import Refusal
from ropewalk.cli.scene_argument import json_option

if TYPE_CHECKING:
    from ropewalk.library import LibraryRope, Number

_MOST = 8  # ropes side by side
_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"))
_LABELS = {
    "mass_per_length": "mass",
    "EA_static": "EA at rest",
    "axial_damping": "damping",
    "relaxing_EA": "EA that relaxes",
    "relaxation_time": "relaxation time",
    "breaking_load": "breaking load",
    "friction_steel": "friction on steel",
    "friction_rock": "friction on rock",
    "friction_itself": "friction on itself",
    "torque_factor": "torque factor",
    "straight_to": "straight up to a strain of",
}


@click.command()
@click.argument("names", nargs=-1, metavar="[NAME]...")
@click.option("--search", metavar="WORDS", help="List the ropes in which all these words stand.")
@click.option("--family", metavar="WORDS", help="List the ropes of the families of such a name.")
@click.option(
    "--plain", is_flag=True, help="Numbers in SI without units, those of the --json output."
)
@json_option
def ropes(
    names: tuple[str, ...], search: str | None, family: str | None, plain: bool, as_json: bool
) -> None:
    """List the ropes of the library, show the one called NAME, or compare several.

    A name can stand in a scene, made_of = "wire-7x19-10", and in --set rope.made_of=wire-7x19-10. Every
    number has a source; guesses are marked with ~ and have a range.
    """
    from ropewalk import library

    if names and (search is not None or family is not None):
        raise Refusal("give either names or --search and --family, not both")
    if len(names) > _MOST:
        raise Refusal(f"{len(names)} names: at most {_MOST} are compared")
    if names:
        chosen = [library.rope(name) for name in names]
        if as_json:
            print_json({"ropes": [one.as_dict() for one in chosen]})
        elif len(chosen) == 1:
            _show(chosen[0], plain)
        else:
            _compare(chosen, plain)
        return
    found = [
        one
        for one in library.search(search or "")
        if family is None or all(word in one.family.lower() for word in family.lower().split())
    ]
    if as_json:
        print_json({"ropes": [one.as_dict() for one in found]})
        return
    if not found:
        raise Refusal(f"no rope found; the families are: {', '.join(library.families())}")
    _list(found, plain)


_COLUMNS = ("diameter", "mass_per_length", "EA", "breaking_load")


def _list(found: list[LibraryRope], plain: bool) -> None:
    rows = [
        (one.name, *(_cell(one.numbers.get(key), key, plain) for key in _COLUMNS), one.title)
        for one in found
    ]
    heads = [_head(key, plain) for key in _COLUMNS]
    print_table(("rope", *heads, ""), rows, right=range(1, 5))
    count = "1 rope" if len(found) == 1 else f"{len(found)} ropes"
    say(f"{count}; ~ is a guess. ropewalk ropes NAME shows sources and ranges.")


def _show(one: LibraryRope, plain: bool) -> None:
    from ropewalk.library import sources
    from ropewalk.library.entry import LABEL_UNITS, QUALITIES, UNITS

    say(f"{one.name}: {one.title} ({one.family})")
    if one.note:
        say(one.note)
    rows = []
    for group, units in ((one.numbers, UNITS), (one.label, LABEL_UNITS)):
        for key, number in group.items():
            shown = _value(number.value, units[key], plain)
            about = "; ".join(filter(None, (_range(number, units[key], plain), number.note)))
            rows.append((_head(key, plain, units), shown, number.quality, number.source, about))
    print_table(("", "value", "is", "source", "range; remark"), rows, right=[1])
    for text in one.doubts:
        say(text)
    used = {number.quality for number in [*one.numbers.values(), *one.label.values()]}
    for quality, meaning in QUALITIES.items():
        if quality in used:
            say(f"{quality}: {meaning}")
    tags = " ".join(number.source for number in [*one.numbers.values(), *one.label.values()])
    for tag in dict.fromkeys(tags.split()):
        say(f"{tag}: {sources()[tag]}")


def _compare(chosen: list[LibraryRope], plain: bool) -> None:
    from ropewalk.library.entry import LABEL_UNITS, UNITS

    rows = []
    for units, group in ((UNITS, "numbers"), (LABEL_UNITS, "label")):
        for key in units:
            found = [getattr(one, group).get(key) for one in chosen]
            if any(found):
                cells = [_cell(number, key, plain, units) for number in found]
                rows.append((_head(key, plain, units), *cells))
    columns = ["", *(one.name for one in chosen)]
    print_table(columns, rows, right=range(1, len(columns)))
    say("~ is a guess, - is not known. ropewalk ropes NAME shows sources and ranges.")


def _head(key: str, plain: bool, units: Any = None) -> str:
    from ropewalk.library.entry import LABEL_UNITS, UNITS

    unit = (units or UNITS | LABEL_UNITS)[key]
    return f"{key} [{unit}]" if plain else _LABELS.get(key, key.replace("_", " "))


def _cell(number: Number | None, key: str, plain: bool, units: Any = None) -> str:
    from ropewalk.library.entry import UNITS

    if number is None:
        return "-"
    return ("~" if number.guessed else "") + _value(number.value, (units or UNITS)[key], plain)


def _value(value: float, unit: str, plain: bool) -> str:
    """A number as people write it: 12 mm, 63 g/m, 4.92 MN."""
    if plain:
        return f"{value:.4g}"
    if unit == "1":
        return f"{value:.3g}"
    if unit == "m":
        return f"{1e3 * value:.4g} mm" if value >= 1e-5 else f"{1e6 * value:.4g} um"
    if unit == "kg/m" and value < 1.0:
        return f"{1e3 * value:.4g} g/m" if value >= 1e-6 else f"{1e9 * value:.4g} ug/m"
    for size, prefix in _PREFIXES:
        if unit[0] == "N" and abs(value) >= size:
            return f"{value / size:.4g} {prefix}{unit}"
    return f"{value:.4g} {unit}"


def _range(number: Number, unit: str, plain: bool) -> str:
    if number.low is None or number.high is None:
        return ""
    return f"{_value(number.low, unit, plain)} to {_value(number.high, unit, plain)}"
