"""Relations: an inequality as a number that is positive, or nonnegative; where one holds.

The same numbers express what parts of an expression need to have values: roots, logarithms,
integrals. Printed notions that SymPy lacks are expressions of their own.
Denominators do not matter here: a statement is judged where none of them is zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.printing.precedence import precedence
from sympy.solvers.inequalities import solve_poly_inequality

from mechproof.record.parts import find_parts

# Work limit.
_HIGHEST_ORDER = 12
_STRICT = (sp.StrictLessThan, sp.StrictGreaterThan)
_ORDERS = (*_STRICT, sp.LessThan, sp.GreaterThan)


def _raise(latex: str, exponent: str) -> str:
    return rf"\left({latex}\right)^{{{exponent}}}" if exponent else latex


class IntegralWithoutDifferential(sp.Function):  # type: ignore[misc]
    """An integral sign whose differential is missing in print; it has no value."""

    def _latex(self, printer: Any, exp: str = "") -> str:
        written = rf"\int{{{printer.doprint(self.args[0])}}}\quad\text{{(without a differential)}}"
        return _raise(written, exp)


class ValueWhere(sp.Function):  # type: ignore[misc]
    """A value that is defined only where a second, printed but cancelled expression is, too.

    Both are arguments: the value, and what is needed for it.
    """

    @property
    def precedence(self) -> int:
        """Return the precedence of the value, by which SymPy's printers put brackets around it."""
        return int(precedence(self.args[0]))

    def _sympystr(self, printer: Any) -> str:
        written: str = printer.doprint(self.args[0])
        return written

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raise(printer.doprint(self.args[0]), exp)


class DerivativeWhere(ValueWhere):
    """A derivative where the function has values; it is unspecified elsewhere."""


class NthDerivative(sp.Function):  # type: ignore[misc]
    """The n-th derivative of an expression by a bound variable, at a place.

    The arguments are the expression, its variable, the place and n; for a small number n it is
    evaluated.
    """

    @classmethod
    def eval(cls, inside: sp.Expr, by: sp.Dummy, place: sp.Expr, order: sp.Expr) -> sp.Expr | None:
        """Return the derivative if its order is a known number of moderate size, else None."""
        if not (order.is_Integer and 0 <= order <= _HIGHEST_ORDER):
            return None
        return sp.diff(inside, (by, order)).xreplace({by: place})

    @property
    def free_symbols(self) -> set[sp.Basic]:
        """Return the symbols that are not bound."""
        inside, by, place, order = self.args
        free: set[sp.Basic] = (inside.free_symbols - {by}) | place.free_symbols | order.free_symbols
        return free

    def _eval_derivative(self, symbol: sp.Symbol) -> sp.Expr:
        inside, by, place, order = self.args
        along = self.func(inside, by, place, order + 1) * sp.diff(place, symbol)
        return along + self.func(sp.diff(inside, symbol), by, place, order)

    def _sympystr(self, printer: Any) -> str:
        inside, by, place, order = map(printer.doprint, self.args)
        return f"derivative {order} by {by} of {inside} at {place}"

    def _latex(self, printer: Any, exp: str = "") -> str:
        inside, by, place, order = map(printer.doprint, self.args)
        operator = rf"\frac{{d^{{{order}}}}}{{d{by}^{{{order}}}}}"
        written = rf"\left.{operator}{inside}\right|_{{{by}={place}}}"
        return _raise(written, exp)


class AnyFunction(sp.Function):  # type: ignore[misc]
    """A function known only by name, or a derivative of it; real and smooth everywhere.

    The arguments are the name, the order of the derivative, -1 for an antiderivative, and the
    argument.
    """

    is_extended_real = True
    is_finite = True

    def _eval_derivative(self, symbol: sp.Symbol) -> sp.Expr:
        name, order, argument = self.args
        return self.func(name, order + 1, argument) * sp.diff(argument, symbol)

    def _sympystr(self, printer: Any) -> str:
        name, order, argument = self.args
        return f"{name}{chr(39) * max(int(order), 0)}({printer.doprint(argument)})"

    def _latex(self, printer: Any, exp: str = "") -> str:
        name, order, argument = self.args
        primes = "'" * max(int(order), 0)
        return _raise(rf"{name}{primes}\left({printer.doprint(argument)}\right)", exp)


class FunctionWithoutArgument(sp.Function):  # type: ignore[misc]
    """A function, named by its argument, that is printed without one; it has no value."""


def sum_distinct(term: sp.Expr, outer: sp.Symbol, inner: sp.Symbol, count: sp.Expr) -> sp.Expr:
    """Return the sum of `term` over outer = 1..count and inner = 1..count, inner != outer."""
    off_diagonal = term * (1 - sp.KroneckerDelta(outer, inner))
    return sp.Sum(off_diagonal, (inner, 1, count), (outer, 1, count))


class Slack(NamedTuple):
    """A number that must not be negative and, if strict, not zero either.

    A point is in a domain if this is true of the slacks of all its relations. As a function of the
    point, it is the slack of optimisation: the margin by which a constraint is met.
    """

    value: sp.Expr
    strict: bool


@lru_cache(maxsize=1024)
def find_slack(relation: sp.Basic) -> Slack | None:
    """Return the greater side of an inequality minus the smaller; None for any other relation."""
    if not isinstance(relation, _ORDERS):
        return None
    return Slack(relation.gts - relation.lts, is_strict(relation))


def solve(condition: sp.Basic, symbol: sp.Symbol) -> sp.Set:
    """Return the set on which a condition on one symbol holds.

    For a polynomial, SymPy's search for a period is skipped, which takes a tenth of loading a
    paper.
    """
    if isinstance(condition, sp.core.relational.Relational):
        polynomial = (condition.lhs - condition.rhs).as_poly(symbol)
        if polynomial is not None and (polynomial.domain.is_QQ or polynomial.domain.is_ZZ):
            return sp.Union(*solve_poly_inequality(polynomial, condition.rel_op))
    return condition.as_set()


def is_strict(relation: sp.Basic) -> bool:
    """Return whether an inequality excludes its boundary."""
    return isinstance(relation, _STRICT)


@lru_cache(maxsize=1024)
def is_comparison(relation: sp.Basic) -> bool:
    """Return whether a relation compares only given numbers, so that no rounding decides it.

    Its sides are numbers, symbols, or absolute values of these.
    """
    parts = relation.atoms(sp.core.relational.Relational)
    return all(_is_given(side) for part in parts for side in part.args)


def _is_given(side: sp.Expr) -> bool:
    inner = side.args[0] if isinstance(side, sp.Abs) else side
    return bool(inner.is_Symbol or inner.is_number or isinstance(inner, sp.Indexed))


_NEEDS: Mapping[type[sp.Basic], Callable[[sp.Expr], tuple[Slack, ...]]] = {
    sp.log: lambda x: (Slack(x, True),),
    sp.asin: lambda x: (Slack(1 - x, False), Slack(1 + x, False)),
    sp.acos: lambda x: (Slack(1 - x, False), Slack(1 + x, False)),
    # Below zero it has values between whole numbers, too, which are left out here.
    sp.gamma: lambda x: (Slack(x, True),),
    sp.acosh: lambda x: (Slack(x - 1, False),),
    sp.atanh: lambda x: (Slack(1 - x, True), Slack(1 + x, True)),
}
_TURNING: Mapping[tuple[type[sp.Expr], ...], type[sp.Expr]] = {
    (sp.tan, sp.sec): sp.cos,
    (sp.cot, sp.csc): sp.sin,
}


def list_gaps(value: sp.Expr, within: sp.Interval) -> list[Slack]:
    """List the slacks that must hold for a number to lie in an interval."""
    ends = ((value - within.start, within.left_open), (within.end - value, within.right_open))
    return [Slack(gap, bool(is_open)) for gap, is_open in ends if not gap.is_infinite]


# Functions with kinks or steps: denominators of these may be zero on whole intervals.
KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.floor, sp.ceiling, sp.Heaviside, sp.Piecewise)


def list_partial(expression: sp.Basic) -> tuple[sp.Expr, ...]:
    """Return the parts that lack a value in places, once each, but none inside sums or cases.

    Integrals, limits and derivatives of symbolic order are not entered either.
    """
    found: dict[sp.Expr, None] = {}
    seen: set[sp.Basic] = set()

    def visit(node: sp.Basic) -> None:
        if node in seen:
            return
        seen.add(node)
        if not isinstance(node, ExprWithLimits | sp.Limit | sp.Piecewise | NthDerivative):
            for part in node.args:
                visit(part)
        if _is_partial(node):
            found[node] = None

    visit(expression)
    return tuple(found)


def list_divisors(expression: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return the expressions by which one divides, including a tangent's cosine."""
    found = dict.fromkeys(
        power.base
        for power in find_parts(expression, sp.Pow)
        if power.exp.could_extract_minus_sign()
    )
    for kinds, below in _TURNING.items():
        found |= dict.fromkeys(below(node.args[0]) for node in find_parts(expression, *kinds))
    return tuple(sorted(found, key=sp.default_sort_key))


def _is_partial(node: sp.Basic) -> bool:
    return bool(
        node is sp.I
        or isinstance(node, ExprWithLimits | sp.Limit | ValueWhere)
        or list_needs(node)
        or (isinstance(node, sp.Pow) and node.exp.is_negative and node.base.has(*KINKED))
    )


def list_needs(node: sp.Basic) -> tuple[Slack, ...]:
    """Return what a root, a logarithm or an inverse function needs beyond values of its parts."""
    if isinstance(node, sp.Pow) and not node.exp.is_integer:
        needs: tuple[Slack, ...] = (Slack(node.base, not node.exp.is_positive),)
    else:
        needs = _NEEDS[type(node)](node.args[0]) if type(node) in _NEEDS else ()
    return tuple(
        Slack(number, strict)
        for number, strict in needs
        if not (number.is_positive or (number.is_nonnegative and not strict))
    )
