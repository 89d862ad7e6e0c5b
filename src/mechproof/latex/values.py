"""Values of symbols defined by others: what depends on what, and substitution.

A letter declared to depend on others must not be taken as fixed if it has no value. For values by
pieces, the ends of the pieces are listed, and whether adjacent pieces agree there.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import partial
from itertools import count, pairwise
from typing import TYPE_CHECKING, Any

import sympy as sp
from sympy.core.relational import Relational

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning

Values = Mapping[sp.Basic, sp.Basic]
Moving = Mapping[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]]
# Functions with kinks or steps, for which SymPy gives a derivative everywhere; the first two have
# one wherever their argument is not zero.
OF_SIGNS = (sp.Abs, sp.sign)
UNSMOOTH = (sp.Max, sp.Min, sp.Piecewise, sp.floor, sp.ceiling, sp.atan2)
# Replacements for angles with whole numbers n: SymPy 1.14 takes tan(x + pi*(n + 1/2)) for tan(x).
QUOTIENTS: Mapping[Any, Callable[[sp.Expr], sp.Expr]] = {
    sp.tan: lambda angle: sp.sin(angle) / sp.cos(angle),
    sp.cot: lambda angle: sp.cos(angle) / sp.sin(angle),
}
_ORDERS = (sp.Lt, sp.Le, sp.Gt, sp.Ge)


def depends(symbol: sp.Basic, on: Collection[sp.Basic], values: Values) -> bool:
    """Return whether a symbol is one of `on`, or its value depends on one."""
    return not list_reached({symbol}, values).isdisjoint(on)


def list_reached(symbols: Collection[sp.Basic], values: Values) -> set[sp.Basic]:
    """Return the symbols and all those on which their values depend."""
    met, new = set[sp.Basic](), set(symbols)
    while new:
        met |= new
        given = (values.get(symbol) for symbol in new)
        new = {s for one in given if one is not None for s in one.free_symbols} - met
    return met


def settle_all(expression: Any, values: Values) -> Any:
    """Put in all given values, also those inside values."""
    for _ in range(len(values) + 1):
        if not expression.free_symbols & values.keys():
            break
        expression = expression.xreplace(dict(values))
    return expression


def find_ratio(one: sp.Expr, other: sp.Expr) -> float | None:
    """Return the ratio of two sides if it is equal at two points, within double precision."""
    letters = sorted(one.free_symbols | other.free_symbols, key=str)
    ratios = []
    for step in (3, 5):
        values = {s: sp.Rational(7 * n + step, 13) for n, s in enumerate(letters)}
        above, below = (side.xreplace(values).evalf() for side in (one, other))
        if not (above.is_Float and below.is_Float) or below == 0:
            return None
        ratios.append(float(above / below))
    return ratios[0] if abs(ratios[0] - ratios[1]) <= 1e-9 * abs(ratios[0]) else None


def has_counts(value: sp.Basic) -> bool:
    """Return whether an expression contains integer symbols."""
    return any(symbol.is_integer for symbol in value.free_symbols)


def split_tangents(expression: Any, put_in: Iterable[sp.Basic]) -> Any:
    """Return the expression with tangents as quotients if `put_in` contains integer symbols.

    Such values can then be put in safely.
    """
    if any(map(has_counts, put_in)):
        for tangent, quotient in QUOTIENTS.items():
            expression = expression.replace(tangent, quotient)
    return expression


def settle(expression: Any, values: Values, changed: Values) -> Any:
    """Put in new values, also for symbols hidden in the values of others."""
    for _ in range(len(values) + 1):
        hidden = {
            symbol: values[symbol]
            for symbol in expression.free_symbols - changed.keys()
            if symbol in values and depends(symbol, changed.keys(), values)
        }
        if not hidden:
            return split_tangents(expression, changed.values()).xreplace(dict(changed))
        expression = expression.xreplace(hidden)
    raise ValueError(f"symbols are defined in terms of each other: {sorted(map(str, hidden))}")


def list_steps(by: sp.Basic, moving: Moving) -> Iterator[tuple[tuple[sp.Basic, ...], sp.Basic]]:
    """Yield letters that move with another, each with its derivatives and their common factor.

    The factor is one, or the rate of the letter they depend on if that itself depends on `by`.
    """
    for symbol, (other, rates) in moving.items():
        carrier, speeds = moving.get(other, (None, ()))
        if by in (other, carrier):
            yield (symbol, *rates), sp.S.One if other == by else speeds[0]


def differentiate(value: Any, by: sp.Basic, moving: Moving) -> Any:
    """Return the derivative of a value by a letter, also through the letters that depend on it.

    Raises `ValueError` for a derivative of higher order than the letters have symbols for.
    """
    total = value.diff(by)
    met = value.free_symbols
    for steps, speed in list_steps(by, moving):
        for one, derivative in pairwise(steps):
            if one in met:
                total += value.diff(one) * derivative * speed
        if steps[-1] in met:
            raise ValueError(f"no symbol is declared for the derivative of {steps[-1]} by {by}")
    # SymPy writes x^(a - 1) as x^a/x, which has no value at zero for any a.
    return total.replace(_is_power_product, partial(sp.powsimp, combine="exp"))


def _is_power_product(node: sp.Basic) -> bool:
    return isinstance(node, sp.Mul) and any(
        isinstance(factor, sp.Pow) and factor.exp.free_symbols for factor in node.args
    )


def is_root(part: sp.Expr) -> bool:
    """Return whether an expression is a root."""
    return isinstance(part, sp.Pow) and bool(part.exp.is_positive and not part.exp.is_integer)


def name_turns(expression: sp.Expr) -> sp.Expr:
    """Replace powers of negative numbers by real symbols: SymPy takes some for imaginary."""
    powers = (p for p in expression.atoms(sp.Pow) if p.base.is_negative and p.exp.free_symbols)
    return expression.xreplace({power: sp.Dummy("turn", real=True) for power in powers})


def make_running(name: str, inside: Any, *, counts: bool = False) -> sp.Dummy:
    """Return a bound variable that `inside` does not contain, the same one at each reading."""
    met, kind = inside.atoms(sp.Dummy), {"integer": True} if counts else {"real": True}
    numbered = (sp.Dummy(f"{name}_", dummy_index=n, **kind) for n in count())
    return next(dummy for dummy in numbered if dummy not in met)


def refuse_unknown(meaning: Meaning, place: int, said: tuple[Any, str], by: sp.Basic) -> None:
    """Refuse a term with a letter that depends on another but has no value."""
    term, where = said
    if unknown := _list_unknown(meaning, term, list_moving(by, meaning.moving)):
        told = "depends on {}, but is" if len(unknown) == 1 else "depend on {}, but are"
        raise meaning.source.refuse(
            place,
            f"{', '.join(unknown)} {where} {told.format(by)} not printed",
            "Declare in the block of letters its value, let name=value, or that it is constant.",
        )


def list_carried(meaning: Meaning, term: Any, by: sp.Basic) -> list[str]:
    """Return the letters of a term that have no value but depend on the carrier of `by`."""
    carrier = _find_carrier(by, meaning.moving)
    beside = {carrier} | list_moving(carrier, meaning.moving)
    return _list_unknown(meaning, term, beside) if by in beside - {carrier} else []


def _list_unknown(meaning: Meaning, term: Any, moving: set[sp.Basic]) -> list[str]:
    known = meaning.values.keys()
    return sorted(map(str, list_reached(term.free_symbols, meaning.values) & moving - known))


def list_moving(by: sp.Basic, moving: Moving) -> set[sp.Basic]:
    """Return the letters that depend on another, also indirectly, and their derivatives."""
    met, new = set[sp.Basic](), {by}
    while new:
        met |= new
        steps = ((s, *rates) for s, (other, rates) in moving.items() if other in new)
        new = {step for one in steps for step in one} - met
    return met - {by}


def _find_carrier(symbol: sp.Basic, moving: Moving) -> sp.Basic:
    """Return the letter on which a letter or derivative ultimately depends, or itself."""
    carriers = (other for s, (other, rates) in moving.items() if symbol in (s, *rates))
    carrier = next(carriers, None)
    return symbol if carrier is None else _find_carrier(carrier, moving)


def list_ends(*values: Any) -> list[Relational]:
    """Return the inequalities at which pieces end, each once."""
    pieces = {piece for value in values for piece in value.atoms(sp.Piecewise)}
    found = {
        r.canonical for piece in pieces for _, said in piece.args for r in said.atoms(*_ORDERS)
    }
    return sorted(found, key=str)


def find_end(end: Relational, by: sp.Basic) -> sp.Expr | None:
    """Return where a piece ends along a letter, or None if the end is not linear in it."""
    return find_zero(end.lhs - end.rhs, by)


def find_zero(difference: sp.Expr, by: sp.Basic) -> sp.Expr | None:
    """Return the zero of an expression linear in a letter, or None if it is not linear."""
    difference = sp.expand(difference)
    slope = difference.coeff(by)
    rest = difference - slope * by
    return None if slope == 0 or rest.has(by) else -rest / slope


def has_value(value: Any, by: sp.Basic, point: sp.Expr) -> bool:
    """Return whether a value is defined at a point where pieces may end, as far as is seen.

    It is not where adjacent pieces differ, or where no piece applies.
    """
    for piece in value.atoms(sp.Piecewise):
        near = [inside for inside, said in piece.args if any(_ends(said, by, point))]
        near += [inside for inside, said in piece.args if said == sp.true and len(near) == 1]
        there = [inside.xreplace({by: point}) for inside in near]
        is_left_out = all(said.xreplace({by: point}) == sp.false for _, said in piece.args)
        if is_left_out or any(sp.simplify(one - there[0]) != 0 for one in there):
            return False
    return True


def list_outer_ends(value: Any, by: sp.Basic) -> Iterator[Relational]:
    """Yield the ends of pieces along a letter beyond which there is no piece.

    Nothing is yielded for a value with several such ends on the same side, or with an end that is
    not linear in the letter.
    """
    for piece in value.atoms(sp.Piecewise):
        if any(said == sp.true for _, said in piece.args):
            continue
        ends = {r: (find_end(r, by), is_lower(r, by)) for r in list_ends(piece)}
        met = set(ends.values())
        outer = [r for r, (point, low) in ends.items() if (point, not low) not in met]
        if len({ends[r][1] for r in outer}) == len(outer) and all(p is not None for p, _ in met):
            yield from outer


def is_lower(end: Relational, by: sp.Basic) -> bool:
    """Return whether an end is seen to be a lower bound of a letter; if not, it is an upper one."""
    return bool(sp.expand(end.gts - end.lts).coeff(by).is_positive)


def _ends(said: sp.Basic, by: sp.Basic, point: sp.Expr) -> Iterator[bool]:
    for end in said.atoms(*_ORDERS):
        found = find_end(end, by)
        yield found is not None and sp.expand(found - point) == 0
