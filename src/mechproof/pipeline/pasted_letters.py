"""The letters of a pasted equation: what each is taken to be, and the statements about them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp
from sympy.core.relational import Relational

from mechproof.latex import Reader
from mechproof.latex.errors import Remedies
from mechproof.latex.name_table import INDEX
from mechproof.latex.tokens import list_signs
from mechproof.latex.undeclared import UNSURE
from mechproof.nomenclature.adjacent_letters import find_factors, find_increments, find_phases
from mechproof.nomenclature.counting_letters import find_counts
from mechproof.nomenclature.possible_matrices import find_possible_matrices
from mechproof.nomenclature.said_relations import read_relations
from mechproof.nomenclature.shown_letters import is_vector, name_symbol, show_letter
from mechproof.pipeline import bold_letters, given_letters, special_letters
from mechproof.pipeline.moving_letters import (
    find_functions,
    find_moving,
    list_differentials,
    list_rates,
)
from mechproof.record import (
    AnyFunction,
    Notation,
    Variable,
    list_divisors,
    list_needs,
    list_partial,
)

COMMAND = Remedies(
    name="Add --name '{0}'.",
    bracket="Add --factor '{0}' for the product, or --name '{0}(…)', with the content of the "
    "bracket, for one quantity that nothing changes.",
    function="Print a function that is the same everywhere (ln, lg, arctg).",
    scope="Print another letter for '{0}' where it is bound.",
    lower_limit="Add --from 0, or wherever it starts.",
    family="Leave --name '{0}' out.",
    membership="Print an interval as a relation, 0<x<1; add --natural for a letter that counts "
    "from 1. Letters are real anyway.",
    rate=r"Print a derivative as a fraction, \frac{{d}}{{dx}}(…). Otherwise:",
    sign="",
    depends="If {0} depends on {1}, give its value, --let '{0}=…'. Otherwise:",
)
_OPERATOR = re.compile(r"\\operatorname\*?\s*\{\s*(\w+)\s*\}")
_IMAGINARY = (r"\mathrm{i}", r"\mathrm{j}", "j")


@dataclass(frozen=True)
class Pasted:
    """An equation and statements about its letters, all in LaTeX.

    `names` are prints of single quantities, `factors` letters that a bracket after them multiplies,
    `where` relations (`0<x<1`), `values` definitions (`C=0`), `natural` letters that count. Vectors
    have three components; with `has_matrices`, bold capitals are matrices of three rows and
    columns. Letters that are `called` are functions of others; the `unknown` among them are
    arbitrary.
    """

    latex: str
    names: tuple[str, ...] = ()
    factors: tuple[str, ...] = ()
    where: tuple[str, ...] = ()
    values: tuple[str, ...] = ()
    natural: tuple[str, ...] = ()
    lower_limit: str = ""
    has_matrices: bool = False
    called: Mapping[str, str] = field(default_factory=dict)
    unknown: tuple[str, ...] = ()

    @property
    def prints(self) -> tuple[str, ...]:
        """Return everything that is read: the equation, and the statements about its letters."""
        return (self.latex, *self.where, *self.values)


@dataclass(frozen=True)
class Letters:
    """Letters with their values, their notation, and the relations stated between them.

    `tied` are the letters of equations that give one of them by the others, `rates` the derivatives
    of letters that have values; `needed` must hold for values to be real, and `decimals` has the
    digits of the values that are rounded.
    """

    variables: tuple[Variable, ...]
    notation: Notation
    relations: Sequence[sp.Basic]
    tied: frozenset[sp.Basic]
    rates: Mapping[sp.Basic, sp.Expr]
    needed: Sequence[Relational]
    decimals: Mapping[sp.Basic, str]


def read_letters(pasted: Pasted) -> Letters:
    """Return the letters with their values, their notation, and the statements about them."""
    pasted = _take_special(pasted)
    counts = tuple(x for x in find_counts(pasted.prints, pasted.natural) if x not in pasted.names)
    # f(x) is no function of x if f is a factor, or the print a name.
    said = [*pasted.factors, *pasted.called, *(name.partition("(")[0] for name in pasted.names)]
    functions = find_functions(pasted.prints, said)
    variables = _declare(pasted, counts, functions)
    symbols = {r"\pi": sp.pi} | {latex: v.symbol for v in variables for latex in v.latex}
    phases = ((symbols.get(one), symbols.get(other)) for one, other in find_phases(pasted.prints))
    given = {name_symbol(text.partition("=")[0]) for text in (*pasted.values, *pasted.where)}
    called = special_letters.find_called(variables, pasted.called)
    others = [v for v in variables if v.symbol not in called]
    moving = given_letters.find_given_moving(
        others, functions, list_differentials(pasted.prints), given
    )
    notation = Notation(
        factors=(*pasted.factors, *counts),
        lower_limit=_read_limit(pasted),
        moving=bold_letters.move_entries(moving.letters),
        primed=moving.primed,
        phases=frozenset((one, other) for one, other in phases if one and other),
        called=called,
        functions=_find_functions(pasted),
    )
    reader = Reader(variables, notation, COMMAND)
    relations = [r for text in pasted.where for r in read_relations(text, reader)]
    equations = [r for r in relations if isinstance(r, sp.Equality)]
    left = [r for r in relations if r not in equations]
    values = [
        *given_letters.read_values(pasted.values, reader),
        *(given_letters.solve_equation(one, moving, left) for one in equations),
        *special_letters.give_unknown(variables, pasted.unknown, called),
    ]
    variables = given_letters.give_values(variables, values)
    given_letters.refuse_units(pasted.values, list_signs(pasted.latex))
    tied = frozenset(s for equation in equations for s in equation.free_symbols)
    rates = given_letters.find_all_rates(variables, moving, called)
    variables = tuple(
        one
        for v in (*variables, *moving.rates)
        for one in bold_letters.show_entries(replace(v, given=rates.get(v.symbol, v.given)))
    )
    parameters = given_letters.find_parameters(variables, list_differentials(pasted.prints))
    notation = replace(notation, parameters=parameters)
    decimals = given_letters.find_decimals(pasted.values, variables)
    return Letters(variables, notation, left, tied, rates, _list_needed(variables), decimals)


def _find_functions(pasted: Pasted) -> dict[str, type[sp.gamma]]:
    return special_letters.find_gamma(pasted.prints, (*pasted.names, *pasted.factors))


def _take_special(pasted: Pasted) -> Pasted:
    """Name special letters of a pasted equation as such: Euler's number e, factors, ..."""
    prints = pasted.prints
    said = [text.partition("=")[0].strip() for text in pasted.values]
    numbers = special_letters.find_declared(pasted.where)
    said += [*numbers, *special_letters.find_running(prints)]
    named = [*pasted.names, *(letter for letter in UNSURE if letter in said)]
    if "e" not in (*named, *pasted.natural) and special_letters.means_euler(prints):
        named.append("e")
        factors, values = (*pasted.factors, "e"), (*pasted.values, special_letters.EULER)
        pasted = replace(pasted, factors=factors, values=values)
    if any(map(special_letters.has_letter_d, prints)) and not any(
        map(special_letters.has_differential, prints)
    ):
        named.append("d")
    named += find_increments(prints)
    factors = (*pasted.factors, *find_factors(prints, numbers))
    return replace(pasted, names=tuple(dict.fromkeys(named)), factors=factors)


def _list_needed(variables: Sequence[Variable]) -> list[Relational]:
    """Return the conditions under which letters with values are real numbers."""
    needed: dict[Relational, None] = {}
    values = [v.given for v in variables if isinstance(v.given, sp.Expr) and v.given.free_symbols]
    for value in values:
        needs = [need for part in list_partial(value) for need in list_needs(part)]
        told = [sp.Gt(number, 0) if strict else sp.Ge(number, 0) for number, strict in needs]
        told += [sp.Ne(divisor, 0) for divisor in list_divisors(value)]
        # For numbers SymPy has already decided whether these hold.
        needed |= dict.fromkeys(relation for relation in told if isinstance(relation, Relational))
    positive = {relation.lhs for relation in needed if isinstance(relation, sp.Gt)}
    return [r for r in needed if isinstance(r, sp.Gt) or r.lhs not in positive]


def _declare(
    pasted: Pasted, counts: Collection[str], functions: Mapping[str, str]
) -> tuple[Variable, ...]:
    """Make a variable for each stated name and each letter that occurs."""
    bold = bold_letters.find_bold(pasted.prints, pasted.names)
    rates = [name for letter in functions for name in list_rates(letter, pasted.prints)]
    of = (*functions, *functions.values(), *rates)
    of = (*of, *special_letters.list_names(pasted.called, pasted.prints))
    said = dict.fromkeys((*pasted.names, *pasted.natural, *bold, *of))
    named = [_make(latex, pasted, counts) for latex in said]
    called = special_letters.find_called(named, pasted.called)
    moving = find_moving([v for v in named if v.symbol not in called], functions)
    notation = Notation(
        factors=(*pasted.factors, *counts),
        moving=moving.letters,
        primed=sp.Symbol("x", real=True),
        called=called,
        functions=_find_functions(pasted),
    )
    reader = Reader(named, notation, COMMAND)
    prints = pasted.prints
    letters = dict.fromkeys(letter for text in prints for letter in reader.collect(text))
    _refuse_others(letters, prints)
    valued = {text.partition("=")[0].strip() for text in pasted.values}
    _refuse_matrices([x for x in letters if x not in {*pasted.names, *valued}], prints)
    bold_letters.refuse_unclear([*letters, *({"d"} & {*said})], bold)
    families = {x.partition("_")[0] for x in letters if INDEX in x}
    kept = [x for x in letters if INDEX in x or x.partition("_")[0] not in families or "_" not in x]
    variables = (*named, *(_make(x, pasted, counts) for x in kept))
    met: dict[str, str] = {}
    for variable in variables:
        (latex,) = variable.latex
        if (other := met.setdefault(name_symbol(str(variable.symbol)), latex)) != latex:
            raise ValueError(f"{other} and {latex} are too similar: print another letter")
    return variables


def _refuse_others(letters: Collection[str], prints: Iterable[str]) -> None:
    """Refuse letters that are no real numbers: the imaginary unit, unknown operators."""
    operators = {rf"\mathrm{{{name}}}" for text in prints for name in _OPERATOR.findall(text)}
    for letter in letters:
        if letter in _IMAGINARY:
            is_one = "may be" if letter == "j" else "is"
            raise ValueError(
                f"{letter} {is_one} the imaginary unit: complex numbers are read in papers, not in "
                f"a single equation; add --name '{letter}' if it is a real number"
            )
        if letter in operators:
            raise ValueError(
                f"{letter} is printed as an operator, but is unknown; add --name "
                f"'{letter}' if it is a number"
            )


def _refuse_matrices(letters: Collection[str], prints: Iterable[str]) -> None:
    """Refuse a letter printed the way matrices are, in square brackets or with a sign T."""
    for letter, shown in find_possible_matrices(letters, prints):
        name = next(latex for latex in letters if name_symbol(latex) == letter)
        raise ValueError(
            rf"{name} may be a matrix, as {shown} suggests: print it bold, \mathbf {name}, or "
            f"add --name '{name}' if it is a number"
        )


def _make(latex: str, pasted: Pasted, counts: Collection[str]) -> Variable:
    if not any(sign.isalpha() for sign in latex):
        raise ValueError(f"the name {latex!r} has no letter")
    name = show_letter(latex.replace(f"_{INDEX}", ""))
    if INDEX in latex:
        return Variable(sp.IndexedBase(name, real=True), latex, latex=(latex,))
    if is_vector(latex) and latex not in pasted.names:
        shape = (3, 3) if pasted.has_matrices and bold_letters.is_capital(latex) else (3, 1)
        return Variable(sp.MatrixSymbol(name, *shape), latex, latex=(latex,))
    if latex in (*pasted.natural, *counts):
        symbol = sp.Symbol(name, integer=True, positive=True)
        return Variable(symbol, latex, within=sp.S.Naturals, latex=(latex,))
    return Variable(sp.Symbol(name, real=True), latex, latex=(latex,))


def count_from_zero(
    variables: Sequence[Variable], relations: Sequence[sp.Basic]
) -> tuple[tuple[Variable, ...], list[sp.Basic]]:
    """Make letters that count from 1 count from 0 if a relation or value includes 0."""
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


def _read_limit(pasted: Pasted) -> sp.Expr | None:
    if not pasted.lower_limit:
        return None
    read = Reader((), None, COMMAND).parse(pasted.lower_limit)
    if len(read.chains) > 1 or read.chains[0].relations:
        raise ValueError(f"{pasted.lower_limit}: a limit must be a single expression")
    limit: sp.Expr = read.meaning().of(read.chains[0].members[0])
    return limit


def describe(variable: Variable) -> str:
    """Return what a letter is taken to be."""
    if isinstance(variable.symbol, sp.MatrixSymbol):
        return (
            "a vector of 3 real numbers" if variable.symbol.shape[1] == 1 else "a real 3x3 matrix"
        )
    if isinstance(variable.given, AnyFunction):
        return "an arbitrary function, smooth everywhere"
    if variable.given is not None:
        return "Euler's number" if variable.given is sp.E else f"= {variable.given}"
    names = {
        sp.S.Reals: "real",
        sp.S.Naturals: "a natural number, 1 or more",
        sp.S.Naturals0: "a natural number, 0 or more",
    }
    kind = names.get(variable.within, f"in {variable.within}")
    return f"{kind}, for each index" if isinstance(variable.symbol, sp.IndexedBase) else kind
