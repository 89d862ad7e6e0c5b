"""Signs of quotients: SymPy factors a difference, and Coq checks the factors and their signs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.bound_distances import NO_BOX, Box, find_box, spread_out
from mechproof.coq.terms import Names, write_term
from mechproof.record.parts import find_parts, find_roots
from mechproof.statement_domains.domain import Point

BITS = 128
# Work limit: a difference of more operations than this is not factored.
_LONGEST = 400
_TURNS = (sp.sin, sp.cos, sp.tan)
ORDERED: Mapping[type[sp.Basic], bool] = {sp.Lt: True, sp.Le: True, sp.Gt: False, sp.Ge: False}


class FactoredQuotient:
    """A quotient of products: a number, and numerator and denominator factors with powers."""

    def __init__(
        self, number: sp.Expr, above: dict[sp.Expr, int], below: dict[sp.Expr, int]
    ) -> None:
        self.number, self.above, self.below = number, above, below

    @property
    def is_one(self) -> bool:
        """Return whether the numerator has one factor and there is no denominator."""
        return len(self.above) == 1 and not self.below

    def split(self) -> Iterator[tuple[sp.Expr, sp.Expr]]:
        """Yield each numerator factor, then their whole product, with the rest of the quotient."""
        below = sp.Mul(*(f**-k for f, k in self.below.items()), evaluate=False)
        for factor, power in self.above.items():
            others = [f**k for f, k in self.above.items() if f != factor]
            rest = [self.number, factor ** (power - 1), *others, below]
            yield factor, sp.Mul(*rest, evaluate=False)
        if len(self.above) > 1:
            whole = sp.Mul(self.number, *(f**k for f, k in self.above.items()), evaluate=False)
            yield whole, below


def find_factors(expression: sp.Expr) -> FactoredQuotient | None:
    """Factor a rational expression of sines, cosines and letters; None for others and long ones."""
    if sp.count_ops(expression) > _LONGEST:
        return None
    plain = expression.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle))
    atoms = sorted(find_parts(plain, sp.sin, sp.cos), key=sp.default_sort_key)
    atoms += _list_powers(plain)
    letters = {atom: sp.Dummy(real=True) for atom in atoms}
    letters[sp.pi] = sp.Dummy(real=True)
    back = {letter: atom for atom, letter in letters.items()}
    for base, powers in _list_roots(plain).items():
        root = sp.Dummy(real=True)
        back[root] = sp.sqrt(base)
        letters |= {power: root ** (2 * power.exp) for power in powers}
    lettered = plain.xreplace(letters)
    above, below = sp.fraction(sp.together(lettered))
    try:
        found = [sp.factor_list(part) for part in (above, below)]
    except sp.PolynomialError:
        return None
    parts = [{f.xreplace(back): int(k) for f, k in listed} for _, listed in found]
    return FactoredQuotient(found[0][0] / found[1][0], *parts)


def _list_roots(expression: sp.Basic) -> dict[sp.Expr, list[sp.Pow]]:
    """List powers with half-integer exponents by their bases, except those inside others."""
    found: dict[sp.Expr, list[sp.Pow]] = {}
    for power in sorted(find_roots(expression), key=sp.default_sort_key):
        if find_parts(power.base, sp.Symbol):
            found.setdefault(power.base, []).append(power)
    return found


def reduce_squares(expression: sp.Expr) -> sp.Expr:
    """Write squares of sines by cosines, and expand."""
    sines = {s: sp.Dummy() for s in find_parts(expression, sp.sin)}
    value = sp.expand(expression.xreplace(sines))
    for sine, letter in sines.items():
        if not value.is_polynomial(letter):
            return value.xreplace({v: k for k, v in sines.items()})
        rule = letter**2 + sp.cos(sine.args[0]) ** 2 - 1
        value = sp.rem(value, rule, letter)
    return sp.expand(value).xreplace({letter: sine for sine, letter in sines.items()})


def _list_powers(expression: sp.Basic) -> list[sp.Pow]:
    """List the powers that are written as exponentials."""
    powers = (p for p in find_parts(expression, sp.Pow) if not p.exp.is_Rational)
    return sorted(powers, key=sp.default_sort_key)


def prove_order(
    relation: sp.Basic,
    bases: Sequence[sp.Basic],
    modulo: str,
    witness: Point,
    names: Names,
    known: Sequence[sp.Basic] = (),
) -> Iterator[str]:
    """Write the tactics for an inequality of quotients, including "differs from"."""
    kind, (left, right) = relation.func, relation.args
    if kind is sp.Ne:
        kind = sp.Lt if balls.truth(sp.Lt(left, right, evaluate=False), witness, BITS) else sp.Gt
    if not ORDERED[kind]:
        left, right = right, left
    factors = find_factors(right - left)
    if factors is None or not find_parts(sp.Tuple(*factors.above, *factors.below), sp.Symbol):
        yield "close."
        return
    if not _is_strict(kind) and (root := _find_root(right - left, bases)):
        square = f"({write_term(root, names)} ^ 2)"
        if relation.func is sp.Ge:
            yield "apply Rle_ge."
        yield f"apply (at_most_by _ _ {square}); [ ring{modulo} | apply pow2_ge_0 ]."
        return
    for base in bases:
        angle = write_term(base, names)
        yield f"pose proof (COS_bound {angle}). pose proof (SIN_bound {angle})."
    for power in _list_powers(right - left):
        exponent, base = write_term(power.exp, names), write_term(power.base, names)
        yield f"pose proof (exp_pos ({exponent} * (ln {base})))."
    if relation.func is sp.Ge:
        yield "apply Rle_ge."
    box = find_box(known)
    proof = _combine(factors, _is_strict(kind), modulo, witness, names, box)
    if relation.func is sp.Ne:
        proof = f"apply {'Rlt_not_eq' if kind is sp.Lt else 'Rgt_not_eq'}; {proof}"
    yield f"first [ solve [ structure ] | solve [ close ] | {proof} ]."


def _is_strict(kind: type[sp.Basic]) -> bool:
    """Return whether the sides of an inequality must differ."""
    return kind in (sp.Lt, sp.Gt)


def _find_root(difference: sp.Expr, bases: Sequence[sp.Basic]) -> sp.Expr | None:
    """Return the root of a difference that is a square once 1 is written as sin² + cos²."""
    if len(bases) != 1 or {a.args[0] for a in find_parts(difference, *_TURNS)} != set(bases):
        return None
    sine, cosine = sp.Dummy(real=True), sp.Dummy(real=True)
    back = {sine: sp.sin(bases[0]), cosine: sp.cos(bases[0])}
    lettered = difference.xreplace({atom: letter for letter, atom in back.items()})
    if not lettered.is_polynomial(sine, cosine):
        return None
    terms = sp.Poly(lettered, sine, cosine).terms()
    most = max(sum(powers) for powers, _ in terms)
    if any((most - sum(powers)) % 2 for powers, _ in terms):
        return None
    whole = sp.Add(
        *(
            factor * sine**s * cosine**c * (sine**2 + cosine**2) ** ((most - s - c) // 2)
            for (s, c), factor in terms
        )
    )
    number, factors = sp.factor_list(whole)
    root = sp.sqrt(number)
    if not root.is_Rational or any(power % 2 for _, power in factors):
        return None
    return sp.Mul(root, *(f ** (power // 2) for f, power in factors)).xreplace(back)


def _combine(
    factors: FactoredQuotient, is_strict: bool, modulo: str, witness: Point, names: Names, box: Box
) -> str:
    """Write the difference as a product of numbers that are each shown to be positive."""
    steps: list[str] = []
    above: list[str] = []
    below: list[str] = []
    number = factors.number
    for listed, texts, strict in ((factors.above, above, is_strict), (factors.below, below, True)):
        for factor, power in listed.items():
            positive = turn_positive(factor, witness)
            text = write_term(positive, names)
            number = -number if positive != factor and power % 2 else number
            texts += [text] * power
            sign = "<" if strict else "<="
            steps.append(f"assert (0 {sign} {text}) by {show_sign(positive, witness, names, box)}")
    quotient = f"({write_term(abs(number), names)} * ({' * '.join(above or ['1'])}))"
    quotient = f"({quotient} / ({' * '.join(below or ['1'])}))"
    lemma = "less_by" if is_strict else "at_most_by"
    steps.append(
        f"apply ({lemma} _ _ {quotient}); "
        f"[ field{modulo}; conditions ltac:(ring{modulo}) | product_sign ]"
    )
    return "; ".join(f"({step})" if step.startswith("assert") else step for step in steps)


def turn_positive(factor: sp.Expr, witness: Point) -> sp.Expr:
    """Return the expression, or its opposite if it is negative at the witness."""
    return -factor if balls.truth(sp.Lt(factor, 0, evaluate=False), witness, BITS) else factor


def show_sign(positive: sp.Expr, witness: Point, names: Names, box: Box = NO_BOX) -> str:
    """Write the tactic that shows an expression positive, possibly linear in one sine or cosine.

    Within a `box`, it suffices that it has no negative coefficient in the distances from its
    bounds.
    """
    above, below = sp.fraction(positive)
    if find_parts(below, sp.Symbol) and box:
        parts = " | ".join(show_sign(part, witness, names, box) for part in (above, below))
        return f"first [ structure | sign | apply Rdiv_lt_0_compat; [ {parts} ] ]"
    ways = ["structure", *_rewrite(positive, names, box), "sign", *_turn(positive, witness, names)]
    return f"first [ {' | '.join(ways)} ]"


def _rewrite(positive: sp.Expr, names: Names, box: Box) -> Iterator[str]:
    """Write the tactics that replace it by an equal sum of positive terms, or by a square."""
    text, spread = write_term(positive, names), spread_out(positive, box)
    if spread is not None:
        yield f"replace {text} with {write_term(spread, names)} by field; structure"
    if (root := _find_square(positive)) is not None:
        square = f"({write_term(root, names)} ^ 2)"
        known = " ".join(f"(square_of_sine {write_term(a, names)})" for a in _list_turned(positive))
        yield f"replace {text} with {square} by ring [{known}]; structure"


def _turn(positive: sp.Expr, witness: Point, names: Names) -> Iterator[str]:
    """Write the tactic for an expression that is linear in one sine or cosine."""
    letter = sp.Dummy()
    for function in sorted(find_parts(positive, sp.sin, sp.cos), key=sp.default_sort_key):
        linear = positive.xreplace({function: letter})
        if linear.has(function.args[0]) or not linear.is_polynomial(letter):
            continue
        if sp.degree(linear, letter) != 1:
            continue
        ends = [write_product(linear.subs(letter, end), witness, names) for end in (1, -1)]
        texts = " ".join((write_term(function, names), *ends))
        bound = "SIN_bound" if isinstance(function, sp.sin) else "COS_bound"
        same = "field; conditions ltac:(ring)" if any(" / (" in end for end in ends) else "field"
        yield (
            f"apply (linear_positive {texts}); "
            f"[ apply {bound} | product_sign | product_sign | {same} ]"
        )
        return


def _list_turned(expression: sp.Expr) -> list[sp.Expr]:
    """List the angles of sines, whose squares determine those of cosines."""
    angles = {sine.args[0] for sine in find_parts(expression, sp.sin)}
    return sorted(angles, key=sp.default_sort_key)


def _find_square(expression: sp.Expr) -> sp.Expr | None:
    """Return the root of an expression that is a square once no sine is squared."""
    if not find_parts(expression, sp.sin):
        return None
    factors = find_factors(reduce_squares(expression))
    if factors is None or factors.below or any(k % 2 for k in factors.above.values()):
        return None
    number = sp.sqrt(factors.number)
    return (
        sp.Mul(number, *(f ** (k // 2) for f, k in factors.above.items()))
        if number.is_Rational
        else None
    )


def write_product(positive: sp.Expr, witness: Point, names: Names) -> str:
    """Write a positive expression as a quotient of products of positive factors."""
    factors = find_factors(positive)
    if factors is None:
        return write_term(positive, names)
    above, below = (
        [turn_positive(f, witness) for f, power in listed.items() for _ in range(power)]
        for listed in (factors.above, factors.below)
    )
    text = " * ".join(write_term(part, names) for part in (abs(factors.number), *above))
    under = " * ".join(write_term(part, names) for part in below)
    return f"({text} / ({under}))" if below else f"({text})"
