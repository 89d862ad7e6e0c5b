"""Numbers equated to numbers: the same in another unit, or a rounding of an irrational one."""

from __future__ import annotations

import pytest
from small_papers import outcomes

from mechproof.document.checking import check

pytestmark = pytest.mark.usefixtures("judged_here")

NUMBERS = {
    r"0.85=85\,\%": "PROVED",
    r"0.85=0.85\,\%": "REFUTED",
    r"\frac{17}{20}=0.85\,\%": "REFUTED",
    r"20^\circ=0.349\,\mathrm{rad}": "PROVED",
    r"20^\circ=0.349^\circ": "REFUTED",
    r"\frac{360}{20}=18^\circ": "PROVED",
    r"\arctan0.5=26.57^\circ": "PROVED",
    # An irrational number equated to a number of many digits is taken as rounded.
    r"\frac{30\,000}{\pi}=9549": "PROVED",
    r"\frac{30\,000}{\pi}=9548": "REFUTED",
    r"\frac{30\,000}{\pi}\approx9550": "not judged",
    r"\frac{30\,000}{\pi}\approx9560": "REFUTED",
    r"\sqrt2=1": "REFUTED",
    r"\frac{199}2=100": "REFUTED",
}


@pytest.mark.parametrize("latex", NUMBERS)
def test_numbers_may_be_equal_to_numbers(latex: str) -> None:
    assert outcomes(latex) == [NUMBERS[latex]]


SPEED = r"""%% mechproof
%% n : speed [1/min]
%% \omega : speed [rad/s]
%% K : clearance [um]
%% sizes \omega=63.2456
%% end
"""
COUNTED = {
    r"n=\frac{30\omega}{\pi}=10.07\,\mathrm{s^{-1}}": "PROVED",
    r"n=\frac{30\omega}{\pi}=10.07\,\mathrm{rad/s}": "REFUTED",
    r"n=\frac{30\omega}{\pi}=604\,\mathrm{min^{-1}}": "PROVED",
    r"\omega=25\,\mathrm{s^{-1}}=25\,\mathrm{rad/s}": "PROVED",
    # For an angular velocity, s^-1 and rad/s are the same.
    r"\omega=25\,\mathrm{s^{-1}}=157.08\,\mathrm{rad/s}": "REFUTED",
    r"1500\,\mathrm{min^{-1}}=25\,\mathrm{s^{-1}}=157.08\,\mathrm{rad/s}": "PROVED",
    # Bare numbers may be in any unit.
    r"K=50.000-49.991=9\,\mathrm{\mu m}": "not judged",
    r"K=50.000-49.991=8\,\mathrm{\mu m}": "REFUTED",
}


@pytest.mark.parametrize("latex", COUNTED)
def test_turns_are_counted_by_the_minute_and_by_the_second(latex: str) -> None:
    assert check("paper.tex", rf"{SPEED}\[{latex}\]").rows[-1].outcome == COUNTED[latex]


TURNED = {
    r"h=6.6\,\mathrm{cm}=66\,\mathrm{mm}": "PROVED",
    r"h=66\,\mathrm{mm}=6.6\,\mathrm{cm}": "PROVED",
    r"h=6.6\,\mathrm{cm}=66": "PROVED",
    r"h=6.6\,\mathrm{cm}=0.66\,\mathrm{cm}": "REFUTED",
    r"h=5\,\mathrm{cm}=5\,\mathrm{mm}": "REFUTED",
    r"h=5\,\mathrm{cm}=5": "REFUTED",
    r"h=5\,\mathrm{cm}=50\,\mathrm{s}": "not judged",
    r"u=5\,\mathrm{cm}=50\,\mathrm{mm}": "PROVED",
    r"u=5\,\mathrm{cm}=5\,\mathrm{mm}": "REFUTED",
    r"u=5\,\mathrm{cm}=50": "not judged",
    r"\lambda=85\,\%=0.85": "PROVED",
    r"\lambda=0.85=85\%": "PROVED",
    r"\lambda=85\,\%=85": "REFUTED",
    r"u=85\,\%=0.85": "PROVED",
    r"u=20\,\mathrm{°C}=293\,\mathrm{K}": "not judged",
    # The number with fewer digits is the rounded one.
    r"u=3000\,\mathrm{rpm}=314\,\mathrm{rad/s}": "PROVED",
    r"u=314\,\mathrm{rad/s}=3000\,\mathrm{rpm}": "PROVED",
    r"u=314\,\mathrm{rad/s}=3010\,\mathrm{rpm}": "REFUTED",
    r"u=50\,\mathrm{Hz}=314\,\mathrm{rad/s}": "PROVED",
    r"u=52\,\mathrm{Hz}=314\,\mathrm{rad/s}": "REFUTED",
    r"u=0.12\,\mathrm{kN}=0.0001234\,\mathrm{MN}": "PROVED",
    r"\alpha=0.314\,\mathrm{rad}=18^\circ": "PROVED",
    r"\alpha=0.314\,\mathrm{rad}=19^\circ": "REFUTED",
}


@pytest.mark.slow
@pytest.mark.parametrize("latex", TURNED)
def test_a_number_may_be_printed_in_two_units(latex: str) -> None:
    assert outcomes(latex)[1:] == [TURNED[latex]]
