"""A pasted equation -> its judgements: what is not said is taken as a real number, and told."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from mechproof.document.letters import is_vector, name_symbol, show_letter
from mechproof.document.relations import narrow, read_relations
from mechproof.latex import Reader, ReadingError
from mechproof.latex.errors import Remedies
from mechproof.latex.expansion import read_row
from mechproof.latex.names import INDEX
from mechproof.latex.tokens import tokenize
from mechproof.latex.tree import Integration, walk
from mechproof.latex.values import depends
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Judgement
from mechproof.record import Definition, Equality, Equation, Notation, Paper, Part, Row, Variable
from mechproof.tools.processes import WorkerError, run_tasks

COMMAND = Remedies(
    name="Say --name '{0}'.",
    bracket="Say --factor '{0}' for the product, or --name '{0}(…)' for one quantity.",
    function="Print a function that is the same everywhere (ln, lg, arctg).",
    scope="Print another letter for '{0}' where it is bound.",
    lower_limit="Say --from 0, or where else it starts.",
    family="Leave --name '{0}' out.",
    membership="Print an interval as a relation, 0<x<1; say --natural for a letter that counts "
    "from 1. Letters are real anyway.",
    rate=r"Print a derivative as a fraction, \frac{{d}}{{dx}}(…). Otherwise:",
)
NUMBER = "(pasted)"
_WRAPPERS = (
    *(("$$", "$$"), ("$", "$"), (r"\[", r"\]"), (r"\(", r"\)")),
    *((rf"\begin{{{x}}}", rf"\end{{{x}}}") for x in ("equation", "equation*", "displaymath")),
)
_OPERATOR = re.compile(r"\\operatorname\*?\s*\{\s*(\w+)\s*\}")
_IMPLIES = (r"\Rightarrow", r"\implies", r"\Longrightarrow")
_IMAGINARY = (r"\mathrm{i}", r"\mathrm{j}")
_LABEL = re.compile(r"\\(?:tag\*?|label)\{[^{}]*\}|\\n(?:onumber|otag)")


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
        return str(error).removeprefix(f"row {NUMBER!r}: ")
    except RecursionError:
        return "it is nested too deeply to be read"


def judge_pasted(pasted: Pasted) -> Checked:
    """Judge a pasted equation; `ValueError` (also `ReadingError`) for what cannot be read."""
    pasted = _take_condition(replace(pasted, latex=_unwrap(pasted.latex)))
    variables, notation, relations = _read_letters(pasted)
    printed = _read_conditions(pasted.latex, Reader(variables, notation, COMMAND))
    variables, relations = _count_from_zero(variables, relations + printed)
    said = {s for relation in relations for s in relation.free_symbols}
    variables, where = narrow(variables, relations)
    reader = Reader(variables, notation, COMMAND)
    free = tuple(v.symbol for v in variables if v.given is None and isinstance(v.symbol, sp.Symbol))
    _refuse_constant(variables, pasted, reader)
    on = Part(" and ".join(pasted.where), where=where) if pasted.where else None
    rows = read_row(Equation(NUMBER, pasted.latex, defines=free, on=on), reader)
    if printed:
        rows = tuple(replace(row, on=row.on and replace(row.on, where=where)) for row in rows)
    tied = {s for v in variables if v.given is not None for s in v.given.free_symbols}
    rows = tuple(_compare_tied(row, tied) for row in rows)
    _refuse_definitions(rows, said)
    paper = Paper("pasted", "", variables, ())
    read = tuple(judge(_rename(row, len(rows)), paper) for row in rows)
    return Checked(read, {v.latex[0]: _describe(v) for v in variables})


def _compare_tied(row: Row, tied: Collection[sp.Basic]) -> Row:
    """Compare what is printed of a letter by which another is given: it is not introduced."""
    says = row.says
    if not (isinstance(says, Definition) and says.symbol in tied):
        return row
    return replace(row, says=Equality(says.symbol, says.printed, "member"))


def _take_condition(pasted: Pasted) -> Pasted:
    r"""Take what stands before the one arrow of an implication as where its conclusion is meant."""
    arrows = [token for token in tokenize(pasted.latex) if token.text in _IMPLIES]
    if len(arrows) != 1:
        return pasted
    (arrow,) = arrows
    condition, conclusion = pasted.latex[: arrow.start], pasted.latex[arrow.end :]
    return replace(pasted, latex=conclusion, where=(*pasted.where, condition.strip()))


def _read_letters(pasted: Pasted) -> tuple[tuple[Variable, ...], Notation, list[sp.Basic]]:
    """Return the letters with their values, how they are written, and what is said of them."""
    counts = _find_counts(pasted)
    variables = _declare(pasted, counts)
    notation = Notation(factors=(*pasted.factors, *counts), lower_limit=_read_limit(pasted))
    reader = Reader(variables, notation, COMMAND)
    relations = [r for text in pasted.where for r in read_relations(text, reader)]
    equations = [r for r in relations if isinstance(r, sp.Equality)]
    variables = _give_values(variables, [*_read_values(pasted, reader), *map(_solve, equations)])
    return variables, notation, [r for r in relations if r not in equations]


def read_expression(pasted: Pasted) -> tuple[sp.Expr, Mapping[sp.Symbol, sp.Set]]:
    """Return what is pasted, of an equation the right side, and the sets of its letters.

    `ValueError` (also `ReadingError`) for what cannot be read, and for relations between letters.
    """
    pasted = replace(pasted, latex=_unwrap(pasted.latex))
    variables, notation, relations = _read_letters(pasted)
    variables, where = narrow(variables, relations)
    if where:
        raise ValueError(f"--where {where[0]}: it is no range of one letter")
    read = Reader(variables, notation, COMMAND).parse(pasted.latex)
    (chain,) = read.chains if len(read.chains) == 1 else (None,)
    if chain is None or chain.condition or len(chain.members) > 2:
        raise ValueError("one expression is needed, or an equation whose right side it is")
    expression = read.meaning().of(chain.members[-1])
    given = {v.symbol: v.given for v in variables if v.given is not None}
    for _ in given:
        expression = expression.subs(given)
    return expression, {v.symbol: v.within for v in variables if v.given is None}


def _rename(row: Row, count: int) -> Row:
    number = row.number.removeprefix(f"{NUMBER}, ") if count > 1 else "equation"
    return replace(row, number=number)


def _unwrap(latex: str) -> str:
    """Return an equation without what stands around it in a paper."""
    text = _LABEL.sub("", latex).strip()
    for opening, closing in _WRAPPERS:
        if len(text) > len(opening) + len(closing) and text.startswith(opening):
            text = text.removeprefix(opening).removesuffix(closing).strip()
    return text.rstrip(".,;").rstrip()


def _refuse_definitions(rows: Sequence[Row], said: Collection[sp.Basic]) -> None:
    """Refuse a letter that is introduced twice, or of which more is said than its definition."""
    defined = [row.says.symbol for row in rows if isinstance(row.says, Definition)]
    for symbol in dict.fromkeys(defined):
        if defined.count(symbol) > 1:
            raise ValueError(f"{symbol} is defined twice: say one of them by --let")
        if symbol in said:
            raise ValueError(
                f"the equation defines {symbol}, of which its condition or --where says something: "
                "say its value by --let, or leave that out"
            )


# Letters ----------------------------------------------------------------------------------------


def _declare(pasted: Pasted, counts: Collection[str]) -> tuple[Variable, ...]:
    """Make a variable of each name that is said and of each letter that is met."""
    said = dict.fromkeys((*pasted.names, *pasted.natural))
    named = [_make(latex, pasted, counts) for latex in said]
    reader = Reader(named, Notation(factors=(*pasted.factors, *counts)), COMMAND)
    prints = (pasted.latex, *pasted.where, *pasted.values)
    letters = dict.fromkeys(letter for text in prints for letter in reader.collect(text))
    _refuse_others(letters, prints)
    families = {x.partition("_")[0] for x in letters if INDEX in x}
    kept = [x for x in letters if INDEX in x or x.partition("_")[0] not in families or "_" not in x]
    variables = (*named, *(_make(x, pasted, counts) for x in kept))
    met: dict[str, str] = {}
    for variable in variables:
        (latex,) = variable.latex
        if (other := met.setdefault(name_symbol(str(variable.symbol)), latex)) != latex:
            raise ValueError(f"{other} and {latex} are too much alike: print another letter")
    return variables


def _refuse_others(letters: Collection[str], prints: Iterable[str]) -> None:
    """Refuse what is no real number: vectors, the imaginary unit, operators that are not known."""
    operators = {rf"\mathrm{{{name}}}" for text in prints for name in _OPERATOR.findall(text)}
    for letter in letters:
        if is_vector(letter):
            raise ValueError(
                f"{letter} is no number: vectors and matrices need their components: check these, "
                f"or say --name '{letter}' where it is a number"
            )
        if letter in _IMAGINARY:
            raise ValueError(
                f"{letter} is the imaginary unit: complex numbers are not read in a single "
                f"equation, but in a paper; say --name '{letter}' where it is a real number"
            )
        if letter in operators:
            raise ValueError(
                f"{letter} is printed as an operator, which is not known; say --name "
                f"'{letter}' where it is a number"
            )


def _make(latex: str, pasted: Pasted, counts: Collection[str]) -> Variable:
    if not any(sign.isalpha() for sign in latex):
        raise ValueError(f"the name {latex!r} has no letter")
    name = show_letter(latex.replace(f"_{INDEX}", ""))
    if INDEX in latex:
        return Variable(sp.IndexedBase(name, real=True), latex, latex=(latex,))
    variable = Variable(sp.Symbol(name, real=True), latex, latex=(latex,))
    return _count(variable) if latex in (*pasted.natural, *counts) else variable


def _count(variable: Variable) -> Variable:
    """Make a natural number of a letter."""
    symbol = sp.Symbol(variable.symbol.name, integer=True, positive=True)
    return replace(variable, symbol=symbol, within=sp.S.Naturals)


def _count_from_zero(
    variables: Sequence[Variable], relations: Sequence[sp.Basic]
) -> tuple[tuple[Variable, ...], list[sp.Basic]]:
    """Let letters that count from 1 count from 0 where that is said."""
    said = [r for r in relations if isinstance(r, sp.Ge | sp.Gt | sp.Le | sp.Lt)]
    least = {r.gts for r in said if r.gts in r.free_symbols and r.subs(r.gts, 0) == sp.true}
    least |= {v.symbol for v in variables if v.given == 0}
    anew = {
        v.symbol: sp.Symbol(v.symbol.name, integer=True, nonnegative=True)
        for v in variables
        if v.within == sp.S.Naturals and v.symbol in least
    }
    from_zero = [
        replace(
            v,
            symbol=anew.get(v.symbol, v.symbol),
            within=sp.S.Naturals0 if v.symbol in anew else v.within,
            given=v.given if v.given is None else v.given.xreplace(anew),
        )
        for v in variables
    ]
    return tuple(from_zero), [relation.xreplace(anew) for relation in relations]


def _find_counts(pasted: Pasted) -> tuple[str, ...]:
    r"""Return the letters of n! and up to which sums go, n also in \sum_{k=1}^{n-1}."""
    found: dict[str, None] = dict.fromkeys(pasted.natural)
    for latex in (pasted.latex, *pasted.where, *pasted.values):
        texts = [token.text for token in tokenize(latex)]
        for place, text in enumerate(texts):
            if text in (r"\sum", r"\prod"):
                found |= dict.fromkeys(_letters_of_limit(texts[place + 1 :]))
            if text == "!":
                found |= dict.fromkeys(_letters_of_factorial(texts[:place]))
            if text == r"\binom":
                found |= dict.fromkeys(_letters_of_binomial(texts[place + 1 :]))
    return tuple(x for x in found if x not in pasted.names)


def _letters_of_factorial(texts: list[str]) -> Iterator[str]:
    """Yield the letter before the sign, or those of the plain sum in the bracket before it."""
    start = len(texts) - 1
    if texts[-1:] == [")"] and "(" in texts:
        start = len(texts) - texts[::-1].index("(")
    inside = texts[start:]
    if all(text.isalnum() or text in ("+", "-", ")") for text in inside):
        yield from (text for text in inside if text.isalpha())


def _letters_of_binomial(texts: list[str]) -> Iterator[str]:
    """Yield the letters that stand alone or in a plain sum in either of two groups of braces."""
    for _ in range(2):
        close = texts.index("}") if "}" in texts else 0
        yield from _letters_of_factorial(["(", *texts[1:close], ")"])
        texts = texts[close + 1 :]


def _letters_of_limit(texts: list[str]) -> Iterator[str]:
    """Yield the letters of the upper limit that follows a lower one, if it is a plain sum."""
    low = texts.index("}") + 1 if texts[:1] == ["_"] and "}" in texts else 0
    if texts[low : low + 2] != ["^", "{"] or "}" not in texts[low:]:
        return
    limit = texts[low + 2 : texts.index("}", low)]
    if all(text.isalnum() or text in ("+", "-") for text in limit):
        yield from (text for text in limit if text.isalpha())


# What is said -----------------------------------------------------------------------------------


def _read_limit(pasted: Pasted) -> sp.Expr | None:
    if not pasted.lower_limit:
        return None
    read = Reader((), None, COMMAND).parse(pasted.lower_limit)
    if len(read.chains) > 1 or read.chains[0].relations:
        raise ValueError(f"{pasted.lower_limit}: a limit is one expression")
    limit: sp.Expr = read.meaning().of(read.chains[0].members[0])
    return limit


def _refuse_constant(variables: Sequence[Variable], pasted: Pasted, reader: Reader) -> None:
    """Refuse a C beside an integral without limits: it depends on where the integral starts."""
    has_constant = any(v.symbol.name == "C" and v.given is None for v in variables)
    parts = list(walk(reader.parse(pasted.latex, upper=1).chains))
    if has_constant and any(isinstance(p, Integration) and p.low is None for p in parts):
        raise ValueError(
            "C beside an integral without limits: what is it? Say --let 'C=0', or its value where "
            "the integral starts."
        )


def _read_values(pasted: Pasted, reader: Reader) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    for text in pasted.values:
        for relation in read_relations(text, reader):
            if not (isinstance(relation, sp.Equality) and relation.lhs.is_Symbol):
                raise ValueError(f"{text}: a value is written letter=expression")
            yield relation.lhs, relation.rhs


def _solve(equation: sp.Equality) -> tuple[sp.Basic, sp.Expr]:
    r"""Return the letter that an equation gives by others, A+B+C=\pi, with its value.

    It stands alone on a side, or has a number as its factor; of several the last is taken.
    """
    sides = (equation.lhs, equation.rhs), (equation.rhs, equation.lhs)
    alone = [(one, other) for one, other in sides if one.is_Symbol and not other.has(one)]
    rest = equation.lhs - equation.rhs
    for letter in sorted(rest.free_symbols, key=str, reverse=True):
        factor = rest.diff(letter)
        if factor.is_number and factor != 0:
            alone.append((letter, sp.expand(letter - rest / factor)))
    if not alone:
        raise ValueError(
            f"--where {equation.lhs}={equation.rhs}: it gives no letter by the others: say the "
            "value of one by --let"
        )
    return alone[0]


def _give_values(
    variables: Sequence[Variable], values: Iterable[tuple[sp.Basic, sp.Expr]]
) -> tuple[Variable, ...]:
    given: dict[sp.Basic, sp.Expr] = {}
    for letter, value in values:
        if letter in given:
            raise ValueError(f"--let {letter}={value}: {letter} has a value already")
        given[letter] = value
    for symbol, value in given.items():
        if any(depends(s, {symbol}, given) for s in value.free_symbols):
            raise ValueError(f"--let {symbol}={value}: the letter is given by itself")
    counts = {v.symbol for v in variables if v.within == sp.S.Naturals}
    for symbol in counts & given.keys():
        value = given[symbol]
        if not (value.is_integer and value.is_nonnegative):
            raise ValueError(
                f"--let {symbol}={value}: {symbol} is a natural number here; say --natural for "
                "letters of its value"
            )
    return tuple(replace(v, given=given.get(v.symbol)) for v in variables)


def _read_conditions(latex: str, reader: Reader) -> list[sp.Basic]:
    """Return what an equation itself says of where it is meant, if all of it is meant there."""
    read = reader.parse(latex, upper=1)
    conditions = {chain.condition for chain in read.chains}
    relations = [r for part in conditions if part for r in read.meaning().relate(part)]
    for relation in relations:
        if isinstance(relation, sp.Equality):
            raise ValueError(
                f"the condition {relation.lhs} = {relation.rhs}: say the value of a letter by --let"
            )
    return relations if len(conditions) == 1 else []


def _describe(variable: Variable) -> str:
    if variable.given is not None:
        return f"= {variable.given}"
    names = {
        sp.S.Reals: "real",
        sp.S.Naturals: "a natural number, from 1 on",
        sp.S.Naturals0: "a natural number, from 0 on",
    }
    kind = names.get(variable.within, f"in {variable.within}")
    return f"{kind}, for each index" if isinstance(variable.symbol, sp.IndexedBase) else kind
