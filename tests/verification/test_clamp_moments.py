"""Moments on the clamps of taut ropes, at rest: the closed form, and what tables say of coarse segments."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Clamp, Force, Material, Rope, Scene, Straight, Winch

PULL, EI, LENGTH, ACROSS = 5000.0, 50.0, 10.0, 1.0  # N, N m^2, m, N


def pressed(segments: int) -> Scene:
    """A taut rope between two clamps, pressed in its middle."""
    EA = 1e7  # its stretch by the press is nothing
    rope = Rope(
        segments=segments,
        length=LENGTH,
        made_of=Material(EA=EA, EI=EI, mass_per_length=1.0),
        shape=Straight(start=(0, 0, 0), end=(LENGTH * (1 + PULL / EA), 0, 0)),
        forces=[Force(node=segments // 2, force=(0, 0, -ACROSS))],
    )
    clamps = [Anchor(node=node, clamp=Clamp(direction=(1, 0, 0))) for node in (0, -1)]
    return Scene(gravity=(0, 0, 0), ropes=[rope], anchors=clamps, run={"duration": 0.1})


def exact() -> float:
    """P / 2k tanh(kL / 4), k^2 = T / EI (Timoshenko, Strength of Materials II, ch. 2) [N m]."""
    k = math.sqrt(PULL / EI)
    return ACROSS / (2.0 * k) * math.tanh(0.25 * k * LENGTH)


@pytest.mark.parametrize("segments", [20, 40, 100, 200])
def test_a_coarse_taut_rope_says_how_low_the_moment_on_its_clamp_is(segments: int) -> None:
    """Times what the table says it is what a fine rope has, which has nothing to say."""
    table = rw.equilibrium(pressed(segments)).table
    found = re.search(
        r"about ([\d.]+) times as large; (\d+)", table["about the largest clamp moment"]
    )
    assert found
    low = exact() / table["largest clamp moment [N m]"]
    assert low > 1.02
    assert float(found[1]) == pytest.approx(low, rel=5e-3)
    enough = rw.equilibrium(pressed(2 * math.ceil(int(found[2]) / 2))).table
    assert 1.01 < exact() / enough["largest clamp moment [N m]"] < 1.0205
    assert "about the largest clamp moment" not in enough


def test_a_run_and_its_sheet_say_it_too() -> None:
    coarse = pressed(20)
    told = rw.simulate(coarse).table["about the largest clamp moment"]
    assert told.startswith("too low: a rope as taut bends there within 0.1 m")
    assert "The largest moment on a clamp: too low" in str(
        rw.sheet(coarse, convergence=False).as_dict()
    )
    slack = coarse.replace(**{"rope.shape": Straight(start=(0, 0, 0), end=(LENGTH, 0, 0))})
    assert "about the largest clamp moment" not in rw.simulate(slack).table


@pytest.mark.parametrize("aside", [0.0, 0.3])
def test_a_clamp_that_turns_a_curled_rope_out_of_its_plane_is_told(aside: float) -> None:
    """The axis that the rope curls about stays fixed in space, which takes a moment that no clamp gives.

    Within the plane the energy is kept; out of it there is an error that no step makes smaller.
    """
    curled = Material(EA=500.0, EI=0.05, curvature=(0, 0.8, 0), mass_per_length=0.1)
    turns = Clamp(direction=(1, 0, 0), turn_axis=(aside, 1, 0), turn_rate=3.0)
    rope = Rope(segments=8, length=1.0, made_of=curled)
    run = {"method": "verlet", "time_step": 2e-4, "duration": 0.5}
    made = Scene(ropes=[rope], anchors=[Anchor(node=0, clamp=turns)], run=run)
    told = any("a clamp's turn leaves" in words for words in rw.check(made).warnings)
    assert told == (aside > 0.0)
    assert (abs(rw.simulate(made).energy_error).max() > 1e-4) == told


def test_a_clamp_at_a_drum_has_the_segment_that_is_off_it() -> None:
    """What lay beside it at the start is wound up, and has no tension."""
    cord = Material(EA=2e4, EI=0.2, mass_per_length=0.2, axial_damping=20.0)
    rope = Rope(segments=10, length=5.0, made_of=cord, shape=Straight(end=(5.0, 0, 0)))
    drum = Anchor(node=0, clamp=Clamp(direction=(1, 0, 0.5)))
    run = {"duration": 0.9, "frame_rate": 50.0, "method": "rk4"}
    reel = Winch(end="start", speed=-1.0)
    result = rw.simulate(Scene(ropes=[rope], anchors=[drum], winches=[reel], run=run))
    table = result.table
    until = float(table["largest clamp moment at"].split()[-2])
    frame = int(np.searchsorted(result.time, until))
    assert not result.live[frame, 0]
    tension = result.tension[frame, result.live[frame]][0]
    assert table["about the largest clamp moment"].startswith(
        f"too low: a rope as taut bends there within {math.sqrt(0.2 / tension):.3g} m"
    )
