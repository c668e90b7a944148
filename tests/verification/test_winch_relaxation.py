"""Ropes that relax on winches: what comes off a drum remembers nothing, what goes on takes its own with it.

The reference is a load on a rope without mass, whose pieces all have the same tension, so that the mean of
their inner strains is enough: D' = L (e - D/L) / tau where rope is paid out, and |speed| D/L less where it is
reeled in.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import ropewalk as rw
from ropewalk.scene import Anchor, Limiter, Load, Material, Rope, RunSettings, Scene, Slide, Winch

EA, ARM, TAU, LOAD, G, END = 2000.0, 3000.0, 0.3, 2.0, 9.81, 0.5  # N, N, s, kg, m/s^2, s
WHOLE = EA + ARM
SPEEDS = pytest.mark.parametrize("speed", [0.6, -0.6])
METHODS = ("sdirk2", "esdirk3", "bdf2", "rk4", "verlet")
FINE = {"sdirk2": 2.5e-3, "esdirk3": 2.5e-3, "bdf2": 1.25e-3, "rk4": 2e-4, "verlet": 2e-4}


def stuff(mass: float = 1e-7, **more: float) -> Material:
    return Material(
        EA=EA, mass_per_length=mass, **{"relaxing_EA": ARM, "relaxation_time": TAU, **more}
    )


def hoist(speed: float, method: str = "esdirk3", step: float = 2.5e-3, **more: object) -> Scene:
    """A load that falls into its rope, which is hauled up or let down."""
    run = {"duration": END, "frame_rate": 20.0, "extremes": False, **more.pop("run", {})}  # type: ignore[dict-item]
    segments = int(more.pop("segments", 4))  # type: ignore[call-overload]
    made_of = more.pop("made_of", stuff(1e-7 if method not in ("rk4", "verlet") else 5e-3))
    rope = Rope(
        segments=segments,
        length=1.0,
        made_of=made_of,
        shape={"kind": "hanging"},
        loads=[Load(node=-1, mass=LOAD)],
    )
    return Scene(
        ropes=[rope],
        anchors=[Anchor(node=0, name="drum")],
        winches=[Winch(end="start", speed=speed)],
        gravity=(0.0, 0.0, -G),
        run=RunSettings(method=method, time_step=step, **run),
        **more,
    )


@cache
def reference(speed: float, fresh: float = 0.0) -> tuple[float, float, float]:
    """Where the load is [m], and what the winch has done and the rope lost [J], by eighth-order steps.

    `fresh` is the share of their strain at rest that pieces have as they come off: the twin has 1.
    """

    def rates(t: float, y: np.ndarray) -> list[float]:
        x, v, sum_d, _, _ = y
        length = 1.0 + speed * t
        e, d = x / length - 1.0, sum_d / length
        tension = EA * e + ARM * (e - d)
        own = fresh * d if speed > 0.0 else d
        there = (tension + ARM * own) / WHOLE  # strain of what comes and goes
        stored = 0.5 * EA * there**2 + 0.5 * ARM * (there - own) ** 2
        power = speed * (stored - (1.0 + there) * tension)
        mixing = max(speed, 0.0) * 0.5 * EA * ARM / WHOLE * (d - own) ** 2
        creep = (e - d) / TAU
        heat = length * ARM * TAU * creep**2 + mixing
        return [v, G - tension / LOAD, length * creep + speed * own, power, heat]

    found = solve_ivp(rates, (0.0, END), [1.0, 0, 0, 0, 0], "DOP853", rtol=1e-11, atol=1e-13)
    return float(found.y[0, -1]), float(found.y[3, -1]), float(found.y[4, -1])


def read(result: rw.Result) -> tuple[float, float, float, float]:
    """The same numbers of a run, and by how much its energy is not what works make it [J]."""
    work = {name: float(values[-1]) for name, values in result.work.items()}
    change = sum(float(v[-1] - v[0]) for name, v in result.energy.items() if name != "total")
    left = change - work["winch"] - work["friction"] - work["anchor:drum"]
    return -float(result.positions[-1, -1, 2]), work["winch"], -work["friction"], left


@SPEEDS
@pytest.mark.parametrize("method", METHODS)
def test_a_load_on_a_solid_is_hauled_as_the_equations_say(method: str, speed: float) -> None:
    """Place, work and heat. The twin: rope that comes off the drum as relaxed as the rest is elsewhere."""
    place, work, heat, left = read(rw.simulate(hoist(speed, method, FINE[method])))
    assert place == pytest.approx(reference(speed)[0], abs=6e-5)
    assert work == pytest.approx(reference(speed)[1], abs=0.03)
    assert heat == pytest.approx(reference(speed)[2], abs=2e-3)
    assert abs(left) < 3e-3
    if speed > 0.0:
        assert abs(reference(speed, 1.0)[0] - reference(speed)[0]) > 2e-4


@SPEEDS
@pytest.mark.parametrize("method", ["sdirk2", "esdirk3"])
def test_it_converges_with_the_method(method: str, speed: float) -> None:
    """Of second order at least, through splits and merges; so does what the books miss."""
    coarse, fine = (read(rw.simulate(hoist(speed, method, step))) for step in (5e-3, 2.5e-3))
    exact = reference(speed)
    for k in range(2):
        assert abs(fine[k] - exact[k]) < 0.4 * abs(coarse[k] - exact[k])
    assert abs(fine[3]) < 0.45 * abs(coarse[3])


def test_new_rope_creeps_as_it_hangs() -> None:
    """At a steady speed the stretch lags behind that at rest by speed (W/EA) (EA1/E) tau E/EA.

    Every piece creeps for itself, with the time tau E/EA, since it came off the drum. The twin: without the
    lag the load is lower by that.
    """
    weight, speed = LOAD * G, 0.02
    run = {"duration": 6.0, "start": "at-rest"}
    result = rw.simulate(hoist(speed, "esdirk3", 1e-2, run=run, made_of=stuff(axial_damping=60.0)))
    lag = speed * weight / EA * ARM / WHOLE * TAU * WHOLE / EA
    deep = -float(result.positions[-1, -1, 2])
    at_rest = (1.0 + speed * 6.0) * (1.0 + weight / EA)
    assert at_rest - deep == pytest.approx(lag, rel=0.02)


@SPEEDS
def test_no_jump_where_segments_are_split_and_merged(speed: float) -> None:
    """Tensions before and after a node comes off or goes on differ by no more than in any other step."""
    simulation = rw.Simulation(hoist(speed, step=1e-3))
    last, jumps, moved = None, [], []
    for _ in range(800):
        simulation.step(1e-3)
        state = simulation.arrays
        there, exits = float(simulation.tension[-1]), int(state.winch_exit[0])
        working = float(simulation.tension[exits])
        if last is not None:
            (moved if exits != last[2] else jumps).append(
                max(abs(there - last[0]), abs(working - last[1]))
            )
        last = there, working, exits
    assert len(moved) >= 2
    assert max(moved) < 1.2 * max(jumps)


def test_what_is_mixed_is_lost_and_never_gained() -> None:
    """A rope pulled unevenly: the books close where pieces of other memories are put together.

    The far end is jerked while rope comes off, so that inner strains differ along it.
    """
    scene = hoist(-0.4, step=1e-3, made_of=stuff(mass=0.5), segments=6)
    simulation = rw.Simulation(scene)
    merged = 0
    for _ in range(300):
        state = simulation.arrays
        exits, heat = int(state.winch_exit[0]), float(state.work.friction.sum())
        simulation.step(1e-3)
        assert float(simulation.arrays.work.friction.sum()) <= heat
        merged += int(simulation.arrays.winch_exit[0]) != exits
    assert merged >= 1


def test_a_snapshot_goes_on_to_the_same_bits() -> None:
    simulation = rw.Simulation(hoist(0.4))
    simulation.step(0.15)
    kept = simulation.state
    simulation.step(0.2)
    first = simulation.positions.copy()
    simulation.restore(kept)
    simulation.step(0.2)
    np.testing.assert_array_equal(simulation.positions, first)


@pytest.mark.parametrize("method", ["esdirk3", "rk4"])
@SPEEDS
def test_it_goes_with_bounds_and_one_way_segments(method: str, speed: float) -> None:
    """A winch hauls a tension-only solid within bounds of its stretch: it ends well, and the books close."""
    step = 5e-3 if method == "esdirk3" else 2e-4
    made_of = stuff(0.05, tension_only=True)
    scene = hoist(speed, method, step, made_of=made_of, limiter=Limiter(max_stretch=1.01))
    result = rw.simulate(scene)
    assert result.status == "finished"
    scale = max(float(np.abs(values).max()) for values in result.energy.values())
    assert result.table["largest balance residual [J]"] < 1e-9 * scale


def test_something_slides_along_a_relaxing_line_on_a_winch() -> None:
    line = Rope(
        name="line",
        segments=12,
        length=3.0,
        diameter=0.01,
        made_of=stuff(0.1),
        shape={"kind": "slack", "start": (0, 0, 0), "end": (2.9, 0, 0)},
    )
    hook = Rope(
        name="hook",
        segments=2,
        length=0.2,
        diameter=0.01,
        made_of=stuff(0.1),
        shape={"kind": "straight", "start": (0, 0, 0), "direction": (0, 0, -1)},
        loads=[Load(node=-1, mass=0.5)],
    )
    result = rw.simulate(
        Scene(
            ropes=[line, hook],
            anchors=[Anchor(rope="line", node=0), Anchor(rope="line", node=-1)],
            slides=[Slide(rope="hook", on="line", at=0.6, friction=0.1)],  # where it is steep
            winches=[Winch(rope="line", end="start", speed=-0.1)],
            run=RunSettings(method="esdirk3", duration=0.5, frame_rate=20.0, time_step=5e-3),
        )
    )
    assert result.status == "finished"
    assert np.ptp(result.slide("slide0").place) > 0.01
    length = result.rest_length.sum(axis=1)
    assert length[-1] - length[0] == pytest.approx(-0.1 * 0.5, rel=1e-9)
