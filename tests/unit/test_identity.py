"""What counts as the same engine: what is computed, not how it is written about."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from ropewalk.core.cache import PACKAGE
from ropewalk.record import identity

SOURCE = b'''"""A module."""
G = 9.81  # [m/s2]


def fall(t):
    """Return the way of a fall [m]."""
    return 0.5 * G * t * t
'''


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"# [m/s2]", b"# standard gravity"),
        (b'"""A module."""', b'"""Falling."""\n\n\n# more'),
        (b'    """Return the way of a fall [m]."""\n', b""),
        (b"0.5 * G * t * t", b"(\n        0.5 * G * t * t\n    )"),
    ],
)
def test_what_is_no_physics_does_not_count(old: bytes, new: bytes) -> None:
    changed = SOURCE.replace(old, new)
    assert changed != SOURCE
    assert identity.meaning(changed) == identity.meaning(SOURCE)


@pytest.mark.parametrize(
    ("old", "new"),
    [(b"9.81", b"9.82"), (b"0.5 * G", b"0.5 + G"), (b"(t)", b"(t=0)"), (b"def fall", b"def drop")],
)
def test_what_is_physics_counts(old: bytes, new: bytes) -> None:
    assert identity.meaning(SOURCE.replace(old, new)) != identity.meaning(SOURCE)


class WithoutTypes(ast.NodeTransformer):
    """Leaves out what is imported for type checkers only."""

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt]:
        if isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            return node.orelse
        return self.generic_visit(node)


def imported(path: Path) -> set[Path]:
    """Return the files of the package that a file imports, here or in its functions."""
    names: set[str] = set()
    for node in ast.walk(WithoutTypes().visit(ast.parse(path.read_bytes()))):
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        elif isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
    found = set()
    for name in names:
        if name.startswith("ropewalk."):
            stem = PACKAGE.joinpath(*name.split(".")[1:])
            found |= {p for p in (stem.with_suffix(".py"), stem / "__init__.py") if p.exists()}
    return found


def test_all_that_a_simulation_uses_counts() -> None:
    seen: set[Path] = set()
    names = ("simulation/__init__.py", "engine/start.py", "lowering/__init__.py")
    todo = {PACKAGE / name for name in names}
    while todo:
        seen |= todo
        todo = {found for path in todo for found in imported(path)} - seen
    assert len(seen) > 60
    computed = {
        path for path in seen if path.parent != PACKAGE / "display"
    }  # the rest is how it looks
    assert len(computed) > len(seen) - 3
    assert computed - set(identity.sources()) == set()


def test_every_folder_of_the_guard_is_there() -> None:
    """One that was renamed would fall out of the guard without a word."""
    for folder in identity.FOLDERS:
        assert list((PACKAGE / folder).glob("*.py")), folder


@pytest.mark.parametrize("name", ["checkpoint", "resume", "run", "simulate"])
def test_what_puts_a_state_back_and_leaves_ropes_behind_counts(name: str) -> None:
    """A change of what a checkpoint restored was gone on with, as if it were to the same bits."""
    assert PACKAGE / "record" / f"{name}.py" in identity.sources()
    assert all(path.is_file() for path in identity.sources())


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(identity, "cache_root", lambda: tmp_path)
    return tmp_path


def test_a_hash_that_is_remembered_is_the_one_that_is_computed(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = identity.sources()[::20]
    monkeypatch.setattr(identity, "sources", lambda: files)
    compute = identity.source_hash.__wrapped__
    first = compute()
    monkeypatch.setattr(identity, "meaning", lambda data: pytest.fail("was remembered"))
    assert compute() == first
    monkeypatch.undo()


@pytest.mark.parametrize("damage", ["empty", "garbage", "changed"])
def test_a_damaged_memory_is_not_trusted(
    root: Path, monkeypatch: pytest.MonkeyPatch, damage: str
) -> None:
    files = identity.sources()[::20]
    monkeypatch.setattr(identity, "sources", lambda: files)
    compute = identity.source_hash.__wrapped__
    first, path = compute(), root / identity.REMEMBERED
    text = path.read_text()
    value = identity.meaning(files[0].read_bytes())
    assert value in text
    path.write_text(
        {"empty": "", "garbage": "{[", "changed": text.replace(value, "0" * 16)}[damage]
    )
    assert compute() == first
    assert path.read_text() == text
