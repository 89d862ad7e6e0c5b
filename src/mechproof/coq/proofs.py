"""Proofs of theorems: sequences of tactics, by the form of what is to be shown.

Equalities are decided by `field` modulo the squares of sines and of roots; inequalities of
quotients by the signs of the factors of their difference, which SymPy finds and Coq checks.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from math import gcd

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.terms import Names, UnwritableError, write_term
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_parts

_BITS = 128
# Work limit: a difference of so many operations is not factored.
_LONGEST = 400
_ORDERED: Mapping[type[sp.Basic], bool] = {sp.Lt: True, sp.Le: True, sp.Gt: False, sp.Ge: False}


def prove(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics that prove a theorem of all values, a line each."""
    if not theorem.symbols:
        return ["at_point."]
    prepared = _Prepared(theorem, names)
    if isinstance(theorem.conclusion, sp.Eq):
        return [*prepared.lines, *_prove_equality(theorem, prepared)]
    if theorem.conclusion.func in _ORDERED:
        return [*prepared.lines, *_prove_order(theorem, prepared)]
    return [*prepared.lines, "close."]


class _Prepared:
    """The first tactics of a proof: tangents written out, angles opened, squares known."""

    def __init__(self, theorem: Theorem, names: Names) -> None:
        self.names = names
        self.witness = theorem.witness
        whole = sp.And(theorem.conclusion, *theorem.hypotheses, evaluate=False)
        facts = [f"H{number}" for number in range(1, len(theorem.hypotheses) + 1)]
        self.lines = [" ".join(["intros", *(names[s] for s in theorem.symbols), *facts]) + "."]
        if find_parts(whole, sp.tan):
            self.lines.append("unfold tan in *.")
        for size in sorted(find_parts(whole, sp.Abs), key=sp.default_sort_key):
            inner = write_term(size.args[0], names)
            self.lines.append(
                f"try (first [ rewrite (Rabs_right {inner}) in * by (apply Rle_ge; sign) "
                f"| rewrite (Rabs_left1 {inner}) in * by sign ])."
            )
        self.rules: list[str] = []
        self.angles = _find_bases({n.args[0] for n in find_parts(whole, sp.sin, sp.cos, sp.tan)})
        self._open()
        self._note_squares(whole)

    @property
    def modulo(self) -> str:
        """Return the equations that hold between sines, cosines and roots, as `ring` takes them."""
        return f" [{' '.join(self.rules)}]" if self.rules else ""

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
        roots = {p.base for p in find_parts(whole, sp.Pow) if p.exp.is_Rational and p.exp.q == 2}
        for number, base in enumerate(sorted(roots, key=sp.default_sort_key), start=1):
            text = write_term(base, self.names)
            square = f"sqrt {text} * sqrt {text} = {text}"
            self.lines.append(f"assert (Q{number} : {square}) by (apply sqrt_sqrt; close).")
            self.rules.append(f"Q{number}")
        self._join_roots(sorted(roots, key=sp.default_sort_key))

    def _join_roots(self, roots: Sequence[sp.Expr]) -> None:
        """Write a root that is a rational multiple of another, or rational, by it."""
        for number, root in enumerate(roots):
            for other in (sp.Integer(1), *roots[:number]):
                scale = _find_scale(root, other)
                if scale is None:
                    continue
                if balls.truth(sp.Lt(scale, 0, evaluate=False), self.witness, _BITS):
                    scale = -scale
                texts = [write_term(part, self.names) for part in (root, scale, other)]
                known = f"sqrt {texts[2]}" if other != 1 else "sqrt 1"
                self.lines.append(
                    f"try assert (M{number} : sqrt {texts[0]} = {texts[1]} * {known}) by "
                    f"(apply root_of_product; [ scale_sign | close | "
                    f"field{self.modulo}; conditions ltac:(ring{self.modulo}) ])."
                )
                self.lines.append(f"try rewrite M{number} in *.")
                if other == 1:
                    self.lines.append("try rewrite sqrt_1 in *.")
                break


def _find_scale(root: sp.Expr, other: sp.Expr) -> sp.Expr | None:
    """Return the m for which `root` is m^2 times `other`, if the factors show one."""
    factors = _factor(root / other)
    if factors is None:
        return None
    powers = Counter(factors.above)
    powers.subtract(factors.below)
    number = sp.sqrt(factors.number)
    if not number.is_Rational or any(power % 2 for power in powers.values()):
        return None
    return sp.Mul(number, *(f ** (power // 2) for f, power in powers.items()))


def _find_bases(angles: set[sp.Basic]) -> dict[sp.Basic, list[tuple[int, sp.Basic]]]:
    """Write every angle as whole multiples of as few others as their terms allow."""
    split = {a: _list_terms(a) for a in sorted(angles, key=sp.default_sort_key)}
    counts: dict[sp.Basic, list[sp.Rational]] = {}
    for number, base in (term for terms in split.values() for term in terms):
        counts.setdefault(base, []).append(number)
    right = {sp.pi: [sp.S.Half]}
    units = {base: _find_unit([*numbers, *right.get(base, [])]) for base, numbers in counts.items()}
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


def _find_unit(numbers: Sequence[sp.Rational]) -> sp.Rational:
    """Return the largest number of which all are whole multiples."""
    below = reduce(lambda a, b: a * b // gcd(a, b), (int(n.q) for n in numbers))
    above = reduce(gcd, (abs(int(n * below)) for n in numbers))
    return sp.Rational(above, below)


def _repeat(count: int, text: str) -> str:
    total = " + ".join([text] * abs(count))
    return f"(- ({total}))" if count < 0 else f"({total})"


def _prove_equality(theorem: Theorem, prepared: _Prepared) -> Iterator[str]:
    yield from _split_denominators(theorem, prepared)
    by = prepared.modulo
    for angle in _list_doubled(theorem.conclusion):
        text = write_term(angle, prepared.names)
        yield f"try rewrite (double_arctangent {text}) by lra."
    closing = f"first [ ring{by} | field{by}; conditions ltac:(ring{by}) ]"
    yield f"by_parts ltac:({closing})."


def _list_doubled(relation: sp.Basic) -> list[sp.Expr]:
    """List the t of which a relation has 2 arctan t as a product."""
    found = (p for p in find_parts(relation, sp.Mul) if len(p.args) == 2 and p.args[0] == 2)
    return [p.args[1].args[0] for p in found if isinstance(p.args[1], sp.atan)]


def _split_denominators(theorem: Theorem, prepared: _Prepared) -> Iterator[str]:
    """Show of the factors of each denominator that has some that they differ from zero, too."""
    by = prepared.modulo
    number = 0
    for place, fact in enumerate(theorem.hypotheses, start=1):
        if not isinstance(fact, sp.Ne) or fact.args[1] != 0:
            continue
        factors = _factor(fact.args[0])
        if factors is None or factors.is_one:
            continue
        for factor, rest in factors.split():
            number += 1
            text, other = (write_term(part, prepared.names) for part in (factor, rest))
            yield (
                f"try assert (N{number} : {text} <> 0) by "
                f"(intro F; apply H{place}; transitivity ({text} * {other}); "
                f"[ field{by}; conditions ltac:(ring{by}) | rewrite F; apply Rmult_0_l ])."
            )


class _Factors:
    """A quotient of products: a number, and the factors above and below with their powers."""

    def __init__(
        self, number: sp.Expr, above: dict[sp.Expr, int], below: dict[sp.Expr, int]
    ) -> None:
        self.number, self.above, self.below = number, above, below

    @property
    def is_one(self) -> bool:
        """Return whether the expression is one factor itself."""
        return len(self.above) == 1 and not self.below

    def split(self) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """Yield each factor above and then all of them, each with what is left of the quotient."""
        below = sp.Mul(*(f**-k for f, k in self.below.items()), evaluate=False)
        for factor, power in self.above.items():
            others = [f**k for f, k in self.above.items() if f != factor]
            rest = [self.number, factor ** (power - 1), *others, below]
            yield factor, sp.Mul(*rest, evaluate=False)
        if len(self.above) > 1:
            whole = sp.Mul(self.number, *(f**k for f, k in self.above.items()), evaluate=False)
            yield whole, below


def _factor(expression: sp.Expr) -> _Factors | None:
    """Factor what is rational in sines, cosines and letters; None of what is not, or too long."""
    if sp.count_ops(expression) > _LONGEST:
        return None
    plain = expression.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle))
    atoms = sorted(find_parts(plain, sp.sin, sp.cos), key=sp.default_sort_key)
    letters = {atom: sp.Dummy(real=True) for atom in atoms}
    letters[sp.pi] = sp.Dummy(real=True)
    back = {letter: atom for atom, letter in letters.items()}
    lettered = plain.xreplace(letters)
    above, below = sp.fraction(sp.together(lettered))
    try:
        found = [sp.factor_list(part) for part in (above, below)]
    except sp.PolynomialError:
        return None
    parts = [{f.xreplace(back): int(k) for f, k in listed} for _, listed in found]
    return _Factors(found[0][0] / found[1][0], *parts)


def _prove_order(theorem: Theorem, prepared: _Prepared) -> Iterator[str]:
    conclusion = theorem.conclusion
    left, right = conclusion.args if _ORDERED[conclusion.func] else reversed(conclusion.args)
    factors = _factor(right - left)
    if factors is None or not find_parts(sp.Tuple(*factors.above, *factors.below), sp.Symbol):
        yield "close."
        return
    for base in prepared.bases:
        angle = write_term(base, prepared.names)
        yield f"pose proof (COS_bound {angle}). pose proof (SIN_bound {angle})."
    if conclusion.func is sp.Ge:
        yield "apply Rle_ge."
    yield f"first [ solve [ close ] | {_combine(theorem, factors, prepared)} ]."


def _combine(theorem: Theorem, factors: _Factors, prepared: _Prepared) -> str:
    """Write the difference as a product of what is shown to be positive."""
    is_strict = theorem.conclusion.func in (sp.Lt, sp.Gt)
    steps: list[str] = []
    above: list[str] = []
    below: list[str] = []
    number = factors.number
    for listed, texts, strict in ((factors.above, above, is_strict), (factors.below, below, True)):
        for factor, power in listed.items():
            negative = balls.truth(sp.Lt(factor, 0, evaluate=False), theorem.witness, _BITS)
            text = write_term(-factor if negative else factor, prepared.names)
            number = -number if negative and power % 2 else number
            texts += [text] * power
            sign = "<" if strict else "<="
            steps.append(f"assert (0 {sign} {text}) by sign")
    quotient = f"({write_term(abs(number), prepared.names)} * ({' * '.join(above or ['1'])}))"
    quotient = f"({quotient} / ({' * '.join(below or ['1'])}))"
    lemma = "less_by" if is_strict else "at_most_by"
    by = prepared.modulo
    steps.append(
        f"apply ({lemma} _ _ {quotient}); [ field{by}; conditions ltac:(ring{by}) | product_sign ]"
    )
    return "; ".join(f"({step})" if step.startswith("assert") else step for step in steps)


__all__ = ["UnwritableError", "prove"]
