"""Ropes that have ended lie as they lay: nothing passes through them, so what comes near ends, too."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.core.status import UNSOLVED
from ropewalk.engine.engine import Engine, Fall
from ropewalk.engine.meeting_boxes import been
from ropewalk.laws.pairs.swept import FROM, HIGH, LOW


def falls_beside(
    engines: Sequence[Engine], pairs: Collection[tuple[int, int]], ended: Floats, time: float
) -> tuple[Fall, ...]:
    """Return the falls of islands that came within reach of `ended` ones, by pairs, before `time` [s]."""
    found = dict[int, Fall]()
    for pair in sorted(pairs):
        going, lying = sorted(pair, key=lambda k: bool(ended[k]))
        if going in found:
            continue
        one, other = engines[going], engines[lying]
        rope, there, what = _named(one, other)
        why = (
            f"Rope {rope!r} came within reach of {what} {there!r} before t = {time:.6g} s, which had ended "
            "and lies as it lay: how they would have touched is not known, so it ends, too."
        )
        ropes = tuple(span.name for span in one.model.layout.ropes)
        found[going] = Fall(going, ropes, UNSOLVED, why)
    return tuple(found.values())


def _named(one: Engine, other: Engine) -> tuple[str, str, str]:
    """Return the names of a rope of each, of which boxes overlap, and what of the second one is near.

    Where none do it is a wheel of that one's.
    """
    near, touching = np.zeros((1, 2), np.int64), False
    if one.system.node.contact.radius.size:
        first, second = (been([engine])[0] for engine in (one, other))
        lower = first[:, None, LOW:HIGH] <= second[None, :, HIGH:FROM]
        higher = second[None, :, LOW:HIGH] <= first[:, None, HIGH:FROM]
        found = np.argwhere((lower & higher).all(axis=2))
        near, touching = (found, True) if len(found) else (near, False)
    a, b = near[0]
    rope, _ = one.model.layout.rope_of(int(one.state.memory.contact.swept[a, FROM]))
    there, _ = other.model.layout.rope_of(int(other.state.memory.contact.swept[b, FROM]))
    return rope, there, "rope" if touching else "a wheel that turns with rope"
