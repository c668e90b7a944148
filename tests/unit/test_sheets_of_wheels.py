"""The sheet of a job with a winch and a wheel says what they do, and what holds them."""

from __future__ import annotations

import ropewalk as rw
from ropewalk.scene import Anchor, Load, Material, Rope, RunSettings, Scene, Winch
from ropewalk.scene.obstacles import Cylinder
from ropewalk.scene.shapes import Polyline
from ropewalk.sheets.ropes import assumption_section
from unit.test_sheets import warnings, words


def hauled(**spin: object) -> Scene:
    """A winch that hauls 10 kg over a wheel that turns freely, by 1.6 m of rope."""
    rope = Rope(
        name="line",
        segments=32,
        length=1.5825,
        diameter=0.01,
        made_of=Material(
            EA=2e4, mass_per_length=0.08, axial_damping=20.0, breaking_load=2e4, parts=True
        ),
        shape=Polyline(
            points=[
                *[(-0.055, 0, -0.7), (-0.055, 0, 0.0228), (-0.0228, 0, 0.055)],
                *[(0.0228, 0, 0.055), (0.055, 0, 0.0228), (0.055, 0, -0.7)],
            ]
        ),
        loads=[Load(node=-1, mass=10.0)],
    )
    wheel = Cylinder(
        name="wheel", start=(0, -0.02, 0), end=(0, 0.02, 0), radius=0.05, friction=0.5, spin=spin
    )
    return Scene(
        ropes=[rope],
        anchors=[Anchor(name="drum", node=0, motion={"kind": "velocity", "velocity": (0, 0, 0.1)})],
        winches=[Winch(end="start", speed=-0.3, start=0.1, stop=0.5, min_length=1.2)],
        obstacles=[wheel],
        run=RunSettings(method="esdirk3", time_step=2e-3, duration=0.1),
    )


def test_winches_and_what_turns_and_parts_are_told() -> None:
    """A sheet said nothing of them, and "drum move"."""
    told = words(assumption_section(hauled(free=True, inertia=2e-3, bearing=0.02)))
    assert "Anchors do not give; drum moves." in told
    winch = "Winch 'winch0' at the start of 'line' reels in 0.3 m/s from 0.1 s until 0.5 s"
    assert f"{winch}, to 1.2 m of rope at least." in told
    turns = "it turns freely, with a moment of inertia of 0.002 kg m², a bearing of 0.02 N m."
    assert f"friction of 0.5; {turns}" in told
    assert "line parts where a segment carries more than the breaking load." in told
    assert "Ropes touch" not in told
    driven = hauled(rate=2.0, start=0.5).replace(contact={"friction": 0.25})
    told = words(assumption_section(driven))
    assert "friction of 0.5; it turns at 2 rad/s from 0.5 s." in told
    assert "Ropes touch each other and themselves with a coefficient of friction of 0.25." in told


def test_a_pulley_that_no_bearing_holds_is_a_warning_at_rest() -> None:
    """The drum carries a part of the load at rest, the wheel the rest of it; twin: a bearing that holds."""
    for bearing, warned in ((0.02, True), (20.0, False)):
        made = rw.sheet(
            hauled(free=True, inertia=2e-3, bearing=bearing), run=False, convergence=False
        )
        told = words(made.section("At rest"))
        assert "No spans are told of 'line', as it lies on an obstacle" in told
        assert "lie on 'wheel' and turn by 180 degrees" in told
        assert "With friction there are many shapes of rest" in told
        assert ("it is held still here, and turns when it is let go" in told) is warned
        assert any("turns when it is let go" in text for text in warnings(made)) is warned
        assert ("'wheel' is held still" in words(made.section("Summary"))) is warned
