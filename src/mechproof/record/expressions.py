"""Expressions that prints need and SymPy lacks."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.printing.precedence import precedence

# Work limit.
_HIGHEST_ORDER = 12


def _raise(latex: str, exponent: str) -> str:
    return rf"\left({latex}\right)^{{{exponent}}}" if exponent else latex


class IntegralWithoutDifferential(sp.Function):  # type: ignore[misc]
    """An integral sign whose differential is missing in print; it has no value."""

    def _latex(self, printer: Any, exp: str = "") -> str:
        written = rf"\int{{{printer.doprint(self.args[0])}}}\quad\text{{(without a differential)}}"
        return _raise(written, exp)


class ValueWhere(sp.Function):  # type: ignore[misc]
    """A first value where a second has one too, which is printed and cancels.

    Both are arguments: the value, and what is needed for it.
    """

    @property
    def precedence(self) -> int:
        """Return that of the value, by which SymPy's printers put brackets around it."""
        return int(precedence(self.args[0]))

    def _sympystr(self, printer: Any) -> str:
        written: str = printer.doprint(self.args[0])
        return written

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raise(printer.doprint(self.args[0]), exp)


class DerivativeWhere(ValueWhere):
    """A derivative where the function has values; nothing is said of it elsewhere."""


class NthDerivative(sp.Function):  # type: ignore[misc]
    """The n-th derivative of an expression by a bound variable, at a place.

    The arguments are the expression, its variable, the place and n; for a number it is worked out.
    """

    @classmethod
    def eval(cls, inside: sp.Expr, by: sp.Dummy, place: sp.Expr, order: sp.Expr) -> sp.Expr | None:
        """Return the derivative of an order that is known, and not too high."""
        if not (order.is_Integer and 0 <= order <= _HIGHEST_ORDER):
            return None
        return sp.diff(inside, (by, order)).xreplace({by: place})

    @property
    def free_symbols(self) -> set[sp.Basic]:
        """Return those that are not bound."""
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
    """A function of which only a name is said, or a derivative of it; real and smooth everywhere.

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
    """Sum of `term` over outer = 1..count and inner = 1..count, inner != outer."""
    off_diagonal = term * (1 - sp.KroneckerDelta(outer, inner))
    return sp.Sum(off_diagonal, (inner, 1, count), (outer, 1, count))
