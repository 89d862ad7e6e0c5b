"""A pasted equation -> its judgements: what is not said is taken as a real number, and told."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import Remedies
from mechproof.latex.expansion import read_row
from mechproof.latex.names import INDEX
from mechproof.latex.tree import Chain, Integration, Letter, Repeated, walk
from mechproof.processes import WorkerError, run_tasks
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement
from mechproof.record import Equation, Notation, Paper, Row, Variable

COMMAND = Remedies(
    name="Say --name '{0}'.",
    bracket="Say --factor '{0}' for the product, or --name '{0}(…)' for one quantity.",
    function="Print a function that is the same everywhere (ln, lg, arctg).",
    scope="Print another letter for '{0}' where it is bound.",
    lower_limit="Say --from 0, or where else it starts.",
    family="Leave --name '{0}' out.",
)
NUMBER = "(pasted)"


class PastedError(ValueError):
    """What was pasted, or said about it, cannot be read."""


@dataclass(frozen=True)
class Pasted:
    """An equation and what is said about its letters, all in LaTeX.

    `names` are prints that are one quantity, `factors` names that a bracket multiplies, `where`
    relations (`0<x<1`), `values` definitions (`C=0`), `natural` counts.
    """

    latex: str
    names: tuple[str, ...] = ()
    factors: tuple[str, ...] = ()
    where: tuple[str, ...] = ()
    values: tuple[str, ...] = ()
    natural: tuple[str, ...] = ()
    lower_limit: str = ""


@dataclass(frozen=True)
class Checked:
    """The judgements of the signs, and what each letter was taken for."""

    judgements: tuple[Judgement, ...]
    taken: Mapping[str, str] = field(default_factory=dict)


def check_pasted(pasted: Pasted, limit: float) -> Checked:
    """Judge a pasted equation in a process of its own.

    Raises `PastedError` for what cannot be read, `WorkerError` for what takes longer than `limit`
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
        return str(error)


def judge_pasted(pasted: Pasted) -> Checked:
    """Judge a pasted equation; `ValueError` (also `ReadingError`) for what cannot be read."""
    variables = _declare(pasted)
    notation = Notation(factors=pasted.factors, lower_limit=_read_limit(pasted))
    reader = Reader(variables, notation, COMMAND)
    variables = _give_values(variables, pasted, reader)
    reader = Reader(variables, notation, COMMAND)
    relations = [r for text in pasted.where for r in _read_relations(text, reader)]
    variables, where = _narrow(variables, relations)
    reader = Reader(variables, notation, COMMAND)
    free = tuple(v.symbol for v in variables if v.given is None and isinstance(v.symbol, sp.Symbol))
    _refuse_constant(variables, pasted, reader)
    rows = read_row(Equation(NUMBER, pasted.latex, defines=free), reader)
    paper = Paper("pasted", "", variables, (), where)
    read = tuple(judge(_rename(row, len(rows)), paper) for row in rows)
    return Checked(read, {v.latex[0]: _describe(v) for v in variables})


def _rename(row: Row, count: int) -> Row:
    number = row.number.removeprefix(f"{NUMBER}, ") if count > 1 else "equation"
    return replace(row, number=number)


# Letters ----------------------------------------------------------------------------------------


def _declare(pasted: Pasted) -> tuple[Variable, ...]:
    """Make a variable of each name that is said and of each letter that is met."""
    named = [_make(latex, pasted) for latex in dict.fromkeys((*pasted.names, *pasted.natural))]
    reader = Reader(named, Notation(factors=pasted.factors), COMMAND)
    prints = (pasted.latex, *pasted.where, *pasted.values)
    letters = dict.fromkeys(letter for text in prints for letter in reader.collect(text))
    families = {x.partition("_")[0] for x in letters if INDEX in x}
    kept = [x for x in letters if INDEX in x or x.partition("_")[0] not in families or "_" not in x]
    read = Reader((*named, *(_make(x, pasted) for x in kept)), reader.notation, COMMAND)
    counts = {s for text in prints for s in _find_counts(read.parse(text).chains)}
    found = [_make(x, pasted) for x in kept]
    return tuple(_count(v) if v.symbol in counts else v for v in (*named, *found))


def _make(latex: str, pasted: Pasted) -> Variable:
    name = re.sub(r"[\\{}\s]", "", latex).replace(f"_{INDEX}", "")
    if INDEX in latex:
        return Variable(sp.IndexedBase(name, real=True), latex, latex=(latex,))
    variable = Variable(sp.Symbol(name, real=True), latex, latex=(latex,))
    return _count(variable) if latex in pasted.natural else variable


def _count(variable: Variable) -> Variable:
    """Make a natural number of a letter."""
    symbol = sp.Symbol(variable.symbol.name, integer=True, positive=True)
    return replace(variable, symbol=symbol, within=sp.S.Naturals)


def _find_counts(chains: tuple[Chain, ...]) -> Iterator[sp.Basic]:
    """Yield the letters up to which sums go."""
    for part in walk(chains):
        if isinstance(part, Repeated) and isinstance(part.high, Letter):
            yield part.high.symbol


# What is said -----------------------------------------------------------------------------------


def _read_limit(pasted: Pasted) -> sp.Expr | None:
    if not pasted.lower_limit:
        return None
    read = Reader((), None, COMMAND).parse(pasted.lower_limit)
    limit: sp.Expr = read.meaning().of(read.chains[0].members[0])
    return limit


def _refuse_constant(variables: Sequence[Variable], pasted: Pasted, reader: Reader) -> None:
    """Refuse a C beside an integral without limits: it depends on where the integral starts."""
    has_constant = any(v.symbol.name == "C" and v.given is None for v in variables)
    parts = list(walk(reader.parse(pasted.latex).chains))
    if has_constant and any(isinstance(p, Integration) and p.low is None for p in parts):
        raise ValueError(
            "C beside an integral without limits: what is it? Say --let 'C=0', or its value where "
            "the integral starts."
        )


def _give_values(
    variables: Sequence[Variable], pasted: Pasted, reader: Reader
) -> tuple[Variable, ...]:
    given: dict[sp.Basic, sp.Expr] = {}
    for text in pasted.values:
        for relation in _read_relations(text, reader):
            if not (isinstance(relation, sp.Equality) and relation.lhs.is_Symbol):
                raise ValueError(f"{text}: a value is said as letter=expression")
            given[relation.lhs] = relation.rhs
    return tuple(replace(v, given=given.get(v.symbol)) for v in variables)


def _read_relations(text: str, reader: Reader) -> list[sp.Basic]:
    read = reader.parse(text)
    relations = [r for chain in read.chains for r in read.meaning().relate(chain)]
    if not relations:
        raise ValueError(f"{text}: it has no relation sign")
    return relations


def _narrow(
    variables: Sequence[Variable], relations: Sequence[sp.Basic]
) -> tuple[tuple[Variable, ...], tuple[sp.Basic, ...]]:
    """Put relations of one letter into its set; the others stay relations."""
    sets = {v.symbol: v.within for v in variables if v.given is None}
    where = []
    for relation in relations:
        symbol = next(iter(relation.free_symbols), None)
        alone = len(relation.free_symbols) == 1 and symbol in sets
        inside = sets[symbol].intersect(relation.as_set()) if alone else None
        if isinstance(inside, sp.Interval):
            sets[symbol] = inside
        else:
            where.append(relation)
    return tuple(replace(v, within=sets.get(v.symbol, v.within)) for v in variables), tuple(where)


def _describe(variable: Variable) -> str:
    if variable.given is not None:
        return f"= {variable.given}"
    names = {sp.S.Reals: "real", sp.S.Naturals: "a natural number"}
    kind = names.get(variable.within, f"in {variable.within}")
    return f"{kind}, for each index" if isinstance(variable.symbol, sp.IndexedBase) else kind
