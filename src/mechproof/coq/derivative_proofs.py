"""Proofs by derivatives, and of derivatives.

Two sides are equal if they are equal at one place and have the same derivative. Integrals with one
moving limit are differentiated by the fundamental theorem of calculus. For a stated derivative, Coq
compares its own result with the statement.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.first_tactics import EstablishedFacts, introduce, is_square, turn_right
from mechproof.coq.sign_proofs import find_factors, prove_order, show_sign, turn_positive
from mechproof.coq.terms import (
    Names,
    UnwritableError,
    list_integrals,
    list_needs,
    name_symbols,
    write_relation,
    write_term,
)
from mechproof.coq.theorems import Theorem, list_between
from mechproof.record.parts import find_free, find_parts, find_roots

# The running variable while it moves from the place of equality to its value.
_MOVING = sp.Symbol("Z0", real=True)
_ANGLES = (sp.atan, sp.atan2)
_TURNS = (sp.sin, sp.cos, sp.tan)


@dataclass(frozen=True)
class _Known:
    """An integral with the name of the function of its upper limit, and with names of letters."""

    integral: sp.Integral
    name: str
    names: Names

    @property
    def letter(self) -> sp.Symbol:
        """Return the variable of integration."""
        return self.integral.limits[0][0]

    @property
    def limit(self) -> sp.Expr:
        """Return the moving limit."""
        return self.integral.limits[0][2]

    def at(self, value: sp.Expr) -> sp.Expr:
        """Return the integrand at a value of its letter."""
        return self.integral.function.subs(self.letter, value)


def prove_by_derivative(theorem: Theorem, names: Names) -> list[str]:
    """Write the tactics for an equality. Raises `UnwritableError` if no variable will do."""
    if not isinstance(theorem.conclusion, sp.Eq):
        raise UnwritableError("with integrals only equalities are proved")
    variable = find_variable(theorem)
    if variable is None:
        raise UnwritableError("no variable by which both sides could be differentiated")
    return list(_Proof(theorem, names, variable).write())


def find_variable(theorem: Theorem) -> sp.Symbol | None:
    """Return the symbol to differentiate by, one whose bounds allow zero, or None.

    Symbols in sines and tangents come first: at an angle of zero these are zero, too.
    """
    parts = find_parts(theorem.conclusion, sp.Integral) or find_parts(theorem.conclusion, *_ANGLES)
    moved = {s for part in parts for s in find_free(_take_moving(part))}
    bounds = {s: _list_bounds(s, theorem) for s in moved}
    tied = {
        s
        for h in theorem.hypotheses
        if not (isinstance(h, sp.Ne) or _is_of_square(h, theorem))
        for s in find_free(h) & moved
        if h not in bounds[s]
    }
    served = [s for s in moved - tied if theorem.witness and _has_zero(bounds[s])]
    turned = {s for node in find_parts(sp.Tuple(*parts), *_TURNS) for s in find_free(node)}
    return min(served, key=lambda s: (s not in turned, len(bounds[s]), str(s)), default=None)


def _is_of_square(hypothesis: sp.Basic, theorem: Theorem) -> bool:
    """Return whether a hypothesis says only that the root of a square has a value."""
    under = (sp.Ge, sp.S.Zero)
    return (hypothesis.func, hypothesis.args[1]) == under and is_square(
        hypothesis.args[0], theorem.witness
    )


def _take_moving(part: sp.Basic) -> sp.Basic:
    return part.limits[0][-1] if isinstance(part, sp.Integral) else part


def _list_bounds(symbol: sp.Basic, theorem: Theorem) -> list[sp.Basic]:
    return [h for h in theorem.hypotheses if h.args[0] == symbol and h.args[1].is_number]


def _has_zero(bounds: Sequence[sp.Basic]) -> bool:
    return all(balls.truth(b.func(0, b.args[1], evaluate=False), {}) is True for b in bounds)


class _Proof:
    def __init__(self, theorem: Theorem, names: Names, variable: sp.Symbol) -> None:
        self.theorem, self.names, self.variable = theorem, names, variable
        self.roots = EstablishedFacts(_list_still_roots(theorem, variable), theorem.witness, names)
        self.sides = tuple(
            _join(side, self.roots.joined).replace(
                sp.atan2, lambda above, along: sp.atan(above / along, evaluate=False)
            )
            for side in theorem.conclusion.args
        )
        integrals = [i for side in self.sides for i in list_integrals(side)]
        self.known = [
            _Known(integral, f"I{number}", name_symbols([integral.limits[0][0]], names))
            for number, integral in enumerate(dict.fromkeys(integrals), start=1)
        ]
        if any(variable in find_free(k.integral.function) for k in self.known):
            raise UnwritableError(
                "an integrand that contains the letter of its limit is not differentiated"
            )
        # Roots are written by their terms, as if they were letters.
        self.names = {**names, **self.roots.joined}
        self.inner = {**self.names, _MOVING: str(_MOVING)}
        self.slopes = [self._move(sp.diff(side, variable).doit()) for side in self.sides]

    def _move(self, expression: sp.Basic) -> sp.Basic:
        return expression.subs(self.variable, _MOVING)

    def write(self) -> Iterator[str]:
        """Yield the lines of the proof."""
        yield introduce(self.theorem, self.names)
        yield from turn_right(self.theorem, self.names)
        yield from self.roots.lines
        needs = list(self._list_inner_needs())
        for number, (known, need) in enumerate(needs, start=1):
            yield from self._state_need(number, known, need)
        for known in self.known:
            yield from self._name_integral(known, needs)
        left, right = (self._write(side, self.names) for side in self.sides)
        name = self.names[self.variable]
        yield from self._state_joined(left, right)
        if self.known:
            yield f"clearbody {' '.join(known.name for known in self.known)}."
        functions = " ".join(f"(fun {name} : R => {side})" for side in (left, right))
        yield f"apply (equal_by_derivative {functions} 0 {name}); cbv beta."
        yield "{"
        yield from (f"  {line}" for line in self._differentiate(needs))
        yield "}"
        yield from self._compare_at_zero()

    def _state_joined(self, left: str, right: str) -> Iterator[str]:
        """State the sides with joined roots, whose factors may then be in another order."""
        if not self.roots.joined:
            known = "by_depth ltac:(zero)"
            other = f"transitivity {left}; [ {known} | transitivity {right}; [ | {known} ] ]"
            yield f"first [ change ({left} = {right}) | {other} ]."
            return
        yield f"transitivity {left}; [ by_depth ltac:(ring) | ]."
        yield f"transitivity {right}; [ | by_depth ltac:(ring) ]."

    def _write(self, expression: sp.Basic, names: Names) -> str:
        """Write an expression with the integrals as functions of their limits."""
        limits = {k.integral: sp.Dummy() for k in self.known}
        found = {**names}
        for known in self.known:
            found[limits[known.integral]] = f"({known.name} {write_term(known.limit, names)})"
        return write_term(expression.xreplace(limits), found)

    def _list_inner_needs(self) -> Iterator[tuple[_Known, sp.Basic]]:
        for known in self.known:
            if list_between(known.integral):
                raise UnwritableError("an integrand that has no values somewhere is not proved yet")
            for need in list_needs(known.integral.function):
                if known.letter in find_free(need):
                    yield known, need

    def _state_need(self, number: int, known: _Known, need: sp.Basic) -> Iterator[str]:
        """Show that a part of an integrand has a value for every value of its letter."""
        letter = known.names[known.letter]
        yield f"assert (W{number} : forall {letter} : R, {write_relation(need, known.names)})."
        yield f"{{ intros {letter}."
        witness = {**self.theorem.witness, known.letter: sp.Rational(3, 4)}
        facts = EstablishedFacts(need, witness, known.names)
        about = (facts.bases, facts.modulo, witness, known.names)
        yield from (f"  {line}" for line in (*facts.lines, *prove_order(need, *about)))
        yield "}"

    def _name_integral(self, known: _Known, needs: list[tuple[_Known, sp.Basic]]) -> Iterator[str]:
        """State the derivative of the integral, and that it is zero at its lower limit."""
        name, letter = known.name, known.names[known.letter]
        number, lower = name[1:], write_term(known.integral.limits[0][1], self.names)
        body = write_term(known.integral.function, known.names)
        function = f"(fun {letter} : R => {body})"
        yield f"pose ({name} := fun {letter} : R => RInt {function} {lower} {letter})."
        yield f"assert (D{number} : forall {letter} : R, is_derive {name} {letter} {body})."
        yield f"{{ intros {letter}. apply (derivative_of_integral {function} {lower} {letter})."
        facts = [
            f"pose proof (W{k} {letter})." for k, (of, _) in enumerate(needs, 1) if of is known
        ]
        yield f"  clear {letter}. intros {letter}. {' '.join(facts)} auto_derive. has_value. }}"
        yield (
            f"assert (B{number} : forall {letter} : R, {letter} = {lower} -> {name} {letter} = 0) "
            f"by (intros {letter}; apply (empty_integral {function} {lower} {letter}))."
        )

    def _differentiate(self, needs: list[tuple[_Known, sp.Basic]]) -> Iterator[str]:
        """Show that the derivative of the difference is zero."""
        yield "intros Z0 B0. cbv beta."
        for bound in _list_bounds(self.variable, self.theorem):
            yield f"assert {write_relation(self._move(bound), self.inner)} by within_bounds."
        for number, (known, _) in enumerate(needs, start=1):
            yield f"pose proof (W{number} {write_term(self._move(known.limit), self.inner)})."
        witness = {**self.theorem.witness, _MOVING: self.theorem.witness[self.variable]}
        facts = EstablishedFacts(sp.Tuple(*self.slopes), witness, self.inner)
        yield from self._bound_angles(facts)
        yield from self._show_factors(facts)
        yield "auto_derive; has_values."
        for known in self.known:
            derivative = f"(fun x : R => {known.name} x) _ _ (D{known.name[1:]} _)"
            yield f"rewrite ?(is_derive_unique {derivative})."
        for angle in (*facts.angles, *facts.turned):
            yield f"angles_as {write_term(angle, self.inner)}."
        yield from facts.lines
        yield f"{facts.closing}."

    def _bound_angles(self, facts: EstablishedFacts) -> Iterator[str]:
        for angle in facts.angles:
            text = write_term(angle, self.inner)
            yield f"pose proof (COS_bound {text}). pose proof (SIN_bound {text})."
        for tangent in find_parts(sp.Tuple(*self.sides), sp.tan):
            angle = write_term(self._move(tangent.args[0]), self.inner)
            yield f"assert (0 < cos {angle}) by (apply cos_gt_0; lra)."
        if find_parts(sp.Tuple(*self.sides), sp.tan):
            yield "unfold tan in *."

    def _show_factors(self, facts: EstablishedFacts) -> Iterator[str]:
        """Show that the factors of all denominators are nonzero."""
        insides = [k.at(k.limit) for k in self.known]
        needed = [n for part in (*self.sides, *insides) for n in list_needs(part)]
        factors: dict[sp.Expr, None] = {}
        for need in needed:
            found = find_factors(self._move(need.args[0])) if isinstance(need, sp.Ne) else None
            if found is not None:
                whole = [self._move(need.args[0])] if found.below else []
                factors |= dict.fromkeys([*found.above, *found.below, *whole])
        for number, factor in enumerate(factors, start=1):
            positive = turn_positive(factor, facts.witness)
            proof = show_sign(positive, facts.witness, self.inner)
            yield f"try assert (N{number} : 0 < {write_term(positive, self.inner)}) by {proof}."

    def _is_outside(self, part: sp.Basic) -> bool:
        """Return whether a part contains no variable of integration."""
        return not find_free(part) & {known.letter for known in self.known}

    def _compare_at_zero(self) -> Iterator[str]:
        for known in self.known:
            number = known.name[1:]
            yield f"repeat rewrite B{number} by (at_zero; zero)."
        yield "at_zero."
        whole = sp.Tuple(*(side.subs(self.variable, 0) for side in self.sides))
        rest = whole.xreplace({k.integral.subs(self.variable, 0): sp.S.Zero for k in self.known})
        facts = EstablishedFacts(rest, self.theorem.witness, self.names)
        nodes = find_parts(sp.Tuple(*self.sides), sp.sin, sp.cos)
        angles = {node.args[0].subs(self.variable, 0) for node in nodes if self._is_outside(node)}
        for angle in sorted(angles - {sp.S.Zero}, key=sp.default_sort_key):
            yield f"angles_as {write_term(angle, self.names)}."
        if any(angle.is_number for angle in angles - {sp.S.Zero}):
            yield "rewrite ?sin_2PI, ?cos_2PI, ?sin_PI, ?cos_PI. at_zero."
        yield from facts.lines
        yield f"odd_arctangents. {facts.closing}."


def _list_still_roots(theorem: Theorem, variable: sp.Symbol) -> sp.Tuple:
    """List the roots that do not depend on the variable, or that are roots of squares."""
    still = [
        r
        for r in find_roots(theorem.conclusion)
        if (variable not in find_free(r) and not find_parts(r, sp.sin, sp.cos))
        or is_square(r.base, theorem.witness)
    ]
    return sp.Tuple(*sorted(still, key=sp.default_sort_key))


def _join(side: sp.Basic, joined: Names) -> sp.Basic:
    """Replace the roots joined by the first tactics, written by other roots or none, by letters."""
    letters = {letter.root: letter for letter in joined}
    powers = [p for p in find_roots(side) if p.base in letters]
    return side.xreplace({p: letters[p.base] ** (2 * p.exp) for p in powers})


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
    """List the expressions under roots, smaller ones first."""
    bases = {root.base for root in find_roots(whole)}
    return sorted(bases, key=lambda base: (sp.count_ops(base), sp.default_sort_key(base)))


def _restore_roots(whole: sp.Basic, names: Names) -> Iterator[str]:
    """Restore roots whose radicands' powers Coq has expanded."""
    for base in _list_roots(whole):
        text = write_term(base, names)
        yield (
            "repeat match goal with |- context [sqrt ?u] => tryif constr_eq u "
            f"{text} then fail else change (sqrt u) with (sqrt {text}) end."
        )


def _show_roots(whole: sp.Basic, names: Names) -> Iterator[str]:
    """Try to show that each root is nonzero."""
    for number, base in enumerate(_list_roots(whole), start=1):
        text = write_term(base, names)
        yield (
            f"try assert (P{number} : sqrt {text} <> 0) by "
            "(apply Rgt_not_eq, sqrt_lt_R0; first [ structure | lra | nra ])."
        )
