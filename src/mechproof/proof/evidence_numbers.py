"""Numbers in the text of evidence: "pi/9 (20°)" and balls in, doubles for who computes on out."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from fractions import Fraction

BALL = re.compile(r"\[(\S+) \+/- (\S+)\]")
# A multiple of pi: 19*pi/180.
TURN = re.compile(r"(-?)(?:(\d+)\*)?pi(?:/(\d+))?")


def read_number(text: str) -> Mapping[str, float]:
    """Return value and, of a ball, radius; nothing of a text that is no number.

    What stands in round brackets behind the number is said of it, as its degrees.
    """
    number = text.partition(" (")[0]
    if ball := BALL.fullmatch(number):
        return _keep_finite({"value": ball[1], "radius": ball[2]})
    if turn := TURN.fullmatch(number):
        factor = Fraction(int(turn[2] or 1), int(turn[3] or 1)) * (-1 if turn[1] else 1)
        return {"value": float(factor) * math.pi}
    return _keep_finite({"value": number})


def describe_number(text: str) -> dict[str, object]:
    """Return a text with its number."""
    return {"text": text, **read_number(text)}


def _keep_finite(texts: Mapping[str, str]) -> Mapping[str, float]:
    try:
        found = {name: float(Fraction(text)) for name, text in texts.items()}
    except (ValueError, OverflowError, ZeroDivisionError):
        return {}
    return found
