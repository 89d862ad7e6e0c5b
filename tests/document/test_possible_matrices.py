"""Undeclared letters that are printed like matrices: no verdict rests on them."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

OPEN, GIVEN, PROVED, REFUTED = "not judged", "DEFINITION", "PROVED", "REFUTED"
# A definition, an expansion that holds for numbers, and one that holds for none.
PRODUCTS = "P=(A+B)^2", "P=A^2+2AB+B^2", "P=A^2+AB+B^2"
SHOWN = [
    "[A]=[C][D]",
    r"\left[A\right]^{-1}C=D",
    r"A^\top C=D",
    r"A^{\mathrm{T}}C=D",
    "A^TC=D",
    "TA^TC=D",
    r"\det A=0",
    r"\det(A-\lambda I)=0",
    r"\operatorname{tr}(AC)=D",
    "C=(A-I)(I+A)^{-1}",
    r"C=\left(1-A\right)^{-1}D",
    r"A\in SO(3)",
    r"A\in\mathbb{R}^{3\times3}",
]
NOT_SHOWN = [
    "C=(A+D)^{-1}",
    "C=(A^{-1}+D^{-1})^{-1}F",
    r"C=\sqrt[A]{D}",
    r"C=\sin[A+D]",
    "C=F^T",
]
TURNED = (
    "X=[R]X",
    "([I]-[R])X=0",
    "[B]=([R]-[I])([R]+[I])^{-1}",
    r"\left([I]-([I]-[B])^{-1}([I]+[B])\right)X=0",
    "C=[R]C+d",
    "([I]-[R])C=d",
)


def _judge(*prints: str, block: str = "") -> list[str]:
    lines = (f"\\begin{{equation}}{latex}\\end{{equation}}" for latex in prints)
    return [row.outcome for row in check("paper.tex", block + "\n".join(lines)).rows]


@pytest.mark.parametrize("shown", SHOWN)
def test_what_may_hold_for_matrices_only_or_for_numbers_only_is_left_open(shown: str) -> None:
    assert _judge(shown, *PRODUCTS)[-2:] == [OPEN, OPEN]


@pytest.mark.parametrize("shown", NOT_SHOWN)
def test_other_letters_are_numbers(shown: str) -> None:
    assert _judge(shown, *PRODUCTS)[-2:] == [PROVED, REFUTED]


def test_what_is_said_to_be_a_number_is_one() -> None:
    block = "%% mechproof\n%% A; B; C; D; P : numbers\n%% end\n"
    assert _judge("[A]=[C][D]", *PRODUCTS, block=block)[-2:] == [PROVED, REFUTED]


def test_what_is_printed_to_be_a_matrix_is_no_number() -> None:
    tables = r"A=\begin{pmatrix}a&b\\0&c\end{pmatrix}", r"B=\begin{pmatrix}0&1\\1&0\end{pmatrix}"
    product = r"[A][B]=\begin{pmatrix}b&a\\c&0\end{pmatrix}"
    assert _judge(*tables, product, product.replace("b&a", "a&b"))[-2:] == [PROVED, REFUTED]


def test_turns_by_matrices_in_brackets_are_accused_of_nothing() -> None:
    assert REFUTED not in _judge(*TURNED)
    assert REFUTED not in _judge(*(x.replace("[", "").replace("]", "") for x in TURNED))
    rows = check("paper.tex", "\n".join(f"$${x}$$" for x in TURNED)).rows
    assert "B 3x3" in rows[3].reason


def test_a_letter_alone_in_brackets_is_defined_as_without_them() -> None:
    verdicts = [GIVEN, PROVED, REFUTED]
    assert _judge("(b)=(r-p)^2", "b=r^2-2rp+p^2", "(b)=r^2-p^2") == verdicts
    block = "%% mechproof\n%% A 2x2 : map\n%% B 2x2 : map\n%% P 2x2 : map\n%% end\n"
    assert _judge("[P]=[A]([A]+[B])", "P=A^2+AB", "[P]=A^2+BA", block=block) == verdicts


@pytest.mark.parametrize(
    ("meaning", "outcomes"),
    [(" : force", ["not judged"] * 2), (" : number", ["REFUTED", "PROVED"])],
)
def test_a_letter_in_bold_that_is_declared_without_a_size_may_be_a_vector(
    meaning: str, outcomes: list[str]
) -> None:
    block = f"%% mechproof\n%% M; N : numbers\n%% \\vec r{meaning}\n%% \\vec F{meaning}\n%% end\n"
    chains = r"M=\vec r\times\vec F=-\vec F\times\vec r", r"N=\vec r\times\vec F=\vec F\times\vec r"
    rows = check("paper.tex", block + "".join(f"$${x}$$" for x in chains)).rows
    assert [row.outcome for row in rows[1::2]] == outcomes
    assert ("3x1" in rows[1].reason) == (meaning != " : number")


TURN = r"R=\begin{pmatrix}\cos q&-\sin q\\\sin q&\cos q\end{pmatrix}"


@pytest.mark.parametrize("power", ["T", "{T}", r"{\mathrm T}", r"\top"])
def test_a_plain_t_above_a_printed_matrix_transposes_it(power: str) -> None:
    inverse = rf"R^{{-1}}=R^{power}"
    assert _judge(TURN, inverse) == [GIVEN, PROVED]
    assert _judge(TURN.replace("-", ""), inverse)[1] != PROVED
    assert _judge(TURN, inverse, "x=2T")[1] == PROVED


@pytest.mark.parametrize("one", [r"\mathbf{1}", r"\mathbf 1"])
def test_a_one_in_bold_beside_a_matrix_is_the_unit_matrix(one: str) -> None:
    product = rf"R^\top R={one}"
    assert _judge(TURN, product) == [GIVEN, PROVED]
    assert _judge(TURN.replace("-", ""), product) == [GIVEN, OPEN]
    assert _judge(TURN.replace("-", "2"), product) == [GIVEN, OPEN]


@pytest.mark.parametrize("letter", ["I", "E", r"\mathbf{I}"])
def test_a_letter_for_unit_matrices_is_asked_for_and_may_be_said(letter: str) -> None:
    text = "".join(f"$${x}$$" for x in (TURN, rf"R^\top R={letter}", rf"RR^\top={letter}"))
    asked = check("paper.tex", text).rows[1]
    assert asked.outcome == GIVEN
    assert asked.reason.endswith(f"say so: {letter} 2x2 : unit matrix")
    lines = ("R 2x2 : turn", "q : angle", f"{letter} 2x2 : unit matrix", "identity display 2")
    block = "".join(f"%% {x}\n" for x in ("mechproof", *lines, "end"))
    for given, outcome in ((text, PROVED), (text.replace("-", ""), REFUTED)):
        rows = check("paper.tex", block + given).rows
        assert [row.outcome for row in rows[:2]] == [GIVEN, outcome]
