"""The presets: complete, valid, commented, and with the constants of their sources."""

from __future__ import annotations

import math
import tomllib

import jsonschema
import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.scene import Scene, SceneError, Slack, Springs, dumps, loads, schema
from ropewalk.scene.presets import names, preset, preset_text

EXPECTED = {
    *(f"r{i}" for i in range(1, 10)),
    *("n39-constant-velocity", "n39-gravity", "n39-spring", "n40", "h1", "h2", "h3"),
    *("hanging-rope", "skipping-rope", "whip", "wave-on-a-string", "falling-chain"),
    *("fishing-rod", "wire-arch"),
    *("climbing-fall", "zip-line", "zip-line-ride", "highline", "rescue-lower", "tow"),
    *("crane-snap", "hoist-stop", "guyed-mast", "suspension-cable", "power-line-in-wind"),
    *("three-leg-sling", "net"),
    *("capstan", "edge", "stairs", "bollard", "pulley"),
    *("crossing", "overhand", "clove-hitch", "pile"),
    *("figure-eight", "reef", "granny", "bowline", "two-half-hitches", "prusik", "munter"),
}


def test_all_presets_are_there_seeds_first() -> None:
    assert set(names()) == EXPECTED
    assert len(names()) == len(EXPECTED)
    assert names()[:10] == [*(f"r{i}" for i in range(1, 10)), "n39-constant-velocity"]


@pytest.mark.parametrize("name", sorted(EXPECTED))
def test_a_preset_is_valid_and_explained(name: str) -> None:
    text = preset_text(name)
    scene = preset(name)
    assert isinstance(scene, Scene)
    assert loads(dumps(scene)) == scene
    jsonschema.validate(tomllib.loads(text), schema())
    # a comment block explains it, a sentence describes it
    head = text.split("\n\n")[0].splitlines()
    assert len(head) >= 4
    assert all(line.startswith("#") for line in head)
    assert scene.description.endswith(".")
    assert scene.description.count(". ") == 0
    assert scene.name != "scene"


@pytest.mark.parametrize("name", sorted(EXPECTED))
def test_the_constants_of_a_preset_have_a_source(name: str) -> None:
    """Every line that sets a number of the physics carries a comment."""
    keys = {"spring_constant", "node_mass", "EA", "mass_per_length", "time_step", "gravity"}
    for line in preset_text(name).splitlines():
        if line.split("=")[0].strip() in keys:
            assert "#" in line, line


@pytest.mark.parametrize(
    ("name", "ends"),
    [
        ("zip-line", (150.0, -7.5)),
        ("zip-line-ride", (150.0, -7.5)),
        ("power-line-in-wind", (300.0, 0.0)),
        ("guyed-mast", (30.48, 30.48)),
    ],
)
def test_a_line_begins_as_it_hangs_alone(name: str, ends: tuple[float, float]) -> None:
    """Not on the curve of an unstretched rope, from which it would drop into its tension with a jerk."""
    scene = preset(name)
    rope = scene.ropes[0]
    hung = rw.line(*ends, rope.made_of, length=rope.length)
    state = build(scene).state
    own = slice(0, rope.segments)
    stretch = np.linalg.norm(np.diff(state.x[:, : rope.segments + 1], axis=1), axis=0)
    tension = state.stiffness[own] * (stretch - state.rest_length[own])
    assert tension.max() == pytest.approx(sum(hung.tensions) / 2, rel=0.02)
    assert tension.min() > 0.95 * min(hung.tensions)


def test_only_the_lesson_stands_on_the_lesson_s_ground() -> None:
    """All others touch an obstacle, whose friction sticks."""
    assert [name for name in names() if preset(name).ground] == ["n40"]


def test_a_slack_shape_may_have_a_sag_of_its_own() -> None:
    shape = Slack(start=(0, 0, 1), end=(30, 40, 11), sag="3 m")  # type: ignore[arg-type]
    x = shape.places(4000, 1.0, 1.0, (0.0, 0.0, 1.0), 0.01)
    share = np.hypot(x[:, 0], x[:, 1]) / 50.0
    assert (1.0 + 10.0 * share - x[:, 2]).max() == pytest.approx(3.0, rel=1e-6)
    assert x[[0, -1]] == pytest.approx(np.array([(0, 0, 1), (30, 40, 11)]), abs=1e-12)
    pieces = np.linalg.norm(np.diff(x, axis=0), axis=1)
    assert pieces.max() == pytest.approx(pieces.min(), rel=1e-6)
    own = Slack(start=(0, 0, 1), end=(30, 40, 11))
    length = float(pieces.sum())
    assert own.places(4000, length, 1.0, (0.0, 0.0, 1.0), 0.01) == pytest.approx(x, abs=1e-5)
    with pytest.raises(SceneError, match="aside from start, across gravity"):
        loads(PLUMB)


PLUMB = """
[[rope]]
segments = 10
length = 5.0
made_of = "semistatic-10.5"
shape = {kind = "slack", end = [0.0, 0.0, -6.0], sag = 1.0}
[[anchor]]
node = 0
"""


def test_an_unknown_preset_names_the_nearest() -> None:
    with pytest.raises(SceneError, match='"skiping-rope" - no such preset; did you mean "skipping'):
        preset("skiping-rope")
    with pytest.raises(SceneError, match="no such preset"):
        preset_text("../presets/r1")


@pytest.mark.parametrize("name", [f"r{i}" for i in range(1, 10)])
def test_the_reports_constants(name: str) -> None:
    """Report: k 10000, c 0.05, m 50 g, L 1 m, dt 0.002 s, unless the scene is about another."""
    scene = preset(name)
    k = {"r7": 200.0, "r8": 100.0}.get(name, 10000.0)
    for rope in scene.ropes:
        assert isinstance(rope.made_of, Springs)
        assert rope.made_of.spring_constant == k
        assert rope.made_of.node_mass == 0.05
        assert rope.segment_length == 1.0
        assert rope.made_of.friction == "vector"
        if name not in ("r5", "r9"):
            assert rope.made_of.spring_friction == 0.05
    assert scene.run.time_step == (1 / 60 if name in ("r6", "r7", "r8") else 0.002)
    assert scene.run.method == "semi-implicit-euler"
    assert scene.up == (0.0, 1.0, 0.0)


def test_the_main_scene_and_its_kin_differ_in_what_they_are_about_only() -> None:
    main = preset("r4")
    assert [main.anchor_node(anchor) for anchor in main.anchors] == [0, 20, 40]
    motion = main.anchors[0].motion
    assert (motion.velocity, motion.start, motion.stop) == ((2.0, 0.0, 0.0), 0.5, 3.5)
    for name in ("r6", "r7", "r8", "r9"):
        assert preset(name).anchors == main.anchors
        assert preset(name).ropes[0].shape == main.ropes[0].shape
    four = preset("r5")
    assert [rope.made_of.spring_friction for rope in four.ropes] == [0.01, 0.05, 0.2, 1.0]
    assert len(four.anchors) == 12
    assert preset("r9").ropes[0].made_of.spring_friction == 0.0


def test_nehes_constants() -> None:
    scene = preset("n40")
    rope = scene.ropes[0]
    assert (rope.nodes, rope.segment_length) == (80, 0.05)
    assert (rope.made_of.spring_constant, rope.made_of.spring_friction) == (10000.0, 0.2)
    assert (rope.made_of.node_mass, rope.own_mass) == (0.05, pytest.approx(4.0))
    assert (rope.kicks[0].node, rope.kicks[0].velocity) == (-1, (0.0, 0.0, 10.0))
    assert scene.air.node_drag == 0.02
    ground = scene.ground
    assert (ground.height, ground.repulsion) == (-1.5, 100.0)
    assert (ground.friction, ground.absorption) == (0.2, 2.0)
    assert (scene.run.time_step, scene.run.steps) == (0.002, "nehe")
    spring = preset("n39-spring").ropes[0]
    assert (spring.made_of.spring_constant, spring.segment_length) == (2.0, 0.0)
    assert spring.shape.end[0] - spring.shape.start[0] == 10.0
    assert preset("n39-gravity").ropes[0].shape.velocity == (10.0, 15.0, 0.0)


def test_habradors_constants() -> None:
    scene = preset("h1")
    rope = scene.ropes[0]
    assert (rope.nodes, rope.segment_length, rope.made_of.spring_constant) == (7, 1.0, 40.0)
    assert (rope.made_of.spring_friction, rope.made_of.friction) == (2.0, "axial")
    assert (rope.loads[0].node, rope.loads[0].mass) == (0, 1.0)
    assert scene.anchor_node(scene.anchors[0]) == 6
    assert (scene.limiter.min_stretch, scene.limiter.max_stretch) == (0.9, 1.1)
    assert (scene.run.method, scene.run.time_step, scene.run.steps) == ("heun", 0.02, "exact")
    assert preset("h2").limiter.passes == 20
    # the tutorial's formula: k = (wire + load) g / 1 cm, wire = 7750 kg/m^3 pi r^2 L
    wire = 7750.0 * math.pi * 0.02**2 * 1.0
    winch = preset("h3").ropes[0]
    assert winch.made_of.node_mass == pytest.approx(wire, rel=1e-4)
    assert winch.made_of.spring_constant == pytest.approx((wire + 100.0) * 9.81 / 0.01, rel=1e-5)
    assert winch.made_of.spring_friction == pytest.approx(0.8 * 107654.0, rel=1e-5)
