"""Operations of the machine on traced values, and the polynomials made of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from mechproof.programs.trace import TRACED, Value

Recorded = Callable[..., Value]
# As the rows of operations state them.
fma: Recorded = TRACED["fma"]
multiply_add: Recorded = TRACED["multiply_add"]
maximum: Recorded = TRACED["maximum"]
rint: Recorded = TRACED["rint"]
floor: Recorded = TRACED["floor"]
power_of_two: Recorded = TRACED["power_of_two"]
root: Recorded = TRACED["sqrt"]
choose: Recorded = TRACED["choose"]


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
