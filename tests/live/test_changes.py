"""What links, the command line and resets make of a session: its constants, whatever way it went."""

from __future__ import annotations

import random
from typing import Any

import pytest

from live.drive import do, refused, slack_rope
from ropewalk.live.changes import changes_between, label_of, same
from ropewalk.live.describe import _variant, parameters
from ropewalk.live.parameters import PARAMETERS, initial
from ropewalk.live.session import Session
from ropewalk.live.sources import address, scene_at
from ropewalk.scene import Anchor, Scene, SceneError
from ropewalk.scene.presets import preset

START = slack_rope()
# A way that leads to constants which none of its steps alone has.
WAYS: dict[str, list[tuple[str, Any]]] = {
    "the cut came after the constant": [("segments", 80), ("spring_constant", 1e3), ("segments", 40)],
    "and was taken back": [("segments", 80), ("spring_constant", 1e3), ("segments", None)],
    "the constant was taken back": [("segments", 80), ("spring_constant", None)],
    "the length came after the stiffness": [("length", 40.0), ("EA", 900.0), ("length", 20.0)],
    "the ground chose its height": [("ground", True)],
    "the step came by frames": [("time_step", 1e-4), ("steps_per_frame", 77)],
}  # fmt: skip


def constants(scene: Scene) -> dict[tuple[str, str], Any]:
    """Return everything that can be changed, of every rope."""
    return {
        (one.name, rope.name): one.get(scene, i)
        for one in PARAMETERS.values()
        for i, rope in enumerate(scene.ropes)
    }


def assert_same(shown: Scene, made: Scene) -> None:
    now, then = constants(shown), constants(made)
    assert {key: (now[key], then[key]) for key in now if not same(now[key], then[key])} == {}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", ["r4", "hanging-rope"])
def test_an_address_has_the_constants_that_are_shown(name: str, way: str) -> None:
    """Of a rope of springs in given steps, and of one of a material in steps that the program chose."""
    session = Session(preset(name), name)
    for parameter, value in WAYS[way]:
        do(session, "set", name=parameter, value=value)
    assert_same(session.scene, initial(session.loaded, session.changes))
    found = address(session.start, (session.loaded, session.preset), session.changes)
    assert_same(session.scene, Session(scene_at(found, (START, None))).scene)


def test_a_chosen_step_stays_though_another_would_be_chosen_now() -> None:
    session = Session(preset("hanging-rope"), "hanging-rope")
    step = session.scene.run.time_step
    start = (session.loaded, session.preset)
    assert address(session.start, start, session.changes) == "scene=hanging-rope"
    do(session, "set", name="EA", value=1e5)
    link = address(session.start, start, session.changes)
    assert Session(scene_at(link, (START, None))).scene.run.time_step == step
    alone = scene_at(f"scene=hanging-rope&EA={1e5}", (START, None))
    assert Session(alone).scene.run.time_step != pytest.approx(step, rel=0.01)


def two() -> Scene:
    """Return two ropes of unlike pieces."""
    [rope] = START.ropes
    pair = [rope.replace(name="a"), rope.replace(name="b", segments=30)]
    ends = [
        Anchor(name=f"{one.name}{node}", rope=one.name, node=node)
        for one in pair
        for node in (0, -1)
    ]
    made: Scene = START.replace(ropes=pair, anchors=ends)
    return made


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("loaded", [preset("r4"), two()], ids=["springs", "two of a material"])
def test_no_way_is_too_crooked(loaded: Scene, seed: int) -> None:
    """Twelve changes at random, of one rope or all, some taken back: no simulation is needed for that."""
    dice = random.Random(seed)
    ropes = [None, *(rope.name for rope in loaded.ropes)]
    values: dict[str, Any] = {
        "segments": lambda: dice.randrange(10, 90),
        "length": lambda: dice.uniform(18.0, 25.0),
        "tension_only": lambda: dice.random() < 0.5,
        "friction_form": lambda: dice.choice(["vector", "axial"]),
        "gravity": lambda: [0.0, dice.uniform(-9.0, 9.0), 0.0],
        "ground": lambda: dice.random() < 0.5,
        "ground_height": lambda: dice.uniform(-9.0, 0.0),
        "method": lambda: dice.choice(["verlet", "rk4"]),
        "time_step": lambda: dice.uniform(1e-4, 1e-3),
    }
    numbers = ["spring_constant", "EA", "spring_friction", "mass", "diameter", "air_drag"]
    values |= dict.fromkeys(numbers, lambda: dice.uniform(1.0, 2.0))
    scene = loaded
    changes: dict[tuple[str, str | None], Any] = {}
    for _ in range(12):
        name = dice.choice(list(values))
        parameter = PARAMETERS[name]
        rope = dice.choice(ropes) if parameter.per_rope else None
        back = dice.random() < 0.2
        which = parameter.ropes(loaded, rope)[0]
        value = parameter.get(loaded, which) if back else values[name]()
        if value is None:
            continue
        scene = parameter.apply(scene, value, rope)
        changes.pop((name, rope), None)
        if not back:
            changes[name, rope] = value
        changes = changes_between(loaded, scene, changes)
    assert_same(scene, initial(loaded, changes))


def test_where_ropes_are_others_it_is_what_was_asked_for() -> None:
    session = Session(START)
    do(session, "set", name="mass", value=3.0)
    do(session, "cut", segment=20)
    do(session, "set", name="gravity", value=[0.0, 0.0, -1.6])
    assert session.changes == {("mass", None): 3.0, ("gravity", None): [0.0, 0.0, -1.6]}


def test_where_no_straight_way_leads_it_is_what_was_asked_for() -> None:
    """Two anchors a node apart: in 20 segments at once they would hold one node, by way of 30 they do not."""
    near = START.replace(anchors=[*START.anchors, Anchor(name="near", node=1)])
    session = Session(near)
    assert "is held by anchor" in refused(session, "set", name="segments", value=20)
    for segments in (30, 20):
        do(session, "set", name="segments", value=segments)
    assert session.changes == {("segments", None): 20}
    with pytest.raises(SceneError):
        initial(session.loaded, session.changes)


def frictions(session: Session) -> list[float]:
    """Return the friction of the springs of every rope [N s/m]."""
    return [rope.segment_friction for rope in session.scene.ropes]


def test_back_gives_every_rope_its_own_value() -> None:
    """All took that of the first."""
    pair = two()
    first, second = pair.ropes
    stiff = second.made_of.replace(axial_damping=5.0)
    session = Session(pair.replace(ropes=[first, second.replace(made_of=stiff)]))
    before = frictions(session)
    assert before[1] > before[0] > 0.0
    for rope in (None, "b"):
        do(session, "set", name="spring_friction", value=0.7, rope=rope)
    do(session, "set", name="spring_friction", value=None)
    assert frictions(session) == pytest.approx(before, rel=1e-12)
    assert session.changes == {}
    told = {one["name"]: one for one in parameters(session)["parameters"]}["spring_friction"]
    assert list(told["defaults"].values()) == pytest.approx(before, rel=1e-12)


def test_a_piece_of_a_cut_rope_goes_back_to_what_the_rope_had() -> None:
    """It read 'rope: "rope-2" - no such rope'; of one rope both halves took the mass of the whole."""
    session = Session(START)
    do(session, "cut", segment=20)
    before = frictions(session)
    do(session, "set", name="spring_friction", value=7.0)
    do(session, "set", name="spring_friction", value=None, rope="rope-2")
    assert frictions(session) == pytest.approx([7.0, before[1]])
    do(session, "set", name="spring_friction", value=None)
    assert frictions(session) == pytest.approx(before)
    assert session.changes == {}
    for rope in ("rope-2", None):
        assert "a piece of a cut rope has no mass of the scene's" in refused(
            session, "set", name="mass", value=None, rope=rope
        )
    assert "no such rope" in refused(session, "set", name="mass", value=None, rope="rope-9")
    told = {one["name"]: one["defaults"] for one in parameters(session)["parameters"]}
    assert told["mass"] == {"rope-1": None, "rope-2": None}


@pytest.mark.parametrize(
    ("own", "change"),
    [
        (("spring_constant", 5e3), ("spring_constant", 6e3)),
        (("spring_constant", 5e3), ("EA", 900.0)),
        (("spring_constant", 5e3), ("segments", 20)),
        (("time_step", 1e-4), ("time_step", 2e-4)),
    ],
)
def test_a_copy_stays_what_its_label_says(own: tuple[str, Any], change: tuple[str, Any]) -> None:
    """A change of all made it like the first."""
    session = Session(START)
    do(session, "compare", variants=[{"changes": dict([own])}])
    do(session, "set", name=change[0], value=change[1])
    first, copy = (track.scene for track in session.tracks)
    assert PARAMETERS[change[0]].get(first, 0) == pytest.approx(change[1])
    assert PARAMETERS[own[0]].get(copy, 0) == pytest.approx(own[1])
    do(session, "set", name="gravity", value=[0.0, -1.0, 0.0])
    assert [track.scene.gravity[1] for track in session.tracks] == [-1.0, -1.0]


@pytest.mark.parametrize("way", ["back", "undo"])
def test_a_copy_says_what_it_differs_in_as_it_was_then(way: str) -> None:
    """After Back its label and its changes were those of later, and a reset ran these."""
    session = Session(slack_rope())
    do(session, "compare", variants=[{"changes": {"EA": 2e4}}])
    copy, stiff = session.tracks[1], "Axial stiffness EA 20 kN"
    assert (copy.label, copy.changes) == (stiff, {"EA": 2e4})
    do(session, "kick", node=9, velocity=[0.0, 0.0, 1.0])
    do(session, "set", name="EA", value=5e4, variant=1)
    assert (copy.label, copy.changes) == ("Axial stiffness EA 50 kN", {"EA": 5e4})
    do(session, way, **({"seconds": 1.0} if way == "back" else {}))
    told = _variant(session.tracks[1], {}, {"rope": 0})
    assert (told["label"], told["changes"]) == (stiff, {"EA": 2e4})
    do(session, "reset")
    assert PARAMETERS["EA"].get(session.tracks[1].scene, 0) == pytest.approx(2e4)
    do(session, "set", name="method", value="rk4", variant=1)
    do(session, "set", name="EA", value=None, variant=1)
    assert session.tracks[1].label == "rk4, Axial stiffness EA 20 kN"


def test_a_label_that_was_given_stays_and_others_say_of_which_rope() -> None:
    """The first change in a copy took its name; of one rope alone it made "variant 2" of "Mass 2 kg"."""
    session = Session(two())
    mine = {"changes": {"EA": 2e4}, "label": "stiff"}
    do(session, "compare", variants=[mine, {"changes": {"mass": 2.0}}])
    do(session, "set", name="EA", value=5e4, variant=1)
    do(session, "set", name="mass", value=5.0, rope="b", variant=2)
    assert [one.label for one in session.tracks[1:]] == ["stiff", "Mass of b 5 kg"]
    assert session.tracks[1].changes == {"EA": 5e4}
    do(session, "reset")
    do(session, "set", name="mass", value=3.0, variant=1)
    do(session, "set", name="mass", value=3.0, variant=2)
    assert [one.label for one in session.tracks[1:]] == ["stiff", "Mass 3 kg"]


@pytest.mark.parametrize(
    ("changes", "label"),
    [
        ({"mass": 12345.6}, "Mass 12350 kg"),
        ({"mass": 0.5}, "Mass 0.5 kg"),
        ({"air_density": 12e3}, "Density of the air 12000 kg/m^3"),
        ({"segments": 20000}, "Segments 20000"),
        ({"gravity": (0.0, 0.0, -3.0)}, "Gravity (0, 0, -3) m/s^2"),
        ({"EA": 2e4}, "Axial stiffness EA 20 kN"),
        ({"method": "rk4"}, "rk4"),
    ],
)
def test_units_that_have_a_k_or_are_none_get_no_prefix(changes: dict[str, Any], label: str) -> None:
    """They read 12.35 kkg, 20 k and [0, 0, -3.0]."""
    assert label_of(changes) == label


@pytest.mark.parametrize(
    ("own", "change"),
    [
        ({"mass": 4.0}, ("gravity", [0.0, 0.0, -5.0])),
        ({"length": 11.0}, ("gravity", [0.0, 0.0, -5.0])),
        ({"segments": 20}, ("gravity", [0.0, 0.0, -5.0])),
        ({"mass": 4.0}, ("length", 6.0)),
    ],
)
def test_pieces_of_a_copy_keep_their_own_part(own: dict[str, Any], change: tuple[str, Any]) -> None:
    """Each got the label's value, which is that of the whole rope: 4 kg were 8.4 kg."""
    session = Session(slack_rope(10))
    do(session, "compare", variants=[{"changes": own}])
    do(session, "cut", segment=4)
    name = next(iter(own))
    copy = session.tracks[1]
    before = [PARAMETERS[name].get(copy.scene, i) for i in range(2)]
    do(session, "set", name=change[0], value=change[1])
    after = [PARAMETERS[name].get(copy.scene, i) for i in range(2)]
    assert after == pytest.approx(before, rel=1e-9)
    assert PARAMETERS[change[0]].get(copy.scene, 0) == pytest.approx(change[1])


def test_a_pin_takes_no_anchor_away_from_a_copy() -> None:
    """Of fewer segments the end, which `left` moved, was held by a pin in its place."""
    session = Session(slack_rope(8))
    do(session, "compare", variants=[{"changes": {"segments": 2}}])
    for node in (1, 5, 4):
        do(session, "pin", node=node)
    names = [[one.name for one in track.scene.anchors] for track in session.tracks]
    assert names == [["left", "right", "pin1", "pin2", "pin3"], ["left", "right", "pin2"]]
    do(session, "unpin", anchor="pin2")
    names = [[one.name for one in track.scene.anchors] for track in session.tracks]
    assert names == [["left", "right", "pin1", "pin3"], ["left", "right"]]


def test_a_comparison_is_reset_though_a_copy_has_a_step_of_its_own_again() -> None:
    """The word "auto" was kept for its step: every reset was refused from then on."""
    session = Session(slack_rope(8))
    do(session, "compare", variants=[{"changes": {"time_step": 1e-4}}])
    do(session, "set", name="time_step", value="auto", variant=1)
    step = session.tracks[1].dt
    do(session, "reset")
    assert session.tracks[1].dt == step != session.main.dt
