"""The functions that papers print, East and West, and the constants."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

Make = Callable[..., sp.Expr]


def _lg(argument: sp.Expr) -> sp.Expr:
    return sp.log(argument) / sp.log(10)


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
    sp.asinh: ("arsh", "asinh", "arsinh"),
    sp.log: ("ln",),
    _lg: ("lg",),
    sp.exp: ("exp",),
    sp.sign: ("sgn", "sign"),
    sp.erf: ("erf",),
    sp.erfc: ("erfc",),
    sp.Max: ("max",),
    sp.Min: ("min",),
}
FUNCTIONS: Mapping[str, Make] = {name: make for make, names in _SPELLINGS.items() for name in names}
# Not the same everywhere: the base of log, the range of the arc cotangent.
AMBIGUOUS = {"log": "its base (10, e, 2)", "arcctg": "its range", "arccot": "its range"}
CONSTANTS: Mapping[str, sp.Expr] = {r"\pi": sp.pi, r"\infty": sp.oo, r"\mathrm{e}": sp.E}
