"""Rows of forces that steps or frames do not show say so, each on its own, whatever comes after."""

from __future__ import annotations

import re

import pytest

import ropewalk as rw
from ropewalk.record.landings import hardest_landing

FLOOR, HAND = "about the largest force on an obstacle", "about the largest anchor force"
ENERGY, PULL = "about the energy", "about the largest tension"


def pile(**run: float) -> rw.Result:
    """The preset in which a cord's end comes down at 0.3 m/s, and no more of it unless asked for."""
    return rw.simulate(rw.preset("pile").replace(**{"run.duration": 0.1} | run))


def test_what_a_landing_gives_at_least_is_told_of_floor_and_hand() -> None:
    """Steps of 4 ms had 0.15 and 0.17 N. The twin: steps and frames that show it, and more than was told."""
    coarse = pile().table
    least = {
        row: float(re.findall(r"too low: it was ([\d.]+) N at least", coarse[row])[0])
        for row in (FLOOR, HAND)
    }
    assert "1.47 N where nothing gives" in coarse[FLOOR]
    assert "may be far too low" in coarse[PULL]
    fine = pile(**{"run.time_step": 1 / 7680, "run.frame_rate": 7680}).table
    force = {
        FLOOR: fine["largest force on an obstacle [N]"],
        HAND: fine["largest anchor force [N]"],
    }
    for row, told in least.items():
        assert coarse[row.removeprefix("about the ") + " [N]"] < 0.3 * told < 0.3 * force[row]
        assert "too low: it was" not in fine.get(row, "")


def test_frames_that_are_too_far_apart_for_a_hit_say_so() -> None:
    """Steps show 4 N of it, frames 0.17 N."""
    table = pile(**{"run.time_step": 1 / 3840}).table
    assert "between two frames there may be far more" in table[FLOOR]
    assert table["largest anchor force [N]"] > 4.0


def test_a_landing_of_a_rope_that_cannot_push_is_none() -> None:
    """No wave of compression runs up it. The twin: the same cord, which pushes."""
    assert hardest_landing(pile()) is not None
    cord = rw.Material(EA=1e3, mass_per_length=0.025, axial_damping=0.05, tension_only=True)
    scene = rw.preset("pile").replace(**{"run.duration": 0.1, "rope.made_of": cord})
    slack = rw.simulate(scene)
    assert hardest_landing(slack) is None


def test_a_hit_that_a_long_run_makes_small_is_told_all_the_same() -> None:
    """4.5 % of all that it turns over, and 80 % of what there was then."""
    table = rw.simulate(rw.preset("pile")).table
    assert table["largest energy error, share of the energy turned over [%]"] < 5.0
    assert "J of it came within one frame, before t = 0.0333333 s" in table[ENERGY]


@pytest.mark.parametrize("name", ["r3", "r8", "wave-on-a-string"])
def test_smooth_runs_tell_no_hit(name: str) -> None:
    scene = rw.preset(name)
    for method in (scene.run.method, "implicit-euler"):
        run = {"run.duration": min(scene.run.duration, 1.0), "run.method": method}
        table = rw.simulate(scene.replace(**run)).table
        assert "came within one frame" not in table.get(ENERGY, "")
        assert ("see the largest tension" in table.get(HAND, "")) <= (PULL in table)
