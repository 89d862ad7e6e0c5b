"""Proofs of inequalities that are equalities at the lower bound of their only symbol.

The difference of their sides rises from there, which the enclosure of its derivative shows.
"""

from __future__ import annotations

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.facts import introduce
from mechproof.coq.signs import BITS
from mechproof.coq.terms import Names, write_relation, write_term
from mechproof.coq.theorems import Theorem

# The symbol while it lies between its lower bound and its value.
_RISING = sp.Symbol("Z0", real=True)


def is_rising(theorem: Theorem) -> bool:
    """Return whether an inequality of one symbol is an equality where that is zero, its least."""
    if not isinstance(theorem.conclusion, sp.Le | sp.Ge) or len(theorem.symbols) != 1:
        return False
    symbol = theorem.symbols[0]
    if sp.Ge(symbol, 0, evaluate=False) not in theorem.hypotheses:
        return False
    equal = sp.Ne(*(side.subs(symbol, 0) for side in theorem.conclusion.args), evaluate=False)
    return equal is sp.false or balls.truth(equal, {}, BITS) is not True


def prove_by_rise(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics for such an inequality."""
    symbol, relation = theorem.symbols[0], theorem.conclusion
    less, more = relation.args if isinstance(relation, sp.Le) else relation.args[::-1]
    name, moving = names[symbol], {symbol: str(_RISING)}
    moved = {**names, _RISING: str(_RISING)}
    difference = f"{write_term(more, moving)} - {write_term(less, moving)}"
    slope = write_term(sp.diff(more - less, symbol), moving)
    sides = " ".join(write_term(side, names) for side in (less, more))
    bounds = [h for h in theorem.hypotheses if h.lhs == symbol and h.rhs.is_number]
    within = " ".join(
        f"assert {write_relation(bound.subs(symbol, _RISING), moved)} by lra." for bound in bounds
    )
    functions = " ".join(f"(fun {_RISING} : R => {body})" for body in (difference, slope))
    return [
        introduce(theorem, names),
        f"apply (at_most_if_rising {functions} {name} {sides}); cbv beta.",
        "- lra.",
        "- intros Z0 B0. auto_derive; [ has_values | zero ].",
        f"- intros Z0 B0. {within} interval with (i_bisect Z0, i_taylor Z0, i_prec 60).",
        "- rewrite ?sin_0, ?cos_0; zero.",
        "- reflexivity.",
    ]
