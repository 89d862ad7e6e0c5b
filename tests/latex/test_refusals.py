"""Prints that could be read in two ways are refused, with the place and a remedy."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.record import Notation, Scope, Variable

x, y, a, rho, k = (sp.Symbol(name, real=True) for name in ("x", "y", "a", "rho", "k"))
q = sp.IndexedBase("q", real=True)
VARIABLES = (
    Variable(x, "", latex=("x",)),
    Variable(y, "", latex=("y",), given=2 * x),
    Variable(a, "", latex=("a",)),
    Variable(rho, "", latex=(r"\rho(x)", r"\rho")),
    Variable(k, "", latex=("k",)),
    Variable(q, "", latex=("q",)),
    Variable(sp.Symbol("r_i"), "", latex=("r_i",)),
    Variable(sp.Symbol("d"), "", latex=("d_1",)),
)
READER = Reader(VARIABLES, Notation(factors=("a",)))

REFUSED = [
    # The print, the text at the place, a part of the reason, a part of the remedy.
    ("x_2+1", "_2", "declared, but not with an index", r"latex=(r'x_2',)"),
    ("x'", "'", "declared, but not with a prime", r"latex=(r'x\'',)".replace("\\'", "'")),
    ("a/xy", "/xy", "several factors", r"\frac"),
    ("1/2x", "/2x", "several factors", r"\frac"),
    (r"\sin^{-1}x", "^{-1}x", "inverse or its reciprocal", r"\arctan"),
    (r"\rho(y)", "(y)", "is declared, but this bracket differs", r"\rho(…)"),
    ("x(1+y)", "(1+y)", "a factor, or the argument", "factors=(r'x',)"),
    ("x^2(1+y)", "(1+y)", "a factor, or the argument", "factors=(r'x',)"),
    ("x2", "2", "a number follows", r"\cdot"),
    (r"\frac x22", "2", "a number follows", r"\cdot"),
    (r"2\frac12", r"\frac12", "mixed number", r"\cdot"),
    ("0,5a", ",5a", "decimal comma or a list", "0.5"),
    ("(0,1)x", ",1)x", "decimal comma or a list", "0.5"),
    ("(0,0,5)x", ",0,5)x", "decimal comma or a list", "0.5"),
    ("1 2", "2", "one number or two", "gap"),
    ("2.", "", "ends with a point", ""),
    (r"\cos xy", "y", "belong to the argument", "brackets"),
    (r"\cos x y", "y", "belong to the argument", "brackets"),
    (r"\cos 2xy", "y", "belong to the argument", "brackets"),
    (r"\cos\frac xy a", "a", "belong to the argument", "brackets"),
    (r"\cos x(1+y)", "(1+y)", "a factor, or the argument", "factors"),
    (r"\cos\sin(x)^2", "^2", "of the function or of the argument", r"\cos^2"),
    (r"\cos^2(x)^2", "^2", "of the function or of the argument", r"\cos^2"),
    (r"\log_2(x)^2", "^2", "of the function or of the argument", r"\cos^2"),
    (r"\frac{x}{y}^2", "^2", "without brackets", r"\left"),
    (r"\psi+x", r"\psi+x", "is not declared", r"latex=(r'\psi',)"),
    (r"\psi_1'", r"\psi_1'", "is not declared", r"latex=(r'\psi_1\'',)".replace("\\'", "'")),
    (r"b", "b", "is not declared", r"latex=(r'b',)"),
    (r"\rho_1", "_1", "declared, but not with an index", r"\rho_1"),
    ("sin x", "sin x", "in italics", r"\sin"),
    # A word for a function, not the command of the same letters.
    (r"\mathrm{int}(x)", r"\mathrm{int}", "has no meaning here", r"\mathrm{int}"),
    ("x^{*2}", "^{*2}", "declared, but not with a star", "x^*"),
    (r"\left(\frac xa\right)_{\max}=1", r"_{\max}=1", "at which place", r"\text{ at }x=0"),
    (r"(x+a)_0=1\text{ for }k=0", r"_0=1\text{ for }k=0", "at which place", r"\max_x(…)"),
    (r"\arctan(x,y)", r"\arctan(x,y)", "which of them is the numerator", "atan2"),
    (r"\vecr x", r"\vecr x", "has no meaning here", r"\newcommand{\vecr}"),
    (r"\log x", r"\log x", "not the same everywhere", "functions"),
    (r"\arcctg x", r"\arcctg x", "not the same everywhere", "functions"),
    (r"\dots=x", r"\dots=x", "an earlier print", "whole"),
    (r"(\dots)x", r"(\dots)x", "the preceding print has 0", "bracket"),
    (r"\sum q_i", "q_i", "without limits", r"\sum_{k=1}^n"),
    (r"\sum_{i=1} q_i", "q_i", "without an upper limit", r"\sum_{k=1}^n"),
    (r"\sum_{i}^2 q_i", "}", "first value", r"\sum_{k=1}^n"),
    (r"\sum_{k=1}^2 k", "k", "bound here, but also declared", "Scope"),
    (r"\int_0^1 b\,dx", r"b\,dx", "neither declared nor bound", r"latex=(r'b',)"),
    (r"\int_0 x\,dx", r"\int_0", "one limit only", ""),
    (r"\int_0^1 dx\,x", "x", "after the differential", "before the differential"),
    (r"\int_0^1\frac{dx}{x}a", "a", "after the differential", "before the differential"),
    (r"\int_0^1\frac{dx}{x}\,dy", "dy", "after the differential", ""),
    (r"\int_0^1 dx/x", "/x", "after the differential", "before the differential"),
    (r"\int_0^1 x\,dx\cdot a", r"\cdot a", "after the differential", "brackets"),
    (r"\sum_{i=1}^2 r_i", "r_i", "its index runs here", "IndexedBase"),
    (r"x\pm a", r"\pm", "no meaning", ""),
    (r"\sin x/2", "/2", "belong to the argument", "brackets"),
    (r"\frac{1}{(x+1", "", "a } is missing", ""),
    ("(x+1", "", "expected )", ""),
    ("x+1)", ")", "not understood", ""),
    ("x}", "}", "a closing brace without", ""),
    ("x^1^2", "^2", "a second ^", ""),
    ("_1", "_1", "nothing precedes", ""),
    ("x+", "", "something must follow", ""),
    ("x=?", "?", "no meaning here", ""),
    (r"\begin{Vmatrix}x\end{Vmatrix}", r"\begin", "Vmatrix", ""),
    (r"\begin{pmatrix}x&y\\x\end{pmatrix}", r"\begin", "differ in length", ""),
    (r"x\text{ if }y", "", "needs a relation sign", ""),
    (r"\mathrm 2", "2", "needs a letter or braces", ""),
    (r"\mathrm x", r"\mathrm x", "no meaning", "latex"),
    (r"a|x|y|x|", "y|x|", "which bars belong together", r"\left|"),
    (r"\lim_{xk\to0}x", r"k\to0}x", "one letter that tends", r"\lim_{x\to a}"),
    (r"tgx", "tgx", "in italics", r"\tg"),
    (r"2cosx", "cosx", "in italics", r"\cos"),
    (r"2cosxcosy", "cosxcosy", "cos in italics: a function", r"\cos"),
    (r"arccosx", "arccosx", "arccos in italics: a function", r"\arccos"),
    (r"2speed", "speed", "speed in italics: a word", r"\text{ speed }"),
    (r"\sum_{i=1}^2\sum_{i=1}^2 i", r"i=1}^2 i", "of an enclosing sum", "another letter"),
    ("1" * 301, "1", "300 digits", ""),
    (r"\sum_{i=1}^2i\sum_{i=1}^ii", "i=1}^ii", "of an enclosing sum", "another letter"),
    (r"x+a\bmod2", r"x+a", "of its last term", r"(a+b)\bmod n"),
    (r"x\bmod2+a", r"x\bmod2", "of its last term", r"(a+b)\bmod n"),
    (r"\frac{dy}{dx}(a)", "(a)", "a factor, or the place", r"\right|_{x=x_0}"),
    (r"[x\ a]", r"\ a]", "entries of a row, or factors", "commas"),
    (r"x=a\quad y", "y", "a gap, but no relation after it", "comma"),
    (r"x=2a\iff a=\frac x2", r"\iff", "has no meaning", r"\Rightarrow"),
    ("x=(4)", "(4)", "the equation with that number", "without brackets"),
    (r"\log^2x", r"\log", "not the same everywhere", "functions"),
    # Minus one in every spelling.
    *(
        (rf"\sin{power}x", rf"{power}x", "inverse or its reciprocal", r"\arctan")
        for power in (
            "^{\u22121}",
            "^{{-1}}",
            "^{(-1)}",
            "^{-1.0}",
            "^{1-2}",
            "^{ - 1}",
            "\u207b\u00b9",
        )
    ),
    (r"\log_2^{{-1}}x", "^{{-1}}x", "inverse or its reciprocal", r"\arctan"),
    # Braces print nothing.
    ("{x+y}^2", "x+y}^2", "braces print nothing", r"\left("),
    ("{-x}^2", "-x}^2", "braces print nothing", r"\left("),
    ("{xy}^2", "xy}^2", "braces print nothing", r"\left("),
    (r"{\sin x}^2", r"\sin x}^2", "braces print nothing", r"\left("),
    ("2{x+1}", "x+1}", "braces print nothing", r"\left("),
    ("{x+1}y", "x+1}y", "braces print nothing", r"\left("),
    ("x-{y+1}", "y+1}", "braces print nothing", r"\left("),
    ("x{-1}", "-1}", "braces print nothing", r"\left("),
    ("-{y-1}", "y-1}", "braces print nothing", r"\left("),
    ("1/{x/y}", "/{x/y}", "several factors", r"\frac"),
    (r"\sum_{i=1}^2{i+1}", "i+1}", "braces print nothing", r"\left("),
    (r"\cos{x}^2", "^2", "of the function or of the argument", r"\cos^2"),
    (r"\cos{x}y", "y", "belong to the argument", "brackets"),
    (r"\cos{x}(1+y)", "(1+y)", "belong to the argument", "brackets"),
    (r"\cos{x}/2", "/2", "belong to the argument", "brackets"),
    # Numbers, letters and scripts.
    ("1.5E-3", "E-3", "power of ten", r"\cdot 10^"),
    ("2e3", "e3", "power of ten", r"\cdot"),
    ("1.5 E\u22123", "E", "power of ten", r"\cdot"),
    ("x^3\u00b2", "\u00b2", "a second ^", ""),
    ("x^2°", "°", "a second ^", ""),
    (r"\Sigma_{k=1}^2 k", r"\Sigma", "not declared", r"\Sigma"),
    ("x for y", "for y", "in italics", r"\text{ for }"),
    ("x or y", "or y", "in italics", r"\text{ or }"),
    (r"\overline{x+y}", r"\overline", "not declared", "Variable"),
]


@pytest.mark.parametrize(("latex", "at", "reason", "remedy"), REFUSED, ids=[r[0] for r in REFUSED])
def test_it_is_refused_with_place_and_remedy(latex: str, at: str, reason: str, remedy: str) -> None:
    with pytest.raises(ReadingError) as caught:
        READER.parse(latex, "(7)")
    error = caught.value
    assert reason in error.reason
    assert remedy in error.remedy
    assert latex[error.place :].startswith(at)
    lines = str(error).splitlines()
    assert lines[0].startswith("row '(7)': ")
    assert lines[2].index("^") == lines[1].index(latex) + error.place


# Refused when an expression is built from what was read.
MEANINGLESS = [
    ("1/0", "divides by zero"),
    (r"\frac{1}{x-x}", "divides by zero"),
    (r"\int x\,dx", "where does it start"),
    (r"\int_0^1 x\,d\cos x", "may vary with"),
    (r"\int_0^1 y\,d\cos x", "may vary with"),
    ("9^{9^9}", "not evaluated"),
    ("(9^{999})^{999}", "not evaluated"),
    ("0^0", "no value"),
    (r"\sqrt{-1}^2", "no real value"),
    (r"\sqrt{-1-x^2}-\sqrt{-1-x^2}", "no real value"),
    (r"\arcsin 2-\arcsin 2", "no real value"),
    (r"\ln(-x^2-1)", "no real value"),
    (r"\begin{pmatrix}1\end{pmatrix}+1", "do not fit"),
    (r"\begin{pmatrix}1&2\end{pmatrix}\begin{pmatrix}1&2\end{pmatrix}", "do not fit"),
    (r"\frac{1}{\begin{pmatrix}1\end{pmatrix}}", "do not fit"),
    (r"\arcsin(1, 2)", "do not fit"),
    (r"\exp\begin{pmatrix}1&2\end{pmatrix}", "only square matrices"),
    (r"\det x", "do not fit"),
    (r"\det(1, 2)", "do not fit"),
    *(
        (latex.replace("M", r"\begin{pmatrix}1&x\\0&1\end{pmatrix}"), "where a number is expected")
        for latex in (
            *(r"\left|2M\right|", r"\sin M", r"\ln M", r"\max(M, 1)"),
            *(r"\sqrt{M}", r"\sum_{i=1}^2M", r"\int_0^1M\,dx", r"\lim_{x\to0}M"),
        )
    ),
    (r"\begin{pmatrix}1\end{pmatrix}^{1/2}", "do not fit"),
    (r"\left|\begin{matrix}1&2\end{matrix}\right|", "do not fit"),
]


@pytest.mark.parametrize(("latex", "reason"), MEANINGLESS)
def test_what_has_no_meaning_is_refused(latex: str, reason: str) -> None:
    read = READER.parse(latex)
    with pytest.raises(ReadingError, match=reason):
        read.meaning().of(read.chains[0].members[0])


def test_one_print_of_two_symbols_needs_a_scope() -> None:
    twice = (*VARIABLES, Variable(sp.Symbol("x_other"), "", latex=("x",)))
    with pytest.raises(ValueError, match=r"Notation\.scopes"):
        Reader(twice).parse("x")
    scope = Scope(("(3)",), {"x": sp.Symbol("x_other")})
    reader = Reader(VARIABLES, Notation(scopes=(scope,)))
    for row, symbol in (("(3)", "x_other"), ("(3), second equals sign", "x_other"), ("(30)", "x")):
        read = reader.parse("x", row)
        assert read.meaning().of(read.chains[0].members[0]) == sp.Symbol(
            symbol, **({"real": True} if symbol == "x" else {})
        )


def test_a_scope_frees_a_letter_for_an_index() -> None:
    reader = Reader(VARIABLES, Notation(scopes=(Scope(("(3)",), {"k": None}),)))
    read = reader.parse(r"\sum_{k=1}^2 q_k", "(3)")
    total = read.meaning().of(read.chains[0].members[0])
    assert total.doit() == q[1] + q[2]


# Functions with an argument that may have any sign.
ARGUMENTS = {
    **{"exp": sp.exp, "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "arctan": sp.atan},
    **{"sinh": sp.sinh, "th": sp.tanh, "erf": sp.erf},
}
# Read, as there is only one reading.
READ = [
    (r"\cos 2x\cdot y", sp.cos(2 * x) * y),
    (r"\cos\frac x2\sin x", sp.cos(x / 2) * sp.sin(x)),
    (r"\mathrm{tg}^2\frac x2", sp.tan(x / 2) ** 2),
    (r"\sqrt[3]{x^2+1}", sp.cbrt(x**2 + 1)),
    (r"\sqrt[3]{-8}", sp.Integer(-2)),
    ("a(x+1)^2", a * (x + 1) ** 2),
    (r"\cos(x+1)^2y", sp.cos(x + 1) ** 2 * y),
    (r"\cos x^2", sp.cos(x**2)),
    ("x[y+1]", x * (y + 1)),
    (r"a\,x^{1/2}", a * sp.sqrt(x)),
    ("-x^2", -(x**2)),
    ("2a/x", 2 * a / x),
    (r"|x-|y||", sp.Abs(x - sp.Abs(y))),
    (r"\left|x\right|^2", sp.Abs(x) ** 2),
    (r"2\lfloor x+y\rfloor", 2 * sp.floor(x + y)),
    (r"\left\lceil\frac{x}{2}\right\rceil y", sp.ceiling(x / 2) * y),
    (r"0{,}5x", x / 2),
    (r"\rho(x)+\rho", 2 * rho),
    (r"\frac12x", x / 2),
    (r"\sum_{i=1}^3 i\,x", 6 * x),
    (r"\prod_{i=1}^3 i", sp.Integer(6)),
    (r"\int_0^1(x+t)\,dt", x + sp.Rational(1, 2)),
    (r"\int_0^1 1+t\,dt", sp.Rational(3, 2)),
    (r"\int_0^{1}\frac{2t\,dt}{1}", sp.Integer(1)),
    (r"\int_0^1\int_0^t s\,ds\,dt", sp.Rational(1, 6)),
    (r"90^\circ", sp.pi / 2),
    (r"\lg 100", sp.Integer(2)),
    (r"\max(1, 2)", sp.Integer(2)),
    (r"{x}{y}", x * y),
    (r"\left|x\left|y\right|x\right|", sp.Abs(x**2 * y)),
    (r"\lvert x\rvert y\lvert x\rvert", x**2 * y),
    (r"\text{tg}\,x+\textrm{ctg}\,x", sp.tan(x) + sp.cot(x)),
    (r"\operatorname{inv}x", sp.tan(x) - x),
    (r"\operatorname{atan2}(x, y)", sp.atan2(x, y)),
    (r"\operatorname{atan} 2(x, -y)", sp.atan2(x, -y)),
    (r"\arctan 2(x-y)", sp.atan(2 * x - 2 * y)),
    (r"\log_2 8+\log_{10}^2 100", sp.Integer(7)),
    ("45°+x²", sp.pi / 4 + x**2),
    ("x\u00b7y\u2212x", x * y - x),
    (r"\mathrm e^x", sp.exp(x)),
    (r"\int_0^1 t\,\mathrm dt", sp.Rational(1, 2)),
    (r"\begin{vmatrix}x&y\\a&k\end{vmatrix}", x * k - y * a),
    (r"\left|\begin{matrix}x&y\\a&k\end{matrix}\right|", x * k - y * a),
    (r"\left|\begin{array}{cc}x&y\\a&k\end{array}\right|^2", (x * k - y * a) ** 2),
    (r"|\begin{pmatrix}x&y\\a&k\end{pmatrix}|", x * k - y * a),
    # Braces right after a function contain its argument.
    *(
        (rf"\{name}{power}{{{inside}}}+1", make(argument) ** exponent + 1)
        for name, make in ARGUMENTS.items()
        for power, exponent in (("", 1), ("^2", 2))
        for inside, argument in (
            *(("-x", -x), ("x+1", x + 1), ("{x}-{y}", x - y), ("2xy", 2 * x * y), ("x", x)),
            *((r"\frac{x}{2}", x / 2), ("{(x+1)}", x + 1), (r"\ x^2", x**2), ("{-{x}}", -x)),
        )
    ),
    (r"\log_2{x+1}", sp.log(x + 1, 2)),
    (r"\max{x,y}", sp.Max(x, y)),
    (r"\max{\left(x, y\right)}", sp.Max(x, y)),
    (r"\cos{\left(x\right)}y", sp.cos(x) * y),
    (r"\cos{(x)}/2", sp.cos(x) / 2),
    (r"\mathrm{tg}{-x}", -sp.tan(x)),
    (r"\operatorname{ch}{x+y}", sp.cosh(x + y)),
    (r"\cos{x}\sin{y+1}", sp.cos(x) * sp.sin(y + 1)),
    (r"\sin{\cos{x+1}}", sp.sin(sp.cos(x + 1))),
    (r"\sin{}x", sp.sin(x)),
    (r"\arccos{-1}", sp.pi),
    (r"{\displaystyle x+1}", x + 1),
    ("{x}^2+{y}{a}", x**2 + y * a),
    ("x+{y-a}", x + y - a),
    (r"\det\left[\begin{array}{cc}x&y\\a&k\end{array}\right]", x * k - y * a),
]


@pytest.mark.parametrize(("latex", "expression"), READ, ids=[r[0] for r in READ])
def test_it_is_read(latex: str, expression: sp.Expr) -> None:
    read = READER.parse(latex)
    found = read.meaning().of(read.chains[0].members[0])
    assert sp.simplify(found.doit() - expression) == 0
