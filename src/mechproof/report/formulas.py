"""Formulas: the LaTeX of a paper in, MathML or a sentence out; nothing in it is trusted."""

from __future__ import annotations

import re
from collections.abc import Iterator

from markupsafe import Markup, escape

from mechproof.latex.sentences import is_sentence, list_parts, walk_outside
from mechproof.report.breaks import WIDE, write_broken
from mechproof.report.kept_formulas import FORMULAS
from mechproof.report.mathml import MARKS, read_text, write_formula

# Formulas within words are broken at their commas if they have more letters than a line.
LONG = 40
COMMA = re.compile(r",(?:\s|\\[ ,;]|~)*")
GAP = re.compile(r",\s*\\q?quad\s*")
# Words that a finding marks within a sentence.
MARKED = re.compile(r"\{\\color\{(red|green)\}\{(.*)\}\}", re.DOTALL)


def write_print(latex: str) -> Markup:
    """Write what a paper prints: a paragraph where it has words, else formulas on their own."""
    if not latex:
        return Markup("")
    if is_sentence(latex):
        return Markup('<p class="sentence">{}</p>').format(write_sentence(latex))
    return Markup("").join(map(write_block, _split(latex, GAP)))


def write_block(latex: str) -> Markup:
    """Write a formula on lines of its own; its widest piece says how small it has to be set."""
    return Markup(FORMULAS.find(latex, "lines", _write_lines))


def _write_lines(latex: str, _: str) -> str:
    pieces, width, folded = write_broken(write_formula(latex, "block"), "block")
    narrow = f";--folded:{folded:.0f}" if round(folded) < round(width) else ""
    written = Markup('<div class="formula" style="--signs:{:.0f}{}">{}</div>')
    return written.format(width, narrow, pieces)


def write_lines(latex: str) -> Markup:
    """Write different formulas, each on a line of its own: as a sentence where it has words."""
    return Markup("").join(map(write_print, dict.fromkeys(_split(latex, GAP))))


def write_sentence(latex: str) -> Markup:
    """Write words as words, and the formulas between them as such."""
    parts = (
        Markup(escape(_set_words(part))) if is_text else _write_within(part)
        for is_text, part in list_parts(latex)
    )
    return Markup("").join(parts)


def _set_words(words: str) -> str:
    """Read words; no line begins with the sign of a percentage, (1)-(3) has a dash."""
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
    # A line does not begin with a comma.
    tied = (Markup('<span class="tied">{},</span> ').format(formula) for formula in shown[:-1])
    return before + Markup("").join((*tied, *shown[-1:]))


def _write_inline(latex: str) -> Markup:
    """Write a formula within words; what cannot be broken scrolls in a box of its own."""
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
