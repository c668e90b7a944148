"""What a run tells of what happened in it: releases, stops of winches, breaks, ends."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import ropewalk as rw
import runs
from ropewalk.cli import main
from ropewalk.record.event_log import log, read_events
from ropewalk.record.result import Result
from ropewalk.record.resume import resume_run
from ropewalk.record.run import record_run
from ropewalk.record.simulate import simulate_in_memory
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Winch


def wound(*winches: Winch, release: float | None = None, duration: float = 2.0) -> Scene:
    """A cord of 4 m in half metres that hangs from its winch."""
    cord = Material(EA=500.0, mass_per_length=0.1, axial_damping=2.0)
    return Scene(
        name="winch",
        ropes=[Rope(segments=8, length=4.0, made_of=cord, shape={"kind": "hanging"})],
        anchors=[Anchor(name="drum", node=0, release_time=release)],
        winches=winches,
        run=RunSettings(
            duration=duration, frame_rate=50.0, time_step=1e-3, method="semi-implicit-euler"
        ),
    )


def told(scene: Scene) -> list[dict[str, Any]]:
    """The events of a run in memory, but for its end."""
    *events, end = simulate_in_memory(scene).events
    assert end["event"] == "finished"
    return events


STOPS = {  # the winch, by what it stops, and when: start + length / speed
    "drum": ({"speed": 0.5, "on_drum": 0.35}, "empty drum", 0.7),
    "longest": ({"speed": 0.5, "start": 0.3, "max_length": 4.4}, "max_length", 1.1),
    "shortest": ({"speed": -0.8, "min_length": 3.0}, "min_length", 1.25),
    "last": ({"speed": -3.75}, "last segment", 1.0),
    "plan": ({"speed": 0.5, "stop": 0.9}, "stop time", 0.9),
}


@pytest.mark.parametrize("case", STOPS)
def test_a_winch_that_stops_is_told_with_its_time(case: str) -> None:
    """start + length / speed, exactly but for rounding; the twin turns on to the end."""
    more, why, time = STOPS[case]
    (event,) = told(wound(Winch(name="hoist", end="start", **more)))
    assert event["event"] == "winch stopped"
    assert (event["winch"], event["by"]) == ("hoist", why)
    assert event["time"] == pytest.approx(time, abs=1e-9)
    assert told(wound(Winch(end="start", speed=0.1))) == []


def test_a_drum_that_is_let_go_is_told_once_for_the_anchor_and_once_for_the_winch() -> None:
    events = told(wound(Winch(end="start", speed=0.5), release=0.612))
    assert events == [
        {"event": "released", "time": 0.612, "anchor": "drum"},
        {"event": "winch stopped", "time": 0.612, "winch": "winch0", "by": "released"},
    ]


def test_events_come_in_order_of_time() -> None:
    """All in one block of frames, which is looked at only once."""
    scene = wound(Winch(end="start", speed=0.5, on_drum=0.2), release=1.5)
    assert [event["time"] for event in told(scene)] == pytest.approx([0.4, 1.5], abs=1e-9)


def test_a_drum_sized_by_the_duration_says_so() -> None:
    """Beyond its plan a run in steps of its own outruns the drum that the plan sized."""
    from ropewalk.record.happenings import Watch
    from ropewalk.simulation import Simulation

    simulation = Simulation(wound(Winch(end="start", speed=0.5), duration=0.5))
    watch = Watch(simulation)
    simulation.step(0.5)
    assert watch.look() == []
    simulation.step(3.0)
    (event,) = watch.look()
    assert event["by"] == "empty drum"
    assert event["time"] == pytest.approx(2.0, abs=1e-9)  # a segment, and one to spare
    assert "on_drum" in event["drum"]


def test_a_break_is_told_with_its_time(tmp_path: Path) -> None:
    """Stopped at the break the log ends with it; going on, the break comes before the end."""
    stopped = record_run(runs.breaking(), tmp_path / "a")
    last = stopped.events[-1]
    assert last["event"] == "broke"
    assert last["time"] == stopped.time[-1]
    assert last["diagnosis"] == stopped.diagnosis
    on = record_run(runs.breaking(), tmp_path / "b", keep_going=True)
    *_, broke, end = (event for event in on.events if event["event"] != "released")
    assert broke["event"] == "broke"
    assert broke["time"] == stopped.time[-1]
    assert end["event"] == "ended"
    assert end["time"] == pytest.approx(2.0)
    in_memory = simulate_in_memory(runs.breaking()).events[-1]
    assert in_memory == {key: value for key, value in last.items() if key != "at"}


def test_a_saved_result_keeps_its_events(tmp_path: Path) -> None:
    result = rw.simulate(runs.hanging())
    saved = result.save(tmp_path / "a")
    assert [event["event"] for event in result.events] == ["released", "finished"]
    assert [event["event"] for event in saved.events] == ["released", "finished", "saved"]


def test_a_resumed_run_tells_everything_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Killed after the release was logged and before the checkpoint: it is released again, and told
    once; a line that the kill has torn is left out. The twin is the log itself, which holds it twice.
    """
    monkeypatch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 8)
    folder, real, seen = tmp_path / "a", os.replace, 0

    class Killed(BaseException):
        pass

    def replace(source: Any, target: Any) -> None:
        nonlocal seen
        if (folder / "events.jsonl").exists() and b"released" in (
            folder / "events.jsonl"
        ).read_bytes():
            raise Killed
        real(source, target)

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", replace)
        with pytest.raises(Killed):
            record_run(runs.hanging(), folder, commit_seconds=0.0)
    with open(folder / "events.jsonl", "ab") as file:
        file.write(b'{"at": "2026-')
    assert Result.open(folder).status == "interrupted"
    result = resume_run(folder, commit_seconds=0.0)
    names = [event["event"] for event in result.events]
    assert names == ["started", "released", "resumed", "finished"]
    lines = (folder / "events.jsonl").read_bytes().splitlines()
    assert sum(b'"released"' in line for line in lines) == 2
    # resumed after its release, a run does not tell it again
    assert [event["time"] for event in result.events if event["event"] == "released"] == [0.5]


def test_a_log_that_is_no_log(tmp_path: Path) -> None:
    """What cannot be read is left out, never an error: the log is for people."""
    assert read_events(tmp_path) == ()
    (tmp_path / "events.jsonl").write_bytes(b'\xff\xfe\n[1, 2]\n{"event": 3}\n"text"\n')
    log(tmp_path, "started")
    assert [event["event"] for event in read_events(tmp_path)] == ["started"]


def test_info_and_run_show_events(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`info` lists them, `run` warns of a drum that ran empty, `check` of one that will."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "160")
    scene = wound(Winch(name="hoist", end="start", speed=0.5, on_drum=0.35), release=1.5)
    rw.save(scene, "scene.toml")

    def call(*arguments: str) -> Any:
        return CliRunner().invoke(main, arguments)

    checked = call("check", "scene.toml")
    assert "winch 'hoist': its drum of 0.35 m is empty at 0.7 s" in checked.stderr
    done = call("run", "scene.toml", "-o", "a")
    assert done.exit_code == 0
    assert "winch 'hoist' stopped at t = 0.7 s: its drum was empty" in done.stderr
    shown = call("info", "a").stdout
    for text in ("winch stopped", "t = 0.7 s", "winch hoist, by empty drum", "released", "drum"):
        assert text in shown
    events = json.loads(call("info", "a", "--json").stdout)["events"]
    names = [event["event"] for event in events]
    assert names == ["started", "winch stopped", "released", "finished"]
    assert json.loads(call("run", "scene.toml", "--json").stdout)["events"] == [
        event | {"at": ours["at"]}
        for event, ours in zip(
            events, json.loads(call("info", "runs/scene-1", "--json").stdout)["events"], strict=True
        )
    ]
