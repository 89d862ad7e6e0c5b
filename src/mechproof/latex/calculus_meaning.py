"""Printed sums, integrals, limits and values at a place -> SymPy."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from mechproof.latex import tree
from mechproof.latex.matrix_meaning import is_matrix
from mechproof.latex.values import (
    depends,
    has_value,
    list_carried,
    list_moving,
    list_reached,
    make_running,
    refuse_unknown,
    settle,
    settle_all,
    split_tangents,
)
from mechproof.record import IntegralWithoutDifferential, ValueWhere

if TYPE_CHECKING:
    from mechproof.latex.meaning import Meaning

# Nodes that bind a variable of their own.
BINDING = (tree.Approach, tree.At, tree.Derivation, tree.Integration, tree.Repeated)
# Nodes whose variable runs through an interval, where cancelled divisors can vanish only at
# isolated points.
RUNNING = (tree.Approach, tree.Derivation, tree.Integration)


def give_repeated(meaning: Meaning, node: tree.Repeated) -> sp.Basic:
    """Return a sum or a product over an index.

    A divisor that the term cancels may vanish at a whole number, so the term requires it to be
    nonzero.
    """
    index = node.index.symbol
    before = {*meaning.lost}
    term = meaning.take_number(node.term, meaning.side(node.term))
    for factor in [factor for factor in meaning.lost if factor not in before]:
        is_zero_nowhere = factor.is_positive or isinstance(factor, sp.factorial)
        if factor.has(index) and not is_zero_nowhere:
            is_factorial = isinstance(1 / factor, sp.factorial)
            positive = (1 / factor).args[0] + 1 if is_factorial else factor**2
            term = ValueWhere(term, sp.log(positive))
    kind, nothing = (sp.Sum, 0) if node.name == "sum" else (sp.Product, 1)
    for other in node.apart:
        term = nothing + (term - nothing) * (1 - sp.KroneckerDelta(meaning.of(other), index))
    return kind(term, (index, meaning.of(node.low), meaning.of(node.high)))


def list_lost(divisors: Mapping[sp.Expr, sp.Expr], value: Any) -> Iterator[sp.Expr]:
    """Yield the factors of divisors that an expression no longer shows.

    `divisors` maps each divisor to the part of an expression that shows it.
    """
    kept = {power.base for power in value.atoms(sp.Pow) if power.exp.could_extract_minus_sign()}
    for divisor, shown in divisors.items():
        if value.has(shown):
            continue
        for factor in sp.Mul.make_args(divisor):
            is_kept = factor.as_base_exp()[0] in kept or value.has(1 / factor)
            if not (is_kept or (factor.is_number and factor.is_nonzero)):
                yield factor


def give_integral(meaning: Meaning, node: tree.Integration) -> sp.Basic:
    """Return an integral, from the declared lower limit if no limits are printed."""
    integrand = meaning.take_number(node.integrand, meaning.side(node.integrand))
    if node.differential is None:
        return IntegralWithoutDifferential(integrand)
    variable = meaning.of(node.differential)
    running, inside = _bind(meaning, node, integrand, variable)
    if node.low and node.high:
        limits = meaning.of(node.low), meaning.of(node.high)
        return sp.Integral(_take_range(inside, running, *limits), (running, *limits))
    if meaning.lower_limit is None:
        raise meaning.source.refuse(
            node.start,
            "an integral without limits: where does it start?",
            meaning.remedies.lower_limit,
        )
    return sp.Integral(inside, (running, meaning.lower_limit, variable))


def _take_range(integrand: sp.Expr, variable: sp.Symbol, low: sp.Expr, high: sp.Expr) -> sp.Expr:
    """Replace a law with a single piece by its expression if the limits lie within its range."""
    laws = {law: law.args[0] for law in integrand.atoms(sp.Piecewise) if len(law.args) == 1}
    if not laws:
        return integrand
    ends = ((sp.Ge, low), (sp.Gt, low), (sp.Le, high), (sp.Lt, high))
    told = {relate(variable, end).canonical for relate, end in ends}
    return integrand.xreplace(
        {
            law: piece.expr
            for law, piece in laws.items()
            if {part.canonical for part in sp.And.make_args(piece.cond)} <= told
        }
    )


def give_limit(meaning: Meaning, node: tree.Approach) -> sp.Expr:
    """Return a limit with its variable bound."""
    variable, point = meaning.letter(node.by), meaning.of(node.point)
    is_inside = any(depends(s, {variable}, meaning.values) for s in point.free_symbols)
    term = meaning.take_number(node.term, meaning.side(node.term))
    running = make_running(variable.name, term, counts=bool(variable.is_integer))
    inside = settle(split_tangents(term, (point,)), meaning.values, {variable: running})
    # Letters that determine the variable must not appear next to it: they would tend to a limit,
    # too.
    moving = meaning.values.get(variable, sp.S.Zero).free_symbols
    if is_inside or any(depends(s, moving, meaning.values) for s in inside.free_symbols):
        raise meaning.source.refuse(
            node.by.start, f"{variable} tends to a limit that contains it, or is defined by others"
        )
    refuse_unknown(meaning, node.start, (inside, "in the limit"), variable)
    return sp.Limit(inside, running, point, node.side)


def give_value(meaning: Meaning, node: tree.At) -> sp.Expr:
    """Return the value of a term at a given value of a letter."""
    variable, point = meaning.letter(node.by), meaning.of(node.point)
    if node.is_found and variable in meaning.values:
        raise meaning.source.refuse(
            node.start,
            f"limits after {variable}, which other letters define: limits of which letter?",
            r"Print the letter: \right|_{x=0}^{x=1}.",
        )
    before = {*meaning.lost}
    term = meaning.side(node.term)
    if not isinstance(node.term, tree.Letter) and not isinstance(term, sp.MatrixBase):
        term = meaning.take_number(node.term, term)
    if any(factor.subs(variable, point) == 0 for factor in meaning.lost.keys() - before):
        raise meaning.source.refuse(node.start, "this divides by zero there")
    value = settle(term, meaning.values, {variable: point})
    all_steps = [(s, *rates) for s, (by, rates) in meaning.moving.items() if by == variable]
    moving = {step for steps in all_steps for step in steps}
    for steps in all_steps:
        _check_seams(meaning, node, steps, (term, point))
    # The derivative of a linear function is the same everywhere.
    known = meaning.values.keys() & {rate for _, *rates in all_steps for rate in rates}
    even = {s for s in known if not moving & settle_all(s, meaning.values).free_symbols}
    unknown = (moving & value.free_symbols or {value} & {term}) - even
    if isinstance(node.term, tree.Letter) and is_matrix(value):
        unknown, is_open = {node.term.symbol}, value == term
    else:
        is_open = bool(unknown) and (value.is_Symbol or not unknown <= {value})
    if is_open:
        raise meaning.source.refuse(
            node.start,
            f"the text does not say what {min(map(str, unknown))} is for {variable} = {point}",
            f"Print it as a function of {variable}, or skip the row in the block of letters.",
        )
    return value


def _check_seams(
    meaning: Meaning, node: tree.At, steps: tuple[sp.Basic, ...], said: tuple[sp.Expr, sp.Expr]
) -> None:
    """Refuse the derivative of a letter at a point where its pieces meet but do not join."""
    term, point = said
    met = term.free_symbols & {*steps[1:]}
    last = max(map(steps.index, met), default=-1)
    for step in steps[: last + 1]:
        if step in meaning.values and not has_value(meaning.values[step], node.by.symbol, point):
            raise meaning.source.refuse(
                node.start,
                f"{steps[last]} has no value at {node.by.text} = {point}: its pieces do not join",
            )


def _bind(
    meaning: Meaning, node: tree.Integration, integrand: sp.Expr, variable: sp.Expr
) -> tuple[sp.Dummy, sp.Expr]:
    """Return a bound variable and the integrand in it; refuse other letters that move with it."""
    place = node.differential.start if node.differential else node.start
    if variable.is_Symbol:
        running = make_running(variable.name, integrand)
        by = _find_argument(meaning, node, variable)
        inside = settle(integrand, meaning.values, {by: running})
        moving = meaning.values.get(by, sp.S.Zero).free_symbols
        refuse_unknown(meaning, place, (inside, "in the integrand"), by)
    else:
        running = make_running("u", integrand)
        inside = integrand.xreplace({variable: running})
        moving = variable.free_symbols
    caught = [
        str(s)
        for s in sorted(inside.free_symbols, key=str)
        if s != running and (s in meaning.values or s in variable.free_symbols)
        if depends(s, moving, meaning.values)
    ]
    if caught := caught or list_carried(meaning, inside, variable):
        raise meaning.source.refuse(
            place,
            f"{', '.join(caught)} in the integrand may vary with {variable}",
            "Declare the value of one in terms of the other, or the printed product as the name "
            "of a variable.",
        )
    return running, inside


def _find_argument(meaning: Meaning, node: tree.Integration, variable: sp.Basic) -> sp.Basic:
    r"""Return the letter in whose place the variable of integration is put into the integrand.

    In \int_0^t\dot x\,d\tau that is t: x depends on it, and \tau appears nowhere else.
    """
    printed = {part.symbol for part in tree.walk(node.integrand) if isinstance(part, tree.Letter)}
    is_said = variable in meaning.values or variable in meaning.moving
    end = node.high.symbol if isinstance(node.high, tree.Letter) and not is_said else variable
    reached = list_reached(printed, meaning.values)
    if variable in reached or end in printed or printed & list_moving(variable, meaning.moving):
        return variable
    is_meant = end in reached or printed & list_moving(end, meaning.moving)
    return end if is_meant else variable
