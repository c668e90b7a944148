"""Every run of a sweep tells what a table of its own would warn of, by kinds that are counted."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.record.landings import landings_of
from ropewalk.record.note_kinds import BETWEEN, KINDS, kinds, kinds_in, noted
from ropewalk.record.turnover import share_turned, steady_note
from ropewalk.scene import apply_overrides
from ropewalk.sweeps.summary import summary
from ropewalk.sweeps.sweep_folder import SweepFolder
from sweeps.scenes import EA, STIFF, of_format, store_bytes, swing

MASS = "rope.load.mass"
FALL = ["run.duration=0.3", "rope.made_of.breaking_load=6000"]
PARTS = "rope.made_of.parts=true"
#: Which row of a table is told as which kinds; of others no note is kept.
ROWS = {
    "largest tension": ("peak may be wrong", "peak may be too low", "end weight"),
    "least tension": ("push",),
    "largest stretch": ("beyond curve",),
    "largest speed": ("speed may be too low",),
    "largest anchor force": ("mean anchor force", "landing not shown"),
    "largest clamp moment": ("clamp moment too low",),
    "largest force on an obstacle": ("landing not shown", "force between frames"),
    "hard stops": ("hard stop",),
    "largest utilisation of the breaking load": ("guess",),
    "stretch limiter": ("limiter gives energy", "rest beyond limiter"),
    "obstacles": ("inside obstacle",),
}


def dropped(step: float = 0.002, frame_rate: float = 100.0) -> rw.Scene:
    """A column that falls 1 m and lands on its end."""
    rope = rw.Rope(
        segments=20, length=3.0, diameter=0.01, made_of=rw.Material(EA=1e5, mass_per_length=0.1),
        shape={"kind": "straight", "start": (0, 0, 4), "end": (0, 0, 1)},
    )  # fmt: skip
    run = {"duration": 0.6, "frame_rate": frame_rate, "method": "implicit-euler", "time_step": step}
    return rw.Scene(ropes=[rope], obstacles=[{"kind": "plane"}], run=run)


def fallen(post: bool) -> rw.Scene:
    """A rope that falls flat onto a floor, across a post above it or not."""
    rope = rw.Rope(
        segments=30, length=3.0, diameter=0.02,
        made_of=rw.Material(EA=1e5, mass_per_length=0.1, axial_damping=50.0),
        shape={"kind": "straight", "start": (-1.5, 0, 1), "end": (1.5, 0, 1)},
    )  # fmt: skip
    floor = {"kind": "plane", "point": (0, 0, -0.5)}
    bodies = [{"kind": "cylinder", "from": (0, -1, 0), "to": (0, 1, 0), "radius": 0.1}, floor]
    run = {"duration": 0.7, "frame_rate": 60, "method": "implicit-euler", "time_step": 0.002}
    return rw.Scene(ropes=[rope], obstacles=bodies if post else [floor], run=run)


def frames_only(scene: rw.Scene) -> rw.Scene:
    """The same of which nothing of the steps between frames is kept."""
    return scene.replace(**{"run.extremes": False})


def disc() -> rw.Scene:
    """The same rope across a flat disc, which only what goes along its axis may pass."""
    flat = {"kind": "cylinder", "start": (0, -0.01, 0), "end": (0, 0.01, 0), "radius": 0.3}
    return fallen(post=False).replace(obstacles=[flat])


def fall(*more: str) -> rw.Scene:
    """A climber's fall on a rope that bears 6 kN."""
    return apply_overrides(rw.preset("climbing-fall"), [*FALL, *more])


def kinds_of_table(result: rw.Result) -> set[str]:
    """What kinds a run's table has, by its rows."""
    table, found = result.table, set()
    for row, known in ROWS.items():
        if f"about the {row}" in table or f"about {row}" in table:
            text = table.get(f"about the {row}") or table[f"about {row}"]
            if not text.startswith("see the largest tension"):  # of its kind
                found.add(known[0] if len(known) == 1 else _of_tension(text))
    if result.status != "at rest" and "about the energy" in table:
        worst = float(np.nanmax(np.abs(result.energy_errors), initial=0.0))
        if not steady_note(result, worst, share_turned(result)):
            found.add("energy not kept")
    if any("only nodes touch" in text for text in rw.check(result.scene, measure=False).warnings):
        found.add("long segments")
    parted = table.get("segments parted", 0) > 0
    found |= {"parted"} if parted else set()
    if table.get("largest utilisation of the breaking load [%]", 0.0) > 100.0 and not parted:
        found.add("above breaking load")
    return found


def _of_tension(text: str) -> str:
    words = {"too low: it": "landing not shown", "the mean over": "mean anchor force"}
    words |= {"between two frames": "force between frames"}
    words |= {"hardly resolve what hits": "peak may be wrong"}
    words |= {"a jerk": "peak may be wrong", " lost ": "peak may be too low"}
    words |= {"a peak of a step": "peak may be wrong", "keeps waves ringing": "peak may be wrong"}
    return next((kind for part, kind in words.items() if part in text), "end weight")


#: Scenes that between them have most kinds, with the kinds that each is there for.
NOTED = [
    (lambda: fall(PARTS), "parted"),
    (fall, "above breaking load"),
    (lambda: apply_overrides(rw.preset("r4"), ["run.duration=1.0"]), "peak may be wrong"),
    (lambda: swing(0.1), "end weight"),
    (lambda: apply_overrides(swing(0.1), ["run.extremes=false"]), "end weight"),
    (lambda: apply_overrides(rw.preset("hanging-rope"), ["run.duration=0.3"]), "push"),
    (
        lambda: apply_overrides(
            rw.preset("r4"), ["run.duration=1.0", "run.method=implicit-euler", "run.time_step=0.02"]
        ),
        "peak may be too low",
    ),
    (lambda: frames_only(dropped()), "landing not shown"),
    (lambda: frames_only(fallen(post=False)), "force between frames"),
    (lambda: frames_only(fallen(post=True)), "force between frames"),
    (lambda: fallen(post=True), "peak may be wrong"),
    (lambda: fallen(post=True).replace(**{"rope.segments": 6, "run.duration": 0.4}), "long segments"),
    (disc, "energy not kept"),
]  # fmt: skip


@pytest.mark.parametrize(("make", "kind"), NOTED)
def test_a_run_is_noted_as_its_table_warns(make: object, kind: str) -> None:
    result = rw.simulate(make())  # type: ignore[operator]
    assert set(kinds(result)) == kinds_of_table(result)
    assert kind in kinds(result)
    assert list(kinds(result)) == [one for one in KINDS if one in kinds(result)]


def test_a_rope_that_parts_is_noted_in_every_run_and_counted(tmp_path: Path) -> None:
    masses = [60.0, 80.0, 100.0]
    ds = rw.sweep(fall(PARTS), {MASS: masses}, store=tmp_path / "s", on="here", progress=False)
    own = [rw.simulate(fall(PARTS, f"{MASS}={mass}")) for mass in masses]
    assert [bool(one.partings) for one in own] == ["parted" in text for text in ds.notes.values]
    assert ds.notes.values.tolist() == [BETWEEN.join(kinds(one)) for one in own]
    told = summary(SweepFolder.open(tmp_path / "s"))
    assert told["notes"]["parted"] == 3
    words = dict(noted(told["notes"], told["ended well"]))["parted"]
    assert words == "3 of 3 runs parted: their largest tension is where they parted"
    whole = rw.sweep(fall(), {MASS: masses}, on="here", progress=False)  # the twin does not part
    assert not any("parted" in text for text in whole.notes.values)
    assert all("above breaking load" in text for text in whole.notes.values)


def test_a_run_that_breaks_has_a_reason_and_no_note(tmp_path: Path) -> None:
    here = rw.sweep(swing(), {EA: STIFF}, on="here")
    there = rw.sweep(swing(), {EA: STIFF}, on="here", store=tmp_path / "s")
    assert here.notes.values.tolist() == there.notes.values.tolist()
    assert list(here.status.values) == ["finished", "finished", "broke"]
    assert [bool(text) for text in here.notes.values] == [True, True, False]
    assert here.notes.attrs == there.notes.attrs
    frame = here[["tension_max", "status", "notes"]].to_dataframe()
    assert "end weight" in frame.to_csv()


def test_bands_say_what_their_runs_are_noted_for() -> None:
    spread = {MASS: (72.0, 88.0)}
    found = rw.uncertain(fall(PARTS), spread, samples=4, seed=1, on="here", progress=False)
    assert found.notes["parted"] == found.sample
    assert f"{found.sample} of {found.sample} runs parted: their largest tension" in found.note
    whole = rw.uncertain(rw.preset("climbing-fall"), spread, samples=4, seed=1, on="here")
    assert "parted" not in whole.note


def test_a_function_has_the_notes_of_its_last_runs() -> None:
    with rw.sweep.function(fall(PARTS), [MASS], ["tension.max"]) as f:
        f([[80.0], [90.0]])
        assert all("parted" in kinds_in(text) for text in f.last.notes)


def test_an_equilibrium_is_noted_as_its_table_warns() -> None:
    scene = rw.preset("hanging-rope")
    ds = rw.sweep(scene, {"rope.length": [11.0, 12.0]}, what="rest", on="here")
    for length, text in zip(ds.length.values.tolist(), ds.notes.values.tolist(), strict=True):
        own = rw.equilibrium(apply_overrides(scene, [f"rope.length={length}"]))
        assert set(kinds_in(text)) == kinds_of_table(own)
    assert ds.notes.values[0]


def test_a_sweep_made_before_there_were_notes_opens_and_goes_on(tmp_path: Path) -> None:
    """Of format 3: no column, no count, no file; the rest to the bits of a new one."""
    ask = {"on": "here", "batch": 1, "keep": "tension.max"}
    new = rw.sweep(swing(), {EA: STIFF[:2]}, store=tmp_path / "new", **ask)
    with of_format(3):
        old = rw.sweep(swing(), {EA: STIFF[:2]}, store=tmp_path / "old", **ask)
    assert "notes" not in old
    assert old.tension_max.values.tolist() == new.tension_max.values.tolist()
    folder = SweepFolder.open(tmp_path / "old")
    folder.unmark([1])
    again = rw.sweep.resume(tmp_path / "old", on="here")
    assert again.tension_max.values.tolist() == new.tension_max.values.tolist()
    told = summary(SweepFolder.open(tmp_path / "old"))
    assert told["notes"] is None
    assert not any("notes" in name for name in store_bytes(tmp_path / "old"))
    assert json.loads((tmp_path / "old" / "sweep.json").read_text())["format"] == 3


def test_utilisation_and_safety_factor_are_those_of_the_table() -> None:
    keep = ["utilisation.max", "safety_factor.min", "utilisation.max[time]"]
    ds = rw.sweep(fall(), {MASS: [60.0, 90.0]}, keep=keep, on="here", progress=False)
    for mass in (60.0, 90.0):
        table, at = rw.simulate(fall(f"{MASS}={mass}")).table, ds.sel(mass=mass)
        share = table["largest utilisation of the breaking load [%]"]
        assert float(at.utilisation_max) == pytest.approx(share / 100.0, rel=1e-14)
        assert float(at.utilisation_max_time.max()) == float(at.utilisation_max)
        factor = table["least safety factor [1]"]
        assert float(at.safety_factor_min) == pytest.approx(factor, rel=1e-14)
    assert ds.utilisation_max.attrs["units"] == "1"


def test_utilisation_at_rest_is_what_the_anchor_bears() -> None:
    scene = apply_overrides(rw.preset("suspension-cable"), ["rope.made_of.breaking_load=1e6"])
    keep = ["utilisation.max", "safety_factor.min"]
    ds = rw.sweep(scene, {"gravity[2]": [-9.81]}, keep=keep, what="rest", on="here")
    table = rw.equilibrium(scene).table
    share = table["largest utilisation of the breaking load [%]"] / 100.0
    assert ds.utilisation_max.item() == pytest.approx(share, rel=1e-14)
    assert ds.safety_factor_min.item() == pytest.approx(1.0 / share, rel=1e-14)


def test_utilisation_needs_a_breaking_load() -> None:
    with pytest.raises(rw.SceneError, match="no rope has a breaking_load"):
        rw.sweep(swing(), {EA: [1e3, 2e3]}, keep="utilisation.max", on="here")


def test_a_rope_without_a_breaking_load_has_no_utilisation_at_rest() -> None:
    """It had 0, which was the least of all segments, and counted in their mean."""
    stuff = {"EA": 1e5, "mass_per_length": 0.1}
    ropes = [
        rw.Rope(
            name=name, segments=4, length=2.0, made_of=rw.Material(**stuff, breaking_load=load),
            shape={"kind": "hanging", "start": (x, 0, 0)}, loads=[{"node": -1, "mass": 50.0}],
        )
        for x, (name, load) in enumerate({"a": None, "b": 2000.0}.items())
    ]  # fmt: skip
    anchors = [{"rope": name, "node": 0} for name in "ab"]
    keep = ["utilisation.min", "utilisation.mean", "safety_factor.max"]
    two = rw.Scene(ropes=ropes, anchors=anchors)
    one = rw.Scene(ropes=ropes[1:], anchors=anchors[1:])
    for scene in (two, one):
        ds = rw.sweep(scene, {"gravity[2]": [-9.81]}, keep=keep, what="rest", on="here")
        least, most = 9.81 * (50.0 + 0.025) / 2000.0, 9.81 * (50.0 + 0.2) / 2000.0
        assert ds.utilisation_min.item() == pytest.approx(least)
        assert least < ds.utilisation_mean.item() < most
        assert ds.safety_factor_max.item() == pytest.approx(1.0 / least)


def test_a_landing_that_short_steps_show_on_an_obstacle_is_not_noted() -> None:
    result = rw.simulate(dropped(step=2e-5, frame_rate=5e4))
    assert landings_of(result)
    assert result.table["largest force on an obstacle [N]"] > 100.0
    assert "landing not shown" not in kinds(result)


def test_a_force_that_rises_between_frames_is_noted_in_every_run_of_a_sweep() -> None:
    """A single run's table told it, a sweep's runs did not. The twin: a frame for every step."""
    scene = frames_only(fallen(post=True))
    found = rw.sweep(scene, {"rope.made_of.EA": [5e4, 1e5]}, on="here", progress=False)
    assert all("force between frames" in kinds_in(text) for text in found.notes.values)
    fine = scene.replace(**{"run.frame_rate": 500.0})
    assert "force between frames" not in kinds(rw.simulate(fine))


def test_what_check_warns_of_long_segments_is_noted_in_a_sweep() -> None:
    scene = fallen(post=True).replace(**{"run.duration": 0.1})
    found = rw.sweep(scene, {"rope.segments": [6, 12, 30]}, on="here", progress=False)
    assert ["long segments" in kinds_in(text) for text in found.notes.values] == [True, True, False]
    along = scene.replace(obstacles=disc().obstacles)
    assert "long segments" not in kinds(rw.simulate(along))
    turned = along.replace(**{"obstacle.start": (-0.01, 0, 0), "obstacle.end": (0.01, 0, 0)})
    assert "long segments" in kinds(rw.simulate(turned))
    said = dict(noted({"long segments": 2}, 3))["long segments"]  # a box has no radius
    assert said.startswith("2 of 3 runs have segments long about an obstacle (see check)")


def test_a_force_at_its_largest_in_the_first_frame_looked_at_is_seen_against_the_one_before() -> (
    None
):
    """It was taken for its own frame before: the table told of it, the sweep did not."""
    made_of = rw.Material(EA=1e4, mass_per_length=0.1)
    ropes = [
        rw.Rope(
            name=name, segments=4, length=0.3, diameter=0.01, made_of=made_of,
            shape={"kind": "straight", "start": (x - 0.15, 0, z), "end": (x + 0.15, 0, z)},
        )
        for name, x, z in (("a", 0.0, 0.5), ("b", 1.0, 0.4))
    ]  # fmt: skip
    balls = [{"kind": "sphere", "center": (x, 0, 0), "radius": 0.1} for x in (0.0, 1.0)]
    run = {"duration": 0.5, "frame_rate": 20, "method": "implicit-euler", "time_step": 5e-4}
    result = rw.simulate(rw.Scene(ropes=ropes, obstacles=balls, run=run | {"extremes": False}))
    assert (
        "from 0 % of it one frame before" in result.table["about the largest force on an obstacle"]
    )
    assert "force between frames" in kinds(result)
