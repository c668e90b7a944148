"""Bodies that turn freely as all else sees them: energies, starts, rests, edits, hands, old folders."""

from __future__ import annotations

import json
import math
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.closing import passing
from ropewalk.laws.contact import contact_energy
from ropewalk.laws.wheel_rows import ANGLE, LEAD, RATE, RECORDED
from ropewalk.live.carry import carry_over
from ropewalk.live.edits import same_nodes
from ropewalk.lowering import build
from ropewalk.lowering.chains import driven_speed
from ropewalk.record.seal import write_sealed
from ropewalk.record.store import SEAL, seal_of
from ropewalk.record.zarr_format import decode, encode, encode_texts, opened
from ropewalk.scene import (
    Anchor,
    Cylinder,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Spin,
    Straight,
)  # fmt: skip
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from verification.test_free_bodies import IMPLICIT, INERTIA, THICK, TOP, across, g, lever


def heavy(method: str, **more: Any) -> Scene:
    """An arm that falls on one side, and lifts a rope on the other."""
    spin = Spin(free=True, inertia=0.2, mass=5.0, center_of_mass=(-0.2, 0, 0))
    settings: dict[str, Any] = {"gravity": g, "height": TOP + 1e-4, "frame_rate": 120.0}
    return across(lever(spin, friction=0.6), method, 1 / 120, **(settings | more))


def alone(body: Any, method: str, step: float, **run: Any) -> Scene:
    """A body that a rope does not touch."""
    rope = Rope(
        segments=1, length=0.4, diameter=THICK, made_of=Material(EA=100.0, mass_per_length=1.0),
        shape=Straight(start=(5, 0, 0), direction=(0, 0, -1)),
    )  # fmt: skip
    settings: dict[str, Any] = {"duration": 0.5, "frame_rate": 60.0}
    settings |= {"method": method, "time_step": step} | run
    return Scene(
        ropes=[rope], anchors=[Anchor(node=0)], obstacles=[body], run=RunSettings(**settings)
    )


@pytest.mark.parametrize("method", ["sdirk2", "esdirk3", "bdf2"])
def test_the_energy_of_contacts_is_that_where_the_body_lies(method: str) -> None:
    """Between steps nothing of the last stage turns it ahead."""
    simulation = Simulation(heavy(method, duration=0.3))
    simulation.advance_steps(6)
    state, table = simulation.arrays, simulation.system.node.obstacle
    memory = state.memory.obstacle
    assert abs(memory.wheel[0, RATE]) > 0.1
    found = contact_energy(state.x, table, memory, state.now)
    memory.wheel[0, LEAD] = 0.0
    assert found == contact_energy(state.x, table, memory, state.now)


@pytest.mark.parametrize("method", ["esdirk3", "sdirk2", "implicit-euler"])
def test_the_first_step_has_all_of_the_weight(method: str) -> None:
    """w = T h / I, T = m g d; begun at rest it hangs straight down, and stays."""
    mass, off, inertia, step = 1.0, 0.1, 0.02, 1 / 240
    spin = Spin(free=True, inertia=inertia, mass=mass, center_of_mass=(off, 0, 0))
    simulation = Simulation(alone(lever(spin), method, step))
    simulation.advance_steps(1)
    rate = simulation.arrays.memory.obstacle.wheel[0, RATE]
    assert rate == pytest.approx(mass * g * off * step / inertia, rel=1e-3)
    still = Simulation(alone(lever(spin), method, step, start="at-rest"))
    still.advance_steps(1)
    assert still.arrays.memory.obstacle.wheel[0, RATE] == pytest.approx(0.0, abs=1e-9)
    assert still.arrays.memory.obstacle.wheel[0, ANGLE] == pytest.approx(0.5 * np.pi, abs=1e-6)


@pytest.mark.slow
def test_the_torque_at_rest_is_that_of_a_body_that_stands() -> None:
    """However fast it starts: contacts' dampers do not count."""
    found = []
    for rate in (0.0, -5.0):
        spin = Spin(free=True, inertia=INERTIA, bearing=0.2, rate=rate)
        scene = across(lever(spin, friction=0.6), *IMPLICIT, gravity=g, height=TOP, start="at-rest")
        (pulley,) = checked_shape(scene).pulleys
        found.append(pulley.torque)
    assert found[0] == pytest.approx(0.2 * g * 0.2, rel=1e-3)
    assert found[1] == pytest.approx(found[0], rel=1e-12)


def test_no_edit_stops_a_body() -> None:
    simulation = Simulation(heavy("implicit-euler", duration=0.3))
    simulation.advance_steps(6)
    before = simulation.arrays.memory.obstacle.wheel[0, [ANGLE, RATE]].copy()
    assert (np.abs(before) > 1e-3).all()
    scene = simulation.scene.replace(gravity=(0, 0, -9.0))
    made = carry_over(simulation, scene, same_nodes(simulation.layout))
    np.testing.assert_array_equal(made.arrays.memory.obstacle.wheel[0, [ANGLE, RATE]], before)
    made.advance_steps(1)
    assert made.arrays.memory.obstacle.wheel[0, ANGLE] == pytest.approx(
        before[0] + before[1] / 120, rel=0.3
    )


def test_how_fast_a_body_starts_counts_as_a_speed() -> None:
    """Its rate times its reach: 0.3, 0.15 and 0.02 m of a box, and its rounding."""
    turned = across(lever(Spin(rate=50.0)), "rk4", 1e-5, gravity=g)
    free = across(lever(Spin(free=True, inertia=INERTIA, rate=50.0)), "rk4", 1e-5, gravity=g)
    speeds = [driven_speed(build(scene).system) for scene in (turned, free)]
    assert speeds[0] == speeds[1] > 50.0 * 0.3
    with pytest.raises(SceneError, match="jump over nodes"):
        build(
            across(lever(Spin(free=True, inertia=INERTIA, rate=50.0)), "sdirk2", 1 / 120, gravity=g)
        )


def test_a_hand_does_not_move_what_has_a_mass() -> None:
    simulation = Simulation(heavy("implicit-euler"))
    body = simulation.obstacles["body"]
    with pytest.raises(ValueError, match="no hand can move it"):
        body.velocity = (0.0, 0.0, 0.01)
    with pytest.raises(ValueError, match="no hand can move it"):
        body.move_to((0.0, 0.0, 0.01), 1.0)


@pytest.mark.parametrize("free", [False, True])
def test_the_middle_of_a_boom_goes_about_its_pivot(free: bool) -> None:
    """A quarter of a turn in a second brings it from the side to below, or above."""
    more: dict[str, Any] = {"free": True, "inertia": 1.0} if free else {}
    spin = Spin(rate=0.5 * math.pi, axis=(0, 1, 0), pivot=(0, 0, 0), **more)
    boom = Cylinder(name="boom", start=(0, 0, 0), end=(1, 0, 0), radius=0.02, spin=spin)
    result = rw.simulate(alone(boom, "implicit-euler", 0.01, duration=1.0, frame_rate=1.0))
    places = result.obstacle_positions()
    np.testing.assert_allclose(places[0, 0], [0.5, 0, 0], atol=1e-12)
    np.testing.assert_allclose(places[-1, 0], [0, 0, -0.5], atol=1e-9)
    np.testing.assert_array_equal(result.obstacle_positions(slice(1, 2)), places[1:2])
    np.testing.assert_array_equal(result.dataset["obstacle_position"], places)


def made_old(folder: Path) -> Path:
    """Turn a run folder into one of format 8, of before pulleys had a column for the work of their weight."""
    facts = json.loads((folder / "provenance.json").read_text())
    facts.pop("checksum")
    write_sealed(folder / "provenance.json", facts | {"format": 8})
    data = folder / "data.zarr"
    root = json.loads((data / "zarr.json").read_text())
    root["attributes"]["ropewalk_format"] = 8
    arrays = root["consolidated_metadata"]["metadata"]
    about, names = arrays["pulleys"], arrays["motion"]
    names["shape"] = names["chunk_grid"]["configuration"]["chunk_shape"] = [6]
    (data / "motion" / "zarr.json").write_text(json.dumps(names))
    (data / "motion" / "c.0").write_bytes(encode_texts(list(RECORDED[:6])))
    about["shape"][2] = about["chunk_grid"]["configuration"]["chunk_shape"][2] = 6
    about["attributes"]["units"] = "rad, rad/s, J, J, J, N m"
    root["attributes"][SEAL] = seal_of(root)
    (data / "zarr.json").write_text(json.dumps(root))
    (data / "pulleys" / "zarr.json").write_text(json.dumps(about))
    rows = about["chunk_grid"]["configuration"]["chunk_shape"][0]
    for path in (data / "pulleys").glob("c.*"):
        values = decode(opened(path.read_bytes()), "float64", (rows, 1, 7))
        path.write_bytes(encode(values[..., :6]))
    return folder


def test_folders_from_before_bodies_had_a_weight_open(tmp_path: Path) -> None:
    spin = Spin(free=True, inertia=INERTIA, bearing=0.2)
    scene = across(lever(spin, friction=0.6), *IMPLICIT, gravity=g, height=TOP)
    new = rw.simulate(scene).save(tmp_path / "run")
    assert np.abs(new.pulley("body").rope_work).max() > 0.0
    shutil.copytree(tmp_path / "run", tmp_path / "old")
    old = rw.Result.open(made_old(tmp_path / "old"))
    for name, values in new.pulley("body")._asdict().items():
        np.testing.assert_array_equal(getattr(old.pulley("body"), name), values)
    assert (old.pulley("body").weight_work == 0.0).all()
    np.testing.assert_array_equal(old.read("pulleys", 2, 4), new.read("pulleys", 2, 4))
    assert old.to_pandas("pulleys").equals(new.to_pandas("pulleys"))
    assert old.dataset["pulleys"].shape[2] == 6
    with pytest.raises(rw.RunError, match="older format|finished"):
        rw.resume(tmp_path / "old")


@pytest.mark.parametrize("radius", [1.0, 0.1, 1e-5])
def test_the_slope_of_what_may_pass_is_that_of_differences(radius: float) -> None:
    """Away from a round edge, and from one as good as without a radius, where nothing changes."""
    for gap in (0.1, 0.3, 1.5):
        more, less = (passing(gap + s * 1e-7, 1.0 / (radius + gap + s * 1e-7)) for s in (1.0, -1.0))
        most, slope = passing(gap, 1.0 / (radius + gap))
        assert slope == pytest.approx((more[0] - less[0]) / 2e-7, rel=1e-4, abs=1e-3 * most)
