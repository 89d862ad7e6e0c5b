"""Requests: in, a name and numbers; out, a quantity of one variable and its range, all checked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from mechproof.arguments.scalars import check_items, check_real, refuse, require
from mechproof.arithmetic.balls import Ball
from mechproof.arithmetic.series import TaylorExpression, working
from mechproof.derivation import (
    check_folder,
    find_systems,
    load_kernels,
    load_packaged,
    load_paper,
    packaged_directory,
)
from mechproof.mechanisms.parameters import check_domain
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Answer, Verdict
from mechproof.record import Equality, Paper, Periodicity, Quantity, Root
from mechproof.record.substitution import resolve, write_sums_out
from mechproof.statement_domains.domain import Domain
from mechproof.tailoring.design import Array
from mechproof.tailoring.enclosure import Repetition

# Working precision of a period.
BITS = 512
# Number of points in the range at which edges are sought.
POINTS = 512
CLOSER = 60


@dataclass(frozen=True)
class Request:
    """A quantity at fixed parameters, and the range of its variable (None: as long as possible).

    `module` has the shipped kernels; `folder` is that of the derivation, unless it is the
    package's.
    """

    paper: Paper
    quantity: Quantity
    values: Mapping[str, float]
    error: float
    ends: tuple[float, float] | None
    module: ModuleType
    folder: Path | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the arguments of the request, as the functions in a paper cannot be pickled."""
        ends = {} if self.ends is None else {self.variable: self.ends}
        return read_request, (self.name, self.error, {**self.values, **ends}, self.folder)

    @property
    def name(self) -> str:
        """Return the name system.quantity."""
        return f"{self.paper.system}.{self.quantity.name}"

    @property
    def variable(self) -> str:
        """Return the name of the running variable."""
        return self.quantity.arguments[0].name

    def define(self, expression: sp.Basic) -> TaylorExpression:
        """Return an expression as a function of the running variable.

        Raises ValueError if it contains a function without a series.
        """
        first, *others = self.quantity.arguments
        numbers = {a.symbols[0]: self.values[a.name] for a in others}
        plain = write_sums_out(expression)
        try:
            return TaylorExpression(plain, first.symbols[0], self.paper.given, numbers)
        except NotImplementedError as missing:
            refuse("name", self.name, f"{missing}: cannot be tailored; call its kernel")

    def kernel(self, points: Array) -> Array:
        """Return values of the shipped kernel, NaN where it is undefined."""
        with np.errstate(all="ignore"):
            found: Array = getattr(self.module, self.quantity.name)(points, **self.values)
        return found

    def repetition(self) -> Repetition | None:
        """Return the period and the gain over it; None for a quantity without one."""
        repeats = self.quantity.periodicity
        if repeats is None:
            return None
        with working(1, BITS):
            period, gain = (self._number(e) for e in (repeats.period, repeats.gain))
            return Repetition(period, gain / period)

    def _number(self, expression: sp.Basic) -> Ball:
        return self.define(sp.sympify(expression)).value()

    def corners(self, low: float, high: float) -> tuple[float, ...]:
        """Return the quantity's singular points between the ends, in ascending order."""
        found: set[float] = set()
        for singular in self.quantity.singular:
            try:
                definition = self.define(singular.equation.lhs - singular.equation.rhs)
            except KeyError:
                # One set for each whole number: a periodic quantity is reduced to one period.
                continue
            if definition.is_moving:
                found.update(_find_zeros(definition, low, high))
        return tuple(sorted(found))


def _find_zeros(definition: TaylorExpression, low: float, high: float) -> list[float]:
    """Return the places between the ends where a function changes sign."""
    points = np.linspace(low, high, POINTS + 1).tolist()
    signs = [_sign(definition, point) for point in points]
    return [
        _close_in(definition, points[i], points[i + 1], signs[i])
        for i in range(POINTS)
        if signs[i] * signs[i + 1] < 0
    ]


def _sign(definition: TaylorExpression, point: float) -> int:
    value = definition.value(arb(point))
    return int(value > 0) - int(value < 0)


def _close_in(definition: TaylorExpression, low: float, high: float, sign: int) -> float:
    for _ in range(CLOSER):
        middle = low + (high - low) / 2
        if _sign(definition, middle) == sign:
            low = middle
        else:
            high = middle
    return high


def read_request(
    name: Any, error: Any, arguments: Mapping[str, Any], derivations: Any = None
) -> Request:
    """Return the request of checked arguments.

    Raises TypeError or ValueError with the text "name = value: what is allowed".
    """
    folder = None if derivations is None else check_folder(derivations)
    paper, quantity = _find_quantity(name, folder)
    error = check_real("error", error)
    require(error > 0, "error", error, "must be positive")
    names = [a.name for a in quantity.arguments]
    for given, value in arguments.items():
        require(given in names, given, value, f"{name} has no such argument: {', '.join(names)}")
    first, *others = quantity.arguments
    values = {a.name: _read_size(name, a.name, a.default, arguments) for a in others}
    generated = None if folder is None else folder.parent / "generated"
    module = load_kernels(paper.system, generated)
    if module is None:
        none = f"{generated} has no kernels of {paper.system}: `mechproof regenerate` writes them"
        refuse("derivations", derivations, none)
    # A module without DOMAIN has kernels that are defined everywhere.
    conditions = [c for c in vars(module).get("DOMAIN", ()) if quantity.name in c.quantities]
    check_domain(conditions, values)
    ends = _read_range(first.name, arguments[first.name]) if first.name in arguments else None
    if ends is None and quantity.periodicity is None:
        refuse(first.name, None, "the range must be given, a pair (lowest, highest)")
    if quantity.periodicity is not None:
        _check_periodicity(name, paper, quantity, quantity.periodicity)
    # Read-only, as all copies of an unpickled kernel share it.
    return Request(paper, quantity, MappingProxyType(values), error, ends, module, folder)


def _check_periodicity(name: str, paper: Paper, quantity: Quantity, repeats: Periodicity) -> None:
    """Raise ValueError unless the quantity is proved to repeat as its derivation says."""
    answer = prove_periodicity(paper, quantity, repeats)
    if answer.verdict is not Verdict.PROVED:
        reason = f"its period {repeats.period} is {answer.verdict}: {answer.reason}"
        refuse("name", name, reason)


def prove_periodicity(paper: Paper, quantity: Quantity, repeats: Periodicity) -> Answer:
    """Decide whether the value rises by the gain over each period, everywhere in its domain."""
    (running,) = quantity.arguments[0].symbols
    here = sp.sympify(resolve(quantity.definition, paper.given))
    there = here.subs(running, running + repeats.period)
    return decide(Equality(there - here, repeats.gain), Domain.of(paper, quantity.on))


def _read_size(
    quantity: str, name: str, default: float | None, arguments: Mapping[str, Any]
) -> float:
    if name not in arguments and default is not None:
        return default
    require(name in arguments, name, None, f"must be given: {quantity} is tailored to it")
    return check_real(name, arguments[name])


def _read_range(name: str, value: Any) -> tuple[float, float]:
    low, high = check_items(name, value, 2, "must be a pair (lowest, highest)")
    ends = check_real(f"{name}[0]", low), check_real(f"{name}[1]", high)
    require(ends[0] < ends[1], name, value, "the lowest must be below the highest")
    return ends


def _find_quantity(name: Any, folder: Path | None) -> tuple[Paper, Quantity]:
    """Find a quantity by system.quantity, in the package or in a folder of derivations."""
    require(isinstance(name, str), "name", name, "must be a string, system.quantity", TypeError)
    system, _, wanted = name.partition(".")
    systems = find_systems(folder or packaged_directory())
    if system not in systems:
        others = "" if folder else "; for papers of your own, give derivations=FOLDER"
        refuse("name", name, f"the system must be one of {', '.join(systems)}{others}")
    paper = load_paper(systems[system]) if folder else load_packaged(system)
    possible = {q.name: q for q in paper.quantities if q.forms and q.is_scalar}
    if wanted not in possible:
        allowed = f"must be one of {', '.join(possible)}" if possible else "cannot be tailored"
        refuse("name", name, f"the quantity of {system} {allowed}")
    if resolve(possible[wanted].definition, paper.given).has(Root):
        refuse("name", name, "a root of an equation cannot be tailored; call its kernel")
    return paper, possible[wanted]
