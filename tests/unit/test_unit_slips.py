"""Slips of units that a check sees, each with a twin that it lets pass."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from report_rope import material, scene
from ropewalk.analysis.unit_slips import unit_slips
from ropewalk.api import preset
from ropewalk.library import names
from ropewalk.library import rope as library_rope
from ropewalk.lowering import build
from ropewalk.scene import (
    Air,
    Box,
    Contact,
    Cylinder,
    Load,
    Material,
    Mesh,
    Plane,
    Polyline,
    Rope,
    Scene,
    Slide,
    Spin,
    Straight,
    Torus,
)


def slips(**changes: object) -> str:
    return "\n".join(unit_slips(build(scene(**changes))))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"gravity": (0, -9810.0, 0)}, "mm/s^2"),
        ({"gravity": (0, -32.17, 0)}, "ft/s^2"),
        ({"gravity": (0, 9.81, 0)}, "sign lost"),
        ({"gravity": (0, 0, 9.81)}, "points to +z"),
        ({"node_mass": 50.0}, "grams for kilograms"),
        ({"spring_constant": 1e10}, "faster than in any fibre"),
        ({"spring_constant": 0.01}, "slower than in rubber"),
        ({"time_step": 2.0, "duration": 100.0, "frame_rate": 0.5}, "milliseconds for seconds"),
        ({"segment_length": 50.0}, "lengths in millimetres"),
        ({"shape": Straight(start=(0, 0, 0), end=(20000.0, 0, 0))}, "places in millimetres"),
        ({"shape": Straight(start=(0, 0, 0), end=(0.02, 0, 0))}, "rope lengths in millimetres"),
        ({"shape": Polyline(points=((0, 0, 0), (9e3, 0, 0), (9e3, 9e3, 0)))}, "millimetres"),
        ({"loads": (Load(node=3, mass=80000.0),)}, "grams for kilograms"),
        ({"diameter": 12.0}, "not a rope's"),
    ],
)
def test_slips_of_units(changes: dict[str, object], words: str) -> None:
    assert words in slips(**changes)


def test_strains_in_per_cent_are_a_slip() -> None:
    for strain, warned in ((10.0, True), (5.0, False)):  # rubber bears some 7
        curve = [(0.5 * strain, 500.0), (strain, 900.0)]
        one = Rope(segments=4, length=2.0, made_of=Material(curve=curve, mass_per_length=0.06))
        found = "\n".join(unit_slips(build(scene().model_copy(update={"ropes": (one,)}))))
        assert ("per cent for shares?" in found) is warned


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"EA": 40.0, "mass_per_length": 0.2}, "kN for N"),
        ({"EA": 40.0, "diameter": 0.01, "mass_per_length": 1e-3}, ""),
        ({"EA": 2e11}, "Young's modulus"),
        ({"mass_per_length": 6000.0}, "grams for kilograms"),
        ({"mass_per_length": 60.0, "diameter": 0.01}, "density"),
        ({"EA": 0.05, "diameter": 0.01}, "that of no material"),
        ({"diameter": 10.0}, "not a rope's"),
        (
            {"breaking_load": 20.0},
            "bears 34 m of this rope, of 0.06 kg/m; kN for N, or g/m for kg/m?",
        ),
        ({"breaking_load": 20e3, "mass_per_length": 60.0}, "kN for N, or g/m for kg/m?"),
        ({"breaking_load": 4e5}, "where no rope breaks; kN for N in one of them?"),
        ({"breaking_load": 20e3, "EA": 1e3}, "where no rope breaks"),
        ({"breaking_load": 20e3}, ""),
        ({"breaking_load": 900.0, "EA": 75.0, "mass_per_length": 0.047}, ""),  # rubber
        ({"length": 30e3}, "30000 m of rope; lengths in millimetres?"),
        ({"length": 2e3, "mass_per_length": 0.02}, ""),  # a tether of 5 mm
        (
            {"length": 0.03, "diameter": 0.012, "EA": 5e6, "mass_per_length": 0.5},
            "is not a rope's shape",
        ),
    ],
)
def test_slips_of_a_material(changes: dict[str, object], words: str) -> None:
    made = scene().model_copy(update={"ropes": (material(**changes),)})
    found = "\n".join(unit_slips(build(made)))
    if words:
        assert words in found
    else:
        assert found == ""


@pytest.mark.parametrize("name", ["tow", "zip-line", "highline", "crane-snap", "climbing-fall"])
def test_rigging_presets_look_like_no_slip(name: str) -> None:
    assert unit_slips(build(preset(name))) == []


def test_a_rider_s_density_is_that_of_his_loads_too() -> None:
    """His diameter is to the air; grams for kilograms is still seen where nothing slides."""
    ride = preset("zip-line-ride")
    assert unit_slips(build(ride)) == []
    light = ride.replace(**{"rope[1].load[1].mass": 0.03, "rope[1].load[2].mass": 0.03})
    light = light.replace(**{"rope[1].load[0].mass": 0.03})
    assert "density" in "\n".join(unit_slips(build(light)))


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"gravity": (0, 0, -9.81)},
        {"gravity": (0, -1.62, 0)},
        {"gravity": (0, 0, 0)},
        {"spring_constant": 100.0},
        {"spring_constant": 10.0, "node_mass": 0.001},
        {"loads": (Load(node=3, mass=80.0),)},
        {"segment_length": 0.05, "segments": 79},
        {"diameter": 0.012},
    ],
)
def test_ordinary_scenes_pass(changes: dict[str, object]) -> None:
    assert slips(**changes) == ""


@pytest.mark.parametrize(
    ("air", "blows"),
    [({}, False), ({"density": 1.2}, True), ({"node_drag": 0.1}, True), ({"node_drag_quadratic": 0.1}, True)],
)  # fmt: skip
def test_a_wind_needs_something_to_blow_on(air: dict[str, float], blows: bool) -> None:
    scene = preset("r2")
    windy = scene.replace(air=Air(wind=(5.0, 0.0, 0.0), **air))
    told = [text for text in unit_slips(build(windy)) if "blows on nothing" in text]
    assert told == [] if blows else len(told) == 1


def test_friction_needs_something_to_rub_on() -> None:
    scene = preset("r2")
    rough = scene.replace(ropes=[scene.ropes[0].replace(friction=0.5)])
    told = [text for text in unit_slips(build(rough)) if "rubs on nothing" in text]
    assert len(told) == 1
    floor = rough.replace(obstacles=[Plane(point=(0, 0, -100))])
    assert not any("rubs on nothing" in text for text in unit_slips(build(floor)))


@pytest.mark.parametrize(
    ("diameter", "EA", "line"),
    [
        (0.0105, 25e3, 0.068),  # climbing rope
        (0.02, 26e6, 1.7),  # steel cable
        (0.0003, 1.5e2, 8e-5),  # fishing line
        (0.1, 800e6, 200.0),  # mooring chain
        (0.008, 30.0, 0.05),  # rubber
    ],
)
def test_real_ropes_pass(diameter: float, EA: float, line: float) -> None:
    rope = material(diameter=diameter, EA=EA, mass_per_length=line)
    made = scene().model_copy(update={"ropes": (rope,)})
    assert unit_slips(build(made)) == []


def test_no_rope_of_the_library_looks_like_a_slip() -> None:
    """Whole, with its guesses: from a spider's thread to a mooring chain."""
    for name in names():
        one = library_rope(name)
        made_of = one.material(guesses=True)
        piece = Rope(
            segments=4, length=500.0 * one.diameter, diameter=one.diameter, made_of=made_of,
            shape=Straight(start=(0, 0, 0)),
        )  # fmt: skip
        assert unit_slips(build(scene().model_copy(update={"ropes": (piece,)}))) == [], name


@pytest.mark.parametrize(("friction", "warned"), [(30.0, True), (1.5, False)])
def test_friction_in_per_cent_is_a_slip(friction: float, warned: bool) -> None:
    """It was taken without a word: 30, or the 17 degrees of an angle, for 0.3."""
    rope = material(name="line", diameter=0.01)
    other = material(name="rider", diameter=0.01, shape=Straight(start=(0, 9, 0)))
    plane = Plane(point=(0, 0, -100.0), friction=friction)
    slide = Slide(rope="rider", on="line", at=0.5 * rope.length_unstretched, friction=friction)
    made = Scene(ropes=[rope, other], obstacles=[plane], contact=Contact(friction=friction))
    told = unit_slips(build(made))
    told += unit_slips(build(Scene(ropes=[rope, other], slides=[slide])))
    paths = ["obstacle[0].friction", "contact.friction", "slide[0].friction"]
    assert [text.split(":")[0] for text in told] == (paths if warned else [])


@pytest.mark.parametrize(("speed", "warned"), [(1000.0, True), (30.0, False)])
def test_speeds_of_a_thousand_are_a_slip(speed: float, warned: bool) -> None:
    """Nothing was said of a rope thrown at 1 km/s, nor of anchors, bodies and winches that go as fast."""
    given = scene()
    fine = given.run.replace(time_step=1e-4)
    rope = given.ropes[0]
    thrown = rope.replace(shape=Straight(start=(0, 0, 0), velocity=(0, 0, speed)))
    kicked = rope.replace(kicks=[{"node": 1, "velocity": (speed, 0, 0)}])
    led = {"kind": "velocity", "velocity": (speed, 0, 0)}
    table = {"kind": "table", "times": (0, 1, 1.5), "positions": ((0, 0, 0),) * 2}
    table["positions"] += ((0.5 * speed, 0, 0),)
    scenes = {
        "rope[0].shape.velocity": given.replace(ropes=[thrown]),
        "rope[0].kick": given.replace(ropes=[kicked]),
        "anchor[0].motion.positions": given.replace(anchors=[{"node": 0, "motion": table}]),
        "anchor[0].motion.velocity": given.replace(anchors=[{"node": 0, "motion": led}]),
        "winch[0].speed": given.replace(
            anchors=[{"node": 0}],
            winches=[{"end": "start", "speed": speed, "on_drum": 1.0}],
            run=fine,
        ),
    }
    for path, one in scenes.items():
        found = [text for text in unit_slips(build(one)) if text.startswith(path)]
        assert [f"{path}: 1000 m/s is faster than sound in air; mm/s for m/s?"] * warned == found
    assert "faster than sound" not in "".join(
        unit_slips(build(scenes["rope[0].kick"].replace(gravity=(0, 0, 0))))
    )


@pytest.mark.parametrize(
    ("body", "reach"),
    [
        (Cylinder(start=(0, 0, -9), end=(0, 1, -9), radius=0.2), 0.2),
        (Torus(center=(0, 0, -9), radius=0.3, bar_radius=0.1), 0.4),
        (Box(center=(0, 0, -9), half_sizes=(0.4, 0.5, 1.2), edge_radius=0.1), 0.6),
        (Box(center=(0, 0, -9), half_sizes=(0.4, 1.3, 0.5), edge_radius=0.1, axis=(0, 5, 0)), 0.6),
        (
            Box(
                center=(0, 0, -9),
                half_sizes=(1.3, 0.6, 0.4),
                edge_radius=0.1,
                axis=(2, 0, 0),
                rotation=(0, math.pi / 2, 0),
            ),
            1.4,
        ),
        (
            Mesh(
                vertices=((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 2)),
                faces=((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)),
                position=(0, 0, -9),
                rounding=0.1,
            ),
            1.1,
        ),
    ],
)
def test_spins_faster_than_sound_are_a_slip(body: Any, reach: float) -> None:
    """By what the surface does: nothing was said of a drum at 3600 rad/s, which was meant in degrees."""
    given = scene()
    given = given.replace(run=given.run.replace(time_step=1e-5))
    for speed, warned in ((400.0, True), (300.0, False)):
        rate = speed / reach
        table = {"times": (0, 1, 1.5), "angles": (0, 0, -0.5 * rate)}
        spins: list[Any] = [{"rate": -rate}, table]
        if isinstance(body, Cylinder):
            spins.append({"free": True, "inertia": 1.0, "rate": rate})
        for spin in spins:
            found = unit_slips(build(given.replace(obstacles=[body.replace(spin=spin)])))
            assert [text for text in found if text.startswith("obstacle[0].spin: ")] == [
                f"obstacle[0].spin: {rate:.4g} rad/s is 400 m/s at {reach:g} m from the axis, faster than "
                "sound in air; degrees for radians, or mm for m?"
            ] * warned


def test_a_turntable_is_as_fast_as_where_ropes_are() -> None:
    given = scene()
    given = given.replace(run=given.run.replace(time_step=1e-5))
    x, y, _ = build(given).state.x
    for beyond in (0.0, 30.0):
        far = float(np.hypot(x - beyond, y).max())
        rate = 400.0 / far
        disc = Plane(point=(beyond, 0, -9), spin=Spin(rate=rate))
        (said,) = [s for s in unit_slips(build(given.replace(obstacles=[disc]))) if "spin" in s]
        assert f"{rate:.4g} rad/s is 400 m/s at {far:.4g} m from the axis" in said
        slow = Plane(point=(beyond, 0, -9), spin=Spin(rate=0.8 * rate))
        assert not [s for s in unit_slips(build(given.replace(obstacles=[slow]))) if "spin" in s]


def test_a_cam_is_as_fast_as_its_farthest_side() -> None:
    given = scene()
    given = given.replace(run=given.run.replace(time_step=1e-5))
    cam = Cylinder(
        start=(0, 0, -9), end=(0, 1, -9), radius=0.2,
        spin=Spin(rate=1000.0, pivot=(0.3, 0, -9)),
    )  # fmt: skip
    (said,) = [s for s in unit_slips(build(given.replace(obstacles=[cam]))) if "spin" in s]
    assert "500 m/s at 0.5 m from the axis" in said
