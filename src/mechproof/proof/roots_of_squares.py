"""Roots of squares, as in the lengths of arcs: they are moduli."""

from __future__ import annotations

import sympy as sp

from mechproof.proof.algebra import decide_equal
from mechproof.proof.half_angles import find_sign_there
from mechproof.proof.powers import decide_by_logarithms
from mechproof.proof.signs import is_nonzero
from mechproof.record import list_divisors
from mechproof.statement_domains.domain import Domain


def write_roots(expression: sp.Expr, letters: set[sp.Basic], domain: Domain) -> sp.Expr:
    """Write roots of squares of such letters by moduli: of 1 + sinh(u)**2 it is cosh(u)."""
    return expression.replace(
        lambda node: node.is_Pow and node.exp == sp.S.Half and node.free_symbols & letters,
        lambda root: _write_root(root, letters, domain),
    )


def take_signs(expression: sp.Expr, domain: Domain) -> sp.Expr:
    """Write the moduli of what is shown to have a sign without bars."""
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
    # A divisor may cancel: it is zero at single values of what runs.
    divisors = (x for x in list_divisors(root.base) if not x.free_symbols & letters)
    if not all(is_nonzero(x, domain) for x in divisors):
        return root
    rungs = (decide_equal, decide_by_logarithms)
    return written if any(rung(square, root.base, domain) for rung in rungs) else root


def _halve_angle(root: sp.Pow) -> sp.Expr:
    """Write the root of a(1 - cos u) by the modulus of the sine of u/2: an arc of a cycloid.

    That of a(1 + cos u) is written by the cosine; a sine is the cosine of what lacks to a quarter
    turn.
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
