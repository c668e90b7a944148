"""Contacts of ropes with ropes, as recorded from their memory: tables, sums, modes, stores, figures."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk import plots
from ropewalk.live.keeper import Keeper, parts
from ropewalk.live.session import Session
from ropewalk.record.contact_modes import SLIPS, STICKS
from ropewalk.record.contacts import node_modes
from ropewalk.record.export import export
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import Scene, apply_overrides, loads
from ropewalk.simulation import Simulation
from ropewalk.simulation.rope_contacts import slots

g = 9.81
MASS = 0.02  # [kg] of the rope that lies on two others


def laid(friction: float = 0.3, aside: float = 0.0, duration: float = 0.5) -> Scene:
    """One segment laid across two ropes that are held; its ends are pulled aside by a force [N] each."""
    stuff = '{ kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 2.0 }'
    held = ""
    for name, y in (("left", -0.05), ("right", 0.05)):
        held += f"""
[[rope]]
name = "{name}"
segments = 5
length = 0.2
diameter = 0.01
made_of = {stuff}
shape = {{ kind = "straight", start = [-0.1, {y}, 0], end = [0.1, {y}, 0] }}
"""
        held += "".join(f'[[anchor]]\nrope = "{name}"\nnode = {i}\n' for i in range(6))
    return loads(f"""
[contact]
friction = {friction}
[run]
method = "implicit-euler"
time_step = 0.0041666667
duration = {duration}
{held}
[[rope]]
name = "over"
segments = 1
length = 0.2
diameter = 0.01
made_of = {stuff}
shape = {{ kind = "straight", start = [0.013, -0.1, 0.01], end = [0.013, 0.1, 0.01] }}
force = [{{ node = 0, force = [{aside}, 0, 0] }}, {{ node = -1, force = [{aside}, 0, 0] }}]
""")


def forces_of_ropes(result: rw.Result, frame: int) -> np.ndarray:
    """What ropes do to every node at a frame [N], (nodes, 3), summed from the recorded contacts."""
    found = np.zeros((result.layout.nodes, 3))
    kept = result.read("rope_contacts", frame, frame + 1)[0]
    kept = kept[np.isfinite(kept[:, 0])]
    for sign, side in ((1.0, 0), (-1.0, 1)):
        segment, at = kept[:, side].astype(np.int64), kept[:, 2 + side, None]
        np.add.at(found, segment, sign * (1.0 - at) * kept[:, 5:8])
        np.add.at(found, segment + 1, sign * at * kept[:, 5:8])
    return found


@pytest.fixture(scope="module")
def at_rest() -> rw.Result:
    return rw.simulate(laid(aside=0.02))


def test_what_ropes_bear_is_the_weight_and_friction_is_the_pull(at_rest: rw.Result) -> None:
    """From statics: two contacts, m g between them, and a pull below mu m g that friction balances."""
    table = at_rest.to_pandas("rope_contacts")
    last = table[table["time [s]"] == table["time [s]"].max()]
    assert set(last["other rope"]) == {"over"}
    assert set(last["rope"]) == {"left", "right"}
    assert last["normal force [N]"].sum() == pytest.approx(MASS * g, rel=1e-3)
    assert last["friction force [N]"].sum() == pytest.approx(0.04, rel=1e-2)
    used = 0.04 / (0.3 * MASS * g)
    assert last["friction used [1]"].mean() == pytest.approx(used, rel=2e-2)
    assert set(last["mode"]) == {"sticks"}
    assert (last["fz [N]"] < 0.0).all()  # on the first of both, which lies below
    assert last["z [m]"].to_numpy() == pytest.approx(0.005, abs=5e-4)
    assert sorted(last["y [m]"]) == pytest.approx([-0.05, 0.05], abs=1e-3)


def test_contacts_told_add_up_to_the_force_recorded(at_rest: rw.Result) -> None:
    """Places and forces against what the kernel summed over nodes by itself."""
    last = at_rest.frames - 1
    told, summed = forces_of_ropes(at_rest, last), at_rest.contact_force[last]
    assert np.abs(summed).max() > 0.02
    assert told == pytest.approx(summed, abs=1e-9)


def test_a_rope_pulled_harder_slips_with_all_that_friction_can() -> None:
    result = rw.simulate(laid(aside=0.05, duration=0.15))
    table = result.to_pandas("rope_contacts")
    last = table[table["time [s]"] == table["time [s]"].max()]
    assert set(last["mode"]) == {"slips"}
    rub, push = last["friction force [N]"].to_numpy(), last["normal force [N]"].to_numpy()
    assert rub == pytest.approx(0.3 * push, rel=1e-3)
    assert (last["slip speed [m/s]"] > 1e-2).all()
    lost = -last["friction force [N]"] * last["slip speed [m/s]"]
    assert last["friction power [W]"].to_numpy() == pytest.approx(lost.to_numpy(), rel=1e-2)
    assert (node_modes(result)[-1] == SLIPS).any()
    assert not (node_modes(result)[-1] == STICKS).any()


def test_frames_are_the_same_however_they_are_cut(at_rest: rw.Result) -> None:
    simulation = Simulation(at_rest.scene)
    blocks = [simulation.recording()]
    blocks += [simulation.advance_frames(count) for count in (1, 4, at_rest.frames - 6)]
    one = np.concatenate([block.pairs for block in blocks if block.pairs is not None])
    assert np.array_equal(one, at_rest.read("rope_contacts"), equal_nan=True)
    x = np.concatenate([block.recording.x for block in blocks]).transpose(0, 2, 1)
    assert np.array_equal(x, at_rest.positions)


def test_they_are_stored_and_opened_and_exported(at_rest: rw.Result, tmp_path: Path) -> None:
    opened = at_rest.save(tmp_path / "run")
    stored = opened.dataset["rope_contacts"]
    assert stored.dims == ("time", "pair", "column")
    assert stored.shape[1] == slots(at_rest.layout.segments)
    assert list(stored["column"].values[:2]) == ["first", "second"]
    before = at_rest.to_pandas("rope_contacts")
    assert opened.to_pandas("rope_contacts").equals(before)
    paths = {path.name: path for path in export(opened, "csv", tmp_path / "csv")}
    assert len(paths["rope_contacts.csv"].read_text().splitlines()) == 1 + len(before)
    rows = opened.datasets["rope_contacts"]
    assert rows["normal_force"].attrs["units"] == "N"
    assert rows["normal_force"].sum().item() == pytest.approx(before["normal force [N]"].sum())
    some = at_rest.to_pandas("rope_contacts", rope="left")
    assert set(some["rope"]) == {"left"}
    assert 0 < len(some) < len(before)


def test_a_run_in_a_folder_tells_the_same(tmp_path: Path) -> None:
    scene = laid(duration=0.2)
    memory = rw.simulate(scene)
    run = record_run(scene, tmp_path / "run")
    assert len(memory.to_pandas("rope_contacts")) > 0
    assert run.to_pandas("rope_contacts").equals(memory.to_pandas("rope_contacts"))


def test_a_resumed_run_has_the_same_contacts(at_rest: rw.Result, tmp_path: Path) -> None:
    def stop(done: int, planned: int, block: object) -> None:
        if done > 10:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        record_run(at_rest.scene, tmp_path / "run", progress=stop, commit_seconds=0.0)
    resumed = resume_run(tmp_path / "run")
    wanted = at_rest.read("rope_contacts")
    assert np.array_equal(resumed.read("rope_contacts"), wanted, equal_nan=True)


def test_a_kept_live_session_has_its_contacts(tmp_path: Path) -> None:
    session = Session(laid(duration=1.0))
    keeper = Keeper(session, tmp_path / "kept")
    session.advance(60)
    keeper.close()
    assert keeper.failure is None
    (part,) = parts(tmp_path / "kept")
    told = rw.Result.open(part).to_pandas("rope_contacts")
    assert told["normal force [N]"].max() > 0.05


def test_the_map_of_sticking_shows_what_the_table_says(at_rest: rw.Result) -> None:
    modes = node_modes(at_rest)
    table = at_rest.to_pandas("rope_contacts")
    frame = at_rest.frames - 1
    now = table[np.isclose(table["time [s]"], at_rest.time[frame])]
    wanted = set()
    for _, row in now.iterrows():
        for rope, segment in (("rope", "segment"), ("other rope", "other segment")):
            start = at_rest.layout.span(row[rope]).start + row[segment]
            wanted |= {start, start + 1}
    assert set(np.flatnonzero(modes[frame])) == wanted
    figure = plots.sticking(at_rest)
    image = np.asarray(figure.axes[2].images[0].get_array())
    span = at_rest.layout.span("over")
    assert np.array_equal(image.T, modes[:, span.start : span.end + 1])
    assert "sticks" in figure._supxlabel.get_text()


def test_no_ratio_at_slip_is_told_of_a_wrap_on_which_ropes_lie() -> None:
    """In a Munter hitch the rope is pressed on itself: 1.96 was told where 3.24 was held."""
    result = rw.simulate(apply_overrides(rw.preset("munter"), ["run.duration=0.4"]))
    table = result.to_pandas("wraps")
    pressed = table["normal force of ropes [N]"] > 0.01 * table["normal force [N]"]
    assert pressed.any()
    assert table["ratio at slip [1]"].isna().equals(pressed)
    assert table["ratio [1]"][pressed].max() > 1.0
    contacts = result.to_pandas("rope_contacts")
    time = table["time [s]"].iloc[-1]
    whole = contacts[contacts["time [s]"] == time]["normal force [N]"].sum()
    both = table[table["time [s]"] == time]["normal force of ropes [N]"].sum()
    assert 0.0 < both <= 2.0 * whole * (1.0 + 1e-9)  # on each of the two that press


def test_wraps_are_told_in_time() -> None:
    """Angle and tensions as `wrap` has them; with the coefficient the ratio at which it slips."""
    scene = apply_overrides(rw.preset("capstan"), ["run.duration=0.2"])
    result = rw.simulate(scene)
    table = result.to_pandas("wraps")
    wrap = result.wrap("drum")
    assert len(table) == result.frames
    assert table["angle [rad]"].to_numpy() == pytest.approx(wrap.angle)
    assert table["ratio [1]"].to_numpy() == pytest.approx(wrap.ratio)
    limit = math.exp(scene.obstacles[0].friction * wrap.angle[-1])
    slips = table["ratio at slip [1]"].iloc[-1]
    assert (
        0.93 * limit < slips < limit
    )  # where it leaves the drum it turns aside, which takes friction
