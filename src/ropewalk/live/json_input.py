"""JSON from outside, within bounds: how deep it nests, how long its numbers are, what its texts may hold."""

from __future__ import annotations

import json
from typing import Any

from ropewalk.live.parameters import refusal

DEEPEST = 8  # lists and objects one in another; no command has more than four
_LONGEST_WHOLE = 20  # letters; longer whole numbers are read as floating-point ones
_SHOWN = 60  # letters of a faulty message that are given back


def read_json(text: str, *, checked: bool = True) -> Any:
    """Return what a text says. Raises SceneError when it is no JSON or, if `checked`, beyond the bounds.

    NaN and Infinity are not JSON. A whole number too large for floating point becomes infinite, which no
    command takes.
    """
    try:
        data = json.loads(text, parse_constant=_refuse, parse_int=_whole)
    except RecursionError:
        raise _too_deep(text) from None
    except ValueError:
        raise refusal("message", _shown(text), "must be JSON") from None
    if checked:
        _check(data, text)
    return data


def _check(data: Any, text: str) -> None:
    """Walk through lists and objects without recursion: those that nest may be very many."""
    level = [data]
    for _ in range(DEEPEST + 1):
        below: list[Any] = []
        for item in level:
            if isinstance(item, str):
                _check_text(item)
            elif isinstance(item, list):
                below += item
            elif isinstance(item, dict):
                below += item.values()
                below += item.keys()
        if not below:
            return
        level = below
    raise _too_deep(text)


def _check_text(text: str) -> None:
    try:
        text.encode()
    except UnicodeEncodeError:
        rule = "holds half of a surrogate pair, which is no character"
        raise refusal("message", _shown(text), rule) from None


def _too_deep(text: str) -> Exception:
    return refusal("message", _shown(text), f"must nest at most {DEEPEST} deep")


def _shown(text: str) -> str:
    return text[:_SHOWN].encode("ascii", "backslashreplace").decode()


def _whole(digits: str) -> int | float:
    return int(digits) if len(digits) <= _LONGEST_WHOLE else float(digits)


def _refuse(name: str) -> Any:
    raise ValueError(name)
