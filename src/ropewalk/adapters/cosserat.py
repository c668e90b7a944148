"""Ropewalk as a solver of cosseratbench, a benchmark of programs for slender rods (extra ``cosserat``).

Found by its entry point: ``cosseratbench run catenary --solver ropewalk``. What a scenario asks for that
Ropewalk has no model of (an end that turns, twist) is refused by name, as the benchmark
wants it. Ropewalk has no twist: the directors that it hands out are carried along without any.
"""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any, Final, Literal

import numpy as np
from cosseratbench.scenario import (
    Cylinder,
    End,
    EndCondition,
    Obstacle,
    Plane,
    Rod,
    Scenario,
    parallel_transport,
)
from cosseratbench.solver import Capability, Diverged
from cosseratbench.trajectory import Trajectory

import ropewalk as rw
from ropewalk import scene as of_scene

METHOD: Final = "esdirk3"
TOUCHING: Final = "implicit-euler"  # where ropes touch each other; such scenarios ask for rest
STEP = 1.0 / 60.0  # [s]
#: Steps in the slowest swing of a scenario whose motion is the result.
STEPS_PER_SWING = 400
OPEN = 1e-9  # [m] or [rad]: a motion smaller than this is none


class RopewalkSolver:
    """Runs scenarios of cosseratbench; `time_step_scale` multiplies the step that it would take."""

    name = "ropewalk"
    backend_version = version("ropewalk")
    capabilities = frozenset(
        {
            *(Capability.STRETCH, Capability.CYLINDER_CONTACT, Capability.PLANE_CONTACT),
            *(Capability.ROD_CONTACT, Capability.ROD_FRICTION),
        }
    )

    def __init__(self, time_step_scale: float = 1.0) -> None:
        self.time_step_scale = time_step_scale

    def settings(self, scenario: Scenario, *, n_elements: int, n_frames: int) -> dict[str, Any]:
        """Return the numerical choices of a run, as JSON values."""
        return {
            "integrator": _method(scenario),
            "time_step": self._step(scenario, n_frames),
            "damping_rate": _damping_rate(scenario),
            "contact_compliance": "automatic",
        }

    def run(self, scenario: Scenario, *, n_elements: int, n_frames: int) -> Trajectory:
        """Simulate a scenario, `n_elements` segments per rope, in `n_frames` frames from start to end."""
        made = self.scene(scenario, n_elements, n_frames)
        result = rw.simulate(made, on_failure="return")
        if result.status != "finished":
            raise Diverged(result.diagnosis, time=float(result.time[-1]))
        ropes = [result.rope(rope.name).positions for rope in made.ropes]
        directors = [
            np.stack([parallel_transport(nodes, np.asarray(rod.normal, float)) for nodes in places])
            for rod, places in zip(scenario.rods, ropes, strict=True)
        ]
        return Trajectory(
            np.linspace(0.0, scenario.duration, n_frames), tuple(ropes), tuple(directors)
        )

    def scene(self, scenario: Scenario, n_elements: int, n_frames: int) -> rw.Scene:
        """Return the scene of a scenario. Raises NotImplementedError for what Ropewalk has no model of."""
        drag = _damping_rate(scenario)
        ropes, anchors = [], []
        for number, rod in enumerate(scenario.rods):
            ropes.append(_rope(rod, f"rod{number}", n_elements))
            anchors += _anchors(rod, f"rod{number}", n_elements)
        masses = [
            rod.material.density * rod.area * rod.length / n_elements for rod in scenario.rods
        ]
        air = of_scene.Air(node_drag=drag * float(np.mean(masses))) if drag > 0.0 else None
        run = of_scene.RunSettings(
            method=_method(scenario),
            duration=scenario.duration,
            frame_rate=(n_frames - 1) / scenario.duration,
            time_step=self._step(scenario, n_frames),
        )
        return rw.Scene(
            ropes=ropes,
            anchors=anchors,
            obstacles=[_obstacle(one) for one in scenario.obstacles],
            contact=_contact(scenario),
            air=air,
            gravity=tuple(float(g) for g in scenario.gravity),
            run=run,
        )

    def _step(self, scenario: Scenario, n_frames: int) -> float:
        """Return the step [s]: a frame's length is a multiple of it."""
        frame, longest = scenario.duration / (n_frames - 1), STEP
        if not scenario.quasi_static:
            swing = 2.0 * math.pi / scenario.slowest_frequency()
            longest = min(longest, swing / STEPS_PER_SWING)
        return frame / math.ceil(frame / (self.time_step_scale * longest))


def _damping_rate(scenario: Scenario) -> float:
    """Return the drag per mass [1/s] that brings a scenario to rest where only rest is asked for."""
    return 2.0 * float(scenario.slowest_frequency()) if scenario.quasi_static else 0.0


def _rope(rod: Rod, name: str, n_elements: int) -> of_scene.Rope:
    material = rod.material
    made_of = rw.Material(
        EA=material.youngs_modulus * rod.area,
        EI=material.youngs_modulus * rod.second_moment_of_area,
        mass_per_length=material.density * rod.area,
    )
    places = [tuple(map(float, place)) for place in rod.nodes(n_elements)]
    ends = {End.START: 0, End.END: -1}
    return of_scene.Rope(
        name=name,
        segments=n_elements,
        length=rod.length,
        diameter=2.0 * rod.radius,
        friction=rod.friction,
        made_of=made_of,
        shape=of_scene.Points(points=places),
        forces=[of_scene.Force(node=ends[one.at], force=one.force) for one in rod.loads],
    )


def _anchors(rod: Rod, name: str, n_elements: int) -> list[of_scene.Anchor]:
    """Return what holds the ends of a rope."""
    nodes = rod.nodes(n_elements)
    found = []
    for end, node, ahead in (
        (End.START, 0, nodes[1] - nodes[0]),
        (End.END, -1, nodes[-1] - nodes[-2]),
    ):
        if rod.condition(end) is EndCondition.FREE:
            continue
        held: dict[str, Any] = {}
        if rod.condition(end) is EndCondition.CLAMPED:
            held["clamp"] = of_scene.Clamp(direction=tuple(map(float, ahead)))
        if (motion := rod.motion(end)) is not None:
            if motion.slides_along is not None or np.abs(motion.rotation).max() > OPEN:
                raise NotImplementedError("a clamped end that turns about the rod, or slides")
            places = nodes[node] + np.asarray(motion.displacement, float)
            held["motion"] = of_scene.Table(
                times=[float(time) for time in motion.times],
                positions=[tuple(map(float, place)) for place in places],
            )
        found.append(of_scene.Anchor(name=f"{name}-{end.value}", rope=name, node=node, **held))
    return found


def _contact(scenario: Scenario) -> rw.Contact | None:
    """Return how ropes touch each other; None where they cannot be meant to.

    A single rope off every plane hangs, swings or lies over a bar: it does not reach itself.
    """
    folds = scenario.self_contact and any(isinstance(one, Plane) for one in scenario.obstacles)
    if len(scenario.rods) == 1 and not folds:
        return None
    return rw.Contact(friction=0.0)  # each rod has its own, of which the larger holds


def _method(scenario: Scenario) -> Literal["esdirk3", "implicit-euler"]:
    return METHOD if _contact(scenario) is None else TOUCHING


def _obstacle(one: Obstacle) -> Any:
    if isinstance(one, Plane):
        return of_scene.Plane(point=one.point, normal=one.normal, friction=one.friction)
    if isinstance(one, Cylinder):
        half = 0.5 * one.length * one.unit_axis
        center = np.asarray(one.center, float)
        return of_scene.Cylinder(
            start=tuple(map(float, center - half)),
            end=tuple(map(float, center + half)),
            radius=one.radius,
            friction=one.friction,
        )
    raise NotImplementedError(f"obstacles of the kind {type(one).__name__}")
