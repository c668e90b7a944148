"""A whole run, copies of it, and one that a full disk stopped."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import ropewalk as rw
import runs
from integration.faulty_runs import fill_disk
from ropewalk.record.errors import RunError
from ropewalk.record.run import record_run


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("whole") / "run"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("ropewalk.record.run.chunk_frames", lambda simulation: 16)
        rw.run(runs.hanging(), path)
    return path


@pytest.fixture
def folder(whole: Path, tmp_path: Path) -> Path:
    shutil.copytree(whole, tmp_path / "run")
    return tmp_path / "run"


@pytest.fixture
def stopped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A run that a full disk stopped in its fourth chunk."""
    fill_disk(monkeypatch, 4 * 11 + 5)
    with pytest.raises(RunError, match="no space left on the disk; everything up to"):
        record_run(runs.hanging(), tmp_path / "run", commit_seconds=0.0)
    monkeypatch.undo()
    return tmp_path / "run"
