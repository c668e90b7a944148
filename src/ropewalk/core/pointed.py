"""Named tuples of arrays, handed to kernels by one address each.

numba hands a named tuple over by its members: a step took a thousand arguments, and every entry code to
take them out of Python's tuples. Here a call from Python writes the members of a tuple, and of those in it,
into one block on the stack. Kernels get its address and load what they use.
"""

from __future__ import annotations

import hashlib
from typing import Any

from llvmlite import ir as llvm
from numba.core import cgutils, types
from numba.core.datamodel.models import PrimitiveModel
from numba.core.datamodel.registry import register_default
from numba.core.imputils import lower_builtin, lower_getattr_generic
from numba.core.pythonapi import NativeValue, unbox

from ropewalk.core.elements import make_array


class Pointed(types.NamedTuple):
    """The type of a named tuple that kernels get by its address."""

    def __init__(self, kinds: tuple[Any, ...], instance_class: type) -> None:
        super().__init__(kinds, instance_class)
        # It is a part of the names of functions: short, for there are two hundred members.
        members = hashlib.sha1(self.name.encode()).hexdigest()[:12]
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
        return Pointed(items, each.instance_class) if named else types.BaseTuple.from_types(items)
    return kind


def _block(dmm: Any, kind: Pointed) -> Any:
    """Return LLVM's type of the members in memory."""
    return llvm.LiteralStructType([_stored(dmm, item) for item in kind.types])


def _stored(dmm: Any, kind: Any) -> Any:
    return _block(dmm, kind) if isinstance(kind, Pointed) else dmm.lookup(kind).get_data_type()


@register_default(Pointed)
class _Address(PrimitiveModel):
    """A pointed tuple is its address."""

    def __init__(self, dmm: Any, kind: Pointed) -> None:
        super().__init__(dmm, kind, _block(dmm, kind).as_pointer())


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
    return _load(context, builder, kind.types[index], _place(builder, value, index))


def _place(builder: Any, address: Any, *at: int) -> Any:
    return cgutils.gep_inbounds(builder, address, 0, *at)


def _load(context: Any, builder: Any, kind: Any, address: Any) -> Any:
    """Return the value at an address in a block."""
    if isinstance(kind, Pointed):
        return address
    if isinstance(kind, types.NoneType):
        return context.get_dummy_value()
    model = context.data_model_manager[kind]
    if isinstance(kind, types.Array):
        places = (model.get_field_position(name) for name in ("data", "shape", "strides"))
        data, *rest = (_place(builder, address, place) for place in places)
        shape, strides = (
            [_word(builder, _place(builder, row, i)) for i in range(kind.ndim)] for row in rest
        )
        known = None if kind.layout == "C" else strides
        return make_array(context, builder, kind, _word(builder, data), shape, known)
    if isinstance(kind, types.BaseTuple):
        each: Any = kind
        found = llvm.Constant(model.get_value_type(), None)
        for i, item in enumerate(each.types):
            value = _load(context, builder, item, _place(builder, address, i))
            found = builder.insert_value(found, value, i)
        return found
    word = _word(builder, address)
    if isinstance(kind, types.Boolean):  # numba's own way has branches, where no block may end
        return builder.icmp_unsigned("!=", word, word.type(0))
    return model.from_data(builder, word)


def _word(builder: Any, address: Any) -> Any:
    """Load from a block; no kernel changes one, so LLVM need not load anything twice."""
    found = builder.load(address)
    found.set_metadata("invariant.load", builder.module.add_metadata([]))
    return found


def _write(c: Any, kind: Any, obj: Any, address: Any) -> Any:
    """Write a Python value into its place in a block; return whether it could not be read."""
    builder = c.builder
    if isinstance(kind, types.NoneType):
        return cgutils.false_bit
    if isinstance(kind, types.Array):
        adapt = c.pyapi.numba_array_adaptor
        return cgutils.is_not_null(builder, adapt(obj, builder.bitcast(address, c.pyapi.voidptr)))
    if isinstance(kind, types.BaseTuple):
        each: Any = kind
        failed = cgutils.false_bit
        for i, item in enumerate(each.types):
            value = c.pyapi.tuple_getitem(obj, i)
            failed = builder.or_(failed, _write(c, item, value, _place(builder, address, i)))
        return failed
    native = c.unbox(kind, obj)
    model = c.context.data_model_manager[kind]
    builder.store(model.as_data(builder, native.value), address)
    return native.is_error


@unbox(Pointed)
def _unbox(kind: Pointed, obj: Any, c: Any) -> Any:
    """Write a block for one call: what calls the kernel keeps the arrays."""
    address = cgutils.alloca_once(c.builder, _block(c.context.data_model_manager, kind))
    return NativeValue(address, is_error=_write(c, kind, obj, address))
