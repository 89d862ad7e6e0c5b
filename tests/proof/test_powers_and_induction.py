"""Normal forms of logarithms and powers, sums by induction: true ones are proved, no others."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.proof import induction, powers
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality
from mechproof.statement_domains.domain import Domain

a, b, q, u, v = sp.symbols("a b q u v", real=True)
n, m = sp.symbols("n m", integer=True, positive=True)
k = sp.Symbol("k", integer=True)
POSITIVE = sp.Interval.open(0, sp.oo)
DOMAIN = Domain(
    {a: POSITIVE, b: POSITIVE, q: sp.Interval.open(0, 1), n: sp.S.Naturals, m: sp.S.Naturals},
    (),
    {},
)


def total(term: sp.Expr, first: int, last: sp.Expr = n) -> sp.Sum:
    return sp.Sum(term, (k, first, last))


POWERS = {
    "exponents add up": (a ** (u + v), a**u * a**v),
    "a product": ((a * b) ** u, a**u * b**u),
    "a power of a power": ((a**u) ** v, a ** (u * v)),
    "logarithm of a power": (sp.log(a**u), u * sp.log(a)),
    "exchanged": (a ** sp.log(b), b ** sp.log(a)),
}
SUMS = {
    "geometric": (total(q**k, 0), (1 - q ** (n + 1)) / (1 - q)),
    "telescoping": (total(1 / (k * (k + 1)), 1), n / (n + 1)),
    "arithmetic and geometric": (
        total(k * q**k, 0),
        q * (1 - (n + 1) * q**n + n * q ** (n + 1)) / (1 - q) ** 2,
    ),
    "factorials": (total(k * sp.factorial(k), 1), sp.factorial(n + 1) - 1),
    "to n - 1": (total(2**k, 0, n - 1), 2**n - 1),
}


@pytest.mark.parametrize("name", POWERS)
def test_powers_are_proved_and_their_wrong_neighbours_refuted(name: str) -> None:
    left, right = POWERS[name]
    assert decide(Equality(left, right), DOMAIN).verdict is Verdict.PROVED
    assert powers.decide_by_logarithms(left, right, DOMAIN) == powers.RUNG
    assert powers.decide_by_logarithms(left, right * a**q, DOMAIN) is None
    assert decide(Equality(left, right * a**q), DOMAIN).verdict is Verdict.REFUTED


@pytest.mark.parametrize("name", SUMS)
def test_sums_are_proved_and_their_wrong_neighbours_refuted(name: str) -> None:
    left, right = SUMS[name]
    answer = decide(Equality(left, right), DOMAIN)
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, induction.RUNG)
    assert decide(Equality(left, right + 1 / n), DOMAIN).verdict is Verdict.REFUTED
    assert decide(Equality(left, right.subs(n, n + 1)), DOMAIN).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (sp.log(u**2), 2 * sp.log(u)),
        (sp.log(u * v), sp.log(u) + sp.log(v)),
        ((u * v) ** q, u**q * v**q),
        ((u**2) ** q, u ** (2 * q)),
    ],
)
def test_without_the_signs_nothing_is_rewritten(left: sp.Expr, right: sp.Expr) -> None:
    assert powers.decide_by_logarithms(left, right, DOMAIN) is None
    assert decide(Equality(left, right), DOMAIN).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (total(k, 1), n * (n + 1) / 2 + sp.Rational(1, 3)),
        (total(k, 1), n**2),
        (total(q ** (k * n), 0), (1 - q ** (n * (n + 1))) / (1 - q**n)),
        (total(k, 4), n * (n + 1) / 2 - 6),
    ],
    ids=["begins elsewhere", "grows otherwise", "n in the term", "begins above 1"],
)
def test_what_does_not_begin_or_grow_alike_is_no_induction(left: sp.Expr, right: sp.Expr) -> None:
    assert induction.decide_by_induction(left, right, DOMAIN) is None
