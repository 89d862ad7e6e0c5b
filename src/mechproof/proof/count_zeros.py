"""Zeros of divisors, where a side has no value, or has one only since SymPy cancelled u/u.

Other searches try few whole numbers as counts, seldom 17, say, so zeros are solved for here. A
factorial has no value where its reciprocal is zero. Zeros of a divisor at single points of a line
are not reported: a quotient is meant where it has values.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from functools import lru_cache
from itertools import chain, islice, product

import sympy as sp
from sympy.concrete.expr_with_limits import ExprWithLimits

from mechproof.arithmetic import balls
from mechproof.proof.cases import narrow
from mechproof.proof.counts import has_steps, is_count
from mechproof.proof.refutation import name_point, points_for, put_exactly
from mechproof.proof.signs import is_nonzero
from mechproof.proof.value_points import IsWanted, are_unlike, find_wanted_at
from mechproof.record import RecordError, Slack, list_divisors
from mechproof.record.parts import find_free, find_parts, has_parts
from mechproof.statement_domains.domain import Domain, Point

# Number of points at which one letter is solved for, the others having their values there.
_SOLVED = 3
# On the way to where a number is least, steps are 1 to 2**-15, each taken three times.
_MOST_TURNS = 48
# Work limit: negative integers that are tried as the argument of a factorial.
_MOST_STEPS = 12
# Work limit: whole numbers among which one is looked for that makes an angle a whole half turn.
_LARGEST_PERIOD = 5000
# Points that are tried; if a divisor is zero at this many, its zeros are more than single points.
_TRIED = 8
_MANY = 2
_BITS = (64, 512)


def find_count_without_value(sides: Sequence[sp.Expr], domain: Domain) -> str:
    """Return a point whose counts make a divisor zero and where only one side has a value.

    Returns "" if none is met.
    """
    if not any(is_count(s, domain) for side in sides for s in find_free(side)):
        return ""
    divisors = _list_divisors(sides, domain)
    zeros = (point for divisor in divisors for point in list_zeros(divisor, domain))
    unlike = (find_wanted_at(sides, zero, domain, are_unlike) for zero in zeros)
    return next(filter(None, unlike), "")


def describe_zero_quotients(sides: Sequence[sp.Expr], domain: Domain) -> str:
    """Report where a factorial in a denominator has a negative argument, or return ""."""
    divisors = {d for side in sides for d in list_divisors(side) if find_free(d) <= find_free(side)}
    below = sorted((d for d in divisors if isinstance(d, sp.factorial)), key=sp.default_sort_key)
    met = ((one, zero) for one in below for x in list_ends(one) for zero in list_zeros(x, domain))
    return next((f"1/{one} is zero at {name_point(zero, domain)}" for one, zero in met), "")


def _list_divisors(sides: Sequence[sp.Expr], domain: Domain) -> Iterator[sp.Expr]:
    """Yield expressions with counts that may be zero and then leave a side without a value.

    Those with a letter bound by a sum or an integral are left out: its limits decide there.
    """
    free = {symbol for side in sides for symbol in find_free(side)}
    below = {divisor for side in sides for divisor in list_divisors(side)}
    # A factorial of a negative integer in a denominator is no pole: its reciprocal is zero there.
    above = {f for side in sides for f in find_parts(side, sp.factorial)} - below
    ends = {end for factorial in above for end in list_ends(factorial)}
    for divisor in sorted(below | ends, key=sp.default_sort_key):
        shown = divisor.args[0] - 1 if isinstance(divisor, sp.log) else divisor
        letters = find_free(shown)
        counts = letters <= free and any(is_count(s, domain) for s in letters)
        if counts and not is_nonzero(shown, domain):
            yield shown


def list_ends(factorial: sp.Expr) -> list[sp.Expr]:
    """List the numbers one of which is zero where a factorial's argument first becomes negative.

    The largest coefficient of a count sets how many: (2n)! has steps of 2.
    """
    (number,) = factorial.args
    steps = [abs(c) for c in number.as_coefficients_dict().values() if c.is_Integer]
    return [number + k for k in range(1, 1 + min(max(steps, default=1), _MOST_STEPS))]


def find_failing(
    sides: Sequence[sp.Expr], needs: Iterable[Slack], domain: Domain, is_wanted: IsWanted
) -> str:
    """Return a point where a condition fails and the sides have values as wanted.

    Returns "" if none is met. Points that are tried elsewhere seldom lie on the edge of a
    condition, or between two such edges that are near each other.
    """
    points = list_failing([*needs], domain)
    found = (find_wanted_at(sides, at, domain, is_wanted) for at in points)
    return next(filter(None, found), "")


def list_failing(needs: Sequence[Slack], domain: Domain) -> Iterator[Point]:
    """Yield points at which a condition fails, if any are found, ends of ranges included."""
    points = chain.from_iterable(_list_tried(need, domain) for need in dict.fromkeys(needs))
    return (at for at in points if not _are_met(needs, at))


# Many rows of a paper have values under the same conditions.
@lru_cache(maxsize=64)
def _list_tried(need: Slack, domain: Domain) -> list[Point]:
    """List points on the edge of a condition, beyond it, and where its number is least."""
    points = [*_list_roots(need.value, domain, find_free(need.value))]
    fails = sp.Le(need.value, 0) if need.strict else sp.Lt(need.value, 0)
    part = narrow(domain, fails)
    if part is None or has_parts(need.value, ExprWithLimits):
        return points
    # A relation that is solved for a letter narrows its set; for others the search takes long.
    if part.where == domain.where:
        with suppress(RecordError):
            points += islice(points_for((need.value,), part, _SOLVED), _SOLVED)
    starts = islice(points_for((need.value,), domain, _SOLVED), _SOLVED)
    return [*points, *(_descend(need.value, start, domain) for start in starts)]


def _descend(number: sp.Expr, start: Point, domain: Domain) -> Point:
    """Return where a number is negative or least, by ever shorter steps along single letters.

    This is the pattern search of Hooke and Jeeves (1961) without its longer moves.
    """
    letters = [s for s in start if isinstance(domain.set_of(s), sp.Interval)]
    place, least = start, balls.evaluate(number, start)
    for turn in range(_MOST_TURNS):
        step = sp.Rational(1, 2 ** (turn // 3))
        for letter, way in product(letters, (step, -step)):
            there = {**place, letter: place[letter] + way}
            value = balls.evaluate(number, there)
            if not least < 0 and value < least and domain.allows(there):
                place, least = there, value
    return place


def _are_met(needs: Iterable[Slack], point: Point) -> bool:
    """Return whether all conditions hold exactly at a point; balls cannot decide at a zero."""
    numbers = ((need, need.value.xreplace(dict(point))) for need in needs)
    return all(x.is_positive or (x.is_zero and not need.strict) for need, x in numbers)


def list_zeros(divisor: sp.Expr, domain: Domain) -> Iterator[Point]:
    """Yield a divisor's zeros in each of its counts, at a few values of the other letters."""
    counts = frozenset(s for s in find_free(divisor) if is_count(s, domain))
    yield from _list_roots(divisor, domain, counts)


# Many rows of a paper have values under the same conditions.
@lru_cache(maxsize=64)
def _list_roots(number: sp.Expr, domain: Domain, letters: frozenset[sp.Basic]) -> list[Point]:
    ordered, roots = sorted(letters, key=str), []
    for point in islice(points_for((number,), domain, _SOLVED), _SOLVED):
        # Labels of families and their elements under a sum have no values to be solved for.
        for letter in (letter for letter in ordered if letter in point):
            others = {s: value for s, value in point.items() if s != letter}
            for root in list_solutions(number.xreplace(others), letter):
                there = {**others, letter: root}
                if (root.is_integer or not is_count(letter, domain)) and domain.allows(there):
                    roots.append(there)
    return roots


def list_solutions(number: sp.Expr, letter: sp.Basic) -> Iterator[sp.Expr]:
    """Yield the rational zeros of a polynomial, or whole ones of other numbers."""
    equation = number.as_poly(letter)
    if equation is None:
        proposed = (*_list_turns(number, letter), *_list_exponents(number, letter))
        yield from (whole for whole in proposed if number.subs(letter, whole).is_zero)
    elif not equation.free_symbols_in_domain:
        yield from equation.ground_roots()


def _list_turns(number: sp.Expr, letter: sp.Basic) -> Iterator[sp.Expr]:
    """Yield the first positive whole numbers that make sines and cosines zero."""
    for wave in number.atoms(sp.sin, sp.cos):
        halves = sp.S.Half if isinstance(wave, sp.cos) else sp.S.Zero
        turns = (sp.expand(wave.args[0] / sp.pi) - halves).as_poly(letter)
        if turns is None or turns.degree() != 1 or not all(c.is_Rational for c in turns.coeffs()):
            continue
        slope, start = turns.nth(1), turns.nth(0)
        period = int(sp.ilcm(slope.q, start.q))
        ahead, offset = int(slope * period), int(start * period)
        counts = range(1, min(period, _LARGEST_PERIOD) + 1)
        yield from islice((sp.Integer(n) for n in counts if (ahead * n + offset) % period == 0), 1)


def knows_zeros(number: sp.Expr, letter: sp.Basic) -> bool:
    """Return whether `list_solutions` yields every whole number that makes a number zero."""
    equation = number.as_poly(letter)
    if equation is None:
        return next(_read_powers(number, letter), None) is not None
    return not equation.free_symbols_in_domain


def _list_exponents(number: sp.Expr, letter: sp.Basic) -> Iterator[sp.Expr]:
    """Yield whole numbers that may make a polynomial in a power with them as exponents zero."""
    for power, equation in _read_powers(number, letter):
        slope, start = (power.exp.as_poly(letter).nth(n) for n in (1, 0))
        for root in filter(None, equation.ground_roots()):
            exponent = round(sp.log(abs(root), abs(power.base)).n())
            if (whole := (exponent - start) / slope).is_integer:
                yield whole


def _read_powers(number: sp.Expr, letter: sp.Basic) -> Iterator[tuple[sp.Pow, sp.Poly]]:
    """Yield a power of a rational number with a letter in its exponent, and the equation in it."""
    for power in number.atoms(sp.Pow):
        exponent, named = power.exp.as_poly(letter), sp.Dummy()
        if not power.base.is_Rational or power.base in (-1, 0, 1):
            continue
        if exponent is None or exponent.degree() != 1 or exponent.free_symbols_in_domain:
            continue
        equation = number.xreplace({power: named}).as_poly(named)
        if equation is not None and not equation.free_symbols_in_domain:
            yield power, equation


def describe_division_by_zero(divisors: Sequence[sp.Expr], domain: Domain) -> str:
    """Report which cancelled divisor is zero, at a count or at more than single points.

    Returns "" if there is none.
    """
    for divisor in divisors:
        resolved = domain.resolve(divisor)
        points = list(islice(points_for((resolved,), domain, _TRIED), _TRIED))
        zeros = [point for point in points if _is_zero(resolved, point)]
        factorial = 1 / divisor if isinstance(1 / divisor, sp.factorial) else None
        solved = map(domain.resolve, list_ends(factorial)) if factorial else [resolved]
        zeros += islice((zero for one in solved for zero in list_zeros(one, domain)), 1)
        needed = 1 if has_steps(resolved, domain) else min(_MANY, len(points))
        if len(zeros) >= needed:
            at = name_point(zeros[0], domain)
            told = f"it divides by {divisor}, which is zero"
            told = f"{factorial} has no value" if factorial else told
            return told + (f" at {at}" if at else "")
    return ""


def _is_zero(divisor: sp.Expr, point: Point) -> bool:
    """Return whether a number cannot be distinguished from zero."""
    exact = put_exactly(divisor, point)
    found = (balls.evaluate(exact, point, bits) for bits in _BITS)
    return all(ball.is_finite() and ball.contains(0) for ball in found)
