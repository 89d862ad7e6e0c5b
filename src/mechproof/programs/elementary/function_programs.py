"""The elementary functions: how each is computed in plain arithmetic, for a float format.

Arguments are reduced by the words of Cody and Waite (1980), each subtracted by an fma; beyond
`largest`, where the method of Payne and Hanek (1983) would be needed, a backend calls its own
library. The rest is a polynomial or a quotient of two (`fits`). There are no tables of values like
Tang's (1989), and no branches up to `largest`, so that a loop over points is vectorised. See
Muller, Elementary Functions (2016).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from inspect import signature

import mpmath as mp

from mechproof.programs.elementary import fits
from mechproof.programs.elementary.fits import Rational, Target, fit
from mechproof.programs.elementary.formats import DIGITS, Format
from mechproof.programs.program import Program
from mechproof.programs.trace import (
    Value,
    choose,
    copysign,
    floor,
    fma,
    maximum,
    multiply_add,
    polynomial,
    power_of_two,
    rint,
    root,
    trace,
)

Body = Callable[..., Value]
Fitted = tuple[Target, Rational]
# Rounding of a term in a sum that keeps its rests, in eps: six of its factors, and its own.
ROUNDED = 4


@dataclass(frozen=True)
class Function:
    """A function as a program. `fits` are the approximations in it.

    In `program` every product with a sum is fused; `parted` marks those that need not be. Where the
    absolute value of the first argument exceeds the format's `largest`, `program` is wrong, and
    `far`, if there is one, uses functions of a backend's own library.
    """

    meaning: str
    program: Program
    parted: Program
    fits: tuple[Fitted, ...]
    far: Program | None


# The functions computed in plain arithmetic, by name: their body, their inputs, and the body by
# library functions for use beyond the largest angle.
BODIES: dict[str, tuple[Body, tuple[str, ...], Body | None]] = {}


def _body(far: Body | None = None) -> Callable[[Body], Body]:
    def register(function: Body) -> Body:
        _, *inputs = signature(function).parameters
        BODIES[function.__name__] = function, tuple(inputs), far
        return function

    return register


def _far_quotient(y: Value, c: Value, a: Value, r: Value, b: Value) -> Value:
    t = y.apply("tan", y)
    return c * t / (a + (r + b * t * t))


def _far(kind: str) -> Body:
    return lambda y: y.apply(kind, y)


class _Maker:
    """Builds the functions of one format."""

    def __init__(self, form: Format) -> None:
        self.form = form
        self.fits: list[Fitted] = []

    def fit(self, target: Target, above: int, below: int = 0) -> Rational:
        """Return the fit of a target, which is also recorded."""
        fitted = fit(target, above, below, self.form)
        self.fits.append((target, fitted))
        return fitted

    def reduce(self, y: Value) -> tuple[Value, Value]:
        """Return the nearest number n of quarter turns, and y less these, to an ulp of itself.

        The first fma is exact: product and angle are multiples of one unit, and their difference is
        small. The second rounds once; what three words of pi/2 omit is less than an ulp of the
        smallest distance of a number up to `largest` from a multiple of pi/2.
        """
        with mp.workdps(DIGITS):
            quarter = self.form.split(mp.pi / 2, 3)
            per_quarter = self.form.round(2 / mp.pi)
        n = rint(y * per_quarter)
        r = y
        for word in quarter:
            r = fma(n, -word, r)
        return n, r

    def tangent_parts(self, y: Value) -> tuple[Value, Value]:
        """Return two values whose quotient is tan(y)."""
        n, r = self.reduce(y)
        fitted = self.fit(fits.TANGENT, *self.form.tangent)
        z = r * r
        first, *others = fitted.above
        lead = r if first == 1.0 else first * r
        above, below = multiply_add(r * z, polynomial(z, others), lead), polynomial(z, fitted.below)
        half = n * 0.5
        is_even = rint(half) == half
        return choose(is_even, above, -below), choose(is_even, below, above)

    @_body(_far("tan"))
    def tan(self, y: Value) -> Value:
        """Return tan(y)."""
        above, below = self.tangent_parts(y)
        return above / below

    @_body(_far_quotient)
    def tangent_quotient(self, y: Value, c: Value, a: Value, r: Value, b: Value) -> Value:
        """Return c*t/(a + r + b*t**2), t = tan(y), r being the rest of a."""
        above, below = self.tangent_parts(y)
        # c/(a + r) in two words, which a loop computes once: the denominator has a product less.
        high = c / a
        low = (fma(-high, a, c) - high * r) / a
        rise = multiply_add(high, above, low * above) * below
        return rise / multiply_add(below, below, b / a * above * above)

    @_body(_far("tan"))
    def tangent_above(self, y: Value) -> Value:
        """Return tan(y) times what `tangent_below` returns."""
        return self.tangent_parts(y)[0]

    @_body(lambda y: y.apply("copy", 1.0))
    def tangent_below(self, y: Value) -> Value:
        """Return what tan(y) is to be multiplied by: it vanishes where cos(y) does."""
        return self.tangent_parts(y)[1]

    def waves(self, y: Value) -> tuple[Value, ...]:
        """Return quarter turns, half of them, if these are even; sine and cosine of the rest."""
        n, r = self.reduce(y)
        odd = self.fit(fits.SINE, self.form.sine)
        even = self.fit(fits.COSINE, self.form.cosine)
        z = r * r
        sine = multiply_add(r * z, polynomial(z, odd.above), r)
        bend = z * 0.5
        # Adds back what the rounding of 1 - z/2 took away, as FreeBSD's library does.
        near = 1.0 - bend
        cosine = near + multiply_add(z * z, polynomial(z, even.above), (1.0 - near) - bend)
        half = n * 0.5
        return n, half, rint(half) == half, sine, cosine

    @_body(_far("sin"))
    def sin(self, y: Value) -> Value:
        """Return sin(y)."""
        _, half, is_even, sine, cosine = self.waves(y)
        return _turn(choose(is_even, sine, cosine), floor(half))

    @_body(_far("cos"))
    def cos(self, y: Value) -> Value:
        """Return cos(y)."""
        n, _, is_even, sine, cosine = self.waves(y)
        return _turn(choose(is_even, cosine, sine), floor((n + 1.0) * 0.5))

    @_body()
    def arctan(self, y: Value) -> Value:
        """Return atan(y)."""
        size = abs(y)
        is_large = size > 1.0
        arc = self.arc(choose(is_large, 1.0 / size, size))
        high, low = self.split_turn(0.5)
        return copysign(choose(is_large, high - (arc - low), arc), y)

    @_body()
    def arctan_quotient(self, a: Value, b: Value) -> Value:
        """Return atan(a/b)."""
        rise, run = abs(a), abs(b)
        is_large = rise > run
        below = choose(is_large, rise, run)
        arc = self.arc(choose(is_large, run, rise) / below)
        high, low = self.split_turn(0.5)
        size = choose(is_large, high - (arc - low), arc)
        return copysign(1.0, b) * copysign(size, a)

    @_body()
    def arctan2(self, a: Value, b: Value) -> Value:
        """Return atan2(a, b)."""
        rise, run = abs(a), abs(b)
        is_steep = rise > run
        below = choose(is_steep, rise, run)
        arc = self.arc(choose(is_steep, run, rise) / choose(below == 0.0, 1.0, below))
        is_left = copysign(1.0, b) < 0.0
        (half, half_low), (whole, whole_low) = map(self.split_turn, (0.5, 1))
        high = choose(is_steep, half, choose(is_left, whole, 0.0))
        low = choose(is_steep, half_low, choose(is_left, whole_low, 0.0))
        turned = choose(is_steep, choose(is_left, arc, -arc), choose(is_left, -arc, arc))
        return copysign(high + (low + turned), a)

    def arc(self, w: Value) -> Value:
        """Return atan(w) for 0 <= w <= 1."""
        return self.near_itself(w, fits.ARCTANGENT, self.form.arctangent)

    def near_itself(self, y: Value, target: Target, degree: int) -> Value:
        """Return the fit of an odd function that is close to its argument where that is small."""
        fitted = self.fit(target, degree)
        z = y * y
        return multiply_add(y * z, polynomial(z, fitted.above), y)

    @_body()
    def small_arctan(self, y: Value) -> Value:
        """Return atan(y) for |y| <= 1/sqrt(3)."""
        return self.near_itself(y, fits.SMALL_ARCTANGENT, self.form.small_arctangent)

    @_body()
    def small_tangent(self, y: Value) -> Value:
        """Return tan(y) for y the half of a low word."""
        return choose(y < -1.0, -1.0, choose(y > 1.0, 1.0, y))

    def split_turn(self, part: float) -> tuple[float, ...]:
        """Return a part of pi as two numbers of the format."""
        with mp.workdps(DIGITS):
            return self.form.split(mp.pi * part, 2)

    @_body()
    def exp(self, y: Value) -> Value:
        """Return exp(y).

        The first fma is exact, as for angles. The power of two is a product of two, of which the
        second alone rounds: where the result is subnormal.
        """
        with mp.workdps(DIGITS):
            words = self.form.split(mp.log(2), 2)
            per_word = self.form.round(1 / mp.log(2))
            top = float(mp.ceil(self.form.exponent * mp.log(2)))
            bottom = float(mp.floor((2 - self.form.exponent - self.form.bits) * mp.log(2)))
        inside = choose(y > top, top, choose(y < bottom, bottom, y))
        n = rint(inside * per_word)
        r = inside
        for word in words:
            r = fma(n, -word, r)
        odd = self.fit(fits.ODD_EXPONENTIAL, self.form.exponential)
        even = self.fit(fits.EVEN_EXPONENTIAL, self.form.exponential)
        z = r * r
        bent = multiply_add(r, polynomial(z, odd.above), polynomial(z, even.above))
        half = floor(n * 0.5)
        return (1.0 + multiply_add(z, bent, r)) * power_of_two(half) * power_of_two(n - half)

    @_body()
    def normal_tail(self, y: Value) -> Value:
        """Return the mass of the standard normal law beyond |y|.

        The square of |y| is taken with the rest of its rounding: the tail is as exact far out.
        """
        size = abs(y)
        x = choose(size > fits.TAIL_END, fits.TAIL_END, size)
        fitted = self.fit(fits.NORMAL_TAIL, self.form.tail)
        scaled = polynomial((x - fits.TAIL) / (x + fits.TAIL), fitted.above) / (1.0 + x)
        square = x * x
        return self.exp(square * -0.5) * multiply_add(fma(x, x, -square) * -0.5, scaled, scaled)

    @_body()
    def hypot(self, a: Value, b: Value) -> Value:
        """Return sqrt(a**2 + b**2), scaled where squares would leave the range."""
        one, other = abs(a), abs(b)
        size = choose(one > other, one, other)
        large, small = 2.0**self.form.squares, 2.0**-self.form.squares
        factor = choose(
            size > large,
            2.0**-self.form.scale,
            choose(size < small, 2.0**self.form.scale, 1.0),
        )
        x, y = one * factor, other * factor
        return root(multiply_add(x, x, y * y)) / factor

    @_body()
    def sign(self, y: Value) -> Value:
        """Return 1 for y > 0, -1 for y < 0, else y."""
        return choose(y > 0.0, 1.0, choose(y < 0.0, -1.0, y))

    @_body()
    def minimum(self, a: Value, b: Value) -> Value:
        """Return the smaller number, NaN if one is."""
        return -maximum(-a, -b)

    @_body()
    def mod(self, a: Value, b: Value) -> Value:
        """Return a less a whole multiple of b, between 0 and b."""
        rest = a.apply("fmod", a, b)
        return choose(rest * copysign(1.0, b) < 0.0, rest + b, rest)

    @_body(lambda y: y.apply("sin", y) / y)
    def sinc(self, y: Value) -> Value:
        """Return sin(y)/y, 1 at 0."""
        return choose(y == 0.0, 1.0, self.sin(y) / y)

    @_body()
    def product_rest(self, a: Value, b: Value, p: Value) -> Value:
        """Return a*b - p."""
        return fma(a, b, -p)

    @_body()
    def quotient_rest(self, a: Value, b: Value, q: Value) -> Value:
        """Return a/b - q."""
        return fma(-q, b, a) / b

    @_body()
    def sum_rest(self, a: Value, b: Value, s: Value) -> Value:
        """Return a + b - s."""
        # Dekker's sum (1971), exact where |b| <= |a|.
        return b - (s - a)

    @_body()
    def total_rest(self, a: Value, b: Value, s: Value) -> Value:
        """Return a + b - s, whichever of both is larger."""
        # Knuth's sum (1969), exact in either order.
        part = s - a
        return (a - (s - part)) + (b - part)

    @_body()
    def nonnegative(self, total: Value, size: Value) -> Value:
        """Return a sum, 0 where it is negative by no more than terms of that size are rounded."""
        rounding = ROUNDED * self.form.eps * size
        beyond = maximum(-total - rounding, 0.0)
        return maximum(total, 0.0 - beyond)


def _turn(value: Value, half_turns: Value) -> Value:
    """Return a value, negated for an odd number of half turns."""
    half = half_turns * 0.5
    return choose(floor(half) == half, value, -value)


@cache
def build(kind: str, form: Format) -> Function:
    """Return the function of a kind of operation in a format.

    Raises `KeyError` for a kind without a body, such as an operation of the machine.
    """
    body, inputs, far = BODIES[kind]
    maker = _Maker(form)
    program = trace(lambda *values: body(maker, *values), inputs)
    far_program = trace(far, inputs) if far else None
    return Function(str(body.__doc__), _fuse(program), program, tuple(maker.fits), far_program)


def _fuse(program: Program) -> Program:
    """Return the program with an fma for every `multiply_add`."""
    operations = (
        replace(step, kind="fma") if step.kind == "multiply_add" else step
        for step in program.operations
    )
    return replace(program, operations=tuple(operations))
