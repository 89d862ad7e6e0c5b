"""Roots of sums of squares without overflow; sums with roots, differences of squares unspoilt.

What cancels is multiplied by its conjugate, as in textbooks since Forsythe's on quadratic equations
(1970); u*u - v*v is (u - v)*(u + v), whose difference is of numbers that were not rounded first.
"""

from __future__ import annotations

from functools import cache

import sympy as sp
from sympy.codegen.cfunctions import hypot

from mechproof.programs.evaluation import Evaluation
from mechproof.programs.rewrites.factored_sums import Factors, is_root, is_sum


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

    q = hypot(sqrt(v - u**2), u) + |u|, and v - u**2 is brought to a product, squares of sines
    having become cosines. No cancellation where u < 0 and sqrt(v) is near -u.
    Legal for real u where v - u**2 >= 0; where both vanish, so does q, and u >= 0.
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
