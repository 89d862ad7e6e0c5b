"""Velocities and accelerations of a loop, compared with proved prints of the position."""

from __future__ import annotations

import pytest
from small_papers import judge_rows

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = r"""%% mechproof
%% x(t) : position [mm]
%% r ; l : lengths [mm] {r>0}
%% \lambda : ratio
%% \varphi(t) ; \beta(t) : angles [rad] {-\pi/2<\beta<\pi/2}
%% \omega : speed of the crank [rad/s]
%% s ; k : length and number {s>0}
%% t : time
%% let \lambda=r/l
%% let \dot\varphi=\omega
%% where r<l
%% end
"""
LOOP = (r"x=r\cos\varphi+l\cos\beta", r"l\sin\beta=r\sin\varphi")
ROOT = r"\sqrt{1-\lambda^2\sin^2\varphi}"
ANGLE, POSITION = rf"\cos\beta={ROOT}", rf"x=r\cos\varphi+l{ROOT}"
VELOCITY = rf"\dot x=-r\omega\left(\sin\varphi+\frac{{\lambda\sin2\varphi}}{{2{ROOT}}}\right)"
ACCELERATION = (
    r"\ddot x=-r\omega^2\left(\cos\varphi+\frac{\lambda\cos2\varphi+\lambda^3\sin^4\varphi}"
    r"{(1-\lambda^2\sin^2\varphi)^{3/2}}\right)"
)
SLOW, ROUGH = VELOCITY.replace("{2", "{3"), ACCELERATION.replace("^{3/2}", "^{1/2}")
SHORT = r"\ddot x=-r\omega^2(\cos\varphi+\lambda\cos2\varphi)"
OPEN = "not judged"
# Equations, the outcome of the last one, and a part of its reason.
PAPERS = {
    "a velocity": ((*LOOP, ANGLE, POSITION, VELOCITY), "PROVED", ""),
    "a wrong velocity": ((*LOOP, ANGLE, POSITION, SLOW), "REFUTED", "compared with (4)"),
    "an acceleration": ((*LOOP, ANGLE, POSITION, ACCELERATION), "PROVED", ""),
    "a wrong acceleration": ((*LOOP, ANGLE, POSITION, ROUGH), "REFUTED", "compared with (4)"),
    "an approximation": (
        (*LOOP, ANGLE, POSITION, "#For small $\\lambda$ we have", SHORT),
        OPEN,
        "",
    ),
    "an approximation, without a word": ((*LOOP, ANGLE, POSITION, SHORT), "REFUTED", "(4)"),
    "beside a wrong position": (
        (*LOOP, ANGLE, POSITION.replace("+l", "+2l"), SLOW),
        OPEN,
        "it differs from (1)",
    ),
    "beside a position of a case": (
        (*LOOP, ANGLE, "#In the case considered,", POSITION, SLOW),
        OPEN,
        "it differs from (1)",
    ),
    "without a position": ((*LOOP, ANGLE, SLOW), OPEN, "it differs from (1)"),
    "what another constraint makes true": (
        (*LOOP, "l^2=16r^2", ANGLE, POSITION, VELOCITY.replace(r"{\lambda", r"{\frac r{4r}")),
        OPEN,
        "could not be decided",
    ),
    "beside another constraint": (
        (*LOOP, "l^2=16r^2", ANGLE, POSITION, SLOW),
        "REFUTED",
        "also where (2), (3) hold; compared with (5)",
    ),
    "with letters of another constraint": (
        (
            *(*LOOP, r"(s+k)\sin\varphi=s^2+r", ANGLE, POSITION),
            VELOCITY.replace(r"(\sin\varphi", r"(\frac{s^2+r}{s+k}"),
        ),
        OPEN,
        "",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_rates_are_compared_with_what_is_proved(name: str) -> None:
    equations, outcome, reason = PAPERS[name]
    row = judge_rows(BLOCK, *equations)[-1]
    assert row.outcome == outcome, row.reason
    assert reason in row.reason
