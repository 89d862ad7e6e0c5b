"""Operations of the machine on traced values, and the polynomials made of them."""

from __future__ import annotations

from collections.abc import Sequence

from mechproof.programs.trace import Value


def fma(a: Value, b: Value | float, c: Value | float) -> Value:
    """Return a*b + c with one rounding."""
    return a.apply("fma", a, b, c)


def multiply_add(a: Value, b: Value | float, c: Value | float) -> Value:
    """Return a*b + c, whose product may be rounded, too, where there is no fma."""
    return a.apply("multiply_add", a, b, c)


def maximum(a: Value, b: Value | float) -> Value:
    """Return the larger number, NaN if one is."""
    return a.apply("maximum", a, b)


def rint(a: Value) -> Value:
    """Return the whole number next to a."""
    return a.apply("rint", a)


def floor(a: Value) -> Value:
    """Return the largest whole number that is not above a."""
    return a.apply("floor", a)


def power_of_two(n: Value) -> Value:
    """Return 2**n for a whole number n, where that is a normal number."""
    return n.apply("power_of_two", n)


def root(a: Value) -> Value:
    """Return the square root of a."""
    return a.apply("sqrt", a)


def choose(condition: Value, a: Value | float, b: Value | float) -> Value:
    """Return a where the condition holds, b elsewhere."""
    return condition.apply("choose", condition, a, b)


def copysign(a: Value | float, b: Value) -> Value:
    """Return |a| with the sign of b."""
    return b.apply("copysign", a, b)


# So many terms of a polynomial may wait for each other.
CHAIN = 7


def polynomial(z: Value, coefficients: Sequence[float]) -> Value | float:
    """Return the polynomial in z, coefficients lowest power first, by Horner's rule.

    A long one is put into pairs, which do not wait for each other, in powers of z**2: half the
    steps for one product, where halving on (Estrin 1960) takes a product for each power.
    """
    terms: list[Value | float] = list(coefficients)
    if len(terms) > CHAIN:
        pairs = zip(terms[::2], terms[1::2], strict=False)
        joined: list[Value | float] = [multiply_add(z, high, low) for low, high in pairs]
        terms, z = joined + terms[len(terms) - len(terms) % 2 :], z * z
    *others, value = terms
    for term in reversed(others):
        value = multiply_add(z, value, term)
    return value
