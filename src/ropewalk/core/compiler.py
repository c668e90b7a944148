"""How kernels are compiled: numba's passes and one of ours, and no machine code for what only kernels call.

numba makes every compiled function ready for calls from Python: it optimises it with all that it calls,
makes machine code of it, and a wrapper that takes a hundred arrays out of their tuples. A kernel that another
kernel calls needs none of that: it is optimised where it is called. So a kernel is two things here: an entry,
compiled when Python calls it, and an inner function, kept as LLVM's bitcode, that kernels link in.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba.core import ir, ir_utils, sigutils, types, typing
from numba.core.compiler import CompilerBase, CompileResult, DefaultPassBuilder
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.dispatcher import _FunctionCompiler  # type: ignore[attr-defined]
from numba.core.registry import CPUDispatcher
from numba.core.typed_passes import NativeLowering, NopythonTypeInference, PreLowerStripPhis
from numba.core.untyped_passes import (
    GenericRewrites,
    MakeFunctionToJitFunction,
    ReconstructSSA,
    TranslateByteCode,
)

from ropewalk.core.deferred import calls_of, raise_late
from ropewalk.core.frontend import ReadByteCode, Rewrite, tell_nobody
from ropewalk.core.inlining import InlineParts
from ropewalk.core.libraries import EntryLibrary, InnerLibrary
from ropewalk.core.litter import kept_for_later
from ropewalk.core.passes import AssignOnce, InferTypes, Options, Passes, StripPhis
from ropewalk.core.pointed import Block, pointed
from ropewalk.core.values import LowerValues

tell_nobody()


@register_pass(mutates_CFG=False, analysis_only=False)
class _ForwardCopies(FunctionPass):
    """Use a variable itself in place of its copies.

    numba copies the arguments of a function that it inlines. A copy of a named tuple of a hundred arrays
    is a thousand loads and stores to LLVM: without this pass a step took three times as long to compile.
    """

    _name = "ropewalk_forward_copies"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        blocks, definitions = state.func_ir.blocks, state.func_ir._definitions
        phis = [phi for block in blocks.values() for phi in block.find_exprs("phi")]
        merged = {
            value.name for phi in phis for value in phi.incoming_values if isinstance(value, ir.Var)
        }

        def stays(variable: Any) -> bool:
            """Whether it is given one value, and not by a phi, which becomes several assignments."""
            given = definitions[variable.name]
            return len(given) == 1 and given[0] not in phis

        copies: dict[str, Any] = {}
        for block in blocks.values():
            for statement in block.find_insts(ir.Assign):
                source, target = statement.value, statement.target
                if isinstance(source, ir.Var) and stays(source) and stays(target):
                    if target.name not in merged:
                        copies[target.name] = source
        for name in copies:
            while copies[name].name in copies:
                copies[name] = copies[copies[name].name]
        for block in blocks.values():
            block.body = [
                statement
                for statement in block.body
                if not (isinstance(statement, ir.Assign) and statement.target.name in copies)
            ]
        ir_utils.replace_vars(blocks, copies)
        return bool(copies)


_OURS = {
    TranslateByteCode: ReadByteCode,
    GenericRewrites: Rewrite,
    MakeFunctionToJitFunction: InlineParts,
    ReconstructSSA: AssignOnce,
    NopythonTypeInference: InferTypes,
    PreLowerStripPhis: StripPhis,
    NativeLowering: LowerValues,
}


# Passes for what kernels have not: functions in functions, overloads to be put in, `with`, errors with values
# of their own, literal arguments, arrays and strings that are made, and counts of references that fall where
# a variable is used for the last time; and for what nobody reads, types in the text of the program.
_IDLE = {
    "AnnotateTypes",
    "DumpParforDiagnostics",
    "FindLiterallyCalls",
    "InlineClosureLikes",
    "InlineInlinables",
    "InlineOverloads",
    "IRLegalization",
    "IRProcessing",
    "LiteralPropagationSubPipelinePass",
    "LiteralUnroll",
    "NopythonRewrites",
    "RewriteDynamicRaises",
    "WithLifting",
}


class Compiler(CompilerBase):
    """numba's own passes and ours."""

    def __init__(self, *args: Any) -> None:
        super().__init__(*args)
        self.state.flags = Options(self.state.flags)

    def define_pipelines(self) -> list[Any]:
        theirs = DefaultPassBuilder.define_nopython_pipeline(self.state)
        manager = Passes(theirs.pipeline_name)
        for step, about in theirs.passes:
            if step.__name__ not in _IDLE:
                manager.add_pass(_OURS.get(step, step), about)
        manager.add_pass_after(_ForwardCopies, AssignOnce)
        manager.finalize()
        return [manager]


class InnerCompiler(Compiler):
    """Compiles into an `InnerLibrary`."""

    def define_pipelines(self) -> list[Any]:
        state = self.state
        state.library = InnerLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        return super().define_pipelines()


class ApartCompiler(InnerCompiler):
    """Promises LLVM that what is written through one argument is read through no other.

    Without it every loop over a rope first compares the bounds of all its arrays, dozens of them.
    """

    def define_pipelines(self) -> list[Any]:
        self.state.flags.noalias = True
        return super().define_pipelines()


def reduce_inner(result: Any) -> tuple[Any, ...]:
    """Return the picklable parts of an inner function's compile result."""
    result.fndesc.typemap = result.fndesc.calltypes = None
    return result.library.reduced(), result.fndesc, result.environment, result.signature


def rebuild_inner(target_context: Any, parts: tuple[Any, ...]) -> Any:
    """Return the compile result of which `reduce_inner` made `parts`."""
    reduced, fndesc, environment, signature = parts
    library = InnerLibrary.of(target_context.codegen(), reduced)
    result: Any = CompileResult  # a named tuple, of which numba's types know no field
    return result(
        typing_context=target_context.typing_context,
        target_context=target_context,
        entry_point=target_context.get_executable(library, fndesc, environment),
        typing_error=None,
        type_annotation=None,
        signature=signature,
        library=library,
        call_helper=None,
        environment=environment,
        lifted=(),
        fndesc=fndesc,
        objectmode=False,
        metadata=None,
        reload_init=[],
        referenced_envs=[],
    )


class _EntryCompiler(_FunctionCompiler):  # type: ignore[misc]
    """Compiles entries: the inner function and a wrapper that Python calls."""

    entry: Any  # the `Entry`

    def _compile_core(self, args: Any, return_type: Any) -> Any:
        self.entry.inner.compile(args)
        inner: Any = self.entry.inner.overloads[args]
        code = inner.library
        context, names, environment = inner.target_context, inner.fndesc, inner.environment
        shown = {names.llvm_cpython_wrapper_name}
        if isinstance(self.entry, Deferred):
            shown.add(names.llvm_func_name)
        library = EntryLibrary(context.codegen(), code.name, shown, seldom=self.entry.seldom)
        library.add_linking_library(code)
        context.create_cpython_wrapper(library, names, environment, None, release_gil=True)
        return inner._replace(
            library=library,
            entry_point=context.get_executable(library, names, environment),
            type_annotation="",
            metadata={},
        )


class Entry(CPUDispatcher):
    """A kernel as Python calls it; kernels that call it link in its `inner` function."""

    inner: Any  # the dispatcher of the inner function
    seldom: bool  # Python calls it so seldom that its machine code need not be fast
    _compiler: Any  # numba's: compiles for types
    _types_active_call: Any  # numba's: keeps the types of arguments alive

    def __call__(self, *args: Any, **named: Any) -> Any:
        """Call the kernel, and raise what it could not."""
        try:
            return super().__call__(*args, **named)
        finally:
            raise_late()

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Return what the types of a call from another kernel follow from.

        Without the values of constants: numba would compile a function for each.
        """
        plain = tuple(types.unliteral(one) for one in args)
        return self.inner.get_call_template(plain, kws)

    def get_overload(self, sig: Any) -> Any:
        """Return what another kernel calls."""
        return self.inner.get_overload(sig)

    def typeof_pyval(self, val: Any) -> Any:
        """Return the type of an argument; named tuples go by their address."""
        if isinstance(val, Block):
            return type(val).kind  # type: ignore[attr-defined]
        found = pointed(super().typeof_pyval(val))
        self._types_active_call.add(found)
        return found

    def compile(self, sig: Any) -> Any:
        """Compile for a signature and return what Python calls."""
        with kept_for_later():
            found = super().compile(sig)
        args, _ = sigutils.normalize_signature(sig)
        compiled: Any = self.overloads[tuple(args)]
        if compiled.library.has_dynamic_globals:
            name = self.py_func.__qualname__
            raise RuntimeError(f"{name}: its machine code holds addresses of this process")
        return found


class Deferred(Entry):
    """A kernel that is compiled when another one first calls it, and that others call by its address."""

    returns: Any  # the type of what it returns
    _calls: dict[Any, Any]

    def compile(self, sig: Any) -> Any:
        """Compile for a signature and return what Python calls."""
        found = super().compile(sig)
        compiled: Any = self.overloads
        for one in compiled.values():
            if one.signature.return_type != self.returns:
                name, what = self.py_func.__qualname__, one.signature.return_type
                raise TypeError(f"{name} returns {what}, and is said to return {self.returns}")
        return found

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Return what the types of a call from another kernel follow from: no code."""
        plain = tuple(types.unliteral(one) for one in args)
        pysig, folded = self._compiler.fold_argument_types(plain, kws)
        made: Any = typing  # of which numba's types know no functions
        name, signature = self.py_func.__name__, made.signature(self.returns, *folded)
        template = made.make_concrete_template(name, key=name, signatures=[signature])
        return template, pysig, folded, {}

    def get_overload(self, sig: Any) -> Any:
        """Return what another kernel calls."""
        args, _ = sigutils.normalize_signature(sig)
        if args not in self._calls:
            self._calls[args] = calls_of(self, args)
        return self._calls[args]


def deferred(function: Callable[..., Any], options: dict[str, Any], returns: Any) -> Any:
    """Return the kernel `function`, a `Deferred`; without caches. Raises TypeError for one inside another."""
    if "<locals>" in function.__qualname__:
        raise TypeError(f"{function.__qualname__}: no module has it under its name, to find it by")
    found = entry(function, options, kind=Deferred)
    found.returns, found._calls = returns, {}
    return found


def entry(
    function: Callable[..., Any],
    options: dict[str, Any],
    inner: Any = InnerCompiler,
    *,
    kind: type[Entry] = Entry,
    seldom: bool = False,
) -> Any:
    """Return the kernel `function`, an `Entry`, with the compiler of its inner function; without caches."""
    options = options | {"nopython": True}
    found: Any = kind(py_func=function, targetoptions=options)
    found.seldom = seldom
    before = found._compiler
    found._compiler = _EntryCompiler(
        function, before.targetdescr, options, before.locals, before.pipeline_class
    )
    found._compiler.entry = found
    options = options | {"no_cpython_wrapper": True}
    found.inner = CPUDispatcher(function, targetoptions=options, pipeline_class=inner)
    return found
