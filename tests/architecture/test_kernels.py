"""Rules for compiled code: what costs time or changes bits without being seen in a result."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from architecture.sources import SOURCES, kernels, name_of

ALLOCATES = {
    "arange", "array", "asarray", "ascontiguousarray", "concatenate", "copy", "empty", "empty_like",
    "eye", "full", "full_like", "hstack", "linspace", "ones", "ones_like", "outer", "stack",
    "tile", "vstack", "zeros", "zeros_like",
}  # fmt: skip
SMALL_BLAS = {"dot", "vdot", "matmul", "inner", "cross", "norm", "einsum"}
KERNEL_FILES = [path for path in SOURCES if kernels(ast.parse(path.read_text(encoding="utf-8")))]


def called(node: ast.Call) -> str:
    """Return the last name of what is called: `zeros` for `np.zeros(3)`."""
    return getattr(node.func, "attr", getattr(node.func, "id", ""))


def has_slice(node: ast.Subscript) -> bool:
    """Tell whether the subscript takes a part of an array rather than one number."""
    parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
    return any(isinstance(part, ast.Slice) for part in parts)


def in_loops(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """Yield what is inside the function's loops."""
    for loop in ast.walk(function):
        if isinstance(loop, ast.For | ast.While):
            for statement in loop.body + loop.orelse:
                yield from ast.walk(statement)


def faults(source: str) -> set[str]:
    """Name every breach of the rules in the kernels of a module, with function and line."""
    found = set()
    for function in kernels(ast.parse(source)):
        if ast.get_docstring(function) is None and not function.name.startswith("_"):
            found.add(f"{function.name}: no docstring")
        for node in ast.walk(function):
            where = f"{function.name}, line {getattr(node, 'lineno', 0)}"
            if isinstance(node, ast.Raise | ast.Assert | ast.Try):
                found.add(f"{where}: a kernel returns a status, it never raises")
            if isinstance(node, ast.Call) and called(node) in SMALL_BLAS:
                found.add(f"{where}: {called(node)} in a kernel")
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
                found.add(f"{where}: @ in a kernel")
        for node in in_loops(function):
            where = f"{function.name}, line {getattr(node, 'lineno', 0)}"
            if isinstance(node, ast.Subscript):
                if has_slice(node):
                    found.add(f"{where}: slice in a loop")
                if isinstance(node.value, ast.Subscript):
                    found.add(f"{where}: row view in a loop, write a[i, j]")
            if isinstance(node, ast.Call) and called(node) in ALLOCATES:
                found.add(f"{where}: {called(node)} allocates in a loop")
    return found


@pytest.mark.parametrize("path", KERNEL_FILES, ids=name_of)
def test_kernels_keep_the_rules(path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    assert faults(source) == set()
    assert ast.get_docstring(ast.parse(source)), "a file of kernels says what it computes"


def test_the_kernels_are_found() -> None:
    names = {name_of(path) for path in KERNEL_FILES}
    assert {"laws/stretch.py", "methods/semi_implicit_euler.py", "motions/orbit.py"} <= names


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("for i in range(3): a[:, i] = 0.0", "slice"),
        ("for i in range(3): a[0][i] = 0.0", "row view"),
        ("for i in range(3): b = np.zeros(3)", "allocates"),
        ("while a[0] > 0: b = a.copy()", "allocates"),
        ("b = np.dot(a, a)", "dot"),
        ("b = a @ a", "@"),
        ("raise ValueError", "status"),
    ],
)
def test_each_breach_is_seen(line: str, complaint: str) -> None:
    source = f"@kernel\ndef f(a):\n    '''f'''\n    {line}"
    assert any(complaint in fault for fault in faults(source))
    assert faults(f"def f(a):\n    {line}") == set()


#: What goes into kernels, and is kept on disk with them alone.
INTO_KERNELS = {"part", "apart"}


def into_kernels() -> set[tuple[str, str]]:
    """Return module and name of all that has no machine code of its own on disk."""
    return {
        ("ropewalk." + name_of(path).removesuffix(".py").replace("/", "."), function.name)
        for path in KERNEL_FILES
        for function in kernels(ast.parse(path.read_text(encoding="utf-8")))
        if INTO_KERNELS & {getattr(one, "id", "") for one in function.decorator_list}
    }


def compiled_again(source: str, there: set[tuple[str, str]]) -> set[str]:
    """Return what of `there` a module calls that is no kernel's."""
    tree = ast.parse(source)
    known = {
        one.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for one in node.names
        if (node.module, one.name) in there
    }
    return known & {called(node) for node in ast.walk(tree) if isinstance(node, ast.Call)}


def test_python_calls_only_kernels_that_are_kept_on_disk() -> None:
    """A part that Python called took half a minute to compile in every process."""
    there = into_kernels()
    found = {
        f"{name_of(path)}: {name}"
        for path in SOURCES
        if path not in KERNEL_FILES
        for name in compiled_again(path.read_text(encoding="utf-8"), there)
    }
    assert found == set()


def test_a_part_that_python_calls_is_seen() -> None:
    line = "from ropewalk.methods.errors import set_zero"
    assert compiled_again(f"{line}\nset_zero(1)", into_kernels()) == {"set_zero"}
    assert compiled_again(line, into_kernels()) == set()


def test_no_source_asks_for_fast_math() -> None:
    flags = [
        f"{name_of(path)}:{node.value.lineno}"
        for path in SOURCES
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.keyword) and node.arg in {"fastmath", "parallel"}
    ]
    assert flags == []
