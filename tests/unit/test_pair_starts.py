"""Ropes that are drawn pressed into each other are told of: contacts throw them apart."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.scene import Material, Rope, Scene, Straight


def beside(deep: float, gravity: float = 0.0, **run: object) -> Scene:
    """Two ropes of 10 mm side by side, so deep inside each other [1] of a diameter."""
    made = Material(EA=1e4, mass_per_length=0.06, axial_damping=5.0)
    ropes = [
        Rope(
            name=name,
            segments=10,
            length=1.0,
            diameter=0.01,
            made_of=made,
            shape=Straight(start=(0, 0, z), end=(1, 0, z)),
        )
        for name, z in (("a", 0.0), ("b", 0.01 * (1.0 - deep)))
    ]
    settings = {"duration": 0.1, "method": "esdirk3", "time_step": 1e-3, **run}
    return Scene(gravity=(0, 0, -gravity), ropes=ropes, contact={}, run=settings)


def told(scene: Scene) -> list[str]:
    return [text for text in rw.check(scene, measure=False).warnings if "throws them" in text]


def apart(scene: Scene) -> float:
    """Return how fast they go apart [m/s]."""
    v = rw.simulate(scene).velocities[-1, :, 2]
    return float(v[11:].mean() - v[:11].mean())


@pytest.mark.parametrize("deep", [0.0, 0.01, 0.018])
def test_what_is_within_the_skin_of_a_contact_is_braked_there(deep: float) -> None:
    assert told(beside(deep)) == []
    assert apart(beside(deep)) < 6e-3


@pytest.mark.parametrize(("deep", "fast"), [(0.06, 0.2), (0.099, 1.0)])
def test_what_a_contact_throws_apart_is_told_of(deep: float, fast: float) -> None:
    """Without a word ropes drawn a tenth inside each other went apart with 5 m/s."""
    (said,) = told(beside(deep))
    assert said.startswith("rope[1].shape: segment ")
    assert f"starts {10.0 * deep:.3g} mm inside segment" in said
    assert "draw their middles 10 mm apart" in said
    most = float(said.split("up to ")[1].split(" m/s")[0])
    assert fast < apart(beside(deep)) < most


def test_what_may_carry_is_left_alone() -> None:
    """As in a pile that goes on as it stands: no deeper than all the ropes' weight presses."""
    assert told(beside(0.025)) != []
    assert told(beside(0.025, gravity=2e3)) == []
    for preset in ("pile", "overhand", "reef", "prusik"):
        assert told(rw.preset(preset)) == []
