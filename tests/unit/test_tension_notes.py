"""Tables say when a largest tension is a jerk that the steps hardly resolve, and what a negative one is."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.record.tension_notes import is_pressed, wave_time
from ropewalk.scene import Plane, Straight

MEAN = "about the largest anchor force"
JERK, PUSH = "about the largest tension", "about the least tension"


def peak(result: rw.Result) -> float:
    return float(result.table["largest tension [N]"])


def test_a_snap_in_steps_too_long_for_it_says_how_good_its_peak_is() -> None:
    scene = rw.preset("r4")
    coarse = rw.simulate(scene)
    text = coarse.table[JERK]
    assert "a jerk" in text
    assert "a wave takes 2.24 ms through a segment, a step 1.85 ms" in text
    assert "time_step = 0.000926 s" in text
    half = rw.simulate(scene.replace(**{"run.time_step": 0.5 * coarse.plan.dt}))
    assert peak(half) > 1.15 * peak(coarse)  # what the sentence is for
    # steps that resolve the jerk have no note, and hardly change with half of them
    fine = rw.simulate(scene.replace(**{"run.time_step": wave_time(scene.ropes[0]) / 12.0}))
    assert "a jerk" not in fine.table.get(JERK, "")
    finer = rw.simulate(scene.replace(**{"run.time_step": wave_time(scene.ropes[0]) / 24.0}))
    assert peak(finer) == pytest.approx(peak(fine), rel=0.02)


@pytest.mark.parametrize("name", ["r3", "r8", "power-line-in-wind", "wave-on-a-string", "zip-line"])
def test_smooth_runs_have_no_such_note(name: str) -> None:
    scene = rw.preset(name)
    coarse = rw.simulate(scene.replace(**{"run.duration": min(scene.run.duration, 2.5)}))
    assert "a jerk" not in coarse.table.get(JERK, "")
    half = rw.simulate(coarse.scene.replace(**{"run.time_step": 0.5 * coarse.plan.dt}))
    assert peak(half) == pytest.approx(peak(coarse), rel=0.005)


def test_a_peak_that_comes_smoothly_has_none_though_the_rope_goes_slack_after_it() -> None:
    """The chain's tension grows to its largest over its whole fall."""
    assert "a jerk" not in rw.simulate(rw.preset("falling-chain")).table.get(JERK, "")


def test_a_chain_that_falls_free_carries_no_jerk_but_rounding() -> None:
    """Onto a floor, link by link: nothing pulls, and what rounding leaves (1e-11 N) is no peak."""
    made_of = rw.Material(EA=1e3, mass_per_length=0.5, axial_damping=0.05, tension_only=True)
    chain = rw.Rope(
        segments=50,
        length=1.0,
        diameter=0.005,
        made_of=made_of,
        shape=Straight(start=(0, 0, 1.0025), end=(0, 0, 0.0025)),
    )
    run = {"method": "esdirk3", "duration": 0.2, "frame_rate": 100, "time_step": 1e-3}
    result = rw.simulate(rw.Scene(ropes=[chain], obstacles=[Plane()], run=run))
    assert 0.0 < peak(result) < 1e-9
    assert "a jerk" not in result.table.get(JERK, "")


def test_a_negative_tension_says_what_pushes() -> None:
    damped = {"rope.made_of": "dynamic-single-9.8"}
    fall = rw.simulate(rw.preset("climbing-fall").replace(**damped))
    assert fall.table["least tension [N]"] < -100.0
    assert fall.table[PUSH].startswith("negative: the push of the friction along a taut rope")
    assert (fall.elastic_tension >= 0.0).all()  # as the sentence says
    springs = rw.simulate(rw.preset("r4"))
    assert "tension_only = true lets it go slack" in springs.table[PUSH]
    assert "its spring and its friction" in springs.table[PUSH]
    assert PUSH not in rw.simulate(rw.preset("r3")).table


def test_the_segment_at_a_drum_reads_what_the_drum_holds() -> None:
    """Steps of 0.12 ms turn the winch by some 1.3 kN of that segment, 4 % of its peak."""
    run = rw.simulate(
        rw.preset("crane-snap").replace(**{"run.duration": 1.0, "run.time_step": 1.2e-4})
    )
    assert "a jerk" not in run.table.get(JERK, "")
    assert peak(run) == pytest.approx(float(run.table["largest anchor force [N]"]), rel=1e-3)


def swinging(end: tuple[float, float, float], segments: int = 20, **run: float | str) -> rw.Scene:
    made_of = rw.Material(EA=2e4, mass_per_length=0.06, axial_damping=5.0)
    rope = rw.Rope(
        segments=segments, length=5.0, made_of=made_of, shape=Straight(start=(0, 0, 0), end=end)
    )
    settings = {"duration": 1.2, "method": "esdirk3", **run}
    return rw.Scene(ropes=[rope], anchors=[rw.Anchor(node=0)], run=settings)


def test_an_anchor_that_gives_less_than_its_segment_bears_says_that_it_is_a_mean() -> None:
    coarse = rw.simulate(swinging((5.0, 0.0, 0.0), time_step=1 / 120))
    assert peak(coarse) > 1.03 * coarse.table["largest anchor force [N]"]
    assert f"bore {peak(coarse):.6g} N" in coarse.table[MEAN]
    fine = rw.simulate(swinging((5.0, 0.0, 0.0), time_step=1 / 1920))
    apart = [abs(peak(run) / run.table["largest anchor force [N]"] - 1.0) for run in (coarse, fine)]
    assert apart[1] < 0.2 * apart[0]  # what the sentence says
    assert MEAN not in rw.simulate(rw.preset("r3")).table


def test_only_what_presses_on_the_anchor_hides_that_its_force_is_a_mean() -> None:
    """A floor far below the swing does not; the twin lies on one. It is 10 % less than fine steps have."""
    far = {"obstacles": [Plane(point=(0, 0, -50.0))], "rope.diameter": 0.01}
    result = rw.simulate(swinging((5.0, 0.0, 0.0), time_step=1 / 120).replace(**far))
    told = result.table[MEAN]
    assert told.startswith("see the largest tension")  # which lacks 5 %
    assert "; the mean over a step" in told
    assert not is_pressed(result, 0, 1.0)
    near = {"obstacles": [Plane(point=(0, 0, -0.005))], "rope.diameter": 0.01, "anchors": []}
    lying = rw.simulate(swinging((5.0, 0.0, 0.0), 5, duration=0.1).replace(**near))
    assert is_pressed(lying, 0, 0.1)
