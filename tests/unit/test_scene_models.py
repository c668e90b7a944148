"""The scene models from Python: defaults, helpers, sentences, immutability."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from ropewalk.scene import (
    Anchor,
    Fixed,
    Load,
    Material,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Springs,
    Straight,
    Table,
    Velocity,
    Winch,
    loads,
)
from ropewalk.simulation import Simulation


def springs_rope(**changes: object) -> Rope:
    made_of = Springs(spring_constant=1e4, node_mass=0.05, spring_friction=0.05, segment_length=0.5)
    return Rope(**({"segments": 20, "made_of": made_of, "shape": Straight()} | changes))


def material_rope(segments: int) -> Rope:
    made_of = Material(EA=1000.0, mass_per_length=0.2, axial_damping=3.0)
    return Rope(segments=segments, made_of=made_of, length=5.0)


def test_lengths_masses_and_stiffness_of_springs() -> None:
    rope = springs_rope(loads=[Load(node=-1, mass=2.0)])
    assert rope.nodes == 21
    assert rope.length_unstretched == 10.0
    assert rope.segment_length == 0.5
    assert rope.segment_stiffness == 1e4
    assert rope.segment_friction == 0.05
    assert rope.own_mass == pytest.approx(21 * 0.05)
    assert rope.total_mass == pytest.approx(21 * 0.05 + 2.0)


@pytest.mark.parametrize("segments", [1, 10, 20])
def test_a_material_does_not_depend_on_the_segments(segments: int) -> None:
    rope = material_rope(segments)
    assert rope.length_unstretched == 5.0
    assert rope.own_mass == pytest.approx(1.0)
    # springs and dampers in series: the whole is one segment's over their number
    assert rope.segment_stiffness / segments == pytest.approx(1000.0 / 5.0)
    assert rope.segment_friction / segments == pytest.approx(3.0 / 5.0)


def test_nodes_are_counted_from_either_end() -> None:
    rope = springs_rope()
    assert [rope.node_index(node) for node in (0, 20, -1, -21)] == [0, 20, 20, 0]
    for node in (21, -22):
        with pytest.raises(IndexError, match="has no node"):
            rope.node_index(node)
    scene = Scene(ropes=[rope], anchors=[Anchor(node=-1), Anchor(node=3)])
    assert [scene.anchor_node(anchor) for anchor in scene.anchors] == [20, 3]


def test_names_are_filled_in() -> None:
    scene = Scene(
        ropes=[springs_rope()],
        anchors=[Anchor(node=0), Anchor(node=1, name="b")],
        winches=[Winch(end="start", speed=1.0)],
    )
    assert [rope.name for rope in scene.ropes] == ["rope"]
    assert [(anchor.name, anchor.rope) for anchor in scene.anchors] == [
        ("anchor0", "rope"),
        ("b", "rope"),
    ]
    assert scene.winches[0].rope == "rope"
    assert scene.anchor_named("b").node == 1
    assert scene.rope_named("rope") is scene.ropes[0]
    assert scene.rope_index("rope") == 0
    with pytest.raises(KeyError, match="no rope 'string'"):
        scene.rope_named("string")
    with pytest.raises(KeyError, match="no anchor 'c'"):
        scene.anchor_named("c")


def test_one_part_stands_for_a_list_of_one() -> None:
    scene = Scene(ropes=springs_rope(), anchors=Anchor(node=0))
    assert len(scene.ropes) == len(scene.anchors) == 1
    assert scene == Scene(ropes=[springs_rope()], anchors=[Anchor(node=0)])


def test_up_is_against_gravity() -> None:
    rope = springs_rope()
    assert Scene(ropes=rope).gravity == (0.0, 0.0, -9.81)
    assert Scene(ropes=rope).up == (0.0, 0.0, 1.0)
    assert Scene(ropes=rope, gravity=(0, -2, 0)).up == (0.0, 1.0, 0.0)
    assert Scene(ropes=rope, gravity=(0, 0, 0)).up == (0.0, 0.0, 1.0)
    assert math.hypot(*Scene(ropes=rope, gravity=(1, -2, 3)).up) == pytest.approx(1.0)


def test_defaults() -> None:
    scene = Scene(ropes=springs_rope(), anchors=Anchor(node=0))
    assert scene.run == RunSettings(
        duration=10.0,
        frame_rate=60.0,
        time_step="auto",
        auto_fraction=0.8,
        steps="divide",
        method="semi-implicit-euler",
    )
    assert scene.anchors[0].motion == Fixed()
    assert (scene.air, scene.ground, scene.limiter) == (None, None, None)
    assert Velocity(velocity=(1, 0, 0)).stop == math.inf
    assert springs_rope().made_of.friction == "vector"
    assert material_rope(2).made_of.friction == "axial"


def test_scenes_are_frozen_and_hashable() -> None:
    scene = Scene(ropes=springs_rope())
    with pytest.raises(ValueError, match="frozen"):
        scene.gravity = (0.0, 0.0, 0.0)
    with pytest.raises(ValueError, match="frozen"):
        scene.ropes[0].segments = 3
    assert hash(scene) == hash(Scene(ropes=springs_rope()))
    assert scene != Scene(ropes=springs_rope(segments=21))


def test_replace_checks_what_it_makes() -> None:
    scene = Scene(ropes=springs_rope(), anchors=Anchor(node=-1))
    longer = scene.replace(ropes=[scene.ropes[0].replace(segments=30)])
    assert longer.ropes[0].segments == 30
    assert longer.anchor_node(longer.anchors[0]) == 30
    assert scene.ropes[0].segments == 20
    with pytest.raises(SceneError, match="segments: 0 - must be at least 1"):
        scene.ropes[0].replace(segments=0)


def test_numpy_values_are_taken_as_what_they_are() -> None:
    shape = Straight(start=np.array([1.0, 2.0, 3.0]), velocity=np.zeros(3))
    rope = springs_rope(segments=np.int64(3), shape=shape, diameter=np.float64(0.02))
    assert rope.shape.start == (1.0, 2.0, 3.0)
    assert (rope.segments, rope.diameter) == (3, 0.02)
    assert type(rope.segments) is int
    run = RunSettings(time_step=np.float32(0.25), extremes=np.bool_(False))
    assert (run.time_step, run.extremes) == (0.25, False)
    assert RunSettings(time_step=np.int64(1)).time_step == 1.0
    with pytest.raises(SceneError, match="must be a number of seconds"):
        RunSettings(time_step=np.bool_(True))  # type: ignore[arg-type]


@pytest.mark.parametrize("value", ["yes", "false", 1, 0.0])
def test_flags_are_true_or_false(value: object) -> None:
    """As all others are; "extremes" took texts and numbers."""
    with pytest.raises(SceneError, match="extremes"):
        RunSettings(extremes=value)  # type: ignore[arg-type]


def test_sentences() -> None:
    move = Velocity(velocity=(2, 0, 0), start=0.5, stop=3.5)
    scene = Scene(
        name="demo",
        ropes=springs_rope(),
        anchors=[Anchor(node=0, name="left", motion=move), Anchor(node=-1, release_time=2)],
    )
    assert repr(scene) == (
        "Scene 'demo': 1 rope of 20 segments, 2 anchors, 10 s at 60 frames/s "
        "with semi-implicit-euler."
    )
    assert repr(scene.ropes[0]) == "Rope 'rope': 20 segments, 10 m, 1.05 kg, springs of 10000 N/m."
    assert repr(material_rope(1)) == "Rope 'rope': 1 segment, 5 m, 1 kg, material with EA = 1000 N."
    loaded = material_rope(1).model_copy(update={"loads": [Load(node=-1, mass=80)]})
    assert "1 segment, 5 m, 1 kg, with loads 81 kg, material" in repr(loaded)
    assert repr(scene.anchors[0]) == (
        "Anchor 'left' holds node 0 of 'rope', moved at (2, 0, 0) m/s from 0.5 to 3.5 s."
    )
    assert str(scene.anchors[1]) == "Anchor 'anchor1' holds node -1 of 'rope' until 2 s, fixed."
    assert str(Winch(end="end", speed=-2)) == "Winch at the end reels in 2 m/s."


def test_a_simulation_of_a_name_says_what_gives_a_scene() -> None:
    with pytest.raises(TypeError, match=r"'r3' is no scene; rw.preset"):
        Simulation("r3")  # type: ignore[arg-type]


def test_the_scene_lists_the_methods_that_there_are() -> None:
    """Its list is written apart, so that a scene loads without kernels."""
    from typing import get_args

    from ropewalk.methods.names import Method
    from ropewalk.methods.registry import METHODS

    assert set(get_args(Method)) == {*METHODS, "auto"}


MADE_OF = '{ kind = "springs", spring_constant = 100, node_mass = 0.1, segment_length = 1.0 }'


@pytest.mark.parametrize(
    ("wrong", "said", "right"),
    [
        (
            "[rope.load]\nnode = 1\nmass = 1.0\n",
            "write [[rope.load]], not [rope.load]",
            "[[rope.load]]\nnode = 1\nmass = 1.0\n",
        ),
        (
            '[[rope.shape]]\nkind = "straight"\n',
            "write [rope.shape], not [[rope.shape]]",
            '[rope.shape]\nkind = "straight"\n',
        ),
    ],
)
def test_headers_that_are_advised_are_toml(wrong: str, said: str, right: str) -> None:
    rope = f"[[rope]]\nsegments = 2\nmade_of = {MADE_OF}\n"
    with pytest.raises(SceneError) as caught:
        loads(rope + wrong)
    assert said in str(caught.value)
    assert loads(rope + right).ropes[0].segments == 2


def test_the_width_that_is_advised_for_a_slack_rope_is_enough() -> None:
    """Six figures of 1e-6 times the length: those of the nearest were too few."""
    text = (
        "[[rope]]\nsegments = 2\nlength = 300.554321\n"
        'made_of = { kind = "material", EA = 1000.0, mass_per_length = 0.1 }\n'
        'shape = { kind = "slack", end = [WIDTH, 0.0, 1.0] }\n'
    )
    with pytest.raises(SceneError) as caught:
        loads(text.replace("WIDTH", "0.0"))
    found = re.search(r"at least (\S+) m aside", str(caught.value))
    assert found is not None
    assert found[1] == "0.000300555"
    assert loads(text.replace("WIDTH", found[1])).ropes[0].segments == 2


def test_a_table_of_no_times_is_told_as_empty_not_as_missing() -> None:
    with pytest.raises(SceneError, match=r"times: \[\] - is empty: give times and positions"):
        Table(times=np.array([]), positions=np.zeros((0, 3)))
    with pytest.raises(SceneError, match="times: missing - give times and positions, or file"):
        Table(positions=[(0.0, 0.0, 0.0)])
