"""Scenes of contact that cannot be: each is refused in a sentence with path, value, rule and remedy."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import ropewalk as rw
from ropewalk.lowering import build
from ropewalk.scene import Cylinder, Plane, SceneError, Straight, loads

ROPE = """
[run]
duration = 0.1
frame_rate = 60
method = "esdirk3"
time_step = 0.004
[[rope]]
segments = 20
length = 1.0
diameter = 0.01
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.05, axial_damping = 10.0 }
shape = { kind = "straight", start = [-0.5, 0, %s], end = [0.5, 0, %s] }
"""
BAR = """
[[obstacle]]
name = "bar"
kind = "cylinder"
from = [0, -0.1, 0]
to = [0, 0.1, 0]
radius = 0.05
"""
MESH = "[[obstacle]]\nkind = 'mesh'\nfile = '%s'\n"
SDF = "[[obstacle]]\nkind = 'sdf'\nfile = '%s'\n"

#: What is written, and what the sentence must hold: path, value, rule, remedy.
CASES: dict[str, tuple[str, tuple[str, ...]]] = {
    "inside": (BAR, ("shape", "node 10", "inside obstacle 'bar'", "move the rope or the obstacle")),
    "zero radius": (BAR.replace("0.05", "0.0"), ("obstacle[0].radius", "0.0", "greater than 0")),
    "friction below 0": (BAR + "friction = -0.1", ("obstacle[0].friction", "-0.1", "at least 0")),
    "friction without end": (
        BAR + "friction = inf",
        ("obstacle[0].friction", "inf", "finite number", "what never slips has a large one, such as 10"),
    ),
    "friction of ropes": ("[contact]\nfriction = inf", ("contact.friction", "inf", "finite", "such as 10")),
    "friction that is none": (BAR + "friction = nan", ("obstacle[0].friction", "nan", "finite number")),
    "too fast": (
        BAR + "motion = { kind = 'velocity', velocity = [0, 0, 500] }",
        ("obstacle[0].motion", "500 m/s", "would jump over nodes", "run.time_step of at most"),
    ),
    "turns too fast": (
        BAR + "spin = { rate = 1e4 }",
        ("obstacle[0].spin", "1e+04 rad/s", "degrees in a step", "run.time_step of at most 0.00031 s"),
    ),
    "wheel without inertia": (
        BAR + "spin = { free = true }",
        ("obstacle[0].spin.inertia", "missing", "needs its moment of inertia", "m R^2 / 2"),
    ),
    "place that is none": (BAR.replace("-0.1", "nan"), ("obstacle[0].from[1]", "nan", "finite number (m)")),
    "two numbers": (BAR.replace("0, -0.1, 0", "0, 0"), ("obstacle[0].from", "[0, 0]", "[x, y, z] (m)")),
    "restitution": (
        "[contact]\nrestitution = 0.5\ncompliance = 1e-4",
        ("contact.restitution", "0.5", 'asks for run.method = "adaptive"', "or leave this out"),
    ),
    "of the ground": (
        "[ground]\nrestitution = 0.5",
        ("ground.restitution", "none here", "[ground] throws back by its spring", "its damping_ratio"),
    ),
    "one array": (SDF % "one.npy", ("obstacle[0].file", "one.npy", "one array", "numpy.savez")),
    "coordinates": (MESH % "nan.obj", ("obstacle[0].file", "nan.obj", "no triangles", "finite numbers")),
    "no mesh": (MESH % "no.stl", ("obstacle[0].file", "no.stl", "no triangles", "export it as STL again")),
}  # fmt: skip


@pytest.fixture
def files(tmp_path: Path) -> Path:
    np.save(tmp_path / "one.npy", np.zeros((3, 3, 3)))
    (tmp_path / "nan.obj").write_text("v 0 0 0\nv nan 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    (tmp_path / "no.stl").write_text("nothing\n")
    return tmp_path


@pytest.mark.parametrize("name", CASES)
def test_what_cannot_be_is_refused(name: str, files: Path) -> None:
    text, told = CASES[name]
    at = "0.02" if name == "inside" else "0.3"
    with pytest.raises(SceneError) as refused:
        build(loads(ROPE % (at, at) + text, folder=files))
    sentence = str(refused.value.faults[0])
    assert len(refused.value.faults) == 1, refused.value
    for words in told:
        assert words in sentence


def test_what_can_be_is_not_refused(files: Path) -> None:
    """The twin: the same rope and bar, with friction, and turned by less than half in a step."""
    model = build(loads(ROPE % ("0.3", "0.3") + BAR + "friction = 10.0\nspin = { rate = 700.0 }"))
    assert model.plan.dt * 700.0 < np.pi


def test_an_automatic_step_follows_what_turns() -> None:
    scene = loads(
        (ROPE % ("0.3", "0.3")).replace("0.004", '"auto"') + BAR + "spin = { rate = 1e4 }"
    )
    assert build(scene).plan.dt * 1e4 <= 0.5 * np.pi * (1.0 + 1e-9)
    assert build(scene).plan.dt < build(rw.Scene.replace(scene, obstacles=[])).plan.dt


@pytest.mark.parametrize("spin", ["rate = 1100.0", "free = true, inertia = 1.0, rate = -1100.0"])
def test_what_turns_by_more_than_half_in_a_step_is_refused(spin: str) -> None:
    """Ropes on a pulley were dragged backwards without a word: 3.2 N and 1.6 N in place of 4 N and 10.3 N."""
    with pytest.raises(SceneError, match="degrees in a step of .*: friction turns with the body"):
        build(loads(ROPE % ("0.3", "0.3") + BAR + f"spin = {{ {spin} }}"))
    slower = spin.replace("1100", "700")
    build(loads(ROPE % ("0.3", "0.3") + BAR + f"spin = {{ {slower} }}"))


@pytest.mark.parametrize("tied", [True, False])
def test_what_is_tied_to_an_anchor_inside_an_obstacle_may_stand_there(tied: bool) -> None:
    """As the anchored node itself, on which it is; a rope that begins there by itself may not."""
    ropes = [
        rw.Rope(
            name=name, segments=1, length=1.0, made_of=rw.Material(EA=1e3, mass_per_length=0.1),
            shape=Straight(start=(0.0, 0.0, 0.02), end=(side, 0.0, 0.02)),
        )
        for name, side in (("one", 1.0), ("other", -1.0))
    ]  # fmt: skip
    knot = {"points": [{"rope": name, "node": 0} for name in ("one", "other")]}
    bar = Cylinder(name="bar", start=(0, -0.1, 0), end=(0, 0.1, 0), radius=0.05)
    scene = rw.Scene(
        ropes=ropes, anchors=[rw.Anchor(rope="one", node=0)], joints=[knot] if tied else [],
        obstacles=[bar], run=rw.RunSettings(method="bdf2", time_step=1e-3),
    )  # fmt: skip
    if tied:
        rw.Simulation(scene)
        return
    with pytest.raises(rw.SceneError, match=r"rope\[1\].shape: .* inside obstacle 'bar'"):
        rw.Simulation(scene)


def test_a_rope_that_others_do_not_touch_is_not_pressed_in_by_them() -> None:
    """A light line 20 mm inside a floor was let in for 2 t beside it, and thrown up at 12 m/s."""

    def level(name: str, y: float, z: float, load: float) -> rw.Rope:
        return rw.Rope(
            name=name, segments=10, length=1.0, diameter=0.01,
            made_of=rw.Material(EA=1e4, mass_per_length=0.05, axial_damping=1.0),
            shape=Straight(start=(0.0, y, z), end=(1.0, y, z)),
            loads=[rw.Load(node=5, mass=load)] if load else [],
        )  # fmt: skip

    scene = rw.Scene(
        ropes=[level("light", 0.0, -0.015, 0.0), level("heavy", 3.0, 0.5, 2000.0)],
        obstacles=[Plane(name="floor")],
    )
    with pytest.raises(
        rw.SceneError, match=r"rope.0.\.shape: .node 0. - starts 20 mm inside .*'floor'"
    ):
        build(scene)


def test_a_plate_is_as_thin_as_it_is_long() -> None:
    """Of 4 mm and 0.7 m across: it went by 150 mm in a step, as nothing but its radius was asked."""
    plate = Cylinder(
        name="plate", start=(0, 0, -0.3), end=(0, 0, -0.296), radius=0.35,
        motion={"kind": "velocity", "velocity": (0, 0, 3.0)},
    )  # fmt: skip
    text = (ROPE % ("0.3", "0.3")).replace("time_step = 0.004", "time_step = %s")
    quick = loads(text % "0.05").replace(obstacles=[plate])
    with pytest.raises(
        rw.SceneError, match=r"more than the half length of 'plate' \(7 mm, .* 0.0023 s"
    ):
        build(quick)
    assert build(loads(text % '"auto"').replace(obstacles=[plate])).plan.dt < 0.0023
    aside = {"kind": "velocity", "velocity": (3.0, 0, 0)}  # in its own plane its radius counts
    build(quick.replace(obstacles=[plate.replace(motion=aside)]))
    held = loads((text % "0.004").replace("segments = 20", "segments = 4")).replace(
        anchors=[rw.Anchor(node=0), rw.Anchor(node=-1)],
        obstacles=[plate.replace(motion={"kind": "fixed"})],
    )
    upright = Straight(start=(0.5, 0, 0.6), direction=(0, 0, -1))
    for still, warned in ((held, 0), (held.replace(**{"rope.shape": upright}), 1)):
        told = rw.check(still, measure=False).warnings
        said = [one for one in told if "only nodes touch" in one]
        assert len(said) == warned
        assert all("longer than 1.4 times its half length (7 mm" in one for one in said)


def beside_a_thick_rope(more: str = "") -> rw.Scene:
    """A rope of 10 mm and segments of 0.2 m past a bar, and one of 120 mm, 5 m away."""
    thin = ROPE.replace("segments = 20", "segments = 5") % ("0.2", "0.2")
    thick = ROPE[ROPE.index("[[rope]]") :] % ("0.3", "0.3")
    thick = thick.replace("0.01", "0.12").replace(
        "mass_per_length = 0.05", "mass_per_length = 50.0"
    )
    thick = thick.replace("-0.5, 0,", "-0.5, 5.0,").replace("[0.5, 0,", "[0.5, 5.0,")
    names = "[[anchor]]\nrope = '%s'\nnode = 0\n[[anchor]]\nrope = '%s'\nnode = -1\n"
    ropes = thin.replace("[[rope]]", "[[rope]]\nname = 'thin'")
    ropes += thick.replace("[[rope]]", "[[rope]]\nname = 'thick'") if more else ""
    anchors = "".join(names % (one, one) for one in ["thin", *([more] if more else [])])
    return loads(ropes + BAR + "compliance = 1e-5\n" + anchors)


def test_a_thick_rope_elsewhere_hides_no_warning_of_a_thin_one() -> None:
    """Its half diameter was counted in: segments of 0.2 m were no longer long for a bar of 50 mm."""
    for scene, whose in (
        (beside_a_thick_rope(), "segments of 200 mm"),
        (beside_a_thick_rope("thick"), "segments of rope 'thin' of 200 mm"),
    ):
        told = [one for one in rw.check(scene, measure=False).warnings if "'bar'" in one]
        assert any(whose in one and "1.4 times its radius (55 mm" in one for one in told)
    quick = {
        "kind": "velocity",
        "velocity": (0.0, 0.0, 20.0),
    }  # 80 mm in a step: a jump for the thin one
    with pytest.raises(SceneError, match=r"more than the radius of 'bar' \(55 mm"):
        build(scene.replace(obstacles=[scene.obstacles[0].replace(motion=quick)]))


def test_the_compliance_that_is_advised_is_that_of_the_rope_that_yields_most() -> None:
    """It was that of the thick rope, which is pressed in deepest: a thin one got the next warning."""
    ropes = [
        rw.Rope(
            name=name, segments=10, length=1.0, diameter=thick,
            made_of=rw.Material(EA=1e5, mass_per_length=mass),
            shape=Straight(start=(-0.5, y, 0.3), end=(0.5, y, 0.3)),
        )
        for name, thick, mass, y in (("thin", 0.002, 2.0, 0.0), ("thick", 0.1, 50.0, 5.0))
    ]  # fmt: skip
    ends = [rw.Anchor(rope=rope.name, node=node) for rope in ropes for node in (0, -1)]
    bar = Cylinder(name="bar", start=(0, -6, 0), end=(0, 6, 0), radius=0.05, compliance=2e-5)
    scene = rw.Scene(ropes=ropes, anchors=ends, obstacles=[bar])

    def advised(compliance: float) -> list[float]:
        bars = [bar.replace(compliance=compliance)]
        told = " ".join(rw.check(scene.replace(obstacles=bars), measure=False).warnings)
        return [float(one) for one in re.findall(r"compliance of at most (\S+) m/N", told)]

    (most,) = advised(2e-5)
    assert most == pytest.approx(0.1 * 0.001 / (2.0 * 9.81), rel=0.25)
    assert not advised(most)
    assert advised(2.0 * most)


def test_what_is_thin_of_a_box_is_called_so() -> None:
    """It was "its radius", of a box 1 m wide."""
    crate = {"kind": "box", "name": "crate", "center": (0, 0, -0.5), "half_sizes": (0.5, 0.5, 0.5)}
    ring = {"kind": "torus", "name": "ring", "center": (0, 0, 0), "radius": 0.5, "bar_radius": 0.02}
    rounded = crate | {"edge_radius": 0.01}
    for body, measure in (
        (rounded, "twice its edges' radius"),
        (ring, "1.4 times its bar's radius"),
    ):
        scene = beside_a_thick_rope().replace(obstacles=[body])
        told = [one for one in rw.check(scene, measure=False).warnings if "only nodes touch" in one]
        assert any(f"{measure} (" in one for one in told)
