"""Characters beyond ASCII are read as the signs they look like, or refused with what to print."""

# ruff: noqa: RUF001
from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.characters import find_alike, find_disguised, find_replaced, spell
from mechproof.latex.tokens import list_signs
from mechproof.record import Variable

x, y, alpha, phi = (sp.Symbol(name, real=True) for name in ("x", "y", "alpha", "phi"))
lowered = sp.Symbol("x_1", real=True)
LATEX = {x: "x", y: "y", alpha: r"\alpha", phi: r"\varphi", lowered: "x_1"}
READER = Reader([Variable(symbol, "", latex=(latex,)) for symbol, latex in LATEX.items()])

READ = [
    ("x−y", x - y),
    ("x－y＋１", x - y + 1),
    ("x×y·x⋅y∙x", x**3 * y**2),
    ("α+𝛼", 2 * alpha),
    ("φ", phi),
    ("𝑥ｘ", x**2),
    ("x²+x³+x⁴+x¹²", x**2 + x**3 + x**4 + x**12),
    ("x⁻¹", 1 / x),
    ("x₁²", lowered**2),
    ("∑_{k=1}^3k", sp.Integer(6)),
    ("∫_0^1 x\\,dx", sp.Rational(1, 2)),
    ("45°", sp.pi / 4),
    ("x\u00a0y\u2009x", x**2 * y),
    ("x\u200cy+\u200dx", x * y + x),
    ("∣x∣", sp.Abs(x)),
    ("⌊x+1⌋", sp.floor(x) + 1),
    ("2⌈x/3⌉", 2 * sp.ceiling(x / 3)),
]


@pytest.mark.parametrize(("latex", "expression"), READ)
def test_what_prints_alike_is_read_alike(latex: str, expression: sp.Expr) -> None:
    read = READER.parse(latex)
    assert sp.simplify(read.meaning().of(read.chains[0].members[0]).doit() - expression) == 0


SAME = [
    (r"\Dot{x}+\Vec{x}", r"\dot{x}+\vec{x}"),
    (
        r"\arraycolsep=2pt \begin{array}{c|c}1&2\\\hline 3&4\end{array}",
        r"\begin{array}{cc}1&2\\3&4\end{array}",
    ),
]


@pytest.mark.parametrize(("latex", "other"), SAME)
def test_what_only_sets_type_has_no_sign(latex: str, other: str) -> None:
    assert list_signs(latex) == list_signs(other)


REFUSED = [
    *((sign, "Print - for a minus") for sign in "‐‑‒–—\u00ad"),
    *((sign, "Print ' for a prime") for sign in "’‘´ʹʼ"),
    *((sign, "for degrees") for sign in "º˚ª"),
    *((sign, "command") for sign in "𝐱𝒙ẋẍ\u0304½①"),
    ("√", r"\sqrt"),
    ("÷", r"\frac"),
    ("•", r"\cdot"),
    *((sign, "") for sign in "\u200b\u2062\ufeff☺"),
]


@pytest.mark.parametrize(("sign", "remedy"), REFUSED)
def test_what_is_no_plain_sign_is_refused_by_name(sign: str, remedy: str) -> None:
    with pytest.raises(ReadingError, match="no meaning here") as caught:
        READER.parse(f"x{sign}y")
    assert remedy in caught.value.remedy
    assert f"U+{ord(caught.value.latex[caught.value.place]):04X}" in caught.value.reason


@pytest.mark.parametrize("latex", ["х", "x+х", "у", "xу", r"\sum_{х=1}^2 1"])
def test_letters_that_look_alike_are_told(latex: str) -> None:
    with pytest.raises(ReadingError, match="look alike: one letter or two") as caught:
        READER.parse(latex)
    assert "cyrillic small letter" in caught.value.reason
    assert latex[caught.value.place] in "ху"


@pytest.mark.parametrize("latex", [r"φ+\phi", r"\varepsilon+ε+\epsilon", "ϕ+φ"])
def test_a_letter_that_fonts_print_in_two_ways_is_told(latex: str) -> None:
    letters = (r"\phi", r"\varphi", r"\varepsilon", r"\epsilon")
    variables = [Variable(sp.Symbol(x.strip("\\"), real=True), "", latex=(x,)) for x in letters]
    with pytest.raises(ReadingError, match="look alike"):
        Reader(variables).parse(latex)
    assert Reader(variables[:2]).parse(r"\phi+\varphi").chains


def test_which_letters_look_alike() -> None:
    assert find_alike(("a", "а")) == ("a", "а")
    assert find_alike(("o", "ο")) == ("o", "ο")
    assert find_alike((r"\Pi", "П")) == (r"\Pi", "П")
    assert find_alike(("β", "ж", "x", "y")) is None
    # Only the first letters are blamed, not a look-alike among the others.
    assert find_alike(("a",), ("а", "b")) is None
    assert find_alike(("а",), ("a", "b")) == ("a", "а")


def test_what_is_read_as_another_sign() -> None:
    assert find_replaced("u−v·w≤αΩφx²") == {"−": "-", "·": r"\cdot", "≤": r"\le"}
    assert find_replaced("\u2126") == {"\u2126": r"\Omega"}
    assert find_disguised("аaφβж") == {"а": "a"}


@pytest.mark.parametrize("latex", ["y", r"\frac{a}{y}", r"\max(a,y)"])
def test_names_of_macros_are_no_letters(latex: str) -> None:
    letters = [Variable(sp.Symbol(x, real=True), "", latex=(x,)) for x in ("y", "a", "А", "х")]
    reader = Reader(letters)
    assert reader.parse(latex).chains
    with pytest.raises(ReadingError, match="no meaning here"):
        reader.parse("y☺")
    assert spell("″") == ("'", "'")
