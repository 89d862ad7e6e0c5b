"""Formulas of a quantity in the reader's language, as self-contained text.

>>> from mechproof import formula
>>> formula("elliptic_planetary.ratio").octave.splitlines()[0]
'function result = elliptic_planetary_ratio(phi1, R1, R2, e)'
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from textwrap import wrap

import sympy as sp
from markupsafe import Markup

from mechproof.arguments.scalars import check_text, refuse
from mechproof.codegen.backends.c99 import render_c, render_c_formula
from mechproof.codegen.backends.standalone_functions import describe_formula, render_script
from mechproof.codegen.docstrings import find_given
from mechproof.derivation import check_folder, find_systems, load_paper, packaged_directory
from mechproof.measured import KERNELS
from mechproof.programs.kernel import Kernel, build_functions
from mechproof.proof.comparison_latex import write_latex
from mechproof.record import Paper, Quantity, Toleranced
from mechproof.record.substitution import resolve
from mechproof.report.judged_derivations import JudgedDerivation
from mechproof.report.mathml import write_formula

# Attributes that hold code to copy -> the usual names of their languages.
LANGUAGES = {
    "python": "Python",
    "c": "C",
    "octave": "Octave or MATLAB",
    "array_api": "Array API (JAX, PyTorch)",
    "javascript": "JavaScript",
    "structured_text": "Structured Text",
    "latex": "LaTeX",
}
# Greatest length of a multiple of pi that is written as such.
SHORT = 8
# Length of a line of code on a wide page.
LINE = 64
# Options are tied, so that no line breaks within one.
C_REMARK = Markup(
    '<code>mechproof emit c {} <span class="tied">--out c</span></code> writes it; link with '
    '<code class="tied">-lm</code>.'
)


@dataclass(frozen=True)
class Formula:
    """A quantity in several languages, each with its domain and its source as a comment.

    `latex` and `mathml` are the definition in the letters of the paper; `sympy` is code that binds
    it to the quantity's name. The others are functions `<system>_<quantity>` with the operations of
    the kernel. `python` (NumPy), `array_api` (JAX, PyTorch and other libraries that follow that
    standard) and `octave` (also MATLAB) take numbers or arrays; `c` (C99; elementary functions
    written out, as in `mechproof emit c`), `javascript` and `structured_text` (IEC 61131-3) take
    numbers. In a language without fused multiply-add, error-free products replace it. Numbers are
    written so that they read back exactly. An attribute raises NotImplementedError, with the
    reason, if its language cannot compute the quantity.
    """

    name: str
    _paper: Paper = field(repr=False)
    _kernel: Kernel = field(repr=False)

    @property
    def latex(self) -> str:
        """Return the definition as LaTeX."""
        shown = " \\\\\n".join(f"{left} &= {right}" for left, right in self._list_equations())
        comment = "".join(f"% {line}\n" for line in describe_formula(self._kernel, self._paper))
        return f"{comment}\\begin{{aligned}}\n{shown}\n\\end{{aligned}}\n"

    @property
    def mathml(self) -> str:
        """Return the definition as MathML, one element for each equation."""
        lines = "\n".join(describe_formula(self._kernel, self._paper)).replace("--", "- -")
        shown = (write_formula(f"{a}={b}", "block") for a, b in self._list_equations())
        return "\n".join((f"<!-- {lines}\n-->", *shown, ""))

    @property
    def sympy(self) -> str:
        """Return SymPy code that defines the symbols and the quantity."""
        quantity = self._kernel.quantity
        if self._kernel.code.indexed:
            raise NotImplementedError(f"{self.name}: sums over axes cannot be written in SymPy")
        written = resolve(quantity.definition, self._paper.given)
        symbols = sorted(written.free_symbols, key=str)
        text = sp.sstr(written, sympy_integers=True)
        names = {*re.findall(r"[A-Za-z]\w*", text)} - {str(s) for s in symbols}
        used = sorted({"Symbol", *(n for n in names if hasattr(sp, n))})
        lines = [f"# {line}" for line in describe_formula(self._kernel, self._paper)]
        lines += [f"from sympy import {', '.join(used)}", ""]
        lines += [f"{s} = {sp.srepr(s)}" for s in symbols]
        return "\n".join((*lines, f"{quantity.name} = {text}", ""))

    @property
    def c(self) -> str:
        """Return C99 source code."""
        return render_c_formula(self._kernel, self._paper)

    @property
    def python(self) -> str:
        """Return a Python module that uses NumPy."""
        return render_script(self._kernel, self._paper, "python")

    @property
    def array_api(self) -> str:
        """Return a Python module for arrays of any library, such as JAX or PyTorch."""
        return render_script(self._kernel, self._paper, "array_api")

    @property
    def octave(self) -> str:
        """Return an Octave or MATLAB file."""
        return render_script(self._kernel, self._paper, "octave")

    @property
    def javascript(self) -> str:
        """Return a JavaScript module."""
        return render_script(self._kernel, self._paper, "javascript")

    @property
    def structured_text(self) -> str:
        """Return Structured Text functions."""
        return render_script(self._kernel, self._paper, "structured_text")

    def _list_equations(self) -> Iterator[tuple[str, str]]:
        """Yield both sides of the definitions of the quantity and of its symbols, as LaTeX."""
        quantity, paper = self._kernel.quantity, self._paper
        name = write_latex(sp.Symbol(quantity.name), ())
        yield name, write_latex(quantity.definition, paper.variables)
        for symbol in find_given(quantity.definition, quantity, paper):
            value = paper.given[symbol]
            yield write_latex(symbol, paper.variables), write_latex(value, paper.variables)


def formula(name: str, *, derivations: str | os.PathLike[str] | None = None) -> Formula:
    """Return a quantity's formula in several languages. Needs the `derive` extra.

    Parameters
    ----------
    name : str
        system.quantity, such as elliptic_planetary.position, or the function of another form that
        equals it, such as elliptic_planetary.position_tan_half.
    derivations : path, optional
        The folder of the derivation; by default that of the package.

    Raises
    ------
    TypeError, ValueError
        If the name is not that of a quantity with a kernel; the message lists the choices.

    """
    system, _, wanted = check_text("name", name).partition(".")
    systems = find_systems(
        packaged_directory() if derivations is None else check_folder(derivations)
    )
    if system not in systems:
        refuse("name", name, f"the system must be one of {', '.join(systems)}")
    paper = load_paper(systems[system])
    functions = build_functions(paper).kernels
    kernels = {k.name: k for k in functions if k.is_shipped or k.is_alternative}
    if wanted not in kernels:
        refuse("name", name, f"the quantity of {system} must be one of {', '.join(kernels)}")
    return Formula(name, paper, kernels[wanted])


def write_header(paper: Paper) -> str:
    """Return the C header of a paper, "" if it cannot have one."""
    try:
        return render_c(paper)[f"{paper.system}.h"]
    except (ValueError, NotImplementedError):
        return ""


def list_calls(
    quantity: Quantity, source: JudgedDerivation, header: str
) -> Iterator[tuple[str, str, str]]:
    """Yield language, code and a remark for each way to call a quantity."""
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
            "The same as one compiled loop; for numbers, also inside your own compiled loops.",
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
    """The formula in other languages: the call for it, its texts, and the languages without one.

    `refused` maps each reason to the languages that it rules out.
    """

    call: str
    texts: tuple[tuple[str, str], ...]
    refused: Mapping[str, Sequence[str]]


def write_sources(kernel: Kernel, source: JudgedDerivation) -> Sources:
    """Write a kernel's formula in every language, each with the usual name of the language."""
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
    """Break a call that is longer than a line at its blanks."""
    lines = wrap(
        call, LINE, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False
    )
    return "\n".join(lines)


def _wrap(prototype: str) -> str:
    return prototype.replace(", ", ",\n    ").replace("(", "(\n    ", 1)


def _write_arguments(quantity: Quantity, paper: Paper) -> Iterator[str]:
    """Write the first published sizes if they are numbers, otherwise the names of arguments."""
    sizes = paper.published[0].sizes if paper.published else {}
    for number, argument in enumerate(quantity.arguments):
        size = sizes.get(argument.symbols[0]) if number and len(argument.symbols) == 1 else None
        nominal = size.nominal if isinstance(size, Toleranced) else size
        yield argument.name if nominal is None else _write_number(sp.sympify(nominal))


def _write_number(size: sp.Expr) -> str:
    """Write a size as code: a short multiple of pi symbolically."""
    text = str(size)
    is_short = size.has(sp.pi) and len(text) <= SHORT
    return text.replace("pi", "np.pi") if is_short else f"{float(size):.12g}"
