"""Moments on the clamps of taut ropes, at rest: the closed form, and what tables say of coarse segments."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.clamps import bent_energy, start_clamps
from ropewalk.lowering import build
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
    """The axis that the rope curls about stays fixed in space; the clamp's work is right all the same.

    It was booked as if turning all changed no energy: an error that no step made smaller.
    """
    curled = Material(EA=500.0, EI=0.05, curvature=(0, 0.8, 0), mass_per_length=0.1)
    turns = Clamp(direction=(1, 0, 0), turn_axis=(aside, 1, 0), turn_rate=3.0)
    rope = Rope(segments=8, length=1.0, made_of=curled)
    run = {"method": "verlet", "time_step": 2e-4, "duration": 0.5}
    made = Scene(ropes=[rope], anchors=[Anchor(node=0, clamp=turns)], run=run)
    told = any("a clamp's turn leaves" in words for words in rw.check(made).warnings)
    assert told == (aside > 0.0)
    assert abs(rw.simulate(made).energy_error).max() < 1e-4


@pytest.mark.parametrize("curvature", [(0.0, 0.0, 0.0), (0.3, 1.2, -0.4)])
def test_the_moment_of_a_clamp_is_what_the_energy_of_bending_has_by_its_turn(
    curvature: tuple[float, float, float],
) -> None:
    """Against differences of the energy by small turns about three axes, clamps at both ends and between."""
    made_of = Material(EA=1e-3, mass_per_length=0.1, EI=3.0, curvature=curvature)
    ways = {0: (1, 0.2, 0.3), 4: (1, -0.2, 0.1), -1: (1, 0.3, 0.5)}
    model = build(
        Scene(
            gravity=(0, 0, 0),
            ropes=[Rope(segments=8, length=2.0, made_of=made_of)],
            anchors=[Anchor(node=node, clamp=Clamp(direction=way)) for node, way in ways.items()],
        )
    )
    system, state, h = model.system, model.state, 1e-6
    state.x[...] = 0.1 * np.random.default_rng(0).normal(size=state.x.shape)
    state.x[0] += 0.25 * np.arange(9)
    start_clamps(system, state)
    for row in range(3):
        first = state.clamp_direction[row].copy()
        for k, axis in enumerate(np.eye(3)):
            energy = []
            for angle in (h, -h):
                turned = first + angle * np.cross(axis, first)
                state.clamp_direction[row] = turned / np.linalg.norm(turned)
                energy.append(bent_energy(system, state, state.x))
            state.clamp_direction[row] = first
            slope = (energy[0] - energy[1]) / (2.0 * h)
            assert state.moment[row, k] == pytest.approx(slope, abs=1e-6)


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
