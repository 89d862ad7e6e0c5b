"""Rows that differ from a proved row by one slip: they are not constraints."""

from __future__ import annotations

from functools import cache

import pytest

from mechproof.document.checked_rows import CheckedRow
from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% r; l : lengths [mm] {r>0} {l>0}
%% a : length [mm] {a>0}
%% x(t) : position [mm]
%% \varphi(t) : crank [rad]
%% \psi(t) : rod [rad] {-\pi/2<\psi<\pi/2}
%% where l>r
%% end
"""
LOOP = (r"r\cos\varphi+l\cos\psi=x", r"r\sin\varphi=l\sin\psi")
RATE = r"r\dot\varphi\cos\varphi=l\dot\psi\cos\psi"
SECOND = (
    r"r\ddot\varphi\cos\varphi-r\dot\varphi^2\sin\varphi=l\ddot\psi\cos\psi{}l\dot\psi^2\sin\psi"
)
TANGENT = r"\tan\psi=\frac{{r\sin\varphi}}{{x{}r\cos\varphi}}"
SQUARED = "x^2-2rx\\cos\\varphi{}=l^2{}"
OPEN, GIVEN, PROVED, REFUTED = "not judged", "DEFINITION", "PROVED", "REFUTED"
CASES = {
    "a tangent": ([*LOOP, TANGENT.format("-"), TANGENT.format("+")], [PROVED, REFUTED]),
    # A second wrong row hides it.
    "two wrong rows": (
        [
            *LOOP,
            SQUARED.format("+r^2", ""),
            SQUARED.format("+l^2", "+r^2-l^2"),
            TANGENT.format("-"),
            TANGENT.format("+"),
        ],
        [PROVED, REFUTED, PROVED, OPEN],
    ),
    "a second derivative": (
        [LOOP[1], RATE, SECOND.format("-"), SECOND.format("+")],
        [PROVED, PROVED, OPEN],
    ),
    "the right print again": ([*LOOP, TANGENT.format("-"), TANGENT.format("-")], [PROVED, PROVED]),
    # A row that ties other letters, or says more, is a constraint.
    "a further constraint": (
        [*LOOP, TANGENT.format("-"), r"r\cos\varphi+l\cos\psi=2a\sin\varphi"],
        [PROVED, GIVEN],
    ),
    "one of a special position": ([*LOOP, TANGENT.format("-"), r"\varphi=2\psi"], [PROVED, GIVEN]),
}


@cache
def judge(name: str) -> tuple[CheckedRow, ...]:
    equations, _ = CASES[name]
    lines = (f"\\begin{{equation}}{latex}\\end{{equation}}" for latex in equations)
    return tuple(check("paper.tex", BLOCK + "\n".join(lines)).rows)


@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=[pytest.mark.slow] if n == "two wrong rows" else []) for n in CASES],
)
def test_a_slip_beside_what_is_proved_is_no_constraint(name: str) -> None:
    _, expected = CASES[name]
    assert [row.outcome for row in judge(name)][-len(expected) :] == expected


def test_the_print_with_which_it_is_compared_is_named() -> None:
    *_, row = judge("a second derivative")
    assert row.reason.startswith("it differs from (3), which is proved")
