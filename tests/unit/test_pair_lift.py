"""How fast the offset grows that lifts ropes out of each other at rest: smoothly, and not for ever."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.core.arrays import State, System
from ropewalk.laws.pairs.force import squeeze
from ropewalk.laws.pairs.lift import (
    DEEP,
    EASES,
    LOSES,
    MORE_FORCE,
    MOST,
    NEAR,
    RATE,
    SAME,
    SHALLOW,
    SPARE,
    STILL,
    TOUCHES,
    WAITS,
    climb_to,
    lift_pairs,
    period_of,
    raise_pairs,
)
from ropewalk.laws.pairs.table import (
    BASE,
    CLIMB,
    CONTACTS,
    DEPTH,
    LAYER,
    LIFT,
    PUSH,
    SPRING,
    VAIN,
    spring_of,
)
from ropewalk.lowering import build
from ropewalk.scene import Anchor, Contact, Load, Material, Rope, RunSettings, Scene, Straight

D = 0.01
STEP = 1.0 / 60.0


def crossed(depth: float, load: float = 0.0, **contact: float) -> tuple[System, State]:
    """Two bars across each other, pressed by so much of D, with what their contact remembers."""
    stuff = {"segments": 1, "length": 0.2, "diameter": D}
    stuff |= {"made_of": Material(EA=1e4, mass_per_length=0.1)}
    low = Straight(start=(-0.1, 0, 0), end=(0.1, 0, 0))
    high = Straight(start=(0, -0.1, D), end=(0, 0.1, D))
    loads = [Load(node=0, mass=load)] if load else []
    scene = Scene(
        gravity=(0, 0, 0),
        ropes=[
            Rope(name="a", shape=low, **stuff),
            Rope(name="b", shape=high, loads=loads, **stuff),
        ],
        anchors=[Anchor(rope=name, node=k) for name in "ab" for k in (0, 1)],
        contact=Contact(**({"friction": 0.3} | contact)),
        run=RunSettings(method="implicit-euler", time_step=STEP, frame_rate=60),
    )
    model = build(scene, drawn=False)
    assert model.state.memory.contact.tally[CONTACTS] == 1
    press(model.system, model.state, depth)
    return model.system, model.state


def press(system: System, state: State, depth: float, force: float | None = None) -> None:
    """Put the upper bar where it is pressed by so much of D, with such a force [N]; negative: apart."""
    memory = state.memory.contact
    state.x[2, 2:] = D * (1.0 - depth)
    memory.grip[0, DEPTH] = depth * D
    soft, hard, stop, _, _ = spring_of(system.node.contact, memory.grip, 0, *memory.pair[0])
    counts = depth * D + memory.grip[0, LIFT]
    own = max(squeeze(counts, soft, hard, stop, LAYER * D)[0], 0.0)
    memory.grip[0, PUSH] = own if force is None else force


def go(
    system: System,
    state: State,
    *,
    steps: int = 1,
    way: tuple[float, float] = (0, 0),
    dt: float = STEP,
) -> float:
    """Take so many steps at that place, the upper bar moving up and along in each [m]; return the offset."""
    memory = state.memory.contact
    memory.way[...] = 0.0
    memory.way[2, 2:], memory.way[0, 2:] = way
    for _ in range(steps):
        climb_to(memory, 0, dt)
        lift_pairs(dt, system.node.contact, memory)
    return float(memory.grip[0, LIFT])


def carried(system: System, state: State, depth: float, steps: int) -> list[float]:
    """Let it be lifted as under a weight: as much less deep, by the same force; return all rates [m/s]."""
    grip, rates = state.memory.contact.grip, []
    force = float(grip[0, PUSH])
    for _ in range(steps):
        press(system, state, depth - grip[0, LIFT] / D, force)
        go(system, state)
        rates.append(float(grip[0, CLIMB]))
    return rates


def test_what_lies_too_deep_rises_slowly_and_smoothly_until_it_is_shallow() -> None:
    """Its rate never jumps by more than its easing allows, up or down; then it stands for ever."""
    system, state = crossed(0.02)
    rates = np.array(carried(system, state, 0.02, 360)) / D
    grip = state.memory.contact.grip
    assert not rates[: round(WAITS / STEP) - 1].any()
    assert rates.min() >= 0.0
    assert rates.max() == pytest.approx(RATE)
    assert np.abs(np.diff(rates)).max() <= RATE * STEP / EASES * (1.0 + 1e-9) + NEAR / EASES
    assert grip[0, LIFT] / D == pytest.approx(0.02 - SHALLOW, abs=1.1 * NEAR)
    assert not rates[-60:].any()
    for depth in (TOUCHES + 1e-6, SHALLOW, DEEP - 1e-6):  # within the band it stands
        press(system, state, depth)
        before = float(grip[0, LIFT])
        assert go(system, state, steps=120) == before


def test_within_a_step_it_is_that_of_each_time() -> None:
    """Known as the step begins: whatever is tried in between, its end is the same; never under nothing."""
    system, state = crossed(0.02)
    memory = state.memory.contact
    carried(system, state, 0.02, 60)
    base, rate = float(memory.grip[0, BASE]), float(memory.grip[0, CLIMB])
    assert rate > 0.0
    for since in (0.0, 0.3 * STEP, STEP, 0.5 * STEP):
        raise_pairs(memory, since)
        assert memory.grip[0, LIFT] == base + rate * since
    assert climb_to(memory, 0, 0.5 * STEP) == pytest.approx(0.5 * rate * STEP)
    memory.grip[0, CLIMB] = -1.0
    raise_pairs(memory, STEP)
    assert memory.grip[0, LIFT] == 0.0
    assert climb_to(memory, 0, STEP) == pytest.approx(-(base + 0.5 * rate * STEP))


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
    grip = state.memory.contact.grip
    grip[0, BASE] = grip[0, LIFT] = 0.01 * D  # as after an edit
    rates = []
    for _ in range(240):
        go(system, state)
        rates.append(float(grip[0, CLIMB]) / D)
    assert grip[0, LIFT] == pytest.approx(0.0, abs=1e-12)
    assert min(rates) == pytest.approx(-RATE, rel=1e-9)


@pytest.mark.parametrize(("share", "rises"), [(SPARE - 1e-3, True), (SPARE + 1e-3, False)])
def test_what_is_near_the_limit_of_friction_is_left(share: float, rises: bool) -> None:
    system, state = crossed(0.02)
    grip = state.memory.contact.grip
    grip[0, SPRING] = share * 0.3 * grip[0, PUSH]
    assert (go(system, state, steps=60) > 0.0) == rises


@pytest.mark.parametrize("axis", [0, 1])
def test_what_moves_is_not_lifted(axis: int) -> None:
    """Along the normal or across it; slower than that, as what is lifted itself goes, it is."""
    for speed, rises in ((0.99 * STILL, True), (1.01 * STILL, False)):
        system, state = crossed(0.02)
        way = (speed * D * STEP, 0.0) if axis == 0 else (0.0, speed * D * STEP)
        assert (go(system, state, steps=60, way=way) > 0.0) == rises
    assert RATE < STILL


@pytest.mark.parametrize("load", [0.0, 5.0])
def test_a_swing_is_not_rest_however_slow(load: float) -> None:
    """Of the heaviest that may be carried, its force by 5 % up and down in the period of that: none rises."""
    for swing, rises in ((0.05, False), (0.4 * SAME, True)):
        system, state = crossed(0.02, load)
        grip = state.memory.contact.grip
        period, force = period_of(system.node.contact, 0, 2), float(grip[0, PUSH])
        assert (period > 0.5) == (load > 0.0)
        steps = max(round(period / STEP), 40)
        for k in range(4 * steps):
            press(system, state, 0.02, force * (1.0 + swing * np.sin(2.0 * np.pi * k / steps)))
            go(system, state)
            grip[0, BASE] = grip[0, LIFT] = min(grip[0, LIFT], 1e-3 * D)
            if rises and grip[0, CLIMB] > 0.0:
                break
        assert (grip[0, CLIMB] > 0.0) == rises


def test_what_does_not_give_way_is_let_down_again() -> None:
    """Held in place it presses more as it is lifted: twice, by less than a fifth, and never again."""
    system, state = crossed(0.02)
    grip, force = state.memory.contact.grip, []
    for _ in range(1200):
        press(system, state, 0.02)
        go(system, state)
        force.append(float(grip[0, PUSH]))
    assert MORE_FORCE < max(force) / force[0] < 1.2
    assert grip[0, VAIN] == 2.0
    assert grip[0, LIFT] == pytest.approx(0.0, abs=1e-12)
    assert np.ptp(force[-300:]) == 0.0


def test_an_offset_stands_in_a_swing_and_is_lost_by_sliding() -> None:
    """By half of what friction takes, over the force, while that is at its limit; else not."""
    system, state = crossed(0.02)
    carried(system, state, 0.02, 300)
    grip = state.memory.contact.grip
    there = float(grip[0, LIFT])
    assert there > 0.012 * D
    assert go(system, state, steps=60, way=(1.0 * D * STEP, 0.0)) == there
    assert go(system, state, steps=60, way=(0.0, 0.1 * D)) == there
    grip[0, PUSH], grip[0, SPRING : SPRING + 3] = 1.0, (0.3, 0.0, 0.0)
    go(system, state, way=(0.0, 0.01 * D))
    assert grip[0, CLIMB] * STEP == pytest.approx(-LOSES * 0.3 * 0.01 * D)
    grip[0, CLIMB], grip[0, SPRING] = 0.0, 0.299
    go(system, state, way=(0.0, 0.01 * D))
    assert grip[0, CLIMB] == 0.0


def test_what_parts_is_let_down() -> None:
    """At once where that changes no force, as far as it touches a little then; else in some steps."""
    system, state = crossed(0.02)
    carried(system, state, 0.02, 300)
    grip = state.memory.contact.grip
    there = float(grip[0, LIFT])
    press(system, state, -0.001)
    assert grip[0, PUSH] > 0.0
    go(system, state)
    assert grip[0, CLIMB] < 0.0
    assert grip[0, LIFT] == there
    press(system, state, -0.02, 0.0)
    go(system, state)
    assert grip[0, LIFT] == 0.0


def test_what_counts_as_open_by_a_plane_that_errs_is_lifted() -> None:
    """1.5 % deep, open by its plane: it presses by so much that it comes out, as what lies there asks for."""
    system, state = crossed(0.015)
    grip = state.memory.contact.grip
    soft, hard, stop, _, _ = spring_of(system.node.contact, grip, 0, 0, 2)
    weight, depth = 0.2 * LAYER * D * soft, 0.015
    for _ in range(600):
        counts = depth * D - 0.01 * D - 0.015 * D + grip[0, LIFT]
        force = max(squeeze(counts, soft, hard, stop, LAYER * D)[0], 0.0)
        depth -= max(force - weight, 0.0) / soft / D
        press(system, state, depth, force)
        go(system, state)
    assert grip[0, LIFT] > 0.01 * D
    assert depth < SHALLOW + 2.0 * NEAR


def test_it_never_rises_by_more_than_most_in_all() -> None:
    system, state = crossed(0.02)
    grip = state.memory.contact.grip
    total = 0.0
    for _ in range(20):
        press(system, state, 0.02)
        before = float(grip[0, LIFT])
        carried(system, state, 0.02, 300)
        total += float(grip[0, LIFT]) - before
        press(system, state, -0.05, 0.0)
        go(system, state)
    assert total == pytest.approx(MOST * D, rel=2e-2)
