"""Proofs of theorems: sequences of tactics, chosen by the form of the conclusion.

Equalities are decided by `field` modulo the squares of sines and of roots; inequalities of
quotients by the signs of the factors of their difference, which SymPy finds and Coq checks. For an
inequality in one symbol that is an equality at its lower bound, the difference of the sides rises
from there, which an enclosure of its derivative shows.

Roots of quotients are written as quotients with roots of expressions without denominators.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.derivative_proofs import find_variable, prove_by_derivative, prove_slope
from mechproof.coq.first_tactics import EstablishedFacts, introduce, turn_right
from mechproof.coq.sign_proofs import (
    BITS,
    ORDERED,
    find_factors,
    prove_order,
    turn_positive,
    write_product,
)
from mechproof.coq.slope_statements import states_slope
from mechproof.coq.terms import Names, has_families, write_relation, write_term
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_parts, find_roots, replace_parts
from mechproof.statement_domains.domain import Point


def prove_at_point(relations: Sequence[sp.Basic]) -> str:
    """Write the tactic for relations between numbers."""
    if has_families(*relations):
        return "at_few."
    return "evaluate." if find_parts(sp.Tuple(*relations), sp.Integral, sp.atan2) else "at_point."


def prove(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics that prove a theorem, one per line."""
    if not theorem.symbols:
        return [prove_at_point((theorem.conclusion, *theorem.hypotheses))]
    if is_the_same(theorem.conclusion, names):
        return [introduce(theorem, names), "reflexivity."]
    if states_slope(theorem.conclusion):
        return prove_slope(theorem, names)
    theorem, opened = open_arctangents(theorem, names)
    if not opened and (find_parts(theorem.conclusion, sp.Integral) or _has_other_angles(theorem)):
        return prove_by_derivative(theorem, names)
    if is_rising(theorem):
        return prove_by_rise(theorem, names)
    theorem, cleared = clear_roots(theorem, names)
    whole = sp.And(theorem.conclusion, *theorem.hypotheses, evaluate=False)
    facts = EstablishedFacts(whole, theorem.witness, names)
    # Vectors on both sides may already be equal, so that they are rewritten only next to
    # arctangents.
    has_arctangents = bool(find_parts(theorem.conclusion, sp.atan))
    vectors = list(turn_right(theorem, names)) if has_arctangents else []
    lines = [introduce(theorem, names), *opened, *cleared, *vectors, *facts.lines]
    if isinstance(theorem.conclusion, sp.Eq):
        lines += _prepare_equality(theorem, facts)
        scaled = list(_scale_vectors(theorem, facts))
        # The arguments of arctangents lie deeper in the terms.
        deep = f"by_depth ltac:({facts.closing})." if has_arctangents or scaled else ""
        return [*lines, *scaled, deep or _compare(facts)]
    if theorem.conclusion.func in (*ORDERED, sp.Ne):
        about = (facts.bases, facts.modulo, theorem.witness, names, theorem.hypotheses)
        return [*lines, *prove_order(theorem.conclusion, *about)]
    return [*lines, "close."]


def is_the_same(conclusion: sp.Basic, names: Names) -> bool:
    """Return whether both sides of an equality have the same text."""
    if not isinstance(conclusion, sp.Eq) or states_slope(conclusion):
        return False
    left, right = (write_term(side, names) for side in conclusion.args)
    return left == right


def _has_other_angles(theorem: Theorem) -> bool:
    """Return whether a side has an arctangent whose value differs from all on the other side."""
    if not isinstance(theorem.conclusion, sp.Eq) or find_variable(theorem) is None:
        return False
    left, right = (list(_list_angles(side)) for side in theorem.conclusion.args)

    def lack(angles: list[sp.Expr], others: list[sp.Expr]) -> bool:
        differences = ((sp.Ne(a, other, evaluate=False) for other in others) for a in angles)
        return any(all(balls.truth(d, theorem.witness, BITS) for d in one) for one in differences)

    return lack(left, right) or lack(right, left)


def _list_angles(side: sp.Basic) -> Iterator[sp.Expr]:
    for angle in find_parts(side, sp.atan, sp.atan2):
        yield angle.args[0] if isinstance(angle, sp.atan) else angle.args[0] / angle.args[1]


def _prepare_equality(theorem: Theorem, facts: EstablishedFacts) -> Iterator[str]:
    yield from _split_denominators(theorem, facts)
    for angle in _list_doubled(theorem.conclusion):
        text = write_term(angle, facts.names)
        yield f"try rewrite (double_arctangent {text}) by lra."


def _compare(facts: EstablishedFacts) -> str:
    by = facts.modulo
    closing = f"first [ ring{by} | field{by}; conditions ltac:(ring{by}) ]"
    return f"by_parts ltac:({closing})."


def _scale_vectors(theorem: Theorem, facts: EstablishedFacts) -> Iterator[str]:
    """Write the angle of a vector as the angle of its multiple on the other side."""
    left, right = (find_parts(side, sp.atan2) for side in theorem.conclusion.args)
    pairs = product(*(sorted(vectors, key=sp.default_sort_key) for vectors in (left, right)))
    for number, (vector, other) in enumerate(pairs, start=1):
        scale = _find_scale(vector, other, theorem.witness)
        if vector == other or scale is None:
            continue
        texts = " ".join(write_term(part, facts.names) for part in other.args)
        size = write_product(scale, theorem.witness, facts.names)
        yield f"assert (K{number} : 0 < {size}) by product_sign."
        yield (
            f"replace {write_term(vector, facts.names)} with (atan2 {texts}) by "
            f"(rewrite <- (atan2_scaled {size} {texts} K{number}); "
            f"apply f_equal2; {facts.closing})."
        )


def _find_scale(vector: sp.atan2, other: sp.atan2, witness: Point) -> sp.Expr | None:
    """Return the positive quotient of two vectors, or None if their angles differ."""
    ratios = [sp.factor(one / two) for one, two in zip(vector.args, other.args, strict=True)]
    is_one = sp.simplify(ratios[0] - ratios[1]) == 0
    is_positive = balls.truth(sp.Gt(ratios[0], 0, evaluate=False), witness, BITS)
    return ratios[0] if is_one and is_positive else None


def _list_doubled(relation: sp.Basic) -> list[sp.Expr]:
    """List every t for which a relation contains 2 arctan t as a product."""
    found = (p for p in find_parts(relation, sp.Mul) if len(p.args) == 2 and p.args[0] == 2)
    return [p.args[1].args[0] for p in found if isinstance(p.args[1], sp.atan)]


def _split_denominators(theorem: Theorem, facts: EstablishedFacts) -> Iterator[str]:
    """Show that each denominator's factors, if there are several, are nonzero, too."""
    by = facts.modulo
    number = 0
    for place, fact in enumerate(theorem.hypotheses, start=1):
        if not isinstance(fact, sp.Ne) or fact.args[1] != 0:
            continue
        factors = find_factors(fact.args[0])
        if factors is None or factors.is_one:
            continue
        for factor, rest in factors.split():
            number += 1
            text, other = (write_term(part, facts.names) for part in (factor, rest))
            yield (
                f"try assert (N{number} : {text} <> 0) by "
                f"(intro F; apply H{place}; transitivity ({text} * {other}); "
                f"[ field{by}; conditions ltac:(ring{by}) | rewrite F; apply Rmult_0_l ])."
            )


# The symbol while it moves from its lower bound to its value.
_RISING = sp.Symbol("Z0", real=True)


def is_rising(theorem: Theorem) -> bool:
    """Return whether an inequality in one symbol is an equality where it is 0, its least value."""
    if not isinstance(theorem.conclusion, sp.Le | sp.Ge) or len(theorem.symbols) != 1:
        return False
    symbol = theorem.symbols[0]
    if sp.Ge(symbol, 0, evaluate=False) not in theorem.hypotheses:
        return False
    equal = sp.Ne(*(side.subs(symbol, 0) for side in theorem.conclusion.args), evaluate=False)
    return equal is sp.false or balls.truth(equal, {}, BITS) is not True


def prove_by_rise(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics for an inequality that is an equality at 0 and rises from there."""
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


def open_arctangents(theorem: Theorem, names: Names) -> tuple[Theorem, list[str]]:
    """Return a theorem without sines and cosines of twice an arctangent, and tactics for that."""
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
    return (_rewrite(theorem, written), lines) if written else (theorem, [])


def _find_double(angle: sp.Expr) -> tuple[sp.Expr, sp.Expr] | None:
    """Return a and t of an angle a + 2 arctan t, or None for any other angle."""
    turned = [term for term in sp.Add.make_args(angle) if find_parts(term, sp.atan)]
    if len(turned) != 1:
        return None
    number, arctangent = turned[0].as_coeff_Mul()
    if abs(number) != 2 or not isinstance(arctangent, sp.atan):
        return None
    return angle - turned[0], arctangent.args[0] * number / 2


def clear_roots(theorem: Theorem, names: Names) -> tuple[Theorem, list[str]]:
    """Return a theorem whose roots have no denominators, and the tactics that rewrite it so."""
    whole = sp.Tuple(theorem.conclusion, *theorem.hypotheses)
    powers = find_roots(whole)
    written: dict[sp.Basic, sp.Basic] = {}
    lines: list[str] = []
    for base in sorted({p.base for p in powers}, key=sp.default_sort_key):
        split = _split_root(base, theorem)
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
    return _rewrite(theorem, written), lines


def _split_root(base: sp.Expr, theorem: Theorem) -> tuple[sp.Expr, sp.Expr] | None:
    """Return a and b with base = a / b^2, b positive, or None without a denominator."""
    factors = find_factors(base)
    if factors is None or not factors.below:
        return None
    below = sp.Mul(
        *(turn_positive(f, theorem.witness) ** -(-k // 2) for f, k in factors.below.items())
    )
    above = sp.expand(sp.cancel(base * below**2))
    return (above, below) if not sp.fraction(above)[1].free_symbols else None


def _rewrite(theorem: Theorem, written: dict[sp.Basic, sp.Basic]) -> Theorem:
    conclusion, *hypotheses = (
        _put_in(r, written) for r in (theorem.conclusion, *theorem.hypotheses)
    )
    return replace(theorem, conclusion=conclusion, hypotheses=tuple(hypotheses))


def _put_in(relation: sp.Basic, written: dict[sp.Basic, sp.Basic]) -> sp.Basic:
    parts = (replace_parts(part, written) for part in relation.args)
    return relation.func(*parts, evaluate=False)
