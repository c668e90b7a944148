"""The recorded quantities: names, dimensions, units, and where a block of frames holds them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.core.peaks import BOUNDS, EXTREMES
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.laws.wheel_rows import RECORDED, UNITS
from ropewalk.lowering import Layout
from ropewalk.methods.recording import energy_names, work_names
from ropewalk.scene import Scene
from ropewalk.simulation.block import Block
from ropewalk.simulation.rope_contacts import COLUMNS, slots

AXES = ("x", "y", "z")
ENERGY = "energy; that of gravity is 0 in the scene's own shape"
JUMPS = ("limiter", "winch")
ROPE_CONTACTS, PULLEYS, CONTACT_WORK = "rope_contacts", "pulleys", "contact_work"
WORKS = ("work", CONTACT_WORK)  # unknown without a ledger
OBSTACLE_FORCE = "obstacle_force"
PRESSED = ("greatest_surface_forces", "surface_force_times", "surface_forces_before")
_OF_BLOCKS = ("pairs", "obstacles")  # fields of `simulation.block.Block`, not of its recording


@dataclass(frozen=True)
class Quantity:
    """One recorded quantity; its first dimension is always `time`."""

    name: str
    dims: tuple[str, ...]
    unit: str
    long_name: str
    field: str  # of `methods.recording.Recording`, or one of _OF_BLOCKS
    swapped: bool = False  # kept in memory and on disk as (time, axis, node)


_A_NODE = "one node (it goes with the length of the segments)"
_SINCE = "of all steps since the frame before"
EXTREME_UNITS = ("N", "N", "1", "m/s", "m", "m", "N", "N m")
_OF_INTERVALS = tuple(
    Quantity(name, ("time", place), unit, f"{meaning} {_SINCE}", field)
    for name, place, unit, meaning, field in (
        ("least_tension", "segment", "N", "least tension", "tension_low"),
        ("greatest_tension", "segment", "N", "greatest tension", "tension_high"),
        ("greatest_stretch", "segment", "1", "greatest stretch", "stretch_high"),
        ("greatest_speed", "node", "m/s", "greatest speed", "speed_high"),
        ("least_height", "node", "m", "least height", "lowest"),
        ("greatest_height", "node", "m", "greatest height", "highest"),
        ("greatest_reactions", "anchor", "N", "greatest force", "reaction_high"),
        ("greatest_moments", "anchor", "N m", "greatest moment", "moment_high"),
        ("extremes", "extreme", ", ".join(EXTREME_UNITS), "greatest and least", "extremes"),
        ("extreme_places", "extreme", "1", "place of the greatest and least", "extreme_places"),
        ("extreme_since", "extreme", "s", "time after which came the extreme", "extreme_since"),
        ("extreme_until", "extreme", "s", "time until which came the extreme", "extreme_until"),
        ("greatest_surface_forces", "surface", "N", "greatest force on it", "pressed_high"),
        ("surface_force_times", "surface", "s", "time of the greatest force on it", "pressed_time"),
        (
            "surface_forces_before",
            "surface",
            "N",
            "least force on it just before",
            "pressed_before",
        ),
        ("energy_errors", "bound", "J", "least and greatest energy error", "error_range"),
        ("energy_error_times", "bound", "s", "time of the energy error's bound", "error_times"),
    )
)
QUANTITIES = (
    Quantity("positions", ("time", "node", "axis"), "m", "position", "x", True),
    Quantity("velocities", ("time", "node", "axis"), "m/s", "velocity", "v", True),
    Quantity("tension", ("time", "segment"), "N", "tension", "tension"),
    Quantity("elastic_tension", ("time", "segment"), "N", "elastic tension", "elastic_tension"),
    Quantity("rest_length", ("time", "segment"), "m", "unstretched length", "rest_length"),
    Quantity("energy", ("time", "form"), "J", ENERGY, "energy"),
    Quantity("work", ("time", "law"), "J", "work done on the rope since the start", "work"),
    Quantity("jump", ("time", "cause"), "J", "kinetic energy put in without a force", "jump"),
    Quantity(
        "reactions", ("time", "anchor", "axis"), "N", "anchor's force on the rope", "reaction"
    ),
    Quantity("moments", ("time", "anchor", "axis"), "N m", "clamp's moment on the rope", "moment"),
    Quantity(
        "joint_forces", ("time", "tie", "axis"), "N", "joint's force on a rope", "joint_force"
    ),
    Quantity(
        "contact_force",
        ("time", "node", "axis"),
        "N",
        f"force of obstacles and of other ropes on {_A_NODE}",
        "contact",
        True,
    ),
    Quantity(
        OBSTACLE_FORCE,
        ("time", "node", "axis"),
        "N",
        f"force of obstacles alone on {_A_NODE}",
        "obstacles",
        True,
    ),
    Quantity(
        ROPE_CONTACTS,
        ("time", "pair", "column"),
        "1, 1, 1, 1, N, N, N, N",
        "contacts of ropes with ropes",
        "pairs",
    ),
    Quantity(
        PULLEYS,
        ("time", "pulley", "motion"),
        ", ".join(UNITS),
        "motion of obstacles that turn freely",
        "wheel",
    ),
    Quantity(
        CONTACT_WORK,
        ("time", "surface", "entry"),
        "J",
        "work on the ropes of what they touch, since the start",
        "books",
    ),
    Quantity("momentum", ("time", "axis"), "kg m/s", "momentum", "momentum"),
    Quantity(
        "angular_momentum",
        ("time", "axis"),
        "kg m^2/s",
        "angular momentum about the origin",
        "angular_momentum",
    ),
    *_OF_INTERVALS,
)
BY_NAME = {quantity.name: quantity for quantity in QUANTITIES}


def law_names(layout: Layout) -> tuple[str, ...]:
    """Return the columns of `work`: the laws, then the anchors."""
    return (
        *work_names(layout.bends, layout.more),
        *(f"anchor:{name}" for name in layout.anchor_names),
    )


def labels(layout: Layout) -> dict[str, tuple[str, ...]]:
    """Return the names along the dimensions that are counted by names."""
    return {
        "axis": AXES,
        "form": energy_names(layout.bends),
        "law": law_names(layout),
        "cause": JUMPS,
        "anchor": layout.anchor_names,
        "extreme": EXTREMES,
        "bound": BOUNDS,
        "tie": layout.ties,
        "column": COLUMNS if "contact" in layout.more else (),
        "pulley": layout.pulleys,
        "motion": RECORDED if layout.pulleys else (),
        "surface": layout.surfaces,
        "entry": ENTRIES if layout.surfaces else (),
    }


# Run folders of format 2 have no other tension than the elastic one, and call it `tension`.
ELASTIC_ONLY = 2
FRAMES_ONLY = 3  # until this one nothing was kept of the steps between frames
SUMS_ONLY = 5  # until this one nothing of ropes on ropes but the sum of all contacts' forces
IN_ONE = 6  # until this one the work of all obstacles was one number
TOGETHER = 7  # until this one the force of obstacles was not apart from that of ropes
WEIGHTLESS = 8  # until this one no weight turned what turns freely
UNPRESSED = 9  # until this one no force on obstacles was kept of the steps between frames
_OLD_MOTIONS = 6  # of what turns freely, until then


def stored(layout: Layout, scene: Scene, version: int) -> tuple[Quantity, ...]:
    """Return the quantities in a run folder of a format."""
    now = recorded(layout, scene)
    if version <= UNPRESSED:
        now = tuple(q for q in now if q.name not in PRESSED)
    if version <= TOGETHER:
        now = tuple(q for q in now if q.name != OBSTACLE_FORCE)
    if version <= IN_ONE:
        now = tuple(q for q in now if q.name != CONTACT_WORK)
    if version <= SUMS_ONLY:
        now = tuple(q for q in now if q.name != ROPE_CONTACTS)
    if version > FRAMES_ONLY:
        return now
    old = tuple(q for q in now if q not in _OF_INTERVALS)
    if version > ELASTIC_ONLY:
        return old
    return tuple(q for q in old if q.name != "elastic_tension")


def recorded(layout: Layout, scene: Scene) -> tuple[Quantity, ...]:
    """Return the quantities that a run of a scene records (none of length zero)."""
    left_out = set() if layout.anchor_names else {"reactions", "greatest_reactions"}
    if not layout.clamped:
        left_out |= {"moments", "greatest_moments"}
    if not layout.ties:
        left_out.add("joint_forces")
    if not layout.touches:
        left_out.add("contact_force")
    if scene.contact is None:
        left_out.add(ROPE_CONTACTS)
    if scene.contact is None or not scene.obstacles:
        left_out.add(OBSTACLE_FORCE)
    if not layout.pulleys:
        left_out.add(PULLEYS)
    if not layout.surfaces:
        left_out.add(CONTACT_WORK)
    if not scene.obstacles:
        left_out |= set(PRESSED)
    if not scene.lengths_change:
        left_out.add("rest_length")
    if not scene.run.extremes:
        left_out |= {quantity.name for quantity in _OF_INTERVALS}
    return tuple(quantity for quantity in QUANTITIES if quantity.name not in left_out)


def sizes(layout: Layout, version: int | None = None) -> dict[str, int]:
    """Return the length of every dimension but time, in a folder of a format, else the present one."""
    found = {name: len(values) for name, values in labels(layout).items()}
    if version is not None and version <= WEIGHTLESS:
        found["motion"] = min(found["motion"], _OLD_MOTIONS)
    places = {"node": layout.nodes, "segment": layout.segments, "pair": slots(layout.segments)}
    return found | places


def raw(block: Block, quantity: Quantity) -> Floats:
    """Return a quantity of a block as it is recorded: (time, axis, node) where `swapped`."""
    array: Floats = getattr(
        block if quantity.field in _OF_BLOCKS else block.recording, quantity.field
    )
    return array


def rope_numbers(layout: Layout) -> NDArray[np.int64]:
    """Return the number of the rope of every node, (n,)."""
    return np.repeat(np.arange(len(layout.ropes)), [span.nodes for span in layout.ropes])


def joined(layout: Layout) -> NDArray[np.bool_]:
    """Tell which segments join two nodes of one rope, (s,); the others are dead."""
    numbers = rope_numbers(layout)
    same: NDArray[np.bool_] = numbers[1:] == numbers[:-1]
    return same


def has_rope(layout: Layout, rest: Floats, lengths: list[float]) -> NDArray[np.bool_]:
    """Tell where there is rope, (..., s): not between two ropes, and not on a winch's drum.

    Args:
        layout: of the ropes.
        rest: unstretched length of all segments [m], (..., s); 0 on a drum.
        lengths: each rope's segment length [m]; where that is 0, so is every rest length off a drum.
    """
    found: NDArray[np.bool_] = rest > 0.0
    for span, length in zip(layout.ropes, lengths, strict=True):
        if length == 0.0:
            found[..., span.first : span.last] = True
    return found & joined(layout)


def rest_length_at_start(layout: Layout, lengths: list[float]) -> Floats:
    """Return the unstretched length of all segments [m], (s,), from each rope's segment length."""
    out = np.zeros(layout.segments)
    for span, length in zip(layout.ropes, lengths, strict=True):
        out[span.start : span.end] = length
    return out
