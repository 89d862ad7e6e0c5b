"""Equations that follow from others according to the block: proved, or refuted where these hold."""

import pytest

import mechproof

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% N_1 ; N_2 : loads of the two bearings [N]
%% W : weight of the shaft [N]
%% a ; b : distances of the bearings from its centre [m] {a>0}
%% \mu ; T : friction, and its moment
%% follows (3): bal, (2)
%% end
"""
PAPER = r"""
\begin{equation}N_1+N_2=W\label{bal}\end{equation}
\begin{equation}N_1a-N_2b=0\end{equation}
\begin{equation}RESULT\end{equation}
"""


def judge(result: str, block: str = BLOCK) -> tuple[str, str]:
    row = mechproof.check("paper.tex", block + PAPER.replace("RESULT", result)).rows[-1]
    return row.outcome, row.reason


@pytest.mark.slow
@pytest.mark.parametrize(
    "result",
    [
        "N_2(a+b)=Wa",
        "N_1(a+b)=Wb",
        "N_1^2a^2=N_2^2b^2",
        r"N_1=\frac{Wb}{a+b}",
        r"\frac{N_1}{b}=\frac{N_2}{a}",
        r"\frac{N_1}{N_1+N_2}=\frac{b}{a+b}",
    ],
)
def test_what_follows_is_proved(result: str) -> None:
    block = BLOCK.replace("%% follows", "%% factor N_1, N_2, W\n%% follows")
    outcome, reason = judge(result, block)
    assert outcome == "PROVED"
    assert "(2)" in reason


@pytest.mark.parametrize(
    "result", ["N_2(a+b)=Wb", "N_1(a-b)=Wb", "N_1^2-N_2^2=W(N_1+N_2)", "N_1=Wb"]
)
def test_what_does_not_follow_is_refuted(result: str) -> None:
    block = BLOCK.replace("%% follows", "%% factor N_1, N_2, W\n%% follows")
    outcome, reason = judge(result, block)
    assert outcome == "REFUTED"
    assert reason.startswith("does not follow from (1), (2): with these solved for ")


LINEAR = r"""%% mechproof
%% u(t) ; w(t) ; b ; c : two angles and two inertias
%% F : moment
%% follows (5), (6): (3), (4)
%% end
\begin{align}b\ddot u+c\ddot w\cos w&=F\\b\ddot u\cos w+2c\ddot w&=0\\
b\ddot u+c\ddot w&=F\\b\ddot u+2c\ddot w&=0\\
\ddot u&=\frac{2F}{b}\\\ddot w&=-\frac{F}{c}\end{align}
"""


def test_what_follows_from_approximations_is_compared_with_these_alone() -> None:
    rows = mechproof.check("paper.tex", LINEAR).rows
    assert [row.outcome for row in rows[-2:]] == ["PROVED", "PROVED"]
    rows = mechproof.check("paper.tex", LINEAR.replace(r"-\frac{F}{c}", r"\frac{F}{c}")).rows
    assert [row.outcome for row in rows[-2:]] == ["PROVED", "REFUTED"]


@pytest.mark.parametrize(("sign", "outcome"), [("-", "PROVED"), ("", "REFUTED")])
def test_matrices_are_compared_entry_by_entry(sign: str, outcome: str) -> None:
    block = LINEAR[: LINEAR.index(r"\begin")].replace("(5), (6): (3), (4)", "(2): (1)")
    angles = r"\begin{bmatrix}\ddot u\\\ddot w\end{bmatrix}"
    text = rf"""{block}
    \begin{{equation}}\begin{{bmatrix}}b&c\\b&2c\end{{bmatrix}}{angles}
    =\begin{{bmatrix}}F\\0\end{{bmatrix}}\end{{equation}}
    \begin{{equation}}{angles}
    =\begin{{bmatrix}}\frac{{2F}}{{b}}\\{sign}\frac{{F}}{{c}}\end{{bmatrix}}\end{{equation}}"""
    assert [row.outcome for row in mechproof.check("paper.tex", text).rows][-1] == outcome


def test_an_equation_that_defines_and_one_that_repeats_it_give_nothing_twice() -> None:
    block = LINEAR[: LINEAR.index(r"\begin")].replace("(5), (6): (3), (4)", "(3): (2)")
    block = block.replace("%% end", "%% let c=0\n%% end")
    text = (
        block
        + r"""\begin{align}b\ddot u-w&=F\\
    \begin{bmatrix}b\ddot u-w\\b w\end{bmatrix}&=\begin{bmatrix}F\\c\end{bmatrix}\\
    wb&=0\end{align}"""
    )
    assert [row.outcome for row in mechproof.check("paper.tex", text).rows][-1] == "PROVED"


def test_what_follows_in_a_part_alone_is_not_proved() -> None:
    """Where F is zero, w need not be b."""
    text = LINEAR[: LINEAR.index(r"\begin")].replace("(5), (6): (3), (4)", "(2): (1)")
    text += r"\begin{align}bFw&=w^2F\\bw&=w^2\end{align}"
    assert [row.outcome for row in mechproof.check("paper.tex", text).rows] == [
        "DEFINITION",
        "not judged",
    ]


def test_what_has_no_meaning_is_not_compared() -> None:
    assert judge(r"\mathrm{e}^{N_1a}=\mathrm{e}^{N_2b}")[0] == "ILL_FORMED"


def test_letters_of_which_more_is_said_are_not_solved_for() -> None:
    """Solving might leave the stated ranges of the letters; a witness must be within them."""
    bounds = "%% where N_1>0, N_2>0, W>0, b>0\n"
    block = BLOCK.replace("%% end", f"%% factor N_2\n{bounds}%% end")
    outcome, reason = judge(r"\sqrt{N_2(a+b)}=\sqrt{Wa}", block)
    assert outcome == "not judged"
    assert "cannot be solved for letters that appear in no other equation" in reason
    row = mechproof.check("paper.tex", block + PAPER.replace("RESULT", "N_2(a+b)=Wb")).rows[-1]
    assert row.outcome == "REFUTED"
    values = row.judgement.evidence[0].at
    assert all(float(values[letter]) > 0 for letter in ("N_1", "N_2", "b", "a"))


def test_of_a_chain_for_a_new_letter_the_steps_follow() -> None:
    text = BLOCK.replace(r"%% \mu", r"%% k : ratio" + "\n" + r"%% \mu") + PAPER
    right, wrong = (
        text.replace("RESULT", rf"k=\frac{{N_1}}{{N_2}}=\frac {q}") for q in ("ba", "ab")
    )
    rows = [mechproof.check("paper.tex", one).rows for one in (right, wrong)]
    assert [row.outcome for row in rows[0][2:]] == ["DEFINITION", "PROVED"]
    assert [row.outcome for row in rows[1][2:]] == ["DEFINITION", "REFUTED"]


def test_what_is_no_constraint_gives_nothing() -> None:
    block = BLOCK.replace("bal, (2)", "(4)").replace("%% end", "%% factor N_2\n%% end")
    text = block + PAPER.replace("RESULT", "N_2(a+b)=Wa") + "$$T=\\mu W$$".replace("$$", "")
    text += r"\begin{equation}T<\mu W\end{equation}"
    row = mechproof.check("paper.tex", text).rows[2]
    assert (row.outcome, row.reason) == (
        "not judged",
        "(4): no equation between letters was read there",
    )


@pytest.mark.parametrize("said", ["follows (3)", "follows (3):", "follows : (1)"])
def test_a_line_without_equations_is_refused(said: str) -> None:
    with pytest.raises(ValueError, match=r"follows|the number or label"):
        judge("N_2a=Wa", BLOCK.replace("follows (3): bal, (2)", said))


def test_equations_that_are_not_there_are_refused() -> None:
    with pytest.raises(ValueError, match=r"name or label \(9\)"):
        judge("N_2a=Wa", BLOCK.replace("bal", "(9)"))
