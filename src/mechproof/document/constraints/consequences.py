"""The consequences of a paper's constraints, taken as given, for another of its equations.

Words in the text say which constraints apply to a row, as far as they say it at all. A constraint
that makes letters equal at a special position lapses at the next words that say something new. A
constraint that is printed again with other signs, after other words, replaces the first print.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from mechproof.document.constraints.combinations import (
    find_combination,
    find_multiple,
    list_factors_below,
)
from mechproof.document.constraints.given_roots import put_in_roots
from mechproof.document.constraints.witnesses import hold_together
from mechproof.document.tasks import Task
from mechproof.latex.values import settle_all
from mechproof.proof.ladder import decide
from mechproof.proof.signs import is_positive
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Definition, Equality, Holds
from mechproof.record.parts import find_roots
from mechproof.statement_domains.domain import Domain

MULTIPLE = "multiple of a constraint"
COMBINATION = "combination of constraints"
SQUARE = "square of a root"
# Names of the rungs by which rows follow from constraints.
FOLLOWING = (MULTIPLE, COMBINATION, SQUARE)
GIVEN = "definition"
# Completes the reason of a row that follows by its square.
ROOT = ", like the root, is taken as given"


def find_consequence(task: Task, others: Sequence[Task]) -> tuple[Verdict, str, str] | None:
    """Judge a row by the constraints that it follows from, or cannot hold together with.

    A constraint proves something only if it holds at some point of the domain. Returns the verdict,
    the rung and the reason, or None.
    """
    domain = task.domain
    task, *others = (
        replace(one, residual=_split_roots(sp.sympify(one.residual), domain))
        for one in (task, *others)
    )
    for other in others:
        name = other.row.number
        multiple = find_multiple(task.residual, other.residual, domain)
        if multiple is None:
            continue
        factor, rest = multiple
        reason = f"left - right equals that of {_multiply(name, factor)}"
        if rest != 0:
            reason = f"cannot hold together with {name}: {reason}, plus {rest}"
            return Verdict.DEFINITION, GIVEN, reason
        if hold_together([other.residual], domain, list_factors_below(task.residual)):
            return Verdict.PROVED, MULTIPLE, f"follows from {name}, taken as given: {reason}"
    found = _combine(task, others, domain) or _square(task, others, domain)
    return found or _put_in_roots(task, others, domain)


def _split_roots(value: sp.Expr, domain: Domain) -> sp.Expr:
    r"""Write roots of products by roots of positive letters, so that \sqrt{km}\sqrt{k/m} is k."""
    letters = {s for root in find_roots(value) for s in root.free_symbols}
    names = {s: sp.Dummy(str(s), positive=True) for s in letters if is_positive(s, domain)}
    return value.xreplace(names).xreplace({name: s for s, name in names.items()})


def _multiply(name: str, factor: sp.Expr) -> str:
    return name if factor == 1 else f"{name} times {factor}"


def list_letters(task: Task) -> set[sp.Basic]:
    """Return the letters of a row's residual, or of the equations that it consists of."""
    if task.residual is not None:
        return set(task.residual.free_symbols)
    says, domain = task.row.says, task.domain
    parts = says.parts if isinstance(says, Conjunction) else (says,)
    sides = [s for p in parts if isinstance(p, Equality) for s in p.sides]
    return {letter for side in sides for letter in domain.resolve(side).free_symbols}


def _combine(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    """Judge whether a row follows from several constraints, or from their derivatives."""
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
    r"""Judge whether a row with a root follows by its square, the root having the right sign.

    a + b\sqrt{c} = 0 holds where a^2 = b^2 c and -a/b is not negative.
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
    reason = f"its square {found[2]}; {sign} >= 0{ROOT}"
    return Verdict.DEFINITION, GIVEN, reason


def _put_in_roots(
    task: Task, others: Sequence[Task], domain: Domain
) -> tuple[Verdict, str, str] | None:
    """Judge whether a row follows once its roots have the values that constraints give them."""
    given = {o.row.number: o.residual for o in others if o.residual is not None}
    rest, used = put_in_roots(sp.sympify(task.residual), given)
    if not used or not hold_together([*used.values()], domain, list_factors_below(rest)):
        return None
    if decide(Equality(rest, sp.S.Zero), domain).verdict is not Verdict.PROVED:
        found = find_consequence(replace(task, residual=rest), others)
        if not found or found[0] is not Verdict.PROVED:
            return None
        used = {name: one for name, one in given.items() if name in used or name in found[2]}
    said = f"follows from {', '.join(used)}, taken as given: roots in it are numbers there"
    return Verdict.PROVED, COMBINATION, said


def _put_in(task: Task, others: Sequence[Task], domain: Domain) -> tuple[Verdict, str, str] | None:
    """Judge whether a row is the derivative of an earlier print after substituting other prints.

    These hold only where they have values, so their divisors need no check.
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
    reason = f"follows from {', '.join(used)}, taken as given, and from their derivatives"
    return Verdict.PROVED, COMBINATION, reason


def _list_rates(task: Task, others: Sequence[Task]) -> Iterator[dict[str, sp.Expr]]:
    """Yield sets of derivatives of constraints: the first, then the first and the second.

    First come those of tangents printed alone, each with its tangent replaced by the printed value:
    these need no other constraint.
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


def list_applicable(given: Sequence[int], number: int, tasks: Sequence[Task]) -> list[int]:
    """Return the numbers of the constraints printed before a row that hold for it."""
    task = tasks[number]
    before = [g for g in given if g < number and may_hold_for(tasks[g], task)]
    before = [g for g in before if not is_left(tasks[g], task)]
    return _leave_out_restated(before, tasks)


def state_at(given: Sequence[Task], task: Task) -> Iterator[Task]:
    """Yield constraints at the values that the row's text states for letters.

    Constraints under a condition that the row does not have are left out.
    """
    for one in given:
        if one.residual is not None and _list_conditions(one) <= _list_conditions(task):
            rests = (sp.sympify(rest) for rest in (one.residual, *one.rates))
            residual, *rates = (settle_all(rest, task.at) for rest in rests)
            if not residual.has(sp.nan, sp.zoo, sp.oo) and sp.expand(residual) != 0:
                yield replace(one, residual=residual, rates=tuple(rates))


def _list_conditions(task: Task) -> set[object]:
    on, said = task.row.on, {sp.Eq(*one, evaluate=False) for one in task.at.items()}
    return {*said, *on.where, *on.within.items()} if on else {*said}


def is_turned(one: Task, other: Task) -> bool:
    """Return whether words between two rows reverse the sense in which something is counted."""
    return one.said.turns != other.said.turns


def may_hold_for(given: Task, task: Task) -> bool:
    """Return whether a constraint is about the same thing as a row, as far as the words show.

    A special position ends at the next passage that says something new.
    """
    is_special = given.said.is_equating or task.said.is_general
    is_left = given.said.is_position or (is_special and is_plain(given))
    is_left &= given.said.scope != task.said.scope
    return not (is_left or is_turned(given, task) or is_of_another_example(given, task))


def is_of_another_example(one: Task, other: Task) -> bool:
    """Return whether `one` is printed in a worked example that `other` is not part of."""
    return one.said.example.number not in (0, other.said.example.number)


def holds_elsewhere(one: Task, other: Task) -> bool:
    """Return whether `one` gives its letter a value only in an example that `other` is not in."""
    given = (v.given for v in other.paper.variables if v.symbol == one.sign.letter)
    return is_of_another_example(one, other) and not any(value is not None for value in given)


def is_left(given: Task, task: Task) -> bool:
    """Return whether letters made equal may differ after the next words that say something new."""
    return is_bare(given) and given.said.scope != task.said.scope


def is_bare(task: Task) -> bool:
    """Return whether a row only makes letters of one meaning equal, or a letter a number.

    Letters declared on one line have one meaning. Letters of two lines are equal by a law.
    """
    says = task.row.says
    one, other = (says.symbol, says.printed) if isinstance(says, Definition) else task.sign.sides
    meanings = {v.symbol: v.meaning for v in task.paper.variables}
    own = meanings.get(_find_letter(one)) or meanings.get(_find_letter(other))
    return bool(own) and all(
        isinstance(side, sp.Expr) and (side.is_number or meanings.get(_find_letter(side)) == own)
        for side in (one, other)
    )


def _find_letter(side: sp.Basic | None) -> sp.Basic | None:
    """Return the letter that a side is, or is the negative of; None for any other side."""
    if not isinstance(side, sp.Expr):
        return None
    return next((one for one in (side, -side) if one.is_Symbol), None)


def _leave_out_restated(given: Sequence[int], tasks: Sequence[Task]) -> list[int]:
    """Leave out constraints that are printed again after other words, with other signs."""
    terms = [_list_terms(tasks[g]) for g in given]
    return [
        g
        for place, g in enumerate(given)
        if not any(
            terms[place] == own and tasks[g].said.passage != tasks[later].said.passage
            for later, own in zip(given[place + 1 :], terms[place + 1 :], strict=True)
        )
    ]


def _list_terms(task: Task) -> frozenset[sp.Expr]:
    """Return the terms of a constraint without their signs."""
    terms = sp.Add.make_args(task.residual)
    return frozenset(-t if t.could_extract_minus_sign() else t for t in terms)


def is_plain(task: Task) -> bool:
    """Return whether a constraint equates sums of letters and numbers, as a = b + pi does.

    Both sides may have been multiplied or divided by letters.
    """
    one, other = task.sign.sides
    is_printed = isinstance(one, sp.Expr) and isinstance(other, sp.Expr)
    above, _ = sp.fraction(sp.together(one - other if is_printed else task.residual))
    factors = (f.as_base_exp()[0] for f in sp.Mul.make_args(sp.factor_terms(above)))
    terms = (term for factor in factors for term in sp.Add.make_args(factor))
    return all(term.as_coeff_Mul()[1].is_Symbol or term.is_number for term in terms)
