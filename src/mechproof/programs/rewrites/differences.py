"""Differences without cancellation: of values of a function, from 1, and of squares and roots.

The sum-to-product identities turn sin a - sin b, whose digits cancel as a nears b, into a product
with sin((a - b)/2), whose digits do not; other functions have similar theorems. A cancelling sum
with a root is multiplied by its conjugate, as in textbooks since Forsythe's paper on quadratic
equations (1970); u*u - v*v becomes (u - v)*(u + v), a difference of numbers not rounded before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from itertools import combinations
from types import MappingProxyType

import sympy as sp
from sympy.codegen.cfunctions import expm1, hypot, log1p
from sympy.codegen.rewriting import expm1_opt, log1p_opt, optimize

from mechproof.programs.evaluation import Evaluation
from mechproof.programs.rewrites.factored_sums import Factors, is_root, is_sum

# For f(a) - f(b), in terms of a, b and d = a - b: an equal expression, and values that must be
# positive.
Theorem = Callable[[sp.Expr, sp.Expr, sp.Expr], tuple[sp.Expr, tuple[sp.Expr, ...]]]
THEOREMS: Mapping[type[sp.Function], Theorem] = MappingProxyType(
    {
        sp.sin: lambda a, b, d: (2 * sp.cos(sp.expand(b + d / 2)) * sp.sin(d / 2), ()),
        sp.cos: lambda a, b, d: (-2 * sp.sin(sp.expand(b + d / 2)) * sp.sin(d / 2), ()),
        sp.tan: lambda a, b, d: (sp.sin(d) / (sp.cos(a) * sp.cos(b)), ()),
        sp.exp: lambda a, b, d: (sp.exp(b) * expm1(d), ()),
        sp.log: lambda a, b, d: (log1p(d / b), (a, b)),
        sp.atan: lambda a, b, d: (sp.atan(d / (1 + a * b)), (1 + a * b,)),
    }
)


def difference_of_functions(evaluation: Evaluation) -> Evaluation:
    """Rewrite c*f(a) - c*f(b) by `THEOREMS`, f one of sin, cos, tan, exp, log, atan.

    Legal where the values that the theorem requires to be positive are so.
    """
    legal: list[sp.Basic] = []

    def convert(total: sp.Add) -> sp.Expr:
        for (one, factor, f), (other, _, g) in _list_pairs(total):
            difference = sp.expand(f.args[0] - g.args[0])
            value, positive = THEOREMS[type(f)](f.args[0], g.args[0], difference)
            legal.extend(sp.Gt(v, 0) for v in positive)
            rest = total - one - other
            return factor * value + (convert(rest) if rest.is_Add else rest)
        return total

    return evaluation.convert_parts(is_sum, convert).oblige(legal)


_Term = tuple[sp.Expr, sp.Expr, sp.Function]


def _list_pairs(total: sp.Add) -> Iterator[tuple[_Term, _Term]]:
    """Yield pairs of terms (term, factor, function) with the same function and factors c and -c."""
    terms: list[_Term] = []
    for term in sorted(total.args, key=sp.default_sort_key):
        found = [f for f in sp.Mul.make_args(term) if type(f) in THEOREMS]
        terms += [(term, term / found[0], found[0])] if len(found) == 1 else []
    for one, other in combinations(terms, 2):
        if type(one[2]) is type(other[2]) and one[1] == -other[1]:
            yield (other, one) if one[1].could_extract_minus_sign() else (one, other)


def difference_of_roots(evaluation: Evaluation) -> Evaluation:
    """Rewrite r + s -> (r**2 - s**2)/(r - s), r = c*sqrt(v), s the only other term.

    Legal where r - s is positive or, for a negative c, negative.
    """
    factors = Factors(evaluation)
    legal: list[sp.Basic] = []

    def convert(total: sp.Add) -> sp.Expr:
        roots = [t for t in total.args if any(map(is_root, sp.Mul.make_args(t)))]
        if len(total.args) != 2 or not roots:
            return total
        root = min(roots, key=lambda term: (term.could_extract_minus_sign(), str(term)))
        other = total - root
        sign = -1 if root.could_extract_minus_sign() else 1
        below = sign * (root - other)
        legal.append(sp.Gt(below, 0))
        return sign * factors.name_sums(sp.expand(root**2 - other**2)) / below

    return evaluation.convert_parts(is_sum, convert, factors.steps).oblige(legal)


def expm1_log1p(evaluation: Evaluation) -> Evaluation:
    """Rewrite exp(u) - 1 -> expm1(u) and log(1 + u) -> log1p(u). Always legal."""
    return evaluation.transform(lambda e: optimize(e, (expm1_opt, log1p_opt)))


def hypotenuse(evaluation: Evaluation) -> Evaluation:
    """Rewrite sqrt(p**2 + q**2 + ...) -> hypot(hypot(p, q), ...).

    No square overflows or underflows. Legal for real p, q.
    """

    def is_root_of_squares(node: sp.Basic) -> bool:
        return (
            is_root(node)
            and isinstance(node.base, sp.Add)
            and all(isinstance(a, sp.Pow) and a.exp == 2 for a in node.base.args)
        )

    def nest(root: sp.Pow) -> sp.Expr:
        first, *others = sorted((a.base for a in root.base.args), key=sp.default_sort_key)
        for other in others:
            first = hypot(first, other)
        return first

    return evaluation.convert_parts(is_root_of_squares, nest)


def conjugate_root(evaluation: Evaluation) -> Evaluation:
    """Rewrite u + sqrt(v) -> q where u >= 0, else (v - u**2)/q.

    q = hypot(sqrt(v - u**2), u) + |u|, and v - u**2 is factored, with squares of sines written by
    cosines. No cancellation where u < 0 and sqrt(v) is near -u.
    Legal for real u where v - u**2 >= 0; where u and v vanish, so does q, and u >= 0 applies.
    """
    factors = Factors(evaluation)
    legal: list[sp.Basic] = []

    def is_sum_with_root(node: sp.Basic) -> bool:
        return is_sum(node) and sum(map(is_root, node.args)) == 1

    @cache
    def convert(node: sp.Add) -> sp.Expr:
        (root,) = filter(is_root, node.args)
        u, w, q = (evaluation.new_symbol(name, factors.steps) for name in "uwq")
        value = node - root
        difference = (root.base - value**2).replace(
            lambda a: isinstance(a, sp.Pow) and a.exp == 2 and isinstance(a.base, sp.sin),
            lambda a: 1 - sp.cos(a.base.args[0]) ** 2,
        )
        product = factors.name_sums(sp.expand(difference))
        legal.append(sp.Ge(sp.expand(difference), 0))
        factors.steps.extend([(u, value), (w, product), (q, hypot(sp.sqrt(w), u) + sp.Abs(u))])
        return sp.Piecewise((q, u >= 0), (w / q, True))

    return evaluation.convert_parts(is_sum_with_root, convert, factors.steps).oblige(legal)


def difference_of_squares(evaluation: Evaluation) -> Evaluation:
    """Rewrite a**2 - b**2 -> (a - b)*(a + b); no rounded square is subtracted. Always legal."""
    factors = Factors(evaluation)

    def is_difference(node: sp.Basic) -> bool:
        if not (is_sum(node) and len(node.args) == 2):
            return False
        negative = [term.could_extract_minus_sign() for term in node.args]
        return sum(negative) == 1 and all(
            _is_square(-t if n else t) for t, n in zip(node.args, negative, strict=True)
        )

    return evaluation.convert_parts(is_difference, factors.name_sums, factors.steps)


def _is_square(term: sp.Expr) -> bool:
    if term.is_Rational:
        return bool(sp.sqrt(term).is_rational)
    try:
        number, factors = sp.factor_list(term)
    except sp.PolynomialError:
        return False
    return bool(sp.sqrt(number).is_rational) and all(power % 2 == 0 for _, power in factors)
