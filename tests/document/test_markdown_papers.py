"""Prints typical of notes in Markdown, each with one that is wrong or means something else."""

from __future__ import annotations

import pytest

from mechproof.document.checking import CheckedPaper, check
from mechproof.document.drafts.draft import draft_block
from mechproof.sources.paper_files import read_source

pytestmark = pytest.mark.usefixtures("judged_here")


def run(text: str, block: str = "") -> CheckedPaper:
    head = f"<!-- mechproof\n{block}\n-->\n" if block else ""
    return check("notes.md", head + text)


def outcomes(text: str, block: str = "") -> list[str]:
    return [row.outcome for row in run(text, block).rows]


D, P, R = "DEFINITION", "PROVED", "REFUTED"
OPEN, UNREAD = "not judged", "not read"
MATRICES = r"""A ; B ; C ; I 2x2 : matrices
v ; w 3x1 : vectors
x ; y ; L : numbers
let I=\begin{pmatrix}1&0\\0&1\end{pmatrix}"""
ANGLES = r"""q ; t ; u : angle [rad]
k ; m : counts
x ; y ; a ; b : lengths [mm]
integer k, m
function \tan^{-1} is \arctan"""
PAPERS = {
    "several solutions in one display": (
        r"$$\begin{align}q&=t-\arcsin r\\ q&=t+\pi+\arcsin r\end{align}$$ $$q=t-2\arcsin r$$",
        "",
        [D, OPEN, R],
    ),
    "a word that tells of another solution": (
        "$$u=\\arccos v$$ or\n$$u=-\\arccos v$$ so that $$u=-\\arccos v$$ $$u=-2\\arccos v$$",
        "",
        [D, OPEN, P, R],
    ),
    "a second root of an equation, and what follows with it": (
        "$$u^2-2vu+w=0$$\n$$u=v+\\sqrt{v^2-w}$$\n$$u=v-\\sqrt{v^2-w}$$\n$$k=2u$$\n"
        "$$k=2v-2\\sqrt{v^2-w}$$\n$$k=2v+\\sqrt{v^2-w}$$",
        "",
        ["UNDECIDED", D, OPEN, D, P, R],
    ),
    "what is no root": (
        "$$u^2-2vu+w=0$$\n$$u=v+\\sqrt{v^2-w}$$\n$$u=v-\\sqrt{v^2+w}$$",
        "",
        ["UNDECIDED", D, R],
    ),
    "a linear equation has one root": (
        r"$$u-2vu+w=0$$ $$u=\frac{w}{2v-1}$$ $$u=-\frac{w}{2v-1}$$",
        "",
        [P, D, R],
    ),
    "quantities that are called by words": (
        r"$$\text{Mean load}=\frac{\text{Greatest load}+\text{Least load}}{2}$$"
        r"$$2\cdot\text{Mean load}=\text{Least load}+1\cdot\text{Greatest load}$$"
        r"$$\text{Mean load}=\frac{\text{Greatest load}-\text{Least load}}{2}$$"
        r"$$\text{Hence we get }c=2b$$ $$h=\text{constant over time}$$ $$k=v+\text{small terms}$$",
        "",
        [D, P, R, UNREAD, UNREAD, UNREAD],
    ),
    "a zero in braces is no number of an equation": (
        r"$$\{u\}-2\{v\}=\{0\}$$ $$\{u\}=2\{v\}$$ $$\{w\}=3\{v\}$$ $$\{w\}=4\{v\}$$ $$x=(0)$$",
        "",
        [P, D, D, R, UNREAD],
    ),
    "several solutions in one line": (r"$$u=2v\ \mbox{ or }\ u=-2v$$ $$u=-2v$$", "", [D, OPEN, P]),
    "what is said to be an identity is no other solution": (
        r"$$\begin{align}u&=2v\\u&=3v\end{align}$$",
        "u : angle\nv : angle\nidentity display 2",
        [D, R],
    ),
    "systems of equations": (
        r"$$u=1-v\\[2ex]\begin{cases}x&=2v\\[2ex]y&=x^2\\\end{cases}\\\Longrightarrow"
        r"\begin{cases}y=4v^2\\x=3v\end{cases}$$",
        "",
        [D, D, D, P, OPEN],
    ),
    "a brace over equations": (
        r"$$\left\{\begin{aligned}x&=2v\\y&=x^2\end{aligned}\right.$$"
        r"$$\left\{\begin{array}{l}y=4v^2\\z=1\end{array}\right.$$",
        "",
        [D, D, P, D],
    ),
    "a function by cases stays one": (
        r"$$y=\begin{cases}x&\text{if }x>0\\-x&\text{if }x\le0\end{cases}$$ $$y=|x|$$",
        "",
        [D, P],
    ),
    "a display that begins with its sign": (
        r"$$u=2\sin v\cos v$$ $$=\sin 2v$$ and $$=2\sin 2v$$",
        "",
        [D, P, R],
    ),
    "indices that run": (r"$$L_i=\sqrt{a_i^2+b^2},\quad i=1,\dots,6$$", "", [D]),
    "indices that are counted": (
        r"$$L_i=a_i+b,\qquad i=1,2,$$ $$M_i=a_i\quad(i=1,\,2,3)$$ $$N_i=a_i\text{ for }i=1,2.$$",
        "",
        [D, D, D],
    ),
    "no index, but a decimal": (r"$$L=2i,\quad i=1,2$$", "L ; i : numbers", [D, UNREAD]),
    "a law by pieces before another": (
        r"$$y=\begin{cases}x&\text{if }x>0\\-x&\text{if }x\le0\end{cases}\qquad "
        r"z=\begin{cases}x,&x>0\\0,&x\le0\end{cases}$$",
        "",
        [D, D],
    ),
    "a name before an equation": (r"$$\text{Base}: u=2v$$ $$B: u=2v$$ $$u:=3v$$", "", [D, D, R]),
    "struck out, boxed": (r"$$u=v-\cancel{w}+\cancel{w}$$ $$\boxed{u\triangleq3v}$$", "", [D, R]),
    "a letter that counts": (
        r"$$q=t+2k\pi,\ k\in\mathbb{Z}$$ $$\sin(u+2k\pi)=\sin u\text{ for }k\in\mathbb{Z}$$"
        r"$$\sin(u+k\pi)=\sin u,\ k,m\in\mathbb{Z}$$ $$x=y,\ x\in\mathbb{N}$$"
        r"$$\cos(u+2k\pi)=\cos u\quad(k\in\mathbb Z)$$ $$\cos(u+k\pi)=\cos u\quad(k\in\mathbb Z)$$",
        ANGLES + "\nidentity display 3, display 6",
        [D, P, R, UNREAD, P, R],
    ),
    "an inverse function by declaration": (
        r"$$q=\tan^{-1}\frac ab$$ $$q=\arctan\frac ba$$ $$t=\cos^{-1}\frac ab$$",
        ANGLES,
        [D, R, UNREAD],
    ),
    "a rate with its argument": (
        r"$$x(t)=a+bt$$ $$\dot x(t)=b$$ $$\ddot x(t)=b$$ $$\dot x(t_1)=a$$",
        "x(t) : way\na ; b : numbers\n\\dot x(t_1) : speed\nt_1 : time",
        [D, P, OPEN, D],
    ),
    "lengths of vectors": (
        r"$$v=\begin{pmatrix}x\\y\\0\end{pmatrix}$$ $$L=\|v\|=\sqrt{x^2+y^2}$$"
        r"$$L=\sqrt{x^2-y^2}$$",
        MATRICES,
        [D, D, P, R],
    ),
    "the matrix of a cross product": (
        r"$$[v]_\times w=v\times w$$ $$[v]_{\times}w=w\times v$$",
        MATRICES + "\nidentity display 2",
        [P, R],
    ),
    "matrices without a value": (
        r"$$C=A^{-1}B$$ $$AC=B$$ $$C^T=B^T(A^{-1})^T$$ $$CA=B$$ $$A^{-1}A=I$$ $$B=AB$$",
        MATRICES + "\nidentity display 3, display 4",
        [D, P, P, R, P, D],
    ),
    "a product of matrices, without a block": (
        r"$$\begin{array}{cc}R_1=\begin{bmatrix}\cos q&-\sin q\\ \sin q&\cos q\\ \end{bmatrix}&"
        r"R_2=\begin{bmatrix}\cos t&-\sin t\\ \sin t&\cos t\\ \end{bmatrix}\end{array}$$"
        r"$$R=R_1R_2$$ $$R=\begin{bmatrix}\cos(q+t)&-\sin(q+t)\\ \sin(q+t)&\cos(q+t)\end{bmatrix}$$"
        r"$$R=\begin{bmatrix}\cos(q+t)&\sin(q+t)\\ \sin(q+t)&\cos(q+t)\end{bmatrix}$$",
        "",
        [D, D, D, P, R],
    ),
    "relations of letters without units have none": (
        r"$$\dot x^2\ge4\ddot x(a-b)$$",
        "x(t) ; a ; b : way\nfactor \\ddot x",
        [D],
    ),
    "numbers without letters": (
        r"$$\sin45^\circ\approx0.7071$$ $$\tan60^\circ=1.723$$ $$\cos0=1$$",
        "",
        [P, R, P],
    ),
    "what holds for positive letters": (
        r"$$x=r+\sqrt{l^2-r^2}$$ $$x=r+l\sqrt{1-r^2/l^2}$$ $$x=r-l\sqrt{1-r^2/l^2}$$",
        "",
        [D, OPEN, R],
    ),
    "what defines letters need not be put in": (
        r"$$k=\frac{q}{2-2m^2}$$ $$n=\frac{uv\sin\alpha}{u+v}$$ $$a=\sqrt{\frac{4Fn}{bk}}$$"
        r" $$p=\frac{2F}{ab}=\sqrt{\frac{Fk}{bn}}$$"
        r" $$w=\frac za-\frac{z^2}{a^2}=\frac za(1-\frac za)$$",
        "",
        [D, D, D, D, OPEN, D, P],
    ),
    "what is said to be positive": (
        r"$$x=r+\sqrt{l^2-r^2}$$ $$x=r+l\sqrt{1-r^2/l^2}$$",
        "x ; r ; l : lengths {l>0}",
        [D, P],
    ),
    "a condition behind a letter that is not defined by it": (r"$$|x|=x,\ x\ge0$$", "", [P]),
    "a column and a row in brackets": (
        r"$$p=\begin{pmatrix}x&y\end{pmatrix}^T$$ $$p=(x,y)$$ $$p=(y,x)$$",
        "",
        [D, P, R],
    ),
}
LINKS = r"""a ; b ; c ; d : lengths [mm]
\theta_2(t) ; \theta_3 ; \theta_4 : angles [rad]
\omega_2 ; \omega_3 ; \omega_4 : angular velocities [rad/s]
V : velocity
R : vector
imaginary j
let \dot\theta_2=\omega_2"""
PAPERS |= {
    "vectors of the plane as complex numbers": (
        r"$$ae^{j\theta_2}+be^{j\theta_3}-ce^{j\theta_4}-d=0$$"
        r"$$a\cos\theta_2+b\cos\theta_3=c\cos\theta_4+d$$",
        LINKS,
        [D, D, P],
    ),
    "a complex letter, its derivative and a wrong one": (
        r"$$R=ae^{j\theta_2}$$ $$R=a(\cos\theta_2+j\sin\theta_2)$$"
        r"$$V=\frac{dR}{dt}=ja\omega_2e^{j\theta_2}$$ $$R=a(\cos\theta_2-j\sin\theta_2)$$",
        LINKS,
        [D, P, P, D, P, P, P, R],
    ),
    "the imaginary unit without a block": (
        r"$$z=re^{i\varphi}$$ $$z=r\cos\varphi+ir\sin\varphi$$ $$z=re^{-i\varphi}$$",
        "",
        [D, P, P, P, R],
    ),
    "an upright imaginary unit": (
        r"$$\mathrm{e}^{\mathrm{i}\pi}+1=0$$ $$\mathrm{i}^2=-1$$ $$\mathrm{i}^2=1$$"
        r"$$(\cos u+\mathrm{i}\sin u)^3=\cos3u+\mathrm{i}\sin3u$$",
        "",
        [P, P, R, P, P],
    ),
    "an upright index is no imaginary unit": (
        r"$$d_\mathrm{i}=d-2h$$ $$d_{\mathrm{i}}=d+2h$$ $$F_{x,\mathrm{i}}=2d$$",
        "",
        [D, R, D],
    ),
    "a derivative beside a length d": (
        r"$$x=at^2$$ $$\frac{dx}{dt}=2at$$ $$y=\frac{da}{d-b}$$ $$y=\frac{da}{d+b}$$",
        "a ; b ; d ; x ; y : lengths\nt : time",
        [D, P, D, R],
    ),
    "a slash is no derivative beside a length d": (
        r"$$x=at^2$$ $$dx/dt=2at$$ $$y=(da)/(db)$$ $$y=a/b$$ $$y=b/a$$",
        "a ; b ; d ; x ; y : numbers\nt : time",
        [D, "not read", D, D, R],
    ),
    "a bracket that goes on in another line": (
        r"$$\begin{aligned}u=&\left(a+b\right.\\&\left.+c\right)v\end{aligned}$$ $$u=av+bv+cv$$"
        r"$$u=av+bv-cv$$",
        "",
        [D, P, R],
    ),
    "an upper index in brackets": (r"$$L=2x^{(1)}+y^{(i)}$$ $$L=x^{(1)}+y^{(i)}$$", "", [D, R]),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_equations_become_what_they_are(name: str) -> None:
    text, block, expected = PAPERS[name]
    assert outcomes(text, block) == expected


def test_a_refuted_print_is_not_said_to_lack_continuity() -> None:
    row = run(r"$$q=\arctan\frac yx$$ $$q=\arctan\frac xy$$").rows[1]
    assert row.reason == "the two sides differ; compared with display 1"


def test_a_display_that_goes_on_is_placed_where_it_begins() -> None:
    rows = run("$$u=2v$$\n\n$$=3v$$").rows
    assert [(row.name, row.place.line) for row in rows] == [
        ("display 1", 2 - 1),
        ("display 2, second equals sign", 3),
    ]


def test_a_draft_knows_products_of_matrices_arguments_and_inverse_functions() -> None:
    text = (
        r"$$M=\begin{pmatrix}1&x\\0&1\end{pmatrix}$$ $$N=MM$$ $$z=f(x, y+1)$$ $$u=\tan^{-1}x$$"
        r"$$w=\sin u(x+y)$$"
    )
    lines = draft_block(read_source("notes.md", text)).splitlines()
    for line in ("M 2x2 :", "N 2x2 :", "f(x, y+1) :", r"function \tan^{-1} is \arctan"):
        assert line in lines
    assert r"factor \sin u" in lines
