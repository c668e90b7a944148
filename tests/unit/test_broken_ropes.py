"""A rope that breaks ends its own island: the others go on, and the run says what broke."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import ropewalk as rw
from ropewalk.analysis.compare import compare_runs
from ropewalk.cli.app import main
from ropewalk.lowering import build
from ropewalk.record.contacts import contact_modes, node_modes
from ropewalk.record.ends import End, in_words
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.scene import Anchor, Material, Rope, Scene, Slack, Velocity, save
from ropewalk.simulation import Simulation
from ropewalk.sweeps.batch import result_of

METHODS = ("sdirk2", "semi-implicit-euler", "adaptive")
OWN = (
    *("velocities", "tension", "elastic_tension", "greatest_tension", "least_tension"),
    *("greatest_height", "least_height"),
)


def hung(names: str, method: str = "sdirk2", **run: object) -> Scene:
    """Ropes that hang from one end; b and d are pulled apart, d later, until they are ten times as long."""
    ropes = [
        Rope(
            name=name,
            segments=6,
            length=1.0,
            made_of=Material(
                EA=20.0 if name in "bd" else 1e3, mass_per_length=0.1, axial_damping=0.5
            ),
            shape=Slack(start=(0, ord(name), 0), end=(0.9, ord(name), 0.1)),
        )
        for name in names
    ]
    anchors = [Anchor(name=f"hold-{name}", rope=name, node=0) for name in names]
    for name, speed in (("b", 60.0), ("d", 30.0)):
        if name in names:
            pulled = Velocity(velocity=(speed, 0, 0))
            anchors.append(Anchor(name=f"pull-{name}", rope=name, node=-1, motion=pulled))
    step = {"time_step": 5e-4 if method == "semi-implicit-euler" else 1 / 240}
    if method == "adaptive":
        step = {"tolerance": 1e-3}
    about = {"method": method, "frame_rate": 60, "duration": 0.5, **step, **run}
    return Scene(name="hung", ropes=ropes, anchors=anchors, run=about)


@pytest.mark.parametrize("method", METHODS)
def test_others_go_on_as_if_alone(method: str) -> None:
    together = rw.simulate(hung("abc", method), on_failure="return")
    assert together.status == "broke"
    assert together.frames == together.plan.frames + 1
    (end,) = together.ends
    assert end.ropes == ("b",)
    assert end.frames < together.frames
    assert end.time == pytest.approx(together.time[end.frames - 1])
    assert "rope 'b'" in together.diagnosis
    assert together.diagnosis.endswith("The other 2 ropes went on.")
    for name in "ac":
        alone = rw.simulate(hung(name, method))
        rope = together.rope(name)
        assert rope.end is None
        for quantity in ("positions", "velocities", "tension", "greatest_tension"):
            assert np.array_equal(getattr(rope, quantity), getattr(alone.rope(), quantity))


@pytest.mark.parametrize("method", METHODS)
def test_a_broken_rope_lies_where_it_broke_and_has_no_numbers_after_that(method: str) -> None:
    together = rw.simulate(hung("abc", method), on_failure="return")
    alone = rw.simulate(hung("b", method), on_failure="return")
    (end,), rope, span = together.ends, together.rope("b"), together.layout.span("b")
    assert (rope.end, alone.frames) == (end, end.frames)
    assert alone.ends[0].why == end.why
    assert np.array_equal(rope.positions[: end.frames], alone.positions)
    after = slice(end.frames, None)
    assert np.array_equal(
        rope.positions[after], np.broadcast_to(alone.positions[-1], rope.positions[after].shape)
    )
    nodes, segments = slice(span.first, span.last + 1), slice(span.first, span.last)
    for name in OWN:
        array = together.read(name)
        own = array[:, nodes if array.shape[1] == together.nodes else segments]
        assert np.isnan(own[after]).all(), name
        assert np.isfinite(own[: end.frames]).all(), name
    rows = [together.layout.anchor_names.index(name) for name in ("hold-b", "pull-b")]
    assert np.isnan(together.reactions[after][:, rows]).all()
    assert np.isnan(rope.stretch[after]).all()


def test_whether_a_broken_rope_touches_is_not_known() -> None:
    """`wrap` said that it had left the bar, with an angle and tensions of 0, and its modes were "open"."""
    bar = {"kind": "cylinder", "name": "bar", "start": (0.45, 0, -0.3), "end": (0.45, 200, -0.3)}
    scene = hung("abc").replace(obstacles=[{**bar, "radius": 0.1, "friction": 0.3}])
    result = rw.simulate(scene, on_failure="return")
    (end,), span = result.ends, result.layout.span("b")
    assert 1 < end.frames < result.frames
    for name, known in (("a", result.frames), ("b", end.frames)):
        lies = result.wrap("bar", name)
        for values in (lies.angle, lies.before, lies.after):
            assert np.isfinite(values[:known]).all()
            assert np.isnan(values[known:]).all()
        assert not lies.touches[known:].any()
    assert result.wrap("bar", "a").touches.any()
    broken = np.zeros((result.frames, result.nodes), bool)
    broken[end.frames :, span.first : span.last + 1] = True
    for modes in (result.contact_modes, node_modes(result)):
        assert (modes[broken] == -1).all()
        assert (modes[~broken] >= 0).all()
    assert (contact_modes(result, [end.frames, 0])[:, span.first] == [-1, 0]).all()
    result.plot.sticking()


def test_sums_and_tables_stay_finite() -> None:
    result = rw.simulate(hung("abc"), on_failure="return")
    for values in (*result.energy.values(), *result.work.values(), result.momentum):
        assert np.isfinite(values).all()
    scale = max(float(np.abs(values).max()) for values in result.energy.values())
    assert np.abs(result.balance_residual).max() < 1e-9 * scale
    table = result.table
    assert table["broken ropes"] == f"b after {result.ends[0].time:.5g} s"
    numbers = [value for value in table.values() if isinstance(value, float)]
    assert np.isfinite(numbers).all()
    assert max(map(abs, numbers)) < 1e6
    assert "rope 'b'" in table["largest tension at"]
    assert "as they broke" in table["final total energy at"]
    # The twin: a run in which nothing breaks says nothing of it.
    sound = rw.simulate(hung("ac")).table
    assert "broken ropes" not in sound
    assert "as they broke" not in sound["final total energy at"]


def test_ropes_break_one_after_another_until_none_is_left() -> None:
    both = rw.simulate(hung("bd"), on_failure="return")
    assert [end.ropes for end in both.ends] == [("b",), ("d",)]
    assert both.ends[0].frames < both.ends[1].frames == both.frames < both.plan.frames + 1
    assert "went on" not in both.diagnosis
    for name, end in zip("bd", both.ends, strict=True):
        alone = rw.simulate(hung(name), on_failure="return")
        assert alone.frames == end.frames
        assert np.array_equal(alone.positions, both.rope(name).positions[: end.frames])


def test_one_verdict_for_ropes_that_share_an_island() -> None:
    """The twin: a simulation that one steps oneself stops at the first break, as ever."""
    simulation = Simulation(hung("ab", "semi-implicit-euler"))
    blocks = list(simulation.frames())
    assert blocks[-1].status != 0
    assert simulation.time < 0.3
    assert simulation.frames_left > 0


def test_a_run_folder_tells_of_its_broken_ropes(tmp_path: Path) -> None:
    run = tmp_path / "run"
    record_run(hung("abc"), run)
    memory, opened = rw.simulate(hung("abc"), on_failure="return"), rw.open(run)
    assert [(end.ropes, end.frames) for end in opened.ends] == [
        (end.ropes, end.frames) for end in memory.ends
    ]
    for name in opened.source.names:
        assert np.array_equal(opened.read(name), memory.read(name), equal_nan=True), name
    kinds = [event["event"] for event in opened.events]
    assert kinds.count("rope broke") == 1
    assert kinds[-1] == "ended"
    assert opened.save(tmp_path / "copy").ends == opened.ends
    frame = opened.to_pandas("segments")
    after = frame[(frame["rope"] == "b") & (frame["time [s]"] > opened.ends[0].time + 1e-6)]
    assert len(after) > 0
    assert after["tension [N]"].isna().all()


@pytest.mark.parametrize("method", ["sdirk2", "semi-implicit-euler"])
def test_a_run_with_a_broken_rope_resumes_to_the_same_bits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, method: str
) -> None:
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 2)
    whole = record_run(hung("abd", method), tmp_path / "whole")

    def stop_late(done: int, planned: int, block: object) -> None:
        if whole.ends[0].frames + 4 < done < whole.ends[1].frames:
            raise TimeoutError

    with pytest.raises(TimeoutError):
        record_run(hung("abd", method), tmp_path / "cut", progress=stop_late, commit_seconds=0.0)
    told = json.loads((tmp_path / "cut" / "status.json").read_text())
    resumed = resume_run(tmp_path / "cut")
    assert [end.ropes for end in resumed.ends] == [("b",), ("d",)]
    assert (told["status"], len(told["ends"])) == ("running", 1)
    assert (
        resumed.beyond is not None
    )  # of the first break, which came before the end of the process
    assert whole.beyond is not None
    np.testing.assert_array_equal(resumed.beyond.positions, whole.beyond.positions)
    assert [(e.frames, e.time) for e in resumed.ends] == [(e.frames, e.time) for e in whole.ends]
    for name in whole.source.names:
        assert np.array_equal(resumed.read(name), whole.read(name), equal_nan=True), name


def test_figures_mark_the_broken_rope(tmp_path: Path) -> None:
    result = rw.simulate(hung("abc"), on_failure="return")
    for name in set(dir(result.plot)) - {"contact", "sticking"}:  # nothing is touched here
        figure = getattr(result.plot, name)()
        figure.savefig(tmp_path / f"{name}.png")
        texts = [text.get_text() for text in figure.findobj(match=_is_text)]
        assert any("Ended early: b after" in text for text in texts), name
    up = result.plot.height(["a:3", "b:3"]).axes[0]
    lines = {line.get_label(): np.asarray(line.get_ydata()) for line in up.lines}
    assert np.isfinite(lines["a, node 3"]).all()
    assert np.isnan(lines["b, node 3"]).sum() == result.frames - result.ends[0].frames


def _is_text(artist: object) -> bool:
    return hasattr(artist, "get_text")


def test_the_command_says_what_broke_and_exits_with_3(tmp_path: Path) -> None:
    save(hung("abc"), tmp_path / "scene.toml")
    arguments = ["run", str(tmp_path / "scene.toml"), "-o", str(tmp_path / "run")]
    done = CliRunner().invoke(main, arguments)
    assert done.exit_code == 3
    assert "The other 2 ropes went on." in done.output
    told = CliRunner().invoke(main, ["info", str(tmp_path / "run")])
    assert "rope broke" in told.output
    assert "broken ropes" in told.output


def test_runs_are_compared_until_a_rope_breaks() -> None:
    broken = rw.simulate(hung("ab"), on_failure="return")
    other = rw.simulate(hung("ab", time_step=1 / 480), on_failure="return")
    found = compare_runs([broken, other], ["one", "other"])
    (far,) = found.distances
    assert len(far.time) == min(broken.ends[0].frames, other.ends[0].frames) < broken.frames
    assert "until one run broke" in far.note
    assert all(row["largest tension [N]"] > 0.0 for row in found.rows)


def test_a_sweep_counts_the_run_as_broken_at_its_first_break() -> None:
    found = result_of(build(hung("abc")), "run")
    assert found.status == "broke"
    assert found.broke_at == found.ends[0].time


def test_what_ended_is_told_in_whole_sentences() -> None:
    """Texts of steps without a solution end in no full stop."""
    ends = (End(("a",), 0.1, 3, "No step (here)"), End(("b",), 0.2, 5, "It ends, too."))
    assert in_words(ends, 3) == "No step (here). It ends, too. The other rope went on."
    assert in_words(ends[:1], 1) == "No step (here)"
