r"""Commands of packages: each is read as what it prints."""

from __future__ import annotations

import re

import pytest

from mechproof.latex.package_commands import write_out
from mechproof.latex.tokens import list_signs

# physics, derivative, commath, esdiff; mathtools; nicefrac, xfrac.
SAME = {
    r"\dv{x}{t}": r"\frac{d(x)}{dt}",
    r"\dv{t}x": r"\frac{d}{dt}x",
    r"\dv t(x)": r"\frac{d}{dt}(x)",
    r"\dv[2]{x}{t}": r"\frac{d^2(x)}{dt^2}",
    r"\dv*[n]{t}x": r"\frac{d^n}{dt^n}x",
    r"\odv{x}t+\diff xt+\od*{}{t}x": r"\frac{d(x)}{dt}+\frac{d(x)}{dt}+\frac{d}{dt}x",
    r"\odv[order=2]{x}{t}": r"\frac{d^2(x)}{dt^2}",
    r"\odv*[n]{x}{t}": r"\frac{d^n(x)}{dt^n}",
    r"\pdv{f}{x,y}": r"\frac{\partial^2(f)}{\partial x\partial y}",
    r"\diffp[2,1]{f}{x,y_{1,2}}": r"\frac{\partial^3(f)}{\partial x^2\partial y_{1,2}}",
    r"\pdv[order={n,m}]{f}{x,y}": r"\frac{\partial^{n+m}(f)}{\partial x^n\partial y^m}",
    r"\dv{}{t}x": r"\frac{d}{dt}x",
    r"\pdv{L}{\dot q}": r"\frac{\partial(L)}{\partial\dot q}",
    r"\pdv{f}{x}{y}": r"\frac{\partial^2(f)}{\partial x\partial y}",
    r"\dv{t}\pdv{L}{\dot q}": r"\frac{d}{dt}\frac{\partial(L)}{\partial\dot q}",
    r"\dv{\norm{v}}{t}": r"\frac{d(\|v\|)}{dt}",
    r"\int x\dd{x}": r"\int xdx",
    r"\int x\dd x": r"\int xdx",
    r"\int x\mathop{}\!\odif{x}": r"\int xdx",
    r"\mdet{a&b\\c&d}": r"\begin{vmatrix}a&b\\c&d\end{vmatrix}",
    r"\begin{pNiceArray}{c|c}a&b\end{pNiceArray}": r"\begin{pmatrix}a&b\end{pmatrix}",
    r"\begin{bNiceMatrix}[r]a\end{bNiceMatrix}": r"\begin{bmatrix}a\end{bmatrix}",
    r"\int x\dd[3]{x}": r"\int xd^3x",
    r"\int x\dif x": r"\int xdx",
    r"\abs*{a+b}": r"\left|a+b\right|",
    r"\norm[\big]{a}": r"\|a\|",
    r"\qty(a+(b))^2": "(a+(b))^2",
    r"\qty[a]": "[a]",
    r"\qty{a}": r"\{a\}",
    r"\qty|a|": r"\left|a\right|",
    r"\pqty{a}\bqty{b}\vqty{c}": r"(a)[b]\left|c\right|",
    r"\eval{x^2}_0^1": r"\left.x^2\right|_0^1",
    r"\mqty(a&b\\c&d)": r"\begin{pmatrix}a&b\\c&d\end{pmatrix}",
    r"\mqty|a&b\\c&d|": r"\begin{vmatrix}a&b\\c&d\end{vmatrix}",
    r"\bmqty{a\\b}\smqty[a&b]": r"\begin{bmatrix}a\\b\end{bmatrix}\begin{bmatrix}a&b\end{bmatrix}",
    r"\spmqty{a}\smdet{a}": r"\begin{pmatrix}a\end{pmatrix}\begin{vmatrix}a\end{vmatrix}",
    r"\vb{a}\vdot\vb b\cross\va{c}": r"\mathbf a\cdot\mathbf b\times\vec c",
    r"\vu*{n}": r"\hat{\mathbf{n}}",
    r"\nicefrac12+\sfrac{a}{b}": r"\frac12+\frac ab",
    r"\prescript{0}{1}{R}": "{}^0_1R",
    r"\tensor*[^0_1]{R}{}\tensor[_1^0]{R}{_2}": "{}^0_1R{}_1^0R_2",
    r"\tensor{T}{^i_j}\tensor{T}{}": "T^i_jT",
    r"T\indices{^i_j}": "T^i_j",
    r"\ensuremath{a}\mathrel{=}\smash{b}": "a=b",
    r"\sum_{\substack{k=1\\k\ne i}}^nk": r"\sum_{k=1,k\ne i}^nk",
    r"\begin{bNiceMatrix}a\end{bNiceMatrix}": r"\begin{bmatrix}a\end{bmatrix}",
    r"\begin{psmallmatrix*}[r]a\end{psmallmatrix*}": r"\begin{pmatrix}a\end{pmatrix}",
    r"\begin{smallmatrix}a\end{smallmatrix}": r"\begin{matrix}a\end{matrix}",
    r"\frac{d^{}x}{dt^{}}": r"\frac{dx}{dt}",
    # Markdown.
    r"x\(t)=a\(b+c\)": "x(t)=a(b+c)",
}
# Calls that are in no known form stay as they are printed.
LEFT = (
    r"\diffp[2]{f}{x,y}",
    r"\odv[style=a]{x}{t}",
    r"\odv{x}",
    r"\dv=1",
    r"\mqty a",
    r"\pdv",
    r"\nicefrac1",
    r"\eval(x|_0^1",
    r"\mqty(a&b",
    r"\dv{}{}",
)


@pytest.mark.parametrize(("short", "plain"), SAME.items())
def test_a_command_is_read_as_what_it_prints(short: str, plain: str) -> None:
    assert list_signs(short) == list_signs(plain)


@pytest.mark.parametrize("latex", LEFT)
def test_a_call_in_no_known_form_is_left(latex: str) -> None:
    command = re.match(r"\\[a-z]+", latex)
    assert command
    assert list_signs(latex)[0] == command[0]


def test_a_quantity_of_siunitx_stays_one() -> None:
    assert list_signs(r"\qty{10}{mm}") == list_signs(r"\SI{10}{mm}")


@pytest.mark.parametrize(
    ("latex", "shown"),
    [
        (r"\dv[2]{x^2}{t}+\text{a b}\,y", r"\frac{d^{2}x^2}{dt^{2}}+\text{a b}\,y"),
        (
            r"\qty(\pdv{L}{q}) \left(a\right)",
            r"\left(\frac{\partial L}{\partial q}\right) \left(a\right)",
        ),
        (r"\vb a\vdot\vb b", r"\mathbf{a}\cdot\mathbf{b}"),
        (r"\qty{10}{mm}+x", r"\qty{10}{mm}+x"),
    ],
)
def test_it_is_shown_as_what_it_prints(latex: str, shown: str) -> None:
    assert write_out(latex) == shown
