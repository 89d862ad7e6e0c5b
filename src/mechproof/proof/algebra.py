"""Rung: equality in a field of rational functions, circle points and square roots.

Angles are reduced to one (cos, sin) pair per base angle with c^2 + s^2 = 1, square roots to roots
of irreducible factors of proved sign with r^2 = f. The numerator of the difference then has a
unique normal form; it is zero exactly if the two sides agree wherever both are defined.
Exponentials, if need be, become powers of one generator for each monomial of their arguments. Other
functions (arctan, ...) stay opaque: equal arguments, equal values. Trigonometric polynomials as a
quotient ring are those of Mulholland and Monagan (2001).
"""

from __future__ import annotations

from math import comb, lcm

import sympy as sp

from mechproof.arithmetic.polynomials import factor_list, is_zero, reduce_polynomial, split
from mechproof.proof.canonical_sums import canonicalise
from mechproof.proof.coordinates import BY_SINES, HYPERBOLIC, list_terms
from mechproof.proof.signs import MOST_MULTIPLIED, find_sign, is_positive, is_workable
from mechproof.record.parts import ANGLES, CIRCULAR, find_parts, has_parts
from mechproof.statement_domains.domain import Domain

_HALF = sp.Rational(1, 2)
_EXPONENTIALS = (sp.exp, *HYPERBOLIC)


class Field:
    """The generators met in one proof, and the relations between them."""

    def __init__(self, domain: Domain, has_powers: bool = False) -> None:
        """Start with no generator; `domain` proves the signs under square roots.

        With `has_powers`, an exponential becomes a product of powers of generators, one for each
        monomial of its argument.
        """
        self.domain = domain
        self.has_powers = has_powers
        self.used_angles = False
        self.used_roots = False
        self.used_sums = False
        self._denominators: dict[sp.Expr, int] = {}
        self._circle: dict[sp.Expr, tuple[sp.Symbol, sp.Symbol]] = {}
        self._bases: dict[sp.Expr, sp.Symbol] = {}
        self._opaque: dict[sp.Basic, sp.Symbol] = {}
        self._meaning: dict[sp.Basic, sp.Basic] = {}
        self._relations: dict[sp.Pow, sp.Expr] = {}
        self._unsigned: list[sp.Expr] = []
        self._translated: dict[sp.Basic, sp.Expr] = {}

    def vanishes(self, expression: sp.Basic) -> bool:
        """Decide whether the expression is identically zero; False means "not shown"."""
        if not is_workable(expression):
            raise NotImplementedError(f"a power above {MOST_MULTIPLIED} is not multiplied out")
        self.used_sums = self.used_sums or has_parts(expression, sp.Sum)
        expression = canonicalise(self.domain.resolve(expression), self.domain)
        self._collect_angles(expression)
        broken = (p.exp.q for p in find_parts(expression, sp.Pow) if p.exp.is_Rational)
        self._degree = lcm(*(int(q) for q in broken if q > 2))
        self._translated.clear()
        translated = self._translate(expression)
        # Translating collects the generators: only now are all relations between them known.
        return is_zero(translated, self._relations)

    @property
    def rung(self) -> str:
        """Name the rung by what the proof needed."""
        kinds = (
            (self.used_sums, "symbolic sum"),
            (self.used_roots, "radicals"),
            (self.used_angles, "trigonometric field"),
        )
        return next((name for used, name in kinds if used), "rational field")

    def _collect_angles(self, expression: sp.Basic) -> None:
        for node in find_parts(expression, *CIRCULAR, *_EXPONENTIALS):
            for monomial, factor in list_terms(node.args[0]):
                known = self._denominators.get(monomial, 1)
                self._denominators[monomial] = lcm(known, int(factor.q))

    def _translate(self, node: sp.Basic) -> sp.Expr:
        if node not in self._translated:
            self._translated[node] = self._translate_anew(node)
        return self._translated[node]

    def _translate_anew(self, node: sp.Basic) -> sp.Expr:
        if node.is_Rational or node.is_Symbol:
            return node
        if isinstance(node, sp.Add | sp.Mul):
            # The result is read as a polynomial, so SymPy need not order its terms first.
            parts = (self._translate(argument) for argument in node.args)
            return node.func(*parts, evaluate=False)
        if isinstance(node, sp.Pow) and node.exp.is_Integer:
            return sp.Pow(self._translate(node.base), node.exp, evaluate=False)
        if isinstance(node, sp.Pow) and node.exp.is_Rational and node.exp.q == 2:
            return self._translate_root(node.base) ** node.exp.p
        if isinstance(node, sp.Pow) and node.exp.is_Rational:
            return self._translate_power(node)
        if isinstance(node, sp.Abs):
            return self._translate_root(node.args[0] ** 2)
        if isinstance(node, sp.sign) and (sign := find_sign(node.args[0], self.domain)):
            return sp.Integer(sign.direction) if sign.strict else self._translate_opaque(node)
        if isinstance(node, CIRCULAR):
            return self._translate_angle(node)
        if self.has_powers and isinstance(node, (*_EXPONENTIALS, type(sp.E))):
            return self._translate_exponential(node)
        if isinstance(node, sp.atan2) and is_positive(node.args[1], self.domain):
            quotient = sp.atan(node.args[0] / node.args[1])
            return self._translate_opaque(quotient) if quotient != 0 else quotient
        return self._translate_opaque(node)

    def _translate_angle(self, node: sp.Expr) -> sp.Expr:
        self.used_angles = True
        cosine, sine = sp.Integer(1), sp.Integer(0)
        for monomial, factor in list_terms(node.args[0]):
            c, s = self._multiple(monomial, factor)
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return BY_SINES[node.func](sine, cosine)

    def _translate_exponential(self, node: sp.Expr) -> sp.Expr:
        """Return a power of generators; hyperbolic functions are quotients of such powers."""
        power = sp.Integer(1)
        for monomial, factor in list_terms(node.args[0] if node.args else sp.S.One):
            denominator = self._denominators.get(monomial, 1)
            if monomial not in self._bases:
                base = sp.Dummy("E", positive=True)
                self._bases[monomial] = base
                self._meaning[base] = sp.exp(monomial / denominator)
            power *= self._bases[monomial] ** (factor * denominator)
        even, odd = (power + 1 / power) / 2, (power - 1 / power) / 2
        quotients = {
            sp.cosh: even,
            sp.sinh: odd,
            sp.tanh: odd / even,
            sp.coth: even / odd,
            sp.sech: 1 / even,
            sp.csch: 1 / odd,
        }
        return quotients.get(node.func, power)

    def _multiple(self, monomial: sp.Expr, factor: sp.Rational) -> tuple[sp.Expr, sp.Expr]:
        """Return cos and sin of factor*monomial as polynomials in those of the base angle."""
        if monomial == sp.pi and not (cosine := sp.cos(factor * sp.pi)).has(sp.cos, sp.sin):
            return self._translate(cosine), self._translate(sp.sin(factor * sp.pi))
        times = int(factor * self._denominators.setdefault(monomial, int(factor.q)))
        c, s = self._circle_point(monomial)
        n = abs(times)
        if n > MOST_MULTIPLIED:
            raise NotImplementedError(f"{n} times an angle is not multiplied out")
        even = sum((-1) ** (k // 2) * comb(n, k) * c ** (n - k) * s**k for k in range(0, n + 1, 2))
        odd = sum((-1) ** (k // 2) * comb(n, k) * c ** (n - k) * s**k for k in range(1, n + 1, 2))
        return sp.sympify(even), sp.sympify(odd) * (1 if times >= 0 else -1)

    def _circle_point(self, monomial: sp.Expr) -> tuple[sp.Symbol, sp.Symbol]:
        # cos(atan(u)/2) is not rational in u and one root: only whole angles are taken apart.
        if isinstance(monomial, ANGLES) and self._denominators[monomial] == 1:
            return self._point_of_argument(monomial)
        if monomial not in self._circle:
            base = monomial / self._denominators[monomial]
            c, s = (sp.Dummy(name, real=True) for name in ("c", "s"))
            self._circle[monomial] = (c, s)
            self._relations[s**2] = 1 - c**2
            self._meaning |= {c: sp.cos(base), s: sp.sin(base)}
        return self._circle[monomial]

    def _point_of_argument(self, node: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return cos and sin of an inverse function: a vector's components over its length."""
        if isinstance(node, sp.asin | sp.acos):
            side, root = self._translate(node.args[0]), self._translate_root(1 - node.args[0] ** 2)
            return (root, side) if isinstance(node, sp.asin) else (side, root)
        y, x = (node.args[0], sp.S.One) if isinstance(node, sp.atan) else node.args
        length = self._translate_root(x**2 + y**2)
        return self._translate(x) / length, self._translate(y) / length

    def _translate_root(self, radicand: sp.Expr) -> sp.Expr:
        """Return sqrt(radicand) with squares pulled out and the rest as roots of single factors."""
        self.used_roots = True
        numerator, denominator = split(self._translate(radicand))
        root, rest = self._split_squares(denominator)
        constant, factors = factor_list(self._reduce(numerator * rest))
        outside = 1 / (root * rest * self._direction(rest))
        inside = sp.Integer(1)
        for factor, power in factors:
            if power > 1:
                outside *= self._size_of_power(factor, power // 2)
            if power % 2:
                direction = self._known_direction(factor)
                if direction is None:
                    inside *= factor
                else:
                    constant *= direction
                    outside *= self._root_of(direction * factor)
        return sp.expand(outside * self._root_of_number_and(constant, inside))

    def _translate_power(self, node: sp.Pow) -> sp.Expr:
        """Return a power as roots of its base's factors, if none of these is negative."""
        above, below = split(self._translate(node.base))
        constant, factors = factor_list(self._reduce(above * below ** (self._degree - 1)))
        parts = (constant, below, *(factor for factor, _ in factors))
        if any(self._known_direction(part) != 1 for part in parts):
            return self._translate_opaque(node)
        self.used_roots = True
        primes = [(sp.Integer(prime), n) for prime, n in sp.factorrat(constant).items()]
        roots = (self._root_of(f, self._degree) ** n for f, n in (*factors, *primes))
        return (sp.Mul(*roots) / below) ** int(node.exp * self._degree)

    def _split_squares(self, denominator: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Write a denominator as root^2 * rest, root positive; a normal form would hide squares."""
        rest, factors = factor_list(denominator)
        root = sp.Integer(1)
        for factor, power in factors:
            root *= self._size_of_power(factor, power // 2)
            rest *= factor ** (power % 2)
        return root, rest

    def _size_of_power(self, factor: sp.Expr, power: int) -> sp.Expr:
        """Return |factor|^power; without a known sign, |factor| is the root of its square."""
        if power % 2 == 0:
            return factor**power
        direction = self._known_direction(factor)
        if direction is not None:
            return (direction * factor) ** power
        self._unsigned.append(factor)
        return self._root_of(sp.expand(factor**2)) * factor ** (power - 1)

    def _root_of_number_and(self, constant: sp.Expr, rest: sp.Expr) -> sp.Expr:
        if rest == 1:
            return self._translate_number_root(constant)
        if constant < 0:
            constant, rest = -constant, -rest
        return self._translate_number_root(constant) * self._root_of(sp.expand(rest))

    def _translate_number_root(self, constant: sp.Expr) -> sp.Expr:
        root = sp.sqrt(constant)
        surds = [p for p in root.atoms(sp.Pow) if p.exp == _HALF]
        return root.subs({surd: self._root_of(surd.base) for surd in surds})

    def _root_of(self, factor: sp.Expr, degree: int = 2) -> sp.Symbol:
        for power, known in self._relations.items():
            if power.base.is_nonnegative and (known, power.exp) == (factor, degree):
                return power.base
        root = sp.Dummy("r", nonnegative=True)
        self._relations[root**degree] = factor
        self._meaning[root] = sp.root(factor, degree)
        return root

    def _direction(self, expression: sp.Expr) -> int:
        direction = self._known_direction(expression)
        if direction is None:
            raise UnknownSignError(f"the sign of {self._original(expression)} is not shown")
        return direction

    def _known_direction(self, expression: sp.Expr) -> int | None:
        sign = find_sign(self._original(expression), self.domain)
        return sign.direction if sign else None

    def _original(self, expression: sp.Expr) -> sp.Expr:
        for _ in range(len(self._meaning) + 1):
            expression = expression.xreplace(self._meaning)
        return expression

    @property
    def hindrance(self) -> str:
        """Name the sign that was not shown, or return "" if there is none."""
        shown = next(map(self._original, self._unsigned), None)
        return f"the sign of {shown} is not shown" if shown is not None else ""

    def _translate_opaque(self, node: sp.Basic) -> sp.Symbol:
        """Return the symbol of a function, the same one if all its arguments are proved equal."""
        for known, symbol in self._opaque.items():
            if known.func == node.func and len(known.args) == len(node.args):
                pairs = zip(known.args, node.args, strict=True)
                if known == node or self._same_arguments(node, pairs):
                    return symbol
        self._opaque[node] = sp.Dummy("f")
        self._meaning[self._opaque[node]] = node
        return self._opaque[node]

    def _same_arguments(self, node: sp.Basic, pairs: object) -> bool:
        if not isinstance(node, sp.Function) or isinstance(node, sp.Piecewise):
            return False
        return all(Field(self.domain).vanishes(a - b) for a, b in pairs)  # type: ignore[attr-defined]

    def _reduce(self, polynomial: sp.Expr) -> sp.Expr:
        """Return the normal form, in which each related generator is below its relation's power."""
        return reduce_polynomial(polynomial, self._relations)


class UnknownSignError(ArithmeticError):
    """A square root could not be taken apart because a sign is not shown."""


def decide_equal(left: sp.Expr, right: sp.Expr, domain: Domain) -> str | None:
    """Return the rung that proves left = right wherever both are defined, or None."""
    difference = left - right
    kinds = (False, True) if has_parts(difference, *_EXPONENTIALS) else (False,)
    return next(filter(None, (_find_rung(Field(domain, k), difference) for k in kinds)), None)


def _find_rung(field: Field, difference: sp.Expr) -> str | None:
    try:
        return field.rung if field.vanishes(difference) else None
    except (UnknownSignError, NotImplementedError, sp.PolynomialError):
        return None


def explain_unequal(left: sp.Expr, right: sp.Expr, domain: Domain) -> str:
    """Name what keeps the rung from proving left = right: a sign, a function, the identity."""
    field, difference = Field(domain), left - right
    # SymPy takes long over infinite products, and orders terms by the values of their integrals.
    try:
        if not has_parts(difference, sp.Product):
            field.vanishes(difference)
    except (UnknownSignError, NotImplementedError) as error:
        return str(error)
    except sp.PolynomialError:
        pass
    is_long = has_parts(difference, sp.Product, sp.Integral)
    shown = sp.sstr(difference, order="none" if is_long else None)
    return field.hindrance or f"{shown} is not shown to be zero"
