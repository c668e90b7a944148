"""Warnings that say the same of several ropes, told once."""

from __future__ import annotations

from collections.abc import Iterable

_NAMED = 3  # ropes that one sentence names


def gathered(warnings: Iterable[str], names: Iterable[str]) -> list[str]:
    """Return warnings with those alike but for the rope they begin with as one, in the place of the first.

    `names` are those of all ropes.
    """
    heads = {f"rope {name!r}": name for name in names}
    said: dict[tuple[str, bool], list[str]] = {}
    for warning in warnings:
        head, colon, text = warning.partition(": ")
        one = bool(colon) and head in heads
        said.setdefault((text if one else warning, one), []).extend([heads[head]] if one else [])
    return [f"{_whose(ropes)}: {text}" if one else text for (text, one), ropes in said.items()]


def _whose(names: list[str]) -> str:
    if len(names) == 1:
        return f"rope {names[0]!r}"
    more = len(names) - _NAMED
    told = ", ".join(map(repr, names[:_NAMED])) + (f" and {more} more" if more > 0 else "")
    return f"{len(names)} ropes ({told}), each"
