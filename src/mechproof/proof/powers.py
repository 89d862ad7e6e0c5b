"""Rung: logarithms and powers in one form, if their signs are shown; roots of squares.

A power of a positive base is an exponential, and the logarithm of a product of positive factors is
the sum of theirs. Where a sign is not shown nothing is rewritten, so that no branch is mistaken.

Roots of squares, as in arc lengths, become moduli.
"""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.coordinates import HYPERBOLIC, write_by_sines
from mechproof.proof.counts import STEPS
from mechproof.proof.half_angles import find_sign_there, is_shown_there
from mechproof.proof.signs import is_nonzero, is_positive
from mechproof.record import Slack, list_divisors
from mechproof.record.parts import has_parts
from mechproof.statement_domains.domain import Domain

RUNG = "logarithms and powers"
_JUMPING = (*STEPS, sp.atan2)


def decide_by_logarithms(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung if left = right once logarithms and powers have one form, else None."""
    left, right = domain.resolve(left), domain.resolve(right)
    one, other = (write_by_logarithms(side, domain) for side in (left, right))
    if (one, other) == (left, right):
        return None
    return RUNG if decide_equal(one, other, domain) else None


def split_powers(expression: sp.Expr) -> sp.Expr:
    """Write b**(k*n + m + a), n a whole number, by b**n and b**a, for any nonzero b.

    Where b is zero, both sides of an identity continue the values nearby: b is zero on no interval,
    and nothing jumps there.
    """
    if has_parts(expression, *_JUMPING):
        return expression
    names: dict[tuple[sp.Expr, sp.Expr], sp.Symbol] = {}
    return expression.replace(
        lambda node: isinstance(node, sp.Pow) and not node.exp.is_number and is_analytic(node.base),
        lambda node: _split_power(node.base, node.exp, names),
    )


def is_analytic(expression: sp.Expr) -> bool:
    """Return whether an expression, unless it is identically zero, is zero on no interval."""
    roots = (power for power in expression.atoms(sp.Pow) if not power.exp.is_integer)
    return not has_parts(expression, *_JUMPING, sp.Abs, sp.Max, sp.Min) and not any(
        root.base.free_symbols for root in roots
    )


def _split_power(
    base: sp.Expr, exponent: sp.Expr, names: dict[tuple[sp.Expr, sp.Expr], sp.Symbol]
) -> sp.Expr:
    result, kept = sp.S.One, sp.S.Zero
    for term in sp.Add.make_args(sp.expand(exponent)):
        times, rest = term.as_coeff_Mul(rational=True)
        if not (times.is_Integer and rest.is_integer):
            kept += term
            continue
        for factor, power in _list_factors(base):
            if rest == 1:
                result *= factor ** (power * times)
            elif factor == -1:
                result *= names.setdefault((factor, rest), sp.Dummy("sign")) ** (times % 2)
            else:
                name = names.setdefault((factor, rest), sp.Dummy("power", real=True))
                result *= name ** (power * times)
    return result * sp.Pow(base, kept)


def _list_factors(base: sp.Expr) -> list[tuple[sp.Expr, int]]:
    """List a base's factors with their whole powers, numbers by their primes."""
    found: list[tuple[sp.Expr, int]] = []
    for factor in sp.Mul.make_args(base):
        if factor.is_Rational:
            primes = sp.factorrat(factor).items()
            found += [(sp.Integer(prime), int(power)) for prime, power in primes]
        elif isinstance(factor, sp.Pow) and factor.exp.is_Integer:
            found.append((factor.base, int(factor.exp)))
        else:
            found.append((factor, 1))
    return found


def write_by_logarithms(node: sp.Expr, domain: Domain) -> sp.Expr:
    """Write powers of positive bases as exponentials, logarithms of products as sums."""
    if not node.args or not node.has(sp.log, sp.Pow, sp.exp):
        return node
    if isinstance(node, HYPERBOLIC) and node.has(sp.log):
        node = node.rewrite(sp.exp)
    node = node.func(*(write_by_logarithms(argument, domain) for argument in node.args))
    if isinstance(node, sp.log):
        logarithm = _take_logarithm(node.args[0], domain)
        written = node if logarithm is None else logarithm
        return written.replace(sp.log, lambda argument: _take_sizes(sp.log(argument)))
    if isinstance(node, sp.exp):
        return _write_exponential(node.args[0])
    if not isinstance(node, sp.Pow) or node.exp.is_Rational:
        return node
    logarithm = _take_logarithm(_write_base(node.base), domain)
    return node if logarithm is None else _write_exponential(node.exp * logarithm)


def _write_base(base: sp.Expr) -> sp.Expr:
    """Write hyperbolic functions by exponentials (cosh x + sinh x is one), or tangents by sines."""
    return sp.expand(base.rewrite(sp.exp)) if base.has(*HYPERBOLIC) else write_by_sines(base)


def _take_logarithm(argument: sp.Expr, domain: Domain) -> sp.Expr | None:
    """Return a product's logarithm as a sum over its factors, or None if not all are positive."""
    factors = _list_powers(argument)
    if not all(
        is_positive(base, domain) or is_shown_there(Slack(base, True), domain)
        for base, _ in factors
    ):
        return None
    return sp.Add(*(exponent * sp.log(base) for base, exponent in factors))


def _take_sizes(logarithm: sp.Expr) -> sp.Expr:
    """Write ln of a product, positive wherever ln has a value, by the moduli of its factors."""
    if not isinstance(logarithm, sp.log):
        return logarithm
    sizes = [
        (part, exponent * power)
        for base, exponent in _list_powers(logarithm.args[0])
        for part, power in _list_powers(base)
    ]
    if len([base for base, _ in sizes if not base.is_number]) < 2:
        return logarithm
    return sp.Add(*(exponent * sp.log(sp.Abs(base)) for base, exponent in sizes))


def _list_powers(product: sp.Expr) -> list[tuple[sp.Expr, sp.Expr]]:
    return [factor.as_base_exp() for factor in sp.Mul.make_args(sp.factor(product))]


def _write_exponential(exponent: sp.Expr) -> sp.Expr:
    """Write the exponential of a sum as a product, whole multiples of logarithms as powers."""
    if any(power.exp.is_negative for power in exponent.atoms(sp.Pow)):
        above, below = sp.fraction(sp.cancel(exponent))
        letter = min(below.free_symbols, key=str, default=None)
        is_divided = letter is not None and all(x.is_polynomial(letter) for x in (above, below))
        whole, rest = sp.div(above, below, letter) if is_divided else (sp.S.Zero, above)
        exponent = whole + rest / below
    return sp.Mul(*(sp.exp(term) for term in sp.Add.make_args(sp.expand(exponent))))


def write_roots(expression: sp.Expr, letters: set[sp.Basic], domain: Domain) -> sp.Expr:
    """Write square roots of squares in the letters as moduli: 1 + sinh(u)**2 gives cosh(u)."""
    return expression.replace(
        lambda node: node.is_Pow and node.exp == sp.S.Half and node.free_symbols & letters,
        lambda root: _write_root(root, letters, domain),
    )


def take_signs(expression: sp.Expr, domain: Domain) -> sp.Expr:
    """Replace |u| by u or -u if the sign of u is shown."""
    signs = {node: find_sign_there(node.args[0], domain) for node in expression.atoms(sp.Abs)}
    return expression.xreplace(
        {node: sign.direction * node.args[0] for node, sign in signs.items() if sign is not None}
    )


def _write_root(root: sp.Pow, letters: set[sp.Basic], domain: Domain) -> sp.Expr:
    if (halved := _halve_angle(root)) != root:
        return halved
    square = sp.factor(sp.trigsimp(sp.expand(root.base)))
    written = sp.sqrt(square).replace(lambda node: node.is_Pow, _halve_angle)
    powers = (p for p in written.atoms(sp.Pow) if not p.exp.is_Integer)
    if any(power.free_symbols & letters for power in powers):
        return root
    # Divisors with a running letter may vanish, as they do so only at single values of it.
    divisors = (x for x in list_divisors(root.base) if not x.free_symbols & letters)
    if not all(is_nonzero(x, domain) for x in divisors):
        return root
    rungs = (decide_equal, decide_by_logarithms)
    return written if any(rung(square, root.base, domain) for rung in rungs) else root


def _halve_angle(root: sp.Pow) -> sp.Expr:
    """Write the root of a(1 - cos u) as a modulus of sin(u/2), as for the arc of a cycloid.

    The root of a(1 + cos u) becomes a cosine; a sine is read as the cosine of its complement.
    """
    if root.exp != sp.S.Half:
        return root
    for kind, other in ((sp.cos, sp.sin), (sp.sin, sp.cos)):
        waves, size = root.atoms(kind), sp.Dummy("c")
        if len(waves) != 1:
            continue
        (wave,) = waves
        squares = {other(wave.args[0]) ** 2: 1 - size**2, wave: size}
        radicand = sp.expand(sp.expand(root.base).subs(squares)).as_poly(size)
        angle = wave.args[0] if kind == sp.cos else sp.pi / 2 - wave.args[0]
        for end, half in ((1, sp.sin), (-1, sp.cos)):
            if radicand and radicand.degree() == 1 and radicand.eval(end) == 0:
                return sp.sqrt(-2 * end * radicand.LC()) * sp.Abs(half(sp.expand(angle / 2)))
    return root
