"""The table of operations: every arithmetic gives a kind the value that its row means."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from c_libraries import COMPILER, STRICT, compile_files
from flint import arb
from trial import load_paper, load_source, paper_of, quantity_of, x

from mechproof.arithmetic.balls import working_precision
from mechproof.codegen.backends.c99 import render_c
from mechproof.codegen.backends.numba import render_compiled
from mechproof.programs import operations
from mechproof.programs.degrees import DEGREES, NONE, Degree
from mechproof.programs.lowering import FUNCTIONS
from mechproof.programs.operations import KINDS, SYMBOLIC, Arithmetic
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, IN_EXTENDED
from mechproof.roundoff.symmetry import EVEN, ODD, PARITIES

EPS = 2.0**-52
EPS = 2.0**-52
POINT = (0.71875, 0.40625, 0.28125, 0.53125, 0.65625)
DECIDES = {"choose": (True, 0.25, 0.5), "both": (True, False), "either": (True, False)}
OTHERS = {
    "maximum": POINT[:2],
    "minimum": POINT[:2],
    "small_tangent": (2.0**-54,),
    "arccosh": (1.71875,),
}
# Operands of rests, which include the rounded result: only computed results have rests.
RESTS = {k: tuple(map(float, values)) for k, values in {
    "product_rest": (1 / 3, 1 / 7, 1 / 3 * (1 / 7)),
    "quotient_rest": (1 / 3, 1 / 7, 1 / 3 / (1 / 7)),
    "sum_rest": (1 / 3, 1 / 70, 1 / 3 + 1 / 70),
    "total_rest": (1 / 3, 1 / 70, 1 / 3 + 1 / 70),
}.items()}  # fmt: skip
MEANT = [k for k, row in KINDS.items() if row.sympy or row.meaning]


def count_operands(kind: str) -> int:
    row, one = KINDS[kind], sp.Symbol("a", real=True)
    for count in range(1, len(POINT) + 1):
        try:
            PARITIES[kind](*[EVEN] * count) if row.meaning else SYMBOLIC[kind](*[one] * count)
        except TypeError:
            continue
        return count
    raise AssertionError(kind)


def operands_of(kind: str) -> tuple[Any, ...]:
    known = {**DECIDES, **OTHERS, **RESTS}
    return known.get(kind) or POINT[: count_operands(kind)]


def evaluate(kind: str, operands: tuple[Any, ...]) -> Any:
    exact = [sp.sympify(o) if isinstance(o, bool) else sp.Rational(o) for o in operands]
    value = SYMBOLIC[kind](*exact)
    return bool(value) if value in (sp.true, sp.false) else sp.N(value, 40)


def is_meant(found: Any, meant: Any) -> bool:
    if isinstance(meant, bool):
        return bool(found) == meant
    if isinstance(found, arb):
        exact = arb(str(meant))
        return bool(abs(found - exact) <= abs(exact) * 1e-35)
    return bool(float(found) == pytest.approx(float(meant), rel=1e-15, abs=0))


def list_others(arithmetic: Arithmetic) -> list[str]:
    """List the kinds whose value in an arithmetic differs from their meaning."""
    told = [k for k in MEANT if k in arithmetic]
    assert len(told) > len(MEANT) - 6
    others = []
    with working_precision(256):
        for kind in told:
            operands = operands_of(kind)
            given = [o if isinstance(o, bool) else arithmetic.number(o) for o in operands]
            if not is_meant(arithmetic[kind](*given), evaluate(kind, operands)):
                others.append(kind)
    return others


@pytest.mark.parametrize("arithmetic", [IN_DOUBLES, IN_EXTENDED, IN_BALLS])
def test_a_kind_is_in_every_arithmetic_what_it_means(arithmetic: Arithmetic) -> None:
    assert list_others(arithmetic) == []


@pytest.mark.parametrize("arithmetic", [IN_DOUBLES, IN_EXTENDED, IN_BALLS])
def test_a_kind_that_is_something_else_is_seen(arithmetic: Arithmetic) -> None:
    wrong = arithmetic.but(
        hypot=lambda a, b: arithmetic.sqrt(a * a - b * b),
        arctan_quotient=lambda a, b: arithmetic.arctan(b / a),
        sum_rest=lambda a, b, s: s - a - b,
        less=arithmetic.greater,
    )
    assert list_others(wrong) == ["less", "hypot", "sum_rest", "arctan_quotient"]


@pytest.mark.parametrize(
    ("kind", "given", "parity"),
    [
        ("add", (ODD, ODD), ODD),
        ("fma", (ODD, EVEN, ODD), ODD),
        ("hypot", (ODD, ODD), EVEN),
        ("copysign", (ODD, ODD), ODD),
        ("tangent_quotient", (ODD, EVEN, EVEN, EVEN, EVEN), ODD),
        ("product_rest", (ODD, EVEN, ODD), ODD),
        ("normal_tail", (ODD,), EVEN),
    ],
)
def test_parities_follow(kind: str, given: tuple[Any, ...], parity: Any) -> None:
    assert PARITIES[kind](*given) == parity


@pytest.mark.parametrize(
    ("kind", "given"), [("add", (ODD, EVEN)), ("exp", (ODD,)), ("rint", (ODD,))]
)
def test_what_has_no_parity_is_refused(kind: str, given: tuple[Any, ...]) -> None:
    with pytest.raises(ValueError, match="odd"):
        PARITIES[kind](*given)


def test_degrees_follow() -> None:
    scaled = Degree({"t": 1})
    assert DEGREES.square(scaled) == DEGREES.fma(scaled, scaled, Degree({"t": 2}))
    assert DEGREES.divide(scaled, scaled) == NONE == DEGREES.tan(NONE)
    for kind, given in (
        ("add", (scaled, NONE)),
        ("tan", (scaled,)),
        ("product_rest", (scaled,) * 3),
    ):
        with pytest.raises(ValueError, match="scaled"):
            DEGREES[kind](*given)


def test_what_no_arithmetic_has_is_named() -> None:
    with pytest.raises(KeyError, match="along_first is not an operation"):
        IN_BALLS["along_first"]
    with pytest.raises(AttributeError, match="cosm1"):
        operations.SYMBOLIC.cosm1(1)


def test_heads_are_kinds() -> None:
    assert len(FUNCTIONS) == len({*FUNCTIONS.values()})
    assert {"sin": "sin", "atan2": "arctan2", "hypot": "hypot"}.items() <= FUNCTIONS.items()


@pytest.mark.parametrize("value", [1e-300, -1e-17, 0.3])
def test_functions_of_libraries_in_all_languages(value: float, tmp_path: Path) -> None:
    """The digits that exp(x) - 1 and log(1 + x) lose are kept by expm1 and log1p."""
    terms = sp.exp(x) - 1 + sp.log(1 + x) / 2 + sp.asin(x / 3), sp.acos(x) * sp.log(x + 2)
    paper = paper_of(quantity_of(sp.Matrix(terms), x, rewrites=("expm1_log1p",)))
    with mp.workdps(700):
        exact = [float(e) for e in sp.lambdify(x, sp.Matrix(terms), "mpmath")(mp.mpf(value))]
    (compiled,) = render_compiled(paper).values()
    assert load_paper(paper, tmp_path).f(value) == pytest.approx(exact, rel=4 * EPS, abs=0)
    assert load_source(compiled, tmp_path).f(value) == pytest.approx(exact, rel=4 * EPS, abs=0)
    if COMPILER:
        library = compile_files(tmp_path, render_c(paper), STRICT)
        out = (ctypes.c_double * 2)()
        library.system_f(ctypes.c_double(value), out)
        assert [*out] == pytest.approx(exact, rel=4 * EPS, abs=0)
