"""What faulty obstacles and contacts get: path, value and rule, by `check` as by `run`; nothing on disk."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.test_bad_input import refused, tree
from ropewalk.scene import SceneError, load, loads

SCENE = """
[run]
method = "implicit-euler"
time_step = 0.0041666667
duration = 0.05
[[rope]]
segments = 4
length = 0.4
diameter = 0.01
made_of = { kind = "material", EA = 1e4, mass_per_length = 0.1 }
shape = { kind = "straight", start = [-0.2, 0, 0.05], end = [0.2, 0, 0.05] }
"""
BALL = 'kind = "sphere"\ncenter = [0, 0, -1]\nradius = 0.1\n'

#: An obstacle, and what is said of it.
FAULTS = {
    "friction = -0.1": "obstacle[0].friction: -0.1 - must be at least 0",
    "friction = inf": "obstacle[0].friction: inf - must be a finite number",
    "friction = nan": "obstacle[0].friction: nan - must be a finite number",
    "friction = 1000": "obstacle[0].friction: 1000 - must be at most 100",
    "fricton = 0.3": "obstacle[0].fricton: unknown key of 'sphere'; did you mean \"friction\"?",
    "compliance = 0": "obstacle[0].compliance: 0 - must be greater than 0",
    "axis = [0, 0, 0]": "obstacle[0].axis: [0.0, 0.0, 0.0] - must not be zero",
    "spin = { rate = inf }": "obstacle[0].spin.rate: inf - must be a finite number (rad/s)",
    "spin = { rate = 1, start = 2, stop = 1 }": "obstacle[0].spin.stop: 1.0 - ",
}
WHOLE = {
    'kind = "sphere"\ncenter = [0, 0, -1]\nradius = 0': "radius: 0 - must be greater than 0",
    'kind = "sphere"\ncenter = [0, 0, -1]\nradius = -1': "radius: -1 - must be greater than 0",
    'kind = "sphere"\ncenter = [0, 0, -1]\nradius = 1e300': "radius: 1e+300 - must be at most 1e+15",
    'kind = "sphere"\ncenter = [nan, 0, -1]\nradius = 1': "center[0]: nan - must be a finite number",
    'kind = "sphere"\ncenter = [1e300, 0, -1]\nradius = 1': "center[0]: 1e+300 - must be at most",
    'kind = "plane"\nnormal = [0, 0, 0]': "normal: [0.0, 0.0, 0.0] - must not be zero",
    'kind = "cylinder"\nfrom = [0, 0, -1]\nto = [0, 0, -1]\nradius = 0.1': "must not be the point from",
    'kind = "torus"\ncenter = [0, 0, -1]\nradius = 0.1\nbar_radius = 0.2': "bar_radius: 0.2 - must be less",
    'kind = "box"\ncenter = [0, 0, -1]\nhalf_sizes = [1, -1, 1]\nedge_radius = 0.1': "half_sizes: [1.0, -1.0",
    'kind = "box"\ncenter = [0, 0, -1]\nhalf_sizes = [1, 1, 1]\nedge_radius = 2': "edge_radius: 2.0 - must",
    'kind = "plain"': 'did you mean "plane"?',
    'kind = "sdf"': "obstacle[0].file: missing - give file, values with spacing, or vertices and faces",
    "friction = 0.2": "obstacle[0].kind: missing - must be one of",
}
#: A line of the [contact] table, and what is said of it.
CONTACT = {
    "friction = -1": "contact.friction: -1 - must be at least 0",
    "friction = nan": "contact.friction: nan - must be a finite number",
    "friction = inf": "contact.friction: inf - must be a finite number",
    "fricton = 0.2": 'contact.fricton: unknown key; did you mean "friction"?',
    "compliance = 0": "contact.compliance: 0 - must be greater than 0",
    "compliance = inf": "contact.compliance: inf - must be a finite number (m/N)",
}


def message(text: str) -> str:
    """What a scene is refused with."""
    with pytest.raises(SceneError) as told:
        loads(text)
    return str(told.value)


@pytest.mark.parametrize("line", FAULTS)
def test_a_faulty_value_of_an_obstacle(line: str) -> None:
    assert FAULTS[line] in message(f"{SCENE}[[obstacle]]\n{BALL}{line}\n")


@pytest.mark.parametrize("body", WHOLE)
def test_a_faulty_obstacle(body: str) -> None:
    assert WHOLE[body] in message(f"{SCENE}[[obstacle]]\n{body}\n")


@pytest.mark.parametrize("line", CONTACT)
def test_a_faulty_contact(line: str) -> None:
    assert CONTACT[line] in message(f"[contact]\n{line}\n{SCENE}")


def test_the_same_name_twice() -> None:
    two = f'[[obstacle]]\nname = "a"\n{BALL}' * 2
    assert 'obstacle[1].name: "a" - is the name of obstacle[0] already' in message(SCENE + two)


def test_ropes_that_touch_need_a_diameter() -> None:
    told = message("[contact]\n" + SCENE.replace("diameter = 0.01\n", ""))
    assert "rope[0].diameter: missing - is needed where ropes touch each other" in told


@pytest.mark.parametrize("command", ["check", "run"])
@pytest.mark.parametrize(
    ("more", "said"),
    [
        (
            '[[obstacle]]\nkind = "sphere"\ncenter = [0, 0, 0.05]\nradius = 0.1\n',
            "rope[0].shape: \"node 2\" - starts 105 mm inside obstacle 'obstacle0', half its diameter",
        ),
        (
            '[[obstacle]]\nkind = "plane"\npoint = [0, 0, 0.3]\n',
            "starts 255 mm inside obstacle 'obstacle0'",
        ),
    ],
)
def test_a_rope_that_starts_inside(
    ropewalk: Any, scene: Path, command: str, more: str, said: str
) -> None:
    scene.write_text(SCENE + more)
    refused(ropewalk(command, scene), f"{scene}: ", said, "move the rope or the obstacle")
    assert tree(scene.parent) == ["scene.toml"]


@pytest.mark.parametrize("command", ["check", "run"])
def test_a_rope_that_starts_through_itself(ropewalk: Any, scene: Path, command: str) -> None:
    points = "[[-0.1, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0], [0, -0.1, 0]]"
    crossing = SCENE.replace(
        'kind = "straight", start = [-0.2, 0, 0.05], end = [0.2, 0, 0.05]',
        f'kind = "points", points = {points}',
    )
    scene.write_text(f"[contact]\n{crossing}")
    said = "starts 10 mm inside segment 0 of rope 'rope', half of both diameters counted in"
    refused(ropewalk(command, scene), f"{scene}: rope[0].shape: ", said, "draw the ropes apart")
    assert tree(scene.parent) == ["scene.toml"]


@pytest.mark.parametrize("radius", ["", "edge_radius = 0\n"])
def test_faulty_sizes_of_a_box_are_told_beside_its_radius(radius: str) -> None:
    """They were hidden by a radius that is missing, or 0."""
    box = f'[[obstacle]]\nkind = "box"\ncenter = [0, 0, -1]\nhalf_sizes = [1, 0, 1]\n{radius}'
    with pytest.raises(SceneError) as refusal:
        loads(SCENE + box)
    told = {fault.path: fault.rule for fault in refusal.value.faults}
    assert told["obstacle[0].half_sizes"] == "must all three be greater than 0"
    assert set(told) == {"obstacle[0].half_sizes", "obstacle[0].edge_radius"}


def test_files_of_solids_have_remedies_and_safe_ones(tmp_path: Path) -> None:
    """numpy's words say how to load "unsafely" what is pickled; others named no file, or no remedy."""
    grid = np.empty((4, 4, 4), dtype=object)
    np.savez(tmp_path / "objects.npz", values=grid, spacing=0.1)
    (tmp_path / "pickled.npz").write_bytes(pickle.dumps({"values": [1.0]}))
    (tmp_path / "folder.stl").mkdir()
    vertices = "vertices = [[0, 0, 0]]\n"
    cases = {
        'kind = "sdf"\nfile = "objects.npz"\n': "numpy.savez(file, values=..., spacing=...)",
        'kind = "sdf"\nfile = "pickled.npz"\n': "numpy.savez(file, values=..., spacing=...)",
        'kind = "mesh"\nfile = "folder.stl"\n': '"folder.stl" - is a folder: name a file in it',
        f'kind = "mesh"\nfile = "a.stl"\n{vertices}': 'file: "a.stl" - give either file or vertices',
        f'kind = "sdf"\nfile = "a.npz"\n{vertices}': 'file: "a.npz" - give one of file, values',
    }
    for table, said in cases.items():
        (tmp_path / "scene.toml").write_text(f"{SCENE}[[obstacle]]\n{table}")
        with pytest.raises(SceneError) as refusal:
            load(tmp_path / "scene.toml")
        assert said in str(refusal.value)
        assert "allow_pickle" not in str(refusal.value)
        assert "unsafe" not in str(refusal.value)
