"""Antiderivatives that SymPy proposes, by one way after another; nothing is proved here.

A product of sines and cosines is written as a sum and integrated term by term.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple

import sympy as sp
from sympy.integrals.heurisch import heurisch
from sympy.polys.polyerrors import PolynomialError
from sympy.simplify.fu import TR8

from mechproof.proof.signs import is_positive
from mechproof.proof.ways_to_integrate import (
    TANGENT,
    list_pieces,
    propose_by_cosine,
    propose_by_exponentials,
    propose_by_fractions,
    propose_by_half_angle,
    propose_by_rules,
    propose_by_tangent,
    propose_by_waves,
    split_fraction,
    write_by_power,
)
from mechproof.record.parts import ARCS
from mechproof.statement_domains.domain import Domain


def propose(integrand: sp.Expr, variable: sp.Symbol, domain: Domain) -> Iterator[sp.Expr]:
    """Propose antiderivatives; SymPy is told which parameters are positive, but decides nothing.

    An exponent said to exceed a number is written as that number plus a positive one.
    """
    if _is_beyond(integrand, variable):
        return
    least = {s: _find_least(s, integrand, domain) for s in integrand.free_symbols - {variable}}
    names = {s: sp.Symbol(s.name, positive=True) for s, low in least.items() if low is not None}
    told = {s: least[s] + positive for s, positive in names.items()}
    back = {positive: s - least[s] for s, positive in names.items()}
    met: set[sp.Expr] = set()
    for known in dict.fromkeys((integrand.xreplace(told), integrand)):
        for proposed in _propose_any(known, variable):
            for candidate in _turn_logarithms(proposed.xreplace(back)):
                if candidate not in met:
                    met.add(candidate)
                    yield candidate


def _find_least(letter: sp.Symbol, integrand: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Return 0 for a positive letter, the number above which one in an exponent lies, or None."""
    if is_positive(letter, domain):
        return sp.S.Zero
    start = getattr(domain.set_of(letter), "start", -sp.oo)
    is_exponent = any(power.exp.has(letter) for power in integrand.atoms(sp.Pow))
    return start if is_exponent and start.is_finite else None


def _is_beyond(integrand: sp.Expr, variable: sp.Symbol) -> bool:
    """Return whether there is no elementary antiderivative (Liouville), which spares long attempts.

    This is so for powers divided by a logarithm, which x = e^t turns into exponentials divided by
    t, and for arctangents and the like divided by x.
    """
    parts = _split_logarithm(integrand, variable)
    if parts is not None:
        return bool(parts.rest.has(variable))
    arcs = _list_moving(sp.expand(integrand * variable), variable)
    if all(isinstance(arc, ARCS) for arc in arcs):
        return True
    powers = _list_moving(sp.powsimp(sp.expand(integrand * sp.log(variable))), variable)
    divided = all(p == 1 or p.as_base_exp()[0] == variable for p in powers)
    return divided and {*powers} != {1 / variable}


def _list_moving(total: sp.Expr, variable: sp.Symbol) -> list[sp.Expr]:
    """List the terms of a sum without their constant factors."""
    return [term.as_independent(variable)[1] for term in sp.Add.make_args(total)]


class _Parts(NamedTuple):
    """A fraction times ln u, u linear: the fraction is the derivative of whole, plus rest*u'/u."""

    logarithm: sp.Expr
    whole: sp.Expr
    rest: sp.Expr


def _split_logarithm(integrand: sp.Expr, variable: sp.Symbol) -> _Parts | None:
    """Split a fraction that multiplies the logarithm of a linear function; None otherwise."""
    logarithms = [node for node in integrand.atoms(sp.log) if node.has(variable)]
    logarithm = min(logarithms, key=sp.default_sort_key, default=sp.S.One)
    fraction, slope = integrand / logarithm, sp.diff(sp.exp(logarithm), variable)
    is_linear = slope != 0 and not slope.has(variable)
    if not is_linear or not fraction.is_rational_function(variable):
        return None
    whole, rest = split_fraction(fraction, variable)
    return _Parts(logarithm, whole, sp.cancel(rest * logarithm.args[0] / slope))


def _propose_by_logarithm(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a fraction times the logarithm of a linear function by parts."""
    if (parts := _split_logarithm(integrand, variable)) is None:
        return
    logarithm, whole, rest = parts
    left = sp.cancel(whole * sp.diff(logarithm, variable))
    for found in propose_by_fractions(left, variable) if left != 0 else [sp.S.Zero]:
        yield rest * logarithm**2 / 2 + whole * logarithm - found


def _turn_logarithms(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """Yield an antiderivative with ln u, and with ln(-u) for where u is negative."""
    yield candidate
    logarithms = sorted(candidate.atoms(sp.log), key=sp.default_sort_key)
    turned = {node: sp.log(-node.args[0]) for node in logarithms if node.args[0].free_symbols}
    if turned:
        yield candidate.xreplace(turned)
        yield from (candidate.xreplace({node: turned[node]}) for node in turned)


def _propose_any(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    # Products of sines and cosines with parameters are quickly integrated as sums, but not by
    # rules.
    waves = dict.fromkeys(integrand.atoms(sp.sin, sp.cos), sp.S.One)
    if integrand.free_symbols - {variable} and not integrand.xreplace(waves).has(variable):
        yield from _list_proposed(_propose_in_parallel, integrand, variable)
    # Fractions of the tangent of an angle are simpler than those of the tangent of its half.
    by_others = (propose_by_cosine, propose_by_tangent, propose_by_half_angle)
    # These come first, as SymPy tries its rules on some fractions for a long time.
    at_first = (
        *(_propose_by_bell, propose_by_fractions, _propose_by_logarithm),
        *(_propose_by_roots, propose_by_waves),
    )
    by_exponentials = (propose_by_exponentials, _propose_by_power)
    ways = (*at_first, *by_exponentials, propose_by_rules, *by_others, _propose_in_parallel)
    for propose in ways:
        yield from _list_proposed(propose, integrand, variable)


# The same integral is asked for more than once, and some ways take long.
@lru_cache(maxsize=256)
def _list_proposed(
    propose: Callable[[sp.Expr, sp.Symbol], Iterator[sp.Expr]],
    integrand: sp.Expr,
    variable: sp.Symbol,
) -> tuple[sp.Expr, ...]:
    """List the proposals of one way, up to the point where SymPy gives up."""
    found: list[sp.Expr] = []
    with suppress(PolynomialError, NotImplementedError):
        found += propose(integrand, variable)
    return tuple(found)


def _propose_by_bell(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate exp(-a*x**2 + b*x + c) by an error function, completing the square."""
    factor, bell = sp.powsimp(integrand).as_independent(variable, as_Add=False)
    exponent = sp.Poly(bell.args[0], variable) if isinstance(bell, sp.exp) else None
    if exponent is None or exponent.degree() != 2:
        return
    a, b, c = (sign * x for sign, x in zip((-1, 1, 1), exponent.all_coeffs(), strict=True))
    argument = sp.sqrt(a) * (variable - b / (2 * a))
    yield factor * sp.exp(c + b**2 / (4 * a)) * sp.sqrt(sp.pi / a) / 2 * sp.erf(argument)


def _propose_by_roots(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate sqrt(p/q), p and q linear functions, as p/sqrt(p*q)."""
    written = integrand
    for root in integrand.atoms(sp.Pow):
        above, below = sp.fraction(sp.together(root.base))
        is_met = all(sp.diff(part, variable).is_number for part in (above, below))
        if root.exp.is_Rational and root.exp.q == 2 and below.has(variable) and is_met:
            other = (above / sp.sqrt(sp.expand(above * below))) ** (2 * root.exp)
            written = written.xreplace({root: other})
    if written != integrand:
        yield from propose_by_rules(sp.expand(written), variable)


def _propose_by_power(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a rational function of an exponential as a fraction of that."""
    if (written := write_by_power(integrand, variable, TANGENT)) is not None:
        rational, exponential = written
        for found in propose_by_fractions(rational, TANGENT):
            yield found.subs(TANGENT, exponential)


def _propose_in_parallel(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by the integrand's own parts with unknown factors (Bronstein 2005).

    An error function is added for each exponential of a square. Skipped because they take long:
    functions divided by or raised to letters, waves whose divisor contains the variable, roots of
    functions, and roots other than square roots next to functions.
    """
    below = sp.fraction(sp.together(integrand))[1]
    functions = {node for node in below.atoms(sp.Function) if not isinstance(node, sp.exp)}
    powers = [power for power in integrand.atoms(sp.Pow) if power.has(variable)]
    if functions or not all(map(_is_tried, powers)):
        return
    if integrand.has(sp.Function) and not all((2 * power.exp).is_integer for power in powers):
        return
    written = TR8(integrand) if integrand.has(sp.sin, sp.cos) else integrand
    if written.has(sp.sin, sp.cos) and below.has(variable):
        return
    whole = sp.S.Zero
    for part in _part_by_functions(sp.expand(written), variable):
        slopes = [-node.args[0] / variable**2 for node in part.atoms(sp.exp)]
        hints = [sp.erf(sp.sqrt(a) * variable) for a in slopes if not a.has(variable)]
        found = heurisch(part, variable, hints=hints)
        if found is None or found.has(sp.Integral):
            return
        whole += found
    yield from list_pieces(whole)


def _is_tried(power: sp.Pow) -> bool:
    """Return whether an exponent is a number or declared whole; over functions, a whole number."""
    if power.base.has(sp.Function):
        return bool(power.exp.is_Integer)
    return bool(power.exp.is_integer or power.exp.is_number)


def _part_by_functions(integrand: sp.Expr, variable: sp.Symbol) -> list[sp.Expr]:
    """Group a sum's terms by their waves and exponentials: no group helps to integrate another."""
    terms: dict[frozenset[sp.Basic], list[sp.Expr]] = {}
    for term in sp.Add.make_args(integrand):
        functions = {f for f in term.atoms(sp.exp, sp.sin, sp.cos) if f.has(variable)}
        terms.setdefault(frozenset(f.args[0] for f in functions), []).append(term)
    return [sp.Add(*group) for group in terms.values()]
