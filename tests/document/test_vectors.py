"""Vectors and matrices in papers without a block, even if printed before their components."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

STIFFNESS = r"\mathbf K=\begin{pmatrix}k+m&-m\\-m&m\end{pmatrix}"
LOAD = r"\mathbf f=\begin{pmatrix}0\\F\end{pmatrix}"
CLOSURE = (
    r"\vec a+\vec b=\vec s",
    r"\vec a=r\vec i",
    r"\vec b=l\vec j",
    r"\vec s=x\vec e",
    r"x=r\cos\varphi+l\cos\beta",
    r"\vec i=\begin{pmatrix}\cos\varphi\\ \sin\varphi\end{pmatrix}",
    r"\vec j=\begin{pmatrix}\cos\beta\\-\sin\beta\end{pmatrix}",
    r"\vec e=\begin{pmatrix}1\\0\end{pmatrix}",
)
ARM = (
    r"x=l\cos u+m\cos(u+v)",
    r"y=l\sin u+m\sin(u+v)",
    r"\mathbf p=(x,y)",
    r"\mathbf q=(u,v)",
)
TURN = r"\begin{pmatrix}\cos\theta&-\sin\theta\\\sin\theta&\cos\theta\end{pmatrix}"
JACOBIAN = r"\frac{\partial\mathbf p}{\partial\mathbf q}"
# The turn about a unit vector (Rodrigues), and the matrix by which it is multiplied.
UNIT = "a^2+b^2+c^2=1"
CROSS = r"\mathbf K=\begin{pmatrix}0&-c&b\\c&0&-a\\-b&a&0\end{pmatrix}"
ONE = r"\mathbf E=\begin{pmatrix}1&0&0\\0&1&0\\0&0&1\end{pmatrix}"
RODRIGUES = r"\mathbf R=\mathbf E+\mathbf K\sin u+\mathbf K^2(1-\cos u)"
CASES = {
    "entries that follow from a constraint": (
        [UNIT, CROSS, ONE, RODRIGUES, r"\mathbf K^3=-\mathbf K", r"\mathbf R\mathbf R^T=\mathbf E"],
        [*["DEFINITION"] * 4, "PROVED", "PROVED"],
    ),
    "entries one of which does not follow": (
        [
            UNIT,
            CROSS.replace("-b&a", "b&a"),
            ONE,
            RODRIGUES,
            r"\mathbf K^3=-\mathbf K",
            r"\mathbf R\mathbf R^T=\mathbf E",
        ],
        [*["DEFINITION"] * 4, "not judged", "not judged"],
    ),
    "derivatives of a vector by another, in either layout": (
        [
            *ARM,
            rf"{JACOBIAN}=\begin{{pmatrix}}-y&-m\sin(u+v)\\x&m\cos(u+v)\end{{pmatrix}}",
            rf"{JACOBIAN}=\begin{{pmatrix}}-y&m\sin(u+v)\\x&m\cos(u+v)\end{{pmatrix}}",
            rf"{JACOBIAN}=\begin{{pmatrix}}-y&x\\-m\sin(u+v)&m\cos(u+v)\end{{pmatrix}}",
            rf"{JACOBIAN}=\begin{{pmatrix}}-y&x\\m\sin(u+v)&m\cos(u+v)\end{{pmatrix}}",
            r"\frac{\partial x}{\partial\mathbf q}=y",
        ],
        [*["DEFINITION"] * 4, "PROVED", "REFUTED", "not judged", "REFUTED", "not read"],
    ),
    "the entries of an inverse": (
        [
            r"\mathbf A=\begin{pmatrix}a&b\\0&c\end{pmatrix}",
            r"\mathbf A^{-1}=\frac1{ac}\begin{pmatrix}c&-b\\0&a\end{pmatrix}",
            r"\mathbf A^{-1}=\frac1{ac}\begin{pmatrix}c&b\\0&a\end{pmatrix}",
            r"\mathbf A\mathbf A^T=\mathbf A^T\mathbf A",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "not judged"],
    ),
    "columns in braces, and how they stand": (
        [
            r"\begin{Bmatrix}F\\G\end{Bmatrix}=\begin{bmatrix}k&-k\\-k&k\end{bmatrix}"
            r"\begin{Bmatrix}u\\v\end{Bmatrix}",
            r"\begin{bmatrix*}[r]1&-1\\-1&\phantom{-}1\end{bmatrix*}\begin{Bmatrix}u\\v\end{Bmatrix}"
            r"=\begin{pmatrix*}u-v\\v-u\end{pmatrix*}",
            r"\begin{bmatrix*}[r]1&-1\\-1&1\end{bmatrix*}\begin{Bmatrix}u\\v\end{Bmatrix}"
            r"=\begin{pmatrix*}u-v\\u-v\end{pmatrix*}",
            r"w=\begin{Bmatrix}u&u>0\\-u&u\le0\end{Bmatrix}",
        ],
        ["DEFINITION", "PROVED", "not judged", "DEFINITION"],
    ),
    "a bracket behind a matrix may be its argument": (
        [
            rf"R={TURN}",
            rf"R(\theta)={TURN}",
            rf"R^T(\theta)={TURN}",
            "R(0)=R",
            r"R(1-\cos\theta)=R-\cos\theta R",
            r"\mathbf q=(x,y)",
            r"R(\mathbf q+\mathbf q)=2R\mathbf q",
            r"R(\mathbf q-\mathbf q)=2R\mathbf q",
            r"R(\mathbf q)=R",
        ],
        [
            *("DEFINITION", "not read", "not read", "not read", "PROVED", "DEFINITION"),
            # The second of these holds where x and y are zero, which may be meant.
            *("PROVED", "DEFINITION", "not read"),
        ],
    ),
    "a bold capital between columns is a matrix, and no cross product": (
        [
            r"\mathbf q=(x,y,z)",
            r"\mathbf p+\mathbf q=\mathbf R\mathbf q",
            r"\mathbf v+\mathbf q=\mathbf W\times\mathbf q",
            r"\mathbf p^T\mathbf R\mathbf q=\langle\mathbf p,\mathbf R\mathbf q\rangle",
            r"\mathbf p^T\mathbf R\mathbf q=\langle\mathbf q,\mathbf R\mathbf p\rangle",
            r"\langle\mathbf p,\mathbf q\rangle_2=x",
            r"\langle x,y\rangle=xy",
        ],
        ["DEFINITION"] * 2 + ["not read", "PROVED", "not judged", "not read", "not read"],
    ),
    "a rate has the size of its vector": (
        [
            r"\dot{\mathbf r}=\mathbf J\dot{\mathbf q}",
            r"\dot{\mathbf q}=\mathbf J^{-1}\dot{\mathbf r}",
            r"\dot{\mathbf r}=\mathbf J^T\dot{\mathbf q}",
            r"\mathbf J=\begin{pmatrix}a&b\\0&c\end{pmatrix}",
            r"\mathbf q=\begin{pmatrix}u\\v\end{pmatrix}",
            r"\mathbf r=\begin{pmatrix}x\\y\end{pmatrix}",
        ],
        ["DEFINITION", "PROVED", "REFUTED", *["DEFINITION"] * 3],
    ),
    "a cross between a number and a vector is not read": (
        [
            r"\vec v=\omega\times\vec r",
            r"\vec r=\begin{pmatrix}x\\y\end{pmatrix}",
            r"\vec v=\begin{pmatrix}-\omega y\\ \omega x\end{pmatrix}",
        ],
        ["not read", "DEFINITION", "DEFINITION"],
    ),
    "a vector is printed behind what is made of it": (
        [
            r"\mathbf r=l\mathbf s",
            r"\mathbf s=\begin{pmatrix}\cos\varphi\\ \sin\varphi\end{pmatrix}",
            r"\mathbf r=\begin{pmatrix}l\cos\varphi\\l\sin\varphi\end{pmatrix}",
            r"\mathbf r=\begin{pmatrix}l\cos\varphi\\-l\sin\varphi\end{pmatrix}",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "REFUTED"],
    ),
    "a system and its solution": (
        [
            r"\mathbf K\mathbf u=\mathbf f",
            STIFFNESS,
            LOAD,
            r"\mathbf u=\mathbf K^{-1}\mathbf f",
            r"\mathbf u=\begin{pmatrix}F/k\\F/k+F/m\end{pmatrix}",
        ],
        ["PROVED", "DEFINITION", "DEFINITION", "DEFINITION", "PROVED"],
    ),
    "a wrong solution of a system is not proved by what is made of it": (
        [
            r"\mathbf K\mathbf u=\mathbf f",
            STIFFNESS,
            LOAD,
            r"\mathbf u=\mathbf K^{-1}\mathbf f",
            r"\mathbf u=\begin{pmatrix}F/k\\F/k-F/m\end{pmatrix}",
        ],
        ["PROVED", "DEFINITION", "DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "the solution of a system before the system": (
        [
            r"\mathbf u=\mathbf K^{-1}\mathbf f",
            r"\mathbf K\mathbf u=\mathbf f",
            STIFFNESS,
            LOAD,
            r"\mathbf u=\begin{pmatrix}F/k\\F/k-F/m\end{pmatrix}",
        ],
        ["DEFINITION", "PROVED", "DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "each of two vectors is made of the other": (
        [
            r"\mathbf r=\mathbf s+\mathbf c",
            r"\mathbf s=\mathbf r-\mathbf c",
            r"\mathbf r=\begin{pmatrix}a\\b\end{pmatrix}",
            r"\mathbf c=\begin{pmatrix}g\\h\end{pmatrix}",
            r"\mathbf s=\begin{pmatrix}a-g\\b+h\end{pmatrix}",
        ],
        ["PROVED", "DEFINITION", "DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "the closure of a loop is no identity": (
        CLOSURE,
        [*["DEFINITION"] * 3, "not judged", *["DEFINITION"] * 4],
    ),
    "a wrong table beside a loop is one": (
        [*CLOSURE, r"\vec a=\begin{pmatrix}r\cos\varphi\\0\end{pmatrix}"],
        [*["DEFINITION"] * 3, "not judged", *["DEFINITION"] * 4, "REFUTED"],
    ),
    "a zero beside a vector is one of zeros, no letter": (
        [
            r"(\mathbf K-\omega^2\mathbf M)\mathbf a=\mathbf 0",
            r"(\mathbf K-\omega^2\mathbf M)\mathbf b=\boldsymbol{0}",
            r"\mathbf a-\mathbf c=\vec 0",
            r"\mathbf a+\mathbf b-\mathbf d=0",
            r"\mathbf a+\mathbf b-2\mathbf d=\mathbf{0}",
            r"\mathbf K=\begin{pmatrix}2k&-k\\-k&2k\end{pmatrix}",
            r"\mathbf M=\begin{pmatrix}m&0\\0&m\end{pmatrix}",
            r"\mathbf a=\begin{pmatrix}1\\1\end{pmatrix}",
            r"\mathbf b=\begin{pmatrix}1\\-1\end{pmatrix}",
            r"\mathbf d=\begin{pmatrix}2\\0\end{pmatrix}",
            r"\mathbf c=\mathbf a",
        ],
        [
            *("DEFINITION", "DEFINITION", "PROVED", "PROVED", "not judged"),
            *("DEFINITION", "DEFINITION", *["not judged"] * 3, "DEFINITION"),
        ],
    ),
    "that two matrices differ is no proof that one is nowhere zero": (
        [
            r"\mathbf A=\begin{pmatrix}a&b\\0&c\end{pmatrix}",
            r"\mathbf A\mathbf A^T\ne\mathbf A^T\mathbf A",
            r"\mathbf A\ne\mathbf 0",
        ],
        ["DEFINITION", "PROVED", "not judged"],
    ),
    "an entry of a matrix that is worked out to be zero is none": (
        [
            r"\mathbf R=\mathbf B\mathbf A",
            r"\mathbf A=\begin{pmatrix}a&b\\0&c\end{pmatrix}",
            r"\mathbf B=\begin{pmatrix}u&v\\0&w\end{pmatrix}",
            r"\mathbf R=\begin{pmatrix}au&bu+cv\\a+b+c+u+v+w&cw\end{pmatrix}",
        ],
        ["DEFINITION", "DEFINITION", "DEFINITION", "REFUTED"],
    ),
    "components in a bracket": (
        [
            r"\mathbf s=(a,b)",
            r"\vec w=(u,v,0)^T",
            r"\boldsymbol\omega=(0, 0, \omega)",
            r"\boldsymbol\omega\times\vec w=(-\omega v,\omega u,0)",
            r"T=\frac m2\mathbf s^2+\vec w^2",
            r"T=\frac{ma^2+mb^2}2+u^2+v^2",
            r"T=\frac m2(a^2-b^2)+u^2+v^2",
            r"\mathbf s=(b,a)",
        ],
        [*["DEFINITION"] * 3, "PROVED", "DEFINITION", "PROVED", "REFUTED", "REFUTED"],
    ),
    "a bracket beside a row is one": (
        [
            r"\mathbf K=\begin{pmatrix}a&b\\c&d\end{pmatrix}",
            r"\mathbf q=(u,v)",
            r"\mathbf q^\top\mathbf K=(au+cv,\ bu+dv)",
            r"\mathbf q^\top\mathbf K=(au+bv,\ cu+dv)",
        ],
        ["DEFINITION", "DEFINITION", "PROVED", "not judged"],
    ),
    "an entry that is never true is no constraint": (
        [
            r"\mathbf R=\begin{pmatrix}\cos u&-\sin u\\ \sin u&\cos u\end{pmatrix}",
            r"\mathbf S=\begin{pmatrix}\cos u&\sin u\\-\sin u&\cos u\end{pmatrix}",
            r"\mathbf S\mathbf R=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
            r"\mathbf R^T\mathbf R=\begin{pmatrix}1&0\\0&2\end{pmatrix}",
            r"\mathbf E=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
            r"\mathbf S\mathbf R=-\mathbf E",
            r"\mathbf R\mathbf R=\mathbf E",
            r"\begin{pmatrix}a\\b\\1\end{pmatrix}=\begin{pmatrix}b\\a\\2\end{pmatrix}",
            r"\begin{pmatrix}a\\b\\1\end{pmatrix}=\begin{pmatrix}b\\a\\1\end{pmatrix}",
        ],
        [
            *["DEFINITION", "DEFINITION", "PROVED", "REFUTED", "DEFINITION", "REFUTED"],
            *["not judged", "REFUTED", "not judged"],
        ],
    ),
    "a system without a solution, and cases, are not accused": (
        [
            r"\begin{pmatrix}1&1\\0&0\end{pmatrix}\begin{pmatrix}a\\b\end{pmatrix}"
            r"=\begin{pmatrix}1\\2\end{pmatrix}",
            r"\mathbf R\mathbf R=\begin{pmatrix}1&0\\0&2\end{pmatrix}",
            r"\mathbf R=\begin{pmatrix}p&q\\0&1\end{pmatrix}",
        ],
        ["DEFINITION", "not judged", "not judged"],
    ),
    "rounded decimals accuse nothing that they explain": (
        [
            r"\mathbf A=\begin{pmatrix}0.866&-0.5\\0.5&0.866\end{pmatrix}",
            r"\mathbf A^T\mathbf A=\begin{pmatrix}1&0\\0&1\end{pmatrix}",
            r"\mathbf A^T\mathbf A=\begin{pmatrix}2&0\\0&1\end{pmatrix}",
        ],
        ["DEFINITION", "not judged", "REFUTED"],
    ),
    "constraints excuse vectors": (
        [
            r"r\sin\varphi=l\sin\beta",
            r"\vec a=\begin{pmatrix}x+l\sin\beta\\l\sin\beta\end{pmatrix}",
            r"\vec b=\begin{pmatrix}x+r\sin\varphi\\r\sin\varphi\end{pmatrix}",
            r"x=l\cos\beta+r\cos\varphi",
            r"\vec a=\vec b",
            r"\vec a=-\vec b",
        ],
        ["DEFINITION"] * 4 + ["PROVED", "REFUTED"],
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_vectors_without_a_block(name: str) -> None:
    equations, expected = CASES[name]
    lines = (f"\\begin{{equation}}{latex}\\end{{equation}}" for latex in equations)
    assert [row.outcome for row in check("paper.tex", "\n".join(lines)).rows] == expected


BLOCKS = r"""%% mechproof
%% a ; b : numbers
%% M ; K ; E 2x2 : matrices
%% let E=\begin{pmatrix}1&0\\0&1\end{pmatrix}
%% end
$$a^2+b^2=1$$
$$K=\begin{pmatrix}a&b\\-b&a\end{pmatrix}$$
\begin{equation}\begin{pmatrix}KK^T&@\\0&KK^T\end{pmatrix}=\begin{pmatrix}E&0\\0&E\end{pmatrix}\end{equation}
"""


@pytest.mark.parametrize(("entry", "expected"), [("0", "PROVED"), ("M", "DEFINITION")])
def test_no_entry_with_the_letter_of_a_matrix_is_left_out(entry: str, expected: str) -> None:
    assert check("paper.tex", BLOCKS.replace("@", entry)).rows[-1].outcome == expected


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"\left.\begin{pmatrix}\cos q\\a\end{pmatrix}\right|_{q=0}=(1, a)", "PROVED"),
        (r"\left.\begin{pmatrix}\cos q\\a\end{pmatrix}\right|_{q=0}=(0, a)", "REFUTED"),
        (r"\left.\begin{pmatrix}q\\s\end{pmatrix}\right|_{q=0}=(0, a)", "not read"),
    ],
)
def test_a_printed_matrix_has_a_value_at_a_place(latex: str, outcome: str) -> None:
    block = "%% mechproof\n%% q : angle\n%% a : number\n%% s(q) : law\n%% end\n"
    (row,) = check("paper.tex", f"{block}$${latex}$$").rows
    assert row.outcome == outcome


QUATERNIONS = r"""%% mechproof
%% q ; p 1x4 : quaternions
%% w ; x ; y ; z ; a ; b ; c : numbers
%% \theta : angle
%% \mathbf n ; \mathbf v 3x1 : vectors
%% let \mathbf n=(a,b,c)
%% end
"""


@pytest.mark.parametrize(
    ("first", "second", "outcome"),
    [
        ("q=[w,(x,y,z)]", r"|q|=\sqrt{w^2+x^2+y^2+z^2}", "PROVED"),
        ("q=[w,(x,y,z)]", r"|q|=\sqrt{w^2+x^2+y^2-z^2}", "not judged"),
        ("q=[w,(x,y,z)]", "q=(w,x,y,z)", "PROVED"),
        (r"p=[\cos\theta,\sin\theta\,\mathbf n]", None, "PROVED"),
        (r"p=[\cos\theta,\cos\theta\,\mathbf n]", None, "REFUTED"),
        # Two vectors are a pair, or a product, and no longer vector.
        ("q=[w,(x,y,z)]", r"(\mathbf n,\mathbf v)=0", "not read"),
    ],
)
def test_a_vector_in_a_list_of_numbers_adds_its_entries(
    first: str, second: str | None, outcome: str
) -> None:
    second = second or r"p=(\cos\theta,a\sin\theta,b\sin\theta,c\sin\theta)"
    rows = check("paper.tex", rf"{QUATERNIONS}\[{first}\] \[{second}\]").rows
    assert [row.outcome for row in rows] == ["DEFINITION", outcome]
