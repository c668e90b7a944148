"""What lies on ropes is lifted out of them: by how much, what that gives, and which forces are told."""

from __future__ import annotations

import math

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.laws.pairs.table import CONTACTS, DEPTH, LAYER, LIFT, PUSH, spring_of
from ropewalk.scene import (
    Air,
    Anchor,
    Contact,
    Force,
    Material,
    Points,
    Rope,
    RunSettings,
    Scene,
    Straight,
)
from ropewalk.simulation import Simulation
from ropewalk.statics import checked_shape

D = 0.01
g = 9.81


def laid(mass_per_length: float, time_step: float = 1.0 / 60.0, friction: float = 0.3) -> Scene:
    """A bar of so much [kg/m], laid across two ropes along x that are held everywhere."""
    stuff = {"diameter": D, "made_of": Material(EA=1e4, mass_per_length=mass_per_length)}
    held = [
        Rope(
            name=name,
            segments=1,
            length=0.2,
            shape=Straight(start=(-0.1, y, 0), end=(0.1, y, 0)),
            **stuff,
        )
        for name, y in (("a", -0.05), ("b", 0.05))
    ]
    shape = Straight(start=(0.01, -0.1, D), end=(0.01, 0.1, D))
    return Scene(
        ropes=[*held, Rope(name="bar", segments=1, length=0.2, shape=shape, **stuff)],
        anchors=[Anchor(rope=name, node=k) for name in "ab" for k in (0, 1)],
        contact=Contact(friction=friction),
        run=RunSettings(method="implicit-euler", time_step=time_step, frame_rate=60, duration=3.0),
    )


@pytest.mark.parametrize("mass_per_length", [0.03, 0.1])
@pytest.mark.parametrize("time_step", [1.0 / 60.0, 1.0 / 6000.0])
def test_it_is_lifted_and_the_books_say_what_that_gave(
    mass_per_length: float, time_step: float
) -> None:
    """Less than a hundredth of the diameter deep, where skin alone lets it sink in by two and more.

    All entries together are what weight gives on the way down, as it lies still at both ends; in short steps
    the motor is what lifts it, weight times way. In long ones it is more: a step's rise presses more, of
    which the squeeze takes the rest.
    """
    scene = laid(mass_per_length, time_step)
    result = rw.simulate(scene)
    simulation = Simulation(scene)
    simulation.step(3.0)
    memory, table = simulation.arrays.memory.contact, simulation.system.node.contact
    gap, weight = float(result.rope("bar").positions[-1, 0, 2]) - D, 0.2 * mass_per_length * g
    more, push = memory.grip[:2, LIFT], memory.grip[:2, PUSH]
    assert push == pytest.approx(0.5 * weight, rel=1e-6)
    assert (push > LAYER * D * spring_of(table, memory.grip, 0, *memory.pair[0])[0]).all()
    assert -gap == pytest.approx(0.007 * D, rel=1e-3)
    assert (more > 0.013 * D).all()
    books = result.contact_work["ropes on ropes"]
    assert np.abs(sum(books.values()) - result.work["contact"]).max() < 1e-13
    assert np.diff(books["motor"]).min() >= 0.0
    entries = {name: float(entry[-1]) for name, entry in books.items()}
    assert sum(entries.values()) == pytest.approx(weight * gap, rel=1e-5)
    least = weight * float(more[0])
    assert least * 0.999 < entries["motor"] < least * (1.02 if time_step < 1e-3 else 2.0)
    assert entries["normal"] < 0.0
    assert np.abs(result.velocities[-1]).max() < 1e-9


def test_the_forces_told_are_those_that_act() -> None:
    """In every step of the way up: mass times acceleration, less the weight; and those of the table.

    Not in the steps in which it fell on them: what is told there is the force at their end, not their mean.
    """
    result = rw.simulate(laid(0.1))
    hit = 5
    bar = result.rope("bar")
    mass = 0.1 * 0.2
    rate = np.diff(bar.velocities[:, :, 2].mean(axis=1)) * 60.0
    acts = mass * (rate + g)[hit:]
    told = result.contact_force[1:, 4:, 2].sum(axis=1)[hit:]
    assert np.abs(told - acts).max() < 1e-8 * mass * g
    table = result.to_pandas("rope_contacts").groupby("time [s]")["normal force [N]"].sum()
    table = table.reindex(result.time[1:], fill_value=0.0).to_numpy()[hit:]
    assert np.abs(table - acts).max() < 1e-8 * mass * g
    rising = np.diff(bar.positions[:, 0, 2])[10:]
    assert (rising > 1e-4 * D).sum() > 30  # else nothing would be shown


@pytest.mark.parametrize(("share", "slips"), [(0.95, False), (0.99, False), (1.01, True)])
def test_what_holds_on_a_slope_holds_as_it_is_lifted(share: float, slips: bool) -> None:
    """The bar on ropes that lead down by such a share of the angle of friction: 1e-6 mm in four seconds.

    The twin beyond that angle slides as fast as it should.
    """
    angle = math.atan(share * 0.3)
    down = g * np.array([math.sin(angle), 0.0, -math.cos(angle)])
    scene = laid(0.1).replace(gravity=tuple(down))
    result = rw.simulate(scene.replace(run=scene.run.replace(duration=1.0 if slips else 5.0)))
    bar, memory = result.rope("bar"), result.contact_work["ropes on ropes"]
    assert (memory["motor"][-1] > 0.0) != slips
    if slips:
        late = bar.velocities[[30, 60], :, 0].mean(axis=1)
        right = g * (math.sin(angle) - 0.3 * math.cos(angle))
        assert np.diff(late)[0] / 0.5 == pytest.approx(right, rel=0.01)
        return
    assert np.abs(bar.positions[60:, :, :2] - bar.positions[60, :, :2]).max() < 1e-9
    assert -(float(bar.positions[-1, 0, 2]) - D) < 0.01 * D


def wrapped(share: float) -> Scene:
    """A cord half round a thick rope that is held, one end pulled by 0.3 N.

    The other end has so much of what friction can hold, as a power of it.
    """
    radius, low = 0.035, 0.3
    turn = np.linspace(math.pi, 0.0, 13)
    points = np.stack([radius * np.cos(turn), 0.0 * turn, radius * np.sin(turn)], axis=1)
    one = np.arange(1.0, 9.0)[:, None] * radius * math.pi / 12.0 * np.array([0.0, 0.0, 1.0])
    points = np.vstack([points[0] - one[::-1], points, points[-1] - one])
    pull = low * math.exp(0.3 * math.pi * share)
    cord = Rope(
        name="cord",
        segments=len(points) - 1,
        length=float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum()),
        diameter=D,
        made_of=Material(EA=1e4, mass_per_length=0.02, axial_damping=2.0),
        shape=Points(points=points.tolist()),
        forces=[Force(node=0, force=(0, 0, -low)), Force(node=-1, force=(0, 0, -pull))],
    )
    post = Rope(
        name="post",
        segments=1,
        length=0.4,
        diameter=0.06,
        made_of=Material(EA=1e6, mass_per_length=1.0),
        shape=Straight(start=(0, -0.2, 0), end=(0, 0.2, 0)),
    )
    return Scene(
        gravity=(0, 0, 0),
        ropes=[post, cord],
        anchors=[Anchor(rope="post", node=0), Anchor(rope="post", node=1)],
        contact=Contact(friction=0.3),
        air=Air(node_drag=0.05),
        run=RunSettings(
            method="implicit-euler", time_step=1.0 / 240.0, frame_rate=60, duration=12.0
        ),
    )


@pytest.mark.parametrize("share", [0.9, 0.99])
def test_a_cord_about_a_rope_is_lifted_and_holds(share: float) -> None:
    """It needs more cord, which slips in, from the end that is pulled less: the other one goes by less than
    the offsets' depth. Then it is at rest: 1e-6 mm in two seconds.
    """
    simulation = Simulation(wrapped(share))
    deep, places = 0.0, {}
    for second in range(1, 13):
        simulation.step(1.0)
        grip = simulation.arrays.memory.contact.grip[
            : simulation.arrays.memory.contact.tally[CONTACTS]
        ]
        deep = float((grip[:, DEPTH] / 0.035).max())
        places[second] = simulation.arrays.x.copy()
    assert (grip[:, LIFT] > 0.001 * 0.035).sum() > 6
    assert deep < 0.01
    assert np.abs(places[12] - places[10]).max() < 1e-9
    assert abs(places[12][2, -1] - places[1][2, -1]) < LAYER * 0.035
    assert places[12][2, 2] - places[1][2, 2] > 0.5e-3  # else no cord would have come in


def test_rest_is_that_of_the_run() -> None:
    """Found by creeping, it is as deep, and a run that begins there stays there, and is given nothing."""
    scene = laid(0.1)
    rest = checked_shape(scene)
    run = rw.simulate(scene)
    assert np.abs(rest.positions - run.positions[-1]).max() < 1e-4 * D
    begun = rw.simulate(scene.replace(run=scene.run.replace(start="at-rest", duration=1.0)))
    assert np.abs(begun.positions - rest.positions).max() < 1e-9
    assert not begun.contact_work["ropes on ropes"]["motor"].any()


def test_the_twin_without_friction_lies_as_deep_as_its_skin_lets_it() -> None:
    result = rw.simulate(laid(0.1, friction=0.0))
    assert float(result.rope("bar").positions[-1, 0, 2]) < D * (1.0 - LAYER)
    assert not result.contact_work["ropes on ropes"]["motor"].any()
