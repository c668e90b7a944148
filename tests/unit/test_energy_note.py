"""An automatic explicit run of an undamped rope that errs in its energy says so."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.scene import Anchor, Material, Rope, RunSettings, Scene, Straight


def fallen(**more: object) -> rw.Result:
    """The table of a soft cord without friction that falls from the horizontal and goes slack."""
    stuff = {"EA": 300.0, "mass_per_length": 0.1, "tension_only": True}
    damping = more.pop("axial_damping", 0.0)
    cord = Rope(
        segments=20,
        length=2.0,
        made_of=Material(**stuff, axial_damping=damping),
        shape=Straight(start=(0, 0, 0), end=(2, 0, 0)),
    )
    run = RunSettings(**({"duration": 4.0, "method": "rk4"} | more))
    return rw.simulate(Scene(ropes=[cord], anchors=[Anchor(node=0)], run=run))


def test_energy_lost_is_told() -> None:
    """rk4 damps the waves that slack segments make. The twins: a fine step, a step that was asked for,
    friction that hides it, and a method that is not explicit.
    """
    table = fallen().table
    text = table["about the energy"]
    assert "rk4 lost" in text
    assert "% of weight times length" in text
    share = table["largest energy error [J]"] / (9.81 * 0.2 * 2.0)
    assert f"{100.0 * share:.2g} %" in text
    assert share > 0.01
    assert "about the energy" not in fallen(auto_fraction=0.05).table
    assert "about the energy" not in fallen(time_step=0.001).table
    assert "about the energy" not in fallen(axial_damping=0.01).table
    assert "about the energy" not in fallen(method="esdirk3").table
