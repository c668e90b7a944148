"""Materials from what data sheets say. Each way says its formula."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ropewalk.library.wire_factors import wire_factors
from ropewalk.scene.faults import MISSING, Fault, SceneError
from ropewalk.scene.units import WrongUnit, in_unit
from ropewalk.theory.edge_fall import harder_by, solid_from_edge_fall
from ropewalk.theory.fall import rope_from_fall
from ropewalk.theory.solid_fall import solid_from_fall
from ropewalk.theory.static_elongation import rope_at_rest

if TYPE_CHECKING:
    from typing import Self

    Quantity = float | str


_GRAVITY = 9.81  # [m/s^2]
_GRADES = 200.0, 3500.0  # of steel wires [N/mm^2]; ropes have 1370 to 2160
_THICKEST = 0.5  # that a wire rope can be [m]
_CURVE = 0.5  # strain up to which a curve made here goes at least [1]


class FromDataSheet:
    """The ways from a data sheet to a material. Numbers may have units, as "8.8 kN" or "32 %"."""

    @classmethod
    def from_elongation(
        cls, force: Quantity, elongation: Quantity, mass_per_length: Quantity, **others: Any
    ) -> Self:
        """Return the material that stretches by a share under a force at rest: EA = force / elongation.

        For loads at rest. A climbing rope in a fall is some three times as stiff: take `from_fall`.

        Args:
            force: that the elongation is given for [N].
            elongation: share of the unloaded length [1], such as 0.08 or "8 %".
            mass_per_length: [kg/m].
            others: fields of the material.

        Raises SceneError for what is no number greater than zero, or a quantity of another kind.
        """
        F, share = _given("force", force, "N"), _share("elongation", elongation)
        return cls(
            **({"EA": F / share, "mass_per_length": mass_per_length, "tension_only": True} | others)
        )

    @classmethod
    def from_fall(
        cls,
        impact_force: Quantity,
        dynamic_elongation: Quantity,
        mass_per_length: Quantity,
        *,
        falling_mass: Quantity = 80.0,
        factor: float = 1.77,
        length: Quantity = 2.8,
        static_elongation: Quantity | None = None,
        static_load: Quantity = 80.0,
        edge_friction: float = 0.0,
        measured: str = "mass",
        stiffening: float = 0.0,
        later_force: Quantity | None = None,
        **others: Any,
    ) -> Self:
        """Return the climbing rope whose standard fall has its label's force and stretch.

        With the label's static elongation e the rope relaxes: EA = ((80 - 5) / e - 5) kg g, as it is measured
        between a preload of 5 kg and 80 kg (`theory.rope_at_rest`), and relaxing_EA and relaxation_time are
        solved for in a fall of the mass into the rope (`theory.solid_from_fall`), or over an edge
        (`theory.solid_from_edge_fall`). Without it EA and axial_damping are, spring and damper
        side by side (`theory.rope_from_fall`). What they give with another mass or length is an estimate. The
        force is that of the first fall, on the anchor, and with an edge as `measured` says.

        Args:
            impact_force: of the label [N].
            dynamic_elongation: of the label [1], such as 0.32 or "32 %".
            mass_per_length: [kg/m].
            falling_mass: 80 kg for a single rope, 55 kg for one strand of a half rope; for one strand of a
                twin rope 40 kg, and half the force of its label [kg].
            factor: free fall over length of rope [1]; the standard's by default.
            length: of the rope [m]; the standard's by default.
            static_elongation: of the label [1], such as 0.08 or "8 %".
            static_load: that it is measured under, 80 kg on one strand of a single or a half rope; 40 kg for
                one strand of a twin rope, which is measured on two; a sixteenth of it is the preload [kg].
            edge_friction: of the rope that turns over the rig's edge, coefficient of friction times angle,
                mu beta [1]; 0 for a fall without an edge. Needs static_elongation, as the next three do.
            measured: "mass" or "anchor", on which side of the edge impact_force is.
            stiffening: s of a tension at rest EA e (1 + s e^2) [1]; the material then has a curve.
            later_force: of a later fall of the series [N], such as the fifth: the rope returned is as it is
                in that fall, the new one made harder by one factor (`theory.harder_by`), an assumption.
            others: fields of the material.

        Raises SceneError for what is no number greater than zero; ValueError for a force and a stretch that
        do not go together, with the forces that would.
        """
        rig = _Rig(falling_mass, factor, length, edge_friction, measured, stiffening, later_force)
        at_rest = static_elongation, static_load
        made = _of_fall(impact_force, dynamic_elongation, at_rest, rig)
        return cls(**(made | {"mass_per_length": mass_per_length, "tension_only": True} | others))

    @classmethod
    def from_break(
        cls,
        breaking_load: Quantity,
        elongation_at_break: Quantity,
        mass_per_length: Quantity,
        **others: Any,
    ) -> Self:
        """Return the material of a straight line to the break: EA = breaking_load / elongation_at_break.

        Fibre ropes are softer than that at first and stiffer near the break; the line is the mean.

        Args:
            breaking_load: [N]; it becomes the material's.
            elongation_at_break: share of the unloaded length [1], such as 0.04 or "4 %".
            mass_per_length: [kg/m].
            others: fields of the material.

        Raises SceneError for what is no number greater than zero, or a quantity of another kind.
        """
        F = _given("breaking_load", breaking_load, "N")
        share = _share("elongation_at_break", elongation_at_break)
        made = {"EA": F / share, "mass_per_length": mass_per_length, "breaking_load": F}
        return cls(**(made | {"tension_only": True} | others))

    @classmethod
    def of_wire(
        cls, construction: str, diameter: Quantity, *, grade: float = 1770.0, **others: Any
    ) -> Self:
        """Return a steel wire rope: mass W d^2, breaking load K d^2 R, EA from the stretch factor.

        W and K of EN 12385-4 and stretch factors as in `library.wire_factors`; EA is that of new rope
        after it has bedded in, within some 15 %.

        Args:
            construction: "6x36 IWRC", "6x19 FC", "7x7" ...
            diameter: nominal [m], such as 0.012 or "12 mm".
            grade: strength of the wires, R [N/mm^2].
            others: fields of the material.

        Raises SceneError for what is no number greater than zero; ValueError for another construction.
        """
        factors = wire_factors(construction)
        d = _given("diameter", diameter, "m")
        if d > _THICKEST:
            rule = f"is {d:g} m, and no wire rope is thicker than {_THICKEST:g} m; write it with its unit"
            raise SceneError([Fault("diameter", diameter, rule)])
        R = _given("grade", grade, "N/mm^2")
        if not _GRADES[0] <= R <= _GRADES[1]:
            rule = (
                f"must be from {_GRADES[0]:g} to {_GRADES[1]:g} N/mm^2, the strength of steel wires"
            )
            raise SceneError([Fault("grade", grade, rule)])
        made = {
            "EA": factors.EA * d**2,
            "mass_per_length": factors.W * 1e4 * d**2,
            "breaking_load": factors.K * R * 1e6 * d**2,
        }
        return cls(**(made | {"tension_only": True} | others))


class _Rig(NamedTuple):
    """Mass and rig of a fall, and how the rope is; as for `from_fall`."""

    mass: Quantity
    factor: float
    length: Quantity
    edge_friction: float
    measured: str
    stiffening: float
    later_force: Quantity | None


def _of_fall(
    impact_force: Quantity,
    elongation: Quantity,
    at_rest: tuple[Quantity | None, Quantity],
    rig: _Rig,
) -> dict[str, Any]:
    """Return the fields of a material that has a label's fall; see `from_fall`."""
    share = _below_one("dynamic_elongation", elongation)
    if rig.measured not in ("mass", "anchor"):
        raise SceneError([Fault("measured", rig.measured, "must be 'mass' or 'anchor'")])
    force = _given("impact_force", impact_force, "N")
    mass = _given("falling_mass", rig.mass, "kg")
    fall: dict[str, Any] = {"factor": rig.factor, "length": _given("length", rig.length, "m")}
    s = rig.stiffening
    static, load = at_rest
    if static is None:
        _need_static(rig, "" if load == 80.0 else "static_load")
        EA, damping = rope_from_fall(force, share, mass, **fall)
        return {"EA": EA, "axial_damping": damping}
    rest = _below_one("static_elongation", static)
    EA = rope_at_rest(rest, _GRAVITY * _given("static_load", load, "kg"), stiffening=s)
    edge = fall | {"edge_friction": rig.edge_friction, "measured": rig.measured, "stiffening": s}
    if rig.edge_friction == s == 0.0:
        arm, time = solid_from_fall(force, share, EA, mass, **fall)
    else:
        arm, time = solid_from_edge_fall(force, share, EA, mass, **edge)
    if rig.later_force is not None:
        later = _given("later_force", rig.later_force, "N")
        if later < force:
            rule = f"must be at least impact_force, {force:g} N: later falls are harder"
            raise SceneError([Fault("later_force", rig.later_force, rule)])
        harder = harder_by(later, EA, arm, time, mass, **edge)
        EA, arm = harder * EA, harder * arm
    made = {"relaxing_EA": arm, "relaxation_time": time}
    if s == 0.0:
        return made | {"EA": EA}
    curve = {"coefficients": [EA, 0.0, EA * s], "largest_strain": max(_CURVE, 1.5 * share)}
    return made | {"curve": {"kind": "polynomial"} | curve}


def _need_static(rig: _Rig, also: str) -> None:
    """Raise SceneError where what only a rope that relaxes has is asked of another; `also` is so, too."""
    asked = {
        "edge_friction": rig.edge_friction,
        "stiffening": rig.stiffening,
        "later_force": rig.later_force,
        also: also,
    }
    wanted = [name for name, value in asked.items() if value]
    if wanted:
        rule = f"is needed with {' and '.join(wanted)}: give it, as the label has it"
        raise SceneError([Fault("static_elongation", MISSING, rule)])


def _given(name: str, value: Any, unit: str) -> float:
    """Return a quantity as a number of `unit`. Raises SceneError unless it is greater than zero."""
    number = in_unit(value, unit)
    if isinstance(number, WrongUnit):
        raise SceneError([Fault(name, number.given, number.rule)])
    if isinstance(number, bool) or not isinstance(number, int | float) or not 0.0 < number < 1e15:
        raise SceneError([Fault(name, value, f"must be a number greater than 0{_in(unit)}")])
    return float(number)


def _share(name: str, value: Any) -> float:
    """Return a share; a bare number above 1 is refused: per cent may have been meant, or times."""
    share = _given(name, value, "1")
    if share > 1.0 and not isinstance(value, str) and not hasattr(value, "dimensionality"):
        few, many = f"{value:g} %", f"{100.0 * value:g} %"
        rule = f'may be {few} or {many}; write it as "{few}" or "{many}"'
        raise SceneError([Fault(name, value, rule)])
    return share


def _below_one(name: str, value: Any) -> float:
    """Return a share of a climbing rope's label: none doubles its length, so that more is per cent."""
    share = _given(name, value, "1")
    if share > 1.0:
        raise SceneError([Fault(name, value, f"must be{_in('1')[1:]}")])
    return share


def _in(unit: str) -> str:
    return f", in {unit}" if unit != "1" else ', a share such as 0.08 or "8 %"'
