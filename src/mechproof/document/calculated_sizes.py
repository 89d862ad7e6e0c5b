r"""Calculations with units, `\frac{5\,\mathrm{kN}}{20\,\mathrm{mm^2}}`: worked out, in SI.

A member that has numbers with units and no letter is the size that it gives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, replace
from typing import Any

import sympy as sp

from mechproof.document.units import REVOLUTIONS, Unit, name_in_si, read_unit
from mechproof.latex.measures import is_number
from mechproof.latex.reader import Print
from mechproof.latex.tree import Calculated, Chain, Letter, Measure, Node, walk
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
    names = {size: sp.Dummy(f"{size.number.text} {size.unit}", positive=True) for size in sizes}
    units = {name: read_unit(size.unit) for size, name in names.items()}
    value = read.meaning().of(_replace(member, lambda size: _name(size, names[size])))
    try:
        scales, unit = _find_scales(value, units)
    except DimensionError as error:
        reason = f"units that do not fit together: {error}".replace("_", "")
        raise read.source.refuse(first.start, reason) from error
    number = value.xreplace({n: sp.Rational(s.number.text) * scales[n] for s, n in names.items()})
    if not (number.is_real and number.is_finite):
        raise read.source.refuse(first.start, f"a calculation that gives no size, but {number}")
    return Calculated(member, number, unit, start=member.start, end=member.end)


def _find_scales(
    value: sp.Expr, units: Mapping[sp.Basic, Unit]
) -> tuple[dict[sp.Basic, sp.Expr], str]:
    """Return how large the units of a calculation are in that of its result, and this.

    Revolutions by the minute are turns beside pi; alone they are what they are in the result.
    """
    # Nothing is of any dimension.
    dimension = infer(value, {name: unit.dimension for name, unit in units.items()}) or NUMBER
    turning = {name for name, unit in units.items() if unit.scale == REVOLUTIONS}
    if dimension == FREQUENCY and turning == units.keys() and not value.has(sp.pi):
        return dict.fromkeys(units, sp.S.One), _MINUTE
    if turning and not value.has(sp.pi):
        raise DimensionError("revolutions by the minute beside others, as turns or as radians?")
    turns = dict.fromkeys(turning, sp.Rational(1, 60))
    return {name: unit.scale for name, unit in units.items()} | turns, name_in_si(dimension)


def _name(size: Measure, name: sp.Dummy) -> Letter:
    return Letter(name, size.unit, start=size.start, end=size.end)


def _replace(part: Any, change: Callable[[Measure], Node]) -> Any:
    """Return a part of a print with other nodes instead of numbers with a unit."""
    if isinstance(part, Measure):
        return change(part)
    if isinstance(part, Node):
        return replace(part, **{f.name: _replace(vars(part)[f.name], change) for f in fields(part)})
    return tuple(_replace(one, change) for one in part) if isinstance(part, tuple) else part
