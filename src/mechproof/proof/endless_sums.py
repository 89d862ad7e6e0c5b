"""Infinite sums: the limits of partial sums, and the series of known functions.

SymPy proposes the partial sum, by Gosper's algorithm (1978); that of a geometric series is known.
It counts if it begins and grows as the sum does, by induction, and has a limit. A sum is infinite
if its terms have values and are eventually at least those of c/k or c/(k*ln k), c > 0.

In the series of elementary functions, and of zeta values, a term is known from the first one and
from its quotient with the preceding one (Petkovšek, Wilf, Zeilberger, A = B, 1996, chapter 3).
SymPy simplifies that quotient; it has to be that of a series of the table (Abramowitz, Stegun,
1964, chapters 3, 4 and 23) where that converges.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp
from sympy.concrete.gosper import gosper_sum
from sympy.simplify.simplify import hypersimp

from mechproof.proof.definedness import has_values
from mechproof.proof.growth import find_limit
from mechproof.proof.induction import decide_by_induction, sum_up
from mechproof.proof.signs import find_sign, is_nonnegative, is_nonzero, is_positive
from mechproof.proof.telescoping import is_nonzero_below
from mechproof.statement_domains.domain import Domain

PARTIAL_SUMS = "limit of partial sums"
SUMS = (sp.Sum, sp.Product)
# Work limit: operations of a term that is tried.
_LARGEST = 40
_N = sp.Dummy("n", integer=True, positive=True)
_ABOVE = sp.Dummy("above", integer=True, nonnegative=True)


def read_endless(total: sp.Sum) -> tuple[sp.Expr, sp.Symbol, sp.Integer] | None:
    """Return the term, the index and its first number, or None if the term is too large."""
    (k, first, last), *others = total.limits
    term = total.function
    is_read = not others and last == sp.oo and first.is_Integer and term.count_ops() <= _LARGEST
    return (term, k, first) if is_read else None


def find_endless(total: sp.Sum | sp.Product, domain: Domain) -> sp.Expr | None:
    """Return the value of an infinite sum as the limit of partial sums, or None."""
    if (read := read_endless(total)) is None:
        return None
    term, k, first = read
    if isinstance(total, sp.Product):
        partial = sum_up(sp.Product(term, (k, first, _N)), _N, domain)
        return None if partial.has(sp.Product) else _find_limit(partial, domain)
    if (endless := _find_infinity(term, k, first, domain)) is not None:
        return endless
    ratio = sp.powsimp(term.subs(k, k + 1) / term)
    if not ratio.has(k):
        return term.subs(k, first) / (1 - ratio) if is_positive(1 - ratio**2, domain) else None
    if not is_nonzero_below(term, {k: first + _ABOVE}, domain):
        return None
    partial_sum = sp.Sum(term, (k, first, _N))
    for value in _propose(partial_sum, domain):
        if decide_by_induction(partial_sum, value, domain):
            return _find_limit(value, domain)
    return None


def _propose(total: sp.Sum, domain: Domain) -> Iterator[sp.Expr]:
    """Propose partial sums: by Gosper's algorithm, as a logarithm of a product, as arctangents."""
    term, (k, first, last) = total.function, total.limits[0]
    if (found := gosper_sum(term, (k, first, last))) is not None:
        yield found
    if isinstance(term, sp.log):
        yield sp.log(sum_up(sp.Product(term.args[0], (k, first, last)), last, domain))
    if isinstance(term, sp.atan):
        yield from _propose_arctangents(total)


def _propose_arctangents(total: sp.Sum) -> Iterator[sp.Expr]:
    """Propose a sum of atan(c/(k**2 + b*k + d)), the steps by s of atan(s/c*(k + (b - s)/2))."""
    (k, first, last), *_ = total.limits
    above, below = (sp.Poly(part, k) for part in sp.fraction(sp.together(total.function.args[0])))
    if above.degree() != 0 or below.degree() != 2:
        return
    square, middle, _ = below.all_coeffs()
    for step in (1, 2):
        slope, shift = step * square / above.LC(), (middle / square - step) / 2
        places = [[slope * (end + n + shift) for n in range(step)] for end in (first, last + 1)]
        begin, end = (sp.Add(*map(sp.atan, arguments)) for arguments in places)
        yield end - begin


def _find_infinity(
    term: sp.Expr, k: sp.Symbol, first: sp.Integer, domain: Domain
) -> sp.Expr | None:
    """Return plus or minus infinity if a harmonic or slower series is exceeded, else None."""
    from_first = domain.with_set(_ABOVE, sp.S.Naturals0)
    running = term.subs(k, first + _ABOVE)
    counts = [factorial.args[0] for factorial in running.atoms(sp.factorial)]
    if not (has_values(running, from_first) and all(count.is_nonnegative for count in counts)):
        return None
    for size in (k, k * sp.log(k)):
        limit = find_limit(term * size, k, sp.oo, -1, domain)
        sign = find_sign(sp.sign(limit), domain) if limit is not None else None
        if sign is not None and sign.strict:
            return sign.direction * sp.oo
    return None


def _find_limit(partial: sp.Expr, domain: Domain) -> sp.Expr | None:
    limit = find_limit(partial, _N, sp.oo, 1, domain)
    return None if limit is None or limit.is_infinite else limit


KNOWN_SERIES = "known series"
# Work limit: terms missing at the beginning of a sum, compared with the known series.
_MOST_BEFORE = 4
# Powers s for which sums of 1/k**s, zeta(s) and the like, are known.
_POWERS = range(2, 9)
_J = sp.Dummy("j", integer=True, nonnegative=True)
_A = sp.Dummy("a", real=True)
_ODD = 2 * _J + 1


@dataclass(frozen=True)
class _Series:
    """A series by the quotient of its terms, with its value for a first term `first`.

    It converges where `positive` and `nonnegative` have the signs in their names.
    """

    quotient: sp.Expr
    value: sp.Expr
    first: sp.Expr = sp.S.One
    positive: sp.Expr = sp.S.One
    nonnegative: sp.Expr = sp.S.One


_ELEMENTARY = (
    _Series(_A / (_J + 1), sp.exp(_A)),
    _Series(-(_A**2) / (_ODD * (_ODD + 1)), sp.cos(_A)),
    _Series(_A**2 / (_ODD * (_ODD + 1)), sp.cosh(_A)),
    _Series(-(_A**2) / ((_ODD + 1) * (_ODD + 2)), sp.sin(_A), _A),
    _Series(_A**2 / ((_ODD + 1) * (_ODD + 2)), sp.sinh(_A), _A),
    _Series(_A * (_J + 1) / (_J + 2), -sp.log(1 - _A), _A, 1 - _A, 1 + _A),
    _Series(-(_A**2) * _ODD / (_ODD + 2), sp.atan(_A), _A, nonnegative=1 - _A**2),
    _Series(_A**2 * _ODD / (_ODD + 2), sp.atanh(_A), _A, positive=1 - _A**2),
    _Series(_A**2 * _ODD**2 / ((_ODD + 1) * (_ODD + 2)), sp.asin(_A), _A, nonnegative=1 - _A**2),
    _Series(
        -(_A**2) * _ODD**2 / ((_ODD + 1) * (_ODD + 2)), sp.asinh(_A), _A, nonnegative=1 - _A**2
    ),
    _Series(
        _A**2 * (_ODD + 1) / (_ODD + 2), sp.asin(_A) / sp.sqrt(1 - _A**2), _A, positive=1 - _A**2
    ),
    _Series(
        _A**2 * (_ODD + 1) ** 2 / ((_ODD + 2) * (_ODD + 3)),
        *(sp.asin(_A) ** 2, _A**2),
        nonnegative=1 - _A**2,
    ),
)
_ZETA = tuple(
    series
    for power in _POWERS
    for series in (
        _Series(((_J + 1) / (_J + 2)) ** power, sp.zeta(power)),
        _Series(
            -(((_J + 1) / (_J + 2)) ** power), (1 - sp.Integer(2) ** (1 - power)) * sp.zeta(power)
        ),
        _Series((_ODD / (_ODD + 2)) ** power, (1 - sp.Integer(2) ** -power) * sp.zeta(power)),
    )
)
_BETA = tuple(
    # The sum of (-1)**j/(2*j + 1)**power, by Euler's numbers.
    _Series(
        -((_ODD / (_ODD + 2)) ** power),
        abs(sp.euler(power - 1)) * sp.pi**power / (2 ** (power + 1) * sp.factorial(power - 1)),
    )
    for power in _POWERS
    if power % 2
)
SERIES = (*_ELEMENTARY, *_ZETA, *_BETA)


def find_series(total: sp.Sum | sp.Product, domain: Domain) -> sp.Expr | None:
    """Return the value of an infinite sum that is a known series, or None."""
    if isinstance(total, sp.Product) or (read := read_endless(total)) is None:
        return None
    term, k, first = read
    above = sp.Dummy("above", integer=True, nonnegative=True)
    counts = {k: first + above}
    if not is_nonzero_below(term, counts, domain):
        return None
    if (value := _find_weighted(term, k, first, domain)) is not None:
        return value
    first += term.subs(k, first) == 0
    before = sp.S.Zero
    for count in range(_MOST_BEFORE + 1):
        leading = term.subs(k, first - count)
        if leading.has(sp.zoo, sp.oo, sp.nan):
            return None
        before += leading if count else 0
        value = _find_whole(term.subs(k, _J + first - count), leading, domain)
        if value is not None:
            return value - before
    return None


def _find_weighted(
    term: sp.Expr, k: sp.Symbol, first: sp.Integer, domain: Domain
) -> sp.Expr | None:
    """Return the sum of p(k)*a**k/k! or p(k)*a**k, p a polynomial, or None for other terms.

    For p = k*(k - 1)*...*(k - i + 1) they are a**i*e**a and i!*a**i/(1 - a)**(i + 1).
    """
    weight = sp.Mul(*(f for f in sp.Mul.make_args(term) if f.has(k) and f.is_polynomial(k)))
    rest = (term / weight).subs(k, _J)
    quotient = hypersimp(rest, _J) if weight != 1 and 0 <= first <= _MOST_BEFORE else None
    if quotient is None:
        return None
    a = sp.cancel(quotient * (_J + 1))
    is_geometric = a.has(_J)
    a = quotient if is_geometric else a
    if a.has(_J) or (is_geometric and not is_positive(1 - a**2, domain)):
        return None
    parts, left = [], sp.Poly(weight, k)
    for i in range(left.degree() + 1):
        # Expands the polynomial in falling factorials: k, k*(k - 1) and so on.
        left, part = sp.div(left, sp.Poly(k - i, k))
        value = sp.factorial(i) / (1 - a) ** (i + 1) if is_geometric else sp.exp(a)
        parts.append(part.as_expr() * a**i * value)
    before = sp.Add(*(term.subs(k, number) for number in range(first)))
    return sp.Add(*parts) * rest.subs(_J, 0) - before


def _find_whole(term: sp.Expr, leading: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Return the value of a sum that begins with j = 0, or None if its series is not known."""
    quotient = hypersimp(term, _J)
    if leading == 0 or quotient is None or not quotient.is_rational_function(_J):
        return None
    for series in (*SERIES, *_make_binomial(quotient)):
        for argument in _find_arguments(quotient, series, domain):
            factor = sp.cancel(leading / series.first.subs(_A, argument))
            conditions = (
                is_positive(series.positive.subs(_A, argument), domain),
                is_nonnegative(series.nonnegative.subs(_A, argument), domain),
                is_nonzero(sp.denom(factor), domain),
            )
            if all(conditions):
                return factor * series.value.subs(_A, argument)
    return None


def _make_binomial(quotient: sp.Expr) -> Iterator[_Series]:
    """Yield Newton's series of (1 - a)**-b if the quotient is a*(j + b)/(j + 1)."""
    above = sp.cancel(quotient * (_J + 1))
    if above.is_polynomial(_J) and sp.degree(above, _J) == 1:
        b = sp.cancel(above.subs(_J, 0) / sp.diff(above, _J))
        yield _Series(_A * (_J + b) / (_J + 1), (1 - _A) ** -b, positive=1 - _A**2)


def _find_arguments(quotient: sp.Expr, series: _Series, domain: Domain) -> Iterator[sp.Expr]:
    """Yield the real argument for which a series has this quotient; 1 if it has no argument."""
    scale = sp.cancel(quotient / series.quotient.subs(_A, 1))
    if scale.has(_J):
        return
    if not series.quotient.has(_A):
        if scale == 1:
            yield scale
    elif not series.quotient.has(_A**2):
        yield scale
    else:
        root = sp.powdenest(sp.sqrt(scale), force=True)
        if is_nonnegative(scale, domain) and sp.expand(root**2 - scale) == 0:
            yield root
