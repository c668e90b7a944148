"""Overrides: what they reach, and what wrong ones get."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from ropewalk.scene import (
    Anchor,
    Load,
    Material,
    Mesh,
    Rope,
    RunSettings,
    Scene,
    SceneError,
    Shake,
    Springs,
    Straight,
    Velocity,
    apply_overrides,
    dumps,
    loads,
)
from ropewalk.scene.presets import preset


def rope(name: str, z: float = 0.0) -> Rope:
    made_of = Springs(spring_constant=1e4, node_mass=0.05, segment_length=0.5)
    loads = [Load(node=1, mass=1.0), Load(node=-1, mass=2.0)]
    return Rope(
        name=name, segments=4, made_of=made_of, loads=loads, shape=Straight(start=(0, 0, z))
    )


ONE = Scene(
    ropes=rope("only"),
    anchors=[Anchor(name="left", node=0, motion=Velocity(velocity=(1, 0, 0), stop=2.0))],
)
TWO = Scene(
    ropes=[rope("a"), rope("b", 1.0)],
    anchors=[Anchor(name="left", rope="a", node=0), Anchor(name="right", rope="b", node=-1)],
)


def test_no_override_changes_nothing() -> None:
    assert apply_overrides(ONE, []) == ONE
    assert apply_overrides(TWO, []) == TWO


def test_one_rope_or_all() -> None:
    assert [r.segments for r in apply_overrides(TWO, ["rope.segments=8"]).ropes] == [8, 8]
    assert [r.segments for r in apply_overrides(TWO, ["rope[1].segments=8"]).ropes] == [4, 8]
    assert [r.segments for r in apply_overrides(TWO, ["rope.a.segments=8"]).ropes] == [8, 4]
    both = apply_overrides(TWO, ["rope.segments=8", "rope.b.segments = 9"])
    assert [r.segments for r in both.ropes] == [8, 9]


def test_more_segments_of_springs_make_a_longer_rope() -> None:
    longer = apply_overrides(ONE, ["rope.segments=80"]).ropes[0]
    assert longer.segment_length == 0.5
    assert longer.length_unstretched == 40.0


def test_more_segments_of_a_material_keep_its_length() -> None:
    scene = Scene(ropes=Rope(segments=4, made_of=Material(EA=1, mass_per_length=1), length=2.0))
    finer = apply_overrides(scene, ["rope.segments=80"]).ropes[0]
    assert finer.length_unstretched == 2.0
    assert finer.segment_length == 0.025


def test_values_of_every_kind() -> None:
    scene = apply_overrides(
        ONE,
        [
            "run.method=rk4",
            "gravity=[0, 0, -1.6]",
            "rope.made_of.spring_constant=200",
            "rope.made_of.tension_only=true",
            "anchor.left.motion.velocity=[3, 0, 0]",
            "anchor[0].release_time=1.5",
            "rope.load[1].mass=7",
            "rope[0].load[0].node=2",
            "air.node_drag=0.02",
            'name="a name"',
            "description=free text, no quotes",
        ],
    )
    only = scene.ropes[0]
    assert scene.run.method == "rk4"
    assert scene.gravity == (0.0, 0.0, -1.6)
    assert (only.made_of.spring_constant, only.made_of.tension_only) == (200.0, True)
    assert scene.anchors[0].motion.velocity == (3.0, 0.0, 0.0)
    assert scene.anchors[0].release_time == 1.5
    assert [(load.node, load.mass) for load in only.loads] == [(2, 1.0), (-1, 7.0)]
    assert scene.air.node_drag == 0.02
    assert (scene.name, scene.description) == ("a name", "free text, no quotes")
    assert ONE.run.method == "semi-implicit-euler"


def test_a_method_that_nobody_asked_for_goes_with_the_springs() -> None:
    made = {"rope.made_of": Material(EA=1e4, mass_per_length=0.1), "rope.length": 2.0}
    other = ONE.replace(**made)
    assert other.run.method == ONE.replace(ropes=other.ropes).run.method == "auto"
    table = "rope.made_of={kind='material', EA=1e4, mass_per_length=0.1}"
    assert apply_overrides(ONE, [table, "rope.length=2"]) == other
    assert other.replace(ropes=ONE.ropes) == ONE
    asked = ONE.replace(**{"run.method": "semi-implicit-euler"}).replace(**made)
    assert asked.run.method == "semi-implicit-euler"


def test_auto_that_was_asked_for_is_kept_in_files_and_changes() -> None:
    auto = ONE.replace(run=RunSettings(method="auto"))
    assert loads(dumps(auto)) == auto
    assert apply_overrides(auto, ["rope.segments=5"]).run.method == "auto"


def test_run_settings_need_no_prefix() -> None:
    short = ["method=heun", "time_step=0.001", "duration=3", "frame_rate=25", "steps=exact"]
    assert apply_overrides(ONE, short) == apply_overrides(ONE, [f"run.{item}" for item in short])
    assert apply_overrides(ONE, short).run.time_step == 0.001


def test_a_new_kind_drops_what_it_does_not_know() -> None:
    changes = ["kind=shake", "axis=[0,0,1]", "amplitude=0.1", "frequency=2"]
    scene = apply_overrides(ONE, [f"anchor.left.motion.{change}" for change in changes])
    assert scene.anchors[0].motion == Shake(axis=(0, 0, 1), amplitude=0.1, frequency=2)
    assert apply_overrides(ONE, [f"anchor.left.motion.{one}" for one in changes[::-1]]) == scene
    renamed = ["anchor.left.name=end", *(f"anchor.end.motion.{one}" for one in changes)]
    assert apply_overrides(ONE, renamed).anchors[0].motion == scene.anchors[0].motion
    table = apply_overrides(
        ONE, ['anchor.left.motion={kind="shake", axis=[0,0,1], amplitude=0.1, frequency=2}']
    )
    assert table == scene


def test_another_file_takes_the_place_of_what_was_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "b.csv").write_text("strain, tension\n0.1, 500\n0.2, 1500\n")
    made = Material(curve=[(0.1, 400.0), (0.2, 900.0)], mass_per_length=0.1)
    scene = Scene(ropes=Rope(segments=4, length=2.0, made_of=made), anchors=[Anchor(node=0)])
    changed = apply_overrides(scene, ["rope.made_of.curve.file=b.csv"])
    assert changed.ropes[0].made_of.curve.tension == (500.0, 1500.0)  # type: ignore[union-attr]
    assert made.curve is not None  # "give either file or ..." it was, by a field of one model
    assert made.curve.replace(file="b.csv").tension == (500.0, 1500.0)
    assert made.curve.replace(file=None).tension == made.curve.tension  # none takes nothing away
    tetra = Mesh(
        vertices=[(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
        faces=[(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)],
        rounding=0.1,
    )
    with pytest.raises(SceneError, match=r'obstacle\[0\].file: "none.obj" - no such file'):
        apply_overrides(scene.replace(obstacles=[tetra]), ["obstacle.file=none.obj"])


def test_none_takes_a_value_away() -> None:
    scene = apply_overrides(ONE, ["air.node_drag=0.1", "anchor.release_time=3"])
    assert apply_overrides(scene, ["air=none", "anchor.release_time=none"]) == ONE


def test_a_single_rope_can_be_renamed() -> None:
    scene = apply_overrides(ONE, ["rope.name=cord"])
    assert (scene.ropes[0].name, scene.anchors[0].rope) == ("cord", "cord")


@pytest.mark.parametrize(
    ("override", "line"),
    [
        ("rope.segmnts=3", 'rope[0].segmnts: unknown key; did you mean "segments"?'),
        ("rope.EA=3 MN", "rope[0].EA: unknown key here; write rope[0].made_of.EA"),
        ("EA=3 MN", "EA: unknown key here; write rope.made_of.EA"),
        ("segments=3", "segments: unknown key here; write rope.segments"),
        ("kind=material", "kind: unknown key; known: schema_version"),
        ("stiffnes=3", "stiffnes: unknown key; known: schema_version"),
        ("rope.mass=3", "rope[0].mass: unknown key; known: name"),
        ("rop.segments=3", 'rop: unknown key; did you mean "rope"?'),
        ("run.metod=rk4", 'run.metod: unknown key; did you mean "method"?'),
        ("rope[2].segments=3", "rope[2]: there is only [0]"),
        ("rope.olny.segments=3", 'rope.olny: no such name or key; did you mean "only"?'),
        ("anchor.lft.node=0", 'anchor.lft: no such name or key; did you mean "left"?'),
        ("winch.speed=3", "winch: the scene has none"),
        ("gravity.x=3", "gravity: holds a value of its own; set it whole"),
        ("run[0].duration=3", "run[0]: there is only one; write run"),
        ("rope[0]=3", "rope[0]: give a key of it too"),
        (
            "rope.made_of.EA=3",
            "'springs' has no such key, 'material' has: set rope[0].made_of.kind",
        ),
        ("anchor.motion.frequency=3", "'velocity' has no such key"),
        ("segments", '"segments": must be written as path=value'),
        ("=3", '"=3": must be written as path=value'),
        ("", '"": must be written as path=value'),
        ("rope..segments=3", "rope..segments: is no path"),
        ("rope[x].segments=3", "rope[x].segments: is no path"),
        ("rope.segments=0", "rope[0].segments: 0 - must be at least 1"),
        ("rope.segments=8O", 'rope[0].segments: "8O" - must be a whole number'),
        ("rope.segments=", 'rope[0].segments: "" - must be a whole number'),
        ("rope.segments=none", 'rope[0].segments: "none" - must be a whole number'),
        ("method=rk5", 'run.method: "rk5" - must be one of'),
        ("time_step=nan", "run.time_step: nan - must be a number of seconds"),
        ("name=1\nfoo=2", None),
    ],
)
def test_wrong_overrides(override: str, line: str | None) -> None:
    if line is None:  # two lines of TOML are one text, not two keys
        assert apply_overrides(ONE, [override]).name == "1\nfoo=2"
        return
    with pytest.raises(SceneError) as caught:
        apply_overrides(ONE, [override])
    assert line in str(caught.value)
    assert len(caught.value.faults) == 1


def test_all_wrong_overrides_come_at_once() -> None:
    with pytest.raises(SceneError) as caught:
        apply_overrides(TWO, ["rope.segmnts=3", "foo=1", "method=rk4"])
    assert [fault.path for fault in caught.value.faults] == ["rope[0].segmnts", "foo"]
    with pytest.raises(SceneError) as caught:
        apply_overrides(TWO, ["rope.segments=0", "method=rk5"])
    paths = [fault.path for fault in caught.value.faults]
    assert paths == ["run.method", "rope[0].segments", "rope[1].segments"]


def test_replace_reaches_as_deep_as_an_override() -> None:
    softer = ONE.replace(**{"rope.made_of.spring_constant": 200})
    assert softer == apply_overrides(ONE, ["rope.made_of.spring_constant=200"])
    assert softer.ropes[0].made_of.spring_constant == 200.0  # type: ignore[union-attr]
    assert ONE.ropes[0].made_of.spring_constant == 1e4  # type: ignore[union-attr]
    both = TWO.replace(**{"ropes.b.segments": 9, "anchors[0].node": 2, "name": "other"})
    assert [one.segments for one in both.ropes] == [4, 9]
    assert both.anchors[0].node == 2
    assert both.name == "other"


def test_replace_names_parts_beside_a_path_as_without_one() -> None:
    """Beside a path an anchor without a name was refused: its name "" must start with a letter."""
    scene = preset("hanging-rope")
    parts = {"anchors": [Anchor(node=0), Anchor(node=-1)]}
    made = scene.replace(**parts, **{"run.duration": 1.0})
    assert [anchor.name for anchor in made.anchors] == ["anchor0", "anchor1"]
    assert made == scene.replace(**parts).replace(**{"run.duration": 1.0})


def test_replace_takes_models_arrays_and_parts_of_scenes() -> None:
    stuff = Material(EA=1e4, mass_per_length=0.1)
    made = ONE.replace(**{"rope.made_of": stuff, "rope.length": 2.0, "rope.made_of.EA": 2e4})
    assert made.ropes[0].made_of == stuff.replace(EA=2e4)
    moved = ONE.replace(**{"anchor.left.motion.velocity": np.array([0.0, 1.0, 0.0])})
    assert moved.anchors[0].motion.velocity == (0.0, 1.0, 0.0)  # type: ignore[union-attr]
    assert ONE.ropes[0].replace(**{"made_of.node_mass": 3.0}).own_mass == 15.0


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("rope.made_of.spring_constnt", 'did you mean "spring_constant"'),
        ("ropes[4].segments", "there is only [0]"),
        ("rope..segments", "is no path"),
        ("rope.made_of.spring_constant", "must be greater than 0"),
    ],
)
def test_replace_says_what_is_wrong_with_a_path(path: str, words: str) -> None:
    with pytest.raises(SceneError) as caught:
        ONE.replace(**{path: -1.0})
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("changes", "path"),
    [
        (("rope=3", "rope.segments=5"), "rope"),
        (("rope=[3]", "rope.segments=5"), "rope"),
        (("rope=[]", "rope.segments=5"), "rope"),
        (("run=3", "run.duration=5"), "run"),
        (("anchor=x", "anchor.left.node=0"), "anchor"),
        (("rope[0].made_of=3", "rope[0].made_of.node_mass=5"), "rope[0].made_of"),
    ],
)
def test_a_part_that_was_set_to_something_else_before(changes: tuple[str, ...], path: str) -> None:
    with pytest.raises(SceneError) as raised:
        apply_overrides(ONE, changes)
    assert raised.value.faults[0].path == path


def test_a_number_of_too_many_digits() -> None:
    with pytest.raises(SceneError, match="must be a whole number"):
        apply_overrides(ONE, ["rope.segments=" + "9" * 5000])


@pytest.mark.parametrize(
    ("text", "value"), [(".5", 0.5), ("5.", 5.0), ("-.5", -0.5), ("+.5", 0.5), ("5.e-1", 0.5)]
)
def test_numbers_are_taken_as_they_are_typed(text: str, value: float) -> None:
    """TOML has none without a digit on both sides of the point."""
    found = apply_overrides(ONE, [f"rope.shape.start[2]={text}"]).ropes[0].shape
    assert isinstance(found, Straight)
    assert found.start[2] == value
