"""Proofs of derivatives: Coq differentiates, and compares what it finds with what is stated."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from mechproof.coq.first_tactics import EstablishedFacts, introduce
from mechproof.coq.terms import Names, write_term
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_parts


def prove_slope(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics for a derivative."""
    derivative, slope = theorem.conclusion.args
    computed = sp.Tuple(derivative.expr, slope)
    facts = EstablishedFacts(computed, theorem.witness, names)
    opened = ["unfold tan in *."] if find_parts(computed, sp.tan) else []
    return [
        introduce(theorem, names),
        *opened,
        "auto_derive; [ repeat split; first [ exact I | structure | nonzero ] | ].",
        *_restore_roots(computed, names),
        *facts.lines,
        *_show_roots(computed, names),
        f"{facts.closing}.",
    ]


def _list_roots(whole: sp.Basic) -> list[sp.Expr]:
    """List what roots are of, the smaller first."""
    powers = find_parts(whole, sp.Pow)
    bases = {power.base for power in powers if power.exp.is_Rational and power.exp.q == 2}
    return sorted(bases, key=lambda base: (sp.count_ops(base), sp.default_sort_key(base)))


def _restore_roots(whole: sp.Basic, names: Names) -> Iterator[str]:
    """Write again as they stood roots of which Coq has written out the powers within."""
    for base in _list_roots(whole):
        text = write_term(base, names)
        yield (
            "repeat match goal with |- context [sqrt ?u] => tryif constr_eq u "
            f"{text} then fail else change (sqrt u) with (sqrt {text}) end."
        )


def _show_roots(whole: sp.Basic, names: Names) -> Iterator[str]:
    """Show that roots differ from zero where they do."""
    for number, base in enumerate(_list_roots(whole), start=1):
        text = write_term(base, names)
        yield (
            f"try assert (P{number} : sqrt {text} <> 0) by "
            "(apply Rgt_not_eq, sqrt_lt_R0; first [ structure | lra | nra ])."
        )
