"""What a verdict shows: published sizes and round angles first, reasons in plain words."""

from __future__ import annotations

import json
from itertools import islice
from pathlib import Path

import pytest
import sympy as sp
from derived import opened

from mechproof.arithmetic import balls
from mechproof.derivation import find_systems, packaged_directory
from mechproof.latex import Reader
from mechproof.proof import refutation
from mechproof.proof.comparison_latex import write_latex
from mechproof.proof.judge import judge
from mechproof.proof.refutation import POINTS, compare, points_for
from mechproof.proof.verdict import Verdict
from mechproof.proof.witness_text import show_plainly, show_point
from mechproof.record import (
    ANGLE,
    LENGTH,
    NUMBER,
    Claim,
    Conjunction,
    Equality,
    Equation,
    Holds,
    Paper,
    PrintedNumber,
    PublishedSizes,
    Toleranced,
    Variable,
)
from mechproof.statement_domains.dimension_inference import infer, is_angle
from mechproof.statement_domains.domain import Domain

phi, psi, e = sp.symbols("phi psi e", real=True)
R, r = sp.symbols("R r", positive=True)
z = sp.Symbol("z", integer=True, positive=True)
POSITIVE = sp.Interval.open(0, sp.oo)
VARIABLES = (
    Variable(phi, "angle", ANGLE, latex=(r"\varphi_1",)),
    Variable(psi, "angle of the output", ANGLE, latex=(r"\varphi_3(\varphi_1)",)),
    Variable(e, "eccentricity", within=sp.Interval.Ropen(0, 1), latex=("e",)),
    Variable(R, "radius", LENGTH, POSITIVE, latex=("R_1",)),
    Variable(r, "another, not printed", LENGTH, POSITIVE),
    Variable(z, "teeth", within=sp.S.Naturals, latex=("z",)),
)
SIZES = PublishedSizes(
    "Table 1",
    {e: sp.Rational(28, 100), R: Toleranced(sp.S(66), sp.S.One, sp.S.Zero), z: sp.S(50)},
)
OTHER = PublishedSizes("Table 2", {e: sp.Rational(1, 2)})


def paper(*published, where=()):
    return Paper("system", "citation", VARIABLES, (), where, published=published)


DOMAIN = Domain.of(paper(SIZES, OTHER))
PLAIN = Domain.of(Paper("system", "citation", (Variable(e, "a number"),), ()))


def evidence(printed, rebuilt, domain=DOMAIN):
    found = compare(printed, rebuilt, domain).counterexample
    assert found is not None
    return found


def test_published_sizes_and_round_angles_come_first() -> None:
    found = evidence(R * sp.cos(phi) * e, R * e)
    assert found.at == {"R": "66", "e": "0.28", "phi": "pi/6 (30°)"}
    assert found.what == "the two sides, sizes of Table 1; chosen: phi"


def test_published_counts_come_first() -> None:
    assert evidence(2 * z, z).at == {"z": "50"}


def test_angles_differ_from_each_other() -> None:
    assert evidence(sp.cos(phi) * psi, sp.cos(psi) * phi).at == {
        "phi": "pi/6 (30°)",
        "psi": "pi/4 (45°)",
    }


def test_sizes_that_do_not_separate_give_way_to_the_next_and_to_any() -> None:
    zero = e - sp.Rational(28, 100)
    assert evidence(zero, sp.S.Zero).what == "the two sides, sizes of Table 2"
    other = evidence(zero * (e - sp.Rational(1, 2)), sp.S.Zero)
    assert other.what == "the two sides, all values chosen"
    assert other.at["e"] not in ("0.28", "0.5")


def test_usual_sizes_stand_for_what_is_not_published() -> None:
    usual = Paper("system", "", VARIABLES, (), published=(SIZES,), usual={r: sp.Rational(1, 40)})
    assert evidence(R * r, R + r, Domain.of(usual)).at == {"R": "66", "r": "0.025"}
    assert evidence(r, 2 * r, Domain.of(usual)).at == {"r": "0.025"}
    assert evidence(r, sp.Rational(1, 40), Domain.of(usual)).at != {"r": "0.025"}


def test_sizes_of_which_a_row_has_none_do_not_hide_the_next() -> None:
    others = (PublishedSizes("none of them", {z: sp.S(50)}), SIZES)
    found = evidence(R * phi, R * sp.sin(phi), Domain.of(paper(*others)))
    assert found.at == {"R": "66", "phi": "pi/6 (30°)"}


def test_sizes_outside_the_domain_are_no_points_of_it() -> None:
    domain = Domain.of(paper(SIZES, OTHER, where=(e > sp.Rational(3, 10),)))
    assert evidence(e, sp.S.Zero, domain).what == "the two sides, sizes of Table 2"
    points = islice(points_for((e * phi * R,), domain, POINTS, thorough=True), 60)
    assert all(point[e] > sp.Rational(3, 10) for point in points)


def test_round_angles_stay_within_the_set() -> None:
    narrow = sp.Interval.open(0, sp.pi / 5)
    variable = Variable(phi, "angle", ANGLE, narrow)
    domain = Domain.of(Paper("system", "citation", (variable,), ()))
    assert evidence(sp.sin(phi), phi, domain).at == {"phi": "pi/6 (30°)"}
    assert all(0 < float(p[phi]) < 0.63 for p in domain.points_at({}, [phi]))


def test_what_is_no_angle_gets_no_degrees_and_no_round_angle() -> None:
    assert "°" not in str(evidence(sp.cos(e), sp.S.One, PLAIN))
    assert list(PLAIN.points_at({}, [e])) == []


def test_values_of_angles_are_shown_in_degrees_too() -> None:
    found = evidence(psi + sp.atan(e), psi)
    assert found.printed == "[0.796607478685 +/- 9.49e-15] (45.6422°)"
    assert found.rebuilt.endswith("(30°)")
    assert "°" not in evidence(R * phi, r).printed


def test_angles_off_the_round_ones_are_rounded() -> None:
    shown = show_point({phi: sp.Rational(-35, 6), psi: 3 * sp.pi / 2}, DOMAIN)
    assert shown == {"phi": "-35/6 (-334.225°)", "psi": "3*pi/2 (270°)"}


def test_plain_numbers_have_the_digits_that_tell_them_apart() -> None:
    near = balls.to_ball(sp.Rational(1, 3)), balls.to_ball(sp.Rational(333333333, 10**9))
    assert show_plainly(*near) == ("0.333333333333", "0.333333333")
    same = balls.to_ball(sp.S(2)), balls.to_ball(sp.S(2))
    assert show_plainly(*same) == ("2", "2")


def test_sizes_and_angles_decide_nothing() -> None:
    bare = Domain(DOMAIN.within, DOMAIN.where, DOMAIN.given)
    assert bare == DOMAIN
    assert hash(bare) == hash(DOMAIN)


def test_proofs_do_not_look_at_published_points(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise AssertionError

    monkeypatch.setattr(Domain, "points_at", fail)
    assert judge(row(Equality((e + 1) ** 2, e**2 + 2 * e + 1)), paper(SIZES)).verdict == "PROVED"
    with pytest.raises(AssertionError):
        refutation.compare(e, e + 1, DOMAIN)


def test_an_angle_is_a_number_wherever_dimensions_are_compared() -> None:
    assert ANGLE == NUMBER
    assert hash(ANGLE) == hash(NUMBER)
    assert str(ANGLE) == "1"
    assert ANGLE.is_angle
    assert not NUMBER.is_angle
    assert not (ANGLE * LENGTH).is_angle
    assert not (ANGLE / ANGLE).is_angle


KINDS = {
    "angle": (phi, True),
    "multiple": (R / r * phi, True),
    "sum with a number": (1 + phi, True),
    "length with its sizes put in": (3 * (sp.sin(phi) - phi * sp.cos(phi)), False),
    "the same, number first": (e + phi, False),
    "arctangent": (sp.atan(e), True),
    "direction": (sp.atan2(R, r), True),
    "integral over it": (sp.Integral(sp.cos(phi) ** 2, (phi, 0, psi)), True),
    "sine": (sp.sin(phi), False),
    "ratio": (psi / phi, False),
    "square": (phi**2, False),
    "root of its square": (sp.sqrt(phi**2 * e, evaluate=False) / sp.sqrt(e), True),
    "arc": (R * phi, False),
    "number": (e, False),
    "mixture": (R + phi, False),
}


@pytest.mark.parametrize("name", KINDS)
def test_which_expressions_are_angles(name: str) -> None:
    expression, expected = KINDS[name]
    assert is_angle((expression,), DOMAIN.dimensions) is expected


def test_powers_that_are_no_fractions_keep_numbers() -> None:
    assert infer(e**e, DOMAIN.dimensions) == NUMBER


# Reasons ----------------------------------------------------------------------------------------


def row(says, latex="print"):
    return Claim("row", latex, says)


def reason(says):
    return judge(row(says), paper(SIZES)).reason


def less(left, right):
    return Holds(sp.Lt(left, right, evaluate=False))


def test_numbers_that_are_compared_are_named() -> None:
    assert reason(less(sp.sqrt(2), sp.S.One)) == "1.41421 < 1 is false"
    assert reason(less(sp.S.One, sp.sqrt(2))) == "1 < 1.41421"
    assert reason(Holds(sp.Ne(sp.sqrt(2), 1, evaluate=False))) == "1.41421 differs from 1"


def test_numbers_that_sympy_compares_are_named_too() -> None:
    given = Variable(e, "a size", given=sp.Rational(1, 2))
    judged = judge(row(Holds(e > 1)), Paper("system", "citation", (given,), ()))
    assert (judged.verdict, judged.reason) == (Verdict.REFUTED, "0.5 > 1 is false")


def test_all_parts_that_fail_are_named_with_their_numbers() -> None:
    parts = (less(sp.S.One, sp.pi), less(sp.S(4), sp.pi), less(sp.S(5), sp.pi))
    assert reason(Conjunction(parts)) == (
        "part 2 of 3: 4 < 3.14159 is false; part 3 of 3: 5 < 3.14159 is false"
    )
    assert reason(Conjunction(parts[1:2])) == "4 < 3.14159 is false"
    assert reason(Conjunction((parts[0], PrintedNumber("3.15", sp.pi)))) == (
        "part 2 of 2: recomputed 3.14159, printed 3.15"
    )


def test_a_relation_too_long_to_read_is_named_by_its_sides() -> None:
    long = sum(phi**k * e ** (k + 1) for k in range(1, 20))
    first, *_ = judge(row(less(long, -long)), paper(SIZES)).evidence
    assert first.what.startswith("printed < rebuilt is false")
    first, *_ = judge(row(less(phi, -phi)), paper(SIZES)).evidence
    assert first.what.startswith("phi < -phi is false")


def test_reasons_hold_no_balls() -> None:
    assert reason(PrintedNumber("3.14", sp.pi)) == "recomputed 3.14159"


# What was compared ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("formula", "latex"),
    [
        ((e**2 - 1) / (e * phi - 1), r"\frac{1 - e^{2}}{1 - e \varphi_1}"),
        (-phi / (e - 1) ** 3, r"\frac{\varphi_1}{\left(1 - e\right)^{3}}"),
        ((-e - phi) * sp.cos(e), r"- \left(e + \varphi_1\right) \cos{\left(e \right)}"),
        (e + (-e - phi) * sp.cos(e), r"e - \left(e + \varphi_1\right) \cos{\left(e \right)}"),
        ((e - 1) * (phi - 1), r"\left(e - 1\right) \left(\varphi_1 - 1\right)"),
        (phi * (e - 1), r"\varphi_1 \left(e - 1\right)"),
        (sp.Symbol("root_jerk"), r"\mathrm{root}_{\mathrm{jerk}}"),
        (2 * sp.sin(e) + phi * (1 + e), r"\varphi_1 \left(1 + e\right) + 2 \sin{\left(e \right)}"),
        (sp.Rational("0.7284") * phi - sp.Rational(2, 5), r"0.7284 \varphi_1 - \frac{2}{5}"),
        (sp.Rational(1, 8) * phi, r"\frac{\varphi_1}{8}"),
        (
            sp.Piecewise((e, e < 1), (0, True)) / phi,
            r"\frac{1}{\varphi_1} \begin{cases} e & \text{for}\: e < 1 \\0 & "
            r"\text{otherwise} \end{cases}",
        ),
        (
            2 * sp.Integral(phi, (phi, 0, e)) / (1 + e),
            r"\frac{2}{1 + e} \int\limits_{0}^{e} \varphi_1\, d\varphi_1",
        ),
        (sp.betainc_regularized(e, 1, 0, phi), r"I_{\varphi_1}\left(e, 1\right)"),
    ],
)
def test_products_and_functions_are_written_as_people_do(formula: sp.Expr, latex: str) -> None:
    assert write_latex(formula, paper(SIZES).variables) == latex


def test_a_letter_of_ours_is_set_as_such_and_is_not_printed() -> None:
    turned = Variable(sp.Symbol("turn_3"), "a step", letter=r"\varphi_3")
    assert write_latex(turned.symbol / 2, [turned]) == r"\frac{\varphi_3}{2}"
    assert Reader((turned,)).collect(r"\varphi_3") == [r"\varphi_{3}"]


def compared(says):
    return judge(row(says), paper(SIZES)).compared_with


def test_the_other_side_is_written_with_the_letters_of_the_paper() -> None:
    assert compared(Equality(psi, phi * e)) == r"e \varphi_1"
    assert compared(PrintedNumber("3.14", sp.pi)) == r"\pi"
    assert compared(Holds(e < 2)) == "e < 2"
    assert compared(Conjunction((Equality(psi, phi), PrintedNumber("3", sp.pi)))) == (
        r"\varphi_3(\varphi_1)=\varphi_1,\quad 3\approx \pi"
    )


def test_elements_have_their_indices_where_the_paper_prints_them() -> None:
    family, t = sp.IndexedBase("K", real=True), sp.Symbol("x-y_0", real=True)
    variables = (Variable(family, "coefficients", latex=("K_#(t)",)), Variable(t, "odd name"))
    judged = judge(
        row(Equality(family[1], family[2] + t)), Paper("system", "citation", variables, ())
    )
    assert judged.compared_with == r"\text{x-y\_0} + K_2(t)"


def test_letters_of_ours_are_written_by_those_of_the_paper() -> None:
    k, bound, word = sp.Symbol("k", real=True), sp.Symbol("x", real=True), sp.Symbol("largest")
    ours = (Variable(k, "ours", given=psi / phi), Variable(word, "a word"))
    about = Paper("system", "citation", (*VARIABLES, *ours), ())

    def show(right):
        return judge(row(Equality(e, right)), about).compared_with

    assert show(2 * k) == r"\frac{2 \varphi_3(\varphi_1)}{\varphi_1}"
    assert show(sp.Integral(k * bound, (bound, 0, e))).count("k") == 0
    assert show(k + word) == r"\mathrm{largest} + \frac{\varphi_3(\varphi_1)}{\varphi_1}"
    # A letter given by a much longer expression is not replaced.
    much = Variable(k, "ours", given=sum(phi**n for n in range(20)))
    long = Paper("system", "citation", (*VARIABLES, much), ())
    assert judge(row(Equality(e, k)), long).compared_with == "k"


def test_what_is_long_is_shown_whole() -> None:
    long = sum(phi**k * e ** (k + 1) for k in range(40))
    assert r"e^{40} \varphi_1^{39}" in compared(Equality(psi, long))
    parts = tuple(Equality(psi, phi + k) for k in range(6))
    assert compared(Conjunction(parts)).count(r"\varphi_3(\varphi_1)=") == 6
    assert compared(Conjunction((Conjunction(parts), *parts))) == compared(Conjunction(parts))


def test_sums_are_written_without_factors_and_deltas_and_long_fractions_by_their_digits() -> None:
    count, family = sp.Symbol("n", integer=True, positive=True), sp.IndexedBase("K", real=True)
    place = sp.Symbol("i", integer=True)
    other = sp.Symbol("j", integer=True)
    equal = sp.KroneckerDelta(place, other)
    spread = sp.Sum(
        equal * family[place] * family[other] / 36, (place, 1, count), (other, 1, count)
    )
    sizes = (
        Variable(family, "coefficients"),
        Variable(count, "their number", within=sp.S.Naturals),
    )
    about = Paper("system", "citation", (*VARIABLES, *sizes), ())
    judged = judge(row(Equality(psi, 6 * sp.sqrt(spread + e**2 / 36))), about)
    assert judged.compared_with == r"\sqrt{e^{2} + \sum_{i=1}^{n} K_{i}^{2}}"
    assert compared(Holds(sp.Rational(941, 1000) ** 50 < e)) == r"0.0478058639687778\ldots < e"


SYSTEMS = find_systems(packaged_directory())
LEDGER = Path(__file__).parents[2] / "generated" / "ledger.json"


def test_the_ledger_shows_what_every_proved_equation_was_compared_with() -> None:
    rows = json.loads(LEDGER.read_text(encoding="utf-8"))["rows"]
    proved = [r for r in rows if r["verdict"] == "PROVED"]
    shown = [r["number"] for r in proved if (r["print"] or r["paraphrase"]) and r["compared_with"]]
    assert shown == [r["number"] for r in proved]


@pytest.mark.slow
def test_the_verdict_sees_sizes_and_letters() -> None:
    found = opened("elliptic_planetary")
    assert found.domain.published == found.paper.published
    numbers = {row.number: row for row in found.rows}
    judged = judge(numbers["(12)"], found.domain)
    assert judged.evidence[0].at == {
        "R1": "66",
        "R2": "16",
        "e": "0.28",
        "phi1": "pi/6 (30°)",
    }
    assert isinstance(numbers["(9)"], Equation)
    assert r"\int" in judge(numbers["(9)"], found.domain).compared_with
