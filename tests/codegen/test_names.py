"""Names of the paper and of what computes: they never meet, in any language."""

from __future__ import annotations

import ctypes
import re
from keyword import iskeyword
from pathlib import Path

import pytest
import sympy as sp
from c_libraries import STRICT, compile_files, needs_compiler
from derived import paper_of as derived_paper
from trial import paper_of, quantity_of

from mechproof.codegen.backends.c99 import render_c
from mechproof.codegen.c_names import WORDS
from mechproof.record import Paper

# Papers whose sources in C have loops, sums, matrices, several forms and results in one pass.
PAPERS = tuple(map(derived_paper, ("track_wheel", "elliptic_planetary")))


def weigh(names: list[str]) -> Paper:
    """Return a paper that adds numbers of these names with other weights."""
    symbols = sp.symbols([f"q{n}" for n in range(len(names))], real=True)
    total = sum(sp.sqrt(1 + n * symbol**2) for n, symbol in enumerate(symbols, start=1))
    return paper_of(quantity_of(total, *symbols, names=" ".join(names)))


def list_words_in_c() -> list[str]:
    texts = [text for paper in PAPERS for text in render_c(paper).values()]
    bare = [re.sub(r"/\*.*?\*/|#\w+|\.0\b|\d[\w.]*", " ", text, flags=re.DOTALL) for text in texts]
    return sorted(WORDS.union(*(re.findall(r"[A-Za-z]\w*", text) for text in bare)))


@needs_compiler
def test_no_name_of_a_paper_meets_one_in_c(tmp_path: Path) -> None:
    """Arguments are called like all that sources have, and like all that C keeps for itself."""
    words = [w for w in list_words_in_c() if not iskeyword(w)]
    assert {"count", "mp_i", "mp_prepared", "out_ratio", "double", "sqrt", "isfinite"} <= set(words)
    words = sorted({*words, *(f"{w}_" for w in words), "i", "j", "M_PI", "system_f_array", "x"})
    files = render_c(weigh(words))
    library = compile_files(tmp_path, files, STRICT)
    library.system_f.restype = ctypes.c_double
    library.system_f.argtypes = [ctypes.c_double] * len(words)
    given = [1 / (3 + n) for n in range(len(words))]
    expected = sum((1 + n * value**2) ** 0.5 for n, value in enumerate(given, start=1))
    assert library.system_f(*given) == pytest.approx(expected, rel=1e-12)
