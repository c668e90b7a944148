"""Writing a scene and reading it back is the identity, for any scene."""

from __future__ import annotations

import math
import tomllib
from itertools import combinations

import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from ropewalk.scene import (
    Anchor,
    Rope,
    Scene,
    SceneError,
    Slack,
    Springs,
    Velocity,
    apply_overrides,
    dumps,
    load,
    loads,
    save,
    schema,
)
from strategies import numbers, scenes
from verification.feature_pairs import FEATURES, MORE, scene_of

RELAXED = settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
VALIDATOR = jsonschema.Draft202012Validator(schema())


@RELAXED
@given(scenes())
def test_reading_what_was_written_gives_the_same_scene(scene: Scene) -> None:
    again = loads(dumps(scene))
    assert again == scene
    assert dumps(again) == dumps(scene)


def test_scenes_with_any_two_features_are_read_as_written() -> None:
    """Obstacles, contact, joints, slides and what else random scenes never have."""
    made = 0
    for pair in combinations(FEATURES | MORE, 2):
        try:
            scene = scene_of("implicit-euler", *pair, implicit=True)
        except SceneError:
            continue  # it is on the list of those that do not go together
        made += 1
        text = dumps(scene)
        assert loads(text) == scene, pair
        assert dumps(loads(text)) == text, pair
        VALIDATOR.validate(tomllib.loads(text))
    assert made > 240


@RELAXED
@given(scenes(), st.integers(0, 3))
def test_the_round_trip_can_fail(scene: Scene, which: int) -> None:
    """The twin: a scene whose text was changed is another scene."""
    changed = {
        0: lambda: scene.replace(gravity=[scene.gravity[0], scene.gravity[1], 20.0]),
        1: lambda: scene.replace(description=scene.description + "x"),
        2: lambda: scene.replace(ropes=[scene.ropes[0].replace(diameter=0.06), *scene.ropes[1:]]),
        3: lambda: scene.replace(run=scene.run.replace(duration=math.nextafter(0.2, 1.0))),
    }[which]()
    assert loads(dumps(changed)) != scene


@RELAXED
@given(scenes())
def test_every_number_keeps_its_bits(scene: Scene) -> None:
    again = loads(dumps(scene))
    assert repr(again.model_dump()) == repr(scene.model_dump())


@RELAXED
@given(scenes())
def test_every_written_scene_follows_the_schema(scene: Scene) -> None:
    VALIDATOR.validate(tomllib.loads(dumps(scene)))


@given(
    st.floats(allow_nan=True, allow_infinity=True) | st.integers(-(10**30), 10**30),
    st.sampled_from(["duration", "frame_rate", "time_step", "auto_fraction"]),
)
@settings(max_examples=150, deadline=None)
def test_any_number_is_taken_or_refused_by_name(value: float, key: str) -> None:
    try:
        scene = loads(dumps(PLAIN).replace("[run]\n", f"[run]\n{key} = {value!r}\n"))
    except SceneError as error:
        paths = [fault.path for fault in error.faults]
        assert paths in ([f"run.{key}"], ["run.duration"])
    else:
        assert getattr(scene.run, key) == value
        assert math.isfinite(value)
        assert value > 0


PLAIN = Scene(
    ropes=Rope(
        segments=4,
        made_of=Springs(spring_constant=100.0, node_mass=0.1, segment_length=0.5),
        shape=Slack(start=(0, 0, 0), end=(1, 0, 0)),
    ),
    anchors=[Anchor(node=0), Anchor(node=-1, motion=Velocity(velocity=(1, 0, 0), stop=math.inf))],
)


@given(
    st.dictionaries(
        st.text(max_size=12),
        st.recursive(
            st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
            lambda inner: (
                st.lists(inner, max_size=3)
                | st.dictionaries(st.text(max_size=8), inner, max_size=3)
            ),
        ),
        max_size=4,
    )
)
@settings(max_examples=150, deadline=None)
def test_any_table_is_refused_with_sentences(table: dict[str, object]) -> None:
    """A random table has no rope and ends in a SceneError, never in anything else."""
    with pytest.raises(SceneError, match="rope"):
        Scene.model_validate(table)


@given(st.text(max_size=80))
@settings(max_examples=200, deadline=None)
def test_any_text_is_refused_with_a_sentence(text: str) -> None:
    with pytest.raises(SceneError) as caught:
        loads(text, "some.toml")
    assert str(caught.value).startswith("some.toml: ")


@given(st.text(max_size=40))
@settings(max_examples=200, deadline=None)
def test_any_override_changes_the_scene_or_is_refused(override: str) -> None:
    try:
        assert isinstance(apply_overrides(PLAIN, [override]), Scene)
    except SceneError as error:
        refused = str(error)
        assert refused


@given(
    st.sampled_from(["rope.segments", "rope.made_of.node_mass", "anchor.node", "gravity", "run"]),
    st.text(max_size=12) | numbers(-1e20, 1e20).map(repr) | st.integers().map(str),
)
@settings(max_examples=200, deadline=None)
def test_any_value_of_an_override_is_taken_or_refused(path: str, value: str) -> None:
    try:
        changed = apply_overrides(PLAIN, [f"{path}={value}"])
    except SceneError as error:
        refused = str(error)
        assert refused
    else:
        assert loads(dumps(changed)) == changed


def test_saving_and_loading_a_file(tmp_path) -> None:
    file = tmp_path / "a scene.toml"
    save(PLAIN, file)
    assert load(file) == PLAIN
    assert list(tmp_path.iterdir()) == [file]
