"""The changes of a correction are marked in both prints, and nothing else is."""

from __future__ import annotations

import re

import pytest
from hypothesis import given, settings, strategies as st

from mechproof.latex.changes import Style, mark_changes

TAKEN = Style("⟦{}⟧".format, "⟧{}⟦".format)
PUT = Style("⟪{}⟫".format, "⟫{}⟪".format)
MARKED = re.compile(r"⟦[^⟧]*⟧|⟪[^⟫]*⟫")

CHANGES = [
    # The print, its correction, and both with their marks.
    ("a+b", "a-b", "a⟦+⟧b", "a⟪-⟫b"),
    ("x_1", "x_2", "x_{⟦1⟧}", "x_{⟪2⟫}"),
    ("x_1", "x", "x_{⟦1⟧}", "x"),
    ("x_5+y", "x'_5+y", "x_{5}+y", r"x_{5}^{⟪\prime⟫}+y"),
    (r"y\sqrt{\frac{a}{b}}", r"y\frac ab", r"y⟦\sqrt{⟧\frac{a}{b}⟦}⟧", r"y\frac{a}{b}"),
    (r"\frac{x}{2}+y", r"\frac{x}{3}+y", r"\frac{x}{⟦2⟧}+y", r"\frac{x}{⟪3⟫}+y"),
    # From the numerator to the denominator.
    (r"u\frac{xy}{z}", r"u\frac{x}{yz}", r"u\frac{x⟦y⟧}{z}", r"u\frac{x}{⟪y⟫z}"),
    (r"a(b+c)d", r"ab+cd", r"a⟦(⟧b+c⟦)⟧d", r"ab+cd"),
    (r"\sin x+y", r"\cos x+y", r"⟦\sin⟧x+y", r"⟪\cos⟫x+y"),
    (r"1+\mathrm{tg}\,x", r"1+\mathrm{ctg}\,x", r"1+⟦\mathrm{tg}\,⟧x", r"1+⟪\mathrm{ctg}\,⟫x"),
    (
        r"\begin{pmatrix}a&b\\c&d\end{pmatrix}",
        r"\begin{pmatrix}a&-b\\c&d\end{pmatrix}",
        r"\begin{pmatrix}a&b\\c&d\end{pmatrix}",
        r"\begin{pmatrix}a&⟪-⟫b\\c&d\end{pmatrix}",
    ),
    (r"\sqrt[3]{x}+y", r"\sqrt[4]{x}+y", r"\sqrt[⟦3⟧]{x}+y", r"\sqrt[⟪4⟫]{x}+y"),
    ("0.68x'y", "0.66x''y", r"0.6⟦8⟧x^{\prime}y", r"0.6⟪6⟫x^{\prime⟪\prime⟫}y"),
]
ALIKE = [
    (r"\left(a+b\right)c", "(a+b)c"),
    (r"\frac12x", r"\dfrac{1}{2}\,x"),
    (r"a\le b", r"a\leq b"),
    ("{a}{b}", "ab"),
    ("x_1^2", "x^2_1"),
]


@pytest.mark.parametrize(("printed", "mend", "left", "right"), CHANGES)
def test_changes_are_marked_in_both(printed: str, mend: str, left: str, right: str) -> None:
    assert mark_changes(printed, mend, TAKEN, PUT) == (left, right)
    assert mark_changes(mend, printed, PUT, TAKEN) == (right, left)


@pytest.mark.parametrize(("printed", "mend"), ALIKE)
def test_what_prints_alike_has_no_marks(printed: str, mend: str) -> None:
    left, right = mark_changes(printed, mend, TAKEN, PUT)
    assert not MARKED.search(left + right)


def test_what_has_little_in_common_stays_as_it_is() -> None:
    pair = r"\text{the mean radius }R", r"R = \frac12(\rho_{max}+\rho_{min})"
    assert mark_changes(*pair, TAKEN, PUT) == pair
    long = "a+" * 300 + "b", "a+" * 300 + "c"
    assert mark_changes(*long, TAKEN, PUT) == long
    assert mark_changes("a", "", TAKEN, PUT) == ("a", "")


SMALL = st.sampled_from(["x", "y", "+", "-", "2", r"\sin ", r"\varphi "])


def _wrap(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    kinds = (
        r"\sqrt{{{}}}",
        r"\frac{{{}}}{{y}}",
        "({})",
        "x_{{{}}}",
        "x^{{{}}}",
        r"\left[{}\right]",
    )
    wrapped = st.builds(lambda kind, text: kind.format(text), st.sampled_from(kinds), inner)
    return st.lists(st.one_of(SMALL, wrapped), min_size=1, max_size=4).map("".join)


FORMULAS = st.recursive(st.lists(SMALL, min_size=1, max_size=4).map("".join), _wrap, max_leaves=4)


def _unmarked(text: str) -> list[str]:
    plain = re.sub(r"\\left|\\right|[{}]", " ", MARKED.sub(" ", text))
    # An index or exponent remains as an empty slot if all of it is marked: ignore its sign.
    return re.findall(r"\\[a-z]+|[^_^\s]", plain)


@settings(max_examples=150, deadline=None)
@given(FORMULAS, FORMULAS)
def test_what_is_not_marked_stands_in_both(printed: str, mend: str) -> None:
    left, right = mark_changes(printed, mend, TAKEN, PUT)
    if MARKED.search(left + right):
        assert _unmarked(left) == _unmarked(right)


@pytest.mark.parametrize(
    "odd", ["a)b", "(a", "{a", "a}", "[0,1)", "_", "^", r"\sqrt", "\\", "&", "'"]
)
def test_what_is_no_latex_is_no_error(odd: str) -> None:
    assert mark_changes(odd, odd, TAKEN, PUT)
    assert mark_changes(odd, "ab", TAKEN, PUT)
