"""Constraints between letters: the equations that follow from them or contradict them.

A constraint says that its residual, one side minus the other, is zero. An equation follows from a
constraint if its own residual is a multiple of the constraint's: the multiplier is sought by
polynomial division in sines, cosines and letters. An equation follows from several constraints if
its residual is a sum of multiples: the multipliers are sought among polynomials in the monomials
of the constraints, by linear equations for the coefficients. The prover confirms each find.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from mechproof.proof.ladder import decide
from mechproof.proof.signs import is_nonzero
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, list_divisors
from mechproof.statement_domains.domain import Domain
from mechproof.statement_domains.preparation import take_values

# Work limit: operation count up to which a multiplier is sought for a residual.
LARGEST = 1000
# Work limit: number of products of constraints and monomials that a sum may be made of.
MOST_PRODUCTS = 300
# Stands for pi in polynomials.
_PI = sp.Dummy("pi", positive=True)


def find_multiple(
    residual: sp.Expr, constraint: sp.Expr, domain: Domain
) -> tuple[sp.Expr, sp.Expr] | None:
    """Return m and r with residual = m * constraint + r, proved on the domain; None if not found.

    With r = 0 the residual follows from the constraint; with any other r, which has no zero, the
    two are never zero together. The divisors of m and r have no zero on the domain, except where
    the residual has no value: a multiplier without a value where the constraint holds would prove
    anything.
    """
    for multiplier, rest in _propose(residual, constraint):
        answer = decide(Equality(residual, multiplier * constraint + rest), domain)
        if answer.verdict is Verdict.PROVED and _have_values((multiplier, rest), residual, domain):
            return multiplier, rest
    return None


def find_combination(
    residual: sp.Expr, constraints: Sequence[sp.Expr], domain: Domain
) -> tuple[sp.Expr, ...] | None:
    """Return multipliers with which the constraints add up to the residual, proved on the domain.

    None if not found. The multipliers' divisors have no zero where the residual has a value.
    """
    total = residual.count_ops() + sum(one.count_ops() for one in constraints)
    if total > LARGEST:
        return None
    if numbers := _add_up(residual, constraints):
        return numbers
    tangents = _name_tangents((residual, *constraints))
    found = _find_multipliers(residual, constraints, {}, domain)
    if found is None and tangents:
        found = _find_multipliers(residual, constraints, tangents, domain)
    return found


def _find_multipliers(
    residual: sp.Expr,
    constraints: Sequence[sp.Expr],
    tangents: Mapping[sp.Expr, sp.Expr],
    domain: Domain,
) -> tuple[sp.Expr, ...] | None:
    """Return multipliers as `find_combination` does, with `tangents` replaced by symbols."""
    plain = (one.xreplace(tangents) for one in (residual, *constraints))
    (above, below), *others = map(_to_fraction, plain)
    names = _name_functions((above, *(one for one, _ in others)))
    polynomials = [e.xreplace(names) for e in (above, *(one for one, _ in others))]
    found = _combine(polynomials[0], polynomials[1:], [*_circles(names)])
    if found is None:
        return None
    back = {name: function for function, name in {**names, **tangents}.items()}
    multipliers = tuple(
        sp.cancel(multiplier.xreplace(back) * own_below / below)
        for multiplier, (_, own_below) in zip(found, others, strict=True)
    )
    total = sp.Add(*(m * c for m, c in zip(multipliers, constraints, strict=True)))
    answer = decide(Equality(residual, total), domain)
    is_shown = answer.verdict is Verdict.PROVED and _have_values(multipliers, residual, domain)
    return multipliers if is_shown else None


def _add_up(residual: sp.Expr, constraints: Sequence[sp.Expr]) -> tuple[sp.Expr, ...] | None:
    """Return numbers by which the constraints add up to the residual, term by term, or None."""
    terms = [sp.expand(one).as_coefficients_dict() for one in (residual, *constraints)]
    if not all(value.is_Rational for one in terms for value in one.values()):
        return None
    places: dict[sp.Expr, tuple[int, ...]] = {
        term: (n,) for n, term in enumerate(dict.fromkeys(t for one in terms for t in one))
    }
    wanted, *columns = [
        {places[t]: sp.QQ.from_sympy(value) for t, value in one.items()} for one in terms
    ]
    found = _solve(columns, wanted)
    return tuple(found) if found and any(found) else None


def list_factors(expression: sp.Expr) -> list[sp.Expr]:
    """Return the factors of an expression, each once and without numbers."""
    return [factor for factor, _ in sp.factor_list(expression)[1]]


def list_factors_below(expression: sp.Expr) -> list[sp.Expr]:
    """Return the factors of an expression's divisors; a tangent counts as divided by its cosine."""
    below = sp.Mul(*list_divisors(expression))
    if any(power.exp.could_extract_minus_sign() for power in below.atoms(sp.Pow)):
        # Divisors of fractions within the divisors are listed separately, so they are dropped here.
        below = sp.numer(sp.together(below))
    return list_factors(below)


def _list_written_out(factor: sp.Expr) -> list[sp.Expr]:
    """Return the factors of a factor after its tangents' cosines are multiplied out.

    The tangent of a sum is expanded by its sine and cosine, as the expansion in other tangents has
    poles of its own.
    """
    above = sp.numer(sp.together(_divide_tangents(factor)))
    return list_factors(sp.expand_trig(above))


def _have_values(multipliers: Sequence[sp.Expr], residual: sp.Expr, domain: Domain) -> bool:
    """Return whether multipliers have values wherever the residual has one."""
    own = {*list_factors_below(residual)}
    # Multipliers contain tangents, and sines of sums, in expanded form.
    own |= {factor for one in own for factor in _list_written_out(one)}
    own |= {-factor for factor in own}
    divisors = {factor for one in multipliers for factor in list_factors_below(one)} - own
    return all(is_nonzero(factor, domain) for factor in divisors)


def _combine(
    target: sp.Expr, parts: Sequence[sp.Expr], circles: Sequence[sp.Expr]
) -> list[sp.Expr] | None:
    """Return polynomials whose products with the parts add up to the target, modulo the circles.

    Coefficients must be rational, otherwise None is returned. pi counts as a letter: what holds for
    any letter holds for pi.
    """
    target, *others = (one.xreplace({sp.pi: _PI}) for one in (target, *parts, *circles))
    parts, circles = others[: len(parts)], others[len(parts) :]
    met = set().union(*(p.free_symbols for p in (target, *parts, *circles)))
    if not met:
        return None
    # In the ring's order a root must come before the letters under it.
    letters = sorted(met, key=lambda s: (not isinstance(s, sp.Dummy), str(s)))
    ring = PolyRing(letters, sp.QQ, lex)
    try:
        goal, *zeros = map(ring.from_expr, (target, *circles))
    except (ValueError, sp.CoercionFailed):
        return None
    sums = [_read_polynomial(one, ring) for one in parts]
    known = {ring.zero_monom, *(g.LM for g in ring.gens), *(m for one in sums for m in one)}
    factors = {sp.Mul(*map(sp.Pow, letters, monomial)): monomial for monomial in known}
    # Squares of constraints may only cancel by the relations of sines, cosines and roots.
    most = max([_degree(goal), *(2 * _degree(one) for one in sums if zeros)])
    products = [
        (n, factor)
        for n, one in enumerate(sums)
        for factor in sorted(factors, key=sp.default_sort_key)
        if sum(factors[factor]) + _degree(one) <= most
    ]
    if len(products) > MOST_PRODUCTS:
        return None
    # If a factor of the goal is a sum of such products, so is the goal.
    goals = dict.fromkeys((goal, *(factor for factor, _ in goal.factor_list()[1])))
    near = dict.fromkeys(pair for one in goals for pair in _list_near(one, sums))
    if len(products) + len(near) <= MOST_PRODUCTS:
        products += [(n, sp.Mul(*map(sp.Pow, letters, monomial))) for n, monomial in near]
        factors |= {sp.Mul(*map(sp.Pow, letters, monomial)): monomial for _, monomial in near}
    columns = [sums[n].mul_monom(factors[factor]).rem(zeros) for n, factor in products]
    for one in goals:
        solved = _solve(columns, one.rem(zeros))
        if solved is not None:
            rest = goal.quo(one).as_expr()
            found = (
                sp.Add(*(x * f for x, (m, f) in zip(solved, products, strict=True) if m == n))
                for n in range(len(parts))
            )
            return [(rest * multiplier).xreplace({_PI: sp.pi}) for multiplier in found]
    return None


def _list_near(
    goal: PolyElement, sums: Sequence[PolyElement]
) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Yield constraints with monomials whose products share terms with the goal.

    The terms of these products count as the goal's in a second round.
    """
    found: dict[tuple[int, tuple[int, ...]], None] = {}
    terms = {*goal}
    for _ in range(2):
        new = [
            (n, quotient)
            for n, one in enumerate(sums)
            for term in sorted(terms)
            for own in one
            if min(quotient := tuple(a - b for a, b in zip(term, own, strict=True))) >= 0
        ]
        terms = {monomial for n, quotient in new for monomial in sums[n].mul_monom(quotient)}
        found |= dict.fromkeys(new)
    yield from found


def _read_polynomial(expression: sp.Expr, ring: PolyRing) -> PolyElement:
    """Return a constraint as a polynomial, or zero (of no use) if it is none over the ring."""
    try:
        return ring.from_expr(expression)
    except (ValueError, sp.CoercionFailed):
        return ring.zero


def _degree(polynomial: PolyElement) -> int:
    return max((sum(monomial) for monomial in polynomial), default=0)


def _solve(
    columns: Sequence[Mapping[tuple[int, ...], Any]], wanted: Mapping[tuple[int, ...], Any]
) -> list[sp.Expr] | None:
    """Return coefficients with which the columns add up to `wanted`, or None if there are none."""
    places = {m: n for n, m in enumerate(sorted({*wanted, *(m for c in columns for m in c)}))}
    last, rows = len(columns), dict[int, dict[int, Any]]()
    for number, column in enumerate((*columns, wanted)):
        for monomial, value in column.items():
            rows.setdefault(places[monomial], {})[number] = value
    shape = (len(places), last + 1)
    reduced, pivots = DomainMatrix(rows, shape, sp.QQ).to_sparse().rref()
    if last in pivots:
        return None
    right = reduced.to_dok()
    values = {p: right.get((n, last), sp.QQ.zero) for n, p in enumerate(pivots)}
    return [sp.QQ.to_sympy(values.get(n, sp.QQ.zero)) for n in range(last)]


def _propose(residual: sp.Expr, constraint: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Yield candidates (m, r) with residual = m * constraint + r."""
    if constraint.is_number or residual.count_ops() + constraint.count_ops() > LARGEST:
        return
    (above, below), (own_above, own_below) = map(_to_fraction, (residual, constraint))
    if 0 in (above, own_above):
        return
    names = _name_functions((above, own_above))
    polynomials = [*(e.xreplace(names) for e in (above, own_above)), *_circles(names)]
    generators = sorted(set().union(*(p.free_symbols for p in polynomials)), key=str)
    back = {name: function for function, name in names.items()}
    for shared in dict.fromkeys((sp.S.One, _find_shared(polynomials[1]))):
        # An equation of motion is printed without the mass that is a factor of all its terms.
        own = sp.expand(polynomials[1] / shared)
        try:
            (first, *_), rest = sp.reduced(polynomials[0], [own, *polynomials[2:]], *generators)
        except (sp.PolynomialError, sp.CoercionFailed):
            return
        if rest.is_number and first != 0:
            yield sp.cancel((first / shared).xreplace(back) * own_below / below), rest / below


def _find_shared(polynomial: sp.Expr) -> sp.Expr:
    """Return the product of the letters that are factors of all terms."""
    factors = sp.Mul.make_args(sp.terms_gcd(polynomial))
    return sp.Mul(*(one for one in factors if not (one.is_Add or one.is_number)))


def _to_fraction(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    plain = sp.expand_trig(take_values(expression))
    above, below = sp.fraction(sp.together(_divide_tangents(plain)))
    return sp.expand(above), below


def _divide_tangents(expression: sp.Expr) -> sp.Expr:
    return expression.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle))


def _name_tangents(expressions: Sequence[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Return a symbol for each tangent of an angle whose sine and cosine do not occur."""
    angles = {f.args[0] for e in expressions for f in e.atoms(sp.sin, sp.cos)}
    met = {tangent for e in expressions for tangent in e.atoms(sp.tan)}
    alone = sorted((one for one in met if one.args[0] not in angles), key=str)
    return {one: sp.Dummy(f"tan{n}") for n, one in enumerate(alone)}


def _name_functions(expressions: Iterable[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Return symbols for the sines and cosines, square roots and powers of e that occur.

    Powers of e whose exponents are multiples of one expression are powers of one symbol.
    """
    expressions = [*expressions]
    angles = {f.args[0] for e in expressions for f in e.atoms(sp.sin, sp.cos)}
    powers = {f for e in expressions for f in e.atoms(sp.Pow) if f.exp.is_Rational and f.exp.q == 2}
    roots = {sp.sqrt(f.base) for f in powers if f.base.free_symbols}
    exponents = {f.args[0].primitive() for e in expressions for f in e.atoms(sp.exp)}
    bases = {rest: sp.Dummy(f"_exp{n}") for n, (_, rest) in enumerate(sorted(exponents, key=str))}
    least = {one: sp.gcd([number for number, rest in exponents if rest == one]) for one in bases}
    return {
        **{sp.exp(least[one] * one): base for one, base in bases.items()},
        **{sp.exp(n * one): bases[one] ** (n / least[one]) for n, one in exponents},
        **{root: sp.Dummy(f"_root{n}") for n, root in enumerate(sorted(roots, key=str))},
        **{
            f(angle): sp.Dummy(f"{f.__name__}{n}")
            for n, angle in enumerate(sorted(angles, key=str))
            for f in (sp.cos, sp.sin)
        },
    }


def _circles(names: Mapping[sp.Expr, sp.Expr]) -> Iterator[sp.Expr]:
    """Yield the relations, as zeros, between the symbols of sines, cosines and square roots."""
    for function, name in names.items():
        if isinstance(function, sp.cos):
            yield name**2 + names[sp.sin(function.args[0])] ** 2 - 1
        elif isinstance(function, sp.Pow):
            above, below = (part.xreplace(names) for part in _to_fraction(function.base))
            yield sp.expand(below * name**2 - above)
