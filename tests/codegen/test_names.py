"""A paper's names never collide with those of the generated code, in any language."""

from __future__ import annotations

import ast
import ctypes
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from pathlib import Path

import numba
import numpy as np
import pytest
import sympy as sp
from c_libraries import STRICT, compile_files, needs_compiler
from derived import paper_of as derived_paper
from trial import load_paper, load_source, paper_of, quantity_of

from mechproof.codegen.backends.c99 import render_c
from mechproof.codegen.backends.numba import render_compiled
from mechproof.codegen.backends.numpy import render_modules
from mechproof.codegen.c_names import WORDS
from mechproof.programs.kernel import list_functions
from mechproof.programs.scalar import fold_sums, list_arguments, list_scalars, list_stages
from mechproof.programs.step_names import PUBLIC, PUBLIC_IN_MODULES, is_free
from mechproof.record import Paper

# Papers whose sources have loops, sums, matrices, several forms and results in one pass.
SYSTEMS = ("track_wheel", "elliptic_planetary")
A_NUMBER = sp.Symbol("a", real=True)


def weigh(names: list[str]) -> Paper:
    """Return a paper that sums over arguments of these names, each with its own weight."""
    symbols = sp.symbols([f"q{n}" for n in range(len(names))], real=True)
    total = sum(sp.sqrt(1 + n * symbol**2) for n, symbol in enumerate(symbols, start=1))
    return paper_of(quantity_of(total, *symbols, names=" ".join(names)))


def list_words_in_c() -> list[str]:
    texts = [text for paper in map(derived_paper, SYSTEMS) for text in render_c(paper).values()]
    bare = [re.sub(r"/\*.*?\*/|#\w+|\.0\b|\d[\w.]*", " ", text, flags=re.DOTALL) for text in texts]
    return sorted(WORDS.union(*(re.findall(r"[A-Za-z]\w*", text) for text in bare)))


@pytest.mark.thorough
@needs_compiler
@pytest.mark.parametrize("half", [0, 1])
def test_no_name_of_a_paper_meets_one_in_c(half: int, tmp_path: Path) -> None:
    """Arguments get every name that sources use and every word that C reserves.

    A function of ctypes takes at most 1024 arguments, hence the two halves.
    """
    words = [w for w in list_words_in_c() if is_free(w)]
    assert {"count", "mp_i", "mp_prepared", "out_ratio", "double", "sqrt", "isfinite"} <= set(words)
    words = sorted({*words, *(f"{w}_" for w in words), "i", "j", "M_PI", "system_f_array", "x"})
    words = words[half::2]
    files = render_c(weigh(words))
    library = compile_files(tmp_path, files, STRICT)
    library.system_f.restype = ctypes.c_double
    library.system_f.argtypes = [ctypes.c_double] * len(words)
    given = [1 / (3 + n) for n in range(len(words))]
    expected = sum((1 + n * value**2) ** 0.5 for n, value in enumerate(given, start=1))
    assert library.system_f(*given) == pytest.approx(expected, rel=1e-12)


def list_sources(paper: Paper) -> list[str]:
    return [*render_modules(paper).values(), *render_compiled(paper).values()]


def list_names(source: str) -> Iterator[str]:
    """Yield the names that a module binds, reads, imports or takes as parameters."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Name):
            yield node.id
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.FunctionDef):
            yield node.name
        elif isinstance(node, ast.alias):
            yield node.asname or node.name


@pytest.mark.slow
@pytest.mark.parametrize("system", SYSTEMS)
def test_what_is_no_name_of_the_paper_has_an_underscore(system: str) -> None:
    paper = derived_paper(system)
    scalars = list_scalars(paper)
    kernels = (*list_functions(paper), *scalars)
    own = {name for kernel in kernels for name in (*kernel.code.names, kernel.name)}
    own |= {c for kernel in scalars for a in list_arguments(kernel) for c in a.components}
    folded, loops = fold_sums(scalars)
    own |= {n for loop in loops for n in (loop.name, *loop.term.inputs)}
    own |= {n for kernel in folded for n in kernel.code.names}
    own |= {several.name for several in paper.one_pass}
    stages = [stage for kernel in scalars for _, stage in list_stages(kernel)]
    own |= {name for stage in stages for p in stage.programs for name in p.inputs}
    annotations = {"tuple", "list", "str", "None"}
    for source in list_sources(paper):
        used = {name for name in list_names(source) if not name.startswith("_")}
        assert used <= own | PUBLIC | PUBLIC_IN_MODULES | annotations
    assert not any(is_free(name) for name in ("_i", "_np", "out", "lambda", "a b"))


def list_own_words() -> list[str]:
    """List the modules' own names, without the underscore that marks them."""
    sources = chain.from_iterable(map(list_sources, map(derived_paper, SYSTEMS)))
    names = {name for source in sources for name in list_names(source)}
    own = {name.removeprefix("_") for name in names if name[0] == "_" and "_of_" not in name}
    return sorted(word for word in own if is_free(word))


@pytest.mark.thorough
def test_arguments_are_called_like_all_that_modules_have(tmp_path: Path) -> None:
    words = list_own_words()
    known = {"i", "j", "at", "terms", "row", "type", "float", "float64", "fill", "loop"}
    assert known | {"run", "np", "math", "elementary", "exact", "as_floats", "in_blocks"} <= {
        *words
    }
    paper = weigh(words)
    plain = load_paper(paper, tmp_path).f
    (source,) = render_compiled(paper).values()
    compiled = load_source(source, tmp_path).f
    numbers = [1 / (3 + n) for n in range(len(words))]
    row = np.linspace(0, 5, 40)
    inside = numba.njit(lambda values: compiled(*values))
    expected = plain(*numbers)
    assert compiled(*numbers) == pytest.approx(expected, rel=1e-14)
    assert inside(tuple(numbers)) == pytest.approx(expected, rel=1e-14)
    for number in (0, 1, len(words) - 1):
        given = [*numbers[:number], row, *numbers[number + 1 :]]
        np.testing.assert_allclose(compiled(*given), plain(*given), rtol=1e-14)


@pytest.mark.slow
def test_kernels_are_called_like_all_that_modules_have(tmp_path: Path) -> None:
    (quantity,) = paper_of(quantity_of(A_NUMBER**2, A_NUMBER)).quantities
    names = ("R", "r", "range", "fill_of_r", "x", "x_1", "prepare_of_r")
    paper = replace(
        paper_of(quantity), quantities=tuple(replace(quantity, name=name) for name in names)
    )
    (source,) = render_compiled(paper).values()
    for module in (load_paper(paper, tmp_path), load_source(source, tmp_path)):
        for name in names:
            assert getattr(module, name)(3.0) == 9.0
            assert getattr(module, name)(np.array([3.0, 4.0])).tolist() == [9.0, 16.0]


@pytest.mark.parametrize("name", ["DOMAIN", "Any", "x_"])
def test_a_name_that_a_module_has_for_others_is_refused(name: str) -> None:
    quantity = replace(quantity_of(A_NUMBER, A_NUMBER), name=name)
    with pytest.raises(ValueError, match="cannot name a kernel"):
        render_modules(paper_of(quantity))
