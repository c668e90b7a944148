"""`ropewalk lab`: a page that runs ropes by itself."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from ropewalk.lessons import lesson_scenes
from ropewalk.live.lab import lab_scene
from ropewalk.scene.presets import preset


def test_the_lab_is_one_file_with_its_scenes(ropewalk: Any, tmp_path: Path) -> None:
    assert ropewalk("lab").stdout == "lab.html\n"
    assert ropewalk("lab", "r1", "r4", "--set", "run.time_step=0.001").stdout == "lab-2.html\n"
    page = (tmp_path / "lab-2.html").read_text(encoding="utf-8")
    assert not re.search(r'(src|href)="(?!data:)', page)  # nothing from elsewhere
    (data,) = re.findall(r'<script type="application/json" id="scenes">(.*?)</script>', page)
    scenes = json.loads(data)
    assert [len(scene["mass"]) for scene in scenes] == [2, 41]
    assert all(scene["step"] <= 0.001 for scene in scenes)


def test_the_lessons_come_before_the_scenes_named(ropewalk: Any, tmp_path: Path) -> None:
    assert ropewalk("lab", "--lessons", "r1", "-o", "lessons.html").exit_code == 0
    page = (tmp_path / "lessons.html").read_text(encoding="utf-8")
    (data,) = re.findall(r'<script type="application/json" id="scenes">(.*?)</script>', page)
    names = [scene["name"] for scene in json.loads(data)]
    assert names == [scene.name for scene in (*lesson_scenes(), preset("r1"))]


def test_no_name_becomes_code(ropewalk: Any, tmp_path: Path) -> None:
    name = "</script><script>alert(1)</script>"
    done = ropewalk("lab", "r1", "--set", f"name={json.dumps(name)}", "-o", "a.html")
    assert done.exit_code == 0
    assert "alert(1)</script>" not in (tmp_path / "a.html").read_text(encoding="utf-8")


def test_another_method_is_not_taken_without_a_word() -> None:
    """The scene was run by semi-implicit Euler at the step of the other: it broke at once."""
    scene = preset("r1").replace(**{"run.method": "bdf2", "run.time_step": 0.5})
    made = lab_scene(scene)
    assert made["method"] == "semi-implicit-euler"
    assert made["step"] < 0.1 * 0.5
    assert made["about"].endswith(
        "The lab has no bdf2: semi-implicit-euler in stable steps stands in for it."
    )
    own = lab_scene(preset("r1").replace(**{"run.method": "verlet"}))
    assert own["method"] == "verlet"
    assert "stands in" not in own["about"]


def test_bad_labs(ropewalk: Any) -> None:
    for options, text in (
        (("n40",), "the lab has no air"),
        (("r1", "-o", "lab.pdf"), "must end in .html"),
        (("r99",), "no preset of that name"),
        (("--lessons", "--set", "run.time_step=0.001"), "changes the scenes that are named"),
    ):
        done = ropewalk("lab", *options)
        assert done.exit_code == 2
        assert text in done.stderr
