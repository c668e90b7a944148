"""Materials from what data sheets say. Each way says its formula."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ropewalk.library.wire_factors import wire_factors
from ropewalk.scene.faults import Fault, SceneError
from ropewalk.scene.label_fall import LabelFall
from ropewalk.scene.sheet_numbers import given, share_of

if TYPE_CHECKING:
    from typing import Self

    Quantity = float | str


_GRADES = 200.0, 3500.0  # of steel wires [N/mm^2]; ropes have 1370 to 2160
_THICKEST = 0.5  # that a wire rope can be [m]


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
        F, share = given("force", force, "N"), share_of("elongation", elongation)
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
        factor: Quantity = 1.77,
        length: Quantity = 2.8,
        static_elongation: Quantity | None = None,
        static_load: Quantity = 80.0,
        edge_friction: Quantity = 0.0,
        measured: str = "mass",
        stiffening: Quantity = 0.0,
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

        What no source gives: the friction of the rig's edge (a guess is 0.5, 0.3 to 0.9, by which a fall
        without an edge has 1 to 3 % less force), the force of later falls (1.1 to 1.5 times the first, a
        guess), and a label of a half or a twin rope with all three numbers, so that of those nothing was
        compared with a label.

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

        Raises SceneError for what is no number greater than zero, for likely slips of units, and for a force
        and a stretch that do not go together, with the forces that would.
        """
        label = LabelFall(
            impact_force, dynamic_elongation, mass_per_length, falling_mass, factor, length,
            static_elongation, static_load, edge_friction, measured, stiffening, later_force,
        )  # fmt: skip
        return cls(**(label.rope() | {"tension_only": True} | others))

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
        F = given("breaking_load", breaking_load, "N")
        share = share_of("elongation_at_break", elongation_at_break)
        made = {"EA": F / share, "mass_per_length": mass_per_length, "breaking_load": F}
        return cls(**(made | {"tension_only": True} | others))

    @classmethod
    def of_wire(
        cls,
        construction: str,
        diameter: Quantity,
        *,
        grade: float | None = None,
        guesses: bool = False,
        **others: Any,
    ) -> Self:
        """Return a steel wire rope: mass W d^2, breaking load K d^2 R, EA from the stretch factor.

        W and K of EN 12385-4 and stretch factors as in `library.wire_factors`; EA is that of new rope
        after it has bedded in, within some 15 %. K of the strand 1x19 has no source, and neither has any
        number of locked coil rope: what is a guess is given only when asked for, and marked in `guessed`.

        Args:
            construction: "6x36 IWRC", "6x19 FC", "7x7", "1x19" ...
            diameter: nominal [m], such as 0.012 or "12 mm".
            grade: strength of the wires, R [N/mm^2]; without one 1770, of "1x19" and "locked coil" 1570, with
                which their guessed K agree with what is known of them.
            guesses: give the breaking load of 1x19, too, K 0.507 (0.477 to 0.549); and locked coil rope at
                all, mass 0.565 (0.54 to 0.587), EA 106.8 GPa d^2 (95 to 117), K 0.605 (0.54 to 0.67).
            others: fields of the material.

        Raises SceneError for what is no number greater than zero, and for guesses that were not asked for;
        ValueError for another construction.
        """
        factors = wire_factors(construction)
        d = given("diameter", diameter, "m")
        if d > _THICKEST:
            rule = f"is {d:g} m, and no wire rope is thicker than {_THICKEST:g} m; write it with its unit"
            raise SceneError([Fault("diameter", diameter, rule)])
        R = given("grade", factors.grade if grade is None else grade, "N/mm^2")
        if not _GRADES[0] <= R <= _GRADES[1]:
            rule = (
                f"must be from {_GRADES[0]:g} to {_GRADES[1]:g} N/mm^2, the strength of steel wires"
            )
            raise SceneError([Fault("grade", grade, rule)])
        if factors.guess and not guesses:
            rule = f"{factors.guess}; guesses=True takes them"
            raise SceneError([Fault("construction", construction, rule)])
        ways = {
            "EA": (factors.EA, factors.EA_range, d**2),
            "mass_per_length": (factors.W, factors.W_range, 1e4 * d**2),
            "breaking_load": (factors.K, factors.K_range, R * 1e6 * d**2),
        }
        if factors.K_range is not None and not guesses:
            del ways["breaking_load"]
        made = {name: factor * size for name, (factor, _, size) in ways.items()}
        marks = [
            {"of": name, "value": made[name], "low": span[0] * size, "high": span[1] * size}
            for name, (_, span, size) in ways.items()
            if span is not None and name not in others
        ]
        return cls(**(made | {"tension_only": True, "guessed": marks} | others))
