"""Roots in integrands that are roots of squares, as in the lengths of arcs."""

from __future__ import annotations

import sympy as sp

from mechproof.domains.domain import Domain
from mechproof.proof.algebra import decide_equal
from mechproof.proof.powers import decide_by_logarithms
from mechproof.proof.signs import is_nonzero
from mechproof.record import list_divisors


def write_roots(integrand: sp.Expr, variable: sp.Symbol, domain: Domain) -> sp.Expr:
    """Write the roots of squares in an integrand by moduli: of 1 + sinh(u)**2 it is cosh(u)."""
    return integrand.replace(
        lambda node: node.is_Pow and node.exp == sp.S.Half and node.has(variable),
        lambda root: _write_root(root, variable, domain),
    )


def _write_root(root: sp.Pow, variable: sp.Symbol, domain: Domain) -> sp.Expr:
    if (halved := _halve_angle(root)) != root:
        return halved
    square = sp.factor(sp.trigsimp(sp.expand(root.base)))
    written = sp.sqrt(square).replace(lambda node: node.is_Pow, _halve_angle)
    if any(p.has(variable) and not p.exp.is_Integer for p in written.atoms(sp.Pow)):
        return root
    divisors = (x for x in list_divisors(root.base) if not x.has(variable))
    if not all(is_nonzero(x, domain) for x in divisors):
        return root
    rungs = (decide_equal, decide_by_logarithms)
    return written if any(rung(square, root.base, domain) for rung in rungs) else root


def _halve_angle(root: sp.Pow) -> sp.Expr:
    """Write the root of a(1 - cos u) by the modulus of the sine of u/2: an arc of a cycloid.

    That of a(1 + cos u) is written by the cosine.
    """
    if root.exp != sp.S.Half or len(waves := root.atoms(sp.cos)) != 1:
        return root
    (wave,), cosine = waves, sp.Dummy("c")
    squares = {sp.sin(wave.args[0]) ** 2: 1 - cosine**2, wave: cosine}
    radicand = sp.expand(sp.expand(root.base).subs(squares)).as_poly(cosine)
    for end, half in ((1, sp.sin), (-1, sp.cos)):
        if radicand and radicand.degree() == 1 and radicand.eval(end) == 0:
            return sp.sqrt(-2 * end * radicand.LC()) * sp.Abs(half(wave.args[0] / 2))
    return root
