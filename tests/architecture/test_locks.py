"""The locks: for each Python, every package that is asked for, in a version that fits, with hashes."""

from __future__ import annotations

import re
import sys
import tomllib
from importlib.metadata import distributions
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

HERE = Path(__file__).resolve().parents[2]
ABOUT = tomllib.loads((HERE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
MATRIX = yaml.safe_load((HERE / ".github/workflows/test.yml").read_text(encoding="utf-8"))
PYTHONS = MATRIX["jobs"]["test"]["strategy"]["matrix"]["python"]
EXTRAS = ABOUT["optional-dependencies"]
BUILD = ["editables", "hatchling"]


def pinned(text: str) -> dict[str, tuple[str, int]]:
    """Return version and number of hashes of every package of a lock, by name."""
    found = {}
    for entry in text.replace("\\\n", " ").splitlines():
        if entry.strip() and not entry.startswith("#"):
            what, *hashes = entry.split("--hash=sha256:")
            requirement = Requirement(what.strip())
            (pin,) = requirement.specifier
            assert pin.operator == "==", entry
            assert all(re.fullmatch("[0-9a-f]{64}", one.strip()) for one in hashes), entry
            found[canonicalize_name(requirement.name)] = pin.version, len(hashes)
    return found


def missing(lock: dict[str, tuple[str, int]], asked: list[str]) -> list[str]:
    """Return what is asked for and not in a lock, or there in another version or without a hash."""
    wants = [Requirement(text) for text in asked]
    return [
        str(want)
        for want in wants
        if want.name != ABOUT["name"]
        and not (
            (pin := lock.get(canonicalize_name(want.name)))
            and pin[1]
            and want.specifier.contains(pin[0], prereleases=True)
        )
    ]


@pytest.mark.parametrize("python", PYTHONS)
def test_the_locks_hold_what_is_asked_for(python: str) -> None:
    demo, dev = (
        pinned((HERE / "requirements" / python / f"{name}.txt").read_text(encoding="utf-8"))
        for name in ("demo", "dev")
    )
    assert missing(demo, [*ABOUT["dependencies"], *EXTRAS["view"], *BUILD]) == []
    everything = [text for extra in EXTRAS.values() for text in extra]
    assert missing(dev, [*ABOUT["dependencies"], *everything]) == []
    assert all(hashes for _, hashes in (demo | dev).values())
    assert demo.items() <= dev.items()  # so that the second installation changes nothing


def without_extras(text: str) -> set[str]:
    """Return what installed packages ask for with an extra that a lock names without it."""
    entries = text.replace("\\\n", " ").splitlines()
    lines = [entry.split("--hash")[0] for entry in entries if entry and entry[0] != "#"]
    locked = {canonicalize_name(one.name): one.extras for one in map(Requirement, lines)}
    wants = [
        Requirement(line)
        for package in distributions()
        if canonicalize_name(package.metadata["Name"]) in locked
        for line in package.requires or []
    ]
    return {
        want.name
        for want in wants
        if want.extras
        and (not want.marker or want.marker.evaluate({"extra": ""}))
        and not want.extras <= locked.get(canonicalize_name(want.name), want.extras)
    }


def test_the_lock_names_extras() -> None:
    """A pin without its extra binds older pips not: each new release then ended the installation."""
    python = ".".join(map(str, sys.version_info[:2]))
    text = (HERE / "requirements" / python / "dev.txt").read_text(encoding="utf-8")
    assert without_extras(text) == set()
    assert without_extras(text.replace("coverage[toml]", "coverage")) == {"coverage"}


def test_there_is_a_lock_for_each_python_and_none_names_a_host() -> None:
    folders = [path.name for path in (HERE / "requirements").iterdir() if path.is_dir()]
    assert sorted(folders) == PYTHONS
    for path in (HERE / "requirements").rglob("*.txt"):
        assert not re.search(r"://|-index|--find-links", path.read_text(encoding="utf-8"))


def test_what_a_lock_lacks_is_found() -> None:
    lock = pinned("some_Name==1.5 \\\n    --hash=sha256:" + "0" * 64 + "\nbare==2.0\n")
    assert missing(lock, ["some-name>=1.5"]) == []
    assert missing(lock, ["some-name>=2", "bare", "other"]) == ["some-name>=2", "bare", "other"]
