"""Names: in, an expression; out, a name a reader would give it (`one_minus_e`, `sin_alpha`)."""

from __future__ import annotations

import sympy as sp

NUMBERS = {1: "one", 2: "two", 3: "three", 4: "four"}
POWERS = {2: "squared", 3: "cubed"}
LONGEST = 24


def suggest_name(expression: sp.Expr, otherwise: str = "term") -> str:
    """Return a name that says what the expression is, or `otherwise` where that would be long."""
    name = _spell(expression)
    # What has no word, as a fraction, is spelled as nothing and leaves an underscore.
    readable = name.isidentifier() and name == name.strip("_")
    return name if readable and len(name) <= LONGEST else otherwise


def _spell(expression: sp.Expr) -> str:
    if isinstance(expression, sp.Symbol):
        return str(expression)
    if isinstance(expression, sp.Integer):
        return NUMBERS.get(int(expression), "")
    if isinstance(expression, sp.Pow) and expression.exp in POWERS:
        return f"{_spell(expression.base)}_{POWERS[int(expression.exp)]}"
    if isinstance(expression, sp.Pow) and expression.exp == sp.S.Half:
        return f"root_{_spell(expression.base)}"
    if isinstance(expression, sp.Mul):
        return "_".join(_spell(factor) for factor in expression.args)
    if isinstance(expression, sp.Add):
        return _spell_sum(expression)
    if isinstance(expression, sp.Function) and len(expression.args) == 1:
        return f"{expression.func.__name__.lower()}_{_spell(expression.args[0])}"
    return ""


def _spell_sum(expression: sp.Add) -> str:
    first, *others = sorted(expression.args, key=sort_positive_first)
    spelled = _spell(first)
    for term in others:
        negative = term.could_extract_minus_sign()
        spelled += f"_minus_{_spell(-term)}" if negative else f"_plus_{_spell(term)}"
    return spelled


def sort_positive_first(term: sp.Expr) -> tuple[bool, bool, object]:
    """Return a sort key of sums as people write them: 1 - e, R - A, 1 + t**2."""
    return (
        term.could_extract_minus_sign(),
        not term.is_Number,
        sp.default_sort_key(term),
    )
