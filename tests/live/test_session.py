"""Every command on a running session: what it does, that nothing jumps, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from live.drive import do, r4, refused, slack_rope
from ropewalk.live.describe import parameters
from ropewalk.live.frozen import scene_now
from ropewalk.live.parameters import PARAMETERS
from ropewalk.live.session import Session
from ropewalk.scene import SceneError
from ropewalk.scene.presets import preset

CHANGES = {
    "spring_constant": 8000.0,
    "EA": 9000.0,
    "spring_friction": 0.2,
    "friction_form": "axial",
    "mass": 3.0,
    "length": 42.0,
    "diameter": 0.02,
    "tension_only": True,
    "gravity": [1.0, -5.0, 0.5],
    "air_drag": 0.01,
    "air_drag_quadratic": 0.01,
    "air_density": 1.2,
    "wind": [3.0, 0.0, 0.0],
    "ground": True,
    "ground_height": -30.0,
    "ground_repulsion": 50.0,
    "ground_friction": 0.5,
    "ground_absorption": 1.0,
    "method": "verlet",
    "time_step": 0.001,
    "steps_per_frame": 20,
}


def test_every_parameter_is_tried_here() -> None:
    of_touch = {"obstacle_friction", "contact_friction"}  # in test_friction_by_hand
    assert set(CHANGES) | {"segments"} | of_touch == set(PARAMETERS)


@pytest.mark.parametrize("name", CHANGES)
def test_a_change_takes_effect_without_a_jump(name: str) -> None:
    session = r4()
    session.advance(270)
    main = session.main.simulation
    before, speeds = main.positions.copy(), main.velocities.copy()
    time, work = main.time, main.arrays.work.friction.sum()
    do(session, "set", name=name, value=CHANGES[name])
    after = session.main.simulation
    assert np.array_equal(after.positions, before)
    assert np.array_equal(after.velocities, speeds)
    assert after.time == time
    assert after.arrays.work.friction.sum() == work
    wanted = CHANGES[name]
    found = PARAMETERS[name].get(session.scene, 0)
    assert found == (wanted if isinstance(wanted, str) else pytest.approx(wanted))
    assert session.advance(9) == 0
    assert np.abs(session.main.simulation.positions - before).max() < 0.5  # m, in 1/60 s


@pytest.mark.parametrize(
    "command",
    [
        {"kind": "set", "name": "mass", "value": 3.0},
        {"kind": "set", "name": "gravity", "value": [1.0, -5.0, 0.5]},
        {"kind": "cut", "segment": 9},
        {"kind": "pin", "node": 11},
        {"kind": "load", "node": 11, "mass": 1.0},
    ],
    ids=["mass", "gravity", "cut", "pin", "load"],
)
def test_a_scene_that_starts_at_rest_goes_on_where_it_stands(command: dict[str, Any]) -> None:
    """It was put at rest anew by every change: a cut cable lay 17 m away at once."""
    scene = slack_rope()
    session = Session(scene.replace(run=scene.run.replace(start="at-rest")))
    first = session.main.simulation.positions.copy()
    session.main.kick(8, np.array([0.0, 2.0, 1.0]))
    session.advance(250)
    before = session.main.simulation
    places, speeds = before.positions[:9].copy(), before.velocities[:9].copy()
    assert np.abs(places - first[:9]).max() > 1e-3
    do(session, **command)
    after = session.main.simulation
    assert np.array_equal(after.positions[:9], places)
    assert np.array_equal(after.velocities[:9], speeds)
    assert after.time == before.time
    assert scene_now(session).run.start == "shape"
    do(session, "reset", all=True)
    assert np.array_equal(session.main.simulation.positions, first)
    assert not session.main.simulation.velocities.any()
    assert scene_now(session, fresh=True).run.start == "at-rest"


def test_a_scene_that_starts_ringing_does_not_ring_again() -> None:
    scene = slack_rope()
    run = scene.run.replace(start="at-rest", ring={"mode": 1, "speed": 0.5})
    session = Session(scene.replace(run=run))
    assert np.abs(session.main.simulation.velocities).max() == pytest.approx(0.5)
    session.advance(700)
    before = session.main.simulation.velocities.copy()
    do(session, "set", name="mass", value=2.5)
    assert np.array_equal(session.main.simulation.velocities, before)


def test_that_no_rest_is_found_is_refused_in_words() -> None:
    """It was an error in Ropewalk itself."""
    session = Session(preset("pulley"), "pulley")
    do(session, "set", name="mass", value=1e9)
    with pytest.raises(SceneError, match="no shape of rest was found"):
        do(session, "reset")
    do(session, "reset", all=True)


@pytest.mark.parametrize("command", [{"kind": "set", "name": "gravity"}, {"kind": "cut"}])
def test_what_a_bound_holds_is_shown_after_a_change(command: dict[str, Any]) -> None:
    """Of 21.4 N that a limiter held 4 N were shown, the spring's, until the next step."""
    session = Session(preset("h1"), "h1")
    session.advance(round(1.0 / session.main.dt))
    before = session.main.simulation.tension.copy()
    assert before[-2:].min() > 19.0  # N
    value = {"set": {"value": [0.0, -9.81, 1e-9]}, "cut": {"segment": 0}}[command["kind"]]
    do(session, **command, **value)
    after = session.main.simulation.tension
    assert after[-4:] == pytest.approx(before[-4:], rel=1e-6)


@pytest.mark.parametrize("beside", [False, True])
def test_what_a_bound_held_is_forgotten_by_a_method_that_solves_for_it(beside: bool) -> None:
    """It was added to all tensions for good: 39 N for 21.6 in the last segment."""
    session = Session(preset("h1"), "h1")
    session.advance(round(1.0 / session.main.dt))
    track = session.main
    assert track.simulation.arrays.limited[-4:].min() > 10.0  # N
    if beside:
        do(session, "compare", variants=[{"changes": {"method": "esdirk3"}}])
        track = session.tracks[1]
    else:
        do(session, "set", name="method", value="esdirk3")
    track.advance(10)
    simulation = track.simulation
    assert not simulation.arrays.limited.any()
    assert simulation.tension[-4:] == pytest.approx(simulation.arrays.tension[-4:], rel=1e-3)


def test_a_rope_that_relaxes_has_the_spring_constant_that_was_given() -> None:
    """It had that of what relaxes added: 224 kN/m became 351 when it was set."""
    session = Session(preset("climbing-fall"), "climbing-fall")
    rope = session.scene.ropes[0]
    shown = {one["name"]: one["value"] for one in parameters(session)["parameters"]}
    assert shown["spring_constant"] * rope.segment_length == pytest.approx(shown["EA"])
    do(session, "set", name="spring_constant", value=1.1 * shown["spring_constant"])
    after = {one["name"]: one["value"] for one in parameters(session)["parameters"]}
    assert after["spring_constant"] == pytest.approx(1.1 * shown["spring_constant"])
    assert after["EA"] == pytest.approx(1.1 * shown["EA"])


def test_a_change_differs_from_no_change() -> None:
    one, other = r4(), r4()
    for session in (one, other):
        session.advance(270)
    do(other, "set", name="mass", value=3.0)
    one.advance(100)
    other.advance(100)
    assert np.abs(one.main.simulation.positions - other.main.simulation.positions).max() > 1e-3


def test_a_new_number_of_segments_keeps_rope_and_shape() -> None:
    session = Session(slack_rope(40))
    session.advance(1000)
    before = session.main.simulation
    shape, mass = before.positions.copy(), before.arrays.mass.sum()
    momentum = before.recording().recording.momentum[0]
    do(session, "set", name="segments", value=80)
    after = session.main.simulation
    # every second node of the finer rope is one of the coarser, the others lie half-way
    assert np.array_equal(after.positions[::2], shape)
    assert np.allclose(after.positions[1::2], 0.5 * (shape[1:] + shape[:-1]), atol=1e-15)
    assert after.arrays.mass.sum() == pytest.approx(mass, rel=1e-12)
    assert after.scene.ropes[0].segment_stiffness == pytest.approx(80 * 2e4 / 10.0)
    # linear velocities on linear elements: momentum to the order of the segments' ends
    assert np.allclose(after.recording().recording.momentum[0], momentum, atol=0.02)
    assert session.advance(100) == 0


def test_springs_stay_the_same_rope_when_they_are_cut_finer() -> None:
    session = r4()
    do(session, "set", name="segments", value=80)
    rope = session.scene.ropes[0]
    assert rope.length_unstretched == pytest.approx(40.0)
    assert rope.own_mass == pytest.approx(41 * 0.05)
    assert rope.segment_stiffness * rope.segment_length == pytest.approx(10000.0 * 1.0)
    assert [session.scene.anchor_node(one) for one in session.scene.anchors] == [0, 40, 80]


def test_anchors_stay_at_nodes_and_nodes_at_anchors() -> None:
    session = r4()
    session.advance(300)
    do(session, "set", name="segments", value=61)  # the middle anchor wants an even number
    assert session.scene.ropes[0].segments == 60
    simulation = session.main.simulation
    assert simulation.positions[30] == pytest.approx([20.0, 0.0, 0.0], abs=1e-12)
    do(session, "pin", node=7)
    place = session.main.simulation.positions[7].copy()
    before = session.main.simulation.positions.copy()
    do(
        session, "set", name="segments", value=100
    )  # nothing fits a pin at 7 of 60: the nearest node
    after = session.main.simulation
    pin = [session.scene.anchor_node(one) for one in session.scene.anchors][-1]
    assert pin == 12
    assert np.array_equal(after.positions[pin], place)
    for points, other in ((before, after.positions), (after.positions, before)):
        nearest = np.abs(points[:, None] - other[None]).max(axis=2).min(axis=1)
        assert nearest.max() < 0.7  # m: no node is further from the old shape than half a segment


def test_out_of_range_values_are_answered_with_the_range() -> None:
    session = r4()
    said = refused(session, "set", name="mass", value=-1)
    assert said == "mass: -1 - must be positive"
    assert "must be from 1e-12 to 1e+15 kg" in refused(session, "set", name="mass", value=1e16)
    assert "must not be negative" in refused(session, "set", name="spring_friction", value=-1)
    assert "must be from 1 to 20000" in refused(session, "set", name="segments", value=0)
    assert "must be a whole number from 1" in refused(session, "set", name="segments", value=1.5)
    assert "three finite numbers" in refused(session, "set", name="gravity", value=[0, 1])
    assert "must be true or false" in refused(session, "set", name="ground", value=1)
    assert '"rk4"' in refused(session, "set", name="method", value="magic")
    assert "must be a finite number" in refused(session, "set", name="EA", value=True)
    assert 'did you mean "mass"' in refused(session, "set", name="mas", value=1)
    assert "there is rope" in refused(session, "set", name="mass", value=1, rope="no")
    assert "must be from 0 to 0" in refused(session, "set", name="mass", value=1, variant=1)
    assert session.scene == r4().scene


def test_a_refused_command_changes_nothing() -> None:
    session = r4()
    session.advance(100)
    before = session.main.save()
    assert refused(session, "set", name="spring_constant", value=0)
    assert session.main.simulation is before.simulation
    assert session.changes == {}


def test_a_value_goes_back_to_the_scenes_own() -> None:
    session = r4()
    do(session, "set", name="mass", value=9.0)
    do(session, "set", name="mass", value=None)
    assert session.scene.ropes[0].own_mass == pytest.approx(2.05)
    assert session.changes == {}


def test_an_automatic_step_is_the_one_of_now() -> None:
    session = r4()
    do(session, "set", name="spring_constant", value=1e6)
    do(session, "set", name="time_step", value="auto")
    # report: stable up to a + 2b < 4, so about 2 sqrt(m/k) less friction; 0.8 of it
    assert session.main.dt == pytest.approx(0.8 * np.sqrt(0.05 / 1e6), rel=0.1)


def test_the_scenes_motions_go_on_after_a_change() -> None:
    plain, changed = r4(), r4()
    for session in (plain, changed):
        session.advance(540)  # 1 s: the left anchor moves from 0.5 s on
    do(changed, "pin", node=30)
    for session in (plain, changed):
        session.advance(540)
    names = plain.main.simulation.anchors, changed.main.simulation.anchors
    assert np.array_equal(names[0]["left"].position, names[1]["left"].position)
    assert names[0]["left"].position[0] == pytest.approx(3.0, abs=0.01)  # 2 m/s for 1.5 s


def test_reset_keeps_constants_and_drops_the_rest() -> None:
    session = r4()
    first = session.main.simulation.positions.copy()
    do(session, "set", name="mass", value=4.0)
    session.advance(200)
    do(session, "pin", node=10)
    do(session, "cut", segment=30)
    do(session, "reset")
    assert session.time == 0.0
    assert np.array_equal(session.main.simulation.positions, first)
    assert session.scene.ropes[0].own_mass == pytest.approx(4.0)
    assert len(session.scene.ropes) == 1
    do(session, "reset", all=True)
    assert session.scene.ropes[0].own_mass == pytest.approx(2.05)


def test_reset_with_another_number_of_segments() -> None:
    session = Session(slack_rope(40))
    do(session, "set", name="segments", value=20)
    do(session, "reset")
    assert session.main.simulation.layout.nodes == 21
    assert session.advance(100) == 0


def test_moving_an_anchor_by_a_held_key() -> None:
    session = r4()
    do(session, "move", anchor="right", velocity=[3, 0, 0])
    session.advance(270)  # 0.5 s
    assert session.main.simulation.anchors["right"].position[0] == pytest.approx(41.5)
    do(session, "move", anchor="right", velocity=[0, 0, 0])
    session.advance(270)
    assert session.main.simulation.anchors["right"].position[0] == pytest.approx(41.5)
    assert "there is left, middle, right" in refused(
        session, "move", anchor="up", velocity=[0, 0, 0]
    )


def test_the_first_variant_of_another_scene() -> None:
    session = r4()
    do(session, "scene", preset="n40")
    assert session.preset == "n40"
    assert session.time == 0.0
    assert "no such preset" in refused(session, "scene", preset="n99")
    assert "one of preset, toml, address" in refused(session, "scene")
    assert session.preset == "n40"


def test_what_would_not_be_felt_is_not_offered() -> None:
    """Wind without drag, and numbers of a ground that is off: each says what it waits for."""
    session = r4()

    def why(name: str) -> str:
        told = {one["name"]: one for one in parameters(session)["parameters"]}[name]
        assert told["enabled"] == (told["why"] == "")
        return str(told["why"])

    do(session, "set", name="ground", value=False)
    for drag in ("air_drag", "air_drag_quadratic", "air_density"):
        do(session, "set", name=drag, value=0.0)
    assert "drag" in why("wind")
    assert "ground is off" in why("ground_height")
    assert not why("ground")
    do(session, "set", name="air_density", value=1.2)
    do(session, "set", name="ground", value=True)
    assert not why("wind")
    assert not why("ground_height")
    assert not why("spring_friction")
    session = Session(preset("climbing-fall"), "climbing-fall")
    assert "relaxation alone" in why("spring_friction")  # any but 0 is refused: axial_damping
    with pytest.raises(SceneError, match="relaxation"):
        do(session, "set", name="spring_friction", value=0.01)


@pytest.mark.parametrize(("name", "barred"), [("crossing", True), ("edge", True), ("n40", False)])
def test_nehes_ground_is_not_offered_beside_true_contact(name: str, barred: bool) -> None:
    session = Session(preset(name), name)
    offered = {one["name"] for one in parameters(session)["parameters"]}
    assert ("ground" not in offered) == ("ground_height" not in offered) == barred
    if barred:
        assert "another law" in refused(session, "set", name="ground", value=True)
        assert session.scene.ground is None
    else:
        do(session, "set", name="ground", value=False)
        do(session, "set", name="ground", value=True)
        assert session.scene.ground is not None
