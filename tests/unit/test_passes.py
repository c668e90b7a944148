"""Passes of numba in our own words: the same names and phis as numba's own."""

from __future__ import annotations

from io import StringIO
from typing import Any

import pytest

from ropewalk.core.jit import PLAIN

pytestmark = pytest.mark.skipif(PLAIN, reason="kernels are not compiled")


def behind(n):
    """Leave the loop with a copy taken before the last change."""
    now = 0
    while True:
        before = now
        now = now + 1
        if now > n:
            break
    return before


def on_one_way(n):
    """Use a variable that one way through the loop leaves without a value."""
    total = 0
    for i in range(n):
        if i > 0:
            last = i
        if i > 1:
            total = total + last
    return total


def nested(n):
    """Change variables in loops, on branches and after them."""
    a, b, found = 0, 1, 0
    for i in range(n):
        for j in range(i):
            if j % 2 == 0:
                a, b = b, a + b
            else:
                found = found + a
        if found > 100:
            found = found - b
            continue
        b = i
    if a > b:
        a = b
    return a + b + found


def with_constants(pair, more):
    """Use constants that numba looks for."""
    pair[1] = pair[0] ** 2
    return (pair, *more)


def told(blocks: dict[int, Any]) -> str:
    """Return all statements as text."""
    file = StringIO()
    for label, block in sorted(blocks.items()):
        print(label, file=file)
        block.dump(file)
    return file.getvalue()


@pytest.mark.parametrize("function", [behind, on_one_way, nested])
def test_every_variable_gets_one_value_as_numba_gives_it(function) -> None:
    from numba.core import compiler, ssa

    from ropewalk.core.passes import rewrite_once

    theirs, ours = compiler.run_frontend(function), compiler.run_frontend(function)
    before = told(ours.blocks)
    rewrite_once(ours.blocks)
    assert told(ours.blocks) == told(ssa.reconstruct_ssa(theirs).blocks)
    assert told(ours.blocks) != before


@pytest.mark.parametrize("function", [behind, on_one_way, nested])
def test_phis_become_assignments_as_numba_strips_them(function) -> None:
    from numba.core import compiler
    from numba.core.typed_passes import PreLowerStripPhis

    from ropewalk.core.passes import rewrite_once, strip_phis

    theirs, ours = compiler.run_frontend(function), compiler.run_frontend(function)
    rewrite_once(theirs.blocks)
    rewrite_once(ours.blocks)
    before = told(ours.blocks)
    assert "phi(" in before
    assert told(strip_phis(ours.blocks)) == told(
        PreLowerStripPhis()._strip_phi_nodes(theirs).blocks
    )
    assert told(ours.blocks) == before


@pytest.mark.parametrize("function", [behind, on_one_way, nested, with_constants])
def test_functions_are_read_as_numba_reads_them(function) -> None:
    from types import SimpleNamespace

    from numba.core import bytecode
    from numba.core.interpreter import Interpreter
    from numba.core.transforms import canonicalize_cfg
    from numba.core.untyped_passes import GenericRewrites

    from ropewalk.core.frontend import ReadByteCode, Rewrite

    def state() -> Any:
        own = bytecode.FunctionIdentity.from_function(function)
        more = {"typemap": None, "calltypes": None, "status": SimpleNamespace(can_fallback=False)}
        return SimpleNamespace(func_id=own, bc=bytecode.ByteCode(own), **more)

    theirs, ours = state(), state()
    theirs.func_ir = Interpreter(theirs.func_id).interpret(theirs.bc)
    ReadByteCode().run_pass(ours)
    before = told(ours.func_ir.blocks)
    assert before == told(theirs.func_ir.blocks)
    GenericRewrites().run_pass(theirs)
    Rewrite().run_pass(ours)
    after = told(canonicalize_cfg(ours.func_ir.blocks))  # as `Passes` does after it
    assert after == told(theirs.func_ir.blocks)
    assert after != before or function is not with_constants


@pytest.mark.parametrize("function", [behind, on_one_way, nested])
def test_variables_are_found_as_numba_finds_them(function) -> None:
    from numba.core import compiler
    from numba.core.analysis import compute_use_defs

    from ropewalk.core.frontend import variables_of
    from ropewalk.core.values import _used

    blocks = compiler.run_frontend(function).blocks
    statements = [one for block in blocks.values() for one in block.body]
    assert any(one.list_vars() for one in statements)
    for one in statements:
        assert variables_of(one) == one.list_vars()
    assert {label: _used(block) for label, block in blocks.items()} == compute_use_defs(
        blocks
    ).usemap


def test_nobody_is_told_of_calls_of_llvm() -> None:
    import llvmlite.binding as llvm
    from numba.core import event

    import ropewalk.core.compiler

    with event.install_recorder("numba:llvm_lock") as heard:
        llvm.parse_assembly("")
    assert ropewalk.core.compiler.tell_nobody
    assert not heard.buffer


def test_an_error_in_a_pass_names_it() -> None:
    import numba

    from ropewalk.core.jit import kernel

    @kernel
    def adds_a_word(x):
        return x + "m"

    with pytest.raises(numba.core.errors.TypingError, match=r"Failed in nopython .*step: "):
        adds_a_word(1.0)


def test_a_kernel_that_deletes_a_variable_is_refused() -> None:
    import numba

    from ropewalk.core.jit import kernel, part

    @part
    def forgets(x):
        y = x + 1.0
        del y
        return x

    @kernel
    def asks(x):
        return forgets(x)

    for one in (kernel(forgets.py_func), asks):
        with pytest.raises(numba.core.errors.CompilerError, match="del found"):
            one(1.0)


def test_a_loop_that_is_called_in_many_places_is_kept_whole() -> None:
    """One that is called in few is not, nor what has no loop, nor what asks for copies."""
    import llvmlite.binding as llvm

    from ropewalk.core.libraries import _COPIES, _PLACES, _keep_whole

    long = "\n".join(f"  %x{i} = add i64 %n, {i}" for i in range(_COPIES // _PLACES + 1))
    loop = f"define void @NAME(i64 %n) MORE {{\nentry:\n  br label %again\nagain:\n{long}\n"
    loop += (
        "  %on = icmp eq i64 %n, 0\n  br i1 %on, label %again, label %out\nout:\n  ret void\n}\n"
    )
    straight = f"define void @straight(i64 %n) {{\nentry:\n{long}\n  ret void\n}}\n"
    calls = "".join(
        f"  call void @{name}(i64 {k})\n"
        for name, places in (
            ("often", _PLACES),
            ("copied", _PLACES),
            ("straight", _PLACES),
            ("few", 2),
        )
        for k in range(places)
    )
    code = loop.replace("NAME", "often").replace("MORE", "")
    code += loop.replace("NAME", "few").replace("MORE", "")
    code += loop.replace("NAME", "copied").replace("MORE", "alwaysinline")
    code += straight + f"define void @all() {{\n{calls}  ret void\n}}\n"
    module = llvm.parse_assembly(code)
    _keep_whole(module)
    found = {one.name for one in module.functions if any(b"noinline" in k for k in one.attributes)}
    assert found == {"often"}


def test_kernels_with_equal_options_share_them() -> None:
    """What numba looks things up by is one object; it stays as it was, and other options have another."""
    from numba.core.compiler import Flags

    from ropewalk.core.passes import Options

    def made(error_model: str) -> Any:
        given = Flags()
        given.error_model = error_model
        return Options(given)

    one, same, other = made("numpy"), made("numpy"), made("python")
    kept = one.copy()
    assert kept is same.copy()
    assert kept is not other.copy()
    assert kept.values() == one.values() != other.values()
    assert kept.get_mangle_string() == same.copy().get_mangle_string()
    one.error_model = "python"
    assert one.copy() is other.copy()
    assert kept is same.copy()
    assert kept.error_model == same.error_model
