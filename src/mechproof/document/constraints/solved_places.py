r"""Values at a place beside constraints that give there what is tied to it.

With $l\sin\beta=r\sin\varphi$ and $-\pi/2<\beta<\pi/2$ there is one angle $\beta$ where
$\varphi=0$. A letter that may have another value there, as in another position in which a loop is
put together, is not solved for.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import sympy as sp

from mechproof.proof.ladder import decide
from mechproof.proof.signs import is_nonzero
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain

# Functions that have each value once in a range, and what gives the angle there.
_INVERSES = (
    (sp.sin, sp.asin, sp.Interval(-sp.pi / 2, sp.pi / 2)),
    (sp.cos, sp.acos, sp.Interval(0, sp.pi)),
    (sp.tan, sp.atan, sp.Interval.open(-sp.pi / 2, sp.pi / 2)),
)

Values = dict[sp.Basic, sp.Expr]


def solve_at_place(
    residuals: Sequence[sp.Expr], tied: Collection[sp.Basic], domain: Domain
) -> Values | None:
    """Return the only values of tied letters at which residuals are zero, as far as they have one.

    None if with these a residual is not shown to be zero that has no other tied letter.
    """
    values: Values = {}
    while found := next(_solve_any(residuals, values, tied, domain), None):
        values = {s: v.xreplace(found) for s, v in values.items()} | found
    rests = (rest.xreplace(values) for rest in residuals)
    settled = (Equality(rest, sp.S.Zero) for rest in rests if not rest.free_symbols & {*tied})
    is_met = all(decide(one, domain).verdict is Verdict.PROVED for one in settled)
    return values if is_met else None


def _solve_any(
    residuals: Sequence[sp.Expr], values: Values, tied: Collection[sp.Basic], domain: Domain
) -> Iterator[Values]:
    """Yield a letter with its value, where a residual has one tied letter left."""
    for residual in residuals:
        rest = sp.expand(residual.xreplace(values))
        letter, *others = sorted(rest.free_symbols & {*tied}, key=str) or [None]
        if letter is None or others:
            continue
        if (value := _solve(rest, letter, domain)) is not None:
            yield {letter: value}


def _solve(residual: sp.Expr, letter: sp.Basic, domain: Domain) -> sp.Expr | None:
    """Return the only value of a letter at which a residual is zero, None if there may be more.

    It lies in the set of the letter wherever it has a value.
    """
    name, within = sp.Dummy(), domain.set_of(letter)
    if any(letter in relation.free_symbols for relation in domain.where):
        return None
    if within == sp.S.Reals:
        return _solve_linear(residual.xreplace({letter: name}), name, letter, domain)
    for function, inverse, values in _INVERSES:
        shown = residual.xreplace({function(letter): name})
        sine = _solve_linear(shown, name, letter, domain) if within.is_subset(values) else None
        if sine is None:
            continue
        value = inverse(sine)
        is_whole = values.interior.is_subset(within)
        is_within = within.contains(value) == sp.true if value.is_number else is_whole
        return value if is_within else None
    return None


def _solve_linear(
    residual: sp.Expr, name: sp.Dummy, letter: sp.Basic, domain: Domain
) -> sp.Expr | None:
    slope = sp.diff(residual, name)
    if slope == 0 or slope.has(name) or residual.has(letter) or not is_nonzero(slope, domain):
        return None
    return sp.cancel(-residual.xreplace({name: sp.S.Zero}) / slope)
