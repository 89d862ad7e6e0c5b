r"""Numbers with a unit beside an inequality, `F<5\,\mathrm{kN}`, in the unit of the other side.

Angles are radians. Nothing is said of letters whose units are not declared.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from mechproof.document.known import Known
from mechproof.document.numbers.scales import Scales, may_turn_units
from mechproof.document.tasks import Sign
from mechproof.record import FREQUENCY, NUMBER, Holds, Row
from mechproof.record.unit_notation import UNITS, Unit, read_unit, weigh
from mechproof.statement_domains.dimension_inference import DimensionError, infer

_BARE = "a unit, {}, but none is declared for {}"
_MISFIT = "the unit {} has dimension {}, the other side {}"
_MIXED = "what is {} {} in the units of the letters of the other side is not known"
_TURNED = "turns, or radians? the unit {} and the other side do not say it"
_ZERO = "{} and the other side count from different zeros"


class _LimitError(ValueError):
    """A number that is not known in the unit of the other side."""


def state_limit(row: Row, sign: Sign, known: Known) -> Row | str:
    """State an inequality whose sides are numbers in one unit, or say why it is not judged."""
    if not (any(sign.units) and isinstance(row.says, Holds)):
        return row
    one, other = sign.limited
    unit, second = sign.units
    try:
        if second:
            meant = read_unit(unit) if unit else _find_unit(one, other, second, known)
            other = _turn(other, second, meant)
        else:
            one = _turn(one, unit, _find_unit(other, one, unit, known))
    except _LimitError as error:
        return str(error)
    return replace(row, says=Holds(row.says.relation.func(one, other, evaluate=False)))


def _find_unit(side: sp.Expr, number: sp.Expr, unit: str, known: Known) -> Unit:
    """Return in which unit a formula of numbers in the units of their letters is a number."""
    settled = known.settle(side)
    formula = settled if settled.free_symbols else side
    letters = (side + formula).free_symbols
    found = {s: known.symbols.find_dimension(s) for s in letters}
    told = {s: dimension for s, dimension in found.items() if dimension is not None}
    if bare := sorted(str(s) for s in letters - told.keys()):
        raise _LimitError(_BARE.format(unit, ", ".join(bare)))
    scale, own = _find_scale(formula, known), _find_scale(side, known)
    try:
        dimension = infer(formula, told) or NUMBER
        if formula.free_symbols & {v.symbol for v in UNITS}:
            return Unit(dimension, 1 / weigh(dimension))
    except DimensionError:
        scale = None
    if scale is None or (scale != own and may_turn_units(formula)):
        raise _LimitError(_MIXED.format(number, unit))
    # Angles are radians in all formulas.
    return Unit(dimension, sp.S.One if dimension.is_angle else scale)


def _turn(number: sp.Expr, unit: str, meant: Unit) -> sp.Expr:
    """Return a number in another unit."""
    own = read_unit(unit)
    if own.dimension != meant.dimension:
        raise _LimitError(_MISFIT.format(unit, own.dimension, meant.dimension))
    if own.scale == meant.scale:
        return number
    if sp.nan in (own.scale, meant.scale):
        raise _LimitError(_ZERO.format(unit))
    if own.dimension == FREQUENCY and own.dimension.angle != meant.dimension.angle:
        raise _LimitError(_TURNED.format(unit))
    return number * own.scale / meant.scale


def _find_scale(formula: sp.Expr, known: Known) -> sp.Expr | None:
    """Return how large the unit of a formula is in SI; None if letters have units of their own."""
    names = {s: sp.Dummy(str(s), positive=True) for s in formula.free_symbols}
    plain, turned = (x.xreplace(names) for x in (formula, Scales(known.symbols).to_si(formula)))
    ratio = sp.simplify(turned / plain)
    return ratio if ratio.is_number else None
