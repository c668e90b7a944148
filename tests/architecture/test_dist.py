"""Wheel and source archive: all that the package needs is in them, and a wheel runs by itself."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest
import yaml

HERE = Path(__file__).resolve().parents[2]
ABOUT = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def built(folder: Path, source: Path, kind: str) -> Path:
    """Build the wheel or the archive of a working copy."""
    command = [sys.executable, "-m", "hatchling", "build", "-t", kind, "-d", str(folder)]
    subprocess.run(command, cwd=source, check=True, capture_output=True)
    (found,) = folder.glob("*.whl" if kind == "wheel" else "*.tar.gz")
    return found


def of_package(names: list[str], before: str) -> set[str]:
    """Return the files of the package below a folder, without what Python leaves there."""
    inside = {name.removeprefix(before) for name in names if name.startswith(before)}
    return {name for name in inside if "__pycache__" not in name and not name.endswith("/")}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("wheel"), HERE, "wheel")


def test_a_wheel_holds_the_package_and_nothing_else(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    sources = [
        str(p.relative_to(HERE).as_posix()) for p in (HERE / "src").rglob("*") if p.is_file()
    ]
    assert of_package(names, "ropewalk/") == of_package(sources, "src/ropewalk/")
    rest = {name for name in names if not name.startswith("ropewalk/")}
    assert all(".dist-info/" in name for name in rest)
    assert any(name.endswith("licenses/LICENSE") for name in rest)


def test_an_archive_makes_the_same_wheel(wheel: Path, tmp_path: Path) -> None:
    archive = built(tmp_path, HERE, "sdist")
    with tarfile.open(archive) as tar:
        tar.extractall(tmp_path / "unpacked", filter="data")
    (source,) = (tmp_path / "unpacked").iterdir()
    for name in ("README.md", "LICENSE", "Makefile", "tests", "docs", "requirements"):
        assert (source / name).exists(), name
    again = built(tmp_path / "wheel", source, "wheel")
    first, second = (
        {one.filename: one.CRC for one in zipfile.ZipFile(path).infolist()}
        for path in (wheel, again)
    )
    assert first == second


def test_a_wheel_runs_by_itself(wheel: Path, tmp_path: Path) -> None:
    """From a folder that has no sources; presets, library, page and style are files of the package."""
    zipfile.ZipFile(wheel).extractall(tmp_path / "site")
    code = (
        "import ropewalk, sys; from pathlib import Path\n"
        f"assert Path(ropewalk.__file__).is_relative_to({str(tmp_path)!r}), ropewalk.__file__\n"
        "print(ropewalk.rope('wire-7x19-12').diameter)\n"
        "print(ropewalk.preset('r4'))\n"
        "from ropewalk.sheets.html import html_page\n"
        "print(html_page('a', 'b', ())[:15])\n"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(tmp_path / "site")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[0] == "0.012"
    assert "<!doctype html>" in done.stdout


def test_workflows_try_every_python_that_is_named() -> None:
    matrix = yaml.safe_load((HERE / ".github/workflows/test.yml").read_text(encoding="utf-8"))
    tried = matrix["jobs"]["test"]["strategy"]["matrix"]
    named = [kind.rpartition(" ")[2] for kind in ABOUT["classifiers"] if ":: Python :: 3." in kind]
    assert set(named) <= set(tried["python"])
    assert {name.partition("-")[0] for name in tried["os"]} == {"ubuntu", "macos", "windows"}
    for path in (HERE / ".github/workflows").glob("*.yml"):
        flow = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert flow["permissions"] == {"contents": "read"}
        for job in flow["jobs"].values():
            assert all("uses" in step or "run" in step for step in job["steps"])
            assert job["timeout-minutes"] <= 90


def test_every_target_is_told_without_make() -> None:
    makefile = (HERE / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([a-z-]+):.*## ", makefile, re.M)) - {"help"}
    told = (HERE / "docs/how-to/install.md").read_text(encoding="utf-8")
    assert targets <= set(re.findall(r"`make ([a-z-]+)`", told))
    assert len(targets) > 10
