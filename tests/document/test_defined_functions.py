"""Functions that prints define: only these are read at other arguments."""

from __future__ import annotations

import pytest

from mechproof import check
from mechproof.document.drafts.draft import draft_block
from mechproof.sources.paper_files import read_source

TURN = r"R_z(\theta)=\begin{bmatrix}\cos\theta&-\sin\theta\\\sin\theta&\cos\theta\end{bmatrix}"
MOTION = r"q(t)=A\cos\omega t"
BLOCK = "%% mechproof\n%% f(x) :\n%% a :\n%% b :\n%% end\n"


def judge(*prints: str, block: str = "") -> list[str]:
    text = block + "\n".join(rf"\begin{{equation}}{latex}\end{{equation}}" for latex in prints)
    return [row.outcome for row in check("paper.tex", text).rows]


@pytest.mark.parametrize(
    ("defined", "true", "wrong"),
    [
        ("f(x)=x^2+1", "f(a+b)=(a+b)^2+1", "f(a+b)=a^2+b^2+2"),
        ("f(x)=x^2+1", "f(2)=5", "f(2)=6"),
        ("f(x)=x^2+1", "f'(x)=2x", "f'(x)=x"),
        ("f(x)=x^2+1", "f(u)=u^2+1", "f(u)=u^2"),
        (
            TURN,
            r"R_z(\alpha)R_z(\beta)=R_z(\alpha+\beta)",
            r"R_z(\alpha)R_z(\beta)=R_z(\alpha\beta)",
        ),
        (TURN, r"R_z(\alpha)^{-1}=R_z(-\alpha)", r"R_z(\alpha)^{-1}=R_z(\pi-\alpha)"),
        (TURN, r"R_z^T(\theta)R_z(2\theta)=R_z(\theta)", r"R_z^T(\theta)R_z(2\theta)=R_z(3\theta)"),
        (TURN, r"R_z^{-1}(\alpha)=R_z(-\alpha)", r"R_z^{-1}(\alpha)=R_z(\pi-\alpha)"),
        (MOTION, r"\dot q(t)=-A\omega\sin\omega t", r"\dot q(t)=A\omega\sin\omega t"),
        (MOTION, r"\ddot q(t)=-\omega^2q(t)", r"\ddot q(t)=\omega^2q(t)"),
        (MOTION, r"q(t+\frac{\pi}{\omega})=-q(t)", r"q(t+\frac{\pi}{\omega})=q(t)+1"),
    ],
)
def test_a_function_that_is_defined_is_read_at_other_arguments(
    defined: str, true: str, wrong: str
) -> None:
    assert judge(defined, true) == ["DEFINITION", "PROVED"]
    assert judge(defined, wrong)[1] in ("REFUTED", "not judged")


def test_a_letter_that_is_printed_of_time_depends_on_it_where_it_stands_bare() -> None:
    prints = ("x(t)=a\\cos t", r"\dot x=-a\sin t", r"x^2+\dot x^2=a^2", "x(0)=a")
    assert judge(*prints) == ["DEFINITION", *3 * ["PROVED"]]
    assert judge(*prints[:1], r"\dot x=a\sin t", "x(0)=2a") == ["DEFINITION", *2 * ["REFUTED"]]
    # A bracket after the letter may be a factor: then nothing is known.
    assert judge(prints[0], "y=x^2", "x(b+c)=a") == ["not read", "DEFINITION", "not read"]


def test_of_several_arguments_the_first_is_its_own() -> None:
    assert judge("f(x)=x^2", "f(u)=u^2", "f(u)=u^3") == ["DEFINITION", "PROVED", "REFUTED"]


def test_functions_may_be_defined_beside_each_other() -> None:
    assert judge(r"f(x)=x^2,\quad g(x)=2x", "f'(u)=g(u)") == [*2 * ["DEFINITION"], "PROVED"]
    assert judge("f(x)=x^2, g(x)=x", "f'(u)=g(u)")[-1] != "PROVED"
    other = TURN.replace("R_z", "R_y")
    assert judge(f"{TURN}, {other}", r"R_z(\alpha)=R_y(\alpha)") == [*2 * ["DEFINITION"], "PROVED"]


def test_a_function_of_several_letters_is_known_by_its_print() -> None:
    print_of_both = r"T(\theta,d)=\begin{bmatrix}\cos\theta&d\\0&1\end{bmatrix}"
    assert judge(print_of_both, r"\det T(\theta,d)=\cos\theta") == ["DEFINITION", "PROVED"]
    assert judge(print_of_both, r"\det T(\theta,d)=d+1")[1] == "DEFINITION"
    assert judge(print_of_both, r"\det T(\alpha,d)=\cos\alpha")[1] == "not read"


@pytest.mark.parametrize(
    "prints",
    [
        # The letter also appears alone, so the bracket may be a factor.
        ("f(x)=x^2", "f=a+b", "f(a+b)=ab"),
        # Nothing defines it.
        ("f(x+1)=x^2", "f(a+b)=ab"),
        ("f(x)=2", "f(a+b)=ab"),
        # Alone, the letter stands for a constant.
        ("v(t)=v+at", r"\dot v=a", "v(t)=a"),
        # It is defined for one argument, which this sum with a cosine is not.
        (r"r(\varphi)=a\varphi", r"r(1-\cos\varphi)=b"),
        # A function of time may be multiplied by lengths.
        (r"k(t)=a+b\sin ct", r"k(x_1-x_2)=b"),
    ],
)
def test_what_may_be_a_product_is_not_read(prints: tuple[str, ...]) -> None:
    assert judge(*prints)[-1] == "not read"


def test_a_declared_function_is_read_at_sums_where_it_never_stands_alone() -> None:
    prints = ("f(x)=x^2", "f(a+b)=(a+b)^2")
    assert judge(*prints, block=BLOCK) == ["DEFINITION", "PROVED"]
    assert judge(*prints, "a=f", block=BLOCK)[1] == "not read"
    assert judge(*prints, block=BLOCK.replace("%% end", "%% factor f\n%% end"))[1] != "PROVED"


def test_a_draft_takes_no_function_as_a_factor() -> None:
    text = f"$${TURN}$$ $$R_z(\\alpha)R_z(\\beta)=R_z(\\alpha+\\beta)$$ $$k(a+b)=ka+kb$$"
    block = draft_block(read_source("paper.tex", text))
    assert [line for line in block.splitlines() if "factor" in line] == ["%% factor k"]
