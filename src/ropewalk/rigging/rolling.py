"""A load that rolls along a line, at rest at each place: two elastic catenaries that meet at the load.

Unknown are the unstretched length on its left and the load's height; at a given place the forces on the
load balance upright, and besides

    rolling free:  the tension is the same on both sides (a pulley without friction)
    held:          the horizontal parts are the same on both sides (a clamp from which the load hangs)

Source: Irvine, Cable Structures (1981), sec. 1.4 and 2.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.rigging.guessed import rolling_notes
from ropewalk.rigging.slips import load_slip, strain_slip
from ropewalk.rigging.words import force, margins
from ropewalk.theory import Cable, elastic_catenary
from ropewalk.theory.cable import Floats
from ropewalk.words.counts import counted

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ropewalk.rigging.lines import Line

_PLOTS = "ropewalk.plots"  # a layer above this one, so it is looked up by name when it is needed
_ROUNDS = 60
_CLOSED = 1e-9  # of the forces: what may be left of them [1]


@dataclass(frozen=True)
class Rolling:
    """What a load does to a line, at each of n places along the span; forces in N, lengths in m.

    Anchor forces are those of the anchors on the rope, across and up.
    """

    line: Line
    mass: float  # [kg]
    held: bool  # whether the trolley grips the rope
    place: Floats  # (n,) across, from the first end [m]
    height: Floats  # (n,) of the load over the first end [m]
    sag: Floats  # (n,) of the load below the straight line between the ends [m]
    tension_start: Floats  # (n,) at the first anchor [N]
    tension_end: Floats  # (n,) at the second anchor [N]
    tension_left: Floats  # (n,) at the load, on the first anchor's side [N]
    tension_right: Floats  # (n,) at the load, on the other side [N]
    anchor_start: Floats  # (n, 2) [N]
    anchor_end: Floats  # (n, 2) [N]
    holding: Floats  # (n,) force across that keeps the load in its place [N]; 0 where it is held by the rope

    @property
    def largest_tension(self) -> Floats:
        """Largest tension anywhere in the line, (n,) [N]."""
        sides = (self.tension_start, self.tension_end, self.tension_left, self.tension_right)
        found: Floats = np.max(np.stack(sides), axis=0)
        return found

    @property
    def utilisation(self) -> Floats | None:
        """Largest tension over the breaking load, (n,) [1]; None where that is not known."""
        load = self.line.material.breaking_load
        return None if load is None else self.largest_tension / load

    @property
    def table(self) -> list[dict[str, float]]:
        """One row for each place; names have the units, [m], [N] or [1]."""
        columns = {
            "place [m]": self.place,
            "height [m]": self.height,
            "sag [m]": self.sag,
            "largest tension [N]": self.largest_tension,
            "tension at first end [N]": self.tension_start,
            "tension at second end [N]": self.tension_end,
            "first anchor across [N]": self.anchor_start[:, 0],
            "first anchor up [N]": self.anchor_start[:, 1],
            "second anchor across [N]": self.anchor_end[:, 0],
            "second anchor up [N]": self.anchor_end[:, 1],
            "holding force [N]": self.holding,
        }
        if self.utilisation is not None:
            columns["utilisation [1]"] = self.utilisation
        return [
            {name: float(column[i]) for name, column in columns.items()}
            for i in range(self.place.size)
        ]

    def figure(self) -> Figure:
        """Draw path, tensions and anchor forces against the place of the load."""
        figure: Figure = import_module(_PLOTS).rolling(self)
        return figure

    def lines(self) -> list[str]:
        """Text, one fact a line."""
        worst, low = int(np.argmax(self.largest_tension)), int(np.argmin(self.height))
        how = "held by the rope" if self.held else "rolling free"
        largest = float(self.largest_tension[worst])
        text = [
            f"a load of {self.mass:.4g} kg, {how}, at {counted(self.place.size, 'place')}",
            f"largest tension {force(largest)}, with the load at {self.place[worst]:.4g} m",
            f"largest sag of the load {self.sag.max():.4g} m; lowest at {self.place[low]:.4g} m, "
            f"{self.height[low]:+.4g} m to the first end",
        ]
        text += margins(largest, self.line.material)
        return text + self.notes()

    def notes(self) -> list[str]:
        """What to know of its numbers: what guesses make of them, and likely slips of units."""
        stretched = strain_slip(self.line, float(self.largest_tension.max()))
        return rolling_notes(self) + (load_slip(self.line, self.mass) or stretched)

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def __repr__(self) -> str:
        return f"Rolling {self.mass:.4g} kg: largest tension {force(float(self.largest_tension.max()))}."


def roll(line: Line, mass: float, held: bool, places: Floats) -> Rolling:
    """Return what a load does at places along the span [m], one after the other.

    Raises ValueError for places that are not inside the span, ArithmeticError where no rest is found.
    """
    inside = (places > 0.0) & (places < line.span)
    if places.ndim != 1 or not places.size or not inside.all():
        raise ValueError(f"at: must be places between 0 and {line.span:g} m, the ends left out")
    load = mass * line.gravity
    order = np.argsort(places)
    found: list[Any] = [None] * places.size
    guess: tuple[float, float] | None = None
    for i in order:
        x = float(places[i])
        left, height, sides = rest_at(line, load, held, x, guess)
        guess = left, line.height_difference * x / line.span - height
        found[i] = (height, *sides)
    return _gathered(line, mass, held, places, found)


def _gathered(line: Line, mass: float, held: bool, places: Floats, found: list[Any]) -> Rolling:
    height = np.array([row[0] for row in found])
    first: list[Cable] = [row[1] for row in found]
    last: list[Cable] = [row[2] for row in found]
    holding = [left.horizontal - right.horizontal for _, left, right in found]
    return Rolling(
        line=line,
        mass=mass,
        held=held,
        place=places,
        height=height,
        sag=line.height_difference * places / line.span - height,
        tension_start=np.array([float(one.tension(0.0)) for one in first]),
        tension_end=np.array([float(one.tension(one.length)) for one in last]),
        tension_left=np.array([float(one.tension(one.length)) for one in first]),
        tension_right=np.array([float(one.tension(0.0)) for one in last]),
        anchor_start=np.array([one.start_force for one in first]),
        anchor_end=np.array([one.end_force for one in last]),
        holding=np.zeros(places.size) if held else np.array(holding),
    )


class _Load:
    """The load at one place: what is left of the forces on it for a length on the left and a drop."""

    def __init__(self, line: Line, load: float, held: bool, x: float) -> None:
        self.line, self.load, self.held, self.x = line, load, held, x
        self.total, self.EA = line.length, line.material.EA
        self.straight = line.height_difference * x / line.span

    def distances(self, drop: float) -> tuple[float, float]:
        """From the load to the first and to the second end [m]."""
        z = self.straight - drop
        line = self.line
        return math.hypot(self.x, z), math.hypot(line.span - self.x, line.height_difference - z)

    def sides(self, left: float, drop: float) -> tuple[Cable, Cable]:
        """Both sides, for an unstretched length on the left and a drop below the straight line."""
        line, z, w = self.line, self.straight - drop, self.line.cable.weight
        first = elastic_catenary(left, self.x, z, w, self.EA)
        over, up = line.span - self.x, line.height_difference - z
        return first, elastic_catenary(self.total - left, over, up, w, self.EA)

    def error(self, left: float, drop: float) -> tuple[Floats, float]:
        """What is left along and up [N], and the size of the forces [N]."""
        first, last = self.sides(left, drop)
        up = -first.end_force[1] - last.start_force[1] - self.load
        if self.held:
            along = last.horizontal - first.horizontal
        else:
            along = float(last.tension(0.0) - first.tension(first.length))
        size = float(first.tension(0.0)) + float(last.tension(0.0)) + self.load
        return np.array([along, up]), size

    def start(self) -> tuple[float, float]:
        """Guess: two straight strings that carry the load."""
        full = self.load + 0.5 * self.line.cable.weight * self.total
        low, high = 0.0, 2.0 * self.total
        for _ in range(60):
            drop = 0.5 * (low + high)
            one, two = self.distances(drop)
            rise, z = self.line.height_difference, self.straight - drop
            taut = one + two > self.total
            soft = (one + two) / self.total - 1.0
            pull = (self.EA * soft if math.isfinite(self.EA) else 1e15) if taut else 0.0
            low, high = (drop, high) if pull * ((rise - z) / two - z / one) < full else (low, drop)
        return self.total * one / (one + two), drop

    def search(self) -> tuple[float, float]:
        """Nearly the place of rest, by bisection of the drop and, for each, of the length on the left."""
        low, high = -self.line.sag, 2.0 * self.total
        left = 0.5 * self.total
        for _ in range(40):
            drop = 0.5 * (low + high)
            found = self._split(drop)
            if found is None:  # out of the rope's reach
                high = drop
                continue
            left, up = found
            low, high = (drop, high) if up < 0.0 else (low, drop)
        return left, drop

    def _split(self, drop: float) -> tuple[float, float] | None:
        """The length on the left that balances along, and what is left upward; None out of reach."""
        one, two = self.distances(drop)
        least = 1.0 + 1e-9 if math.isinf(self.EA) else 1e-3
        low, high = one * least, self.total - two * least
        if low >= high:
            return None
        error = np.zeros(2)
        for _ in range(40):
            left = 0.5 * (low + high)
            error, _size = self.error(left, drop)
            low, high = (left, high) if error[0] < 0.0 else (low, left)
        return left, float(error[1])


def rest_at(
    line: Line, load: float, held: bool, x: float, guess: tuple[float, float] | None
) -> tuple[float, float, tuple[Cable, Cable]]:
    """Return the unstretched length on the left, the load's height, and both sides."""
    problem = _Load(line, load, held, x)
    found = _newton(problem, *guess) if guess is not None else None
    found = found or _newton(problem, *problem.start()) or _newton(problem, *problem.search())
    if found is not None:
        left, drop = found
        return left, problem.straight - drop, problem.sides(left, drop)
    slip = "".join(f": {text}" for text in load_slip(line, load / line.gravity))
    raise ArithmeticError(f"no rest was found for a load of {load:.4g} N at {x:g} m{slip}")


def _newton(problem: _Load, left: float, drop: float) -> tuple[float, float] | None:
    """Return length on the left and drop at rest, from a guess of them; None where it leads nowhere."""

    def tried(left: float, drop: float) -> tuple[Floats, float]:
        try:
            return problem.error(left, drop)
        except (ValueError, ArithmeticError):  # out of reach
            return np.array([np.inf, np.inf]), 1.0

    if not 0.0 < left < problem.total:
        return None
    error, size = tried(left, drop)
    for _ in range(_ROUNDS):
        if np.abs(error).max() <= _CLOSED * size or not np.isfinite(error).all():
            break
        a = 1e-7 * min(left, problem.total - left)
        b = 1e-7 * (abs(drop) + 1e-3 * problem.line.span)
        slopes = [(tried(left + a, drop)[0] - error) / a, (tried(left, drop + b)[0] - error) / b]
        matrix = np.stack(slopes, axis=1)
        if not np.isfinite(matrix).all() or np.linalg.det(matrix) == 0.0:
            break
        step = np.linalg.solve(matrix, -error)
        factor = 1.0
        for _ in range(40):
            trial = left + factor * float(step[0]), drop + factor * float(step[1])
            new = tried(*trial) if 0.0 < trial[0] < problem.total else None
            if new is not None and np.abs(new[0]).max() < np.abs(error).max():
                break
            factor *= 0.5
        else:
            break
        (left, drop), (error, size) = trial, new
    return (left, drop) if np.abs(error).max() <= 1e-7 * size else None
