"""Rung: a definite integral has the value that an antiderivative gives.

SymPy only proposes the antiderivative. It counts if its derivative is proved to be the integrand
inside the limits and both are continuous up to them: the fundamental theorem of calculus. One by
tan(x/2) jumps at odd multiples of pi; its arctangent is written without a jump (Jeffrey 1993).
An improper integral has the value of the limits at its ends, where these are shown.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from itertools import pairwise
from typing import Any

import sympy as sp
from sympy.integrals.manualintegrate import manualintegrate
from sympy.integrals.rationaltools import ratint, ratint_ratpart
from sympy.polys.polyerrors import PolynomialError
from sympy.simplify.fu import TR8

from mechproof.proof.algebra import decide_equal
from mechproof.proof.continuity import find_break
from mechproof.proof.coordinates import parametrise
from mechproof.proof.counts import has_steps
from mechproof.proof.domain import Domain
from mechproof.proof.growth import find_limit
from mechproof.proof.half_angles import find_sign_there
from mechproof.proof.powers import decide_by_logarithms
from mechproof.proof.refutation import compare
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.record.parts import find_bound, find_parts
from mechproof.record.substitution import substitute

RUNG = "antiderivative"
# Work limit: an integrand of more operations is not tried.
_LARGEST = 60
_MOST_ZEROS = 12
# Points at which sides are compared first, and the bits of their balls.
_TRIED = 2
_PRECISION = (64,)
_TANGENT = sp.Dummy("t", real=True)


def decide_by_antiderivative(
    left: sp.Expr, right: sp.Expr, domain: Domain, prove: Callable[..., str | None]
) -> str | None:
    """Return the rungs if left = right is proved with the values of integrals, else None."""
    sides = (domain.resolve(left), domain.resolve(right))
    integrals = _list_free(*sides)
    if not integrals or _are_seen_to_differ(sides, domain):
        return None
    values = {integral: _find_value(integral, domain) for integral in integrals}
    known = {integral: value for integral, value in values.items() if value is not None}
    if not known:
        return None
    rest = prove(*(side.xreplace(known) for side in sides), domain)
    return f"{RUNG}, {rest}" if rest else None


def _are_seen_to_differ(sides: tuple[sp.Expr, sp.Expr], domain: Domain) -> bool:
    """Compare sides at a few points, which takes less than to look for antiderivatives."""
    with suppress(NotImplementedError):
        return compare(*sides, domain, _TRIED, _PRECISION).counterexample is not None
    return False


def settle_improper(expression: Any, domain: Domain) -> Any:
    """Put the values of improper and iterated integrals in their places, as far as shown."""
    free = _list_free(expression)
    kinds = (_is_improper, _has_power_of_zero, _is_iterated)
    met = (node for node in free if any(is_one(node) for is_one in kinds))
    values = ((node, _find_value(node, domain)) for node in met)
    return expression.xreplace({node: value for node, value in values if value is not None})


def _list_free(*sides: Any) -> list[sp.Integral]:
    """List the integrals of which no symbol is bound, here or elsewhere in the sides."""
    bound = {symbol for side in sides for symbol in find_bound(side)}
    found = {node for side in sides for node in find_parts(side, sp.Integral)}
    return sorted((node for node in found if not node.free_symbols & bound), key=str)


def _is_improper(integral: sp.Integral) -> bool:
    """Tell whether a limit is infinite or the integrand seen to have no value there."""
    (variable, *limits), *others = integral.limits
    if others or len(limits) != 2:
        return False
    there = (integral.function.subs(variable, limit) for limit in limits)
    return any(limit.is_infinite for limit in limits) or any(
        value.has(sp.oo, -sp.oo, sp.zoo, sp.nan) for value in there
    )


def _has_power_of_zero(integral: sp.Integral) -> bool:
    """Tell whether a base vanishes at a limit whose exponent is no whole number.

    What is computed of such a power has the logarithm of zero.
    """
    powers = [power for power in integral.function.atoms(sp.Pow) if not power.exp.is_integer]
    variable, *limits = integral.limits[0]
    return any(power.base.subs(variable, end) == 0 for power in powers for end in limits)


def _is_iterated(integral: sp.Integral) -> bool:
    """Tell whether an integral is one of integrals."""
    return len(integral.limits) > 1 or integral.function.has(sp.Integral)


def _find_value(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    integrand, *inner, (variable, *limits) = integral.args
    if len(limits) != 2 or integrand.count_ops() > _LARGEST or integrand.has(sp.Sum):
        return None
    lower, upper = limits
    if lower == upper:
        return None
    if (lower > upper) == sp.true:
        turned = _find_value(sp.Integral(integrand, *inner, (variable, upper, lower)), domain)
        return None if turned is None else -turned
    if _is_iterated(integral):
        return _find_iterated(integral, domain)
    if lower == -upper and _is_odd(integrand, variable, upper, domain):
        return sp.S.Zero
    if integrand.has(sp.Abs):
        return _find_value_by_signs(integrand, variable, lower, upper, domain)
    return _find_by_antiderivative(integrand, variable, lower, upper, domain)


def _find_iterated(integral: sp.Integral, domain: Domain) -> sp.Expr | None:
    """Return the value of an integral of integrals, which are worked out between its limits."""
    *inner, (variable, *ends) = integral.limits
    if len(ends) != 2 or _jumps(integral, domain):
        return None
    place, run = parametrise(variable, *ends)
    integrand = sp.Integral(integral.function, *inner) if inner else integral.function
    slope = sp.diff(place, variable)
    integrand = substitute(integrand, {variable: place}) * slope
    inside = domain.with_set(variable, run)
    values = {node: _find_value(node, inside) for node in _list_free(integrand)}
    if not values or None in values.values():
        return None
    limits = (variable, run.start, run.end)
    return _find_value(sp.Integral(integrand.xreplace(values), limits), domain)


def _jumps(integral: sp.Integral, domain: Domain) -> bool:
    """Tell whether what is integrated is not shown to be continuous in the outermost variable."""
    if any(len(limit) != 3 for limit in integral.limits):
        return True
    running, inside = integral.function, domain
    for variable, *ends in integral.limits:
        place, run = parametrise(variable, *ends)
        running, inside = _put(running, variable, place), inside.with_set(variable, run.interior)
    return find_break(running, integral.limits[-1][0], inside) is not None


def _is_odd(integrand: sp.Expr, variable: sp.Symbol, end: sp.Expr, domain: Domain) -> bool:
    """Return whether an integrand is odd, and continuous from one end to the opposite one."""
    sides = [_put(integrand, variable, end * variable), _put(integrand, variable, -end * variable)]
    half = domain.with_set(variable, sp.Interval(0, 1))
    is_odd = end.is_infinite is not True and decide_equal(sides[1], -sides[0], half) is not None
    return is_odd and all(find_break(side, variable, half) is None for side in sides)


def _find_by_antiderivative(
    integrand: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr, domain: Domain
) -> sp.Expr | None:
    """Return the difference of an antiderivative, of its limits where it has no values itself."""
    place, run = parametrise(variable, lower, upper)
    inside = domain.with_set(variable, run.interior)
    slope = sp.diff(place, variable)
    running = _put(integrand, variable, place)
    if find_break(running, variable, inside) is not None:
        return None
    for candidate in _propose(integrand, variable, domain):
        moved = _put(candidate, variable, place)
        if _may_divide_by_zero(moved, inside):
            # So will all others.
            return None
        if find_break(moved, variable, inside) is not None:
            continue
        sides = (sp.diff(moved, variable), running * slope, inside)
        if decide_equal(*sides) is None and decide_by_logarithms(*sides) is None:
            continue
        low, high = (_find_end(moved, variable, end, run, domain) for end in (run.start, run.end))
        if low is not None and high is not None:
            return high - low
    return None


def _may_divide_by_zero(candidate: sp.Expr, domain: Domain) -> bool:
    """Tell whether it divides by a number of steps that may be zero: sin(n*x)/n.

    What is divided by a number that runs has the same value beside its zero, and there.
    """
    below = (
        power.base for power in candidate.atoms(sp.Pow) if power.exp.could_extract_minus_sign()
    )
    return any(has_steps(base, domain) and not is_nonzero(base, domain) for base in below)


def _put(expression: sp.Expr, variable: sp.Symbol, place: sp.Expr) -> sp.Expr:
    return expression if place == variable else expression.subs(variable, place)


def _find_end(
    candidate: sp.Expr, variable: sp.Symbol, end: sp.Expr, run: sp.Interval, domain: Domain
) -> sp.Expr | None:
    """Return the value that an antiderivative comes to at an end, None if it is not shown."""
    if end.is_finite:
        near = sp.Interval(run.start, run.end, end != run.start, end != run.end)
        if find_break(candidate, variable, domain.with_set(variable, near)) is None:
            return candidate.subs(variable, end)
    limit = find_limit(candidate, variable, end, 1 if end == run.start else -1, domain)
    return None if limit is None or limit.is_infinite else limit


def _find_value_by_signs(
    integrand: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr, domain: Domain
) -> sp.Expr | None:
    """Cut an integral between numbers where what stands in a modulus is zero."""
    modulus = max(integrand.atoms(sp.Abs), key=lambda node: (node.count_ops(), str(node)))
    (inner,) = modulus.args
    if not (lower.is_number and upper.is_number):
        return None
    cuts = [lower, *_list_zeros(inner, variable, lower, upper), upper]
    total = sp.S.Zero
    for start, end in pairwise(cuts):
        sign = find_sign_there(inner, domain.with_set(variable, sp.Interval.open(start, end)))
        if sign is None:
            return None
        part = integrand.xreplace({modulus: sign.direction * inner})
        value = _find_value(sp.Integral(part, (variable, start, end)), domain)
        if value is None:
            return None
        total += value
    return total


def _list_zeros(
    inner: sp.Expr, variable: sp.Symbol, lower: sp.Expr, upper: sp.Expr
) -> list[sp.Expr]:
    """List zeros between the limits of a polynomial, or of a sine or cosine of a multiple.

    Where one is missed, no sign is shown beside it.
    """
    inside = sp.Interval.open(lower, upper)
    found: list[sp.Expr] = []
    if inner.is_polynomial(variable) and inner.free_symbols == {variable}:
        found = list(dict.fromkeys(sp.Poly(inner, variable).real_roots()))
    elif isinstance(inner, sp.sin | sp.cos) and lower.is_finite and upper.is_finite:
        slope = sp.diff(inner.args[0], variable)
        if slope.is_Rational and slope != 0:
            start = inner.args[0].subs(variable, 0)
            shift = sp.pi / 2 if isinstance(inner, sp.cos) else sp.S.Zero
            found = [(sp.pi * k + shift - start) / slope for k in range(-_MOST_ZEROS, _MOST_ZEROS)]
    return sorted((z for z in found if inside.contains(z) == sp.true), key=sp.N)


def _propose(integrand: sp.Expr, variable: sp.Symbol, domain: Domain) -> Iterator[sp.Expr]:
    """Propose antiderivatives; SymPy is told which parameters are positive, and decides nothing."""
    told = {
        s: sp.Dummy(s.name, positive=True)
        for s in sorted(integrand.free_symbols - {variable}, key=str)
        if is_positive(s, domain)
    }
    back = {dummy: symbol for symbol, dummy in told.items()}
    met: set[sp.Expr] = set()
    for known in dict.fromkeys((integrand.xreplace(told), integrand)):
        for proposed in _propose_any(known, variable):
            for candidate in _turn_logarithms(proposed.xreplace(back)):
                if candidate not in met:
                    met.add(candidate)
                    yield candidate


def _turn_logarithms(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """Yield an antiderivative with ln u, and with ln(-u) for where u is negative."""
    yield candidate
    logarithms = sorted(candidate.atoms(sp.log), key=sp.default_sort_key)
    turned = {node: sp.log(-node.args[0]) for node in logarithms if node.args[0].free_symbols}
    if turned:
        yield candidate.xreplace(turned)
        yield from (candidate.xreplace({node: turned[node]}) for node in turned)


def _propose_any(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    if integrand.free_symbols - {variable}:
        yield from _propose_by_sums(integrand, variable)
    found = _close(manualintegrate(integrand, variable), sp.Integral(integrand, variable))
    if not found.has(sp.Integral):
        yield from _list_pieces(found)
    for propose in (_propose_by_half_angle, _propose_by_tangent, _propose_by_fractions):
        with suppress(PolynomialError, NotImplementedError):
            yield from propose(integrand, variable)


def _close(found: sp.Expr, whole: sp.Integral) -> sp.Expr:
    """Solve an integral by parts that has led back to itself: I = A + c*I."""
    around = sp.expand(found).coeff(whole)
    return (found - around * whole).expand() / (1 - around) if around not in (0, 1) else found


def _propose_by_sums(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a product of sines and cosines of multiples as a sum of such."""
    if not integrand.has(sp.sin, sp.cos):
        return
    written = sp.expand(TR8(sp.expand(integrand)))
    terms = [_integrate_wave(term, variable) for term in sp.Add.make_args(written)]
    if None not in terms:
        yield sp.Add(*terms)


def _integrate_wave(term: sp.Expr, variable: sp.Symbol) -> sp.Expr | None:
    """Integrate a multiple of the sine or cosine of a linear function; None for another term."""
    factor, wave = term.as_independent(variable)
    if wave == 1:
        return term * variable
    if not isinstance(wave, sp.sin | sp.cos):
        return None
    slope = sp.factor(sp.diff(wave.args[0], variable))
    if slope.has(variable) or slope == 0:
        return None
    turned = -sp.cos(wave.args[0]) if isinstance(wave, sp.sin) else sp.sin(wave.args[0])
    return factor * turned / slope


def _propose_by_half_angle(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate what is rational in the sine and cosine of the variable by t = tan(x/2).

    With sines, x is also counted from a quarter turn: of a + b*sin(x) the angle then stays small.
    """
    t = _TANGENT
    circle = {sp.sin(variable): 2 * t / (1 + t**2), sp.cos(variable): (1 - t**2) / (1 + t**2)}
    for shift in (sp.S.Zero, sp.pi / 2) if integrand.has(sp.sin) else (sp.S.Zero,):
        turned = sp.expand_trig(integrand.subs(variable, variable + shift))
        rational = turned.xreplace(circle) * 2 / (1 + t**2)
        for found in _propose_by_slope(rational, variable, variable):
            yield found.subs(variable, variable - shift)


def _propose_by_tangent(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate by t = tan x what a half turn does not change."""
    t, c, s = _TANGENT, sp.Dummy("c"), sp.Dummy("s")
    written = sp.expand_trig(integrand).xreplace({sp.sin(variable): s, sp.cos(variable): c})
    tangent = sp.cancel(sp.together(written.subs(s, t * c)))
    above, below = (sp.Poly(part, c) for part in sp.fraction(tangent))
    powers = [m[0] for polynomial in (above, below) for m in polynomial.monoms()]
    if any((power - powers[0]) % 2 for power in powers):
        return
    rational = tangent.subs(c, 1 / sp.sqrt(1 + t**2)) / (1 + t**2)
    yield from _propose_by_slope(rational, 2 * variable, variable)


def _propose_by_slope(rational: sp.Expr, double: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate what is rational in t, the tangent of half an angle."""
    t = _TANGENT
    rational = sp.together(rational)
    if rational.has(variable):
        return
    whole, rest = ratint_ratpart(*sp.fraction(sp.cancel(rational)), t)
    found = manualintegrate(sp.apart(rest, t), t)
    if not found.has(sp.Integral):
        turned = found.replace(sp.atan, lambda slope: _turn(slope, double))
        turned = turned.subs(t, sp.sin(double) / (1 + sp.cos(double)))
        yield from _list_pieces(_turn_fraction(whole, double) + turned)


def _propose_by_fractions(integrand: sp.Expr, variable: sp.Symbol) -> Iterator[sp.Expr]:
    """Integrate a quotient of polynomials by its partial fractions, or its quadratic factors."""
    if not integrand.is_rational_function(variable):
        return
    found = manualintegrate(sp.apart(integrand, variable), variable)
    if not found.has(sp.Integral):
        yield from _list_pieces(found)
    if integrand.free_symbols == {variable}:
        yield ratint(integrand, variable, real=True)


def _list_pieces(candidate: sp.Expr) -> Iterator[sp.Expr]:
    """List what SymPy proposes for one sign of a parameter and for the other."""
    node = min(candidate.atoms(sp.Piecewise), key=sp.default_sort_key, default=None)
    if node is None:
        yield candidate
        return
    for value, _ in node.args:
        yield from _list_pieces(candidate.xreplace({node: value}))


def _turn_fraction(fraction: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Write a fraction of t = tan(angle/2) by sine and cosine, without a pole of t."""
    c, s = sp.symbols("c s", cls=sp.Dummy)
    square = (1 - c) / (1 + c)
    above, below = (
        sum(
            factor * square ** (power // 2) * (s / (1 + c)) ** (power % 2)
            for (power,), factor in sp.Poly(part, _TANGENT).terms()
        )
        for part in sp.fraction(fraction)
    )
    return sp.cancel(above / below).xreplace({c: sp.cos(angle), s: sp.sin(angle)})


def _turn(slope: sp.Expr, variable: sp.Expr) -> sp.Expr:
    """Write atan(a*t + b), t = tan(x/2), as x/2 and an angle that does not jump."""
    slope = sp.expand(slope)
    a, b = slope.coeff(_TANGENT, 1), slope.coeff(_TANGENT, 0)
    if slope != sp.expand(a * _TANGENT + b):
        return sp.atan(slope)
    sine, cosine = sp.sin(variable), sp.cos(variable)
    across = (a - 1) * sine + b * (1 + cosine)
    along = (1 + cosine) + a * (1 - cosine) + b * sine
    return variable / 2 + sp.atan(across / along)
