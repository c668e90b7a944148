"""The notebooks of examples/ run from top to bottom, and their last cells check what they found."""

from __future__ import annotations

import os
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))


def run(book: nbformat.NotebookNode, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run a notebook in a fresh kernel of this Python, with this tree's package."""
    path = os.pathsep.join([str(ROOT / "src"), os.environ.get("PYTHONPATH", "")])
    monkeypatch.setenv("PYTHONPATH", path)
    NotebookClient(
        book, timeout=None, kernel_name="python3", resources={"metadata": {"path": str(folder)}}
    ).execute()


def test_there_are_notebooks() -> None:
    names = {"students-report", "zip-line", "climbing-fall", "robots-hand", "sound-of-a-string"}
    assert {path.stem for path in NOTEBOOKS} >= names
    page = (ROOT / "examples/README.md").read_text(encoding="utf-8")
    for name in names:
        assert f"[`{name}`](notebooks/{name}.ipynb)" in page


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    book = nbformat.read(path, as_version=4)
    nbformat.validate(book)
    code = [cell for cell in book.cells if cell.cell_type == "code"]
    assert code[-1].source.count("assert ") >= 3
    assert all(not cell.outputs and cell.execution_count is None for cell in code)
    run(book, tmp_path, monkeypatch)
    kinds = [kind for cell in code for out in cell.outputs for kind in out.get("data", {})]
    assert {"text/html", "image/png"} & set(kinds)


def test_a_wrong_result_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("assert 1 + 1 == 3")])
    with pytest.raises(CellExecutionError, match="AssertionError"):
        run(book, tmp_path, monkeypatch)
