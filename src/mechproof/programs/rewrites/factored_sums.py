"""Products: in, a polynomial; out, its factors, every sum in them being a named step.

SymPy flattens (1 - e) + (1 + e)*t**2 into one sum of four terms in its own order, which cancels as
e -> 1. A named factor keeps its brackets.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from mechproof.arithmetic.polynomials import factor_list
from mechproof.programs.evaluation import Evaluation, Step
from mechproof.programs.step_names import suggest_name


class Factors:
    """The named sums of one evaluation; their definitions are appended to `steps`."""

    def __init__(self, evaluation: Evaluation) -> None:
        self.steps: list[Step] = []
        self._evaluation = evaluation

    def name_sums(self, polynomial: sp.Expr) -> sp.Expr:
        """Return the polynomial factored over the integers, with a name for every sum."""
        return self.multiply(polynomial, self._name)

    def by_powers(self, polynomial: sp.Expr, *variables: sp.Symbol) -> sp.Expr:
        """Return the polynomial factored, with a name for every sum.

        A factor with `variables` stays a sum of their powers, with factored coefficients.
        """

        def convert(base: sp.Expr) -> sp.Expr:
            if not base.has(*variables):
                return self._name(base)
            terms = sp.Poly(base, *variables).terms()
            return sp.Add(
                *(
                    self.name_sums(c) * sp.prod(map(sp.Pow, variables, powers))
                    for powers, c in terms
                )
            )

        return self.multiply(polynomial, convert)

    def multiply(self, polynomial: sp.Expr, convert: Callable[[sp.Expr], sp.Expr]) -> sp.Expr:
        """Return the product of the converted factors, with signs as people write them.

        Raises ValueError for an expression that is no polynomial.
        """
        try:
            number, factors = factor_list(polynomial)
        except sp.PolynomialError as error:
            raise ValueError(f"factors: {polynomial} is not a polynomial") from error
        # The number is multiplied last: SymPy would turn 2*(1 - e), with a single sum, into 2 -
        # 2*e.
        sign, result = sp.sign(number), sp.S.One
        for base, power in factors:
            if base.is_Add and _reads_better_negated(base, sign * result, power):
                base, sign = sp.expand(-base), sign * (-1) ** power
            converted = convert(base) if base.is_Add else base
            if is_negative_sum(converted):
                converted, sign = -converted, sign * (-1) ** power
            result *= converted**power
        return sign * abs(number) * result

    def _name(self, base: sp.Expr) -> sp.Symbol:
        for symbol, value in self.steps:
            if value == base:
                return symbol
        return self._evaluation.add_step(suggest_name(base, "factor"), base, self.steps)


def _reads_better_negated(base: sp.Expr, product: sp.Expr, power: int) -> bool:
    """Return whether a factor reads better negated: 1 - e for e - 1, R - A for -(A - R)."""
    number = base.as_coeff_Add()[0]
    if number:
        return bool(number < 0)
    signs = {term.could_extract_minus_sign() for term in base.args}
    return len(signs) == 2 and power % 2 == 1 and product.could_extract_minus_sign()


def is_negative_sum(node: sp.Basic) -> bool:
    """Return whether a node is a sum whose terms all have a minus sign."""
    return is_sum(node) and all(term.could_extract_minus_sign() for term in node.args)


def is_sum(node: sp.Basic) -> bool:
    """Return whether a node is a sum."""
    return isinstance(node, sp.Add)


def is_root(node: sp.Basic) -> bool:
    """Return whether a node is a square root."""
    return isinstance(node, sp.Pow) and node.exp == sp.S.Half
