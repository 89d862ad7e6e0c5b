"""Subjects: a quantity, the point sets it is measured on, and the ways of computing it.

Quantities are found in the derivations, kernels by their names. A module of
`mechproof.lab.specimens` adds rows: a `Table` for each of its systems or statistics. A quantity
without rows is still measured: its kernel and what SymPy prints, on points of its domain.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from importlib import import_module
from types import MappingProxyType
from typing import Literal

import numpy as np
import sympy as sp

from mechproof.derivation import load_directory, packaged_directory
from mechproof.lab.specimen import (
    Arguments,
    Array,
    Compute,
    Specimen,
    list_kernel,
    print_by_sympy,
)
from mechproof.proof.domain import Domain
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement
from mechproof.record import Claim, Paper, Quantity, Variable

Box = Mapping[str, tuple[float, float]]


@dataclass(frozen=True)
class PointSet:
    """Named points: `make` draws the arguments, in the order of the quantity's arguments.

    The leading axis runs over the points; an argument of fewer axes is shared by all of them.
    `ordered`: the first argument rises from 0 in even steps, all others are shared. `halved`: the
    points are one sequence, of which every seed takes its half.
    """

    name: str
    make: Callable[[np.random.Generator], Arguments]
    ordered: bool = False
    halved: bool = False


@dataclass(frozen=True)
class Cells:
    """Edges that split the size of an argument; errors are kept for every box between them."""

    argument: str
    edges: tuple[float, ...]


@dataclass(frozen=True)
class Map:
    """A map of lost bits: a grid of arguments (rows times columns, flat) and its two axes.

    The worst along the other axis is drawn `against` one of them.
    """

    name: str
    make: Callable[[int], tuple[Arguments, Array, Array]]
    across: str
    upward: str
    forms: tuple[str, ...]
    against: Literal["across", "upward"] = "upward"


@dataclass(frozen=True)
class Study:
    """The rows of one quantity: specimens, points, and how the error is to be read.

    `within` marks the points at which the bar of the kernel holds (None: all). `period` is the
    spacing of wrong branches. `cells` and `in_cell` (points of one box) are what `choose` decides
    from. `workloads` make the arguments of timed calls with N points; `typical` names the point
    set nearest to them, if one is.
    """

    specimens: tuple[Specimen, ...] = ()
    sets: tuple[PointSet, ...] = ()
    cells: tuple[Cells, ...] = ()
    in_cell: Callable[[np.random.Generator, Box], Arguments] | None = None
    within: Callable[..., Array] | None = None
    period: float | None = None
    workloads: tuple[tuple[str, Callable[[int], Arguments]], ...] = ()
    maps: tuple[Map, ...] = ()
    typical: str | None = None


@dataclass(frozen=True)
class Table:
    """What a module of specimens binds to the name TABLE."""

    studies: Mapping[str, Study]
    variables: tuple[Variable, ...] = ()
    paper: Paper | None = None
    kernels: Mapping[str, Compute] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True)
class Subject:
    """A quantity with its paper, its kernel and its rows."""

    paper: Paper
    quantity: Quantity
    kernel: Compute
    study: Study

    @property
    def name(self) -> str:
        """Return system.quantity."""
        return f"{self.paper.system}.{self.quantity.name}"

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
        """Write the definition out, whose value is the truth; of an approximation its form.

        An approximation's own rounding is what its bar is about.
        """
        form = self.quantity.form
        whole = self.quantity.definition if form.bound is None else form.expression
        return self.domain.resolve(whole)

    @cached_property
    def form(self) -> sp.Basic:
        """Write the form out, which equals the truth and may spare it a cancellation."""
        return self.domain.resolve(self.quantity.form.expression)

    @cached_property
    def specimens(self) -> tuple[Specimen, ...]:
        """List ours first, then the rows of the table, then what SymPy prints."""
        own = list_kernel(self.kernel, self.quantity, self.paper)
        return (*own, *self.study.specimens, *print_by_sympy(self.quantity, self.domain))


def find_subjects(names: tuple[str, ...] = ()) -> tuple[Subject, ...]:
    """Find the subjects with these names (system, quantity or system.quantity); all without.

    Raises ValueError naming a name that fits none, with those that there are.
    """
    subjects = _all_subjects()
    for name in names:
        if not any(_fits(subject, name) for subject in subjects):
            known = ", ".join(subject.name for subject in subjects)
            raise ValueError(f"quantity {name!r} is not one of {known}")
    return tuple(s for s in subjects if not names or any(_fits(s, name) for name in names))


def judge_specimen(subject: Subject, specimen: Specimen) -> Judgement | None:
    """Decide by the ladder what a specimen equals; None for a row that asserts nothing."""
    if specimen.says is None:
        return None
    number = f"{subject.name}, {specimen.name}"
    row = Claim(number, "", specimen.says, on=specimen.on, holds_on=specimen.holds_on)
    return judge(row, subject.paper)


def _fits(subject: Subject, name: str) -> bool:
    return name in (subject.name, subject.paper.system, subject.quantity.name)


@lru_cache(maxsize=1)
def _all_subjects() -> tuple[Subject, ...]:
    papers = {paper.system: paper for paper in load_directory(packaged_directory())}
    tables = dict(_find_tables())
    papers |= {name: table.paper for name, table in tables.items() if table.paper}
    return tuple(
        subject
        for name, paper in sorted(papers.items())
        for subject in _subjects_of(paper, tables.get(name, Table({})))
    )


def _find_tables() -> Iterator[tuple[str, Table]]:
    package = import_module("mechproof.lab.specimens")
    for module in sorted(info.name for info in pkgutil.iter_modules(package.__path__)):
        table = getattr(import_module(f"{package.__name__}.{module}"), "TABLE", None)
        if isinstance(table, Table):
            yield module, table


def _subjects_of(paper: Paper, table: Table) -> Iterator[Subject]:
    """Pair the shipped quantities of a paper with their rows; a row without a quantity raises."""
    shipped = [q for q in paper.quantities if not q.specimen]
    if surplus := sorted(set(table.studies) - {q.name for q in shipped}):
        raise ValueError(f"specimens of {paper.system}: no quantities {surplus}")
    extended = replace(paper, variables=paper.variables + table.variables)
    for quantity in shipped:
        kernel = table.kernels.get(quantity.name) or _find_kernel(paper.system, quantity.name)
        study = table.studies.get(quantity.name, Study())
        yield Subject(extended, quantity, kernel, study)


def _find_kernel(system: str, name: str) -> Compute:
    kernel: Compute = getattr(import_module(f"mechproof.kernels.{system}"), name)
    return kernel
