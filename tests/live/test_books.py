"""The books of a session: they begin with it, go on over every edit, and have what edits store."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from property.test_islands_kept import on_floor
from ropewalk.cli.progress import energy_error
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.live.carry import carry_over
from ropewalk.live.edits import Edit, same_nodes
from ropewalk.live.pictures import picture
from ropewalk.live.recorded import Recorded
from ropewalk.live.session import Session
from ropewalk.live.track import Track
from ropewalk.methods.recording import work_names
from ropewalk.scene import (
    Anchor,
    Box,
    Material,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    Straight,
    Velocity,
)
from ropewalk.scene.spin import Spin
from ropewalk.simulation import Simulation
from ropewalk.simulation.block import join

MOTOR, STORED, METHOD = (ENTRIES.index(name) for name in ("motor", "stored", "method"))


def books(simulation: Simulation) -> np.ndarray:
    """Return the entries of all surfaces [J]."""
    return simulation.recording().recording.books[0].copy()


def over_a_box(segments: int = 6, method: str = "esdirk3") -> Scene:
    """A rope of 60 cm that falls on a square bar that turns freely, as none turns that is round."""
    rope = Rope(
        segments=segments,
        length=0.6,
        diameter=0.01,
        made_of=Material(EA=2000.0, mass_per_length=0.2, axial_damping=0.5),
        shape=Points(points=[(0.6 * i / segments - 0.25, 0.0, 0.06) for i in range(segments + 1)]),
    )
    spin = Spin(free=True, inertia=2e-3, rate=1.0, bearing=0.002)
    box = Box(
        center=(0, 0, 0), half_sizes=(0.05, 0.2, 0.05), edge_radius=0.02, friction=0.5, spin=spin
    )
    run = RunSettings(method=method, time_step=1e-3, frame_rate=200.0, duration=1.0)
    return Scene(ropes=[rope], obstacles=[box], run=run)


SCENES = {
    "a floor that goes aside": on_floor(Velocity(velocity=(0.1, 0.0, 0.02)), 1, friction=0.2),
    "ropes apart": on_floor(Velocity(velocity=(0.1, 0.0, 0.02)), 2, friction=0.2),
    "a box that turns": over_a_box(),
}


@pytest.mark.parametrize("name", list(SCENES))
def test_an_edit_that_changes_nothing_changes_no_entry(name: str) -> None:
    """All were 0, and what had pressed since was told from where bodies are drawn."""
    scene = SCENES[name]
    simulation, other = Simulation(scene), Simulation(scene)
    simulation.advance_frames(40)
    other.advance_frames(40)
    assert np.abs(books(other)).max() > 1e-4
    made = carry_over(simulation, scene, same_nodes(simulation.layout))
    assert books(made) == pytest.approx(books(other), rel=1e-9, abs=1e-15)
    made.advance_frames(3)
    other.advance_frames(3)
    assert books(made) == pytest.approx(books(other), rel=1e-6, abs=1e-9)


def test_with_other_nodes_works_go_on_and_add_up_to_the_ledgers() -> None:
    """Those of nodes that are there no more, too; the twin: with no books at all they do not."""
    simulation = Simulation(over_a_box(6))
    simulation.advance_frames(40)
    before = books(simulation)
    made = carry_over(simulation, over_a_box(9), np.linspace(0.0, 6.0, 10))
    after = books(made)
    assert after[:, METHOD] == pytest.approx(before[:, METHOD], abs=1e-15)
    put = before[:, STORED] - after[:, STORED]
    assert after[:, MOTOR] == pytest.approx(before[:, MOTOR] + put, abs=1e-12)
    made.advance_frames(20)
    names = work_names(made.layout.bends, made.layout.more)
    work = made.recording().recording.work[0, names.index("obstacle")]
    assert abs(work) > 0.01
    assert books(made).sum() == pytest.approx(work, rel=1e-9)


def heap(compliance: float) -> Scene:
    """A rope that lies on a floor that yields."""
    scene = on_floor(Velocity(velocity=(0.0, 0.0, 0.0)), 1, friction=0.2)
    return scene.replace(obstacles=[Plane(compliance=compliance)])


def test_what_a_stiffer_contact_stores_the_edit_has_put_in() -> None:
    """It threw the rope up, and lost went below nothing by what had been stored so: -4 mJ."""
    track = Track(heap(1e-2))
    track.advance(600)
    before = picture(track).scalars
    track.edit(Edit(heap(2e-3), same_nodes(track.simulation.layout)))
    after = picture(track).scalars
    assert after["put_in"] - before["put_in"] > 1e-3
    assert after["lost"] - before["lost"] == pytest.approx(after["put_in"] - before["put_in"])
    least = before["lost"]
    for _ in range(60):
        track.advance(5)
        least = min(least, picture(track).scalars["lost"])
    assert least >= before["lost"] - 1e-6


def test_a_view_of_a_simulation_that_has_run_begins_with_nothing_lost() -> None:
    """It told all that was lost before, and as much as the method's error."""
    simulation = Simulation(SCENES["a floor that goes aside"])
    simulation.advance_frames(5)  # the ropes slip still
    session = Session.of(simulation)
    first = picture(session.main).scalars
    names = ("lost", "put_in", "energy_error")
    assert [first[name] for name in names] == pytest.approx([0.0] * 3, abs=1e-15)
    session.advance(100)
    found = picture(session.main).scalars
    assert found["put_in"] > found["lost"] > 5e-5
    gained = sum(found[name] - first[name] for name in ("kinetic", "gravity", "elastic"))
    assert gained == pytest.approx(found["put_in"] - found["lost"] + found["energy_error"])
    assert abs(found["energy_error"]) < 0.02 * found["put_in"]


def boom(mass: float | None = 2.0) -> Scene:
    """A boom that swings down by its weight and errs, and a rope beside it at rest; without mass it stays."""
    spin = Spin(free=True, inertia=0.4, **({"mass": mass, "pivot": (0, 0, 0)} if mass else {}))
    body = Box(
        center=(0.3, 0, 0),
        half_sizes=(0.3, 0.02, 0.02),
        edge_radius=0.005,
        axis=(0, 1, 0),
        spin=spin,
    )
    hung = over_a_box().ropes[0].replace(shape=Straight(start=(3, 0, 0), direction=(0, 0, -1)))
    run = RunSettings(method="implicit-euler", time_step=1 / 60, duration=0.5)
    return Scene(ropes=[hung], anchors=[Anchor(node=0)], obstacles=[body], run=run)


@pytest.mark.parametrize("mass", [2.0, None])
def test_page_progress_and_table_tell_one_energy_error(mass: float | None) -> None:
    """The page and the bar left out what the boom erred by, all but a thousandth of it."""
    scene = boom(mass)
    result, track = rw.simulate(scene), Track(scene)
    error = result.energy_error[-1]
    assert (abs(error) > 0.1) == (mass is not None)
    track.advance(30)
    assert picture(track).scalars["energy_error"] == pytest.approx(error, rel=1e-9, abs=1e-12)
    told = Recorded(result).picture(result.frames - 1).scalars["energy_error"]
    assert told == pytest.approx(error, rel=1e-9, abs=1e-12)
    simulation = Simulation(scene)
    whole = join([simulation.recording(), *simulation.frames()])
    drift = energy_error(whole, scene) - energy_error(whole.head(1), scene)
    assert drift == pytest.approx(error, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("again", ["kept", "heavier", "gone"])
def test_an_edit_of_a_boom_is_no_error(again: str) -> None:
    """What it gives or takes of a body's motion, it has put in."""
    scenes = {"kept": boom(), "heavier": boom(3.0), "gone": boom().replace(obstacles=[])}
    track = Track(boom())
    track.advance(12)
    before = picture(track).scalars["energy_error"]
    assert abs(before) > 0.02
    track.edit(Edit(scenes[again], same_nodes(track.simulation.layout)))
    assert picture(track).scalars["energy_error"] == pytest.approx(before, rel=1e-9)
