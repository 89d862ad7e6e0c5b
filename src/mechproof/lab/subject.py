"""Subjects: a quantity with its paper, every way of computing it, and where it is measured.

All of it comes from the derivation: quantities with their forms, peers from the module `peers`
beside them, point sets from singular sets, usual and published sizes. A module `points` may add
sets that cannot be said by equations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache, partial
from importlib.util import find_spec
from pathlib import Path
from pickle import PicklingError
from types import ModuleType
from typing import Any

import numpy as np
import sympy as sp

from mechproof import derivation
from mechproof.codegen.form_rows import form_rows
from mechproof.lab.c_kernels import find_gpu, find_in_c, find_on_gpu
from mechproof.lab.sampling.named_sets import PointSet
from mechproof.lab.sampling.stated_sizes import Facts
from mechproof.lab.sampling.usual_sizes import Sides
from mechproof.lab.ways import Arguments, Compute, Way, list_ways
from mechproof.measured import IN_C, ON_GPU, goes_by
from mechproof.record import Paper, Peer, Quantity, Row
from mechproof.statement_domains.domain import Domain


@dataclass(frozen=True)
class ByHand:
    """What a module `points` states of a quantity where no equation can.

    Its point sets, how points of one cell are drawn, and timed calls with so many points.
    """

    sets: tuple[PointSet, ...] = ()
    in_cell: Callable[[np.random.Generator, Sides], Arguments] | None = None
    workloads: Mapping[str, Callable[[int], Arguments]] = field(default_factory=dict)

    @classmethod
    def of(cls, module: ModuleType | None, quantity: str) -> ByHand:
        """Read what the module says of a quantity in POINTS, IN_CELL and WORKLOADS."""
        drawn = getattr(module, "POINTS", {}).get(quantity, {})
        return cls(
            tuple(PointSet(name, make) for name, make in drawn.items()),
            getattr(module, "IN_CELL", {}).get(quantity),
            getattr(module, "WORKLOADS", {}).get(quantity, {}),
        )


@dataclass(frozen=True, repr=False, eq=False)
class Subject:
    """A quantity with its paper, the ledger's rows of its forms, its code and its peers."""

    paper: Paper
    quantity: Quantity
    list_rows: Callable[[], tuple[Row, ...]]
    modules: tuple[ModuleType | None, ModuleType | None]
    peers: tuple[Peer, ...] = ()
    by_hand: ByHand = field(default_factory=ByHand)
    # Compiled kernels are imported only for those who ask for all ways.
    load_compiled: Callable[[], ModuleType | None] = lambda: None
    # The folders of the derivation and of its generated modules.
    origin: tuple[Path, Path | None] | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        """Send where the subject is found: modules and functions cannot be sent."""
        if not self.origin or not any(s is self for s in _subjects_at(*self.origin)):
            raise PicklingError(f"{self!r} was not found by find_subjects")
        return _find_again, (*self.origin, self.quantity.name)

    def __repr__(self) -> str:
        # The name alone: the expressions of a paper would take minutes to write out.
        return f"Subject({self.name})"

    @property
    def name(self) -> str:
        """Return system.quantity."""
        return f"{self.paper.system}.{self.quantity.name}"

    @property
    def folder(self) -> Path | None:
        """Return the folder of the derivation, unless it belongs to the package."""
        return self.origin[0].parent if self.origin and self.origin[1] else None

    @cached_property
    def domain(self) -> Domain:
        """Return where the kernel is defined: ends that the proofs leave out may belong to it."""
        whole, part = Domain.of(self.paper), self.quantity.on
        if part is None:
            return whole
        given = {s: value for s, value in whole.given.items() if s not in part.within}
        where = tuple(map(whole.resolve, part.where))
        return Domain({**whole.within, **part.within}, whole.where + where, given)

    @cached_property
    def exact(self) -> sp.Basic:
        """Write the definition out, whose value is the truth."""
        return self.domain.resolve(self.quantity.definition)

    @cached_property
    def equal_forms(self) -> tuple[sp.Basic, ...]:
        """Write out the shipped forms, which equal the truth and may spare it a cancellation."""
        forms = (f for f in self.quantity.shipped if f.bound is None)
        return tuple(self.domain.resolve(form.expression) for form in forms)

    @cached_property
    def ways(self) -> tuple[Way, ...]:
        """List every way of computing the quantity, the shipped one first."""
        modules = (*self.modules, self.load_compiled())
        rows, sources = self.list_rows(), self._list_sources()
        return list_ways(self.quantity, self.domain, rows, modules, self.peers, sources)

    def _list_sources(self) -> Iterator[Way]:
        """List the kernel in C, called here and on a GPU, as far as there is what it needs."""
        asked = self.quantity.name, self.paper
        if in_c := find_in_c(*asked):
            yield Way(IN_C, in_c, "source", note="called by ctypes, in one thread")
        if on_gpu := find_on_gpu(*asked):
            note = f"the source in C on {find_gpu()}; timed with arrays that lie there"
            yield Way(ON_GPU, on_gpu, "source", note=note, place=on_gpu.place)

    @property
    def shipped(self) -> tuple[Way, ...]:
        """List the ways that are called by others: the first, and the compiled kernel."""
        first, *others = self.ways
        return (first, *(w for w in others if w.kind == "kernel" and not w.into_buffer))

    @property
    def kernel(self) -> Compute:
        """Return the function that is shipped."""
        module = self.modules[0]
        own: Compute | None = getattr(module, self.quantity.name, None)
        return own or self.ways[0].compute

    @cached_property
    def facts(self) -> Facts:
        """Return the facts that points are made from."""
        quantity = self.quantity
        return Facts(quantity.arguments, self.domain, quantity.singular, self.paper.published)

    @cached_property
    def period(self) -> float | None:
        """Return the spacing of wrong branches."""
        return None if self.quantity.period is None else float(self.quantity.period)


def find_subjects(
    names: tuple[str, ...] = (), directory: Path | None = None
) -> tuple[Subject, ...]:
    """Find the subjects with these names (system, quantity or system.quantity); all without.

    `directory` holds the derivations, by default those of the package; their kernels lie in the
    folder `generated` beside it. Raises ValueError naming a name that fits none.
    """
    source = directory or derivation.packaged_directory()
    generated = None if directory is None else directory.resolve().parent / "generated"
    places = derivation.find_systems(source)
    # A name that begins with a system spares loading the others.
    systems = {name.partition(".")[0] for name in names}
    needed = [p for s, p in places.items() if not names or s in systems or systems - places.keys()]
    subjects = [s for place in needed for s in _subjects_at(place, generated)]
    for name in names:
        if not any(goes_by(subject.name, name) for subject in subjects):
            known = ", ".join(subject.name for subject in subjects)
            reason = f"is not one of {known}" if known else "is not there: no quantity is stated"
            raise ValueError(f"quantity {name!r} {reason}")
    return tuple(s for s in subjects if not names or any(goes_by(s.name, name) for name in names))


@lru_cache(maxsize=16)
def _subjects_at(place: Path, generated: Path | None) -> tuple[Subject, ...]:
    return tuple(make_subjects(derivation.load_paper(place), place, generated))


def _find_again(place: Path, generated: Path | None, name: str) -> Subject:
    (subject,) = (s for s in _subjects_at(place, generated) if s.quantity.name == name)
    return subject


def make_subjects(paper: Paper, place: Path, generated: Path | None) -> Iterator[Subject]:
    """Pair the quantities of a paper with their code, in `generated` or in the package.

    Peers or points for no quantity raise ValueError.
    """
    # Stating the rows of all forms takes longer than a run of one kernel, which needs none.
    list_rows = cache(partial(form_rows, paper))
    peers: Mapping[str, tuple[Peer, ...]] = getattr(
        derivation.load_part(place, "peers"), "PEERS", {}
    )
    points = derivation.load_part(place, "points")
    names = {quantity.name for quantity in paper.quantities}
    if surplus := sorted({*peers, *getattr(points, "POINTS", {})} - names):
        raise ValueError(f"peers and points of {paper.system}: no quantities {surplus}")
    modules = (
        derivation.load_kernels(paper.system, generated),
        derivation.load_kernels(f"forms.{paper.system}", generated),
    )
    load_compiled = cache(partial(_load_compiled, paper.system, generated))
    for quantity in paper.quantities:
        yield Subject(
            paper,
            quantity,
            list_rows,
            modules,
            peers.get(quantity.name, ()),
            ByHand.of(points, quantity.name),
            load_compiled,
            (place, generated),
        )


def _load_compiled(system: str, generated: Path | None) -> ModuleType | None:
    """Import compiled kernels where numba is installed."""
    return derivation.load_kernels(f"compiled.{system}", generated) if find_spec("numba") else None
