"""Sums with a symbolic number of terms: identities for every n, and near misses."""

import pytest
import sympy as sp

from mechproof.proof.canonical_sums import canonicalise
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, sum_distinct
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import prepare

n, m = sp.symbols("n m", integer=True, positive=True)
i, j, k = sp.symbols("i j k", integer=True, positive=True)
K, T, R, a, b = (sp.IndexedBase(name, real=True) for name in ["K", "T", "R", "a", "b"])
scale = sp.Symbol("s", real=True)
COUNTS = Domain({n: sp.S.Naturals, m: sp.S.Naturals}, (), {})
DELTA = sp.KroneckerDelta(i, j)


def total(term, *indices):
    """Return the sum of `term` with every index running from 1 to n."""
    return sp.Sum(term, *((index, 1, n) for index in indices))


TRUE = {
    "constant": (total(scale, i), n * scale),
    "factor in front": (total(scale * a[i], i), scale * total(a[j], j)),
    "square of a sum": (total(a[i], i) ** 2, total(a[i] * a[j], i, j)),
    "sums of unlike counts": (
        sp.Sum(a[i] * b[j], (i, 1, n), (j, 1, m)),
        sp.Sum(a[i], (i, 1, n)) * sp.Sum(b[i], (i, 1, m)),
    ),
    "diagonal": (total(a[i] * a[j] * DELTA, i, j), total(a[i] ** 2, i)),
    "off the diagonal": (
        sum_distinct(a[i] * a[j], i, j, n),
        total(a[i], i) ** 2 - total(a[i] ** 2, i),
    ),
    "indices swapped throughout": (
        total(K[i] * K[j] * R[i, j], i, j),
        total(K[j] * K[i] * R[j, i], j, i),
    ),
    "nested, same letter": (total(a[i] * total(a[i], i), i), total(a[i], i) ** 2),
    "variance of a mean": (total(DELTA / n**2, i, j), 1 / n),
    "root of a sum": (sp.sqrt(total((scale * a[i]) ** 2, i)) ** 2, scale**2 * total(a[i] ** 2, i)),
}

WRONG = {
    "constant": (total(scale, i), scale),
    "true for one and two terms only": (
        total(a[i], i) ** 2,
        total(a[i] ** 2, i) + 2 * a[1] * a[2],
    ),
    "true for n = 2 only": (total(a[i] ** 2, i) * (n - 2), sp.Integer(0)),
    "true for n = 2, not for 3": (n * (n - 1) * total(a[i], i), n * total(a[i], i)),
    "square inside": (total(a[i], i) ** 2, total(a[i] ** 2, i)),
    "cross terms not doubled": (sum_distinct(a[i] * a[j], i, j, n), total(a[i], i) ** 2),
    "index swapped in one factor": (
        total(K[i] * T[j] * R[i, j], i, j),
        total(K[j] * T[j] * R[i, j], i, j),
    ),
    "index swapped in a matrix": (
        total(K[i] * T[j] * R[i, j], i, j),
        total(K[i] * T[j] * R[j, i], i, j),
    ),
    "sum over the wrong index": (total(K[i] * R[i, j], i), total(K[i] * R[i, j], j)),
    "other upper limit": (sp.Sum(a[i], (i, 1, n)), sp.Sum(a[i], (i, 1, m))),
    "counts swapped": (sp.Sum(1, (i, 1, n), (j, 1, m)), n**2),
    "limit that depends on an index": (
        total(a[i] * sp.Sum(b[j], (j, 1, i)), i),
        total(a[i], i) * total(b[j], j),
    ),
    "limit that starts later": (sp.Sum(a[i], (i, 2, n)), sp.Sum(a[i], (i, 1, n))),
    "delta in a denominator": (total(1 / (2 - DELTA), i, j), n),
    "delta in an exponent": (total(2**DELTA, i, j), 2 * n),
    "reciprocal of a sum": (total(1 / a[i], i), 1 / total(a[i], i)),
    "root of a sum of squares": (sp.sqrt(total(a[i] ** 2, i)), total(a[i], i)),
}


@pytest.mark.parametrize("name", TRUE)
def test_an_identity_for_every_count_is_proved(name):
    answer = decide(Equality(*TRUE[name]), COUNTS)
    assert (answer.verdict, answer.rung) == (Verdict.PROVED, "symbolic sum")


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_neighbour_is_not_proved(name):
    assert decide(Equality(*WRONG[name]), COUNTS).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    "node",
    [
        sp.Sum(a[i], (i, 1, n - 5)),
        total(a[i] * sp.Sum(b[j], (j, 1, i)), i),
        total(1 / (2 - DELTA), i, j),
        total(sp.KroneckerDelta(i, k) * a[i], i),
    ],
    ids=str,
)
def test_a_sum_without_a_canonical_form_is_refused(node):
    with pytest.raises(NotImplementedError):
        canonicalise(node, Domain({}, (), {}))


def test_a_sum_that_ends_before_it_begins_has_no_value():
    empty, reversed_one = sp.Sum(i, (i, 3, 2)), sp.Sum(i, (i, 3, 1))
    assert prepare(empty) == 0
    assert prepare(reversed_one) == reversed_one
    assert decide(Equality(empty, sp.Integer(0)), COUNTS).verdict is Verdict.PROVED
    assert decide(Equality(scale + reversed_one, scale - 2), COUNTS).verdict is Verdict.UNDECIDED
