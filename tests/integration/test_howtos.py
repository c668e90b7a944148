"""What CONTRIBUTING.md says of adding a thing: each is done as it is written, in a copy of the package.

It must touch the files and lines that are named there, and do what it says. Laws: `test_added_law`.
Kernels run as Python.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import ropewalk
from golden import states

ROOT, PACKAGE = Path(__file__).resolve().parents[2], Path(ropewalk.__file__).parent
BLOCK = re.compile(r"^```(py|diff)\n# (.+?)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SECTIONS = {
    title: body
    for title, body in re.findall(
        r"^## (.+?)\n(.*?)(?=^## |\Z)", (ROOT / "CONTRIBUTING.md").read_text(), re.M | re.S
    )
    if BLOCK.search(body)
}
#: The sample, with which kernels are gone through line by line; files that are only imported are none.
TRACED = """
import sys
seen = set()
sys.settrace(lambda frame, *_: seen.add((frame.f_code.co_filename, frame.f_code.co_name)))
SAMPLE
sys.settrace(None)
kernels = {name for file, name in seen if file.endswith("stretch.py")} - {"<module>"}
assert kernels, "no kernel was gone through"
"""


def apply(change: str, text: str) -> str:
    """Return a text with a change: lines with a minus become those with a plus, others are where it is."""
    lines = [(line[:1] or " ", line[1:]) for line in change.splitlines()]
    assert {mark for mark, _ in lines} <= set(" +-")
    old = "".join(f"{line}\n" for mark, line in lines if mark != "+")
    new = "".join(f"{line}\n" for mark, line in lines if mark != "-")
    assert text.count(old) == 1, f"is there {text.count(old)} times:\n{old}"
    return text.replace(old, new)


def make(section: str, folder: Path) -> tuple[list[str], dict[str, int]]:
    """Copy the package and change it as a section says; return new files, and lines added to others."""
    package = folder / "ropewalk"
    shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns("__pycache__", "page"))
    new: list[str] = []
    lines: dict[str, int] = {}
    for kind, name, body in BLOCK.findall(section):
        path = package / name
        if kind == "diff":
            path.write_text(apply(body, path.read_text(encoding="utf-8")), encoding="utf-8")
            lines[name] = lines.get(name, 0) + body.count("\n+") + body.startswith("+")
        elif name != "then":
            assert not path.exists()
            path.write_text(body, encoding="utf-8")
            new.append(name)
    return new, lines


def run(section: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run what must hold then."""
    (then,) = (
        body for kind, name, body in BLOCK.findall(section) if (kind, name) == ("py", "then")
    )
    more = {"PYTHONPATH": str(folder), "NUMBA_DISABLE_JIT": "1", "MPLBACKEND": "Agg"}
    return subprocess.run(
        [sys.executable, "-W", "ignore", "-c", then],
        env=os.environ | more,
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_every_kind_of_thing_has_its_section() -> None:
    assert list(SECTIONS) == [
        "Add a method", "Add an explicit method", "Add a shape", "Add an anchor motion", "Add an output",
    ]  # fmt: skip


@pytest.mark.parametrize("title", SECTIONS)
def test_a_howto_is_true(title: str, tmp_path: Path) -> None:
    section = SECTIONS[title]
    new, lines = make(section, tmp_path)
    said = re.search(
        r"touches (?:(\d+) new files?, and )?(\d+) (lines?|places) in (\d+) files?", section, re.I
    )
    assert said is not None
    files, count, what, others = said.groups()
    blocks = len([kind for kind, _, _ in BLOCK.findall(section) if kind == "diff"])
    assert len(new) == int(files or 0)
    assert len(lines) == int(others)
    assert int(count) == (sum(lines.values()) if what != "places" else blocks)
    done = run(section, tmp_path)
    assert done.returncode == 0, done.stderr


def test_without_its_entry_a_shape_is_not_known(tmp_path: Path) -> None:
    """The twin: the new file alone does nothing, and the sample says so."""
    section = SECTIONS["Add a shape"]
    alone = re.sub(r"^```diff\n.*?^```$", "", section, flags=re.M | re.S)
    make(alone, tmp_path)
    done = run(alone, tmp_path)
    assert done.returncode != 0
    assert "helix" in done.stderr


def test_a_debugger_gets_into_kernels(tmp_path: Path) -> None:
    """As "Debug a kernel" says, with its own scene; the twin: where kernels are compiled it does not."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("## Debug a kernel")[1]
    sample = text.split("```python\n")[1].split("```")[0]
    (tmp_path / "debug.py").write_text(TRACED.replace("SAMPLE", sample))
    done = [
        subprocess.run(
            [sys.executable, "debug.py"],
            env=os.environ | {"NUMBA_DISABLE_JIT": off},
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        for off in ("1", "0")
    ]
    assert done[0].returncode == 0, done[0].stderr
    assert "no kernel was gone through" in done[1].stderr


def test_golden_states_are_written_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As "Golden states" says: of one method, with the laws and places of those that are committed."""
    method = "semi-implicit-euler"
    kept = json.loads(states.path(method).read_text())
    monkeypatch.setattr(states, "FOLDER", tmp_path)
    monkeypatch.setattr(states, "METHODS", [method])
    states.main()
    (made,) = tmp_path.iterdir()
    found = json.loads(made.read_text())
    assert list(found) == list(kept)
    for law in states.laws():
        assert list(found[law]) == list(kept[law])
        if "x" in kept[law]:  # else it is refused with this method
            assert np.allclose(found[law]["x"], kept[law]["x"], rtol=1e-9, atol=1e-9)
