"""Elements, rows and ranges of arrays in few instructions.

numba's own way serves every layout, index and step, and writes some hundred instructions for a range of
a row, all of which LLVM takes away again. Kernels have whole arrays of numbers, and ranges of step one.
Indices mean what they mean to Python, negative ones too.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir as llvm
from numba.core import cgutils, types


def is_plain(kind: Any, index: Any) -> bool:
    """Tell whether an array with an index of this type is served here."""
    if not (isinstance(kind, types.Array) and kind.layout == "C" and kind.aligned):
        return False
    each = _each(index)
    if not each or not isinstance(kind.dtype, types.Float | types.Integer):
        return False
    last, before = each[-1], each[:-1]
    ranged = isinstance(last, types.SliceType) and not last.has_step and len(each) == kind.ndim
    whole = isinstance(last, types.Integer) and len(each) <= kind.ndim
    return (ranged or whole) and all(isinstance(one, types.Integer) for one in before)


def _each(index: Any) -> tuple[Any, ...]:
    return tuple(index.types) if hasattr(index, "types") else (index,)


class View:
    """A part of an array in LLVM: the address of its first number, and its lengths."""

    def __init__(self, context: Any, builder: Any, kind: Any, array: Any) -> None:
        self._context, self._builder, self._model = (
            context,
            builder,
            context.data_model_manager[kind],
        )
        self.data, shape = self._get(array, "data"), self._get(array, "shape")
        self.shape = [builder.extract_value(shape, axis) for axis in range(kind.ndim)]

    def _get(self, array: Any, name: str) -> Any:
        return self._builder.extract_value(array, self._model.get_field_position(name))

    def take(self, index_type: Any, index: Any) -> None:
        """Narrow it down to what an index means."""
        builder, kinds, values = self._builder, _each(index_type), [index]
        if isinstance(index_type, types.BaseTuple):
            values = [builder.extract_value(index, i) for i in range(len(kinds))]
        lengths, offset = self.shape, None
        self.shape = lengths[len(kinds) :]
        for axis, length in enumerate(lengths):
            begin = None
            if axis < len(kinds) and isinstance(kinds[axis], types.Integer):
                whole = self._context.cast(builder, values[axis], kinds[axis], types.intp)
                begin = self._from_start(whole, length)
            elif axis < len(kinds):
                begin, size = self._range(values[axis], length)
                self.shape = [size]
            if axis > 0:
                offset = builder.mul(offset, length)
            if begin is not None:
                offset = begin if offset is None else builder.add(offset, begin)
        self.data = builder.gep(self.data, [offset])

    def _from_start(self, index: Any, length: Any) -> Any:
        """Return an index from the end as one from the start."""
        if isinstance(index, llvm.Constant) and index.constant >= 0:
            return index
        builder = self._builder
        negative = builder.icmp_signed("<", index, index.type(0))
        return builder.select(negative, builder.add(length, index), index)

    def _range(self, value: Any, length: Any) -> tuple[Any, Any]:
        """Return where a range begins and how long it is; it ends with the array at the latest."""
        builder = self._builder
        begin, end = (self._within(builder.extract_value(value, i), length) for i in range(2))
        size = builder.sub(end, begin)
        some = builder.icmp_signed(">", size, size.type(0))
        return begin, builder.select(some, size, size.type(0))

    def _within(self, index: Any, length: Any) -> Any:
        """Return an index as one from the start, from 0 to `length`."""
        builder, index = self._builder, self._from_start(index, length)
        index = builder.select(
            builder.icmp_signed("<", index, length.type(0)), length.type(0), index
        )
        return builder.select(builder.icmp_signed(">", index, length), length, index)


def make_array(
    context: Any,
    builder: Any,
    kind: Any,
    data: Any,
    shape: list[Any],
    strides: list[Any] | None = None,
) -> Any:
    """Return an array in LLVM; without strides a whole one, of which they follow from the shape."""
    model, number = context.data_model_manager[kind], context.get_data_type(kind.dtype)
    itemsize = context.get_constant(types.intp, context.get_abi_sizeof(number))
    size = itemsize.type(1)
    for length in shape:
        size = builder.mul(size, length)
    if strides is None:
        strides = [itemsize]
        for length in shape[:0:-1]:
            strides.insert(0, builder.mul(length, strides[0]))
    members = {
        "nitems": size,
        "itemsize": itemsize,
        "data": data,
        "shape": cgutils.pack_array(builder, shape),
        "strides": cgutils.pack_array(builder, strides),
    }
    found = llvm.Constant(model.get_value_type(), None)
    for name, value in members.items():
        found = builder.insert_value(found, value, model.get_field_position(name))
    return found
