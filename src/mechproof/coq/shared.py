"""Numbers that are parts of several statements, written once: a definition and where it lies.

Every definition comes with a fact, an enclosure between decimal fractions, that Coq derives from
those of the definitions before it; statements over the definitions are then small ones.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import floor

import flint
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.terms import Names, UnwritableError, write_term
from mechproof.record.parts import find_free

# A shorter term is written where it stands.
_SHORTEST = 30
# Enclosures have so many decimal places, fewer where those of the parts are wider.
_PLACES = 30
_BITS = 128
# Two numbers are related as their difference is to zero, and differ where it has a sign.
_SETTLE = f"""Ltac settle :=
  let lies := interval with (i_prec {_BITS}) in
  intros;
  repeat match goal with |- _ /\\ _ => split end;
  first
    [ lies
    | apply Rminus_lt; lies
    | apply Rminus_gt; lies
    | apply Rminus_le; lies
    | apply Rminus_ge; lies
    | apply Rlt_not_eq, Rminus_lt; lies
    | apply Rgt_not_eq, Rminus_gt; lies
    | at_point ].
"""


def share_parts(relations: Sequence[sp.Basic]) -> Names:
    """Name both sides, and numbers that occur more than once, those of which others are made first.

    The sides have no free symbols.
    """
    found = _Parts()
    sides = {side for relation in relations for side in relation.args}
    for relation in relations:
        found.visit(relation)
    names: dict[sp.Basic, str] = {}
    for part in found.order:
        if (found.counts[part] > 1 or part in sides) and len(write_term(part, names)) >= _SHORTEST:
            names[part] = f"shared_{len(names) + 1}"
    return names


class _Parts:
    """Parts from below, and how often each is written where every other is written once."""

    def __init__(self) -> None:
        self.counts: Counter[sp.Basic] = Counter()
        self.order: list[sp.Expr] = []

    def visit(self, node: sp.Basic) -> None:
        """Count a part, and what it is made of when it is met first."""
        is_inverse = isinstance(node, sp.Pow) and node.exp.is_negative
        if not is_inverse:
            self.counts[node] += 1
        if self.counts[node] > 1 or not node.args or isinstance(node, sp.Integral):
            return
        for part in node.args:
            self.visit(part)
        if isinstance(node, sp.Expr) and not is_inverse and not find_free(node):
            self.order.append(node)


def write_definitions(names: Names) -> Iterator[str]:
    """Yield a tactic, and of each part its definition and the fact where it lies.

    Raises `UnwritableError`.
    """
    if names:
        yield _SETTLE
    known: dict[sp.Basic, str] = {}
    values: dict[sp.Basic, flint.arb] = {}
    for part, name in names.items():
        term = write_term(part, known)
        letters = {other: sp.Symbol(known[other]) for other in known}
        low, high, places = _enclose(part.xreplace(letters), values)
        turn = "turn_vectors; " if "atan2" in term else ""
        yield (
            f"Definition {name} : R := {term}.\n"
            f"Fact {name}_lies : ({low} / 10 ^ {places}) <= {name} <= ({high} / 10 ^ {places}).\n"
            f"Proof. {_recall(term)}unfold {name}; {turn}interval with (i_prec {_BITS}). Qed.\n"
        )
        known[part] = name
        with balls.working_precision(_BITS):
            ends = flint.arb(low + high, high - low) / 2
            values[sp.Symbol(name)] = ends / flint.arb(10) ** places


def settle(text: str) -> str:
    """Write the tactics that prove relations from where the definitions lie that they use."""
    return f"{_recall(text)}settle."


def _recall(text: str) -> str:
    """Write the tactics that recall where the definitions lie that a text uses."""
    used = dict.fromkeys(re.findall(r"\bshared_\d+\b", text))
    return "".join(f"pose proof {name}_lies. " for name in used)


def _enclose(part: sp.Expr, values: Mapping[sp.Basic, flint.arb]) -> tuple[int, int, int]:
    """Return whole numbers below and above a number times a power of ten, and the exponent."""
    ball = balls.evaluate(part, values, _BITS)
    if not ball.is_finite():
        raise UnwritableError("a number in it could not be enclosed")
    middle, radius = (_to_fraction(end) for end in (ball.mid(), ball.rad()))
    places = next(n for n in range(_PLACES, -_PLACES, -1) if radius * Fraction(10) ** n < 1)
    near = floor(middle * Fraction(10) ** places)
    return near - 2, near + 3, places


def _to_fraction(number: flint.arb) -> Fraction:
    mantissa, exponent = number.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
