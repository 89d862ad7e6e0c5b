"""Papers of a few lines: what each equation does and what becomes of it, with wrong neighbours."""

from __future__ import annotations

import pytest

from mechproof.document.checking import CheckedPaper, check
from mechproof.document.roles import Role

pytestmark = pytest.mark.usefixtures("judged_here")

LETTERS = r"""%% mechproof
%% r ; l : crank and rod [mm] {r>0}
%% \lambda : their ratio [1]
%% x(t) : position [mm]
%% \varphi(t) : angle of the crank [rad]
%% s(\psi) : lift [mm]
%% \psi : angle of the cam [rad]
%% a ; b ; c ; h : lengths of the links [mm] {a>0}
%% \alpha ; \beta ; \gamma : angles [rad]
%% k ; m ; n ; u : numbers
%% \sigma : branch
%% R 2x2 : rotation
%% Q(\alpha) 2x2 : shear
%% factor a, \dot\varphi
%% branch \sigma=\pm1
"""


def paper(*equations: str, block: str = "") -> str:
    lines = "".join(f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations)
    return f"{LETTERS}{block}%% end\n{lines}"


def outcomes(*equations: str, block: str = "") -> list[str]:
    return [row.outcome for row in run(*equations, block=block).rows]


def run(*equations: str, block: str = "") -> CheckedPaper:
    return check("paper.tex", paper(*equations, block=block))


ROD = r"x=r\cos\varphi"
LOOP = r"a\cos\alpha+b\cos\beta=c\cos\gamma+h"
CASES = {
    "first prints define, later ones are compared": (
        [
            r"\lambda=\frac rl",
            r"\lambda=\frac{r\sin^2\alpha+r\cos^2\alpha}{l}",
            r"\lambda=\frac lr",
        ],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "definitions are put in": (
        [r"\lambda=\frac rl", r"\lambda l\sin\alpha=r\sin\alpha"],
        ["DEFINITION", "PROVED"],
    ),
    "steps of chains are compared": (
        [r"k=\cos 2\alpha=1-2\sin^2\alpha=2\cos^2\alpha+1"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "dots are derivatives": (
        [ROD, r"\dot x=-r\dot\varphi\sin\varphi", r"\dot x=r\dot\varphi\sin\varphi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a derivative through letters that are given by others": (
        [
            r"\gamma=\varphi+\alpha",
            r"x=r\sin\gamma",
            r"\dot x=r\dot\varphi\cos(\varphi+\alpha)",
            r"\dot x=0",
            r"\dot x=r\dot\varphi\sin\gamma",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "not judged", "REFUTED"],
    ),
    "two dots": (
        [ROD, r"\ddot x=-r\ddot\varphi\sin\varphi-r\dot\varphi^2\cos\varphi"],
        ["DEFINITION", "PROVED"],
    ),
    "d by dt": (
        [ROD, r"\frac{dx}{dt}=-r\frac{d\varphi}{dt}\sin\varphi"],
        ["DEFINITION", "PROVED"],
    ),
    "primes": (
        [r"s=a\cos\psi+b\psi", r"s'=b-a\sin\psi", r"s''=a\cos\psi"],
        ["DEFINITION", "PROVED", "REFUTED"],
    ),
    "a derivative by the time of what is printed of a letter": (
        [
            r"k=\frac12r^2\dot\varphi^2-rl\cos\varphi",
            r"\frac{d}{dt}\frac{\partial k}{\partial\dot\varphi}=r^2\ddot\varphi",
            r"\frac{d}{dt}\frac{\partial k}{\partial\dot\varphi}=2r^2\ddot\varphi",
            r"\frac{\partial k}{\partial\varphi}=rl\sin\varphi",
            r"\frac{\partial k}{\partial\varphi}=-rl\sin\varphi",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "PROVED", "REFUTED"],
    ),
    "the third derivative has no symbol": (
        [r"k=\ddot\varphi", r"\frac{dk}{dt}=m"],
        ["DEFINITION", "not read"],
    ),
    "a derivative defines what is bare": (
        [r"k=m^2n", r"u=\frac{\partial k}{\partial m}", r"u=2mn", r"u=mn"],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "a matrix": (
        [
            r"R=\begin{pmatrix}\cos\alpha&-\sin\alpha\\\sin\alpha&\cos\alpha\end{pmatrix}",
            r"RR^T=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
        ],
        ["DEFINITION", "PROVED"],
    ),
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
        ["DEFINITION", "DEFINITION", "PROVED", "DEFINITION"],
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
    "letters of which only some have units": (
        [r"x=rk", r"rk\cos\alpha=x\cos\alpha", r"m=\frac{x}{l}", r"\frac{x}{n}=\frac{rk}{n}"],
        ["DEFINITION", "PROVED", "DEFINITION", "PROVED"],
    ),
    "nothing excuses another extremum": (
        [r"\min_\psi(a\cos\psi+c)=a+c", r"kn=m^2"],
        ["REFUTED", "DEFINITION"],
    ),
    "special positions define nothing": (
        [r"k=m\cos\alpha+n\cos\beta", r"k=n\cos\alpha+m\cos\beta", r"m=n"],
        ["DEFINITION", "not judged", "DEFINITION"],
    ),
    "units tell what a bracket multiplies": (
        [
            r"x=r(1-\cos\alpha)",
            r"x=r-r\cos\alpha",
            r"x=r(1+\cos\alpha)",
            r"x=\lambda(l+b)",
            r"x=r(\alpha+\beta)",
            r"x=r(\alpha)",
            r"x=k(l+b)",
            r"s=x(1+\cos\psi)",
            r"x=r(1-\lambda)",
        ],
        [
            *["DEFINITION", "PROVED", "REFUTED", "not judged"],
            *["not read", "not read", "not read", "not read", "not read"],
        ],
    ),
    "later prints are compared with each member of a chain": (
        [r"k=mu=n\cos\alpha", r"k=n\frac{\cos^2\alpha}{\cos\alpha}", r"k=n\sin\alpha", r"k=2mu"],
        ["DEFINITION", "not judged", "PROVED", "not judged", "REFUTED"],
    ),
    "derivatives are compared with that of each member": (
        [
            r"x=lk=r\cos\varphi",
            r"\dot x=-r\dot\varphi\sin\varphi",
            r"\dot x=r\dot\varphi\sin\varphi",
        ],
        ["DEFINITION", "not judged", "PROVED", "not judged"],
    ),
    "a member that differs from the others does not stand": (
        [r"k=\cos2\alpha=1-2\sin^2\alpha=2\cos^2\alpha+1", r"k=2\cos^2\alpha+1"],
        ["DEFINITION", "PROVED", "REFUTED", "REFUTED"],
    ),
    "of two members that differ either may be right": (
        [
            r"x=r\cos\varphi=r\sin\varphi",
            r"\dot x=-r\dot\varphi\sin\varphi",
            r"\ddot x=r\ddot\varphi\cos\varphi-r\dot\varphi^2\sin\varphi",
            r"x=r\tan\varphi",
        ],
        ["DEFINITION", "REFUTED", "PROVED", "PROVED", "not judged"],
    ),
    "derivatives by pieces are compared beside the seams": (
        [
            r"s=\begin{cases}a\psi^2&\psi\le1\\a(2\psi-1)&\psi>1\end{cases}",
            r"s'=\begin{cases}2a\psi&\psi<1\\2a&\psi>1\end{cases}",
            r"s''=\begin{cases}0&\psi\ge1\\2a&\psi<1\end{cases}",
            r"s''=\begin{cases}2a&\psi<1\\0&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<2\\0&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<1\\a&\psi>1\end{cases}",
        ],
        ["DEFINITION", "PROVED", "PROVED", "PROVED", "REFUTED", "REFUTED"],
    ),
    "seams with letters": (
        [
            r"s=\begin{cases}a\psi^2&\psi\le k\\2ak\psi-ak^2&\psi\ge k\end{cases}",
            r"s'=\begin{cases}2a\psi&\psi<k\\2ak&\text{otherwise}\end{cases}",
            r"s''=\begin{cases}2a&\psi<k\\0&\psi>k\end{cases}",
            r"s''=\begin{cases}2a&\psi<k\\2&\psi>k\end{cases}",
            r"s'(k)=2ak",
            r"s'(k)=ak",
            r"s''(k)=0",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "PROVED", "REFUTED", "not read"],
    ),
    "derivatives are compared where their pieces join": (
        [
            r"s=\begin{cases}a\psi^2&0\le\psi\le k\\2ak\psi-ak^2&k\le\psi\le u\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi<k\\2ak&\text{otherwise}\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi\le k\\2ak&k<\psi\le u\end{cases}",
            r"s'=\begin{cases}2a\psi&0\le\psi<k\\2a\psi&k\le\psi\le u\end{cases}",
            r"s''=\begin{cases}2a&0\le\psi\le k\\0&\text{otherwise}\end{cases}",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "PROVED"],
    ),
    "values of a law by pieces": (
        [
            r"s=\begin{cases}a\psi^2&0\le\psi\le k\\2ak\psi-ak^2&k<\psi\le u\end{cases}",
            r"s(0)=0",
            r"s(u)=2aku-ak^2",
            r"s(u)=2aku-2ak^2",
        ],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED"],
    ),
    "a law that jumps has no derivative there": (
        [
            r"s=\begin{cases}a\psi&\psi\le1\\a\psi+h&\psi>1\end{cases}",
            r"s'=a",
            r"s'(1)=a",
            r"s'(2)=a",
        ],
        ["DEFINITION", "PROVED", "not read", "DEFINITION"],
    ),
    "a law in displays of its own, and where its pieces meet": (
        [
            r"s=a\psi^2,\quad 0\le\psi\le k",
            r"s(\psi)=2ak\psi-ak^2\quad\text{for }k<\psi\le u",
            r"s=2aku-ak^2,\quad\psi>u",
            r"s'=2a\psi,\quad 0\le\psi\le k",
            r"s'=2ak,\quad k<\psi\le u",
            r"s''=2a,\quad 0\le\psi<k",
            r"s''=a,\quad 0\le\psi<k",
            r"s(0)=0",
            r"s=a\sin^2\psi,\quad 0\le\psi\le k",
        ],
        [*["DEFINITION"] * 3, *["PROVED"] * 3, "REFUTED", "PROVED", "REFUTED", *["PROVED"] * 3],
    ),
    "a piece that does not begin where the one before it ends, beside its velocity": (
        [
            r"s=a\psi^2,\quad 0\le\psi\le k",
            r"s=2ak\psi+ak^2,\quad k<\psi\le u",
            r"s'=2a\psi,\quad 0\le\psi\le k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "two values at one place": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=ak^2+h,\quad k\le\psi\le u"],
        ["DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "a law may jump": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=ak^2+h,\quad k<\psi\le u"],
        ["DEFINITION", "DEFINITION", "not judged"],
    ),
    "a velocity may jump": (
        [
            r"s'=2a\psi,\quad 0\le\psi\le k",
            r"s'=0,\quad k\le\psi\le u",
            r"s''=2a,\quad 0<\psi<k",
            r"s''=a,\quad 0<\psi<k",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "not judged"],
    ),
    "ranges that overlap are no pieces of one law": (
        [r"s=a\psi^2,\quad 0\le\psi\le k", r"s=2a\psi,\quad 0\le\psi\le m"],
        ["DEFINITION", "DEFINITION"],
    ),
    "pieces whose other letters are matrices": (
        [
            r"s=a\psi,\quad\psi\le k",
            r"s=ak,\quad\psi>k",
            r"RR^T=R^TR",
            r"s'=a,\quad\psi<k",
        ],
        ["DEFINITION", "DEFINITION", "not judged", "PROVED", "PROVED"],
    ),
    "two letters that are zero define nothing": (
        [r"\dot x=\dot\varphi=0", ROD, r"\dot x=-r\dot\varphi\sin\varphi"],
        ["DEFINITION", "DEFINITION", "DEFINITION", "PROVED"],
    ),
    "constant speed has no acceleration": (
        [r"\dot\varphi=k", ROD, r"\ddot x=-rk^2\cos\varphi", r"\ddot x=-2rk^2\cos\varphi"],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "pieces of a law are no contradiction": (
        [r"k=m,\quad m>0", r"k=-m,\quad m<0"],
        ["DEFINITION", "DEFINITION"],
    ),
    "a number within a chain": (
        [r"k=12=3\cdot4", r"m=25=3\cdot4", r"n=2.5=3.5"],
        ["DEFINITION", "PROVED", "DEFINITION", "REFUTED", "DEFINITION", "REFUTED"],
    ),
    "rounded coefficients accuse nobody": (
        [r"k=\frac{\pi n}{30}=0.105n", r"\sqrt2m=1.414m"],
        ["DEFINITION", "not judged", "not judged"],
    ),
    "nowhere true": ([r"m^2+1=0"], ["REFUTED"]),
    "somewhere true": ([r"m^2-1=0"], ["DEFINITION"]),
    "other letters make no accusation": (
        [r"k=mn=\frac{2mu}{3}", r"k=mu"],
        ["DEFINITION", "not judged", "not judged"],
    ),
    "an identity may be claimed": (
        [r"\sin\alpha\cos\alpha=\sin2\alpha"],
        ["REFUTED"],
    ),
    "a circle of definitions is compared": (
        [ROD, r"r=\frac{x}{\cos\varphi}"],
        ["DEFINITION", "PROVED"],
    ),
    "an inverse with a branch is not accused": (
        [r"k=\cos\alpha", r"\alpha=\arccos k"],
        ["DEFINITION", "DEFINITION"],
    ),
    "conditions": ([r"l>r", r"k^2\ge0", r"k^2<0"], ["DEFINITION", "PROVED", "REFUTED"]),
    "a double sign on one side is the branch": (
        [r"m=k\pm\sqrt{k^2+n^2}", r"m^2-2mk=n^2", r"m^2-2mk=2n^2"],
        ["DEFINITION", "PROVED", "DEFINITION"],
    ),
    "a bracket behind a matrix is its name": (
        [r"Q(\alpha)=\begin{pmatrix}1&\alpha\\0&1\end{pmatrix}", r"\det Q(\alpha)=1"],
        ["DEFINITION", "PROVED"],
    ),
    "a branch": ([r"\sigma^2=1", r"\sigma=1"], ["PROVED", "DEFINITION"]),
    "dimensions": ([r"x=r+\lambda", r"k=\frac{r}{l}+m"], ["ILL_FORMED", "DEFINITION"]),
    "sizes are no definitions": ([r"r=66", r"\lambda=\frac rl"], ["DEFINITION", "DEFINITION"]),
    "rounded numbers need sizes": (
        [r"\lambda=\frac rl=0.33"],
        ["DEFINITION", "not judged"],
    ),
    "an undeclared letter": ([r"q=2r"], ["not read"]),
    "a derivative that is not declared": ([r"\frac{dk}{dm}=0"], ["not read"]),
    "an expression": ([r"a+b"], ["not judged"]),
}
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
    r"m(x-r\cos\varphi-l\cos\alpha)+n(r\sin\varphi-l\sin\alpha)=0": "PROVED",
    r"m(x-r\cos\varphi-l\cos\alpha)+n(r\sin\varphi+l\sin\alpha)=0": "DEFINITION",
}


@pytest.mark.parametrize("latex", FOLLOWING)
def test_equations_follow_from_constraints_together(latex: str) -> None:
    letters = "%% r ; l : lengths\n%% x(t) : position\n%% \\varphi(t) ; \\alpha(t) : angles\n"
    block = f"%% mechproof\n{letters}%% m ; n : numbers\n%% factor m, n\n%% end\n"
    equations = "".join(f"$${one}$$\n" for one in (*SLIDER, latex))
    rows = check("paper.tex", block + equations).rows
    assert rows[-1].outcome == FOLLOWING[latex], rows[-1].reason


# What a block says besides.
SAID = {
    "an identity may be claimed": "%% identity (1)\n",
    "a law in displays of its own, and where its pieces meet": "%% where 0<k<u\n",
    "what is said to follow is compared with nothing else": "%% follows (3): (1)\n",
    "values of a law by pieces": "%% where 0<k<u\n",
    "what is said to be a constraint is one, whatever its letters": "%% constraint (1)\n",
}


@pytest.mark.parametrize("case", CASES)
def test_every_row_has_its_outcome(case: str) -> None:
    equations, expected = CASES[case]
    assert outcomes(*equations, block=SAID.get(case, "")) == expected


def test_a_double_sign_without_a_branch_defines_nothing() -> None:
    block = "%% mechproof\n%% k ; m ; n : numbers\n%% end\n"
    found = check("paper.tex", block + r"$$k=m\pm n$$ $$k=m-n$$")
    assert [row.outcome for row in found.rows] == ["not read", "DEFINITION"]


def test_values_may_be_said_that_the_paper_says_in_words() -> None:
    block = "%% let m=\\cos\\alpha, n=\\sin\\alpha\n"
    assert outcomes("m^2+n^2=1", "m^2-n^2=1", block=block) == ["PROVED", "DEFINITION"]
    assert outcomes(r"m=\cos\alpha", r"m=\sin\alpha", block=block) == ["DEFINITION", "REFUTED"]


def test_angles_may_be_said_modulo_turns() -> None:
    equal = r"\alpha=\alpha+2\pi"
    wrong = r"\alpha=\alpha+\pi"
    said = "%% modulo 2\\pi (1), (2)\n"
    assert outcomes(equal, wrong, block=said) == ["PROVED", "REFUTED"]
    assert outcomes(equal) == ["REFUTED"]


def test_numbers_are_compared_at_the_sizes() -> None:
    sizes = "%% sizes r=20 mm, l=60\\,mm\n"
    found = outcomes(r"\lambda=\frac rl=0.333", r"\lambda=\frac rl=0.34", block=sizes)
    assert found == ["DEFINITION", "PROVED", "DEFINITION", "REFUTED"]
    assert outcomes(r"\lambda=\frac rl", r"\lambda=0.34", block=sizes)[1] == "not judged"
    assert outcomes(r"\lambda=\frac rl", r"\lambda=0", block=sizes)[1] == "not judged"


def test_numbers_are_compared_in_the_units_of_their_letters() -> None:
    block = "%% w : speed [m/s]\n%% \\omega : speed [rpm]\n%% \\delta : angle [deg]\n"
    sizes = "%% sizes r=20 mm, \\omega=30\\,rpm, \\delta=30\n"
    right = outcomes(r"w=r\omega=0.0628", r"x=r\sin\delta=10.0", block=block + sizes)
    assert right == ["DEFINITION", "PROVED", "DEFINITION", "PROVED"]
    wrong = outcomes(r"w=r\omega=0.0728", r"x=r\sin\delta=11.0", block=block + sizes)
    assert wrong == ["DEFINITION", "REFUTED", "DEFINITION", "REFUTED"]
    numbers = outcomes(r"\omega=\frac{30k}{\pi}=95.5", block=block + "%% sizes k=10\n")
    assert numbers == ["DEFINITION", "PROVED"]
    turns = "%% n_0 : turns [min^-1]\n%% sizes n_0=300\n"
    for number, outcome in (("31.42", "PROVED"), ("3.142", "REFUTED"), ("30.42", "REFUTED")):
        printed = rf"w=\frac{{2\pi n_0}}{{60}}={number}\,\mathrm{{s}}^{{-1}}"
        assert outcomes(printed, block="%% w : speed\n" + turns)[1] == outcome


UNITS = {
    r"\lambda=\frac rl\approx0.333": ["DEFINITION", "PROVED"],
    r"\lambda=\frac rl\approx0.343": ["DEFINITION", "REFUTED"],
    r"x=r\cos\alpha=17.6\,\mathrm{mm}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=\SI{1.76}{\centi\metre}": ["DEFINITION", "PROVED"],
    r"x=r\cos\alpha=\qty{1.76}{mm}": ["DEFINITION", "REFUTED"],
    r"\beta=\arcsin\frac rl=19.5^\circ": ["DEFINITION", "PROVED"],
    r"\beta=\arcsin\frac rl=-19.5^\circ": ["DEFINITION", "REFUTED"],
    r"r=20\,\text{mm},\quad l=\num{60}~\mathrm{mm}": ["DEFINITION", "DEFINITION"],
    r"r>10\,\mathrm{mm}": ["not read"],
    r"x=3\,\mathrm{mm}\cos\alpha": ["not read"],
    r"x=r\cos\alpha=17.6\,\mathrm{apples}": ["not read"],
    r"\cos30^\circ\approx0.866": ["PROVED"],
    r"x\approx r": ["not judged"],
    r"k\approx3.52": ["DEFINITION"],
    r"l\approx0.06\,\mathrm m": ["DEFINITION"],
}


@pytest.mark.parametrize("latex", UNITS)
def test_numbers_may_have_units(latex: str) -> None:
    block = "%% sizes r=20 mm, l=60 mm, \\alpha=0.5\n"
    assert outcomes(latex, block=block) == UNITS[latex]


def test_a_letter_with_a_size_and_a_formula_may_be_either() -> None:
    block = "%% sizes r=20 mm, l=60 mm, \\beta=0.5\n"
    numbers = [r"h=r\cos\beta=17.55", r"h=r\cos\beta=18.86", r"h=r\cos\beta=18.0"]
    found = outcomes(r"\beta=\arcsin\frac rl", *numbers, block=block)
    assert found[2::2] == ["PROVED", "PROVED", "REFUTED"]


def test_equations_are_skipped_or_constrained_by_name_or_label() -> None:
    block = "%% skip (1): a print of the scan\n%% constraint eq:b\n"
    rows = run(r"k=m", r"\label{eq:b}k=m=\cos k", block=block).rows
    assert [row.outcome for row in rows] == ["skipped", "DEFINITION", "DEFINITION"]
    assert rows[0].reason == "a print of the scan"


def test_rows_say_what_they_do_and_where_they_stand() -> None:
    rows = run(ROD, r"\dot x=-r\dot\varphi\sin\varphi").rows
    assert [row.role for row in rows] == [Role.DEFINITION, Role.DERIVATIVE]
    assert [row.place.line for row in rows] == [17, 18]


# An equation, what stands behind it, and whether it tells that nothing else uses its letter.
LONELY = {
    (r"u=m\cos\alpha", ""): True,
    (r"u=m\cos\alpha", "$$k=2u$$"): False,
    (r"\dot x=r\dot\varphi", "$$x=r$$"): False,
    # Nobody knows what stands there.
    (r"u=m\cos\alpha", "$$k=2q_u$$"): False,
    (r"u=m\cos\alpha", "$$k=\\mu$$"): True,
    (r"u=m\cos\alpha", r"\begin{tabular}{ll}$m$ & $u$\\1 & 2\end{tabular}"): False,
    (r"u=3", ""): True,
}


@pytest.mark.parametrize(("latex", "more"), LONELY)
def test_a_letter_that_nothing_else_uses_is_told(latex: str, more: str) -> None:
    row = check("paper.tex", paper(latex) + more).rows[0]
    assert row.outcome == "DEFINITION"
    assert row.reason.endswith(" uses u.") == LONELY[latex, more]


def test_an_accusation_names_what_it_is_compared_with() -> None:
    rows = run(r"\lambda=\frac rl", r"\lambda=\frac lr").rows
    assert rows[1].reason.endswith("compared with (1)")


def test_without_a_block_letters_are_real_numbers_and_told() -> None:
    found = check("paper.tex", r"$$k=\frac{a}{b}$$ $$k^2=\frac{a^2}{b^2}$$ $$f(x)=x$$")
    assert found.taken == ("k", "a", "b", "f", "x")
    assert [row.outcome for row in found.rows] == ["DEFINITION", "PROVED", "not read"]


def test_a_wrong_line_of_many_ends_nothing() -> None:
    found = outcomes(r"k=\frac{m}{", r"m=\begin{foo}", r"\lambda=\frac rl", r"u=\unknown{2}")
    assert found == ["not read", "not read", "DEFINITION", "not read"]
