"""Tension is all that a segment carries: spring, friction along it, bound, or a rigid link's multiplier."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import plots
from ropewalk.analysis.compare import compare_runs
from ropewalk.record.errors import RunError
from ropewalk.record.quantities import QUANTITIES
from ropewalk.scene import (
    Anchor,
    Hanging,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Springs,
    Straight,
    Winch,
)
from ropewalk.simulation import Simulation

MU, EA, DAMPING, g = 0.07, 2e4, 2000.0, 9.81


def fall(method: str, time_step: float, **more: object) -> Scene:
    """80 kg at 3 m/s on 2 m of rope that has just gone taut, and damps a lot."""
    stuff = {"EA": EA, "mass_per_length": MU, "axial_damping": DAMPING} | more
    rope = Rope(
        segments=4,
        length=2.0,
        made_of=Material(**stuff),
        shape=Straight(start=(0, 0, 0), end=(0, 0, -2.0), velocity=(0, 0, -3.0)),
        loads=[Load(node=-1, mass=80.0)],
    )
    settings = RunSettings(duration=0.05, frame_rate=200.0, method=method, time_step=time_step)
    return Scene(ropes=[rope], anchors=[Anchor(name="bolt", node=0)], run=settings)


@pytest.mark.parametrize(
    ("method", "time_step"), [("semi-implicit-euler", 2e-6), ("sdirk2", 5e-4), ("bdf2", 5e-4)]
)
def test_a_damped_fall_says_what_the_bolt_carries(method: str, time_step: float) -> None:
    """In the beginning the damper holds all: the spring's share is 5 % of what is at the bolt."""
    result = rw.simulate(fall(method, time_step))
    weight = MU * 0.25 * g  # of the bolt's half segment
    bolt = np.linalg.norm(result.reactions[2:, 0], axis=1)
    np.testing.assert_allclose(result.tension[2:, 0], bolt, rtol=2e-3, atol=weight)
    assert result.elastic_tension[2, 0] < 0.15 * bolt[0]
    assert bolt[0] > 2500.0
    at_start = result.elastic_tension[0] + DAMPING / 0.5 * np.r_[3.0, np.zeros(3)]
    np.testing.assert_allclose(result.tension[0], at_start, atol=1e-6)  # frame 0, too
    assert result.table["largest tension [N]"] >= result.tension.max() * (1 - 1e-12)


@pytest.mark.parametrize("friction", ["vector", "axial"])
def test_only_the_part_along_the_segment_counts(friction: str) -> None:
    """Elastic tension plus c (v2 - v1) . t of every live segment; slack one-way ones carry nothing."""
    stuff = Springs(
        spring_constant=50.0, node_mass=0.1, segment_length=0.3, spring_friction=0.4,
        friction=friction, tension_only=True,
    )  # fmt: skip
    rope = Rope(segments=6, made_of=stuff, shape=Straight(start=(0, 0, 0), end=(1.5, 0, 0)))
    settings = RunSettings(duration=0.6, time_step=0.001, method="semi-implicit-euler")
    result = rw.simulate(Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings))
    along, apart = np.diff(result.positions, axis=1), np.diff(result.velocities, axis=1)
    length = np.linalg.norm(along, axis=2)
    rubbing = 0.4 * (along * apart).sum(axis=2) / length
    taut = length >= 0.3
    assert taut.any()
    assert not taut.all()
    assert np.abs(rubbing[taut]).max() > 0.1
    expected = np.where(taut, 50.0 * (length - 0.3) + rubbing, 0.0)
    np.testing.assert_allclose(result.tension, expected, atol=1e-9)
    np.testing.assert_allclose(
        result.elastic_tension, np.maximum(50.0 * (length - 0.3), 0.0), atol=1e-9
    )


@pytest.mark.parametrize("method", ["semi-implicit-euler", "implicit-euler"])
def test_the_bound_of_the_stretch_carries_the_rest_of_the_weight(method: str) -> None:
    """A rope far too soft for its load hangs on its limiter: the tension is the weight below."""
    soft = Material(EA=1.0, mass_per_length=0.1, axial_damping=0.01)
    scene = Scene(
        ropes=[Rope(segments=6, length=6.0, made_of=soft, shape=Hanging())],
        anchors=[Anchor(node=0)],
        limiter=Limiter(min_stretch=0.9, max_stretch=1.1),
        run=RunSettings(duration=20.0, time_step=0.005, method=method),
    )
    simulation = Simulation(scene)
    simulation.step(20.0)
    out = simulation.recording().recording
    below = 0.1 * g * (5.5 - np.arange(6))
    np.testing.assert_allclose(out.tension[0], below, rtol=1e-3)
    assert out.elastic_tension[0].max() < 0.11
    kept = simulation.state
    simulation.step(1.0)
    simulation.restore(kept)
    np.testing.assert_array_equal(simulation.recording().recording.tension, out.tension)


def test_a_rigid_link_carries_what_was_solved_for() -> None:
    stiff = Material(EA=np.inf, mass_per_length=0.1)
    rope = Rope(segments=4, length=2.0, made_of=stiff, shape=Hanging())
    settings = RunSettings(duration=0.1, method="esdirk3", time_step=0.01)
    result = rw.simulate(Scene(ropes=[rope], anchors=[Anchor(node=0)], run=settings))
    below = 0.1 * 0.5 * g * (3.5 - np.arange(4))
    np.testing.assert_allclose(result.tension[-1], below, rtol=1e-6)
    np.testing.assert_array_equal(result.tension, result.elastic_tension)


def test_rope_that_is_paid_out_meets_no_friction() -> None:
    """The working segment grows at the drum's speed: its ends part, but nothing is strained."""
    stuff = Material(EA=5e3, mass_per_length=0.1, axial_damping=30.0)
    rope = Rope(
        segments=8, length=2.0, made_of=stuff, shape=Hanging(), loads=[Load(node=-1, mass=1)]
    )
    settings = RunSettings(
        duration=1.0, frame_rate=50.0, time_step=2e-5, method="semi-implicit-euler"
    )
    scene = Scene(
        ropes=[rope],
        anchors=[Anchor(node=0)],
        winches=[Winch(end="start", speed=0.2, start=0.3)],
        run=settings,
    )
    simulation = Simulation(scene)
    for _ in range(50):
        simulation.step()
        (winch,) = simulation.winches.values()
        bolt = np.linalg.norm(simulation.arrays.reaction[0])
        assert winch.tension == pytest.approx(bolt, abs=0.6)  # the drum's half segment weighs that
    out = simulation.recording().recording
    j = int(simulation.arrays.winch_exit[0])
    assert out.tension[0, j] == winch.tension


BETWEEN = [q.name for q in QUANTITIES if "since the frame before" in q.long_name]


def made_old(folder: Path) -> Path:
    """Turn a run folder into one of format 2: its tension is the elastic one, and there is no other.

    Nor are there checksums, or a hash of the scene.
    """
    data = folder / "data.zarr"
    for path in (folder / "provenance.json", data / "zarr.json"):
        found = json.loads(path.read_text())
        if "format" in found:
            found["format"] = 2
            found.pop("scene_hash")
            found.pop("checksum")
        else:
            found["attributes"]["ropewalk_format"] = 2
            arrays = found["consolidated_metadata"]["metadata"]
            old = arrays.pop("elastic_tension")
            for name in (*BETWEEN, "extreme"):
                arrays.pop(name, None)
                shutil.rmtree(data / name, ignore_errors=True)
            arrays["tension"] = old
            for about in arrays.values():
                about["codecs"].remove({"name": "crc32c"})
            (data / "tension" / "zarr.json").write_text(json.dumps(old))
        path.write_text(json.dumps(found))
    for path in data.glob("*/c.*"):
        path.write_bytes(path.read_bytes()[:-4])
    for path in (data / "elastic_tension").glob("c.*"):
        path.replace(data / "tension" / path.name)
    return folder


def test_old_run_folders_open_and_say_that_their_tension_is_elastic(tmp_path: Path) -> None:
    new = rw.simulate(fall("semi-implicit-euler", 2e-6)).save(tmp_path / "new")
    rw.simulate(fall("semi-implicit-euler", 2e-6)).save(tmp_path / "old")
    old = rw.Result.open(made_old(tmp_path / "old"))
    np.testing.assert_array_equal(old.tension, new.elastic_tension)
    np.testing.assert_array_equal(old.elastic_tension, new.elastic_tension)
    assert (new.tension_name, old.tension_name) == ("tension", "elastic tension")
    assert old.table["largest elastic tension [N]"] == new.elastic_tension.max()
    assert "largest tension [N]" not in old.table
    assert old.table["largest elastic tension at"].endswith("of the recorded frames")
    (label,) = {a.get_ylabel() for a in plots.tension(old).axes if "[N]" in a.get_ylabel()}
    assert label == "elastic tension [N]"
    assert old.dataset.tension.attrs["long_name"] == "elastic tension"
    assert new.dataset.tension.attrs["long_name"] == "tension"
    old.export("csv", tmp_path / "t.csv", quantities=("tension",))
    assert (tmp_path / "t.csv").read_text().splitlines()[0].endswith(",elastic tension [N]")
    old.export("npz", tmp_path / "t.npz", quantities=("tension",))
    assert "elastic_tension" in np.load(tmp_path / "t.npz").files
    rows, name = compare_runs([new, old]).rows, "largest elastic tension of the recorded frames [N]"
    assert rows[0][name] == rows[1][name]
    with pytest.raises(RunError, match="older format"):
        old.save(tmp_path / "again")


def test_a_run_without_all_that_is_recorded_today_is_not_saved_and_says_so(tmp_path: Path) -> None:
    """A run of format 6, without the work of contacts: KeyError."""
    made = rw.simulate(fall("semi-implicit-euler", 2e-6))
    names = [name for name in made.source.names if name != "momentum"]
    old = rw.Result(
        made.scene, made.layout, SimpleNamespace(names=names, read=made.source.read), made.facts
    )
    with pytest.raises(RunError, match="older format, without momentum; copy its folder"):
        old.save(tmp_path / "again")
    assert not (tmp_path / "again").exists()
