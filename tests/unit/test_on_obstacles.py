"""What is around a rope that touches obstacles: files, checks, sheets, tables, live edits."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.core.status import OK
from ropewalk.laws.obstacle import radius_of
from ropewalk.live.edits import Edit
from ropewalk.live.track import Track
from ropewalk.lowering import build
from ropewalk.record.export import export
from ropewalk.scene import (
    Anchor,
    Contact,
    Cylinder,
    Ground,
    Material,
    Plane,
    Polyline,
    Rope,
    Scene,
    SceneError,
    Straight,
    apply_overrides,
    dumps,
    loads,
)
from ropewalk.scene.recut import recut
from ropewalk.sheets.ropes import assumption_section
from ropewalk.statics.wraps import Wrap, sliding_words

STUFF = 'made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1, axial_damping = 5.0 }'


def over_a_bar(diameter: str = "diameter = 0.01") -> Scene:
    """A rope that hangs over a bar, with a load at one end and a breaking load."""
    return loads(f"""
[run]
duration = 0.05
time_step = 0.005
method = "implicit-euler"
[[rope]]
name = "rope"
segments = 8
length = 0.5
{diameter}
loads = [{{ node = -1, mass = 0.5 }}]
made_of = {{ kind = "material", EA = 1e4, mass_per_length = 0.1, breaking_load = 5e3 }}
shape = {{ kind = "polyline", points = [[-0.2, 0, 0.06], [0.2, 0, 0.06]] }}
[[anchor]]
rope = "rope"
node = 0
[[obstacle]]
name = "bar"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.05
""")


def test_a_given_diameter_outlives_a_file_even_where_it_is_the_default() -> None:
    """Half of it keeps the rope off the obstacles; a rope without one touches as a line."""
    for scene, radius in ((over_a_bar(), 0.005), (over_a_bar(""), 0.0)):
        assert radius_of(scene.ropes[0]) == radius
        assert radius_of(loads(dumps(scene)).ropes[0]) == radius
        assert radius_of(apply_overrides(scene, ["run.duration=0.1"]).ropes[0]) == radius


def test_what_is_an_obstacles_own_can_be_varied() -> None:
    scene = apply_overrides(over_a_bar(), ["obstacle[0].radius=0.06", "obstacle[0].friction=0.1"])
    assert (scene.obstacles[0].radius, scene.obstacles[0].friction) == (0.06, 0.1)


def test_check_says_where_a_rope_rests_and_nothing_where_there_is_no_rest() -> None:
    check = rw.check(over_a_bar())
    said = "\n".join(check.ropes[0].lines())
    assert "at rest: largest tension" in said
    assert "hang free" not in str(check)
    assert check.ropes[0].utilisation is not None
    loose = over_a_bar().model_copy(update={"anchors": ()})
    check = rw.check(loose)
    assert not any("at rest" in line for line in check.ropes[0].lines())
    assert check.ropes[0].utilisation is None
    (told,) = (text for text in check.warnings if "the ropes still slide or fall" in text)
    assert "fall. `ropewalk settle` looks longer. " in told
    assert not [text for text in check.warnings if ".." in text]
    assert "rope 'rope': no anchor holds it" in check.warnings
    assert not [text for text in check.warnings if "stretched" in text]


def test_a_sheet_names_obstacles_and_joints() -> None:
    words = str(assumption_section(over_a_bar()))
    assert "cylinder 'bar' with a coefficient of friction of 0.3" in words
    assert "contact with edges" not in words
    assert "contact with edges" in str(assumption_section(rw.preset("hanging-rope")))
    assert "Joint 'ring' ties" in str(assumption_section(rw.preset("three-leg-sling")))
    assert "49 joints tie" in str(assumption_section(rw.preset("net")))


def test_contact_forces_go_into_tables(tmp_path: Path) -> None:
    result = rw.simulate(over_a_bar())
    (path,) = export(result, "csv", tmp_path, quantities=["contact_force"])
    lines = path.read_text().splitlines()
    assert "contact fz [N]" in lines[0]
    told = np.array([float(line.split(",")[-1]) for line in lines[1:]])
    assert told.tobytes() == np.asarray(result.contact_force)[:, :, 2].ravel().tobytes()


def test_a_light_rope_that_carries_others_presses_as_the_whole_does() -> None:
    """A strop of which a piece is tied on has the contacts of the uncut one: 77 kN/m, not 0.7."""
    rope = f'{STUFF}\nsegments = 4\ndiameter = 0.01\nshape = {{ kind = "straight", start = [%s, 0, 1] }}'
    body = '[[obstacle]]\nkind = "plane"\n'
    load = "loads = [{ node = -1, mass = 20.0 }]\n"
    one = loads(f'[[rope]]\nname = "a"\nlength = 0.4\n{rope % 0}\n{load}{body}')
    two = loads(
        f'[[rope]]\nname = "a"\nlength = 0.4\n{rope % 0}\n'
        f'[[rope]]\nname = "b"\nlength = 0.4\n{rope % 0.4}\n{load}{body}'
        '[[joint]]\npoints = [{ rope = "a", node = -1 }, { rope = "b", node = 0 }]\n'
    )
    whole, tied = (build(scene).system.node.obstacle.stiffness[0] for scene in (one, two))
    assert tied[1] == pytest.approx(whole[1], rel=0.05)
    apart = build(two.model_copy(update={"joints": ()})).system.node.obstacle.stiffness[0]
    assert apart[1] < 0.5 * tied[1]


def test_a_loop_that_would_close_on_itself_is_not_halved() -> None:
    """An eye of two segments: the sheet's second run takes twice as many, not half."""
    scene = loads(f"""
[[rope]]
segments = 8
length = 0.8
{STUFF}
shape = {{ kind = "points", points = [
  [0, 0, 0], [0.1, 0, 0], [0.2, 0, 0], [0.3, 0, 0], [0.4, 0, 0], [0.5, 0, 0], [0.6, 0, 0], [0.65, 0.07, 0],
  [0.6, 0, 0]] }}
[[joint]]
points = [{{ node = -1 }}, {{ node = -3 }}]
""")
    assert recut(scene).factor == 2.0


@pytest.mark.parametrize(
    ("text", "path", "words"),
    [
        ('kind = "box"\nbar_radius = 1.0\ncenter = [0, 0, 0]\nhalf_sizes = [1, 1, 1]\nedge_radius = 0.1',
         "obstacle[0].bar_radius", "unknown key of 'box'; only"),
        ('kind = "capsule"\nfrom = [0, 0, 0]\nstart = [0, 0, 0]\nto = [1, 0, 0]\nradius = 0.1',
         "obstacle[0].from", "is given already"),
    ],
)  # fmt: skip
def test_faults_of_obstacles_are_told_where_they_are(text: str, path: str, words: str) -> None:
    with pytest.raises(SceneError) as error:
        loads(f"[[rope]]\nsegments = 2\nlength = 1.0\n{STUFF}\n[[obstacle]]\n{text}\n")
    told = {fault.path: fault.rule for fault in error.value.faults}
    assert words in told[path]


def test_a_stop_that_is_no_number_may_be_inf() -> None:
    """It once said that it must be finite."""
    with pytest.raises(SceneError) as error:
        apply_overrides(rw.preset("capstan"), ["obstacle.spin.stop=nan"])
    (fault,) = error.value.faults
    assert (fault.path, fault.rule) == (
        "obstacle[0].spin.stop",
        "must be a number (s), or inf for never",
    )
    apply_overrides(rw.preset("capstan"), ["obstacle.spin.stop=inf"])


def test_a_faulty_point_is_the_only_fault_of_its_joint() -> None:
    with pytest.raises(SceneError) as error:
        loads(
            f"[[rope]]\nsegments = 2\nlength = 1.0\n{STUFF}\n[[joint]]\n"
            "points = [{ node = 0 }, { node = 1.5 }]\n"
        )
    assert [fault.path for fault in error.value.faults] == ["joint[0].points[1].node"]


def on_a_plane(tilt: float, spin: str = "") -> Scene:
    c, s = math.cos(tilt), math.sin(tilt)
    start, end = (
        [0.1 + 0.0055 * s, 0, 0.0055 * c],
        [0.1 + 0.0055 * s + 0.4 * c, 0, 0.0055 * c - 0.4 * s],
    )
    start[2], end[2] = start[2] - 0.1 * s / c, end[2] - 0.1 * s / c
    return loads(f"""
[run]
method = "esdirk3"
time_step = 0.016666666666
duration = 5
[[rope]]
name = "rope"
segments = 4
length = 0.4
diameter = 0.011
{STUFF}
shape = {{ kind = "straight", start = {json.dumps(start)}, end = {json.dumps(end)} }}
[[obstacle]]
kind = "plane"
normal = [{s}, 0, {c}]
friction = 0.3
{spin}
""")


def test_live_edits_let_contacts_hold() -> None:
    """Twenty edits that change nothing let a rope on a slope creep by 0.5 mm once; now by 1e-6 mm at most."""
    track: Any = Track(on_a_plane(math.radians(14.0)))
    assert track.advance(90) == OK
    before = track.simulation.positions.copy()
    for _ in range(20):
        track.edit(Edit(track.scene, np.arange(5.0)))
        assert track.advance(3) == OK
    assert np.abs(track.simulation.positions - before).max() < 1e-9


def test_a_turntable_drags_along_its_turn_and_a_fast_one_is_warned_of() -> None:
    """Friction follows the chord of the surface's way in a step: half the angle of the turn aside."""
    simulation = rw.Simulation(on_a_plane(0.0, "spin = { rate = 5.0 }"))
    simulation.advance_steps(12)
    place, speed = simulation.positions[2], simulation.velocities[2]
    along = np.array([-place[1], place[0], 0.0]) / np.hypot(place[0], place[1])
    assert speed @ along == pytest.approx(0.3 * 9.81 * simulation.time, rel=0.05)
    aside = {
        rate: [text for text in rw.check(on_a_plane(0.0, spin)).warnings if "aside" in text]
        for rate in (5.0, 100.0)
        for spin in [f"spin = {{ rate = {rate} }}"]
    }
    assert not aside[5.0]
    assert "turns by 95.5 degrees in a step" in aside[100.0][0]


def test_only_explicit_methods_are_warned_of_long_ways() -> None:
    """What would go through is solved again in halves by implicit ones: a run of 5 radii a step is fine."""
    bar = over_a_bar().obstacles[0].replace(radius=0.001)
    thrown = over_a_bar().replace(
        obstacles=[bar.replace(start=(0, -0.1, -0.2), end=(0, 0.1, -0.2))],
        gravity=(0.0, 0.0, -50.0),
    )
    told = {
        method: [
            text
            for text in rw.check(apply_overrides(thrown, [f"run.method={method}"])).warnings
            if "a node may move" in text
        ]
        for method in ("implicit-euler", "bdf2", "verlet")
    }
    assert not told["implicit-euler"]
    assert not told["bdf2"]
    assert "a run in which one goes through ends there" in told["verlet"][0]
    assert not [text for text in rw.check("munter").warnings if "a node may" in text]


def test_a_corner_of_three_planes_is_in_the_bound() -> None:
    one = loads(
        f'[[rope]]\nsegments = 2\nlength = 0.2\n{STUFF}\nshape = {{ kind = "straight", start = [1, 1, 1] }}\n'
    )
    bodies = [rw.scene.Plane(normal=n) for n in ((0, 0, 1), (0, 1, 0), (1, 0, 0))]
    steps = [
        rw.check(one.replace(obstacles=bodies[:count])).stability.largest_step["verlet"]
        for count in (1, 2, 3)
    ]
    assert steps[0] > steps[1] > steps[2]


def lines(*heights: float, **more: object) -> Scene:
    """Ropes of 0.5 m along x in turn with such along y, at `heights` [m]."""
    made_of = Material(EA=2e4, mass_per_length=0.1, axial_damping=20.0)
    ropes = []
    for row, z in enumerate(heights):
        way = np.array([0.25, 0.0, 0.0] if row % 2 == 0 else [0.0, 0.25, 0.0])
        shape = Straight(
            start=tuple(np.array([0, 0, z]) - way), end=tuple(np.array([0, 0, z]) + way)
        )
        cut = {"segments": 20, "length": 0.5, "diameter": 0.01}
        ropes.append(Rope(name=f"rope{row}", **cut, made_of=made_of, shape=shape))
    return Scene(ropes=ropes, **more)


def unheld(scene: Scene) -> list[str]:
    """What is said of ropes that no anchor holds."""
    return [
        text for text in rw.check(scene, measure=False).warnings if "hold" in text.split(";")[0]
    ]


def test_of_ropes_that_no_anchor_holds_one_sentence_is_said() -> None:
    """A net had a line for each of its ropes, and "it falls" was said of a rope right above another."""
    floor, touch = Plane(point=(0, 0, -1)), Contact(friction=0.3)
    assert unheld(lines(0.0, 0.02, 0.04, 0.06)) == [
        "ropes 'rope0', 'rope1', 'rope2' and 1 more: nothing holds them; they fall"
    ]
    assert unheld(lines(0.0)) == ["rope 'rope0': nothing holds it; it falls"]
    assert unheld(lines(0.0, gravity=(0, 0, 0))) == ["rope 'rope0': nothing holds it"]
    ends = [Anchor(rope="rope0", node=node) for node in (0, -1)]
    assert unheld(lines(0.0, 0.02, anchors=ends)) == ["rope 'rope1': nothing holds it; it falls"]
    assert unheld(lines(0.0, 0.02, anchors=ends, contact=touch)) == [
        "rope 'rope1': no anchor holds it"
    ]
    assert unheld(lines(0.0, ground=Ground(height=0.0))) == []  # which lies there, and was to fall
    both = "ropes 'rope0', 'rope1': "
    assert unheld(lines(0.0, 0.02, contact=touch)) == [f"{both}nothing holds them; they fall"]
    assert unheld(lines(0.0, 0.02, contact=touch, obstacles=[floor])) == [
        f"{both}no anchor holds them"
    ]


def test_what_is_tied_to_a_rope_that_lies_is_held() -> None:
    """A rope over a bar, and one that hangs from its end and touches nothing: it was said to fall."""
    arc = [(0.0555 * math.cos(a), 0.0, 0.0555 * math.sin(a)) for a in np.linspace(math.pi, 0.0, 25)]
    over = Polyline(points=[(-0.0555, 0, -0.3), *arc, (0.0555, 0, -0.3)])
    hangs = Straight(start=(0.0555, 0, -0.3), end=(0.0555, 0, -0.4))
    scene = lines(0.0, 0.0)
    first, second = scene.ropes
    ropes = [
        first.replace(segments=40, length=0.6 + 0.0555 * math.pi, shape=over),
        second.replace(segments=4, length=0.1, shape=hangs),
    ]
    points = [{"rope": "rope0", "node": -1}, {"rope": "rope1", "node": 0}]
    bar = Cylinder(start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, friction=0.8)
    tied = Scene(ropes=ropes, joints=[{"points": points}], obstacles=[bar])
    assert {wrap.rope for wrap in rw.check(tied, measure=False).statics.wraps} == {"rope0"}
    assert unheld(tied) == []


def test_the_slope_that_friction_holds_is_that_of_the_least() -> None:
    """Of ice and a post it named what the post holds: a rope slides on the ice from 5.7 degrees on."""

    def lies(obstacle: str, friction: float, first: int = 0, angle: float = 0.0) -> Wrap:
        ends, known = (first, first + 4), (math.nan, math.nan)
        return Wrap("rope", obstacle, *ends, 10.0, angle, 1.0, 1.0, *known, False, 1.0, friction)

    both = sliding_words((lies("ice", 0.1), lies("post", 0.5, 10)))
    assert f"{math.degrees(math.atan(0.1)):.4g} degrees with the least of them" in both
    assert "26.57 degrees, and round a drum" in sliding_words((lies("post", 0.5, angle=1.0),) * 2)
    assert "26.57 degrees. Give" in sliding_words((lies("post", 0.5),) * 2)  # nothing turns there
    groove = sliding_words((lies("left", 0.3), lies("right", 0.3, 2)))  # it holds 31 degrees
    assert "degrees" not in groove
    assert "carries all it can. Give more friction" in groove


@pytest.mark.parametrize(("bearing", "stands"), [(0.0, False), (50.0, True)])
def test_check_says_that_a_free_wheel_is_held_still(bearing: float, stands: bool) -> None:
    """A rope from an anchor over it with 5 kg: "at rest" was said, as of a wheel that is held."""
    arc = [(0.0508 * math.cos(a), 0.0, 0.0508 * math.sin(a)) for a in np.linspace(math.pi, 0.0, 17)]
    over = Polyline(points=[(-0.0508, 0, -0.1), *arc, (0.0508, 0, -0.1)])
    made_of = Material(EA=1e4, mass_per_length=0.05)
    rope = Rope(
        segments=24, length=0.2 + 0.0508 * math.pi, diameter=0.001, made_of=made_of, shape=over,
        loads=[rw.Load(node=-1, mass=5.0)],
    )  # fmt: skip
    wheel = Cylinder(
        name="wheel", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05, friction=0.5,
        spin=rw.scene.Spin(free=True, inertia=2.0, bearing=bearing),
    )  # fmt: skip
    found = rw.check(
        Scene(ropes=[rope], anchors=[Anchor(node=0)], obstacles=[wheel]), measure=False
    )
    assert found.statics.solved
    told = [
        text for text in found.warnings if "held still here, and turns when it is let go" in text
    ]
    assert bool(told) is not stands
    (pulley,) = found.as_dict()["statics"]["pulleys"]  # type: ignore[index]
    assert pulley["stands"] is stands
    assert pulley["torque"] == pytest.approx(found.statics.pulleys[0].torque)
