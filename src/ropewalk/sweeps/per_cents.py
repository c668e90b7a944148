"""Texts as ranges: `10 %` of what a scene has (of 200 kN 180 to 220 kN), and `29 m..31 m`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from ropewalk.record.errors import InputError
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import Fault
from ropewalk.scene.overrides import Places
from ropewalk.scene.units import WrongUnit, in_unit
from ropewalk.sweeps.spread_text import range_ends

_RANGE = "give a range LOW..HIGH"


def with_ranges(scene: Scene, spreads: Any) -> Any:
    """Return spreads with each text such as "10 %" as the range that far below and above the scene's value.

    Args:
        scene: whose values they are per cents of.
        spreads: mapping from paths to distributions, ranges (low, high) or "29..31 m", and per cents;
            others as they are.

    Raises SceneError for what is no range, nor a per cent above 0 and up to 100, and for paths where no one
    number but zero stands.
    """
    if not isinstance(spreads, Mapping) or not any(isinstance(v, str) for v in spreads.values()):
        return spreads
    faults: list[Fault] = []
    made = dict(spreads)
    for path, what in spreads.items():
        if not isinstance(what, str):
            continue
        try:
            made[path] = _range(scene, path, what)
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(faults)
    return made


def _range(scene: Scene, path: str, text: str) -> tuple[float, float] | tuple[str, str]:
    if ".." in text:
        try:
            return range_ends(text)
        except InputError as error:
            raise SceneError([Fault(path, text, error.rule)]) from None
    share = in_unit(text.strip().removeprefix("±").strip(), "1") if "%" in text else None
    if share is None or isinstance(share, WrongUnit | str) or not 0.0 < share <= 1.0:
        rule = f"must be per cents above 0 and up to 100, such as 10 %; for anything else {_RANGE}"
        raise SceneError([Fault(path, text, rule)])
    value = _value(Places(scene, [path]).values(0), path, text)
    off = share * abs(value)
    return value - off, value + off


def _value(values: list[Any], path: str, text: str) -> float:
    """Return the one number that stands at a path."""
    sound = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in values)
    if None in values:
        why = f"nothing stands there; {_RANGE}"
    elif not sound or not all(map(math.isfinite, values)):
        why = "no single number stands there"
    elif len(set(values)) > 1:
        why = f"its places have {min(values):g} to {max(values):g}; name one of them, or {_RANGE}"
    elif values[0] == 0.0:
        why = f"the scene has 0 there; {_RANGE}"
    else:
        return float(values[0])
    raise SceneError([Fault(path, text, f"cannot be per cents: {why}")])
