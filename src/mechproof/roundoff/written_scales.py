"""Written scales: in, the scale that errors are relative to; out, its steps and those of its terms.

Steps that compute the same number are merged: a sum or a product is rounded alike whatever the
order of its operands. This is the value numbering of compilers (Cocke and Schwartz 1970).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp
from sympy.simplify.fu import TR9

from mechproof.arithmetic.polynomials import cancel
from mechproof.programs.evaluation import find_needed
from mechproof.programs.kernel import build_kernel, input_names
from mechproof.programs.program import Operand, Stage
from mechproof.record import Form, Paper, Quantity
from mechproof.record.substitution import resolve
from mechproof.roundoff.affine import find_size
from mechproof.roundoff.error_sums import ErrorScale
from mechproof.roundoff.interval_monomials import IntervalMonomial
from mechproof.roundoff.steps import EXACT, IN_NUMPY, Step, StraightLineProgram, flatten_stage

PLAIN_REWRITES = ("positive_atan2", "half_angle_tangent")
# With fewer terms than this, one of them is nearly the whole scale, so terms do not help.
LEAST_TERMS = 3


@dataclass(frozen=True)
class WrittenScale:
    """The steps of a scale and, if the value is a part of it, of its excess over the value.

    A second program has, up to sign, `terms` terms of the sum, without the value if that is one of
    them, and then lower bounds of the scale: the candidates of maxima. `known` marks those known to
    be never negative. `is_at_least` states that the scale, though the value is no term of it, is
    visibly at least the value.
    """

    straights: tuple[StraightLineProgram, ...]
    terms: int
    known: tuple[bool, ...]
    is_at_least: bool = False

    def weigh(
        self, outputs: Sequence[IntervalMonomial], parts: Sequence[IntervalMonomial] = ()
    ) -> ErrorScale:
        """Return the scale over boxes, with its terms if none of them is negative."""
        whole, *rest = outputs
        pairs = zip(self.known, parts, strict=True)
        signs = [known or part.decide_sign() > 0 for known, part in pairs]
        terms = parts[: self.terms] if all(signs[: self.terms]) else ()
        least = [part for part, holds in zip(parts, signs, strict=True) if holds][len(terms) :]
        if not rest or (not terms and rest[0].decide_sign() <= 0):
            # The listed terms add up to the scale without the value.
            return ErrorScale(whole, self.is_at_least and not terms, terms, least)
        # The absolute value of a pole is no monomial: there the excess replaces the scale.
        is_known = whole.span.is_finite
        scale = rest[0] if whole.variables.choose(is_known, ~is_known) else whole
        return ErrorScale(scale, True, terms, least)


def write_scale(quantity: Quantity, form: Form, stage: Stage, paper: Paper) -> WrittenScale | None:
    """Return the scale, written without roundings by the form's rewrites other than low words.

    None if errors are relative to the value.
    """
    if quantity.accuracy is None or quantity.accuracy.scale is None:
        return None
    rewrites = tuple(name for name in form.rewrites if name in PLAIN_REWRITES)
    scale = quantity.accuracy.scale
    # The value is written in the same way as in the scale.
    size, value = (
        _join_waves(replace(scale, expression=part).written_out())
        for part in (scale.expression, quantity.definition)
    )
    if stage.affine:
        points, shift = quantity.arguments[0].symbols, stage.prepare.outputs[-len(stage.running) :]
        size = find_size(size, points, [s for s, n in input_names(quantity).items() if n in shift])

    def write(*expressions: sp.Expr) -> StraightLineProgram:
        return _join([_write_exact(e, rewrites, quantity, paper) for e in expressions])

    terms = _list_terms(size)
    own = [part for part in (value, sp.Abs(value)) if _list_terms(part) <= terms]
    others = sorted(terms - _list_terms(own[0]) if own else terms, key=sp.default_sort_key)
    least = [part for term in others if isinstance(term, sp.Max) for part in term.args]
    if len(others) + len(own) < LEAST_TERMS:
        others = []
    straights = [write(size, *(size - part for part in own))]
    parts = [*others, *sorted(least, key=sp.default_sort_key)]
    if parts:
        straights.append(share_equal_steps(write(*map(_drop_signs, parts))))
    known = tuple(part.is_extended_nonnegative is True for part in parts)
    is_at_least = not own and not others and _is_seen(size, quantity, form, paper)
    return WrittenScale(tuple(straights), len(others), known, is_at_least)


def _is_seen(size: sp.Expr, quantity: Quantity, form: Form, paper: Paper) -> bool:
    """Return whether a scale is visibly at least the value of a form."""
    if form.expression.is_Matrix:
        return False
    inputs = input_names(quantity).keys()
    given = {symbol: value for symbol, value in paper.given.items() if symbol not in inputs}
    value = resolve(form.expression, given)
    return any(_is_multiple(resolve(part, given), value) for part in list_below(size))


def list_below(size: sp.Expr) -> Iterator[sp.Expr]:
    """Yield expressions that are no larger in absolute value than a scale, itself first."""
    yield size
    parts = size.args
    if isinstance(size, sp.Add) and all(part.is_extended_nonnegative for part in parts):
        yield from itertools.chain.from_iterable(map(list_below, parts))
    elif isinstance(size, sp.Max):
        for part in parts:
            if part.is_extended_nonnegative:
                yield from list_below(part)
    elif isinstance(size, sp.Mul):
        for part in parts:
            if isinstance(part, sp.Add | sp.Max):
                others = sp.Mul(*(other for other in parts if other is not part))
                _, *below = list_below(part)
                yield from (others * one for one in below)


def _is_multiple(part: sp.Expr, value: sp.Expr) -> bool:
    """Return whether a part is visibly a multiple of a value, of at least its absolute value."""
    one, other = map(_drop_signs, (part, value))
    if one.has(sp.Abs, sp.Max) or other == 0:
        return False
    try:
        above, below = cancel(one / other)
    except sp.PolynomialError:
        return False
    return bool(above.is_Number and below.is_Number and abs(above) >= below)


def _join_waves(size: sp.Basic) -> sp.Basic:
    """Write differences of sines or cosines as products, which vanish as their angles do."""
    return size.replace(
        lambda part: part.is_Add and all(term.has(sp.sin, sp.cos) for term in part.args), TR9
    )


def _list_terms(size: sp.Basic) -> set[sp.Basic]:
    return {*sp.Add.make_args(size)}


def _drop_signs(term: sp.Expr) -> sp.Expr:
    """Return a term without absolute values: only its size is used."""
    factors = sp.Mul.make_args(term)
    return sp.Mul(*(f.args[0] if isinstance(f, sp.Abs) else f for f in factors))


def _write_exact(
    expression: sp.Expr, rewrites: tuple[str, ...], quantity: Quantity, paper: Paper
) -> StraightLineProgram:
    if not expression.free_symbols:
        return StraightLineProgram((), (), (float(expression),))
    written = Form("scale", expression, rewrites)
    met = find_needed(expression, paper.given)
    needed = tuple(a for a in quantity.arguments if met & {*a.symbols})
    alone = replace(quantity, forms=(written,), arguments=needed)
    (stage,) = build_kernel("scale", alone, (written,), paper).code.stages
    straight = flatten_stage(stage, IN_NUMPY)
    return replace(straight, steps=tuple(replace(step, ulps=EXACT) for step in straight.steps))


def _join(straights: Sequence[StraightLineProgram]) -> StraightLineProgram:
    """Return one program of several, with a prefix on the results of each."""
    steps: list[Step] = []
    outputs: list[Operand] = []
    inputs = tuple(dict.fromkeys(name for straight in straights for name in straight.inputs))
    for number, straight in enumerate(straights):
        renamed = straight.rename({s.result: f"{number}.{s.result}" for s in straight.steps})
        steps += renamed.steps
        outputs += renamed.outputs
    return StraightLineProgram(inputs, tuple(steps), tuple(outputs))


_COMMUTATIVE = ("add", "multiply")
Key = tuple[str, float, str, Operand, tuple[str, ...]]


def share_equal_steps(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with equal ones merged, so that each number is computed once."""
    names: dict[Operand, Operand] = {}
    known: dict[Key, str] = {}
    steps: list[Step] = []
    for step in straight.steps:
        operands = tuple(names.get(o, o) if isinstance(o, str) else o for o in step.operands)
        key = _name(step, operands)
        if key in known and not {known[key], step.result} & {*straight.held}:
            names[step.result] = known[key]
        else:
            known[key] = step.result
            steps.append(replace(step, operands=operands))
    outputs = tuple(names.get(output, output) for output in straight.outputs)
    return replace(straight, steps=tuple(steps), outputs=outputs)


def _name(step: Step, operands: tuple[Operand, ...]) -> Key:
    # Numbers are written by their bits: 0.0 and -0.0 are equal, but not the same operand.
    texts = tuple(o if isinstance(o, str) else float(o).hex() for o in operands)
    ordered = tuple(sorted(texts)) if step.kind in _COMMUTATIVE else texts
    # Parts of different angles that are both modelled as 1 have different unknown factors.
    return step.kind, step.ulps, step.proved, step.scaled, ordered
