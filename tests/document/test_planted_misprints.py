"""Prints that one change would make true, given constraints, and true ones that look alike."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from small_papers import judge_parts, judge_rows

from mechproof.document.checked_rows import CheckedRow
from mechproof.document.checking import check
from mechproof.document.context.judging_by_constraints import judge_by_constraints
from mechproof.document.judging_workers import Judging
from mechproof.tools.processes import WorkerError

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r ; l ; l_1 ; l_2 : lengths {r>0}
%% x(t) ; y(t) : position
%% q_1(t) ; q_2(t) ; \alpha(t) ; \beta(t) ; \gamma : angles
%% k ; m ; n ; u ; w_1 ; w_2 ; w_3 ; T_1 ; T_2 ; T_3 : numbers
%% J 2x2 : matrix
%% factor l_1, l_2, w_1, w_2
"""
ROD = r"r\sin\alpha=l\sin\beta"
SLIDER = r"x=r\cos\alpha+l\cos\beta"
ARM = (
    r"x=l_1\cos q_1+l_2\cos(q_1+q_2)",
    r"y=l_1\sin q_1+l_2\sin(q_1+q_2)",
    r"J=\begin{pmatrix}-l_1\sin q_1-l_2\sin(q_1+q_2)&-l_2\sin(q_1+q_2)\\"
    r"l_1\cos q_1+l_2\cos(q_1+q_2)&l_2\cos(q_1+q_2)\end{pmatrix}",
)
TRAIN = (r"k=\frac{w_1-w_3}{w_2-w_3}", "T_2=-kT_1", "T_3=-(1-k)T_1")
FOUR_BAR = (
    r"l_1\cos q_1+l\cos\alpha=r+l_2\cos q_2",
    r"l_1\sin q_1+l\sin\alpha=l_2\sin q_2",
    r"m=\frac{r}{l_1}",
    r"n=\frac{r}{l_2}",
    r"u=\frac{l_1^2-l^2+l_2^2+r^2}{2l_1l_2}",
)
# The prints before, a true print, and wrong ones.
PAPERS: dict[str, tuple[tuple[str, ...], str, list[str]]] = {
    "a factor on the other side of the bar": (
        (r"k\tan\beta=n", "T_1=uw_1"),
        r"\frac uk=\frac{u\tan\beta}n",
        [r"\frac uk=\frac u{n\tan\beta}"],
    ),
    "a rod eliminated": (
        (ROD, SLIDER),
        r"x=r\cos\alpha+\sqrt{l^2-r^2\sin^2\alpha}",
        [
            r"x=r\cos\alpha+\sqrt{l^2-r^2\cos^2\alpha}",
            r"x=r\cos\alpha+\sqrt{l^2+r^2\sin^2\alpha}",
            r"x=r\cos\alpha+\sqrt{l^2-r\sin^2\alpha}",
        ],
    ),
    "a velocity": (
        (ROD, SLIDER),
        r"\dot x=-r\dot\alpha\frac{\sin(\alpha+\beta)}{\cos\beta}",
        [
            r"\dot x=-r\dot\alpha\frac{\sin(\alpha-\beta)}{\cos\beta}",
            r"\dot x=-r\dot\alpha\frac{\sin(\alpha+\beta)}{\cos\alpha}",
        ],
    ),
    "a determinant": (
        ARM,
        r"\det J=l_1l_2\sin q_2",
        [r"\det J=l_1l_2\sin q_1", r"\det J=l_1l_2\cos q_2", r"\det J=l_1^2\sin q_2"],
    ),
    "a theorem of cosines": (
        ARM,
        r"x^2+y^2=l_1^2+l_2^2+2l_1l_2\cos q_2",
        [
            r"x^2+y^2=l_1^2+l_2^2+l_1l_2\cos q_2",
            r"x^2+y^2=l_1^2+l_2^2-2l_1l_2\cos q_2",
            r"x^2-y^2=l_1^2+l_2^2+2l_1l_2\cos q_2",
        ],
    ),
    "Willis": (
        TRAIN,
        "w_1-kw_2-(1-k)w_3=0",
        ["w_1-kw_2+(1-k)w_3=0", "w_1-kw_2-(1-k)w_2=0", "w_1-w_2-(1-k)w_3=0"],
    ),
    "torques": (TRAIN, "T_1+T_2+T_3=0", ["T_1+T_2-T_3=0"]),
    "a joint": (
        (r"k=\sin\alpha\cos\beta-\cos\gamma\cos\alpha\sin\beta=0",),
        r"\tan\alpha=\cos\gamma\tan\beta",
        [],
    ),
    "a belt": (
        (r"\frac{w_1}{w_2}=\mathrm{e}^{m\gamma}", r"k=m\gamma"),
        r"w_1(1-\mathrm{e}^{-m\gamma})=w_2(\mathrm{e}^{k}-1)",
        [r"w_1(1-\mathrm{e}^{-m\gamma})=w_2(\mathrm{e}^{-k}-1)"],
    ),
    "Freudenstein": (
        FOUR_BAR,
        r"m\cos q_2-n\cos q_1+u=\cos(q_1-q_2)",
        [
            r"m\cos q_2-n\cos q_1-u=\cos(q_1-q_2)",
            r"m\cos q_1-n\cos q_1+u=\cos(q_1-q_2)",
        ],
    ),
}
LOOP = (
    r"l_1\cos q_1+l\cos\alpha=r+l_2\cos q_2",
    r"l_1\sin q_1+l\sin\alpha=l_2\sin q_2",
)
RATES = (
    r"\dot\alpha=\frac{l_1\dot q_1\sin(q_2-q_1)}{l\sin(\alpha-q_2)}",
    r"\dot q_2=\frac{l_1\dot q_1\sin(q_1-\alpha)}{l_2\sin(q_2-\alpha)}",
)
ACCELERATION = (
    r"\ddot q_2=\frac{l_1\ddot q_1\sin(q_1-\alpha)+l_1\dot q_1^2\cos(q_1-\alpha)"
    r"+l\dot\alpha^2-l_2\dot q_2^2\cos(q_2-\alpha)}{l_2\sin(q_2-\alpha)}"
)
WRONG = [
    ACCELERATION.replace(r"+l\dot\alpha^2", r"-l\dot\alpha^2"),
    ACCELERATION.replace(r"\cos(q_1-\alpha)", r"\sin(q_1-\alpha)"),
    ACCELERATION.replace(r"-l_2\dot q_2^2", r"+l_2\dot q_2^2"),
]
# Rows that follow from the loop show that it is not another case.
PAPERS["an acceleration"] = (*LOOP, *RATES), ACCELERATION, WRONG
JOINT = PAPERS["a joint"][0]
CENTRE = (ROD, SLIDER, r"\alpha=-\beta", "x=u", "u^2=(r+l)^2")
INLINE = (*FOUR_BAR[:2], r"q_1=\alpha", r"(l_1+l)^2=l_2^2+r^2+2rl_2\cos q_2")
# Papers with a wrong print, and the two rows of which a change in either would make both true:
# neither is accused.
CONTRADICTIONS: dict[str, tuple[tuple[str, ...], list[str]]] = {
    "a joint, letters exchanged": (
        (*JOINT, r"\tan\beta=\cos\gamma\tan\alpha"),
        ["(1), second equals sign", "(2)"],
    ),
    "a joint, sine for cosine": (
        (*JOINT, r"\tan\alpha=\sin\gamma\tan\beta"),
        ["(1), second equals sign", "(2)"],
    ),
    "a sign of an angle": (
        (*FOUR_BAR, r"m\cos q_2-n\cos q_1+u=\cos(q_1+q_2)"),
        ["(2)", "(6)"],
    ),
    # No other print follows from the loop, or those that do come before it.
    "an acceleration alone": ((*LOOP, WRONG[0]), ["(1)", "(3)"]),
    "a dead centre": (CENTRE, []),
    "a dead centre, wrong": ((*CENTRE[:2], r"\alpha=\beta", *CENTRE[3:]), ["(1)", "(3)"]),
    "crank and coupler in line": (INLINE, []),
    "crank and coupler in line, wrong": (
        (*INLINE[:2], r"q_1=\pi-\alpha", INLINE[3].replace("l_1+l", "l_1-l")),
        ["(2)", "(3)"],
    ),
}
LONG = ("a sign of an angle", "an acceleration alone", "crank and coupler in line, wrong")
# Prints, the words before the last one, and additional lines of the block: none is accused.
EXCUSED: dict[str, tuple[tuple[str, ...], str, str]] = {
    "another letter": (("k=mn", "k=mu"), "", ""),
    "another circuit, printed alike": ((ROD, r"r\sin\alpha=-l\sin\beta"), "", ""),
    "another assembly, in words": ((*TRAIN, "T_1+T_2-T_3=0"), "In the other case", ""),
    "a constraint, the block says": ((*TRAIN, "T_1+T_2-T_3=0"), "", "%% constraint (4)\n"),
    "a letter of its own": ((*TRAIN, r"T_1+T_2=m"), "", ""),
    # x_0 is the place where it holds, not a slip for x.
    "a zero, and where it is": (
        (r"y=r+\frac{x^2}{l}", r"x_0=\sqrt{rl}", "y=2r", "x^2-rl=0"),
        "",
        "%% x_0 : length\n",
    ),
    "a position": ((ROD, SLIDER, r"\alpha=\beta", r"x=2r\cos\alpha"), "", ""),
    "a branch of the rod": ((ROD, SLIDER, r"x=r\cos\alpha-\sqrt{l^2-r^2\sin^2\alpha}"), "", ""),
    "the same on both sides": ((r"m=\cos\gamma", r"k\cos\gamma=k\sin\gamma"), "", ""),
    "two changes": (
        (ROD, SLIDER, r"\dot x=r\dot\beta\frac{\sin(\alpha-\beta)}{\cos\beta}"),
        "",
        "",
    ),
    # The misprint is in the first print; it was not seen at positive angles alone.
    "an offset, of which the derivative is printed": (
        (
            r"r\sin\alpha=l\sin\beta+2l_1",
            r"\dot\beta=\frac{r\dot\alpha\cos\alpha}{l\cos\beta}",
            r"l^2\cos^2\beta=l^2-(r\sin\alpha-l_1)^2",
        ),
        "",
        "%% where l>r\n%% where l_1>r\n",
    ),
    "an angle counted otherwise, in words": (
        (ROD, SLIDER, r"\dot x=-r\dot\alpha\sin\alpha+r\dot\alpha\cos\alpha\tan\beta"),
        r"\section{Lower cylinder} Its angle $\beta$ is counted clockwise.",
        "",
    ),
    "a crank that turns the other way, in words": (
        (r"x=r\cos\alpha", r"y=r\sin\alpha", r"\dot x=r\dot\alpha\sin\alpha"),
        r"From here on $\alpha$ is measured in the opposite sense.",
        "",
    ),
    # With one change in the differentiated print, the acceleration would not matter.
    "constant speed, in words": (
        (r"y=r\sin\alpha\cos\alpha", r"m=\dot\alpha", r"\ddot y=-2rm^2\sin2\alpha"),
        "",
        "",
    ),
    "a letter as a function of itself": (
        (r"\alpha=\arctan\frac km", r"u=\sin\beta", r"\alpha=\arctan(\tan\beta)"),
        "",
        "",
    ),
    "a rounded number": ((r"k=\sqrt2m", r"k\sqrt2=1.9m"), "", ""),
}


def judge(equations: tuple[str, ...], words: str = "", block: str = "") -> CheckedRow:
    """Return the last row of a paper that has `words` before its last equation."""
    shown = [f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations]
    text = "".join([*shown[:-1], words, " ", shown[-1]])
    return check("paper.tex", f"{BLOCK}{block}%% end\n{text}").rows[-1]


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_a_true_print_is_not_accused(name: str) -> None:
    before, right, _ = PAPERS[name]
    row = judge((*before, right))
    assert row.outcome in ("PROVED", "DEFINITION", "not judged"), row.reason


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "wrong"), [(name, one) for name, paper in PAPERS.items() for one in paper[2]]
)
def test_a_misprint_is_refuted_where_all_else_holds(name: str, wrong: str) -> None:
    row = judge((*PAPERS[name][0], wrong))
    assert row.outcome == "REFUTED", row.reason
    assert row.judgement.evidence[0].at


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "outcome"),
    [
        ("Solving for it we obtain", "REFUTED"),
        ("The expression for it is", "REFUTED"),
        ("For the other we obtain", "DEFINITION"),
        ("For a wheel we obtain", "DEFINITION"),
    ],
)
def test_what_equations_are_solved_for_is_no_case(words: str, outcome: str) -> None:
    parts = ("T_1=uw_1", r"k\tan\beta=n", f"#{words}", r"\frac uk=\frac u{n\tan\beta}")
    assert judge_parts(f"{BLOCK}%% end\n", *parts)[-1] == outcome


def test_what_holds_in_an_example_contradicts_nothing_elsewhere() -> None:
    parts = ("T_1=kw_1", r"k\tan\beta=n", r"T_1\tan\beta=\frac{n}{w_1}")
    for words, outcome in (("For $r=66$ mm it has", "REFUTED"), ("It has", "not judged")):
        behind = (f"#{words}", "k=3w_1")
        assert judge_parts(f"{BLOCK}%% end\n", *parts, *behind)[2] == outcome


@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=[pytest.mark.slow] if n in LONG else []) for n in CONTRADICTIONS],
)
def test_of_two_prints_that_contradict_each_other_neither_is_accused(name: str) -> None:
    equations, pair = CONTRADICTIONS[name]
    rows = {row.name: row for row in judge_rows(f"{BLOCK}%% end\n", *equations)}
    assert "REFUTED" not in {row.outcome for row in rows.values()}
    told = [name for name, row in rows.items() if "contradict each other" in row.reason]
    assert told == pair
    for name, other in zip(pair, reversed(pair), strict=True):
        assert rows[name].reason.startswith(f"it and {other} contradict")


@pytest.mark.slow
@pytest.mark.parametrize("name", EXCUSED)
def test_what_may_be_meant_is_not_accused(name: str) -> None:
    row = judge(*EXCUSED[name])
    assert row.outcome in ("DEFINITION", "not judged"), row.reason


@pytest.mark.slow
def test_what_took_too_long_supports_no_accusation(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def answer(at: Judging, judge: Any, arguments: Any) -> Iterator[tuple[Any, Any]]:
        if judge is judge_by_constraints:
            asked.append(arguments)
        # The first question is what follows from the constraints, the second which ones it needs.
        if judge is judge_by_constraints and len(asked) > 1:
            return ((one, WorkerError("no answer")) for one in arguments)
        return ask(at, judge, arguments)

    before, _, (wrong, *_) = PAPERS["an acceleration"]
    ask = Judging.ask
    monkeypatch.setattr(Judging, "ask", answer)
    row = judge((*before, wrong))
    assert len(asked) > 1
    assert row.outcome == "not judged"
    assert "contradict each other" in row.reason


COSINE = r"\cos\beta=\sqrt{1-\frac{r^2}{l^2}\sin^2\alpha}"
ACUTE = r"%% where -\pi/2<\beta<\pi/2" + "\n%% where l>r\n"
RATE = r"\dot\beta=\frac{r\dot\alpha\cos\alpha}{l\cos\beta}"
SPEED = r"\dot\alpha=2\pi w_1"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("equations", "block", "number", "outcome"),
    [
        ((ROD, COSINE), ACUTE, 1, "PROVED"),
        ((ROD, COSINE), "", 1, "DEFINITION"),
        ((ROD, COSINE.replace(r"=\sqrt", r"=-\sqrt")), ACUTE, 1, "REFUTED"),
        ((ROD, COSINE.replace("1-", "1+")), ACUTE, 1, "REFUTED"),
        # The misprint may also be in the equation of the rod.
        ((ROD, COSINE.replace(r"\sin^2", r"\cos^2")), ACUTE, 1, "not judged"),
        # The sides compared may contain the root, too.
        (
            (ROD, COSINE, "x=" + SLIDER[2:] + r"=r\cos\alpha+\sqrt{l^2-r^2\sin^2\alpha}"),
            ACUTE,
            3,
            "PROVED",
        ),
        # A later definition of a speed by a letter of its own is no excuse.
        ((ROD, RATE, SPEED), ACUTE, 1, "PROVED"),
        ((ROD, RATE.replace(r"\cos\alpha", r"\sin\alpha"), SPEED), ACUTE, 1, "REFUTED"),
        ((ROD, RATE.replace(r"\cos\alpha", r"\sin\alpha"), SPEED), ACUTE, 2, "DEFINITION"),
    ],
)
def test_a_root_and_a_rate_follow_from_what_they_are_made_of(
    equations: tuple[str, ...], block: str, number: int, outcome: str
) -> None:
    text = "".join(f"\\begin{{equation}}{one}\\end{{equation}}\n Then\n" for one in equations)
    row = check("paper.tex", f"{BLOCK}{block}%% end\n{text}").rows[number]
    assert row.outcome == outcome, row.reason


RISE = (r"x=r\sin\alpha", r"y=r\cos\alpha")
STEADY = (r"#When it rises steadily, it turns at the rate", r"\dot\alpha=\frac{u}{r\cos\alpha}")
DRIVEN = ("#If the worm drives, the force is", r"w_1=\frac{2T_1}{r}", "#The torque is", r"w_2=kw_1")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("parts", "number", "outcome"),
    [
        # A later print about a letter puts no other letters into earlier rows.
        ((*RISE, r"\dot y=-r\dot\alpha\sin\alpha", *STEADY), 2, "PROVED"),
        ((*RISE, r"\dot y=-r\dot\alpha\cos\alpha", *STEADY), 2, "REFUTED"),
        ((*RISE, r"\dot x=-\dot y\cot\alpha", *STEADY), 2, "PROVED"),
        # A letter introduced in a case keeps its meaning wherever it is printed.
        ((*DRIVEN, r"w_3=w_2n=\frac{2knT_1}{r}"), 3, "PROVED"),
        ((*DRIVEN, r"w_3=w_2n=\frac{knT_1}{r}"), 3, "REFUTED"),
        ((*DRIVEN, "#In general", r"w_3=w_2n=\frac{knT_1}{r}"), 3, "not judged"),
        # A constraint with a letter of its own says nothing about other letters.
        ((r"mu+nT_1=0", r"x=kn^2=k^2n"), 2, "REFUTED"),
    ],
)
def test_definitions_of_cases_and_later_ones_excuse_no_misprint(
    parts: tuple[str, ...], number: int, outcome: str
) -> None:
    rows = judge_parts(f"{BLOCK}%% end\n", *parts)
    assert rows[number] == outcome, rows


THREAD = (r"\tan\alpha=\frac{k}{n}", r"u=\frac{w_1}{w_2}=\frac{m}{k}")
SLIDING = r"\frac{mw_2}{nw_1}=\tan\alpha"
LEVER = r"T_1=\frac{mw_2}{nw_1\tan(\alpha+\beta)}=\frac{\tan\alpha}{\tan(\alpha+\beta)}"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("equations", "number", "outcome"),
    [
        ((*THREAD, SLIDING), 2, "DEFINITION"),
        ((*THREAD, SLIDING), 3, "PROVED"),
        ((*THREAD, SLIDING.replace(r"\tan", r"\cot")), 2, "not judged"),
        ((*THREAD, SLIDING.replace(r"\tan", r"\cot")), 3, "DEFINITION"),
        ((*THREAD, LEVER), 4, "PROVED"),
        ((*THREAD, LEVER.replace(r"{\tan\alpha}", r"{\tan\beta}")), 4, "not judged"),
        # Members that are equal somewhere need not have equal derivatives.
        (
            (r"x=l=r\cos\alpha", r"\dot x=-r\dot\alpha\sin\alpha", r"\dot x=r\dot\alpha\sin\alpha"),
            3,
            "not judged",
        ),
    ],
)
def test_a_step_of_a_chain_is_a_constraint_if_further_rows_follow_from_it(
    equations: tuple[str, ...], number: int, outcome: str
) -> None:
    row = judge_rows(f"{BLOCK}%% end\n", *equations)[number]
    assert row.outcome == outcome, row.reason


PREMISES = r"""%% mechproof
%% x_1(t) ; x_2(t) ; u(t) : displacements [m]
%% m_1 ; m_2 ; \mu : masses [kg] {m_1>0}
%% c : stiffness [N/m] {c>0}
%% end
"""
SPRUNG = (r"m_1\ddot x_1=-c(x_1-x_2)", r"m_2\ddot x_2=c(x_1-x_2)", "u=x_1-x_2")
SUM, WRONG_SUM = (rf"m_1\ddot x_1{sign}m_2\ddot x_2=0" for sign in "+-")


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "outcome"), [(SUM, "PROVED"), (WRONG_SUM, "not judged")])
def test_nothing_follows_from_what_is_contradicted(latex: str, outcome: str) -> None:
    equations = (*SPRUNG, r"\mu\ddot u+cu=0", r"\mu\ddot u-cu=0", latex)
    assert judge_rows(PREMISES, *equations)[-1].outcome == outcome


@pytest.mark.slow
def test_of_prints_that_contradict_each_other_one_may_be_right() -> None:
    block = r"""%% mechproof
%% v_1 ; v_2 ; u_1 ; u_2 : velocities [m/s]
%% m_1 ; m_2 : masses [kg] {m_1>0}
%% e : restitution [1]
%% factor e
%% end
"""
    momentum = r"m_1v_1+m_2v_2=m_1u_1+m_2u_2"
    speed = r"u_1=v_1-\frac{m_2}{m_1+m_2}(1+e)(v_1-v_2)"
    plastic = r"u_1=u_2=\frac{m_1v_1+m_2v_2}{m_1+m_2}"
    equations = (momentum, r"e=\frac{u_2-u_1}{v_1-v_2}", speed, plastic)
    rows = {row.name: row for row in judge_rows(block, *equations)}
    assert "contradict each other" in rows["(1)"].reason
    assert rows["(3)"].outcome == "PROVED"


def test_nothing_follows_from_what_only_zeros_satisfy() -> None:
    block = "%% mechproof\n%% n ; w ; v ; d : numbers\n%% end\n"
    equations = (r"w=n=2\pi n", r"v=\pi dn=\frac{dn}2")
    assert judge_rows(block, *equations)[-1].outcome == "REFUTED"


@pytest.mark.slow
def test_what_defines_a_letter_may_have_the_misprint() -> None:
    circle = (r"(x-l_1\cos\alpha)^2+(y-l_1\sin\alpha)^2=l_2^2", r"m=-2l_1x", r"n=-2l_1y")
    row = judge((*circle, "u=x^2+y^2+l_1^2-l_2^2", r"m\cos\alpha+n\sin\alpha+u=0"))
    assert row.outcome in ("PROVED", "DEFINITION")
    row = judge((*circle, "u=x^2+y^2-l_1^2-l_2^2", r"m\cos\alpha+n\sin\alpha+u=0"))
    assert row.outcome == "REFUTED"
    assert "^2 in the definition of u" in row.reason


@pytest.mark.slow
def test_a_misprint_is_told_with_what_mends_it() -> None:
    before, _, (wrong, *_) = PAPERS["a determinant"]
    assert judge((*before, wrong)).reason == (
        "the two sides differ, but not with q_2 instead of q_1"
    )
    before, _, (wrong, *_) = PAPERS["Freudenstein"]
    assert judge((*before, wrong)).reason.endswith("; compared with (1), (2)")


# The law of cosines, its rearrangements and its root: which print is wrong is seen only with enough
# others.
STEPS = (
    r"l^2=r^2+x^2-2rx\cos\gamma",
    r"l^2-r^2+r^2\cos^2\gamma=(x-r\cos\gamma)^2",
    r"l^2-r^2\sin^2\gamma=(x-r\cos\gamma)^2",
    r"x=r\cos\gamma+\sqrt{l^2-r^2\sin^2\gamma}",
)
ROOT = STEPS[3].replace("l^2-r", "l^2+r")
SQUARE = r"(x-r\cos\gamma)^2=x^2-2rx\cos\gamma+r^2\cos^2\gamma"
MINUS = STEPS[3].replace(r"x=r", r"x=-r")
WRONG_STEP = STEPS[2].replace(r"\sin^2", r"\cos^2")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("equations", "words", "refuted", "contested"),
    [
        (STEPS, "", [], []),
        ((*STEPS[:3], ROOT), "", ["(4)"], []),
        ((*STEPS[:3], ROOT), "In the other case", [], ["(1)", "(4)"]),
        ((*STEPS[:2], WRONG_STEP, STEPS[3]), "", [], ["(3)", "(4)"]),
        # An identity is true for any letter, so it supports no definition.
        ((STEPS[0], SQUARE, MINUS), "", [], ["(1)", "(3)"]),
        ((STEPS[0], ROOT), "", [], ["(1)", "(2)"]),
        ((WRONG_STEP, STEPS[3]), "", [], ["(1)", "(2)"]),
    ],
)
def test_the_rest_tells_whether_a_definition_or_what_it_contradicts_is_wrong(
    equations: tuple[str, ...], words: str, refuted: list[str], contested: list[str]
) -> None:
    block = BLOCK.replace("x(t) ;", "x ;") + "%% where l>r\n%% where r>0\n%% where l>0\n%% end\n"
    *shown, last = [f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations]
    rows = check("paper.tex", "".join([block, *shown, words, " ", last])).rows
    assert [row.name for row in rows if row.outcome == "REFUTED"] == refuted
    assert [row.name for row in rows if "contradict each other" in row.reason] == contested


# A loop, a consequence of it, and another print of the same angle between them.
ROOT_OF_ROD = r"\cos\beta=\sqrt{1-\frac{r^2}{l^2}\sin^2\alpha}"
WRONG_ROOT = ROOT_OF_ROD.replace(r"\sin", r"\cos")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("equations", "refuted", "contested"),
    [
        ((ROD, r"\sin\beta=\frac rl\cos\alpha", ROOT_OF_ROD), ["(2)"], []),
        ((ROD, r"\sin\beta=\frac rl\sin\alpha", ROOT_OF_ROD), [], []),
        # Nothing else shows which one is wrong, or the consequence comes from the last print.
        ((r"\sin\beta=\frac rl\cos\alpha", ROOT_OF_ROD), [], ["(1)", "(2)"]),
        (
            (SLIDER, ROD, WRONG_ROOT, r"x=r\cos\alpha+\sqrt{l^2-r^2\cos^2\alpha}"),
            [],
            ["(2)", "(3)"],
        ),
    ],
)
def test_what_follows_from_the_first_of_two_prints_tells_which_is_wrong(
    equations: tuple[str, ...], refuted: list[str], contested: list[str]
) -> None:
    block = "%% mechproof\n%% r ; l ; x : lengths {r>0}\n%% where l>r\n%% \\alpha : angle\n"
    block += "%% \\beta : angle {-\\pi/2<\\beta<\\pi/2}\n%% end\n"
    rows = judge_rows(block, *equations)
    assert [row.name for row in rows if row.outcome == "REFUTED"] == refuted
    assert [row.name for row in rows if "contradict each other" in row.reason] == contested


def test_what_cancels_in_what_gives_a_letter_is_no_definition() -> None:
    speeds = (r"w_3=\frac{w_1+w_2}2", r"u=\frac{w_1-w_2}k")
    assert judge((*speeds, r"w_2=w_3-\frac{uk}2")).outcome == "PROVED"
    assert judge((*speeds, r"w_2=w_3+\frac{uk}2")).outcome == "REFUTED"


def test_no_change_is_offered_that_makes_nothing_of_both_sides() -> None:
    block = "%% mechproof\n%% b ; t ; M ; E ; K : numbers {b>0, t>0, E>0}\n%% \\varphi : angle\n"
    turn = r"\varphi=\int_{-\pi/2}^{\pi/2}\frac{M\cos\theta}{Ebt^2}\,d\theta"
    equations = (turn, r"\frac{6K\varphi}{bt^2}=3E\varphi")
    assert judge_rows(f"{block}%% end\n", *equations)[-1].outcome == "DEFINITION"


PENDULUM = r"""%% mechproof
%% x(t) : position
%% \theta(t) : angle
%% m ; M ; l : sizes {m>0, M>0, l>0}
%% g ; F : others
%% factor m
%% end
$$(M+m)\ddot x+ml\ddot\theta\cos\theta-ml\dot\theta^2\sin\theta=F$$
$$ml\ddot x\cos\theta+ml^2\ddot\theta-mgl\sin\theta=0$$
$$\ddot x\cos\theta+l\ddot\theta-g\sin\theta=0$$
The final equation is $$\ddot x\cos\theta+l\ddot\theta=g\sin\theta$$
For small angles $$\ddot x+l\ddot\theta=g\theta$$
"""


@pytest.mark.parametrize("change", [("", ""), (r"+l\ddot\theta=g\s", r"-l\ddot\theta=g\s")])
def test_no_print_is_accused_that_would_become_a_later_one(change: tuple[str, str]) -> None:
    outcomes = [row.outcome for row in check("paper.tex", PENDULUM.replace(*change)).rows]
    expected = ["DEFINITION", "DEFINITION", "PROVED", "REFUTED" if any(change) else "PROVED"]
    assert outcomes[:4] == expected
