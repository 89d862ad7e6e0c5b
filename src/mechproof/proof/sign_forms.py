"""Forms of a number that have its sign, in which the sign is easier to see.

A quotient is multiplied by its denominator, and divided by the common factor of its logarithms or
arc functions. Of two terms with opposite signs, the logarithms are compared. Whole numbers are
replaced by real ones, and two positive variables by one of them and their ratio: if the number is
homogeneous, only the ratio is left.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import permutations

import sympy as sp

from mechproof.proof.counts import let_run
from mechproof.proof.half_angles import find_sign_there
from mechproof.proof.powers import write_by_logarithms
from mechproof.proof.signs import is_positive
from mechproof.record.parts import INVERSES, TURNING, has_parts
from mechproof.record.relations import find_slack
from mechproof.statement_domains.domain import Domain

Form = tuple[sp.Expr, Domain]


def list_forms(value: sp.Expr, domain: Domain) -> Iterator[Form]:
    """Yield a number and others of its sign, each with the domain on which it has that sign."""
    for count in sorted(value.free_symbols, key=str):
        if count.is_integer and (run := let_run(value, count, domain)) is not None:
            value, domain = run
    if len(value.free_symbols) > 1:
        value = compare_logarithms(value, domain) or value
    for number, part in ((value, domain), *_list_ratios(value, domain)):
        yield free_logarithms(number, part), part
    if has_parts(sp.denom(sp.together(value)), *TURNING):
        yield value, domain


def drop_signed_factors(value: sp.Expr, domain: Domain) -> sp.Expr:
    """Divide by the positive factors, and by the opposites of the negative ones."""
    kept = sp.S.One
    for factor in sp.Mul.make_args(sp.factor_terms(sp.together(sp.powsimp(value)))):
        base, power = factor.as_base_exp()
        sign = find_sign_there(base, domain)
        is_signed = sign is not None and sign.strict
        if sign is None or not is_signed or not (sign.direction > 0 or power.is_integer):
            kept *= factor
        elif sign.direction < 0 and not power.is_even:
            kept *= -1 if power.is_odd else (-1) ** power
    return kept


def free_logarithms(value: sp.Expr, domain: Domain) -> sp.Expr:
    """Drop factors with known signs, and the factor that all logarithms have in common."""
    value = drop_signed_factors(value, domain)
    nodes = sorted(value.atoms(sp.log) or value.atoms(*INVERSES), key=sp.default_sort_key)
    if not nodes:
        return value
    expanded = sp.expand(value)
    factors = {node: expanded.coeff(node) for node in nodes}
    common = factors[nodes[0]].as_coeff_Mul()[1]
    if not common.free_symbols or common.has(sp.log, *INVERSES):
        return value
    ratios = {node: sp.cancel(factor / common) for node, factor in factors.items()}
    sign = find_sign_there(common, domain)
    if sign is None or not sign.strict or not all(ratio.is_number for ratio in ratios.values()):
        return value
    rest = sp.expand(expanded - sum(node * factor for node, factor in factors.items()))
    total = sum(node * ratio for node, ratio in ratios.items()) + sp.cancel(rest / common)
    return sign.direction * total


def compare_logarithms(value: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Write a - b, both positive and one a power that is not a root, as ln a - ln b; else None."""
    value = sp.collect(value, _list_powers(value))
    terms = value.as_independent(*value.free_symbols, as_Add=True)
    if terms[0] == 0:
        terms = sp.Add.make_args(value)
    if len(terms) != 2 or not _list_powers(value):
        return None
    signs = [find_sign_there(term, domain) for term in terms]
    known = [sign.direction for sign in signs if sign is not None and sign.strict]
    if sorted(known) != [-1, 1]:
        return None
    logarithms = (
        direction * write_by_logarithms(sp.log(direction * term), domain)
        for direction, term in zip(known, terms, strict=True)
    )
    written = sp.factor(sp.expand(sp.Add(*logarithms)))
    return None if _list_powers(written) else drop_signed_factors(written, domain)


def _list_powers(value: sp.Expr) -> list[sp.Expr]:
    """List the powers that are not roots."""
    return [power for power in value.atoms(sp.Pow, sp.exp) if not power.exp.is_Rational]


def _list_ratios(value: sp.Expr, domain: Domain) -> Iterator[Form]:
    """Write one of two positive variables as the other times their ratio, if only that remains."""
    symbols = sorted(value.free_symbols, key=str)
    for large, small in permutations(symbols, 2):
        least = _find_least_ratio(large, small, domain)
        if least is None:
            continue
        ratio, unit = sp.Dummy("ratio", positive=True), sp.Dummy("unit", positive=True)
        sets = {ratio: least, unit: sp.Interval.open(0, sp.oo)}
        part = replace(domain, within={**domain.within, **sets})
        written = value.subs({large: ratio * unit, small: unit}, simultaneous=True)
        written = sp.expand(write_by_logarithms(written, part)).replace(sp.exp, _write_power)
        left = drop_signed_factors(sp.factor(written), part)
        if not left.has(unit):
            yield left, part
            return


def _write_power(exponent: sp.Expr) -> sp.Expr:
    """Write exp(k*ln b) as b**k."""
    factors = sp.Mul.make_args(exponent)
    logarithm = next((factor for factor in factors if isinstance(factor, sp.log)), None)
    return sp.exp(exponent) if logarithm is None else logarithm.args[0] ** (exponent / logarithm)


def _find_least_ratio(large: sp.Symbol, small: sp.Symbol, domain: Domain) -> sp.Interval | None:
    """Return the interval of the ratio of two variables, or None if they are not shown positive."""
    if not is_positive(small, domain):
        return None
    said = {find_slack(relation) for relation in domain.where}
    for strict in (True, False):
        if (large - small, strict) in said:
            return sp.Interval(1, sp.oo, left_open=strict)
    return sp.Interval.open(0, sp.oo) if is_positive(large, domain) else None
