"""A node that slides along another rope: forces from a potential, energy, friction that sticks, refusals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.status import OK
from ropewalk.laws.slides.rail import look, piece_of, shares
from ropewalk.laws.slides.reach import whole
from ropewalk.laws.slides.slide_force import slide_energy, slide_forces
from ropewalk.laws.slides.slide_tangent import along_slides, block, weights_of
from ropewalk.laws.slides.table import WIDTH, Memory, Slides
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import Straight

g = 9.81
SPAN, LINE = 8.0, 5  # m; nodes of the line, after which the rider's come


def scene(method: str = "rk4", step: float = 1e-3, **more: Any) -> rw.Scene:
    """A bead of 2 kg on a taut line down a slope, four segments of 2 m, with a light tail of 0.5 m."""
    slope, EA, tail = more.pop("slope", 0.2), more.pop("EA", 2e4), more.pop("tail", 0.05)
    speed, anchored = more.pop("speed", 0.0), more.pop("anchored", True)
    down = np.array([math.cos(slope), 0.0, -math.sin(slope)])
    line = rw.Rope(
        name="line",
        segments=LINE - 1,
        length=SPAN / 1.01 if anchored else SPAN,
        made_of=rw.Material(EA=EA, mass_per_length=0.05),
        shape=Straight(end=tuple(SPAN * down)),
    )
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=0.5,
        made_of=rw.Material(EA=1e4, mass_per_length=tail),
        shape=Straight(end=(0, 0, -0.5), velocity=tuple(speed * down)),
        loads=[rw.Load(node=0, mass=2.0)],
    )
    slide = rw.Slide(rope="rider", **({"at": 1.2} | more.pop("slide", {})))
    anchors = [rw.Anchor(rope="line", node=node) for node in (0, -1)] if anchored else []
    run = {"duration": 1.0, "method": method, "time_step": step, "frame_rate": 1.0 / step}
    return rw.Scene(
        ropes=[line, rider], anchors=anchors, slides=[slide], run=run | more.pop("run", {}), **more
    )


def arrays_of(**changes: Any) -> tuple[np.ndarray, np.ndarray, Slides, Memory]:
    """Return places and velocities with the rider at an inner node, and the slide's table and memory."""
    simulation = rw.Simulation(scene(slide={"at": 3.7}))
    random = np.random.default_rng(1)
    x = simulation.arrays.x + 0.02 * random.normal(size=simulation.arrays.x.shape)
    table = simulation.system.node.slide._replace(
        **{name: np.array([value]) for name, value in changes.items()}
    )
    return x, random.normal(size=x.shape), table, simulation.arrays.memory.slide


def force_at(x: np.ndarray, v: np.ndarray, table: Slides, memory: Memory) -> np.ndarray:
    force = np.zeros_like(x)
    slide_forces(x, v, table, memory, force, 0, x.shape[1])
    return force


STICKS = {"brake": 500.0, "damping": 50.0}
SLIPS = {"friction": 0.1, "brake": 1.0, "damping": 50.0}


@pytest.mark.parametrize("changes", [{}, STICKS, SLIPS])
def test_the_force_has_neither_resultant_nor_moment(changes: dict[str, float]) -> None:
    x, v, table, memory = arrays_of(**changes)
    force = force_at(x, v, table, memory)
    size = np.abs(force).max()
    assert size > 50.0
    assert np.abs(force.sum(axis=1)).max() < 1e-13 * size
    assert np.abs(np.cross(x.T, force.T).sum(axis=0)).max() < 1e-12 * size
    carried = np.flatnonzero(force[:, :LINE].any(axis=0))
    assert carried.tolist() == [1, 2, 3]  # the line's nodes carry it


def test_without_friction_it_is_the_gradient_of_what_is_stored() -> None:
    x, v, table, memory = arrays_of()
    force, h = force_at(x, v, table, memory), 1e-6
    for k in range(3):
        for i in range(x.shape[1]):
            ends = []
            for sign in (1, -1):
                moved = x.copy()
                moved[k, i] += sign * h
                ends.append(slide_energy(moved, table, memory))
            assert force[k, i] == pytest.approx(-(ends[0] - ends[1]) / (2 * h), abs=1e-6)


@pytest.mark.parametrize(("changes", "close"), [({}, 1e-7), (STICKS, 2e-2), (SLIPS, 1e-7)])
def test_the_tangent_against_differences(changes: dict[str, float], close: float) -> None:
    """That of what sticks leaves out how damping turns."""
    x, v, table, memory = arrays_of(**changes)
    d, h = np.random.default_rng(2).normal(size=x.shape), 1e-7
    for weights in ((1.0, 0.0), (1.0, 60.0)):
        dx, dv = (weight * h * d for weight in weights)
        ends = [force_at(x + s * dx, v + s * dv, table, memory) for s in (1, -1)]
        found = np.zeros_like(x)
        look(x, table, memory, 0)
        parts = weights_of(x, v, table, memory, 0, *weights)
        for m, i in enumerate(memory.group[0]):
            for n, j in enumerate(memory.group[0]):
                one = np.array(block(memory.sight, 0, m, n, parts)).reshape(3, 3)
                found[:, i] += one @ d[:, j]
        expected = -(ends[0] - ends[1]) / (2 * h)
        assert np.abs(found - expected).max() < close * np.abs(expected).max()
        along = along_slides(x, v, d, table, memory, *weights)
        assert along == pytest.approx(float((d * found).sum()), rel=1e-12)


@pytest.mark.parametrize("stretch", [1.0, 1.5, 0.4])
def test_the_brakes_force_is_what_it_is_on_a_rope_of_any_stretch(stretch: float) -> None:
    """As the rate of the unstretched place it was divided by the stretch, and much too large in folds."""
    x, v, table, memory = arrays_of(brake=30.0, damping=50.0)
    for node in range(LINE):
        x[:, node] = stretch * SPAN / 1.01 / (LINE - 1) * node * np.array([1.0, 0.0, 0.0])
    x[:, LINE] = 0.5 * (x[:, 1] + x[:, 2])
    v[:, :LINE], v[:, LINE] = 0.0, [50.0, 0.0, 0.0]
    memory.grip[0] = 1.5, 0.0
    force = force_at(x, v, table, memory)
    assert force[:, LINE] == pytest.approx([-30.0, 0.0, 0.0], abs=1e-9)
    assert force[0, :LINE].sum() == pytest.approx(30.0, abs=1e-9)


def sink(share: Any, u: float, count: int) -> float:
    """How far a load at a place lowers itself, on a string of `count` segments with unit T, h and load."""
    weights = np.zeros(count + 1)
    for node, part in share(u):
        weights[node] += part
    inner = weights[1:-1]
    stiff = 2 * np.eye(count - 1) - np.eye(count - 1, k=1) - np.eye(count - 1, k=-1)
    return float(inner @ np.linalg.solve(stiff, inner))


def test_a_load_rolls_over_no_bumps() -> None:
    """Under constant tension it sinks as a string without segments says, less 1/4 everywhere. The twin:
    shared between two nodes alone, as on straight segments, it climbs over each node.
    """
    count = 8

    def arcs(u: float) -> list[tuple[int, float]]:
        ends = whole(count)
        *parts, middle = shares(u, piece_of(u, ends), ends)
        return [(middle - 1 + m, parts[m]) for m in range(3)]

    def straight(u: float) -> list[tuple[int, float]]:
        left = min(math.floor(u), count - 1)
        return [(left, left + 1 - u), (left + 1, u - left)]

    places = np.linspace(0.6, count - 0.6, 41)
    smooth = np.array([sink(arcs, u, count) - u * (count - u) / count for u in places])
    rough = np.array([sink(straight, u, count) - u * (count - u) / count for u in places])
    assert np.abs(smooth + 0.25).max() < 1e-12
    assert np.ptp(rough) > 0.2


def test_the_force_does_not_jump_at_nodes() -> None:
    """As the node passes a kink of 0.3 rad. The twin: towards the nearest point of straight segments."""
    line = np.array([[0.0, 0, 0], [1, 0, -0.15], [2, 0, 0]]).T
    ways = np.linspace(0.9, 1.1, 401)
    beads = np.stack([ways, np.zeros_like(ways), np.full_like(ways, 0.1)])
    table = Slides(
        *(np.array([i]) for i in (3, 0, 2)),
        *(np.array([s]) for s in (1.0, 1.0, 1.0, 0, 0, 0, 0)),
        *(np.array([i]) for i in (0, 2)),
        np.full((1, 2), -1),
    )
    working = np.zeros((1, 4), int), np.zeros((1, WIDTH)), np.zeros(2, int)
    off, stops = np.full(1, math.inf), np.zeros((1, 3))
    memory = Memory(np.full((1, 2), 1.0), *working, whole(2)[None], off, stops)
    memory.grip[0, 1] = 0.0
    found, straight = [], []
    for bead in beads.T:
        x = np.concatenate([line, bead[:, None]], axis=1)
        found.append(force_at(x, np.zeros_like(x), table, memory)[:, 3])
        away = []
        for a, b in ((line[:, 0], line[:, 1]), (line[:, 1], line[:, 2])):
            share = min(max(float((bead - a) @ (b - a) / ((b - a) @ (b - a))), 0.0), 1.0)
            away.append(a + share * (b - a) - bead)
        straight.append(min(away, key=lambda r: float(r @ r)))
    step = ways[1] - ways[0]
    assert np.abs(np.diff(found, axis=0)).max() < 2.0 * step
    assert np.abs(np.diff(straight, axis=0)).max() > 0.05


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.4])
def test_a_bead_on_an_incline(mu: float) -> None:
    """a = g (sin - mu cos), and none where mu is larger than the slope."""
    slope, time, step = 0.3, 0.5, 0.0125
    simulation = rw.Simulation(
        scene("esdirk3", step, slope=slope, EA=1e8, tail=1e-3, slide={"friction": mu})
    )
    length, before = SPAN / (LINE - 1), simulation.arrays.memory.slide.grip[0, 0]
    assert simulation.advance_steps(round(time / step)) == OK
    way = (simulation.arrays.memory.slide.grip[0, 0] - before) * length
    pull = max(g * (math.sin(slope) - mu * math.cos(slope)), 0.0)
    if pull > 0.0:
        assert way == pytest.approx(0.5 * pull * time**2, rel=0.02)
    else:
        assert abs(way) < 4e-3  # the give of what holds it


def crossing(method: str, step: float, **more: Any) -> tuple[float, rw.Simulation]:
    """Run over a node at 6 m/s; return what energy is made up [J], and the simulation."""
    simulation = rw.Simulation(scene(method, step, speed=6.0, **({"slide": {"at": 2.5}} | more)))
    start = energy_now(simulation.system, simulation.arrays)
    simulation.advance_steps(round(0.2 / step))
    assert simulation.arrays.memory.slide.grip[0, 0] > 1.6  # from 1.26, past 1.5
    return energy_now(simulation.system, simulation.arrays) - start, simulation


def test_energy_is_kept_to_the_order_across_a_node() -> None:
    """Order 4 in the energy of about 40 J; the second derivative of the potential jumps, once."""
    errors = [abs(crossing("rk4", step)[0]) for step in (2e-3, 1e-3)]
    assert errors[0] < 1e-5
    assert errors[0] / errors[1] > 10.0


def test_friction_takes_what_is_booked_and_gives_nothing() -> None:
    made_up, simulation = crossing("rk4", 1e-3, slide={"at": 2.5, "friction": 0.1, "brake": 2.0})
    taken = -float(simulation.arrays.work.node.slide.sum())
    assert taken > 3.0
    assert made_up == pytest.approx(-taken, rel=0.01)  # all but what the slide's springs hold


def test_a_free_pair_keeps_momentum_and_angular_momentum() -> None:
    """The line, held nowhere, and what slides on it with friction."""
    simulation = rw.Simulation(
        scene(
            "semi-implicit-euler",
            1e-3,
            speed=6.0,
            anchored=False,
            gravity=(0, 0, 0),
            slide={"at": 2.5, "friction": 0.1, "brake": 2.0},
        )
    )

    def momenta() -> np.ndarray:
        state = simulation.arrays
        p = state.mass * state.v
        return np.concatenate([p.sum(axis=1), np.cross(state.x.T, p.T).sum(axis=0)])

    before = momenta()
    simulation.advance_steps(200)
    assert simulation.arrays.memory.slide.grip[0, 0] > 1.6
    assert np.abs(momenta() - before).max() < 1e-11
    assert np.abs(before).max() > 10.0


def test_the_table_of_a_run_says_where_it_slid_and_what_it_carried() -> None:
    result = rw.simulate(scene())
    found, table = result.slide("slide0"), result.table
    assert found.place[0] == pytest.approx(1.2, abs=0.02)
    assert np.all(np.diff(found.place) > 0.0)  # down the slope
    rider = result.layout.span("rider").start
    np.testing.assert_array_equal(found.speed, np.linalg.norm(result.velocities[:, rider], axis=1))
    assert table["largest speed of a sliding node [m/s]"] == found.speed.max()
    assert table["farthest place of a slide [m]"] == found.place.max()
    assert table["farthest place of a slide at"].endswith(
        f"in the end 'slide0' {found.place[-1]:.5g} m along"
    )
    where = table["largest load of a slide on its rope at"]
    assert "of the recorded frames; at an end of the line the stop's force is in it" in where
    # Over the ride what the line carries across is its weight's share, and the tail's.
    assert np.median(found.load) == pytest.approx(2.025 * g * math.cos(0.2), rel=0.1)
    heavy = rw.simulate(scene(tail=8.0))  # 4 kg in the tail: their middle is a quarter metre below
    slow = heavy.slide("slide0")
    assert not np.allclose(slow.carried, slow.speed, rtol=1e-3)
    with pytest.raises(KeyError, match="name one of the slides, slide0, not 'hook'"):
        result.slide("hook")


def test_it_stops_at_the_end_of_the_rope() -> None:
    simulation = rw.Simulation(scene("rk4", 5e-4, speed=9.0, slide={"at": 6.8}))
    last = 0.0
    for _ in range(10):
        simulation.advance_steps(40)
        last = max(last, float(simulation.arrays.x[0, LINE]))
    assert last < SPAN * math.cos(0.2) + 0.3
    assert simulation.arrays.v[0, LINE] < -5.0  # thrown back


def test_a_brake_begins_where_it_is_told_and_holds() -> None:
    simulation = rw.Simulation(
        scene(
            "esdirk3",
            0.0125,
            speed=3.0,
            EA=1e6,
            slide={"at": 1.0, "brake": 60.0, "brake_from": 2.0},
        )
    )
    places = [float(simulation.arrays.memory.slide.grip[0, 0])]
    for _ in range(12):
        simulation.advance_steps(8)
        places.append(float(simulation.arrays.memory.slide.grip[0, 0]))
    assert places[2] - places[1] > 0.1
    assert 1.0 < places[-1] < 3.0
    assert abs(places[-1] - places[-2]) < 1e-3


def test_at_rest_the_anchors_carry_it() -> None:
    """In the middle of a level line: the tension of a string with a load, T = W / (2 sin)."""
    simulation = rw.Simulation(
        scene("implicit-euler", 0.05, slope=0.0, slide={"at": 0.5 * SPAN / 1.01})
    )
    simulation.advance_steps(60)
    state = simulation.arrays
    assert state.reaction[:, 2].sum() == pytest.approx(g * state.mass.sum(), rel=5e-3)
    down = -float(state.x[2, 2])
    pull = 0.5 * g * (state.mass.sum() - 0.05 * SPAN / 1.01) / (down / math.hypot(0.5 * SPAN, down))
    assert abs(state.reaction[0, 0]) == pytest.approx(pull, rel=0.15)


def test_a_snapshot_goes_on_to_the_same_bits() -> None:
    simulation = rw.Simulation(
        scene("semi-implicit-euler", 1e-3, speed=6.0, slide={"friction": 0.1, "brake": 2.0})
    )
    simulation.advance_steps(50)
    kept = simulation.state
    simulation.advance_steps(50)
    ends = [simulation.arrays.x.copy(), simulation.arrays.memory.slide.grip.copy()]
    other = rw.Simulation(simulation.scene)
    other.restore(kept)
    for _ in range(5):
        other.advance_steps(10)
    assert np.array_equal(other.arrays.x, ends[0])
    assert np.array_equal(other.arrays.memory.slide.grip, ends[1])
