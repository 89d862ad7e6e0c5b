"""A pasted equation -> its judgements; undeclared letters are taken as real and listed."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

import sympy as sp
from sympy.core.relational import Relational

from mechproof.arguments.scalars import check_text, check_texts
from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import TOO_DEEP
from mechproof.latex.expansion import read_row
from mechproof.latex.tokens import list_signs
from mechproof.latex.tree import Integration, Letter, walk
from mechproof.latex.values import list_reached, settle_all
from mechproof.nomenclature.said_relations import narrow
from mechproof.pipeline.bold_letters import compare_bold, is_capital
from mechproof.pipeline.pasted_letters import (
    COMMAND,
    Letters,
    Pasted,
    count_from_zero,
    describe,
    read_letters,
)
from mechproof.pipeline.pasted_statements import (
    give_limits,
    part_equivalence,
    take_condition,
    take_remainder,
    take_sets,
    unwrap,
)
from mechproof.pipeline.special_letters import (
    find_unknown,
    leave_out_integers,
    take_said,
)
from mechproof.proof.judge import judge
from mechproof.proof.signs import is_nonzero, is_shown
from mechproof.proof.verdict import Judgement
from mechproof.record import (
    Definition,
    Equality,
    Equation,
    Paper,
    Part,
    PrintedNumber,
    Row,
    Variable,
)
from mechproof.record.estimates import without_estimates
from mechproof.record.parts import find_bound
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain
from mechproof.tools.processes import WorkerError, run_tasks

NUMBER = "equation"


class PastedError(ValueError):
    """The pasted text, or what was said about it, cannot be read."""


@dataclass(frozen=True)
class Checked:
    """The judgements of the signs, and what each letter was taken to be."""

    judgements: tuple[Judgement, ...]
    taken: Mapping[str, str] = field(default_factory=dict)


def check_pasted(pasted: Pasted, limit: float) -> Checked:
    """Judge a pasted equation in a separate process.

    Raises `PastedError` if it cannot be read, and `WorkerError` if it takes longer than `limit`
    seconds or ends its process.
    """
    ((_, answer),) = run_tasks(_answer, [pasted], limit=limit)
    if isinstance(answer, WorkerError):
        raise answer
    if isinstance(answer, str):
        raise PastedError(answer)
    return answer


def _answer(pasted: Pasted) -> Checked | str:
    try:
        return judge_pasted(pasted)
    except (ReadingError, ValueError) as error:
        return str(error).removeprefix(f"row {NUMBER!r}: ")
    except RecursionError:
        return TOO_DEEP


def judge_equation(
    latex: str,
    *,
    where: Sequence[str] = (),
    values: Sequence[str] = (),
    names: Sequence[str] = (),
    factors: Sequence[str] = (),
    natural: Sequence[str] = (),
) -> Checked:
    r"""Judge an equation in LaTeX, a chain or a relation.

    `where` lists relations that must hold, such as 0<x<1; `values` gives letters values, such as
    k=a/b; `names` lists notations for single quantities, `factors` letters that multiply a bracket
    after them. Letters in `natural` count from 1. Raises `ValueError` for what cannot be read.
    """
    pasted = Pasted(
        check_text("latex", latex),
        where=check_texts("where", where),
        values=check_texts("values", values),
        names=check_texts("names", names),
        factors=check_texts("factors", factors),
        natural=check_texts("natural", natural),
    )
    return judge_pasted(pasted)


@without_estimates()
def judge_pasted(pasted: Pasted) -> Checked:
    """Judge a pasted equation; raise `ValueError` (or `ReadingError`) if it cannot be read.

    Bold letters are vectors. If that cannot be read, capitals are taken as matrices, and letters
    before brackets as unknown functions.
    """
    if directions := part_equivalence(pasted):
        one, other = map(judge_pasted, directions)
        alike = {x: kind for x, kind in one.taken.items() if other.taken.get(x) == kind}
        return Checked((*one.judgements, *other.judgements), alike)
    values, called = take_said(pasted.values)
    latex, *where = map(leave_out_integers, (pasted.latex, *pasted.where))
    pasted = replace(pasted, latex=latex, where=(*where,), values=values, called=called)
    try:
        return _judge(pasted)
    except ValueError:
        unknown = find_unknown(pasted.prints) if pasted.names == pasted.factors == () else {}
        if unknown and not called:
            with suppress(ValueError):
                return _judge(replace(pasted, called=unknown, unknown=(*unknown,)))
        if not is_capital(pasted.latex):
            raise
        return _judge(replace(pasted, has_matrices=True))


def _judge(pasted: Pasted) -> Checked:
    pasted = take_sets(take_condition(replace(pasted, latex=unwrap(pasted.latex))))
    whole = pasted.latex
    latex, remainder = take_remainder(whole)
    pasted = replace(pasted, latex=latex)
    letters = read_letters(pasted)
    variables, notation = letters.variables, letters.notation
    printed = _read_conditions(pasted.latex, Reader(variables, notation, COMMAND))
    needed = _leave_out_shown(letters.needed, variables, [*letters.relations, *printed])
    variables, relations = count_from_zero(variables, [*letters.relations, *needed, *printed])
    said = {s for relation in relations for s in relation.free_symbols}
    variables, where = narrow(variables, relations)
    reader = Reader(variables, notation, COMMAND)
    free = tuple(v.symbol for v in variables if v.given is None and isinstance(v.symbol, sp.Symbol))
    _refuse_running(variables, pasted, reader)
    told = [*pasted.where, *(f"{r.lhs} {r.rel_op} {r.rhs}" for r in needed)]
    on = Part(" and ".join(told), where=where) if told else None
    rows = read_row(Equation(NUMBER, pasted.latex, defines=free, on=on), reader)
    if printed:
        rows = tuple(replace(row, on=row.on and replace(row.on, where=where)) for row in rows)
    rows = tuple(_round_given(_compare_given(row, letters, reader), letters) for row in rows)
    rows = tuple(compare_bold(row, variables) for row in rows)
    _refuse_definitions(rows, said)
    if pasted.unknown:
        _refuse_open(rows, reader, {*notation.called.values()})
    paper = Paper("pasted", "", variables, ())
    if remainder:
        rows = give_limits(rows, whole, Domain.of(paper, on), remainder)
    named = [replace(row, number=row.number.removeprefix(f"{NUMBER}, ")) for row in rows]
    read = tuple(judge(row, paper) for row in named)
    depends = {x: f", depends on {by}" for x, (by, _) in notation.moving.items()}
    moved = {by for by, _ in notation.moving.values()} | {*notation.parameters.values()}
    moved = moved or {s for s in free if letters.rates and s.name in ("t", "x")}
    if moved:
        steady = {v.symbol for v in variables if v.given is None} - moved
        steady -= {rate for _, rates in notation.moving.values() for rate in rates}
        depends = dict.fromkeys(steady, ", a constant") | depends
    taken = {v.latex[0]: describe(v) + depends.get(v.symbol, "") for v in variables if v.latex}
    return Checked(read, taken)


def _leave_out_shown(
    needed: Sequence[Relational], variables: Sequence[Variable], said: Sequence[sp.Basic]
) -> list[Relational]:
    """Return the conditions for real values that do not follow from the relations stated."""
    if not needed:
        return []
    narrowed, where = narrow(*count_from_zero(variables, said))
    domain = Domain.of(Paper("pasted", "", narrowed, ()), Part("", where=where))
    return [r for r in needed if not _is_shown(r, domain)]


def _is_shown(relation: Relational, domain: Domain) -> bool:
    slack = find_slack(relation)
    return is_shown(slack, domain) if slack else is_nonzero(relation.lhs, domain)


def _compare_given(row: Row, letters: Letters, reader: Reader) -> Row:
    """Compare a printed definition with the value from other letters, if its letter is not new."""
    says = row.says
    if not isinstance(says, Definition):
        return row
    is_tied = says.symbol in letters.tied
    if says.symbol in reader.values and not {r"\pm", r"\mp"} & {*list_signs(row.printed_latex)}:
        members = reader.members(row)
        if len(members) == 2 and (is_tied or says.symbol not in members):
            return replace(row, says=Equality(members[0], members[1], "member"))
    is_new = says.symbol not in settle_all(says.printed, reader.values).free_symbols
    if is_new and not (is_tied or says.symbol in letters.rates):
        return row
    given, printed = (letters.rates.get(one, one) for one in (says.symbol, says.printed))
    return replace(row, says=Equality(given, printed, "member"))


def _round_given(row: Row, letters: Letters) -> Row:
    """Take the decimal given for a letter as the other side's value, rounded.

    If the other side contains the letter itself, the decimal is exact, as it is inside expressions.
    """
    says, values = row.says, {v.symbol: v.given for v in letters.variables if v.given is not None}
    sides = (says.printed, says.rebuilt) if isinstance(says, Equality) else ()
    for letter, other in zip(sides, sides[::-1], strict=True):
        digits = letters.decimals.get(letter)
        if not digits or other.is_Symbol or letter in list_reached(other.free_symbols, values):
            continue
        value = settle_all(other, values)
        if not value.free_symbols:
            return replace(row, says=PrintedNumber(digits, value))
    return row


def read_expression(pasted: Pasted) -> tuple[sp.Expr, Mapping[sp.Symbol, sp.Set]]:
    """Return the pasted expression, or the right side of an equation, and its letters' sets.

    Raises `ValueError` (or `ReadingError`) if it cannot be read or a relation is between letters.
    """
    pasted = replace(pasted, latex=unwrap(pasted.latex))
    letters = read_letters(pasted)
    variables, where = narrow(letters.variables, [*letters.relations, *letters.needed])
    if where:
        raise ValueError(f"--where {where[0]}: must be a range of one letter")
    read = Reader(variables, letters.notation, COMMAND).parse(pasted.latex)
    (chain,) = read.chains if len(read.chains) == 1 else (None,)
    if chain is None or chain.condition or len(chain.members) > 2:
        raise ValueError("one expression is needed, or an equation with it on the right side")
    expression = read.meaning().of(chain.members[-1])
    given = {v.symbol: v.given for v in variables if v.given is not None}
    for _ in given:
        expression = expression.subs(given)
    return expression, {v.symbol: v.within for v in variables if v.given is None}


def _refuse_definitions(rows: Sequence[Row], said: Collection[sp.Basic]) -> None:
    """Refuse a letter that is defined twice, or that other statements restrict, too."""
    says = [row.says for row in rows if isinstance(row.says, Definition)]
    defined = [one.symbol for one in says]
    bound = {s.name.removesuffix("_") for one in says for s in find_bound(one.printed)}
    for symbol in dict.fromkeys(defined):
        if symbol.name == "e":
            raise ValueError(
                r"e is alone on one side: Euler's number, or a letter? Print \mathrm{e} for the "
                "number; give the value of the letter by --let"
            )
        if symbol.name in bound:
            raise ValueError(f"{symbol} is also a bound letter: use another letter for one of them")
        if defined.count(symbol) > 1:
            raise ValueError(f"{symbol} is defined twice: give one definition by --let")
        if symbol in said:
            raise ValueError(
                f"the equation defines {symbol}, but its condition or --where restricts it: "
                "give its value by --let, or leave the restriction out"
            )


def _refuse_open(rows: Sequence[Row], reader: Reader, running: Collection[sp.Basic]) -> None:
    r"""Refuse a function of a running variable where nothing runs, as in \int_0^1u'\,dx=u."""
    for side in (side for row in rows for side in reader.members(row)):
        if met := settle_all(side, reader.values).free_symbols & {*running}:
            raise ValueError(f"it is not stated at which {min(map(str, met))} a function is taken")


# Statements about letters -----------------------------------------------------------------------


def _refuse_running(variables: Sequence[Variable], pasted: Pasted, reader: Reader) -> None:
    r"""Refuse f(x) named as one quantity where x runs, as in \int_0^1f(x)\,dx, and a free C.

    A C next to an integral without limits depends on where the integral starts.
    """
    parts = [p for text in pasted.prints for p in walk(reader.parse(text, upper=1).chains)]
    bound = (getattr(p, name, None) for p in parts for name in ("by", "differential", "index"))
    running = {letter.text for letter in bound if isinstance(letter, Letter)}
    for text in (p.text for p in parts if isinstance(p, Letter) and "(" in p.text):
        if met := sorted(running & {*list_signs(text.partition("(")[2].rpartition(")")[0])}):
            raise ValueError(f"{text} is named as one quantity, but {met[0]} runs: give its value")
    has_constant = any(v.symbol.name == "C" and v.given is None for v in variables)
    if has_constant and any(isinstance(p, Integration) and p.low is None for p in parts):
        raise ValueError(
            "C next to an integral without limits is undetermined: give --let 'C=0', or its value "
            "where the integral starts."
        )


def _read_conditions(latex: str, reader: Reader) -> list[sp.Basic]:
    """Return the conditions stated in an equation, if they apply to all of it."""
    read = reader.parse(latex, upper=1)
    conditions = {chain.condition for chain in read.chains}
    relations = [r for part in conditions if part for r in read.meaning().relate(part)]
    for relation in relations:
        if isinstance(relation, sp.Equality):
            raise ValueError(
                f"the condition {relation.lhs} = {relation.rhs}: give a letter's value by --let"
            )
    return relations if len(conditions) == 1 else []
