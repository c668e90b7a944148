"""What is kept of a run is what the run itself says."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Load, Material, Plane, Rope, Scene, Slack, Straight, Winch
from ropewalk.sweeps.derived import DERIVED
from ropewalk.sweeps.keep import parse
from sweeps.scenes import swing

CORD = Material(EA=2e4, mass_per_length=0.2, axial_damping=20.0)


@pytest.mark.parametrize("end", ["start", "end"])
def test_the_sag_of_a_rope_on_a_winch_has_what_is_paid_out(end: str) -> None:
    """Below the line between its ends, not below one to where the first rope has gone."""
    rope = Rope(segments=12, length=6.6, made_of=CORD, shape=Slack(end=(6.0, 0, 0)))
    anchors = [Anchor(name="left", node=0), Anchor(name="right", node=-1)]
    run = {"duration": 2.0, "frame_rate": 20.0, "method": "sdirk2", "time_step": 0.01}
    scene = Scene(ropes=[rope], anchors=anchors, winches=[Winch(end=end, speed=1.0)], run=run)
    result = rw.simulate(scene)
    sag = DERIVED["sag"].of(result)[:, 0]
    assert sag == pytest.approx(-result.positions[:, :, 2].min(axis=1), rel=1e-6)
    assert sag[-1] > 1.4 * sag[0]


def test_works_of_contacts_are_since_the_start() -> None:
    """A rope that lies in the ground from the beginning has stored work there."""
    low = Straight(start=(0, 0, 0.005), end=(1.0, 0, 0.005))
    rope = Rope(segments=4, length=1.0, diameter=0.01, made_of=CORD, shape=low)
    run = {"duration": 0.02, "frame_rate": 100.0, "method": "sdirk2", "start": "at-rest"}
    floor = Plane(name="floor", friction=0.3)
    result = rw.simulate(Scene(ropes=[rope], obstacles=[floor], run=run))
    assert result.read("contact_work", 0, 1).any()
    kept, _ = parse("contact_work[-1]").of(result)
    said = [array[-1] for array in result.contact_work["floor"].values()]
    np.testing.assert_array_equal(kept[0], said)


def hung(frame_rate: float, speed: float, segments: int = 5) -> rw.Result:
    """A kilogram that falls into 1 m of cord, which parts; or on a winch, which stops [m/s]."""
    weak = {} if speed else {"breaking_load": 15.0, "parts": True}
    cord = Material(EA=2e3, mass_per_length=0.1, axial_damping=1.0, **weak)
    down = Straight(start=(0, 0, 0), direction=(0, 0, -1))
    load = Load(node=-1, mass=1.0)
    rope = Rope(segments=segments, length=1.0, made_of=cord, shape=down, loads=[load])
    winch = Winch(end="start", speed=speed, stop=0.5, min_length=0.2)
    run = {"method": "esdirk3", "time_step": 0.005, "duration": 0.5, "frame_rate": frame_rate}
    more = {"winches": [winch]} if speed else {}
    return rw.simulate(Scene(ropes=[rope], anchors=[Anchor(node=0)], run=run, **more))


@pytest.mark.parametrize("frame_rate", [2.0, 8.0, 100.0])
@pytest.mark.parametrize("speed", [0.0, -0.8])
def test_what_parts_or_is_reeled_in_between_two_frames_has_its_peak(
    speed: float, frame_rate: float
) -> None:
    """What carried the most is gone when the next frame is recorded; tables have always told it."""
    result = hung(frame_rate, speed)
    there = result.table["largest tension [N]"], result.table["least tension [N]"]
    kept = [float(parse(text).of(result)[0]) for text in ("tension.max", "tension.min")]
    np.testing.assert_array_equal(kept, there)
    assert float(parse("stretch.max").of(result)[0]) == result.table["largest stretch [1]"]
    gone = result.live[0] & ~result.live[-1]
    assert gone.any()
    of_each, _ = parse("tension.max[segment]").of(result)
    assert (of_each[gone] > 5.0).all()
    np.testing.assert_array_equal(of_each[~result.live.any(axis=0)], np.nan)


PICKED = [
    ("tension[:,3].max", lambda r: r.greatest_tension[:, 3].max()),
    ("tension[:,0].max[time]", lambda r: r.greatest_tension[:, 0]),
    ("elastic_tension[:,-1].max", lambda r: r.elastic_tension[:, -1].max()),
    ("tension[-1].max", lambda r: r.tension[-1].max()),
]


@pytest.mark.parametrize(("text", "own"), PICKED)
def test_one_segment_or_frame_is_kept_as_the_run_has_it(text: str, own: object) -> None:
    result = rw.simulate(swing(0.1))
    kept, _ = parse(text).of(result)
    np.testing.assert_array_equal(kept, own(result))  # type: ignore[operator]


def test_what_is_kept_of_a_part_is_named_by_the_part() -> None:
    assert parse("tension[-1].max").long_name == "largest tension (tension[-1].max)"
    name = "largest anchor's force on the rope (reactions[:,top,1].max), over the recorded frames"
    assert parse("reactions[:,top,1].max").long_name == name
    assert parse("tension.max").long_name == "largest tension, over all steps"
