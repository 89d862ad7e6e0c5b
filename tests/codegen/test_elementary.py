"""Elementary functions in plain arithmetic: enclosed approximations, programs, their errors."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from c_libraries import list_fused

from mechproof.codegen.backends.numpy import render_template
from mechproof.codegen.backends.scalar_texts import write_elementary
from mechproof.codegen.languages import C99, C99_SINGLE
from mechproof.codegen.syntax import write_program
from mechproof.lab.single_precision_errors import IN_SINGLES
from mechproof.programs.elementary.fits import Rational, enclose
from mechproof.programs.elementary.formats import DOUBLE, SINGLE, Format
from mechproof.programs.elementary.function_programs import BODIES, build
from mechproof.programs.elementary.plain import write_plainly
from mechproof.programs.operations import HELPER
from mechproof.programs.program import Operand, Program
from mechproof.roundoff.running import run as run_steps

FORMATS = (DOUBLE, SINGLE)
NUMBER: dict[Format, Callable[[float], float]] = {
    DOUBLE: float,
    SINGLE: lambda a: ctypes.c_float(a).value,
}
FITTED = [
    pytest.param(form, target, fitted, id=f"{form.name} {kind} {number}")
    for form in FORMATS
    for kind in BODIES
    for number, (target, fitted) in enumerate(build(kind, form).fits)
]


@pytest.mark.slow
@pytest.mark.parametrize(("form", "target", "fitted"), FITTED)
def test_an_approximation_is_off_by_less_than_what_rounding_makes(form, target, fitted) -> None:
    assert enclose(target, fitted) <= 0.51 * form.eps


@pytest.mark.slow
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
    "fma": lambda a, b, c: (
        float(Fraction(a) * Fraction(b) + Fraction(c))
        if all(map(math.isfinite, (a, b, c)))
        else a * b + c
    ),
    "rint": lambda a: float(round(a)) if math.isfinite(a) else a,
    "floor": lambda a: float(math.floor(a)) if math.isfinite(a) else a,
    "power_of_two": lambda n: math.ldexp(1.0, int(n)) if math.isfinite(n) else 1.0,
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


def run_singly(program: Program, *arguments: float) -> float:
    given = {n: np.float32(a) for n, a in zip(program.inputs, arguments, strict=True)}
    with np.errstate(over="ignore"):
        (value,) = run_steps(program, given, IN_SINGLES)
    return float(value)


RUNS = {DOUBLE: run, SINGLE: run_singly}


def nearest_angles(form: Format) -> list[float]:
    """Return the numbers relatively nearest to multiples of pi/2: convergents of pi/2 in ulps."""
    found = []
    with mp.workdps(60):
        for exponent in range(int(math.log2(form.largest))):
            ulp = mp.mpf(2) ** (exponent + 1 - form.bits)
            rest, (p, q), (before_p, before_q) = mp.pi / 2 / ulp, (1, 0), (0, 1)
            while q * mp.pi / 2 < form.largest and q < 2**40:
                part = int(mp.floor(rest))
                (p, q), (before_p, before_q) = (part * p + before_p, part * q + before_q), (p, q)
                rest = 1 / (rest - part)
                if p < 2**form.bits and p * ulp <= form.largest:
                    found.append(float(p * ulp))
    return found


def hard_angles(form: Format) -> list[float]:
    """Return multiples of pi/4 and neighbours up to the largest angle, and a ladder to zero."""
    turns = [*range(1, 60), 1297, 12345, 99999, 1000003, 2**20 + 1, 2**25 - 3, 85440000]
    angles = [n * math.pi / 4 for n in turns if n * math.pi / 4 <= form.largest]
    near = [x * (1 + k * form.eps) for x in angles for k in (-1, 0, 1)]
    return [
        *nearest_angles(form),
        *near,
        *(10.0**-k for k in range(0, 301, 12)),
        *(2.0**-k for k in range(0, 126, 9)),
        0.1,
        0.7853,
        1.1,
        2.2,
        3.9,
        5.5,
    ]


SLOPES = [10.0**k for k in range(-300, 301, 25)] + [0.1, 0.5, 0.9, 0.9999999, 1.0, 1.0000001, 1.7]
# Odd multiples of log(2)/2 and neighbours, a ladder to zero, and the ends of the range.
EXPONENTS = [
    *(n * math.log(2) / 2 * (1 + e) for n in (1, 3, 7, 255, 1021) for e in (-1e-15, 0, 1e-15)),
    *(10.0**-k for k in range(0, 301, 12)),
    0.1, 0.3465, 0.7, 2.2, 33.0, 690.0, 708.3,
]  # fmt: skip
# The worst argument found: there 1/2 is rounded down and then once more.
WORST_TAIL = 8.547434413440087e-09
LIMITS = [WORST_TAIL] + [10.0**-k for k in range(0, 301, 12)] + [i / 7 for i in range(1, 263)]
# Left empty: which angles are hard depends on the format.
ANGLES: list[float] = []
# Bounds in ulp, for the approximation, the reduced argument or quotient, and the last operation.
CASES = {
    "tan": (ANGLES, mp.tan, 2.5),
    "sin": (ANGLES, mp.sin, 1.7),
    "cos": (ANGLES, mp.cos, 1.7),
    "arctan": (SLOPES, mp.atan, 1.1),
    "exp": (EXPONENTS, mp.exp, 0.8),
    "normal_tail": (LIMITS, lambda x: mp.erfc(abs(x) / mp.sqrt(2)) / 2, 3.3),
    "small_arctan": ([s for s in SLOPES if s < 0.57], mp.atan, 1.2),
}


COMPILER = shutil.which("cc")


@pytest.mark.slow
@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
@pytest.mark.parametrize("form", FORMATS, ids=lambda f: f.name)
def test_exponentials_in_c(form: Format, tmp_path: Path) -> None:
    """In double C has the bits of the program, in float twice the bound of each function."""
    language, real = (C99, ctypes.c_double) if form == DOUBLE else (C99_SINGLE, ctypes.c_float)
    kinds = ("exp", "normal_tail")
    data = {
        **{
            "prefix": "none",
            "reductions": [],
            "kernels": [],
            "used": ["power_of_two", "fma", "multiply_add"],
            "split": write_program(write_plainly("fma"), language),
            "far": {},
            "block": 1,
        },
        **{"form": form, "largest": 0, "number": language.number},
        **{"absolute": "", "limit": "", "letters": "", "helper": HELPER},
        "real": form.name.replace("single", "float"),
        "functions": [write_elementary(kind, form, language, language) for kind in kinds],
    }
    text = render_template("c_source.c.jinja", data).replace("static inline", "")
    (tmp_path / "none.h").write_text("")
    (tmp_path / "none.c").write_text(text)
    command = [str(COMPILER), "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"]
    command += [
        "-ffp-contract=off",
        *list_fused(),
        "-shared",
        "-fPIC",
        "none.c",
        "-o",
        "none.so",
        "-lm",
    ]
    subprocess.run(command, cwd=tmp_path, check=True)
    library = ctypes.CDLL(str(tmp_path / "none.so"))
    for kind in kinds:
        points, true, bound = CASES[kind]
        function = getattr(library, f"{HELPER}{kind}")
        function.restype, function.argtypes = real, [real]
        for x in (*points, *(-x for x in points)):
            number = real(x).value
            wanted = float(true(mp.mpf(number)))
            if form == DOUBLE:
                assert function(x) == run(build(kind, form).program, x)
            elif 2.0**-126 < wanted < 2.0**127:
                assert function(x) == pytest.approx(wanted, rel=2 * bound * form.eps, abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMATS, ids=lambda f: f.name)
@pytest.mark.parametrize("kind", CASES)
def test_a_function_is_within_few_eps_where_reductions_fail(kind: str, form: Format) -> None:
    points, true, bound = CASES[kind]
    program, least = build(kind, form).program, 2.0 ** (2 - form.exponent)
    with mp.workdps(60):
        for x in map(NUMBER[form], points or hard_angles(form)):
            for y in (x, -x) if least <= abs(x) < math.inf else ():
                wanted = true(mp.mpf(y))
                off = abs(mp.mpf(RUNS[form](program, y)) - wanted)
                if least <= abs(wanted) < 2.0 ** (form.exponent - 1):
                    assert off <= bound * form.eps * abs(wanted), (kind, y.hex())


@pytest.mark.parametrize("form", FORMATS, ids=lambda f: f.name)
def test_arcs_of_two_numbers_in_every_quarter(form: Format) -> None:
    arcs, quotients = (build(kind, form).program for kind in ("arctan2", "arctan_quotient"))
    far = 2.0 ** (form.exponent // 2)
    sides = [NUMBER[form](s * v) for v in (1 / far, 0.3, 1.0, 7.5, far) for s in (1, -1)]
    for a in sides:
        for b in sides:
            for program, wanted in ((arcs, math.atan2(a, b)), (quotients, math.atan(a / b))):
                least = 2.0 ** (2 - form.exponent)
                found = RUNS[form](program, a, b)
                assert found == pytest.approx(wanted, rel=2 * form.eps, abs=least * form.eps)
    for a, b in ((0.0, 1.0), (0.0, -1.0), (-0.0, -1.0), (0.0, 0.0), (1.0, 0.0), (-1.0, -0.0)):
        assert RUNS[form](arcs, a, b) == NUMBER[form](math.atan2(a, b))


LENGTHS = [(3.0, -4.0), (0.0, 2.0), (1.0, 1e-3), (0.03, 0.04), (0.1, 0.0), (0.0, 0.0)]
# Sides whose squares overflow or underflow, up to the ends of the range.
ENDS = {
    DOUBLE: [(3e200, 4e200), (3e-200, 4e-200), (1e-300, 1e300), (1e308, 1e308), (5e-324, 5e-324)],
    SINGLE: [(3e25, 4e25), (3e-25, 4e-25), (1e-30, 1e30), (2e38, 2e38), (1.4e-45, 1.4e-45)],
}


@pytest.mark.parametrize("form", FORMATS, ids=lambda f: f.name)
def test_the_length_of_a_side_that_has_no_square(form: Format) -> None:
    program, smallest = build("hypot", form).program, 2.0 ** (3 - form.exponent - form.bits)
    ladder = [(0.7 * 2.0**n, 0.3 * 2.0**n) for n in range(-form.exponent, form.exponent - 1)]
    for pair in (*LENGTHS, *ENDS[form], *ladder):
        a, b = map(NUMBER[form], pair)
        found = RUNS[form](program, a, b)
        wanted = math.hypot(a, b)
        assert found == pytest.approx(wanted, rel=1.5 * form.eps, abs=smallest / 2)


@pytest.mark.parametrize(
    ("kind", "points", "values"),
    [
        ("exp", (0.0, 709.8, 1e9, math.inf), (1.0, math.inf, math.inf, math.inf)),
        ("exp", (-740.0, -745.0, -746.0, -math.inf), (4.2e-322, 5e-324, 0.0, 0.0)),
        ("normal_tail", (38.4, -38.4, 38.6, 1e300, -math.inf), (6.4e-323, 6.4e-323, 0.0, 0.0, 0.0)),
    ],
)
def test_the_ends_of_the_range(kind: str, points: Any, values: Any) -> None:
    program = build(kind, DOUBLE).program
    assert [run(program, x) for x in points] == list(values)
    assert math.isnan(run(program, math.nan))


@pytest.mark.parametrize("form", FORMATS, ids=lambda f: f.name)
def test_a_reduction_that_lost_a_word_is_seen(form, monkeypatch: pytest.MonkeyPatch) -> None:
    """The check above fails when pi/2 has only two words."""
    split = Format.split
    monkeypatch.setattr(Format, "split", lambda self, v, n: (*split(self, v, 2), 0.0)[:n])
    build.cache_clear()
    try:
        with pytest.raises(AssertionError):
            test_a_function_is_within_few_eps_where_reductions_fail("sin", form)
    finally:
        build.cache_clear()
