"""Subjects: a quantity with its paper, every way of computing it, and where it is measured.

All of it comes from the derivation: quantities with their forms, peers from the module `peers` next
to it, point sets from singular sets, usual and published sizes. A module `points` may add sets that
equations cannot describe.
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
    """The parts of a quantity's measurement that a module `points` states by hand.

    They are its point sets, how points of one cell are drawn, and timed calls with N points.
    """

    sets: tuple[PointSet, ...] = ()
    in_cell: Callable[[np.random.Generator, Sides], Arguments] | None = None
    workloads: Mapping[str, Callable[[int], Arguments]] = field(default_factory=dict)

    @classmethod
    def of(cls, module: ModuleType | None, quantity: str) -> ByHand:
        """Read the module's POINTS, IN_CELL and WORKLOADS for a quantity."""
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
    # Compiled kernels are imported only if all ways are needed.
    load_compiled: Callable[[], ModuleType | None] = lambda: None
    # The folders of the derivation and of its generated modules.
    origin: tuple[Path, Path | None] | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle where the subject is found: its modules and functions cannot be pickled."""
        if not self.origin or not any(s is self for s in _subjects_at(*self.origin)):
            raise PicklingError(f"{self!r} was not found by find_subjects")
        return _find_again, (*self.origin, self.quantity.name)

    def __repr__(self) -> str:
        # Only the name: the expressions of a paper would take minutes to write out.
        return f"Subject({self.name})"

    @property
    def name(self) -> str:
        """Return system.quantity."""
        return f"{self.paper.system}.{self.quantity.name}"

    @property
    def folder(self) -> Path | None:
        """Return the folder of the derivation, or None if it belongs to the package."""
        return self.origin[0].parent if self.origin and self.origin[1] else None

    @cached_property
    def domain(self) -> Domain:
        """Return the kernel's domain, which may include ends that the proofs leave out."""
        whole, part = Domain.of(self.paper), self.quantity.on
        if part is None:
            return whole
        given = {s: value for s, value in whole.given.items() if s not in part.within}
        where = tuple(map(whole.resolve, part.where))
        return Domain({**whole.within, **part.within}, whole.where + where, given)

    @cached_property
    def exact(self) -> sp.Basic:
        """Return the definition with all given symbols resolved; its value is the truth."""
        return self.domain.resolve(self.quantity.definition)

    @cached_property
    def equal_forms(self) -> tuple[sp.Basic, ...]:
        """Return the shipped forms, resolved: they equal the truth and may avoid a cancellation."""
        forms = (f for f in self.quantity.shipped if f.bound is None)
        return tuple(self.domain.resolve(form.expression) for form in forms)

    @cached_property
    def ways(self) -> tuple[Way, ...]:
        """Return every way of computing the quantity, the shipped one first."""
        modules = (*self.modules, self.load_compiled())
        rows, sources = self.list_rows(), self._list_sources()
        return list_ways(self.quantity, self.domain, rows, modules, self.peers, sources)

    def _list_sources(self) -> Iterator[Way]:
        """Yield the kernel in C, called here and on a GPU, if the machine has what they need."""
        asked = self.quantity.name, self.paper
        if in_c := find_in_c(*asked):
            yield Way(IN_C, in_c, "source", note="called by ctypes, in one thread")
        if on_gpu := find_on_gpu(*asked):
            note = f"the source in C on {find_gpu()}; timed with arrays that lie there"
            yield Way(ON_GPU, on_gpu, "source", note=note, place=on_gpu.place)

    @property
    def shipped(self) -> tuple[Way, ...]:
        """Return the ways that users call: the first, and the compiled kernel."""
        first, *others = self.ways
        return (first, *(w for w in others if w.kind == "kernel" and not w.into_buffer))

    @property
    def kernel(self) -> Compute:
        """Return the shipped function."""
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
        """Return the spacing of wrong branches, or None without branches."""
        return None if self.quantity.period is None else float(self.quantity.period)


def find_subjects(
    names: tuple[str, ...] = (), directory: Path | None = None
) -> tuple[Subject, ...]:
    """Find the subjects with these names (system, quantity or system.quantity), or all subjects.

    `directory` holds the derivations, by default those of the package; their kernels are in the
    folder `generated` next to it. Raises ValueError for a name that fits no subject.
    """
    source = directory or derivation.packaged_directory()
    generated = None if directory is None else directory.resolve().parent / "generated"
    places = derivation.find_systems(source)
    # If every name begins with a system, the other systems need not be loaded.
    systems = {name.partition(".")[0] for name in names}
    needed = [p for s, p in places.items() if not names or s in systems or systems - places.keys()]
    subjects = [s for place in needed for s in _subjects_at(place, generated)]
    for name in names:
        if not any(goes_by(subject.name, name) for subject in subjects):
            known = ", ".join(subject.name for subject in subjects)
            reason = f"is not one of {known}" if known else "does not exist: no quantity is stated"
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

    Raises ValueError for peers or points of a quantity that does not exist.
    """
    # Stating the rows of all forms takes longer than running one kernel, which needs none.
    list_rows = cache(partial(form_rows, paper))
    peers: Mapping[str, tuple[Peer, ...]] = getattr(
        derivation.load_part(place, "peers"), "PEERS", {}
    )
    points = derivation.load_part(place, "points")
    names = {quantity.name for quantity in paper.quantities}
    if surplus := sorted({*peers, *getattr(points, "POINTS", {})} - names):
        raise ValueError(f"peers and points of {paper.system}: unknown quantities {surplus}")
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
    """Import compiled kernels if numba is installed."""
    return derivation.load_kernels(f"compiled.{system}", generated) if find_spec("numba") else None
