"""Many generated, slightly wrong neighbours of the proved formulas of the five papers.

Every mutant of a printed or rebuilt side is compared with the other side by balls. A mutant
that balls separate must not be PROVED; one that they do not separate counts as an equivalent
mutant, of which there must be few.
"""

from functools import cache
from itertools import chain, islice, pairwise

import pytest
import sympy as sp
from derived import paper_of
from weights import first_of

from mechproof.derivations.track_wheel.mechanics import i, j
from mechproof.proof.continuity import find_break
from mechproof.proof.ladder import decide
from mechproof.proof.refutation import compare
from mechproof.proof.verdict import Verdict
from mechproof.record import Conjunction, Equality, IntegralWithoutDifferential
from mechproof.statement_domains.domain import Domain

# The first batch runs each time, the others only with the thorough tests.
BATCHES = 24
ENTRIES, PER_SIDE = 2, 3
LEAST, LEAST_ROWS = 600, 120
# In the longer derivations, larger statements and those with integrals take seconds each.
MOST_OPERATIONS = 120
# In a batch of some twenty: swaps of symmetric letters, changes of terms that cancel.
MOST_EQUIVALENT = 4
SHORT = ("elliptic_planetary", "track_wheel")
LONG = ("oval_planetary", "tooth_thickness", "wedge_linkage")
SWAPPED = {sp.sin: sp.cos, sp.cos: sp.sin, sp.tan: sp.cot, sp.atan: sp.tan}
# Rows whose cross-examination integrates over many turns: seconds for each mutant.
SLOW = (
    "(9)",
    "(10), first equals sign",
    "(10), second equals sign",
    "(12)",
    "(3)",
    "(4)",
    "(12) gives the position function",
    "Fig. 3, formula used",
    "(11) over all turns",
)
# Rows whose mutants also take seconds: they are kept out of the first batch.
DEAR = ("wedge_linkage chain, velocity", "elliptic_planetary jerk, largest before half a turn")


def replace_at(node, change):
    """Yield the copies of `node` in which `change` alters one subexpression, outermost first."""
    for changed in change(node):
        if changed != node:
            yield changed
    for place, argument in enumerate(node.args):
        if isinstance(argument, sp.Expr):
            for changed in replace_at(argument, change):
                arguments = (*node.args[:place], changed, *node.args[place + 1 :])
                yield node.func(*arguments)


def flip_a_sign(node):
    if node.is_Add:
        yield from (node - 2 * term for term in node.args)


def drop_a_term(node):
    if node.is_Add:
        yield from (node - term for term in node.args)


def double_or_halve(node):
    if isinstance(node, sp.Symbol | sp.Indexed | sp.Function | sp.Sum | sp.Integral):
        yield from (2 * node, node / 2)


def swap_a_function(node):
    if node.func in SWAPPED:
        yield SWAPPED[node.func](*node.args)


def change_an_exponent(node):
    if node.is_Pow and node.exp.is_Rational:
        yield from (node.base ** (node.exp + 1), node.base ** (node.exp - 1))


def lose_a_root(node):
    if node.is_Pow and node.exp == sp.S.Half:
        yield node.base


def swap_two_indices(node):
    if isinstance(node, sp.Indexed) and len(node.indices) == 1:
        others = [s for s in (i, j) if s not in node.indices]
        yield from (node.base[other] for other in others)


def swap_two_symbols(expression):
    names = sorted(
        (s for s in expression.free_symbols if s.is_Symbol and not s.is_integer), key=str
    )
    for one, two in pairwise(names):
        yield expression.subs({one: two, two: one}, simultaneous=True)


def add_a_constant(expression):
    yield expression + sp.Rational(1, 1000)


def let_it_jump(expression):
    for symbol in sorted((s for s in expression.free_symbols if s.is_Symbol), key=str)[:1]:
        yield expression + sp.floor(symbol / 3 + sp.Rational(1, 7))


LOCAL = (
    flip_a_sign,
    swap_a_function,
    double_or_halve,
    change_an_exponent,
    lose_a_root,
    swap_two_indices,
    drop_a_term,
)
WHOLE = (add_a_constant, let_it_jump, swap_two_symbols)


def mutate(expression):
    """Yield distinct mutants, one of each kind of mutation in turn."""
    kinds = [replace_at(expression, change) for change in LOCAL]
    kinds += [change(expression) for change in WHOLE]
    seen = {expression}
    while kinds:
        for kind in list(kinds):
            mutant = next(kind, None)
            if mutant is None:
                kinds.remove(kind)
            elif mutant not in seen and not mutant.has(sp.nan, sp.zoo):
                seen.add(mutant)
                yield mutant


def entries(statement):
    """Yield the scalar equalities of a statement; of a matrix equality, the first three entries."""
    if isinstance(statement, Conjunction):
        for part in statement.parts:
            yield from entries(part)
    elif isinstance(statement, Equality) and hasattr(statement.printed, "shape"):
        pairs = zip(statement.printed, statement.rebuilt, strict=True)
        yield from islice((Equality(*pair) for pair in pairs if pair[0] != 0), 3)
    elif isinstance(statement, Equality) and not statement.printed.has(IntegralWithoutDifferential):
        yield statement


def mutants_of(paper):
    """Yield (name, mutant, other side, domain) for the correct equalities of each row."""
    for row in paper.rows:
        if row.number in SLOW:
            continue
        right = row.corrected.says if row.corrected else row.says
        domain = Domain.of(paper, row.on)
        for equality in islice(entries(right), ENTRIES):
            printed, rebuilt = map(domain.resolve, (equality.printed, equality.rebuilt))
            if paper.system in LONG and not is_cheap(printed - rebuilt):
                continue
            for side, other in ((printed, rebuilt), (rebuilt, printed)):
                sound = (mutant for mutant in mutate(side) if has_proper_integrals(mutant, domain))
                for mutant in islice(sound, PER_SIDE):
                    yield f"{paper.system} {row.number}", mutant, other, domain


def is_cheap(difference):
    """Return whether mutants of this difference are decided in a fraction of a second."""
    return not difference.has(sp.Integral) and difference.count_ops() <= MOST_OPERATIONS


def has_proper_integrals(mutant, domain):
    """Return whether no integral runs over a break, where balls take seconds to find no value."""
    return all(
        find_break(node.function, node.limits[0][0], domain) is None
        for node in mutant.atoms(sp.Integral)
    )


@cache
def collect_mutants():
    return tuple(chain.from_iterable(map(mutants_of, map(paper_of, SHORT + LONG))))


def list_batches():
    """Distribute the mutants in batches; the first, which always runs, gets no slow ones."""
    batches = [[] for _ in range(BATCHES)]
    for number, mutant in enumerate(collect_mutants()):
        batch = number % BATCHES
        batches[batch or int(mutant[0] in DEAR)].append(mutant)
    return batches


@pytest.mark.slow
@pytest.mark.parametrize("batch", first_of(range(BATCHES)))
def test_no_wrong_neighbour_is_proved(batch):
    equivalent = []
    for name, mutant, other, domain in list_batches()[batch]:
        answer = decide(Equality(mutant, other), domain)
        if answer.verdict is Verdict.REFUTED:
            continue
        equivalent.append(f"{name}: {mutant} = {other}: {answer.verdict}")
        if answer.verdict is Verdict.PROVED:
            assert compare(mutant, other, domain).counterexample is None, equivalent[-1]
    assert len(equivalent) <= MOST_EQUIVALENT, equivalent


@pytest.mark.slow
def test_there_are_many_mutants():
    assert len(collect_mutants()) >= LEAST
    assert len({name for name, *_ in collect_mutants()}) >= LEAST_ROWS
