"""Numbers in the text of evidence are also given as numbers for further computation."""

from __future__ import annotations

import math

import pytest

from mechproof.proof.verdict import describe_number, read_number


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("1.25", {"value": 1.25}),
        ("-19/40", {"value": -0.475}),
        ("0.5 (28.6°)", {"value": 0.5}),
        ("pi", {"value": math.pi}),
        ("-pi/9 (-20°)", {"value": -math.pi / 9}),
        ("19*pi/180 (19°)", {"value": 19 / 180 * math.pi}),
        ("[1.5 +/- 2.01e-9]", {"value": 1.5, "radius": 2.01e-9}),
        ("[-3.0e-7 +/- 1e-20] (0.2°)", {"value": -3.0e-7, "radius": 1e-20}),
    ],
)
def test_numbers_are_read(text: str, found: dict[str, float]) -> None:
    assert read_number(text) == pytest.approx(found, rel=1e-15)
    assert describe_number(text)["text"] == text


@pytest.mark.parametrize(
    "text", ["", "2, the difference is 9", "inf", "nan", "[x +/- 1]", "1/0", "e9"]
)
def test_what_is_no_number_is_text_only(text: str) -> None:
    assert read_number(text) == {}
