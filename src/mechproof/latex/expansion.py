"""A paper with prints -> the same paper with a row for each relation sign."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import sympy as sp

from mechproof.latex.errors import PrintedText, Remedies
from mechproof.latex.latex_signs import DOUBLE
from mechproof.latex.meaning import Meaning
from mechproof.latex.printed_statements import Members, state
from mechproof.latex.reader import Print, Reader
from mechproof.latex.text import write, write_sign
from mechproof.latex.tokens import list_signs
from mechproof.latex.tree import Chain, Letter, Node, Repeated, walk
from mechproof.record import (
    ChainLink,
    Conjunction,
    Correction,
    Distinct,
    Equality,
    Holds,
    Nearly,
    Paper,
    Part,
    Row,
    Statement,
    ValueWhere,
)

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth")


def read_paper(paper: Paper) -> Paper:
    """Return the paper with every print read, one row for each relation sign.

    A paper without prints to be read is returned unchanged.
    Raises `ReadingError` with the row and the place in its print, `ValueError` for a row whose
    declarations do not fit its print.
    """
    reader = Reader(paper.variables, paper.notation)
    rows = tuple(new for row in paper.rows for new in read_row(row, reader))
    return paper if rows == paper.rows else replace(paper, rows=rows)


def read_row(row: Row, reader: Reader) -> tuple[Row, ...]:
    """Return the rows of a print, one for each relation sign; a typed row unchanged."""
    if row.says is not None:
        if row.corrected and row.corrected.says is None:
            raise ValueError(f"row {row.number!r}: it is typed, so its correction needs a `says`")
        return (row,)
    upper = _read_signs(row, reader, 1)
    signs = {*list_signs(row.printed_latex)}
    if not signs & {r"\pm", r"\mp"}:
        return upper
    lower = _read_signs(row, reader, -1)
    pairs = list(zip(upper, lower, strict=True))
    if reader.notation.branch is not None and any(map(_is_on_one_side, *zip(*pairs, strict=True))):
        return _read_signs(row, reader, 0)
    return tuple(_join_signs(one, other, reader.remedies) for one, other in pairs)


def _is_on_one_side(upper: Row, lower: Row) -> bool:
    """Return whether a double sign is on one side of a relation only."""
    pairs = zip(_list_sides(upper.statement), _list_sides(lower.statement), strict=True)
    is_same = upper.says == lower.says and upper.on == lower.on
    is_other = upper.on != lower.on or type(upper.statement) is not type(lower.statement)
    return not is_same and (is_other or not all(a != b for a, b in pairs))


def _join_signs(upper: Row, lower: Row, remedies: Remedies) -> Row:
    """Return a row that asserts a relation both with its upper and with its lower signs."""
    if upper.says == lower.says:
        return upper
    says = (upper.statement, lower.statement)
    if _is_on_one_side(upper, lower):
        latex = upper.printed_latex
        error = PrintedText(latex).refuse(
            next(DOUBLE.finditer(latex)).start(),
            "a double sign on one side, or in the definition of a letter: both signs, or either?",
            f"It stands for two equations: print them one by one{remedies.sign}.",
        )
        error.row = upper.number
        raise error
    corrected = upper.corrected
    if corrected and lower.corrected:
        both = (corrected.statement, lower.corrected.statement)
        corrected = replace(corrected, says=Conjunction(both))
    text = f"{upper.read_as}; and {lower.read_as}"
    return replace(upper, says=Conjunction(says), read_as=text, corrected=corrected)


def _list_sides(says: Statement) -> Sequence[sp.Basic]:
    """Return the sides of a statement; a single zero for one that has none to compare."""
    if isinstance(says, Equality):
        return says.printed, says.rebuilt
    if isinstance(says, Distinct | Nearly):
        return says.left, says.right
    if isinstance(says, Holds):
        return tuple(says.relation.args)
    return (sp.S.Zero,)


def _read_signs(row: Row, reader: Reader, upper: int) -> tuple[Row, ...]:
    read = reader.parse(row.printed_latex, row.number, upper)
    signs = [(chain, left) for chain in read.chains for left in range(len(chain.members) - 1)]
    places = [_Place(read, chain, left) for chain, left in signs]
    if any(not chain.relations for chain in read.chains):
        raise ValueError(f"row {row.number!r}: a part of its print has no relation sign")
    if surplus := sorted(row.links.keys() - set(range(1, len(places) + 1))):
        raise ValueError(f"row {row.number!r}: it has {len(places)} signs, but links for {surplus}")
    only_equal = all(place.sign == "=" for place in places)
    return tuple(
        _expand(_specialise(row, number), place, _number(row, number, len(places), only_equal))
        for number, place in enumerate(places, start=1)
    )


@dataclass(frozen=True)
class _Place:
    """A relation sign of a print: its chain and the place of its left member."""

    read: Print
    chain: Chain
    left: int

    @property
    def sign(self) -> str:
        return self.chain.relations[self.left]

    @property
    def nodes(self) -> tuple[Node, Node]:
        one, other = self.chain.members[self.left : self.left + 2]
        return one, other

    def members(self, meaning: Meaning) -> tuple[Any, Any]:
        one, other = self.nodes
        return meaning.side(one), meaning.side(other)

    @property
    def text(self) -> str:
        one, other = self.nodes
        condition = f" if {write(self.chain.condition)}" if self.chain.condition else ""
        return f"{write(one)} {write_sign(self.sign)} {write(other)}{condition}"


def _number(row: Row, number: int, count: int, only_equal: bool) -> str:
    if count == 1:
        return row.number
    kind = "equals sign" if only_equal else "sign"
    return f"{row.number}, {name_ordinal(number)} {kind}"


def name_ordinal(number: int) -> str:
    """Return an ordinal number, spelled out up to the ninth."""
    if number <= len(_ORDINALS):
        return _ORDINALS[number - 1]
    endings = {1: "st", 2: "nd", 3: "rd"} if number % 100 not in (11, 12, 13) else {}
    return f"{number}{endings.get(number % 10, 'th')}"


def _specialise(row: Row, number: int) -> Row:
    """Put one link's entries into its row; its values and substitutions are added to the row's."""
    link = row.links.get(number, ChainLink())
    own = {f.name: getattr(link, f.name) for f in fields(ChainLink)}
    merged = {name: {**getattr(row, name), **own[name]} for name in ("derived", "substituted")}
    given = {name: value for name, value in own.items() if value}
    if link.residual is not None:
        given["residual"] = link.residual
    return replace(row, **{**given, **merged, "links": {}})


def _expand(row: Row, place: _Place, number: str) -> Row:
    """Return the row of a single relation sign."""
    latex = place.read.cut(place.chain, place.left, place.left + 1)
    says, text, note, divisors = row.says, "", row.note, row.divisors
    if says is None:
        (says, divisors), text = _state(row, place), _describe(row, place)
        note = " ".join(filter(None, (*_find_unused(place), *_find_needed(says), note)))
    corrected = row.corrected and _read_correction(row.corrected, row, place)
    empty: dict[str, Any] = {"derived": {}, "substituted": {}, "residual": None, "defines": ()}
    on = _narrow(row, place)
    return replace(
        row,
        number=number,
        printed_latex=latex,
        says=says,
        read_as=text,
        note=note,
        corrected=corrected,
        divisors=divisors,
        on=on,
        **empty,
    )


def _state(row: Row, place: _Place) -> tuple[Statement, tuple[sp.Expr, ...]]:
    reader, meaning = place.read.reader, place.read.meaning()
    as_printed = place.members(meaning)
    rebuilt = place.members(place.read.meaning(row.derived))
    says = state(row, place.sign, Members(place.nodes, as_printed, rebuilt), reader)
    return says, tuple(meaning.lost)


def _describe(row: Row, place: _Place) -> str:
    changes = ", ".join(f"{old} -> {new}" for old, new in row.substituted.items())
    start = place.read.reader.notation.lower_limit
    from_start = f", integrals from {start}" if "integral(" in place.text else ""
    return place.text + from_start + (f", with {changes}" if changes else "")


def _find_unused(place: _Place) -> Iterator[str]:
    """Yield a note for each sum whose term does not contain its index, which may be a misprint."""
    for part in walk(place.nodes):
        if isinstance(part, Repeated):
            letters = {p.symbol for p in walk(part.term) if isinstance(p, Letter)}
            if part.index.symbol not in letters:
                yield f"The index {part.index.symbol} of a {part.name} does not appear in its term."


def _find_needed(says: Statement) -> Iterator[str]:
    """Yield a note for each factor that must be defined at the first n, although it cancels."""
    for part in says.parts if isinstance(says, Conjunction) else ():
        for node in part.printed.atoms(ValueWhere) if isinstance(part, Equality) else ():
            yield f"For the first number, {node.args[1]} must have a value."


def _narrow(row: Row, place: _Place) -> Part | None:
    """Return where the relation is claimed: under the printed condition and that of the row."""
    condition = place.chain.condition
    if condition is None:
        return row.on
    text, relations = write(condition), place.read.meaning().relate(condition)
    if row.on is None:
        return Part(text, where=relations)
    both = " and ".join(dict.fromkeys((text, row.on.text)))
    return Part(both, row.on.within, (*relations, *row.on.where))


def _refuse_other_condition(row: Row, chain: Chain, place: _Place) -> None:
    """Refuse a correction with a condition that is not the print's, under which it is judged."""
    if chain.condition not in (None, place.chain.condition):
        raise ValueError(
            f"row {row.number!r}: its correction has its own condition: state it in `on`"
        )


def _refuse_other_quantity(row: Row, place: _Place, right: _Place) -> None:
    """Refuse a correction of both members that keeps neither, or that becomes trivial."""
    printed, corrected = (p.members(p.read.meaning()) for p in (place, right))
    kept = [k for k in (0, 1) if printed[k] == corrected[k]]
    if not kept:
        raise ValueError(f"row {row.number!r}: its correction keeps no member of the print")
    own, other = corrected[kept[0]], corrected[1 - kept[0]]
    returns = own.is_Symbol and own in other.free_symbols - printed[1 - kept[0]].free_symbols
    if own == other or returns:
        raise ValueError(f"row {row.number!r}: its correction only says that {own} is {other}")


def _read_correction(correction: Correction, row: Row, place: _Place) -> Correction:
    """Read a correction of the right member, or of both members."""
    if correction.says is not None:
        return correction
    read = place.read.reader.parse(correction.latex, row.number, place.read.upper)
    (chain,) = read.chains
    _refuse_other_condition(row, chain, place)
    right = replace(place, read=read, chain=chain, left=max(len(chain.members) - 2, 0))
    if len(chain.members) > 1:
        _refuse_other_quantity(row, place, right)
        return replace(correction, says=_state(row, right)[0])
    nodes = place.nodes[0], chain.members[0]
    printed, derived = (
        (place.read.meaning(values).side(nodes[0]), read.meaning(values).side(nodes[1]))
        for values in ({}, row.derived)
    )
    members = Members(nodes, printed, derived)
    return replace(correction, says=state(row, place.sign, members, place.read.reader))
