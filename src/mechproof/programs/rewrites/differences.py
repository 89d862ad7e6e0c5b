"""Differences of two values of a function, and from 1, without the digits that cancel there.

The sums and products of trigonometry turn sin a - sin b, whose digits cancel as a nears b, into a
product with sin((a - b)/2), whose digits do not; other functions have such theorems, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations
from types import MappingProxyType

import sympy as sp
from sympy.codegen.cfunctions import expm1, log1p
from sympy.codegen.rewriting import expm1_opt, log1p_opt, optimize

from mechproof.programs.evaluation import Evaluation
from mechproof.programs.rewrites.factored_sums import Factors, is_root, is_sum

# For f(a) - f(b): what it equals by a, b and d = a - b, and the values that have to be positive.
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

    Legal where the values beside the theorem are positive.
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
    """Yield pairs of terms (term, factor, function) of one function and factors c and -c."""
    terms: list[_Term] = []
    for term in sorted(total.args, key=sp.default_sort_key):
        found = [f for f in sp.Mul.make_args(term) if type(f) in THEOREMS]
        terms += [(term, term / found[0], found[0])] if len(found) == 1 else []
    for one, other in combinations(terms, 2):
        if type(one[2]) is type(other[2]) and one[1] == -other[1]:
            yield (other, one) if one[1].could_extract_minus_sign() else (one, other)


def difference_of_roots(evaluation: Evaluation) -> Evaluation:
    """Rewrite r + s -> (r**2 - s**2)/(r - s), r = c*sqrt(v), s a term of the other sign.

    Legal where r - s is positive, for a negative c where it is negative.
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
