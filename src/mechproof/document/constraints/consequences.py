"""What becomes of an equation beside the constraints of its paper, which are taken as given."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.constraints.combinations import (
    find_combination,
    find_multiple,
    list_factors_below,
)
from mechproof.document.constraints.witnesses import hold_together
from mechproof.document.tasks import Task
from mechproof.proof.ladder import decide
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality, Holds
from mechproof.statement_domains.domain import Domain

MULTIPLE = "multiple of a constraint"
COMBINATION = "combination of constraints"
SQUARE = "square of a root"
# How rows follow from constraints.
FOLLOWING = (MULTIPLE, COMBINATION, SQUARE)
GIVEN = "definition"
# What remains to be said where the square of a row follows.
ROOT = ", as the root is, is taken as given"


def find_consequence(task: Task, others: Sequence[Task]) -> tuple[Verdict, str, str] | None:
    """Judge a row by the constraints that it follows from, or cannot hold together with.

    Only constraints that hold together somewhere on the domain prove anything.
    """
    domain = Domain.of(task.paper, task.row.on)
    for other in others:
        name = other.row.number
        multiple = find_multiple(task.residual, other.residual, domain)
        if multiple is None:
            continue
        factor, rest = multiple
        reason = f"left - right is that of {_multiply(name, factor)}"
        if rest != 0:
            reason = f"cannot hold together with {name}: {reason}, plus {rest}"
            return Verdict.DEFINITION, GIVEN, reason
        if hold_together([other.residual], domain, list_factors_below(task.residual)):
            return Verdict.PROVED, MULTIPLE, f"follows from {name}, taken as given: {reason}"
    return _combine(task, others, domain) or _square(task, others, domain)


def _multiply(name: str, factor: sp.Expr) -> str:
    return name if factor == 1 else f"{name} times {factor}"


def list_letters(task: Task) -> set[sp.Basic]:
    """Return the letters of the residual of a row, or of the equations that it consists of."""
    if task.residual is not None:
        return set(task.residual.free_symbols)
    says, domain = task.row.says, Domain.of(task.paper, task.row.on)
    parts = says.parts if isinstance(says, Conjunction) else (says,)
    sides = [s for p in parts if isinstance(p, Equality) for s in (p.printed, p.rebuilt)]
    return {letter for side in sides for letter in domain.resolve(side).free_symbols}


def _combine(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    """Return that a row follows from several constraints, or from the derivative of some."""
    given = {other.row.number: other.residual for other in others}
    for known in (given, *_list_rates(task, others)):
        multipliers = find_combination(task.residual, list(known.values()), domain)
        used = {n: m for n, m in zip(known, multipliers or (), strict=False) if m != 0}
        divisors = list_factors_below(task.residual)
        if used and hold_together([known[name] for name in used], domain, divisors):
            parts = ", plus ".join(_multiply(name, m) for name, m in used.items())
            reason = f"follows from constraints, taken as given: left - right is {parts}"
            return Verdict.PROVED, COMBINATION, reason
    return _put_in(task, others, domain)


def _square(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    r"""Return that a row with a root follows by its square, where the root has the right sign.

    Where a + b\sqrt{c} is printed to be zero, a^2 = b^2 c, and a and b are not of one sign.
    """
    residual = sp.sympify(task.residual)
    roots = [power for power in residual.atoms(sp.Pow) if power.exp == sp.Rational(1, 2)]
    roots = [root for root in roots if root.free_symbols]
    if len(roots) != 1:
        return None
    (root,), name = roots, sp.Dummy()
    above = sp.expand(sp.numer(sp.together(residual.xreplace({root: name}))))
    rest, factor = (above.coeff(name, n) for n in range(2))
    if not factor or sp.expand(above - rest - factor * name) != 0:
        return None
    squared = replace(task, residual=rest**2 - factor**2 * root.base)
    found = find_consequence(squared, [o for o in others if not sp.sympify(o.residual).has(root)])
    if not found or found[0] is not Verdict.PROVED:
        return None
    sign = sp.cancel(-rest / factor)
    if decide(Holds(sp.Ge(sign, 0)), domain).verdict is Verdict.PROVED:
        return Verdict.PROVED, SQUARE, f"its square {found[2]}; the root has the right sign"
    reason = f"its square {found[2]}; that {sign} >= 0{ROOT}"
    return Verdict.DEFINITION, GIVEN, reason


def _put_in(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    """Return that a row is the derivative of one printed before, what others print put in.

    These hold only where they have values, so that no divisor of theirs is a matter.
    """
    letters = list_letters(task)
    rates = [
        (other, other.rates[0], letter)
        for other in others
        if other.rates
        for letter in other.rates[0].free_symbols & letters - list_letters(other)
    ]
    printed = [(other, other.residual, other.sign.letter) for other in others if other.sign.letter]
    rest, used = sp.sympify(task.residual), dict[str, sp.Expr]()
    for solved in (rates, printed):
        known = [(o, r, letter) for o, r, letter in solved if sp.diff(r, letter) == 1]
        used |= {other.row.number: other.residual for other, _, _ in known}
        rest = rest.xreplace({letter: sp.expand(letter - r) for _, r, letter in known})
        if not known or rest == task.residual:
            return None
    is_shown = decide(Equality(rest, sp.S.Zero), domain).verdict is Verdict.PROVED
    if not is_shown or not hold_together([*used.values()], domain, list_factors_below(rest)):
        return None
    reason = f"follows from {', '.join(used)}, taken as given, and from derivatives of these"
    return Verdict.PROVED, COMBINATION, reason


def _list_rates(task: Task, others: Sequence[Task]) -> Iterator[dict[str, sp.Expr]]:
    """Yield the first derivatives of constraints, and with them the second ones.

    First those of angles whose tangents are printed, without these: they need no other constraint.
    """
    tangents = {
        f"the derivative of {other.row.number}": other.rates[0].xreplace({tangent: value})
        for other in others
        if other.rates and (solved := _solve_for_tangent(other.residual))
        for tangent, value in [solved]
    }
    if tangents:
        yield tangents
    found: dict[str, sp.Expr] = {}
    for order, name in enumerate(("the derivative", "the second derivative")):
        new = {
            f"{name} of {other.row.number}": other.rates[order]
            for other in others
            if len(other.rates) > order
            and other.rates[order].free_symbols & list_letters(task) - list_letters(other)
        }
        if new:
            found |= new
            yield found


def _solve_for_tangent(residual: sp.Expr | None) -> tuple[sp.Expr, sp.Expr] | None:
    """Return a tangent that is printed alone on one side, and the other side, without its angle."""
    terms = sp.S.Zero if residual is None else residual
    for tangent in sorted(terms.atoms(sp.tan), key=str):
        factor = terms.as_coefficients_dict()[tangent]
        value = tangent - terms / factor if factor else tangent
        if not value.has(tangent.args[0]):
            return tangent, value
    return None
