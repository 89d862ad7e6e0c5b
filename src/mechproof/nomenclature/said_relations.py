"""Relations stated for letters: read, and made part of the sets of their letters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from mechproof.latex import Reader
from mechproof.record import Variable
from mechproof.record.relations import solve


def read_relations(text: str, reader: Reader) -> list[sp.Basic]:
    """Return the relations of a print; raises `ValueError` if it has none."""
    read = reader.parse(text)
    if not all(chain.relations for chain in read.chains):
        raise ValueError(f"{text}: it has no relation sign")
    said = [part for chain in read.chains for part in (chain, chain.condition) if part]
    return [relation for part in said for relation in read.meaning().relate(part)]


def read_value(letter: str, value: str, reader: Reader) -> tuple[sp.Symbol, sp.Expr] | None:
    """Return a letter and its value as a sentence prints them; None for anything else."""
    try:
        (relation,) = read_relations(f"{letter}={value}", reader)
        symbol, said = relation.args
    except ValueError:
        return None
    is_value = isinstance(symbol, sp.Symbol) and isinstance(said, sp.Expr)
    return (symbol, said) if is_value else None


def narrow(
    variables: Sequence[Variable], relations: Sequence[sp.Basic]
) -> tuple[tuple[Variable, ...], tuple[sp.Basic, ...]]:
    """Intersect the sets of letters with relations in one letter; return the other relations, too.

    Raises `ValueError` if nothing satisfies them, and for an equation, which gives a value.
    """
    sets = {v.symbol: v.within for v in variables if v.given is None}
    where = []
    for relation in [part for one in relations for part in _split(one)]:
        if isinstance(relation, sp.Equality):
            raise ValueError(_advise(relation))
        symbol = next(iter(relation.free_symbols), None)
        alone = len(relation.free_symbols) == 1 and symbol in sets
        found = _solve(relation, symbol) if alone else None
        inside = None if found is None else sets[symbol].intersect(found)
        if inside is sp.S.EmptySet:
            raise ValueError(f"no value of {symbol} satisfies all that is declared of it")
        if isinstance(inside, sp.Interval | sp.FiniteSet):
            sets[symbol] = inside
        else:
            where.append(relation)
    return tuple(replace(v, within=sets.get(v.symbol, v.within)) for v in variables), tuple(where)


def _advise(equation: sp.Equality) -> str:
    """Return advice for an equation that is given as a condition."""
    said = f"{equation.lhs}={equation.rhs}".replace("**", "^")
    if equation.lhs.is_Symbol:
        return f"{said} is a value, not a condition: declare let {said}"
    return (
        f"{said} is an equation, not a condition: declare its display as constraint (…), "
        "or the value of one of its letters by let"
    )


def _split(relation: sp.Basic) -> list[sp.Basic]:
    """Open an absolute value; one of several letters is kept as well."""
    parts = open_modulus(relation)
    is_kept = len(parts) > 1 and len(relation.free_symbols) > 1
    return [*parts, relation] if is_kept else parts


def open_modulus(relation: sp.Basic) -> list[sp.Basic]:
    """Write |x|<a as x<a and -a<x; return any other relation unchanged."""
    smaller = getattr(relation, "lts", None)
    if not isinstance(smaller, sp.Abs) or relation.gts.has(sp.Abs):
        return [relation]
    order = sp.Le if isinstance(relation, sp.Le | sp.Ge) else sp.Lt
    (inside,) = smaller.args
    return [order(inside, relation.gts), order(-relation.gts, inside)]


def _solve(relation: sp.Basic, symbol: sp.Basic) -> sp.Set | None:
    """Return the solution set of a relation between rational functions, None for any other.

    SymPy's solutions for other functions are not trusted.
    """
    is_rational = all(side.is_rational_function(symbol) for side in relation.args)
    return solve(relation, symbol) if is_rational else None
