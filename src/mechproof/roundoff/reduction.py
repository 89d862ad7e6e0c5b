"""Reduction: what a program decides, and angles that it takes off by whole numbers of turns.

A whole number is known but for the number of turns. Where boxes leave two of them, or both
outcomes of a comparison, each is bounded on its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from math import floor
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
from flint import arb

from mechproof.codegen.elementary.formats import DOUBLE
from mechproof.codegen.program import Operand
from mechproof.proof.balls import working_precision
from mechproof.roundoff.angles import Whole
from mechproof.roundoff.ends import limit_by_spacing, round_at_ends, widen_by_ulps
from mechproof.roundoff.germs import Germ, Open
from mechproof.roundoff.intervals import PI, Ends, Interval, Mask, exactly
from mechproof.roundoff.steps import Step, Straight

if TYPE_CHECKING:
    from mechproof.roundoff.bound import Evaluation

UNIT = 2.0**-53
EPS = 2.0**-52
# Whole numbers besides those of the turns.
COUNTS = range(-8, 9)
COMPARED: Mapping[str, Callable[[Interval, Interval], tuple[Mask, Mask]]] = MappingProxyType(
    {
        "greater": lambda a, b: (~(a.high <= b.low), ~(a.low > b.high)),
        "less": lambda a, b: (~(a.low >= b.high), ~(a.high < b.low)),
    }
)
# What a decision leaves: half of the margin of the approximations beyond the ends.
CLIPPED = 2.0**-21
# The errors of what is decided upon may be this much, a share of that.
HARDLY = 2.0**-24
BITS = 300
# Later words of pi/2 and what all leave are no more than this share of what is reduced.
SMALL = 2.0**-20


@dataclass(frozen=True)
class Chain:
    """An angle less a whole number times words of a quarter turn."""

    base: str
    number: Whole
    words: tuple[float, ...]


class Reducer:
    """Takes the steps of an evaluation that are no matter of derivatives."""

    def __init__(self, evaluation: Evaluation, straight: Straight) -> None:
        self._of = evaluation
        self.facts: dict[str, Whole | bool] = {}
        self._chains: dict[str, Chain] = {}
        self._per: dict[str, float] = {}
        self._rounded: dict[tuple[Operand, ...], str] = {}
        uses = Counter(o for s in straight.steps for o in s.operands if isinstance(o, str))
        fused = {s.operands[2] for s in straight.steps if s.kind == "fma"}
        self._inner = {name for name in fused if isinstance(name, str) and uses[name] == 1}

    def take(self, step: Step) -> bool:
        """Take a step; False if it is one of arithmetic."""
        first = step.operands[0]
        fact = self.facts.get(first) if isinstance(first, str) else None
        if step.kind == "choose":
            self._choose(step)
        elif step.kind == "rint" and fact is None:
            self._round_angle(step, str(first))
        elif step.kind in COMPARED:
            self._compare(step)
        elif step.kind == "within":
            self._limit(step)
        elif isinstance(fact, Whole):
            self._go_on(step, fact)
        else:
            return False
        return True

    def _choose(self, step: Step) -> None:
        condition, *both = step.operands
        taken = both[0] if self.facts[str(condition)] else both[1]
        of = self._of
        of.add(
            replace(step, operands=(taken,)),
            of.value(taken),
            (of.one,),
            0.0,
            None,
            of.computed_value(taken),
        )

    def _go_on(self, step: Step, whole: Whole) -> None:
        other = step.operands[1] if len(step.operands) > 1 else 0.0
        if step.kind == "fma" and not isinstance(other, str):
            self._take_off(step, whole, float(other))
        elif step.kind == "multiply" and not isinstance(other, str):
            self.facts[step.result] = whole.times(other)
        elif step.kind == "add" and not isinstance(other, str):
            self.facts[step.result] = replace(whole, count=whole.count + Fraction(other))
        elif step.kind == "rint":
            self.facts[step.result] = whole.rounded(round)
        elif step.kind == "floor":
            self.facts[step.result] = whole.rounded(floor)
        elif step.kind == "equal" and isinstance(known := self.facts.get(str(other)), Whole):
            self.facts[step.result] = known == whole
        else:
            raise ValueError(f"{step}: no rule for this with a whole number")

    def _round_angle(self, step: Step, name: str) -> None:
        """Round a multiple of an angle to a whole number: in all boxes the same."""
        of, germ = self._of, self._of.values[name]
        made = next(m.step for m in of.moving if m.step.result == name)
        if made.operands in self._rounded:
            # The same number of the same angle, in another function of it.
            known = self._rounded[made.operands]
            self.facts[step.result], self._per[step.result] = self.facts[known], self._per[known]
            return
        self._rounded[made.operands] = step.result
        each, rest = Fraction(0), germ.expanded()
        if of.turn and of.turn.holds(germ):
            per = germ.span * PI * exactly(2.0)
            each = Fraction(round(float(np.mean(per.low))))
            rest = germ.span * of.turn.residue + (per - exactly(float(each))) * of.turn.count
        low, high = np.ceil(rest.low - 0.5), np.floor(rest.high + 0.5)
        few = high - low <= 1
        masks = [few & (low <= n) & (n <= high) for n in COUNTS]
        choice = of.frame.choose(*masks, ~np.logical_or.reduce(masks))
        if choice == len(COUNTS):
            raise Open
        self.facts[step.result] = Whole(each, Fraction(COUNTS[choice]))
        self._per[step.result] = float(made.operands[1]) if made.kind == "multiply" else np.nan

    def _take_off(self, step: Step, whole: Whole, word: float) -> None:
        """Take a whole number times a word of a quarter turn off an angle."""
        number, rest = str(step.operands[0]), str(step.operands[2])
        before = self._chains.get(rest, Chain(rest, whole, ()))
        chain = Chain(before.base, whole, (*before.words, word))
        self._chains[step.result] = chain
        of = self._of
        if step.result in self._inner:
            return
        made, angle = replace(step, operands=(chain.base,)), of.values[chain.base]
        whole_span = self._reduce(angle, chain)
        span = self._clip(whole_span, chain, self._per[number])
        if not whole.each and not whole.count:
            near = whole_span.largest() <= 0.5 / self._per[number]
            small = angle if of.frame.choose(near, ~near) == 0 else of.frame.constant(span)
            of.add(made, small, (of.one,), 0.0, None, small.expanded())
            return
        relative, absolute = _bound_reduction(angle, chain, span, of)
        germ = of.frame.add_variable(span)
        of.add(made, germ, (of.one,), relative, absolute, widen_by_ulps(span, 1.0))

    def _reduce(self, angle: Germ, chain: Chain) -> Interval:
        turn, whole = self._of.turn, chain.number
        count = exactly(float(whole.count))
        words = exactly(chain.words[0]) + exactly(sum(chain.words[1:]))
        if turn is None or not turn.holds(angle):
            return angle.expanded() + words * count
        per = angle.span * PI * exactly(2.0) + words * exactly(float(whole.each))
        return angle.span * turn.residue + per * turn.count + words * count

    def _clip(self, span: Interval, chain: Chain, per: float) -> Interval:
        """Leave of a rest what rounding to the nearest number leaves."""
        of, size = self._of, self._of.values[chain.base].expanded().largest()
        off = of.sum_errors(chain.base) * EPS * size
        known = (off <= HARDLY) & (size <= DOUBLE.largest)
        most = np.where(known, 0.5 / per * (1 + CLIPPED), np.inf)
        return span.within(-most, most)

    def _limit(self, step: Step) -> None:
        """Take what is known to be within a limit."""
        of, (name, limit) = self._of, step.operands
        germ = of.value(name)
        inside = germ.expanded().largest() <= limit
        if of.frame.choose(inside, ~inside):
            sure = of.sum_errors(name, of.in_units) * EPS <= HARDLY
            most = np.where(sure, float(limit), np.inf)
            germ = of.frame.constant(germ.expanded().within(-most, most))
        of.add(step, germ, (of.one,), 0.0, None, germ.expanded())

    def _compare(self, step: Step) -> None:
        """Decide a comparison with a number; where both are open, what is compared is clipped."""
        of, (name, bound) = self._of, step.operands
        if isinstance(bound, str) or not isinstance(name, str):
            raise ValueError(f"{step}: only comparisons with numbers have a rule")
        known = of.computed[name].is_finite
        masks = [m & known for m in COMPARED[step.kind](of.computed[name], exactly(bound))]
        is_open = masks[0] & masks[1]
        choice = of.frame.choose(*masks, ~known)
        if choice == len(masks):
            raise Open
        held = self.facts[step.result] = choice == 0
        if of.frame.choose(~is_open, is_open) == 0:
            return
        off = of.sum_errors(name) * EPS
        ends = bound - CLIPPED * abs(bound), bound + CLIPPED * abs(bound)
        sure = off <= HARDLY
        low = np.where(sure & (held == (step.kind == "greater")), ends[0], -np.inf)
        high = np.where(sure & (held == (step.kind == "less")), ends[1], np.inf)
        span = of.values[name].expanded().within(low, high)
        of.values[name] = of.frame.constant(span)
        of.computed[name] = of.computed[name].within(low, high)


def _bound_reduction(
    angle: Germ, chain: Chain, span: Interval, of: Evaluation
) -> tuple[Ends, Ends]:
    """Bound the error of a reduced angle, of itself and absolute.

    The first product and difference are exact: multiples of one unit, the difference small. Each
    later word is rounded once, where what is left is the reduced angle but for a small share.
    """
    whole, size = chain.number.expanded(of.turn).largest(), angle.expanded()
    nearest = np.maximum(size.low, -size.high)
    _, exponent = np.frexp(np.where(nearest > 0, nearest, np.nan))
    unit = np.minimum(np.ldexp(1.0, exponent - 53), _lowest_bit(chain.words[0]))
    known = (nearest > 0) & (span.largest() * (1 + SMALL) <= unit * 2.0**53)
    left, least = _bound_rest(chain.words), _find_nearest(DOUBLE.largest)
    later = max([*map(abs, chain.words[2:]), 0.0]) * len(chain.words)
    known &= (size.largest() <= DOUBLE.largest) & (whole * (later + left) <= SMALL * least)
    rounded = limit_by_spacing(round_at_ends("", (), span), 0.5)
    roundings = [np.minimum(rounded, whole * abs(word)) for word in chain.words[1:]]
    absolute = (sum(roundings, np.float64(0.0)) + whole * left) * (1 + SMALL)
    relative = (len(roundings) * UNIT + whole * left / least) * (1 + SMALL)
    return np.where(known, relative, np.nan), np.where(known, absolute, np.nan)


def _lowest_bit(number: float) -> float:
    return 1.0 / Fraction(number).denominator


@cache
def _bound_rest(words: tuple[float, ...]) -> float:
    """Bound what the words leave of a quarter turn."""
    with working_precision(BITS):
        return float(abs(arb.pi() / 2 + sum(map(arb, words), arb(0))).upper())


@cache
def _find_nearest(largest: float) -> float:
    """Bound from below how near doubles up to the largest come to multiples of a quarter turn.

    In a binade doubles are multiples of a unit, and the multiples of pi/2 that are nearest to
    those of it are those by the denominators of a continued fraction.
    """
    with working_precision(BITS):
        mantissa, exponent = (arb.pi() / 2).mid().man_exp()
    quarter = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    nearest = Fraction(1)
    end = Fraction(1)
    while end <= largest:
        unit = end / 2**53
        for number in _list_denominators(quarter / unit, end / quarter + 1):
            over = number * quarter / unit
            nearest = min(nearest, abs(over - round(over)) * unit)
        end *= 2
    # Half of it, for what 300 bits leave of pi.
    return float(nearest / 2)


def _list_denominators(number: Fraction, most: Fraction) -> Iterator[int]:
    """List the denominators of the convergents of a number."""
    before, last = 0, 1
    while last <= most:
        yield last
        number = number - floor(number)
        if not number:
            return
        number = 1 / number
        before, last = last, floor(number) * last + before
