"""Rung: can the printed side be evaluated at all? Bound symbols, differentials, dimensions."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from mechproof.proof import balls
from mechproof.proof.dimensions import DimensionError, Dimensions, check, infer, rescale
from mechproof.proof.domain import Domain
from mechproof.proof.refutation import points_for
from mechproof.proof.verdict import Evidence
from mechproof.record import (
    Conjunction,
    Definition,
    Equality,
    FunctionWithoutArgument,
    IntegralWithoutDifferential,
    Power,
    Statement,
)

UNIT_CHANGE = 1000


@dataclass(frozen=True)
class Fault:
    """Why a printed side cannot be evaluated."""

    rung: str
    reason: str
    evidence: Evidence


def find_faults(statement: Statement, known: Dimensions, domain: Domain) -> list[Fault]:
    """Return every fault of the printed side; none if it is well formed."""
    if isinstance(statement, Conjunction):
        return [fault for part in statement.parts for fault in find_faults(part, known, domain)]
    if not isinstance(statement, Equality | Definition):
        return []
    found = (
        _find_missing_differential(statement.printed),
        _find_missing_argument(statement.printed),
        _find_unbound_symbol(statement.printed, known),
        _find_mixture(statement, known, domain),
    )
    return [fault for fault in found if fault]


def _find_missing_differential(printed: sp.Basic) -> Fault | None:
    integrals = printed.atoms(IntegralWithoutDifferential)
    if not integrals:
        return None
    integrand = next(iter(integrals)).args[0]
    names = ", ".join(sorted(map(str, integrand.free_symbols)))
    witness = Evidence(
        f"no differential after the integrand {integrand}; it has the symbols {names}"
    )
    return Fault("well-formedness", "an integral has no differential", witness)


def _find_missing_argument(printed: sp.Basic) -> Fault | None:
    functions = printed.atoms(FunctionWithoutArgument)
    if not functions:
        return None
    names = ", ".join(sorted(str(function.args[0]) for function in functions))
    reason = f"{names} has no argument"
    return Fault("well-formedness", reason, Evidence(f"nothing stands behind {names}"))


def _find_unbound_symbol(printed: sp.Basic, known: Dimensions) -> Fault | None:
    declared = {getattr(s, "label", s) for s in known} | known.keys()
    functions = {node.args[0] for node in printed.atoms(FunctionWithoutArgument)}
    unbound = sorted(map(str, printed.free_symbols - _indexed(printed) - declared - functions))
    if not unbound:
        return None
    names = ", ".join(unbound)
    witness = Evidence(f"free in the printed form: {names}")
    return Fault(
        "well-formedness",
        f"{names} has no value there: bound by no sum and no quantity of the paper",
        witness,
    )


def _indexed(printed: sp.Basic) -> set[sp.Basic]:
    return set(printed.atoms(sp.Indexed))


def _find_mixture(
    statement: Equality | Definition, known: Dimensions, domain: Domain
) -> Fault | None:
    if statement.printed.has(IntegralWithoutDifferential, FunctionWithoutArgument):
        return None
    try:
        check(statement, known)
    except DimensionError as error:
        return Fault("dimensions", str(error), _show_change_of_units(statement, known, domain))
    return None


def _power_of_length(expression: sp.Basic, known: Dimensions) -> Power:
    """Return zero for a side that mixes dimensions itself."""
    try:
        dimension = infer(expression, known)
    except DimensionError:
        return 0
    return dimension.length if dimension else 0


def _show_change_of_units(
    statement: Equality | Definition, known: Dimensions, domain: Domain
) -> Evidence:
    """Give the printed value in mm and, from the same lengths in µm, turned back into mm."""
    printed = domain.resolve(statement.printed)
    other = statement.rebuilt if isinstance(statement, Equality) else statement.symbol
    power = _power_of_length(other, known)
    point = points_for((printed,), domain, 1)[0]
    scaled = rescale(printed, known, UNIT_CHANGE)
    values = [balls.evaluate(e.subs(point).doit(), point) for e in (printed, scaled)]
    back = values[1] / balls.to_ball(UNIT_CHANGE) ** balls.to_ball(power)
    at = {str(s): str(v) for s, v in sorted(point.items(), key=lambda item: str(item[0]))}
    what = f"printed form: first in mm, then in a unit {UNIT_CHANGE} times smaller and turned back"
    return Evidence(what, at, balls.show(values[0]), balls.show(back))
