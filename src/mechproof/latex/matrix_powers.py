r"""A power of a matrix to a whole number n, read as what it is for the first n and at each step.

A^n = B(n) for n = 1, 2, ... says that B(1) = A and B(n + 1) = B(n)A, and no more.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import reduce
from typing import Any

import sympy as sp

from mechproof.record import Conjunction, Equality, ValueWhere, list_divisors
from mechproof.record.substitution import substitute


def is_power(value: Any) -> bool:
    """Tell whether a value is a power of a matrix to a whole number."""
    return isinstance(value, sp.MatPow)


def raise_matrix(base: sp.MatrixBase, exponent: sp.Expr) -> sp.MatPow | None:
    """Return a power that is not worked out, to a letter that counts; None of other exponents."""
    is_count = exponent.is_Symbol and exponent.is_integer and exponent.is_nonnegative
    return sp.MatPow(base, exponent) if is_count and base.is_square else None


def says_from_one_on(relation: sp.Basic) -> bool:
    """Tell whether a relation says no more of a letter that counts from 1 on than that."""
    is_lower = isinstance(relation, sp.GreaterThan | sp.StrictGreaterThan)
    return bool(
        is_lower
        and relation.lhs.is_Symbol
        and relation.lhs.is_positive
        and relation.rhs == isinstance(relation, sp.GreaterThan)
    )


def state_power(sides: Sequence[Any], counts: Collection[sp.Basic]) -> Conjunction | None:
    """Return what an equation with a power on one side says; None where that is not clear.

    The exponent is any of the whole numbers from 0 or 1 on, as `counts` are.
    """
    powers = [side for side in sides if isinstance(side, sp.MatPow)]
    values = [side for side in sides if isinstance(side, sp.MatrixBase)]
    if len(powers) != 1 or len(values) != 1:
        return None
    (value,), (base, count) = values, powers[0].args
    if base.has(count) or value.shape != base.shape or count not in counts:
        return None
    first = base if count.is_positive else sp.eye(base.rows).as_immutable()
    number = sp.Integer(bool(count.is_positive))
    at_first = value.applyfunc(lambda entry: _put_in(entry, count, number))
    later = value.applyfunc(lambda entry: substitute(entry, {count: count + 1}))
    return Conjunction(
        (Equality(at_first, first, "member"), Equality(later, value * base, "member"))
    )


def _put_in(entry: sp.Expr, count: sp.Basic, number: sp.Integer) -> sp.Expr:
    """Put in a number; what then cancels and may have no value, as in n*a^(n - 1), is kept."""
    found = substitute(entry, {count: number})
    powers = (substitute(power, {count: number}) for power in entry.atoms(sp.Pow))
    return reduce(ValueWhere, (p for p in powers if list_divisors(p) and not found.has(p)), found)
