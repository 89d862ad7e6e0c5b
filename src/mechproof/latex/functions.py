"""The functions that papers print, East and West, and the constants."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from mechproof.latex.products import invert, is_matrix, show_entries

Make = Callable[..., sp.Expr]


def _lg(argument: sp.Expr) -> sp.Expr:
    return sp.log(argument) / sp.log(10)


def _lb(argument: sp.Expr) -> sp.Expr:
    return sp.log(argument) / sp.log(2)


def _acoth(argument: sp.Expr) -> sp.Expr:
    return sp.atanh(1 / argument)


def _asech(argument: sp.Expr) -> sp.Expr:
    return sp.acosh(1 / argument)


def _acsch(argument: sp.Expr) -> sp.Expr:
    return sp.asinh(1 / argument)


def _inv(argument: sp.Expr | sp.MatrixBase | sp.MatrixExpr) -> sp.Expr | sp.MatrixBase:
    """Return the involute of an angle, the inverse of a matrix."""
    return invert(argument) if is_matrix(argument) else sp.tan(argument) - argument


def _det(matrix: sp.MatrixBase | sp.MatrixExpr) -> sp.Expr:
    determinant: sp.Expr = show_entries(matrix).det()
    return determinant


def _trace(matrix: sp.MatrixBase | sp.MatrixExpr) -> sp.Expr:
    trace: sp.Expr = show_entries(matrix).trace()
    return trace


_SPELLINGS: Mapping[Make, tuple[str, ...]] = {
    sp.sin: ("sin",),
    sp.cos: ("cos",),
    sp.tan: ("tg", "tan"),
    sp.cot: ("ctg", "cot", "cotg"),
    sp.sec: ("sec",),
    sp.csc: ("cosec", "csc"),
    sp.asin: ("arcsin", "asin"),
    sp.acos: ("arccos", "acos"),
    sp.atan: ("arctg", "arctan", "atan"),
    sp.sinh: ("sh", "sinh"),
    sp.cosh: ("ch", "cosh"),
    sp.tanh: ("th", "tanh"),
    sp.coth: ("cth", "coth"),
    sp.sech: ("sech",),
    sp.csch: ("csch", "cosech"),
    sp.asinh: ("arsh", "asinh", "arsinh", "Arsh", "Arsinh"),
    sp.acosh: ("arch", "acosh", "arcosh", "Arch", "Arcosh"),
    sp.atanh: ("arth", "atanh", "artanh", "Arth", "Artanh"),
    _acoth: ("arcoth", "Arcoth", "arcth", "Arcth", "acoth"),
    _asech: ("arsech", "Arsech", "asech"),
    _acsch: ("arcsch", "Arcsch", "acsch"),
    sp.atan2: ("atan2", "arctan2", "arctg2"),
    _inv: ("inv",),
    _det: ("det",),
    _trace: ("tr", "Tr"),
    sp.log: ("ln",),
    _lg: ("lg",),
    _lb: ("lb", "ld"),
    sp.exp: ("exp",),
    sp.Abs: ("abs",),
    sp.sign: ("sgn", "sign"),
    sp.erf: ("erf",),
    sp.erfc: ("erfc",),
    sp.Max: ("max",),
    sp.Min: ("min",),
}
FUNCTIONS: Mapping[str, Make] = {name: make for make, names in _SPELLINGS.items() for name in names}
# Those that take matrices.
OF_MATRICES = ("det", "tr", "Tr", "inv")
# Not the same everywhere: the base of log, the range of the arc cotangent.
AMBIGUOUS = {"log": "its base (10, e, 2)", "arcctg": "its range", "arccot": "its range"}
CONSTANTS: Mapping[str, sp.Expr] = {r"\pi": sp.pi, r"\infty": sp.oo, r"\mathrm{e}": sp.E}
