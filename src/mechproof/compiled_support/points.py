"""Many points: storage for what one loop computes for each point and the next one takes.

The numbers of one kind are adjacent, so that a loop that stores them can be vectorised.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

# Number of points in a block: fifty numbers for each fit the fastest cache.
POINTS = 64


@intrinsic
def own_row(typingctx: Any) -> Any:
    """Return a pointer to space for one number for each point of a block.

    It is on the stack, so that LLVM sees that it aliases no argument, and vectorises loops over it.
    """
    kind = types.CPointer(types.float64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        length = ir.Constant(ir.IntType(64), POINTS)
        return cgutils.alloca_once(builder, ir.DoubleType(), size=length)

    return kind(), generate


@intrinsic
def prefetch_row(typingctx: Any, table: Any, row: Any) -> Any:
    """Prefetch a row of a table, which need not exist."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        array = context.make_array(signature.args[0])(context, builder, arguments[0])
        offset = builder.mul(builder.extract_value(array.strides, 0), arguments[1])
        byte, flag = ir.IntType(8).as_pointer(), ir.IntType(32)
        place = builder.gep(builder.bitcast(array.data, byte), [offset])
        function = ir.FunctionType(ir.VoidType(), [byte, flag, flag, flag])
        prefetch = builder.module.declare_intrinsic("llvm.prefetch", [byte], function)
        # The flags: for reading, into the nearest cache, data.
        builder.call(prefetch, [place, flag(0), flag(3), flag(1)])
        return context.get_dummy_value()

    return types.void(table, types.intp), generate


@intrinsic
def put(typingctx: Any, block: Any, point: Any, values: Any) -> Any:
    """Store the numbers of nested tuples in a flat array, for one point of a block."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        places = _point_at(context, builder, signature, arguments)
        for place, number in zip(places, _flatten(builder, values, arguments[2]), strict=False):
            builder.store(number, place)
        return context.get_dummy_value()

    return types.void(block, types.intp, values), generate


@intrinsic
def take(typingctx: Any, block: Any, point: Any, example: Any) -> Any:
    """Return the numbers stored for one point, in nested tuples like those of the example."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        places = _point_at(context, builder, signature, arguments)
        return _build(context, builder, example, map(builder.load, places))

    return example(block, types.intp, example), generate


@intrinsic
def count_numbers(typingctx: Any, example: Any) -> Any:
    """Return the count of numbers in nested tuples."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return context.get_constant(types.intp, _count(example))

    return types.intp(example), generate


def _count(kind: Any) -> int:
    return sum(map(_count, kind.types)) if isinstance(kind, types.BaseTuple) else 1


def _point_at(context: Any, builder: Any, signature: Any, arguments: Any) -> Iterator[Any]:
    """Yield pointers to the numbers of a point, one after another, endlessly."""
    block, point = arguments[:2]
    data = context.make_array(signature.args[0])(context, builder, block).data
    number = 0
    while True:
        offset = ir.Constant(point.type, number * POINTS)
        yield builder.gep(data, [builder.add(point, offset)])
        number += 1


def _flatten(builder: Any, kind: Any, value: Any) -> Iterator[Any]:
    if not isinstance(kind, types.BaseTuple):
        yield value
        return
    for i, part in enumerate(kind.types):
        yield from _flatten(builder, part, builder.extract_value(value, i))


def _build(context: Any, builder: Any, kind: Any, numbers: Iterator[Any]) -> Any:
    if not isinstance(kind, types.BaseTuple):
        return next(numbers)
    parts = [_build(context, builder, part, numbers) for part in kind.types]
    return context.make_tuple(builder, kind, parts)
