"""The meaning of an equation in special cases: under a condition, up to turns, for each branch.

Laws whose pieces are printed one by one also state something where the pieces meet.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from mechproof.document.known import Known
from mechproof.document.law_pieces import read_piece
from mechproof.document.tasks import Role, Sign, Task
from mechproof.latex.values import differentiate, find_end, has_value, list_ends, list_outer_ends
from mechproof.nomenclature.said_relations import narrow
from mechproof.nomenclature.symbol_names import ORDERS
from mechproof.record import Conjunction, Equality, Equation, Paper, Part, Row, Statement
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Files

# Work limit: longer expressions take long to differentiate, and nothing was found to follow.
_MOST = 1_000


def list_values(row: Row, known: Known) -> dict[sp.Basic, sp.Basic]:
    """Return the values that a row's condition, e=0, gives letters without a formula."""
    said = [r for r in (row.on.where if row.on else ()) if isinstance(r, sp.Equality)]
    free = [r for r in said if r.lhs.is_Symbol and r.lhs not in {*known.values, *r.rhs.atoms()}]
    return {r.lhs: r.rhs for r in free}


def put_on(row: Row, values: Mapping[sp.Basic, Any]) -> Row:
    """Add values of letters to the condition of a row."""
    if not values:
        return row
    said = tuple(sp.Eq(*one, evaluate=False) for one in values.items())
    part = row.on or Part("", {})
    shown = (f"{s} = {value}" for s, value in values.items())
    text = " and ".join([*([part.text] if part.text else []), *shown])
    return replace(row, on=replace(part, text=text, where=(*part.where, *said)))


def put_in(side: Any, values: Mapping[sp.Basic, sp.Basic], known: Known) -> Any:
    """Put values into a side, including values given in terms of other letters."""
    side = known.settle(side, values)
    for _ in values:
        side = side.xreplace(values)
    return side


def specialise(row: Row, values: Mapping[sp.Basic, sp.Basic], known: Known) -> Row:
    """Put the values from a row's condition into the sides that it compares."""
    if row.on is None or not values or not isinstance(row.says, Equality):
        return row
    one, other = (put_in(side, values, known) for side in row.says.sides)
    if any(side.has(sp.nan, sp.zoo, sp.oo) for side in (one, other)):
        return row
    where = tuple(r for r in row.on.where if values.get(getattr(r, "lhs", None)) != r.rhs)
    on = replace(row.on, where=where) if where else None
    note = f"{row.note} Compared for {row.on.text}.".strip()
    return replace(row, says=replace(row.says, printed=one, rebuilt=other), on=on, note=note)


def stay_at_last_piece(
    row: Row, sign: Sign, printed: Printed, every: Sequence[Printed], known: Known
) -> Row:
    """Relate a derivative printed between the pieces of a law to the last piece before it.

    After all pieces, or with a range of its own, it is the derivative of the whole law.
    """
    order = [one.name for one in every]
    _, steps = known.symbols.find_steps(sign.letter) if sign.letter else (None, ())
    places = {order.index(piece.name): piece for s in steps for piece in known.laws.get(s, ())}
    before = [place for place in places if place < order.index(printed.name)]
    if sign.role is not Role.DERIVATIVE or row.on or not 0 < len(before) < len(places):
        return row
    last = places[max(before)]
    return replace(row, on=Part(f"{last.name} is meant", {}, last.where))


def stay_within_pieces(row: Row, sign: Sign, known: Known) -> Row:
    """Restrict a comparison of piecewise sides to where they hold, and derivatives off the seams.

    A piecewise law has no derivative where pieces meet, unless they join; prints give that of
    either piece.
    """
    if not isinstance(row.says, Equality) or sign.letter is None:
        return row
    by, steps = known.find_parted(sign.letter), known.symbols.find_steps(sign.letter)[1]
    sides = _choose_pieces(row.on, by, row.says.sides, known)
    row = replace(row, says=replace(row.says, printed=sides[0], rebuilt=sides[1]))
    laws = [known.values[s] for s in steps[: steps.index(sign.letter)] if s in known.values]
    ends = list_ends(*sides) if sign.role is Role.DERIVATIVE else []
    apart = dict.fromkeys(sp.Ne(*e.args) for e in ends if not _joins(e, by, [*sides, *laws]))
    outer = dict.fromkeys(end for side in sides for end in list_outer_ends(side, by))
    if not (apart or outer):
        return row
    text = "no two pieces meet" if apart else "a printed piece holds"
    part = row.on or Part("", {})
    text = f"{part.text} and {text}" if part.text else text
    return replace(row, on=_narrow(Part(text, part.within, (*part.where, *apart)), outer, known))


def _choose_pieces(
    on: Part | None, by: sp.Basic, sides: tuple[Any, Any], known: Known
) -> tuple[Any, Any]:
    """Return the sides with piecewise laws replaced by the piece for exactly this range."""
    own = read_piece("", None, on.where, by) if on else None
    if own is None:
        return sides
    chosen: dict[sp.Basic, sp.Basic] = {}
    settled = known.settle(sides[0]), known.settle(sides[1])
    for law in {law for side in settled for law in side.atoms(sp.Piecewise)}:
        for value, said in law.args:
            piece = read_piece("", value, sp.And.make_args(said), by)
            if piece and piece.range == own.range:
                chosen[law] = value
    if not chosen:
        return sides
    return settled[0].xreplace(chosen), settled[1].xreplace(chosen)


def _narrow(part: Part, ends: Iterable[Relational], known: Known) -> Part:
    """Put the bounds of a letter into its set, if they are numbers."""
    free = [v for v in known.symbols.variables if v.symbol not in known.values]
    variables, where = narrow(free, list(ends))
    sets = {v.symbol: v.within for v in set(variables) - set(free)}
    return replace(part, within={**part.within, **sets}, where=(*part.where, *where))


def _joins(end: Relational, by: sp.Basic, values: Sequence[Any]) -> bool:
    point = find_end(end, by)
    return point is not None and all(has_value(value, by, point) for value in values)


def state_modulo(says: Equality, turn: str, known: Known) -> Conjunction:
    """State that two angles are equal up to whole turns."""
    read = known.symbols.reader().parse(turn)
    whole = read.meaning().of(read.chains[0].members[0])
    return state_angles(says, 2 * sp.pi / whole)


def state_angles(says: Equality, times: sp.Expr = sp.S.One) -> Conjunction:
    """State that the sides, times a factor, are angles of the same direction."""
    sides = [times * side for side in says.sides]
    parts = (Equality(f(sides[0]), f(sides[1]), says.rebuilt_from) for f in (sp.cos, sp.sin))
    return Conjunction(tuple(parts))


def split_branches(says: Statement, known: Known) -> Statement:
    """State an equation for each sign of the letters that are branches."""
    if not isinstance(says, Equality):
        return says
    one, other = known.settle(says.printed), known.settle(says.rebuilt)
    choices = known.symbols.list_branches(one.free_symbols | other.free_symbols)
    if choices == [{}]:
        return says
    parts = (Equality(one.subs(c), other.subs(c), says.rebuilt_from) for c in choices)
    return Conjunction(tuple(parts))


def list_rates(residual: sp.Expr, at: Iterable[sp.Basic], known: Known) -> Iterator[sp.Expr]:
    """Yield the first and second derivatives of a residual by letters that others depend on.

    Residuals with too many operations are not differentiated. There are no derivatives by a letter
    that has a value in `at`, or on which such a letter depends.
    """
    fixed = {known.symbols.find_steps(letter)[0] for letter in at}
    moving = known.symbols.moving
    third = {rate for _, rates in moving.values() for rate in rates[2:]}
    for by in dict.fromkeys(by for by, _ in moving.values() if by not in fixed):
        rate = residual
        for _ in ORDERS:
            if rate.count_ops() > _MOST:
                break
            try:
                rate = known.settle(differentiate(rate, by, moving))
            except ValueError:
                break
            if rate == 0 or rate.free_symbols & third:
                break
            yield rate


def make_seams(
    printed: Sequence[Printed], known: Known, papers: Mapping[bool, Paper], files: Files
) -> Iterator[Task]:
    """Make tasks of the places where the pieces of laws meet.

    A letter whose derivative is printed does not jump, nor does one where both pieces include the
    place. `papers` are the paper with the units of its letters (True), and without (False).
    """
    for letter, pieces in known.laws.items():
        by, steps = pieces[0].by, known.symbols.find_steps(letter)[1]
        order = steps.index(letter)
        is_smooth = not order and known.met[steps[1]] > 0
        for one, other in pairwise(pieces):
            if one.high is None:
                continue
            before, after = (piece.value.xreplace({by: one.high}) for piece in (one, other))
            is_shared = one.is_closed[1] and other.is_closed[0]
            shown = [display for display in printed if display.name in (one.name, other.name)]
            row = Equation(
                f"{known.name_law(letter)}, {letter} at {by} = {one.high}",
                r"\quad ".join(display.latex.string for display in shown),
                says=Equality(before, after, "member"),
                read_as=f"{before} = {after}",
            )
            sides = known.settle(before), known.settle(after)
            letters = sides[0].free_symbols | sides[1].free_symbols
            paper = papers[not letters & known.symbols.bare]
            asserts = is_smooth or (is_shared and not order)
            sign, place = Sign(Role.SEAM), shown[-1].locate(files)
            yield Task(row, place, sign, paper, asserts, residual=sides[0] - sides[1])
