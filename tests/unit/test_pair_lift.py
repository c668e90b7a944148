"""The offset that lifts ropes out of each other at rest: a ratchet with a dead band, that drives nothing."""

from __future__ import annotations

import math

import numpy as np
import pytest

from ropewalk.core.arrays import State, System
from ropewalk.laws.pairs.force import squeeze
from ropewalk.laws.pairs.lift import (
    DEEP,
    HEAVY,
    LOSES,
    MOST,
    RATE,
    SHALLOW,
    STILL,
    TOUCHES,
    WAITS,
    lift_pairs,
)
from ropewalk.laws.pairs.table import (
    CONTACTS,
    DEPTH,
    GIVEN,
    LAYER,
    LIFT,
    PUSH,
    RESTED,
    SPRING,
    spring_of,
)
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Contact, Material, Rope, RunSettings, Scene, Straight

D = 0.01
STEP = 1.0 / 60.0


def crossed(depth: float, **contact: float) -> tuple[System, State]:
    """Two bars across each other, pressed by so much of D, with what their contact remembers."""
    stuff = {"segments": 1, "length": 0.2, "diameter": D}
    stuff |= {"made_of": Material(EA=1e4, mass_per_length=0.1)}
    low = Straight(start=(-0.1, 0, 0), end=(0.1, 0, 0))
    high = Straight(start=(0, -0.1, D), end=(0, 0.1, D))
    scene = Scene(
        gravity=(0, 0, 0),
        ropes=[Rope(name="a", shape=low, **stuff), Rope(name="b", shape=high, **stuff)],
        anchors=[Anchor(rope=name, node=k) for name in "ab" for k in (0, 1)],
        contact=Contact(**({"friction": 0.3} | contact)),
        run=RunSettings(method="implicit-euler", time_step=STEP, frame_rate=60),
    )
    model = build(scene, drawn=False)
    assert model.state.memory.contact.tally[CONTACTS] == 1
    press(model.state, depth)
    return model.system, model.state


def press(state: State, depth: float) -> None:
    """Put the upper bar where it is pressed by so much of D; negative: apart."""
    state.x[2, 2:] = D * (1.0 - depth)
    state.memory.contact.grip[0, DEPTH] = depth * D


def go(system: System, state: State, *, steps: int = 1, way: tuple[float, float] = (0, 0)) -> float:
    """Take so many steps at that place, the upper bar moving up and along in each [m]; return the offset."""
    memory = state.memory.contact
    memory.way[...] = 0.0
    memory.way[2, 2:], memory.way[0, 2:] = way
    for _ in range(steps):
        lift_pairs(state.x, STEP, system.node.contact, memory)
    return float(memory.grip[0, LIFT])


def test_what_lies_too_deep_rises_slowly_until_it_is_shallow_and_stays() -> None:
    """The bar follows, as a weight would: no more than RATE allows, nothing in the first moments."""
    system, state = crossed(0.02)
    assert go(system, state, steps=math.floor(WAITS / STEP)) == 0.0
    before, found = 0.0, []
    for _ in range(240):
        press(state, 0.02 - before / D)
        after = go(system, state)
        assert 0.0 <= after - before <= RATE * D * STEP * (1.0 + 1e-9)
        before = after
        found.append(after)
    assert found[-1] == pytest.approx((0.02 - SHALLOW) * D, rel=1e-9)
    assert found[60] < 0.9 * found[-1]
    for depth in (TOUCHES + 1e-6, SHALLOW, DEEP - 1e-6):  # within the band it stands
        press(state, depth)
        assert go(system, state, steps=60) == found[-1]


@pytest.mark.parametrize("depth", [0.0, SHALLOW, DEEP - 1e-6])
def test_what_is_no_deeper_is_left(depth: float) -> None:
    system, state = crossed(depth)
    assert go(system, state, steps=300) == 0.0


@pytest.mark.parametrize("contact", [{"friction": 0.0}, {"compliance": 1e-3}])
def test_without_friction_or_with_a_compliance_of_its_own_a_contact_is_left(
    contact: dict[str, float],
) -> None:
    system, state = crossed(0.02, **contact)
    assert go(system, state, steps=300) == 0.0


def test_what_bears_much_is_left() -> None:
    for share, rises in ((0.9, True), (1.1, False)):
        system, state = crossed(0.02)
        grip = state.memory.contact.grip
        soft = spring_of(system.node.contact, grip, 0, 0, 2)[0]
        grip[0, PUSH] = share * HEAVY * LAYER * D * soft
        assert (go(system, state, steps=60) > 0.0) == rises


@pytest.mark.parametrize("axis", [0, 1])
def test_what_moves_is_not_lifted_and_has_to_rest_anew(axis: int) -> None:
    """Along the normal or across it; slower than that, as what is lifted itself goes, it is."""
    for speed, rises in ((0.99 * STILL, True), (1.01 * STILL, False)):
        system, state = crossed(0.02)
        way = (speed * D * STEP, 0.0) if axis == 0 else (0.0, speed * D * STEP)
        assert (go(system, state, steps=60, way=way) > 0.0) == rises
    assert state.memory.contact.grip[0, RESTED] == 0.0
    assert RATE < STILL


def test_an_offset_stands_in_a_swing_and_is_lost_by_sliding() -> None:
    """By half of what friction takes, over the force, while that is at its limit; else not."""
    system, state = crossed(0.02)
    there = go(system, state, steps=180)
    assert there > 0.005 * D
    assert go(system, state, steps=60, way=(1.0 * D * STEP, 0.0)) == there
    assert go(system, state, steps=60, way=(0.0, 0.1 * D)) == there
    grip = state.memory.contact.grip
    grip[0, PUSH], grip[0, SPRING : SPRING + 3] = 1.0, (0.3, 0.0, 0.0)
    assert go(system, state, way=(0.0, 0.01 * D)) == pytest.approx(there - LOSES * 0.3 * 0.01 * D)
    grip[0, SPRING] = 0.299
    left = float(grip[0, LIFT])
    assert go(system, state, way=(0.0, 0.01 * D)) == left
    grip[0, SPRING] = 0.3
    assert go(system, state, way=(0.0, 10.0 * D)) == 0.0


def test_what_parts_is_let_down_at_once() -> None:
    """As far as it touches a little then, and never up."""
    system, state = crossed(0.02)
    there = go(system, state, steps=180)
    press(state, -0.001)
    assert go(system, state) == pytest.approx(there - (TOUCHES + 0.001) * D)
    press(state, -0.05)
    assert go(system, state) == 0.0


def test_it_never_rises_by_more_than_most_in_all() -> None:
    """Pressed and parted again and again, which would feed a swing: it rises ten times at most."""
    system, state = crossed(0.02)
    grip, rises = state.memory.contact.grip, []
    for _ in range(40):
        press(state, 0.02)
        before = grip[0, LIFT]
        rises.append(go(system, state, steps=180) - before)
        press(state, -0.05)
        go(system, state)
    assert rises[0] > 0.012 * D
    assert sum(rises) == pytest.approx(MOST * D, rel=1e-9)
    assert max(rises[5:]) == 0.0


def test_what_it_gives_is_booked_as_the_integral_of_the_force_over_it() -> None:
    """In the skin and beyond; what lets down is taken back alike."""
    system, state = crossed(0.018)
    memory = state.memory.contact
    spring = spring_of(system.node.contact, memory.grip, 0, 0, 2)
    there = go(system, state, steps=180)
    way = np.linspace(0.0, there, 2001)
    force = [squeeze(0.018 * D + e, *spring[:3], LAYER * D)[0] for e in way]
    assert there + 0.018 * D > LAYER * D
    assert memory.books[GIVEN] == pytest.approx(float(np.trapezoid(force, way)), rel=1e-6)
    press(state, 0.018)
    state.memory.contact.grip[0, DEPTH] = -0.1 * D
    assert go(system, state) == 0.0
    assert abs(memory.books[GIVEN]) < 1e-9 * float(np.trapezoid(force, way))
