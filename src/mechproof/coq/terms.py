"""SymPy's expressions -> terms of Coq's real numbers, with the conditions for their values.

Division, square roots and tangents are total functions in Coq: x / 0 is a number of which nothing
is known. So every term comes with the conditions under which it means what is printed.

The letters of sums are whole numbers, the upper limits, and families of numbers with indices. A
mapping of names contains each whole number twice: as itself, where it is a number among others, and
as `sp.Tuple` of itself, where it is a limit or an index.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import MappingProxyType

import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from mechproof.programs.operations import KINDS
from mechproof.proof.canonical_sums import write_out
from mechproof.record.parts import find_free, find_parts, replace_parts
from mechproof.record.substitution import substitute

Names = Mapping[sp.Basic, str]
_NO_NAMES: Names = MappingProxyType({})
# Names that a letter of a paper must not take.
TAKEN = re.compile(
    "R|PI|sin|cos|tan|atan|atan2|asin|acos|exp|ln|sqrt|Rabs|Rmin|Rmax|RInt|sinh|cosh|tanh|forall|"
    "exists|fun|in|let|match|with|end|as|return|if|then|else|Set|Prop|Type|at|using|where|fix|"
    "cofix|IF|E|F|INR|nat|sum_to|kronecker|is_derive|[HKSQNMDIVWZ][0-9]+"
)
# For every family, the number for each choice of indices.
Laws = Mapping[sp.Basic, sp.Lambda]


class UnwritableError(ValueError):
    """A part of a statement that has no term in Coq; its message says which."""


_FUNCTIONS = {row.sympy: row.coq for row in KINDS.values() if row.coq}
_RELATIONS: Mapping[type[sp.Basic], str] = {
    sp.Eq: "=",
    sp.Ne: "<>",
    sp.Lt: "<",
    sp.Le: "<=",
    sp.Gt: ">",
    sp.Ge: ">=",
}


def write_term(expression: sp.Basic, names: Names) -> str:
    """Write an expression with every operation in parentheses. Raises `UnwritableError`."""
    if expression in names:
        return names[expression]
    kind = expression.func
    if kind in _FUNCTIONS:
        arguments = " ".join(write_term(part, names) for part in expression.args)
        return f"({_FUNCTIONS[kind]} {arguments})"
    for type_, write in _WRITERS.items():
        if isinstance(expression, type_):
            return write(expression, names)
    raise UnwritableError(f"{kind.__name__} has no term")


def write_relation(relation: sp.Basic, names: Names) -> str:
    """Write a relation, a conjunction or a disjunction. Raises `UnwritableError`."""
    if isinstance(relation, sp.And | sp.Or):
        sign = " /\\ " if isinstance(relation, sp.And) else " \\/ "
        parts = sorted(relation.args, key=sp.default_sort_key)
        return "(" + sign.join(write_relation(part, names) for part in parts) + ")"
    if not isinstance(relation, Relational):
        raise UnwritableError(f"{type(relation).__name__} is not a relation")
    if isinstance(relation.lhs, sp.Derivative):
        return _write_derivative(relation.lhs, relation.rhs, names)
    left, right = (write_term(side, names) for side in relation.args)
    return f"({left} {_RELATIONS[relation.func]} {right})"


def _write_derivative(derivative: sp.Derivative, slope: sp.Basic, names: Names) -> str:
    """Write that a function of a letter has, at that letter, the derivative `slope`."""
    letter = names[derivative.variables[0]]
    body, value = (write_term(part, names) for part in (derivative.expr, slope))
    return f"(is_derive (fun {letter} : R => {body}) {letter} {value})"


def name_symbols(symbols: Iterable[sp.Basic], known: Names = _NO_NAMES) -> Names:
    """Give every symbol an identifier that no other symbol and no `known` name has."""
    names = dict(known)
    for symbol in symbols:
        plain = re.sub(r"\W+", "_", str(symbol), flags=re.ASCII).strip("_") or "x"
        plain = f"{plain}_" if TAKEN.fullmatch(plain) or plain[0].isdigit() else plain
        while plain in names.values():
            plain += "_"
        names[symbol] = plain
    return names


def list_needs(expression: sp.Basic) -> list[sp.Basic]:
    """List the conditions for an expression's parts to have values, except those shown by numbers.

    Conditions for integrands are not included: `list_integrals` lists the integrals.
    """
    found = (need for node in _list_outside(expression) for need in _need(node))
    return list(dict.fromkeys(need for need in found if need is not sp.true))


def list_integrals(expression: sp.Basic) -> list[sp.Integral]:
    """List the integrals of an expression, each once."""
    return [node for node in _list_outside(expression) if isinstance(node, sp.Integral)]


def _list_outside(expression: sp.Basic) -> list[sp.Basic]:
    """List an expression's parts, inner ones first, each once; of integrals only the limits."""
    found: dict[sp.Basic, None] = {}

    def visit(node: sp.Basic) -> None:
        parts = node.args
        if isinstance(node, sp.Integral):
            parts = tuple(limit for limits in node.limits for limit in limits[1:])
        for part in parts:
            if part not in found:
                visit(part)
        found[node] = None

    visit(expression)
    return [*found]


def _need(node: sp.Basic) -> Iterator[sp.Basic]:
    if isinstance(node, sp.Pow):
        if not node.exp.is_Rational or node.exp.q > 2:
            yield _relate(sp.Gt, node.base)
            return
        if node.exp.is_negative:
            yield _relate(sp.Ne, node.base)
        if node.exp.q == 2:
            yield _relate(sp.Ge, node.base)
    elif isinstance(node, sp.tan):
        yield _relate(sp.Ne, sp.cos(node.args[0]))
    elif isinstance(node, sp.log):
        yield _relate(sp.Gt, node.args[0])
    elif isinstance(node, sp.atan2):
        yield _relate(sp.Ne, sp.Add(*map(_square, node.args)))
    elif isinstance(node, sp.asin | sp.acos):
        yield sp.Le(sp.Abs(node.args[0]), 1)


def _square(part: sp.Expr) -> sp.Expr:
    """Square a part, unevaluated if it is long: SymPy would check at length if it is infinite."""
    return sp.Pow(part, 2, evaluate=not (part.is_number and isinstance(part, sp.Add)))


def _relate(relation: Callable[..., sp.Basic], part: sp.Basic) -> sp.Basic:
    """Relate a part to zero; a non-rational number stays unevaluated, for Coq to enclose."""
    return relation(part, 0, evaluate=not part.is_number or part.is_Rational)


def _write_number(number: sp.Rational, names: Names) -> str:
    text = f"{abs(number.p)}" if number.q == 1 else f"({abs(number.p)} / {number.q})"
    return f"(- {text})" if number < 0 else text


def _write_product(product: sp.Mul, names: Names) -> str:
    above = [part for part in product.args if not _is_below(part)]
    below = [
        sp.Pow(part.base, -part.exp, evaluate=False) for part in product.args if _is_below(part)
    ]
    text = " * ".join(write_term(part, names) for part in above) or "1"
    for part in below:
        text = f"{text} / {write_term(_plain(part), names)}"
    return f"({text})"


def _plain(power: sp.Pow) -> sp.Basic:
    return power.base if power.exp == 1 else power


def _is_below(part: sp.Basic) -> bool:
    return isinstance(part, sp.Pow) and bool(part.exp.is_Rational and part.exp.is_negative)


def _write_power(power: sp.Pow, names: Names) -> str:
    """Write a power: whole and half exponents by products and roots, others by exp and ln."""
    base, exponent = power.base, power.exp
    if not exponent.is_Rational or exponent.q > 2:
        return f"(exp ({write_term(exponent, names)} * (ln {write_term(base, names)})))"
    if exponent < 0:
        return f"(/ {write_term(_plain(sp.Pow(base, -exponent, evaluate=False)), names)})"
    if exponent.q == 2:
        root = f"(sqrt {write_term(base, names)})"
        return root if exponent.p == 1 else f"({root} ^ {exponent.p})"
    return f"({write_term(base, names)} ^ {exponent.p})"


def _write_integral(integral: sp.Integral, names: Names) -> str:
    if len(integral.limits) > 1 or len(integral.limits[0]) < 3:
        raise UnwritableError("an integral over several letters, or without limits, has no term")
    (letter, lower, upper) = integral.limits[0]
    inner = name_symbols([letter], {s: name for s, name in names.items() if s != letter})
    body = write_term(integral.function, inner)
    limits = " ".join(write_term(limit, names) for limit in (lower, upper))
    return f"(RInt (fun {inner[letter]} : R => {body}) {limits})"


def _write_total(total: sp.Sum, names: Names) -> str:
    """Write a sum, the last limit outermost."""
    opening, closing, inner = "", "", dict(names)
    for index, lower, upper in reversed(total.limits):
        if lower != 1 or sp.Tuple(upper) not in names:
            raise UnwritableError(f"a sum from {lower} to {upper} has no term")
        letter = name_symbols([index], {s: n for s, n in inner.items() if s != index})[index]
        inner |= {index: f"(INR {letter})", sp.Tuple(index): letter}
        opening += f"(sum_to {names[sp.Tuple(upper)]} (fun {letter} : nat => "
        closing += "))"
    return f"{opening}{write_term(total.function, inner)}{closing}"


def _write_element(element: sp.Indexed | sp.KroneckerDelta, names: Names) -> str:
    """Write a number of a family, or the Kronecker delta of two indices."""
    is_family = isinstance(element, sp.Indexed)
    name = names[element.base] if is_family else "kronecker"
    return f"({name} {' '.join(_write_indices(element, names))})"


def _write_indices(element: sp.Basic, names: Names) -> Iterator[str]:
    indices = element.indices if isinstance(element, sp.Indexed) else element.args
    for index in indices:
        if sp.Tuple(index) not in names:
            raise UnwritableError(f"{element} has an index outside of a sum")
        yield names[sp.Tuple(index)]


_WRITERS: Mapping[type[sp.Basic], Callable[..., str]] = {
    sp.Rational: _write_number,
    sp.Add: lambda total, names: f"({' + '.join(write_term(t, names) for t in total.args)})",
    sp.Mul: _write_product,
    sp.Pow: _write_power,
    sp.Integral: _write_integral,
    sp.Sum: _write_total,
    sp.Indexed: _write_element,
    sp.KroneckerDelta: _write_element,
    type(sp.pi): lambda number, names: "PI",
    type(sp.E): lambda number, names: "(exp 1)",
}


def has_families(*expressions: sp.Basic) -> bool:
    """Return whether there are sums, elements of families or Kronecker deltas."""
    return bool(find_parts(sp.Tuple(*expressions), sp.Sum, sp.Indexed, sp.KroneckerDelta))


def find_wholes(*expressions: sp.Basic) -> set[sp.Basic]:
    """Return the letters of whole numbers that are upper limits of sums."""
    sums = find_parts(sp.Tuple(*expressions), sp.Sum)
    return {limit[2] for total in sums for limit in total.limits}


def find_ranks(*expressions: sp.Basic) -> dict[sp.Basic, int]:
    """Return the families, each with its number of indices."""
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
    """Name the letters of a statement whose parts are the given expressions."""
    names = dict(name_symbols(symbols))
    for whole in find_wholes(*expressions):
        if whole in names:
            names[sp.Tuple(whole)] = names[whole]
            names[whole] = f"(INR {names[whole]})"
    return names


def write_binders(symbols: Iterable[sp.Basic], names: Names, *expressions: sp.Basic) -> str:
    """Write the letters with their kinds, as a quantifier binds them."""
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
    """Write the value of a letter at a point."""
    if isinstance(value, sp.Lambda):
        used = {v: f"i{k}" for k, v in enumerate(value.variables) if value.expr.has(v)}
        letters = " ".join(used.get(v, "_") for v in value.variables)
        inner = {v: f"(INR {name})" for v, name in used.items()}
        return f"(fun {letters} : nat => {write_term(value.expr, inner)})"
    return f"{value}%nat" if sp.Tuple(symbol) in names else write_term(value, {})


def give_laws(symbols: Iterable[sp.Basic], relations: Iterable[sp.Basic], slope: int) -> Laws:
    """Give each family numbers, which depend on the indices unless `slope` is zero."""
    found = {}
    for place, (family, rank) in enumerate(sorted(find_ranks(*relations).items(), key=str)):
        if family in set(symbols):
            indices = [sp.Dummy() for _ in range(rank)]
            change = sum(((k + 1) * index for k, index in enumerate(indices)), sp.S.Zero)
            law = sp.Rational(1, place + 2) * (1 + sp.Rational(slope, 7) * change)
            found[family] = sp.Lambda(tuple(indices), law)
    return found


def write_at(expression: sp.Basic, point: Mapping[sp.Basic, sp.Basic]) -> sp.Basic:
    """Write sums out at a point, with the point's numbers for the families in them."""
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
