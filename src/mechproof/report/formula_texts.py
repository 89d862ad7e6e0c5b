"""Formulas of a quantity in the reader's language: text that needs nothing beside it.

>>> from mechproof import formula
>>> formula("elliptic_planetary.ratio").octave.splitlines()[0]
'function result = elliptic_planetary_ratio(phi1, R1, R2, e)'
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

import sympy as sp

from mechproof.arguments.scalars import check_text, refuse
from mechproof.codegen.backends.c99 import render_c_formula
from mechproof.codegen.backends.standalone_functions import describe_formula, render_script
from mechproof.codegen.docstrings import find_given
from mechproof.derivation import check_folder, find_systems, load_paper, packaged_directory
from mechproof.programs.kernel import Kernel, build_functions
from mechproof.proof.comparison_latex import write_latex
from mechproof.record import Paper
from mechproof.record.substitution import resolve
from mechproof.report.mathml import write_formula

# Attributes that are code to be copied, and what people call the languages.
LANGUAGES = {
    "python": "Python",
    "c": "C",
    "octave": "Octave or MATLAB",
    "array_api": "Array API (JAX, PyTorch)",
    "javascript": "JavaScript",
    "structured_text": "Structured Text",
    "latex": "LaTeX",
}


@dataclass(frozen=True)
class Formula:
    """A quantity in several languages, each with its domain and its source as a comment.

    `latex` and `mathml` are the definition in the letters of the paper, `sympy` is source that
    binds it to the quantity's name. The others are functions `<system>_<quantity>`, of the
    operations of the kernel: `python` with NumPy, `array_api` (for JAX, PyTorch and what else keeps
    to that standard) and `octave` (MATLAB, too) of numbers or arrays, `c` (C99; elementary
    functions written out, as `mechproof emit c` has them), `javascript` and `structured_text` (IEC
    61131-3) of numbers. Where a language has no fused multiply-add, rests of products are computed
    by error-free products. Numbers are written so that they are read back exactly. An attribute
    raises NotImplementedError where a language cannot compute the quantity, and says why.
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
        """Return source of SymPy that defines the symbols and the quantity."""
        quantity = self._kernel.quantity
        if self._kernel.code.indexed:
            raise NotImplementedError(f"{self.name}: sums over axes are not written in SymPy")
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
        """Return a source in C99."""
        return render_c_formula(self._kernel, self._paper)

    @property
    def python(self) -> str:
        """Return a module of Python with NumPy."""
        return render_script(self._kernel, self._paper, "python")

    @property
    def array_api(self) -> str:
        """Return a module of Python for arrays of any library, as JAX's and PyTorch's."""
        return render_script(self._kernel, self._paper, "array_api")

    @property
    def octave(self) -> str:
        """Return a file of Octave or MATLAB."""
        return render_script(self._kernel, self._paper, "octave")

    @property
    def javascript(self) -> str:
        """Return a module of JavaScript."""
        return render_script(self._kernel, self._paper, "javascript")

    @property
    def structured_text(self) -> str:
        """Return functions of Structured Text."""
        return render_script(self._kernel, self._paper, "structured_text")

    def _list_equations(self) -> Iterator[tuple[str, str]]:
        """List the definition and those of the symbols in it, as LaTeX."""
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
        system.quantity, such as elliptic_planetary.position, or the function of another form of
        ours that equals it, as elliptic_planetary.position_tan_half.
    derivations : path, optional
        The folder of the derivation; that of the package if left out.

    Raises
    ------
    TypeError, ValueError
        If the name is none of a quantity with a kernel; the message lists what there is.

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
