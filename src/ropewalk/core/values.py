"""Lowering to LLVM that keeps named tuples apart.

numba keeps what is used in several blocks in memory, and loads a named tuple of two hundred arrays whole for
each field that is read: thousands of instructions that LLVM takes apart again. Here a variable that is given
one value is that value, and the field of a tuple that was just put together is what was put in.
"""

from __future__ import annotations

from typing import Any

from llvmlite.ir import IRBuilder, instructions
from numba.core import cgutils, ir
from numba.core.analysis import compute_cfg_from_blocks, must_use_alloca
from numba.core.compiler_machinery import register_pass
from numba.core.lowering import Lower
from numba.core.typed_passes import NativeLowering

from ropewalk.core.elements import View, is_plain, make_array
from ropewalk.core.frontend import variables_in, variables_of


class _Builder(IRBuilder):  # type: ignore[misc]
    """Takes a field out of an aggregate where it was put in, and knows what of tuples is loaded already."""

    def __init__(self, block: Any) -> None:
        super().__init__(block)
        self.members: dict[
            int, dict[int, Any]
        ] = {}  # by the address's identity, see `core.pointed`

    def extract_value(self, agg: Any, idx: Any, name: str = "") -> Any:
        """Return member `idx` of an aggregate."""
        at = tuple(idx) if isinstance(idx, tuple | list) else (idx,)
        while isinstance(agg, instructions.InsertValue):
            inside = tuple(agg.indices)
            if inside == at:
                return agg.value
            if inside[: len(at)] == at or at[: len(inside)] == inside:
                break  # a part of it, or it is a part
            agg = agg.aggregate
        return super().extract_value(agg, at, name)


class _Lower(Lower):
    """Keeps variables that are given one value out of memory."""

    def setup_function(self, fndesc: Any) -> None:
        """Begin a function."""
        super().setup_function(fndesc)
        self._operators: dict[Any, Any] = {}  # what they return, and how that is computed
        self.builder = _Builder(self.entry_block)
        self.call_helper = self.call_conv.init_call_helper(self.builder)

    def _find_singly_assigned_variable(self) -> None:
        """Find the variables with one value, in a block before all that use them."""
        self._blk_local_varmap: dict[str, Any] = {}
        blocks = self.func_ir.blocks
        given: dict[str, list[int]] = {}
        for label, block in blocks.items():
            for statement in block.find_insts(ir.Assign):
                given.setdefault(statement.target.name, []).append(label)
        used: dict[str, set[int]] = {}
        for label, block in blocks.items():
            for name in _used(block):
                used.setdefault(name, set()).add(label)
        dominators = compute_cfg_from_blocks(blocks).dominators()
        in_memory = must_use_alloca(blocks)
        self._singly_assigned_vars = {
            name
            for name, labels in given.items()
            if len(labels) == 1
            and name not in in_memory
            and all(
                labels[0] in dominators[label] and labels[0] < label for label in used.get(name, ())
            )
        }

    def alloca_lltype(self, name: str, lltype: Any, datamodel: Any = None) -> Any:
        """Return a place in memory; numba asks for its size besides, for a debugger."""
        return cgutils.alloca_once(self.builder, lltype, name=name, zfill=False)

    def storevar(self, value: Any, name: str, argidx: Any = None) -> None:
        """Store a variable, and tell a debugger of no argument."""
        super().storevar(value, name)

    def lower_binop(self, resty: Any, expr: Any, op: Any) -> Any:
        """Put two values together; numba is asked how, once in a function for each operator and types."""
        if expr.static_lhs is not ir.UNDEFINED or expr.static_rhs is not ir.UNDEFINED:
            return super().lower_binop(resty, expr, op)
        context, args = self.context, self.fndesc.calltypes[expr].args
        if (op, args) not in self._operators:
            function = context.typing_context.resolve_value_type(op)
            signature = function.get_call_type(context.typing_context, args, {})
            self._operators[op, args] = signature, context.get_function(function, signature)
        signature, compute = self._operators[op, args]
        values = [
            context.cast(self.builder, self.loadvar(one.name), self.typeof(one.name), kind)
            for one, kind in zip((expr.lhs, expr.rhs), args, strict=True)
        ]
        found = compute(self.builder, values)
        return context.cast(self.builder, found, signature.return_type, resty)

    def lower_getitem(self, resty: Any, expr: Any, value: Any, index: Any, signature: Any) -> Any:
        """Take an element, a row or a range out of an array."""
        view = self._view(value, index)
        if view is None:
            return super().lower_getitem(resty, expr, value, index, signature)
        if view.shape:
            return make_array(self.context, self.builder, resty, view.data, view.shape)
        dtype = self.typeof(value.name).dtype
        found = self.context.unpack_value(self.builder, dtype, view.data)
        return self.context.cast(self.builder, found, dtype, resty)

    def lower_setitem(self, target_var: Any, index_var: Any, value_var: Any, signature: Any) -> Any:
        """Write an element of an array."""
        view = self._view(target_var, index_var)
        if view is None or view.shape:
            return super().lower_setitem(target_var, index_var, value_var, signature)
        value, given = self.loadvar(value_var.name), self.typeof(value_var.name)
        dtype = self.typeof(target_var.name).dtype
        value = self.context.cast(self.builder, value, given, dtype)
        return self.context.pack_value(self.builder, dtype, value, view.data)

    def _view(self, array: Any, index: Any) -> View | None:
        """Return the part of an array that an index means, None where numba has to find it."""
        kind, place = self.typeof(array.name), self.typeof(index.name)
        if not is_plain(kind, place):
            return None
        view = View(self.context, self.builder, kind, self.loadvar(array.name))
        view.take(place, self.loadvar(index.name))
        return view

    def lower_normal_function(self, fndesc: Any) -> None:
        """Lower a function, and leave out what takes tuples apart or puts them together for nothing."""
        super().lower_normal_function(fndesc)
        _drop_unused(self.function)


def _used(block: Any) -> set[str]:
    """Return the variables that a block uses, but those that it gave a value before."""
    used: set[str] = set()
    given: set[str] = set()
    for statement in block.body:
        if isinstance(statement, ir.Assign):
            taken = {one.name for one in variables_in([statement.value])}
            used |= taken - given
            given.add(statement.target.name)
        else:
            used |= {one.name for one in variables_of(statement)} - given
    return used


def _drop_unused(function: Any) -> None:
    """Take away the instructions on aggregates that nothing uses."""
    uses: dict[int, int] = {}
    for block in function.blocks:
        for one in block.instructions:
            for value in _operands(one):
                uses[id(value)] = uses.get(id(value), 0) + 1
    idle = [one for block in function.blocks for one in block.instructions if _is_idle(one, uses)]
    gone = set()
    while idle:
        one = idle.pop()
        gone.add(id(one))
        for value in _operands(one):
            uses[id(value)] -= 1
            if _is_idle(value, uses):
                idle.append(value)
    for block in function.blocks:
        block.instructions = [one for one in block.instructions if id(one) not in gone]


def _operands(one: Any) -> list[Any]:
    values = list(one.operands)
    if isinstance(one, instructions.PhiInstr):
        values += [value for value, _ in one.incomings]
    return values


def _is_idle(value: Any, uses: dict[int, int]) -> bool:
    on_tuples = instructions.InsertValue, instructions.ExtractValue
    return isinstance(value, on_tuples) and uses.get(id(value), 0) == 0


@register_pass(mutates_CFG=False, analysis_only=False)
class LowerValues(NativeLowering):
    """Lower with variables as values."""

    _name = "ropewalk_lower_values"

    @property
    def lowering_class(self) -> Any:
        return _Lower
