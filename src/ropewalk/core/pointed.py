"""Named tuples of arrays, handed to kernels by one address each.

numba hands a named tuple over by its members: a step took a thousand arguments, and every entry code to
take them out of Python's tuples. Here a call from Python writes the members of a tuple, and of those in it,
into one block of words on the stack. Kernels get its address and load what they use. What writes it is one
loop that goes by a table of the members: written out for each of them, it was most of an entry's code.
"""

from __future__ import annotations

import hashlib
import zlib
from functools import cache
from itertools import accumulate
from typing import Any, NamedTuple

from llvmlite import ir as llvm
from numba.core import cgutils, types
from numba.core.datamodel.models import PrimitiveModel
from numba.core.datamodel.registry import register_default
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.pythonapi import NativeValue, unbox

from ropewalk.core.elements import make_array

_WORD, _HALF = llvm.IntType(64), llvm.IntType(32)
_DATA, _SHAPE = 4, 5  # words before them in numba's array


_KNOWN: dict[str, Any] = {}
_MARKED: dict[int, Any] = {}


def known(name: str) -> Any:
    """Return the type of this name that Python has called a kernel with."""
    return _KNOWN[name]


class Block(NamedTuple):
    """A tuple's block that is kept, which kernels take from Python in its place: no type is looked at.

    Of a class of its own for each type of tuples, as numba knows named tuples again by their classes.
    """

    words: Any  # (m,)


@cache
def block_class(mark: int) -> Any:
    """Return the class of blocks of the type with this mark that Python has called a kernel with."""
    kind = _MARKED[mark]
    if len(kind.types) == 1:
        raise NotImplementedError("a block of a tuple of one: it could be taken for that")
    return type(f"Block_{mark}", (Block,), {"__slots__": (), "kind": kind})


def mark_of(kind: Any) -> int:
    """Return a number for the type of a tuple, the same in every process."""
    return zlib.crc32(kind.name.encode())


class Pointed(types.NamedTuple):
    """The type of a named tuple that kernels get by its address."""

    def __init__(self, kinds: tuple[Any, ...], instance_class: type) -> None:
        super().__init__(kinds, instance_class)
        # It is a part of the names of functions: short, for there are two hundred members.
        own = f"{instance_class.__module__}.{instance_class.__qualname__} {self.name}"
        members = hashlib.sha1(own.encode()).hexdigest()[:12]
        self.name = f"{instance_class.__name__}_{members}"

    @property
    def key(self) -> Any:
        """Return what types are told apart by; not the members, which the compiler hashed all day."""
        return self.instance_class, self.name


def pointed(kind: Any) -> Any:
    """Return the type of a value with all named tuples in it by their addresses."""
    if isinstance(kind, types.BaseTuple):
        each: Any = kind
        items = tuple(pointed(item) for item in each.types)
        named = isinstance(kind, types.BaseNamedTuple)
        if not named:
            return types.BaseTuple.from_types(items)
        found = Pointed(items, each.instance_class)
        found = _KNOWN.setdefault(found.name, found)
        _MARKED[mark_of(found)] = found
        return found
    return kind


@cache
def _places(kind: Any) -> tuple[int, ...]:
    """Return the word of a block at which each member of a tuple begins, and that after the last."""
    return tuple(accumulate((words_of(item) for item in kind.types), initial=0))


def words_of(kind: Any) -> int:
    """Return how many words of a block a value takes."""
    if isinstance(kind, types.BaseTuple):
        return _places(kind)[-1]
    if isinstance(kind, types.Array):
        return _SHAPE + 2 * kind.ndim
    return 0 if isinstance(kind, types.NoneType) else 1


@register_default(Pointed)
class _Address(PrimitiveModel):
    """A pointed tuple is its address."""

    def __init__(self, dmm: Any, kind: Pointed) -> None:
        super().__init__(dmm, kind, _WORD.as_pointer())


@lower_getattr_generic(Pointed)
def _named(context: Any, builder: Any, kind: Pointed, value: Any, name: str) -> Any:
    """Return a member by name."""
    return _member(context, builder, kind, value, kind.fields.index(name))


@lower_builtin("static_getitem", Pointed, types.IntegerLiteral)
def _placed(context: Any, builder: Any, signature: Any, args: Any) -> Any:
    """Return a member by its place."""
    kind, (value, index) = signature.args[0], args
    return _member(context, builder, kind, value, index % len(kind.types))


def _member(context: Any, builder: Any, kind: Pointed, value: Any, index: int) -> Any:
    """Return a member, loaded where the function begins: once, and outside of all loops.

    That needs the address there, which an argument has, and a tuple in one. Named tuples that are put
    together in kernels are numba's own.
    """
    loaded = getattr(builder, "members", {})
    if isinstance(value, llvm.Argument):
        loaded.setdefault(id(value), {})
    if id(value) not in loaded:
        return _load_member(context, builder, kind, value, index)
    members = loaded[id(value)]
    if index not in members:
        with builder.goto_entry_block():
            members[index] = _load_member(context, builder, kind, value, index)
        if isinstance(kind.types[index], Pointed):
            loaded[id(members[index])] = {}
    return members[index]


def _load_member(context: Any, builder: Any, kind: Pointed, value: Any, index: int) -> Any:
    place = _place(builder, value, _places(kind)[index])
    return _load(context, builder, kind.types[index], place)


def _place(builder: Any, address: Any, word: int) -> Any:
    return builder.gep(address, [_HALF(word)], inbounds=True)


def _load(context: Any, builder: Any, kind: Any, address: Any) -> Any:
    """Return the value at an address in a block."""
    if isinstance(kind, Pointed):
        return address
    if isinstance(kind, types.NoneType):
        return context.get_dummy_value()
    model = context.data_model_manager[kind]
    if isinstance(kind, types.Array):
        data = context.get_data_type(kind.dtype).as_pointer()
        shape = [_word(builder, _place(builder, address, _SHAPE + i)) for i in range(kind.ndim)]
        strides = None
        if kind.layout != "C":
            first = _SHAPE + kind.ndim
            strides = [
                _word(builder, _place(builder, address, first + i)) for i in range(kind.ndim)
            ]
        place = builder.bitcast(_place(builder, address, _DATA), data.as_pointer())
        return make_array(context, builder, kind, _word(builder, place), shape, strides)
    if isinstance(kind, types.BaseTuple):
        each: Any = kind
        found = llvm.Constant(model.get_value_type(), None)
        for i, (item, word) in enumerate(zip(each.types, _places(kind), strict=False)):
            value = _load(context, builder, item, _place(builder, address, word))
            found = builder.insert_value(found, value, i)
        return found
    if isinstance(kind, types.Boolean):  # numba's own way has branches, where no block may end
        word = _word(builder, address)
        return builder.icmp_unsigned("!=", word, word.type(0))
    stored = _stored(kind)
    place = builder.bitcast(address, context.get_data_type(stored).as_pointer())
    return context.cast(builder, _word(builder, place), stored, kind)


def _word(builder: Any, address: Any) -> Any:
    """Load from a block; no kernel changes one, so LLVM need not load anything twice."""
    found = builder.load(address)
    found.set_metadata("invariant.load", builder.module.add_metadata([]))
    return found


_SCALARS: Any = types.float64, types.int64, types.boolean
_FAMILIES: Any = types.Float, types.Integer, types.Boolean
_NONE, _TUPLE, _ARRAY, _SCALAR = range(4)


def _stored(kind: Any) -> Any:
    """Return as what a number is in a block."""
    for stored, family in zip(_SCALARS, _FAMILIES, strict=True):
        if isinstance(kind, family):
            return stored
    raise NotImplementedError(f"a member of a tuple for kernels: {kind}")


def _table(kind: Any, word: int = 0) -> list[int]:
    """Return what `_filler` goes by: the number of members, for each what it is and where, and their tables.

    Where is the word of the block, for a tuple the place of its table from this one on.
    """
    rows: list[int] = []
    after: list[int] = []
    for item, place in zip(kind.types, _places(kind), strict=False):
        if isinstance(item, types.NoneType):
            rows += [_NONE, 0]
        elif isinstance(item, types.BaseTuple):
            rows += [_TUPLE, 1 + 2 * len(kind.types) + len(after)]
            after += _table(item, word + place)
        elif isinstance(item, types.Array):
            rows += [_ARRAY, word + place]
        else:
            rows += [_SCALAR + _SCALARS.index(_stored(item)), word + place]
    return [len(kind.types), *rows, *after]


def _filler(c: Any) -> Any:
    """Return the function of a module that writes a tuple into a block, and returns whether it failed."""
    module, pyapi = c.builder.module, c.pyapi
    name = "ropewalk.fill"
    if name in module.globals:
        return module.globals[name]
    flag, table, block = llvm.IntType(1), _HALF.as_pointer(), _WORD.as_pointer()
    fill = llvm.Function(module, llvm.FunctionType(flag, [pyapi.pyobj, table, block]), name)
    fill.linkage = "internal"
    builder = llvm.IRBuilder(fill.append_basic_block())
    pyapi = c.context.get_python_api(builder)
    own = c._replace(builder=builder, pyapi=pyapi)
    obj, rows, block = fill.args
    failed = cgutils.alloca_once_value(builder, cgutils.false_bit)
    take = llvm.FunctionType(pyapi.pyobj, [pyapi.pyobj, pyapi.py_ssize_t])
    take = cgutils.get_or_insert_function(module, take, "PyTuple_GetItem")

    def note(bad: Any) -> None:
        builder.store(builder.or_(builder.load(failed), bad), failed)

    with cgutils.for_range(builder, builder.load(rows), intp=_HALF) as loop:
        row = builder.gep(rows, [builder.add(builder.shl(loop.index, _HALF(1)), _HALF(1))])
        what, where = builder.load(row), builder.load(builder.gep(row, [_HALF(1)]))
        item = builder.call(take, [obj, builder.sext(loop.index, pyapi.py_ssize_t)])
        place = builder.gep(block, [where])
        after = builder.append_basic_block()
        switch = builder.switch(what, after)

        def case(number: int) -> None:
            one = builder.append_basic_block()
            switch.add_case(number, one)
            builder.position_at_end(one)

        case(_TUPLE)
        note(builder.call(fill, [item, builder.gep(rows, [where]), block]))
        builder.branch(after)
        case(_ARRAY)
        adapted = pyapi.numba_array_adaptor(item, builder.bitcast(place, pyapi.voidptr))
        note(cgutils.is_not_null(builder, adapted))
        builder.branch(after)
        for number, kind in enumerate(_SCALARS, start=_SCALAR):
            case(number)
            native = own.unbox(kind, item)
            word = native.value
            word = (
                builder.zext(word, _WORD) if kind == types.boolean else builder.bitcast(word, _WORD)
            )
            builder.store(word, place)
            note(native.is_error)
            builder.branch(after)
        builder.position_at_end(after)
    builder.ret(builder.load(failed))
    return fill


@unbox(Pointed)
def _unbox(kind: Pointed, obj: Any, c: Any) -> Any:
    """Take the block that is kept, or write one for this call: what calls the kernel keeps the arrays."""
    builder, pyapi = c.builder, c.pyapi
    with builder.goto_entry_block():
        room = builder.alloca(_WORD, words_of(kind))
        array = builder.alloca(_WORD, _SHAPE + 2)
        found = builder.alloca(room.type)
        bad = builder.alloca(cgutils.false_bit.type)
    size = pyapi.tuple_size(obj)
    is_block = builder.icmp_signed("==", size, size.type(1 if len(kind.types) > 1 else -1))
    with builder.if_else(is_block) as (kept, other):
        with kept:
            words = pyapi.tuple_getitem(obj, 0)
            failed = pyapi.numba_array_adaptor(words, builder.bitcast(array, pyapi.voidptr))
            builder.store(cgutils.is_not_null(builder, failed), bad)
            place = builder.load(builder.gep(array, [_HALF(_DATA)]))
            builder.store(builder.inttoptr(place, room.type), found)
        with other:
            numbers = llvm.Constant(llvm.ArrayType(_HALF, len(table := _table(kind))), table)
            table = cgutils.global_constant(builder.module, f"{kind.name}.members", numbers)
            args = obj, builder.bitcast(table, _HALF.as_pointer()), room
            builder.store(builder.call(_filler(c), args), bad)
            builder.store(room, found)
    return NativeValue(builder.load(found), is_error=builder.load(bad))
