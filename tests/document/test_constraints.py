"""Constraints of small papers: what follows from them, and what they excuse."""

from __future__ import annotations

import pytest
from small_papers import outcomes

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

LOOP = r"a\cos\alpha+b\cos\beta=c\cos\gamma+h"
CASES = {
    "constraints are given": ([LOOP], ["DEFINITION"]),
    "consequences of constraints": (
        [LOOP, r"h+c\cos\gamma-b\cos\beta-a\cos\alpha=0", r"ka\cos\alpha=k(h-b\cos\beta)"],
        ["DEFINITION", "PROVED", "not read"],
    ),
    "a multiple": (
        [r"a\cos\alpha=b", r"a^2\cos^2\alpha=b^2", r"a\cos^2\alpha=b\cos\alpha"],
        ["DEFINITION", "PROVED", "PROVED"],
    ),
    "nothing follows where it has no value": (
        [
            r"\sin\alpha=0",
            r"\frac{k\sin\alpha}{1-\cos^2\alpha}=0",
            r"\frac{m\sin\alpha}{a}=0",
            r"\frac{m\sin\alpha}{n}=0",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "PROVED"],
    ),
    "nor from what its own tangent is divided by": (
        [r"\cos\psi=0", r"m\tan\psi=\frac{m\sin\psi}{\cos\psi}+\cos\psi"],
        ["DEFINITION", "not judged"],
    ),
    "constraints may be divided by each other": (
        [
            r"h\cos\psi=a+r\cos\alpha",
            r"h\sin\psi=r\sin\alpha",
            r"\tan\psi=\frac{r\sin\alpha}{a+r\cos\alpha}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "the derivative of an angle whose tangent is printed": (
        [
            r"\tan\eta=\frac{r\sin\varphi}{h-r\cos\varphi}",
            r"\dot\eta=\frac{r\dot\varphi(h\cos\varphi-r)}{h^2+r^2-2hr\cos\varphi}",
            r"\dot\eta=\frac{r\dot\varphi(h\cos\varphi+r)}{h^2+r^2-2hr\cos\varphi}",
        ],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "what a tangent of a sum is written out by": (
        [
            r"\tan\alpha=\frac{h}{a}",
            r"k\tan(\alpha+\beta)=k\frac{h+a\tan\beta}{a-h\tan\beta}",
            r"k\tan(\alpha+\beta)=k\frac{h+a\tan\beta}{a+h\tan\beta}",
            r"k\tan(\alpha+\beta)=k\frac{h+a\tan\beta}{a-h\tan\beta}+mh-ma\tan\alpha",
            r"k\tan(\alpha+\beta)=k\frac{h+a\tan\beta}{a-h\tan\beta}+\frac{mh-ma\tan\alpha}{n}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "PROVED"],
    ),
    "the derivative of what a constraint gives": (
        [
            r"x^2-2rx\cos\varphi+r^2=l^2",
            r"\dot x=-\frac{rx\dot\varphi\sin\varphi}{x-r\cos\varphi}",
            r"(x-r\cos\varphi)\dot x=-rx\dot\varphi\sin\varphi",
        ],
        ["DEFINITION", "PROVED", "PROVED"],
    ),
    "a derivative by two constraints": (
        [
            r"r\cos\varphi+l\cos\zeta=h+c\cos\eta",
            r"r\sin\varphi+l\sin\zeta=c\sin\eta",
            r"\dot\zeta=\frac{r\dot\varphi\sin(\eta-\varphi)}{l\sin(\zeta-\eta)}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "a second derivative by two": (
        [
            r"r\cos\varphi+l\cos\zeta=h+c\cos\eta",
            r"r\sin\varphi+l\sin\zeta=c\sin\eta",
            r"\dot\zeta=\frac{r\dot\varphi\sin(\eta-\varphi)}{l\sin(\zeta-\eta)}",
            r"\dot\eta=\frac{r\dot\varphi\sin(\varphi-\zeta)}{c\sin(\eta-\zeta)}",
            r"\ddot\eta=\frac{r\ddot\varphi\sin(\varphi-\zeta)+r\dot\varphi^2\cos(\varphi-\zeta)"
            r"+l\dot\zeta^2-c\dot\eta^2\cos(\eta-\zeta)}{c\sin(\eta-\zeta)}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "PROVED"],
    ),
    "a wrong second derivative by two": (
        [
            r"r\cos\varphi+l\cos\zeta=h+c\cos\eta",
            r"r\sin\varphi+l\sin\zeta=c\sin\eta",
            r"\dot\zeta=\frac{r\dot\varphi\sin(\eta-\varphi)}{l\sin(\zeta-\eta)}",
            r"\dot\eta=\frac{r\dot\varphi\sin(\varphi-\zeta)}{c\sin(\eta-\zeta)}",
            r"\ddot\eta=\frac{r\ddot\varphi\sin(\varphi-\zeta)+r\dot\varphi^2\cos(\varphi-\zeta)"
            r"-l\dot\zeta^2-c\dot\eta^2\cos(\eta-\zeta)}{c\sin(\eta-\zeta)}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "REFUTED"],
    ),
    "a value of the derivative of what a constraint gives": (
        [
            r"s^2-2rs\cos\psi+r^2=l^2",
            r"s'=-\frac{rs\sin\psi}{s-r\cos\psi}",
            r"\left.s'\right|_{\psi=0}=0",
        ],
        ["DEFINITION", "PROVED", "PROVED"],
    ),
    "a wrong derivative of what a constraint gives": (
        [
            r"x^2-2rx\cos\varphi+r^2=l^2",
            r"\dot x=-\frac{r\dot\varphi\sin\varphi}{x-r\cos\varphi}",
        ],
        ["not judged", "not judged"],
    ),
    "a law of motion defines what moves": (
        [r"x^2-2rx\cos\varphi+r^2=l^2", r"\dot\varphi=k", r"\ddot\varphi=0"],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "constraints that cannot hold together may be two cases": (
        [r"m+n=1", r"m+n=2"],
        ["DEFINITION", "DEFINITION"],
    ),
    "nothing follows from constraints that cannot hold together": (
        [r"m+n=1", r"m+n=2", r"m=7u", r"m+n=k+1", r"m+n=u^2+\cos k"],
        ["DEFINITION", "DEFINITION", "DEFINITION", "DEFINITION", "DEFINITION"],
    ),
    "nothing follows from a constraint that holds nowhere": (
        [
            r"\mathrm{e}^m+\ln(1+n^2)+\sin k\cos u+1=0",
            r"2\mathrm{e}^m+2\ln(1+n^2)+2\sin k\cos u+2=0",
        ],
        ["DEFINITION", "DEFINITION"],
    ),
    "what is true nowhere is excused by no constraint": (
        [r"m^2+n^2+1=0", r"m=n+k"],
        ["REFUTED", "DEFINITION"],
    ),
    # A later definition of a letter may itself be the wrong equation.
    "what a later definition makes true nowhere is not refuted": (
        [r"\frac1m=\frac1n+\frac1k", r"m=\frac{nk}{n-k}"],
        ["not judged", "not judged"],
    ),
    "nor is what such a definition refutes": (
        [r"\frac1m=\frac1n+\frac1k", "l=2m", r"m=\frac{nk}{n-k}", r"l=\frac{2nk}{n+k}"],
        ["not judged", "DEFINITION", "not judged", "not judged"],
    ),
    "what an earlier definition makes true nowhere is": (
        [r"m=\frac{nk}{n-k}", r"\frac1m=\frac1n+\frac1k"],
        ["DEFINITION", "REFUTED"],
    ),
    "a wrong derivative that is divided by fractions": (
        [
            r"s=h\arctan\frac{k\sin\psi}{1-k\cos\psi}",
            r"s''=-\frac{hk(1-k^2)\sin\psi}{(1-2k\cos\psi+k^2)^3}",
            r"2k\cos^2\alpha+(1+k^2)\cos\alpha-4k=0",
        ],
        ["DEFINITION", "REFUTED", "DEFINITION"],
    ),
    "squares of constraints are added": (
        [r"m\cos\psi=n+k\cos\varphi", r"m\sin\psi=k\sin\varphi", r"m^2=n^2+k^2+2nk\cos\varphi"],
        ["DEFINITION", "DEFINITION", "PROVED"],
    ),
    "squares with a wrong sign are not": (
        [r"m\cos\psi=n+k\cos\varphi", r"m\sin\psi=k\sin\varphi", r"m^2=n^2+k^2-2nk\cos\varphi"],
        ["not judged", "DEFINITION", "not judged"],
    ),
    "two sides with the same letters may be a constraint": (
        [r"\sin(m+n)=m\cos n-n\cos m", r"2\sin(m+n)=2m\cos n-2n\cos m"],
        ["not judged", "not judged"],
    ),
    "a wrong identity that one change makes right is no constraint": (
        [r"\sin(m+n)=\sin m\cos n-\cos m\sin n"],
        ["REFUTED"],
    ),
    "what is said to be a constraint is one, whatever its letters": (
        [r"\sin(m+n)=\sin m\cos n-\cos m\sin n", r"2\sin(m+n)=2\sin m\cos n-2\cos m\sin n"],
        ["DEFINITION", "PROVED"],
    ),
    "what a constraint contradicts is not acquitted by it": (
        [r"m^2=n+1", r"k=m^2n=m^2n+n-m^2+2"],
        ["DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "what holds by a constraint is not accused": (
        [
            r"r\sin\alpha=l\sin\beta",
            r"u=k^2r\sin\alpha=k^2l\sin\beta",
            r"u=r\cos\alpha+k=r\cos\alpha-k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "REFUTED"],
    ),
    "what a constraint may turn into the smallest value is not accused": (
        [r"\min_\psi(a\cos\psi+c)=c-\sqrt{bc}", r"bc=a^2", r"bk=hm"],
        ["not judged", "DEFINITION", "DEFINITION"],
    ),
    "a constraint that a letter of its own makes true excuses nothing": (
        [
            r"k=\sin2\alpha",
            r"k=\sin\alpha\cos\alpha",
            r"\tan\beta=\frac{\tan\alpha}{1+\cos^2\alpha}",
        ],
        ["DEFINITION", "REFUTED", "DEFINITION"],
    ),
    "nor one that gives a letter whose derivative is printed": (
        [r"\tan\varphi=\frac{km}{1+k}", r"\dot\varphi=n", r"m=k^2", r"m=2k^2"],
        ["DEFINITION", "DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "a constraint may restrict other letters, too": (
        [r"k=m", r"k=|m|", r"\tan\beta=\sqrt m"],
        ["DEFINITION", "not judged", "DEFINITION"],
    ),
    "what holds for positive letters or acute angles is not accused": (
        [
            r"u=m\sin\alpha=\sqrt{m^2-m^2\cos^2\alpha}",
            r"k=m\sin\alpha=\sqrt{m^2+m^2\cos^2\alpha}",
        ],
        ["DEFINITION", "not judged", "DEFINITION", "REFUTED"],
    ),
    "a letter on which a side does not depend is none of its letters": (
        [
            r"k=m\cos\alpha",
            r"n=m\sin\alpha",
            r"k^2+n^2=m^2",
            r"k^2+n^2=2m^2",
            r"k^2+n^2=m^2\cos\beta",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "not judged", "DEFINITION"],
    ),
    "a step may follow from another member of a chain": (
        [r"k=\frac mn=\cos\alpha", r"u=1-k^2=\sin^2\alpha", r"h=ak^2=a\sin^2\alpha"],
        ["DEFINITION", "not judged", "DEFINITION", "PROVED", "DEFINITION", "not judged"],
    ),
    "roots of products of positive letters": (
        [
            r"u=\sqrt{\frac km}",
            r"n=\frac h{2\sqrt{km}}",
            r"m\ddot x+h\dot x+kx=0",
            r"\ddot x+2un\dot x+u^2x=0",
            r"\ddot x+un\dot x+u^2x=0",
        ],
        [*["DEFINITION"] * 3, "PROVED", "REFUTED"],
    ),
    "tangents of one angle": (
        [
            r"\tan\psi=\frac{\tan\alpha}k",
            r"\tan\psi=\frac{\tan\beta}m",
            r"\tan\beta=\frac mk\tan\alpha",
            r"\tan\beta=\frac km\tan\alpha",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "powers of e": (
        [
            r"\frac{h-b}{c-b}=\mathrm{e}^k",
            r"h-c=(h-b)\frac{\mathrm{e}^k-1}{\mathrm{e}^k}",
            r"(h-b)\mathrm{e}^k=(c-b)\mathrm{e}^{2k}",
        ],
        ["DEFINITION", "PROVED", "PROVED"],
    ),
    "powers of e that do not follow": (
        [r"\frac{h-b}{c-b}=\mathrm{e}^k", r"h-c=(h-b)\frac{\mathrm{e}^k+1}{\mathrm{e}^k}"],
        ["not judged", "not judged"],
    ),
    "a trace": (
        [
            r"R=\begin{pmatrix}\cos\alpha&-\sin\alpha\\\sin\alpha&\cos\alpha\end{pmatrix}",
            r"k=\operatorname{tr}R=2\cos\alpha",
            r"\operatorname{tr}(R^2)=2\cos2\alpha",
            r"k=\mathrm{tr}(R)=2\sin\alpha",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "PROVED", "PROVED", "REFUTED"],
    ),
    "what is said to follow is compared with nothing else": (
        [
            r"r\sin\psi=l\sin\beta",
            r"s=r\cos\psi+l\cos\beta=r\cos\psi+\sqrt{l^2-r^2\sin^2\psi}",
            r"s'=-\frac{r\sin(\psi+\beta)}{\cos\beta}",
        ],
        ["DEFINITION", "DEFINITION", "not judged", "not judged"],
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize(("factor", "outcome"), [("", "PROVED"), ("2", "REFUTED")])
def test_what_is_said_to_be_an_identity_may_follow(factor: str, outcome: str) -> None:
    letters = "%% r ; l : lengths {r>0}\n%% x(t) : position\n%% \\varphi(t) ; \\beta(t) : angles\n"
    said = "%% where -\\pi/2<\\beta<\\pi/2\n%% where l>r\n%% identity (3)\n"
    printed = (
        r"x=r\cos\varphi+l\cos\beta",
        r"l\sin\beta=r\sin\varphi",
        rf"\dot x=-{factor}r\dot\varphi\frac{{\sin(\varphi+\beta)}}{{\cos\beta}}",
    )
    equations = "".join(rf"\begin{{equation}}{one}\end{{equation}}" for one in printed)
    rows = check("p.tex", f"%% mechproof\n{letters}{said}%% end\n{equations}").rows
    assert rows[-1].outcome == outcome


SLIDER = (r"r\cos\varphi+l\cos\alpha=x", r"r\sin\varphi=l\sin\alpha")
FOLLOWING = {
    r"x^2-2rx\cos\varphi+r^2=l^2": "PROVED",
    r"x^2-2rx\sin\varphi+r^2=l^2": "REFUTED",
    r"l^2=r^2+x^2+2rx\cos\varphi": "REFUTED",
    r"r\dot\varphi\cos\varphi=l\dot\alpha\cos\alpha": "PROVED",
    r"r\dot\varphi\cos\varphi=l\dot\alpha\sin\alpha": "DEFINITION",
    r"\dot x\cos\alpha+r\dot\varphi\sin(\varphi+\alpha)=0": "PROVED",
    r"\dot x\cos\alpha+r\dot\varphi\sin(\varphi-\alpha)=0": "REFUTED",
    r"\ddot x+r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi"
    r"+l\ddot\alpha\sin\alpha+l\dot\alpha^2\cos\alpha=0": "PROVED",
    r"\ddot x+r\ddot\varphi\sin\varphi+r\dot\varphi^2\cos\varphi"
    r"+l\ddot\alpha\sin\alpha-l\dot\alpha^2\cos\alpha=0": "DEFINITION",
    r"\ddot\alpha=\frac{r\ddot\varphi\cos\varphi-r\dot\varphi^2\sin\varphi"
    r"+l\dot\alpha^2\sin\alpha}{l\cos\alpha}": "PROVED",
    r"\ddot x=0": "not judged",
    # An equation that gives an acceleration is not meant for the case where it is zero.
    r"\ddot\alpha=\frac{r\ddot\varphi\cos\varphi+r\dot\varphi^2\sin\varphi"
    r"+l\dot\alpha^2\sin\alpha}{l\cos\alpha}": "REFUTED",
    r"m(x-r\cos\varphi-l\cos\alpha)+n(r\sin\varphi-l\sin\alpha)=0": "PROVED",
    r"m(x-r\cos\varphi-l\cos\alpha)+n(r\sin\varphi+l\sin\alpha)=0": "not judged",
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", FOLLOWING)
def test_equations_follow_from_constraints_together(latex: str) -> None:
    letters = "%% r ; l : lengths\n%% x(t) : position\n%% \\varphi(t) ; \\alpha(t) : angles\n"
    block = f"%% mechproof\n{letters}%% m ; n : numbers\n%% factor m, n\n%% end\n"
    equations = "".join(f"$${one}$$\n" for one in (*SLIDER, latex))
    rows = check("paper.tex", block + equations).rows
    assert rows[-1].outcome == FOLLOWING[latex], rows[-1].reason


@pytest.mark.parametrize(
    ("latex", "told"),
    [
        (r"r\cos\varphi=l\cos\alpha", "display 2"),
        (r"r\cos\psi=l\cos\alpha", ""),
    ],
)
def test_a_constraint_says_which_others_have_its_letters(latex: str, told: str) -> None:
    row = check("paper.tex", "".join(f"$${one}$$\n" for one in (*SLIDER, latex))).rows[-1]
    assert row.outcome == "DEFINITION"
    assert row.reason.partition("; it was not shown to follow from ")[2] == told


# Additional lines of the block of a case.
SAID = {
    "roots of products of positive letters": "%% where k>0\n%% where m>0\n",
    "the derivative of an angle whose tangent is printed": "%% \\eta(t) : angle [rad]\n",
    "a derivative by two constraints": "%% \\eta(t) ; \\zeta(t) : angles [rad]\n",
    "a second derivative by two": "%% \\eta(t) ; \\zeta(t) : angles [rad]\n",
    "a wrong second derivative by two": "%% \\eta(t) ; \\zeta(t) : angles [rad]\n",
    "a wrong derivative that is divided by fractions": "%% factor k\n%% where 0<k<1\n",
    "what is said to follow is compared with nothing else": "%% follows (3): (1)\n",
    "what is said to be a constraint is one, whatever its letters": "%% constraint (1)\n",
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_rows_beside_constraints_have_their_outcome(case: str) -> None:
    equations, expected = CASES[case]
    assert outcomes(*equations, block=SAID.get(case, "")) == expected


# A slotted lever: equations shown to follow are not premises again for later ones.
LEVER = r"""%% mechproof
%% r ; c : lengths [mm] {r>0}
%% s(t) : position [mm]
%% \theta(t) ; \phi(t) : angles [rad]
%% \omega : angular speed [rad/s]
%% let \dot\theta=\omega
%% where c>r
%% end
$$s\cos\phi=c+r\cos\theta$$ $$s\sin\phi=r\sin\theta$$
$$\tan\phi=\frac{r\sin\theta}{c+r\cos\theta}$$
$$\dot s\cos\phi-s\dot\phi\sin\phi=-r\omega\sin\theta$$
$$\dot s\sin\phi+s\dot\phi\cos\phi=r\omega\cos\theta$$
"""


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "expected"), [("-", "PROVED"), ("+", "REFUTED")])
def test_what_follows_is_no_premise_again(sign: str, expected: str) -> None:
    row = check("paper.tex", rf"{LEVER}$$\dot s=-r\omega\sin(\theta{sign}\phi)$$").rows[-1]
    assert row.outcome == expected, row.reason


# A rod and a crank, which turns at a speed given by the block.
TURNING = r"""%% mechproof
%% r ; l : lengths [mm] {r>0}
%% \varphi(t) ; \beta(t) : angles [rad] {-\pi/2<\beta<\pi/2}
%% \omega : angular speed [rad/s]
%% n : speed of rotation [rpm]
%% let \dot\varphi=\omega
%% where l>r
%% end
$$r\sin\varphi=l\sin\beta$$
"""


@pytest.mark.parametrize(
    ("rate", "behind", "expected"),
    [
        (r"\omega\cos\varphi", "", "PROVED"),
        (r"\omega\sin\varphi", "", "REFUTED"),
        (r"\omega\cos\varphi", r"$$\omega=\frac{2\pi n}{60}$$", "PROVED"),
        # Given by n, which appears nowhere else, the speed may have any value.
        (r"\omega\sin\varphi", r"$$\omega=\frac{2\pi n}{60}$$", "REFUTED"),
    ],
)
def test_a_speed_that_the_block_gives_is_that_of_a_loop(
    rate: str, behind: str, expected: str
) -> None:
    rows = check(
        "paper.tex", rf"{TURNING}$$\dot\beta=\frac{{r{rate}}}{{l\cos\beta}}$$ {behind}"
    ).rows
    assert rows[1].outcome == expected
