"""Numbers of a data sheet, with or without units; what is none is refused by name, as it was given."""

from __future__ import annotations

from typing import Any

from ropewalk.scene.base import in_python
from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.units import WrongUnit, in_unit

_SHARE = 'a share such as 0.08 or "8 %"'


def given(
    name: str,
    value: Any,
    unit: str,
    *,
    zero: bool = False,
    most: float = 1e15,
    like: str = "",
) -> float:
    """Return a quantity as a number of `unit`.

    Args:
        name: what a refusal calls it.
        value: a number, also of numpy, a text such as "12 mm", or pint's quantity.
        unit: that is returned.
        zero: 0 will do, too.
        most: largest number that can be meant.
        like: what a number without unit is, in words.

    Raises SceneError unless it is greater than zero and at most `most`.
    """
    value = in_python(value)
    number = in_unit(value, unit)
    if isinstance(number, WrongUnit):
        raise SceneError([Fault(name, number.given, number.rule)])
    plain = isinstance(number, int | float) and not isinstance(number, bool)
    if not plain or not (0.0 < number < 1e15 or (zero and number == 0.0)):
        least = "0 or greater" if zero else "a number greater than 0"
        kind = f", {like}" if like else "" if unit == "1" else f", in {unit}"
        raise SceneError([Fault(name, value, f"must be {least}{kind}")])
    if number > most:
        size = f"{most:g} {unit}" if unit != "1" else f"{most:g}"
        rule = f"must be at most {size}"
        if unit != "1" and not isinstance(value, str):
            rule += f"; it is taken for {value:g} {unit}: write it with its unit"
        raise SceneError([Fault(name, value, rule)])
    return float(number)


def share_of(name: str, value: Any) -> float:
    """Return a share; a bare number above 1 is refused: per cent may have been meant, or times."""
    share = given(name, value, "1", like=_SHARE)
    if share > 1.0 and not isinstance(value, str) and not hasattr(value, "dimensionality"):
        few, many = f"{value:g} %", f"{100.0 * value:g} %"
        rule = f'may be {few} or {many}; write it as "{few}" or "{many}"'
        raise SceneError([Fault(name, value, rule)])
    return share


def below_one(name: str, value: Any) -> float:
    """Return a share of a climbing rope's label: none doubles its length, so that more is per cent."""
    share = given(name, value, "1", like=_SHARE)
    if share > 1.0:
        raise SceneError([Fault(name, value, f"must be {_SHARE}")])
    return share
