"""Operations: one row for each kind, with its meaning, its rounding and its spellings.

Nothing that follows from a row is repeated. A kind means a function of SymPy, or is composed of
other kinds by arithmetic that every number has; so it has a value in every `Arithmetic` that knows
the functions: SymPy's expressions, doubles, long doubles, balls, series, parities, degrees.
Herbie's platforms (Panchekha et al. 2015) list operations so, with a cost in place of the rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum
from functools import partial
from types import MappingProxyType
from typing import Any

import sympy as sp

# Prefix of helper functions and their variables in C sources.
HELPER = "mp_"
ATOM, POWER, SIGN, PRODUCT, SUM, BOTH, EITHER, COMPARISON, CHOICE = range(9, 0, -1)
Level = int


class Rounding(Enum):
    """How much a result may be off: not at all, by half an ulp, or by a library's error."""

    EXACT = "exact"
    NEAREST = "to nearest"
    LIBRARY = "of a library"


@dataclass(frozen=True)
class Infix:
    """A sign between two operands, associating to the left."""

    sign: str
    level: Level


@dataclass(frozen=True)
class Pattern:
    """A text with operands, bracketed if they bind less than `inner`; it binds as `outer`."""

    text: str
    inner: Level
    outer: Level


@dataclass(frozen=True)
class Support:
    """A function of a module of the support package."""

    module: str
    name: str


class AxisReduction(Support):
    """A function of the support package that reduces the last axes of an array."""


# A plain string is the name of a function.
Spelling = Infix | Pattern | Support | str


@dataclass(frozen=True)
class Kind:
    """The definition of a kind of operation.

    It means `sympy`, or what `meaning` composes in an arithmetic; kinds that act on axes of arrays
    have neither. With both, expressions use the first, and an arithmetic without it the second.
    `head` is its name in expressions, if that is not one of SymPy's own functions.
    Languages without a spelling use the function of `elementary`; formulas use the meaning.
    Formulas are `python` with NumPy (as `numpy`, if that is a name), `octave`, which MATLAB reads
    too, `javascript`, `structured_text` of IEC 61131-3, and `array_api` by that standard (as
    `python`, where its name follows from NumPy's). Programs in `fpcore` are read and bounded, also
    by `fptaylor` and `gappa` where these have the operation. A view has `indices`: those of the
    element that it shows, counted from the outermost axis. `coq` is a function of real numbers.
    """

    name: str
    rounding: Rounding
    sympy: Callable[..., sp.Basic] | None = None
    meaning: Callable[..., Any] | None = None
    numpy: Spelling | None = None
    numba: Spelling | None = None
    c: Spelling | None = None
    head: str = ""
    python: Spelling | None = None
    octave: Spelling | None = None
    javascript: Spelling | None = None
    structured_text: Spelling | None = None
    array_api: Spelling | None = None
    fpcore: str = ""
    fptaylor: Spelling | None = None
    gappa: Spelling | None = None
    coq: str = ""
    indices: tuple[int, ...] = ()

    @property
    def is_composed(self) -> bool:
        """Return whether programs have the operations of its meaning instead."""
        return self.sympy is not None and self.meaning is not None and self.numpy is None


class Arithmetic:
    """The operations on one type of number: some by own functions, all others by their meanings."""

    def __init__(self, own: Mapping[str, Callable[..., Any]]) -> None:
        self._own = MappingProxyType(dict(own))
        self._derived: dict[str, Callable[..., Any]] = {}

    def but(self, **own: Callable[..., Any]) -> Arithmetic:
        """Return the arithmetic with some of its own functions added or replaced."""
        return Arithmetic({**self._own, **own})

    def __contains__(self, kind: str) -> bool:
        return kind in self._own or (kind in KINDS and KINDS[kind].meaning is not None)

    def __getitem__(self, kind: str) -> Callable[..., Any]:
        if kind in self._own:
            return self._own[kind]
        if kind not in self._derived:
            meaning = KINDS[kind].meaning if kind in KINDS else None
            if meaning is None:
                raise KeyError(f"{kind} is not an operation of this arithmetic")
            self._derived[kind] = partial(meaning, self)
        return self._derived[kind]

    def __getattr__(self, kind: str) -> Callable[..., Any]:
        if kind.startswith("_") or kind not in self:
            raise AttributeError(f"{kind} is not an operation of this arithmetic")
        return self[kind]


EXACT, NEAREST, LIBRARY = Rounding


def _keep(on: Arithmetic, a: Any) -> Any:
    return a


def _tangent_quotient(on: Arithmetic, y: Any, c: Any, a: Any, r: Any, b: Any) -> Any:
    t = on.tan(y)
    return c * t / (a + (r + b * on.square(t)))


def _take_multiple_off(on: Arithmetic, a: Any, b: Any) -> Any:
    quotient = a / b
    return a - b * on.sign(quotient) * on.floor(on.absolute(quotient))


def _function(name: str, sympy: Callable[..., sp.Basic], short: str, fpcore: str = "") -> Kind:
    """Return a function that libraries have but compiled kernels compute by plain arithmetic."""
    return Kind(name, LIBRARY, sympy, numpy=f"_np.{name}",
                octave=short, javascript=f"Math.{short}",
                structured_text=short.upper(), fpcore=fpcore, fptaylor=fpcore or None,
                coq=short)  # fmt: skip


def _library(
    name: str,
    sympy: Callable[..., sp.Basic],
    c: str,
    text: str | None = None,
    fpcore: str = "",
    coq: str = "",
) -> Kind:
    """Return a function of all languages' libraries; `text` is its name in Structured Text."""
    return Kind(name, LIBRARY, sympy, numpy=f"_np.{name}", numba=f"_math.{c}", c=c,
                octave=c, javascript=f"Math.{c}", structured_text=text,
                fpcore=fpcore, fptaylor=fpcore or None, coq=coq)  # fmt: skip


def _composed(name: str, sympy: Callable[..., sp.Basic], meaning: Callable[..., Any]) -> Kind:
    """Return a function that programs replace by the operations of its meaning."""
    return Kind(name, LIBRARY, sympy, meaning)


def _near_one(name: str, meaning: Callable[..., Any]) -> Kind:
    """Return a library function that keeps the digits that cancel in its meaning."""
    return Kind(name, LIBRARY, None, meaning, f"_np.{name}", f"_math.{name}", name, head=name,
                octave=name, javascript=f"Math.{name}")  # fmt: skip


def _sign(name: str, sign: str, level: Level, meaning: Callable[..., Any], point: str = "") -> Kind:
    """Return an arithmetic operation that all languages spell alike, Octave with a `point`."""
    infix = Infix(sign, level)
    octave = Infix(f"{point}{sign}", level)
    return Kind(name, NEAREST, None, meaning, infix, infix, infix, "", infix, octave, infix, infix,
                fpcore=sign, fptaylor=infix, gappa=infix)  # fmt: skip


def _compare(name: str, sign: str, sympy: Callable[..., sp.Basic], other: str = "") -> Kind:
    """Return a comparison; `other` is its sign in languages where = does not assign."""
    infix = Infix(sign, COMPARISON)
    text = Infix(other or sign, COMPARISON)
    return Kind(name, EXACT, sympy, None, infix, infix, infix, "", infix, infix, infix, text)


def _join(name: str, signs: tuple[str, ...], level: Level, sympy: Callable[..., sp.Basic]) -> Kind:
    python, c, text = (Infix(sign, level) for sign in signs)
    return Kind(name, EXACT, sympy, None, python, python, c, "", python, python, c, text)


def _view(name: str, pattern: str, level: Level, *indices: int) -> Kind:
    """Return a view of an array whose axes are the indices of a sum."""
    return Kind(name, EXACT, numpy=Pattern(pattern, level, ATOM), indices=indices)


_NEGATIVE = Pattern("-{}", SIGN, SIGN)
_FUSED = Pattern("{} * {} + {}", PRODUCT, SUM)
_SAME = Pattern("{}", CHOICE, CHOICE)
# In Octave the root of a negative number is complex, even in a branch that is not taken.
_REAL_ROOT = Pattern("real(sqrt({0})) ./ ({0} >= 0)", SUM, PRODUCT)
_QUESTION = Pattern("{} ? {} : {}", EITHER, CHOICE)
_ROWS = (
    # Arithmetic of the machine.
    _sign("add", "+", SUM, lambda on, a, b: a + b),
    _sign("subtract", "-", SUM, lambda on, a, b: a - b),
    _sign("multiply", "*", PRODUCT, lambda on, a, b: a * b, "."),
    _sign("divide", "/", PRODUCT, lambda on, a, b: a / b, "."),
    Kind("negate", EXACT, None, lambda on, a: -a, _NEGATIVE, _NEGATIVE, _NEGATIVE, "",
         _NEGATIVE, _NEGATIVE, _NEGATIVE, _NEGATIVE,
         fpcore="-", fptaylor=Pattern("-({})", CHOICE, SIGN), gappa=_NEGATIVE),
    Kind("fma", NEAREST, None, lambda on, a, b, c: a * b + c, None, "_fma", f"{HELPER}fma",
         fpcore="fma", fptaylor=_FUSED, gappa=_FUSED),
    # An fma whose product may also be rounded, where that is cheaper.
    Kind("multiply_add", NEAREST, None, lambda on, a, b, c: a * b + c,
         None, "_fma", f"{HELPER}multiply_add"),
    Kind("square", NEAREST, None, lambda on, a: a * a,
         Support("functions", "square"), Pattern("{} ** 2", ATOM, POWER), f"{HELPER}square"),
    Kind("sqrt", NEAREST, sp.sqrt, None, "_np.sqrt", "_np.sqrt", "sqrt",
         octave=_REAL_ROOT, javascript="Math.sqrt", structured_text="SQRT",
         fpcore="sqrt", fptaylor="sqrt", gappa="sqrt"),
    Kind("absolute", EXACT, sp.Abs, None, "_abs", "_abs", "fabs",
         python="abs", octave="abs", javascript="Math.abs", structured_text="ABS",
         fpcore="fabs", fptaylor="abs", gappa=Pattern("|{}|", CHOICE, ATOM), coq="Rabs"),
    Kind("sign", EXACT, sp.sign, None, "_np.sign", octave="sign", javascript="Math.sign"),
    Kind("fmod", EXACT, None, _take_multiple_off, "_np.fmod", "_np.fmod", "fmod",
         octave="rem", javascript=Infix("%", PRODUCT)),
    Kind("copysign", EXACT, None, lambda on, a, b: on.absolute(a) * on.sign(b),
         "_np.copysign", "_copysign", "copysign"),
    Kind("floor", EXACT, sp.floor, None, Support("functions", "floor"), "_floor", "floor",
         python="_np.floor", octave="floor", javascript="Math.floor"),
    Kind("rint", EXACT, None, lambda on, a: on.floor(a + on.number(0.5)), None, "_rint", "rint"),
    Kind("power_of_two", EXACT, lambda n: 2**n, None,
         None, "_power_of_two", f"{HELPER}power_of_two"),
    Kind("maximum", EXACT, sp.Max, None,
         Support("functions", "maximum"), "_maximum", f"{HELPER}maximum",
         python="_np.maximum", javascript="Math.max", coq="Rmax"),
    Kind("minimum", EXACT, sp.Min, None, "_np.minimum", javascript="Math.min", coq="Rmin"),
    Kind("copy", EXACT, None, _keep, fptaylor=_SAME, gappa=_SAME),
    # Stands for a value with an approximation error.
    Kind("approximate", EXACT, None, _keep),
    # Comparisons and choices.
    _compare("less", "<", sp.Lt),
    _compare("less_equal", "<=", sp.Le),
    _compare("greater", ">", sp.Gt),
    _compare("greater_equal", ">=", sp.Ge),
    _compare("equal", "==", sp.Eq, "="),
    _join("both", ("&", "&&", "AND"), BOTH, sp.And),
    _join("either", ("|", "||", "OR"), EITHER, sp.Or),
    Kind("choose", EXACT, lambda condition, a, b: sp.Piecewise((a, condition), (b, True)), None,
         Support("functions", "choose_where"), "_choose", _QUESTION,
         python="_np.where", javascript=_QUESTION,
         structured_text=Pattern("SEL({0}, {2}, {1})", CHOICE, ATOM)),
    Kind("is_finite", EXACT, lambda a: sp.And(a > -sp.oo, a < sp.oo), None,
         Support("domains", "is_finite"), "_is_finite", "isfinite",
         python="_np.isfinite", octave="isfinite", javascript="Number.isFinite"),
    Kind("is_positive", EXACT, None,
         lambda on, a: on.both(on.greater(a, on.number(0)), on.is_finite(a)),
         Support("domains", "is_positive")),
    Kind("is_nonnegative", EXACT, None,
         lambda on, a: on.both(on.greater_equal(a, on.number(0)), on.is_finite(a)),
         Support("domains", "is_nonnegative")),
    # Functions.
    _function("sin", sp.sin, "sin", "sin"),
    _function("cos", sp.cos, "cos", "cos"),
    _function("tan", sp.tan, "tan", "tan"),
    _function("arctan", sp.atan, "atan", "atan"),
    _function("arctan2", sp.atan2, "atan2"),
    _function("exp", sp.exp, "exp", "exp"),
    _library("arcsin", sp.asin, "asin", "ASIN", coq="asin"),
    _library("arccos", sp.acos, "acos", "ACOS", coq="acos"),
    _library("log", sp.log, "log", "LN", "log", "ln"),
    _library("sinh", sp.sinh, "sinh", coq="sinh"),
    _library("cosh", sp.cosh, "cosh", coq="cosh"),
    _library("tanh", sp.tanh, "tanh", coq="tanh"),
    _library("arcsinh", sp.asinh, "asinh"),
    _library("arccosh", sp.acosh, "acosh"),
    _library("arctanh", sp.atanh, "atanh"),
    Kind("power", LIBRARY, sp.Pow, None, "_np.power", "_math.pow", "pow",
         octave=Pattern("{}.^{}", ATOM, POWER), javascript="Math.pow",
         structured_text="EXPT", array_api=Pattern("{} ** {}", ATOM, POWER)),
    Kind("cbrt", LIBRARY, sp.cbrt, None, "_np.cbrt", "_np.cbrt", "cbrt",
         javascript="Math.cbrt", array_api=Pattern("{} ** (1 / 3)", ATOM, POWER)),
    Kind("mod", NEAREST, sp.Mod, None, "_np.mod", octave="mod", array_api="xp.remainder"),
    Kind("sinc", LIBRARY, sp.sinc,
         lambda on, a: on.choose(on.equal(a, on.number(0)), on.number(1), on.sin(a) / a),
         Support("functions", "sinc")),
    # Functions that are written by others.
    _composed("sec", sp.sec, lambda on, a: on.number(1) / on.cos(a)),
    _composed("csc", sp.csc, lambda on, a: on.number(1) / on.sin(a)),
    _composed("cot", sp.cot, lambda on, a: on.number(1) / on.tan(a)),
    _composed("sech", sp.sech, lambda on, a: on.number(1) / on.cosh(a)),
    _composed("csch", sp.csch, lambda on, a: on.number(1) / on.sinh(a)),
    _composed("coth", sp.coth, lambda on, a: on.number(1) / on.tanh(a)),
    _near_one("expm1", lambda on, a: on.exp(a) - on.number(1)),
    _near_one("log1p", lambda on, a: on.log(on.number(1) + a)),
    Kind("hypot", LIBRARY, None, lambda on, a, b: on.sqrt(a * a + b * b),
         Support("functions", "hypot"), head="hypot",
         python="_np.hypot", octave="hypot", javascript="Math.hypot"),
    Kind("normal_tail", LIBRARY, lambda a: sp.erfc(sp.Abs(a) / sp.sqrt(2)) / 2),
    # Rests of roundings, and functions of small or reduced arguments.
    Kind("product_rest", EXACT, None, lambda on, a, b, p: a * b - p,
         Support("error_free", "product_rest"), head="ProductRest"),
    Kind("quotient_rest", NEAREST, None, lambda on, a, b, q: a / b - q,
         Support("error_free", "quotient_rest"), head="QuotientRest"),
    Kind("sum_rest", EXACT, None, lambda on, a, b, s: a + b - s,
         Support("error_free", "sum_rest"), head="SumRest"),
    Kind("total_rest", EXACT, None, lambda on, a, b, s: a + b - s),
    Kind("small_tangent", NEAREST, None, lambda on, y: on.tan(y),
         Support("error_free", "small_tangent"), head="SmallTangent"),
    Kind("small_arctan", LIBRARY, None, lambda on, y: on.arctan(y),
         Support("functions", "small_arctan"), head="SmallArctan"),
    Kind("tangent_quotient", LIBRARY, None, _tangent_quotient,
         Support("functions", "tangent_quotient"), head="TangentQuotient"),
    # Two values whose quotient is a tangent; a common factor does not matter.
    Kind("tangent_above", LIBRARY, None, lambda on, y: on.sin(y)),
    Kind("tangent_below", LIBRARY, None, lambda on, y: on.cos(y)),
    Kind("arctan_quotient", LIBRARY, None, lambda on, a, b: on.arctan(a / b),
         Support("functions", "arctan_quotient"), head="ArctanQuotient"),
    Kind("single", NEAREST, None, _keep, Support("error_free", "single"), head="Single"),
    Kind("whole_turns_off", LIBRARY, None, _keep,
         Support("error_free", "whole_turns_off"), head="WholeTurnsOff"),
    # A sum that cannot be negative, given the size of its terms.
    Kind("nonnegative", EXACT, None, lambda on, total, size: total),
    # Arrays with axes that are summed over: views of a vector along the first or the last of two
    # axes, of a matrix transposed or its diagonal; and the kinds that reduce these axes.
    _view("along_first", "{}[..., :, _np.newaxis]", ATOM, 0),
    _view("along_last", "{}[..., _np.newaxis, :]", ATOM, 1),
    _view("transpose", "_np.swapaxes({}, -1, -2)", CHOICE, 1, 0),
    _view("diagonal", "_np.diagonal({}, axis1=-2, axis2=-1)", CHOICE, 0, 0),
    Kind("sum", NEAREST, numpy=AxisReduction("functions", "add_up")),
    Kind("every", EXACT, numpy=AxisReduction("domains", "every")),
    Kind("quadratic_form", NEAREST, numpy=Support("functions", "quadratic_form")),
    Kind("nonnegative_form", NEAREST, numpy=Support("functions", "nonnegative_form")),
)  # fmt: skip
KINDS: Mapping[str, Kind] = MappingProxyType({row.name: row for row in _ROWS})
# The exact meaning of every kind in SymPy expressions.
SYMBOLIC = Arithmetic(
    {"number": sp.Rational, **{k: row.sympy for k, row in KINDS.items() if row.sympy is not None}}
)
COMPARISONS = tuple(
    k for k, row in KINDS.items() if isinstance(row.numpy, Infix) and row.numpy.level == COMPARISON
)
REDUCTIONS = tuple(k for k, row in KINDS.items() if isinstance(row.numpy, AxisReduction))
VIEWS = tuple(k for k, row in KINDS.items() if row.indices)
