"""A print or an expression with one thing changed is not accepted, unless it is still equal.

Equality is decided by numerics that share nothing with the ladder: SymPy's `evalf`.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import pytest
import sympy as sp
from derived import declared_paper_of, paper_of
from weights import first_of

from mechproof.latex import Reader
from mechproof.latex.expansion import read_row
from mechproof.latex.tokens import tokenize
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Equality, Holds, Paper, RecordError, Row
from mechproof.statement_domains.domain import Domain
from mechproof.tools.processes import WorkerError, run_tasks

SYSTEMS = (
    *("elliptic_planetary", "measurement", "oval_planetary"),
    *("tooth_thickness", "track_wheel", "wedge_linkage"),
)
COUNT = 6
SECONDS = 3.0
PROCESSES = 2
POINTS = 4
DIGITS = 40
# Two sides are equal if they agree in half of the digits that they are computed with.
EQUAL = sp.Float(10) ** (-DIGITS // 2)

SWAPS = {
    **{str(n): tuple(str(m) for m in range(10) if m != n) for n in range(10)},
    "+": ("-",),
    "-": ("+",),
    r"\sin": (r"\cos",),
    r"\cos": (r"\sin",),
    r"\tg": (r"\ctg", r"\arctg"),
    r"\arctg": (r"\tg",),
    r"\cdot": ("+", "-"),
    r"\sqrt": ("",),
    "^": ("_",),
    "'": ("",),
}


@dataclass(frozen=True)
class Changed:
    """A row with one thing changed; `what` shows it before and after."""

    system: str
    row: Row
    what: str


# What is changed -------------------------------------------------------------------------------


@lru_cache
def load(system: str) -> tuple[Paper, Paper]:
    """Return a paper as its module binds it, and the same paper with its prints read."""
    return declared_paper_of(system), paper_of(system)


def change_print(system: str, draw: random.Random) -> Changed | str:
    """Change one sign of a print; return a text that says why if that gives no changed row."""
    typed, paper = load(system)
    row = draw.choice([r for r in typed.rows if r.says is None])
    latex = _change_sign(row.printed_latex, paper, draw)
    reader = Reader(paper.variables, paper.notation)
    plain = replace(row, corrected=None, readings=(), holds_on=None)
    plain = replace(
        plain,
        links={
            number: replace(link, corrected=None, readings=(), holds_on=None)
            for number, link in plain.links.items()
        },
    )
    try:
        old = read_row(plain, reader)
        new = read_row(replace(plain, printed_latex=latex), reader)
    except ValueError:
        return "refused"
    differing = [
        b
        for a, b in zip(old, new, strict=False)
        if (a.statement, a.printed_latex) != (b.statement, b.printed_latex)
    ]
    if len(old) != len(new) or not differing:
        return "other signs" if len(old) != len(new) else "same print"
    changed = draw.choice(differing)
    before = old[new.index(changed)]
    if before.read_as == changed.read_as:
        return f"silent: {before.printed_latex} -> {changed.printed_latex}"
    return Changed(system, changed, f"{before.printed_latex} -> {changed.printed_latex}")


def _change_sign(latex: str, paper: Paper, draw: random.Random) -> str:
    """Replace one sign of a print by another legal one, or one letter by another."""
    names = [t for v in paper.variables for t in v.latex if "#" not in t]
    places = [t for t in tokenize(latex) if t.end > t.start]
    while True:
        token = draw.choice(places)
        swaps = SWAPS.get(token.text, ())
        found = [n for n in names if latex.startswith(n, token.start)]
        if found and draw.random() < 0.5:
            old = max(found, key=len)
            new = draw.choice([n for n in names if n != old])
            return f"{latex[: token.start]}{{{new}}}{latex[token.start + len(old) :]}"
        if swaps:
            new = draw.choice(swaps)
            blank = " " if new[-1:].isalpha() else ""
            return f"{latex[: token.start]}{new}{blank}{latex[token.end :]}"


def change_expression(system: str, draw: random.Random) -> Changed | str:
    """Change one node of the printed side of an equality; return a text if that gives no row."""
    _, paper = load(system)
    rows = [r for r in paper.rows if isinstance(r.says, Equality)]
    row = draw.choice(rows)
    says = row.statement
    assert isinstance(says, Equality)
    printed = says.printed
    if isinstance(printed, sp.MatrixBase):
        entries = [(i, j) for i in range(printed.rows) for j in range(printed.cols)]
        i, j = draw.choice(entries)
        changed = printed.as_mutable()
        changed[i, j] = _change_node(printed[i, j], draw)
        changed = changed.as_immutable()
    else:
        changed = _change_node(printed, draw)
    if changed == printed or changed.has(sp.nan, sp.zoo, sp.I):
        return "no change"
    try:
        new = replace(
            row,
            says=Equality(changed, says.rebuilt, says.rebuilt_from),
            corrected=None,
            readings=(),
            holds_on=None,
        )
    except RecordError:
        return "refused"
    return Changed(system, new, f"{row.number}: {printed} -> {changed}")


def _change_node(tree: sp.Basic, draw: random.Random) -> sp.Basic:
    node = draw.choice(list(_nodes(tree)))
    return tree.xreplace({node: draw.choice(list(_variants(node, tree, draw)))})


def _nodes(tree: sp.Basic) -> Iterator[sp.Expr]:
    """Yield the nodes of a tree, except bound symbols and the bases of families."""
    free = tree.free_symbols
    for node in sp.preorder_traversal(tree):
        is_bound = node.is_Symbol and node not in free
        is_label = isinstance(node, sp.IndexedBase) or node in {
            base.label for base in tree.atoms(sp.IndexedBase)
        }
        if isinstance(node, sp.Expr) and not is_bound and not is_label:
            yield node


def _variants(node: sp.Expr, tree: sp.Basic, draw: random.Random) -> Iterator[sp.Expr]:
    yield -node
    if node.is_Number:
        yield node + draw.choice((1, -1, 2))
    if node.is_Symbol:
        yield draw.choice([*sorted(tree.free_symbols, key=str), node + 1])
    if isinstance(node, sp.Add | sp.Mul):
        dropped = draw.randrange(len(node.args))
        yield node.func(*(a for k, a in enumerate(node.args) if k != dropped))
    if isinstance(node, sp.sin | sp.cos | sp.tan):
        yield draw.choice((sp.sin, sp.cos, sp.tan))(node.args[0])
    if isinstance(node, sp.Pow):
        yield node.base ** (node.exp + 1)


# How it is judged ------------------------------------------------------------------------------


def judge_changed(changed: Changed) -> tuple[Verdict | str, str]:
    """Return the verdict and, if it is PROVED, the answer of `compare_numbers`, else ""."""
    _, paper = load(changed.system)
    try:
        verdict = judge(changed.row, paper).verdict
    except RecordError:
        return "refused", ""
    if verdict is not Verdict.PROVED:
        return verdict, ""
    return verdict, compare_numbers(changed.row, paper)


def compare_numbers(row: Row, paper: Paper) -> str:
    """Return "equal", "different" or "unknown" for the sides of a row."""
    says = row.statement
    domain = Domain.of(paper, row.on)
    if isinstance(says, Holds):
        return _compare_sides(domain.resolve(says.relation), domain)
    if not isinstance(says, Equality):
        return "unknown"
    sides = [domain.resolve(side) for side in (says.printed, says.rebuilt)]
    if isinstance(sides[0], sp.MatrixBase):
        pairs = list(zip(sides[0], sides[1], strict=True))
    else:
        pairs = [(sides[0], sides[1])]
    found = [_compare_pair(left, right, domain) for left, right in pairs]
    return next((f for f in ("different", "unknown") if f in found), "equal")


def _compare_sides(relation: sp.Basic, domain: Domain) -> str:
    """Return "equal" for a relation that is true at points, "different" for one that is false."""
    sides = relation.args
    points = domain.points(sorted(relation.free_symbols, key=str), POINTS)
    values = [[side.subs(point).evalf(DIGITS) for side in sides] for point in points]
    kept = [pair for pair in values if all(value.is_finite for value in pair)]
    held = [bool(relation.func(*pair)) for pair in kept]
    return "unknown" if not held else "equal" if all(held) else "different"


def _compare_pair(left: sp.Expr, right: sp.Expr, domain: Domain) -> str:
    draw = random.Random(5)
    difference = left - right
    plain = {s for s in difference.free_symbols if isinstance(s, sp.Symbol)}
    labels = {b.label for b in difference.atoms(sp.IndexedBase)}
    points = domain.points(sorted(plain - labels, key=str), POINTS) if plain - labels else [{}]
    agreed = 0
    for point in points[:POINTS]:
        value = difference.subs(point).doit(integrals=False)
        elements = {e: sp.Rational(draw.randint(1, 999), 100) for e in value.atoms(sp.Indexed)}
        number = value.xreplace(elements).evalf(DIGITS, maxn=200)
        if not number.is_Number and not number.is_number:
            continue
        if not number.is_finite or abs(sp.im(number)) > EQUAL:
            continue
        if abs(number) > EQUAL:
            return "different"
        agreed += 1
    return "equal" if agreed else "unknown"


@dataclass(frozen=True)
class Task:
    """One change to try on a paper, with the seed of its random numbers."""

    change: Callable[[str, random.Random], Changed | str]
    system: str
    seed: str


def try_change(task: Task) -> tuple[str, str]:
    """Change a row and judge it; return the result, and a text about the change."""
    found = task.change(task.system, random.Random(task.seed))
    if isinstance(found, str):
        kind, _, what = found.partition(": ")
        return kind, f"{task.system} {what}"
    verdict, equal = judge_changed(found)
    return " ".join(filter(None, (str(verdict), equal))), f"{task.system} {found.what}"


def attack(change: Any, count: int, seed: int) -> dict[str, list[str]]:
    """Change `count` rows, of all papers in turn; return the changes, grouped by their results."""
    for system in SYSTEMS:
        load(system)
    tasks = [Task(change, SYSTEMS[k % len(SYSTEMS)], f"{seed} {k}") for k in range(count)]
    found: dict[str, list[str]] = {}
    for number, answer in run_tasks(try_change, tasks, limit=SECONDS, processes=PROCESSES):
        kind, what = ("error", "") if isinstance(answer, WorkerError) else answer
        found.setdefault(kind, []).append(what or f"{tasks[number].seed}: {answer}")
    return found


@pytest.mark.slow
@pytest.mark.parametrize("change", first_of([change_print, change_expression]))
def test_nothing_changed_is_accepted(change: Any) -> None:
    found = attack(change, COUNT * len(SYSTEMS), seed=20240611)
    for kind in ("silent", "PROVED different", "PROVED unknown"):
        assert found.get(kind, []) == []
    assert len(found["REFUTED"]) > len(found.get("PROVED equal", []))


def test_numbers_tell_equal_sides_from_different_ones() -> None:
    x = sp.Symbol("x", real=True)
    domain = Domain({}, (), {})
    assert _compare_pair(sp.sin(2 * x), 2 * sp.sin(x) * sp.cos(x), domain) == "equal"
    assert _compare_pair(sp.sin(2 * x), 2 * sp.sin(x) * sp.sin(x), domain) == "different"
    assert _compare_pair(sp.sqrt(-1 - x**2), sp.Integer(0), domain) == "unknown"
    assert _compare_sides(sp.Le(x, x + 1, evaluate=False), domain) == "equal"
    assert _compare_sides(sp.Le(x + 1, x, evaluate=False), domain) == "different"
