"""The verdict of every row of the paper, and of forms that are slightly wrong."""

from __future__ import annotations

import dataclasses

import pytest
import sympy as sp
from derived import judge_all, paper_of
from weights import first_of

from mechproof.arithmetic import balls
from mechproof.codegen.form_rows import form_rows
from mechproof.derivations.wedge_linkage import mechanics
from mechproof.derivations.wedge_linkage.kernels import chain
from mechproof.derivations.wedge_linkage.rows import boundaries, sizes, transfer
from mechproof.proof.judge import judge
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Judgement, Verdict
from mechproof.record import Conjunction, Equality, Form, Holds, Paper, PublishedSizes, Toleranced
from mechproof.statement_domains.domain import Domain

# The paper is judged in one process, once.
pytestmark = pytest.mark.xdist_group("verdicts wedge_linkage")


# With these the lever turns by more than a right angle over the stroke, where (1) is off by pi.
FAR_TURN = {
    size: Toleranced(sp.Rational(value), sp.S.Zero, sp.S.Zero)
    for size, value in ((mechanics.l_AB, "6.25"), (mechanics.l_BC, "15"), (mechanics.l_CD, "13.75"))
}


def judgement(number: str) -> Judgement:
    return judge_all("wedge_linkage")[number]


def test_no_error_rests_on_a_rebuilt_or_reconstructed_reading() -> None:
    charged = (Verdict.REFUTED, Verdict.ILL_FORMED)
    assert not [
        row.number
        for row in paper_of("wedge_linkage").rows
        if judgement(row.number).verdict in charged
    ]


def test_what_was_fitted_is_no_claim() -> None:
    assert judgement("crossing").verdict is Verdict.DEFINITION
    assert "fitted" in judgement("crossing").marks


def test_a_lost_prime_is_set_by_the_sense_and_marked() -> None:
    for number in ("(6), Ox", "(7)", "(8)", "(7) and (8), R"):
        assert judgement(number).verdict is Verdict.PROVED
        assert {"rebuilt", "uncertain"} <= set(judgement(number).marks)


def test_the_rod_in_place_of_the_link_behind_the_clearance_is_refuted() -> None:
    row = next(row for row in paper_of("wedge_linkage").rows if row.number == "(6), Ox")
    assert isinstance(row.says, Equality)
    in_contact = row.says.rebuilt.subs(mechanics.x5_driven, mechanics.x5 - mechanics.l_GH)
    wrong = Equality(row.says.printed.subs(mechanics.x5_driven, mechanics.x5), in_contact)
    assert decide(wrong, Domain.of(paper_of("wedge_linkage"))).verdict is Verdict.REFUTED


def test_the_substituted_chain_has_no_value_where_the_roller_arm_is_upright() -> None:
    hole = judgement(transfer.SUBSTITUTED)
    assert hole.verdict is Verdict.CONDITIONAL
    assert hole.evidence[1].at == {"tau": "1"}


def test_what_rests_on_lost_digits_is_not_checkable() -> None:
    for number in ("boundary II", "largest spread", "deviation at -40"):
        assert judgement(number).verdict is Verdict.NOT_CHECKABLE


def test_no_angle_of_an_arctangent_hides_a_turn_of_the_lever() -> None:
    for table in paper_of("wedge_linkage").published:
        far = dataclasses.replace(table, sizes={**table.sizes, **FAR_TURN})
        says = boundaries.angles_in_range(far).parts[0]
        assert decide(says, Domain.of(paper_of("wedge_linkage"))).verdict is Verdict.REFUTED


def test_what_rests_on_the_reconstructions_is_marked() -> None:
    numbers = ("boundary III", "boundary IV", "budget at -40")
    assert all("calibrated" in judgement(number).marks for number in numbers)
    assert all(
        {"calibrated", "fitted"} <= set(table.marks)
        for table in paper_of("wedge_linkage").published
    )


WRONG = {
    "(3)": mechanics.print_3.subs(mechanics.phi3, -mechanics.phi3),
    "(10)": mechanics.print_10 + 2 * mechanics.l_LM * sp.sin(mechanics.alpha_LM),
    "(8)": mechanics.print_7.subs(mechanics.R, mechanics.l_KL * mechanics.cosine_of_sigma),
    "(1)": mechanics.print_1.subs(mechanics.l_CD, mechanics.l_AB),
}


@pytest.mark.parametrize("number", WRONG)
def test_a_slightly_wrong_formula_is_refuted(number: str) -> None:
    row = next(row for row in paper_of("wedge_linkage").rows if row.number == number)
    assert isinstance(row.says, Equality)
    wrong = dataclasses.replace(row.says, printed=WRONG[number])
    assert decide(wrong, Domain.of(paper_of("wedge_linkage"), row.on)).verdict is Verdict.REFUTED


def test_a_slope_of_the_wrong_sign_is_refuted() -> None:
    row = next(row for row in paper_of("wedge_linkage").rows if row.number == "slopes of varphi3")
    assert isinstance(row.says, Conjunction)
    first = row.says.parts[0]
    assert isinstance(first, Equality)
    wrong = dataclasses.replace(first, printed=-first.printed)
    assert decide(wrong, Domain.of(paper_of("wedge_linkage"), row.on)).verdict is Verdict.REFUTED


def test_another_budget_is_refuted() -> None:
    says = boundaries.totals(sizes.FIRST_SET, ("10.2", "4.6"))
    assert decide(says, Domain.of(paper_of("wedge_linkage"))).verdict is Verdict.REFUTED


def above(table: PublishedSizes, one: sizes.Signs, other: sizes.Signs) -> Holds:
    """State that one curve lies above another where they begin."""
    first, second = (boundaries.position_of(table, signs, -40) for signs in (one, other))
    return boundaries.less(second, first)


def test_the_other_signs_of_iv_are_not_lowest() -> None:
    wrong = {**boundaries.BOUNDARY_IV, mechanics.alpha_DE: 1}
    for table in paper_of("wedge_linkage").published:
        says = above(table, boundaries.BOUNDARY_IV, wrong)
        assert decide(says, Domain.of(paper_of("wedge_linkage"))).verdict is Verdict.REFUTED


OTHER_CURVES = {
    "III beyond its end": (boundaries.BOUNDARY_III, "-29.45"),
    "IV beyond its end": (boundaries.BOUNDARY_IV, "-29.35"),
    "III with the wrong l_KL": ({**boundaries.BOUNDARY_III, mechanics.l_KL: 1}, "-29.35"),
}


@pytest.mark.parametrize("curve", OTHER_CURVES)
def test_another_curve_is_no_boundary(curve: str) -> None:
    signs, place = OTHER_CURVES[curve]
    for table in paper_of("wedge_linkage").published:
        says = boundaries.extreme(table, signs, place, (-29,))
        assert decide(says, Domain.of(paper_of("wedge_linkage"))).verdict is Verdict.REFUTED


def test_reconstructed_sizes_differ_in_three_and_are_exact() -> None:
    first, second = (table.sizes for table in paper_of("wedge_linkage").published)
    assert first.keys() == second.keys()
    changed = {s for s in first if first[s] != second[s]}
    assert changed == {mechanics.l_BC, mechanics.l_CD, mechanics.l_DE}
    expected = Toleranced(
        sp.Rational(28306, 18000) * sp.pi, sp.Rational(62, 18000) * sp.pi, -sp.pi * 11 / 1800
    )
    assert first[mechanics.alpha_DE] == expected


def test_balls_of_an_undefined_arctangent_are_not_finite() -> None:
    y, x = sp.symbols("y x", real=True)
    undefined = sp.atan2(sp.sqrt(y), x)
    assert not balls.evaluate(undefined, {y: -1, x: 1}).is_finite()
    assert balls.evaluate(undefined, {y: 1, x: -1}).is_finite()


def test_evidence_of_exact_numbers_shows_both_sides() -> None:
    says = above(sizes.FIRST_SET, boundaries.BOUNDARY_II, boundaries.BOUNDARY_IV)
    (evidence,) = decide(says, Domain.of(paper_of("wedge_linkage"))).evidence
    assert "-110.1" in evidence.what
    assert "-134.9" in evidence.what


def with_form(name: str, form: Form) -> Paper:
    """Return the paper with a single quantity, computed by `form` only, and without rows."""
    quantity = next(q for q in paper_of("wedge_linkage").quantities if q.name == name)
    return dataclasses.replace(
        paper_of("wedge_linkage"),
        quantities=(dataclasses.replace(quantity, forms=(form,)),),
        rows=(),
    )


def shipped(name: str) -> Form:
    return next(q for q in paper_of("wedge_linkage").quantities if q.name == name).forms[0]


def judge_form(paper: Paper) -> Verdict:
    (row,) = form_rows(paper)
    return judge(row, paper).verdict


# For each step, the quantity that first uses it, and a wrong definition of the step.
NEARLY = sp.Rational(1025, 1024)
IN_CONTACT = chain.l_LM * chain.cos_wedge / chain.rise
WRONG_STEPS = {
    chain.arm: ("position", NEARLY * chain.STEPS[chain.arm]),
    chain.sin_DE: ("position", sp.cos(mechanics.alpha_DE)),
    chain.to_right: ("position", NEARLY * chain.STEPS[chain.to_right]),
    chain.to_left: ("position", chain.STEPS[chain.to_right]),
    chain.start_height: ("position", NEARLY * chain.STEPS[chain.start_height]),
    chain.guide_length: ("position", NEARLY * chain.STEPS[chain.guide_length]),
    chain.guide_sum: ("position", NEARLY * chain.STEPS[chain.guide_sum]),
    chain.lever_square: ("position", chain.guide_sum**2 - mechanics.x1**2),
    chain.run: ("position", -chain.STEPS[chain.run]),
    chain.push: ("position", sp.Max(0, chain.run - 2 * mechanics.l_GH)),
    chain.rise: ("position", NEARLY * chain.STEPS[chain.rise]),
    chain.roller_square: ("position", NEARLY * chain.STEPS[chain.roller_square]),
    chain.cos_lever: ("velocity", NEARLY * chain.STEPS[chain.cos_lever]),
    chain.sin_arm: ("velocity", NEARLY * chain.STEPS[chain.sin_arm]),
    chain.cos_wedge: ("velocity", NEARLY * chain.STEPS[chain.cos_wedge]),
    chain.gain: ("velocity", sp.Piecewise((0, chain.run >= mechanics.l_GH), (IN_CONTACT, True))),
}


@pytest.mark.parametrize("step", first_of(WRONG_STEPS), ids=str)
def test_a_wrong_step_is_refuted(step: sp.Symbol) -> None:
    name, value = WRONG_STEPS[step]
    paper = with_form(name, shipped(name))
    variables = tuple(
        dataclasses.replace(v, given=value) if v.symbol == step else v for v in paper.variables
    )
    assert judge_form(dataclasses.replace(paper, variables=variables)) is Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(
    "size", first_of([mechanics.l_BC, mechanics.l_KL, mechanics.l_LM, mechanics.alpha_DE]), ids=str
)
def test_a_wrong_sensitivity_is_refuted(size: sp.Symbol) -> None:
    form = shipped("sensitivities")
    entries = list(form.expression)
    entries[list(chain.SENSITIVITY_FORMS).index(size)] *= NEARLY
    wrong = dataclasses.replace(form, expression=sp.ImmutableDenseMatrix(entries))
    assert judge_form(with_form("sensitivities", wrong)) is Verdict.REFUTED


R = mechanics.R
OTHER_CASES = {
    "(7) where R < 0": ((mechanics.print_7, R < 0), (mechanics.print_8, R > 0)),
    "half a turn": ((mechanics.print_7, R > 0), (mechanics.print_8 + sp.pi, R < 0)),
    "R > l_KL/2": ((mechanics.print_7, mechanics.l_KL < 2 * R), (mechanics.print_8, R < 0)),
}


@pytest.mark.parametrize("cases", OTHER_CASES)
def test_a_wrong_case_is_refuted(cases: str) -> None:
    quantity = next(
        q for q in paper_of("wedge_linkage").quantities if q.name == "roller_lever_angle"
    )
    form = next(f for f in quantity.forms if f.key == "printed")
    expression = sp.Piecewise(*OTHER_CASES[cases], (sp.nan, True)).subs(R, mechanics.PRINTED_R)
    wrong = dataclasses.replace(form, expression=expression)
    assert judge_form(with_form("roller_lever_angle", wrong)) is Verdict.REFUTED
