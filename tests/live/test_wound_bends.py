"""What is carried over into another scene while a winch winds a rope with bending stiffness."""

from __future__ import annotations

import numpy as np
import pytest

from ropewalk.live.carry import carry_over
from ropewalk.scene import Anchor, Clamp, Material, Rope, Scene, Straight, Winch
from ropewalk.simulation import Simulation


@pytest.mark.parametrize("speed", [0.5, -0.5])
@pytest.mark.parametrize("clamped", [True, False])
def test_bends_at_a_drum_stay_as_they_are(clamped: bool, speed: float) -> None:
    """A bend counts for the length that is there, and not for what the scene began with."""
    clamp = {"clamp": Clamp(direction=(1, 0, 0))} if clamped else {}
    scene = Scene(
        ropes=[
            Rope(
                segments=5,
                length=0.5,
                made_of=Material(EA=40.0, EI=0.02, mass_per_length=0.05, bending_damping=1e-4),
                shape=Straight(start=(0, 0, 0), end=(0.5, 0, 0)),
            )
        ],
        anchors=[Anchor(node=0, **clamp)],
        winches=[Winch(end="start", speed=speed, on_drum=0.4)],
        run={"method": "esdirk3", "time_step": 0.01, "duration": 1.0},
    )
    old = Simulation(scene)
    begun = old.arrays.bending_stiffness.copy()
    old.step(0.3)
    assert old.arrays.winch_exit[0] != old.system.winches.first[0] or speed < 0
    assert not np.array_equal(old.arrays.bending_stiffness, begun)
    new = carry_over(
        old, scene.replace(gravity=(0, 0, -1.0)), np.arange(old.arrays.x.shape[1]) + 0.0
    )
    np.testing.assert_allclose(
        new.arrays.bending_stiffness, old.arrays.bending_stiffness, rtol=1e-12
    )
    np.testing.assert_allclose(new.arrays.bending_damping, old.arrays.bending_damping, rtol=1e-12)
    same = carry_over(old, scene, np.arange(old.arrays.x.shape[1]) + 0.0)
    for one in (old, same):
        one.step(0.2)
    np.testing.assert_allclose(same.positions, old.positions, atol=1e-9)


@pytest.mark.parametrize("speed", [0.5, -0.5])
def test_another_length_of_the_same_bends_is_told_by_none_but_ei(speed: float) -> None:
    """Stiffness, friction and mass of a wound rope change; its bends and their places do not."""
    made_of = Material(EA=40.0, EI=0.02, mass_per_length=0.05, bending_damping=1e-4)
    shape = Straight(start=(0, 0, 0), end=(0.5, 0, 0))
    rope = Rope(segments=5, length=0.5, made_of=made_of, shape=shape)
    scene = Scene(
        ropes=[rope],
        anchors=[Anchor(node=0)],
        winches=[Winch(end="start", speed=speed, on_drum=0.4)],
        run={"method": "esdirk3", "time_step": 0.01, "duration": 1.0},
    )
    old = Simulation(scene)
    old.step(0.3)
    stiffer = rope.replace(made_of=made_of.replace(EA=80.0, mass_per_length=0.1))
    source = np.arange(old.arrays.x.shape[1]) + 0.0
    new = carry_over(old, scene.replace(ropes=[stiffer]), source)
    for name in ("bending_stiffness", "bending_damping"):
        before, after = getattr(old.arrays, name), getattr(new.arrays, name)
        np.testing.assert_allclose(after, before, rtol=1e-12)
    stiffer = rope.replace(made_of=made_of.replace(EI=0.04, bending_damping=3e-4))
    bent = carry_over(old, scene.replace(ropes=[stiffer]), source)
    for name, times in (("bending_stiffness", 2.0), ("bending_damping", 3.0)):
        before, after = getattr(old.arrays, name), getattr(bent.arrays, name)
        np.testing.assert_allclose(after, times * before, rtol=1e-12)
    for name in ("mass", "stiffness", "rest_length", "damping_axial"):
        assert np.array_equal(getattr(bent.arrays, name), getattr(old.arrays, name)), name
