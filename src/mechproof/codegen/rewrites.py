"""Rewrites: in, an evaluation; out, one with the same exact value that computes better.

Every rewrite is exact where it is legal, and its docstring says where that is. A form names its
rewrites; `REWRITES` resolves the names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp
from sympy.codegen.cfunctions import hypot

from mechproof.codegen.evaluation import Evaluation, Step, arrange, entries, map_entries
from mechproof.codegen.half_angle import cosine_minus_one, half_angle_tangent, small_arc
from mechproof.codegen.low_product import low_product
from mechproof.codegen.low_word import low_word
from mechproof.codegen.products import Factors

Rewrite = Callable[[Evaluation], Evaluation]


def positive_atan2(evaluation: Evaluation) -> Evaluation:
    """Rewrite atan2(y, x) -> atan(y/x); legal where x > 0."""
    return evaluation.transform(lambda e: e.replace(sp.atan2, lambda y, x: sp.atan(y / x)))


def hypotenuse(evaluation: Evaluation) -> Evaluation:
    """Rewrite sqrt(p**2 + q**2 + ...) -> hypot(hypot(p, q), ...).

    No square overflows or underflows. Legal for real p, q.
    """

    def is_root_of_squares(node: sp.Basic) -> bool:
        return (
            isinstance(node, sp.Pow)
            and node.exp == sp.S.Half
            and isinstance(node.base, sp.Add)
            and all(isinstance(a, sp.Pow) and a.exp == 2 for a in node.base.args)
        )

    def nest(root: sp.Pow) -> sp.Expr:
        first, *others = sorted((a.base for a in root.base.args), key=sp.default_sort_key)
        for other in others:
            first = hypot(first, other)
        return first

    return evaluation.transform(lambda e: e.replace(is_root_of_squares, nest))


def conjugate_root(evaluation: Evaluation) -> Evaluation:
    """Rewrite u + sqrt(v) -> q where u >= 0, else (v - u**2)/q.

    q = hypot(sqrt(v - u**2), u) + |u|, and v - u**2 is brought to a product, squares of sines
    having become cosines. No cancellation where u < 0 and sqrt(v) is near -u.
    Legal for real u and v - u**2 >= 0, not both zero.
    """
    factors = Factors(evaluation)

    def is_sum_with_root(node: sp.Basic) -> bool:
        return isinstance(node, sp.Add) and sum(map(_is_root, node.args)) == 1

    @cache
    def convert(node: sp.Add) -> sp.Expr:
        (root,) = filter(_is_root, node.args)
        u, w, q = (evaluation.new_symbol(name, factors.steps) for name in "uwq")
        value = node - root
        difference = (root.base - value**2).replace(
            lambda a: isinstance(a, sp.Pow) and a.exp == 2 and isinstance(a.base, sp.sin),
            lambda a: 1 - sp.cos(a.base.args[0]) ** 2,
        )
        product = factors.name_sums(sp.expand(difference))
        factors.steps.extend([(u, value), (w, product), (q, hypot(sp.sqrt(w), u) + sp.Abs(u))])
        return sp.Piecewise((q, u >= 0), (w / q, True))

    return evaluation.transform(lambda e: e.replace(is_sum_with_root, convert), factors.steps)


def _is_root(node: sp.Basic) -> bool:
    return isinstance(node, sp.Pow) and node.exp == sp.S.Half


def difference_of_squares(evaluation: Evaluation) -> Evaluation:
    """Rewrite a**2 - b**2 -> (a - b)*(a + b); no rounded square is subtracted. Always legal."""
    factors = Factors(evaluation)

    def is_difference(node: sp.Basic) -> bool:
        if not (isinstance(node, sp.Add) and len(node.args) == 2):
            return False
        negative = [term.could_extract_minus_sign() for term in node.args]
        return sum(negative) == 1 and all(
            _is_square(-t if n else t) for t, n in zip(node.args, negative, strict=True)
        )

    return evaluation.transform(
        lambda e: e.replace(is_difference, factors.name_sums), factors.steps
    )


def _is_square(term: sp.Expr) -> bool:
    number, factors = sp.factor_list(term)
    return bool(sp.sqrt(number).is_rational) and all(power % 2 == 0 for _, power in factors)


def name_coefficients(evaluation: Evaluation) -> Evaluation:
    """Name each coefficient of entries affine in a common set of inputs as a step C_ij.

    The coefficients have the shape of the other inputs, so a pose is computed once for all points.
    """
    rows = entries(evaluation.output)
    linear = _affine_inputs(evaluation.inputs, rows)
    steps: list[Step] = []
    named = []
    for i, row in enumerate(rows, start=1):
        rest = row.xreplace(dict.fromkeys(linear, sp.S.Zero))
        for j, variable in enumerate(linear, start=1):
            coefficient = sp.diff(row, variable)
            # What is one call or less needs no name of this kind.
            if isinstance(coefficient, sp.Add | sp.Mul):
                steps.append((evaluation.new_symbol(f"C{i}{j}", steps), coefficient))
                coefficient = steps[-1][0]
            rest += coefficient * variable
        named.append(rest)
    output = iter(named)
    return arrange(
        evaluation.inputs,
        (*evaluation.steps, *steps),
        map_entries(lambda _: next(output), evaluation.output),
    )


def _affine_inputs(inputs: frozenset[sp.Basic], rows: tuple[sp.Expr, ...]) -> list[sp.Symbol]:
    """Find the inputs whose derivatives are free of each other, in the order of their names."""
    candidates = sorted((s for s in inputs if isinstance(s, sp.Symbol)), key=str)
    slopes = {s: [sp.diff(row, s) for row in rows] for s in candidates}
    flat = [s for s in candidates if not any(d.has(s) for d in slopes[s])]
    joint = [s for s in flat if not any(d.has(other) for d in slopes[s] for other in flat)]
    # A plain summand, its slopes numbers, has nothing to name.
    return [s for s in joint if not all(d.is_number for d in slopes[s])]


REWRITES: Mapping[str, Rewrite] = MappingProxyType(
    {
        function.__name__: function
        for function in (
            positive_atan2,
            low_word,
            low_product,
            half_angle_tangent,
            small_arc,
            cosine_minus_one,
            hypotenuse,
            conjugate_root,
            difference_of_squares,
            name_coefficients,
        )
    }
)


def apply_rewrites(evaluation: Evaluation, names: tuple[str, ...]) -> Evaluation:
    """Apply the named rewrites in order; ValueError names one that the table does not have."""
    for name in names:
        if name not in REWRITES:
            raise ValueError(f"rewrite {name!r} is not one of {sorted(REWRITES)}")
        evaluation = REWRITES[name](evaluation)
    return evaluation
