"""Anchors that stop, turn back or let go at once break no damped rope and make up no energy.

Before steps in which friction gives energy were taken in parts, 8 of the first 120 did in steps of esdirk3.

`ROPEWALK_STOPPING_SCENES=1000` runs that many; by default 120, which takes half a minute.
"""

from __future__ import annotations

import os

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.record.balances import weight_times_length
from verification.stopping_scenes import METHODS, stopping_scene

SCENES = int(os.environ.get("ROPEWALK_STOPPING_SCENES", "120"))
MOST = (
    0.25  # [1] of the energy turned over, the anchors' works, or weight times length; 0.14 was seen
)
TORN = "so this is not the method"  # the anchors pulled it apart, every joule accounted for


def made_up(result: rw.Result) -> float:
    """Return the largest rise of the energy that anchors did not give, over what there is [1].

    Friction, whatever is booked for it, can only take.
    """
    good = result.good_frames
    total, work = result.energy["total"][:good], result.work
    given: Floats = sum((w[:good] for name, w in work.items() if "anchor:" in name), np.zeros(good))
    left = total - given
    rise = float((left - np.minimum.accumulate(left)).max())
    turned = max(np.ptp(part[:good]) for part in result.energy.values())
    size = max(float(turned), np.abs(given).max(), weight_times_length(result.scene))
    return rise / size if size > 0.0 else 0.0


@pytest.mark.slow
def test_sudden_stops_break_nothing_and_make_up_no_energy() -> None:
    broke, gained, torn = {}, {}, 0
    for seed in range(SCENES):
        result = rw.simulate(stopping_scene(seed), on_failure="return")
        torn += TORN in result.diagnosis
        if result.status != "finished" and TORN not in result.diagnosis:
            broke[seed] = result.diagnosis
        if (share := made_up(result)) > MOST:
            gained[seed] = f"{result.plan.method}: {share:.3g}"
    assert broke == {}
    assert gained == {}
    assert torn < 0.05 * SCENES


@pytest.mark.slow
def test_the_scenes_stop_and_let_go_under_stiff_friction() -> None:
    """All methods are there, and what the scenes are for. The twin: an unstable step makes energy up."""
    scenes = [stopping_scene(seed) for seed in range(len(METHODS) * 10)]
    assert {scene.run.method for scene in scenes} == set(METHODS)
    held = [anchor for scene in scenes for anchor in scene.anchors]
    assert {"velocity", "table"} <= {anchor.motion.kind for anchor in held}
    assert any(anchor.release_time is not None for anchor in held)
    assert {rope.made_of.friction for s in scenes for rope in s.ropes} == {"vector", "axial"}
    assert made_up(rw.simulate(scenes[0], on_failure="return")) < MOST
    step = 3e-4  # [s], which explicit Euler does not hold there
    run = {"method": "euler", "time_step": step, "frame_rate": 1.0 / step, "duration": 30 * step}
    assert made_up(rw.simulate(scenes[2].replace(run=run), on_failure="return")) > MOST
