"""Ropes of a run that broke: which, when, and why."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from ropewalk.words.counts import counted

_NAMED = 3  # ends that are told of one by one


@dataclass(frozen=True)
class End:
    """The end of some ropes that belong together: of one, as a rule. They broke, or met what had ended."""

    ropes: tuple[str, ...]
    time: float  # of their last good frame [s]
    frames: int  # good ones, the initial one included
    why: str  # in whole sentences

    def as_dict(self) -> dict[str, Any]:
        """Return plain values for JSON."""
        return asdict(self) | {"ropes": list(self.ropes)}


def from_dicts(found: Iterable[Mapping[str, Any]]) -> tuple[End, ...]:
    """Read what `as_dict` returned. Raises KeyError, TypeError and ValueError."""
    return tuple(
        End(tuple(map(str, one["ropes"])), float(one["time"]), int(one["frames"]), str(one["why"]))
        for one in found
    )


def in_words(ends: tuple[End, ...], ropes: int) -> str:
    """Say why a run of so many ropes broke, and whether some of them went on; "" for no end."""
    if not ends:
        return ""
    told = [end.why for end in ends[:_NAMED]]
    if len(ends) > _NAMED:
        more = counted(sum(len(end.ropes) for end in ends[_NAMED:]), "more rope")
        told.append(f"{more} ended after that.")
    left = ropes - sum(len(end.ropes) for end in ends)
    if left > 0:
        whole = "the other rope" if left == 1 else f"the other {left} ropes"
        told.append(f"{whole.capitalize()} went on.")
    return " ".join([*(f"{why.removesuffix('.')}." for why in told[:-1]), told[-1]])


def shortly(ends: tuple[End, ...]) -> str:
    """Return which ropes broke after when, in a few words; "" for none."""
    found = [f"{', '.join(end.ropes)} after {end.time:.5g} s" for end in ends[:_NAMED]]
    if len(ends) > _NAMED:
        found.append(f"and {sum(len(end.ropes) for end in ends[_NAMED:])} more")
    return ", ".join(found)
