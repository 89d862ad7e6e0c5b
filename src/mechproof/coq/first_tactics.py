"""The first tactics of a proof: write out tangents, open angles, note squares and roots."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, combinations

import sympy as sp
from sympy.core.relational import Relational

from mechproof.arithmetic import balls
from mechproof.coq.bound_distances import find_box
from mechproof.coq.sign_proofs import BITS, find_factors, reduce_squares, show_sign, turn_positive
from mechproof.coq.terms import Names, write_term
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_parts, find_roots
from mechproof.statement_domains.domain import Point


def introduce(theorem: Theorem, names: Names) -> str:
    """Write the first tactic, which names the letters and numbers the hypotheses."""
    facts = [f"H{number}" for number in range(1, len(theorem.hypotheses) + 1)]
    letters = (names.get(sp.Tuple(s)) or names[s] for s in theorem.symbols)
    return " ".join(["intros", *letters, *facts]) + "."


def turn_right(theorem: Theorem, names: Names) -> Iterator[str]:
    """Write as arctangents the angles of vectors that point to the right at the witness."""
    vectors = find_parts(theorem.conclusion, sp.atan2)
    for number, vector in enumerate(sorted(vectors, key=sp.count_ops), start=1):
        above, along = vector.args
        if not balls.truth(sp.Gt(along, 0, evaluate=False), theorem.witness, BITS):
            continue
        for angle in _list_angles(along, names):
            yield f"pose proof (COS_bound {angle}). pose proof (SIN_bound {angle})."
        texts = [write_term(part, names) for part in (above, along)]
        proof = show_sign(along, theorem.witness, names, find_box(theorem.hypotheses))
        yield f"try assert (V{number} : 0 < {texts[1]}) by {proof}."
        yield (
            f"try (rewrite (atan2_right {' '.join(texts)} V{number}); "
            f"pose proof (Rgt_not_eq _ _ V{number}))."
        )


def _list_angles(part: sp.Basic, names: Names) -> list[str]:
    angles = {node.args[0] for node in find_parts(part, sp.sin, sp.cos, sp.tan)}
    return [write_term(a, names) for a in sorted(angles, key=sp.default_sort_key)]


class RootLetter(sp.Dummy):  # type: ignore[misc]
    """A letter for the root of an expression."""

    def __new__(cls, root: sp.Expr) -> RootLetter:
        """Return a new positive letter that keeps the expression under the root."""
        letter: RootLetter = super().__new__(cls, "root", positive=True)
        letter.root = root
        return letter


class EstablishedFacts:
    """The facts on parts of the statement `whole` that the tactics in `lines` establish."""

    def __init__(self, whole: sp.Basic, witness: Point, names: Names) -> None:
        self.names = names
        self.witness = witness
        self.lines: list[str] = []
        if find_parts(whole, sp.tan):
            self.lines.append("unfold tan in *.")
        for size in sorted(find_parts(whole, sp.Abs), key=sp.default_sort_key):
            inner = write_term(size.args[0], names)
            self.lines.append(f"pose proof (within_size {inner}).")
            self.lines.append(
                f"try (first [ rewrite (Rabs_right {inner}) in * by (apply Rle_ge; sign) "
                f"| rewrite (Rabs_left1 {inner}) in * by sign ])."
            )
        # Angles with whole turns taken off; SymPy may cancel what is written for them.
        self.turned: list[sp.Basic] = []
        rests: list[sp.Basic] = []
        whole = self._take_turns_off(whole, rests)
        self.rules: list[str] = []
        # The terms that write roots by other roots.
        self.joined: dict[RootLetter, str] = {}
        turned = [*find_parts(whole, sp.sin, sp.cos, sp.tan), *rests]
        self.angles = _find_bases({node.args[0] for node in turned})
        self._open()
        self._note_squares(whole)

    @property
    def modulo(self) -> str:
        """Return the equations between sines, cosines and roots as an argument of `ring`."""
        return f" [{' '.join(self.rules)}]" if self.rules else ""

    @property
    def closing(self) -> str:
        """Return the tactic for an equality of quotients.

        If all else fails, terms are simplified with the squares before `field` compares them.
        """
        by = self.modulo
        conditions = f"conditions ltac:(ring{by})"
        simplified = f"field_simplify_eq{by}; [ ring{by} | {conditions}.. ]"
        return f"first [ ring{by} | field{by}; {conditions} | {simplified} ]"

    def _take_turns_off(self, whole: sp.Basic, rests: list[sp.Basic]) -> sp.Basic:
        """Write sines and cosines of angles with whole turns by those of the remaining angles.

        The latter are added to `rests`.
        """
        # Split into sides, because SymPy would evaluate a relation with equal sides to true.
        sides = [relation.args for relation in find_parts(whole, Relational)]
        whole = sp.Tuple(*chain(*sorted(sides, key=sp.default_sort_key))) if sides else whole
        for node in sorted(find_parts(whole, sp.sin, sp.cos), key=sp.default_sort_key):
            angle = sp.expand(node.args[0])
            turns = angle.coeff(sp.pi) / 2
            if not (turns.is_Integer and turns > 0):
                continue
            rest = node.func(angle - 2 * turns * sp.pi)
            texts = [write_term(part, self.names) for part in (node, rest)]
            inner = write_term(rest.args[0], self.names)
            lemma = "sin_period" if isinstance(node, sp.sin) else "cos_period"
            period = f"rewrite <- ({lemma} {inner} {turns})"
            self.lines.append(
                f"replace {texts[0]} with {texts[1]} in * by "
                f"({period}; f_equal; simpl; field; conditions ltac:(ring))."
            )
            whole = whole.xreplace({node: rest})
            self.turned.append(node.args[0])
            rests += [rest] if isinstance(rest, sp.sin | sp.cos) else []
        return whole

    def _open(self) -> None:
        opened = False
        for angle, terms in self.angles.items():
            if terms == [(1, angle)]:
                continue
            text = write_term(angle, self.names)
            written = " + ".join(
                _repeat(count, write_term(base, self.names)) for count, base in terms
            )
            for function in ("sin", "cos"):
                self.lines.append(
                    f"try replace ({function} {text}) with ({function} ({written})) in * "
                    "by (f_equal; field; conditions ltac:(ring))."
                )
            opened = True
        if opened or any(base.is_number for base in self.bases):
            self.lines.append("open_angles.")

    @property
    def bases(self) -> list[sp.Basic]:
        """Return the angles of which all others are sums."""
        return list(dict.fromkeys(base for terms in self.angles.values() for _, base in terms))

    def _note_squares(self, whole: sp.Basic) -> None:
        for number, base in enumerate(self.bases, start=1):
            angle = write_term(base, self.names)
            self.lines.append(f"pose proof (square_of_sine {angle}) as S{number}.")
            self.rules.append(f"S{number}")
        roots = {root.base for root in find_roots(whole)}
        for number, base in enumerate(sorted(roots, key=sp.default_sort_key), start=1):
            text = write_term(base, self.names)
            square = f"sqrt {text} * sqrt {text} = {text}"
            self.lines.append(
                f"assert (Q{number} : {square}) by (apply sqrt_sqrt; first [ structure | close ])."
            )
            self.rules.append(f"Q{number}")
        self._join_roots(sorted(roots, key=sp.default_sort_key))

    def _join_roots(self, roots: Sequence[sp.Expr]) -> None:
        """Write roots by others: by none, an earlier one, or two that are not written by others."""
        joined: set[sp.Expr] = set()
        for number, root in enumerate(roots):
            self._join_first(root, [(), *((other,) for other in roots[:number])], joined)
        for root in sorted(roots, key=sp.count_ops, reverse=True):
            left = [other for other in roots if other not in (*joined, root)]
            self._join_first(root, combinations(left, 2), joined)

    def _join_first(
        self, root: sp.Expr, choices: Iterable[Sequence[sp.Expr]], joined: set[sp.Expr]
    ) -> None:
        """Write a root by the first choice of others for which that works."""
        for others in () if root in joined else choices:
            scale = _find_scale(root, sp.Mul(*others), self.witness)
            if scale is not None:
                joined.add(root)
                self._join(len(joined), root, scale, others)
                break

    def _join(self, number: int, root: sp.Expr, scale: sp.Expr, others: Sequence[sp.Expr]) -> None:
        text, size = (write_term(part, self.names) for part in (root, scale))
        known = [f"sqrt {write_term(other, self.names)}" for other in others] or ["sqrt 1"]
        lemma, closing = "root_of_product", " | ".join(["close"] * len(known))
        if len(known) == 2:
            lemma, known = "root_of_two", [f"({' * '.join(known)})"]
        self.lines.append(
            f"try assert (M{number} : sqrt {text} = {size} * {known[0]}) by "
            f"(apply {lemma}; [ scale_sign | {closing} | "
            f"field{self.modulo}; conditions ltac:(ring{self.modulo}) ])."
        )
        self.joined[RootLetter(root)] = f"({size} * {known[0] if others else '1'})"
        self.lines.append(f"try rewrite M{number} in *.")
        if not others:
            self.lines.append("try rewrite sqrt_1 in *.")


def is_square(base: sp.Expr, witness: Point) -> bool:
    """Return whether an expression's factors show that it is the square of a quotient."""
    return _find_scale(base, sp.Integer(1), witness) is not None


def _find_scale(root: sp.Expr, other: sp.Expr, witness: Point) -> sp.Expr | None:
    """Return the m for which `root` is m^2 times `other`, if the factors show one, else None.

    Each factor of m is positive at the witness.
    """
    if reduce_squares(root - other) == 0:
        return sp.Integer(1)
    factors = find_factors(root / other)
    if factors is None:
        return None
    powers = Counter(factors.above)
    powers.subtract(factors.below)
    number = sp.sqrt(factors.number)
    if not number.is_Rational or any(power % 2 for power in powers.values()):
        return None
    parts = (turn_positive(f, witness) ** (power // 2) for f, power in powers.items())
    return sp.Mul(number, *parts)


def _find_bases(angles: set[sp.Basic]) -> dict[sp.Basic, list[tuple[int, sp.Basic]]]:
    """Write every angle as whole multiples of as few others as their terms allow."""
    if len(angles) == 1 and not any(angle.has(sp.pi) for angle in angles):
        return {angle: [(1, angle)] for angle in angles}
    split = {a: _list_terms(a) for a in sorted(angles, key=sp.default_sort_key)}
    counts: dict[sp.Basic, list[sp.Rational]] = {}
    for number, base in (term for terms in split.values() for term in terms):
        counts.setdefault(base, []).append(number)
    right = {sp.pi: [sp.S.Half]}
    # The largest number of which all of these are whole multiples.
    units = {
        base: abs(sp.gcd_list([*numbers, *right.get(base, [])])) for base, numbers in counts.items()
    }
    return {
        angle: [(int(number / units[base]), units[base] * base) for number, base in terms]
        for angle, terms in split.items()
    }


def _list_terms(angle: sp.Basic) -> list[tuple[sp.Rational, sp.Basic]]:
    terms = [term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(angle))]
    if len(terms) == 1 and not terms[0][1].is_Symbol and terms[0][0] == 1:
        return [(sp.Integer(1), angle)]
    return [
        (n, base) if n.is_Rational and base != 1 else (sp.Integer(1), n * base) for n, base in terms
    ]


def _repeat(count: int, text: str) -> str:
    total = " + ".join([text] * abs(count))
    return f"(- ({total}))" if count < 0 else f"({total})"
