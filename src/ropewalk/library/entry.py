"""One rope of the library, and one number of it with where that comes from."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, cast

if TYPE_CHECKING:
    from ropewalk.scene import Material, Rope

#: What each quality says of a number, best first.
QUALITIES = {
    "measured": "measured and published",
    "standard": "demanded by a standard",
    "maker": "from the maker",
    "table": "from a textbook, a handbook or open code",
    "derived": "computed from numbers that are cited",
    "guess": "not sourced: a guess, with a range",
}
#: The quantities that an entry may have, with units; "1" is none.
UNITS = {
    "diameter": "m",
    "mass_per_length": "kg/m",
    "EA": "N",
    "EA_static": "N",
    "axial_damping": "N s",
    "relaxing_EA": "N",
    "relaxation_time": "s",
    "EI": "N m^2",
    "breaking_load": "N",
    "straight_to": "1",
    "friction_steel": "1",
    "friction_rock": "1",
    "friction_itself": "1",
    "torque_factor": "1",
}
#: What a data sheet says of a climbing rope, with units.
LABEL_UNITS = {
    "impact_force": "N",
    "dynamic_elongation": "1",
    "static_elongation": "1",
    "falling_mass": "kg",
}
Use = Literal["", "static", "relaxing"]
_SCENE = "ropewalk.scene"  # a layer above this one, so it is looked up when it is needed


@dataclass(frozen=True)
class Number:
    """A number with its quality and source; a guess has a range from `low` to `high`."""

    value: float
    quality: str
    source: str
    low: float | None = None
    high: float | None = None
    note: str = ""

    @property
    def guessed(self) -> bool:
        """Whether it is a guess."""
        return self.quality == "guess"

    def as_dict(self) -> dict[str, Any]:
        """Plain values, without what is not there."""
        return {key: value for key, value in vars(self).items() if value not in (None, "")}


_FALLS = (
    "The label's force is that of the first fall, over the edge of a rig whose friction no source gives. "
    "Later falls are harder; no source says by how much."
)
_NO_LABEL = (
    "No label of a half or a twin rope with all three numbers was read: its EA at rest is a guess."
)


@dataclass(frozen=True)
class LibraryRope:
    """A rope of the library. Its numbers are attributes in SI, and in `numbers` with their sources.

    A quantity that no source gives and nobody would guess is None. `EA` is the stiffness for the load that
    such a rope is made for: for a climbing rope a fall, for which `axial_damping` is fitted, too.
    `EA_static`, where there is one, is that of a load at rest; `relaxing_EA` and `relaxation_time` beside it
    make one rope of both.
    """

    name: str
    title: str
    family: str
    numbers: Mapping[str, Number]
    label: Mapping[str, Number] = field(default_factory=dict)
    note: str = ""

    def _value(self, key: str) -> float | None:
        found = self.numbers.get(key)
        return None if found is None else found.value

    @property
    def diameter(self) -> float:
        """Nominal diameter [m]."""
        return self.numbers["diameter"].value

    @property
    def mass_per_length(self) -> float:
        """Mass per length [kg/m]."""
        return self.numbers["mass_per_length"].value

    @property
    def EA(self) -> float:
        """Axial stiffness [N]."""
        return self.numbers["EA"].value

    @property
    def EA_static(self) -> float | None:
        """Axial stiffness for a load at rest [N], where it is another than `EA`."""
        return self._value("EA_static")

    @property
    def axial_damping(self) -> float | None:
        """Tension per strain rate [N s]."""
        return self._value("axial_damping")

    @property
    def relaxing_EA(self) -> float | None:
        """Axial stiffness beside `EA_static` that relaxes [N]."""
        return self._value("relaxing_EA")

    @property
    def relaxation_time(self) -> float | None:
        """Time in which it does [s]."""
        return self._value("relaxation_time")

    @property
    def EI(self) -> float | None:
        """Bending stiffness [N m^2]."""
        return self._value("EI")

    @property
    def breaking_load(self) -> float | None:
        """Breaking load of new straight rope [N]; knots, bends and wear take from it."""
        return self._value("breaking_load")

    @property
    def straight_to(self) -> float | None:
        """Strain up to which `EA` is right, where that is less than at the break [1]."""
        return self._value("straight_to")

    @property
    def friction_steel(self) -> float | None:
        """Coefficient of friction against smooth steel [1]."""
        return self._value("friction_steel")

    @property
    def friction_rock(self) -> float | None:
        """Coefficient of friction against rock or concrete [1]."""
        return self._value("friction_rock")

    @property
    def friction_itself(self) -> float | None:
        """Coefficient of friction of the rope on itself [1]."""
        return self._value("friction_itself")

    @property
    def torque_factor(self) -> float | None:
        """Torque over tension times diameter, of a rope that is kept from turning [1]."""
        return self._value("torque_factor")

    @property
    def density(self) -> float:
        """Mass over the volume of the nominal round section [kg/m^3]."""
        return self.mass_per_length / self._section

    @property
    def wave_speed(self) -> float:
        """Speed of stretching waves, sqrt(EA / mass_per_length) [m/s]."""
        return math.sqrt(self.EA / self.mass_per_length)

    @property
    def modulus(self) -> float:
        """EA over the nominal round section [Pa]."""
        return self.EA / self._section

    @property
    def breaking_stress(self) -> float | None:
        """Breaking load over the nominal round section [Pa]."""
        load = self.breaking_load
        return None if load is None else load / self._section

    @property
    def _section(self) -> float:
        return 0.25 * math.pi * self.diameter**2

    @property
    def guesses(self) -> tuple[str, ...]:
        """Names of the quantities that are guesses."""
        return tuple(key for key, number in self.numbers.items() if number.guessed)

    @property
    def doubts(self) -> tuple[str, ...]:
        """What no source gives of a climbing rope's falls, in sentences; nothing for other ropes."""
        if "climbing" not in self.family:
            return ()
        rest = self.numbers.get("EA_static")
        return (_FALLS, _NO_LABEL) if rest is not None and rest.guessed else (_FALLS,)

    def material(self, *, use: Use = "", guesses: bool = False, bending: bool = False) -> Material:
        """Return what a scene's rope is made of.

        Sourced damping is in it; guessed damping, and any bending stiffness, only when asked for.

        Args:
            use: "static" takes `EA_static`, without damping, for loads at rest; "relaxing" that with
                `relaxing_EA` and `relaxation_time`, for falls, what comes after them, and rest; else `EA`.
            guesses: take guessed damping, too, and a guessed bending stiffness where that is asked for.
            bending: take the bending stiffness.

        Raises ValueError for another use, for one whose numbers are not there, and for a bending stiffness
        that is not there.
        """
        numbers = self.material_numbers(use, guesses, bending)
        return cast("Material", import_module(_SCENE).Material(**numbers))

    def material_numbers(
        self, use: str = "", guesses: bool = False, bending: bool = False
    ) -> dict[str, Any]:
        """Return the fields of `material` for the same `use`, `guesses` and `bending`, in SI.

        Raises ValueError as `material` does.
        """
        if use not in ("", "static", "relaxing"):
            raise ValueError(f'use: {use!r} - must be "static" or "relaxing", or left out')
        if use == "static" and "EA_static" not in self.numbers:
            raise ValueError(f"use: {use!r} - {self.name} has one EA only, for all uses")
        if use == "relaxing" and "relaxing_EA" not in self.numbers:
            raise ValueError(f"use: {use!r} - it is not known how {self.name} relaxes")
        made: dict[str, Any] = {
            "kind": "material",
            "EA": self.numbers["EA_static" if use else "EA"].value,
            "mass_per_length": self.mass_per_length,
            "tension_only": True,
            "library": f"{self.name}:{use}" if use else self.name,
        }
        own = {"": ["axial_damping"], "relaxing": ["relaxing_EA", "relaxation_time"]}
        wanted = ["breaking_load", *own.get(use, []), *(["EI"] * bending)]
        for key in wanted:
            number = self.numbers.get(key)
            if number is not None and (guesses or not number.guessed):
                made[key] = number.value
            elif key == "EI":
                why = "only a guess (guesses=True takes it)" if number else "not known"
                raise ValueError(f"bending: the bending stiffness of {self.name} is {why}")
        return made

    def cut(self, length: float, segments: int, *, use: Use = "", **fields: Any) -> Rope:
        """Return a piece of this rope for a scene, with its diameter.

        Args:
            length: unstretched [m].
            segments: how many [1].
            use: as in `material`.
            fields: others of `Rope`, such as `shape` and `loads`.

        Raises SceneError for fields that are faulty, ValueError for another use.
        """
        given = {"diameter": self.diameter, "made_of": self.material(use=use)} | fields
        rope = import_module(_SCENE).Rope
        return cast("Rope", rope(length=length, segments=segments, **given))

    def as_dict(self) -> dict[str, Any]:
        """Plain values for JSON, in SI, with sources."""
        about: dict[str, Any] = {"name": self.name, "title": self.title, "family": self.family}
        for key, group, units in (
            ("numbers", self.numbers, UNITS),
            ("label", self.label, LABEL_UNITS),
        ):
            rows = {name: {"unit": units[name]} | one.as_dict() for name, one in group.items()}
            if rows:
                about[key] = rows
        return about | ({"note": self.note} if self.note else {})

    def __repr__(self) -> str:
        d, m = 1e3 * self.diameter, self.mass_per_length
        wide, heavy, hard, strong = (
            "~" if key in self.guesses else ""
            for key in ("diameter", "mass_per_length", "EA", "breaking_load")
        )
        load = f", breaks at {strong}{self.breaking_load:.4g} N" if self.breaking_load else ""
        what = f"{self.name}: {self.title}, {wide}{d:.4g} mm, {heavy}{m:.4g} kg/m"
        return f"{what}, EA {hard}{self.EA:.4g} N{load}."
