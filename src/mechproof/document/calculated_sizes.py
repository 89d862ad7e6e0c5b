r"""Calculations with units, `\frac{5\,\mathrm{kN}}{20\,\mathrm{mm^2}}`: worked out, in SI.

A member that has numbers with units and no letter is the size that it gives.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.cells import Numeral
from mechproof.document.scales import RoundedSize, has_sixty, spread
from mechproof.document.units import ONE, REVOLUTIONS, Unit, name_in_si, read_unit
from mechproof.latex import ReadingError
from mechproof.latex.measures import is_number
from mechproof.latex.reader import Print
from mechproof.latex.tree import Calculated, Chain, Letter, Measure, Node, Number, walk
from mechproof.proof.dimensions import DimensionError, infer
from mechproof.record import FREQUENCY, NUMBER

# In which revolutions are counted.
_MINUTE = "1/min"


def calculate_sizes(read: Print) -> Print:
    """Put in the sizes that members calculate; `ReadingError` for what mixes units."""

    def settle(chain: Chain) -> Chain:
        return replace(chain, members=tuple(_calculate(read, node) for node in chain.members))

    return replace(read, chains=tuple(map(settle, read.chains)))


def _calculate(read: Print, member: Node) -> Node:
    sizes = [node for node in walk(member) if isinstance(node, Measure)]
    if not sizes or is_number(member):
        return member
    first = sizes[0]
    if any(isinstance(node, Letter) for node in walk(member)):
        raise read.source.refuse(
            first.start,
            f"a number with a unit, {first.unit}, beside letters",
            "Print the number alone, in the unit of the letters.",
        )
    try:
        value, given, unit = _work_out(read, member)
    except DimensionError as error:
        reason = f"units that do not fit together: {error}".replace("_", "")
        raise read.source.refuse(first.start, reason) from error
    number = value.xreplace({name: size.value for name, size in given.items()})
    if not (number.is_real and number.is_finite):
        raise read.source.refuse(first.start, "a calculation that gives no real number")
    return Calculated(member, number, unit, start=member.start, end=member.end)


def find_span(read: Print, member: Node) -> tuple[float, float] | None:
    """Return between what a calculation lies whose decimals are rounded, None if it has none."""
    member = member.of if isinstance(member, Calculated) else member
    if is_number(member) or any(isinstance(node, Letter) for node in walk(member)):
        return None
    try:
        value, sizes, _ = _work_out(read, member)
    except (ReadingError, DimensionError):
        # Where one of its decimals stands, no name may.
        return None
    found = balls.evaluate(value, {name: spread(size) for name, size in sizes.items()})
    rounded = any(size.half for size in sizes.values())
    return (float(found.lower()), float(found.upper())) if rounded and found.is_finite() else None


def _work_out(read: Print, member: Node) -> tuple[sp.Expr, dict[sp.Basic, RoundedSize], str]:
    """Return what a member calculates of names for its sizes and decimals, these, and its unit."""
    found = [node for node in walk(member) if isinstance(node, Measure | Number)]
    inside = {node.number for node in found if isinstance(node, Measure)}
    names = {
        node: sp.Dummy(_show(node), positive=True)
        for node in found
        if isinstance(node, Measure) or ("." in node.text and node not in inside)
    }
    units = {
        name: read_unit(node.unit) if isinstance(node, Measure) else ONE
        for node, name in names.items()
    }
    value = read.meaning().of(_replace(member, names))
    scales, unit = _find_scales(value, units)
    sizes = {}
    for node, name in names.items():
        number = Numeral(_find_digits(node), sp.S.One)
        half = number.half_place * scales[name] if number.is_decimal else sp.S.Zero
        sizes[name] = RoundedSize(number.value * scales[name], half)
    return value, sizes, unit


def _find_scales(
    value: sp.Expr, units: Mapping[sp.Basic, Unit]
) -> tuple[dict[sp.Basic, sp.Expr], str]:
    """Return how large the units of a calculation are in that of its result, and this.

    Revolutions by the minute are turns; alone they are what they are in the result.
    """
    # Nothing is of any dimension.
    dimension = infer(value, {name: unit.dimension for name, unit in units.items()}) or NUMBER
    if any(power != int(power) for power in dimension.powers):
        raise DimensionError(f"a root of {dimension}")
    scales = {name: unit.scale for name, unit in units.items()}
    turning = {name for name, scale in scales.items() if scale == REVOLUTIONS}
    others = {name for name, unit in units.items() if unit != ONE} - turning
    if turning and dimension == FREQUENCY and not (others or value.has(sp.pi)):
        return scales | dict.fromkeys(turning, sp.S.One), _MINUTE
    if turning and value.has(sp.pi) and has_sixty(value):
        raise DimensionError("revolutions by the minute, which are turned or not")
    return scales | dict.fromkeys(turning, sp.Rational(1, 60)), name_in_si(dimension)


def _find_digits(node: Measure | Number) -> str:
    return node.number.text if isinstance(node, Measure) else node.text


def _show(node: Measure | Number) -> str:
    return f"{_find_digits(node)} {node.unit if isinstance(node, Measure) else ''}".strip()


def _replace(part: Any, names: Mapping[Any, sp.Dummy]) -> Any:
    """Return a part of a print with names for some of its nodes."""
    if isinstance(part, Node) and part in names:
        return Letter(names[part], str(names[part]), start=part.start, end=part.end)
    if isinstance(part, Node):
        return replace(part, **{f.name: _replace(vars(part)[f.name], names) for f in fields(part)})
    return tuple(_replace(one, names) for one in part) if isinstance(part, tuple) else part
