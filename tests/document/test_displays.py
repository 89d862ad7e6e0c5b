"""Equations of a source: where they are, how they are named, what belongs together."""

from __future__ import annotations

import pytest

from mechproof.nomenclature.inline import find_inline, find_quantities
from mechproof.sources.displays import Printed, find_displays
from mechproof.sources.macros import MOST_CALLS
from mechproof.sources.paper_files import read_source


def find(content: str, name: str = "paper.tex") -> list[Printed]:
    return list(find_displays(read_source(name, content).text))


def show(content: str, name: str = "paper.tex") -> list[tuple[str, str]]:
    return [(p.name, " ".join(p.latex.string.split())) for p in find(content, name)]


E = r"\begin{equation}%s\end{equation}"
DISPLAYS = {
    "numbers": (E % "a=1" + E % "b=2", [("(1)", "a=1"), ("(2)", "b=2")]),
    "a star has none": (r"\begin{equation*}a=1\end{equation*}", [("display 1", "a=1")]),
    "brackets and dollars": (r"\[a=1\] $$b=2$$", [("display 1", "a=1"), ("display 2", "b=2")]),
    "a line break is no bracket": (E % r"a=1\\[2pt] b=2", [("(1), part 1", "a=1")]),
    "a tag": (E % r"a=1 \tag{A.3}" + E % "b=2", [("(A.3)", "a=1"), ("(1)", "b=2")]),
    "a line each": (
        r"\begin{align} a&=1\\ b&=2\notag\\ c&=3 \end{align}",
        [("(1)", "a=1"), ("display 1", "b=2"), ("(2)", "c=3")],
    ),
    "a chain over lines": (
        r"\begin{align} a&=b\\ &=c\\ &\quad+d \end{align}",
        [("(1)", "a=b =c +d")],
    ),
    "an open end": (E % r"\begin{split} a&=b+\\&c \end{split}", [("(1)", "a=b+ c")]),
    "braces around a letter are no system": (
        r"$$\left\{r\right\}_a=2\left\{r\right\}_b$$ $$\left\{r=1\right.$$",
        [
            ("display 1", r"\left\{r\right\}_a=2\left\{r\right\}_b"),
            ("display 2", "r=1"),
        ],
    ),
    "a star above ends no line": (
        E % r"\begin{aligned} a&=y^*\\b&=z^+\\c&=2* \\&x=d \end{aligned}",
        [("(1), part 1", "a=y^*"), ("(1), part 2", "b=z^+"), ("(1), part 3", "c=2* x=d")],
    ),
    "one line of several": (r"\begin{multline}a=b\\+c\\=d\end{multline}", [("(1)", "a=b +c =d")]),
    "one line of several between dollars": (
        r"$$\begin{multline}a=b\\ \qquad+c\end{multline}$$",
        [("display 1", r"a=b +c")],
    ),
    "letters": (
        r"\begin{subequations}\begin{gather}a=1\\b=2\end{gather}\end{subequations}" + E % "c=3",
        [("(1a)", "a=1"), ("(1b)", "b=2"), ("(2)", "c=3")],
    ),
    "within sections": (
        r"\numberwithin{equation}{section}\section{A}" + E % "a=1" + r"\section{B}" + E % "b=2",
        [("(1.1)", "a=1"), ("(2.1)", "b=2")],
    ),
    "a counter": (r"\setcounter{equation}{6}" + E % "a=1", [("(7)", "a=1")]),
    "a counter that goes on": (
        E % "a=1" + r"\addtocounter{equation}{-1}" + E % "b=2",
        [("(1)", "a=1"), ("(1)", "b=2")],
    ),
    "a sign that is printed again behind a break": (
        r"\begin{align}u&=a+{}\notag\\&\phantom{=}+b\\v&=a-\\&{}-b=\\&=c\end{align}",
        [("(1)", r"u=a \phantom{=}+b"), ("(2)", "v=a {}-b =c")],
    ),
    "a number beside an equation, without a tag": (
        r"$$a=1 \qquad (3.2)$$" + E % r"\boxed{b=2}\quad\ (7a)." + E % "c=3",
        [("(3.2)", "a=1"), ("(7a)", "b=2"), ("(1)", "c=3")],
    ),
    "dots that lead to a number, and a condition": (
        r"$$a=1\qquad-(3)$$ $$b=2\quad\cdots\cdots(4)$$ $$c=3\quad(d=0)$$ $$e=a-(3)$$",
        [
            ("(3)", "a=1"),
            ("(4)", "b=2"),
            ("display 1", r"c=3\quad(d=0)"),
            ("display 2", "e=a-(3)"),
        ],
    ),
    "a number of another shape": (
        r"\renewcommand{\theequation}{S\arabic{equation}}" + E % "a=1",
        [("(S1)", "a=1")],
    ),
    "a number within a section": (
        r"\renewcommand{\theequation}{\thesection.\alph{equation}}\section{A}" + E % "a=1",
        [("(1.a)", "a=1")],
    ),
    "an appendix": (
        r"\numberwithin{equation}{section}\section{A}"
        + E % "a=1"
        + r"\appendix\section{B}"
        + E % "b=2",
        [("(1.1)", "a=1"), ("(A.1)", "b=2")],
    ),
    "a tag with braces": (E % r"a=1 \tag{\textit{A}.3}", [(r"(\textit{A}.3)", "a=1")]),
    "inequalities before two equations, which may be meant where they hold": (
        E % r"a>0,\quad b=1,\quad c=2" + E % r"a=1,\quad b>0,\quad c=2",
        [
            ("(1)", r"a>0,\quad b=1,\quad c=2"),
            ("(2), part 1", r"a=1,\quad b>0"),
            ("(2), part 2", "c=2"),
        ],
    ),
    "what is false is no text": (
        r"\iffalse $$a=1 \iff b$$ \iftrue $$b=2$$ \fi $$c=3$$ \fi $$d=4$$",
        [("display 1", "d=4")],
    ),
    "the other branch of what is false is text": (
        r"\iffalse $$a=1$$ \else $$b=2$$ \fi \ifx\a\b $$c=3$$ \else $$d=4$$ \fi \iftoggle{a}{}{}"
        r"\iftrue $$e=5$$ \else $$f=6$$ \fi",
        [(f"display {n}", f"{x}={m}") for n, (x, m) in enumerate(("b2", "c3", "d4", "e5"), 1)],
    ),
    "a decision of the paper": (
        r"\newif\ifdraft\newif\iflong\longtrue\ifdraft $$a=1$$ \ifx\a\b\else $$b=2$$ \fi"
        r"\else $$c=3$$ \fi\iflong $$d=4$$ \fi",
        [("display 1", "c=3"), ("display 2", "d=4")],
    ),
    "listings, drawings and algorithms": (
        r"\lstinline[a]!$$a=1$$!, \mintinline{tex}|$$b=2$$|, \verb*+$$c=3$$+"
        r"\begin{Verbatim}$$e=5$$\end{Verbatim} \begin{algorithm}\[n=n+1\]\end{algorithm}"
        r"\begin{tikzpicture}\node {$$e=6$$};\end{tikzpicture} $$d=4$$",
        [("display 1", "d=4")],
    ),
    "two formulas in a line are no display": (
        r"Both $a$$b$ and $c$ $$d=4$$",
        [("display 1", "d=4")],
    ),
    "prices are no formulas": (
        r"It costs \$5 or $6: $$a=1$$ and \$6 $$b=2$$",
        [("display 1", "a=1"), ("display 2", "b=2")],
    ),
    "a matrix is whole": (
        E % r"A=\begin{pmatrix}1&2\\3&4\end{pmatrix}",
        [("(1)", r"A=\begin{pmatrix}1&2\\3&4\end{pmatrix}")],
    ),
    "cases are whole": (
        E % r"y=\begin{cases}1&x>0\\2&x\le0\end{cases}",
        [("(1)", r"y=\begin{cases}1&x>0\\2&x\le0\end{cases}")],
    ),
    "a gap parts equations": (
        E % r"a=1,\quad\text{and}\quad b=2",
        [("(1), part 1", "a=1"), ("(1), part 2", "b=2")],
    ),
    "a gap keeps conditions": (E % r"a=b,\quad x>0", [("(1)", r"a=b,\quad x>0")]),
    "words keep conditions": (E % r"a=b\quad\text{if }x=0", [("(1)", r"a=b\quad\text{if }x=0")]),
    "what leads is left": (r"\[\Rightarrow a=1.\]", [("display 1", "a=1")]),
    "comments": ("% $$a=1$$\n$$b=2 % c\n$$", [("display 1", "b=2")]),
    "a per cent is none": (E % r"a=5\%", [("(1)", r"a=5\%")]),
    "verbatim": (r"\begin{verbatim}$$a=1$$\end{verbatim}$$b=2$$", [("display 1", "b=2")]),
    "macros": (
        r"\newcommand{\half}[1]{\frac{#1}{2}}\def\om{\omega}" + E % r"a=\half{b}\om t",
        [("(1)", r"a=\frac{b}{2}\omega t")],
    ),
    "a default": (
        r"\newcommand{\p}[2][x]{\frac{d#2}{d#1}}" + E % r"\p{y}=\p[t]{z}",
        [("(1)", r"\frac{dy}{dx}=\frac{dz}{dt}")],
    ),
    "a name runs into no letter": (
        r"\newcommand{\p}[1]{\sin#1}" + E % r"\p{y}=\p zt",
        [("(1)", r"\sin y=\sin zt")],
    ),
    "a command with its arguments specified": (
        r"\NewDocumentCommand{\p}{O{x} m m}{\frac{d#2}{d#1}#3}"
        r"\DeclareDocumentCommand\q{o m}{#2_{#1}}" + E % r"\p{y}{2}=\p[t]zw+\q{c}",
        [("(1)", r"\frac{dy}{dx}2=\frac{dz}{dt}w+c_{}")],
    ),
    "what a command has for arguments that are given": (
        r"\NewDocumentCommand{\p}{m o O{z}}{#1\IfValueT{#2}{_{#2}}#3}"
        r"\NewDocumentCommand\q{o}{\IfNoValueTF{#1}{c}{d^{#1}}}"
        r"\NewDocumentCommand\s{s m}{#2}" + E % r"\p{x}=\p{y}[1][w]+\q+\q[2]+\s{a}",
        [("(1)", r"xz=y_{1}w+c+d^{2}+\s{a}")],
    ),
    "a pair of delimiters": (
        r"\DeclarePairedDelimiter{\p}{\lvert}{\rvert}" + E % r"\p{y}=\p*{z}+\p[\big]w",
        [("(1)", r"\left\lvert y\right\rvert=\left\lvert z\right\rvert+\left\lvert w\right\rvert")],
    ),
    "an operator": (
        r"\DeclareMathOperator{\inv}{inv}" + E % r"\inv a=b",
        [("(1)", r"\operatorname{inv} a=b")],
    ),
    "a unit": (
        r"\DeclareSIUnit[mode=text]{\rev}{rpm}\DeclareSIUnit\turn{r}" + E % r"n=\SI{3}{\rev}",
        [("(1)", r"n=\SI{3}{rpm}")],
    ),
    "a macro within the first display that uses it": (
        r"$$\newcommand{\w}[1]{\mathbf{#1}} a=\w{b}$$ $$c=\w{d}$$",
        [("display 1", r"a=\mathbf{b}"), ("display 2", r"c=\mathbf{d}")],
    ),
    "macros are known from where they stand on": (
        r"\newcommand\w{x}" + E % r"a=\w" + r"\renewcommand\w{y}" + E % r"a=\w",
        [("(1)", "a=x"), ("(2)", "a=y")],
    ),
    "macros for environments": (
        r"\def\be{\begin{equation}}\def\ee{\end{equation}}\be a=1\ee" + E % "b=2",
        [("(1)", "a=1"), ("(2)", "b=2")],
    ),
    "columns": (
        r"\begin{align}x&=2a & y&=3a\\ z&=1\end{align}",
        [("(1), part 1", "x=2a"), ("(1), part 2", "y=3a"), ("(2)", "z=1")],
    ),
    "columns, and numbers below a number": (
        r"\begin{IEEEeqnarray}{rCl} a&=&1\IEEEyesnumber\IEEEyessubnumber\\"
        r"b&=&2\IEEEyessubnumber\\c&=&3\IEEEnonumber\\d&=&4\\f&=&5\IEEEyessubnumber"
        r"\end{IEEEeqnarray}\begin{IEEEeqnarray*}{l}g=6\\h=7\IEEEyesnumber\end{IEEEeqnarray*}",
        [
            *(("(1a)", "a=1"), ("(1b)", "b=2"), ("display 1", "c=3"), ("(2)", "d=4")),
            *(("(3a)", "f=5"), ("display 2", "g=6"), ("(4)", "h=7")),
        ],
    ),
    "arrows between lines": (
        r"$$\begin{aligned}a&=1\Leftrightarrow\\b&=2\\&\Longleftrightarrow\\c&=3\end{aligned}$$",
        [("display 1", "a=1"), ("display 2", "b=2"), ("display 3", "c=3")],
    ),
    "one column": (r"\begin{eqnarray}x&=&2a\end{eqnarray}", [("(1)", "x=2a")]),
    "sized brackets over lines": (
        r"\begin{align}y&=a\left(b\right.\nonumber\\&\quad\left.+c\right)\\x&=y\end{align}",
        [("(1)", r"y=a\left(b\right. \left.+c\right)"), ("(2)", "x=y")],
    ),
    "words between lines": (
        r"\begin{align}a&=1\\ \intertext{and}b&=2\end{align}",
        [("(1)", "a=1"), ("(2)", "b=2")],
    ),
    "the end of the document": (r"$$a=1$$\end{document}$$b=2$$", [("display 1", "a=1")]),
    "verbatim in a line": (r"\verb|$$a=1$$| $$b=2$$", [("display 1", "b=2")]),
    "macros of macros": (
        r"\newcommand\a{\b}\newcommand\b{x}" + E % r"\a=1",
        [("(1)", "x=1")],
    ),
}


@pytest.mark.parametrize("case", DISPLAYS)
def test_displays_are_named_as_latex_does(case: str) -> None:
    content, expected = DISPLAYS[case]
    assert show(content)[: len(expected)] == expected


def test_markdown_has_dollars_and_fences() -> None:
    content = (
        "# A\n```\n$$a=1$$\n```\n<!-- $$c=3$$ -->\n$$b=2$$\n\\[d=4\\]\n```math\ne=5\n```\n$f=6$\n"
    )
    latex = [latex for _, latex in show(content, "paper.md")]
    assert latex == ["b=2", "d=4", "e=5", "f=6"]


def test_directives_are_displays_that_may_have_a_label() -> None:
    fence = "```"
    first = ":::{math}\n:label: eq:a\na = 1\n:::\n:::{note}\nSee {eq}`eq:a`.\n"
    content = f"{first}::::{{math}}\nb = 2\n::::\n{fence}{{math}}\nc=3\n{fence}\n:::\n"
    content += ":::{math}\n:label:\nd=4\n:::\n<!--\n:::{math}\nx=5\n::: -->\n"
    content += f"{fence}{{code}}\n:::{{math}}\n{fence}\n$$e=5$$\n"
    source = read_source("paper.md", content)
    found = list(find_displays(source.text))
    shown = [(one.latex.string.strip(), one.labels) for one in found]
    assert shown[:2] == [("a = 1", ("eq:a",)), ("b = 2", ())]
    assert shown[2:] == [(latex, ()) for latex in ("c=3", "d=4", "e=5")]
    assert r"See \eqref{eq:a}." in source.text.string
    assert found[0].locate(source.files).line == 3


def test_labels_name_what_they_stand_in() -> None:
    (one,) = find(E % r"\label{eq:ratio}a=1")
    assert one.labels == ("eq:ratio",)
    assert "label" not in one.latex.string


def test_a_tag_may_have_a_sign_that_begins_comments() -> None:
    (one,) = find(r"$$a=1\tag*{95 \% interval}$$ % a comment")
    assert one.name == "95 % interval"


def test_what_a_display_cites_is_no_part_of_it() -> None:
    first, second = find(r"$$a=1\cite{S6, S48}$$ $$b=2$$")
    assert (first.cites, first.latex.string) == (("S6", "S48"), "a=1")
    assert second.cites == ()
    (third,) = find(r"$$c=3\cite[p.~3]{S6}$$")
    assert (third.cites, third.latex.string) == (("S6",), "c=3")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\\begin{equation}a=1\n" + E % "b=2", [("a=1", True), ("b=2", False)]),
        (E % "a=1" + "\\begin{align*}\nb=2", [("a=1", False), (r"\begin{align*}", True)]),
        ("$$a=1$$\n  $$b=2$$\n$$c=3", [("a=1", False), ("b=2", False), ("c=3", True)]),
        ("\\[a=1\\]\n\\[b=2\n", [("a=1", False), ("b=2", True)]),
        (r"\[\begin{aligned}[t]a&=1\\b&=2\end{aligned}\]", [("a=1", False), ("b=2", False)]),
        (r"\[\begin{aligned}a&=1\\[2mm]b&=2\end{aligned}\]", [("a=1", False), ("b=2", False)]),
    ],
)
def test_what_is_opened_and_has_no_end_is_told(text: str, expected: list[tuple[str, bool]]) -> None:
    found = [(one.latex.string, "never closed" in one.fault) for one in find(text)]
    assert found == expected


@pytest.mark.slow
def test_macros_in_a_circle_are_told() -> None:
    (one,) = find(r"\newcommand{\x}{\x+1}" + E % r"a=\x")
    assert "endlessly" in one.fault
    assert MOST_CALLS > 0


def test_places_are_those_of_the_source() -> None:
    source = read_source("paper.tex", "\n% comment\n" + r"\newcommand{\k}{kk}" + "\n  $$ \\k=b $$")
    (one,) = find_displays(source.text)
    place = source.files.locate(one.latex.offsets[one.latex.string.index("b")])
    assert str(place) == "paper.tex:4:9"
    assert str(source.files.locate(one.latex.offsets[0])) == "paper.tex:4:6"


@pytest.mark.parametrize(
    "name",
    [
        *("equation", "align*", "alignat", "flalign*", "displaymath", "IEEEeqnarray", "dmath"),
        *("numcases", "xalignat", "tabular*", "longtable"),
    ],
)
def test_what_stands_in_a_display_or_a_table_is_no_sentence(name: str) -> None:
    said = r"y \text{, a bolt of 157 mm and, as given above, $a=5$} \\[2pt]"
    shown = read_source("paper.tex", rf"\begin{{{name}}}{said}\end{{{name}}} Then {said}")
    places = [one.offset for one in find_inline(shown, ["a"])]
    places += [one.place for one in find_quantities(shown)]
    assert len(places) == 2
    assert all(place > shown.text.string.index("Then") for place in places)


@pytest.mark.parametrize("command", ["text", "textrm", "textit", "mbox", "mathrm"])
def test_words_are_the_same_in_every_typeface(command: str) -> None:
    ranged = rf"$$x_i=a_i\quad\{command}{{for}}\ i=1,\dots,n$$"
    titled, joined = rf"$$\{command}{{Law}}: x=b$$", rf"$$y=c\quad\{command}{{and}}\quad z=d$$"
    assert [latex for _, latex in show(ranged + titled + joined)] == [
        "x_i=a_i",
        "x=b",
        "y=c",
        "z=d",
    ]
    assert rf"\{command}{{never}}" in show(joined.replace("and", "never"))[0][1]


def test_what_stands_after_a_line_break_is_a_sentence() -> None:
    shown = read_source("paper.tex", r"A line\\[2pt] with $a=5$ \[y=ax\] and $b=6$")
    assert [one.letter for one in find_inline(shown, ["a", "b"])] == ["a", "b"]
