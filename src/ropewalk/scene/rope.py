"""Ropes: chains of nodes joined by segments, and what these are made of."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, model_validator

from ropewalk.library import names
from ropewalk.scene.at_nodes import Force, Kick, Load
from ropewalk.scene.base import (
    NAME,
    Flag,
    Many,
    Model,
    Number,
    Stiffness,
    Text,
    Vector,
    Whole,
    listed,
    not_negative,
    positive,
    quantity,
    refuse,
    stiffness,
    vector,
)
from ropewalk.scene.data_sheet import FromDataSheet
from ropewalk.scene.faults import MISSING, Fault
from ropewalk.scene.from_library import filled, with_diameter
from ropewalk.scene.guess import Guess
from ropewalk.scene.knot_shape import Knot
from ropewalk.scene.limits import MOST_SEGMENTS
from ropewalk.scene.rubbing import coefficient
from ropewalk.scene.shapes import Points, Shape, Slack, Straight
from ropewalk.scene.solid_fields import relaxation_time, relaxing_EA, solid_faults
from ropewalk.scene.tension_curves import PAIRS_SCHEMA, Curve, curve_fault, with_curve

Friction = Literal["vector", "axial"]
_FRICTION = (
    "vector: against the whole difference of velocities; axial: only along the segment, which "
    "keeps angular momentum"
)
#: Largest angle between two segments of the unloaded rope [rad].
_MOST_TURN = 1.0
_TENSION_ONLY = "Whether a segment shorter than its rest length goes slack instead of pushing"
_PARTS = "Whether it parts where the tension passes its breaking load"


def breaking_load() -> Any:
    """Return the field of a breaking load."""
    use = "Tension at which it breaks, for utilisation and safety factor; with parts it parts there"
    return positive(use, "N", default=None)


def check_parts(made_of: Springs | Material) -> None:
    """Raise SceneError for what parts at no known load."""
    if made_of.parts and made_of.breaking_load is None:
        rule = "needs a load at which it parts: give breaking_load (N)"
        refuse([Fault("parts", True, rule)])


class Springs(Model):
    """A rope given spring by spring and node by node (the student report's and NeHe's way).

    Another number of segments makes another rope: each one more adds ``segment_length`` to
    the length and one node to the mass.
    """

    kind: Literal["springs"] = "springs"
    spring_constant: Stiffness = stiffness("Stiffness of each spring; inf makes rigid links", "N/m")
    node_mass: Number = positive("Mass of every node, the ends too", "kg")
    spring_friction: Number = not_negative(
        "Friction coefficient of each spring", "N s/m", default=0.0
    )
    segment_length: Number = not_negative("Rest length of each spring (0 is allowed)", "m")
    friction: Friction = Field(default="vector", description=_FRICTION)
    tension_only: Flag = Field(default=False, description=_TENSION_ONLY)
    breaking_load: Number | None = breaking_load()
    parts: Flag = Field(default=False, description=_PARTS)

    @model_validator(mode="after")
    def _check(self) -> Springs:
        check_parts(self)
        return self


class Material(FromDataSheet, Model):
    """A rope as a continuum: it stays the same rope however many segments it is cut into."""

    kind: Literal["material"] = "material"
    EA: Stiffness = stiffness(
        "Axial stiffness: tension per strain; inf makes a rope that does not stretch; left out with a curve",
        "N",
    )
    mass_per_length: Number = positive("Mass per unstretched length", "kg/m")
    axial_damping: Number = not_negative(
        "Tension per strain rate (EA x retardation)", "N s", default=0.0
    )
    EI: Number = not_negative(
        "Bending stiffness: moment per curvature; 0 bends freely", "N m^2", default=0.0
    )
    bending_damping: Number = not_negative(
        "Moment per rate of curvature's size (EI x retardation); what turns a bend is not damped",
        "N m^2 s",
        default=0.0,
    )
    curvature: Vector = vector(
        "Natural curvature: 1/radius of the unloaded rope along the axis it curls about "
        "(right-handed from start to end); the axis stays fixed in space",
        "1/m",
        default=(0, 0, 0),
    )
    friction: Friction = Field(default="axial", description=_FRICTION)
    tension_only: Flag = Field(default=False, description=_TENSION_ONLY)
    curve: Curve | None = Field(
        default=None,
        description="Tension against strain, in place of EA, which is then its largest slope",
    )
    relaxing_EA: Number | None = relaxing_EA()
    relaxation_time: Number | None = relaxation_time()
    breaking_load: Number | None = breaking_load()
    parts: Flag = Field(default=False, description=_PARTS)
    library: Text = Field(
        default="",
        max_length=100,
        description="Rope of the library that gives what is left out, EA or mass_per_length with it; "
        "else says where the numbers came from",
    )
    guessed: Many[Guess] = listed("Which numbers are guesses", "guess", "guessed", default=())

    @model_validator(mode="before")
    @classmethod
    def _fill(cls, data: Any, info: ValidationInfo) -> Any:
        return filled(with_curve(data, info))

    def derived(self) -> frozenset[str]:
        """See `Model.derived`."""
        return frozenset() if self.curve is None else frozenset({"EA"})

    @classmethod
    def __get_pydantic_json_schema__(cls, core_schema: Any, handler: Any) -> Any:
        made = super().__get_pydantic_json_schema__(core_schema, handler)
        made["properties"]["curve"]["anyOf"].append(PAIRS_SCHEMA)
        needed = made.pop("required")
        curved = ["curve" if name == "EA" else name for name in needed]
        ways = (needed, curved, ["library"])
        return made | {"anyOf": [{"required": way} for way in ways]}

    @model_validator(mode="after")
    def _check(self) -> Material:
        if self.curve is not None:
            refuse(curve_fault(self.EA, self.curve))
            self.__pydantic_fields_set__.discard("EA")
        check_parts(self)
        refuse(solid_faults(self))
        rule = "needs a bending stiffness: give EI (N m^2)"
        if self.EI == 0.0:
            if self.bending_damping > 0.0:
                refuse([Fault("bending_damping", self.bending_damping, rule)])
            if any(self.curvature):
                refuse([Fault("curvature", self.curvature, rule)])
        return self


class Rope(Model):
    """A chain of ``segments + 1`` nodes, numbered from 0 at its start."""

    name: Text = Field(
        default="rope", pattern=NAME, max_length=60, description="Name, needed with several ropes"
    )
    segments: Whole = Field(
        ge=1, le=MOST_SEGMENTS, description="Number of segments", json_schema_extra={"unit": "1"}
    )
    made_of: Annotated[Springs | Material, Field(discriminator="kind")] = Field(
        description="Springs, a material, or the name of a rope of the library"
    )
    length: Number | None = positive(
        "Unstretched length; only with a material (springs have segments x segment_length)",
        "m",
        default=None,
    )
    diameter: Number = positive(
        "Diameter, for quadratic air drag and, where given, for obstacles", "m", default=0.01
    )
    friction: Number = coefficient(
        "Coefficient of friction of its surface, Coulomb's, on obstacles and ropes: the larger of this and "
        "theirs holds",
        default=0.0,
    )
    shape: Shape = Field(default=Straight(), description="Initial shape")
    loads: Many[Load] = listed("Extra masses at nodes", "load", "loads", default=())
    kicks: Many[Kick] = listed("Initial velocities of single nodes", "kick", "kicks", default=())

    forces: Many[Force] = listed("Constant forces at nodes", "force", "forces", default=())
    submerged_weight: Number | None = quantity(
        "Weight in water per unstretched length, loads left out; negative: it floats up; "
        "default: its mass times gravity",
        "N/m",
        default=None,
    )

    @model_validator(mode="before")
    @classmethod
    def _from_library(cls, data: Any) -> Any:
        return with_diameter(data)

    @classmethod
    def __get_pydantic_json_schema__(cls, core_schema: Any, handler: Any) -> Any:
        made = super().__get_pydantic_json_schema__(core_schema, handler)
        tables = made["properties"]["made_of"]
        about = {"description": tables.pop("description")}
        named = {"type": "string", "examples": names()}
        made["properties"]["made_of"] = about | {"anyOf": [tables, named]}
        return made

    @property
    def nodes(self) -> int:
        """Number of nodes, one more than segments."""
        return self.segments + 1

    @property
    def length_unstretched(self) -> float:
        """Unstretched length of the whole rope [m]."""
        if isinstance(self.made_of, Springs):
            return self.segments * self.made_of.segment_length
        return float(self.length or 0.0)

    @property
    def segment_length(self) -> float:
        """Rest length of one segment [m]."""
        if isinstance(self.made_of, Springs):
            return self.made_of.segment_length
        return self.length_unstretched / self.segments

    @property
    def segment_stiffness(self) -> float:
        """Largest stiffness of one segment [N/m]: spring constant, or EA and relaxing_EA over its length."""
        if isinstance(self.made_of, Springs):
            return self.made_of.spring_constant
        return (self.made_of.EA + (self.made_of.relaxing_EA or 0.0)) / self.segment_length

    @property
    def rigid(self) -> bool:
        """Whether its segments are rigid links."""
        return math.isinf(self.segment_stiffness)

    @property
    def curved(self) -> bool:
        """Whether its tension follows a curve of the strain."""
        return isinstance(self.made_of, Material) and self.made_of.curve is not None

    @property
    def relaxes(self) -> bool:
        """Whether a part of its tension relaxes."""
        return isinstance(self.made_of, Material) and self.made_of.relaxing_EA is not None

    @property
    def segment_friction(self) -> float:
        """Friction coefficient of one segment [N s/m], of the form ``made_of.friction``."""
        if isinstance(self.made_of, Springs):
            return self.made_of.spring_friction
        return self.made_of.axial_damping / self.segment_length

    @property
    def bending_stiffness(self) -> float:
        """Bending stiffness EI [N m^2]; 0 for springs."""
        return 0.0 if isinstance(self.made_of, Springs) else self.made_of.EI

    @property
    def strength(self) -> float:
        """Tension at which it parts [N]; inf where it does not."""
        load = self.made_of.breaking_load if self.made_of.parts else None
        return math.inf if load is None else load

    @property
    def own_mass(self) -> float:
        """Mass without loads [kg]."""
        if isinstance(self.made_of, Springs):
            return self.nodes * self.made_of.node_mass
        return self.made_of.mass_per_length * self.length_unstretched

    @property
    def total_mass(self) -> float:
        """Mass with loads [kg]."""
        return self.own_mass + sum(load.mass for load in self.loads)

    def node_index(self, node: int) -> int:
        """The node counted from 0, for one that may be negative (counted from the end).

        Raises:
            IndexError: when the rope has no such node.
        """
        if not -self.nodes <= node < self.nodes:
            raise IndexError(f"rope {self.name!r} has no node {node}: {node_range(self)}")
        return node % self.nodes

    @model_validator(mode="after")
    def _check(self) -> Rope:
        refuse(rope_faults(self))
        return self

    def __str__(self) -> str:
        made_of = self.made_of
        if self.rigid:
            stuff = "rigid links"
        elif isinstance(made_of, Springs):
            stuff = f"springs of {made_of.spring_constant:g} N/m"
        elif made_of.curve is not None:
            stuff = f"material with a curve of up to EA = {made_of.EA:g} N"
        else:
            stuff = f"material with EA = {made_of.EA:g} N"
        if not isinstance(made_of, Springs) and made_of.relaxing_EA is not None:
            stuff += f" and {made_of.relaxing_EA:g} N that relax"
        size = f"{_count(self.segments, 'segment')}, {self.length_unstretched:g} m"
        masses = mass_words(self.own_mass, self.total_mass)
        return f"Rope {self.name!r}: {size}, {masses}, {stuff}."

    __repr__ = __str__


def mass_words(own: float, whole: float, form: str = "g") -> str:
    """A rope's own mass [kg] in words, and with its loads where it has any; each number in a `form`."""
    return f"{own:{form}} kg" + ("" if whole == own else f", with loads {whole:{form}} kg")


def node_range(rope: Rope) -> str:
    """The rule for a node of this rope, in words."""
    return f"must be from 0 to {rope.segments}, or from -{rope.nodes} to -1 counted from the end"


def rope_faults(rope: Rope) -> list[Fault]:
    """What fields that are right by themselves get wrong together; paths relative to the rope."""
    faults = []
    springs = isinstance(rope.made_of, Springs)
    if springs and rope.length is not None:
        product = f"{rope.segments} x {rope.segment_length:g} m"
        rule = f"leave it out with springs: their length is segments x segment_length ({product})"
        faults.append(Fault("length", rope.length, rule))
    if not springs and rope.length is None:
        faults.append(Fault("length", MISSING, "a material needs the rope's length (m)"))
        return faults
    if springs and rope.rigid and rope.segment_length == 0.0:
        rule = "inf makes rigid links, which need a segment_length greater than 0"
        faults.append(Fault("made_of.spring_constant", math.inf, rule))
    if springs and rope.made_of.parts and rope.segment_length == 0.0:
        rule = "needs springs of a length: give a segment_length greater than 0"
        faults.append(Fault("made_of.parts", True, rule))
    if isinstance(rope.made_of, Material):
        turn = math.hypot(*rope.made_of.curvature) * rope.segment_length
        if turn > _MOST_TURN:
            least = math.ceil(rope.segments * turn / _MOST_TURN)
            rule = f"turns by {turn:.3g} rad from segment to segment; take {least} segments or more"
            faults.append(Fault("made_of.curvature", rope.made_of.curvature, rule))
    if rope.submerged_weight is not None and rope.length_unstretched == 0.0:
        rule = "leave it out: springs of no length have no weight per length"
        faults.append(Fault("submerged_weight", rope.submerged_weight, rule))
    nodes = [(f"load[{i}].node", load.node) for i, load in enumerate(rope.loads)]
    nodes += [(f"force[{i}].node", one.node) for i, one in enumerate(rope.forces)]
    nodes += [(f"kick[{i}].node", kick.node) for i, kick in enumerate(rope.kicks)]
    for path, node in nodes:
        if not -rope.nodes <= node < rope.nodes:
            faults.append(Fault(path, node, node_range(rope)))
    first: dict[int, int] = {}
    for i, kick in enumerate(rope.kicks):
        earlier = first.setdefault(kick.node % rope.nodes, i)
        if earlier != i:
            faults.append(
                Fault(f"kick[{i}].node", kick.node, f"is kicked by kick[{earlier}] already")
            )
    return faults + _shape_faults(rope)


def _shape_faults(rope: Rope) -> list[Fault]:
    """Whether the shape fits the rope's length and number of nodes."""
    shape, length = rope.shape, rope.length_unstretched
    if isinstance(shape, Points) and len(shape.points) != rope.nodes:
        rule = f"must be {rope.nodes} points, one per node (segments + 1)"
        return [Fault("shape.points", f"{len(shape.points)} points", rule)]
    if isinstance(shape, Knot):
        return shape.faults(rope.diameter, rope.segments, length)
    if isinstance(shape, Slack) and rope.rigid and length < shape.span * (1 - 1e-9):
        rule = f"the rope of {length:g} m is shorter than the {shape.span:g} m from start to end"
        rule += ", and does not stretch"
        return [Fault("shape.end", shape.end, rule)]
    if length == 0.0 and shape.kind == "hanging":
        rule = "needs a rope that has a length; give a straight shape with start and end"
        return [Fault("shape.kind", shape.kind, rule)]
    if length == 0.0 and isinstance(shape, Straight) and shape.end is None:
        rule = "springs of no length need the place of the last node"
        return [Fault("shape.end", MISSING, rule)]
    return []


def _count(number: int, noun: str) -> str:
    """``1 segment``, ``2 segments``."""
    return f"{number} {noun}" + ("" if number == 1 else "s")
