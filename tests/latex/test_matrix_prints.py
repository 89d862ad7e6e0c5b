r"""Vectors and matrices in print: products, blocks, parts, determinants, in every spelling.

Each form has a twin, a similar print that is refused or says something else.
"""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.values import differentiate
from mechproof.record import Notation, Variable

x, y, s = sp.symbols("x y s", real=True)
A, B = sp.MatrixSymbol("A", 3, 3), sp.MatrixSymbol("B", 3, 3)
u, v, w = (sp.MatrixSymbol(name, 3, 1) for name in "uvw")
P = sp.MatrixSymbol("P", 2, 2)
PRINTED = {
    **{x: "x", y: "y", s: "s", A: "[A]", B: r"\mathbf{B}", u: r"\vec{u}", v: "v", w: "w", P: "P"},
}
VARIABLES = tuple(Variable(symbol, "", latex=(latex,)) for symbol, latex in PRINTED.items())
UNIT = Variable(sp.MatrixSymbol("I", 3, 3), "", given=sp.eye(3), latex=("[I]",))
GIVEN = Variable(
    sp.MatrixSymbol("Q", 1, 2), "", given=sp.ImmutableMatrix([[x, 2 * x]]), latex=("Q(x)", "Q")
)
OPEN = Variable(sp.MatrixSymbol("S", 1, 2), "", latex=("S(x)", "S"))
READER = Reader(
    (*VARIABLES, UNIT, GIVEN, OPEN), Notation(functions={"Inv": lambda matrix: matrix.inv()})
)


def read(latex: str) -> Any:
    print_ = READER.parse(latex)
    found = print_.meaning().of(print_.chains[0].members[0])
    return found.as_explicit() if isinstance(found, sp.MatrixExpr) else found


def show(value: Any) -> Any:
    return sp.Matrix(value.as_explicit() if isinstance(value, sp.MatrixExpr) else value)


E = {name: show(symbol) for name, symbol in (("A", A), ("B", B), ("u", u), ("v", v), ("w", w))}
NUMBERS = [
    (r"\vec{u}\cdot v", E["u"].dot(E["v"])),
    (r"2(\vec{u}\cdot v)x", 2 * x * E["u"].dot(E["v"])),
    (r"\vec{u}\cdot v\times w", E["u"].dot(E["v"].cross(E["w"]))),
    (r"\vec{u}^Tv", E["u"].dot(E["v"])),
    (r"v^2", E["v"].dot(E["v"])),
    (r"(\vec{u}-2w)^2", (E["u"] - 2 * E["w"]).dot(E["u"] - 2 * E["w"])),
    (r"v^{\top}[A]v", (E["v"].T * E["A"] * E["v"])[0]),
    (r"(1, 2, 3)\cdot(x, y, s)", x + 2 * y + 3 * s),
    (r"|P|", P[0, 0] * P[1, 1] - P[0, 1] * P[1, 0]),
    (r"|v|", sp.sqrt(v[0, 0] ** 2 + v[1, 0] ** 2 + v[2, 0] ** 2)),
    (r"\|v\|^2", v[0, 0] ** 2 + v[1, 0] ** 2 + v[2, 0] ** 2),
    (r"\left\|(x, y)\right\|", sp.sqrt(x**2 + y**2)),
    (r"\Vert x\Vert y", sp.Abs(x) * y),
    (r"\det P", P[0, 0] * P[1, 1] - P[0, 1] * P[1, 0]),
    (r"x\times y", x * y),
    (r"[A][2, 3:3]", A[1, 2]),
    (r"\text{abs}\begin{pmatrix}x-y\end{pmatrix}", sp.Abs(x - y)),
    (r"\operatorname{inv}(x)", sp.tan(x) - x),
]
MATRICES = [
    (r"\operatorname{inv}(P)", show(P).inv()),
    (r"2\cos x[P]", 2 * sp.cos(x) * show(P)),
    ("Q(y)", sp.Matrix([[y, 2 * y]])),
    (r"\vec{u}\times v", E["u"].cross(E["v"])),
    (r"v\times\vec{u}", -E["u"].cross(E["v"])),
    (r"x\,v\times(w+\vec{u})", x * E["v"].cross(E["w"] + E["u"])),
    (r"[v]_\times w", E["v"].cross(E["w"])),
    (r"\vec{u}\times[A]w", E["u"].cross(E["A"] * E["w"])),
    (r"[(x, y, s)]_{\times}", sp.Matrix([[0, -s, y], [s, 0, -x], [-y, x, 0]])),
    (r"\mathbf B^{-1}\;[A]v", E["B"].inv("ADJ") * E["A"] * E["v"]),
    # Wide gaps separate the entries of a row, but not the terms of a sum or factors.
    (r"[x\cos y\quad -y\qquad0]", sp.Matrix([[x * sp.cos(y), -y, 0]])),
    (r"\left[x\quad y\right]^T", sp.Matrix([x, y])),
    (r"[A][x\quad y\quad s]^T", E["A"] * sp.Matrix([x, y, s])),
    (r"2[x\quad +\quad y]\quad[A]", 2 * (x + y) * E["A"]),
    (r"[A](v\times w)", E["A"] * E["v"].cross(E["w"])),
    (r"(1, 0, 0)\times(0, 1, 0)", sp.Matrix([[0, 0, 1]])),
    (r"(1,0,0)\times(0,1,0)", sp.Matrix([[0, 0, 1]])),
    (r"(0,0,s)\times(x, y)", sp.Matrix([[-s * y, s * x]])),
    (r"(0,0,s)\times(x,0,0)", sp.Matrix([[0, s * x, 0]])),
    (r"(0, 0, s)\times(x, y)", sp.Matrix([[-s * y, s * x]])),
    (r"(x, y)\times(0, 0, s)", sp.Matrix([[s * y, -s * x]])),
    (r"[A]\times\mathbf B", E["A"] * E["B"]),
    (r"2\times v", 2 * E["v"]),
    (r"[A]\cdot\mathbf B\cdot v", E["A"] * E["B"] * E["v"]),
    (r"\sin x[A]+\mathbf{B}\cos x", sp.sin(x) * E["A"] + sp.cos(x) * E["B"]),
    *((rf"([A]\mathbf B)^{t}", (E["A"] * E["B"]).T) for t in ("T", r"\top", r"{\mathsf T}")),
    (r"[I]-[A]", sp.eye(3) - E["A"]),
    (r"P^{-1}", show(P).inv()),
    (r"Inv(P)", show(P).inv()),
    (r"\operatorname{Inv}(P)P", sp.eye(2)),
    (r"[A][1:3, 2]", E["A"][:, 1]),
    (r"[A][2:3, :]", E["A"][1:, :]),
    (r"v[2:3]", E["v"][1:, :]),
    (
        r"\begin{bmatrix}P&\begin{matrix}x\\y\end{matrix}\\0\;0&1\end{bmatrix}",
        show(P).row_join(sp.Matrix([x, y])).col_join(sp.Matrix([[0, 0, 1]])),
    ),
    (r"\begin{pmatrix}P&0\\0&P\end{pmatrix}", sp.diag(show(P), show(P))),
    # The distance to the next row means nothing; a row may begin with a bracket.
    *(
        (rf"\begin{{pmatrix}}x\\{space}-y\end{{pmatrix}}", sp.Matrix([x, -y]))
        for space in ("[2mm]", " [0.5 em]", "[-1ex]", "*", "*[3pt]", r"[\jot]", r"[2\baselineskip]")
    ),
    (r"\begin{pmatrix}x\\ [2y]s\end{pmatrix}", sp.Matrix([x, 2 * y * s])),
]


@pytest.mark.parametrize(("latex", "value"), NUMBERS)
def test_a_number_is_read(latex: str, value: sp.Expr) -> None:
    assert sp.simplify(read(latex) - value) == 0


@pytest.mark.slow
@pytest.mark.parametrize(("latex", "value"), MATRICES)
def test_a_matrix_is_read(latex: str, value: sp.Matrix) -> None:
    assert sp.simplify(sp.Matrix(read(latex)) - value).is_zero_matrix


REFUSED = [
    *(
        (latex, "comes first")
        for latex in (r"\vec{u}\times v\times w", r"[A]v\times w", r"v\cdot(1, 2, 3)")
    ),
    (r"[A]v\times[A]w", "comes first"),
    *((latex, "comes first") for latex in (r"\vec{u}\cdot v\cdot w", r"v\cdot[A]\cdot w")),
    *((latex, "do not fit") for latex in (r"\vec{u}v", "v^3", r"P\cdot v")),
    *((latex, "a number and a vector") for latex in (r"x\times v", r"\vec{u}\times(x+y)")),
    (r"\begin{bmatrix}P&x\\0&1\end{bmatrix}", "do not fit"),
    (r"|2P|", "where a number is expected"),
    (r"x^{\top}", "the transpose of something that is not a matrix"),
    (r"[A][0:2, 1]", "0 to 2 of 3"),
    (r"[A][2:4, 1]", "2 to 4 of 3"),
    (r"[A][x:2, 1]", "by their numbers only"),
    (r"x[1:2, 1]", "of something that is not a matrix"),
    (r"0\;0+P", "a blank within a number"),
    (r"\begin{pmatrix}1 2&3\end{pmatrix}", "a blank within a number"),
    (r"\cos x(y+1)", "a bracket after"),
    (r"\|P\|", "where a number is expected"),
    (r"[x]_\times", "do not fit"),
    (r"(0, x, y)\times(x, y)", "is not along z"),
    (r"\cos x[y]", "belong to the argument"),
    (r"\operatorname{inv}(v)", "do not fit"),
    ("S(y)", "the text does not say what S is for x = y"),
    (r"[P]_{xy}", r"\[P\]_{xy} is not declared"),
    (r"\begin{bmatrix}x&\dots&y\end{bmatrix}", "whose number is not given"),
    (r"\begin{bmatrix}x&...&y\end{bmatrix}", "whose number is not given"),
]


@pytest.mark.parametrize(("latex", "told"), REFUSED)
def test_what_is_no_matrix_or_not_clear_is_refused(latex: str, told: str) -> None:
    with pytest.raises(ReadingError, match=told):
        read(latex)


def test_bars_beside_a_determinant_may_be_one() -> None:
    with pytest.raises(ReadingError, match="of a matrix, or an absolute value"):
        Reader(VARIABLES).collect(r"|M|=\left|\begin{array}{cc}x&y\\y&x\end{array}\right|")
    assert Reader(VARIABLES).collect(r"|M|=x") == ["M"]


def test_a_function_may_be_declared_as_it_is_printed() -> None:
    functions = {"tan^{-1}": sp.atan, "cos^{-1}": sp.acos}
    reader = Reader(VARIABLES, Notation(functions=functions, factors=(r"\cos z_1", "z_1")))
    for latex, value in ((r"\tan^{-1}x", sp.atan(x)), (r"cos^{-1}(x)", sp.acos(x))):
        print_ = reader.parse(latex)
        assert print_.meaning().of(print_.chains[0].members[0]) == value
    with pytest.raises(ReadingError, match="its inverse or its reciprocal"):
        reader.parse(r"\sin^{-1}x")
    assert reader.collect(r"\cos z_1(y+1)") == ["z_{1}"]
    with pytest.raises(ReadingError, match="a bracket after"):
        reader.collect(r"\sin z_1(y+1)")


def test_a_matrix_is_differentiated_beside_letters_that_move_and_are_not_in_it() -> None:
    moving = {y: (x, (s,))}
    assert differentiate(sp.ImmutableMatrix([x]), x, moving) == sp.ImmutableMatrix([1])
    assert differentiate(sp.ImmutableMatrix([x * y]), x, moving) == sp.ImmutableMatrix([y + x * s])
