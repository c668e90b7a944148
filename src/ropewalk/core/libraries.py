"""LLVM's code of kernels: made into machine code where it is called from outside, else kept as it is."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache
from typing import Any

import llvmlite.binding as llvm
from numba.core import config
from numba.core.codegen import JITCodeLibrary

_NAME = re.compile(r'@"?([^"( ]+)"?\(')
_LABEL = re.compile(r'label %"?([^", ]+)"?')


class _NoEnvironments:
    """A code generator that is told nothing of the Python objects of a function without machine code.

    They are what a function needs in order to raise or print, which kernels do not.
    """

    def __init__(self, codegen: Any) -> None:
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def set_env(self, name: str, environment: Any) -> None:
        """Do nothing: the variable is nowhere in memory."""


class _Library(JITCodeLibrary):
    """LLVM's code of a function; its passes go over what is defined, numba's over what is only named, too."""

    def _optimize_functions(self, module: Any) -> None:
        module.data_layout = self._codegen._data_layout
        manager, builder = self._codegen._function_pass_manager()
        for function in module.functions:
            if not function.is_declaration:
                manager.run(function, builder)


@cache
def _quick_machine(codegen: Any) -> Any:
    """Return what makes machine code in little time; of bits that are the same, as no sum is reordered."""
    target = llvm.Target.from_triple(llvm.get_process_triple())
    options = {"opt": 0, "features": codegen._tm_features}
    codegen._customize_tm_options(options)
    return target.create_target_machine(**options)


_PLACES, _COPIES = 8, 700  # calls of a function, and the instructions of so many copies of it


class _Seen:
    """What is in a function, by its text."""

    def __init__(self) -> None:
        self.instructions = 0
        self.loops = False
        self._labels: set[str] = set()

    def read(self, line: str) -> None:
        """Take a line: a label, an instruction, or a jump back."""
        if line.startswith("  "):
            self.instructions += 1
            if line.startswith("  br "):
                self.loops = self.loops or not self._labels.isdisjoint(_LABEL.findall(line))
        elif ":" in line:
            self._labels.add(line.partition(":")[0].strip('"'))


def _keep_whole(module: Any) -> None:
    """Have loops that are called in many places called, and not put into each of them.

    LLVM takes most of its time to make the copies wide, each with its own checks of overlap: of what
    copies and adds arrays a step of an implicit method has forty.
    """
    seen: dict[str, _Seen] = {}
    calls: Counter[str] = Counter()
    here = _Seen()
    for line in str(module).splitlines():
        if line.startswith("define"):
            here = seen.setdefault(_NAME.findall(line)[0], _Seen())
        here.read(line)
        if " call " in line:
            calls.update(_NAME.findall(line)[:1])
    for name, places in calls.items():
        found = seen.get(name)
        if found is None or not found.loops or places < _PLACES:
            continue
        function = module.get_function(name)
        asked_for = any(b"alwaysinline" in kinds for kinds in function.attributes)
        if places * found.instructions >= _COPIES and not asked_for:
            function.add_function_attribute("noinline")


class InnerLibrary(_Library):
    """The LLVM code of an inner function and of all that it calls, neither optimised nor emitted."""

    @property
    def codegen(self) -> Any:
        return _NoEnvironments(self._codegen)

    def _optimize_final_module(self) -> None:
        """Leave it to the entry."""

    def _finalize_final_module(self) -> None:
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:
        """Return no address: there is no machine code."""
        self._ensure_finalized()
        return 0

    def reduced(self) -> tuple[str, bytes]:
        """Return what `of` makes it from again."""
        return self.name, self._get_module_for_linking().as_bitcode()

    @classmethod
    def of(cls, codegen: Any, reduced: tuple[str, bytes]) -> InnerLibrary:
        """Return the library that was `reduced`."""
        name, bitcode = reduced
        library = cls(codegen, name)
        library._final_module = llvm.parse_bitcode(bitcode)
        library._finalized = True
        return library


class EntryLibrary(_Library):
    """The LLVM code of an entry and of all that it calls, as machine code.

    Loops are vectorised as numba does it, but neither interleaved nor unrolled by the number of turns that a
    run brings: LLVM took half its time for the copies, and steps are as fast to 2 %. Short loops of known
    length are unrolled before, function by function.

    Its functions are its own. As numba links them, a process takes the first of its libraries that has
    a function of a name for all others that call it.
    """

    def __init__(self, codegen: Any, name: str, shown: set[str], *, seldom: bool) -> None:
        super().__init__(codegen, name)
        self._shown, self._seldom = shown, seldom
        self.enable_object_caching()

    def _optimize_final_module(self) -> None:
        codegen, module = self._codegen, self._final_module
        _keep_whole(module)
        cheap, builder = codegen._module_pass_manager(opt=0, loop_vectorize=False, cost="cheap")
        cheap.run(module, builder)
        if not self._seldom:
            self._optimize_loops()
        self._keep_to_itself()

    def _keep_to_itself(self) -> None:
        """Let no other library link what neither Python nor a kernel calls by its address."""
        for function in self._final_module.functions:
            if not function.is_declaration and function.name not in self._shown:
                function.linkage = llvm.Linkage.internal

    def _finalize_final_module(self) -> None:
        if self._seldom:
            self._compiled_object = _quick_machine(self._codegen).emit_object(self._final_module)
        made = self._compiled_object
        super()._finalize_final_module()
        self._compiled_object = made or self._compiled_object  # numba forgets what it was given

    def _optimize_loops(self) -> None:
        chosen: Any = config  # numba sets its options at run time
        options = llvm.create_pipeline_tuning_options(int(chosen.OPT))
        options.loop_vectorization = bool(chosen.LOOP_VECTORIZE)
        options.slp_vectorization = bool(chosen.SLP_VECTORIZE)
        options.loop_interleaving = options.loop_unrolling = False
        builder = llvm.create_pass_builder(self._codegen._tm, options)
        builder.getModulePassManager().run(self._final_module, builder)
