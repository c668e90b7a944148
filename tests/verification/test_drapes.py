"""Limp ropes that come down on several bodies at once are solved for in few solutions of their equations."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.band import make_band
from ropewalk.laws.contact_tangent import contact_tangent
from ropewalk.methods.stage_report import SOLVES
from ropewalk.scene import Cylinder, Material, Plane, Rope, RunSettings, Scene, Sphere, Straight

STEP = 1.0 / 60.0  # [s]
MOST = {"implicit-euler": 2000, "sdirk2": 3500, "esdirk3": 3500}  # 4900 to 6200 then


def drape(method: str, bending: float = 0.0) -> Scene:
    """Return 60 segments of 20 mm that fall by 0.15 m on a bar, two balls and a floor."""
    rope = Rope(
        segments=60,
        length=1.2,
        diameter=0.01,
        made_of=Material(EA=1e4, EI=bending, mass_per_length=0.1, axial_damping=1.0),
        shape=Straight(start=(-0.6, 0.0, 0.15), direction=(1.0, 0.0, 0.0)),
    )
    bodies = [
        Cylinder(start=(0, -1, 0), end=(0, 1, 0), radius=0.05, friction=0.3),
        Sphere(center=(-0.4, 0.0, -0.2), radius=0.1, friction=0.3),
        Sphere(center=(0.4, 0.02, -0.2), radius=0.12, friction=0.3),
        Plane(point=(0, 0, -0.5), friction=0.3),
    ]
    run = RunSettings(method=method, time_step=STEP, duration=1.0)
    return Scene(ropes=[rope], obstacles=bodies, run=run)


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "esdirk3"])
def test_a_rope_that_drapes_takes_few_solutions(method: str) -> None:
    """Fewer by half at least than with a search on residuals, each step of which began whole."""
    simulation, most = rw.Simulation(drape(method)), MOST[method]
    report = simulation._engine._scratch.stage.report
    state = simulation._state

    def energy() -> float:
        moving = 0.5 * float((state.mass * (state.v**2).sum(axis=0)).sum())
        return moving + 9.81 * float((state.mass * state.x[2]).sum())

    begun = last = energy()
    for _ in range(60):
        simulation.step(STEP)
        last = max(last, energy())
    assert last <= begun + 1e-9
    assert report[SOLVES] < most


def test_a_contact_deep_in_a_ball_is_held_definite() -> None:
    """What is round turns its push as a node slides: far from the solution that outweighs its inertia."""
    simulation = rw.Simulation(drape("implicit-euler"))
    system, state = simulation.system, simulation._state
    obstacles, memory = system.node.obstacle, state.memory.obstacle
    x = state.x.copy()
    x[:, 20] = (-0.4, 0.0, -0.2 + 0.08)  # 25 mm deep, half the diameter counted in
    least = []
    for definite in (0, 1):
        band = make_band(x.shape[1])
        band.definite[0] = definite
        contact_tangent(x, np.zeros_like(x), obstacles, memory, np.zeros(2), 1.0, 60.0, band)
        block = band.diagonal[20].reshape(3, 3)
        least.append(float(np.linalg.eigvalsh(0.5 * (block + block.T)).min()))
    inertia = state.mass[20] / STEP**2
    assert least[0] < -100.0 * inertia
    assert least[1] > -1e-9 * inertia
