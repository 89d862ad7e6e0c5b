"""Keys of records: the same in every process for equal records, and different for all others."""

from __future__ import annotations

import os
import subprocess
import sys
from itertools import combinations

import pytest
import sympy as sp

from mechproof.ledger.verdict_cache import Fingerprint, NoFingerprintError
from mechproof.record import Claim, Equality, Holds, Part, PrintedNumber, Variable

x, y = sp.symbols("x y", real=True)
n = sp.Symbol("n", integer=True)
c = sp.IndexedBase("c")
f = sp.Function("f")
DISTINCT = [
    sp.Symbol("x"),
    x,
    y,
    x + y,
    x * y,
    x**2,
    sp.sin(x),
    f(x),
    sp.Function("f", real=True)(x),
    sp.Function("g")(x),
    sp.Integer(1),
    sp.Rational(1, 2),
    sp.Float("0.5"),
    sp.Float("0.5", 30),
    "x",
    1,
    True,
    1.0,
    None,
    (x, y),
    (x, (y,)),
    ((x,), y),
    ("ab", "c"),
    ("a", "bc"),
    {x: y},
    {y: x},
    sp.Matrix([[x, y]]),
    sp.Matrix([x, y]),
    sp.Interval(0, 1),
    sp.Interval.open(0, 1),
    x < y,
    x <= y,
    sp.Eq(x, y),
    c[n],
    sp.Sum(c[n], (n, 1, 3)),
    sp.Sum(c[n], (n, 1, 4)),
    sp.Piecewise((x, x > 0), (y, True)),
    Equality(x, y),
    Equality(y, x),
    Holds(x < y),
    PrintedNumber("1.0", x),
    PrintedNumber("1.00", x),
    Part("x > 0", where=(x > 0,)),
    Part("x > 0", within={x: sp.Interval(0, 1)}),
    Variable(x, "a number"),
    Claim("1", "x", Holds(x < y)),
    Claim("1", "x", Holds(x < y), note="so"),
]


def key(part: object) -> str:
    return Fingerprint().visit(part)


def test_unlike_records_have_unlike_keys() -> None:
    keys = list(map(key, DISTINCT))
    alike = [
        (DISTINCT[i], DISTINCT[j])
        for i, j in combinations(range(len(keys)), 2)
        if keys[i] == keys[j]
    ]
    assert alike == []


def test_equal_records_have_equal_keys() -> None:
    assert key(Equality(x + y, y * x)) == key(Equality(y + x, x * y))
    assert key({x: 1, y: 2}) == key({y: 2, x: 1})
    assert key(sp.Matrix([x])) == key(sp.Matrix([x]))


def test_dummies_are_told_apart_and_not_by_their_chance_numbers() -> None:
    def statement(same: bool) -> Equality:
        one, other = sp.Dummy("d"), sp.Dummy("d")
        return Equality(one - 2 * (one if same else other), x)

    assert key(statement(True)) == key(statement(True))
    assert key(statement(False)) == key(statement(False))
    assert key(statement(True)) != key(statement(False))


def test_a_copy_goes_on_with_the_dummies_met() -> None:
    one, other = sp.Dummy("d"), sp.Dummy("d")
    start = Fingerprint()
    start.visit(one)
    assert start.copy().visit(one) != start.copy().visit(other)


class Own(sp.Function):  # type: ignore[misc]
    """A function whose code no key can cover."""


@pytest.mark.parametrize("part", [lambda: 1, Own(x), Equality(Own(x), x), object()])
def test_what_cannot_be_compared_is_refused(part: object) -> None:
    with pytest.raises(NoFingerprintError):
        key(part)


@pytest.mark.slow
def test_the_key_is_the_same_in_every_process() -> None:
    code = (
        "import sympy as sp; from mechproof.ledger.verdict_cache import Fingerprint;"
        "a, b, d = *sp.symbols('a b', real=True), sp.Dummy('d');"
        "e = sp.And(a < b, sp.FiniteSet(a, b, 1).contains(d), evaluate=False);"
        "print(Fingerprint().visit((e, {a: 1, b: 2}, sp.sin(a*b) + sp.Abs(b) + d)))"
    )
    keys = {
        subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2", "3")
    }
    assert len(keys) == 1
