"""The loops of compiled kernels: over all points of flat arrays, or block by block.

A kernel passes the function that computes one point to a loop from one of its own functions. That
function is cached in a file; numba compiles the loop anew as a part of it. Arguments are flat
arrays with one number per point, `vector`s with several, and numbers or tuples common to all
points.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np.arrayobj import load_item, store_item

from mechproof.compiled_support.machine import apart, bare, widen, within

# Number of points after which the results of a fast loop are checked for NaN and, if there is one,
# computed again.
BLOCK = 1024
_REAL = types.float64


@intrinsic(prefer_literal=True)
def vector(typingctx: Any, values: Any, width: Any) -> Any:
    """Return a flat array as one with `width` numbers per point; anything else unchanged."""
    if not isinstance(values, types.Array):
        return values(values, width), lambda context, builder, signature, given: given[0]
    # With the width in the type, LLVM knows the strides of elements.
    kind = types.Tuple((values, types.UniTuple(types.none, width.literal_value)))

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        # numba expects a new reference to whatever is returned.
        context.nrt.incref(builder, values, given[0])
        return context.make_tuple(builder, kind, (given[0], context.get_constant_undef(kind[1])))

    return kind(values, width), generate


def _is_array(kind: Any) -> bool:
    return isinstance(kind, types.Array) or _is_vector(kind)


def _is_vector(kind: Any) -> bool:
    return isinstance(kind, types.Tuple) and isinstance(kind[-1], types.UniTuple)


def _split(kind: Any) -> tuple[Any, int]:
    """Return the type of an array or a vector's array, and its count of numbers per point."""
    return (kind[0], len(kind[1])) if _is_vector(kind) else (kind, 1)


def _make(context: Any, builder: Any, kind: Any, value: Any) -> Any:
    """Return the array of a value, which is an array or a vector."""
    held = builder.extract_value(value, 0) if _is_vector(kind) else value
    return context.make_array(_split(kind)[0])(context, builder, held)


def _list_places(
    context: Any, builder: Any, kind: Any, value: Any, point: Any
) -> list[tuple[Any, Any]]:
    """List pointers to the numbers of a point in one or several arrays, with the arrays' types."""
    if not _is_array(kind):
        parts = zip(kind, cgutils.unpack_tuple(builder, value), strict=True)
        return [place for part in parts for place in _list_places(context, builder, *part, point)]
    (array, width), made = _split(kind), _make(context, builder, kind, value)
    first = builder.mul(point, context.get_constant(types.intp, width), flags=["nsw"])
    steps = [context.get_constant(types.intp, k) for k in range(width)]
    indices = [builder.add(first, step, flags=["nsw"]) for step in steps]
    return [
        (array, cgutils.get_item_pointer(context, builder, array, made, [index]))
        for index in indices
    ]


@intrinsic
def count_points(typingctx: Any, values: Any) -> Any:
    """Return the number of points of an array or a vector."""

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        size = _make(context, builder, values, given[0]).nitems
        return builder.udiv(size, context.get_constant(types.intp, _split(values)[1]))

    return types.intp(values), generate


@intrinsic
def take_point(typingctx: Any, arguments: Any, point: Any) -> Any:
    """Return a tuple of the arguments at a point: numbers as doubles, booleans unchanged."""
    found = types.Tuple([part for kind in arguments for part in _list_taken(kind)])

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        parts = zip(arguments, cgutils.unpack_tuple(builder, given[0]), strict=True)
        taken = [n for part in parts for n in _take(context, builder, *part, given[1])]
        numbers = [
            context.cast(builder, number, kind, result)
            for (kind, number), result in zip(taken, found, strict=True)
        ]
        return context.make_tuple(builder, found, numbers)

    return found(arguments, point), generate


def _list_taken(kind: Any) -> list[Any]:
    """List the types of the values that a point takes from an argument."""
    if isinstance(kind, types.BaseTuple) and not _is_vector(kind):
        return [_REAL] * len(kind)
    array, width = _split(kind)
    return [types.boolean if getattr(array, "dtype", array) == types.boolean else _REAL] * width


def _take(
    context: Any, builder: Any, kind: Any, value: Any, point: Any
) -> Iterator[tuple[Any, Any]]:
    if _is_array(kind):
        for array, place in _list_places(context, builder, kind, value, point):
            yield array.dtype, load_item(context, builder, array, place)
    elif isinstance(kind, types.BaseTuple):
        yield from zip(kind, cgutils.unpack_tuple(builder, value), strict=True)
    else:
        yield kind, value


@intrinsic
def put_point(typingctx: Any, target: Any, point: Any, values: Any) -> Any:
    """Store the results for a point in an array, or in a tuple of arrays."""

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        goal, number, value = given
        places = _list_places(context, builder, target, goal, number)
        results = cgutils.unpack_tuple(builder, value) if len(places) > 1 else [value]
        for (array, place), result in zip(places, results, strict=True):
            stored = context.cast(builder, result, _REAL, array.dtype)
            store_item(context, builder, array, stored, place)
        return context.get_dummy_value()

    return types.void(target, point, values), generate


@intrinsic
def get_width(typingctx: Any, target: Any) -> Any:
    """Return how many adjacent numbers an array or a vector has for each point."""

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        return context.get_constant(types.intp, _split(target)[1])

    return types.intp(target), generate


@intrinsic
def count_nans(typingctx: Any, target: Any, index: Any) -> Any:
    """Count the NaNs at a flat index of an array or of several, regardless of points."""

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        value, number = given
        count = context.get_constant(types.intp, 0)
        flat, held = target, value
        if _is_vector(target):
            flat, held = target[0], builder.extract_value(value, 0)
        for array, place in _list_places(context, builder, flat, held, number):
            element = load_item(context, builder, array, place)
            is_nan = builder.fcmp_unordered("uno", element, element)
            count = builder.add(count, builder.zext(is_nan, count.type))
        return count

    return types.intp(target, index), generate


@within
def fill(value: Any, target: Any, arguments: Any) -> None:
    """Fill a target with the result of `value` at each point."""
    _fill_part(bare(value), target, arguments, 0, count_points(arguments[0]), ())


@within
def fill_blocks(value: Any, target: Any, arguments: Any) -> None:
    """Fill a target in the fast way, then each block that has a NaN again in the exact way."""
    size = count_points(arguments[0])
    for start in range(0, size, BLOCK):
        stop = min(start + BLOCK, size)
        _fill_part(bare(value), target, arguments, start, stop, (None,))
        if _has_nan(target, start, stop):
            _fill_part(bare(value), target, arguments, start, stop, (True,))


@apart
def _fill_part(value: Any, target: Any, arguments: Any, start: int, stop: int, exact: Any) -> None:
    widen()
    for i in range(start, stop):
        put_point(target, i, value(*(take_point(arguments, i) + exact)))


@apart
def _has_nan(target: Any, start: int, stop: int) -> bool:
    count, width = 0, get_width(target)
    for i in range(start * width, stop * width):
        count += count_nans(target, i)
    return count > 0
