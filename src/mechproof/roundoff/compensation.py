"""Compensation: finds the roundings that move no output because a low word compensates them.

With every other operation exact, the outputs do not depend on the rounding of a product whose rest
is added back, nor on that of a quotient that both a product and a rest contain. Derivatives,
rational in the values of the functions, prove this here; the other roundings are then bounded at
whatever values these take. Error-free transformations (Ogita, Rump and Oishi 2005) are applied by
hand; here it is checked that they compensate.

Multiplying by a power of two is exact: 2*a*b and 2*(a*b) are the same double in the normal range.
With such factors moved after products and quotients, the rounded result is the product of a and b,
and its rest is recognised as its own.

Both parts of a tangent are scaled by one unknown factor, which no output may have. Degrees are
inferred as the dimensions of physical quantities are (Kennedy 1996): a result without one is the
same whatever the factor.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache

import sympy as sp

from mechproof.arithmetic.polynomials import cancel
from mechproof.programs.degrees import DEGREES, NONE, Degree
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.program import CONSTANTS, Operand
from mechproof.roundoff.steps import (
    CONSTANT,
    EXACT,
    PRODUCT_REST,
    QUOTIENT_REST,
    RESTS,
    SUM_REST,
    Step,
    StraightLineProgram,
)

Pair = tuple[sp.Expr, sp.Expr]


def find_compensated(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with compensated products held; ValueError if a rest compensates nothing."""
    straight = take_powers_last(straight)
    products = _list_rounded(straight, PRODUCT_REST)
    for name in (*products, *_list_rounded(straight, QUOTIENT_REST)):
        for output in straight.outputs:
            if not _is_still(straight, name, products, output):
                raise ValueError(
                    f"an output depends on the rounding of {name} in spite of its rest"
                )
    _check_factors(straight, products)
    return replace(straight, held=products)


def _check_factors(straight: StraightLineProgram, products: Sequence[str]) -> None:
    """Raise ValueError for a compensated product with a rounded factor whose rest is not added.

    A held product passes no rounding of its factors on, nor does a rest pass on one of its
    operands.
    """
    made = {step.result: step for step in straight.steps}
    rests = {step.operands[2]: step for step in straight.steps if step.kind in (*RESTS, SUM_REST)}
    factors = {frozenset(s.operands) for s in straight.steps if s.kind == "multiply"}
    for name in products:
        one, other = made[name].operands[0], made[name].operands[-1]
        for factor, partner in ((one, other), (other, one)):
            for rounded in _list_roundings(factor, made):
                rest = rests.get(rounded)
                given = rest.operands[:2] if rest and rounded == factor else (rounded,)
                is_added = rest and (
                    rest.kind != SUM_REST or frozenset((rest.result, partner)) in factors
                )
                if not is_added or any(_list_roundings(o, made) for o in given):
                    raise ValueError(f"{name}: the rounding of its factor {factor} has no rest")


def _list_roundings(operand: Operand, made: Mapping[str, Step]) -> list[str]:
    """List the rounded results that an operand is computed from by exact steps, itself included."""
    step = made.get(str(operand))
    if step is None:
        return []
    if step.ulps:
        return [step.result]
    return [rounded for used in step.operands for rounded in _list_roundings(used, made)]


def _list_rounded(straight: StraightLineProgram, rest: str) -> tuple[str, ...]:
    """List the results whose rests are of one kind, in the order of the rests."""
    found = (str(step.operands[2]) for step in straight.steps if step.kind == rest)
    return tuple(dict.fromkeys(found))


def _is_still(
    straight: StraightLineProgram, name: str, products: Sequence[str], output: Operand
) -> bool:
    """Return whether an output is independent of how a product or a quotient is rounded."""
    symbols = (*straight.inputs, *CONSTANTS)
    values: dict[Operand, Pair] = {n: (sp.Symbol(n), sp.S.Zero) for n in symbols}
    moved = (sp.Symbol(f"rounded {name}"), sp.S.One)
    for step in straight.steps:
        sees = step.kind in RESTS or step.result in products
        given = [
            moved
            if operand == name and sees
            else values[operand]
            if isinstance(operand, str)
            else (sp.nsimplify(operand, rational=True), sp.S.Zero)
            for operand in step.operands
        ]
        if step.result in products:
            # Other products stand for their rounded values; each is checked in its own turn.
            values[step.result] = (sp.Symbol(f"rounded {step.result}"), sp.S.Zero)
        else:
            values[step.result] = _differentiate(step, given)
        if step.result == name and name in products:
            values[name] = moved
    return bool(cancel(values[output][1])[0] == 0)


def _differentiate(step: Step, given: list[Pair]) -> Pair:
    """Return a step's value and derivative; non-rational values become symbols."""
    meaning, arguments, slopes = _find_slopes(step.kind, len(given))
    places = dict(zip(arguments, (value for value, _ in given), strict=True))
    moving = zip(slopes, (slope for _, slope in given), strict=True)
    total = sp.Add(*(part * slope for part, slope in moving if slope != 0))
    value = meaning
    if not meaning.is_rational_function():
        value = sp.Symbol(f"value {step.result}")
        total = total.xreplace({meaning: value})
    return value.xreplace(places), total.xreplace(places)


@cache
def _find_slopes(
    kind: str, count: int
) -> tuple[sp.Expr, tuple[sp.Dummy, ...], tuple[sp.Expr, ...]]:
    """Return an operation's meaning in letters, these letters, and its derivatives by them."""
    letters = tuple(sp.Dummy() for _ in range(count))
    meaning = letters[0] if kind == CONSTANT else SYMBOLIC[kind](*letters)
    return meaning, letters, tuple(meaning.diff(letter) for letter in letters)


# Kinds that pass powers of two on from their operands; sums do not.
_PRODUCTS = ("multiply", "divide", "square", *RESTS)


def take_powers_last(straight: StraightLineProgram) -> StraightLineProgram:
    """Return steps whose rests refer to rounded results, not to powers of two times these."""
    made = {step.result: step for step in straight.steps}
    rests = [made.get(str(step.operands[2])) for step in straight.steps if step.kind in RESTS]
    if not any(product and _find_factor(product) for product in rests):
        return straight
    return _Mover(straight).move()


def _find_factor(step: Step) -> tuple[Operand, int] | None:
    """Return operand and exponent of a step that multiplies by a power of two; None for others."""
    if step.ulps != EXACT or step.kind not in ("multiply", "divide"):
        return None
    first, second = step.operands
    if step.kind == "multiply" and not isinstance(first, str):
        first, second = second, first
    if not isinstance(first, str) or isinstance(second, str) or second < 0:
        return None
    exponent = math.frexp(second)[1] - 1
    return first, exponent if step.kind == "multiply" else -exponent


def _find_exponent(kind: str, exponents: Sequence[int]) -> int | None:
    """Return a result's exponent of two from those of its operands; None if it has none."""
    if kind not in _PRODUCTS:
        return None
    given = (Degree({2: exponent} if exponent else {}) for exponent in exponents)
    try:
        found: Degree = DEGREES[kind](*given)
    except ValueError:
        return None
    return found.powers.get(2, 0)


class _Mover:
    def __init__(self, straight: StraightLineProgram) -> None:
        self._straight = straight
        self._steps: list[Step] = []
        # For results that are another one times a power of two: that one and the exponent.
        self._known: dict[Operand, tuple[Operand, int]] = {}
        self._written: dict[tuple[Operand, int], str] = {}

    def move(self) -> StraightLineProgram:
        for step in self._straight.steps:
            if factor := _find_factor(step):
                base, exponent = self._find(factor[0])
                self._known[step.result] = base, exponent + factor[1]
            else:
                self._take(step)
        outputs = tuple(map(self._write, self._straight.outputs))
        return replace(self._straight, steps=tuple(self._steps), outputs=outputs)

    def _find(self, operand: Operand) -> tuple[Operand, int]:
        return self._known.get(operand, (operand, 0))

    def _take(self, step: Step) -> None:
        found = [self._find(operand) for operand in step.operands]
        exponents = [exponent for _, exponent in found]
        exponent = _find_exponent(step.kind, exponents)
        if exponent is None or not any(exponents):
            self._append(step, [*map(self._write, step.operands)])
            return
        name = f"{step.result} / 2**{exponent}"
        self._append(replace(step, result=name), [base for base, _ in found])
        self._known[step.result] = name, exponent

    def _append(self, step: Step, operands: Sequence[Operand]) -> None:
        self._steps.append(replace(step, operands=tuple(operands)))

    def _write(self, operand: Operand) -> Operand:
        """Return an operand that holds the value, adding a step for its power of two if needed."""
        base, exponent = self._find(operand)
        if not exponent:
            return base
        if (base, exponent) not in self._written:
            name = self._written[base, exponent] = f"{base} * 2**{exponent}"
            self._steps.append(Step(name, "multiply", (2.0**exponent, base), EXACT))
        return self._written[base, exponent]


def find_scaled(straight: StraightLineProgram) -> StraightLineProgram:
    """Return the steps with their scaled results listed; ValueError if an output is scaled."""
    known: dict[Operand, Degree] = {}
    for step in straight.steps:
        given = [known.get(operand, NONE) for operand in step.operands]
        if step.scaled:
            known[step.result] = Degree({step.scaled: 1})
        elif any(degree.powers for degree in given):
            try:
                known[step.result] = DEGREES[step.kind](*given)
            except (KeyError, ValueError) as error:
                raise ValueError(f"{step.result}: {step.kind} of a scaled value") from error
    scaled = tuple(str(result) for result, degree in known.items() if degree.powers)
    if any(output in scaled for output in straight.outputs):
        raise ValueError("an output is scaled")
    return replace(straight, scaled=scaled)
