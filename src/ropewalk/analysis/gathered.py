"""Warnings that say the same of several ropes, told once."""

from __future__ import annotations

from collections.abc import Container, Iterable

_NAMED = 3  # ropes that one sentence names


def gathered(
    warnings: Iterable[str], names: Iterable[str], *, named: Container[str] | None = None
) -> list[str]:
    """Return warnings with those alike but for the rope they begin with as one, in the place of the first.

    `names` are those of all ropes. `named`: warnings that name every rope they are of; None: all of them.
    """
    heads = {f"rope {name!r}": name for name in names}
    said: dict[tuple[str, bool], list[str]] = {}
    full = set()
    for warning in warnings:
        head, colon, text = warning.partition(": ")
        one = bool(colon) and head in heads
        if one and (named is None or warning in named):
            full.add(text)
        said.setdefault((text if one else warning, one), []).extend([heads[head]] if one else [])
    return [
        f"{_whose(ropes, text in full)}: {text}" if one else text
        for (text, one), ropes in said.items()
    ]


def _whose(names: list[str], full: bool) -> str:
    if len(names) == 1:
        return f"rope {names[0]!r}"
    most = len(names) if full else _NAMED
    more = len(names) - most
    told = ", ".join(map(repr, names[:most])) + (f" and {more} more" if more > 0 else "")
    return f"{len(names)} ropes ({told}), each"
