"""What slides along a rope that a winch winds: the ellipse, the books, the stop at the drum."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.slides.rail import piece_of, point_at, shares
from ropewalk.laws.slides.reach import whole
from ropewalk.laws.slides.slide_force import slide_energy
from ropewalk.laws.slides.stops import move_stops
from ropewalk.laws.slides.table import CLEAR, DRUM, GIVEN, LOW, NEAREST
from ropewalk.laws.winch import MERGE, SPLIT
from ropewalk.lowering.layout import make_layout
from ropewalk.scene import Points, Slack, Straight
from ropewalk.statics import checked_shape

g = 9.81
SPAN, MASS = 10.0, 40.0  # m, kg


def scene(**more: Any) -> rw.Scene:
    """40 kg on a line of 10.6 m across 10 m, by default up to 3 m, with a winch at its lower end."""
    segments, rise, speed = more.pop("segments", 20), more.pop("rise", 3.0), more.pop("speed", -0.2)
    EA, length, end = more.pop("EA", 1e5), more.pop("length", 10.6), more.pop("end", "start")
    line = rw.Rope(
        name="line",
        segments=segments,
        length=length,
        made_of=rw.Material(EA=EA, mass_per_length=0.1, axial_damping=more.pop("damping", 50.0)),
        shape=Slack(start=(0, 0, 0), end=(SPAN, 0, rise)),
    )
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=0.3,
        made_of=rw.Material(EA=1e4, mass_per_length=0.1, axial_damping=20.0),
        shape=Straight(end=(0, 0, -0.3)),
        loads=[rw.Load(node=0, mass=MASS)],
    )
    anchors = [rw.Anchor(name=f"end{node % 2}", rope="line", node=node) for node in (0, -1)]
    winch = rw.Winch(rope="line", end=end, speed=speed, **more.pop("winch", {}))
    slide = rw.Slide(rope="rider", compliance=1e-5, at=more.pop("at", 2.5), **more.pop("slide", {}))
    run = {"method": "rk4", "time_step": 1e-4, "frame_rate": 100.0, "duration": 3.0} | more
    return rw.Scene(ropes=[line, rider], anchors=anchors, winches=[winch], slides=[slide], run=run)


def at_rest(given: rw.Scene) -> rw.Scene:
    """The scene drawn in its rest."""
    found = checked_shape(given)
    (seat,) = found.seats
    ropes = [
        rope.replace(
            shape=Points(
                points=[tuple(point) for point in found.positions[span.start : span.end + 1]]
            )
        )
        for rope, span in zip(given.ropes, make_layout(given).ropes, strict=True)
    ]
    return given.replace(ropes=ropes, slides=[given.slides[0].replace(at=seat.at)])


def test_rest_is_that_of_the_rope_that_is_out() -> None:
    """A winch stands at rest, and its stop presses on nothing far from it."""
    given = scene(rise=0.0, EA=1e7, length=10.2)
    found = checked_shape(given)
    plain = checked_shape(given.replace(winches=[]))
    assert found.seats[0].at == pytest.approx(5.1, abs=1e-6)
    np.testing.assert_allclose(found.positions[-1], plain.positions[-1], atol=1e-9)


@pytest.mark.parametrize(("end", "speed"), [("start", -0.1), ("end", -0.1), ("start", 0.1)])
def test_the_way_of_a_load_on_a_line_that_is_hauled(end: str, speed: float) -> None:
    """It is on the ellipse about the ends whose sum of distances is the rope that is out, stretched."""
    given = scene(
        segments=80, rise=1.0, length=10.3, EA=4e5, damping=4e3, end=end, speed=speed, at=6.0
    )
    run = given.run.replace(method="esdirk3", time_step=2e-3, frame_rate=50.0, duration=3.0)
    result = rw.simulate(at_rest(given).replace(run=run))
    assert result.status == "finished"
    rider = result.positions[:, result.layout.span("rider").start]
    sums = sum(
        np.linalg.norm(rider - np.array(focus), axis=1) for focus in ((0, 0, 0), (SPAN, 0, 1.0))
    )
    out = result.rest_length.sum(axis=1) - 0.3
    assert out[-1] - out[0] == pytest.approx(3.0 * speed, abs=0.01)
    pull = result.tension[:, 60]
    off = sums - out * (1.0 + pull / 4e5)
    # Between the two nodes of a segment that carry it a load cuts the corner: kinks of F / (2 T), h / 2 away.
    corner = -0.125 * (10.3 / 80) * (MASS * g / pull) ** 2
    assert abs(off[0] - corner[0]) < 3e-4
    late = result.time > 1.0  # once the start is damped; the load bounces
    assert np.abs(off - corner)[late].max() < 3.5e-3
    assert abs(sums[-1] - sums[0]) > 0.24


@pytest.fixture(scope="module")
def hauled() -> dict[float, tuple[rw.Simulation, np.ndarray]]:
    """Runs in which a load rolls to the drum and is stopped there, and one number for each frame.

    That is the slide's work, and what it has stored.
    """
    found = {}
    for speed, rise in ((-0.2, 3.0), (0.2, 4.0)):
        simulation, rows = rw.Simulation(scene(speed=speed, rise=rise)), []
        for _ in range(300):
            simulation.advance_steps(100)
            state = simulation.arrays
            stored = slide_energy(state.x, simulation.system.node.slide, state.memory.slide)
            rider = state.x[:, simulation.layout.span("rider").start]
            drum = state.x[:, state.winch_exit[0]]
            apart = float(np.linalg.norm(rider - drum))
            rows.append((float(state.work.node.slide.sum()), stored, apart))
        found[speed] = simulation, np.array(rows)
    return found


@pytest.mark.parametrize("speed", [-0.2, 0.2])
def test_nothing_jumps_where_nodes_go_on_to_the_drum_or_come_off(
    speed: float, hauled: dict[float, tuple[rw.Simulation, np.ndarray]]
) -> None:
    """A slide without friction takes what it stores, no more, at the stop at the drum, too."""
    simulation, rows = hauled[speed]
    work, stored, apart = rows.T
    state = simulation.arrays
    assert state.winch_exit[0] == state.memory.slide.ends[0, DRUM] != 0 or speed > 0.0
    assert state.memory.slide.ends[0, LOW] == (1 if speed < 0.0 else -1)
    assert apart.min() < NEAREST * 0.53  # pressed into the stop
    assert apart.min() > 0.9 * NEAREST * 0.53
    assert stored.max() > 5.0
    assert np.abs(work + stored).max() < 1e-3 * stored.max()


def test_the_books_of_a_load_that_is_hauled_to_the_drum() -> None:
    """The winch puts in what the rope gets; its work is that of the tension at the drum."""
    result = rw.simulate(scene(duration=2.0, frame_rate=1000.0))
    work, energy = result.work, result.energy
    gained = energy["total"] - energy["total"][0]
    taken = work["friction"] + work["slide"]
    assert gained[-1] > 300.0
    assert np.abs(work["winch"] + taken - gained).max() < 1e-5 * gained[-1]
    assert result.table["largest balance residual [J]"] < 1e-9
    drums = (result.rest_length > 0.0).argmax(axis=1)
    pull = result.tension[np.arange(len(drums)), drums]
    steps = 0.5 * (pull[1:] + pull[:-1]) * 0.2 / 1000.0
    assert steps.sum() == pytest.approx(work["winch"][-1], rel=0.01)


def test_the_place_is_of_the_rope_and_goes_on_as_rope_comes_off_the_drum() -> None:
    """The same mark of the rope is at the same place throughout: with friction that holds, so is the load."""
    brake = {"brake": 5000.0}
    for end, sign in (("start", 1.0), ("end", -1.0)):
        given = scene(speed=0.5, end=end, slide=brake, at=5.0, rise=0.0, duration=1.5)
        result = rw.simulate(given)
        place = result.slide("slide0").place
        assert np.ptp(place) < 0.02
        rider = result.positions[:, result.layout.span("rider").start]
        assert sign * (rider[-1, 0] - rider[0, 0]) > 0.2  # carried along with the rope


def test_a_winch_leaves_room_for_what_slides() -> None:
    """It stops three segments before the far end, which is free here, and says why; or where told to."""
    given = scene(segments=6, speed=-2.0, rise=0.0, duration=4.0, at=9.0, length=12.0)
    free = given.replace(anchors=given.anchors[:1], run=given.run.replace(time_step=2e-4))
    simulation = rw.Simulation(free)
    winch = simulation.winches["winch0"]
    assert winch.limits[0] == 6.0
    while winch.length > 6.0 + 1e-9:
        simulation.advance_steps(100)
        assert simulation.time < 3.5
    assert winch.stopped_by == "room for a slide"
    held = given.replace(winches=[given.winches[0].replace(min_length=7.0)])
    assert rw.Simulation(held).winches["winch0"].limits[0] == 7.0


def sunk(lam: float, load: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Places of nodes of a taut string, the first segment `lam` long, the others 1, under a unit load.

    That is at material place `load` from the drum, on the curve, and sinks it little. Returns places and x.
    """
    along = np.concatenate([[0.0], lam + np.arange(count)])
    ends, u = whole(count), load - lam + 1.0
    *parts, middle = shares(u, piece_of(u, ends), ends)
    force = np.zeros(count + 1)
    for m in range(3):
        force[middle - 1 + m] = parts[m]
    sizes = np.diff(along)
    stiff = np.zeros((count + 1, count + 1))
    for j, size in enumerate(sizes):
        stiff[j : j + 2, j : j + 2] += np.array([[1, -1], [-1, 1]]) / size
    down = np.zeros(count + 1)
    down[1:-1] = np.linalg.solve(stiff[1:-1, 1:-1], 1e-3 * force[1:-1])
    return along, np.array([along, np.zeros(count + 1), -down])


@pytest.mark.parametrize("lam", [MERGE, SPLIT])
def test_the_curve_stays_where_a_node_goes_on_to_the_drum_or_comes_off(lam: float) -> None:
    """Where the load is as near as the stop lets it, and farther off. The twin: nearer, it is moved."""

    def moved(load: float) -> float:
        _, x = sunk(lam, load, 8)
        u = load - lam + 1.0
        before = np.array(point_at(x, 0, whole(8), u))
        if lam == MERGE:
            after = np.delete(x, 1, axis=1)
            u -= 1.0
        else:
            new = x[:, :1] + (lam - 1.0) / lam * (x[:, 1:2] - x[:, :1])
            after = np.insert(x, [1], new, axis=1)
            u += 1.0
        ends = whole(after.shape[1] - 1)
        return float(np.linalg.norm(np.array(point_at(after, 0, ends, u)) - before))

    for load in (NEAREST, 2.6, 3.1, 4.0):
        assert moved(load) < 1e-15
    assert moved(1.2) > 1e-5


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"at": 1.0}, "is 1 m from the drum of winch 'winch0'"),
        ({"segments": 4, "at": 10.0, "end": "end"}, "stopped 2.25 segments from a drum, 5.96"),
    ],
)
def test_what_begins_at_a_drum_is_refused(more: dict[str, Any], words: str) -> None:
    with pytest.raises(rw.SceneError) as refused:
        rw.Simulation(scene(**more))
    assert words in str(refused.value)


def test_a_trolley_is_hauled_along_by_a_rope_of_its_own() -> None:
    """The end of a rope slides whose other end is on a winch; the end at the drum cannot."""
    plain = scene(rise=0.0, EA=1e5)
    tow = rw.Rope(
        name="tow",
        segments=6,
        length=3.0,
        made_of=rw.Material(EA=1e4, mass_per_length=0.02, axial_damping=200.0),
        shape=Straight(start=(5.0, 0, 0.0), end=(8.0, 0, 0.0)),
        loads=[rw.Load(node=0, mass=5.0)],
    )
    line = plain.ropes[0].replace(length=9.9, shape=Straight(end=(SPAN, 0, 0)))
    given = plain.replace(
        ropes=[line, tow],
        anchors=[*plain.anchors, rw.Anchor(name="drum", rope="tow", node=-1)],
        winches=[rw.Winch(rope="tow", end="end", speed=-0.5)],
        slides=[rw.Slide(rope="tow", compliance=1e-5, brake=20.0)],
        run=plain.run.replace(duration=1.0, method="esdirk3", time_step=2e-3),
    )
    result = rw.simulate(given)
    rider = result.positions[:, result.layout.span("tow").start]
    assert rider[-1, 0] - rider[0, 0] == pytest.approx(0.5, abs=0.1)
    with pytest.raises(rw.SceneError, match="could come on to the drum of its rope"):
        given.replace(slides=[rw.Slide(rope="tow", node=-1)])
    assert math.isinf(rw.Simulation(given).arrays.memory.slide.off[0])


def test_the_stop_is_where_it_is_seen_from_the_drum() -> None:
    """Not along the rope: from a corner one segment off the drum 2.26 segments of rope are 1.6 away, and the
    stop would throw what begins there.
    """
    h = 0.53
    corner = [(0.0, 0.0, -h), *((h * i, 0.0, -h) for i in range(1, 20))]
    given = scene(rise=0.0, at=2.26 * h)
    line = given.ropes[0].replace(shape=Points(points=[(0.0, 0.0, 0.0), *corner]))
    with pytest.raises(rw.SceneError, match="from the drum of winch 'winch0'"):
        rw.Simulation(given.replace(ropes=[line, given.ropes[1]]))


def test_the_stop_follows_the_stretch() -> None:
    """A load pressed into it stays 2.1 stretched segments off the drum, as at 16 % more than at rest.

    The twin: 2.25 segments at rest are fewer of these.
    """
    segment, most, nearest = 9.6 / 20, 1.0, math.inf
    soft = {"EA": 8e3, "length": 9.6, "rise": 5.0, "at": 1.5, "damping": 5.0}
    simulation, pressed = rw.Simulation(scene(**soft)), 0.0
    for _ in range(200):
        simulation.advance_steps(100)
        state = simulation.arrays
        drum = int(state.winch_exit[0])
        stretch = np.linalg.norm(state.x[:, drum + 2] - state.x[:, drum + 1]) / segment
        rider = state.x[:, simulation.layout.span("rider").start]
        apart = float(np.linalg.norm(rider - state.x[:, drum]))
        pressed = max(pressed, float(state.memory.slide.stops[0, 0]) - apart)
        most, nearest = max(most, float(stretch)), min(nearest, apart / (stretch * segment))
        stored = slide_energy(state.x, simulation.system.node.slide, state.memory.slide)
        assert abs(state.work.node.slide.sum() + stored) < 1e-2  # of 60 J
    assert pressed > 0.01
    assert nearest > 2.1
    assert NEAREST / most < 2.1


def test_a_stop_that_is_pressed_on_is_moved_out_where_the_rope_is_stretched_more() -> None:
    """By no more than it must, and what that gives is kept. One that nothing presses on comes back."""
    simulation = rw.Simulation(scene())
    table, memory = simulation.system.node.slide, simulation.arrays.memory.slide
    x, node, segment = simulation.arrays.x.copy(), int(table.node[0]), float(table.length[0])
    for i in range(21):
        x[:, i] = [1.3 * segment * i, 0.0, 0.0]
    memory.stops[0] = 2.25 * segment, 0.0, 0.0
    x[:, node] = [2.2 * segment, 0.0, 0.0]
    move_stops(x, table, memory, 0)
    assert memory.stops[0, 0] == pytest.approx(CLEAR * 1.3 * segment)
    depths = (CLEAR * 1.3 - 2.2) * segment, 0.05 * segment
    gave = 0.5 * table.stiffness[0] * (depths[0] ** 2 - depths[1] ** 2)
    assert memory.stops[0, GIVEN] == pytest.approx(gave)
    x[:, node] = [5.0 * segment, 0.0, 0.0]
    x[:, :21] /= 1.3
    move_stops(x, table, memory, 0)
    assert memory.stops[0, 0] == pytest.approx(NEAREST * segment)
