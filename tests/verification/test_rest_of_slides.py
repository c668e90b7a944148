"""Rest of what slides along a rope: the lowest place without friction, any within its reach with it."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core import arrays
from ropewalk.laws.slides.rail import look
from ropewalk.laws.slides.table import AT, GRADIENT, PER_PLACE, R1
from ropewalk.lowering import build
from ropewalk.rigging.held_places import held_places, in_words
from ropewalk.scene import (
    Anchor,
    Force,
    Load,
    Material,
    Points,
    Rope,
    Scene,
    Slack,
    Slide,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape
from ropewalk.statics.balance import Balance
from ropewalk.statics.rolling import _bars
from ropewalk.vibration.flexibility import NoModes
from ropewalk.vibration.linear import linearise

g = 9.81


def trolley(
    at: float, friction: float = 0.0, drop: float = -0.5, length: float = 10.05, **more: Any
) -> rw.Scene:
    """5 kg on a light line across 10 m, with a light tail that hangs from them."""
    line = rw.Rope(
        name="line",
        segments=more.pop("segments", 20),
        length=length,
        made_of=rw.Material(EA=1e8, mass_per_length=0.002),
        shape=Slack(start=(0, 0, 0), end=(10, 0, drop)),
    )
    rider = rw.Rope(
        name="rider",
        segments=1,
        length=0.3,
        made_of=rw.Material(EA=1e4, mass_per_length=0.002),
        shape=Straight(end=(0, 0, -0.3)),
        loads=[rw.Load(node=0, mass=5.0)],
    )
    run = {"duration": 1.0, "method": "implicit-euler", "time_step": 1 / 240, "frame_rate": 60.0}
    slide = rw.Slide(rope="rider", on="line", at=at, friction=friction, **more)
    anchors = [rw.Anchor(rope="line", node=node) for node in (0, -1)]
    return rw.Scene(ropes=[line, rider], anchors=anchors, slides=[slide], run=run)


def slope(scene: rw.Scene) -> tuple[float, Any]:
    """How steep the line is at rest where the trolley is [1], and the rest."""
    found = checked_shape(scene)
    memory, table = found.memory.slide, build(scene).system.node.slide
    look(np.ascontiguousarray(found.positions.T), table, memory, 0)
    along = memory.sight[0, R1 : R1 + 3]
    return float(along[2] / along[0]), found


def test_without_friction_it_rolls_to_where_the_line_is_level() -> None:
    """From anywhere, to the same place; on a light line both sides are as steep: cos = across / length."""
    steep = math.acos(10.0 / 10.05)
    lower = 0.5 * (10.05 + 0.5 / math.sin(steep))  # m from the upper anchor to the lowest place
    places = []
    for at in (1.0, 4.0, 9.0):
        level, found = slope(trolley(at, segments=40))
        (seat,) = found.seats
        assert abs(level) < 1e-9
        assert found.residual < 1e-8
        assert (seat.along, seat.most, seat.use) == (0.0, 0.0, 0.0)
        assert seat.force == pytest.approx(g * 5.0, rel=2e-3)
        places.append(seat.at)
    assert np.ptp(places) < 1e-6
    assert places[0] == pytest.approx(lower, abs=0.25 * 10.05 / 40)
    assert not found.by_friction


def test_with_friction_it_stops_where_friction_holds_it() -> None:
    """From both ends it comes to the ends of what friction allows, mu on either side; within it stays."""
    ends = []
    for at in (1.0, 9.5):
        steep, found = slope(trolley(at, 0.05))
        (seat,) = found.seats
        assert seat.use == pytest.approx(1.0, abs=1e-6)
        assert abs(steep) == pytest.approx(0.05, rel=0.05)
        assert found.by_friction
        ends.append(seat.at)
    assert ends[1] - ends[0] > 1.0
    steep, found = slope(trolley(0.5 * sum(ends) + 0.2, 0.05))
    (seat,) = found.seats
    assert 0.0 < seat.use < 0.9
    assert seat.at == pytest.approx(0.5 * sum(ends) + 0.2, abs=0.2)
    assert "friction and brake carry" in str(seat)
    _, found = slope(trolley(4.0, brake=100.0))
    assert 0.0 < found.seats[0].use < 1.0


def test_what_rests_in_a_bump_of_steep_sides_is_told() -> None:
    """Tensions beside what slides without friction are the same on a line without segments."""
    for at in (2.6, 1.5):
        _, found = slope(trolley(5.0 * at / 2.5, drop=3.0, length=15.0))
        (seat,) = found.seats
        pulls = found.tension[[1, 18]]
        assert [seat.before, seat.after] == pytest.approx(pulls, rel=0.01)
        assert seat.uneven == pytest.approx(abs(np.diff(pulls)[0]), abs=0.1)
        assert seat.uneven > 0.02 * pulls.max()
        assert "more apart than on a line without segments" in str(seat)
        assert seat.as_dict()["uneven"] == seat.uneven
    rests = trolley(5.2)
    line = rests.ropes[0].replace(forces=[Force(node=11, force=(3.0, 0.0, 0.0))])
    drawn = rests.replace(ropes=[line, *rests.ropes[1:]])  # a given force is no bump
    held = trolley(2.2, drop=0.0, length=10.3, segments=12, brake=1000.0)
    second = held.ropes[1].replace(name="second")
    both = [*held.slides, held.slides[0].replace(rope="second", name="beside", at=2.9)]
    crowded = held.replace(ropes=[*held.ropes, second], slides=both)  # the other one's brake
    for flat in (trolley(4.0), trolley(4.0, 0.05), trolley(0.3, brake=100.0), drawn, crowded):
        _, found = slope(flat)
        assert {seat.uneven for seat in found.seats} == {0.0}
        assert not any("apart" in str(seat) for seat in found.seats)


@pytest.mark.parametrize("friction", [0.0, 0.05])
def test_it_stays_at_rest(friction: float) -> None:
    scene = trolley(4.0, friction)
    simulation = Simulation(scene.replace(run=scene.run.replace(start="at-rest")))
    before = simulation.positions.copy()
    simulation.step(1.0)
    assert np.abs(simulation.positions - before).max() < 1e-8


def test_it_rolls_about_the_lowest_place_as_on_an_ellipse() -> None:
    """omega^2 = g / rho, rho = a^2 / b of the ellipse about both anchors; where friction holds it is not."""
    a, c = 0.5 * 10.01, 5.0
    expected = math.sqrt(g * math.sqrt(a * a - c * c) / (a * a)) / (2.0 * math.pi)
    for segments in (20, 21, 80):
        rolling = rw.modes(trolley(4.0, drop=0.0, length=10.01, segments=segments), count=1)
        assert rolling.frequencies[0] == pytest.approx(expected, rel=0.03), segments
    stuck = rw.modes(trolley(5.1, 0.2, drop=0.0, length=10.01), count=1)
    assert stuck.frequencies[0] > 2.0 * expected
    assert stuck.motions[0].name == "out of plane"


def test_it_is_told_where_segments_shift_the_frequency() -> None:
    """At 14 degrees; with the frequency on an ellipse. Not at 2.6."""
    length = 10.0 / math.cos(math.radians(14.0))
    a, c = 0.5 * length, 5.0
    expected = math.sqrt(g * math.sqrt(a * a - c * c) / (a * a)) / (2.0 * math.pi)
    steep = rw.modes(trolley(4.0, drop=0.0, length=length), count=1)
    (note,) = steep.notes
    told = float(note.rpartition(" it is ")[2].removesuffix(" Hz"))
    assert told == pytest.approx(expected, rel=0.01)
    assert "sides stand at 14" in note
    off = steep.frequencies[0] / expected
    assert 1.1 < off < 1.2
    assert "by up to some 37 %, finer lines the more" in note
    with pytest.raises(NoModes, match="segments by one"):  # on a bump
        rw.modes(trolley(4.0, drop=0.0, length=length, segments=41), count=1)
    assert rw.modes(trolley(4.0, drop=0.0, length=10.01), count=1).notes == []
    assert rw.modes(trolley(4.0, 0.3, drop=0.0, length=length), count=1).notes == []


@pytest.mark.parametrize("friction", [0.0, 0.2])
def test_modes_have_the_tangents_of_slides(friction: float) -> None:
    scene = trolley(6.0, friction)
    model, found = build(scene), checked_shape(scene)
    balance = Balance(model)
    for state in (balance.state, model.state):
        arrays.assign(state.memory, found.memory)
    x = np.ascontiguousarray(found.positions.T)
    linear = linearise(model, x, np.zeros_like(found.elastic_tension))
    way = np.random.default_rng(3).normal(size=x.shape)
    way[:, ~balance.free] = 0.0
    way *= 1e-7 / np.abs(way).max()
    ends = [balance.others(x + sign * way).copy() for sign in (1.0, -1.0)]
    change = -0.5 * (ends[0] - ends[1])[:, balance.free].T.ravel()
    said = linear.other @ way[:, balance.free].T.ravel()
    assert np.abs(change - said).max() < 1e-5 * np.abs(said).max()


@pytest.mark.parametrize("friction", [0.05, 0.1])
def test_between_which_places_friction_holds_it(friction: float) -> None:
    """On an ellipse: the line at the trolley, half way between its sides, is as steep as mu.

    With both sides p and q long and at angles a and b to the level, p + q the line's length, the trolley is
    held where |tan((a - b) / 2)| <= mu. Creeping from beyond either end comes to that end.
    """
    length, across = 10.05, 10.0
    a, c = 0.5 * length, 0.5 * across
    turn = math.atan(friction)
    b = math.sqrt(a * a - c * c)
    parameter = math.atan(a / b * math.tan(turn))  # of the ellipse, whose slope is (b / a) tan
    half = c * math.sin(parameter)  # a side is a + (c / a) x long, x = a sin
    scene = trolley(5.0, friction, drop=0.0)
    _, found = slope(scene)
    ropes = {"line": found.positions[:21], "rider": found.positions[21:]}
    places = held_places(build(scene).scene, ropes, found.seats[0])
    assert places is not None
    assert places[0] == pytest.approx(0.5 * length - half, abs=0.01)
    assert places[1] == pytest.approx(0.5 * length + half, abs=0.01)
    for start, end in ((1.0, places[0]), (9.0, places[1])):
        _, crept = slope(trolley(start, friction, drop=0.0))
        assert crept.seats[0].at == pytest.approx(end, abs=0.3)
    assert "is held anywhere from" in in_words(found.seats[0], places)
    between = in_words(found.seats[0], (3.12345, 7.98765))  # both ends as they are told hold it
    assert "from 3.124 to 7.987 m" in between
    edge = replace(found.seats[0], at=102.3212)  # it rested before the first place that holds it
    assert edge.at > 102.3108
    assert "from 102.32 to 128.58 m" in in_words(edge, (102.3108, 128.586))


def test_where_nothing_says_between_which_places() -> None:
    """Without friction or weight, and where something else holds the line."""
    scene = trolley(5.0, 0.0)
    _, found = slope(scene)
    ropes = {"line": found.positions[:21], "rider": found.positions[21:]}
    assert held_places(build(scene).scene, ropes, found.seats[0]) is None
    assert in_words(found.seats[0], None) == ""
    scene = trolley(5.0, 0.1)
    seat = slope(scene)[1].seats[0]
    more = scene.replace(anchors=[*scene.anchors, rw.Anchor(rope="line", node=7)])
    assert held_places(build(more).scene, ropes, seat) is None
    with np.errstate(
        all="raise"
    ):  # without weight nothing is level: numpy warned of a division by zero
        weightless = build(scene.replace(gravity=(0, 0, 0))).scene
        assert held_places(weightless, ropes, seat) is None
    for rope, node in (
        ("line", 10),
        ("rider", -1),
    ):  # a force is no weight of the line, nor upright
        pushed = [
            one.replace(forces=[Force(node=node, force=(0, 0, -500))]) if one.name == rope else one
            for one in scene.ropes
        ]
        assert held_places(build(scene.replace(ropes=pushed)).scene, ropes, seat) is None


def test_friction_that_holds_it_near_where_arcs_meet_is_found() -> None:
    """Friction jumped there, and held the rider half a millionth too much or too little.

    It comes to rest where friction carries all that it can: no force is left.
    """
    scene = rw.preset("zip-line-ride").replace(**{"slide.at": 101.5})
    found = checked_shape(scene)
    assert found.solved
    (seat,) = found.seats
    assert seat.at / scene.ropes[0].segment_length == pytest.approx(163.45, abs=0.01)
    assert abs(seat.along) == pytest.approx(0.02 * seat.force, rel=1e-9)
    assert found.residual < 1e-6  # [N], of 982 N


def test_friction_does_not_jump_where_arcs_meet() -> None:
    """The bend of the curve does. The twin: along the gradient of the place, which knows of the bend."""
    scene = trolley(7.5 * 10.05 / 20, brake=20.0, compliance=1e-3)
    found = checked_shape(scene)
    balance = Balance(build(scene))
    memory, table = balance.state.memory.slide, balance.system.node.slide
    x = np.ascontiguousarray(found.positions.T)
    balance.restore((arrays.copy(found.memory.obstacle), found.memory.contact, found.memory.slide))
    look(x, table, memory, 0)
    node, along = int(table.node[0]), memory.sight[0, R1 : R1 + 3].copy()
    for _ in range(60):  # to where they meet
        look(x, table, memory, 0)
        x[:, node] += (7.5 - memory.sight[0, AT]) * -along
    forces, twins = [], []
    for aside in (-1e-9, 1e-9):
        y = x.copy()
        y[:, node] -= aside * along
        look(y, table, memory, 0)
        gradient = 20.0 * memory.sight[0, GRADIENT : GRADIENT + 3]
        forces.append(gradient * memory.sight[0, PER_PLACE])
        twins.append(gradient * table.length[0])
    assert np.linalg.norm(twins[1] - twins[0]) > 1e-3
    assert np.linalg.norm(forces[1] - forces[0]) < 1e-6


def test_what_rolls_far_is_at_rest_in_few_steps() -> None:
    """The preset's trolley rolls 100 m: creeping alone took 9419 Newton steps to the same place."""
    found = checked_shape(rw.preset("zip-line-ride"))
    assert found.steps < 400
    assert found.seats[0].at == pytest.approx(102.32123480, abs=1e-7)


def down_two_spans(at: float, **more: Any) -> rw.Scene:
    """A trolley on a line that goes down over a support half-way, 40 segments and 2.35 m to either side."""
    share = np.linspace(0.0, 2.0, 81)
    height = -share - (share % 1.0) * (1.0 - share % 1.0)
    points = [(2.0 * s, 0.0, z) for s, z in zip(share, height, strict=True)]
    line = rw.Rope(
        name="line",
        segments=80,
        length=4.7,
        made_of=rw.Material(EA=1e8, mass_per_length=0.002),
        shape=Points(points=points),
        **more,
    )
    scene = trolley(at)
    anchors = [rw.Anchor(rope="line", node=40 * k) for k in range(3)]
    return scene.replace(ropes=[line, scene.ropes[1]], anchors=anchors)


def test_what_rolls_far_passes_no_support() -> None:
    """It rests where the legs about it are as steep as each other, to a fifth of a segment."""
    found = checked_shape(down_two_spans(0.4))
    longer = 1.0 / math.sqrt(1.0 - (2.0 / 2.35) ** 2)
    assert found.seats[0].at == pytest.approx(0.5 * (2.35 + longer), abs=0.0125)


def test_places_that_are_not_passed_unseen() -> None:
    """Ends, supports, loads, forces, and what slides along the same line."""
    scene = down_two_spans(0.4, loads=[rw.Load(node=50, mass=1.0)])
    forced = scene.ropes[0].replace(forces=[rw.Force(node=60, force=(0.0, 0.0, 1.0))])
    rider = scene.ropes[1].replace(name="other")
    more = rw.Slide(name="other", rope="other", on="line", at=3.9 * 4.7 / 80)
    slides = [*scene.slides, more]
    balance = Balance(build(scene.replace(ropes=[forced, scene.ropes[1], rider], slides=slides)))
    bars = _bars(balance, balance.coupled.slide, 0)
    assert bars == pytest.approx([0, 40, 50, 60, 80, 3.9], abs=0.05)


def tension_at_rest(length: float, segments: int) -> tuple[float, float]:
    """The largest tension of a line over 10 m with 20 kg in its middle [N], and what its bend takes [m]."""
    line = Rope(
        name="line",
        segments=segments,
        length=length,
        made_of=Material(EA=1e7, mass_per_length=1e-4),
        shape=Slack(start=(0, 0, 0), end=(10, 0, 0)),
    )
    hook = Rope(
        name="hook",
        segments=1,
        length=0.5,
        made_of=Material(EA=1e6, mass_per_length=1e-4),
        shape=Straight(start=(5, 0, -2), direction=(0, 0, -1)),
        loads=[Load(node=-1, mass=20.0)],
    )
    scene = Scene(
        ropes=[line, hook],
        anchors=[Anchor(rope="line", node=0), Anchor(rope="line", node=-1)],
        slides=[Slide(rope="hook", at=0.5 * length, friction=0.6)],
        gravity=(0, 0, -9.81),
    )
    found = checked_shape(scene)
    (seat,) = found.seats
    assert seat.is_rounded == ("longer" in str(seat)) == (seat.rounded > 0.01 * seat.spare)
    return float(found.tension[:segments].max()), seat.rounded


@pytest.mark.parametrize("segments", [10, 11, 21])
@pytest.mark.parametrize("length", [10.2, 11.0])
def test_it_is_told_how_much_rope_a_bend_takes(length: float, segments: int) -> None:
    """A line that is given so much less pulls as two straight legs do; as it is it pulls 2 to 5 % less."""
    slack = math.sqrt(0.25 * length**2 - 25.0)
    exact = 20.0 * 9.81 * 0.25 * length / slack
    read, taken = tension_at_rest(length, segments)
    assert read / exact == pytest.approx(1.0 - 0.5 / segments, abs=0.006)
    assert 0.94 < read / exact < 0.98
    assert tension_at_rest(length - taken, segments)[0] == pytest.approx(exact, rel=7e-3)
