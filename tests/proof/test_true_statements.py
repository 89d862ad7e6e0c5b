"""True statements of textbooks: none convicted, most of them proved, each within seconds."""

import pytest
import sympy as sp
from sympy import (
    Abs,
    Integral,
    KroneckerDelta,
    Max,
    Min,
    Rational,
    Sum,
    acos,
    asin,
    atan,
    atan2,
    cos,
    cot,
    exp,
    log,
    pi,
    sin,
    sqrt,
    tan,
)
from weights import make_thorough

from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Claim, Equality, Holds, Paper, Statement, Variable

x, y, z, t, u = sp.symbols("x y z t u", real=True)
p, q, r = sp.symbols("p q r", positive=True)
s = sp.Symbol("s", real=True)  # within (-1, 1)
w = sp.Symbol("w", real=True)  # within (-pi/2, pi/2)
n, m, k, j = sp.symbols("n m k j", integer=True, positive=True)
i = sp.Symbol("i", integer=True)
A, B = sp.IndexedBase("A", real=True), sp.IndexedBase("B", real=True)
POSITIVE = sp.Interval.open(0, sp.oo)
PAPER = Paper(
    "textbook",
    "a textbook",
    (
        *(Variable(symbol, "a number") for symbol in (x, y, z, A, B)),
        *(Variable(symbol, "a size", within=POSITIVE) for symbol in (p, q, r)),
        Variable(s, "a sine", within=sp.Interval.open(-1, 1)),
        Variable(w, "an angle within a quarter turn", within=sp.Interval.open(-pi / 2, pi / 2)),
        Variable(n, "a count", within=sp.S.Naturals),
        Variable(m, "another count", within=sp.S.Naturals),
    ),
    (),
)


def ge(left: sp.Expr, right: sp.Expr) -> Holds:
    return Holds(sp.Ge(left, right, evaluate=False))


def gt(left: sp.Expr, right: sp.Expr) -> Holds:
    return Holds(sp.Gt(left, right, evaluate=False))


def total(term: sp.Expr, *indices: sp.Symbol, upper: sp.Expr = n) -> sp.Sum:
    return Sum(term, *((index, 1, upper) for index in indices))


MEAN = total(A[k], k) / n
ROTATION = sp.ImmutableMatrix([[cos(x), -sin(x)], [sin(x), cos(x)]])

PROVED: dict[str, Statement] = {
    "square of a sum": Equality((x + y) ** 2, x**2 + 2 * x * y + y**2),
    "sum of cubes": Equality(x**3 + y**3, (x + y) * (x**2 - x * y + y**2)),
    "partial fractions": Equality(1 / (x * (x + 1)), 1 / x - 1 / (x + 1)),
    "two squares": Equality((x**2 + y**2) * (z**2 + 1), (x * z - y) ** 2 + (x + y * z) ** 2),
    "sixth powers": Equality(
        x**6 - y**6, (x - y) * (x + y) * (x**2 + x * y + y**2) * (x**2 - x * y + y**2)
    ),
    "Pythagoras": Equality(sin(x) ** 2 + cos(x) ** 2, 1),
    "sine of a sum": Equality(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),
    "sine of three angles": Equality(sin(3 * x), 3 * sin(x) - 4 * sin(x) ** 3),
    "tangent of a sum": Equality(tan(x + y), (tan(x) + tan(y)) / (1 - tan(x) * tan(y))),
    "cosine of five angles": Equality(cos(5 * x), 16 * cos(x) ** 5 - 20 * cos(x) ** 3 + 5 * cos(x)),
    "product of sines": Equality(2 * sin(x) * sin(y), cos(x - y) - cos(x + y)),
    "sum of sines": Equality(sin(x) + sin(y), 2 * sin((x + y) / 2) * cos((x - y) / 2)),
    "half-angle tangent": Equality(tan(x / 2), sin(x) / (1 + cos(x))),
    "half-angle tangent, other": Equality(tan(x / 2), (1 - cos(x)) / sin(x)),
    "cotangent": Equality(cot(x) - tan(x), 2 * cot(2 * x)),
    "secants": Equality(1 + tan(x) ** 2, 1 / cos(x) ** 2),
    "fourth powers": Equality(sin(x) ** 4 + cos(x) ** 4, 1 - sin(2 * x) ** 2 / 2),
    "turned by sixty degrees": Equality(sin(x) * sin(pi / 3 - x) * sin(pi / 3 + x), sin(3 * x) / 4),
    "quarter turn": Equality(sin(x + pi / 2), cos(x)),
    "cosine of thirty-six degrees": Equality(cos(pi / 5), (1 + sqrt(5)) / 4),
    "cosine of fifteen degrees": Equality(cos(pi / 12), (sqrt(6) + sqrt(2)) / 4),
    "tangent of an eighth": Equality(tan(pi / 8), sqrt(2) - 1),
    "rotation keeps lengths": Equality(
        (ROTATION * sp.Matrix([y, z])).dot(ROTATION * sp.Matrix([y, z])), y**2 + z**2
    ),
    "rotations add": Equality(ROTATION * ROTATION.subs(x, y), ROTATION.subs(x, x + y)),
    "law of cosines": Equality(
        (p * cos(x) - q) ** 2 + p**2 * sin(x) ** 2, p**2 + q**2 - 2 * p * q * cos(x)
    ),
    "root of a square": Equality(sqrt(x**2), Abs(x)),
    "root of a product": Equality(sqrt(p * q), sqrt(p) * sqrt(q)),
    "root of a quotient": Equality(sqrt(p / q), sqrt(p * q) / q),
    "rationalised": Equality(1 / (sqrt(p + 1) + sqrt(p)), sqrt(p + 1) - sqrt(p)),
    "nested root": Equality(sqrt(p**2 + 2 * p + 1), p + 1),
    "cosine of the arcsine": Equality(cos(asin(s)), sqrt(1 - s**2)),
    "cosine of the arctangent": Equality(cos(atan(x)), 1 / sqrt(1 + x**2)),
    "sine of the double arctangent": Equality(sin(2 * atan(x)), 2 * x / (1 + x**2)),
    "cosine within a quarter turn": Equality(sqrt(1 - sin(w) ** 2), cos(w)),
    "arctangents of reciprocals": Equality(atan(p) + atan(1 / p), pi / 2),
    "arctangent by atan2": Equality(atan2(y, p), atan(y / p)),
    "scaled atan2": Equality(atan2(p * sin(w), p * cos(w)), w),
    "arcsine and arccosine": Equality(asin(s) + acos(s), pi / 2),
    "arcsine as arctangent": Equality(asin(s), atan(s / sqrt(1 - s**2))),
    "arctangent of the tangent": Equality(atan(tan(w)), w),
    "integral of a square": Equality(Integral(t**2, (t, 0, x)), x**3 / 3),
    "integral of the cosine": Equality(Integral(cos(t), (t, 0, x)), sin(x)),
    "arctangent as an integral": Equality(Integral(1 / (1 + t**2), (t, 0, x)), atan(x)),
    "exponential as an integral": Equality(Integral(exp(t), (t, 0, x)), exp(x) - 1),
    "sine squared": Equality(Integral(sin(t) ** 2, (t, 0, x)), x / 2 - sin(2 * x) / 4),
    "integral turned round": Equality(Integral(cos(t), (t, x, 0)), -sin(x)),
    "integral over a scaled variable": Equality(
        Integral(p / (1 + p**2 * t**2), (t, 0, x)), atan(p * x)
    ),
    "unused index": Equality(total(x, k), n * x),
    "linear sum": Equality(total(A[k] + B[k], k), total(A[k], k) + total(B[k], k)),
    "constant in front": Equality(total(x * A[k], k), x * total(A[k], k)),
    "renamed index": Equality(total(A[k], k), total(A[j], j)),
    "square of a total": Equality(total(A[k], k) ** 2, total(A[k] * A[j], k, j)),
    "delta": Equality(total(A[k] * A[j] * KroneckerDelta(k, j), k, j), total(A[k] ** 2, k)),
    "deviations vanish": Equality(total(A[k] - MEAN, k), 0),
    "sum of squared deviations": Equality(
        total((A[k] - MEAN) ** 2, k), total(A[k] ** 2, k) - n * MEAN**2
    ),
    "pairs of differences": Equality(
        total((A[k] - A[j]) ** 2, k, j), 2 * n * total(A[k] ** 2, k) - 2 * total(A[k], k) ** 2
    ),
    "off the diagonal": Equality(
        total(A[k] * A[j] * (1 - KroneckerDelta(k, j)), k, j),
        total(A[k], k) ** 2 - total(A[k] ** 2, k),
    ),
    "double sum of two lengths": Equality(
        Sum(A[k] * B[j], (k, 1, n), (j, 1, m)), total(A[k], k) * total(B[k], k, upper=m)
    ),
    "sum of numbers": Equality(total(k, k), n * (n + 1) / 2),
    "sum of squares": Equality(total(k**2, k), n * (n + 1) * (2 * n + 1) / 6),
    "sum of cubes by square": Equality(total(k**3, k), total(k, k) ** 2),
    "sum of odd numbers": Equality(total(2 * k - 1, k), n**2),
    "sum from zero": Equality(Sum(A[i], (i, 0, n)), A[0] + total(A[k], k)),
    "sum to the next": Equality(Sum(A[k], (k, 1, n + 1)), total(A[k], k) + A[n + 1]),
    "two squares bound a product": ge(x**2 + y**2, 2 * x * y),
    "means": ge((p + q) / 2, sqrt(p * q)),
    "a number and its reciprocal": ge(p + 1 / p, 2),
    "no real root": gt(x**2 + x + 1, 0),
    "cosine at most one": ge(1, cos(x)),
    "combined sine": ge(2, (sin(x) + cos(x)) ** 2),
    "positive cosine": gt(cos(w), 0),
    "below one": gt(1, p / (1 + p)),
    "fourth degree": gt(x**4 - x + 1, 0),
    "quadratic form": ge(x**2 + y**2 + z**2, x * y + y * z + z * x),
    "count": ge(n**2, n),
    "number of pairs": ge(n * (n - 1) / 2, 0),
}

NOT_CONVICTED: dict[str, Statement] = {
    "root of a full square": Equality(sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
    "arctangent of a half": Equality(atan(Rational(1, 2)) + atan(Rational(1, 3)), pi / 4),
    "logarithm as an integral": Equality(Integral(1 / t, (t, 1, p)), log(p)),
    "integral of a root": Equality(
        Integral(sqrt(t), (t, 0, p)), Rational(2, 3) * p ** Rational(3, 2)
    ),
    "length of a parabola": Equality(
        Integral(sqrt(1 + t**2), (t, 0, x)),
        (x * sqrt(1 + x**2) + log(x + sqrt(1 + x**2))) / 2,
    ),
    "larger root": gt(sqrt(p + 1), sqrt(p)),
    "larger of two": Equality(Max(x, y) + Min(x, y), x + y),
    "maximum by the absolute value": Equality(Max(x, y), (x + y + Abs(x - y)) / 2),
    "absolute value of a product": Equality(Abs(x * y), Abs(x) * Abs(y)),
    "logarithm of a product": Equality(log(p * q), log(p) + log(q)),
    "exponential of a sum": Equality(exp(x + y), exp(x) * exp(y)),
    "integral of the absolute value": Equality(Integral(Abs(t), (t, 0, x)), x * Abs(x) / 2),
    "geometric sum": Equality(total(p**k, k) * (p - 1), p ** (n + 1) - p),
    "alternating sum": Equality(total((-1) ** k, k), ((-1) ** n - 1) / 2),
    "triangle inequality": ge(Abs(x) + Abs(y), Abs(x + y)),
    "Cauchy and Schwarz": ge(total(A[k] ** 2, k) * total(B[k] ** 2, k), total(A[k] * B[k], k) ** 2),
    "sine below its angle": ge(p, sin(p)),
    "exponential above its tangent": ge(exp(x), 1 + x),
    "error functions": Equality(sp.erf(x) + sp.erfc(x), 1),
    "even power": ge(x ** (2 * n), 0),
    "telescoping": Equality(total(1 / (k * (k + 1)), k), n / (n + 1)),
}
CONVICTED = (Verdict.REFUTED, Verdict.ILL_FORMED, Verdict.CONDITIONAL)


def verdict_of(statement: Statement) -> Verdict:
    return judge(Claim("c", "print", statement), PAPER).verdict


@pytest.mark.slow
@pytest.mark.parametrize("name", PROVED)
def test_it_is_proved(name: str) -> None:
    assert verdict_of(PROVED[name]) is Verdict.PROVED


# Enclosing these integrals at many points takes seconds each.
SLOW = ("integral of a root", "integral of the absolute value", "length of a parabola")


@pytest.mark.slow
@pytest.mark.parametrize("name", [make_thorough(n) if n in SLOW else n for n in NOT_CONVICTED])
def test_it_is_not_convicted(name: str) -> None:
    assert verdict_of(NOT_CONVICTED[name]) not in CONVICTED
