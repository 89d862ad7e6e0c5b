"""Generated expressions survive printing and reading; a changed character changes the reading."""

from __future__ import annotations

import random
from functools import lru_cache

import pytest
import sympy as sp
from derived import paper_of

from mechproof.latex import Reader, ReadingError
from mechproof.record import Notation, Paper, Row, Variable

COUNT = 200
x, y, z = SYMBOLS = tuple(sp.Symbol(name, real=True) for name in ("x", "y", "z"))
PRINTED = {x: "x", y: r"\varphi_{3}'", z: r"l_{AB}"}
VARIABLES = tuple(Variable(s, "", latex=(latex,)) for s, latex in PRINTED.items())
READER = Reader(VARIABLES, Notation(factors=tuple(PRINTED.values())))
FUNCTIONS = (sp.sin, sp.cos, sp.tan, sp.atan, sp.exp, sp.log, sp.Abs, sp.asin)
# Papers do not print SymPy's names of the inverse functions.
SPELLING = {"inv_trig_style": "full", "ln_notation": True, "symbol_names": PRINTED}


def generate(draw: random.Random, depth: int) -> sp.Expr:
    if depth == 0:
        number = sp.Rational(draw.randint(-9, 9), draw.randint(1, 5))
        return draw.choice([*SYMBOLS, *SYMBOLS, number])
    parts = [generate(draw, depth - 1) for _ in range(2)]
    kind = draw.randrange(6)
    if kind == 0:
        return parts[0] + parts[1]
    if kind == 1:
        return parts[0] * parts[1]
    if kind == 2:
        return parts[0] - parts[1]
    if kind == 3:
        return parts[0] / (parts[1] if parts[1] != 0 else x)
    if kind == 4:
        return parts[0] ** draw.choice([2, 3, sp.S.Half]) if parts[0] != 0 else x
    return draw.choice(FUNCTIONS)(parts[0])


@lru_cache
def generated() -> tuple[sp.Expr, ...]:
    draw = random.Random(20240607)
    found: dict[sp.Expr, None] = {}
    while len(found) < COUNT:
        expression = generate(draw, draw.randint(1, 4))
        parts = sp.preorder_traversal(expression)
        has_value = not expression.has(sp.nan, sp.zoo, sp.oo, sp.I, sp.AccumBounds) and not any(
            part.is_extended_real is False for part in parts
        )
        # SymPy prints the power of a logarithm after its argument, which is refused.
        powers = [p for p in expression.atoms(sp.Pow) if p.base.func is sp.log and p.exp != -1]
        if has_value and not powers:
            found[expression] = None
    return tuple(found)


def read(latex: str) -> sp.Expr:
    found = READER.parse(latex)
    return found.meaning().of(found.chains[0].members[0])


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(4))
def test_a_printed_expression_is_read_as_it_was(batch: int) -> None:
    for expression in generated()[batch::4]:
        latex = sp.latex(expression, **SPELLING).replace("e^{", r"\mathrm{e}^{")
        found = read(latex)
        # SymPy distributes numbers over sums when it builds products: the value is the same.
        assert found == expression or sp.expand(found - expression) == 0, latex
        again = sp.latex(found, **SPELLING).replace("e^{", r"\mathrm{e}^{")
        assert read(again) == found


# Changed characters -----------------------------------------------------------------------------

CHANGES = {
    **{str(n): str((n + 1) % 10) for n in range(10)},
    **{"+": "-", "-": "+", "=": "<", "(": ")", ")": "(", "{": "}", "}": "{", "_": "^", "^": "_"},
    **{"a": "e", "e": "a", "x": "e", "R": "a", "C": "x", "q": "n", "n": "q", "k": "n", "d": "x"},
    # A t is not changed into an s: \sfrac prints the same fraction as \tfrac.
    **{"s": "c", "c": "s", "t": "r", "i": "o", "o": "i", "g": "n", "'": "2", "V": "R", "A": "B"},
}
SYSTEMS = ("elliptic_planetary", "measurement")


@lru_cache
def prints(system: str) -> tuple[Paper, tuple[Row, ...]]:
    paper = paper_of(system)
    return paper, tuple(row for row in paper.rows if row.read_as)


@pytest.mark.slow
@pytest.mark.parametrize("system", SYSTEMS)
def test_a_changed_character_changes_what_is_read(system: str) -> None:
    paper, rows = prints(system)
    reader = Reader(paper.variables, paper.notation)
    changed = silent = 0
    for row in rows:
        right = members(reader, row.printed_latex, row.number)
        for place, sign in enumerate(row.printed_latex):
            if sign not in CHANGES:
                continue
            latex = row.printed_latex[:place] + CHANGES[sign] + row.printed_latex[place + 1 :]
            changed += 1
            silent += members(reader, latex, row.number) == right
    assert changed > 40
    assert silent == 0


def members(reader: Reader, latex: str, row: str) -> tuple[object, ...] | str:
    try:
        read = reader.parse(latex, row)
        meaning = read.meaning()
        found = tuple(meaning.of(member) for chain in read.chains for member in chain.members)
        return (*found, *(chain.relations for chain in read.chains))
    except ReadingError:
        return "refused"
