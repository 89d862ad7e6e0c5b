"""Infinite sums of fractions of the index, alone or times a wave, by partial fractions.

The sum over all whole numbers k of R(k)*cos(u*k + p), R a fraction and 0 <= u <= 2*pi, is minus the
sum of the residues of R(z)*pi*cos((u - pi)*z + p)/sin(pi*z) at the poles of R, if none of these is
a whole number (Whittaker, Watson, A Course of Modern Analysis, 1927, chapters 6 and 7). If the
terms are symmetric about a point, a sum from a first number onwards is half of that, corrected for
the terms between this number and its mirror image. Other sums need rational poles: there Gauss's
theorem gives the values of the digamma function.

An infinite product of fractions is a product of gamma functions of their zeros and poles (chapter
12 there); those of two zeros that mirror each other make up a sine.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import sympy as sp

from mechproof.proof.signs import find_sign, is_nonnegative, is_nonzero, is_positive
from mechproof.statement_domains.domain import Domain

RUNG = "partial fractions"
# Work limits: operations in a term, terms between the first index and its mirror image, and the
# denominator in Gauss's theorem.
_LARGEST = 40
_MOST_BETWEEN = 8
_FINEST = 24


class _Root(NamedTuple):
    """A zero of a polynomial, given by its real and imaginary parts."""

    real: sp.Expr
    imaginary: sp.Expr

    @property
    def number(self) -> sp.Expr:
        return self.real + sp.I * self.imaginary


class _Term(NamedTuple):
    """A term of a sum over k: a fraction of k, times the cosine of u*k + p."""

    fraction: sp.Expr
    k: sp.Symbol
    u: sp.Expr
    p: sp.Expr


def find_fractions(total: sp.Sum | sp.Product, domain: Domain) -> sp.Expr | None:
    """Return the value of an infinite sum or product of fractions, or None."""
    (k, first, last), *others = total.limits
    if others or last != sp.oo or total.function.count_ops() > _LARGEST:
        return None
    if isinstance(total, sp.Product):
        return _multiply(total.function, k, first, domain) if first.is_Integer else None
    for term in _read(total.function, k):
        if _converges(term, domain):
            if first == -sp.oo:
                value = _sum_all(term, domain)
            elif first.is_Integer:
                value = _sum_half(term, first, domain) or _sum_by_digamma(term, first)
            else:
                return None
            if value is not None:
                return value
    return None


def _read(term: sp.Expr, k: sp.Symbol) -> Iterator[_Term]:
    """Yield a term as a fraction times a cosine, with (-1)**k written as a shift of u by pi."""
    waves = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.sin | sp.cos) and f.has(k)]
    if len(waves) > 1:
        return
    rest, u, p = term, sp.S.Zero, sp.S.Zero
    for wave in waves:
        rest, angle = rest / wave, sp.expand(wave.args[0])
        u, p = angle.coeff(k, 1), angle.coeff(k, 0) - (sp.pi / 2 if wave.func is sp.sin else 0)
        if sp.expand(angle - u * k - angle.coeff(k, 0)) != 0 or u.has(k):
            return
    for turned, turns in ((rest, (0,)), (rest * (-1) ** k, (sp.pi, -sp.pi))):
        fraction = sp.powsimp(sp.expand(turned)) if turns != (0,) else turned
        if fraction.is_rational_function(k):
            yield from (_Term(sp.cancel(sp.together(fraction), k), k, u + t, p) for t in turns)
            return


def _converges(term: _Term, domain: Domain) -> bool:
    """Return whether 0 <= u <= 2*pi is shown and the fraction falls fast enough with k."""
    above, below = map(partial(_write, term.k), sp.fraction(term.fraction))
    fall = below.degree() - above.degree()
    is_within = is_positive if fall == 1 else is_nonnegative
    if (fall >= 2 and term.u == 0) or (fall >= 1 and term.u == sp.pi):
        return True
    return fall >= 1 and is_within(term.u, domain) and is_within(2 * sp.pi - term.u, domain)


def _write(k: sp.Symbol, polynomial: sp.Expr) -> sp.Poly:
    return sp.Poly(polynomial, k)


def _list_roots(
    polynomial: sp.Expr, k: sp.Symbol, domain: Domain, *, are_apart: bool
) -> list[tuple[_Root, int]] | None:
    """List the zeros of a polynomial with their multiplicities, one of each conjugate pair.

    None if not all are found. If `are_apart`, the two zeros of a quadratic factor must be shown to
    differ.
    """
    found: list[tuple[_Root, int]] = []
    for factor, count in sp.factor_list(polynomial)[1]:
        if not factor.has(k):
            continue
        coefficients = sp.Poly(factor, k).all_coeffs()
        if len(coefficients) == 2:
            found.append((_Root(-coefficients[1] / coefficients[0], sp.S.Zero), count))
            continue
        roots = _solve(coefficients, domain, are_apart) if len(coefficients) == 3 else None
        if roots is None:
            return None
        found += [(root, count) for root in roots]
    return found


def _solve(coefficients: list[sp.Expr], domain: Domain, are_apart: bool) -> list[_Root] | None:
    a, b, c = coefficients
    middle, square = -b / (2 * a), sp.factor((b**2 - 4 * a * c) / (4 * a**2))
    sign = find_sign(square, domain)
    if sign is None or (are_apart and not is_nonzero(square, domain)):
        return None
    root = sp.powdenest(sp.sqrt(sign.direction * square), force=True)
    # Either square root will do, so moduli can be dropped.
    root = root.replace(sp.Abs, lambda number: number)
    if sp.expand(root**2 - sign.direction * square) != 0:
        return None
    if sign.direction < 0:
        return [_Root(middle, root)]
    return [_Root(middle + root, sp.S.Zero), _Root(middle - root, sp.S.Zero)]


def _is_apart(root: _Root, domain: Domain) -> bool:
    """Return whether a zero is shown not to be a whole number."""
    number = sp.expand(root.real)
    if root.imaginary != 0:
        return is_nonzero(root.imaginary, domain)
    if number.is_Rational:
        return not number.is_Integer
    for said in domain.where:
        if isinstance(said, sp.Ne) and isinstance(floor := said.rhs, sp.floor):
            (other,) = floor.args
            shifts = (sp.expand(number - other), sp.expand(number + other))
            if other == said.lhs and any(shift.is_Integer for shift in shifts):
                return True
    return any(
        is_positive(number - low, domain) and is_positive(low + 1 - number, domain)
        for low in range(-2, 3)
    )


def _sum_all(term: _Term, domain: Domain) -> sp.Expr | None:
    """Return the sum over all whole numbers, by residues at simple poles."""
    above, below = sp.fraction(term.fraction)
    roots = _list_roots(below, term.k, domain, are_apart=True)
    if not is_nonzero(sp.LC(below, term.k), domain):
        return None
    if roots is None or not all(n == 1 and _is_apart(root, domain) for root, n in roots):
        return None
    slope = sp.diff(below, term.k)
    parts = []
    for root, _ in roots:
        factor = sp.cancel((above / slope).subs(term.k, root.number))
        parts.append(_evaluate(factor, root, term.u - sp.pi, term.p))
    return -sp.Add(*parts)


def _evaluate(factor: sp.Expr, root: _Root, step: sp.Expr, phase: sp.Expr) -> sp.Expr:
    """Return factor*pi*cos(step*z + phase)/sin(pi*z) at z, plus its conjugate if z is not real."""
    x, y = root
    angle = sp.expand(step * x + phase)
    if y == 0:
        return factor * sp.pi * sp.cos(angle) / sp.sin(sp.expand(sp.pi * x))
    wide, tall = step * y, sp.pi * y
    wave = sp.cos(angle) * sp.cosh(wide) - sp.I * sp.sin(angle) * sp.sinh(wide)
    below = [sp.sin(sp.pi * x) * sp.cosh(tall), sp.cos(sp.pi * x) * sp.sinh(tall)]
    one, other = sp.fraction(sp.together(factor))
    # Multiplying by their conjugates makes both denominators real.
    turned = sp.expand(one * sp.conjugate(other) * wave * (below[0] - sp.I * below[1]))
    size = sp.expand(other * sp.conjugate(other)) * (below[0] ** 2 + below[1] ** 2)
    return sp.cancel(2 * sp.pi * turned.subs(sp.I, 0) / size)


def _sum_half(term: _Term, first: sp.Integer, domain: Domain) -> sp.Expr | None:
    """Return a sum from `first` onwards whose terms are the same at k and at -shift - k."""
    below = sp.Poly(sp.denom(term.fraction), term.k).all_coeffs()
    if len(below) < 2:
        return None
    shift = sp.cancel(2 * below[1] / (below[0] * (len(below) - 1)))
    if not shift.is_Integer or abs(2 * first + shift) > _MOST_BETWEEN:
        return None
    turns = sp.cancel((term.u * shift - 2 * term.p) / sp.pi)
    mirrored = term.fraction.subs(term.k, -shift - term.k)
    if not turns.is_Integer or sp.cancel(mirrored * (-1) ** turns - term.fraction) != 0:
        return None
    if (value := _sum_all(term, domain)) is None:
        return None
    wave = term.fraction * sp.cos(term.u * term.k + term.p)
    last = -shift - first
    missing = [wave.subs(term.k, k) for k in range(last + 1, first)]
    doubled = [wave.subs(term.k, k) for k in range(first, last + 1)]
    return (value - sp.Add(*missing) + sp.Add(*doubled)) / 2


def _sum_by_digamma(term: _Term, first: sp.Integer) -> sp.Expr | None:
    """Return a sum of terms c/(k + r)**n with rational r, whose signs may alternate."""
    is_turning = term.u == sp.pi
    if term.p != 0 or term.u not in (0, sp.pi):
        return None
    parts = []
    total = sp.S.Zero
    for part in sp.Add.make_args(sp.apart(term.fraction, term.k)):
        above, below = sp.fraction(sp.together(part))
        _, factors = sp.factor_list(below, term.k)
        if above.has(term.k) or len(factors) != 1:
            return None
        (linear, power), size = factors[0], sp.cancel(below / factors[0][0] ** factors[0][1])
        slope = sp.diff(linear, term.k)
        start = sp.cancel(linear.subs(term.k, first) / slope)
        if not (start.is_Rational and start > 0) or slope.has(term.k):
            return None
        factor = above / (size * slope**power)
        total += factor if power == 1 else 0
        value = _add_powers(start, power, is_turning)
        if value is None:
            return None
        parts.append(factor * value)
    if not is_turning and sp.cancel(total) != 0:
        return None
    return (-1) ** (first * is_turning) * sp.Add(*parts)


def _add_powers(start: sp.Rational, power: int, is_turning: bool) -> sp.Expr | None:
    """Return the sum of 1/(j + start)**power over j >= 0, with alternating signs if `is_turning`.

    For the power 1 without alternating signs it is the sum minus the harmonic series, which cancels
    between the partial fractions.
    """
    if power == 1 and 2 * start.q <= _FINEST:
        if is_turning:
            return (_find_digamma((start + 1) / 2) - _find_digamma(start / 2)) / 2
        return -_find_digamma(start)
    if power == 1 or start.q > 1:
        return None
    if is_turning:
        whole = (1 - sp.Integer(2) ** (1 - power)) * sp.zeta(power)
        before = sp.Add(*((-1) ** (j - 1) * sp.Integer(j) ** -power for j in range(1, start)))
        return (-1) ** (start - 1) * (whole - before)
    return sp.zeta(power) - sp.Add(*(sp.Integer(j) ** -power for j in range(1, start)))


def _find_digamma(number: sp.Rational) -> sp.Expr:
    """Return the digamma function of a positive number plus Euler's constant (Gauss's theorem)."""
    whole = sp.ceiling(number) - 1
    part = number - whole
    sums = sp.Add(*(1 / (part + j) for j in range(whole)))
    if part == 1:
        return sums
    p, q = part.p, part.q
    logarithms = (
        2 * sp.cos(2 * sp.pi * n * p / q) * sp.log(sp.sin(sp.pi * sp.Rational(n, q)))
        for n in range(1, (q + 1) // 2)
    )
    turned = sp.pi / 2 * sp.cot(sp.pi * sp.Rational(p, q))
    return sums - sp.log(2 * q) - turned + sp.Add(*logarithms)


def _multiply(factor: sp.Expr, k: sp.Symbol, first: sp.Integer, domain: Domain) -> sp.Expr | None:
    """Return the infinite product of a fraction with zeros and poles symmetric about one point."""
    parts = sp.fraction(sp.cancel(sp.together(factor)))
    if not all(part.is_polynomial(k) and part.has(k) for part in parts):
        return None
    above, below = (sp.Poly(part, k).all_coeffs() for part in parts)
    lead, second, *_ = below
    are_alike = all(sp.expand(a - b) == 0 for a, b in zip(above[:2], below[:2], strict=True))
    if len(above) != len(below) or not are_alike or not is_nonzero(lead, domain):
        return None
    shift = sp.cancel(2 * second / (lead * (len(below) - 1)))
    if not shift.is_Integer or abs(2 * first + shift) > _MOST_BETWEEN:
        return None
    zeros, poles = (_list_roots(part, k, domain, are_apart=False) for part in parts)
    if zeros is None or poles is None:
        return None
    if not all(
        _is_apart(r, domain) or (r.number.is_Integer and r.number < first) for r, _ in poles
    ):
        return None
    one, other = (_multiply_sines(roots, first, shift, domain) for roots in (zeros, poles))
    return None if one is None or other is None else one / other


def _multiply_sines(
    roots: list[tuple[_Root, int]], first: sp.Integer, shift: sp.Integer, domain: Domain
) -> sp.Expr | None:
    """Return 1 over the product of gamma(first - r) for the zeros r, paired by reflection."""
    left = [root for root, count in roots for _ in range(count)]
    left += [_Root(x, -y) for x, y in left if y != 0]
    value = sp.S.One
    while left:
        root = left.pop()
        mates = [r for r in left if sp.expand(r.number + root.number + shift) == 0]
        pair = _find_sine(root, first, shift, domain) if mates else None
        if pair is None:
            return None
        left.remove(mates[0])
        value *= pair
    return value


def _find_sine(root: _Root, first: sp.Integer, shift: sp.Integer, domain: Domain) -> sp.Expr | None:
    """Return 1/(gamma(z)*gamma(m + 1 - z)), z = first - root: sin(pi*z)/pi, over m factors."""
    x, y, m = first - root.real, -root.imaginary, 2 * first + shift - 1
    if x.is_Integer and y == 0:
        is_met = 0 < x < m + 1
        return 1 / (sp.factorial(x - 1) * sp.factorial(m - x)) if is_met else None
    if m < 0:
        return None
    angle = sp.expand(sp.pi * x)
    sine = sp.sin(angle) * sp.cosh(sp.pi * y) + sp.I * sp.cos(angle) * sp.sinh(sp.pi * y)
    divisors = [1 - x + j - sp.I * y for j in range(m)]
    value = sp.expand(sine / sp.pi / sp.expand(sp.Mul(*divisors)))
    numbers = divisors if y == 0 else divisors and [y]
    if all(is_nonzero(number, domain) for number in numbers):
        return value
    return sp.Piecewise((1, sp.Eq(numbers[0], 0)), (value, True)) if m == 1 else None
