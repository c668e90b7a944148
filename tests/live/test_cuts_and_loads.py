"""What is pinned, cut, loaded and kicked in the live view."""

from __future__ import annotations

import numpy as np
import pytest

from live.drive import do, r4, refused, slack_rope
from ropewalk.live.session import Session
from ropewalk.scene import SceneError
from ropewalk.scene.presets import preset


def test_a_rope_on_a_winch_is_not_cut_and_why_is_told() -> None:
    """It read "no such rope; did you mean hoist-2?"."""
    session = Session(preset("hoist-stop"), "hoist-stop")
    with pytest.raises(SceneError, match="a rope that a winch winds can part only in a scene"):
        do(session, "cut", segment=12)


def test_pin_and_unpin() -> None:
    session = r4()
    session.advance(400)
    place = session.main.simulation.positions[10].copy()
    do(session, "pin", node=10)
    session.advance(400)
    assert np.array_equal(session.main.simulation.positions[10], place)
    assert "held by anchor 'pin1'" in refused(session, "pin", node=10)
    do(session, "unpin", anchor="pin1")
    session.advance(400)
    assert np.abs(session.main.simulation.positions[10] - place).max() > 1e-3
    do(session, "unpin", node=20)  # the scene's own middle anchor
    assert [one.name for one in session.scene.anchors] == ["left", "right"]
    assert "no such anchor; there is left, right" in refused(session, "unpin", anchor="pin1")
    assert "is held by no anchor" in refused(session, "unpin", node=5)
    assert "must be from 0 to 40" in refused(session, "pin", node=41)


def test_a_cut_rope_falls_apart_and_keeps_mass_and_momentum() -> None:
    session = Session(slack_rope(40))
    session.advance(2000)
    before = session.main.simulation
    mass, shape = before.arrays.mass.copy(), before.positions.copy()
    do(session, "cut", segment=20)
    after = session.main.simulation
    assert np.array_equal(after.positions, shape)
    assert np.allclose(after.arrays.mass, mass, rtol=1e-12)
    assert [span.nodes for span in after.layout.ropes] == [21, 20]
    assert after.arrays.stiffness[20] == 0.0
    session.advance(2000)
    gap = np.linalg.norm(after.positions[21] - after.positions[20])
    assert gap > 1.0  # m after 0.4 s of falling apart
    assert "nothing to cut" in refused(session, "cut", segment=20)
    assert "must be from 0 to 39" in refused(session, "cut", segment=40)


def test_a_node_that_a_cut_leaves_alone_is_dropped() -> None:
    session = Session(slack_rope(40))
    note = do(session, "cut", segment=0)
    assert "dropped" in note
    assert session.main.simulation.layout.nodes == 40
    assert [one.name for one in session.scene.anchors] == ["right"]
    assert session.scene.ropes[0].name == "rope"
    assert session.advance(500) == 0


def test_a_load_pulls_its_node_down_and_comes_off() -> None:
    session, plain = r4(), r4()
    do(session, "load", node=30, mass=2.0)
    assert session.main.simulation.arrays.mass[30] == pytest.approx(2.05)
    session.advance(500)
    plain.advance(500)
    heights = [one.main.simulation.positions[30, 1] for one in (session, plain)]
    assert heights[0] < heights[1] - 0.3
    do(session, "load", node=30, mass=0)
    assert session.main.simulation.arrays.mass[30] == pytest.approx(0.05)
    assert "must be from 0 to 1e+09 kg" in refused(session, "load", node=30, mass=-1)


def test_a_kick_adds_velocity_and_is_booked() -> None:
    session = r4()
    session.advance(300)
    before = session.main.simulation.velocities[10].copy()
    energy = session.main.energy
    do(session, "kick", node=10, velocity=[0, 4, 0])
    assert np.allclose(session.main.simulation.velocities[10] - before, [0, 4, 0])
    # m ((v + u)^2 - v^2) / 2
    gain = 0.5 * 0.05 * (16.0 + 8.0 * before[1])
    assert session.main.energy - energy == pytest.approx(gain, rel=1e-9)
    assert session.main.edited == pytest.approx(gain, rel=1e-9)
    assert "is held by anchor 'middle'" in refused(session, "kick", node=20, velocity=[0, 1, 0])
