"""What a check says before a run."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest

from report_rope import material, scene, warnings
from ropewalk.analysis.check import check
from ropewalk.analysis.cost import seconds_per_step
from ropewalk.api import preset
from ropewalk.lowering import build
from ropewalk.rigging import line
from ropewalk.scene import (
    Anchor,
    Contact,
    Ground,
    Limiter,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Springs,
    Straight,
)
from ropewalk.sheets.content import Text
from ropewalk.sheets.ropes import rope_section
from ropewalk.sheets.trust import PARTED, Variant, _partings
from ropewalk.simulation import Simulation


def test_numbers_of_the_report() -> None:
    found = check(scene(), measure=False)
    assert found.ok
    assert found.steps_per_frame == 9
    assert found.steps == 600 * 9
    assert found.statics.sag[0] == pytest.approx(0.7181, abs=1e-4)
    rope = found.ropes[0]
    assert rope.longitudinal == pytest.approx([math.sqrt(1e4 / 0.05)] * 2)
    # Sideways: between sqrt(H/mu) in the middle and sqrt(T/mu) at the ends (stretch 0.3 %).
    low, high = rope.transverse or (0.0, 0.0)
    assert low == pytest.approx(math.sqrt(34.094 / 0.05), rel=3e-3)
    assert high == pytest.approx(math.sqrt(found.statics.largest_tension / 0.05), rel=3e-3)
    assert low < high
    assert found.warnings == ()
    text = "\n".join(found.lines())
    for word in ("semi-implicit-euler", "2.23", "9 steps", "sag 0.7181 m", "strain 0.3"):
        assert word in text
    assert "rad/s" not in text
    assert "rad/s" in "\n".join(found.lines(all_methods=True))
    again = json.loads(json.dumps(found.as_dict(), allow_nan=False))
    assert again["stability"]["stable"] is True
    assert again["statics"]["spans"][0]["sag"] == pytest.approx(0.7181, abs=1e-4)


def test_a_predicted_break_is_warned_of_with_values() -> None:
    text = warnings(spring_constant=200.0, time_step=1 / 60)
    assert "will break" in text
    assert "spring_constant <= 175 N/m" in text
    assert "time_step <= 0.0156 s" in text
    assert "break" not in warnings(spring_constant=170.0, time_step=1 / 60)


def test_a_small_margin_is_warned_of() -> None:
    assert "the largest stable step is only" in warnings(time_step=0.0022, steps="exact")
    assert "largest stable step" not in warnings(time_step=0.0020, steps="exact")


def test_a_limiter_that_always_acts() -> None:
    # Habrador's rope: 1 + 2.2 * 9.81 / 40 = 1.54 at the top against 1.1.
    habrador = {
        "spring_constant": 40.0,
        "node_mass": 0.2,
        "segments": 6,
        "loads": (Load(node=-1, mass=1.0),),
        "anchors": (Anchor(node=0),),
        "time_step": 0.02,
    }
    text = warnings(limiter=Limiter(min_stretch=0.9, max_stretch=1.1), **habrador)
    assert "acts even at rest, on 6 segments" in text
    assert "1.54" in text
    assert "acts even" not in warnings(
        limiter=Limiter(min_stretch=0.9, max_stretch=1.6), **habrador
    )
    assert "springs that are weak" in warnings(**habrador)


def test_slack_short_and_unheld() -> None:
    short = warnings(shape=Straight(start=(0, 0, 0), end=(18, 0, 0)))
    assert "20 of 20 segments start shorter" in short
    assert "shorter" not in warnings(shape=Straight(start=(0, 0, 0), end=(20, 0, 0)))
    loose = {"gravity": (0, 0, 0), "shape": Straight(start=(0, 0, 0), end=(18, 0, 0))}
    assert "carry no tension" in warnings(**loose)
    assert "nothing holds it; it falls" in warnings(anchors=())
    assert "nothing holds" not in warnings()


def test_one_of_a_kind_is_told_as_one() -> None:
    """It read "1 of 19 segments carry", "1 warnings", "at 1 places" and "1 more ropes are"."""
    links = Springs(spring_constant=1e3, node_mass=0.01, segment_length=0.05, tension_only=True)
    drawn = Straight(start=(0, 0, 0), end=(0.01, 0.0, 0.0))
    loose = Rope(segments=19, made_of=links, shape=drawn)
    found = check(Scene(ropes=[loose], anchors=[Anchor(node=0), Anchor(node=-1)]), measure=False)
    assert "rope 'rope': 1 of 19 segments carries no tension at rest" in found.warnings
    short = loose.replace(segments=1, shape=Straight(start=(0, 0, 0), end=(0.04, 0, 0)))
    text = " ".join(check(Scene(ropes=[short], anchors=[Anchor(node=0)]), measure=False).warnings)
    assert "1 of 1 segments starts shorter than its rest length" in text
    assert repr(replace(found, warnings=found.warnings[:1])).endswith("; 1 warning.")
    assert repr(replace(found, warnings=found.warnings[:1] * 2)).endswith("; 2 warnings.")
    wire = Material(EA=1e6, mass_per_length=0.5)
    assert "rolling free, at 1 place\n" in str(line(20.0, 0.0, wire, sag=1.0).rolling(9, places=1))
    (told,) = _partings(0, [Variant("half the step", {PARTED: 1.0})])
    assert isinstance(told, Text)
    assert told.words == "With half the step ropes part at 1 place, in this sheet at 0."
    many = [loose.replace(name=f"rope-{k}", segments=k + 1) for k in range(7)]
    said = rope_section(Scene(ropes=many)).items[-1]
    assert isinstance(said, Text)
    assert said.words == "1 more rope is in the scene at the end of this sheet."


def test_ground_above_the_rest_shape() -> None:
    """The sag of 0.718 m is held up by a ground at 0.5 m, and left alone by one at 1 m."""
    near, far = (check(scene(ground=Ground(height=-h))) for h in (0.5, 1.0))
    assert near.statics.grounded.sum() > 5
    assert near.statics.sag[0] < 0.6
    assert "nodes lie on the ground" in "\n".join(near.lines())
    assert far.statics.sag[0] == pytest.approx(0.718, abs=1e-3)
    assert "lie on the ground" not in "\n".join(far.lines())
    assert near.statics.solved
    assert "no shape of rest" not in warnings(ground=Ground(height=-0.5))


def test_run_time_is_measured_when_the_kernel_is_there() -> None:
    made = scene(segments=200)
    Simulation(made).step()  # compiles
    found = check(made)
    assert found.seconds_measured
    per_segment = found.seconds / found.steps / 200
    assert 1e-10 < per_segment < 1e-6
    assert not check(made, measure=False).seconds_measured


def test_what_is_not_measured_is_a_range_and_of_contact_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Nineteen presets took 0.44 to 1.5 times the table's time; one with ropes in contact fourteen times."""
    plain = check(preset("r4"), measure=False)
    low, high = (
        plain.run_time.removeprefix("in some ").removesuffix(" (not measured)").split(" to ")
    )
    assert float(high.split()[0]) == pytest.approx(9.0 * float(low.split()[0]), rel=0.1)
    assert plain.as_dict()["estimated_seconds"] == plain.seconds
    for name in ("pulley", "stairs"):
        found = check(preset(name), measure=False)
        assert "in a time that is not known" in str(found)
        assert not found.seconds_known
        assert found.as_dict()["estimated_seconds"] is None
    monkeypatch.setattr("ropewalk.analysis.check.seconds_per_step", lambda *_: (1e-3, True))
    assert "in about 480 ms, at the pace of its first steps;" in str(check(preset("pulley")))
    assert "pace" not in check(preset("r4")).run_time


def test_durations_that_are_no_whole_frames() -> None:
    """Said with the time at which the run ends; the twin is a whole number of frames."""
    said = warnings(duration=1.01, frame_rate=50.0, time_step=0.002)
    assert "run.duration: 1.01 s is no whole number of frames; the run ends at 1 s" in said
    assert "after 50 frames of 0.02 s" in said
    assert "run.duration" not in warnings(duration=1.02, frame_rate=50.0, time_step=0.002)
    # exact steps: 8 steps of 2 ms are a frame of 16 ms, and 63 of these are 1.008 s
    assert "the run ends at 1.008 s" in warnings(duration=1.005, time_step=0.002, steps="exact")
    assert "after 1 frame of 0.02 s" in warnings(duration=1e-3, frame_rate=50.0)


def test_the_warning_of_a_break_says_so_once() -> None:
    said = warnings(time_step=1.0 / 60.0)
    assert said.count("will break") == 1
    assert "first at rope 'rope', node" in said


def test_the_highest_frequency_at_rest_is_below_the_bound_for_any_shape() -> None:
    """Exact for the nearly straight rope of the report: 2 sqrt(k/m) sin(19 pi/40), closed forms 1.1."""
    found = check(scene())
    assert found.highest_at_rest is not None
    exact = 2.0 * math.sqrt(1e4 / 0.05) * math.sin(19 * math.pi / 40)
    assert found.highest_at_rest == pytest.approx(exact, rel=1e-3)
    assert found.highest_at_rest <= found.stability.highest_frequency
    slack = check(scene(shape=Straight(start=(0, 0, 0), end=(8, 0, 0))))
    assert slack.highest_at_rest < 0.999 * slack.stability.highest_frequency
    assert "rad/s about the rest shape" in "\n".join(found.lines(all_methods=True))
    assert check(scene(), measure=False).highest_at_rest is None


def test_a_release_inside_a_step_is_told_where_steps_are_not_cut() -> None:
    """By semi-implicit Euler, and where it is late by more than 1 ms."""

    def said(method: str, step: float, time: float) -> str:
        ends = [Anchor(node=0), Anchor(node=-1, name="far", release_time=time)]
        run = {"method": method, "time_step": step, "duration": 1.0}
        return " ".join(check(Scene(ropes=[material()], anchors=ends, run=run)).warnings)

    text = "'far': release_time = 0.501 s lies inside a step of 16.67 ms; it lets go at 0.516667 s"
    assert text in said("semi-implicit-euler", 1.0 / 60.0, 0.501)
    assert "release_time" not in said("semi-implicit-euler", 1.0 / 60.0, 0.5)
    assert "release_time" not in said("semi-implicit-euler", 0.001, 0.5005)
    for method in ("esdirk3", "adaptive"):
        assert "release_time" not in said(method, 1.0 / 60.0, 0.501)


def test_of_very_many_nodes_no_steps_are_run_for_the_estimate(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two implicit steps of 100 000 nodes took 18 s, of a million minutes."""

    def refuse(self: Simulation, duration: float) -> None:
        raise AssertionError("a step was run")

    monkeypatch.setattr(Simulation, "step", refuse)
    monkeypatch.setattr("ropewalk.analysis.cost.are_compiled", lambda *_: True)
    made_of = Material(EA=1e7, mass_per_length=0.1)
    rope = Rope(segments=20_000, length=1000.0, made_of=made_of, shape=Slack(end=(900.0, 0, 0)))
    ends = [Anchor(node=0), Anchor(node=-1)]
    seconds, measured = seconds_per_step(build(Scene(ropes=[rope], anchors=ends)))
    assert not measured
    assert seconds > 0.0
    assert "(not measured)" in str(check(scene(), measure=False))
    with pytest.raises(AssertionError, match="a step was run"):  # the twin
        seconds_per_step(build(Scene(ropes=[rope.replace(segments=20)], anchors=ends)))


def test_nothing_is_said_of_rest_where_ropes_touch_each_other() -> None:
    """It once said 0 N and 0 % of the breaking load; without contact it says what they are."""
    made_of = Material(EA=1e4, mass_per_length=0.1, breaking_load=1e3)
    rope = Rope(segments=5, length=1.0, diameter=0.01, made_of=made_of, shape=Straight())
    anchors = (Anchor(node=0), Anchor(node=-1))
    run = RunSettings(method="implicit-euler", time_step=0.01)
    apart = check(Scene(run=run, ropes=(rope,), anchors=anchors), measure=False)
    found = check(Scene(run=run, ropes=(rope,), anchors=anchors, contact=Contact()), measure=False)
    assert "at rest: largest tension" in "\n".join(apart.lines())
    assert "at rest:" not in "\n".join(found.lines())
    assert any("is not looked for" in warning for warning in found.warnings)
    told = json.loads(json.dumps(found.as_dict()))
    assert (told["statics"]["largest_tension"], told["statics"]["spans"]) == (None, [])
    assert (told["ropes"][0]["largest_tension"], told["ropes"][0]["utilisation"]) == (None, None)
