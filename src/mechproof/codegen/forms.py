"""Forms: in, a paper's quantities; out, the rows that say each printed form is its definition."""

from __future__ import annotations

import sympy as sp

from mechproof.codegen.kernel import evaluate_quantity, take_shortcut
from mechproof.record import Claim, Conjunction, Equality, Paper, Quantity, Row, Statement


def form_rows(paper: Paper) -> tuple[Row, ...]:
    """Return one row for each form, shortcuts included, that is not its quantity's definition.

    Left out are approximations, whose bound has rows of its own in the derivation, and
    quantities whose row stands in the derivation itself. Raises ValueError if it does not.
    """
    rows = {row.number for row in paper.rows}
    for quantity in paper.quantities:
        if quantity.form.proved_by not in (*rows, ""):
            raise ValueError(f"{quantity.name}: no row {quantity.form.proved_by!r} in the paper")
    forms = [
        (name, version)
        for quantity in paper.quantities
        for name, version in (
            (quantity.name, quantity),
            (f"{quantity.name}, shortcut", take_shortcut(quantity)),
        )
        if version is not None
    ]
    return tuple(
        _state_form(name, quantity, paper)
        for name, quantity in forms
        if quantity.form.bound is None
        and not quantity.form.proved_by
        and (quantity.form.rewrites or quantity.form.expression != quantity.definition)
    )


def _state_form(number: str, quantity: Quantity, paper: Paper) -> Row:
    rewrites = ", ".join(quantity.form.rewrites) or "none"
    name = quantity.name.replace("_", r"\_")
    return Claim(
        f"kernel {number}",
        rf"\text{{the kernel {name} computes its definition}}",
        _equal_on_branches(evaluate_quantity(quantity, paper).expanded(), quantity.definition),
        note=f"Form: {quantity.form.name}; rewrites: {rewrites}.",
        marks=("ours",),
    )


def _equal_on_branches(form: sp.Basic, definition: sp.Basic) -> Statement:
    """State the equality for each branch, where the sign of the compared value is known."""
    values = sorted(_branch_values(form), key=sp.default_sort_key)
    if not values:
        return Equality(form, definition)
    (value,) = values
    return Conjunction(
        tuple(Equality(_take_branch(form, value, sign), definition) for sign in (1, -1))
    )


def _branch_values(form: sp.Basic) -> set[sp.Expr]:
    """Collect the values v of the branches v >= 0."""
    conditions = {piece.args[0].cond for piece in form.atoms(sp.Piecewise)}
    for condition in conditions:
        if not (isinstance(condition, sp.GreaterThan) and condition.rhs == 0):
            raise NotImplementedError(f"a branch on {condition}; only v >= 0 is known")
    return {condition.lhs for condition in conditions}


def _take_branch(form: sp.Basic, value: sp.Expr, sign: int) -> sp.Basic:
    """Take the branch of one sign, in which |value| is sign*value."""
    absolutes = {node: sign * value for node in form.atoms(sp.Abs) if node.args[0] == value}
    pieces = {
        piece: piece.args[0 if sign > 0 else 1].expr.xreplace(absolutes)
        for piece in form.atoms(sp.Piecewise)
    }
    return form.xreplace(pieces).xreplace(absolutes)
