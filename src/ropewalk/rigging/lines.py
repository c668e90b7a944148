"""A line between two points, set up by its sag, its pretension, or its length."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.library import LibraryRope
from ropewalk.rigging.guessed import line_notes
from ropewalk.rigging.slips import line_slips
from ropewalk.rigging.words import force, margins
from ropewalk.scene import (
    Anchor,
    Fault,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Slack,
    Straight,
)
from ropewalk.scene.base import in_python
from ropewalk.scene.faults import MISSING, NO_VALUE
from ropewalk.scene.from_library import entry
from ropewalk.scene.units import WrongUnit, in_unit
from ropewalk.theory import Cable, elastic_catenary
from ropewalk.words.safe_side import inwards, rounded_down, rounded_up, within

if TYPE_CHECKING:
    from ropewalk.rigging.rolling import Rolling

    Quantity = float | str

_LONGEST = 0.9  # strain up to which a line may be pulled [1]
_SLACKEST = 20.0  # lengths of the chord up to which a line may be long [1]
_HALVINGS = 200
_UNITS = {"pretension": "N", "length": "m"}


@dataclass(frozen=True)
class Line:
    """A line at rest under its own weight: an elastic catenary between two fixed points.

    The first point is at the origin, the second one `span` away and `height_difference` higher.
    """

    cable: Cable  # its shape and forces: the closed form
    material: Material
    diameter: float | None  # [m]; None of a material without one
    gravity: float  # [m/s^2]
    given: str  # what it was set up by, in words
    rope: LibraryRope | None = None  # that the material is of
    set_up: tuple[str, float] = ("", 0.0)  # "sag", "pretension" or "length", and how much

    @property
    def span(self) -> float:
        """Horizontal distance of the ends [m]."""
        return self.cable.across

    @property
    def height_difference(self) -> float:
        """How much higher the second end is [m]."""
        return self.cable.rise

    @property
    def length(self) -> float:
        """Length to cut, without tension [m]."""
        return self.cable.length

    @property
    def sag(self) -> float:
        """Largest drop below the straight line between the ends [m]."""
        return self.cable.sag

    @property
    def tensions(self) -> tuple[float, float]:
        """Tension at the first and at the second end [N]."""
        first, last = self.cable.tension([0.0, self.cable.length])
        return float(first), float(last)

    @property
    def anchor_forces(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Force of the first and of the second anchor on the line, each across and up [N]."""
        return self.cable.start_force, self.cable.end_force

    @property
    def utilisation(self) -> float | None:
        """Largest tension over the breaking load [1]; None where that is not known."""
        load = self.material.breaking_load
        return None if load is None else max(self.tensions) / load

    @property
    def safety_factor(self) -> float | None:
        """Breaking load over the largest tension [1]; None where that is not known."""
        load = self.material.breaking_load
        return None if load is None else load / max(self.tensions)

    def with_EA(self, EA: float) -> Line:
        """Return the line of a rope of another EA [N], set up by the same sag, pretension or length.

        Raises SceneError where such a line cannot have it.
        """
        return self._with(self.material.replace(EA=EA))

    def with_mass(self, mass_per_length: float) -> Line:
        """Return the line of a rope of another `mass_per_length` [kg/m], set up as `with_EA` does it.

        Raises SceneError where such a line cannot have it.
        """
        return self._with(self.material.replace(mass_per_length=mass_per_length))

    def _with(self, made: Material) -> Line:
        cable, words = _hung(self.span, self.height_difference, made, self.gravity, *self.set_up)
        return Line(cable, made, self.diameter, self.gravity, words, self.rope, self.set_up)

    def rolling(
        self, mass: Quantity, *, held: bool = False, places: int = 41, at: Any = None
    ) -> Rolling:
        """Return what a load does to the line at rest, at places from one end to the other.

        Args:
            mass: of the load [kg].
            held: the trolley grips the rope, as a clamp does, and hangs straight down; else the rope runs
                through it with the same tension on both sides, and something holds it along the span.
            places: how many [1], evenly spread over the span without its ends.
            at: a place of your own, or a list of them, in place of these [m].

        Raises SceneError for a mass that is none, ValueError for places that are not inside the span,
        ArithmeticError where no rest is found, as within a hair of an end.
        """
        from ropewalk.rigging.rolling import roll

        found = quantity("mass", mass, "kg")
        if at is None:
            places = in_python(places)
            if isinstance(places, bool) or not isinstance(places, int) or places < 1:
                raise ValueError(f"places: {places!r} - must be a whole number, 1 or more")
            at = self.span * np.arange(1, places + 1) / (places + 1)
        return roll(self, found, held, _places(at))

    def scene(self, segments: int = 60, *, name: str = "line", **fields: Any) -> Scene:
        """Return a scene of this line that starts at rest.

        Args:
            segments: how many [1].
            name: of the scene.
            fields: others of its rope, such as `loads`.

        Raises SceneError for fields that are faulty.
        """
        if "length" in fields:
            rule = f"is that of the line, {self.length:.6g} m; set up another line for it"
            raise SceneError([Fault("length", fields["length"], rule)])
        end = (self.span, 0.0, self.height_difference)
        distance = math.hypot(self.span, self.height_difference)
        taut = self.length <= distance * (1.0 + 1e-9)
        shape = Straight(end=end) if taut else Slack(start=(0.0, 0.0, 0.0), end=end)
        thick = {} if self.diameter is None else {"diameter": self.diameter}
        given = {"shape": shape, "made_of": self.material, **thick} | fields
        rope = Rope(length=self.length, segments=segments, **given)
        anchors = [Anchor(name="first", node=0), Anchor(name="last", node=-1)]
        run = RunSettings(duration=5.0, frame_rate=100.0, start="at-rest")
        pull = (0.0, 0.0, -self.gravity)
        return Scene(name=name, ropes=[rope], anchors=anchors, run=run, gravity=pull)

    def lines(self) -> list[str]:
        """Text, one fact a line."""
        first, last = self.tensions
        made_of = self.material.library or f"EA {self.material.EA:.4g} N"
        chord = math.hypot(self.span, self.height_difference)
        text = [
            f"line of {made_of} over {self.span:.6g} m, {self.height_difference:+.4g} m; {self.given}",
            f"length to cut {self.length:.6g} m without tension, {_against(self.length - chord)}",
            f"sag {self.sag:.4g} m, {100.0 * self.sag / self.span:.3g} % of the span",
            f"tension {force(first)} at the first end, {force(last)} at the second one",
        ]
        for noun, (across, up) in zip(("first", "second"), self.anchor_forces, strict=True):
            text.append(f"the {noun} anchor pulls {force(across)} across and {force(up)} up")
        text += margins(max(first, last), self.material)
        return text + self.notes()

    def notes(self) -> list[str]:
        """What to know of its numbers: guesses, what they make of it, and likely slips of units."""
        return line_notes(self) + line_slips(self)

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def __repr__(self) -> str:
        return (
            f"Line over {self.span:.6g} m: length {self.length:.6g} m, sag {self.sag:.4g} m, "
            f"tension {force(max(self.tensions))}."
        )


def line(
    span: Quantity,
    height_difference: Quantity,
    rope: str | LibraryRope | Material,
    *,
    sag: Quantity | None = None,
    pretension: Quantity | None = None,
    length: Quantity | None = None,
    diameter: Quantity | None = None,
    gravity: float = 9.81,
) -> Line:
    """Return a line between two points, set up by its sag, its pretension or its length.

    A taut line may be shorter than the distance of its ends: it is stretched between them.

    Args:
        span: horizontal distance of the ends [m].
        height_difference: how much higher the second end is [m].
        rope: the name of a rope of the library, such a rope, or a material. A climbing rope is taken as it is
            at rest, with its `EA_static`, and relaxes in `Line.scene` where it is known how.
        sag: largest drop below the straight line between the ends [m], or a share of the span, "2 %".
        pretension: tension at the first end, nothing hung on it [N].
        length: without tension [m].
        diameter: [m]; a rope of the library has its own, a material none: its line's scene is one
            without thickness, as every rope whose diameter is not given.
        gravity: [m/s^2].

    Raises SceneError for quantities that cannot be, and unless exactly one of sag, pretension and length is
    given; UnknownRope for a name that the library has not.
    """
    material, own, known_rope = _made_of(rope)
    if material.curve is not None:
        rule = (
            "a line in closed form has a straight one: give EA, or take a scene and its equilibrium"
        )
        raise SceneError([Fault("rope.curve", NO_VALUE, rule)])
    across = quantity("span", span, "m")
    rise = quantity("height_difference", height_difference, "m", any_sign=True)
    d = quantity("diameter", diameter, "m") if diameter is not None else own
    g = quantity("gravity", gravity, "m/s^2")
    ways = {"sag": sag, "pretension": pretension, "length": length}
    known = {name: in_python(value) for name, value in ways.items() if value is not None}
    if len(known) != 1:
        rule = "give one of sag, pretension and length"
        named = ", ".join(known) or "sag, pretension, length"
        raise SceneError([Fault(named, NO_VALUE if known else MISSING, rule)])
    ((way, value),) = known.items()
    size = _drop(value, across) if way == "sag" else quantity(way, value, _UNITS[way])
    cable, words = _hung(across, rise, material, g, way, size, given=value)
    return Line(cable, material, d, g, words, known_rope, (way, size))


def _places(at: Any) -> Any:
    """Return places, with or without units, as an array [m]. Raises SceneError for what is none."""
    found = in_unit(at, "m")
    if isinstance(found, WrongUnit):
        raise SceneError([Fault("at", found.given, found.rule)])
    try:
        return np.atleast_1d(np.asarray(found, dtype=np.float64))
    except (TypeError, ValueError):
        raise SceneError([Fault("at", at, 'must be places in m, such as 50 or ["50 m"]')]) from None


def _drop(sag: Any, across: float) -> float:
    """Return a sag that may be given as a share of the span [m]."""
    plain = isinstance(sag, bool | int | float)
    share = sag if plain else in_unit(sag, "1")
    if plain or isinstance(share, str | WrongUnit):  # no share: a length
        if isinstance(sag, str) and "%" in sag:
            rule = 'must be a length such as "3 m", or a share of the span such as "2 %"'
            raise SceneError([Fault("sag", sag, rule)])
        return quantity("sag", sag, "m")
    if not isinstance(share, int | float) or not share > 0.0:
        raise SceneError([Fault("sag", sag, "must be a share of the span greater than 0")])
    return float(share) * across


def _hung(
    across: float,
    rise: float,
    material: Material,
    gravity: float,
    way: str,
    wanted: float,
    given: Any = None,
) -> tuple[Cable, str]:
    """Return the cable that has the sag [m], pretension [N] or length [m], and in words what it has.

    Refusals show what was `given`, with its unit.
    """
    given = wanted if given is None else given
    weight = material.mass_per_length * gravity

    def hung(size: float) -> Cable:
        return elastic_catenary(size, across, rise, weight, material.EA)

    def pull(size: float) -> float:
        return float(hung(size).tension(0.0))

    chord = math.hypot(across, rise)
    shortest = chord / (1.0 + _LONGEST) if math.isfinite(material.EA) else chord * (1.0 + 1e-10)
    if way == "length":
        _refuse_length(wanted, shortest, chord, math.isinf(material.EA), given)
        return hung(wanted), f"length {wanted:.6g} m"
    if way == "sag":
        found = _bisected(wanted, lambda size: hung(size).sag, shortest, _SLACKEST * chord)
        return hung(_within(way, found, given, "m")), f"sag {wanted:.4g} m"
    found = _bisected(wanted, pull, shortest, _slackest(pull, shortest, chord))
    return hung(_within(way, found, given, "N")), f"pretension {force(wanted)} at the first end"


def _made_of(rope: Any) -> tuple[Material, float | None, LibraryRope | None]:
    """Return material, diameter [m] and entry of what stands for a rope, as it is at rest."""
    if isinstance(rope, Material):
        return rope, None, None
    if not isinstance(rope, str | LibraryRope):
        raise SceneError([Fault("rope", rope, "must be a name of the library, or a material")])
    try:
        found, use = (rope, "") if isinstance(rope, LibraryRope) else entry(rope)
    except ValueError as error:
        raise SceneError([Fault("rope", rope, str(error).partition(" - ")[2])]) from None
    if not use and "EA_static" in found.numbers:
        use = "relaxing" if "relaxing_EA" in found.numbers else "static"
    return Material(**found.material_numbers(use)), found.diameter, found


def quantity(name: str, value: Any, unit: str, *, any_sign: bool = False) -> float:
    """Return a number, or a text with a unit, as a number of `unit`. Raises SceneError for others."""
    value = in_python(value)
    number = in_unit(value, unit)
    if isinstance(number, WrongUnit):
        raise SceneError([Fault(name, number.given, number.rule)])
    rule = f"must be a number of {unit}" + ("" if any_sign else " greater than 0")
    if isinstance(number, bool) or not isinstance(number, int | float) or not abs(number) < 1e12:
        raise SceneError([Fault(name, value, rule)])
    if not any_sign and number <= 0.0:
        raise SceneError([Fault(name, value, rule)])
    return float(number)


def _refuse_length(size: float, shortest: float, chord: float, rigid: bool, given: Any) -> None:
    rule = ""
    if size < shortest and rigid:
        rule = f"must be more than {rounded_up(chord, 6)} m: this rope does not stretch between the ends"
    elif not within(shortest, size, math.inf):
        rule = f"must be at least {rounded_up(shortest, 6)} m: the ends are {chord:.6g} m apart, "
        rule += f"and a line is set up with at most {100.0 * _LONGEST:.0f} % of stretch"
    elif not within(shortest, size, _SLACKEST * chord):
        rule = f"must be at most {rounded_down(_SLACKEST * chord, 6)} m"
    if rule:
        raise SceneError([Fault("length", given, rule)])


def _slackest(pull: Callable[[float], float], shortest: float, chord: float) -> float:
    """Return the length of least tension at the first end [m]: a longer line weighs more."""
    low, high = shortest, _SLACKEST * chord
    golden = 0.5 * (math.sqrt(5.0) - 1.0)
    for _ in range(80):
        a, b = high - golden * (high - low), low + golden * (high - low)
        if pull(a) < pull(b):
            high = b
        else:
            low = a
    return 0.5 * (low + high)


def _within(way: str, found: float | tuple[float, float], given: Any, unit: str) -> float:
    """Return the length that was found. Raises SceneError with the least and the most that can be."""
    if isinstance(found, float):
        return found
    ends = [force(float(one)) if unit == "N" else f"{one} {unit}" for one in inwards(*found)]
    raise SceneError([Fault(way, given, f"must be from {' to '.join(ends)} between these ends")])


def _bisected(
    wanted: float, of: Callable[[float], float], low: float, high: float
) -> float | tuple[float, float]:
    """Return the length at which a quantity that only grows, or only falls, has a value.

    Where none has it: the quantity's least and greatest value.
    """
    at_low, at_high = of(low), of(high)
    least, most = sorted((at_low, at_high))
    if not within(least, wanted, most):
        return least, most
    rising = at_high > at_low
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if (of(middle) < wanted) == rising:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _against(more: float) -> str:
    """Say how a length is to the straight line between the ends, by how much it is longer [m]."""
    return f"{abs(more):.4g} m {'shorter' if more < 0.0 else 'longer'} than the ends are apart"
