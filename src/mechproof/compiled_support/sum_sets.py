"""Sums in compiled kernels: over the terms of one set, or of many sets side by side.

Kernels pass functions that compute one term, as they do for one point. The place of a term (`at`)
is None for a single set, otherwise the number of the set and the number of terms in a set.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, overload
from numba.np.arrayobj import load_item

from mechproof.compiled_support.machine import apart, bare, choose, is_finite, widen, within
from mechproof.compiled_support.point_loops import put_point, take_point
from mechproof.compiled_support.points import POINTS, own_row, prefetch_row

# The most numbers of an argument in a block of sets, so that a few arguments fit the fastest cache.
LARGEST_BLOCK = 4096
# Number of doubles in the widest vector register.
LANES = 8
_HOW = {"error_model": "numpy", "forceinline": True, "no_cfunc_wrapper": True}
TAKEN = {"jit_options": _HOW, "strict": False}


@intrinsic
def lend(typingctx: Any, values: Any) -> Any:
    """Return arrays, possibly in tuples, without their reference counts."""

    def strip(context: Any, builder: Any, kind: Any, value: Any) -> Any:
        if isinstance(kind, types.BaseTuple):
            parts = zip(kind, cgutils.unpack_tuple(builder, value), strict=True)
            return context.make_tuple(
                builder, kind, [strip(context, builder, *part) for part in parts]
            )
        if not isinstance(kind, types.Array):
            return value
        array = context.make_array(kind)(context, builder, value)
        for name in ("meminfo", "parent"):
            setattr(array, name, cgutils.get_null_value(getattr(array, name).type))
        return array._getvalue()

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        return strip(context, builder, values, given[0])

    return values(values), generate


@intrinsic
def hold(typingctx: Any, values: Any) -> Any:
    """Keep arrays alive up to this call."""
    return types.void(values), lambda context, builder, signature, given: context.get_dummy_value()


@intrinsic
def take_element(typingctx: Any, block: Any, index: Any, number: Any) -> Any:
    """Return an element of a set in a block, without the reference counting numba would add."""
    array = block[0]

    def generate(context: Any, builder: Any, signature: Any, given: Any) -> Any:
        held = builder.extract_value(given[0], 0)
        made = context.make_array(array)(context, builder, held)
        place = cgutils.get_item_pointer(context, builder, array, made, given[1:])
        return load_item(context, builder, array, place)

    return array.dtype(block, types.intp, types.intp), generate


def element(values: Any, at: Any, *indices: int) -> float:
    """Return the element of a set at some indices, or the value that all its terms share.

    Before a loop over sets, when `at` has no set yet, this is a row: a number for each set.
    """
    raise NotImplementedError("called in compiled functions only")


@overload(element, **TAKEN)
def _find_element(values: Any, at: Any, *indices: Any) -> Any:
    if isinstance(values, types.Array):
        return lambda values, at, *indices: np.float64(values[indices])
    if not isinstance(values, types.BaseTuple):
        return lambda values, at, *indices: np.float64(values)
    if len(at) > 2:
        return lambda values, at, *indices: values[0][0]
    if not indices:
        return lambda values, at, *indices: take_element(values, 0, at[0])
    if len(indices) == 1:
        return lambda values, at, *indices: take_element(values, indices[0], at[0])
    return lambda values, at, *indices: take_element(values, indices[0] * at[1] + indices[1], at[0])


def count_inner(counts: Any) -> int:
    """Return the number of values of the inner index, 1 if there is none."""
    raise NotImplementedError("called in compiled functions only")


@overload(count_inner, **TAKEN)
def _count_inner(counts: Any) -> Any:
    return (lambda counts: counts[1]) if len(counts) > 1 else lambda counts: 1


def add_up(term: Any, rest: Any, at: Any, row: int, counts: Any, arrays: Any, *exact: bool) -> Any:
    """Return the sum of terms over one or two indices, including the rest of every addition.

    For many sets the sums are put into a row, only once if all sets have the same terms.
    """
    raise NotImplementedError("called in compiled functions only")


@overload(add_up, **TAKEN)
def _add_up(term: Any, rest: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any) -> Any:
    def add_one(
        term: Any, rest: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any
    ) -> Any:
        return _add_set(bare(term), bare(rest), counts, arrays + exact)

    def add_many(
        term: Any, rest: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any
    ) -> Any:
        if _vary(arrays, at[2]):
            _add_sets(bare(term), bare(rest), at[0][row], counts, arrays + exact)
        return at[0][row]

    return add_one if isinstance(at, types.NoneType) else add_many


@apart
def _add_set(term: Any, rest: Any, counts: Any, terms: Any) -> Any:
    high, low = 0.0, 0.0
    for i in range(counts[0]):
        for j in range(count_inner(counts)):
            value = term(None, i, j, *terms)
            total = high + value
            low += rest(high, value, total)
            high = total
    # A sum that overflows has no valid rest.
    return choose(is_finite(low), high + low, high)


@apart
def _add_sets(term: Any, rest: Any, out: Any, counts: Any, terms: Any) -> None:
    widen()
    high, low = own_row(), own_row()
    for s in range(len(out)):
        high[s], low[s] = 0.0, 0.0
    for i in range(counts[0]):
        for j in range(count_inner(counts)):
            for s in range(len(out)):
                value = term((s, counts[0]), i, j, *terms)
                total = high[s] + value
                low[s] += rest(high[s], value, total)
                high[s] = total
    for s in range(len(out)):
        out[s] = choose(is_finite(low[s]), high[s] + low[s], high[s])


def every(term: Any, at: Any, row: int, counts: Any, arrays: Any, *exact: bool) -> Any:
    """Return whether all terms over one or two indices are true; for many sets as `add_up`."""
    raise NotImplementedError("called in compiled functions only")


@overload(every, **TAKEN)
def _every(term: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any) -> Any:
    def ask_one(term: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any) -> Any:
        return _ask_set(bare(term), counts, arrays + exact)

    def ask_many(term: Any, at: Any, row: Any, counts: Any, arrays: Any, *exact: Any) -> Any:
        if _vary(arrays, at[2]):
            _ask_sets(bare(term), at[1][row], counts, arrays + exact)
        return at[1][row]

    return ask_one if isinstance(at, types.NoneType) else ask_many


@apart
def _ask_set(term: Any, counts: Any, terms: Any) -> bool:
    holds = True
    for i in range(counts[0]):
        for j in range(count_inner(counts)):
            holds = holds & term(None, i, j, *terms)
    return holds


@apart
def _ask_sets(term: Any, out: Any, counts: Any, terms: Any) -> None:
    widen()
    holds = own_row()
    for s in range(len(out)):
        holds[s] = 1.0
    for i in range(counts[0]):
        for j in range(count_inner(counts)):
            for s in range(len(out)):
                found = term((s, counts[0]), i, j, *terms)
                holds[s] = choose(found, holds[s], 0.0)
    for s in range(len(out)):
        out[s] = holds[s] > 0


@apart
def _vary(blocks: Any, start: int) -> bool:
    """Return whether sums of a block must be computed: its sets vary, or it is the first block."""
    for _, varies in blocks:
        if varies:
            return True
    return start == 0


@within
def fill_sets(
    value: Any, sums: Any, count: int, target: Any, terms: int, tables: Any, sizes: Any, exact: Any
) -> None:
    """Fill a target with the values of `value` for numbers and sums, in blocks of sets.

    `sums` returns the arguments of `value`, by at most `count` loops over terms; `sizes` are the
    numbers of elements that each table has for one set.
    """
    sets = _count_sets(len(target), max(sizes))
    owned = make_blocks(tables, sizes, sets)
    totals, answers = np.empty((count, sets)), np.empty((count, sets), np.bool_)
    blocks, lent, rows = lend(owned), lend(tables), lend((totals, answers))
    for start in range(0, len(target), sets):
        stop = min(start + sets, len(target))
        put_blocks(blocks, lent, start, stop)
        found = sums((rows[0], rows[1], start), terms, *blocks)
        _fill_sets(bare(value), target, start, stop, found, exact)
    hold((owned, totals, answers))


@apart
def _fill_sets(value: Any, target: Any, start: int, stop: int, found: Any, exact: Any) -> None:
    widen()
    for s in range(stop - start):
        put_point(target, start + s, value(*(take_point(found, s) + exact)))


@apart
def _count_sets(sets: int, elements: int) -> int:
    """Return how many sets, of up to `elements` elements each, are computed side by side."""
    fitting = LARGEST_BLOCK // max(elements, 1) // LANES * LANES
    return max(min(sets, POINTS, max(fitting, LANES)), 1)


def make_blocks(tables: Any, sizes: Any, sets: int) -> Any:
    """Return for each table a block to hold some sets, and whether the table has several rows."""
    raise NotImplementedError("called in compiled functions only")


@overload(make_blocks, **TAKEN)
def _make_blocks(tables: Any, sizes: Any, sets: Any) -> Any:
    if not len(tables):
        return lambda tables, sizes, sets: ()

    def make(tables: Any, sizes: Any, sets: Any) -> Any:
        first = (np.empty((sizes[0], sets)), len(tables[0]) > 1)
        return (first, *make_blocks(tables[1:], sizes[1:], sets))

    return make


def put_blocks(blocks: Any, tables: Any, start: int, stop: int) -> None:
    """Copy the rows of some sets of each table into its block, one set per column."""
    raise NotImplementedError("called in compiled functions only")


@overload(put_blocks, **TAKEN)
def _put_blocks(blocks: Any, tables: Any, start: Any, stop: Any) -> Any:
    if not len(tables):
        return lambda blocks, tables, start, stop: None

    def put_all(blocks: Any, tables: Any, start: Any, stop: Any) -> None:
        _put_sets(blocks[0][0], tables[0], start, stop)
        put_blocks(blocks[1:], tables[1:], start, stop)

    return put_all


@apart
def _put_sets(block: Any, table: Any, start: int, stop: int) -> None:
    """Copy the rows of some sets into a block, one set per column; a common row is copied once.

    A single column in the table stands for equal elements.
    """
    step = 1 if table.shape[1] == len(block) else 0
    if len(table) > 1:
        for s in range(stop - start):
            prefetch_row(table, start + s + POINTS)
            for i in range(len(block)):
                block[i, s] = table[start + s, i * step]
    elif start == 0:
        for i in range(len(block)):
            value = table[0, i * step]
            for s in range(block.shape[1]):
                block[i, s] = value
