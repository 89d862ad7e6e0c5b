"""Brackets after letters: sums that units and functions show to be factors, and arguments."""

from __future__ import annotations

import pytest
from small_papers import outcomes

pytestmark = pytest.mark.usefixtures("judged_here")

BLOCK = "%% \\tau_1 ; \\tau_2 : times [s] {\\tau_2>0}\n%% natural n\n"
CASES = {
    "a number beside a ratio is multiplied, one beside an angle shifts it": (
        [
            r"x=r(1-\lambda)",
            r"x=r-r\lambda",
            r"x=r(1+\lambda/2)",
            r"x=r\lambda-r",
            r"x=r(\alpha+1)",
            r"x=r(\lambda+2\pi)",
            r"x=r(1+\lambda+n)",
            r"s=s(\lambda+1)",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "REFUTED"] + ["not read"] * 4,
    ),
    "a sum with a function of an angle is multiplied": (
        [
            r"x=r(\alpha-\sin\alpha)",
            r"x=r\alpha-r\sin\alpha",
            r"x=r(\alpha+\alpha\cos\alpha)",
            r"x=r(\alpha-\sqrt{1-\alpha^2})",
            r"x=r(\beta+\arcsin\lambda)",
            r"x=r(\beta+\sqrt2)",
            r"x=s(\psi-\sin\psi)",
            r"x=r(\tau_1+\sqrt{\tau_1\tau_2})",
        ],
        ["DEFINITION", "PROVED", "REFUTED", "REFUTED"] + ["not read"] * 4,
    ),
    "an exponential is multiplied, and no time by what moves": (
        [
            r"h=r(1-\mathrm e^{-\tau_1/\tau_2})",
            r"h=r(\lambda-\mathrm e^{-\tau_1/\tau_2})",
            r"\ddot x=\dot x(\tau_1+\cos\alpha)",
            r"\ddot x=\dot x(t+\mathrm e^\lambda)",
        ],
        ["DEFINITION", "not judged", "not read", "not read"],
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_a_bracket_behind_a_letter(name: str) -> None:
    equations, expected = CASES[name]
    assert outcomes(*equations, block=BLOCK) == expected
