"""Budgets of size: what is longer is two things."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from architecture.sources import SOURCES, is_kernel, name_of

FILE_LINES = 400
FUNCTION_LINES = 60
KERNEL_LINES = 80


def long_functions(source: str) -> Iterator[str]:
    """Name the functions over their budget."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            budget = KERNEL_LINES if is_kernel(node) else FUNCTION_LINES
            lines = (node.end_lineno or node.lineno) - node.lineno + 1
            if lines > budget:
                yield f"{node.name}: {lines} lines, at most {budget}"


@pytest.mark.parametrize("path", SOURCES, ids=name_of)
def test_files_and_functions_keep_their_budget(path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    assert len(source.splitlines()) <= FILE_LINES
    assert list(long_functions(source)) == []


def test_a_long_function_is_found() -> None:
    body = "    x = 1\n" * FUNCTION_LINES
    assert len(list(long_functions(f"def f():\n{body}"))) == 1
    assert list(long_functions(f"@kernel\ndef f():\n{body}")) == []
    assert len(list(long_functions(f"@kernel\ndef f():\n{body * 2}"))) == 1
