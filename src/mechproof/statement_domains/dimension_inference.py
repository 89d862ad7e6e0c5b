"""Physical dimensions of an expression, and the change of units that shows a mixture.

The dimension of each subexpression is inferred, like types of units in programs (Kennedy 1996); if
terms of unlike dimension are added, the witness is a change of a unit after which the two sides no
longer scale alike.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import repeat

import sympy as sp
from sympy.logic.boolalg import Boolean
from sympy.matrices.expressions.matexpr import MatrixElement

from mechproof.record import ANGLE, NUMBER, Dimension, Paper, RecordError, ValueWhere, family_of
from mechproof.record.implicit import Implicit
from mechproof.record.memory import remember_last

Dimensions = Mapping[sp.Basic, Dimension]
_OF_ANGLES = (sp.atan, sp.asin, sp.acos, sp.acot, sp.atan2)


class DimensionError(ValueError):
    """Terms of unlike dimension are added, compared or put into a function of a number."""


class _OfPaper(dict[sp.Basic, Dimension]):
    """The dimensions of a paper's symbols, and those inferred from these alone."""

    def __init__(self, known: Dimensions) -> None:
        super().__init__(known)
        self.inferred: dict[sp.Basic, Dimension | None] = {}


@remember_last(8)
def dimensions_of(paper: Paper) -> Dimensions:
    """Return the dimension of every symbol of the paper."""
    known = {variable.symbol: variable.dimension for variable in paper.variables}
    matrices = [symbol for symbol in known if isinstance(symbol, sp.MatrixSymbol)]
    return _OfPaper(known | {family_of(symbol): known[symbol] for symbol in matrices})


def check_derived(paper: Paper) -> None:
    """Raise `RecordError` for a derived value whose dimension differs from its symbol's.

    Values with undeclared letters, whose dimensions are not known, are not checked.
    """
    known = dimensions_of(paper)
    derived = [(row.number, row.derived) for row in paper.rows]
    derived += [(row.number, link.derived) for row in paper.rows for link in row.links.values()]
    for number, values in derived:
        for symbol, value in values.items():
            try:
                if value.free_symbols <= known.keys():
                    infer_common((symbol, value), known)
            except DimensionError as error:
                raise RecordError(f"row {number!r}: derived: {error}") from error


def is_angle(sides: tuple[sp.Basic, ...], known: Dimensions) -> bool:
    """Return whether the sides of a statement are angles."""
    try:
        found = [infer(side, known) for side in sides]
        _common(sides, known)
    except DimensionError:
        return False
    return any(dimension is not None and dimension.is_angle for dimension in found)


def infer(expression: sp.Basic, known: Dimensions) -> Dimension | None:
    """Return the dimension, or None for zero (which has every dimension).

    Raises `DimensionError` naming the terms that do not fit.
    """
    if not isinstance(known, _OfPaper):
        return _infer(expression, known)
    if expression not in known.inferred:
        known.inferred[expression] = _infer(expression, known)
    return known.inferred[expression]


def _infer(expression: sp.Basic, known: Dimensions) -> Dimension | None:
    if expression.is_number:
        return None if expression == 0 else NUMBER
    if isinstance(expression, sp.Indexed):
        return known.get(expression.base, NUMBER)
    if expression.is_Symbol:
        return known.get(expression, NUMBER)
    if isinstance(expression, MatrixElement):
        return known.get(expression.parent, NUMBER)
    if isinstance(expression, sp.Add):
        return _common(expression.args, known)
    if isinstance(expression, sp.Mul):
        return _product(expression.args, known)
    if isinstance(expression, sp.Pow):
        return _power(expression, known)
    if isinstance(expression, sp.Sum | sp.Integral):
        return _of_sum_or_integral(expression, known)
    if isinstance(expression, Implicit):
        return _of_root(expression, known)
    if isinstance(expression, sp.Piecewise):
        return _of_pieces(expression, known)
    if isinstance(expression, sp.core.relational.Relational):
        _common(expression.args, known)
        return NUMBER
    if isinstance(expression, Boolean):
        for part in expression.args:
            infer(part, known)
        return NUMBER
    if isinstance(expression, sp.Limit):
        return _of_limit(expression, known)
    if isinstance(expression, ValueWhere):
        return infer(expression.args[0], known)
    if isinstance(expression, sp.sign):
        infer(expression.args[0], known)
        return NUMBER
    if isinstance(expression, sp.Abs | sp.Max | sp.Min | sp.atan2 | sp.MatrixBase):
        common = _common(tuple(expression) if expression.is_Matrix else expression.args, known)
        return ANGLE if isinstance(expression, sp.atan2) else common
    return _of_function(expression, known)


def infer_common(sides: tuple[sp.Basic, ...], known: Dimensions) -> Dimension | None:
    """Return the dimension of the sides of a statement, for matrices entry by entry."""
    if any(getattr(side, "is_Matrix", False) for side in sides):
        shown = (s.as_explicit() if isinstance(s, sp.MatrixExpr) else s for s in sides)
        entries = zip(*(s if s.is_Matrix else repeat(s) for s in shown), strict=False)
        first, *_ = [_common(pair, known) for pair in entries]
        return first
    return _common(sides, known)


def rescale(expression: sp.Basic, known: Dimensions, unit: str, factor: int) -> sp.Basic:
    """Express every quantity in a `unit` (length, mass, ...) that is `factor` times smaller."""
    symbols = {s: known.get(s, NUMBER) for s in expression.free_symbols if s.is_Symbol}
    indexed = {i: known.get(i.base, NUMBER) for i in expression.atoms(sp.Indexed)}
    scaled = {
        symbol: symbol * sp.Integer(factor) ** sp.Rational(power)
        for symbol, dimension in (symbols | indexed).items()
        if (power := getattr(dimension, unit))
    }
    return expression.subs(scaled, simultaneous=True)


def _common(parts: tuple[sp.Basic, ...], known: Dimensions) -> Dimension | None:
    result: Dimension | None = None
    first: sp.Basic | None = None
    for part in parts:
        found = infer(part, known)
        if found is None:
            continue
        if result is not None and found != result:
            raise DimensionError(f"{first} has dimension {result} but {part} has {found}")
        first = first if first is not None else part
        result = found if result is None else _as_terms(first, result, part, found)
    return result


def _as_terms(one: sp.Basic, of_one: Dimension, other: sp.Basic, of_other: Dimension) -> Dimension:
    """Return the dimension of two added terms: angle plus constant is an angle, plus sine is not.

    Once sizes have been put in, the rest of a length may be such a mixture.
    """
    if of_one.angle == of_other.angle or other.is_number:
        return of_one
    return of_other if one.is_number else replace(of_one, angle=0)


def _product(parts: tuple[sp.Basic, ...], known: Dimensions) -> Dimension | None:
    result = NUMBER
    for part in parts:
        found = infer(part, known)
        if found is None:
            return None
        result = result * found
    return result


def _power(node: sp.Pow, known: Dimensions) -> Dimension | None:
    base = infer(node.base, known)
    if base is None or base == NUMBER:
        _require_number(node.exp, known, node)
    if base is not None and node.exp.is_Rational:
        return base ** Fraction(int(node.exp.p), int(node.exp.q))
    if base is not None and base != NUMBER:
        raise DimensionError(f"{node.base} has dimension {base} and the exponent {node.exp}")
    return base and NUMBER


def _of_sum_or_integral(node: sp.Basic, known: Dimensions) -> Dimension | None:
    if isinstance(node, sp.Integral) and any(len({*ends}) < len(ends) for _, *ends in node.limits):
        # Zero, as both limits are the same; zero fits every dimension.
        return None
    result = infer(node.function, _with_bound(node, known))
    if isinstance(node, sp.Sum) or result is None:
        return result
    for _, *limits in node.limits:
        result = result * (_common(tuple(limits), known) or NUMBER)
    return result


def _of_root(node: Implicit, known: Dimensions) -> Dimension | None:
    result = _common((*node.ends, node.start), known)
    infer(node.function, {**known, node.unknown: result or NUMBER})
    return result


def _of_limit(node: sp.Limit, known: Dimensions) -> Dimension | None:
    """Return the dimension of a limit, trying known dimensions for its letter.

    The letter may tend to zero, which has every dimension.
    """
    body, variable, point, _ = node.args
    own = None if point.is_infinite else infer(point, known)
    for dimension in dict.fromkeys((own or NUMBER, *([] if own else known.values()))):
        with suppress(DimensionError):
            return infer(body, {**known, variable: dimension})
    return infer(body, {**known, variable: own or NUMBER})


def _of_pieces(node: sp.Piecewise, known: Dimensions) -> Dimension | None:
    for _, condition in node.args:
        infer(condition, known)
    return _common(tuple(piece for piece, _ in node.args), known)


def _with_bound(node: sp.Basic, known: Dimensions) -> Dimensions:
    if isinstance(node, sp.Sum):
        return known
    bound = {v: _common(tuple(limits), known) or NUMBER for v, *limits in node.limits}
    return {**known, **bound}


def _of_function(node: sp.Basic, known: Dimensions) -> Dimension:
    for argument in node.args:
        _require_number(argument, known, node)
    return ANGLE if isinstance(node, _OF_ANGLES) else NUMBER


def _require_number(argument: sp.Basic, known: Dimensions, node: sp.Basic) -> None:
    found = infer(argument, known)
    if found not in (None, NUMBER):
        raise DimensionError(f"{argument} inside {node} has dimension {found}")
