"""A coefficient of restitution of obstacles: what `adaptive` throws back, against closed forms.

A node on its own leaves a surface with e of the speed across it with which it came, as seen from the surface.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.arrays import Floats
from ropewalk.lowering import build
from ropewalk.scene import (
    Joint,
    Load,
    Material,
    Obstacle,
    Plane,
    Points,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Sphere,
    Spin,
    Straight,
    Tie,
    Velocity,
    loads,
)
from ropewalk.simulation import Simulation
from verification.setups import DOWN

D, NODE, SPEED, DEEP = 0.01, 0.1, 2.0, 1e-3  # m, kg, m/s; how deep it goes [m]: 100 tolerances
SHARES = (0.1, 0.3, 0.5, 0.8, 1.0)
NONE = (0.0, -1e-9, 0.0)  # all but no weight


def softness(deep: float = DEEP, speed: float = SPEED, mass: float = NODE) -> float:
    """The compliance [m/N] with which a node goes so deep."""
    return (deep / speed) ** 2 / mass


def floor(share: float, **more: object) -> Plane:
    kept: dict[str, object] = {"friction": 0.0, "compliance": softness()} | more
    return Plane(name="floor", normal=(0, 1, 0), restitution=share, **kept)


def thrown(body: Obstacle, height: float = 0.05, along: float = 0.0, **more: object) -> Scene:
    """A node that comes fast at a body, and another one beside it; all but nothing ties them."""
    up = height + 0.5 * D
    rope = Rope(
        segments=1, length=1.0, diameter=D, made_of=Material(EA=1e-3, mass_per_length=2.0 * NODE),
        shape=Points(points=[(0, up, 0), (1, up, 0)], velocity=(0, -SPEED, along)),
    )  # fmt: skip
    run = RunSettings(method="adaptive", duration=0.2, frame_rate=5.0)
    scene = Scene(ropes=[rope], obstacles=[body], gravity=NONE, run=run)
    return scene.replace(**more) if more else scene


def left(scene: Scene) -> Floats:
    """The velocity with which the first node flies on (3,) [m/s]."""
    found: Floats = rw.simulate(scene).velocities[-1, 0]
    return found


@pytest.mark.parametrize("share", SHARES)
def test_a_node_is_thrown_back_with_its_share(share: float) -> None:
    """Right and at a slant, by what stands and what moves, flat and round."""
    plane, ball = (
        floor(share),
        Sphere(center=(0, -0.1, 0), radius=0.1, friction=0.0, restitution=share, compliance=softness()),
    )  # fmt: skip
    for height in (0.05, 0.0523, 0.0571):
        assert left(thrown(plane, height))[1] / SPEED == pytest.approx(share, abs=2e-3)
    slanting = left(thrown(plane, along=1.3))
    assert slanting[1] / SPEED == pytest.approx(share, abs=2e-3)
    assert slanting[2] == pytest.approx(1.3, rel=1e-12)
    lift = Velocity(velocity=(0, 0.7, 0))
    rises = left(thrown(floor(share, motion=lift, compliance=softness(speed=SPEED + 0.7))))[1]
    assert (rises - 0.7) / (SPEED + 0.7) == pytest.approx(share, abs=2e-3)
    x, y, z = left(thrown(ball))
    assert y / SPEED == pytest.approx(share, abs=2e-3)
    assert abs(x) < 1e-3  # the string to the other node
    assert z == 0.0


@pytest.mark.parametrize("share", SHARES)
def test_thirty_tolerances_are_deep_enough(share: float) -> None:
    """Off by 0.02 and more with steps that were looked at on their way in alone, as in 0.3 sqrt(m / k)."""
    for height in (0.05, 0.0523, 0.0571, 0.0613):
        plane = floor(share, compliance=softness(3e-4))
        assert left(thrown(plane, height))[1] / SPEED == pytest.approx(share, abs=5e-3)


@pytest.mark.parametrize("share", [0.3, 0.8])
def test_what_slips_as_it_is_thrown_back_loses_by_coulombs_law(share: float) -> None:
    """The impulse along is mu times that across, (1 + e) m u."""
    found = left(thrown(floor(share, friction=0.2), along=1.5))
    assert found[1] / SPEED == pytest.approx(share, abs=2e-3)
    assert 1.5 - found[2] == pytest.approx(0.2 * (1.0 + share) * SPEED, rel=2e-3)


@pytest.mark.parametrize(
    ("share", "friction", "comes", "goes"), [(1.0, 0.3, 0.5, -0.134), (0.8, 1.0, 1.0, -0.195)]
)
def test_what_sticks_leaves_backwards_as_it_is_said(
    share: float, friction: float, comes: float, goes: float
) -> None:
    """The numbers of the page: the spring along the surface lets go with the contact; a rigid body: 0."""
    found = left(thrown(floor(share, friction=friction), along=comes))
    assert found[1] / SPEED == pytest.approx(share, abs=2e-3)
    assert found[2] == pytest.approx(goes, abs=0.01)


def tied(
    share: float, thick: tuple[float, float], mass: tuple[float, float], stops: float
) -> Scene:
    """Two ropes, tied at their first nodes, that come at a floor for so much mass [kg]."""
    ropes = [
        Rope(
            name=name, segments=1, length=1.0, diameter=wide,
            made_of=Material(EA=1e-3, mass_per_length=2.0 * heavy),
            shape=Points(points=[(0, 0.055, 0), (side, 0.055, 0)], velocity=(0, -SPEED, 0)),
        )
        for name, side, wide, heavy in zip("ab", (1.0, -1.0), thick, mass, strict=True)
    ]  # fmt: skip
    joint = Joint(name="knot", points=[Tie(rope="a", node=0), Tie(rope="b", node=0)])
    floored = thrown(floor(share, compliance=softness(mass=stops)))
    return floored.replace(ropes=ropes, joints=[joint])


@pytest.mark.parametrize("share", [0.5, 0.8, 1.0])
@pytest.mark.parametrize(
    ("thick", "mass"), [((D, 0.2 * D), (0.1, 0.9)), ((D, D), (0.1, 0.9)), ((D, D), (0.5, 0.5))]
)
def test_what_a_joint_ties_counts(
    share: float, thick: tuple[float, float], mass: tuple[float, float]
) -> None:
    """Left with 0.81 for 0.5 where a thick light end stops for a thin heavy one with its own damper."""
    scene = tied(share, thick, mass, sum(mass) / thick.count(D))
    assert left(scene)[1] / SPEED == pytest.approx(share, abs=5e-3)


@pytest.mark.parametrize("share", [0.5, 0.8])
def test_what_a_joint_has_let_go_counts_no_more(share: float) -> None:
    """Left with 0.05 for 0.5 where the damper stayed that of all that had been tied; `restore` ties again."""
    simulation = Simulation(tied(share, (D, 0.2 * D), (0.1, 0.9), 0.1))
    before = simulation.state
    for lets_go in (True, False, True):
        simulation.restore(before)
        if lets_go:
            simulation.cut_joint("knot")
        simulation.advance_frames(1)
        speeds = simulation.velocities[[0, 2], 1] / SPEED
        assert speeds == pytest.approx(np.full(2, share), abs=5e-3)


@pytest.mark.parametrize("share", [0.5, 0.8, 1.0])
def test_three_bounces_are_as_high_as_its_square_says(share: float) -> None:
    """Less a share of g deep / u^2: what falls is braked from before the surface on."""
    fall, deep = 0.3, 2e-4
    speed = math.sqrt(2.0 * 9.81 * fall)
    body = floor(share, compliance=softness(deep, speed))
    scene = thrown(body, fall, gravity=DOWN)
    shape = scene.ropes[0].shape.replace(velocity=(0, 0, 0))
    run = RunSettings(method="adaptive", duration=2.0, frame_rate=1000.0, tolerance=1e-6)
    result = rw.simulate(scene.replace(ropes=[scene.ropes[0].replace(shape=shape)], run=run))
    gap = result.positions[:, 0, 1] - 0.5 * D
    rise = result.velocities[:, 0, 1]
    peaks = gap[:-1][(rise[:-1] > 0.0) & (rise[1:] <= 0.0)]
    for bounce, peak in enumerate(peaks[:3], start=1):
        assert peak / fall == pytest.approx(share ** (2 * bounce), rel=0.02)


@pytest.mark.parametrize("share", SHARES)
def test_the_contact_takes_what_the_node_loses(share: float) -> None:
    result = rw.simulate(thrown(floor(share)))
    books = result.contact_work["floor"]
    taken = -float(books["normal"][-1] + books["method"][-1])
    struck = 2 * 0.5 * NODE * SPEED**2  # both nodes
    assert taken == pytest.approx((1.0 - share**2) * struck, abs=3e-3 * struck)
    assert float(books["friction"][-1]) == 0.0
    assert result.table["largest energy error [J]"] < 1e-12
    assert result.table["largest balance residual [J]"] < 1e-12


def test_what_loses_nothing_keeps_its_energy_as_the_tolerance_says() -> None:
    """Of bounces for two seconds: off by the third of a per cent each, and less with finer steps."""
    lost = []
    for tolerance in (1e-5, 1e-7):
        scene = thrown(floor(1.0), 0.3, gravity=DOWN)
        run = RunSettings(method="adaptive", duration=2.0, frame_rate=10.0, tolerance=tolerance)
        energy = rw.simulate(scene.replace(run=run)).energy["total"]
        lost.append(1.0 - float(energy[-1] / energy[0]))
    assert abs(lost[0]) < 0.015
    assert abs(lost[1]) < abs(lost[0])


def level(share: float, mass: float = 0.0) -> Scene:
    """A level rope that falls on a floor as a whole, with a load of so much at a node."""
    rope = Rope(
        segments=10, length=0.5, diameter=D, made_of=Material(EA=1e4, mass_per_length=0.1),
        shape=Straight(start=(0, 0.055, 0), direction=(1, 0, 0), velocity=(0, -SPEED, 0)),
        loads=[Load(node=3, mass=mass)] if mass else [],
    )  # fmt: skip
    plane = floor(share, compliance=softness(DEEP, SPEED, 0.005))
    run = RunSettings(method="adaptive", duration=0.05, frame_rate=100.0)
    return Scene(ropes=[rope], obstacles=[plane], gravity=NONE, run=run)


def test_all_nodes_of_a_rope_leave_alike() -> None:
    """Its ends have half the mass: with the mean node's damper they left with 0.37 in place of 0.5."""
    speeds = rw.simulate(level(0.5)).velocities[-1, :, 1] / SPEED
    assert np.abs(speeds - 0.5).max() < 5e-3


def test_a_load_counts() -> None:
    table = build(level(0.5, mass=1.0)).system.node.obstacle
    ratio = table.ratio[0] * table.damping[0] / (2.0 * np.sqrt(table.stiffness[0]))
    masses = build(level(0.5, mass=1.0)).state.mass
    wanted = math.log(2.0) / math.hypot(math.pi, math.log(2.0))
    assert ratio / np.sqrt(masses) == pytest.approx(np.full(11, wanted), rel=1e-12)


def test_none_is_what_was() -> None:
    """With e = 0 a contact is that of one that says nothing, to the bit; with a little another."""
    silent = Plane(name="floor", normal=(0, 1, 0), friction=0.0, compliance=softness())
    runs = [
        Simulation(thrown(body)).advance_frames(1).recording.v
        for body in (silent, floor(0.0), floor(1e-3))
    ]
    assert np.array_equal(runs[0], runs[1])
    assert not np.array_equal(runs[0], runs[2])


def refused(scene: Scene) -> str:
    with pytest.raises(SceneError) as told:
        build(scene)
    return str(told.value)


@pytest.mark.parametrize("method", ["auto", "esdirk3", "implicit-euler", "verlet", "rk4"])
def test_steps_of_a_fixed_length_are_refused_by_name(method: str) -> None:
    run = RunSettings(method=method, duration=0.1)
    text = refused(thrown(floor(0.5)).replace(run=run))
    assert 'obstacle[0].restitution: 0.5 - asks for run.method = "adaptive"' in text
    assert f'it is "{method}"' in text
    build(thrown(floor(0.0)).replace(run=run))  # the twin


def test_a_contact_that_hardens_is_refused_with_one_that_does() -> None:
    """The compliance that is told is taken, and goes as deep as is told."""
    text = refused(thrown(floor(0.5, compliance=None)))
    assert (
        "obstacle[0].restitution: 0.5 - asks for a compliance (m/N): by default a contact" in text
    )
    told = text.split("else; with ")[1].split(" ")
    assert left(thrown(floor(0.5, compliance=float(told[0]))))[1] / SPEED == pytest.approx(
        0.5, abs=5e-3
    )
    assert "a node of 0.1 kg that comes with 2 m/s goes 1 mm deep" in text


def test_what_turns_freely_is_refused() -> None:
    body = Sphere(
        center=(0, -0.1, 0), radius=0.1, restitution=0.5, compliance=softness(),
        spin=Spin(free=True, inertia=1e-3),
    )  # fmt: skip
    assert (
        "obstacle[0].restitution: 0.5 - is of bodies that stand, or move as they are told"
        in refused(thrown(body))
    )
    build(thrown(body.replace(spin=Spin(rate=1.0))))


@pytest.mark.parametrize(
    ("value", "rule"), [("-0.1", "at least 0"), ("1.01", "at most 1"), ("nan", "finite number")]
)
def test_a_faulty_share_is_refused(value: str, rule: str) -> None:
    text = (
        f'[[rope]]\nsegments = 1\nlength = 1\n[[obstacle]]\nkind = "plane"\nrestitution = {value}\n'
    )
    with pytest.raises(SceneError, match=rule) as told:
        loads(text)
    assert "obstacle[0].restitution" in str(told.value)


def notes(scene: Scene, words: str) -> list[str]:
    return [note for note in rw.check(scene, measure=False).warnings if words in note]


def test_check_says_where_it_goes_too_little_deep_or_too_deep() -> None:
    (shallow,) = notes(thrown(floor(0.5, compliance=softness(1e-4))), "goes in by")
    assert (
        "comes with 2 m/s, the fastest to reckon with, goes in by 0.1 mm, 10 tolerances" in shallow
    )
    assert (
        "take a run.tolerance of at most 3.3e-06 m, or a compliance of at least 2.3e-07 m/N"
        in shallow
    )
    (far,) = notes(thrown(floor(0.5, compliance=softness(0.02))), "goes in by")
    assert "goes in by 20 mm, where 5 mm are half of the rope" in far
    assert "take a compliance of at most 6.2e-05 m/N" in far
    assert not notes(thrown(floor(0.5)), "goes in by")
    assert not notes(thrown(floor(0.0, compliance=softness(1e-4))), "goes in by")


def test_check_says_that_links_which_push_strike_with_more() -> None:
    scene = level(0.5)
    rod = scene.ropes[0].replace(made_of=Material(EA=math.inf, mass_per_length=0.1))
    (note,) = notes(scene.replace(ropes=[rod]), "the links of rope")
    assert note.startswith("obstacle 'floor': its restitution is that of a node on its own")
    assert not notes(scene, "the links of rope")


def test_check_says_what_a_start_in_touch_is_thrown_back_with() -> None:
    """A damper that takes hold only at the surface takes less: as in the run."""
    scene = thrown(floor(0.3), height=0.0)
    (note,) = notes(scene, "thrown back")
    share = float(note.split("with about ")[1].split(" ")[0])
    assert f"with about {share:g} of that (its restitution is 0.3)" in note
    assert share > 0.32
    assert left(scene)[1] / SPEED == pytest.approx(share, abs=0.01)
    assert not notes(thrown(floor(0.3), height=0.01), "thrown back")


def test_the_lab_refuses_it_by_name() -> None:
    from ropewalk.live.lab import lab_scene

    with pytest.raises(SceneError, match=r"obstacle\[0\].restitution: the lab has no restitution"):
        lab_scene(thrown(floor(0.5)))
