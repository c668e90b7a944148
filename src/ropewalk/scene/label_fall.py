"""A climbing rope's label: its standard fall, and the rope that has it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from ropewalk.scene.faults import MISSING, Fault, SceneError
from ropewalk.scene.sheet_numbers import below_one, given
from ropewalk.theory.edge_fall import harder_by, solid_from_edge_fall
from ropewalk.theory.fall import rope_from_fall
from ropewalk.theory.solid_fall import solid_from_fall
from ropewalk.theory.static_elongation import rope_at_rest

if TYPE_CHECKING:
    Quantity = float | str

_GRAVITY = 9.81  # [m/s^2]
_CURVE = 0.5  # strain up to which a curve made here goes at least [1]
# What no climbing rope and no fall has: more is a slip of units.
_HEAVIEST = 1.0  # [kg/m]
_HARDEST = 10.0  # fall factor [1]; 2 in climbing, some 5 on a via ferrata
_LONGEST = 300.0  # [m]
_HELD = 4.0  # friction of an edge, mu beta [1]: exp(4) is 55 times
_LEAST = 0.01  # stretch of a fall [1]


@dataclass(frozen=True)
class LabelFall:
    """What `Material.from_fall` is given: numbers of a label, the rig, and how the rope is."""

    impact_force: Quantity
    dynamic_elongation: Quantity
    mass_per_length: Quantity
    falling_mass: Quantity
    factor: Quantity
    length: Quantity
    static_elongation: Quantity | None
    static_load: Quantity
    edge_friction: Quantity
    measured: str
    stiffening: Quantity
    later_force: Quantity | None

    def rope(self) -> dict[str, Any]:
        """Return the fields of the material that has this fall.

        Raises SceneError for what is no number, for slips of units, and for numbers that do not go together.
        """
        line = given("mass_per_length", self.mass_per_length, "kg/m", most=_HEAVIEST)
        stretch = below_one("dynamic_elongation", self.dynamic_elongation)
        if stretch < _LEAST:
            few, meant = f"{100.0 * stretch:.3g} %", f"{1e4 * stretch:.3g} %"
            rule = f"is {few}, and no rope stretches so little in a fall; {meant}?"
            raise SceneError([Fault("dynamic_elongation", self.dynamic_elongation, rule)])
        if self.measured not in ("mass", "anchor"):
            raise SceneError([Fault("measured", self.measured, "must be 'mass' or 'anchor'")])
        force = given("impact_force", self.impact_force, "N")
        mass = given("falling_mass", self.falling_mass, "kg")
        try:
            found = self._solved(force, stretch, mass)
        except SceneError:
            raise
        except ValueError as error:
            raise SceneError([self._fault(str(error), force, stretch, mass)]) from None
        return found | {"mass_per_length": line}

    def _rig(self) -> dict[str, Any]:
        """Height over length, and length [m], of the fall."""
        factor = given("factor", self.factor, "1", most=_HARDEST)
        return {"factor": factor, "length": given("length", self.length, "m", most=_LONGEST)}

    def _solved(self, force: float, stretch: float, mass: float) -> dict[str, Any]:
        """Return the fields that force and stretch are solved for. Raises ValueError where there are none."""
        if self.static_elongation is None:
            self._need_static()
        fall = self._rig()
        s = given("stiffening", self.stiffening, "1", zero=True)
        friction = given("edge_friction", self.edge_friction, "1", zero=True, most=_HELD)
        load = given("static_load", self.static_load, "kg")
        if self.static_elongation is None:
            EA, damping = rope_from_fall(force, stretch, mass, **fall)
            return {"EA": EA, "axial_damping": damping}
        static = below_one("static_elongation", self.static_elongation)
        if static >= stretch:
            rule = f"must be below dynamic_elongation, {100.0 * stretch:.3g} %"
            raise SceneError([Fault("static_elongation", self.static_elongation, rule)])
        EA = rope_at_rest(static, _GRAVITY * load, stiffening=s)
        edge = fall | {"edge_friction": friction, "measured": self.measured, "stiffening": s}
        if friction == s == 0.0:
            arm, time = solid_from_fall(force, stretch, EA, mass, **fall)
        else:
            arm, time = solid_from_edge_fall(force, stretch, EA, mass, **edge)
        if self.later_force is not None:
            later = given("later_force", self.later_force, "N")
            if later < force:
                rule = f"must be at least impact_force, {force:g} N: later falls are harder"
                raise SceneError([Fault("later_force", self.later_force, rule)])
            harder = harder_by(later, EA, arm, time, mass, **edge)
            EA, arm = harder * EA, harder * arm
        made = {"relaxing_EA": arm, "relaxation_time": time}
        if s == 0.0:
            return made | {"EA": EA}
        curve = {"coefficients": [EA, 0.0, EA * s], "largest_strain": max(_CURVE, 1.5 * stretch)}
        return made | {"curve": {"kind": "polynomial"} | curve}

    def _need_static(self) -> None:
        """Raise SceneError where what only a rope that relaxes has is asked of another."""
        asked = {
            "edge_friction": self.edge_friction != 0.0,
            "stiffening": self.stiffening != 0.0,
            "later_force": self.later_force is not None,
            "static_load": self.static_load != 80.0,
        }
        wanted = [name for name, value in asked.items() if value]
        if wanted:
            rule = f"is needed with {' and '.join(wanted)}: give it, as the label has it"
            raise SceneError([Fault("static_elongation", MISSING, rule)])

    def _fault(self, text: str, force: float, stretch: float, mass: float) -> Fault:
        """Say of which number of the label it is that nothing has all of them, and what may be meant."""
        name, _, rule = text.partition(" - ")
        if name.startswith("force"):
            if "five times" in rule:
                return Fault("later_force", self.later_force, rule)
            hint = next(self._meant(force, stretch, mass), "")
            return Fault("impact_force", self.impact_force, rule + hint)
        if self.static_elongation is not None and name.startswith(("EA", "relaxing_EA")):
            rule = f"makes a rope of {name.replace(':', '')} N at rest, which {rule}"
            return Fault("static_elongation", self.static_elongation, rule)
        path, _, value = name.partition(": ")
        return Fault(path, value, rule)

    def _meant(self, force: float, stretch: float, mass: float) -> Iterator[str]:
        """Go through what else a force that cannot be may be, and what to give then."""
        half = replace(self, falling_mass=55.0, later_force=None)
        other: list[tuple[LabelFall, float, float, str]] = [
            (self, 1e3 * force, mass, f'; kN for N? Write it as "{force:g} kN"')
        ]
        if mass != 55.0:
            word = "; one strand of a half rope falls with 55 kg: falling_mass=55"
            other.append((half, force, 55.0, word))
        word = "; a twin rope's label is of two strands: half of it is one strand's"
        other.append((self, 0.5 * force, mass, word))
        for label, pull, falling, said in other:
            try:
                label._solved(pull, stretch, falling)
            except ValueError:
                continue
            yield said
