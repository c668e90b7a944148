"""The one rope of a scene as PyElastica's Cosserat rod, on a plane or over a cylinder.

PyElastica (extra `ropewalk[bench]`) gets the same rope: mass, length, diameter, as many elements as
segments, E = EA / A. Bending would follow from E and the radius, EI = EA r^2 / 4, which makes a bar of it:
the capstan's, 0.06 N m^2, springs off its drum. So that is cut down (`BENDS`) until the rope's own weight
bends it round the drum, as Ropewalk's bends freely and MuJoCo's has ball joints; shear and twist follow.

Friction: on a plane it holds below a speed and slips above, as Coulomb's; on a cylinder it is viscous, at
most Coulomb's, with the coefficient that the documentation names against slip. Between rods there is none:
a rope that lies across another slides off, so that neither crossing nor pile can be the same.

Contacts have the stiffness and damping of the documentation's examples. They are those of the middles of
elements: a cylinder is thinner by as much as straight pieces would be inside it at the start. High modes
are damped by the filter that it has for that, which leaves a rope alone that slides as a whole.
"""

from __future__ import annotations

import math
import time
from typing import Any, NamedTuple

import numpy as np

import ropewalk as rw
from ropewalk.scene import Rope

FRAME = 1.0 / 60.0  # [s] between places that are kept
BENDS = 1e-5  # [1] of the bending stiffness of a solid rod
STIFFNESS, DAMPING = 1e4, 10.0  # [N/m], [N s/m] of a contact
NO_SLIP = 1e4  # [N s/m] of the friction on a cylinder
HOLDS_BELOW = 1e-4  # [m/s] on a plane
FILTER = 5  # order of the filter; 3 to 7 are recommended
#: Of the longest step that its explicit method bears. The documentation's rule of thumb, 0.01 s/m of an
#: element, is two to seven times too long for these ropes: they break up at once.
SAFETY = 0.5


class Found(NamedTuple):
    """What PyElastica made of a scene."""

    times: np.ndarray  # (frames,) [s]
    places: np.ndarray  # (frames, nodes, 3) [m]; NaN where it broke up
    seconds: float  # of processor time, without building and compiling


def run(scene: rw.Scene) -> Found:
    """Run a rope of material, free at both ends, that touches planes or cylinders from the start."""
    _advance(scene, 1)  # compiles
    return _advance(scene, round(scene.run.duration / FRAME))


def _advance(scene: rw.Scene, frames: int) -> Found:
    import elastica as ea

    steps = math.ceil(FRAME / (SAFETY * _longest_step(scene.ropes[0])))
    simulator, rod = _simulator(scene)
    stepper, now, places = ea.PositionVerlet(), 0.0, [rod.position_collection.T.copy()]
    begun = time.process_time()
    for _ in range(frames):
        for _ in range(steps):
            now = stepper.step(simulator, now, FRAME / steps)
        places.append(rod.position_collection.T.copy())
    spent = time.process_time() - begun
    return Found(FRAME * np.arange(frames + 1), np.array(places), spent)


def _modulus_and_density(rope: Rope) -> tuple[float, float]:
    """Return E [N/m^2] and density [kg/m^3] of a solid round rod like the rope."""
    area = 0.25 * math.pi * rope.diameter**2
    return rope.made_of.EA / area, rope.own_mass / rope.length / area


def _longest_step(rope: Rope) -> float:
    """Return the time [s] of a stretch wave over an element, or of a shear wave over the radius."""
    modulus, density = _modulus_and_density(rope)
    shear = 27.0 / 28.0 * modulus / 3.0  # that of PyElastica, for Poisson's ratio 0.5
    stretching = rope.length / rope.segments * math.sqrt(density / modulus)
    return min(stretching, 0.5 * rope.diameter * math.sqrt(density / shear))


def _simulator(scene: rw.Scene) -> tuple[Any, Any]:
    """Return the scene in PyElastica, and its rod."""
    import elastica as ea

    class Simulator(ea.BaseSystemCollection, ea.Constraints, ea.Forcing, ea.Damping, ea.Contact):
        pass

    simulator = Simulator()
    rod = _rod(scene.ropes[0], np.array(rw.Simulation(scene).positions))
    simulator.append(rod)
    weight = np.array(scene.gravity, float)
    simulator.add_forcing_to(rod).using(ea.GravityForces, acc_gravity=weight)
    for body in scene.obstacles:
        (_on_plane if body.kind == "plane" else _on_cylinder)(simulator, rod, body)
    simulator.dampen(rod).using(ea.LaplaceDissipationFilter, filter_order=FILTER)
    simulator.finalize()
    return simulator, rod


def _rod(rope: Rope, nodes: np.ndarray) -> Any:
    """Return a rod, unstretched at nodes (n + 1, 3) [m] that lie in a plane."""
    import elastica as ea

    tangents = np.diff(nodes, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    across = np.linalg.svd(tangents)[2][-1]  # to that plane
    sides = np.tile(across, (rope.segments, 1))
    frames = np.stack([sides, np.cross(tangents, sides), tangents]).transpose(0, 2, 1)
    modulus, density = _modulus_and_density(rope)
    rod = ea.CosseratRod.straight_rod(
        rope.segments,
        start=nodes[0],
        direction=tangents[0],
        normal=across,
        base_length=rope.length,
        base_radius=0.5 * rope.diameter,
        density=density,
        youngs_modulus=modulus,
        position=nodes.T.copy(),
        directors=frames.copy(),
    )
    rod.bend_matrix[:2, :2] *= BENDS
    return rod


def _on_plane(simulator: Any, rod: Any, body: Any) -> None:
    import elastica as ea

    normal = np.array(body.normal, float)
    plane = ea.Plane(
        plane_origin=np.array(body.point, float), plane_normal=normal / np.linalg.norm(normal)
    )
    simulator.append(plane)
    simulator.detect_contact_between(rod, plane).using(
        ea.RodPlaneContactWithAnisotropicFriction,
        k=STIFFNESS,
        nu=DAMPING,
        slip_velocity_tol=HOLDS_BELOW,
        static_mu_array=np.full(3, body.friction),
        kinetic_mu_array=np.full(3, body.friction),
    )


def _on_cylinder(simulator: Any, rod: Any, body: Any) -> None:
    import elastica as ea

    start, end = np.array(body.start, float), np.array(body.end, float)
    length = float(np.linalg.norm(end - start))
    axis = (end - start) / length
    cylinder = ea.Cylinder(
        start=start,
        direction=axis,
        normal=np.linalg.svd(axis[None])[2][-1],
        base_length=length,
        base_radius=body.radius - _overlap(rod, start, axis, body.radius),
        density=1.0,  # it is held
    )
    simulator.append(cylinder)
    held = {"constrained_position_idx": (0,), "constrained_director_idx": (0,)}
    simulator.constrain(cylinder).using(ea.OneEndFixedBC, **held)
    simulator.detect_contact_between(rod, cylinder).using(
        ea.RodCylinderContact,
        k=STIFFNESS,
        nu=DAMPING,
        velocity_damping_coefficient=NO_SLIP,
        friction_coefficient=body.friction,
    )


def _overlap(rod: Any, start: np.ndarray, axis: np.ndarray, radius: float) -> float:
    """Return how deep [m] the middles of a rod's elements are in a cylinder, at most."""
    nodes = rod.position_collection.T
    middles = 0.5 * (nodes[1:] + nodes[:-1]) - start
    away = np.linalg.norm(middles - np.outer(middles @ axis, axis), axis=1)
    return max(0.0, radius + float(rod.radius[0] - away.min()))
