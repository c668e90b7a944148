"""Passes of numba without what they do again and again: the same code, in a fraction of the time.

Kernels are functions of some thousand statements, as all parts are put into them. numba rewrites all of
a function for every variable that is given several values, asks every statement for its types until
no type changes any more, and finds out after every pass where each variable is used for the last time.
"""

from __future__ import annotations

import operator
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from numba.core import errors, ir, ir_utils, ssa, typeinfer, types
from numba.core.analysis import compute_cfg_from_blocks
from numba.core.compiler import Flags
from numba.core.compiler_machinery import (
    FunctionPass,
    PassManager,
    _pass_registry,
    register_pass,
)
from numba.core.transforms import canonicalize_cfg

from ropewalk.core.frontend import ReadByteCode, variables_of


class Passes(PassManager):
    """Runs passes, and keeps no account of where variables live: kernels delete none, and never yield."""

    def run(self, state: Any) -> None:
        """Run all passes on a function. Raises NumbaError with the name of the one that failed."""
        for step, about in self.passes:
            known = _pass_registry.get(step)
            known.pass_inst.analysis = self._analysis
            try:
                for part in ("run_initialization", "run_pass", "run_finalizer"):
                    getattr(known.pass_inst, part)(state)
            except errors.NumbaError as error:
                raise self._patch_error(
                    f"Failed in {self.pipeline_name} (step: {about})", error
                ) from error
            if step is ReadByteCode:
                ir_utils.enforce_no_dels(state.func_ir)
            if known.mutates_CFG:
                state.func_ir.blocks = canonicalize_cfg(state.func_ir.blocks)


def rewrite_once(blocks: dict[int, Any]) -> None:
    """Give every variable one value, as `ssa.reconstruct_ssa`, where it is in a block at all."""
    cfg = compute_cfg_from_blocks(blocks)
    fronts, variables = ssa._iterated_domfronts(cfg), ssa._CacheListVars()
    having: dict[str, list[int]] = defaultdict(list)
    for label, block in blocks.items():
        for name in {one.name for statement in block.body for one in variables_of(statement)}:
            having[name].append(label)
    for name in ssa._find_defs_violators(blocks, cfg):
        mine, given = ssa._fresh_vars({label: blocks[label] for label in having[name]}, name)
        phis: dict[int, list[Any]] = defaultdict(list)
        states = ssa._make_states(blocks) | {
            "varname": name,
            "defmap": given,
            "phimap": phis,
            "cfg": cfg,
            "phi_locations": ssa._compute_phi_locations(fronts, given),
        }
        blocks.update(ssa._run_block_rewrite(mine, states, ssa._FixSSAVars(variables)))
        for label, some in phis.items():
            blocks[label].body = some + blocks[label].body


@register_pass(mutates_CFG=False, analysis_only=False)
class AssignOnce(FunctionPass):
    """Give every variable one value."""

    _name = "ropewalk_assign_once"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        func_ir = state.func_ir
        rewrite_once(func_ir.blocks)
        func_ir._definitions = ir_utils.build_definitions(func_ir.blocks)
        func_ir.blocks = canonicalize_cfg(func_ir.blocks)
        return True


def strip_phis(blocks: dict[int, Any]) -> dict[int, Any]:
    """Return blocks in which what a phi chooses from is assigned where it comes from.

    As early as can be: after the last value that it is given there.
    """
    chosen: dict[int, list[tuple[Any, Any]]] = defaultdict(list)
    found = {label: block.copy() for label, block in blocks.items()}
    for block in found.values():
        phis = {id(one): one for one in block.body if _is_phi(one)}
        for one in phis.values():
            for label, value in zip(
                one.value.incoming_blocks, one.value.incoming_values, strict=True
            ):
                chosen[label].append((one.target, value))
        block.body = [one for one in block.body if id(one) not in phis]
    for label, block in found.items():
        if chosen[label]:
            block.body = list(_with_choices(block.body, chosen[label]))
    return found


def _is_phi(one: Any) -> bool:
    value = one.value if isinstance(one, ir.Assign) else None
    return isinstance(value, ir.Expr) and value.op == "phi"


def _with_choices(body: list[Any], chosen: list[tuple[Any, Any]]) -> Iterator[Any]:
    """Yield statements, and after the last value of each chosen variable what is assigned it."""
    last = {one.target.name: id(one) for one in body if isinstance(one, ir.Assign)}
    following: dict[int, list[Any]] = defaultdict(list)
    for target, value in chosen:
        if value is ir.UNDEFINED:
            value = ir.Expr.null(loc=target.loc)
        one = ir.Assign(target=target, value=value, loc=value.loc)
        at = last.get(value.name, 0) if isinstance(value, ir.Var) else 0
        following[at].insert(0, one)
        last[target.name] = id(one)

    def shown(statements: list[Any]) -> Iterator[Any]:
        for one in statements:
            yield one
            yield from shown(following.get(id(one), []))

    yield from shown(following.get(0, []))
    yield from shown(body)


@register_pass(mutates_CFG=False, analysis_only=False)
class StripPhis(FunctionPass):
    """Assign what phis choose from, as LLVM's are others."""

    _name = "ropewalk_strip_phis"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        func_ir = state.func_ir
        func_ir.blocks = strip_phis(func_ir.blocks)
        func_ir._definitions = ir_utils.build_definitions(func_ir.blocks)
        return True


class _Types(typeinfer.TypeVarMap):
    """The types of all variables, and which were asked for."""

    asked: dict[str, Any]

    def __getitem__(self, name: str) -> Any:
        found = super().__getitem__(name)
        self.asked[name] = found
        return found


class _Constraints(typeinfer.ConstraintNetwork):
    """What every statement says about types; one whose types are as it left them has no more to say."""

    def __init__(self) -> None:
        super().__init__()
        self._left: dict[int, list[tuple[Any, Any]]] = {}

    def propagate(self, inferer: Any) -> list[Any]:
        """Ask those that may have something to say; return their errors."""
        found: list[Any] = []
        for constraint in self.constraints:
            left = self._left.get(id(constraint))
            if left is not None and all(one.type is kind for one, kind in left):
                continue
            asked: dict[str, Any] = {}
            inferer.typevars.asked = asked
            alone = typeinfer.ConstraintNetwork()
            alone.append(constraint)
            failed = alone.propagate(inferer)
            found += failed
            if not failed:
                self._left[id(constraint)] = [(one, one.type) for one in asked.values()]
        return found


_PLAIN = types.Number, types.Boolean, types.Array, types.SliceType
_CALLS: dict[Any, Any] = {}  # what numba's own functions return for plain arguments


class _Inferer(typeinfer.TypeInferer):
    """Infers types with both, and asks numba once what the sum of two floats is."""

    def __init__(self, context: Any, func_ir: Any, warnings: Any, options: Any) -> None:
        super().__init__(context, func_ir, warnings)
        self._options = options
        self.typevars, self.constraints = _Types(), _Constraints()
        self.typevars.set_context(context)
        self.typevars.asked = {}

    def resolve_call(self, fnty: Any, pos_args: Any, kw_args: Any) -> Any:
        """Return the signature of a call."""
        known = isinstance(fnty, types.Function) or type(fnty) is type(operator.add)
        if not known or kw_args or not all(map(_is_plain, pos_args)):
            return super().resolve_call(fnty, pos_args, kw_args)
        key = self.context, self._options, fnty, tuple(pos_args)
        if key not in _CALLS:
            _CALLS[key] = super().resolve_call(fnty, pos_args, kw_args)
        return _CALLS[key]


def _is_plain(kind: Any) -> bool:
    members: Any = kind
    if isinstance(kind, types.BaseTuple):
        return all(map(_is_plain, members))
    return isinstance(kind, _PLAIN)


@register_pass(mutates_CFG=False, analysis_only=False)
class InferTypes(FunctionPass):
    """Find the type of every variable."""

    _name = "ropewalk_infer_types"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        func_ir, context = state.func_ir, state.typingctx
        known: Any = errors  # numba's types know no fixer
        warnings = known.WarningsFixer(errors.NumbaWarning)
        inferer = _Inferer(context, func_ir, warnings, state.flags.copy())
        active = context.callstack.register(
            state.targetctx.target, inferer, state.func_id, state.args
        )
        with active, warnings:
            for i, (name, kind) in enumerate(zip(func_ir.arg_names, state.args, strict=True)):
                inferer.seed_argument(name, i, kind)
            inferer.build_constraint()
            inferer.propagate()
            state.typemap, state.return_type, state.calltypes = inferer.unify()
        state.typing_errors = []
        return True


class _Shared(Flags):
    """Options that are the same as others only if they are these."""

    __hash__ = object.__hash__
    __eq__ = object.__eq__


_SHARED: list[_Shared] = []


class Options(Flags):
    """What a kernel is compiled with. All kernels with equal options look things up by the same ones.

    numba remembers by them what `max` is for two floats, and compared all thirty with each kernel's for
    each call of any function.
    """

    def copy(self) -> Any:
        """Return what numba looks things up by, and changes nothing of."""
        for one in _SHARED:
            if one.values() == self.values():
                return one
        _SHARED.append(_Shared(self))
        return _SHARED[-1]
