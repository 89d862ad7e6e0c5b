"""Calls: how a quantity is computed in several languages, as its page shows it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from textwrap import wrap

import sympy as sp
from markupsafe import Markup

from mechproof.codegen.backends.c99 import render_c
from mechproof.measured import KERNELS
from mechproof.programs.kernel import Kernel
from mechproof.record import Paper, Quantity, Toleranced
from mechproof.report.formula_texts import LANGUAGES, Formula
from mechproof.report.judged_derivations import JudgedDerivation

# Letters of a multiple of pi that is written as such.
SHORT = 8
# Letters of a line of code on a wide page.
LINE = 64
# No line begins within an option.
C_REMARK = Markup(
    '<code>mechproof emit c {} <span class="tied">--out c</span></code> writes it; link with '
    '<code class="tied">-lm</code>.'
)


def write_header(paper: Paper) -> str:
    """Return the C header of a paper, empty if it cannot have one."""
    try:
        return render_c(paper)[f"{paper.system}.h"]
    except (ValueError, NotImplementedError):
        return ""


def list_calls(
    quantity: Quantity, source: JudgedDerivation, header: str
) -> Iterator[tuple[str, str, str]]:
    """Yield language, code and a remark for each way to compute a quantity."""
    if quantity.call:
        yield "Python", quantity.call, ""
    if not (quantity.forms and source.home):
        return
    system, arguments = source.system, ", ".join(_write_arguments(quantity, source.told))
    call = _break_lines(f"{quantity.name}({arguments})")
    for language, package, remark in (
        ("NumPy", source.home, "Arrays of any shape that broadcast; takes out=."),
        (
            "numba",
            f"{source.home}.compiled",
            "The same as one compiled loop; with numbers also inside your own compiled loops.",
        ),
    ):
        needed = "import numpy as np\n\n" if "np." in call else ""
        code = f"{needed}from {package}.{system} import {quantity.name}\n\n{call}"
        yield language, code, remark
    pattern = rf"^.*\b{system}_{quantity.name}(?:_array)?\(.*\);$"
    if found := re.findall(pattern, header, re.MULTILINE):
        remark = C_REMARK.format(system)
        yield "C", "\n".join([f'#include "{system}.h"', "", *map(_wrap, found)]), remark


@dataclass(frozen=True)
class Sources:
    """The formula in other languages: the call for it, its texts, and why which have none."""

    call: str
    texts: tuple[tuple[str, str], ...]
    refused: Mapping[str, Sequence[str]]


def write_sources(kernel: Kernel, source: JudgedDerivation) -> Sources:
    """Write a kernel's formula in every language, each with the name that people call it."""
    paper = source.ledger.paper
    name, place = f"{paper.system}.{kernel.name}", source.location.parent.name
    given = "" if source.home == KERNELS else f', derivations="{place}"'
    written, texts, refused = Formula(name, paper, kernel), [], dict[str, list[str]]()
    for attribute, language in LANGUAGES.items():
        try:
            texts.append((language, getattr(written, attribute)))
        except (NotImplementedError, ValueError) as reason:
            refused.setdefault(str(reason), []).append(language)
    return Sources(f'mechproof.formula("{name}"{given})', tuple(texts), refused)


def _break_lines(call: str) -> str:
    """Break a call that is longer than a line, behind commas."""
    lines = wrap(
        call, LINE, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False
    )
    return "\n".join(lines)


def _wrap(prototype: str) -> str:
    return prototype.replace(", ", ",\n    ").replace("(", "(\n    ", 1)


def _write_arguments(quantity: Quantity, paper: Paper) -> Iterator[str]:
    """Write the first published sizes where they are numbers, else the names of arguments."""
    sizes = paper.published[0].sizes if paper.published else {}
    for number, argument in enumerate(quantity.arguments):
        size = sizes.get(argument.symbols[0]) if number and len(argument.symbols) == 1 else None
        nominal = size.nominal if isinstance(size, Toleranced) else size
        yield argument.name if nominal is None else _write_number(sp.sympify(nominal))


def _write_number(size: sp.Expr) -> str:
    """Write a size as code: a short multiple of pi as such."""
    text = str(size)
    is_short = size.has(sp.pi) and len(text) <= SHORT
    return text.replace("pi", "np.pi") if is_short else f"{float(size):.12g}"
