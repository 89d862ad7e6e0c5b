"""Letters of sums: whole numbers to which they go, and families of numbers that have indices.

In a mapping of names a whole number stands twice: itself, where it is a number among others, and
as `sp.Tuple` of itself, where it is a limit or an index.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp
from sympy.logic.boolalg import Boolean

from mechproof.coq.terms import Names, name_symbols, write_term
from mechproof.proof.canonical_sums import write_out
from mechproof.record.parts import find_free, find_parts, replace_parts
from mechproof.record.substitution import substitute

# Of every family, the number for each choice of indices.
Laws = Mapping[sp.Basic, sp.Lambda]


def has_families(*expressions: sp.Basic) -> bool:
    """Return whether there are sums, or parts of some."""
    return bool(find_parts(sp.Tuple(*expressions), sp.Sum, sp.Indexed, sp.KroneckerDelta))


def find_wholes(*expressions: sp.Basic) -> set[sp.Basic]:
    """Return the letters of whole numbers up to which is summed."""
    sums = find_parts(sp.Tuple(*expressions), sp.Sum)
    return {limit[2] for total in sums for limit in total.limits}


def find_ranks(*expressions: sp.Basic) -> dict[sp.Basic, int]:
    """Return the families with the number of their indices."""
    return {part.base: len(part.indices) for part in find_parts(sp.Tuple(*expressions), sp.Indexed)}


def list_letters(*expressions: sp.Basic) -> tuple[sp.Basic, ...]:
    """List real letters, whole numbers, and families; each kind by name."""
    wholes, ranks = find_wholes(*expressions), find_ranks(*expressions)
    labels = {base.label for base in ranks}
    free = set().union(*(find_free(e) for e in expressions))
    letters = {s for s in free - labels if isinstance(s, sp.Symbol)}
    kinds = (letters - wholes, wholes & letters, ranks)
    return tuple(s for kind in kinds for s in sorted(kind, key=lambda s: (ranks.get(s, 0), str(s))))


def name_letters(symbols: Iterable[sp.Basic], *expressions: sp.Basic) -> Names:
    """Name the letters of a statement, of which these are parts."""
    names = dict(name_symbols(symbols))
    for whole in find_wholes(*expressions):
        if whole in names:
            names[sp.Tuple(whole)] = names[whole]
            names[whole] = f"(INR {names[whole]})"
    return names


def write_binders(symbols: Iterable[sp.Basic], names: Names, *expressions: sp.Basic) -> str:
    """Write the letters with their kinds."""
    listed, ranks = list(symbols), find_ranks(*expressions)
    kinds: dict[str, list[str]] = {}
    for symbol in listed:
        whole = names.get(sp.Tuple(symbol))
        kind = "nat -> " * ranks.get(symbol, 0) + "R" if whole is None else "nat"
        kinds.setdefault(kind, []).append(whole or names[symbol])
    if list(kinds) in ([], ["R"]):
        return f"{' '.join(kinds['R'])} : R" if kinds else ""
    return " ".join(f"({' '.join(letters)} : {kind})" for kind, letters in kinds.items())


def write_value(symbol: sp.Basic, value: sp.Basic, names: Names) -> str:
    """Write what stands for a letter at a point."""
    if isinstance(value, sp.Lambda):
        used = {v: f"i{k}" for k, v in enumerate(value.variables) if value.expr.has(v)}
        letters = " ".join(used.get(v, "_") for v in value.variables)
        inner = {v: f"(INR {name})" for v, name in used.items()}
        return f"(fun {letters} : nat => {write_term(value.expr, inner)})"
    return f"{value}%nat" if sp.Tuple(symbol) in names else write_term(value, {})


def give_laws(symbols: Iterable[sp.Basic], relations: Iterable[sp.Basic], slope: int) -> Laws:
    """Give each family numbers that depend on the indices where the slope is not zero."""
    found = {}
    for place, (family, rank) in enumerate(sorted(find_ranks(*relations).items(), key=str)):
        if family in set(symbols):
            indices = [sp.Dummy() for _ in range(rank)]
            change = sum(((k + 1) * index for k, index in enumerate(indices)), sp.S.Zero)
            law = sp.Rational(1, place + 2) * (1 + sp.Rational(slope, 7) * change)
            found[family] = sp.Lambda(tuple(indices), law)
    return found


def write_at(expression: sp.Basic, point: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """Write sums out at a point, with the numbers of the families in them."""
    if not has_families(expression):
        return expression
    if isinstance(expression, Boolean):
        sides = (write_at(side, point) for side in expression.args)
        return expression.func(*sides, evaluate=False)
    ends = {whole: point[whole] for whole in find_wholes(expression)}
    written = write_out(substitute(expression, ends))
    numbers = {item: point[item.base] for item in find_parts(written, sp.Indexed)}
    laws = {item: law for item, law in numbers.items() if isinstance(law, sp.Lambda)}
    return replace_parts(written, {item: law(*item.indices) for item, law in laws.items()})
