"""Findings: the root causes of what is wrong in print, what each costs, and what follows from it.

A derivation may name the causes; a wrong printed row that belongs to none is a finding of its own.
That a row follows from another is itself a row of the ledger: with the correction of the cause in
place of its print, the statement is proved.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.ledger.costs import LedgerCost, show_witness
from mechproof.proof.verdict import Judgement, Verdict, describe_print, name_row
from mechproof.record import (
    Check,
    Conjunction,
    Cost,
    Equality,
    Finding,
    FollowingRow,
    Paper,
    PrintedNumber,
    Row,
    Weight,
)
from mechproof.record.papers import WEIGHTS
from mechproof.record.substitution import substitute
from mechproof.sources.located_text import Place
from mechproof.statement_domains.domain import Domain

WRONG = (Verdict.REFUTED, Verdict.ILL_FORMED)
# Factors that turn a value in radians, millimetres or parts of one into each unit.
UNITS: Mapping[str, sp.Expr] = {
    "": sp.S.One,
    "°": 180 / sp.pi,
    "rad": sp.S.One,
    "mm": sp.S.One,
    "µm": sp.Integer(1000),
    "%": sp.Integer(100),
}
PRINTED_AND_RIGHT = ("printed", "right")
# A convention is true in some sense: only the literal reading of the print gives the first value.
READ_AND_RIGHT = ("read literally", "right")
_BITS = 60


@dataclass(frozen=True)
class LedgerFinding:
    """One finding of the ledger."""

    system: str
    number: str
    verdict: Verdict
    marks: tuple[str, ...]
    printed_latex: str
    wrong: str
    costs: tuple[LedgerCost, ...]
    corrected_latex: str
    corrected_by: str
    corrected_on: str
    follows: tuple[str, ...]
    weight: Weight
    mend_latex: str
    mend_by: str
    mend_on: str
    check: str
    figure: str
    place: Place | None = None

    @property
    def id(self) -> str:
        """Return the name by which it can be cited: that of its row."""
        return name_row(self.system, self.number)

    def as_dict(self) -> dict[str, object]:
        """Return the JSON record."""
        written = {field.name: getattr(self, field.name) for field in fields(self)}
        place = written.pop("place")
        written |= describe_print(written.pop("printed_latex"), is_source=place is not None)
        lists = {name: list(written[name]) for name in ("marks", "follows")}
        said = {"verdict": self.verdict.value, "weight": WEIGHTS[self.weight]}
        said |= {"place": str(place)} if place else {}
        costs = [cost.as_dict() for cost in self.costs]
        return {"id": self.id, **written, **said, **lists, "costs": costs}


def follower_rows(paper: Paper) -> tuple[Row, ...]:
    """Return every follower of every finding, stated with the correction of its cause inserted.

    Raises `ValueError` for a row that is not in the paper, a cause without a correction, a follower
    that does not contain the print of its cause, and parts that the cause does not have.
    """
    rows = {row.number: row for row in paper.rows}
    return tuple(
        _insert_correction(_find(rows, follower.row), _find(rows, finding.row), follower)
        for finding in paper.findings
        for follower in finding.followers
    )


def list_findings(paper: Paper, judgements: Sequence[Judgement]) -> tuple[LedgerFinding, ...]:
    """Return the findings of a paper, the gravest first, otherwise in the order of its rows.

    A row without a verdict is not a finding. Raises `ValueError` for a cause that is not wrong, a
    follower that does not follow and a mend that is not proved.
    """
    judged = {j.number: j for j in judgements}
    named = {finding.row: finding for finding in paper.findings}
    following = {follower.row for finding in paper.findings for follower in finding.followers}
    wrong = {j.number for j in judgements if j.verdict in WRONG and "ours" not in j.marks}
    causes = named.keys() | (wrong - following)
    found = (
        _describe(paper, row, named.get(row.number), judged)
        for row in paper.rows
        if row.number in causes
    )
    return tuple(sorted(found, key=lambda one: one.weight))


def _describe(
    paper: Paper, row: Row, finding: Finding | None, judged: Mapping[str, Judgement]
) -> LedgerFinding:
    about = judged[row.number]
    weight = Weight.FORMULA if about.verdict is Verdict.ILL_FORMED else Weight.NUMBER
    finding = finding or Finding(row.number, about.reason, weight=weight)
    if about.verdict in (Verdict.PROVED, Verdict.DEFINITION):
        raise ValueError(
            f"paper {paper.system!r}: finding {row.number!r}: its row is {about.verdict}"
        )
    for follower in finding.followers:
        again = judged[_corrected_number(follower.row, row.number)]
        if again.verdict is not Verdict.PROVED:
            raise ValueError(
                f"paper {paper.system!r}: {follower.row!r} does not follow from {row.number!r}: "
                f"with its correction it is {again.verdict}: {again.reason}"
            )
    mend = _find_mend(finding, judged)
    return LedgerFinding(
        system=paper.system,
        number=row.number,
        verdict=about.verdict,
        marks=about.marks,
        printed_latex=about.printed_latex,
        wrong=finding.wrong,
        costs=tuple(_compare(cost, about.verdict, row, paper) for cost in finding.costs)
        or tuple(show_witness(about)),
        corrected_latex=about.corrected_latex,
        corrected_by=about.corrected_by,
        corrected_on=about.on if about.corrected_by else "",
        follows=tuple(follower.row for follower in finding.followers),
        weight=finding.weight,
        mend_latex=mend.printed_latex if mend else "",
        mend_by=mend.rung if mend else "",
        mend_on=mend.on if mend else "",
        check=_write_check(finding.check, Domain.of(paper)) if finding.check else "",
        figure=finding.figure,
        place=about.place,
    )


def _find_mend(finding: Finding, judged: Mapping[str, Judgement]) -> Judgement | None:
    """Return the row whose print is the smallest mend; raises ValueError unless it is proved."""
    if not finding.mend:
        return None
    mend = judged.get(finding.mend)
    if mend is None or mend.verdict is not Verdict.PROVED:
        found = mend.verdict if mend else "not a row"
        raise ValueError(
            f"finding {finding.row!r}: mend = {finding.mend!r}: must be PROVED, but is {found}"
        )
    return mend


def _write_check(check: Check, domain: Domain) -> str:
    """Return the sentence of a check with its computed numbers."""
    values = (_value(value, {}, check.unit, check.text, domain) for value in check.values)
    return check.text.format(*(_Shown(value, check) for value in values))


@dataclass(frozen=True)
class _Shown:
    """A number of a check, shown in its unit; a format gives the decimals of the bare number."""

    value: balls.Ball
    check: Check

    def __format__(self, decimals: str) -> str:
        unit = self.check.unit
        if decimals:
            bare = self.value / balls.evaluate_until(UNITS[unit], {}, _BITS)
            return str(_round(bare, int(decimals)))
        after = unit if unit in ("", "°") else f" {unit}"
        return f"{_round(self.value, self.check.decimals)}{after}"


def _compare(cost: Cost, verdict: Verdict, row: Row, paper: Paper) -> LedgerCost:
    """Return both values at a place and, for a printed and a right one, their difference."""
    domain = Domain.of(paper)
    sides = (
        _sides(row) if cost.printed is None or cost.right is None else (cost.printed, cost.right)
    )
    values = [_value(side, cost.at, cost.unit, cost.where, domain) for side in sides]
    differ = cost.names == PRINTED_AND_RIGHT
    literally = differ and verdict is Verdict.CONVENTION
    named = dict(zip(READ_AND_RIGHT if literally else cost.names, values, strict=True))
    if differ:
        named["off by"] = abs(values[0] - values[1])
    rounded = {name: str(_round(value, cost.decimals)) for name, value in named.items()}
    return LedgerCost(cost.where, rounded, cost.unit)


def _sides(row: Row) -> tuple[sp.Expr, sp.Expr]:
    says = row.statement
    if isinstance(says, Equality):
        return says.printed, says.rebuilt
    if isinstance(says, PrintedNumber):
        return sp.Rational(says.printed), says.value
    raise ValueError(f"row {row.number!r}: its cost must state both values")


def _value(
    side: sp.Expr, at: Mapping[sp.Basic, sp.Expr], unit: str, where: str, domain: Domain
) -> balls.Ball:
    if unit not in UNITS:
        raise ValueError(f"{where}: unit = {unit!r}: must be one of {', '.join(UNITS)}")
    sizes = {symbol: sp.sympify(value) for symbol, value in at.items()}
    placed = substitute(domain.resolve(side), sizes)
    if placed.free_symbols:
        raise ValueError(f"{where}: no size is given for {sorted(map(str, placed.free_symbols))}")
    value = balls.evaluate_until(UNITS[unit] * placed, {}, _BITS)
    if not value.is_finite():
        raise ValueError(f"{where}: {side} has no value there")
    return value


def _round(value: balls.Ball, decimals: int) -> Decimal:
    """Round the midpoint of a ball far smaller than the last place; zero gets no decimals."""
    middle = Decimal(value.mid().str(40, radius=False))
    return middle.quantize(Decimal(1).scaleb(-decimals if middle else 0))


def _find(rows: Mapping[str, Row], number: str) -> Row:
    if number not in rows:
        raise ValueError(f"finding: there is no row {number!r}")
    return rows[number]


def _corrected_number(number: str, root: str) -> str:
    return f"{number}, with {root} corrected"


def _insert_correction(row: Row, root: Row, follower: FollowingRow) -> Row:
    pairs = _rename(_corrections(root, follower), follower)
    says = row.statement
    if isinstance(says, Equality) and says.rebuilt_from == "mechanics":
        inserted: Any = replace(says, printed=_replace_in(says.printed, pairs))
    else:
        inserted = _replace_in(says, pairs)
    if inserted == says:
        raise ValueError(
            f"row {row.number!r} does not contain the part that {root.number!r} corrects"
        )
    return replace(
        row,
        number=_corrected_number(row.number, root.number),
        printed_latex=row.corrected.latex if row.corrected else row.printed_latex,
        says=inserted,
        note="",
        corrected=None,
        readings=(),
        holds_on=None,
        read_as="",
        marks=tuple(dict.fromkeys((*row.marks, "ours"))),
    )


def _corrections(root: Row, follower: FollowingRow) -> Mapping[sp.Basic, sp.Basic]:
    """Map parts of a cause's print to the parts of its correction in the same places.

    If the correction is a conjunction, its first part replaces the print.
    """
    if root.corrected is None:
        raise ValueError(f"finding {root.number!r}: rows follow from it, so it needs a correction")
    printed, mend = root.statement, root.corrected.statement
    if isinstance(mend, Conjunction) and not isinstance(printed, Conjunction):
        mend = mend.parts[0]
    whole = _pairs(printed, mend)
    for part, right in follower.parts.items():
        if not any(print_.has(part) and whole[print_].has(right) for print_ in whole):
            raise ValueError(f"finding {root.number!r}: it does not correct {part} to {right}")
    return follower.parts or whole


def _rename(pairs: Mapping[sp.Basic, sp.Basic], follower: FollowingRow) -> dict[sp.Basic, sp.Basic]:
    renamed = dict(follower.renamed)
    return {part.xreplace(renamed): right.xreplace(renamed) for part, right in pairs.items()}


def _pairs(printed: Any, corrected: Any) -> dict[sp.Basic, sp.Basic]:
    if isinstance(printed, sp.Basic):
        return {printed: corrected} if printed != corrected else {}
    both: Iterable[tuple[Any, Any]] = ()
    if is_dataclass(printed) and type(printed) is type(corrected):
        both = ((getattr(printed, f.name), getattr(corrected, f.name)) for f in fields(printed))
    elif isinstance(printed, tuple) and len(printed) == len(corrected):
        both = zip(printed, corrected, strict=True)
    return {k: v for p, c in both for k, v in _pairs(p, c).items()}


def _replace_in(part: Any, pairs: Mapping[sp.Basic, sp.Basic]) -> Any:
    if isinstance(part, sp.Basic):
        if part in pairs:
            # Replaced as a whole: in a matrix SymPy would only replace elements.
            return pairs[part]
        # `subs`, not `xreplace`: a product within a product is merged with its factors.
        return part.subs(pairs, simultaneous=True)
    if isinstance(part, tuple):
        return tuple(_replace_in(item, pairs) for item in part)
    if is_dataclass(part) and not isinstance(part, type):
        values = {f.name: _replace_in(getattr(part, f.name), pairs) for f in fields(part)}
        return replace(part, **values)
    return part
