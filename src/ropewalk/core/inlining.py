"""Parts, put into the kernels that call them from the outside in, and branches decided by types.

numba's own inliner compiles a part anew for each call, and copies it once more for every part around it. Here
a part is read once in a process and copied once for each call. Between the levels go the branches that
types decide: `system.rare is None` is true or false by the type of the tuple. So what a kernel never does
in a variant is neither inlined nor compiled.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator
from types import FunctionType
from typing import Any, NamedTuple

from numba.core import bytecode, ir, ir_utils, types, untyped_passes
from numba.core.analysis import compute_cfg_from_blocks
from numba.core.compiler import StateDict, _CompileStatus
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.inline_closurecall import _get_callee_args, _replace_args_with, _replace_returns
from numba.core.ir_utils import build_definitions, simplify_CFG

from ropewalk.core.frontend import ReadByteCode, Rewrite
from ropewalk.core.passes import Passes

_READ: dict[FunctionType, Any] = {}  # parts, as numba reads them


class _Known(NamedTuple):
    """What is known of a variable without running: its value, or else its type."""

    constant: bool
    what: Any


class _Knowledge:
    """What the types of the arguments tell of the variables in blocks that can be reached."""

    def __init__(self, blocks: dict[int, Any], args: tuple[Any, ...]) -> None:
        self._definitions = build_definitions(blocks)
        self._args = args
        self._found: dict[str, _Known | None] = {}

    def truth(self, name: str) -> bool | None:
        """Return whether a variable is true, None where only a run can tell."""
        found = self._of(name)
        return bool(found.what) if found is not None and found.constant else None

    def _of(self, name: str) -> _Known | None:
        if name not in self._found:
            self._found[name] = None  # of what depends on itself nothing is known
            every = [self._value(value) for value in self._definitions.get(name, [])]
            if every and all(one is not None and one == every[0] for one in every):
                self._found[name] = every[0]
        return self._found[name]

    def _value(self, value: Any) -> _Known | None:
        """Return what is known of the right side of an assignment."""
        if isinstance(value, ir.Var):
            return self._of(value.name)
        if isinstance(value, ir.Arg):
            return _of_type(self._args[value.index])
        if isinstance(value, ir.Const | ir.Global | ir.FreeVar):
            plain = value.value is None or isinstance(value.value, bool)
            return _Known(True, value.value) if plain else None
        if not isinstance(value, ir.Expr):
            return None
        if value.op == "cast":
            return self._of(value.value.name)
        if value.op == "getattr":
            return _field(self._of(value.value.name), value.attr)
        if value.op == "call" and self._is_bool(value.func) and len(value.args) == 1:
            return self._of(value.args[0].name)
        if value.op == "unary" and value.fn is operator.not_:
            truth = self.truth(value.value.name)
            return None if truth is None else _Known(True, not truth)
        if value.op == "binop" and value.fn in (operator.is_, operator.is_not):
            same = _same(self._of(value.lhs.name), self._of(value.rhs.name))
            return None if same is None else _Known(True, same is (value.fn is operator.is_))
        return None

    def _is_bool(self, function: Any) -> bool:
        given = self._definitions.get(function.name, [])
        return len(given) == 1 and getattr(given[0], "value", None) is bool


def _of_type(kind: Any) -> _Known | None:
    """Return what is known of a value of a type."""
    if isinstance(kind, types.NoneType):
        return _Known(True, None)
    if isinstance(kind, types.Omitted):
        return _Known(True, kind.value) if kind.value is None else None
    return None if isinstance(kind, types.Optional) else _Known(False, kind)


def _field(owner: _Known | None, name: str) -> _Known | None:
    """Return what is known of a field of a named tuple."""
    if owner is None or owner.constant or not isinstance(owner.what, types.BaseNamedTuple):
        return None
    kind: Any = owner.what
    return _of_type(kind.types[kind.fields.index(name)]) if name in kind.fields else None


def _same(one: _Known | None, other: _Known | None) -> bool | None:
    """Return whether one thing is the other where one of them is None, None where that is not known."""
    if one is None or other is None:
        return None
    if one.constant and other.constant:
        return one.what is other.what
    nothing = _Known(True, None)
    return False if nothing in (one, other) else None


def decide(blocks: dict[int, Any], args: tuple[Any, ...]) -> None:
    """Take away the branches that types decide, and the blocks that cannot be reached then."""
    changed = True
    while changed:
        for dead in compute_cfg_from_blocks(blocks).dead_nodes():
            del blocks[dead]
        changed, knowledge = False, _Knowledge(blocks, args)
        for block in blocks.values():
            last = block.body[-1]
            if isinstance(last, ir.Branch):
                truth = knowledge.truth(last.cond.name)
                if truth is not None:
                    block.body[-1] = ir.Jump(last.truebr if truth else last.falsebr, last.loc)
                    changed = True


def _read(function: FunctionType, state: Any) -> Any:
    """Return a part as numba reads it, with the calls of other parts in it."""
    if function not in _READ:
        own = StateDict()
        own.update(state)
        own.func_ir = None
        own.func_id = bytecode.FunctionIdentity.from_function(function)
        own.status = _CompileStatus(False)
        own.typemap = own.calltypes = own.return_type = own.type_annotation = None
        own.metadata, own.locals = {}, {}
        untyped_passes.ExtractByteCode().run_pass(own)
        own.args = len(own.func_id.pysig.parameters) * (types.pyobject,)
        manager = Passes("part")
        for step in (
            ReadByteCode,
            untyped_passes.FixupArgs,
            untyped_passes.RewriteSemanticConstants,
            Rewrite,
        ):
            manager.add_pass(step, step.__name__)
        manager.finalize()
        manager.run(own)
        _READ[function] = own.func_ir
    return _READ[function]


class _Copier:
    """Copies a part's blocks under names and labels of their own."""

    def __init__(self, scope: Any, prefix: str, offset: int) -> None:
        self._scope, self._prefix, self._offset = scope, prefix, offset
        self._variables: dict[str, Any] = {}

    def block(self, block: Any) -> Any:
        """Copy a block."""
        found = ir.Block(self._scope, block.loc)
        found.body = [self._statement(statement) for statement in block.body]
        return found

    def _statement(self, statement: Any) -> Any:
        copy = object.__new__(type(statement))
        for key, value in vars(statement).items():
            is_label = key in ("target", "truebr", "falsebr") and isinstance(value, int)
            copy.__dict__[key] = value + self._offset if is_label else self._copied(value)
        return copy

    def _copied(self, value: Any) -> Any:
        if isinstance(value, ir.Var):
            if value.name not in self._variables:
                name = f"{self._prefix}{value.name}"
                self._variables[value.name] = self._scope.redefine(name, value.loc)
            return self._variables[value.name]
        if isinstance(value, ir.Expr):
            fields = {key: self._copied(item) for key, item in value._kws.items()}
            return ir.Expr(value.op, value.loc, **fields)
        if isinstance(value, list | tuple):
            return type(value)(self._copied(item) for item in value)
        return value


def _part(func_ir: Any, call: Any) -> Any:
    """Return the Python function of the part that is called, None where it is something else."""
    try:
        called = func_ir.get_definition(call.func)
    except KeyError:
        return None
    value: Any = called.value if isinstance(called, ir.Global | ir.FreeVar) else None
    options = getattr(value, "targetoptions", None) or {}
    return value.py_func if options.get("inline") == "always" else None


def _calls(blocks: dict[int, Any], func_ir: Any) -> Iterator[tuple[int, int, Any]]:
    """Yield label and place of the first call of a part in every block, and the part's function."""
    for label in list(blocks):
        for i, statement in enumerate(blocks[label].body):
            if isinstance(statement, ir.Assign) and isinstance(statement.value, ir.Expr):
                if statement.value.op == "call":
                    function = _part(func_ir, statement.value)
                    if function is not None:
                        yield label, i, function
                        break


def _put_in(func_ir: Any, label: int, i: int, part: Any, count: int) -> None:
    """Put a part in place of statement `i` of a block; what comes after it becomes a block of its own."""
    blocks = func_ir.blocks
    block = blocks[label]
    call, offset = block.body[i], max(blocks) + 1
    copier = _Copier(block.scope, f"{part.func_id.func_name}.{count}.", offset)
    body = {key + offset: copier.block(one) for key, one in part.blocks.items()}
    after = max(body) + 1
    args = _get_callee_args(call.value, part.func_id.func, call.loc, func_ir)
    _replace_args_with(body, args)
    _replace_returns(body, call.target, after)
    rest = ir.Block(block.scope, block.loc)
    rest.body = block.body[i + 1 :]
    block.body = [*block.body[:i], ir.Jump(min(body), call.loc)]
    blocks.update(body)
    blocks[after] = rest


@register_pass(mutates_CFG=True, analysis_only=False)
class InlineParts(FunctionPass):
    """Put all parts that are called into a function, level by level."""

    _name = "ropewalk_inline_parts"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        func_ir, count = state.func_ir, 0
        decide(func_ir.blocks, state.args)
        while True:
            found = list(_calls(func_ir.blocks, func_ir))
            if not found:
                break
            for label, i, function in found:
                count += 1
                _put_in(func_ir, label, i, _read(function, state), count)
            decide(func_ir.blocks, state.args)
            func_ir._definitions = build_definitions(func_ir.blocks)
        if count > 0:
            func_ir.blocks = simplify_CFG(func_ir.blocks)
            ir_utils._the_max_label.update(max(func_ir.blocks))
            func_ir._definitions = build_definitions(func_ir.blocks)
        return count > 0
