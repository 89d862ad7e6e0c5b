"""Ways: every way of computing a quantity, as a function, with the rows that judge it."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from mechproof.measured import Kind
from mechproof.programs.evaluation import entries, result_shape
from mechproof.programs.kernel import name_rival
from mechproof.record import Peer, Quantity, Row
from mechproof.record.implicit import Implicit
from mechproof.record.quantities import KERNEL
from mechproof.statement_domains.domain import Domain

Array = NDArray[Any]
Arguments = tuple[Array, ...]
Compute = Callable[..., Any]

# Name of the extra that compiled kernels need.
COMPILED = "fast"
# Expressions that SymPy's NumPy printer has no array code for.
BEYOND_LAMBDIFY = (sp.Sum, sp.Integral, sp.Indexed, Implicit)


@dataclass(frozen=True)
class Way:
    """One way of computing a quantity: the kernel, a form or a peer.

    `rows` of the ledger say what its source computes; a peer has none, as nothing is proved of it.
    `key` ends the name of its function, "" for the kernel and for peers; `needs` is the extra that
    it is installed with. `into_buffer` marks a variant that writes into an existing array. `place`
    moves an argument to where the way computes, before it is timed.
    """

    name: str
    compute: Compute
    kind: Kind
    rows: tuple[Row, ...] = ()
    bound: sp.Expr | None = None
    ordered: bool = False
    slow: bool = False
    key: str = ""
    needs: str = ""
    note: str = ""
    into_buffer: bool = False
    place: Callable[[Any], Any] | None = None


def list_ways(
    quantity: Quantity,
    domain: Domain,
    rows: Iterable[Row],
    modules: tuple[ModuleType | None, ...],
    peers: tuple[Peer, ...],
    sources: Iterable[Way] = (),
) -> tuple[Way, ...]:
    """Return the kernel, its rival forms, peers, and code by SymPy; the shipped way comes first.

    `modules` are those of the kernels, of their rival forms and of the compiled kernels; `sources`
    are the kernel in other languages.
    """
    rows = tuple(rows)
    ours = [peer for peer in peers if peer.ours]
    others = [peer for peer in peers if not peer.ours]
    kernels, forms, compiled = modules
    found = [*_list_kernel(quantity, kernels, rows), *_list_compiled(quantity, compiled, rows)]
    if found:
        found += sources
    found += map(_from_peer, ours)
    found += _list_rivals(quantity, forms, rows)
    return (*found, *map(_from_peer, others), *print_by_sympy(quantity, domain))


def _list_kernel(
    quantity: Quantity, module: ModuleType | None, rows: tuple[Row, ...]
) -> Iterator[Way]:
    """Yield the kernel, its variant with an output array, and its variant in float32."""
    if not quantity.forms or module is None:
        return
    kernel: Compute = getattr(module, quantity.name)
    yield from _list_with_buffer(_describe_kernel("kernel", kernel, quantity, rows))
    yield Way("kernel, float32", _in_single(kernel), "peer", note="inputs rounded too")


def _list_compiled(
    quantity: Quantity, module: ModuleType | None, rows: tuple[Row, ...]
) -> Iterator[Way]:
    """Yield the compiled kernel, whose source is read back like that of the kernel."""
    kernel: Compute | None = getattr(module, quantity.name, None)
    if kernel is not None:
        way = _describe_kernel("kernel, compiled", kernel, quantity, rows)
        yield from _list_with_buffer(replace(way, needs=COMPILED, note="threads for long arrays"))


def _describe_kernel(name: str, compute: Compute, quantity: Quantity, rows: tuple[Row, ...]) -> Way:
    return Way(name, compute, "kernel", _rows_of(quantity.name, rows), quantity.shipped[-1].bound)


def _list_with_buffer(way: Way) -> Iterator[Way]:
    yield way
    if "out" in inspect.signature(way.compute).parameters:
        compute = _into_buffer(way.compute)
        yield replace(way, name=f"{way.name}, out=", compute=compute, into_buffer=True)


def _list_rivals(
    quantity: Quantity, module: ModuleType | None, rows: tuple[Row, ...]
) -> Iterator[Way]:
    for form in quantity.rivals if module is not None else ():
        name = name_rival(quantity, form)
        compute = getattr(module, name)
        decided = _rows_of(name, rows)
        yield Way(form.name, compute, "form", decided, form.bound, key=form.key, note=form.note)


def _from_peer(peer: Peer) -> Way:
    return Way(
        peer.name,
        peer.compute,
        "peer",
        ordered=peer.ordered,
        slow=peer.slow,
        note=peer.note,
        needs=peer.needs,
    )


def _rows_of(name: str, rows: tuple[Row, ...]) -> tuple[Row, ...]:
    """Return the rows of the ledger about a function."""
    wanted = f"{KERNEL}{name}"
    return tuple(r for r in rows if r.number == wanted or r.number.startswith(f"{wanted}, "))


def _into_buffer(kernel: Compute) -> Compute:
    """Return a kernel that reuses the output array of its last call, as a loop would."""
    kept: dict[tuple[tuple[int, ...], ...], Array] = {}

    def compute(*arguments: Array) -> Any:
        # `getattr`, because asking NumPy for the shape of a number is too slow compared with a
        # call on few points.
        key = tuple([getattr(a, "shape", ()) for a in arguments])
        if key not in kept:
            kept.clear()
            kept[key] = np.asarray(kernel(*arguments))
        return kernel(*arguments, out=kept[key])

    return compute


def _in_single(kernel: Compute) -> Compute:
    return lambda *arguments: kernel(*(np.asarray(a, np.float32) for a in arguments))


def print_by_sympy(quantity: Quantity, domain: Domain) -> Iterator[Way]:
    """Yield `sympy.lambdify` of the definition, with and without common subexpressions.

    There is none for sums, integrals and roots: SymPy has no array code for them.
    """
    definition = domain.resolve(quantity.definition)
    if definition.has(*BEYOND_LAMBDIFY):
        return
    for name, cse in (("sympy.lambdify", False), ("sympy.lambdify, cse", True)):
        yield Way(name, _lambdify(quantity, definition, cse), "peer")


def _lambdify(quantity: Quantity, definition: sp.Basic, cse: bool) -> Compute:
    function = sp.lambdify(quantity.symbols, list(entries(definition)), "numpy", cse=cse)
    shape = result_shape(definition)

    def compute(*arguments: Array) -> Array:
        results = np.broadcast_arrays(*function(*list_columns(quantity, arguments)))
        common = results[0].shape
        return np.stack(results, axis=-1).reshape(*common, *shape) if shape else results[0]

    return compute


def list_columns(quantity: Quantity, arguments: Arguments) -> list[Array]:
    """Return the values of each symbol: for a vector, its components from the last axis."""
    counts = [len(argument.symbols) for argument in quantity.arguments]
    parts = zip(counts, map(np.asarray, arguments), strict=True)
    return [c for n, a in parts for c in ([a] if n == 1 else np.moveaxis(a, -1, 0))]
