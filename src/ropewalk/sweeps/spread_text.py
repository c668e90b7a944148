"""Values and spreads as text, for the command line: `1e4,1e5`, `9.5..10.5`, `norm(1e5, 5e3)`."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ropewalk.record.errors import InputError
from ropewalk.scene.toml_text import as_value
from ropewalk.words.nearest import nearest

#: Distributions by their names in scipy.stats, with what they take.
DISTRIBUTIONS = {
    "norm": "mean, standard deviation",
    "uniform": "low, width",
    "lognorm": "shape, loc, scale",
    "triang": "share of the peak, low, width",
    "truncnorm": "a, b, mean, standard deviation",
    "beta": "a, b, low, width",
    "gamma": "a, loc, scale",
    "weibull_min": "c, loc, scale",
}
_MOST = 1_000_000  # values of a grid
_GRIDS: dict[str, Any] = {
    "linspace": np.linspace,
    "logspace": np.logspace,
    "geomspace": np.geomspace,
}
_QUANTITY = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\D.*)?\s*")
_CALL = re.compile(r"(\w+)\((.*)\)")


def parse_all(
    option: str, parse: Callable[[str], tuple[str, Any]], texts: Iterable[str]
) -> dict[str, Any]:
    """Return what `parse` finds in the texts of an option, by path. Raises InputError for one path twice."""
    found: dict[str, Any] = {}
    for text in texts:
        path, what = parse(text)
        if path in found:
            raise InputError(option, text, f"{path} is varied already")
        found[path] = what
    return found


def parse_uncertain(text: str) -> tuple[str, Any]:
    """Return path and spread of `PATH=SPREAD`, per cents as the text they are. Raises InputError.

    SPREAD is a range or a distribution as of `parse_vary`, or per cents of the scene's value, `10 %`.
    """
    path, _, what = text.partition("=")
    if path.strip() and what.strip().endswith("%") and ".." not in what:
        return path.strip(), what.strip()
    try:
        return parse_vary(text)
    except InputError as error:
        rule = error.rule.replace("rope.made_of.EA=1e4,1e5,1e6", "rope.made_of.EA=10%")
        raise InputError("--uncertain", text, rule) from None


def parse_vary(text: str) -> tuple[str, Any]:
    """Return path and values (or spread) of `PATH=WHAT`. Raises InputError.

    WHAT is a list `1e4,1e5,1e6`, a range `9.5..10.5` or `9.5..10.5 m`, a grid `linspace(1, 2, 5)`,
    `logspace(3, 6, 4)`, or a distribution of scipy.stats such as `norm(1e5, 5e3)`; the second number of its
    `uniform(3, 0.5)` is a width.
    """
    path, equals, what = text.partition("=")
    if not equals or not path.strip() or not what.strip():
        rule = "must be written as PATH=WHAT, such as rope.made_of.EA=1e4,1e5,1e6"
        raise InputError("--vary", text, rule)
    return path.strip(), parse_values(what.strip(), text)


def parse_values(what: str, text: str) -> Any:
    """Return the list, range or distribution that a text stands for."""
    if found := _CALL.fullmatch(what):
        return _called(found[1], found[2], text)
    if ".." in what:
        return range_ends(what, text)
    return [_number(part) for part in _parts(what)]


def range_ends(what: str, text: str = "") -> tuple[float, float] | tuple[str, str]:
    """Return both ends, as numbers, or as texts with units: `11.9 m..12.1 m`, or `11.9..12.1 m`.

    Raises InputError, for `text`, which says where it stands.
    """
    if "..." in what:
        raise InputError("--vary", text, "a range has two dots: LOW..HIGH")
    low, _, high = what.partition("..")
    try:
        return float(low), float(high)
    except ValueError:
        first, last = _QUANTITY.fullmatch(low), _QUANTITY.fullmatch(high)
    if first is None or last is None or not last[2]:
        raise InputError("--vary", text, "a range is written LOW..HIGH, or LOW..HIGH UNIT")
    return f"{first[1]} {first[2] or last[2]}", f"{last[1]} {last[2]}"


def _parts(what: str) -> list[str]:
    """Cut at the commas outside brackets."""
    return [part.strip() for part in re.split(r",(?![^\[]*\])", what) if part.strip()]


def _number(part: str) -> Any:
    try:
        return int(part)
    except ValueError:
        pass
    try:
        return float(part)
    except ValueError:
        value = as_value(part)
        return value if isinstance(value, (str, bool, list)) else part


def _called(name: str, given: str, text: str) -> Any:
    try:
        numbers = [float(ast.literal_eval(part)) for part in _parts(given)]
    except (ValueError, SyntaxError, TypeError):
        raise InputError("--vary", text, f"{name}(...) takes numbers") from None
    if name in _GRIDS:
        if len(numbers) != 3 or numbers[2] < 1 or not numbers[2].is_integer():
            rule = (
                f"{name} takes first, last, count"
                if name != "logspace"
                else ("logspace takes the exponents of first and last, and the count")
            )
            raise InputError("--vary", text, rule)
        if numbers[2] > _MOST:
            raise InputError("--vary", text, f"the count must be at most {_MOST}")
        try:
            with np.errstate(all="ignore"):
                made = _GRIDS[name](numbers[0], numbers[1], int(numbers[2]))
        except ValueError as error:
            raise InputError("--vary", text, str(error)) from None
        if not np.isfinite(made).all():
            raise InputError("--vary", text, f"{name} makes numbers that are not finite of these")
        return made.tolist()
    if name not in DISTRIBUTIONS:
        rule = f"there is no {name!r}; {nearest(name, [*DISTRIBUTIONS, *_GRIDS])}"
        raise InputError("--vary", text, rule)
    import scipy.stats

    try:
        made = getattr(scipy.stats, name)(*numbers)
        sound = bool(np.isfinite(made.ppf([0.25, 0.5, 0.75])).all())
    except (TypeError, ValueError):
        sound = False
    if not sound:
        takes = DISTRIBUTIONS[name].split(", ")
        rule = f"{name} takes {DISTRIBUTIONS[name]}"
        if len(numbers) == len(takes) and not numbers[-1] > 0.0:
            rule += f"; the {takes[-1]} must be positive"
        raise InputError("--vary", text, rule)
    return made
