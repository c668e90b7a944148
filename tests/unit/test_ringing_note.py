"""Methods that keep waves ringing have tensions that are far too high: it was told that they are too low."""

from __future__ import annotations

import pytest

import ropewalk as rw
from ropewalk.record.note_kinds import kinds
from ropewalk.scene import (
    Anchor,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    Slack,
    Straight,
    Velocity,
)

PULL = "about the largest tension"


def span(method: str, time_step: float) -> rw.Scene:
    """A span that is at rest, of which an anchor is moved at once; a wave takes 0.5 ms through a segment."""
    rope = Rope(
        segments=20,
        length=5.0,
        made_of=Material(EA=1e4, mass_per_length=0.04, axial_damping=5.0),
        shape=Slack(end=(4.5, 0, 0)),
    )
    moved = Anchor(node=0, motion=Velocity(velocity=(-1.0, 0, 0.5), start=0.2, stop=0.5))
    return Scene(
        ropes=rope,
        anchors=(moved, Anchor(node=-1)),
        run=RunSettings(method=method, time_step=time_step, duration=1.5, start="at-rest"),
    )


@pytest.mark.parametrize("method", ["implicit-midpoint", "generalized-alpha"])
def test_waves_that_ring_may_make_a_peak_too_high(method: str) -> None:
    """Steps of 1/60 s had many times the tension of fine ones, and a note that it may be too low."""
    result = rw.simulate(span(method, 1 / 60))
    fine = rw.simulate(span("esdirk3", 2e-4))
    most = "largest tension [N]"
    assert result.table[most] > 1.5 * fine.table[most]
    assert "may be far too high" in result.table[PULL]
    assert "is too low" not in result.table[PULL]
    assert "peak may be wrong" in kinds(result)
    assert "far too high" not in rw.simulate(span("bdf2", 1 / 60)).table.get(PULL, "")


@pytest.mark.parametrize("method", ["implicit-midpoint", "generalized-alpha"])
def test_where_nothing_rings_nothing_is_told(method: str) -> None:
    """A load that is swung on a rope that stretches slowly: its tension is right to a per cent."""
    rope = Rope(
        segments=10,
        length=2.0,
        made_of=Material(EA=2e4, mass_per_length=0.05, axial_damping=100.0),
        shape=Slack(end=(1.9, 0, 0)),
        loads=[Load(node=-1, mass=20.0)],
    )
    run = RunSettings(method=method, time_step=1 / 480, duration=1.0)
    scene = Scene(ropes=rope, anchors=Anchor(node=0), run=run)
    result = rw.simulate(scene)
    fine = rw.simulate(scene.replace(**{"run.method": "esdirk3", "run.time_step": 2e-4}))
    most = "largest tension [N]"
    assert result.table[most] == pytest.approx(fine.table[most], rel=0.03)
    assert PULL not in result.table


@pytest.mark.parametrize("method", ["implicit-midpoint", "generalized-alpha"])
def test_what_a_rope_bore_as_it_began_no_step_has_made(method: str) -> None:
    """A taut span that an anchor slackens at once: its own tension was told to be far too high."""
    scene = span(method, 1 / 60).replace(**{"run.start": "shape", "gravity": (0, 0, 0)})
    (rope,) = scene.ropes
    taut = rope.replace(shape=Straight(end=(5.05, 0, 0)))
    slackened = Anchor(node=0, motion=Velocity(velocity=(0.5, 0, 0), stop=0.08))
    result = rw.simulate(scene.replace(ropes=taut, anchors=(slackened, Anchor(node=-1))))
    assert result.table["largest tension [N]"] == pytest.approx(100.0)  # EA times 1 %
    assert PULL not in result.table
    assert "peak may be wrong" not in kinds(result)
