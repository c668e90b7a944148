"""Winches: length, mass and tension while rope is paid out and reeled in."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.scene import Air, Anchor, Ground, Material, Rope, Straight, Winch
from ropewalk.simulation import Simulation
from verification.setups import ALL, DOWN, Film, g, hold, off, run, scene

MU = 0.1  # kg/m


def wound(
    EA: float,
    speed: float,
    *,
    end: str = "start",
    span: float | None = None,
    load: float = 0.5,
    length: float = 2.0,
    segments: int = 8,
    duration: float = 1.0,
    method: str = "semi-implicit-euler",
    **more,
) -> Film:
    """A rope hanging from its winch with a load, or stretched over `span`, every step a frame."""
    made_of = Material(
        EA=EA, mass_per_length=MU, axial_damping=more.pop("damping", 0.02 * math.sqrt(EA))
    )
    held = 0 if end == "start" else segments
    if span is None:
        stretch = 1 + (load + 0.5 * MU * length) * g / EA
        far = (0.0, -length * stretch, 0.0)
        anchors = hold(held)
    else:
        far, anchors = (span, 0.0, 0.0), hold(0, segments)
    start, stop = ((0, 0, 0), far) if end == "start" else (far, (0, 0, 0))
    loads = [{"node": segments if end == "start" else 0, "mass": load}] if load else []
    rope = Rope(
        segments=segments,
        length=length,
        made_of=made_of,
        loads=loads,
        shape=Straight(start=start, end=stop),
    )
    nominal = length / segments
    dt = 0.15 * math.sqrt(MU / EA) * nominal
    steps = round(duration / dt)
    winch = Winch(end=end, speed=speed, **more)
    return run(
        scene(rope, anchors, dt=dt, steps=steps, gravity=DOWN if span is None else (0, 0, 0),
              winches=[winch], method=method, every=max(1, steps // 20000))
    )  # fmt: skip


def unstretched(film: Film) -> np.ndarray:
    """Unstretched length of all rope that is out, in every frame [m]."""
    return film.block.recording.rest_length.sum(axis=1)


@pytest.mark.parametrize("speed", [0.8, -0.8])
@pytest.mark.parametrize("EA", [30.0, 3000.0])
@pytest.mark.parametrize("end", ["start", "end"])
def test_the_length_follows_the_speed(end: str, EA: float, speed: float) -> None:
    """L(t) = L0 + speed t exactly, but for what a merge holds back of itself: at most strain times a
    segment, given back within the next segment of turning. The mass follows: mu L + load.
    """
    film = wound(EA, speed, end=end, load=0.5)
    strain = (0.5 + MU * 2.8) * g / EA
    allowed = 1e-9 if speed > 0 else 3.0 * strain * 0.25 + 1e-9
    assert off(unstretched(film), 2.0 + speed * film.t) < allowed
    debt = film.simulation.arrays.winch_debt[0]
    assert unstretched(film)[-1] + debt == pytest.approx(2.0 + speed * film.t[-1], abs=1e-9)
    mass = film.simulation.arrays.mass.sum()
    assert mass == pytest.approx(MU * (2.0 + speed * film.t[-1]) + 0.5, rel=1e-9)
    # twins: the other way round; a winch that stands
    assert off(unstretched(film), 2.0 - speed * film.t) > 1.0
    assert off(unstretched(film), 2.0) > 0.5


@pytest.mark.parametrize("speed", [0.4, -0.4])
@pytest.mark.parametrize("EA", [30.0, 3000.0])
def test_tension_has_no_jump_where_segments_split_and_merge(EA: float, speed: float) -> None:
    """Between two held ends, at rest: T = EA (span / L(t) - 1) while L changes slowly; a split keeps
    both strains, a merge the working segment's tension. Every live tension stays within the wave of
    the slow change, strain rate times L / c, of the formula, in every step, also across the events.
    """
    hurry = math.sqrt(EA / 30)
    film = wound(EA, speed * 1e-2 * hurry, span=3.0, load=0, duration=60.0 / hurry)
    out = unstretched(film)
    counts = (film.block.recording.rest_length > 0).sum(axis=1)
    assert len(np.unique(counts)) >= 2  # something was split or merged
    tension = film.block.recording.tension
    live = film.block.recording.rest_length > 0
    expected = EA * (3.0 / out - 1.0)
    worst = np.where(live, np.abs(tension - expected[:, None]), 0.0).max(axis=1)
    swing = 0.02 * EA
    assert worst[10:].max() < swing
    # tension of the working segment from frame to frame: no jump at the events
    rows = np.arange(len(out))
    first = live.argmax(axis=1)
    working = tension[rows, first]
    events = np.flatnonzero(np.diff(counts) != 0)
    assert np.abs(np.diff(working))[events].max() < 2e-3 * EA
    # the twin: the same comparison sees a working segment that is 1 % longer from one step to the next
    simulation = film.simulation
    segment = int(first[-1])
    simulation.arrays.rest_length[segment] *= 1.01
    after = simulation.recording().recording.tension[0, segment]
    assert abs(after - working[-1]) > 2e-3 * EA


@pytest.mark.parametrize("speed", [0.5, -0.5])
@pytest.mark.parametrize("method", ALL)
def test_a_load_is_lowered_and_lifted_at_the_winchs_speed(method: str, speed: float) -> None:
    """The load's mean speed is the winch's (times 1 + strain), once it has stopped bouncing (at the
    rate c / 2ML, 1 to 5 1/s); the drum carries the weight of what hangs: M + mu L.
    """
    film = wound(4000.0, speed, load=1.0, duration=3.0, segments=4, method=method, damping=10.0)
    a = len(film.t) // 2
    mean = -np.polyfit(film.t[a:], film.x[a:, -1, 1], 1)[0]
    assert mean == pytest.approx(speed * (1 + 1.2 * g / 4000.0), rel=0.01)
    pull = film.block.recording.reaction[a:, 0, 1].mean()
    hanging = 1.0 + MU * unstretched(film)[a:].mean()
    assert pull == pytest.approx(hanging * g, rel=0.01)
    assert abs(mean + speed) > 0.5  # the twin: the other way round


def test_stops_and_intervals() -> None:
    """min_length, max_length, start and stop: the length between them, and nothing beyond."""
    film = wound(300.0, 0.8, max_length=2.3)
    assert off(unstretched(film), np.minimum(2.0 + 0.8 * film.t, 2.3)) < 1e-9
    film = wound(300.0, -0.8, min_length=1.6)
    assert unstretched(film)[-1] + film.simulation.arrays.winch_debt[0] == pytest.approx(
        1.6, abs=1e-6
    )
    film = wound(300.0, 0.8, start=0.2, stop=0.7)
    allowed = 0.8 * film.simulation.plan.dt + 1e-9
    assert off(unstretched(film), 2.0 + 0.8 * np.clip(film.t - 0.2, 0, 0.5)) < allowed
    assert off(unstretched(film), 2.0 + 0.8 * film.t) > 0.2  # the twin: a winch that never stops


def test_a_winch_on_a_moving_anchor() -> None:
    """The rope on the drum moves with it; length and mass as with a drum that stands."""
    made_of = Material(EA=100.0, mass_per_length=MU, axial_damping=0.2)
    rope = Rope(segments=4, length=1.0, made_of=made_of, shape={"kind": "hanging"})
    anchor = Anchor(node=0, motion={"kind": "velocity", "velocity": (0.5, 0, 0)})
    made = scene(
        rope, [anchor], dt=5e-4, steps=1500, gravity=DOWN, winches=[Winch(end="start", speed=1.0)]
    )
    film = run(made)
    assert off(unstretched(film), 1.0 + film.t) < 1e-9
    simulation: Simulation = film.simulation
    drum = simulation.arrays.winch_exit[0]
    assert off(simulation.positions[: drum + 1], [0.5 * film.t[-1], 0, 0]) < 1e-12
    assert simulation.arrays.mass.sum() == pytest.approx(MU * 1.75, rel=1e-9)


def test_air_drags_the_rope_that_was_paid_out() -> None:
    """Every node that is out has the same drag as those that were out from the start; those on the
    drum, and a ground around it, do no work. The balance closes, and the twin forgets the air's work.
    """
    made_of = Material(EA=100.0, mass_per_length=MU, axial_damping=0.2)
    rope = Rope(segments=4, length=1.0, made_of=made_of, shape={"kind": "hanging"})
    anchor = Anchor(node=0, motion={"kind": "velocity", "velocity": (0.5, 0.2, 0)})
    made = scene(
        rope,
        [anchor],
        dt=5e-4,
        steps=1500,
        gravity=DOWN,
        winches=[Winch(end="start", speed=1.0)],
        air=Air(node_drag=0.02, node_drag_quadratic=0.01),
        ground=Ground(height=0.5),
    )
    film = run(made)
    arrays, air = film.simulation.arrays, film.simulation.system.node.air
    out = arrays.mass > 0.0
    assert out.sum() > 6
    drag = arrays.forces.node.air[:, out].T
    u = np.linalg.norm(film.v[-2, out], axis=1)[:, None]
    assert off(drag, -(0.02 + 0.01 * u) * film.v[-2, out]) < 1e-12
    assert air.linear == 1
    assert off(film.residual(), 0.0) < 1e-11
    assert off(film.residual(without="air"), 0.0) > 1e-3


def test_a_drum_that_is_let_go_does_not_turn() -> None:
    """After its release the rope keeps its length and mass, and falls. The twin is held."""

    def film(release: float | None) -> Film:
        made_of = Material(EA=100.0, mass_per_length=MU, axial_damping=0.2)
        rope = Rope(segments=4, length=1.0, made_of=made_of, shape={"kind": "hanging"})
        anchor = Anchor(node=0, release_time=release)
        winch = Winch(end="start", speed=1.0)
        return run(scene(rope, [anchor], dt=5e-4, steps=1000, gravity=DOWN, winches=[winch]))

    released = film(0.25)
    assert off(unstretched(released), 1.0 + np.minimum(released.t, 0.25)) < 1e-9
    assert off(released.residual(), 0.0) < 1e-12
    momentum = released.block.recording.momentum[:, 1]
    fall = np.diff(momentum[520:]) / 5e-4
    assert off(fall, -1.25 * MU * g) < 1e-9
    assert off(unstretched(film(None)), 1.0 + np.minimum(released.t, 0.25)) > 0.2


def holds(film: Film, dt: float) -> np.ndarray:
    """Tell for which steps the free end's place follows BDF2's formula from the two before."""
    x, v = film.x[:, -1, 1], film.v[:, -1, 1]
    expected = (4.0 * x[1:-1] - x[:-2] + 2.0 * dt * v[2:]) / 3.0
    return np.abs(x[2:] - expected) < 1e-11


def test_bdf2_is_bdf2_beside_a_winch() -> None:
    """All steps but the first and those after a node leaves the drum; twin: sdirk2, which it was."""
    found = {}
    for method in ("bdf2", "sdirk2"):
        film = wound(50.0, 0.5, method=method, duration=0.8)
        found[method] = holds(film, film.t[1] - film.t[0])
    assert found["bdf2"].mean() > 0.9
    assert not found["bdf2"].all()
    assert found["sdirk2"].mean() < 0.2
