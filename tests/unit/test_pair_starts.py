"""Ropes that are drawn pressed into each other are told of: contacts throw them apart."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.scene import Anchor, Joint, Load, Material, Rope, Scene, Straight


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


@pytest.mark.parametrize("at", ["elsewhere", "on it", "bound to it"])
def test_what_hangs_elsewhere_presses_nothing(at: str) -> None:
    """50 kg on another rope hid two that part with 0.4 m/s. The twins: on the pair, or bound to it."""
    pair = beside(0.06, gravity=9.81)
    y = 0.0 if at == "on it" else 5.0
    hangs = Rope(
        name="hangs",
        segments=2,
        length=1.0,
        diameter=0.01,
        made_of=Material(EA=1e6, mass_per_length=0.06),
        shape=Straight(start=(0.45, y, -0.0099), direction=(0, 0, -1)),
        loads=[Load(node=-1, mass=50.0)],
    )
    tie = [Joint(points=[{"rope": "a", "node": 0}, {"rope": "hangs", "node": 0}])]
    scene = pair.replace(
        ropes=[*pair.ropes, hangs],
        anchors=[Anchor(rope="hangs", node=0)],
    )
    if at == "bound to it":
        hangs = hangs.replace(shape=Straight(start=(0, 0, 0), direction=(0, 0, -1)))
        scene = pair.replace(ropes=[*pair.ropes, hangs], joints=tie)
    assert bool(told(scene)) == (at == "elsewhere")
    if at == "elsewhere":
        assert apart(scene) > 0.2
