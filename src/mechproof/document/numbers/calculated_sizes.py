r"""Calculations with units, `\frac{5\,\mathrm{kN}}{20\,\mathrm{mm^2}}`: worked out, in SI.

A member with units and without letters is the size that it evaluates to. When it is compared with
a number or another calculation, rounded decimals make it a range. Sizes that the block declares are
exact, as is a member exactly equal to an exact one before it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.document.numbers.scales import RoundedSize, has_sixty, spread
from mechproof.document.tasks import Sign
from mechproof.latex import ReadingError
from mechproof.latex.measures import is_number
from mechproof.latex.reader import Print
from mechproof.latex.tree import Calculated, Chain, Letter, Measure, Node, Number, exchange, walk
from mechproof.nomenclature.cells import Numeral
from mechproof.record import FREQUENCY, NUMBER
from mechproof.record.parts import ENDLESS
from mechproof.record.unit_notation import ONE, REVOLUTIONS, Unit, name_in_si, read_unit, weigh_unit
from mechproof.statement_domains.dimension_inference import DimensionError, infer

_IN_SI = "Print it in an SI unit or a multiple of one: K for °C, rad/s for 1/min."
# Unit of speeds that count revolutions.
_MINUTE = "1/min"
Span = tuple[float, float] | None


def calculate_sizes(read: Print, bare: Collection[sp.Basic]) -> Print:
    """Put in the sizes that members calculate; raises `ReadingError` for mixed units.

    `bare` are letters without a declared unit.
    """

    def settle(chain: Chain) -> Chain:
        members = tuple(_calculate(read, node, bare) for node in chain.members)
        return replace(chain, members=members)

    return replace(read, chains=tuple(map(settle, read.chains)))


def _calculate(read: Print, member: Node, bare: Collection[sp.Basic]) -> Node:
    sizes = [node for node in walk(member) if isinstance(node, Measure)]
    if not sizes or is_number(member):
        return member
    first = sizes[0]
    if any(isinstance(node, Letter) for node in walk(member)):
        _refuse_bare(read, first, bare)
        return member
    try:
        value, given, unit = _work_out(read, member)
    except DimensionError as error:
        reason = f"units that do not fit together: {error}".replace("_", "")
        raise read.source.refuse(first.start, reason) from error
    number = value.xreplace({name: size.value for name, size in given.items()})
    if not (number.is_real and number.is_finite):
        raise read.source.refuse(first.start, "a calculation whose result is not a real number")
    return Calculated(member, number, unit, start=member.start, end=member.end)


def _refuse_bare(read: Print, first: Measure, bare: Collection[sp.Basic]) -> None:
    """Refuse a number with a unit next to letters if one has none, or if the unit is not of SI."""
    letters = (node for node in walk(read.chains) if isinstance(node, Letter))
    without = next((letter.text for letter in letters if letter.symbol in bare), "")
    if without or weigh_unit(first.unit) is None:
        raise read.source.refuse(
            first.start,
            f"a number with a unit, {first.unit}, next to letters",
            f"Declare the unit of {without}." if without else _IN_SI,
        )


def find_span(read: Print, member: Node, exact: Collection[sp.Expr]) -> tuple[float, float] | None:
    """Return the range of a calculation with rounded decimals, or None if it has none.

    If all its rounded sizes are among the `exact` ones, the calculation is exact and has no range.
    """
    member = member.of if isinstance(member, Calculated) else member
    if is_number(member) or any(isinstance(node, Letter) for node in walk(member)):
        return None
    try:
        value, sizes, _ = _work_out(read, member)
    except (ReadingError, DimensionError):
        # A decimal stands where a name must not.
        return None
    if all(size.value in exact for size in sizes.values() if size.half):
        return None
    with suppress(NotImplementedError):
        found = balls.evaluate(value, {name: spread(size) for name, size in sizes.items()})
        return (float(found.lower()), float(found.upper())) if found.is_finite() else None
    return None


def _work_out(read: Print, member: Node) -> tuple[sp.Expr, dict[sp.Basic, RoundedSize], str]:
    """Return a member as an expression in named sizes and decimals, these sizes, and its unit."""
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

    def name(node: Node) -> Node | None:
        symbol = names.get(node) if isinstance(node, Measure | Number) else None
        return symbol and Letter(symbol, str(symbol), start=node.start, end=node.end)

    value = read.meaning().of(exchange(member, name))
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
    """Return the scales of a calculation's units in the unit of its result, and that unit.

    Revolutions per minute count as turns per second; if they are the only unit, the result has it,
    too.
    """
    # Zero has any dimension, and is taken as a number.
    dimension = infer(value, {name: unit.dimension for name, unit in units.items()}) or NUMBER
    if any(power != int(power) for power in dimension.powers):
        raise DimensionError(f"a root of {dimension}")
    scales = {name: unit.scale for name, unit in units.items()}
    turning = {name for name, scale in scales.items() if scale == REVOLUTIONS}
    others = {name for name, unit in units.items() if unit != ONE} - turning
    if turning and dimension == FREQUENCY and not (others or value.has(sp.pi)):
        return scales | dict.fromkeys(turning, sp.S.One), _MINUTE
    if turning and value.has(sp.pi) and has_sixty(value):
        raise DimensionError("revolutions per minute: converted to radians, or not?")
    return scales | dict.fromkeys(turning, sp.Rational(1, 60)), name_in_si(dimension)


def _find_digits(node: Measure | Number) -> str:
    return node.number.text if isinstance(node, Measure) else node.text


def _show(node: Measure | Number) -> str:
    return f"{_find_digits(node)} {node.unit if isinstance(node, Measure) else ''}".strip()


def add_calculations(
    read: Print, chain: Chain, signs: Sequence[Sign], exact: Collection[sp.Expr]
) -> list[Sign]:
    """Return the signs of a chain, with formulas and ranges for those next to calculations."""
    spans = [*_find_spans(read, chain, signs, exact)]
    beside = zip(signs, [None, *signs[:-1]], pairwise(chain.members), pairwise(spans), strict=True)
    return [_add_calculation(*one) for one in beside]


def _find_spans(
    read: Print, chain: Chain, signs: Sequence[Sign], exact: Collection[sp.Expr]
) -> Iterator[Span]:
    last: Span = None
    # A sign that defines a letter has no sides, but the one after it has.
    left = [*(sign.sides[0] for sign in signs), None]
    right = [None, *(sign.sides[1] for sign in signs)]
    sides = [one if other is None else other for one, other in zip(left, right, strict=True)]
    for node, side, other in zip(chain.members, sides, [None, *sides[:-1]], strict=True):
        is_same = _is_calculated(side) and _is_calculated(other)
        is_same = is_same and balls.evaluate(side - other, {}).contains(0)
        if not (is_same and last is None):
            last = find_span(read, node, exact) if _is_calculated(side) else None
        yield last


def _is_calculated(side: Any) -> bool:
    """Return whether a side is a number that can be evaluated directly."""
    if not isinstance(side, sp.Expr) or side.is_Matrix or side.free_symbols or side.has(*ENDLESS):
        return False
    with suppress(NotImplementedError):
        return bool(balls.evaluate(side, {}).is_finite())
    return False


def _add_calculation(
    sign: Sign, before: Sign | None, nodes: tuple[Node, ...], spans: tuple[Span, Span]
) -> Sign:
    """Return a sign next to a calculation, with the formula before it and its range."""
    if not sign.number and all(map(_is_calculated, sign.sides)):
        units = {node.unit if isinstance(node, Calculated) else "" for node in nodes}
        span = _subtract(sign.sides, spans)
        return replace(sign, span=span, is_calculated=True) if len(units) == 1 else sign
    if not (sign.number and isinstance(sign.value, sp.Expr)) or sign.value.free_symbols:
        return sign
    place = int(sign.sides[0] is not sign.value)
    if is_number(nodes[place]) and not isinstance(nodes[place], Calculated):
        return sign
    first = before and (before.letter if before.sides[0] is None else before.sides[0])
    has_letters = isinstance(first, sp.Expr) and first.free_symbols
    formula = first if has_letters else None
    return replace(sign, formula=formula, span=spans[place], is_calculated=True)


def _subtract(sides: tuple[sp.Expr, sp.Expr], spans: tuple[Span, Span]) -> Span:
    values = [float(sp.N(side)) if side.is_real else 0.0 for side in sides]
    (low, high), (least, most) = (
        span or (value, value) for span, value in zip(spans, values, strict=True)
    )
    return low - most, high - least
