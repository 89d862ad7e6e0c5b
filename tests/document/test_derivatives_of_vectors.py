"""Time derivatives of printed vectors and matrices, compared with those of the entries."""

from __future__ import annotations

import pytest

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% \theta(t) ; \omega(t) ; u(t) ; w(t) : coordinates
%% a ; b ; c ; d ; k : numbers
%% \mathbf p ; \dot{\mathbf p} ; \ddot{\mathbf p} 2x1 : a vector and its derivatives
%% R ; \dot R 2x2 : a matrix and its derivative
%% end
"""
CIRCLE = r"\mathbf p=\begin{pmatrix}a\cos\theta\\a\sin\theta\end{pmatrix}"
TURN = r"R=\begin{pmatrix}\cos\theta&-\sin\theta\\\sin\theta&\cos\theta\end{pmatrix}"
CASES = {
    "the derivative of each entry": (
        [CIRCLE, r"\dot{\mathbf p}=\begin{pmatrix}-a\dot\theta\sin\theta\\a\dot\theta\cos\theta"],
        "PROVED",
    ),
    "a wrong sign in one entry": (
        [CIRCLE, r"\dot{\mathbf p}=\begin{pmatrix}a\dot\theta\sin\theta\\a\dot\theta\cos\theta"],
        "REFUTED",
    ),
    "a wrong factor in the second derivative": (
        [
            CIRCLE,
            r"\ddot{\mathbf p}=\begin{pmatrix}-a\ddot\theta\sin\theta-2a\dot\theta^2\cos\theta"
            r"\\a\ddot\theta\cos\theta-a\dot\theta^2\sin\theta",
        ],
        "REFUTED",
    ),
    "the second derivative": (
        [
            CIRCLE,
            r"\ddot{\mathbf p}=\begin{pmatrix}-a\ddot\theta\sin\theta-a\dot\theta^2\cos\theta"
            r"\\a\ddot\theta\cos\theta-a\dot\theta^2\sin\theta",
        ],
        "PROVED",
    ),
    "a matrix and its derivative by products": (
        [TURN, r"\dot R=\dot\theta R\begin{pmatrix}0&-1\\1&0"],
        "PROVED",
    ),
    "a product that turns the other way": (
        [TURN, r"\dot R=\dot\theta R\begin{pmatrix}0&1\\-1&0"],
        "REFUTED",
    ),
    "an equation of motion in states": (
        [
            r"\mathbf p=\begin{pmatrix}\theta\\\omega\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}\omega\\-k\theta-c\omega",
        ],
        "DEFINITION",
    ),
    "entries that are not said to move": (
        [
            r"\mathbf p=\begin{pmatrix}a\\b\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}c\\d",
        ],
        "DEFINITION",
    ),
    "the derivative of a vector given in a turning frame": (
        [
            r"\mathbf p=\begin{pmatrix}u\\w\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}\dot u-w\dot\theta\\\dot w+u\dot\theta",
        ],
        "DEFINITION",
    ),
    "the same letters, in a frame that turns with the angle": (
        [
            r"\mathbf p=\begin{pmatrix}a\dot\theta\cos\theta\\a\dot\theta\sin\theta\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}a\ddot\theta\cos\theta-2a\dot\theta^2\sin\theta"
            r"\\a\ddot\theta\sin\theta+2a\dot\theta^2\cos\theta",
        ],
        "not judged",
    ),
    "almost the same": (
        [
            r"\mathbf p=\begin{pmatrix}a\dot\theta\cos\theta\\a\dot\theta\sin\theta\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}a\ddot\theta\cos\theta-2a\dot\theta^2\sin\theta"
            r"\\a\ddot\theta\sin\theta+a\dot\theta^2\cos\theta",
        ],
        "REFUTED",
    ),
    "a radial vector with other letters in an entry": (
        [
            r"\mathbf p=\begin{pmatrix}\dot u\\u\dot\theta\end{pmatrix}",
            r"\dot{\mathbf p}=\begin{pmatrix}\ddot u-u\dot\theta^2\\u\ddot\theta+2\dot u\dot\theta",
        ],
        "not judged",
    ),
}


@pytest.mark.parametrize("case", CASES)
def test_derivatives_of_entries_are_compared(case: str) -> None:
    (first, second), expected = CASES[case]
    second += r"\end{pmatrix}"
    rows = check("p.tex", rf"{BLOCK}\[{first}\] \[{second}\]").rows
    assert [row.outcome for row in rows] == ["DEFINITION", expected], rows[-1].reason


def test_block_may_repeat_the_derivative() -> None:
    let = r"%% let \mathbf p=\begin{pmatrix}\theta\\\omega\end{pmatrix}"
    rate = let.replace(r"\mathbf p", r"\dot{\mathbf p}").replace(r"\theta", r"\dot\theta")
    rate = rate.replace(r"\omega", r"\dot\omega")
    block = BLOCK.replace("%% end", f"{let}\n{rate}\n%% end")
    row = check("p.tex", block + r"\[b=\dot{\mathbf p}\cdot\dot{\mathbf p}\]").rows[0]
    assert row.outcome == "DEFINITION"
    with pytest.raises(ValueError, match="already has a value"):
        check("p.tex", block.replace(r"\dot\omega", r"2\dot\omega") + r"\[a=b\]")
