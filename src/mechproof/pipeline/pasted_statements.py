"""A pasted print -> its statement, without what stands around it, and where that is meant."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from mechproof.latex.several_equations import EQUIVALENCES
from mechproof.latex.tokens import tokenize
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.pipeline.special_letters import take_set

_WRAPPERS = (
    *(("$$", "$$"), ("$", "$"), (r"\[", r"\]"), (r"\(", r"\)")),
    *((rf"\begin{{{x}}}", rf"\end{{{x}}}") for x in ("equation", "equation*", "displaymath")),
)
_IMPLIES = (r"\Rightarrow", r"\implies", r"\Longrightarrow")
_LABEL = re.compile(r"\\(?:tag\*?|label)\{[^{}]*\}|\\n(?:onumber|otag)")


def unwrap(latex: str) -> str:
    """Return an equation without what stands around it in a paper."""
    text = _LABEL.sub("", latex).strip()
    for opening, closing in _WRAPPERS:
        if len(text) > len(opening) + len(closing) and text.startswith(opening):
            text = text.removeprefix(opening).removesuffix(closing).strip()
    kept = text.rstrip(".,;").rstrip()
    return f"{kept}." if kept.endswith(r"\right") else kept


def part_equivalence(pasted: Pasted) -> tuple[Pasted, Pasted] | None:
    """Return the two implications that the one double arrow of an equation says."""
    one, other = _part_at_arrow(unwrap(pasted.latex), EQUIVALENCES)
    if not other:
        return None
    sides = ((one, other), (other, one))
    first, second = (replace(pasted, latex=b, where=(*pasted.where, a)) for a, b in sides)
    return first, second


def take_condition(pasted: Pasted) -> Pasted:
    """Take what stands before the one arrow of an implication as where its conclusion is meant."""
    condition, conclusion = _part_at_arrow(pasted.latex, _IMPLIES)
    if not conclusion:
        return pasted
    return replace(pasted, latex=conclusion, where=(*pasted.where, condition))


def _part_at_arrow(latex: str, arrows: Sequence[str]) -> tuple[str, str]:
    """Return what stands before the one arrow of a print and what behind it, if there is one."""
    found = [token for token in tokenize(latex) if token.text in arrows]
    if len(found) != 1:
        return latex, ""
    return latex[: found[0].start].strip(), latex[found[0].end :].strip()


def take_sets(pasted: Pasted) -> Pasted:
    r"""Let letters count that are said to, n\in\mathbb{N}; all letters are real numbers anyway."""
    taken = [take_set(text) for text in (pasted.latex, *pasted.where)]
    members = [(letter, kind) for _, letters, kind in taken for letter in letters]
    counts = [letter for letter, kind in members if kind.startswith("N")]
    zeros = [rf"{letter}\ge0" for letter, kind in members if kind == "N_0"]
    where = [text for text, _, kind in taken[1:] if text or not kind]
    natural = tuple(dict.fromkeys((*pasted.natural, *counts)))
    latex = taken[0][0] or pasted.latex
    return replace(pasted, latex=latex, where=(*where, *zeros), natural=natural)
