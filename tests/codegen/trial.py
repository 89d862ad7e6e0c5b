"""A trial paper with one quantity, its emitted modules, and their import."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import sympy as sp

from mechproof.codegen.backends.numpy import render_modules
from mechproof.record import Argument, Form, Paper, Quantity, Variable

a, b, x = sp.symbols("a b x", real=True)


def quantity_of(
    expression: sp.Basic, *symbols: sp.Symbol, names: str = "", rewrites: tuple[str, ...] = ()
) -> Quantity:
    """Return a quantity whose only form is the expression itself."""
    arguments = tuple(
        Argument(name, (symbol,), "a number")
        for name, symbol in zip(names.split() or map(str, symbols), symbols, strict=True)
    )
    form = Form("direct", expression, rewrites)
    return Quantity("f", "Compute f.", arguments, expression, (form,), "here")


def paper_of(quantity: Quantity, *variables: Variable) -> Paper:
    """Return a paper with one quantity; symbols without a variable are declared as reals."""
    declared = {variable.symbol for variable in variables}
    symbols = (s for a in quantity.arguments for s in a.symbols if s not in declared)
    others = tuple(Variable(symbol, "a number") for symbol in symbols)
    return Paper("system", "citation", (*variables, *others), (), quantities=(quantity,))


def load_source(source: str, folder: Path) -> ModuleType:
    """Import emitted source as a new module."""
    name = f"trial_{len(list(folder.iterdir()))}"
    path = folder / f"{name}.py"
    path.write_text(source, encoding="utf-8")
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def load_paper(paper: Paper, folder: Path) -> ModuleType:
    """Import the shipped kernels of a paper."""
    return load_source(render_modules(paper)[f"{paper.system}.py"], folder)
