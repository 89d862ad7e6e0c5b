"""Elementary functions in plain arithmetic: enclosed approximations, programs, their errors."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

import mpmath as mp
import pytest

from mechproof.codegen.elementary.fits import Rational, enclose
from mechproof.codegen.elementary.formats import DOUBLE, SINGLE, Format
from mechproof.codegen.elementary.functions import BODIES, Function, build
from mechproof.codegen.program import Operand, Program

FORMATS = (DOUBLE, SINGLE)
FITTED = [
    pytest.param(form, target, fitted, id=f"{form.name} {kind} {number}")
    for form in FORMATS
    for kind in BODIES
    for number, (target, fitted) in enumerate(build(kind, form).fits)
]


@pytest.mark.parametrize(("form", "target", "fitted"), FITTED)
def test_an_approximation_is_off_by_less_than_what_rounding_makes(form, target, fitted) -> None:
    assert enclose(target, fitted) <= 0.51 * form.eps


@pytest.mark.parametrize(("form", "target", "fitted"), FITTED)
def test_a_changed_coefficient_has_a_larger_bound(form, target, fitted) -> None:
    above = (fitted.above[0] * (1 + 64 * form.eps), *fitted.above[1:])
    changed = Rational(above, fitted.below)
    assert enclose(target, changed) > enclose(target, fitted) + form.eps


# Each operation in doubles, one rounding each; Fractions make fma exact before it rounds.
DOUBLES: dict[str, Callable[..., float | bool]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / b if b else math.copysign(math.inf, a),
    "negate": lambda a: -a,
    "fma": lambda a, b, c: float(Fraction(a) * Fraction(b) + Fraction(c)),
    "rint": lambda a: float(round(a)),
    "floor": lambda a: float(math.floor(a)),
    "sqrt": math.sqrt,
    "absolute": abs,
    "copysign": math.copysign,
    "choose": lambda condition, a, b: a if condition else b,
    "greater": lambda a, b: a > b,
    "less": lambda a, b: a < b,
    "equal": lambda a, b: a == b,
}


def run(program: Program, *arguments: float) -> float:
    known: dict[Operand, float | bool] = dict(zip(program.inputs, arguments, strict=True))

    def find(operand: Operand) -> float | bool:
        return known[operand] if isinstance(operand, str) else float(operand)

    for step in program.operations:
        known[step.result] = DOUBLES[step.kind](*map(find, step.operands))
    return find(program.outputs[0])


def nearest_angles() -> list[float]:
    """The doubles nearest to multiples of pi/2, for their size: convergents of pi/2 over an ulp."""
    found = []
    with mp.workdps(60):
        for exponent in range(26):
            ulp = mp.mpf(2) ** (exponent - 52)
            rest, (p, q), (before_p, before_q) = mp.pi / 2 / ulp, (1, 0), (0, 1)
            while q * mp.pi / 2 < DOUBLE.largest and q < 2**40:
                part = int(mp.floor(rest))
                (p, q), (before_p, before_q) = (part * p + before_p, part * q + before_q), (p, q)
                rest = 1 / (rest - part)
                if p < 2**53 and p * ulp <= DOUBLE.largest:
                    found.append(float(p * ulp))
    return found


def hard_angles() -> list[float]:
    """Multiples of pi/4 and their neighbours up to the largest angle, and a ladder to zero."""
    turns = [*range(1, 60), 12345, 99999, 1000003, 2**20 + 1, 2**25 - 3, 85440000]
    angles = [n * math.pi / 4 for n in turns if n * math.pi / 4 <= DOUBLE.largest]
    near = [a for x in angles for a in (math.nextafter(x, 0), x, math.nextafter(x, math.inf))]
    return [
        *nearest_angles(),
        *near,
        *(10.0**-k for k in range(0, 301, 12)),
        0.1,
        0.7853,
        1.1,
        2.2,
        3.9,
        5.5,
    ]


ANGLES = hard_angles()
SLOPES = [10.0**k for k in range(-300, 301, 25)] + [0.1, 0.5, 0.9, 0.9999999, 1.0, 1.0000001, 1.7]
# ulp: the approximation, the rounding of what is reduced or the quotient, the last operation.
CASES = {
    "tan": (ANGLES, mp.tan, 2.5),
    "sin": (ANGLES, mp.sin, 1.7),
    "cos": (ANGLES, mp.cos, 1.7),
    "arctan": (SLOPES, mp.atan, 1.1),
    "small_arctan": ([s for s in SLOPES if s < 0.57], mp.atan, 1.2),
}


@pytest.mark.parametrize("kind", CASES)
def test_a_function_is_within_few_eps_where_reductions_fail(kind: str) -> None:
    points, true, bound = CASES[kind]
    function: Function = build(kind, DOUBLE)
    with mp.workdps(60):
        for x in (*points, *(-x for x in points)):
            wanted = true(mp.mpf(x))
            off = abs(mp.mpf(run(function.program, x)) - wanted) / abs(wanted)
            assert off <= bound * DOUBLE.eps, (kind, x.hex())


def test_arcs_of_two_numbers_in_every_quarter() -> None:
    program = build("arctan2", DOUBLE).program
    sides = [s * v for v in (1e-300, 0.3, 1.0, 7.5, 1e200) for s in (1, -1)]
    for a in sides:
        for b in sides:
            wanted = math.atan2(a, b)
            assert run(program, a, b) == pytest.approx(wanted, rel=2 * DOUBLE.eps, abs=0)
    for a, b in ((0.0, 1.0), (0.0, -1.0), (-0.0, -1.0), (0.0, 0.0), (1.0, 0.0), (-1.0, -0.0)):
        assert run(program, a, b) == math.atan2(a, b)


def test_the_length_of_a_side_that_has_no_square() -> None:
    program = build("hypot", DOUBLE).program
    for a, b in ((3e200, 4e200), (3e-200, 4e-200), (3.0, -4.0), (0.0, 2.0), (1e-300, 1e300)):
        wanted = math.hypot(a, b)
        assert run(program, a, b) == pytest.approx(wanted, rel=1.5 * DOUBLE.eps, abs=0)


def test_a_reduction_that_lost_a_word_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The check above fails where pi/2 is two words only."""
    split = Format.split
    monkeypatch.setattr(Format, "split", lambda self, v, n: (*split(self, v, 2), 0.0)[:n])
    build.cache_clear()
    try:
        with pytest.raises(AssertionError):
            test_a_function_is_within_few_eps_where_reductions_fail("sin")
    finally:
        build.cache_clear()
