"""Roots of quotients, written as quotients with roots of what has no denominator."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from mechproof.coq.sign_proofs import find_factors, turn_positive
from mechproof.coq.terms import Names, write_term
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_parts, find_roots, replace_parts


def open_arctangents(theorem: Theorem, names: Names) -> tuple[Theorem, list[str]]:
    """Return a theorem without sines and cosines of twice an arctangent, and the tactics for it."""
    whole = sp.Tuple(theorem.conclusion, *theorem.hypotheses)
    written: dict[sp.Basic, sp.Basic] = {}
    lines: list[str] = []
    for node in sorted(find_parts(whole, sp.sin, sp.cos), key=sp.default_sort_key):
        parts = _find_double(node.args[0])
        if parts is None:
            continue
        rest, size = parts
        sine, cosine = sp.sin(rest), sp.cos(rest)
        first, second = (cosine, -sine) if isinstance(node, sp.cos) else (sine, cosine)
        written[node] = (first * (1 - size**2) + second * 2 * size) / (1 + size**2)
        lemma = "cosine_with_arctangent" if isinstance(node, sp.cos) else "sine_with_arctangent"
        whole, a, t = (write_term(part, names) for part in (node, rest, size))
        left, right = ("cos", "- sin") if isinstance(node, sp.cos) else ("sin", "+ cos")
        value = f"({left} {a} * (1 - {t} * {t}) {right} {a} * (2 * {t})) / (1 + {t} * {t})"
        shown = f"rewrite <- ({lemma} {a} {t}); apply f_equal; odd_arctangents; ring"
        lines.append(f"replace {whole} with ({value}) by ({shown}).")
    return (_write(theorem, written), lines) if written else (theorem, [])


def _find_double(angle: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """Return a and t of an angle a + 2 arctan t; None of any other."""
    turned = [term for term in sp.Add.make_args(angle) if find_parts(term, sp.atan)]
    if len(turned) != 1:
        return None
    number, arctangent = turned[0].as_coeff_Mul()
    if abs(number) != 2 or not isinstance(arctangent, sp.atan):
        return None
    return angle - turned[0], arctangent.args[0] * number / 2


def clear_roots(theorem: Theorem, names: Names) -> tuple[Theorem, list[str]]:
    """Return a theorem whose roots have no denominators, and the tactics that write it so."""
    whole = sp.Tuple(theorem.conclusion, *theorem.hypotheses)
    powers = find_roots(whole)
    written: dict[sp.Basic, sp.Basic] = {}
    lines: list[str] = []
    for base in sorted({p.base for p in powers}, key=sp.default_sort_key):
        split = _split(base, theorem)
        if split is None or find_parts(base, sp.Pow) & powers:
            continue
        above, below = split
        if sp.sqrt(above) != sp.Pow(above, sp.S.Half, evaluate=False):
            continue
        texts = [write_term(part, names) for part in (base, above, below)]
        number = len(lines) + 1
        known = f"replace {texts[1]} with ({texts[0]} * ({texts[2]} * {texts[2]}))"
        value = f"{known} by (field; conditions ltac:(ring)); structure"
        lines.append(
            f"try (assert (C{number} : sqrt {texts[0]} = sqrt {texts[1]} / {texts[2]}) by "
            f"(apply root_over; [ first [ structure | sign ] "
            f"| first [ structure | close | {value} ] "
            f"| field; conditions ltac:(ring) ]); rewrite C{number} in * )."
        )
        root = sp.sqrt(above) / below
        written |= {p: root ** (2 * p.exp) for p in powers if p.base == base}
    if not written:
        return theorem, []
    return _write(theorem, written), lines


def _split(base: sp.Expr, theorem: Theorem) -> tuple[sp.Expr, sp.Expr] | None:
    """Return a and b with base = a / b^2 where b is positive; None without a denominator."""
    factors = find_factors(base)
    if factors is None or not factors.below:
        return None
    below = sp.Mul(
        *(turn_positive(f, theorem.witness) ** -(-k // 2) for f, k in factors.below.items())
    )
    above = sp.expand(sp.cancel(base * below**2))
    return (above, below) if not sp.fraction(above)[1].free_symbols else None


def _write(theorem: Theorem, written: dict[sp.Basic, sp.Basic]) -> Theorem:
    conclusion, *hypotheses = (_put(r, written) for r in (theorem.conclusion, *theorem.hypotheses))
    return replace(theorem, conclusion=conclusion, hypotheses=tuple(hypotheses))


def _put(relation: sp.Basic, written: dict[sp.Basic, sp.Basic]) -> sp.Basic:
    parts = (replace_parts(part, written) for part in relation.args)
    return relation.func(*parts, evaluate=False)
