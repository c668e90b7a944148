"""`ropewalk sweep` and what other commands do with its folder."""

from __future__ import annotations

import json
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from click.testing import Result

import ropewalk as rw
from ropewalk.live.replay import ReplayBroadcast
from ropewalk.sweeps.batch import Batcher
from sweeps.scenes import EA, STIFF, of_format, swing

Call = Callable[..., Result]
VARY = ("--vary", "rope.made_of.spring_constant=500,1000,1e7", "--on", "here")


def test_a_sweep_says_how_its_runs_ended(ropewalk: Call, scene: Path, tmp_path: Path) -> None:
    done = ropewalk("sweep", scene, *VARY, "-o", "s")
    assert done.exit_code == 0, done.output
    assert "3 of 3 made: 2 finished, 1 broke" in done.output
    assert "tension_max" in done.output
    assert "broke: " in done.output
    told = json.loads(ropewalk("info", "s", "--json").output)
    assert told["ended"] == {"finished": 2, "broke": 1}
    assert sum(told["causes"].values()) == 1
    assert told["parameters"][0]["unit"] == "N/m"
    ds = rw.sweep.open(tmp_path / "s")
    own = rw.simulate(rw.load(scene).replace(ropes=[rw.load(scene).ropes[0].replace(
        made_of=rw.load(scene).ropes[0].made_of.replace(spring_constant=1000.0))]))  # fmt: skip
    assert ds.tension_max.values[1] == own.table["largest tension [N]"] >= own.tension.max()


def interrupted_at(number: int) -> Callable[[Batcher, list[float]], rw.Result]:
    """Return what makes a sweep's runs until the one of this number, where Ctrl-C is pressed."""
    real, seen = Batcher.run, 0

    def run(self: Batcher, row: list[float]) -> rw.Result:
        nonlocal seen
        seen += 1
        if seen == number:
            raise KeyboardInterrupt
        return real(self, row)

    return run


def test_an_interrupted_sweep_is_gone_on_with(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = interrupted_at(7)
    names = ["--vary", "gravity[2]=linspace(-12,-8,12)", "--on", "here"]
    monkeypatch.setattr("ropewalk.sweeps.many._MEASURED", 0.0)
    monkeypatch.setattr("ropewalk.sweeps.many.BATCH_SECONDS", 0.0)
    with monkeypatch.context() as patch:
        patch.setattr(Batcher, "run", run)
        stopped = ropewalk("sweep", scene, *names, "-o", "s")
    assert stopped.exit_code == 130, stopped.output
    assert "of 12 runs are stored" in stopped.output
    assert "ropewalk resume s" in stopped.output
    assert "go on with: ropewalk resume s" in ropewalk("info", "s").output
    resumed = ropewalk("resume", "s", "--on", "here")
    assert resumed.exit_code == 0, resumed.output
    assert "12 of 12 made: 12 finished" in resumed.output
    ropewalk("sweep", scene, *names, "-o", "whole")
    one, other = rw.sweep.open(tmp_path / "s"), rw.sweep.open(tmp_path / "whole")
    np.testing.assert_array_equal(one.positions_last, other.positions_last)


def test_samples_are_drawn_and_figures_made(ropewalk: Call, scene: Path, tmp_path: Path) -> None:
    spread = [
        "--vary",
        "rope.made_of.spring_constant=norm(800, 20)",
        "--vary",
        "gravity[2]=-10..-9",
    ]
    spread += ["--vary", "rope.made_of.node_mass=0.04..0.06"]
    keep = ["--keep", "tension.max", "--keep", "tension.max[time]", "--on", "here"]
    done = ropewalk("sweep", scene, *spread, "--samples", 16, "--seed", 4, *keep, "-o", "s")
    assert done.exit_code == 0, done.output
    assert "sobol, seed 4" in done.output
    drawn = ropewalk("plot", "s")
    assert drawn.exit_code == 0, drawn.output
    assert (tmp_path / "s" / "figures" / "tension_max_time.png").stat().st_size > 5000
    assert "there is no such figure" in ropewalk("plot", "s", "tension_maxx").output


def test_damage_is_told(ropewalk: Call, scene: Path, tmp_path: Path) -> None:
    values = {"gravity[2]": [-12.0, -11.0, -10.0, -9.0]}
    rw.sweep(scene, values, batch=1, store=tmp_path / "s", on="here")
    assert ropewalk("info", "s", "--verify").exit_code == 0
    store = tmp_path / "s" / "data.zarr"
    chunk = store / "tension_max" / "c.1"
    data = bytearray(chunk.read_bytes())
    data[-1] ^= 1
    chunk.write_bytes(data)
    (store / "status" / "c.2").unlink()
    checked = ropewalk("info", "s", "--verify")
    assert checked.exit_code == 2
    assert "tension_max/c.1: is damaged (run 1): its" in checked.output
    assert "status/c.2: is damaged (run 2): it is missing" in checked.output
    assert checked.output.count("`ropewalk resume s` makes these runs again") == 2
    told = ropewalk("info", "s")
    assert told.exit_code == 0, told.output
    assert "2 of 4 made: 2 finished" in told.output
    assert "2 stored batches are damaged" in told.output
    assert ropewalk("resume", "s").exit_code == 0
    assert ropewalk("info", "s", "--verify").exit_code == 0


def test_info_has_quantiles_of_what_is_one_number_a_run(ropewalk: Call, tmp_path: Path) -> None:
    scene = rw.preset("hanging-rope").replace(**{"run.duration": 0.02})
    keep = ["tension.max", "reactions.max", "positions[-1]", "sag.max[time]"]
    ds = rw.sweep(
        scene, {"rope.length": [12.0, 13.0, 14.0]}, keep=keep, store=tmp_path / "s", on="here"
    )
    kept = {one["name"]: one for one in json.loads(ropewalk("info", "s", "--json").output)["kept"]}
    anchors = ds.anchor.values.tolist()
    assert set(kept) == {
        *("tension_max", "positions_last", "sag_max_time"), *(f"reactions_max[{a}]" for a in anchors)
    }  # fmt: skip
    assert "quantiles" not in kept["positions_last"]
    assert "quantiles" not in kept["sag_max_time"]
    for anchor in anchors:
        median = float(ds.reactions_max.sel(anchor=anchor).median())
        assert kept[f"reactions_max[{anchor}]"]["quantiles"][2] == median


def test_numbers_of_a_sweep_with_broken_runs_say_whose_they_are(ropewalk: Call) -> None:
    stiff = ("--vary", "rope.made_of.spring_constant=100,1e9", "--set", "run.duration=0.5")
    done = ropewalk("sweep", "r8", *stiff, "--on", "here", "-o", "s")
    assert "1 finished, 1 broke" in done.output
    assert "those of the runs that ended well alone" in done.output
    whole = ropewalk("sweep", "r8", "--vary", "rope.made_of.spring_constant=90,100", "--set",
                     "run.duration=0.1", "--on", "here", "-o", "t")  # fmt: skip
    assert "ended well alone" not in whole.output


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--vary", "rope.made_of.springs=1"], "unknown key"),
        (["--vary", "rope.made_of.spring_constant"], "must be written as PATH=WHAT"),
        (["--vary", "gravity[2]=nrm(1,2)"], 'did you mean "norm"'),
        (["--vary", "gravity[2]=norm(1)..2"], "LOW..HIGH"),
        (["--vary", "gravity[2]=-10..-9"], "say how many samples"),
        (["--vary", "gravity[2]=-10,-9", "--vary", "gravity[2]=1"], "varied already"),
        (["--vary", "gravity[2]=1", "--keep", "tention.max"], 'did you mean "tension"'),
    ],
)
def test_bad_input(ropewalk: Call, scene: Path, words: list[str], told: str) -> None:
    done = ropewalk("sweep", scene, *words, "-o", "s")
    assert done.exit_code == 2
    assert told in done.output


def test_uncertain_runs(ropewalk: Call, scene: Path, tmp_path: Path) -> None:
    spread = ["--uncertain", "rope.made_of.node_mass=0.04..0.06", "--samples", 8]
    done = ropewalk("run", scene, *spread, "--uncertain", "gravity[2]=norm(-9.8, 0.1)", "-o", "u")
    assert done.exit_code == 0, done.output
    assert "node_mass" in done.output
    assert (tmp_path / "u" / "figures" / "uncertain.png").exists()
    told = json.loads(ropewalk("run", scene, *spread, "-o", "v", "--json").stdout)
    assert told["bands"]["tension_max"]["5 %"] < told["bands"]["tension_max"]["95 %"]
    for flag in ("--samples", "--seed"):
        assert "goes with --uncertain" in ropewalk("run", scene, flag, 8).output
    one, other = (
        json.loads(ropewalk("run", scene, *spread, "--seed", 3, "-o", f, "--json").stdout)
        for f in ("w", "x")
    )
    assert one["seed"] == other["seed"] == 3
    assert one["bands"] == other["bands"]
    info = " ".join(ropewalk("info", "w").output.split())
    assert "seed 3" in info
    told_of = "are of 8 runs, those of a plain sample of 8 that ended well"
    assert (told_of in info) == bool(find_spec("SALib"))


def test_uncertain_runs_that_were_interrupted_are_gone_on_with_to_their_bands(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing said how to go on, and `resume` gave neither bands nor indices nor the figure."""
    run = interrupted_at(20)
    spread = ["--uncertain", "rope.made_of.node_mass=0.04..0.06", "--samples", 8, "--seed", 3]
    spread += ["--uncertain", "gravity[2]=norm(-9.8, 0.1)"]
    whole = json.loads(ropewalk("run", scene, *spread, "-o", "whole", "--json").stdout)
    monkeypatch.setattr("ropewalk.sweeps.many._MEASURED", 0.0)
    monkeypatch.setattr("ropewalk.sweeps.many.BATCH_SECONDS", 0.0)
    with monkeypatch.context() as patch:
        patch.setattr(Batcher, "run", run)
        stopped = ropewalk("run", scene, *spread, "-o", "u")
    assert stopped.exit_code == 130, stopped.output
    assert "go on with: ropewalk resume u" in stopped.output
    assert not (tmp_path / "u" / "figures" / "uncertain.png").exists()
    resumed = ropewalk("resume", "u", "--on", "here", "--json")
    told = json.loads(resumed.stdout)
    assert told | {"folder": "whole"} == whole
    indices = told["total Sobol indices"].get("tension_max", {})
    assert ("node_mass" in indices) == bool(find_spec("SALib"))
    assert (tmp_path / "u" / "figures" / "uncertain.png").exists()


def test_who_goes_on_with_a_sweep_can_be_said(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rw.sweep(
        rw.load(scene), {"gravity[2]": [-10.0, -9.0]}, store=tmp_path / "s", on="here", batch=1
    )
    asked = []
    monkeypatch.setattr(
        "ropewalk.sweeps.many.resume_sweep", lambda folder, **how: asked.append(how)
    )
    assert ropewalk("resume", "s", "--on", "local", "--workers", 2).exit_code == 0
    assert asked == [{"on": "local", "workers": 2, "force": False}]
    ropewalk("run", scene, "-o", "r")
    assert "are of sweeps" in ropewalk("resume", "r", "--workers", 2).output
    assert "no such run folder" in ropewalk("resume", "none", "--on", "here").output


def replaying(scene: rw.Scene, stiffness: float) -> ReplayBroadcast:
    """A broadcast that shows a run of its own with this spring constant."""
    made = scene.replace(**{"rope.made_of.spring_constant": stiffness})
    return ReplayBroadcast(rw.simulate(made))


def test_a_run_of_a_sweep_is_shown(
    ropewalk: Call, scene: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ropewalk("sweep", scene, *VARY, "-o", "s")
    shown = []
    monkeypatch.setattr(
        "ropewalk.cli.commands.view._serve", lambda make, *_: shown.append(make(None)) or 0
    )
    own = replaying(rw.load(scene), 1000.0)
    other = replaying(rw.load(scene), 1000.0 * (1.0 + 2.0**-52))
    assert ropewalk("view", "s", "--run", 1).exit_code == 0
    (server,) = shown
    server.stop("")
    served = server.broadcast.parts[0].result
    mine = own.parts[0].result
    assert served.source.names == mine.source.names
    for name in ("time", *mine.source.names):
        assert served.read(name).tobytes() == mine.read(name).tobytes(), name
    frames = list(server.broadcast.frames_between(0, mine.frames, 1))
    assert frames == list(own.frames_between(0, mine.frames, 1))  # as they go to the page
    assert served.read("tension").tobytes() != other.parts[0].result.read("tension").tobytes()
    assert "say which run" in ropewalk("view", "s").output
    assert "has no run 9" in ropewalk("view", "s", "--run", 9).output
    assert "is no sweep" in ropewalk("view", scene, "--run", 1).output


@pytest.mark.parametrize("words", [["movie"], ["share"], ["export", "--to", "csv"]])
def test_what_is_made_of_a_run_says_of_a_sweep_that_it_is_one(
    ropewalk: Call, scene: Path, words: list[str]
) -> None:
    ropewalk("sweep", scene, *VARY, "-o", "s")
    done = ropewalk(*words, "s")
    assert done.exit_code == 2
    assert "s: is a sweep, which keeps no run whole; `ropewalk view s --run 0`" in done.stderr
    assert "no run folder" not in done.stderr


def test_a_value_that_is_uncertain_twice_is_refused(ropewalk: Call, scene: Path) -> None:
    """The first of the two was dropped."""
    twice = ("--uncertain", "gravity[2]=-10..-9", "--uncertain", "gravity[2]=5%")
    for command in ("run", "sheet"):
        done = ropewalk(command, scene, *twice)
        assert done.exit_code == 2, done.output
        assert "--uncertain: 'gravity[2]=5%' - gravity[2] is varied already" in done.output


def test_quiet_sweeps_print_their_folder_alone(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spread = ("--uncertain", "gravity[2]=-10..-9", "--samples", 8)
    done = ropewalk("run", scene, *spread, "-o", "u", "-q")
    assert (done.stdout, done.stderr) == ("u\n", "")
    assert (tmp_path / "u" / "figures" / "uncertain.png").exists()
    done = ropewalk("resume", "u", "-q", "--on", "here")
    assert (done.stdout, done.stderr) == ("u\n", "")
    rw.sweep(scene, {"gravity[2]": [-10.0, -9.0]}, store=tmp_path / "s", on="here", batch=1)
    (tmp_path / "s" / "data.zarr" / "status" / "c.1").unlink()
    done = ropewalk("resume", "s", "-q", "--on", "here")
    assert (done.stdout, done.stderr) == ("s\n", "")
    assert json.loads(ropewalk("resume", "s", "-q", "--json").stdout)["done"] == 2
    kept = ropewalk("run", scene, *spread, "--keep-going", "-o", "v")
    assert kept.exit_code == 2
    assert "--keep-going: goes on with one run" in kept.output


def test_what_is_drawn_of_a_sweep_that_was_overwritten_is_warned_of(
    ropewalk: Call, scene: Path, tmp_path: Path
) -> None:
    spread = ("--uncertain", "gravity[2]=-10..-9", "--samples", 8, "-o", "u", "--overwrite")
    spread += ("--duration", 0.02)
    told = "figures may be of the sweep before: make them anew"
    assert told not in ropewalk("run", scene, *spread).stderr
    assert told not in ropewalk("run", scene, *spread).stderr  # the one figure is made anew
    (tmp_path / "u" / "figures" / "tension_max_time.png").write_bytes(b"drawn")
    assert f"u: {told}" in ropewalk("run", scene, *spread).stderr
    assert ropewalk("run", scene, *spread, "-q").stderr == ""
    done = ropewalk("sweep", scene, *VARY, "-o", "u", "--overwrite")
    assert f"u: {told}" in done.stderr
    ropewalk("sweep", scene, *VARY, "-o", "t")
    assert told not in ropewalk("sweep", scene, *VARY, "-o", "t", "--overwrite").stderr


def test_an_interruption_before_a_sweep_is_there_tells_nothing_of_the_one_it_would_overwrite(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rw.sweep(scene, {"gravity[2]": [-10.0, -9.0]}, store=tmp_path / "s", on="here")
    monkeypatch.setattr(Batcher, "run", interrupted_at(1))
    stopped = ropewalk("sweep", scene, *VARY, "-o", "s", "--overwrite")
    assert stopped.exit_code == 130
    assert "resume" not in stopped.output
    assert "runs are stored" not in stopped.output
    assert rw.sweep.open(tmp_path / "s").gravity_2.values.tolist() == [-10.0, -9.0]
    (tmp_path / "s" / "data.zarr" / "status" / "c.0").unlink()
    monkeypatch.setattr(Batcher, "run", interrupted_at(1))
    stopped = ropewalk("resume", "s", "--on", "here")  # this one it does go on with
    assert stopped.exit_code == 130
    assert "go on with: ropewalk resume s" in stopped.output


def test_without_salib_uncertain_runs_are_gone_on_with_to_their_bands(
    ropewalk: Call, scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Their design is that of any sample; the twin keeps something else, and is a plain sweep."""
    monkeypatch.setattr("ropewalk.sweeps.uncertainty.find_spec", lambda name: None)
    spread = {"gravity[2]": (-10.0, -9.0)}
    short = rw.load(scene).replace(**{"run.duration": 0.02})
    rw.uncertain(short, spread, samples=4, seed=3, store=tmp_path / "u", batch=2, on="here")
    ask = {"samples": 4, "seed": 3, "batch": 2, "on": "here"}
    rw.sweep(short, spread, keep=["sag.max[time]", "tension.max"], store=tmp_path / "s", **ask)
    for folder, bands in (("u", True), ("s", False)):
        (tmp_path / folder / "data.zarr" / "done" / "marks" / "c.1").unlink()
        done = ropewalk("resume", folder, "--on", "here")
        assert done.exit_code == 0, done.output
        assert ("seed of the samples: 3" in done.stdout) is bands
        assert ("4 of 4 made" in done.stdout) is not bands
        assert (tmp_path / folder / "figures" / "uncertain.png").exists() is bands


def test_one_run_is_told_as_one_and_folders_as_they_are_typed(
    ropewalk: Call, scene: Path, tmp_path: Path
) -> None:
    short = rw.load(scene).replace(**{"run.duration": 0.01})
    rw.sweep(short, {"gravity[2]": [-9.0]}, store=tmp_path / "a sweep", on="here")
    (tmp_path / "a sweep" / "data.zarr" / "done" / "marks" / "c.0").unlink()
    told = ropewalk("info", "a sweep").stdout
    assert "0 of 1 made" in told
    assert "go on with: ropewalk resume 'a sweep'" in told
    rw.sweep.resume(tmp_path / "a sweep", on="here")
    told = ropewalk("info", "a sweep").stdout
    assert "1 of 1 made: 1 finished" in told
    assert "of 1 run, 5 % and 95 %" in told


def test_no_heading_is_told_where_nothing_is_noted(ropewalk: Call, tmp_path: Path) -> None:
    """It stood there alone, of sweeps without notes and of those from before there were any."""
    heading = "of the runs that ended well"
    calm = rw.preset("suspension-cable").replace(**{"run.duration": 0.02})
    ask = {"keep": "tension.max", "on": "here"}
    lengths = {"gravity[2]": [-9.8, -9.81]}
    ds = rw.sweep(calm, lengths, store=tmp_path / "calm", **ask)
    assert ds.notes.values.tolist() == ["", ""]
    assert heading not in ropewalk("info", "calm").output
    with of_format(3):
        rw.sweep(calm, lengths, store=tmp_path / "old", **ask)
    told = ropewalk("info", "old").output
    assert "was not kept yet" in told
    assert heading not in told
    rw.sweep(swing(0.1), {EA: STIFF[:2]}, store=tmp_path / "noted", **ask)
    assert heading in ropewalk("info", "noted").output
