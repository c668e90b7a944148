"""What is changed of ropes while winches wind them: as much rope is out, of what it is made of then."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from live.drive import do, refused
from ropewalk.core.arrays import flatten
from ropewalk.laws.winch import unstretched
from ropewalk.live.carry import carry_over
from ropewalk.live.describe import parameters
from ropewalk.live.edits import same_nodes
from ropewalk.live.session import Session
from ropewalk.methods.partings import part_segment
from ropewalk.scene import (
    Anchor,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Springs,
    Straight,
    Winch,
)

CORD = {"EA": 40.0, "mass_per_length": 0.0625, "axial_damping": 0.4}


def hung(speed: float, end: str = "start", made_of: Any = None, **more: Any) -> Scene:
    """Return 0.4 m of rope in four segments with 50 g at its free end, and a winch above."""
    up = end == "start"
    places = [(0.0, 0.0, 0.0), (0.0, 0.0, -0.4)]
    low, high = places if up else places[::-1]
    rope = Rope(
        segments=4,
        length=None if isinstance(made_of, Springs) else 0.4,
        made_of=made_of or Material(**CORD),
        shape=Straight(start=low, end=high),
        loads=[Load(node=-1 if up else 0, mass=0.05), *more.pop("loads", [])],
        name="line",
    )
    run = {"method": "implicit-euler", "time_step": 0.01, "duration": 2.0}
    given = {
        "ropes": [rope],
        "anchors": [Anchor(name="drum", node=0 if up else -1, rope="line")],
        "winches": [Winch(rope="line", end=end, speed=speed, on_drum=0.5, stop=0.6)],
        "run": RunSettings(**run),
    }
    return Scene(**(given | more))


def wound(scene: Scene, time: float = 0.35) -> Session:
    """Return a session in which the winch has taken on, or let go, nodes already."""
    session = Session(scene)
    begun = session.main.simulation.arrays.winch_exit.copy()
    session.advance(round(time / session.main.dt))
    assert (session.main.simulation.arrays.winch_exit != begun).all()
    return session


def books(session: Session) -> float:
    """Return what the method has lost or made [J]."""
    one = session.main.frame().recording
    return session.main.books(one)[2]


def out(session: Session) -> float:
    """Return the unstretched length that is off the first winch's drums [m], debts included."""
    simulation = session.main.simulation
    return float(unstretched(simulation.system.winches, simulation.arrays, 0))


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_what_is_carried_over_into_the_same_scene_keeps_its_bits(speed: float, end: str) -> None:
    session = wound(hung(speed, end))
    old = session.main.simulation
    new = carry_over(old, session.main.scene, same_nodes(old.layout))
    before, after = flatten(old.arrays), flatten(new.arrays)
    for name in ("mass", "inverse_mass", "rest_length", "stiffness", "damping_vector", "inner"):
        assert np.array_equal(before[name], after[name]), name
    for name in (one for one in before if one.startswith("winch") or one == "anchor_node"):
        assert np.array_equal(before[name], after[name]), name


@pytest.mark.parametrize("speed", [0.5, -0.5])
@pytest.mark.parametrize("name", ["EA", "mass", "spring_friction", "diameter", "gravity"])
def test_what_is_set_to_what_it_was_changes_no_bit(name: str, speed: float) -> None:
    """Nor does what acts on nothing here, which makes all anew."""
    one, other = wound(hung(speed)), wound(hung(speed))
    values = {about["name"]: about["value"] for about in parameters(other)["parameters"]}
    do(other, "set", name=name, value=0.02 if name == "diameter" else values[name])
    for session in (one, other):
        session.advance(40)
    for name in ("positions", "velocities", "tension"):
        assert np.array_equal(*(getattr(s.main.simulation, name) for s in (one, other))), name


@pytest.mark.parametrize("springs", [False, True])
@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_another_stiffness_is_that_of_a_rope_that_had_it_from_the_start(
    speed: float, end: str, springs: bool
) -> None:
    """All segments pull by the new EA over their lengths, and the rope hangs as long in the end."""
    made = Springs(
        spring_constant=400.0, node_mass=0.00625, segment_length=0.1, spring_friction=4.0
    )
    scene = hung(speed, end, made if springs else None)
    changed = wound(scene)
    do(changed, "set", name="EA", value=80.0)
    state = changed.main.simulation.arrays
    alive = state.rest_length > 0.0
    np.testing.assert_allclose((state.stiffness * state.rest_length)[alive], 80.0, rtol=1e-14)
    assert not state.stiffness[~alive].any()
    rope = scene.ropes[0]
    twice = {"spring_constant": 800.0} if springs else {"EA": 80.0}
    always = wound(scene.replace(ropes=[rope.replace(made_of=rope.made_of.replace(**twice))]))
    assert out(changed) == pytest.approx(out(always), rel=1e-12)
    for session in (changed, always):
        session.advance(200)
    assert out(changed) == pytest.approx(out(always), rel=1e-12)
    lengths = [np.ptp(s.main.simulation.positions[:, 2]) for s in (changed, always)]
    debts = [float(s.main.simulation.arrays.winch_debt.sum()) for s in (changed, always)]
    assert lengths[0] + debts[0] == pytest.approx(lengths[1] + debts[1], rel=1e-4)
    for session in (changed, always):
        simulation = session.main.simulation
        carried = simulation.tension.max()
        weight = simulation.arrays.mass[simulation.arrays.inverse_mass > 0.0].sum() * 9.81
        assert carried == pytest.approx(weight, rel=1e-3)


@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_the_mass_of_all_that_is_out_is_that_of_its_length(speed: float) -> None:
    session = wound(hung(speed, loads=[Load(node=3, mass=0.01), Load(node=0, mass=0.02)]))
    before = session.main.simulation.arrays.mass.copy()
    assert before.sum() == pytest.approx(0.0625 * out(session) + 0.08, rel=1e-12)
    do(session, "set", name="mass", value=0.1)
    state = session.main.simulation.arrays
    assert state.mass.sum() == pytest.approx(0.25 * out(session) + 0.08, rel=1e-12)
    assert np.array_equal(state.mass == 0.0, before == 0.0)
    free = state.inverse_mass > 0.0
    np.testing.assert_allclose(state.inverse_mass[free] * state.mass[free], 1.0, rtol=1e-14)
    session.advance(40)
    state = session.main.simulation.arrays
    assert state.mass.sum() == pytest.approx(0.25 * out(session) + 0.08, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "value", "share"),
    [
        ("spring_friction", 8.0, 2.0),
        ("spring_friction", 0.0, 0.0),
        ("friction_form", "vector", 1.0),
    ],
)
def test_friction_is_that_of_the_lengths_that_are_there(
    name: str, value: Any, share: float
) -> None:
    session = wound(hung(0.5))
    before = session.main.simulation.arrays
    assert before.damping_axial[-1] == 4.0  # N s/m
    do(session, "set", name=name, value=value)
    after = session.main.simulation.arrays
    forms = [after.damping_axial, after.damping_vector]
    now, other = forms[::-1] if name == "friction_form" else forms
    np.testing.assert_allclose(now, share * before.damping_axial, rtol=1e-14)
    assert not other.any()


@pytest.mark.parametrize("height", [0.0, 5.0])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_energy_that_a_change_puts_in_is_in_the_books(speed: float, height: float) -> None:
    """What has gone on to a drum, or came off it, is heavier as well, in the winch's work alike."""
    scene = hung(speed)
    shape = Straight(start=(0.0, 0.0, height), end=(0.0, 0.0, height - 0.4))
    session = wound(scene.replace(ropes=[scene.ropes[0].replace(shape=shape)]), 0.25)
    error = books(session)
    hanging = {"node": session.main.simulation.layout.nodes - 1, "mass": 0.2}
    for kind, values in (
        ("set", {"name": "gravity", "value": [0.0, 0.0, -9.0]}),
        ("set", {"name": "EA", "value": 80.0}),
        ("set", {"name": "mass", "value": 0.1}),
        ("load", hanging),
    ):
        before, put_in = session.main.energy, session.main.edited
        do(session, kind, **values)
        if values.get("name") == "EA":
            given = session.main.energy - before
            assert given > 1e-4  # J
            assert session.main.edited - put_in == pytest.approx(given, rel=1e-9)
        assert books(session) == pytest.approx(error, abs=1e-12)


def test_undo_and_going_back_bring_back_what_was_wound() -> None:
    session = wound(hung(-0.5), 0.25)
    do(session, "set", name="EA", value=90.0)
    do(session, "set", name="mass", value=0.1)
    before = {name: one.copy() for name, one in flatten(session.main.simulation.arrays).items()}
    parts = ("mass", "stiffness", "rest_length", "damping_axial", "winch_exit", "x", "v")
    for kind in ("undo", "back"):
        do(session, "load", node=session.main.simulation.layout.nodes - 1, mass=0.3)
        session.advance(15)
        now = flatten(session.main.simulation.arrays)
        assert not any(np.array_equal(now[name], before[name]) for name in ("mass", "x"))
        if kind == "back":
            do(session, "undo")
            session.advance(15)
        do(session, kind, **({"seconds": 10.0} if kind == "back" else {}))
        now = flatten(session.main.simulation.arrays)
        for name in parts:
            assert np.array_equal(now[name], before[name]), name


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_a_load_that_is_hung_on_beside_a_winch_weighs(speed: float, end: str) -> None:
    """It was in the scene, and weighed nothing."""
    session = wound(hung(speed, end))
    span, mass = session.main.simulation.layout.ropes[0], session.main.simulation.arrays.mass.copy()
    free = span.last if end == "start" else span.first
    for node, load, more in ((free, 0.2, 0.15), (free, 0.0, -0.05)):
        do(session, "load", node=node, mass=load)
        after = session.main.simulation.arrays.mass
        assert after[node] == pytest.approx(mass[node] + more, rel=1e-12)
        assert np.array_equal(np.delete(after, node), np.delete(mass, node))
    drum = span.start if end == "start" else span.end
    on_it = span.start + 1 if speed < 0 and end == "start" else drum - (speed < 0)
    assert "on a winch's drum" in refused(session, "load", node=on_it, mass=0.1)
    assert np.array_equal(session.main.simulation.arrays.mass, after)


def test_lengths_and_segments_of_wound_ropes_stay_and_why_is_told() -> None:
    session = wound(hung(0.5))
    told = {one["name"]: one for one in parameters(session)["parameters"]}
    off = {name for name, one in told.items() if "winch" in one["why"]}
    assert off == {"length", "segments"}
    for name, value in (("length", 0.5), ("segments", 8)):
        said = refused(session, "set", name=name, value=value)
        assert "while a winch winds the rope" in said
        assert said.endswith(told[name]["why"] + ".") or told[name]["why"] in said


def beside(speed: float, **more: Any) -> Scene:
    """Return the wound rope with one before it in the arrays that is not, both held at the top."""
    scene = hung(speed)
    shape = Straight(start=(1.0, 0.0, 0.0), end=(1.0, 0.0, -0.4))
    first = scene.ropes[0].replace(name="first", shape=shape)
    anchors = [Anchor(name="top", node=0, rope="first"), *scene.anchors]
    return scene.replace(ropes=[first, scene.ropes[0]], anchors=anchors, **more)


@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_ropes_that_no_winch_winds_change_as_without_one(speed: float) -> None:
    """Nodes that come and go there move the wound rope's in the arrays, and nothing else of it."""
    session, other = wound(beside(speed)), wound(beside(speed))
    do(session, "set", name="segments", value=9, rope="first")
    do(session, "set", name="length", value=0.45, rope="first")
    do(session, "set", name="EA", value=90.0, rope="first")
    do(session, "cut", segment=0)  # of which a node goes as well
    do(session, "cut", segment=4)
    names = [span.name for span in session.main.simulation.layout.ropes]
    assert names == ["first-1", "first-2", "line"]
    said = refused(session, "set", name="length", value=0.5)
    assert "while a winch winds the rope" in said
    told = {one["name"]: one["enabled"] for one in parameters(session)["parameters"]}
    assert told["length"]
    assert told["segments"]
    for _ in range(2):
        here, there = (s.main.simulation.layout.span("line") for s in (session, other))
        a, b = (s.main.simulation.arrays for s in (session, other))
        assert here.first != there.first
        assert (a.winch_exit - here.first == b.winch_exit - there.first).all()
        row = session.main.simulation.layout.anchor_names.index("drum")
        assert a.anchor_node[row] == a.winch_exit[0]
        one, two = slice(here.first, here.last), slice(there.first, there.last)
        for name in ("mass", "rest_length", "stiffness", "damping_axial"):
            assert np.array_equal(getattr(a, name)[one], getattr(b, name)[two]), name
        np.testing.assert_allclose(a.x[:, one], b.x[:, two], rtol=0.0, atol=1e-9)
        for each in (session, other):
            each.advance(20)


def test_of_a_wound_rope_that_has_parted_changes_leave_the_gap() -> None:
    scene = hung(0.5)
    weak = scene.ropes[0].made_of.replace(breaking_load=1.5, parts=True)
    session = wound(scene.replace(ropes=[scene.ropes[0].replace(made_of=weak)]))
    session.advance(20)
    hung_on = session.main.simulation.layout.nodes - 1
    assert not session.main.parted
    do(session, "load", node=hung_on, mass=0.3)
    session.advance(60)
    parted = session.main.parted
    assert len(parted) == 1
    (gap,) = np.flatnonzero(np.isfinite(session.main.simulation.arrays.memory.parting.time))
    whole = out(session)
    for name, value in (("EA", 80.0), ("mass", 0.1), ("spring_friction", 1.0)):
        do(session, "set", name=name, value=value)
    state = session.main.simulation.arrays
    for one in (state.rest_length, state.stiffness, state.damping_axial, state.damping_vector):
        assert one[gap] == 0.0
    assert (state.stiffness[gap + 1 :] > 0.0).all()
    assert out(session) == whole
    session.advance(20)
    assert session.main.parted == parted
    assert session.scene.rope_named("line").segments == 4


def test_a_parted_rope_beside_a_winch_becomes_two_and_a_wound_one_stays_one() -> None:
    scene = beside(0.5)
    ropes = [
        rope.replace(made_of=rope.made_of.replace(breaking_load=1.5, parts=True))
        for rope in scene.ropes
    ]
    session = wound(scene.replace(ropes=ropes))
    simulation = session.main.simulation
    for name in ("first", "line"):
        do(session, "load", node=simulation.layout.span(name).last, mass=0.3)
    session.advance(100)
    assert {one.parting.rope for one in session.main.parted} == {"first", "line"}
    *others, last = session.scene.ropes
    assert sum(rope.segments for rope in others) == 3
    assert (last.name, last.segments) == ("line", 4)
    assert np.isfinite(session.main.simulation.positions).all()


def strong(scene: Scene) -> Scene:
    """Return the scene with ropes that may part, at a load that they never carry."""
    ropes = [
        rope.replace(made_of=rope.made_of.replace(breaking_load=100.0, parts=True))
        for rope in scene.ropes
    ]
    return scene.replace(ropes=ropes)


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_a_wound_rope_that_is_cut_goes_on_as_one_that_has_parted(speed: float, end: str) -> None:
    """To the last bit; what it had stored is lost, its winch stands, changes leave the gap."""
    session, other = wound(strong(hung(speed, end))), wound(strong(hung(speed, end)))
    error = books(session)
    span = session.main.simulation.layout.span("line")
    cut, gone = (span.last - 2, span.first) if end == "start" else (span.first + 1, span.last - 1)
    before = {name: one.copy() for name, one in flatten(session.main.simulation.arrays).items()}
    assert "stands" in do(session, "cut", segment=cut)
    assert books(session) == pytest.approx(error, abs=1e-12)
    simulation = other.main.simulation
    tension = float(simulation.tension[cut])
    part_segment(simulation.system, simulation.arrays, cut, tension, simulation.time)
    simulation.push({})
    begun = out(session)
    for each in (session, other):
        each.advance(30)
    for name in ("positions", "velocities"):
        assert np.array_equal(*(getattr(s.main.simulation, name) for s in (session, other))), name
    assert out(session) == begun
    assert not session.main.simulation.arrays.winch_rate.any()
    ((one, _, _),) = session.main.parted
    assert (one.tension, one.segment) == (tension, cut - span.start)
    assert "has parted: nothing is to be cut" in refused(session, "cut", segment=cut)
    if speed < 0.0:
        assert "is on a winch's drum" in refused(session, "cut", segment=gone)
    do(session, "set", name="EA", value=80.0)
    assert session.main.simulation.arrays.stiffness[cut] == 0.0
    do(session, "undo")
    after = flatten(session.main.simulation.arrays)
    for name in ("mass", "stiffness", "rest_length", "damping_axial", "x", "v"):
        assert np.array_equal(after[name], before[name]), name
    assert not session.main.parted
    session.advance(5)
    assert out(session) != begun


def test_bends_beside_a_cut_of_a_wound_rope_are_gone() -> None:
    bending = Material(**CORD, EI=0.02, bending_damping=1e-4)
    session = wound(strong(hung(0.5, made_of=bending)))
    cut = session.main.simulation.layout.nodes - 3
    do(session, "cut", segment=cut)
    do(session, "set", name="gravity", value=[0.0, 0.0, -9.0])
    state = session.main.simulation.arrays
    assert not state.bending_stiffness[cut : cut + 2].any()
    assert state.bending_stiffness[cut - 1] > 0.0
    session.advance(20)
    assert np.isfinite(session.main.simulation.positions).all()
