"""Witness text: a point and the values of two sides, written for a reader."""

from __future__ import annotations

import re

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.proof.verdict import Evidence
from mechproof.statement_domains.dimension_inference import DimensionError, infer_common, is_angle
from mechproof.statement_domains.domain import Domain, Point, sizes_of

# Longest expression, in characters, that a reason quotes.
LONGEST = 240
# Most decimals of a fraction that is written as a decimal number.
_MOST_DECIMALS = 6
_DIGITS = (6, 9, 12, 16, 24, 48)
# A bound variable of ours, the dummy `x_`, as SymPy prints it: `_x_`.
_BOUND = re.compile(r"(?<!\w)_(\\?\w+?)_(?!\w)")


def show_point(point: Point, domain: Domain) -> dict[str, str]:
    """Return the names and values of a point, angles in degrees too."""
    ordered = sorted(point.items(), key=lambda item: str(item[0]))
    return {str(s): _show_size(v, domain.dimension_of(s).is_angle) for s, v in ordered}


def describe(
    what: str,
    sides: tuple[sp.Basic, ...],
    values: tuple[balls.Ball, balls.Ball],
    point: Point,
    domain: Domain,
) -> Evidence:
    """Return the evidence of two values at a point, with the source of the point's sizes."""
    left, right = balls.show_apart(*values)
    dimension = _describe_dimension(sides, domain)
    if dimension == "angle":
        degrees = show_plainly(*(value * 180 / balls.to_ball(sp.pi) for value in values))
        left, right = (f"{b} ({d}°)" for b, d in zip((left, right), degrees, strict=True))
    told = f"{what}{_describe_sources(point, domain)}"
    return Evidence(told, show_point(point, domain), left, right, dimension)


def _describe_dimension(sides: tuple[sp.Basic, ...], domain: Domain) -> str:
    """Return the name of the dimension that both sides share, or "" if there is none."""
    if is_angle(sides, domain.dimensions):
        return "angle"
    try:
        found = infer_common(sides, domain.dimensions)
    except DimensionError:
        return ""
    return "" if found is None else str(found)


def name_bound(text: str) -> str:
    """Write bound variables in a text as they are printed."""
    return _BOUND.sub(r"\1", text)


def show_plainly(*values: balls.Ball) -> tuple[str, ...]:
    """Round balls to numbers without radii, with the fewest digits that distinguish them."""
    for digits in _DIGITS:
        texts = tuple(_round(value, digits) for value in values)
        if len(set(texts)) == len(texts):
            return texts
    return tuple(_round(value, _DIGITS[0]) for value in values)


def _round(value: balls.Ball, digits: int) -> str:
    text = str(value.mid().str(digits, radius=False))
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def _show_size(value: sp.Expr, angle: bool) -> str:
    text = _show_exactly(value)
    if not angle:
        return text
    degrees = sp.nsimplify(value * 180 / sp.pi) if value.is_Rational is False else None
    exact = degrees is not None and degrees.is_Rational
    (rounded,) = show_plainly(balls.to_ball(value) * 180 / balls.to_ball(sp.pi))
    return f"{text} ({_show_exactly(degrees) if exact else rounded}°)"


def _show_exactly(value: sp.Expr) -> str:
    """Write a fraction as a decimal number if that is short."""
    places = range(_MOST_DECIMALS + 1)
    ends = next((p for p in places if (value * 10**p).is_Integer), None) if value.is_Rational else 0
    return str(value) if not ends else f"{sp.Integer(value * 10**ends) / 10**ends:.{ends}f}"


def _describe_sources(point: Point, domain: Domain) -> str:
    """Write which values of a point the paper has published, and which are chosen here."""
    for published in domain.published:
        met = {s: v for s, v in sizes_of(published).items() if s in point}
        if met and all(point[s] == v for s, v in met.items()):
            chosen = ", ".join(sorted(str(s) for s in point.keys() - met.keys()))
            return f", sizes of {published.source}" + (f"; chosen: {chosen}" if chosen else "")
    return ", all values chosen" if point and domain.published else ""


def clip(text: str) -> str:
    """Return a text that quotes an expression, cut to at most `LONGEST` characters."""
    text = name_bound(text)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 4]} ..."
