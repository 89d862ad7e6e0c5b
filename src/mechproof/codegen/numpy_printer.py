"""Printer: in, a SymPy expression; out, the same as NumPy source text.

Written over SymPy's `CodePrinter`, because `NumPyPrinter` names modules in full, orders sums and
products for mathematicians and cannot print a sum over an axis.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import sympy as sp
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.precedence import PRECEDENCE

from mechproof.codegen.names import sort_positive_first

FUNCTIONS: Mapping[str, str] = MappingProxyType(
    {
        "sin": "np.sin",
        "cos": "np.cos",
        "tan": "np.tan",
        "asin": "np.arcsin",
        "acos": "np.arccos",
        "atan": "np.arctan",
        "atan2": "np.arctan2",
        "sqrt": "np.sqrt",
        "exp": "np.exp",
        "log": "np.log",
        "hypot": "np.hypot",
        "Abs": "np.abs",
        "floor": "np.floor",
        "sign": "np.sign",
        "SumRest": "sum_rest",
        "ProductRest": "product_rest",
        "QuotientRest": "quotient_rest",
        "SmallTangent": "small_tangent",
        "SmallArctan": "small_arctan",
        "TangentQuotient": "tangent_quotient",
    }
)
# The constants of the module that a function takes as its last argument.
FITTED: Mapping[str, str] = MappingProxyType(
    {"small_arctan": "ARCTANGENT", "tangent_quotient": "TANGENT"}
)
CONSTANTS: Mapping[sp.Basic, str] = MappingProxyType(
    {sp.pi: "np.pi", sp.E: "np.e", sp.oo: "np.inf", -sp.oo: "-np.inf"}
)


class NumpyPrinter(CodePrinter):  # type: ignore[misc]
    """Prints with `names` for the inputs; factors with a symbol in `large` come last.

    The product of the small factors is then taken once, not once per point.
    """

    printmethod = "_numpycode"
    language = "NumPy"

    def __init__(self, names: Mapping[sp.Basic, str], large: frozenset[sp.Basic]) -> None:
        super().__init__()
        self._names = names
        self._large = large
        self._axes: tuple[sp.Basic, ...] = ()

    def print_expression(self, expression: sp.Basic) -> str:
        """Source text of an expression; NotImplementedError for what has no row here."""
        return str(self._print(expression))

    def print_condition(self, relation: sp.Basic) -> str:
        """Source text of a relation, true where it holds for every value of its indices."""
        items = relation.atoms(sp.Indexed)
        self._axes = tuple(sorted({i for item in items for i in item.indices}, key=str))
        text = self.print_expression(relation)
        axes, self._axes = self._axes, ()
        text = text if axes or text.startswith("is_finite") else f"({text})"
        return f"np.all({text}, axis={_last_axes(len(axes))})" if axes else text

    def emptyPrinter(self, expr: sp.Basic) -> str:  # noqa: N802
        raise NotImplementedError(f"the NumPy printer has no row for {expr.func.__name__}: {expr}")

    def _print_Symbol(self, expr: sp.Symbol) -> str:  # noqa: N802
        return self._names.get(expr, str(expr.name))

    def _print_Integer(self, expr: sp.Integer) -> str:  # noqa: N802
        return str(expr.p)

    def _print_Rational(self, expr: sp.Rational) -> str:  # noqa: N802
        return f"{expr.p} / {expr.q}"

    def _constant(self, expr: sp.Basic) -> str:
        return CONSTANTS[expr]

    _print_Pi = _print_Exp1 = _print_Infinity = _print_NegativeInfinity = _constant  # noqa: N815

    def _print_Function(self, expr: sp.Function) -> str:  # noqa: N802
        name = expr.func.__name__
        if name not in FUNCTIONS:
            return self.emptyPrinter(expr)
        function = FUNCTIONS[name]
        fit = [FITTED[function]] if function in FITTED else []
        return f"{function}({', '.join([*map(self._print, expr.args), *fit])})"

    _print_hypot = _print_Abs = _print_Function  # noqa: N815

    def _print_Max(self, expr: sp.Max) -> str:  # noqa: N802
        first, *others = map(self._print, expr.args)
        for other in others:
            first = f"np.maximum({first}, {other})"
        return str(first)

    def _print_Add(self, expr: sp.Add, order: str | None = None) -> str:  # noqa: N802
        first, *others = sorted(expr.args, key=sort_positive_first)
        text = str(self.parenthesize(first, PRECEDENCE["Add"], strict=True))
        for term in others:
            negative = term.could_extract_minus_sign()
            shown = self.parenthesize(-term if negative else term, PRECEDENCE["Add"])
            text += f" - {shown}" if negative else f" + {shown}"
        return text

    def _print_Mul(self, expr: sp.Mul) -> str:  # noqa: N802
        negative = expr.could_extract_minus_sign()
        numerator, denominator = sp.fraction(-expr if negative else expr)
        factors = sp.Mul.make_args(numerator)
        small = [f for f in factors if not f.has(*self._large)]
        large = [f for f in factors if f.has(*self._large)]
        if denominator == 1:
            parts = [self._product(small + large)]
        else:
            # A small quotient times the variable: a tiny variable times a tiny numerator would
            # underflow before a tiny denominator brings it back.
            below = self.parenthesize(denominator, PRECEDENCE["Mul"])
            first, last = (small, large) if small else (large, [])
            parts = [f"{self._product(first)} / {below}", *([self._product(last)] if last else [])]
        return ("-" if negative else "") + " * ".join(parts)

    def _product(self, factors: list[sp.Expr]) -> str:
        return " * ".join(self.parenthesize(f, PRECEDENCE["Mul"]) for f in factors)

    def _print_Pow(self, expr: sp.Pow) -> str:  # noqa: N802
        base, exponent = expr.as_base_exp()
        if exponent == sp.S.Half:
            return f"np.sqrt({self._print(base)})"
        if exponent.could_extract_minus_sign():
            below = self.parenthesize(base**-exponent, PRECEDENCE["Mul"])
            return f"1 / {below}"
        shown = self.parenthesize(base, PRECEDENCE["Pow"])
        # NumPy squares fast and exactly rounded; any other power is a call of pow.
        if exponent == 3:
            return f"{shown} * {shown} ** 2"
        return f"{shown} ** {self.parenthesize(exponent, PRECEDENCE['Pow'])}"

    def _print_Relational(self, expr: sp.Basic) -> str:  # noqa: N802
        if isinstance(expr, sp.Eq):
            return f"{self._compared(expr.lhs)} == {self._compared(expr.rhs)}"
        low, high = expr.lts, expr.gts
        if sp.oo in (-low, high):
            return f"is_finite({self._print(low if high == sp.oo else high)})"
        equal = "" if isinstance(expr, sp.StrictLessThan | sp.StrictGreaterThan) else "="
        if low.is_number:
            return f"{self._compared(high)} >{equal} {self._compared(low)}"
        return f"{self._compared(low)} <{equal} {self._compared(high)}"

    def _compared(self, expr: sp.Expr) -> str:
        return str(self.parenthesize(expr, PRECEDENCE["Relational"]))

    def _print_Piecewise(self, expr: sp.Piecewise) -> str:  # noqa: N802
        (value, condition), (otherwise, last) = expr.args
        if last != sp.true:
            return self.emptyPrinter(expr)
        return f"choose_where({', '.join(map(self._print, (condition, value, otherwise)))})"

    def _print_Sum(self, expr: sp.Sum) -> str:  # noqa: N802
        # The outermost index of a double sum stands last in `limits` and first among the axes.
        self._axes = tuple(index for index, *_ in reversed(expr.limits))
        text = f"np.sum({self._print(expr.function)}, axis={_last_axes(len(self._axes))})"
        self._axes = ()
        return text

    def _print_Indexed(self, expr: sp.Indexed) -> str:  # noqa: N802
        name = self._names[expr.base]
        indices, axes = expr.indices, self._axes
        table = {
            (1, indices == axes): name,
            (2, indices == axes): name,
            (2, indices == axes[::-1] and len(axes) == 2): f"np.swapaxes({name}, -1, -2)",
            (2, len(axes) == 1): f"np.diagonal({name}, axis1=-2, axis2=-1)",
            (1, len(axes) == 2 and indices[0] == axes[0]): f"{name}[..., :, np.newaxis]",
            (1, len(axes) == 2 and indices[0] == axes[-1]): f"{name}[..., np.newaxis, :]",
        }
        if (len(indices), True) not in table:
            return self.emptyPrinter(expr)
        return table[(len(indices), True)]


def _last_axes(count: int) -> str:
    return "-1" if count == 1 else str(tuple(range(-count, 0)))
