"""Obstacles and joints in the layout message, and the page's surfaces against the engine's."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from live.drive import do, refused
from ropewalk.laws.obstacle_places import surface_near
from ropewalk.live import describe
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.live.session import Session
from ropewalk.live.solids import obstacle_list
from ropewalk.record.obstacle_table import obstacle_places, obstacle_table
from ropewalk.scene import Scene, Sphere, loads
from ropewalk.scene.presets import preset
from ropewalk.simulation import Simulation

SHARED = Path(__file__).parents[2] / "page" / "test" / "solids.json"
ROPE = """
[run]
duration = 0.02
time_step = 0.01
method = "implicit-euler"
[[rope]]
segments = 4
length = 1.0
diameter = 0.02
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }
shape = { kind = "straight", start = [-0.5, 0, 3.0], end = [0.5, 0, 3.0] }
"""
ALL = """
[[obstacle]]
name = "slope"
kind = "plane"
point = [0, 0, -1.5]
normal = [0.2, 0.1, 1]
[[obstacle]]
kind = "sphere"
center = [0.1, 0.2, 0.3]
radius = 0.4
axis = [1, 0, 0]
spin = { rate = 2.0, start = 0.5 }
[[obstacle]]
kind = "cylinder"
from = [0, -0.3, 0.1]
to = [0.2, 0.3, 0]
radius = 0.2
[[obstacle]]
kind = "cylinder"
from = [0, 0, 0]
to = [0, 1, 0]
radius = 0.1
endless = true
spin = { rate = -1.0, stop = 4.0 }
[[obstacle]]
kind = "capsule"
from = [-0.5, 0, 0]
to = [0.5, 0.1, 0]
radius = 0.15
[[obstacle]]
kind = "box"
center = [0, 0.1, 0]
half_sizes = [0.5, 0.3, 0.2]
edge_radius = 0.05
[[obstacle]]
kind = "box"
center = [0.1, 0, -0.1]
half_sizes = [0.5, 0.2, 0.3]
edge_radius = 0.1
rotation = [0.4, -0.7, 1.1]
axis = [1, 0, 2]
spin = { rate = 1.5, start = 0.2 }
[[obstacle]]
kind = "torus"
center = [0, 0, 0.2]
axis = [1, 2, 0.5]
radius = 0.4
bar_radius = 0.1
[[obstacle]]
kind = "half-pipe"
from = [0, -1, -0.5]
to = [0.2, 1, -0.6]
radius = 3.2
open_to = [0.1, 0, 1]
spin = { times = [0.0, 2.0], angles = [0.0, -1.0] }
"""
LATER = 0.7  # [s]


def scene() -> Scene:
    return loads(ROPE + ALL)


def made() -> dict[str, Any]:
    """What the page's own test reads: obstacles, places, and how far each place is from each of them [m]."""
    here = scene()
    where = Simulation(here).layout
    table = obstacle_table(here, where)
    assert table is not None
    places = np.random.default_rng(4).uniform(-1.0, 1.0, (40, 3)).round(3)
    away, later = (
        [[surface_near(table, row, p, t)[0] for p in places] for row in range(len(table.kind))]
        for t in (0.0, LATER)
    )
    return {
        "obstacles": obstacle_list(here, where),
        "places": places.tolist(),
        "away": away,
        "time": LATER,
        "later": later,
        "ways": ways(),
    }


MOTIONS: list[dict[str, Any]] = [
    {"kind": "velocity", "velocity": (0.1, -0.2, 0.3), "start": 0.5, "stop": 1.5},
    {"kind": "velocity", "velocity": (0.1, -0.2, 0.3)},
    {"kind": "shake", "axis": (1, 2, 0), "amplitude": 0.2, "frequency": 0.7, "phase": 0.4},
    {"kind": "orbit", "center": (0.3, 0.0, 0.1), "axis": (0, 1, 1), "frequency": -0.3},
    {"kind": "table", "times": (0.5, 1, 2), "positions": ((0, 0, 0), (1, 0, 2), (3, 1, 0)),
     "interpolation": "cubic"},
]  # fmt: skip


def ways() -> list[dict[str, Any]]:
    """Motions as a layout has them, and where a ball that has them is at some times [s]."""
    found = []
    for motion in MOTIONS:
        ball = Sphere(center=(0.2, 0.1, -5.0), radius=0.1, motion=motion)
        here = scene().replace(obstacles=[ball])
        where = Simulation(here).layout
        (one,) = obstacle_list(here, where)
        times = np.array([0.0, 0.3, 0.5, 0.9, 1.4, 2.0, 3.0])
        places = obstacle_places(here, where, times, np.zeros((len(times), 1)))[:, 0]
        found.append({"motion": one["motion"], "center": one["center"],
                      "times": times.tolist(), "places": places.tolist()})  # fmt: skip
    return found


def assert_alike(known: Any, fresh: Any) -> None:
    """Machines differ in the last bits of square roots and sines that have been multiplied."""
    if isinstance(known, dict):
        assert known.keys() == fresh.keys()
        for key, value in known.items():
            assert_alike(value, fresh[key])
    elif isinstance(known, list):
        assert len(known) == len(fresh)
        for one, other in zip(known, fresh, strict=True):
            assert_alike(one, other)
    elif isinstance(known, float):
        assert known == pytest.approx(fresh, rel=1e-12, abs=1e-12)
    else:
        assert known == fresh


def test_the_pages_test_reads_what_the_engine_says() -> None:
    known = json.loads(SHARED.read_text())
    fresh = json.loads(json.dumps(made()))
    assert_alike(known["obstacles"], fresh["obstacles"])
    assert_alike(known["places"], fresh["places"])
    for when in ("away", "later"):
        assert np.array(known[when]) == pytest.approx(np.array(fresh[when]), abs=1e-12)
    moved = np.abs(np.array(fresh["later"]) - fresh["away"]).max(axis=1) > 0.01
    turned = [one["name"] for one, by in zip(fresh["obstacles"], moved, strict=True) if by]
    assert turned == [
        "obstacle6",
        "obstacle8",
    ]  # the box and the half-pipe; the round ones are where they were
    for old, new in zip(known["ways"], fresh["ways"], strict=True):
        assert {key: old[key] for key in ("center", "times")} == {
            key: new[key] for key in ("center", "times")
        }
        assert old["motion"]["kind"] == new["motion"]["kind"]
        assert np.array(old["places"]) == pytest.approx(np.array(new["places"]), abs=1e-12)


def test_a_layout_has_the_obstacles_and_joints_of_its_scene() -> None:
    sent = describe.layout(Session(scene()))
    names = [(one["name"], one["kind"]) for one in sent["obstacles"]]
    assert names[:2] == [("slope", "plane"), ("obstacle1", "sphere")]
    assert sent["obstacles"][1]["spin"] == [2.0, 0.5, None]
    assert sent["obstacles"][3]["size"] == [0.1, None, 0.0, 0.0]  # endless
    json.dumps(sent, allow_nan=False)
    replayed = ReplayBroadcast(rw.simulate(scene())).layout(0)
    assert replayed["obstacles"] == sent["obstacles"]
    # The twin: scenes without any have none.
    assert describe.layout(Session(preset("r4")))["obstacles"] == []


def test_a_joint_tells_its_nodes_in_the_arrays() -> None:
    session = Session(preset("three-leg-sling"))
    (variant,) = describe.layout(session)["variants"]
    places = session.main.simulation.positions
    assert [one["name"] for one in variant["joints"]] == ["ring"]
    nodes = variant["joints"][0]["nodes"]
    assert len(nodes) == 4
    assert np.ptp(places[nodes], axis=0).max() < 1e-9


def test_a_joint_is_cut_without_a_jump_and_tied_again_by_undo() -> None:
    session, twin = Session(preset("three-leg-sling")), Session(preset("three-leg-sling"))
    for one in (session, twin):
        one.advance(100)
    nodes = describe.layout(session)["variants"][0]["joints"][0]["nodes"]
    before = [session.main.simulation.positions.copy(), session.main.simulation.velocities.copy()]
    do(session, "untie", joint="ring")
    after = [session.main.simulation.positions, session.main.simulation.velocities]
    assert np.array_equal(before, after)
    assert describe.layout(session)["variants"][0]["joints"] == []
    session.advance(100)
    assert np.ptp(session.main.simulation.positions[nodes], axis=0).max() > 0.01
    assert session.undo.word == "the cut of a joint"
    do(session, "undo")
    for one in (session, twin):
        one.advance(100)
    assert np.array_equal(session.main.simulation.positions, twin.main.simulation.positions)
    assert np.ptp(session.main.simulation.positions[nodes], axis=0).max() < 1e-9
    assert "no such joint; there is ring" in refused(session, "untie", joint="bow")


def test_a_mesh_is_told_with_its_triangles() -> None:
    """About the origin of its frame, turned and scaled; its size is its rounding."""
    own = """
[[obstacle]]
kind = "mesh"
vertices = [[1000, 0, 0], [-1000, 1000, 0], [-1000, -1000, 0], [0, 0, 1000]]
faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
scale = "1 mm"
rotation = [0, 0, 1.5707963267948966]
position = [0, 0, -5]
rounding = 0.1
"""
    here = loads(ROPE + own)
    (told,) = obstacle_list(here, Simulation(here).layout)
    assert told["center"] == [0.0, 0.0, -5.0]
    assert told["size"] == [0.1]
    assert told["vertices"] == pytest.approx([0, 1, 0, -1, -1, 0, 1, -1, 0, 0, 0, 1])
    assert told["faces"] == [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]
