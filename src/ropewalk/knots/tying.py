"""A knot of a rope: its curves, how near its strands come, and how sharply they bend."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.knots import drawn, hitches
from ropewalk.knots.course import Curve
from ropewalk.knots.measures import number, number_or_none, whole
from ropewalk.words.safe_side import inwards, rounded_down, rounded_up, within

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats

KNOTS = ("overhand", "figure-eight", "reef", "granny", "bowline")
"""Knots of ropes alone."""

HITCHES = ("clove-hitch", "two-half-hitches", "prusik", "munter", "bollard")
"""Knots about a post or a ring."""

TURNED = ("prusik", "bollard")
"""Of which it can be said how many turns they have."""

_TWO = ("reef", "granny")
_ALONG = np.array([1.0, 0.0, 0.0])
_HALF_TURN = np.array([-1.0, 1.0, -1.0])  # about y
MOST_SLACK = 4.0
LEAST, MOST = 1e-12, 1e6  # diameter [m]: as in a scene, and where curves are exact to 1e-10 of it
THICKEST, THINNEST = 50.0, 0.4  # radius of a post over the rope's diameter
MOST_TURNS = 50.0
WIDEST = 1e5  # radius of a ring over the rope's diameter
LONGEST = 1.5  # segment over the rope's diameter, with which a knot is still itself


def names() -> tuple[str, ...]:
    """Return the names of all knots."""
    return KNOTS + HITCHES


def named(name: str) -> str:
    """Return a knot with its article; hitches that are two have none."""
    if name.startswith("two-"):
        return name
    return f"an {name}" if name[0] == "o" else f"a {name}"


@dataclass(frozen=True)
class Tied:
    """A knot of a rope of some diameter, about the origin; its rope goes along x, a post along z.

    Each rope of it is a curve that goes on straight at both ends.
    """

    name: str
    diameter: float  # of the rope [m]
    curves: tuple[Curve, ...]
    post_radius: float = 0.0  # [m]; 0: there is none
    ring_radius: float = 0.0  # of the ring that is the post [m]; 0: it is straight
    within: tuple[float, float] = (
        0.0,
        0.0,
    )  # of the straight ends, what the knot is tied about [m]
    reach: float = 0.0  # of the turns along the post to each side, half the rope with it [m]

    @property
    def ropes(self) -> int:
        """Number of its ropes [1]."""
        return len(self.curves)

    @property
    def length(self) -> float:
        """Length of one of its ropes without what of its straight ends is no part of the knot [m]."""
        return max(curve.length for curve in self.curves) + sum(self.within)

    @property
    def least_radius(self) -> float:
        """Least radius to which a rope is bent [m]."""
        return min(curve.least_radius for curve in self.curves)

    def points(
        self,
        segments: int,
        length: float,
        rope: int = 1,
        first_end: float | None = None,
    ) -> Floats:
        """Return the nodes of one of its ropes [m], (segments + 1, 3), all segments equally long.

        Args:
            segments: how many [1].
            length: of the whole rope [m]; what the knot does not need are its ends.
            rope: which rope [1], from 1.
            first_end: length of the first end [m]; by default both are as long.

        Raises ValueError for a rope that the knot has not, one too short or too coarse for it, and for what
        is no such number.
        """
        segments, rope = whole("segments", segments), whole("rope", rope)
        length, first_end = number("length", length), number_or_none("first_end", first_end)
        if not 1 <= rope <= self.ropes:
            raise ValueError(
                f"rope: {rope} - must be from 1 to {self.ropes} for {named(self.name)}"
            )
        fault = self.fault(segments, length, first_end)
        if fault is not None:
            raise ValueError(f"{fault[0]}: {fault[1]:g} - {fault[2]}")
        curve, (before, after) = self.curves[rope - 1], self.within
        if first_end is None:
            return _chain(curve, segments, length, None, 0.5 * (before - after)).copy()
        return _chain(curve, segments, length, before + first_end, 0.0).copy()

    def fault(
        self, segments: int, length: float, first_end: float | None = None
    ) -> tuple[str, float, str] | None:
        """Return what is wrong with a rope for this knot: what of it, its value, the rule; or None.

        Args:
            segments: how many [1].
            length: of the whole rope [m].
            first_end: length of the first end [m], or None.
        """
        if not 0.0 <= (first_end or 0.0) < math.inf:
            return "first_end", first_end or 0.0, "must be a finite number of m, not negative"
        need = self.length + (first_end or 0.0)
        if not length > need:
            of = f"{named(self.name)} of a rope {self.diameter:g} m thick"
            ends = "" if first_end is None else " with that first_end"
            return "length", length, f"must be more than {rounded_up(need, 4)} m for {of}{ends}"
        if length == math.inf:
            return "length", length, "must be a finite number of m"
        most = LONGEST * self.diameter
        if length / segments > most * (1.0 + 1e-9):
            least = math.ceil(length / most * (1.0 - 1e-9))
            rule = (
                f"must be at least {least}: a knot needs segments of at most {LONGEST:g} diameters"
            )
            return "segments", segments, rule
        return None


def knot(
    name: str,
    diameter: float,
    *,
    slack: float = 1.0,
    post_radius: float | None = None,
    ring_radius: float | None = None,
    turns: float | None = None,
) -> Tied:
    """Return a knot of a rope, loose.

    Args:
        name: of the knot, see `names`.
        diameter: of the rope [m].
        slack: how loose it is tied [1], 1 to 4. Of a knot without a post all sizes are multiplied with it.
        post_radius: of what a hitch is tied about [m], 0.4 to 50 diameters.
        ring_radius: of a ring whose bar the post is [m], from its centre to the bar's middle; a munter's.
        turns: of a prusik to each side (3), or of a bollard (2) [1].

    Raises ValueError for a name that there is not, and for sizes that cannot be or are no numbers.
    """
    diameter, slack = number("diameter", diameter), number("slack", slack, "1")
    post_radius = number_or_none("post_radius", post_radius)
    ring_radius = number_or_none("ring_radius", ring_radius)
    turns = number_or_none("turns", turns, "1")
    if name not in names():
        raise ValueError(f"name: {name!r} - must be one of {', '.join(names())}")
    for path, value, rule in faults(name, diameter, slack, post_radius, ring_radius, turns):
        raise ValueError(f"{path}: {value} - {rule}")
    return _tied(name, diameter, slack, post_radius or 0.0, ring_radius or 0.0, turns or 0.0)


def faults(
    name: str,
    diameter: float | None,
    slack: float,
    post_radius: float | None,
    ring_radius: float | None,
    turns: float | None,
) -> list[tuple[str, float | None, str]]:
    """Return what is wrong with a knot's sizes: which, its value, and the rule.

    Without a diameter [m] only what does not depend on it; `slack` [1], radii [m] and `turns` [1] of `name`.
    """
    found: list[tuple[str, float | None, str]] = []
    if diameter is not None and not diameter > 0.0:
        return [("diameter", diameter, "must be greater than 0")]
    if diameter is not None and not LEAST <= diameter <= MOST:
        return [("diameter", diameter, f"must be from {LEAST:g} to {MOST:g} m")]
    if not 1.0 <= slack <= MOST_SLACK:
        found.append(("slack", slack, f"must be from 1 to {MOST_SLACK:g}"))
    if name in KNOTS:
        found += [
            (path, value, f"leave it out: {named(name)} has no post")
            for path, value in (("post_radius", post_radius), ("ring_radius", ring_radius))
            if value is not None
        ]
    elif post_radius is None:
        found.append(
            ("post_radius", None, f"{named(name)} is tied about a post: give its radius (m)")
        )
    elif diameter is not None:
        least, most = THINNEST * diameter, THICKEST * diameter
        if not within(least, post_radius, most):
            low, high = inwards(least, most)
            rule = f"must be from {low} to {high} m for a rope {diameter:g} m thick"
            found.append(("post_radius", post_radius, rule))
        elif ring_radius is not None and name == "munter":
            found += _ring_faults(ring_radius, post_radius, diameter, slack)
    if ring_radius is not None and name in HITCHES and name != "munter":
        found.append(("ring_radius", ring_radius, "leave it out: only a munter is tied on a ring"))
    if turns is not None and name not in TURNED:
        found.append(("turns", turns, f"leave it out: only {' and '.join(TURNED)} have them"))
    elif turns is not None and name == "prusik":
        if not 1.0 <= turns <= MOST_TURNS or turns % 1.0 != 0.0:
            rule = f"must be a whole number from 1 to {MOST_TURNS:g} for a prusik"
            found.append(("turns", turns, rule))
    elif turns is not None and not 0.5 <= turns <= MOST_TURNS:
        found.append(("turns", turns, f"must be from 0.5 to {MOST_TURNS:g}"))
    return found


def _ring_faults(
    ring_radius: float, post_radius: float, diameter: float, slack: float
) -> list[tuple[str, float | None, str]]:
    """Return what is wrong with the radius of a ring [m] for a rope on a bar of these sizes [m]."""
    need, most = 2.0 * (post_radius + (1.0 + slack) * diameter), WIDEST * diameter
    if not within(need, ring_radius, math.inf):
        rule = f"must be at least {rounded_up(need, 4)} m, for the rope to have room in the ring"
    elif ring_radius > most:
        rule = f"must be at most {rounded_down(most, 4)} m; leave it out for a straight bar"
    else:
        return []
    return [("ring_radius", ring_radius, rule)]


@lru_cache(maxsize=64)
def _chain(
    curve: Curve, segments: int, length: float, first_end: float | None, more: float
) -> Floats:
    """Return the nodes of a curve (`Curve.chain`): a sweep asks for the same ones for every run."""
    return curve.chain(segments, length, first_end, more)


@lru_cache(maxsize=64)
def _tied(name: str, diameter: float, slack: float, post: float, ring: float, turns: float) -> Tied:
    if name in KNOTS:
        return Tied(name, diameter, _free(name, slack * diameter))
    rho = post / diameter + 0.5 + 0.2 * slack
    gap = 1.0 + 0.3 * slack
    first, last, inside = _ALONG, _ALONG, (0.0, 0.0)
    match name:
        case "clove-hitch":
            points = hitches.clove(rho, gap)
            first, last = hitches.clove_ends(rho)
        case "two-half-hitches":
            points, last = hitches.round_turn(rho, gap, 2.4 + 0.2 * slack)
            inside = (hitches.BEYOND - float(points[:, 0].min()), 0.0)
        case "prusik":
            points, last = hitches.prusik(rho, gap, turns or 3.0), -_ALONG
            inside = (hitches.BEYOND, hitches.BEYOND)  # its bight lies over them
        case "munter":
            # within a ring turns are nearer to each other than on a straight bar
            room = 1.0 if ring == 0.0 else 1.0 / (1.0 - rho * diameter / ring)
            points, last = hitches.munter(rho, gap * room), -_ALONG
        case _:
            points = hitches.bollard(rho, gap, turns or 2.0)
            angle = 2.0 * math.pi * (turns or 2.0)
            last = np.array([math.cos(angle), math.sin(angle), 0.0])
    about = np.hypot(points[:, 0], points[:, 1]) < rho + 0.5
    reach = diameter * (0.5 + float(np.abs(points[about, 2]).max()))
    points = hitches.bent(points, ring / diameter) if ring > 0.0 else points
    curve = Curve(points * diameter, first, last)
    ends = (diameter * inside[0], diameter * inside[1])
    return Tied(name, diameter, (curve,), post, ring, ends, reach)


def _free(name: str, size: float) -> tuple[Curve, ...]:
    """Return the curves of a knot without a post, drawn for diameters of this size [m]."""
    tables = {
        "overhand": drawn.OVERHAND,
        "figure-eight": drawn.FIGURE_EIGHT,
        "reef": drawn.REEF,
        "granny": drawn.GRANNY,
        "bowline": drawn.BOWLINE,
    }
    points = size * np.array(tables[name])
    if name not in _TWO:
        last = points[-1] - points[-2] if name == "bowline" else _ALONG
        return (Curve(points, _ALONG, last),)
    return (
        Curve(points, _ALONG, -_ALONG),
        Curve(points * _HALF_TURN, -_ALONG, _ALONG),
    )
