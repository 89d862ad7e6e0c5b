"""Normal form: a polynomial with every related generator to at most its first power.

SymPy's expressions go to flint's sparse polynomials over the rationals and back.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from functools import reduce
from operator import add, mul

import sympy as sp
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx


def reduce_polynomial(polynomial: sp.Expr, squares: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Return the normal form; a square may hold the generators before it.

    Raises `sympy.PolynomialError` for what is no polynomial in symbols over the rationals.
    """
    ring = _Ring(polynomial.free_symbols.union(*(s.free_symbols | {g} for g, s in squares.items())))
    result = ring.read(polynomial)
    for generator in reversed(list(squares)):
        result = ring.lower(result, generator, squares[generator])
    return ring.write(result)


class _Ring:
    """The polynomials in some symbols."""

    def __init__(self, symbols: set[sp.Symbol]) -> None:
        self.symbols = sorted(symbols, key=sp.default_sort_key)
        # A ring of flint's has a generator, needed or not.
        names = [f"x{n}" for n in range(max(1, len(symbols)))]
        self.context = fmpq_mpoly_ctx.get(names, "lex")
        self.generators: dict[sp.Symbol, fmpq_mpoly] = dict(
            zip(self.symbols, self.context.gens(), strict=False)
        )

    def read(self, node: sp.Expr) -> fmpq_mpoly:
        """Return the polynomial of an expression."""
        if node.is_Rational:
            return self.context.constant(fmpq(int(node.p), int(node.q)))
        if node.is_Symbol:
            return self.generators[node]
        if isinstance(node, sp.Add | sp.Mul):
            combine = add if node.is_Add else mul
            return reduce(combine, [self.read(argument) for argument in node.args])
        if isinstance(node, sp.Pow) and node.exp.is_Integer and node.exp >= 0:
            return self.read(node.base) ** int(node.exp)
        raise sp.PolynomialError(f"no polynomial: {node}")

    def lower(self, value: fmpq_mpoly, generator: sp.Symbol, square: sp.Expr) -> fmpq_mpoly:
        """Put `square` in place of the generator's square, as often as it is there."""
        place = self.symbols.index(generator)
        parts: dict[int, dict[tuple[int, ...], fmpq]] = defaultdict(dict)
        for powers, coefficient in value.to_dict().items():
            half, odd = divmod(powers[place], 2)
            parts[half][(*powers[:place], odd, *powers[place + 1 :])] = coefficient
        if not any(parts):
            return value
        root = self.read(square)
        rests = (self.context.from_dict(part) * root**half for half, part in parts.items())
        return reduce(add, rests)

    def write(self, value: fmpq_mpoly) -> sp.Expr:
        """Return the expression of a polynomial, expanded."""
        terms = value.to_dict().items()
        return sp.Add(*(self._term(powers, coefficient) for powers, coefficient in terms))

    def _term(self, powers: tuple[int, ...], coefficient: fmpq) -> sp.Expr:
        number = sp.Rational(int(coefficient.p), int(coefficient.q))
        pairs = zip(self.symbols, powers, strict=False)
        return sp.Mul(number, *(symbol**power for symbol, power in pairs if power))
