"""Specimens: ways of computing a quantity, and those that every quantity has without a row."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from mechproof.codegen.evaluation import entries
from mechproof.codegen.forms import form_rows
from mechproof.proof.domain import Domain
from mechproof.record import Equality, Paper, Part, Quantity, Statement

Array = NDArray[Any]
Arguments = tuple[Array, ...]
Compute = Callable[..., Any]

# What SymPy's NumPy printer has no array code for.
BEYOND_LAMBDIFY = (sp.Sum, sp.Integral, sp.Indexed)


@dataclass(frozen=True)
class Specimen:
    """One way of computing a quantity.

    `says` is what it equals, decided by the ladder on `on`; where false, `holds_on` may say where
    it is true. `bound` is what |specimen - definition| stays below by `says`. `ordered`: it needs
    samples in order from 0 on, not single points. `note`: what else limits it, or by which
    theorem the bound holds. `source`: "ours", "form" (a way found in print or in habit) or "peer"
    (another library). `slow`: measured on a sample of the points and timed at small sizes only.
    """

    name: str
    compute: Compute
    says: Statement | None = None
    on: Part | None = None
    holds_on: Part | None = None
    bound: sp.Expr | None = None
    ordered: bool = False
    slow: bool = False
    note: str = ""
    source: str = "form"


def list_kernel(kernel: Compute, quantity: Quantity, paper: Paper) -> Iterator[Specimen]:
    """List the kernel, the same into a given array if it can, and the same in float32."""
    says, on = _state_kernel(quantity, paper)
    own = Specimen("kernel", kernel, says, on, bound=quantity.form.bound, source="ours")
    yield own
    if "out" in inspect.signature(kernel).parameters:
        yield replace(own, name="kernel, out=", compute=_into_buffer(kernel))
    yield Specimen("kernel, float32", _in_single(kernel), source="ours", note="inputs rounded too")


def _state_kernel(quantity: Quantity, paper: Paper) -> tuple[Statement | None, Part | None]:
    """Return what the ledger states of the kernel; None if the derivation bounds it instead."""
    form = quantity.form
    if form.bound is not None:
        return None, None
    rows = {row.number: row for row in (*paper.rows, *form_rows(paper))}
    row = rows.get(form.proved_by or f"kernel {quantity.name}")
    return (row.says, row.on) if row else (Equality(form.expression, quantity.definition), None)


def _into_buffer(kernel: Compute) -> Compute:
    """Call a kernel with the output array of the call before, as a loop would."""
    kept: dict[tuple[tuple[int, ...], ...], Array] = {}

    def compute(*arguments: Array) -> Any:
        key = tuple(map(np.shape, arguments))
        if key not in kept:
            kept.clear()
            kept[key] = np.asarray(kernel(*arguments))
        return kernel(*arguments, out=kept[key])

    return compute


def _in_single(kernel: Compute) -> Compute:
    return lambda *arguments: kernel(*(np.asarray(a, np.float32) for a in arguments))


def print_by_sympy(quantity: Quantity, domain: Domain) -> Iterator[Specimen]:
    """List `sympy.lambdify` of the definition (of an approximation: its form).

    Once with common subexpressions, once without. Sums and integrals have none: their array code
    is a row of a table, written by hand.
    """
    exact = quantity.definition if quantity.form.bound is None else quantity.form.expression
    definition = domain.resolve(exact)
    if definition.has(*BEYOND_LAMBDIFY):
        return
    says = Equality(definition, exact)
    for name, cse in (("sympy.lambdify", False), ("sympy.lambdify, cse", True)):
        yield Specimen(name, _lambdify(quantity, definition, cse), says, source="peer")


def _lambdify(quantity: Quantity, definition: sp.Basic, cse: bool) -> Compute:
    symbols = [s for argument in quantity.arguments for s in argument.symbols]
    counts = [len(argument.symbols) for argument in quantity.arguments]
    function = sp.lambdify(symbols, list(entries(definition)), "numpy", cse=cse)
    shape = result_shape(definition)

    def compute(*arguments: Array) -> Array:
        parts = zip(counts, map(np.asarray, arguments), strict=True)
        columns = [c for n, a in parts for c in ([a] if n == 1 else np.moveaxis(a, -1, 0))]
        results = np.broadcast_arrays(*function(*columns))
        common = results[0].shape
        return np.stack(results, axis=-1).reshape(*common, *shape) if shape else results[0]

    return compute


def result_shape(definition: sp.Basic) -> tuple[int, ...]:
    """Return the trailing axes of a result: none, (n,) for a column, (m, n) for a matrix."""
    if not isinstance(definition, sp.MatrixBase):
        return ()
    rows, columns = definition.shape
    return (rows,) if columns == 1 else (rows, columns)
