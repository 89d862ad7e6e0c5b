r"""Letters of a single equation that are given by others: x=r\cos\varphi, \dot x, A+B+C=\pi."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from mechproof.latex import Reader
from mechproof.latex.sides import INVERSES
from mechproof.latex.values import OF_SIGNS, UNSMOOTH, depends, differentiate, settle_all
from mechproof.nomenclature.adjacent_letters import RUNNING
from mechproof.nomenclature.said_relations import read_relations
from mechproof.nomenclature.shown_letters import name_symbol
from mechproof.pipeline.moving_letters import Moving, find_moving, find_rates
from mechproof.record import ValueWhere, Variable
from mechproof.record.unit_notation import is_unit

# Matches a number with what may be its unit after a blank.
_WITH_UNIT = re.compile(r"[-+\d.]+(?:\s|~|\\[,:;!])+(?:\\mathrm\s*\{)?([^\W\d_]+)\}?\s*")
_DECIMAL = re.compile(r"-?\d+\.\d+")
_ACCENTS = re.compile(r"\\d{1,3}ot(?![A-Za-z])|'+")


def read_values(said: Iterable[str], reader: Reader) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    r"""Yield letters with the values given for them, x=r\cos t."""
    for text in said:
        for relation in read_relations(text, reader):
            if not (isinstance(relation, sp.Equality) and relation.lhs.is_Symbol):
                raise ValueError(f"{text}: a value is written letter=expression")
            yield relation.lhs, relation.rhs


def find_decimals(said: Iterable[str], variables: Sequence[Variable]) -> dict[sp.Basic, str]:
    """Return the digits of letters with decimal values, which count as rounded, as if printed."""
    values = ((name.strip(), value.strip()) for name, _, value in (x.partition("=") for x in said))
    digits = {name: value for name, value in values if _DECIMAL.fullmatch(value)}
    return {v.symbol: digits[name] for v in variables for name in v.latex if name in digits}


def refuse_units(said: Iterable[str], letters: Collection[str]) -> None:
    """Refuse a value with a unit, unless its letters occur in the equation."""
    for text in said:
        found = _WITH_UNIT.fullmatch(text.partition("=")[2].strip())
        if found and is_unit(found[1]) and not {*found[1]} & {*letters}:
            raise ValueError(
                f"--let {text}: {found[1]} after a number: units are not read in a single "
                "equation, only in papers; give numbers alone, all in matching units"
            )


def solve_equation(
    equation: sp.Equality, moving: Moving, said: Sequence[sp.Basic]
) -> tuple[sp.Basic, sp.Expr]:
    r"""Return a letter that an equation gives in terms of others, A+B+C=\pi, with its value.

    It is alone on a side; or it or its reciprocal has only a number as factor; or its range makes
    it an inverse sine, cosine or tangent, or a square root; or its factor cannot be zero, as in
    a/\sin\alpha=b/\sin\beta. Of several, those that depend on other letters come first, then
    those alone on a side, then the last by name, or the first if it has such a factor.
    """
    sides = (equation.lhs, equation.rhs), (equation.rhs, equation.lhs)
    alone = [(one, other) for one, other in sides if one.is_Symbol and not other.has(one)]
    rest = equation.lhs - equation.rhs
    letters = sorted(rest.free_symbols, key=str, reverse=True)
    for letter, power in ((letter, power) for power in (1, -1) for letter in letters):
        sum_of_it = rest.subs(letter, letter**power)
        factor = sum_of_it.diff(letter)
        if factor.is_number and factor != 0:
            alone.append((letter, sp.expand(letter - sum_of_it / factor) ** power))
    alone = alone or [*_invert(equation, letters, said)]
    alone = alone or [*_take_roots(rest, letters, said)]
    for letter in () if alone else letters[::-1]:
        factor = sp.together(rest.diff(letter))
        if not factor.has(letter) and _is_never_zero(sp.numer(factor), said):
            alone.append((letter, ValueWhere(sp.expand(letter - rest / factor), factor)))
    if not alone:
        raise ValueError(
            f"--where {equation.lhs}={equation.rhs}: it cannot be solved for a letter: "
            "give the value of one by --let"
        )
    letter, value = min(alone, key=lambda one: one[0] not in moving.letters)
    if letter not in (equation.lhs, *moving.letters) and value.free_symbols & {*moving.letters}:
        raise ValueError(
            f"--where {equation.lhs}={equation.rhs}: {letter} would depend on what others depend "
            "on: give the value of another one by --let"
        )
    return letter, value


def _invert(
    equation: sp.Equality, letters: Sequence[sp.Basic], said: Sequence[sp.Basic]
) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    r"""Yield letters that an inverse function gives in their range: l\sin\psi=r\sin\varphi."""
    pairs = ((equation.lhs, equation.rhs), (equation.rhs, equation.lhs))
    for letter, (side, other) in product(letters, pairs):
        factor, wave = side.as_independent(letter, as_Add=False)
        if type(wave) not in INVERSES or other.has(letter):
            continue
        inverse, values = INVERSES[type(wave)]
        rate = sp.diff(wave.args[0], letter)
        if wave.args[0] != rate * letter or not rate.is_Rational:
            continue
        own = _list_sets(letter, said)
        run = sp.imageset(letter, rate * letter, sp.Intersection(*own)) if own else sp.S.Reals
        if run.is_subset(values):
            yield letter, inverse(other / factor) / rate


def _take_roots(
    rest: sp.Expr, letters: Sequence[sp.Basic], said: Sequence[sp.Basic]
) -> Iterator[tuple[sp.Basic, sp.Expr]]:
    """Yield letters of which only the square occurs, and that are said not to be negative."""
    for letter in letters:
        own = _list_sets(letter, said)
        square = rest.subs(letter, sp.sqrt(letter))
        factor = square.diff(letter)
        is_met = own and sp.Intersection(*own).is_subset(sp.Interval(0, sp.oo))
        if is_met and factor.is_number and factor != 0:
            yield letter, sp.sqrt(sp.expand(letter - square / factor))


def _is_never_zero(factor: sp.Expr, said: Sequence[sp.Basic]) -> bool:
    """Return whether all factors are nonzero, by themselves or by what is said of them."""
    return all(
        x.is_nonzero or (x.is_Symbol and any(0 not in values for values in _list_sets(x, said)))
        for x in sp.Mul.make_args(factor)
    )


def _list_sets(letter: sp.Basic, said: Sequence[sp.Basic]) -> list[sp.Set]:
    """List the sets to which inequalities of polynomials and their moduli restrict a letter."""
    own = (one for one in said if one.free_symbols == {letter})
    return [one.as_set() for one in own if _is_plain(one, letter)]


def _is_plain(relation: sp.Basic, letter: sp.Basic) -> bool:
    opened = relation.xreplace({modulus: modulus.args[0] for modulus in relation.atoms(sp.Abs)})
    return isinstance(opened, sp.Rel) and all(x.is_polynomial(letter) for x in opened.args)


def give_values(
    variables: Sequence[Variable], values: Iterable[tuple[sp.Basic, sp.Expr]]
) -> tuple[Variable, ...]:
    """Return variables with their values."""
    given: dict[sp.Basic, sp.Expr] = {}
    for letter, value in values:
        if letter in given:
            raise ValueError(f"--let {letter}={value}: {letter} already has a value")
        given[letter] = value
    for symbol, value in given.items():
        if any(depends(s, {symbol}, given) for s in value.free_symbols):
            raise ValueError(f"--let {symbol}={value}: the letter is defined by itself")
    counts = {v.symbol for v in variables if v.within == sp.S.Naturals}
    for symbol in counts & given.keys():
        value = given[symbol]
        if not (value.is_integer and value.is_nonnegative):
            raise ValueError(
                f"--let {symbol}={value}: {symbol} is a natural number here; add --natural for "
                "the letters of its value"
            )
    return tuple(replace(v, given=given.get(v.symbol)) for v in variables)


def find_given_moving(
    variables: Sequence[Variable],
    functions: Mapping[str, str],
    differentials: Collection[str],
    given: Collection[str],
) -> Moving:
    """Return the letters that depend on others; if a letter has a value, the value says on which.

    The derivative of a letter with a value, next to derivatives of other letters, is worked out as
    a printed derivative is.
    """
    prints = [v.latex[0] for v in variables]
    derived = {name_symbol(_ACCENTS.sub("", x)) for x in prints if _ACCENTS.search(x)}
    if derived & {*given} and derived - {*given}:
        differentials = {*differentials, "'"}
    # A prime may mean the derivative by a letter that has a value.
    known = set() if any("'" in x for x in prints) else {*given} - derived
    known -= {name_symbol(x) for x in prints if _ACCENTS.search(x)}
    shown = [v for v in variables if name_symbol(v.latex[0]) not in known]
    moving = find_moving(shown, functions, differentials)
    unclear = derived - {*given} - {name_symbol(str(letter)) for letter in moving.letters}
    if derived & {*given} and unclear:
        raise ValueError(
            f"derivatives of {min(unclear)} and of a letter with a value: by which letters? Print "
            r"each as a fraction, \frac{d}{dx}(…)"
        )
    return moving


def find_parameters(
    variables: Sequence[Variable], differentials: Collection[str]
) -> dict[sp.Basic, sp.Symbol]:
    """Return the running letter in the value of each letter in a denominator, x of dy/dx."""
    values = {v.symbol: v.given for v in variables if v.given is not None}
    moved = {v.symbol for v in variables if v.latex and v.latex[0] in RUNNING}
    found: dict[sp.Basic, sp.Symbol] = {}
    for symbol in (v.symbol for v in variables if v.latex and v.latex[0] in differentials):
        value = settle_all(symbol, values)
        running = [*(value.free_symbols & moved)]
        if symbol in values and len(running) == 1:
            found[symbol] = running[0]
    return found


def find_all_rates(
    variables: Sequence[Variable], moving: Moving, called: Mapping[sp.Basic, sp.Symbol]
) -> dict[sp.Basic, sp.Expr]:
    """Return derivatives of letters that have values, also by letters that vary in these."""
    values = {v.symbol: v.given for v in variables if v.given is not None}
    free = {x: steps for x, steps in moving.letters.items() if x not in values}
    moved = {one for x, (_, own) in free.items() for one in (x, *own)}
    printed = {v.symbol for v in variables}
    rates: dict[sp.Basic, sp.Expr] = {}
    for letter, (by, own) in moving.letters.items():
        steps = (letter, *own)
        first = next((n for n, step in enumerate(steps) if step in values), len(own))
        value = settle_all(steps[first], values)
        is_fixed = first == 0 and not value.free_symbols & moved
        if is_fixed or value.has(*UNSMOOTH, *OF_SIGNS):
            continue
        last = max(n for n, step in enumerate(steps) if first or step in printed)
        for rate in steps[first + 1 : last + 1]:
            value = rates[rate] = settle_all(differentiate(value, by, free), values)
    return rates | find_rates([v for v in variables if v.symbol not in rates], called)
