"""Prints that are common on paper: parted thousands, degrees in brackets, numbers in two units."""

from __future__ import annotations

import pytest
from small_papers import outcomes

pytestmark = pytest.mark.usefixtures("judged_here")

TURN = r"s=r\sin\psi"
CASES = {
    "thousands are parted by thin spaces": (
        [
            r"60\,000=6\cdot10^4",
            r"60\,000=6\cdot10^5",
            r"1\,234\,567=1234567",
            r"n=1\,23",
            r"n=1\,2345",
            "n=60 000",
        ],
        ["PROVED", "REFUTED", "PROVED", "not read", "not read", "not read"],
    ),
    "a value is printed at an angle in degrees": (
        [TURN, r"s(90^\circ)=r", r"s(30^\circ)=\frac r2", r"s(90^\circ)=2r", r"r(90^\circ)=2r"],
        ["DEFINITION", "PROVED", "PROVED", "REFUTED", "not read"],
    ),
    "numbers in two units need no letter": (
        [
            r"85\,\%=0.85",
            r"85\,\%=8.5",
            r"1\,\mathrm{kN}=1000\,\mathrm N",
            r"1\,\mathrm{kN}=100\,\mathrm N",
            r"3\,\mathrm{mm}=3",
            r"3\,\mathrm{mm}>3",
        ],
        ["PROVED", "REFUTED", "PROVED", "REFUTED", "not judged", "not read"],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_printed_so(name: str) -> None:
    equations, expected = CASES[name]
    assert outcomes(*equations, block="%% where m>0\n") == expected
