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


def test_what_reduces_the_numbers_is_in_the_identity(monkeypatch: pytest.MonkeyPatch) -> None:
    made = identity.sweep_hash.__wrapped__
    assert made() == identity.sweep_hash()
    shorter = [name for name in identity.KEPT_BY if name != "sweeps/keep.py"]
    monkeypatch.setattr(identity, "KEPT_BY", shorter)
    assert made() != identity.sweep_hash()


def test_all_that_makes_a_result_is_in_the_identity_or_known_to_keep_nothing() -> None:
    found = set()
    for name in ("result", "simulate", "rest"):
        tree = ast.parse((PACKAGE / "record" / f"{name}.py").read_bytes())
        modules = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        found |= {m.removeprefix("ropewalk.record.") for m in modules if "ropewalk.record." in m}
    names = (*identity.KEPT_BY, *FILES)
    hashed = {Path(name).stem for name in names if name.startswith("record/")}
    assert len(found) > 10
    assert found - hashed == KEEP_NOTHING
    assert all((PACKAGE / name).is_file() for name in identity.KEPT_BY)
