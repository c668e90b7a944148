"""What stops ropes that strike each other, by itself: against an inelastic hit's closed form."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from ropewalk.core.arrays import Floats, State, System
from ropewalk.laws.pairs.brake import ALL_BUT, SLOW, SOFT
from ropewalk.laws.pairs.force import pair_forces
from ropewalk.laws.pairs.law import CONTACT
from ropewalk.laws.pairs.table import BRAKE, CONTACTS, PUSH, SEEN
from ropewalk.lowering import build
from ropewalk.scene import Contact, Load, Material, Rope, RunSettings, Scene, Straight

THICK = 0.01  # [m]
NEAR = 1.0 + 0.09  # so many diameters apart the links begin: within the reach of contacts
STEP = 2e-6  # [s], within the bound of explicit steps
STUFF = Material(EA=1e4, mass_per_length=0.05)


def link(name: str, shape: Straight, **more: Any) -> Rope:
    """Return a link of 20 cm."""
    return Rope(
        name=name, segments=1, length=0.2, diameter=THICK, made_of=STUFF, shape=shape, **more
    )


def crossing(speed: float, load: float, aside: float) -> tuple[System, State]:
    """Two links, of which one comes down on the other beside both their middles."""
    still = link(
        "still",
        Straight(start=(-0.1 - aside, 0, 0), end=(0.1 - aside, 0, 0)),
        loads=[Load(node=1, mass=load)] if load else [],
    )
    start, end = (0, NEAR * THICK, -0.1 + aside), (0, NEAR * THICK, 0.1 + aside)
    flies = link("flies", Straight(start=start, end=end, velocity=(0, -speed, 0)))
    run = RunSettings(method="semi-implicit-euler", time_step=STEP, duration=0.1)
    model = build(
        Scene(ropes=[still, flies], contact=Contact(friction=0.0), gravity=(0, 0, 0), run=run),
        drawn=False,
    )
    return model.system, model.state


def fly(system: System, state: State, brakes: bool) -> None:
    """Let both go on, with nothing but their contact, until they have parted or for 2 ms."""
    table, force = system.node.contact, np.zeros_like(state.x)
    for n in range(1000):
        pair_forces(state.x, state.v, table, state.memory.contact, force, 0, state.x.shape[1])
        state.v[...] += STEP * force * state.inverse_mass
        state.x[...] += STEP * state.v
        state.now[:] = (n + 1) * STEP, n * STEP
        CONTACT.remember(table, state)
        if not brakes:
            state.memory.contact.grip[:, BRAKE] = 0.0


def inelastic(state: State, speed: float, aside: float) -> Floats:
    """Velocities [m/s] of the nodes after a hit that leaves the points where it is no normal velocity."""
    s, t = (0.1 + aside) / 0.2, (0.1 - aside) / 0.2
    share = np.array([1.0 - s, s, t - 1.0, -t])
    impulse = speed / (share**2 @ state.inverse_mass)
    left: Floats = state.v[1] - impulse * share * state.inverse_mass
    return left


@pytest.mark.parametrize("aside", [0.0, 0.04])
@pytest.mark.parametrize("load", [0.0, 0.5])
@pytest.mark.parametrize("speed", [1.0, 5.0, 20.0])
def test_a_hit_is_inelastic(speed: float, load: float, aside: float) -> None:
    """The points go on together, momentum is kept to rounding, and each node has what mechanics says."""
    system, state = crossing(speed, load, aside)
    before, expected = float(state.mass @ state.v[1]), inelastic(state, speed, aside)
    fly(system, state, brakes=True)
    assert float(state.mass @ state.v[1]) == pytest.approx(before, rel=1e-12)
    assert np.abs(state.v[1] - expected).max() < 0.07 * speed
    twin_system, twin = crossing(speed, load, aside)
    fly(twin_system, twin, brakes=False)
    assert np.abs(twin.v[1] - expected).max() > 0.2 * speed


def test_what_parts_or_comes_slowly_meets_no_drag() -> None:
    """No drag of what goes apart; of what comes slowly less than the damper that is there anyhow."""
    for speed in (-1.0, 1e-3):
        system, state = crossing(speed, 0.0, 0.0)
        state.now[:] = STEP, 0.0
        CONTACT.remember(system.node.contact, state)
        memory = state.memory.contact
        assert memory.tally[CONTACTS] == 1
        table = system.node.contact
        stiff = 1.0 / (table.soft[0] + table.soft[2])
        damper = 2.0 * (stiff * 0.5 * table.mass[0]) ** 0.5
        assert 0.0 <= memory.grip[0, BRAKE] < (damper if speed > 0.0 else 1e-300)


def test_an_explicit_step_takes_no_more_than_half() -> None:
    """However long a step is: m u^2 / S would turn round what comes at 20 m/s in steps of 0.1 ms."""
    for step in (1e-4, 1e-5):
        system, state = crossing(20.0, 0.0, 0.0)
        state.now[:] = step, 0.0
        CONTACT.remember(system.node.contact, state)
        together = 1.0 / (0.25 * state.inverse_mass.sum())
        assert state.memory.contact.grip[0, BRAKE] == pytest.approx(0.5 * together / step)


@pytest.mark.parametrize(("step", "most"), [(1e-3, ALL_BUT / 1e-3), (1e-6, np.inf)])
def test_a_step_that_is_solved_for_takes_what_the_step_before_allows(
    step: float, most: float
) -> None:
    """m u^2 / S, but no quicker than so many times in a step."""
    system, state = crossing(20.0, 0.0, 0.0)
    state.now[:] = step, 0.0
    state.memory.contact.tally[SEEN] = 1
    CONTACT.remember(system.node.contact, state)
    together = 1.0 / (0.25 * state.inverse_mass.sum())
    rate = min(20.0 / (SOFT * THICK), most)
    assert state.memory.contact.grip[0, BRAKE] == pytest.approx(rate * together)


@pytest.mark.parametrize("way", [0.5, 2.0])
def test_what_is_stopped_in_a_step_too_long_to_follow_counts_as_hit(way: float) -> None:
    """From a way of SLOW of the radii's sum on; not where nothing pressed in the step, nor what parts."""
    system, state = crossing(20.0, 0.0, 0.0)
    table, memory = system.node.contact, state.memory.contact
    state.now[:] = 1e-3, 0.0
    memory.tally[SEEN] = 1
    CONTACT.remember(table, state)
    memory.grip[0, PUSH] = 1.0
    step, force = way * SLOW * THICK / 20.0, np.ones((6, state.x.shape[1]))
    hit = CONTACT.hits(table, state, force, step, state.x, state.v)
    assert (hit > 0.0) == (way > 1.0)
    assert CONTACT.hits(table, state, 0.0 * force, step, state.x, state.v) == 0.0
    state.v[...] *= -1.0
    assert CONTACT.hits(table, state, force, step, state.x, state.v) == 0.0
