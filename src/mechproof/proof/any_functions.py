"""Rung: statements about functions that are only named, and smooth everywhere.

Integrands are written as derivatives as far as possible: f'(x), u*v' + u'*v; for the rest an
antiderivative is given a name. Values of functions then are numbers of which nothing is known, so
what is proved of them holds for all functions. Functions for which a statement fails refute it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.core.symbol import Str

from mechproof.proof.limits import settle_limits
from mechproof.proof.refutation import FEW, compare
from mechproof.proof.verdict import Answer, Verdict
from mechproof.record import AnyFunction, ValueWhere, list_divisors, list_partial
from mechproof.record.parts import find_bound, find_parts
from mechproof.record.relations import KINKED
from mechproof.statement_domains.domain import Domain

RUNG = "values of any functions"
# Work limit: terms that are integrated one by one.
_MOST_STEPS = 40
_X = sp.Dummy("x", real=True)
# Functions that are tried for a refutation, n counting the named ones so that each gets its own.
_N = sp.Dummy("n")
_SAMPLES = (_X**3 / _N + (_N + 1) * _X + 1, sp.exp(_X / _N) + _X**2)


def has_any_functions(*sides: Any) -> bool:
    """Return whether a side contains a function that is only named."""
    return any(find_parts(side, AnyFunction) for side in sides)


def decide_any(
    printed: sp.Expr, rebuilt: sp.Expr, domain: Domain, decide: Callable[..., Answer]
) -> Answer:
    """Decide whether the sides are equal for all functions."""
    sides = [settle_limits(domain.resolve(side), domain) for side in (printed, rebuilt)]
    written = [side.replace(sp.Integral, _integrate) for side in sides]
    bound = {symbol for side in written for symbol in find_bound(side)}
    met = {node for side in written for node in find_parts(side, AnyFunction)}
    if not any(node.free_symbols & bound for node in met):
        names: dict[sp.Expr, sp.Dummy] = {}
        answer = decide(*(_name_values(side, names) for side in written), domain)
        if answer.verdict is Verdict.PROVED:
            return replace(answer, rung=f"{RUNG}, {answer.rung}")
    for sample in _SAMPLES:
        (one, other), told = _try(sides, sample)
        if found := compare(one, other, domain, FEW).counterexample:
            reason = f"the two sides differ for {told}"
            if _list_names(sides[0]) != _list_names(sides[1]):
                reason = f"the equation may define a function: {reason}"
                return Answer(Verdict.UNDECIDED, "none", reason)
            return Answer(Verdict.REFUTED, "separating balls", reason, (found,))
    reason = "neither proved for all functions nor refuted by any that was tried"
    return Answer(Verdict.UNDECIDED, "none", reason)


def _list_names(side: sp.Expr) -> set[str]:
    return {str(node.args[0]) for node in find_parts(side, AnyFunction)}


def _try(sides: list[sp.Expr], sample: sp.Expr) -> tuple[list[sp.Expr], str]:
    """Replace the named functions by sample functions; also return which, as text."""
    called = sorted({name for side in sides for name in _list_names(side)})
    chosen = {name: sample.subs(_N, count) for count, name in enumerate(called, start=2)}

    def put(name: Str, order: sp.Integer, argument: sp.Expr) -> sp.Expr:
        return sp.diff(chosen[str(name)], (_X, order)).subs(_X, argument)

    told = ", ".join(f"{name}(x) = {value}".replace("_x", "x") for name, value in chosen.items())
    return [side.replace(AnyFunction, put) for side in sides], told


def _name_values(side: Any, names: dict[sp.Expr, sp.Dummy]) -> Any:
    """Replace each value of a function by an unknown number, where its argument has a value."""
    if isinstance(side, AnyFunction):
        *which, argument = side.args
        key = AnyFunction(*which, sp.expand(argument))
        named = names.setdefault(key, sp.Dummy(str(side), real=True))
        is_open = list_partial(argument) or list_divisors(argument)
        return ValueWhere(named, argument) if is_open else named
    if not find_parts(side, AnyFunction):
        return side
    return side.func(*(_name_values(part, names) for part in side.args))


# Integrals --------------------------------------------------------------------------------------


def _integrate(integrand: sp.Expr, *limits: sp.Tuple) -> sp.Expr:
    """Write an integral of functions by values of antiderivatives at its limits."""
    whole = sp.Integral(integrand, *limits)
    (x, *ends), *others = limits
    is_bounded = len(ends) == 2 and not others and not any(end.is_infinite for end in ends)
    is_plain = integrand.has(AnyFunction) and not integrand.has(*KINKED)
    if not (is_bounded and is_plain and _is_smooth(integrand, x)):
        return whole
    antiderivative, left = _reduce(integrand.xreplace({x: _X}))
    values = [antiderivative.subs(_X, end) for end in ends]
    return values[1] - values[0] + sp.Integral(left.xreplace({_X: x}), (x, *ends))


def _reduce(integrand: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return an antiderivative of the terms with functions, and the terms without them."""
    found = left = sp.S.Zero
    terms = [*sp.Add.make_args(sp.expand(integrand))]
    for _ in range(_MOST_STEPS):
        if not terms:
            break
        term = terms.pop()
        factor, running = term.as_independent(_X)
        if not running.has(AnyFunction):
            left += term
        elif (one := _find_part(running)) is None:
            found += factor * AnyFunction(Str(str(running)), sp.S.NegativeOne, _X)
        else:
            found += factor * one
            rest = sp.expand(sp.Add(*terms) + term - factor * sp.diff(one, _X))
            terms = [*sp.Add.make_args(rest)] if rest != 0 else []
    else:
        raise NotImplementedError("the integrand has too many terms")
    return found, left


def _find_part(term: sp.Expr) -> sp.Expr | None:
    """Return an expression whose derivative is the term up to other terms, or None.

    The last function is differentiated less often, the others more; for a function multiplied by a
    polynomial, antiderivatives are used as well.
    """
    powers = dict(factor.as_base_exp() for factor in sp.Mul.make_args(term))
    functions = [base for base in powers if isinstance(base, AnyFunction)]
    ranked = sorted(functions, key=lambda f: (str(f.args[0]), str(f.args[2]), f.args[1]))
    for whole in reversed(ranked):
        name, order, argument = whole.args
        below = AnyFunction(name, order - 1, argument)
        power = powers.get(below, sp.S.Zero)
        others = sp.cancel(term / whole / below**power / sp.diff(argument, _X))
        is_known = not others.has(AnyFunction) and others.is_polynomial(_X)
        is_one = powers[whole] == 1 and not others.has(whole, below) and _is_smooth(others, _X)
        if is_one and power.is_Integer and (is_known or (order > 0 and whole == ranked[-1])):
            return others * below ** (power + 1) / (power + 1)
    return None


def _is_smooth(node: sp.Expr, x: sp.Symbol) -> bool:
    """Return whether an expression is known from its form to be smooth for all numbers x."""
    if not node.has(x) or node == x:
        return True
    if isinstance(node, sp.Pow) and not isinstance(node, sp.exp):
        return bool(node.exp.is_Integer and node.exp > 0) and _is_smooth(node.base, x)
    kinds = (sp.Add, sp.Mul, sp.sin, sp.cos, sp.exp, AnyFunction)
    return isinstance(node, kinds) and all(_is_smooth(part, x) for part in node.args)
