"""Greatest and least of every step: no recording rate hides a peak."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.peaks import EXTREMES
from ropewalk.methods.recording import Recording
from ropewalk.record.errors import RunError
from ropewalk.record.export import export
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import Anchor, Load, Material, Rope, RunSettings, Scene, Springs, Straight
from ropewalk.simulation import Simulation

DT, EVERY, FRAMES = 0.002, 75, 2  # frames longer than two searches over the rope


def swinging(method: str, every: int, friction: float, form: str, **more: object) -> Scene:
    """A rope thrown into its anchor, which stretches, swings and turns."""
    stuff = Springs(
        spring_constant=200.0,
        node_mass=0.1,
        segment_length=0.3,
        spring_friction=friction,
        friction=form,
        tension_only=bool(more.pop("one_way", False)),
    )
    shape = Straight(start=(0, 0, 0), end=(1.5, 0, 1.2), velocity=(0.3, 0, -1))
    settings = RunSettings(
        duration=EVERY * FRAMES * DT,
        frame_rate=1.0 / (every * DT),
        time_step=DT,
        steps="exact",
        method=method,
    )
    rope = Rope(segments=6, made_of=stuff, shape=shape)
    motion = {"motion": more.pop("motion")} if "motion" in more else {}
    anchors = [Anchor(node=0, **motion)]
    return Scene(ropes=[rope], anchors=anchors, run=settings, **more)


def steps_of(simulation: Simulation, frames: int) -> Recording:
    """Every step as a frame, the first state included."""
    parts = [simulation.recording().recording, simulation.advance_frames(frames).recording]
    return Recording(*(np.concatenate(pair) for pair in zip(*parts, strict=True)))


SHAKEN = {"kind": "shake", "axis": (1.0, 0.0, 0.5), "amplitude": 0.1, "frequency": 3.0}
STARTS = {"kind": "velocity", "velocity": (0.4, 0.0, 0.2), "start": 0.0371, "stop": 0.1117}
EULER = "semi-implicit-euler"
CASES = [
    (EULER, False, 0.0, "vector", {}),
    (EULER, False, 0.5, "vector", {"motion": SHAKEN}),
    (EULER, False, 0.5, "axial", {"gravity": (0.0, -9.81, 0.0)}),
    (EULER, False, 0.5, "axial", {"gravity": (0.0, -8.0, -4.0)}),
    (EULER, False, 0.5, "vector", {"one_way": True}),
    (EULER, False, 0.5, "vector", {"limiter": {"min_stretch": 0.9, "max_stretch": 1.02}}),
    (EULER, True, 0.5, "vector", {}),
    ("verlet", False, 0.0, "vector", {"one_way": True}),
    ("rk4", True, 0.5, "axial", {"motion": STARTS}),
    ("esdirk3", True, 0.5, "axial", {"motion": STARTS}),
]


@pytest.mark.parametrize(("method", "ledger", "friction", "form", "more"), CASES)
def test_an_interval_has_the_extremes_of_all_its_steps(
    method: str, ledger: bool, friction: float, form: str, more: dict[str, object]
) -> None:
    """Every step recorded as a frame, and every 75th: what the ones say is what the other kept."""
    fine = Simulation(swinging(method, 1, friction, form, **dict(more)), ledger=ledger)
    own = steps_of(fine, EVERY * FRAMES)
    up, time = np.asarray(fine.scene.up), DT * np.arange(EVERY * FRAMES + 1)
    stretch = np.linalg.norm(np.diff(own.x, axis=2), axis=1) / 0.3
    speed, height = np.linalg.norm(own.v, axis=1), np.einsum("fkn,k->fn", own.x, up)
    force = np.linalg.norm(own.reaction, axis=2)
    coarse = Simulation(swinging(method, EVERY, friction, form, **dict(more)), ledger=ledger)
    out = coarse.advance_frames(FRAMES).recording
    np.testing.assert_array_equal(out.x[-1], own.x[-1])
    missed = 0
    for k in range(FRAMES):
        steps = slice(EVERY * k, EVERY * (k + 1) + 1)
        close = {"rtol": 1e-12, "atol": 1e-12}
        for kept, values in (
            (out.tension_high, own.tension),
            (out.stretch_high, stretch),
            (out.speed_high, speed),
            (out.highest, height),
            (out.reaction_high, force),
        ):
            np.testing.assert_allclose(kept[k], values[steps].max(axis=0), **close)
        np.testing.assert_allclose(out.tension_low[k], own.tension[steps].min(axis=0), **close)
        np.testing.assert_allclose(out.lowest[k], height[steps].min(axis=0), **close)
        series = (own.tension, own.tension, stretch, speed, height, height, force)
        for q, values in enumerate(series):
            least = EXTREMES[q].startswith(("least", "lowest"))
            sign = -1.0 if least else 1.0
            best = sign * (sign * values[steps]).max()
            assert out.extremes[k, q] == pytest.approx(best, rel=1e-12, abs=1e-12), EXTREMES[q]
            since, until = out.extreme_since[k, q], out.extreme_until[k, q]
            here = sign * values[steps, int(out.extreme_places[k, q])] >= sign * best - 1e-11
            when = time[steps][here]
            assert ((when >= since - 1e-9) & (when <= until + 1e-9)).any(), EXTREMES[q]
            assert until - since <= 32.01 * DT
            missed += bool(not here[0] and not here[-1])
    assert missed > 2  # the twin: frames alone would not do


def test_extremes_of_an_adaptive_method_are_those_of_its_steps() -> None:
    """Frames do not change the walk, so that what many frames say together is what few say."""
    scene = swinging("adaptive", 5, 0.5, "axial", motion=STARTS)
    many = Simulation(scene).advance_frames(30).recording
    few = Simulation(scene.replace(run=scene.run.replace(frame_rate=20.0))).advance_frames(6)
    kept = few.recording
    for k in range(6):
        own = slice(5 * k, 5 * k + 5)
        assert (kept.tension_high[k] >= kept.tension[k]).all()
        # frames inside a step are steps of their own, which only the one that records them sees
        np.testing.assert_allclose(
            kept.tension_high[k], many.tension_high[own].max(axis=0), rtol=0.02, atol=0.02
        )
        np.testing.assert_allclose(kept.lowest[k], many.lowest[own].min(axis=0), atol=1e-3)


def test_extremes_go_on_to_the_same_bits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run stopped in the middle and resumed has the very extremes of one that was not."""
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 2)
    scene = swinging(EULER, 10, 0.5, "vector")
    whole = record_run(scene, tmp_path / "whole")

    def stop(done: int, planned: int, block: object) -> None:
        if done >= whole.frames // 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        record_run(scene, tmp_path / "cut", progress=stop, commit_seconds=0.0)
    cut = resume_run(tmp_path / "cut")
    assert cut.frames == whole.frames
    names = [name for name in whole.source.names if name.startswith(("great", "least", "extreme"))]
    assert len(names) == 11
    for name in ("energy_errors", "energy_error_times"):
        np.testing.assert_array_equal(cut.read(name), whole.read(name))
    for name in names:
        np.testing.assert_array_equal(cut.read(name), whole.read(name))


def caught(rate: float) -> Scene:
    """10 kg at 3 m/s caught by 2 m of 12 mm steel wire."""
    wire = Material(EA=9.05e6, mass_per_length=0.62)
    rope = Rope(
        segments=10,
        length=2.0,
        made_of=wire,
        shape=Straight(start=(0, 0, 0), end=(0, 0, -2.0), velocity=(0, 0, -3.0)),
        loads=[Load(node=-1, mass=10.0)],
    )
    settings = RunSettings(duration=0.05, frame_rate=rate, time_step=2e-6, method=EULER)
    return Scene(
        ropes=[rope], anchors=[Anchor(name="bolt", node=0)], run=settings.replace(steps="exact")
    )


def test_the_force_of_a_catch_does_not_depend_on_the_frame_rate(tmp_path: Path) -> None:
    """It lasts some milliseconds, of which frames of 60 Hz see nothing. About v sqrt(k m), and its waves."""
    seldom, often = rw.simulate(caught(60.0)), rw.simulate(caught(1000.0))
    most = seldom.table["largest tension [N]"]
    assert most == pytest.approx(often.table["largest tension [N]"], rel=1e-12)
    assert most > 3.0 * np.sqrt(9.05e6 / 2.0 * 10.0)
    assert seldom.tension.max() < 0.95 * most  # the twin: what the frames say
    assert seldom.table["largest anchor force [N]"] == pytest.approx(most, rel=0.05)
    assert seldom.table["largest speed [m/s]"] >= 3.0
    assert "recorded frames" not in str(seldom.table)
    where = seldom.table["largest tension at"]
    first, last = (float(word) for word in where.split(" t from ")[1][:-2].split(" to "))
    assert last - first < 33 * 2e-6
    moment = float(often.time[int(np.argmax(often.greatest_tension.max(axis=1)))])
    assert moment - 1e-3 - 1e-9 <= last <= moment + 1e-9
    assert "'bolt'" in seldom.table["largest anchor force at"]
    kept = seldom.save(tmp_path / "run")
    assert kept.table["largest tension [N]"] == most
    export(kept, "csv", tmp_path / "out")
    heads = (tmp_path / "out" / "segments.csv").read_text().splitlines()[0]
    assert "least tension [N],greatest tension [N]" in heads
    assert "greatest tension [N]" in (tmp_path / "out" / "run.csv").read_text().splitlines()[0]
    assert kept.dataset.extremes.sel(extreme="greatest tension").max() == most


def test_the_crack_of_a_whip_is_said_at_any_rate() -> None:
    """The preset at 60 frames a second: its frames see 42 m/s of the tip's 136."""
    whip = rw.preset("whip").replace(**{"run.duration": 0.25, "run.steps": "exact"})
    run = whip.run.replace(time_step=1.0 / 57600, frame_rate=60.0)
    seldom = rw.simulate(whip.replace(run=run))
    most = seldom.table["largest speed [m/s]"]
    every = Simulation(whip.replace(run=run.replace(frame_rate=57600.0))).frames()
    tip = max(np.linalg.norm(block.recording.v, axis=1).max() for block in every)
    assert most == pytest.approx(tip, rel=1e-12)
    assert 130.0 < most < 145.0
    assert np.linalg.norm(seldom.velocities, axis=2).max() < 0.4 * most  # the twin: what frames say
    assert seldom.table["largest speed at"].startswith("node 100 of rope 'cord', t from 0.23")


@pytest.mark.parametrize("method", [EULER, "verlet", "esdirk3"])
def test_the_energy_error_is_that_of_every_step(method: str, tmp_path: Path) -> None:
    """What all steps as frames say, least and greatest of it and when; the twin, the frames, misses it."""
    made = swinging(method, EVERY, 0.5, "vector", motion=STARTS)
    seldom = rw.simulate(made)
    often = rw.simulate(swinging(method, 1, 0.5, "vector", motion=STARTS))
    error, size = often.energy_error, 1e-12 * np.abs(often.energy["total"]).max()
    for k in range(FRAMES):
        own = slice(EVERY * k, EVERY * (k + 1) + 1)
        least, most = seldom.energy_errors[k + 1]
        assert least == pytest.approx(error[own].min(), abs=size)
        assert most == pytest.approx(error[own].max(), abs=size)
        for when, bound in zip(
            seldom.read("energy_error_times")[k + 1], (least, most), strict=True
        ):
            assert error[round(when / DT)] == pytest.approx(bound, abs=size)
    worst = seldom.table["largest energy error [J]"]
    assert worst == pytest.approx(np.abs(error).max(), abs=size)
    if method == EULER:  # the others' errors only grow here
        assert np.abs(seldom.energy_error).max() < 0.999 * worst
    assert seldom.table["largest energy error at"].startswith("t = ")
    kept = seldom.save(tmp_path / "run")
    np.testing.assert_array_equal(kept.energy_errors, seldom.energy_errors)
    export(kept, "csv", tmp_path / "out")
    heads = (tmp_path / "out" / "run.csv").read_text().splitlines()[0]
    assert "least energy error [J],greatest energy error [J]" in heads
    assert kept.dataset.energy_errors.sel(bound="least").min() == seldom.energy_errors[:, 0].min()


def test_energy_errors_of_ropes_that_move_alone_add_up_and_without_a_ledger_there_are_none() -> (
    None
):
    """The sum of what each errs bounds what all err together; when is then known to a frame."""
    one = swinging(EULER, EVERY, 0.5, "vector")
    rope, anchor = one.ropes[0], one.anchors[0]
    two = one.replace(
        ropes=[rope.replace(name="a"), rope.replace(name="b")],
        anchors=[anchor.replace(name=name, rope=name) for name in "ab"],
    )
    alone, both = rw.simulate(one), rw.simulate(two)
    np.testing.assert_allclose(both.energy_errors, 2.0 * alone.energy_errors, rtol=1e-12)
    assert both.table["largest energy error at"].endswith("the errors of all ropes added up")
    assert np.isnan(rw.simulate(one, ledger=False).energy_errors).all()


def test_without_extremes_the_table_is_of_the_frames_and_says_so(tmp_path: Path) -> None:
    scene = caught(60.0)
    result = rw.simulate(scene.replace(run=scene.run.replace(extremes=False)))
    assert result.table["largest tension [N]"] == result.tension.max()
    assert result.table["largest tension at"].endswith("of the recorded frames")
    assert not any(name.startswith(("extreme", "greatest")) for name in result.source.names)
    again = result.save(tmp_path / "run")
    assert again.table["largest tension at"] == result.table["largest tension at"]


def test_ropes_side_by_side_go_without_extremes_too() -> None:
    one = caught(60.0)
    rope, anchors = one.ropes[0], one.anchors
    two = one.replace(
        ropes=[rope.replace(name=name) for name in "ab"],
        anchors=[
            held.replace(rope=name, name=f"{held.name}-{name}") for name in "ab" for held in anchors
        ],
    )
    alone, both = (rw.simulate(s.replace(**{"run.extremes": False})) for s in (one, two))
    assert both.table["largest tension [N]"] == alone.table["largest tension [N]"]
    assert both.table["largest tension at"].endswith("of the recorded frames")


def test_a_break_leaves_no_absurd_extreme() -> None:
    """What came after the last good frame is in no table."""
    scene = swinging(EULER, 5, 0.0, "vector")
    wild = scene.replace(run=scene.run.replace(time_step=0.06, frame_rate=1.0, duration=60.0))
    result = rw.simulate(wild, on_failure="return")
    assert result.status == "broke"
    numbers = [value for value in result.table.values() if isinstance(value, float)]
    assert np.isfinite([n for n in numbers if not np.isnan(n)]).all()
    assert result.table["largest tension [N]"] < 1e4


def test_a_tension_map_of_a_slack_half_has_no_stripes() -> None:
    """Frames of 60 Hz meet waves of another rhythm now here, now there; intervals do not."""
    result = rw.simulate(rw.preset("wire-arch").replace(**{"run.duration": 1.0}))
    assert result.table["largest tension [N]"] > 10.0 * result.tension[1:].max()


def test_a_damaged_file_of_extremes_is_told(tmp_path: Path) -> None:
    record_run(swinging(EULER, 10, 0.0, "vector"), tmp_path / "run")
    path = next((tmp_path / "run" / "data.zarr" / "extremes").glob("c*"))
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(bytes(data))
    with pytest.raises(RunError, match="damaged"):
        rw.open(tmp_path / "run").table  # noqa: B018
