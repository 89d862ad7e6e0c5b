r"""Prints of textbooks and lecture notes: frames to the left of a letter, words as names, matrices.

Each form has a twin, a similar print that is refused or says something else.
"""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.record import Variable

x, y = sp.symbols("x y", real=True)
PLAIN = tuple(Variable(s, "", latex=(str(s),)) for s in (x, y))
READER = Reader(PLAIN)

# Letters --------------------------------------------------------------------------------------

COLLECTED = [
    # The letter is the same in every spelling of the scripts to its left.
    *(
        (spelling, [r"{}^{C}_{D}Q"])
        for spelling in (
            *(r"{}^C_D Q", r"{}_D^C Q", r"{^C_D}Q", r"{^C_D Q}", r"{ }_{D}^{C} Q", r"^C_DQ"),
            *(r"\ ^{C}_{D}Q", r"{}^C{}_DQ", r"x\,{}^C_DQ", r"x\ ^C_DQ", r"[^C_DQ]", r"x={^C_D}Q"),
        )
    ),
    (r"{}^CQ_{wx}'\cdot{}^2\hat{n}_3", [r"{}^{C}Q_{wx}'", r"{}^{2}\hat{n}_{3}"]),
    (r"{}^CQ^2+Q^2", [r"{}^{C}Q", "Q"]),
    (r"{}^0T_1\,{}^1T_2", [r"{}^{0}T_{1}", r"{}^{1}T_{2}"]),
    (r"{}^0T_1{}^1T_2", [r"{}^{0}T_{1}", r"{}^{1}T_{2}"]),
    (r"{}^2T_3\,{}^{3}T_4", [r"{}^{2}T_{3}", r"{}^{3}T_{4}"]),
    (r"\text{drift}+\mathrm{gain}_1", [r"\text{drift}", r"\mathrm{gain}_{1}"]),
    (r"\mathrm{m}+2x\mathrm{m}", [r"\mathrm{m}"]),
    # A unit of one letter may be a letter.
    (r"2\mathrm{A}+x", [r"\mathrm{A}"]),
    (r"\mathbf{q}_1\cdot\vec{q}\cdot q", [r"\mathbf{q}_{1}", r"\vec{q}", "q"]),
    (
        r"\underline{q}_1\cdot{\bf q}\cdot{\rm gain}",
        [r"\underline{q}_{1}", r"\mathbf{q}", r"\mathrm{gain}"],
    ),
    (r"q_{\rm max}+q_{\mathrm{max}}", [r"q_{\max}"]),
    # In a run of letters from a onwards, none is Euler's number or a differential.
    (r"a+b+c+d+e", ["a", "b", "c", "d", "e"]),
    (r"\begin{vmatrix}a&b\\c&d\end{vmatrix}", ["a", "b", "c", "d"]),
    ("d=l+d_1", ["d", "l", "d_{1}"]),
    (r"\frac{d_2}{d_1q}", ["d_{2}", "d_{1}", "q"]),
]


@pytest.mark.parametrize(("latex", "letters"), COLLECTED)
def test_a_letter_is_met_with_all_that_belongs_to_it(latex: str, letters: list[str]) -> None:
    assert READER.collect(latex) == letters
    named = [Variable(sp.Symbol(f"n{k}", real=True), "", latex=(s,)) for k, s in enumerate(letters)]
    read = Reader([*PLAIN, *named]).parse(latex)
    found = read.meaning().of(read.chains[0].members[-1])
    assert found.free_symbols - {x, y} <= {v.symbol for v in named}


NOT_COLLECTED = [
    (r"x\ ^2y", "a script after a gap"),
    (r"x{}^Ty", "a script after a gap"),
    (r"x\ _1y", "a script after a gap"),
    ("^2", "nothing precedes"),
    (r"x+{}^A+y", "nothing precedes"),
    (r"{}^A{}^BQ", "a second ^"),
    ("e^x", "e is not declared"),
    ("a+e", "e is not declared"),
    ("d\\,x", "d is not declared"),
    ("a+b+c+i", "i is not declared"),
    (r"x\,\text{drift}", "is not understood here"),
    (r"5\,\mathrm{mm}", "units are not read"),
    (r"0.5\,\mathrm m+x", "units are not read"),
    (r"p=5\,\mathrm{bar}", "units are not read"),
    ("=x", "no meaning here"),
]


@pytest.mark.parametrize(("latex", "told"), NOT_COLLECTED)
def test_what_may_be_no_letter_is_refused(latex: str, told: str) -> None:
    with pytest.raises(ReadingError, match=told.replace("^", r"\^")):
        READER.collect(latex)


def test_scripts_at_both_sides_keep_their_side() -> None:
    q, left = sp.symbols("q left", real=True)
    reader = Reader([Variable(q, "", latex=("q",)), Variable(left, "", latex=(r"{}^{2}q",))])
    read = reader.parse(r"q^2+q{}^2+q\ ^2={}^2q")
    assert [read.meaning().of(side) for side in read.chains[0].members] == [3 * q**2, left]


# Spaces ---------------------------------------------------------------------------------------

APART = {
    r"\cos x\,\frac{y}{2}": sp.cos(x) * y / 2,
    r"\cos x\;(1-y)": sp.cos(x) * (1 - y),
    r"\cos x\quad\sqrt{1+y^2}": sp.cos(x) * sp.sqrt(1 + y**2),
    r"\cos x\frac{y}{2}": None,
    r"\cos x(1-y)": None,
    r"\cos x\,y": None,
}


@pytest.mark.parametrize("latex", APART)
def test_a_space_ends_an_argument_before_what_is_no_letter(latex: str) -> None:
    meant = APART[latex]
    if meant is None:
        with pytest.raises(ReadingError):
            READER.parse(latex)
    else:
        read = READER.parse(latex)
        assert read.meaning().of(read.chains[0].members[0]) == meant
