"""What a winch's own segment carries, in steps in which it winds much of a segment's strain."""

from __future__ import annotations

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.methods.registry import METHODS
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Winch

EA, LINE, LOAD, g = 2e5, 0.3, 50.0, 9.80665  # N, kg/m, kg, m/s^2
IMPLICIT = [name for name, method in METHODS.items() if method.implicit and method.fixed]
WORK = -0.41  # J, by implicit Euler in steps of 1/240 to 1/3840 s
RINGING = ("implicit-midpoint", "generalized-alpha")  # take long to damp the start
EXPLICIT = [name for name, method in METHODS.items() if not method.implicit]


def hoisted(method: str, speed: float, **run: object) -> rw.Result:
    """A load of 50 kg on 5 m of rope that goes up or down at `speed` [m/s], well damped."""
    rope = Rope(
        segments=10,
        length=5.0,
        made_of=Material(EA=EA, mass_per_length=LINE, axial_damping=2000.0),
        shape={"kind": "hanging"},
        loads=[{"node": -1, "mass": LOAD}],
    )
    settings = {"duration": 4.0, "frame_rate": 60.0, "start": "at-rest", "extremes": False, **run}
    return rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            winches=[Winch(end="start", speed=speed, start=0.0)],
            gravity=(0.0, 0.0, -g),
            run=RunSettings(method=method, **settings),
        )
    )


def readings(result: rw.Result) -> tuple[np.ndarray, np.ndarray]:
    """Tension of the segment at the drum, and the weight below its middle, per frame of the last half [N]."""
    late = result.time > 0.5 * result.time[-1]
    lengths, tension = result.rest_length[late], result.tension[late]
    own = (lengths > 0.0).argmax(axis=1)
    rows = np.arange(len(own))
    below = LOAD + LINE * (lengths.sum(axis=1) - 0.5 * lengths[rows, own])
    return tension[rows, own], g * below


@pytest.mark.parametrize("speed", [-0.5, 0.5])
@pytest.mark.parametrize("method", [*IMPLICIT, "adaptive"])
def test_a_load_on_its_way_weighs_what_it_weighs(method: str, speed: float) -> None:
    """In steps of 1/60 s, in each of which the winch winds some 2 to 8 kN of the segment's stiffness."""
    steps = {"tolerance": 1e-4} if method == "adaptive" else {"time_step": 1.0 / 60.0}
    tension, weight = readings(hoisted(method, speed, **steps))
    assert 4.0 * weight.max() < EA * 0.5 / 60.0 / 0.8  # what one step winds
    assert abs(tension.mean() - weight.mean()) < 0.01 * weight.mean()
    if method not in RINGING:
        assert np.abs(tension - weight).max() < 0.25 * weight.max()


def test_explicit_methods_read_the_same() -> None:
    """As that of Euler, which acts with what it records: read after a turn it would be half of that more."""
    dt = 1e-5
    steps = {"time_step": dt, "duration": 1.0, "frame_rate": 1000.0}
    means = {name: readings(hoisted(name, -0.5, **steps))[0].mean() for name in EXPLICIT}
    for name, mean in means.items():
        assert abs(mean - means["semi-implicit-euler"]) < 0.005 * EA * 0.5 * dt / 0.5, name


@pytest.mark.parametrize("speed", [-0.3, 0.3])
@pytest.mark.parametrize("method", [name for name in METHODS if METHODS[name].holds_links])
def test_a_load_at_the_bound_of_the_stretch_weighs_what_it_weighs(
    method: str, speed: float
) -> None:
    """In every frame, those in which a node comes off the drum, too: with `bdf2` the new segment read what
    its spring alone carries at the bound, 100 N for 495.
    """
    rope = Rope(
        segments=20,
        length=4.0,
        made_of=Material(EA=5000.0, mass_per_length=0.1, axial_damping=50.0),
        shape={"kind": "straight", "end": (0.0, 0.0, -4.08)},
        loads=[{"node": -1, "mass": LOAD}],
    )
    pace = {"time_step": 1.0 / 60.0} if METHODS[method].fixed else {"tolerance": 1e-4}
    result = rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0)],
            winches=[Winch(end="start", speed=speed)],
            limiter={"min_stretch": 0.5, "max_stretch": 1.02},
            gravity=(0.0, 0.0, -g),
            run=RunSettings(method=method, duration=3.0, frame_rate=60.0, **pace),
        )
    )
    lengths, tension = result.rest_length[30:], result.tension[30:]
    own, rows = (lengths > 0.0).argmax(axis=1), np.arange(len(lengths))
    assert len(set(own)) > 3
    below = LOAD + 0.1 * (lengths.sum(axis=1) - 0.5 * lengths[rows, own])
    assert tension[rows, own] == pytest.approx(g * below, rel=3e-3)


@pytest.mark.parametrize("method", ["implicit-euler", "sdirk2", "bdf2", "esdirk3"])
def test_the_winch_does_the_work_of_the_force_at_its_drum(method: str) -> None:
    """A stiff rope between two points, paid out by 1.25 mm a step, forty times its strain: the work is the
    drum's force times the speed, to what the steps leave of it. (Booked at either end of a step with the
    whole change of length it was -12.5 J, at the mean places of the nodes -0.18; the twin with a hundredth of
    the stiffness never was.)
    """
    for stiff in (1e6, 1e4):
        rope = Rope(
            segments=20,
            length=2.0,
            made_of=Material(EA=stiff, mass_per_length=0.1, axial_damping=1e-4 * stiff),
            shape={"kind": "slack", "end": (1.8, 0, 0)},
        )
        result = rw.simulate(
            Scene(
                ropes=[rope],
                anchors=[Anchor(node=0), Anchor(node=-1)],
                winches=[Winch(rope="rope", end="start", speed=0.3)],
                run=RunSettings(method=method, duration=1.0, time_step=1 / 240, frame_rate=240.0),
            )
        )
        if method == "implicit-euler":  # the others let the drum's force ring
            force = np.linalg.norm(result.reactions[:, 0], axis=1)
            assert -0.3 * np.trapezoid(force[2:], result.time[2:]) == pytest.approx(WORK, abs=0.01)
        found = float(result.work["winch"][-1] - result.work["winch"][2])
        assert found == pytest.approx(WORK, abs=0.025), stiff


@pytest.mark.parametrize("speed", [-0.05, 0.05])
def test_strain_energy_is_let_go_on_the_drum(speed: float) -> None:
    """At a tenth of strain e the work is that of T (1 + e / 2), not of T, nor of T (1 + e)."""
    EA = 1e4
    rope = Rope(
        segments=20,
        length=2.0,
        made_of=Material(EA=EA, mass_per_length=0.1, axial_damping=2.0),
        shape={"kind": "straight", "end": (2.2, 0, 0)},
    )
    result = rw.simulate(
        Scene(
            ropes=[rope],
            anchors=[Anchor(node=0), Anchor(node=-1)],
            winches=[Winch(rope="rope", end="start", speed=speed)],
            gravity=(0, 0, 0),
            run=RunSettings(method="rk4", duration=0.5, frame_rate=1000.0),
        )
    )
    drum = (result.rest_length > 0.0).argmax(axis=1)
    pull = result.tension[np.arange(len(drum)), drum]
    work = {
        part: np.trapezoid(-speed * pull * (1.0 + part * pull / EA), result.time)
        for part in (0.0, 0.5, 1.0)
    }
    assert result.work["winch"][-1] == pytest.approx(work[0.5], rel=3e-4)
    assert min(abs(work[part] / work[0.5] - 1.0) for part in (0.0, 1.0)) > 0.04


def test_a_drum_that_takes_in_a_slack_rope_does_the_work_of_the_lift() -> None:
    """Where steps begin slack and end taut, too. Booked half at the places of either end it was 2770 J with
    `sdirk2` and 4560 J with `adaptive`; what is in no law's work is as little as what the steps leave.
    """
    slow = {"run.duration": 0.6, "run.time_step": 1 / 60}
    scene = rw.preset("crane-snap")
    lift = rw.simulate(scene.replace(**{"run.duration": 0.6})).work["winch"][-1]
    for method in ("sdirk2", "adaptive"):
        found = rw.simulate(scene.replace(**slow, **{"run.method": method}))
        assert found.work["winch"][-1] == pytest.approx(lift, rel=0.003), method
        assert abs(found.table["largest energy error [J]"]) < 0.003 * lift, method


@pytest.mark.parametrize("method", ["rk4", "sdirk2"])
def test_what_comes_off_a_drum_has_not_been_slack(method: str) -> None:
    """Paid out at 0.1 m/s the load swings by v sqrt(k m), 141 N of 490, once the jolt of the start is over. A
    segment that came off the drum between two frames was counted with the 0 N that it carried there.
    """
    result = hoisted(method, 0.1, extremes=True)
    live, late = result.rest_length > 0.0, result.time > 0.5
    assert (np.diff(live[late].sum(axis=1)) > 0).any()
    assert result.least_tension[late][live[late]].min() > LOAD * g - 160.0
    assert result.table["least tension [N]"] > 0.0
    assert (result.least_tension[~live] == 0.0).all()
