"""The package's source files, and which functions in them are kernels."""

from __future__ import annotations

import ast
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "src" / "ropewalk"
SOURCES = sorted(PACKAGE.rglob("*.py"))


def name_of(path: Path) -> str:
    """Return the path inside the package."""
    return path.relative_to(PACKAGE).as_posix()


def is_kernel(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Tell whether the function is compiled, with arguments of its decorator or without."""
    for decorator in function.decorator_list:
        target = decorator.func if isinstance(decorator, ast.Call) else decorator
        if isinstance(target, ast.Name) and target.id in (
            "kernel",
            "deferred",
            "seldom",
            "part",
            "small",
            "apart",
        ):
            return True
    return False


def kernels(tree: ast.Module) -> list[ast.FunctionDef]:
    """Return all kernels of a module."""
    return [n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef) and is_kernel(n)]
