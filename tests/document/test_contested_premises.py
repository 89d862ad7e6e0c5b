"""Contradictory rows are not used as premises together: anything would follow from them."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

BLOCK = "%% mechproof\n%% p ; a ; b ; c ; q ; i : numbers [1] {b>0,q>0}\n%% end\n"
WILLIS = r"\begin{equation}\frac{p-c}{a-c}=-\frac bq\end{equation}"
SOLVED = r"\begin{equation}p=c\left(1+\frac bq\right)-a\frac bq\end{equation}"
WRONG = SOLVED.replace("-a", "+a")
# False except where a is zero; a = 0 would follow from both rows together.
CONSEQUENCE = r"\begin{equation}p^2=c^2\left(1+\frac bq\right)^2\end{equation}"
OTHER = r"\begin{equation}i=\frac ab=\frac{a+a}b\end{equation}"


def judge(*parts: str) -> list[str]:
    return [row.outcome for row in check("paper.tex", BLOCK + "\n".join(parts)).rows]


@pytest.mark.parametrize("words", ["so that", "for which", ""])
def test_a_wrong_solution_of_a_constraint_is_told(words: str) -> None:
    assert judge(WILLIS, words, SOLVED) == ["PROVED", "DEFINITION"]
    assert judge(WILLIS, words, WRONG) == ["not judged", "not judged"]


@pytest.mark.parametrize("consequence", [CONSEQUENCE, OTHER])
def test_nothing_follows_from_rows_that_contradict_each_other(consequence: str) -> None:
    rows = judge(WILLIS, "so that", WRONG, "The square is", consequence)
    assert rows[:2] == ["not judged", "not judged"]
    assert rows[2:] in (["not judged"], ["DEFINITION", "not judged"])


def test_what_has_further_letters_is_no_solution() -> None:
    sums = r"\begin{equation}a+b=c+q\end{equation}", r"\begin{equation}a=\frac i2\end{equation}"
    assert judge(*sums) == ["DEFINITION", "DEFINITION"]


TRAIN = r"""%% mechproof
%% r ; q ; s : radii [mm] {r>0, q>0, s>0}
%% u ; v ; w ; c : speeds [1/s]
%% end
The planet rolls on both wheels:
$$s(w-c)=-q(v-c)$$
$$r(u-c)=q(v-c)$$
The ring is held:
$$u=0$$
This gives
$$c=\frac{s}{r+s}w$$
"""


@pytest.mark.parametrize(
    ("other", "outcome"),
    [("r(u-c)=q(v-c)", "DEFINITION"), ("sw=sc-q(v-c)", "PROVED"), ("sw=sc+q(v-c)", "REFUTED")],
)
def test_what_is_held_later_contradicts_nothing_before_it(other: str, outcome: str) -> None:
    rows = check("paper.tex", TRAIN.replace("r(u-c)=q(v-c)", other)).rows
    assert [rows[1].outcome, rows[3].outcome] == [outcome, "DEFINITION"]


LOOP = r"""%% mechproof
%% r ; l : lengths [mm] {r>0, l>r}
%% x(t) : position [mm]
%% \varphi(t) ; \beta(t) : angles [rad] {-\pi/2<\beta<\pi/2}
%% end
$$r\cos\varphi+l\cos\beta=x$$
$$r\sin\varphi-l\sin\beta=0$$
$$r\dot\varphi\cos\varphi-l\dot\beta\cos\beta=0$$
$$r\dot\varphi\cos\varphi\sin\beta-l\dot\beta\cos\beta\sin\beta=0$$
$$x^2-2xr\cos\varphi+r^2-l^2=0$$
"""


@pytest.mark.slow
def test_a_slip_is_told_also_where_another_one_agrees_with_it() -> None:
    papers = LOOP, LOOP.replace(r"-l\dot", r"+l\dot")
    true, wrong = (check("paper.tex", paper).rows for paper in papers)
    assert [row.outcome for row in true[2:]] == ["PROVED"] * 3
    assert wrong[2].outcome == "not judged"
    assert "compared with display 2" in wrong[2].reason
    assert wrong[4].outcome == "PROVED"
