"""Derivatives: in, a paper; out, its scalar quantities' partial derivatives by every argument.

The chain rule passes once backwards through the steps of the shipped form, like the reverse mode of
automatic differentiation (Griewank and Walther 2008), but in symbols: each step is differentiated
separately, and parts common to several derivatives are computed once. The shipped form is proved
equal to the definition, so that its derivatives are those of the definition.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.arithmetic.polynomials import factor
from mechproof.programs.evaluation import KeepsShape, trace_inputs
from mechproof.record import Accuracy, Form, Paper, Quantity, Scale
from mechproof.record.memory import remember_last
from mechproof.record.parts import differentiate as differentiate_part, find_free, find_parts

Given = Mapping[sp.Symbol, sp.Expr]
# Stand for the sine and the cosine of an angle.
_S, _C = sp.symbols("S C", real=True)
CONDITIONING = Scale("its conditioning", sp.S.One)


@remember_last(8)
def differentiate(paper: Paper) -> Paper:
    """Return the paper with the derivatives of its wanted scalar quantities as its quantities.

    Each keeps the name of the quantity and has one entry per argument, in their order.
    """
    quantities = tuple(_differentiate(quantity, paper) for quantity in select_wanted(paper))
    return replace(paper, rows=(), findings=(), one_pass=(), quantities=quantities)


def select_wanted(paper: Paper) -> tuple[Quantity, ...]:
    """Return the quantities whose derivatives are wanted, reduced to what these are derived from.

    Each one's definition determines the derivatives, and its only form how they are computed.
    """
    quantities = paper.quantities if paper.derivatives else ()
    return tuple(_strip(q) for q in quantities if q.slopes and is_exact_scalar(q))


def _strip(quantity: Quantity) -> Quantity:
    form = quantity.shipped[-1]
    # If the form's row claims anything other than equality with the definition, the form itself is
    # differentiated.
    exact = quantity.definition if form.states is None else form.expression
    bare = Form(form.name, form.expression, form.rewrites)
    return replace(
        quantity, definition=exact, forms=(bare,), singular=(), period=None, periodicity=None
    )


def is_exact_scalar(quantity: Quantity) -> bool:
    """Return whether the quantity is one number, computed without approximation from numbers."""
    return bool(quantity.forms) and quantity.is_scalar and quantity.shipped[-1].bound is None


def _differentiate(quantity: Quantity, paper: Paper) -> Quantity:
    symbols = [argument.symbols[0] for argument in quantity.arguments]
    given = {s: value for s, value in paper.given.items() if s not in symbols}
    form, own, slopes = quantity.shipped[-1], quantity.accuracy, quantity.slopes
    assert slopes is not None
    within = (*(own.within if own else ()), *slopes.within)
    return Quantity(
        quantity.name,
        f"Differentiate `{quantity.name}` by its arguments, in their order.",
        quantity.arguments,
        sp.ImmutableDenseMatrix(chain(quantity.definition, symbols, given)),
        (Form("backward pass", _go_back(form.expression, symbols, given), form.rewrites),),
        quantity.source,
        unit=f"{quantity.unit} per unit of each argument",
        accuracy=Accuracy(slopes.ulp, CONDITIONING, tuple(dict.fromkeys(within))),
        on=quantity.on,
        remarks=quantity.remarks,
    )


def chain(
    expression: sp.Expr,
    symbols: Sequence[sp.Symbol],
    given: Given,
    tidy: Callable[[sp.Expr], sp.Expr] = lambda slope: slope,
) -> list[sp.Expr]:
    """Return an expression's derivatives by symbols, each as shortened by `tidy` if that helps."""

    def differentiate_step(value: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
        return _choose_shorter(_choose_sides(differentiate_part(value, symbol)), tidy)

    steps = _order_steps(expression, given)
    slopes = {s: differentiate_step(expression, s) for s in (*steps, *symbols)}
    for step in reversed(steps):
        value = given[step]
        for s in sorted(find_free(value), key=str) if slopes[step] != 0 else ():
            slopes[s] += slopes[step] * differentiate_step(value, s)
    return [_choose_shorter(slopes[s], tidy) for s in symbols]


def _choose_shorter(slope: sp.Expr, tidy: Callable[[sp.Expr], sp.Expr]) -> sp.Expr:
    tidied = tidy(slope)
    return slope if tidied == slope else min((slope, tidied), key=sp.count_ops)


def _go_back(
    expression: sp.Expr, symbols: Sequence[sp.Symbol], given: Given
) -> sp.ImmutableDenseMatrix:
    """Return the derivatives by the symbols, in the form in which they are computed."""
    plain = _write_tangents(expression, symbols[0], given)
    # A homogeneous expression must stay so: written in cosines alone, it would cancel.
    tidy = _factor if plain == expression else lambda slope: slope
    entries = chain(plain, symbols, given, tidy)
    # An argument that no derivative depends on still gives the result its shape and its NaN.
    needed = {s for entry in entries for s in trace_inputs(entry, given)}
    for idle in (s for s in symbols if s not in needed):
        entries = [KeepsShape(entry, idle) for entry in entries]
    return sp.ImmutableDenseMatrix(entries)


def _order_steps(expression: sp.Expr, given: Given) -> list[sp.Symbol]:
    """List the steps that an expression needs, each after the steps it depends on."""
    ordered: dict[sp.Symbol, None] = {}

    def visit(part: sp.Expr) -> None:
        needed = find_free(part)
        for step in (s for s in given if s in needed and s not in ordered):
            visit(given[step])
            ordered[step] = None

    visit(expression)
    return list(ordered)


def _write_tangents(expression: sp.Expr, running: sp.Symbol, given: Given) -> sp.Expr:
    """Write the tangent of the running variable as sine over cosine, as its poles would cancel.

    An expression that is rational in the tangent becomes homogeneous in both.
    """
    tangent, steps = sp.tan(running), _order_steps(expression, given)
    turning = {s: given[s] for s in steps if given[s].has(tangent)}
    for _ in turning:
        expression = expression.xreplace(turning)
    if not expression.has(tangent):
        return expression
    expression = _homogenise(expression.xreplace({tangent: _S / _C}))
    return expression.xreplace({_S: sp.sin(running), _C: sp.cos(running)})


def _homogenise(expression: sp.Expr) -> sp.Expr:
    if isinstance(expression, sp.atan2):
        # Both sides may be multiplied by the cosine's square, which is positive.
        return sp.atan2(*(sp.expand(side * _C**2) for side in expression.args))
    if expression.is_Add:
        return sp.Add(*map(_homogenise, expression.args))
    return sp.factor(sp.together(expression)).xreplace({_C**2 + _S**2: sp.S.One})


def _choose_sides(slope: sp.Expr) -> sp.Expr:
    """Write the slopes of Max, Min and Abs by pieces; at a kink, that of positive arguments."""
    slope = slope.replace(sp.Heaviside, lambda number, *_: _choose(number, sp.S.Zero))
    return slope.replace(sp.sign, lambda number: _choose(number, sp.S.NegativeOne))


def _choose(number: sp.Expr, below: sp.Expr) -> sp.Piecewise:
    return sp.Piecewise((below, number < 0), (sp.S.One, True))


def _factor(expression: sp.Expr) -> sp.Expr:
    if expression.has(sp.Piecewise) or not _divides_by_angles(expression):
        return expression
    above, below = map(_spare_sines, sp.fraction(sp.together(expression)))
    if not below.has(sp.sin, sp.cos):
        return expression
    return factor(above / below)


def _divides_by_angles(expression: sp.Expr) -> bool:
    powers = (p for p in find_parts(expression, sp.Pow) if p.exp.could_extract_minus_sign())
    return any(power.base.has(sp.sin, sp.cos) for power in powers)


def _spare_sines(polynomial: sp.Expr) -> sp.Expr:
    expanded = sp.expand(polynomial)
    circle = {node.args[0] for node in expanded.atoms(sp.sin)}
    for angle in sorted(circle, key=sp.default_sort_key):
        sine, square = sp.sin(angle), 1 - sp.cos(angle) ** 2
        powers = {n: sine ** (n.exp % 2) * square ** (n.exp // 2) for n in expanded.atoms(sp.Pow)
                  if n.base == sine and n.exp.is_Integer and n.exp > 1}  # fmt: skip
        expanded = sp.expand(expanded.xreplace(powers))
    return expanded
