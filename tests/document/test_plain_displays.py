"""Displays of packages and of plain TeX: how they are read, numbered and judged."""

from __future__ import annotations

import pytest

from mechproof import check
from mechproof.sources.displays import find_displays
from mechproof.sources.paper_files import read_source

E = r"\begin{equation}%s\end{equation}"


def show(content: str) -> list[tuple[str, str]]:
    found = find_displays(read_source("paper.tex", content).text)
    return [(p.name, " ".join(p.latex.string.split())) for p in found]


CASES = r"\begin{cases*} x &\text{ if } x>0 \\ -x, &\text{ otherwise } \end{cases*}"
DISPLAYS = {
    "empheq": (
        r"\begin{empheq}[box={\fbox[a]{}}]{align} a&=b\\c&=d\end{empheq}" + E % "e=f",
        [("(1)", "a=b"), ("(2)", "c=d"), ("(3)", "e=f")],
    ),
    "a brace around equations": (
        r"\begin{empheq}[left=\empheqlbrace\,,right={}]{alignat*=2} a&=b&c&=d\end{empheq}",
        [("display 1", "a=b"), ("display 2", "c=d")],
    ),
    "a brace before values": (
        r"\begin{empheq}[left={y=\empheqlbrace}]{align} &a,&x>0\\&b,&x<0\end{empheq}" + E % "e=f",
        [("(1)", r"{y=}\begin{cases} &a,&x>0\\&b,&x<0\end{cases}"), ("(3)", "e=f")],
    ),
    "numcases": (
        r"\begin{numcases}{y_{a}=} x & if $x>0$\\ -x, & otherwise \end{numcases}" + E % "e=f",
        [("(1)", "y_{a}=" + CASES), ("(3)", "e=f")],
    ),
    "subnumcases": (
        r"\begin{subnumcases}{\label{a}y=} a & $x>0$,\\ b & $x<0$.\end{subnumcases}" + E % "e=f",
        [("(1)", r"y=\begin{cases*} a & x>0 , \\ b & x<0 . \end{cases*}"), ("(2)", "e=f")],
    ),
    "subeqnarray": (
        r"\begin{subeqnarray}a&=&b\\c&=&d\end{subeqnarray}",
        [("(1a)", "a=b"), ("(1b)", "c=d")],
    ),
    "old fractions": (
        r"$$x={a\over b}+\sqrt{1\over{c+1}}\eqno(3)$$ $$\left(a\over b\right)=a\overline b$$",
        [
            ("(3)", r"x={\frac{a}{b}}+\sqrt{\frac{1}{{c+1}}}"),
            ("display 1", r"\left(a\over b\right)=a\overline b"),
        ],
    ),
    "old lines": (
        r"$$\eqalign{a&=b\cr c&=\matrix{a\cr d\cr}\cr}\leqno(A.1)$$",
        [("(A.1), part 1", "a=b"), ("(A.1), part 2", r"c=\begin{matrix}a\\ d\\ \end{matrix}")],
    ),
    "lengths and points in words": (
        E % r"a=b\hspace{-1mm}c\kern 2pt d,\hspace{1em}x=y\hspace*{1cm}\mbox{ .}\hfill",
        [("(1), part 1", "a=b c d"), ("(1), part 2", "x=y")],
    ),
    "a break of lines before a length": (
        r"\begin{align}a&=b\\\hspace{1em}c&=d\end{align}",
        [("(1)", "a=b"), ("(2)", "c=d")],
    ),
    "words of physics": (
        E % r"a=b\qq{and}c=d\qc e=f\qand g=h",
        [
            ("(1), part 1", "a=b"),
            ("(1), part 2", "c=d"),
            ("(1), part 3", "e=f"),
            ("(1), part 4", "g=h"),
        ],
    ),
    "a box over an alignment": (
        r"\begin{align}\Aboxed{a&=b}\\\boxed{c=d}\\\textcolor[rgb]{1,0,0}{e=f}\\{\color{red}g=h}\qedhere"
        r"\end{align}",
        [("(1)", "a=b"), ("(2)", "c=d"), ("(3)", "e=f"), ("(4)", r"{\color{red}g=h}")],
    ),
    "matrices of physics, and formulas on a colour or in a frame": (
        E
        % r"\mqty(a\\b)=\smqty[(c)\\d]+\colorbox{red}{$b+1$}\fcolorbox{red}{white}{$c$}\fbox{$d$}",
        [("(1)", r"\pmqty{a\\b}=\bmqty{(c)\\d}+{b+1}{c}{d}")],
    ),
    "equations from which others follow": (
        r"$$(1),(2)\Longrightarrow(3)\qquad a=b$$ $$(1)\Rightarrow c=d$$ $$(1)\to(2)\quad2(3)=e$$",
        [
            ("display 1", "a=b"),
            ("display 2", "c=d"),
            ("display 3", r"(1)\to(2)\quad2(3)=e"),
        ],
    ),
    "settings of siunitx": (
        E % r"a=\SI[per-mode=symbol]{3}{m}+\qty[b]{c}",
        [("(1)", r"a=\SI{3}{m}+\qty[b]{c}")],
    ),
    "environments of one's own": (
        r"\newenvironment{eqs}[1]{\begin{align}\label{#1}}{\end{align}}"
        r"\newenvironment{note}{\begin{quote}}{\end{quote}}"
        r"\begin{note}\begin{eqs}{k}a&=b\\c&=d\end{eqs}\end{note}",
        [("(1)", "a=b"), ("(2)", "c=d")],
    ),
    "a pair of commands": (
        r"\def\be#1\ee{\begin{equation}#1\end{equation}}\be a=b\ee \def\f#1\g{#1#1}\[\f a\g\]",
        [("(1)", "a=b"), ("display 1", r"\f a\g")],
    ),
    "brackets that go on": (
        r"\begin{align}a&=b\Bigl(c\nonumber\\&\quad+d=e\Bigr)\\f&=g\left(h\right.\\&\left.+k\right)=l"
        r"\\+m&=n\\x&=(0,1]\\y&=z\end{align}",
        [
            ("(1)", r"a=b\Bigl(c +d=e\Bigr)"),
            ("(2)", r"f=g\left(h\right. \left.+k\right)=l +m=n"),
            ("(5)", "x=(0,1]"),
            ("(6)", "y=z"),
        ],
    ),
    "for all values of a letter": (
        r"\begin{align}a&=b\quad\forall a\\c&=d,\text{ for all }c_{1}\\e&=f\ \forall n\\"
        r"g&=h\;\forall g>0\end{align}",
        [("(1)", "a=b"), ("(2)", "c=d"), ("(3)", r"e=f\ \forall n"), ("(4)", r"g=h\;\forall g>0")],
    ),
    "what braces say": (
        E % r"\underbrace{a+\frac{b}{c}}_{=:d}+\overbrace{e}^{\text{gain}}+\underbrace{f}_{g}=h",
        [
            (
                "(1), part 1",
                r"\underbrace{a+\frac{b}{c}}_{=:d}+\overbrace{e}^{\text{gain}}+\underbrace{f}_{g}=h",
            ),
            ("(1), part 2", r"d=a+\frac{b}{c}"),
        ],
    ),
    "first lines that stand out": (
        r"\begin{eqnarray*}\lefteqn{a+b}\\&=&c\end{eqnarray*}"
        r"\begin{align*}\MoveEqLeft[3]a\\={}&b\end{align*}",
        [("display 1", "a+b =c"), ("display 2", "a ={}b")],
    ),
    "words with formulas among them": (
        E % r"a=\left\lbrace\begin{array}[c]{l}b\\c&\mbox{if $d_{1}>0$}\end{array}\right.",
        [("(1)", r"a=\left\{\begin{array}{l}b\\c&\text{if } d_{1}>0 \end{array}\right.")],
    ),
    "words between with braces of their own": (
        r"\begin{align*}a&=b\intertext{the \emph{sum} of all}c&=\int\text{d}x\end{align*}",
        [("display 1", "a=b"), ("display 2", r"c=\int\mathrm{d}x")],
    ),
    "names at the ends of lines": (
        r"\begin{IEEEeqnarray}{rCl}a&=&b\IEEEyesnumber\IEEEyessubnumber*\\c&=&\nonumber\\&&d\\"
        r"\end{IEEEeqnarray}",
        [("(1a)", "a=b"), ("(2)", "c= d")],
    ),
}


@pytest.mark.parametrize(("content", "expected"), DISPLAYS.values(), ids=DISPLAYS)
def test_displays_are_those_of_amsmath(content: str, expected: list[tuple[str, str]]) -> None:
    assert show(content) == expected


PAPER = r"""
%% mechproof
%% x ; y ; x_1 : numbers
%% end
"""
JUDGED = {
    r"\begin{numcases}{|x|=} x & if $x\ge0$\\ %sx & otherwise\end{numcases}": ("-", "2"),
    r"$$|x|=\cases{x,&if $x\ge0$\cr %sx,&if $x<0$\cr}$$": ("-", "2"),
    r"$$\eqalign{x^2-y^2&=(x+y)\cr&\quad\times(x%sy)\cr}$$": ("-", "+"),
    r"$$\tan x={\sin x\over\cos %s}$$": ("x", "(x+1)"),
    r"\begin{empheq}{equation}\sin2x=%s\sin x\cos x\end{empheq}": ("2", "3"),
    r"\begin{equation}\sin{x}_{1}=2\sin\frac{{x}_1}2%s\frac{x_1}2\end{equation}": (
        r"\cos",
        r"\sin",
    ),
    r"\begin{align*}\sqrt{x^2}&=x\quad\text{for $x%s0$.}\end{align*}": (">", "<"),
    r"$$2\pi*x-\pi*%s=\pi*x$$": ("x", "x^2"),
    r"$$(3)2x=%sx$$": ("6", "5"),
    r"$$\sqrt{x^2}=x\quad with\qquad x%s0$$": (">", "<"),
    r"$$x\textsubscript{1}+x\textsubscript{$1$}=%sx_1$$": ("2", "3"),
    r"\begin{align*}\sin2x&=%s\sin x\cos x&&\text{(double angle)},\end{align*}": ("2", "3"),
    r"$$\sin^2x+\cos^2x=%s\text{ (loop 2)}$$": ("1", "2"),
    r"$$x+x=%sx\quad\text{(see Fig. 2)}$$": ("2", "3"),
    r"\begin{align}x^2-y^2&=\bigl(x\\&\quad+y\bigr)(x%sy)\end{align}": ("-", "+"),
}


VECTORS = r"""
%% mechproof
%% J 2x2 : matrix
%% \bm q ; \dot{\bm q} ; \bm x 2x1 : columns
%% end
"""


def test_types_that_print_alike_and_dots_in_bold_are_one_letter() -> None:
    rows = check(
        "paper.tex",
        VECTORS + E % r"\bm x=J\bm{\dot q}\quad\text{and}\quad "
        r"\boldsymbol{x}\cdot\pmb{\dot{q}}=\dot{\bm{q}}^TJ\boldsymbol{\dot{q}}",
    ).rows
    assert [str(row.outcome) for row in rows] == ["DEFINITION", "PROVED"]
    (row,) = check("paper.tex", VECTORS + E % r"\bm x=J\mathbf{\dot q}").rows
    assert str(row.outcome) == "not read"


@pytest.mark.parametrize(("last", "outcome"), [("a", "PROVED"), ("c", "DEFINITION")])
def test_vectors_may_have_the_arrow_of_esvect(last: str, outcome: str) -> None:
    block = "%% mechproof\n%% \\vec a ; \\vec b ; \\vec c 3x1 : vectors\n%% end\n"
    latex = rf"\vv{{a}}\cdot(\vv{{b}}\times\vv{{{last}}})=\vv{{a}}\cdot\vv{{a}}-\vv{{a}}^2"
    (row,) = check("paper.tex", block + E % latex).rows
    assert str(row.outcome) == outcome


UNREAD = {
    r"\sin[2](x)=y": "a number in square brackets after a function",
    r"y=\num{2.0(1)}": "a bracket after the digits of a number",
    r"y=\SI{3(2)}{m}": "a bracket after the digits of a number",
    r"\begin{pmatrix}x&\\&y\end{pmatrix}=\begin{pmatrix}x&0\\0&y\end{pmatrix}": "an empty entry",
    r"\sqrt{x^2}=x\quad\text{unless $x<0$}": "unless",
    r"\left(x\over y\right)=\frac xy": r"\over has no meaning",
    # Remarks that deny an equation, and words that may be units.
    r"x=y\quad\text{(a contradiction)}": "is not understood",
    r"x=2y\quad\text{(kilometers)}": "is not understood",
    r"x=25\quad\text{(percent)}": "is not understood",
    r"x=25\quad\text{(square metres)}": "is not understood",
    # The (1) may refer to equation (1).
    r"x=y-2(1)": "the number, or the equation with that number?",
    r"x=5-(1)": "the number, or the equation with that number?",
    r"xspeed=y": "speed in italics: a word or a product?",
}


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"x,y\Longrightarrow(3)", "not judged"),
        (r"(3),(4)\Rightarrow(5)\to(6)", "not judged"),
        (r"\frac xz\longrightarrow(x_1)", "not judged"),
        (r"\vec z", "not judged"),
        # What states something is read, or refused with a reason.
        (r"x=y\Longrightarrow x^2=y^2", "PROVED"),
        (r"x=y\Longrightarrow x^2=-y^2-1", "REFUTED"),
        (r"x\ll y", "not read"),
        (r"x∝y", "not read"),
    ],
)
def test_references_and_other_prints_without_relations_state_nothing(
    latex: str, outcome: str
) -> None:
    (*_, row) = check("paper.tex", PAPER + E % latex).rows
    assert str(row.outcome) == outcome
    assert ("no relation sign" in row.reason) == (outcome == "not judged")


@pytest.mark.parametrize(("one", "other"), [("", "REFUTED"), ("(maximum)", "not judged")])
@pytest.mark.parametrize("is_first", [True, False])
def test_an_equation_with_a_remark_may_be_of_another_case(
    one: str, other: str, is_first: bool
) -> None:
    remark = rf"\text{{{one}}}"
    remarks = (remark, "") if is_first else ("", remark)
    text = rf"$$x_1=2x+y{remarks[0]}$$ $$x_1=3x+y{remarks[1]}$$"
    rows = check("paper.tex", PAPER + text).rows
    assert [str(row.outcome) for row in rows] == ["DEFINITION", other]


def test_what_a_brace_says_is_judged() -> None:
    print_ = E % r"\underbrace{\sin^2x-\cos^2x}_{=-%s2x}+y=y-\cos2x"
    for name, outcome in {r"\cos": "PROVED", r"\sin": "REFUTED"}.items():
        rows = check("paper.tex", PAPER + print_ % name).rows
        assert [str(row.outcome) for row in rows] == ["PROVED", outcome]


@pytest.mark.parametrize(("latex", "reason"), UNREAD.items())
def test_what_may_be_meant_in_two_ways_is_not_read(latex: str, reason: str) -> None:
    (row,) = check("paper.tex", PAPER + E % latex).rows
    assert str(row.outcome) == "not read"
    assert reason in row.reason


@pytest.mark.parametrize(("latex", "ways"), JUDGED.items())
def test_what_is_true_is_proved_and_a_misprint_is_not(latex: str, ways: tuple[str, str]) -> None:
    true, wrong = (check("paper.tex", PAPER + latex % way).rows for way in ways)
    assert [str(row.outcome) for row in true] == ["PROVED"]
    assert "PROVED" not in [str(row.outcome) for row in wrong]
