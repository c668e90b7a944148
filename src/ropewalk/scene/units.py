"""Quantities with units, "5.65 MN" or pint's own, as numbers in the unit that a field is stored in."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

_LONGEST = (
    60  # characters; a number and a unit need few, and pint's reader takes its time over many
)
_MANY = 64  # parts of a list; longer ones without a text are numbers from elsewhere, and stay as they are
_NUMBER = r"[+-]?(?:\d+(?:_\d+)*\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?"
_POWER = r"(?:(?:\*\*|\^)-?\d)?"
_NAME = r"[A-Za-zµμΩ°%²³]+"
_UNIT = rf"{_NAME}{_POWER}(?:\s*[*/·]\s*{_NAME}{_POWER}|\s+{_NAME}{_POWER})*"
_QUANTITY = re.compile(rf"\s*({_NUMBER})\s*((?:1/)?(?:1|{_UNIT}))\s*")
#: The JSON Schema of a text with a number and a unit; whether that is of the right kind it cannot say.
TEXT_SCHEMA = {
    "title": "Quantity",
    "description": "A number with a unit of its own",
    "examples": ["5.65 MN", "12 mm", "5 %"],
    "type": "string",
    "maxLength": _LONGEST,
    "pattern": rf"^\s*{_NUMBER}\s*(1/)?{_UNIT}\s*$",
}
_BARE = re.compile(rf"\s*(?>{_NUMBER})\s*")
_SEVERAL = re.compile(rf"\s*(?>{_NUMBER})(?:(?>\s*[,;]\s*|\s+)(?>{_NUMBER}))+\s*")
#: Newtons times metres or seconds without a sign between them, which pint takes for a count of yarn
#: (Nm) and for newtons (Ns), and what stands before them.
_RUN_ON = re.compile(r"(/\s*|(?<![A-Za-zµμ]))((?:da|[µμmkMG])?N)(ms|m|s)(?![A-Za-zµμΩ])")
#: Without a word more it is the 2000 lb of one country, to pint as well, and the 1000 kg of all others.
_TON = re.compile(r"\b(?:[kM]|kilo|mega)?tons?\b")
_FRACTION = re.compile(r"\s*[+-]?(?:\d+[\s-])?\s*\d+\s*/\s*\d+")


class WrongUnit:
    """What was given in place of a number, and why it is none; the field's own check tells it."""

    def __init__(self, given: Any, rule: str) -> None:
        self.given, self.rule = given, rule


def in_unit(value: Any, unit: str) -> Any:
    """Return a text such as "12 mm", or pint's quantity, as a number of `unit`; lists part by part.

    Anything else is returned as it is; a WrongUnit stands for what cannot be.
    """
    if isinstance(value, str):
        return _from_text(value, unit)
    if isinstance(value, list | tuple) and (len(value) <= _MANY or _has_text(value)):
        parts = [in_unit(part, unit) for part in value]
        wrong = next((part for part in parts if isinstance(part, WrongUnit)), None)
        return wrong or tuple(parts)
    if hasattr(value, "dimensionality") and hasattr(value, "to"):
        return _converted(value, unit, str(value))
    return value


def _has_text(value: list[Any] | tuple[Any, ...]) -> bool:
    """Return whether a list has a text in it, or in one of its lists."""
    return any(
        isinstance(part, str) or (isinstance(part, list | tuple) and _has_text(part))
        for part in value
    )


def _are_several(text: str) -> bool:
    """Return whether a text is several numbers; one comma without a space is that of decimals."""
    apart = len(text.split()) > 1 or text.count(",") > 1 or ";" in text
    return apart and _SEVERAL.fullmatch(text) is not None


def _from_text(text: str, unit: str) -> Any:
    head = text.strip()[:1]
    if not (head.isdigit() or head in "+-.") or not any(c.isdigit() for c in text):
        return text  # a word, such as "auto"
    if _BARE.fullmatch(text):
        return text  # a number in quotes, which the field refuses
    found = _QUANTITY.fullmatch(text) if len(text) <= _LONGEST else None
    if len(text) <= _LONGEST and _are_several(text):
        numbers = ", ".join(re.findall(_NUMBER, text))
        rule = f"is more than one number; write a list, [{numbers}], or one alone"
        return WrongUnit(text, rule)
    if found is None:
        rule = f"is no number with a unit; write it as {_example(unit)}"
        decimals = "," in text or _FRACTION.match(text)
        return WrongUnit(text, rule + (", with a point for the decimals" if decimals else ""))
    if "%" in found[2] and found[2].strip() != "%":
        return WrongUnit(text, f"has % beside another unit; write it as {_example(unit)}")
    if _TON.search(found[2]):
        rule = "has a ton, which may be of 1000 kg or of 2000 lb: write it in t, kg or lb"
        return WrongUnit(text, rule)
    import pint

    try:
        units = _registry().parse_units(_readable(found[2]))
        return _converted(_registry().Quantity(float(found[1]), units), unit, text)
    except pint.UndefinedUnitError as error:
        names = ", ".join(repr(name) for name in error.unit_names)
        return WrongUnit(
            text, f"has a unit that is not known, {names}; write it as {_example(unit)}"
        )
    except (pint.PintError, ValueError, TypeError, AttributeError):
        return WrongUnit(text, f"has a unit that cannot be read; write it as {_example(unit)}")


def _readable(unit: str) -> str:
    """Return a unit as pint reads it."""
    unit = _RUN_ON.sub(_apart, unit)
    for sign, word in (("^", "**"), ("·", "*"), ("%", "percent"), ("°", "degree")):
        unit = unit.replace(sign, word)
    return unit


def _apart(found: re.Match[str]) -> str:
    """Return newtons times metres or seconds with the signs between them; all are divided by after a "/"."""
    return found[1] + ("/" if found[1] else "*").join((found[2], *found[3]))


def _converted(quantity: Any, unit: str, given: str) -> Any:
    """Return the quantity as a number of `unit`, or what is wrong with it."""
    registry = quantity._REGISTRY
    target = registry.parse_units("dimensionless" if unit == "1" else unit.replace("^", "**"))
    if quantity.dimensionality == target.dimensionality and _turns(quantity) == _turns(target):
        try:
            number = quantity.to(target).magnitude
            return number.tolist() if hasattr(number, "tolist") else float(number)
        except Exception:  # of units with a zero of their own, such as degrees Celsius
            return WrongUnit(given, f"cannot be converted to {unit}")
    force = registry.parse_units("kgf / kg")
    per_mass = (
        target.dimensionality == (registry.Quantity(1.0, quantity.units) * force).dimensionality
    )
    hint = "; a weight is written in kgf or lbf" if per_mass else ""
    if unit == "kg" and registry.parse_units("N").dimensionality == quantity.dimensionality:
        hint = "; a mass is written in kg or lb"
    kind = f"a quantity in {unit}" if unit != "1" else "a plain number or a share such as 5 %"
    return WrongUnit(given, f"is of another kind: {kind} is needed{hint}")


def _turns(value: Any) -> float:
    """Return the power of an angle in a quantity or unit: pint takes 1 Hz for 1 rad/s, which it is not."""
    return float(dict((1.0 * value).to_root_units().unit_items()).get("radian", 0.0))


def _example(unit: str) -> str:
    known = {"N": '"5.65 MN"', "m": '"12 mm"', "kg/m": '"63 g/m"', "s": '"20 ms"', "kg": '"80 kg"'}
    return known.get(unit, f'"2.5 {unit}"' if unit != "1" else '2.5 or "2.5 %"')


@cache
def _registry() -> Any:
    """Return the units that are known; pint is imported where a unit is met first."""
    import pint

    return pint.UnitRegistry(cache_folder=None)
