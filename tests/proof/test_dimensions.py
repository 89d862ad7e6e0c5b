"""Physical dimensions: sound and mixed ones, and the change of units that exposes a mixture."""

from fractions import Fraction

import pytest
import sympy as sp

from mechproof.proof.wellformed import find_faults
from mechproof.record import FREQUENCY, LENGTH, NUMBER, SPEED, Dimension, Distinct, Equality, Holds
from mechproof.statement_domains.dimension_inference import (
    DimensionError,
    infer,
    infer_common,
    rescale,
)
from mechproof.statement_domains.domain import Domain

a, b, v, w, t, p = sp.symbols("a b v w t p", positive=True)
q = sp.IndexedBase("q", positive=True)
i, n = sp.symbols("i n", integer=True, positive=True)
TIME = FREQUENCY**-1
V = sp.MatrixSymbol("V", 2, 1)
KNOWN = {
    V: LENGTH,
    a: LENGTH,
    b: LENGTH,
    v: SPEED,
    w: FREQUENCY,
    t: TIME,
    p: NUMBER,
    q: LENGTH,
    n: NUMBER,
}
DOMAIN = Domain({s: sp.Interval.open(0, sp.oo) for s in (a, b, v, w, t, p, q)}, (), {})

RIGHT = {
    "speed": (w * a + v, SPEED),
    "root": (sp.sqrt(a**2 + b**2), LENGTH),
    "half power": (sp.sqrt(a), Dimension(length=Fraction(1, 2))),
    "angle of two lengths": (sp.atan2(a, b), NUMBER),
    "sum of squares": (sp.Sum(q[i] ** 2, (i, 1, n)), LENGTH**2),
    "distance by integral": (sp.Integral(v, (t, 0, t)), LENGTH),
    "integral from a place to itself": (sp.Integral(v, (t, 0, 0)), None),
    "product without unit": (sp.sin(w * t) + a / b, NUMBER),
    "zero fits all": (sp.Integer(0), None),
    "largest": (sp.Max(a, b), LENGTH),
    "entry of a vector": (V[0, 0] + a, LENGTH),
    "cases": (sp.Piecewise((a, v < w * b), (b, True)), LENGTH),
    "matrix of one kind": (sp.ImmutableMatrix([a, b]), LENGTH),
    "dimensionless power": (p**p, NUMBER),
}
MIXED = {
    "length and area": a + b**2,
    "length and number": a + p,
    "length and speed": a + v,
    "sine of a length": sp.sin(a),
    "cases of unlike kinds": sp.Piecewise((a, p < 1), (p, True)),
    "case of unlike sides": sp.Piecewise((a, a < v), (b, True)),
    "exponent with a unit": p**a,
    "length to a symbol": a**p,
    "angle of unlike sides": sp.atan2(a, v),
    "largest of unlike": sp.Max(a, p),
    "inside a root": sp.sqrt(a**2 + b),
    "inside a sum": sp.Sum(q[i] + q[i] ** 2, (i, 1, n)),
    "inside an integral": sp.Integral(v + a, (t, 0, t)),
    "unlike limits": sp.Integral(p, (t, a, t)),
    "matrix of two kinds": sp.ImmutableMatrix([a, v]),
}


@pytest.mark.parametrize("name", RIGHT)
def test_the_dimension_is_inferred(name):
    expression, dimension = RIGHT[name]
    assert infer(expression, KNOWN) == dimension


@pytest.mark.parametrize("name", MIXED)
def test_a_mixture_is_refused(name):
    with pytest.raises(DimensionError):
        infer(MIXED[name], KNOWN)


@pytest.mark.parametrize("power", [2, -1, 0])
def test_both_sides_must_have_one_dimension(power):
    infer_common((a * b**power, b ** (power + 1)), KNOWN)
    with pytest.raises(DimensionError):
        infer_common((a * b**power, b**power), KNOWN)
    with pytest.raises(DimensionError):
        infer_common((a, b * v**2), KNOWN)


def test_matrices_are_compared_entry_by_entry():
    vector = sp.ImmutableMatrix([a, v])
    infer_common((vector,), KNOWN)
    infer_common((vector, sp.ImmutableMatrix([b, w * a])), KNOWN)
    with pytest.raises(DimensionError):
        infer_common((vector, sp.ImmutableMatrix([v, a])), KNOWN)
    with pytest.raises(DimensionError):
        infer_common((vector, sp.ImmutableMatrix([b, a])), KNOWN)


@pytest.mark.parametrize(
    ("unit", "scaled"),
    [("length", 1000 * a * w + 10**6 * q[i] ** 2), ("time", a * w / 1000 + q[i] ** 2)],
)
def test_a_change_of_units_scales_what_has_the_unit(unit, scaled):
    assert rescale(a * w + q[i] ** 2, KNOWN, unit, 1000) == scaled


def test_the_witness_may_be_another_unit_than_that_of_length():
    (fault,) = find_faults(Equality(t + w, t), KNOWN, DOMAIN)
    assert "unit of time" in fault.evidence[0].what


@pytest.mark.parametrize("says", [Equality(sp.sin(a) ** 2 + sp.cos(a) ** 2, p), Holds(v + v >= v)])
def test_what_no_change_of_units_changes_is_no_fault(says):
    assert find_faults(says, KNOWN, DOMAIN) == []


@pytest.mark.parametrize(
    "says",
    [
        Holds(sp.Gt(a + a**2, 0, evaluate=False)),
        Holds(sp.And(a < b, a > v)),
        sp.Ne(a, v),
        Distinct(a + v, a),
    ],
)
def test_relations_are_checked_too(says):
    statement = Holds(says) if isinstance(says, sp.Ne) else says
    (fault,) = find_faults(statement, KNOWN, DOMAIN)
    assert fault.evidence[0].printed != fault.evidence[0].rebuilt


def test_the_witness_differs_for_a_mixture_and_not_for_a_sound_formula():
    (fault,) = find_faults(Equality(sp.sqrt(a**2 + b), a), KNOWN, DOMAIN)
    assert fault.rung == "dimensions"
    assert fault.evidence[0].printed != fault.evidence[0].rebuilt
    assert find_faults(Equality(sp.sqrt(a**2 + b**2), a), KNOWN, DOMAIN) == []


def test_the_witness_is_turned_back_by_the_dimension_of_the_other_side():
    point = DOMAIN.points([a, b], 1)[0]
    (fault,) = find_faults(Equality(a + b**2, sp.sqrt(a)), KNOWN, DOMAIN)
    length, area = point[a] * 1000, point[b] ** 2 * 10**6
    expected = (length + area) / sp.sqrt(1000)
    assert sp.Float(fault.evidence[0].rebuilt.split()[0].strip("[")) == pytest.approx(
        float(expected)
    )


def test_a_witness_is_given_when_both_sides_are_mixed():
    (fault,) = find_faults(Equality(a + b**2, b + a**2), KNOWN, DOMAIN)
    assert fault.evidence[0].printed != fault.evidence[0].rebuilt


def test_the_letter_of_a_limit_has_the_dimension_that_fits() -> None:
    a, b = sp.symbols("a b", positive=True)
    running = sp.Dummy("c", real=True)
    known = {a: LENGTH, b: NUMBER}
    assert infer(sp.Limit(a + running, running, 0), known) == LENGTH
    assert infer(sp.Limit(a / (b + running), running, 0), known) == LENGTH
    with pytest.raises(DimensionError):
        infer(sp.Limit((a + running) / (a + running**2), running, 0), known)
    with pytest.raises(DimensionError):
        infer(sp.Limit(a + running, running, b), known)
