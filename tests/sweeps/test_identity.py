"""What decides the numbers of a sweep is in its identity, so that another source is not gone on with."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from ropewalk.core.cache import PACKAGE
from ropewalk.record.identity import FILES
from ropewalk.sweeps import identity

#: What `record` has beside that: words, tables, folders, and views that no sweep can keep.
KEEP_NOTHING = {
    "beyond",
    "errors",
    "folder",
    "outlets",
    "place",
    "point_forces",
    "rope_view",
    "summary",
}
#: What those that note import of `record` beside: files, and their seals and locks.
FILES_ALONE = {
    "errors",
    "files",
    "identity",
    "lock",
    "place",
    "seal",
}


def imported(name: str) -> set[str]:
    """Return the modules of `record` that one of them imports."""
    tree = ast.parse((PACKAGE / "record" / f"{name}.py").read_bytes())
    modules = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    return {m.removeprefix("ropewalk.record.") for m in modules if "ropewalk.record." in m}


def hashed() -> set[str]:
    """Return the modules of `record` that are in the identity."""
    names = (*identity.KEPT_BY, *FILES)
    return {Path(name).stem for name in names if name.startswith("record/")}


def test_what_reduces_the_numbers_is_in_the_identity(monkeypatch: pytest.MonkeyPatch) -> None:
    made = identity.sweep_hash.__wrapped__
    assert made() == identity.sweep_hash()
    shorter = [name for name in identity.KEPT_BY if name != "sweeps/keep.py"]
    monkeypatch.setattr(identity, "KEPT_BY", shorter)
    assert made() != identity.sweep_hash()


def test_all_that_makes_a_result_is_in_the_identity_or_known_to_keep_nothing() -> None:
    found = set()
    for name in ("result", "simulate", "rest"):
        found |= imported(name)
    assert len(found) > 10
    assert found - hashed() == KEEP_NOTHING
    assert all((PACKAGE / name).is_file() for name in identity.KEPT_BY)


def test_all_that_decides_notes_is_in_the_identity() -> None:
    """Landings and what is too low were not: notes of two sources were counted together."""
    found, ahead = {"result"}, {"note_kinds"}  # a result imports its views, which keep nothing
    while ahead:
        found |= ahead
        ahead = set[str]().union(*map(imported, ahead)) - found
    assert {"landings", "too_low", "body_loads", "deep_note"} <= found
    assert found - hashed() == FILES_ALONE
