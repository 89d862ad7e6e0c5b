"""Prints that cannot be evaluated: a missing differential, an unbound symbol, mixed units."""

import pytest
import sympy as sp

from mechproof.proof.wellformed import find_faults
from mechproof.record import (
    LENGTH,
    NUMBER,
    Conjunction,
    Definition,
    Equality,
    Holds,
    IntegralWithoutDifferential,
    sum_distinct,
)
from mechproof.statement_domains.domain import Domain

x, y, u = sp.symbols("x y u", real=True)
a, b = sp.symbols("a b", positive=True)
n, i, j, k = sp.symbols("n i j k", integer=True, positive=True)
K = sp.IndexedBase("K", real=True)
KNOWN = {x: NUMBER, a: LENGTH, b: LENGTH, n: NUMBER, K: NUMBER}
DOMAIN = Domain({a: sp.Interval.open(0, sp.oo), b: sp.Interval.open(0, sp.oo)}, (), {})
BOUND = sum_distinct(K[i] * K[j], i, j, n)
FREE = sum_distinct(K[i] * K[j], i, k, n)

SOUND = {
    "bound indices": Equality(BOUND, FREE),
    "bound variable of an integral": Equality(sp.Integral(u, (u, 0, x)), x**2 / 2),
    "definition": Definition(x, sp.sqrt(x**2 + 1)),
    "inequality": Holds(sp.Ge(y, 0, evaluate=False)),
}
FAULTY = {
    "index bound by no sum": (Equality(FREE, BOUND), "j has no value there"),
    "undeclared symbol": (Equality(x + y, x), "y has no value there"),
    "no differential": (
        Equality(IntegralWithoutDifferential(x**2), x**3 / 3),
        "an integral has no differential",
    ),
    "mixed units": (Equality(a + b**2, a), "has dimension"),
    "unlike its symbol": (Definition(a, a * b), "has dimension"),
    "mixed units in an inequality": (Holds(sp.Gt(a + a**2, 0, evaluate=False)), "has dimension"),
    "in a definition": (Definition(x, x + y), "y has no value there"),
    "in the second part": (
        Conjunction((Equality(x, x), Equality(x, y), Equality(y, x))),
        "y has no value there",
    ),
}


@pytest.mark.parametrize("name", SOUND)
def test_a_sound_statement_has_no_fault(name):
    assert find_faults(SOUND[name], KNOWN, DOMAIN) == []


@pytest.mark.parametrize("name", FAULTY)
def test_a_fault_is_named_with_its_witness(name):
    statement, reason = FAULTY[name]
    (fault,) = find_faults(statement, KNOWN, DOMAIN)
    assert reason in fault.reason
    assert fault.evidence[0].what


def test_several_faults_are_all_named():
    both = Equality(a + b**2 + y, a)
    assert [fault.rung for fault in find_faults(both, KNOWN, DOMAIN)] == [
        "well-formedness",
        "dimensions",
    ]


def test_a_missing_differential_hides_its_units():
    integral = IntegralWithoutDifferential(a + b**2)
    (fault,) = find_faults(Equality(integral + b, a), KNOWN, DOMAIN)
    assert fault.reason == "an integral has no differential"
