"""The functions that papers of East and West print, and the constants."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from mechproof.latex.matrix_exponentials import give_exponential
from mechproof.latex.matrix_meaning import invert, is_matrix, show_entries

Make = Callable[..., sp.Expr]


def _inv(argument: sp.Expr | sp.MatrixBase | sp.MatrixExpr) -> sp.Expr | sp.MatrixBase:
    """Return the involute of an angle, or the inverse of a matrix."""
    return invert(argument) if is_matrix(argument) else sp.tan(argument) - argument


def _exp(argument: sp.Expr | sp.MatrixBase | sp.MatrixExpr) -> sp.Expr | sp.MatrixBase:
    return give_exponential(argument) if is_matrix(argument) else sp.exp(argument)


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
    lambda x: sp.atanh(1 / x): ("arcoth", "Arcoth", "arcth", "Arcth", "acoth"),
    lambda x: sp.acosh(1 / x): ("arsech", "Arsech", "asech"),
    lambda x: sp.asinh(1 / x): ("arcsch", "Arcsch", "acsch"),
    sp.atan2: ("atan2", "arctan2", "arctg2"),
    _inv: ("inv",),
    lambda matrix: show_entries(matrix).det(): ("det",),
    lambda matrix: show_entries(matrix).trace(): ("tr", "Tr"),
    sp.log: ("ln",),
    lambda x: sp.log(x) / sp.log(10): ("lg",),
    lambda x: sp.log(x) / sp.log(2): ("lb", "ld"),
    _exp: ("exp",),
    sp.Abs: ("abs",),
    sp.sign: ("sgn", "sign"),
    sp.erf: ("erf",),
    sp.erfc: ("erfc",),
    sp.Si: ("Si",),
    sp.Max: ("max",),
    sp.Min: ("min",),
}
FUNCTIONS: Mapping[str, Make] = {name: make for make, names in _SPELLINGS.items() for name in names}
OF_MATRICES = ("det", "tr", "Tr", "inv", "exp")
# Functions told apart by their range, since the name alone is ambiguous.
RANGES: Mapping[str, Make] = {
    r"(0,\pi)": lambda x: sp.pi / 2 - sp.atan(x),
    r"(-\pi/2,\pi/2)": lambda x: sp.atan(1 / x),
}
# Functions whose meaning varies from paper to paper, what is unclear about them, and the choices.
_RANGE = ("its range", " or is ".join(RANGES))
AMBIGUOUS = {
    "log": ("its base (10, e, 2)", r"\lg, \ln or \lb"),
    **dict.fromkeys(("arcctg", "arccot"), _RANGE),
}
CONSTANTS: Mapping[str, sp.Expr] = {r"\pi": sp.pi, r"\infty": sp.oo, r"\mathrm{e}": sp.E}
