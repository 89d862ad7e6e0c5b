"""Domains: given symbols, relations, exact points inside, and what is refused."""

import pytest
import sympy as sp

from mechproof.proof.ladder import decide
from mechproof.proof.refutation import points_for
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, Holds, Paper, Part, Variable
from mechproof.statement_domains.domain import Domain

x, y, z = sp.symbols("x y z", real=True)
n, m = sp.symbols("n m", integer=True, positive=True)
SETS = {
    "open": sp.Interval.open(0, 1),
    "closed": sp.Interval(-2, 3),
    "half line": sp.Interval(1, sp.oo),
    "left half line": sp.Interval.open(-sp.oo, -1),
    "irrational ends": sp.Interval.open(-sp.pi, sp.pi),
    "narrow, irrational ends": sp.Interval(sp.sqrt(2), sp.sqrt(2) + sp.Rational(1, 5000)),
    "line": sp.S.Reals,
    "counts": sp.S.Naturals,
    "two values": sp.FiniteSet(1, 2),
}


def paper(*variables, where=()):
    return Paper("system", "citation", variables, (), where=where)


@pytest.mark.parametrize("name", SETS)
def test_points_lie_in_the_set(name):
    points = Domain({x: SETS[name]}, (), {}).points([x], 40)
    assert len(points) >= 40
    assert all(point[x] in SETS[name] for point in points)


def test_points_are_exact_and_always_the_same():
    domain = Domain({x: SETS["open"], y: SETS["line"]}, (), {})
    first, second = domain.points([x, y], 30), domain.points([y, x], 30)
    assert first == second
    assert all(value.is_Rational for point in first for value in point.values())
    assert len({tuple(point.values()) for point in first}) == len(first)


def test_points_satisfy_relations_that_reach_them_through_others():
    domain = Domain({z: sp.Interval.open(0, 1)}, (x < y, y < z), {})
    assert all(point[x] < point[y] < point[z] for point in domain.points([x], 10))
    assert decide(Holds(x < 1), domain).verdict is not Verdict.REFUTED


def test_counts_satisfy_relations():
    domain = Domain({n: sp.S.Naturals, m: sp.S.Naturals}, (n > 3, m < n), {})
    points = points_for((n * m * x,), domain, 5)
    assert all(point[n] > 3 and point[m] < point[n] for point in points)
    assert decide(Holds(n**2 > 10), domain).verdict is not Verdict.REFUTED


@pytest.mark.thorough
def test_points_satisfy_relations_of_elements():
    i, j = sp.symbols("i j", integer=True)
    c, d = sp.IndexedBase("c", real=True), sp.IndexedBase("d", real=True)
    square = sp.Sum(c[i, j] * d[i] * d[j], (i, 1, n), (j, 1, n))
    where = (sp.Eq(c[i, i], 1), sp.Eq(c[i, j], c[j, i]), square >= 0, x < d[i])
    domain = Domain({c: sp.Interval(-1, 1), d: sp.S.Reals}, where, {})
    points = list(points_for((square + x,), domain, 5))
    assert len(points) >= 10
    for point in points:
        counted = range(1, int(point[n]) + 1)
        assert all(point[c[k, k]] == 1 for k in counted)
        assert all(point[c[k, m]] == point[c[m, k]] for k in counted for m in counted)
        assert all(point[x] < point[d[k]] for k in counted)
        assert square.subs(n, point[n]).doit().xreplace(point) >= 0
    assert decide(Holds(sp.Ge(c[1, 1] * x**2, 0)), domain).verdict is not Verdict.REFUTED
    assert decide(Equality(c[1, 2], c[2, 1]), domain).verdict is not Verdict.REFUTED
    assert decide(Equality(c[1, 2], c[1, 3]), domain).verdict is Verdict.REFUTED


def test_unlike_counts_get_unlike_values():
    assert all(p[n] != p[m] for p in points_for((n * m,), Domain({}, (), {}), 3))
    assert decide(Equality(n, m), Domain({}, (), {})).verdict is Verdict.REFUTED


def test_an_empty_domain_is_an_error():
    with pytest.raises(ValueError, match="no point found in the domain"):
        decide(Holds(sp.Gt(x, y)), Domain({}, (x > y + 1, y > x + 1), {}))


def test_given_symbols_are_put_in():
    domain = Domain.of(
        paper(Variable(x, "x"), Variable(y, "y", given=2 * x), Variable(z, "z", given=y + 1))
    )
    assert domain.resolve(z * y) == 2 * x * (2 * x + 1)


def test_symbols_given_in_a_circle_are_refused():
    domain = Domain({}, (), {x: y + 1, y: x - 1})
    with pytest.raises(ValueError, match="defined in terms of each other"):
        domain.resolve(x)


def test_a_part_can_be_stated_in_a_given_symbol():
    known = paper(Variable(x, "x"), Variable(y, "y", given=3 * x))
    domain = Domain.of(known, Part("|y| < 1", {y: sp.Interval.open(-1, 1)}))
    assert domain.resolve(x) == y / 3
    assert domain.set_of(y) == sp.Interval.open(-1, 1)


def test_a_part_in_a_given_symbol_that_cannot_be_solved_is_refused():
    known = paper(Variable(x, "x"), Variable(y, "y", given=x**2))
    with pytest.raises(ValueError, match="cannot be solved"):
        Domain.of(known, Part("y < 1", {y: sp.Interval.open(0, 1)}))


@pytest.mark.parametrize("where", [sp.S.Rationals, sp.Union(sp.Interval(0, 1), sp.Interval(2, 3))])
def test_a_set_without_a_rule_for_points_is_refused(where):
    with pytest.raises(ValueError, match=r"x in .* use an Interval"):
        Domain.of(paper(Variable(x, "x", within=where)))


@pytest.mark.parametrize(
    ("symbol", "where"),
    [
        (sp.Symbol("p", positive=True), sp.S.Reals),
        (sp.Symbol("p", positive=True), sp.Interval(0, 1)),
        (sp.Symbol("p", nonnegative=True), sp.Interval(-1, 1)),
        (sp.IndexedBase("p", positive=True), sp.Interval(-1, 1)),
    ],
)
def test_a_symbol_must_not_be_declared_narrower_than_its_set(symbol, where):
    with pytest.raises(ValueError, match="the set does not imply all assumptions"):
        Domain.of(paper(Variable(symbol, "p", within=where)))
    with pytest.raises(ValueError, match="the set does not imply all assumptions"):
        Domain.of(paper(Variable(x, "x")), Part("wider", {symbol: where}))
