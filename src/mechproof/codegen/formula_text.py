"""Formulas as plain text: in, an expression of a quantity; out, its text for a docstring."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from mechproof.programs.step_names import sort_positive_first


class FormulaPrinter(StrPrinter):  # type: ignore[misc]
    """Plain text with arguments' names, and with sums in the order people write them."""

    # Under SymPy's own method name, elements of indexed symbols would print themselves.
    printmethod = "_formula_text"

    def __init__(self, names: Mapping[sp.Basic, str]) -> None:
        super().__init__()
        self._names = names

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return str(self._names.get(expr, expr.name))

    def _print_Integer(self, expr: sp.Integer) -> str:
        return _as_power(int(expr))

    def _print_Rational(self, expr: sp.Rational) -> str:
        exponent = len(str(expr.q)) - 1
        if expr.p == 1 and expr.q == 10**exponent and exponent > 3:
            return f"1e-{exponent}"
        below = _as_power(int(expr.q))
        if expr.p == 1 and below.startswith("2**"):
            return below.replace("**", "**-")
        return f"{_as_power(int(expr.p))}/{below}"

    def _print_Abs(self, expr: sp.Abs) -> str:
        return f"|{self._print(expr.args[0])}|"

    def _print_Indexed(self, expr: sp.Indexed) -> str:
        name = self._names.get(expr.base, str(expr.base))
        return f"{name}[{','.join(map(self._print, expr.indices))}]"

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:
        first, *others = sorted(expr.args, key=sort_positive_first)
        text = str(self.parenthesize(first, PRECEDENCE["Add"], strict=True))
        for term in others:
            sign, size = ("-", -term) if term.could_extract_minus_sign() else ("+", term)
            text += f" {sign} {self.parenthesize(size, PRECEDENCE['Add'])}"
        return text

    def _print_Sum(self, expr: sp.Sum) -> str:
        limits = ", ".join(f"{i}={low}..{high}" for i, low, high in reversed(expr.limits))
        return f"Sum[{limits}]({self._print(expr.function)})"

    def _print_And(self, expr: sp.And) -> str:
        parts = map(self._print, sorted(expr.args, key=sp.default_sort_key))
        return " and ".join(chain_relations(list(parts)))

    def _print_Or(self, expr: sp.Or) -> str:
        parts = map(self._print, sorted(expr.args, key=sp.default_sort_key))
        return f"({' or '.join(parts)})"

    def _print_Relational(self, expr: sp.Basic) -> str:
        if isinstance(expr, sp.GreaterThan | sp.StrictGreaterThan):
            expr = expr.reversed
        sign = "=" if isinstance(expr, sp.Eq) else expr.rel_op
        return f"{self._print(expr.lhs)} {sign} {self._print(expr.rhs)}"


def _as_power(number: int) -> str:
    """Return a number's text, with large powers of two and ten written as powers."""
    twos, tens = abs(number).bit_length() - 1, len(str(abs(number))) - 1
    if twos > 9 and number == 2**twos:
        return f"2**{twos}"
    return f"1e{tens}" if tens > 9 and number == 10**tens else str(number)


def write_formula(expression: sp.Basic, names: Mapping[sp.Basic, str]) -> str:
    """Return the plain text of an expression or relation; `names` spells the inputs."""
    return str(FormulaPrinter(names).doprint(expression))


def chain_relations(limits: list[str]) -> list[str]:
    """Join neighbouring relations: 0 < R1, R1 < oo -> 0 < R1 < oo."""
    chained: list[str] = []
    for limit in limits:
        last = chained[-1].split(" ")[-1] if chained else ""
        first, _, rest = limit.partition(" ")
        if first == last and chained[-1].count(" ") == 2:
            chained[-1] += f" {rest}"
        else:
            chained.append(limit)
    return chained


def join_equal_limits(limits: list[str]) -> list[str]:
    """Join relations with the same limits: 0 < R1 < oo, 0 < R2 < oo -> 0 < R1, R2 < oo."""
    between: dict[tuple[str, str], list[str]] = {}
    for limit in limits:
        low, below, name, under, high = [*limit.split(" "), *[""] * 5][:5]
        double = limit.count(" ") == 4 and {below, under} <= {"<", "<="}
        ends = (f"{low} {below}", f"{under} {high}") if double else (limit, "")
        between.setdefault(ends, []).append(name)
    return [
        f"{low} {', '.join(names)} {high}" if high else low
        for (low, high), names in between.items()
    ]
