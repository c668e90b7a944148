"""Likely slips of units in a scene: numbers that no rope has, and the unit they may be in.

Every rule states the number, why it looks wrong, and the probable unit. They are warnings: a scene
may mean what it says. The limits are wide on purpose; ropes from fishing line (1e-5 kg/m) to
mooring chain (500 kg/m) and from rubber (sound at some 30 m/s) to carbon fibre (10 km/s) pass.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.laws.obstacle_rows import axle_of, corners_of, hub_of, turned_by
from ropewalk.lowering import Model
from ropewalk.scene import Material, Rope, Scene, Springs, TableCurve
from ropewalk.scene.obstacles import Obstacle

# Speed of sound along a rope, sqrt(EA / mass per length) [m/s].
_SLOWEST = {"springs": 0.5, "material": 20.0}  # springs are often meant to be soft
_FASTEST = 15_000.0
_HEAVIEST_LINE = 500.0  # kg/m
_HEAVIEST_LOAD = 5000.0  # of a rope's own mass, at least of 1 kg [1]; a car on a tow rope has 1060
_HEAVY_NODE = 10.0  # kg, of a rope whose nodes are at most a metre apart
_THINNEST_LINE = 5e-9  # kg/m; a spider's thread has 9e-9
_YOUNG = 1e3, 2e12  # N/m^2
_MOST_STRAIN = 8.0  # [1] rubber breaks at some 7
_DENSITY = 10.0, 40_000.0  # kg/m^3; a chain goes by the diameter of its bar
_STIFFEST = 1.5  # [1] radius of gyration over that of a solid round section; a thin tube has 1.41
_OWN_LENGTH = (
    300.0,
    5e5,
)  # m of itself that a rope bears: rubber and cables have some 1.3 km, HMPE 170 km
_BREAK_STRAIN = 5e-4, 4.0  # [1] breaking load over EA: power cables have 0.0013, shock cord 2.3
_RUBBER = 60.0  # speed of sound below which a rope is of rubber and stretches by more [m/s]
_SHORTEST = 3.0  # length over diameter [1]
_LONGEST = 1e4  # m, of a rope with weight
_SOUND = 340.0  # m/s, in air
_ROUGHEST = 3.0  # [1] coefficient of friction; rubber on rough rock has some 1.5
_FAR_OFF = 100.0  # initial length over unstretched length, or the reverse


def unit_slips(model: Model) -> list[str]:
    """Return one sentence for every number of a scene that looks like a slip of units."""
    scene = model.scene
    found = _gravity(scene) + _run(scene) + _speeds(model) + _frictions(scene)
    found += _wind(scene) + _idle_friction(scene)
    for i, rope in enumerate(scene.ropes):
        path = f"rope[{i}]"
        found += _line(path, rope) + _section(path, rope, scene) + _size(path, rope, model)
        found += _strength(path, rope) + _bending(path, rope) + _in_water(path, rope, scene)
        for j, load in enumerate(rope.loads):
            if load.mass > _HEAVIEST_LOAD * max(rope.own_mass, 1.0):
                found.append(
                    f"{path}.load[{j}].mass: {load.mass:g} kg is {load.mass / rope.own_mass:.3g} "
                    "times the rope's own mass; grams for kilograms?"
                )
    return found


def _gravity(scene: Scene) -> list[str]:
    size = math.hypot(*scene.gravity)
    _, y, z = scene.gravity
    if size > 1000.0:
        return [f"gravity: {size:g} m/s^2 is 9.81 m/s^2 in mm/s^2, or too strong by far"]
    if 31.5 < size < 33.0:
        return [f"gravity: {size:g} m/s^2 is 9.81 m/s^2 in ft/s^2"]
    if size > 100.0:
        return [f"gravity: {size:g} m/s^2 is stronger than on any planet; cm/s^2 for m/s^2?"]
    if 9.7 < size < 9.9 and max(y, z) > 0.999 * size:
        axis = "y" if y > z else "z"
        return [f"gravity: points to +{axis}, so that -{axis} is up; a sign lost?"]
    return []


def _run(scene: Scene) -> list[str]:
    run, found = scene.run, []
    if run.time_step != "auto" and run.time_step >= 0.2:
        found.append(f"run.time_step: {run.time_step:g} s is very long; milliseconds for seconds?")
    if run.frame_rate < 0.1 and run.duration < 1000.0:
        found.append(f"run.frame_rate: {run.frame_rate:g} frames a second; a frame time instead?")
    return found


def _speeds(model: Model) -> list[str]:
    """Speeds that are given, of what begins, is led or is wound: the fastest one of each rope or thing."""
    scene = model.scene
    if not any(scene.gravity):  # in space they go at kilometres a second
        return []
    given = []
    for i, rope in enumerate(scene.ropes):
        given.append((f"rope[{i}].shape.velocity", math.hypot(*rope.shape.velocity)))
        kicks = [math.hypot(*kick.velocity) for kick in rope.kicks]
        given.append((f"rope[{i}].kick", max(kicks, default=0.0)))
    for name, led in (("anchor", scene.anchors), ("obstacle", scene.obstacles)):
        for i, one in enumerate(led):
            velocity = getattr(one.motion, "velocity", (0.0,))
            given.append((f"{name}[{i}].motion.velocity", math.hypot(*velocity)))
            given.append((f"{name}[{i}].motion.positions", _fastest(one.motion)))
    given += [(f"winch[{i}].speed", abs(one.speed)) for i, one in enumerate(scene.winches)]
    return [
        f"{path}: {speed:.4g} m/s is faster than sound in air; mm/s for m/s?"
        for path, speed in given
        if speed > _SOUND
    ] + [text for i in range(len(scene.obstacles)) for text in _spin(i, model)]


def _frictions(scene: Scene) -> list[str]:
    """Coefficients of Coulomb's friction, of obstacles, ropes on ropes and what slides."""
    given = [(f"obstacle[{i}].friction", one.friction) for i, one in enumerate(scene.obstacles)]
    given += [(f"slide[{i}].friction", one.friction) for i, one in enumerate(scene.slides)]
    given += [(f"rope[{i}].friction", one.friction) for i, one in enumerate(scene.ropes)]
    given += [
        (f"obstacle[{i}].pair[{k}].friction", pair.friction)
        for i, one in enumerate(scene.obstacles)
        for k, pair in enumerate(one.pairs)
    ]
    if scene.contact is not None:
        given.append(("contact.friction", scene.contact.friction))
        pairs = enumerate(scene.contact.pairs)
        given += [(f"contact.pair[{k}].friction", pair.friction) for k, pair in pairs]
    return [
        f"{path}: {value:g} is rougher than any rope on anything (0.1 to 1.5); a percentage, or an angle? "
        f"{value:g} % is {0.01 * value:g}"
        for path, value in given
        if value > _ROUGHEST
    ]


def _wind(scene: Scene) -> list[str]:
    """A wind without anything that it could blow on."""
    air = scene.air
    if air is None or not any(air.wind):
        return []
    if air.drags:
        return []
    return [
        "air.wind: blows on nothing without a drag; give air.density (1.2 kg/m^3 at sea level), or node_drag"
    ]


def _idle_friction(scene: Scene) -> list[str]:
    """Frictions of ropes that touch nothing with Coulomb's."""
    if scene.obstacles or scene.contact is not None:
        return []
    return [
        f"rope[{i}].friction: rubs on nothing; it is for [[obstacle]] and [contact] (the ground has its own)"
        for i, rope in enumerate(scene.ropes)
        if rope.friction > 0.0
    ]


def _spin(row: int, model: Model) -> list[str]:
    """The greatest rate of a spin, as the speed that it gives the body's surface."""
    body = model.scene.obstacles[row]
    if body.spin is None:
        return []
    by_table = _fastest(body.spin.as_motion()) if body.spin.times else 0.0
    rate, reach = max(abs(body.spin.rate or 0.0), by_table), _reach(body, model.state.x.T)
    if rate * reach <= _SOUND:
        return []
    surface = f"{rate:.4g} rad/s is {rate * reach:.4g} m/s at {reach:.4g} m from the axis"
    slip = "degrees for radians, or mm for m?"
    return [f"obstacle[{row}].spin: {surface}, faster than sound in air; {slip}"]


def _reach(body: Obstacle, nodes: Floats) -> float:
    """Return how far a surface is from its axis at most [m], of a plane at the farthest node, (n, 3)."""

    def aside(places: Any) -> float:
        away = np.asarray(places, dtype=float) - hub_of(body)
        return float(np.linalg.norm(np.cross(away, axle_of(body)), axis=-1).max())

    match body.kind:
        case "box":  # its edges are round about the corners of a smaller box
            inner = np.array(body.half_sizes) - body.edge_radius
            corners = turned_by(body.rotation, inner * list(itertools.product((-1, 1), repeat=3)))
            return aside(np.array(body.center) + corners) + body.edge_radius
        case "mesh" | "sdf":
            return aside(np.array(body.position) + corners_of(body)) + body.rounding
        case "plane":
            return aside(nodes)
        case "torus":
            return aside(body.center) + body.radius + body.bar_radius
        case "cylinder" | "capsule":
            return aside([body.start, body.end]) + body.radius
        case "sphere":
            return aside(body.center) + body.radius
    return body.radius


def _fastest(motion: object) -> float:
    """Return the greatest mean speed between two times of a table [m/s]; 0 of other motions."""
    times, positions = getattr(motion, "times", ()), getattr(motion, "positions", ())
    if len(times) < 2 or len(times) != len(positions):
        return 0.0
    ways = np.linalg.norm(np.diff(np.asarray(positions, dtype=float), axis=0), axis=1)
    return float((ways / np.diff(times)).max())


def _line(path: str, rope: Rope) -> list[str]:
    """Mass per length, stiffness and the speed of sound that the two make."""
    length = rope.segment_length
    if length <= 0.0:
        return []
    made_of = rope.made_of
    stiffness = rope.segment_stiffness * length
    if isinstance(made_of, Springs):
        line = made_of.node_mass / length
        mass, name = f"node_mass: {made_of.node_mass:g} kg", "spring_constant"
        value, wrong = f"{made_of.spring_constant:g} N/m", "kN/m for N/m"
        heavy = line > _HEAVIEST_LINE or (made_of.node_mass >= _HEAVY_NODE and length <= 1.0)
    else:
        line = made_of.mass_per_length
        mass, name = f"mass_per_length: {line:g} kg/m", "EA" if made_of.curve is None else "curve"
        value, wrong = f"{made_of.EA:g} N", "kN for N"
        heavy = line > _HEAVIEST_LINE
    found = []
    if heavy:
        found.append(f"{path}.made_of.{mass} makes {line:.3g} kg per metre; grams for kilograms?")
    if line < _THINNEST_LINE:
        found.append(
            f"{path}.made_of.{mass} makes {line:.3g} kg per metre, less than a spider's thread; "
            "lengths in millimetres?"
        )
    if isinstance(made_of, Material) and isinstance(made_of.curve, TableCurve):
        strain = made_of.curve.strain[-1]
        if strain > _MOST_STRAIN:
            found.append(
                f"{path}.made_of.curve.strain: {strain:g} is {100.0 * strain:g} % of stretch, more than "
                "rubber's; per cent for shares?"
            )
    sound = math.sqrt(stiffness / line)
    if sound > _FASTEST and not rope.rigid:
        why = "Young's modulus (N/m^2) for EA (N)" if name == "EA" else "kN/m^2 or N/m^2 for N/m"
        found.append(
            f"{path}.made_of.{name}: {value} makes sound run along the rope at {sound:.3g} m/s, "
            f"faster than in any fibre; {why}, or a mass too small?"
        )
    if sound < _SLOWEST[made_of.kind]:
        found.append(
            f"{path}.made_of.{name}: {value} makes sound run along the rope at only "
            f"{sound:.3g} m/s, slower than in rubber; {wrong}, or grams for kilograms?"
        )
    return found


def _section(path: str, rope: Rope, scene: Scene) -> list[str]:
    """A diameter that was given, and the modulus and density that it implies."""
    if "diameter" not in rope.model_fields_set:
        return []
    found = []
    if rope.diameter > 0.5:
        return [f"{path}.diameter: {rope.diameter:g} m is not a rope's; millimetres for metres?"]
    if _SHORTEST * rope.diameter > max(rope.length_unstretched, 1e-3):
        return [
            f"{path}: {rope.length_unstretched:g} m of a rope of {rope.diameter:g} m of diameter is not a "
            "rope's shape; millimetres for metres, or metres for millimetres?"
        ]
    area = 0.25 * math.pi * rope.diameter**2
    if isinstance(rope.made_of, Material):
        modulus = rope.made_of.EA / area
        if not (rope.rigid or _YOUNG[0] <= modulus <= _YOUNG[1]):
            found.append(
                f"{path}.made_of.EA: {rope.made_of.EA:g} N over {1e3 * rope.diameter:g} mm of "
                f"diameter is a modulus of {modulus:.3g} N/m^2, that of no material; EA is in N"
            )
        density = rope.made_of.mass_per_length / area
        if density < _DENSITY[0] and any(slide.rope == rope.name for slide in scene.slides):
            # A rider: his masses are loads, and the diameter is his to the air.
            density = rope.total_mass / (area * rope.length_unstretched)
        if not _DENSITY[0] <= density <= _DENSITY[1]:
            found.append(
                f"{path}.made_of.mass_per_length: {rope.made_of.mass_per_length:g} kg/m over "
                f"{1e3 * rope.diameter:g} mm of diameter is a density of {density:.3g} kg/m^3; "
                "g/m for kg/m?"
            )
    return found


def _strength(path: str, rope: Rope) -> list[str]:
    """A breaking load, against the rope's own weight and against its EA."""
    made_of = rope.made_of
    if not isinstance(made_of, Material) or made_of.breaking_load is None:
        return []
    load, line = made_of.breaking_load, made_of.mass_per_length
    start, found = f"{path}.made_of.breaking_load: {load:g} N", []
    own = load / (9.81 * line)
    if not _OWN_LENGTH[0] <= own <= _OWN_LENGTH[1]:
        wrong = (
            "kN for N, or g/m for kg/m?" if own < _OWN_LENGTH[0] else "g/m for kg/m, or too many N?"
        )
        found.append(f"{start} bears {own:.3g} m of this rope, of {line:g} kg/m; {wrong}")
    strain = load / made_of.EA
    soft = math.sqrt(made_of.EA / line) < _RUBBER
    if not rope.rigid and (strain < _BREAK_STRAIN[0] or (strain > _BREAK_STRAIN[1] and not soft)):
        found.append(
            f"{start} over an EA of {made_of.EA:g} N is a stretch of {100.0 * strain:.3g} %, where no rope "
            "breaks; kN for N in one of them?"
        )
    return found


def _bending(path: str, rope: Rope) -> list[str]:
    """EI over EA is the square of a section's radius of gyration, d/4 of a round rod."""
    made_of = rope.made_of
    if not isinstance(made_of, Material) or made_of.EI == 0.0 or rope.rigid:
        return []
    radius = math.sqrt(made_of.EI / made_of.EA)
    if "diameter" in rope.model_fields_set:
        solid = 0.25 * rope.diameter
        if radius > _STIFFEST * solid:
            return [
                f"{path}.made_of.EI: {made_of.EI:g} N m^2 is more than a round section of "
                f"{1e3 * rope.diameter:g} mm can have with this EA; a solid one has "
                f"{made_of.EA * solid**2:.3g} N m^2, strands that slide far less; N mm^2 for N m^2?"
            ]
    elif radius > 0.25 * rope.length_unstretched:
        return [
            f"{path}.made_of.EI: {made_of.EI:g} N m^2 over EA {made_of.EA:g} N means a section "
            f"{4.0 * radius:.3g} m thick; N mm^2 for N m^2?"
        ]
    return []


def _in_water(path: str, rope: Rope, scene: Scene) -> list[str]:
    """Water only makes a rope lighter."""
    weight = rope.submerged_weight
    if weight is None:
        return []
    dry = rope.own_mass * math.hypot(*scene.gravity) / rope.length_unstretched
    if weight <= dry * (1.0 + 1e-6):
        return []
    return [
        f"{path}.submerged_weight: {weight:g} N/m is more than its {dry:.4g} N/m in air, and water only "
        "makes it lighter; another unit for N/m, or its mass too small?"
    ]


def _size(path: str, rope: Rope, model: Model) -> list[str]:
    """How long the rope starts, against its unstretched length."""
    length = rope.length_unstretched
    if length <= 0.0:
        return []
    span = model.layout.span(rope.name)
    x = model.state.x[:, span.start : span.end + 1]
    ratio = float(np.linalg.norm(np.diff(x, axis=1), axis=0).sum()) / length
    found = []
    if ratio > _FAR_OFF:
        found.append(
            f"{path}.shape: starts {ratio:.3g} times as long as the unstretched rope of "
            f"{length:g} m; places in millimetres?"
        )
    elif 0.0 < ratio < 1.0 / _FAR_OFF:
        found.append(
            f"{path}.shape: starts at 1/{1 / ratio:.3g} of the unstretched length of {length:g} m; "
            "rope lengths in millimetres?"
        )
    if length > _LONGEST and np.any(model.system.gravity):
        found.append(f"{path}: {length:g} m of rope; lengths in millimetres?")
    light = rope.own_mass / length < (0.05 if rope.made_of.kind == "springs" else 0.002)
    if length > 500.0 and rope.segment_length >= 5.0 and light:  # a tether of 5 mm has some 20 g/m
        found.append(
            f"{path}: {length:g} m of rope of only {rope.own_mass:g} kg in segments of "
            f"{rope.segment_length:g} m; lengths in millimetres?"
        )
    return found
