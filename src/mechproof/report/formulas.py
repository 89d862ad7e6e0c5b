"""Formulas: takes LaTeX or a quantity, returns MathML or a sentence; no input is trusted."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import sympy as sp
from markupsafe import Markup, escape

from mechproof.codegen.docstrings import find_given
from mechproof.latex.sentences import is_sentence, list_parts, walk_outside
from mechproof.proof.comparison_latex import write_latex, write_letter
from mechproof.record import Paper, PublishedSizes, Quantity, Toleranced
from mechproof.report.breaks import WIDE, write_broken
from mechproof.report.mathml import FORMULAS, MARKS, read_text, write_formula
from mechproof.report.phrases import set_prose

# Length in letters above which formulas within a sentence are broken at their commas.
LONG = 40
COMMA = re.compile(r",(?:\s|\\[ ,;]|~)*")
GAP = re.compile(r",\s*\\q?quad\s*")
# Matches words that a finding marks within a sentence.
MARKED = re.compile(r"\{\\color\{(red|green)\}\{(.*)\}\}", re.DOTALL)


def write_print(latex: str) -> Markup:
    """Write a print of a paper: as a paragraph if it contains words, otherwise as formulas."""
    if not latex:
        return Markup("")
    if is_sentence(latex):
        return Markup('<p class="sentence">{}</p>').format(write_sentence(latex))
    return Markup("").join(map(write_block, _split(latex, GAP)))


def write_block(latex: str) -> Markup:
    """Write a formula on lines of its own, with its width, by which the stylesheet scales it."""
    return Markup(FORMULAS.find(latex, "lines", _write_lines))


def _write_lines(latex: str, _: str) -> str:
    pieces, width, folded = write_broken(write_formula(latex, "block"), "block")
    narrow = f";--folded:{folded:.0f}" if round(folded) < round(width) else ""
    written = Markup('<div class="formula" style="--signs:{:.0f}{}">{}</div>')
    return written.format(width, narrow, pieces)


def write_lines(latex: str) -> Markup:
    """Write different formulas, each on a line of its own, or as a sentence if it has words."""
    return Markup("").join(map(write_print, dict.fromkeys(_split(latex, GAP))))


def write_sentence(latex: str) -> Markup:
    """Write words as words, and the formulas between them as formulas."""
    parts = (
        Markup(escape(_set_words(part))) if is_text else _write_within(part)
        for is_text, part in list_parts(latex)
    )
    return Markup("").join(parts)


def _set_words(words: str) -> str:
    """Read words; ties a percent sign to its number and joins (1)-(3) with a dash."""
    told = read_text(words).replace(" %", "\N{NO-BREAK SPACE}%")
    return told.replace(")-(", ")\N{EN DASH}(")


def _write_within(latex: str) -> Markup:
    marked = MARKED.fullmatch(latex)
    if marked and r"\text" in latex and len(list(walk_outside(latex))) == 1:
        written = Markup('<span class="{}">{}</span>')
        return written.format(MARKS[marked[1]], write_sentence(marked[2]))
    if latex.startswith(","):
        return Markup(",") + _write_within(latex[1:])
    before = " " if re.match(r"\s|\\[ ,;]|~", latex) else ""
    bare = re.sub(r"^(?:\s|\\[ ,;]|~)+|(?:\s|\\[ ,;]|~)+$", "", latex)
    parts = list(_split(bare, COMMA)) if len(bare) > LONG else [bare]
    shown = list(map(_write_inline, filter(None, parts)))
    # Each comma is tied to its formula, so that no line begins with one.
    tied = (Markup('<span class="tied">{},</span> ').format(formula) for formula in shown[:-1])
    return before + Markup("").join((*tied, *shown[-1:]))


def _write_inline(latex: str) -> Markup:
    """Write a formula within a sentence; one that cannot be broken scrolls in a box of its own."""
    math = write_formula(latex, "inline")
    if len(latex) <= LONG:
        return math
    pieces, width, _ = write_broken(math, "inline")
    return Markup('<span class="long">{}</span>').format(pieces) if width > WIDE else pieces


def _split(latex: str, gap: re.Pattern[str]) -> Iterator[str]:
    outside = set(walk_outside(latex))
    places = [m.span() for m in gap.finditer(latex) if m.start() in outside]
    edges = [0, *(edge for span in places for edge in span), len(latex)]
    return (latex[low:high] for low, high in zip(edges[::2], edges[1::2], strict=True))


def write_definition(quantity: Quantity, paper: Paper) -> Markup:
    """Write the formula of a quantity after the letter that it defines, or the function's name."""
    definition, given = quantity.definition, paper.given
    printed = {v.symbol for v in paper.variables if v.latex}
    names = [s for s, value in given.items() if value == definition and s in printed]
    if definition in given:
        names = [definition] if definition in printed else names
        definition = given[definition]
    arguments = ",".join(
        write_letter(symbol, paper.variables, [quantity.definition])
        for a in quantity.arguments
        for symbol in a.symbols
    )
    name = quantity.name.replace("_", r"\_")
    left = write_latex(names[0], paper.variables) if names else rf"\mathrm{{{name}}}({arguments})"
    return write_lines(f"{left}={write_latex(_take_in(definition), paper.variables)}")


def _take_in(formula: sp.Basic) -> sp.Basic:
    """Move exponentials in front of integrals inside them, where they may cancel."""
    return formula.replace(
        lambda part: part.is_Mul and any(isinstance(f, sp.Integral) for f in part.args), _join
    )


def _join(product: sp.Mul) -> sp.Expr:
    factors = product.args
    (integral,) = (f for f in factors if isinstance(f, sp.Integral))
    taken = sp.Mul(*(f for f in factors if isinstance(f, sp.exp)))
    others = sp.Mul(*(f for f in factors if not isinstance(f, sp.exp | sp.Integral)))
    joined = sp.powsimp(taken * integral.function, combine="exp")
    return others * sp.Integral(joined, *integral.limits)


def write_given(quantity: Quantity, paper: Paper) -> Iterator[Markup]:
    """Write the definitions of the symbols that the formula uses."""
    for symbol in find_given(quantity.definition, quantity, paper):
        sides = (write_latex(side, paper.variables) for side in (symbol, paper.given[symbol]))
        yield write_block(" = ".join(sides))


# The turn for which the stated bound of a position is given in radians, and the number of places
# tried in it.
TURNS, PLACES = 10, 360


def goes_on(quantity: Quantity) -> bool:
    """Return whether a quantity is a position that increases from turn to turn."""
    running = quantity.arguments[0]
    return quantity.period is not None and quantity.unit == running.unit == "rad"


def describe_turned(quantity: Quantity, paper: Paper) -> Markup:
    """Return the stated bound of a position in its tenth turn in radians, at published sizes."""
    if quantity.accuracy is None or not goes_on(quantity):
        return Markup()
    scale = quantity.accuracy.scale
    size = scale.written_out() if scale else sp.Abs(quantity.definition)
    for symbol, value in reversed(paper.given.items()):
        size = size.xreplace({symbol: value})
    errors = {
        table.source: quantity.accuracy.ulp * 2.0**-52 * largest
        for table in paper.published
        if (largest := _find_largest(size, quantity, table)) is not None
    }
    if not errors:
        return Markup()
    label = max(errors, key=lambda name: errors[name])
    return set_prose(f"in the tenth turn at most {errors[label]:.1e} rad, at the sizes of {label}")


def _find_largest(size: sp.Expr, quantity: Quantity, table: PublishedSizes) -> float | None:
    """Return the largest value in the tenth turn; None if a size or a function is missing."""
    running, *others = quantity.arguments
    sizes = {a.symbols[0]: table.sizes.get(a.symbols[0], a.default) for a in others}
    if any(value is None or isinstance(value, Toleranced) for value in sizes.values()):
        return None
    exact = {symbol: sp.sympify(given) for symbol, given in sizes.items()}
    value = sp.lambdify(running.symbols[0], size.xreplace(exact), "math")
    turns = (TURNS - 1 + place / PLACES for place in range(1, PLACES + 1))
    try:
        return max(float(value(2 * math.pi * turn)) for turn in turns)
    except (ArithmeticError, NameError, TypeError, ValueError):
        return None
