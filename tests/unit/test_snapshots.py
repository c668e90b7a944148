"""Snapshots are of one scene: of any other they are refused before anything has changed."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import flatten
from ropewalk.record import checkpoint
from ropewalk.record.checkpoint import Checkpoint
from ropewalk.record.errors import RunError
from ropewalk.scene import Anchor, Clamp, Contact, Ground, Material, Plane, Rope, Scene, Straight
from ropewalk.simulation import Snapshot
from ropewalk.simulation.snapshot import GROWN

CORD = Material(EA=2e3, mass_per_length=0.1, axial_damping=1.0)


def ropes(*segments: int, made_of: Material = CORD) -> list[Rope]:
    return [
        Rope(name=f"r{k}", segments=count, length=0.1 * count, made_of=made_of)
        for k, count in enumerate(segments)
    ]


def scene(*segments: int, made_of: Material = CORD, **more: object) -> Scene:
    run = {"duration": 0.1, "method": "semi-implicit-euler", "time_step": 1e-3}
    held = [Anchor(rope="r0", node=0)]
    return Scene(ropes=ropes(*segments, made_of=made_of), run=run, **{"anchors": held} | more)


OTHERS = {
    "two ropes of as many nodes": scene(2, 5),
    "in another order": scene(5, 2),
    "held elsewhere": scene(8, anchors=[Anchor(rope="r0", node=3)]),
    "stiff": scene(8, made_of=CORD.replace(EI=0.01)),
    "clamped": scene(
        8,
        made_of=CORD.replace(EI=0.01),
        anchors=[Anchor(rope="r0", node=0, clamp=Clamp(direction=(1, 0, 0)))],
    ),
    "on a plane": scene(8, obstacles=[Plane(friction=0.3)]),
    "by another method": scene(8).replace(run={"duration": 0.1, "method": "adaptive"}),
}


@pytest.mark.parametrize("name", OTHERS)
def test_one_of_another_scene_with_equal_counts_changes_nothing(name: str) -> None:
    """Half of the state was overwritten before numpy refused the rest, or nothing was refused at all."""
    simulation, other = rw.Simulation(scene(8)), rw.Simulation(OTHERS[name])
    assert other.layout.nodes == simulation.layout.nodes == 9
    other.advance_steps(3)
    simulation.advance_steps(2)
    before = flatten(simulation.state)
    with pytest.raises(ValueError, match=r"^snapshot: of another scene - must be of this simula"):
        simulation.restore(other.state)
    for key, part in flatten(simulation.state).items():
        np.testing.assert_array_equal(part, before[key], err_msg=key)


def test_one_of_the_same_ropes_in_other_surroundings_fits() -> None:
    """So it is with the names: what a law without a memory does is no part of a snapshot."""
    first = rw.Simulation(scene(8))
    first.advance_steps(3)
    windy = rw.Simulation(scene(8, ground=Ground(height=-5.0)))
    windy.restore(first.state)
    np.testing.assert_array_equal(windy.positions, first.positions)


def touching() -> Scene:
    """Two ropes side by side that press each other."""
    shapes = [Straight(start=(0, y, 0), end=(0.3, y, 0)) for y in (0.0, 0.0099)]
    lines = [rope.replace(shape=shape) for rope, shape in zip(ropes(3, 3), shapes, strict=True)]
    thick = [rope.replace(diameter=0.01) for rope in lines]
    run = {"duration": 0.1, "method": "implicit-euler", "time_step": 1e-3}
    return Scene(ropes=thick, contact=Contact(), gravity=(0, 0, 0), run=run)


#: Arrays of the state that had fewer numbers, and how many.
FEWER = {"past": 3, "pair": 2, "grip": 24, "tally": 9, "books": 3}


def as_it_was(name: str, part: np.ndarray) -> np.ndarray:
    """Return an array of the state as older versions have it: of contacts there were more rows."""
    part = part[..., : FEWER[name]]
    more = 256 - len(part) if name in ("pair", "grip") and part.size else 0
    return np.pad(part, [(0, more)] + [(0, 0)] * (part.ndim - 1))


@pytest.mark.parametrize(
    "made",
    [
        scene(8),
        scene(3, 4).replace(run={"duration": 0.1, "method": "implicit-euler", "time_step": 1e-3}),
        touching(),
    ],
    ids=["one rope", "islands", "touching"],
)
def test_one_that_an_older_version_pickled_opens(made: Scene) -> None:
    """It has no mark of its layout, so that counts and shapes tell alone, and less of the steps before."""
    simulation = rw.Simulation(made)
    simulation.advance_steps(3)
    now = simulation.state
    assert (now.inner.size > 0) is (len(made.ropes) > 1 and made.contact is None)
    memory = now.state.memory
    contact = memory.contact._replace(
        **{
            name: as_it_was(name, getattr(memory.contact, name))
            for name in ("pair", "grip", "tally", "books")
        }
    )
    assert (contact.grip.size > 0) is (made.contact is not None)
    past = now.state.past[: FEWER["past"]]
    fewer = now.state._replace(past=past, memory=memory._replace(contact=contact))
    old = pickle.loads(pickle.dumps(Snapshot(fewer, *now[1:-1])))
    assert old.layout == ""
    simulation.advance_steps(3)
    ahead = simulation.positions.copy()
    for snapshot in (old, pickle.loads(pickle.dumps(now))):
        simulation.restore(snapshot)
        simulation.advance_steps(3)
        np.testing.assert_array_equal(simulation.positions, ahead)


def test_a_checkpoint_of_an_older_version_opens(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has no mark either; its folder's scene has been compared by then. The twin: one that lacks more."""
    simulation = rw.Simulation(scene(8))
    simulation.advance_steps(3)
    for lacking, opens in (("layout", True), ("dt", False)):
        kept = {key: part for key, part in flatten(simulation.state).items() if key != lacking}
        with monkeypatch.context() as patch:
            patch.setattr(checkpoint, "flatten", lambda snapshot, kept=kept: kept)
            checkpoint.save(tmp_path, Checkpoint(simulation.state, 1, "hash", 0.0, ()))
        other = rw.Simulation(scene(8))
        if opens:
            other.restore(checkpoint.load(tmp_path, other.state).snapshot)
            np.testing.assert_array_equal(other.positions, simulation.positions)
        else:
            with pytest.raises(RunError, match="it lacks dt"):
                checkpoint.load(tmp_path, other.state)


def test_a_checkpoint_with_less_of_contacts_and_steps_opens(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    simulation = rw.Simulation(touching())
    simulation.advance_steps(3)
    kept = {
        key: as_it_was(key.rpartition(".")[2], part) if key in GROWN else part
        for key, part in flatten(simulation.state).items()
    }
    assert kept["state.memory.contact.grip"].shape == (256, 24)
    with monkeypatch.context() as patch:
        patch.setattr(checkpoint, "flatten", lambda snapshot: kept)
        checkpoint.save(tmp_path, Checkpoint(simulation.state, 1, "hash", 0.0, ()))
    other = rw.Simulation(touching())
    other.restore(checkpoint.load(tmp_path, other.state).snapshot)
    for one in (simulation, other):
        one.advance_steps(3)
    np.testing.assert_array_equal(other.positions, simulation.positions)


@pytest.mark.parametrize("contact", [Contact(friction=0.2), None], ids=["contact", "none"])
def test_the_same_hand_on_an_obstacle_is_felt_again_after_going_back(
    contact: Contact | None,
) -> None:
    """The forces at that moment were those of the obstacle at rest: it moved as when last looked at."""
    made = [
        Rope(
            name=f"r{k}",
            segments=4,
            length=1.0,
            diameter=0.01,
            made_of=Material(EA=50.0, mass_per_length=0.1, axial_damping=2.0),
            shape=Straight(start=(-0.5, 2.0 * k, 0.0052), end=(0.5, 2.0 * k, 0.0052)),
        )
        for k in range(2)
    ]
    run = {"method": "verlet", "duration": 0.5, "frame_rate": 60.0}
    floor = Plane(name="floor", friction=0.5)
    simulation = rw.Simulation(
        Scene(ropes=made, obstacles=[floor], contact=contact, run=run), apart=True
    )
    simulation.advance_frames(2)
    here, rest = simulation.state, simulation.arrays.acceleration.copy()
    found = []
    for _ in range(2):
        simulation.restore(here)
        simulation.obstacles["floor"].velocity = (3.0, 0.0, 0.0)
        found.append(simulation.arrays.acceleration.copy())
    assert np.array_equal(*found)
    assert np.abs(found[0] - rest).max() > 1.0  # the twin: friction takes the ropes along
