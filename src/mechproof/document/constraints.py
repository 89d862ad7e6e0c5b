"""Constraints between letters: what follows from one, and what cannot hold together with it.

A constraint says that its residual, one side minus the other, is zero. An equation follows from it
if its own residual is a multiple of that one: the multiplier is looked for by a division of
polynomials in the sines and cosines and letters, and what is found is left to the prover.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from mechproof.proof.domain import Domain
from mechproof.proof.ladder import decide
from mechproof.proof.signs import is_nonzero
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality

# Operations of residuals beyond which no multiplier is looked for.
LARGEST = 1000


def find_multiple(
    residual: sp.Expr, constraint: sp.Expr, domain: Domain
) -> tuple[sp.Expr, sp.Expr] | None:
    """Return m and r with residual = m * constraint + r, proved on the domain; None if not found.

    With r = 0 the residual follows from the constraint; with another r, which has no zero, both
    are never zero together. What the multiplier is divided by has no zero on the domain: where the
    constraint holds, a multiplier without value would prove anything.
    """
    for multiplier, rest, below in _propose(residual, constraint):
        answer = decide(Equality(residual, multiplier * constraint + rest), domain)
        if answer.verdict is Verdict.PROVED and is_nonzero(below, domain):
            return multiplier, rest
    return None


def _propose(residual: sp.Expr, constraint: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """Yield a multiplier, what remains, and what both are divided by."""
    if constraint.is_number or residual.count_ops() + constraint.count_ops() > LARGEST:
        return
    (above, below), (own_above, own_below) = map(_to_fraction, (residual, constraint))
    names = _name_functions((above, own_above))
    polynomials = [e.xreplace(names) for e in (above, own_above, *_circles(names))]
    generators = sorted(set().union(*(p.free_symbols for p in polynomials)), key=str)
    try:
        (first, *_), rest = sp.reduced(polynomials[0], polynomials[1:], *generators)
    except (sp.PolynomialError, sp.CoercionFailed):
        return
    if rest.is_number and first != 0:
        back = {name: function for function, name in names.items()}
        yield first.xreplace(back) * own_below / below, rest / below, below


def _to_fraction(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    above, below = sp.fraction(sp.together(sp.expand_trig(expression)))
    return sp.expand(above), below


def _name_functions(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Return a symbol for each sine and cosine of the angles that are met."""
    angles = {f.args[0] for e in expressions for f in e.atoms(sp.sin, sp.cos)}
    return {
        f(angle): sp.Dummy(f"{f.__name__}{n}")
        for n, angle in enumerate(sorted(angles, key=str))
        for f in (sp.cos, sp.sin)
    }


def _circles(names: Iterable[sp.Expr]) -> Iterator[sp.Expr]:
    """Yield what is zero of sines and cosines."""
    for function in names:
        if isinstance(function, sp.cos):
            yield function**2 + sp.sin(function.args[0]) ** 2 - 1
