"""What the bumps of a line made of segments hold, over which a slide goes where the line turns sharply.

A slide's force F = 2 T sin(b/2) turns a line of the tension T by b, shared among three of its nodes (`rail`)
as w(s) where it is s segments past the middle one, so that the chain's two segments there point along
    t_1 = T e_0 - w_0 F,  t_2 = t_1 - w_1 F,     e_0 and e_3 the line's directions to either side.
With the slide where it is and segments of the length h the ends of these two are out along the line by
    c(s) = e_3 . x_(i+1) - e_0 . x_(i-1),
and a way of h ds along the line gains T h c'(s) ds: up to max |c'| T more on one side is held. h cancels:
finer segments make the bumps lower and as much closer. On small turns it is 0.012 b^4, as the curve is the
one without bumps to the order of b^2.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats

SHARP = math.radians(60.0)  # [rad] beyond it bumps hold more than 1.5 % of the tension
_PLACES = np.linspace(-0.5, 0.5, 201)  # from the middle of a segment to that of the next


def held_by_bumps(turn: float) -> float:
    """Return how much more tension one side of a slide without friction may have, over the tension [1].

    Where the line turns by `turn` [rad] there, taut and without weight: 0.015 at 60 degrees, 0.077 at 90,
    0.25 at 120, 0.67 at 150.
    """
    half, s = 0.5 * turn, _PLACES
    q = np.sqrt(0.5 - s * s)
    up = 2.0 * math.sin(half)
    first, rise = np.empty((2, s.size)), np.empty((2, s.size))
    rise[0] = math.sin(half) - 0.5 * (1.0 - s - q) * up
    rise[1] = rise[0] - q * up
    size = np.hypot(math.cos(half), rise)
    first, rise = math.cos(half) / size, rise / size
    right = 0.5 * (1.0 + s - q)
    # x_(i-1) and x_(i+1) from the slide, by the two segments' directions
    before = -np.stack(
        [q * first[0] + right * first.sum(axis=0), q * rise[0] + right * rise.sum(axis=0)]
    )
    after = before + np.stack([first.sum(axis=0), rise.sum(axis=0)])
    out = math.cos(half) * (after[0] - before[0]) - math.sin(half) * (after[1] + before[1])
    return float(np.abs(np.gradient(out, s)).max())


def turn_at(x: Floats, first: int, last: int, u: float) -> float:
    """Return the angle by which a line turns where a slide is [rad], from before its nodes there to after.

    Of places (3, n) [m]; the line's nodes are `first` to `last`, and it is at `u` of its segments.
    """
    middle = first + math.floor(u + 0.5)
    one = min(max(middle - 2, first), last - 1)
    other = max(min(middle + 1, last - 1), one)
    into, out = (x[:, i + 1] - x[:, i] for i in (one, other))
    return math.atan2(float(np.linalg.norm(np.cross(into, out))), float(into @ out))


def bump_words(slide: str, on: str, turn: float, most: str = "") -> str:
    """Return what is said of a slide at which its line turns sharply, by `turn` [rad], `most` before it."""
    held = 100.0 * held_by_bumps(turn)
    return (
        f"slide {slide!r}: rope {on!r} turns by {most}{math.degrees(turn):.0f} degrees there; its segments "
        f"make bumps, which hold tensions on both sides that differ by up to {held:.3g} % without any "
        "friction, however fine they are; for sharp turns take a pulley or an obstacle"
    )
