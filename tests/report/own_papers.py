"""A user's own papers: the one shown in docs/verify.md, and one that would run scripts."""

from __future__ import annotations

import re
from pathlib import Path

TESTS = Path(__file__).parents[1]
HURT = "document.title='hurt'"
# A paper whose every text tries to run scripts, with a row that cannot be judged: its rebuilt side
# has a symbol that is declared nowhere.
HOSTILE = rf"""
from sympy import Symbol

from mechproof.record import Claim, Equality, Equation, Paper, Variable

x, ghost = Symbol("x", real=True), Symbol("ghost", real=True)
SCRIPT = "<script>{HURT}</script>"
PAPER = Paper(
    system="größe",
    citation=f"Ä & Ö {{SCRIPT}}",
    conventions=f'"{{SCRIPT}}"',
    variables=(Variable(x, f"a <b>length</b> {{SCRIPT}}", latex=("x",)),),
    rows=(
        Claim(f"Ω {{SCRIPT}}", r"\text{{" + SCRIPT + r" holds}}", Equality(x, x), note=SCRIPT),
        Claim(f"Ω '{{SCRIPT}}'", r"x\text{{" + SCRIPT + r"}}^2", Equality(x, 2 * x)),
        Claim("link", r"\href{{javascript:{HURT}}}{{x}}", Equality(x, x)),
        Claim("no LaTeX", r"\frac{{x" + SCRIPT, Equality(x, x)),
        Equation("(3)", "x=y", Equality(x, ghost), note=SCRIPT),
    ),
)
"""


def write_slider_crank(folder: Path) -> Path:
    """Write the paper that docs/verify.md shows."""
    uses = (TESTS.parent / "docs" / "verify.md").read_text(encoding="utf-8")
    found = re.search(r'```python\n("""Slider-crank.*?)```', uses, re.DOTALL)
    assert found is not None
    file = folder / "slider_crank.py"
    file.write_text(found[1], encoding="utf-8")
    return file


def write_hostile(folder: Path) -> Path:
    file = folder / "größe.py"
    file.write_text(HOSTILE, encoding="utf-8")
    return file
