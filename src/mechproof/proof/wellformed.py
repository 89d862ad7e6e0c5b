"""Rung: can the printed side be evaluated at all? Bound symbols, differentials, dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import fields, replace
from itertools import product

import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanFunction

from mechproof.arithmetic import balls
from mechproof.proof.refutation import points_for, put_exactly
from mechproof.proof.verdict import Answer, Evidence, Verdict
from mechproof.proof.witness_text import show_point
from mechproof.record import (
    NUMBER,
    Conjunction,
    Definition,
    Dimension,
    Distinct,
    Equality,
    FunctionWithoutArgument,
    Holds,
    IntegralWithoutDifferential,
    Statement,
)
from mechproof.record.parts import find_free, find_parts, has_parts
from mechproof.statement_domains.dimension_inference import (
    DimensionError,
    Dimensions,
    infer,
    infer_common,
    rescale,
)
from mechproof.statement_domains.domain import Domain

# Name of the rung that finds terms of different dimensions added or compared.
DIMENSIONS = "dimensions"
# Factor by which units are changed, as from metres to millimetres.
UNIT_CHANGE = 1000
UNITS = tuple(field.name for field in fields(Dimension) if field.compare)
POINTS = 2


def _describe(reason: str, witness: Evidence, rung: str = "well-formedness") -> Answer:
    return Answer(Verdict.ILL_FORMED, rung, reason, (witness,))


def find_faults(
    statement: Statement, known: Dimensions, domain: Domain, mended: bool = False
) -> list[Answer]:
    """Return every fault of the printed side; none if it is well formed.

    `mended`: a correction is given, so a dimension unlike the other side's is a fault.
    """
    if isinstance(statement, Conjunction):
        parts = statement.parts
        return [fault for part in parts for fault in find_faults(part, known, domain, mended)]
    if isinstance(statement, Holds):
        fault = _find_mixture(statement.relation, statement, known, domain)
        return [fault] if fault else []
    if not isinstance(statement, Equality | Distinct | Definition):
        return []
    if isinstance(statement, Equality) and _has_two_prints(statement):
        swapped = replace(statement, printed=statement.rebuilt, rebuilt=statement.printed)
        sides = (statement, swapped)
        return next(filter(None, (_find_in_side(side, known, domain) for side in sides)), [])
    return _find_in_side(statement, known, domain, mended)


def _find_in_side(
    statement: Equality | Distinct | Definition,
    known: Dimensions,
    domain: Domain,
    mended: bool = False,
) -> list[Answer]:
    printed = statement.left if isinstance(statement, Distinct) else statement.printed
    found = (
        _find_missing_differential(printed),
        _find_missing_argument(printed),
        _find_unbound_symbol(printed, known, domain),
        _find_mixture(printed, statement, known, domain, mended),
    )
    return [fault for fault in found if fault]


def _find_missing_differential(printed: sp.Basic) -> Answer | None:
    integrals = find_parts(printed, IntegralWithoutDifferential)
    if not integrals:
        return None
    integrand = next(iter(integrals)).args[0]
    names = ", ".join(sorted(map(str, find_free(integrand))))
    what = f"no differential after the integrand {integrand}; it has the symbols {names}"
    return _describe("an integral has no differential", Evidence(what))


def _find_missing_argument(printed: sp.Basic) -> Answer | None:
    functions = find_parts(printed, FunctionWithoutArgument)
    if not functions:
        return None
    names = ", ".join(sorted(str(function.args[0]) for function in functions))
    reason = f"{names} has no argument"
    return _describe(reason, Evidence(f"nothing follows {names}"))


def _find_unbound_symbol(printed: sp.Basic, known: Dimensions, domain: Domain) -> Answer | None:
    symbols = {*known, *domain.within, *domain.given}
    declared = {getattr(s, "label", s) for s in symbols} | symbols
    functions = {node.args[0] for node in find_parts(printed, FunctionWithoutArgument)}
    indexed = find_parts(printed, sp.Indexed)
    unbound = sorted(map(str, find_free(printed) - indexed - declared - functions))
    if not unbound:
        return None
    names = ", ".join(unbound)
    witness = Evidence(f"free in the printed form: {names}")
    reason = f"{names} has no value there: neither bound by a sum nor a quantity of the paper"
    return _describe(reason, witness)


def _find_mixture(
    printed: sp.Basic, statement: Statement, known: Dimensions, domain: Domain, mended: bool = False
) -> Answer | None:
    """Find terms of unlike dimension; they are a fault only if a change of units shows it."""
    if has_parts(printed, IntegralWithoutDifferential, FunctionWithoutArgument):
        return None
    other = _other_side(statement)
    compared = mended or isinstance(statement, Definition) or _has_two_prints(statement)
    try:
        infer_common((printed, other) if compared else (printed,), known)
    except DimensionError as error:
        witness = next(_changes_of_units(domain.resolve(printed), other, known, domain), None)
        return _describe(str(error), witness, DIMENSIONS) if witness else None
    return None


def _has_two_prints(statement: Statement) -> bool:
    return isinstance(statement, Equality) and statement.rebuilt_from == "member"


def _other_side(statement: Statement) -> sp.Basic:
    """Return the side that the printed one is compared with, zero for a relation."""
    if isinstance(statement, Definition):
        return statement.symbol
    if isinstance(statement, Distinct):
        return statement.right
    return statement.rebuilt if isinstance(statement, Equality) else sp.S.Zero


def _dimension(expression: sp.Basic, known: Dimensions) -> Dimension:
    """Return the dimension of a side, or that of a number if the side mixes dimensions."""
    with suppress(DimensionError):
        return infer(expression, known) or NUMBER
    return NUMBER


def _changes_of_units(
    printed: sp.Basic, other: sp.Basic, known: Dimensions, domain: Domain
) -> Iterator[Evidence]:
    """Yield evidence of printed values that change if computed in another unit, then converted."""
    for unit in UNITS:
        pairs = [(term, rescale(term, known, unit, UNIT_CHANGE)) for term in _terms(printed)]
        power = getattr(_dimension(other, known), unit)
        back = balls.to_ball(UNIT_CHANGE) ** balls.to_ball(power)
        with suppress(NotImplementedError):
            points = points_for((printed,), domain, POINTS, thorough=True)
            for point, pair in product(points, pairs):
                before, after = (balls.evaluate(put_exactly(e, point), point) for e in pair)
                values = [before, after / back]
                if all(v.is_finite() for v in values) and not values[0].overlaps(values[1]):
                    yield _show_change(unit, show_point(point, domain), values)


def _terms(printed: sp.Basic) -> list[sp.Expr]:
    """List the scalars of a print: an expression, a matrix's entries, the gaps of relations."""
    if isinstance(printed, sp.MatrixBase):
        return list(printed.flat())
    if isinstance(printed, Relational | BooleanFunction):
        relations = sorted(printed.atoms(Relational), key=str)
        return [relation.lhs - relation.rhs for relation in relations]
    return [printed]


def _show_change(unit: str, at: dict[str, str], values: list[balls.Ball]) -> Evidence:
    what = (
        f"printed form: first in one unit of {unit}, then in a unit {UNIT_CHANGE} times smaller, "
        "converted back"
    )
    return Evidence(what, at, *balls.show_apart(*values))
