"""Hostile statements for every rung: no false one proved, no true one convicted, no typo judged."""

import time
from collections.abc import Callable

import pytest
import sympy as sp
from sympy import (
    Abs,
    Integral,
    Rational,
    S,
    Sum,
    Symbol,
    acos,
    asin,
    atan,
    atan2,
    cos,
    exp,
    floor,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
)

from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import (
    LENGTH,
    Claim,
    Conjunction,
    Correction,
    Distinct,
    Equality,
    Holds,
    Paper,
    Part,
    PrintedNumber,
    Reading,
    RecordError,
    Row,
    Statement,
    Variable,
)
from mechproof.statement_domains.domain import Domain

x, y, z, t, k1, c, g = sp.symbols("x y z t _1 c g", real=True)
p, L, h = sp.symbols("p L h", positive=True)
n, m, k, j = sp.symbols("n m k j", integer=True, positive=True)
n0 = Symbol("n0", integer=True, nonnegative=True)
A, B = sp.IndexedBase("A", real=True), sp.IndexedBase("B", real=True)
POSITIVE = sp.Interval.open(0, sp.oo)
VARIABLES = (
    *(Variable(symbol, "a number") for symbol in (x, y, z, k1, A, B)),
    Variable(p, "a size", within=POSITIVE),
    Variable(L, "a length", LENGTH, POSITIVE),
    Variable(h, "a height", LENGTH, POSITIVE),
    Variable(n, "a count", within=S.Naturals),
    Variable(m, "a count", within=S.Naturals),
    Variable(n0, "a count from zero", within=S.Naturals0),
    Variable(c, "a constant", within=sp.FiniteSet(pi)),
    Variable(g, "a given number", given=2 * x),
)
PAPER = Paper("hostile", "nowhere", VARIABLES, ())
raw: dict[str, bool] = {"evaluate": False}


def gt(left: sp.Expr, right: sp.Expr) -> Holds:
    return Holds(sp.Gt(left, right, **raw))


def ge(left: sp.Expr, right: sp.Expr) -> Holds:
    return Holds(sp.Ge(left, right, **raw))


FALSE: dict[str, Statement] = {
    # definedness
    "root of what is never positive": ge(sqrt(-1 - x**2), 0),
    "root of what may be negative": ge(sqrt(x), 0),
    "logarithm of a square below zero": gt(exp(log(-1 - x**2)), 0),
    "arccosine out of reach": ge(acos(2 + x**2), 0),
    "square of a root": Equality(sp.Pow(sqrt(x), 2, **raw), x),
    "both sides nowhere": Equality(log(-1 - x**2) * 2 / 2, log(-1 - x**2) + x - x + 0 * y),
    "distinct where nothing is": Distinct(sqrt(-1 - x**2), sqrt(-2 - x**2)),
    # powers
    "power of a negative number": Holds(sp.Lt((-(p**2) + p - 1) ** (n * (n - 1) / 2), 0, **raw)),
    "power of a negative number, positive": gt((-p) ** n, 0),
    "power to a real exponent": gt((x**2 + 1 - 3 * x) ** y, 0),
    "even power, strictly": gt(x ** (2 * n), 0),
    "root of a power": Equality(sqrt(x ** (2 * n)), x**n),
    # counts
    "roots at two and three": Equality(n**2 - 5 * n + 6, 0),
    "roots at one to four": Equality((n - 1) * (n - 2) * (n - 3) * (n - 4), 0),
    "roots at two to seven": Equality(sp.prod([n - i for i in range(2, 8)]), 0),
    "unlike counts only": Holds(sp.Ne(n, m)),
    "difference of counts": Equality((n - m) ** 2, Abs(n - m)),
    "false from five on": Holds(sp.Lt(n, 5)),
    "floor of a part": Equality(floor(n / 4), 0),
    # sums
    "sum to a half": Equality(Sum(1, (k, 1, n / 2)), n / 2),
    "sum that may be empty": Equality(Sum(1, (k, 1, n - 5)), n - 5),
    "sum to a real number": Equality(Sum(1, (k, 1, x)), x),
    "sum to a negative number": Equality(Sum(p, (k, 1, -n)), -n * p),
    "double sum to a difference": Equality(Sum(1, (k, 1, n), (j, 1, m - 3)), n * (m - 3)),
    "capture of the index": Equality(Sum(k1 * A[k], (k, 1, n)), Sum(k * A[k], (k, 1, n))),
    "capture of the index, squares": Equality(Sum(k1, (k, 1, n)), Sum(k, (k, 1, n))),
    "one term short": Equality(Sum(A[k], (k, 1, n - 1)), Sum(A[k], (k, 1, n))),
    "sum of squares": Equality(Sum(k**2, (k, 1, n)), n * (n + 1) / 2),
    "square inside and outside": Equality(Sum(A[k] ** 2, (k, 1, n)), Sum(A[k], (k, 1, n)) ** 2),
    "product of sums": Equality(
        Sum(A[k] * B[k], (k, 1, n)), Sum(A[k], (k, 1, n)) * Sum(B[k], (k, 1, n))
    ),
    "shifted without its ends": Equality(Sum(A[k + 1], (k, 1, n)), Sum(A[k], (k, 1, n))),
    # special points
    "zero at zero": Equality(sign(x) ** 2, 1),
    "integer at one": Equality(sp.KroneckerDelta(x, 1), 0),
    "at a right angle": Equality(floor(sin(x) ** 2), 0),
    "at half a turn": gt(1 + cos(x), 0),
    "square above zero": gt(x**2, 0),
    "two squares above zero": gt(x**2 + (y - 1) ** 2, 0),
    "never one": Holds(sp.Ne(x, 1)),
    # circle
    "double angle": Equality(sin(2 * x), 2 * sin(x)),
    "sign of the cosine": Equality(sqrt(1 - sin(x) ** 2), cos(x)),
    "arctangent of the tangent": Equality(atan(tan(x)), x),
    "break at a quarter turn": Equality(atan(tan(x)) - x, 0),
    "tangent at a quarter turn": Holds(sp.Lt(atan(tan(x)) ** 2, 2, **raw)),
    "arcsine of the sine": Equality(asin(sin(x)), x),
    "sum of arctangents": Equality(atan(x) + atan(y), atan((x + y) / (1 - x * y))),
    "arctangent of the reciprocal": Equality(atan(x) + atan(1 / x), pi / 2),
    "argument by arctangent": Equality(atan2(y, x), atan(y / x)),
    "argument on the cut": Equality(atan2(x, y) + atan2(-x, y), 0),
    "half-angle root": Equality(sqrt((1 - cos(x)) / 2), sin(x / 2)),
    "thirty degrees": Equality(cos(pi / 6), S.Half),
    # radicals
    "root of a square": Equality(sqrt(x**2), x),
    "sum under a root": Equality(sqrt(x**2 + y**2), Abs(x) + Abs(y)),
    "root of a product of any sign": Equality(sqrt(x * y) ** 2, Abs(x * y)),
    "sign lost": Equality(1 / (sqrt(p + 1) - sqrt(p)), sqrt(p + 1) - sqrt(p)),
    # integrals
    "jumping antiderivative": Equality(
        Integral(1 / (2 + cos(t)), (t, 0, x)), 2 * atan(tan(x / 2) / sqrt(3)) / sqrt(3)
    ),
    "constant off": Equality(Integral(cos(t), (t, 0, x)), sin(x) + Rational(1, 10**9)),
    "over a pole": Equality(Integral(1 / t**2, (t, -1, 1)), -2),
    "absolute value": Equality(Integral(Abs(t), (t, 0, x)), x**2 / 2),
    "from the other end": Equality(Integral(exp(t), (t, 0, x)), exp(x)),
    # signs
    "mixed form": ge(x**2 - 3 * x * y + y**2, 0),
    "nearly a square": gt(x**2 - 2 * x + 1, 0),
    "sum of sine and cosine": ge(sqrt(2) - Rational(1, 10**6), sin(x) + cos(x)),
    "difference of sizes": gt(p, L / h),
    # numbers
    "a hundred digits": Equality(pi, Rational(str(pi.n(60)))),
    "not rounded": PrintedNumber("3.15", pi),
    "boundary": PrintedNumber("0.1", Rational(1501, 10000)),
    "tiny difference": Holds(sp.Gt(exp(pi * sqrt(163)), 640320**3 + 744, **raw)),
    # given, capture
    "given captures the index": Equality(Sum(g * k, (k, 1, n)), Sum(k**2, (k, 1, n))),
    # one part of many
    "false part": Conjunction((Equality(x, x), Equality(x, -x))),
    "false entry": Equality(sp.Matrix([[x, 1], [0, x]]), sp.Matrix([[x, 1], [0, -x]])),
    "shapes": Equality(sp.Matrix([x, y]), sp.Matrix([[x, y]])),
}
NOT_CONVICTED: dict[str, Statement] = {
    "irrational member of a finite set": Equality(c, pi),
    "sine at the member": Equality(sin(c), 0),
    "count from zero": ge(n0 * (n0 - 1), 0),
    "empty sum from zero": Equality(Sum(1, (k, 1, n0)), n0),
    "argument of a vector": Equality(atan2(x, p) + atan2(-x, p), 0),
    "largest of lengths": ge(sp.Max(L, h), L),
    "dimension in each piece": Holds(sp.Gt(sp.Piecewise((L, x > 0), (h, True)), 0, **raw)),
    "powers of lengths that cancel": Equality(L**n / L**n, 1),
    "sign of a length": Equality(sign(L), 1),
    "sine of a length, whatever its unit": Equality(sin(L) ** 2 + cos(L) ** 2, 1),
    "same name, other variable": Equality(Integral(x, (x, 0, x)), x**2 / 2),
    "nested indices of one name": Equality(Sum(Sum(k, (k, 1, m)), (k, 1, n)), n * m * (m + 1) / 2),
    "roots that have no value": Equality(sqrt(x) * sqrt(y), sqrt(x * y)),
    "logarithms that have no value": Equality(log(x) + log(y), log(x * y)),
    "a root of an odd power": Equality(x ** Rational(3, 2) * sqrt(y), x * sqrt(x * y)),
    "removable": Equality((x**2 - 1) / (x - 1), x + 1),
    "Python numbers": Equality(2, 2),
    "power with a count": Equality((x**n) ** 2, x ** (2 * n)),
}
other_x = Symbol("x", positive=True)
undeclared = Symbol("w", real=True)
even = Symbol("k", even=True, positive=True)
positive_t = Symbol("t", positive=True)
alien = Symbol("g_", real=True)


def corrected(says: Statement) -> Row:
    return Claim("c", "p", Equality(x, 2 * x), corrected=Correction("c", says))


def declared(symbol: Symbol, within: sp.Set = S.Reals) -> Callable[[], object]:
    return lambda: Domain.of(Paper("s", "c", (Variable(symbol, "s", within=within),), ()))


OURS: dict[str, Callable[[], object]] = {
    "positive in the extended sense": declared(Symbol("e", extended_positive=True)),
    "imaginary": declared(Symbol("e", imaginary=True)),
    "odd": declared(Symbol("e", odd=True), S.Naturals),
    "zero": declared(Symbol("e", zero=True)),
    "prime": declared(Symbol("e", prime=True), S.Naturals),
    "rational": declared(Symbol("e", rational=True)),
    "irrational": declared(Symbol("e", irrational=True), sp.Interval(0, 1)),
    "infinite": declared(Symbol("e", infinite=True)),
    "not commutative": declared(Symbol("e", commutative=False)),
    "not zero": declared(Symbol("e", nonzero=True)),
    "positive at zero": declared(Symbol("e", positive=True), sp.Interval(0, 1)),
    "integer between": declared(Symbol("e", integer=True), sp.Interval(0, 1)),
    "even index": lambda: Equality(Sum((-1) ** even, (even, 1, n)), n),
    "positive index from zero": lambda: Equality(Sum(Abs(k), (k, 0, n)), n * (n + 1) / 2),
    "positive integration variable": lambda: Equality(
        Integral(Abs(positive_t), (positive_t, 0, x)), x**2 / 2
    ),
    "undeclared symbol": lambda: Equality(x, undeclared),
    "undeclared symbol in a relation": lambda: gt(undeclared**2 + 1, 0),
    "undeclared symbol in a number": lambda: PrintedNumber("1", undeclared),
    "other assumptions, rebuilt": lambda: Equality(Abs(x), other_x),
    "other assumptions, printed": lambda: Equality(Abs(other_x), x),
    "undefined function": lambda: Equality(sp.Function("f", positive=True)(x), Abs(x)),
    "dimension of the rebuilt side": lambda: Equality(L, h**2),
    "mixture on the rebuilt side": lambda: Equality(L, h + h**2),
    "dimension of the right side": lambda: Distinct(L, h**2),
    "correction of other dimension": lambda: corrected(Equality(L + L**2, L * (1 + L))),
    "correction with an undeclared symbol": lambda: corrected(Equality(undeclared, x)),
    "reading with an undeclared symbol": lambda: Claim(
        "c", "p", Equality(x, 2 * x), readings=(Reading("r", Equality(undeclared, x)),)
    ),
    "number of a symbol": lambda: PrintedNumber("1", x),
    "a float": lambda: Equality(x, 0.1 * x),
    "a Python float": lambda: Equality(x, 0.1),
    "a text": lambda: Equality(x, "x"),
    "a truth": lambda: Equality(True, True),
    "a relation as a side": lambda: Equality(x > 0, x),
    "an expression as a relation": lambda: Holds(x),
    "a Python truth": lambda: Holds(True),
    "a relation as a statement": lambda: Claim("c", "p", sp.Eq(x, x, evaluate=False)),
    "no decimal number": lambda: PrintedNumber("1e+3", S(1000)),
    "no part": lambda: Conjunction(()),
    "part with an undeclared symbol": lambda: Claim(
        "c", "p", Equality(x, x + 0 * y), on=Part("w > 0", where=(undeclared > 0,))
    ),
}


def judge_what(state: Callable[[], object]) -> None:
    stated = state()
    judge(stated if isinstance(stated, Row) else Claim("c", "print", stated), PAPER)


@pytest.mark.slow
@pytest.mark.parametrize("name", FALSE)
def test_what_is_false_is_not_proved(name: str) -> None:
    judgement = judge(Claim("c", "print", FALSE[name]), PAPER)
    assert judgement.verdict in (Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED)


@pytest.mark.parametrize("name", NOT_CONVICTED)
def test_what_is_true_is_not_convicted(name: str) -> None:
    judgement = judge(Claim("c", "print", NOT_CONVICTED[name]), PAPER)
    assert judgement.verdict not in (Verdict.REFUTED, Verdict.ILL_FORMED)


HEAVY: dict[str, Statement] = {
    "tower": Equality(sp.Pow(9, sp.Pow(9, sp.Pow(9, 9, **raw), **raw), **raw), sp.Pow(9, x, **raw)),
    "high power": Equality((x + y) ** 5000, (x + y + z) ** 5000),
    "large multiple": Equality(cos(10**6 * x), 2 * cos(5 * 10**5 * x) ** 2 - 1),
    "sign of a high power": gt((x**2 + x + 1) ** 4000 + x**2, 0),
    "high power in a modulus": ge(Abs((x + y + z) ** 4000 + y) + Abs(y), Abs(x)),
    "slope of a high power": ge(Abs(x - y), Abs((x + 1) ** 4000 - (y + 1) ** 4000)),
    "many terms": Equality(Sum(1 / k**2, (k, 1, 10**9)), pi**2 / 6),
    "high power in a sum": Equality(Sum((A[k] + 1) ** 3000, (k, 1, n)), 0),
}


@pytest.mark.parametrize("name", HEAVY)
def test_what_is_too_much_work_is_left_open_at_once(name: str) -> None:
    begun = time.process_time()
    judgement = judge(Claim("c", "print", HEAVY[name]), PAPER)
    assert judgement.verdict is not Verdict.PROVED
    assert time.process_time() - begun < 30


TAUGHT: dict[str, tuple[Statement, str]] = {
    "sign under a root": (
        Equality(sqrt((x**3 - y) ** 2), Abs(x**3 - y) + sp.erf(x) + sp.erfc(x) - 1),
        "is not shown to be zero",
    ),
    "break": (
        Equality(Integral(sign(cos(t)), (t, 0, x)), asin(sin(x))),
        "was not shown to be continuous in x over the domain",
    ),
    "inequality": (
        ge(sqrt(floor(p)), floor(sqrt(p))),
        "the sign of -floor(sqrt(p)) + sqrt(floor(p)) is not shown",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", TAUGHT)
def test_what_is_left_open_says_what_is_not_shown(name: str) -> None:
    statement, reason = TAUGHT[name]
    assert reason in judge(Claim("c", "print", statement), PAPER).reason


@pytest.mark.parametrize("name", OURS)
def test_what_is_wrong_on_our_side_is_an_error_and_no_verdict(name: str) -> None:
    with pytest.raises(RecordError):
        judge_what(OURS[name])
