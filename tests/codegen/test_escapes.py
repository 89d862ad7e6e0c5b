"""A paper's texts stay texts in every language, and its names stay within their folder."""

from __future__ import annotations

import ast
import inspect
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from c_libraries import COMPILER, needs_compiler
from trial import a, load_source, paper_of, quantity_of, x
from weights import first_of

from mechproof.codegen.backends.c99 import render_c
from mechproof.codegen.backends.numba import render_compiled
from mechproof.codegen.backends.numpy import render_modules
from mechproof.ledger.judged import Ledger, to_markdown
from mechproof.proof.judge import judge
from mechproof.record import (
    Claim,
    Equality,
    Form,
    OnePass,
    Paper,
    Part,
    PublishedSizes,
    Quantity,
    Singular,
    Variable,
)

HOSTILE = [
    r"\alpha and \nu, \N{DASH}, \x41, \u",
    'a "quoted" word, and "',
    '"""\nimport sys\nsys.exit("hurt")\n"""',
    "'''; '",
    "*/ int hurt = 1; /*",
    "a line\nbreak = 1\n\tand a tab",
    "{{ hurt }} {% raw %} {# #}",
    "??/ ends with \\",
    "<script>hurt()</script> | `x` $y$ $$ _z_",
]


def hostile_paper(text: str) -> Paper:
    """Return a paper with `text` wherever its records hold a text."""
    quantity = quantity_of(a / x, x, a)
    (form,) = quantity.forms
    arguments = tuple(replace(one, meaning=text, unit=text) for one in quantity.arguments)
    rival = Form(text, a * x**-1, key="rival", source=text, note=text)
    hostile = replace(
        quantity,
        summary=text,
        arguments=arguments,
        forms=(replace(form, name=text, note=text, source=text), rival),
        source=text,
        unit=text,
        on=Part(text, where=(sp.Gt(a, x),)),
        singular=(Singular(sp.Eq(x, 0), text),),
        remarks=(text,),
        workloads=((text, ("x",)),),
    )
    other = replace(quantity, name="g", definition=a + x, forms=(Form("direct", a + x),))
    variables = (Variable(x, text), Variable(a, text, within=sp.Interval.open(0, sp.oo)))
    row = Claim("(1) " + text, rf"\text{{{text}}}", Equality(x, x), note=text)
    paper = paper_of(hostile, *variables)
    return replace(
        paper,
        citation=text,
        conventions=text,
        rows=(row,),
        quantities=(hostile, replace(other, arguments=hostile.arguments)),
        one_pass=(OnePass("both", ("f", "g")),),
        published=(PublishedSizes(text, {a: sp.Integer(2)}, (text,)),),
    )


def read_words(text: str) -> str:
    return "".join(text.split())


@pytest.mark.slow
@pytest.mark.parametrize("text", first_of(HOSTILE))
def test_python_holds_a_text_as_it_is(text: str, tmp_path: Path) -> None:
    paper = hostile_paper(text)
    sources = {**render_modules(paper), **render_compiled(paper)}
    plain = {**render_modules(hostile_paper("a")), **render_compiled(hostile_paper("a"))}
    for name, source in sources.items():
        found, meant = (list_code(ast.parse(one)) for one in (source, plain[name]))
        assert found == meant, name
    module: Any = load_source(sources["system.py"], tmp_path)
    assert read_words(text) in read_words(module.__doc__)
    help_ = inspect.getdoc(module.f)
    # Summary, meaning, unit, domain, singular set, remark and source.
    assert read_words(help_ or "").count(read_words(text)) >= 7
    assert module.PUBLISHED[0].source == text
    assert module.f(2.0, 3.0) == 1.5


def list_code(tree: ast.Module) -> list[str]:
    """List the types of a module's nodes, whatever texts it contains."""
    return [type(node).__name__ for node in ast.walk(tree)]


@needs_compiler
@pytest.mark.parametrize("text", first_of(HOSTILE))
@pytest.mark.parametrize("single", [False, True])
def test_a_comment_of_c_is_not_ended_by_a_text(text: str, single: bool, tmp_path: Path) -> None:
    errors = dict.fromkeys(("f", "g"), text) if single else None
    files = render_c(hostile_paper(text), errors=errors)
    for name, source in files.items():
        (tmp_path / name).write_text(source, encoding="utf-8")
    (source_name,) = (name for name in files if name.endswith(".c"))
    command = [str(COMPILER), "-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]
    done = subprocess.run(
        [*command, "-c", source_name, "-o", "kernels.o"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert (
        "hurt"
        not in subprocess.run(
            ["nm", "kernels.o"], cwd=tmp_path, capture_output=True, text=True
        ).stdout
    )


@pytest.mark.parametrize("text", HOSTILE)
def test_a_page_of_markdown_has_neither_tags_nor_ends_of_formulas_from_a_text(text: str) -> None:
    page = to_markdown([judge_all(hostile_paper(text))])
    assert "<script" not in page
    assert len(page.splitlines()) == len(to_markdown([judge_all(hostile_paper("a"))]).splitlines())
    for line in page.splitlines():
        assert line.count("$$") == 2 * line.startswith("$$ "), line


def judge_all(paper: Paper) -> Ledger:
    return Ledger(paper.system, paper.citation, tuple(judge(row, paper) for row in paper.rows))


@pytest.mark.parametrize("letter", ["\x00", "\x1b", "\r", "\x7f", "\x85", "\u202e", "\u2066",
                                    "\u200b", "\ufeff", "\u2028", "\ud800"])  # fmt: skip
@pytest.mark.parametrize("field", ["citation", "conventions", "meaning", "row", "remark"])
def test_what_is_not_seen_is_refused(letter: str, field: str) -> None:
    text = f"a{letter}b"
    quantity = replace(quantity_of(a / x, x, a), remarks=(text,) if field == "remark" else ())
    variables = (Variable(x, text if field == "meaning" else "a number"),)
    rows = (Claim("(1)", text, Equality(x, x)),) if field == "row" else ()
    texts = {field: text} if field in ("citation", "conventions") else {}
    with pytest.raises(ValueError, match=rf"paper 'system', .*: .* has U\+{ord(letter):04X}, "):
        Paper(**{"system": "system", "citation": "", "variables": variables, "rows": rows,
                 "quantities": (quantity,), **texts})  # fmt: skip


NAMES = ["/../../x", "../x", "a/b", "a\\b", "", "a b", "class", "_x", "1x", "ﬁ", "x\n", 3, None]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_names_code_and_a_file(name: Any) -> None:
    form = Form("direct", x)
    for what, make in (
        ("quantity: name", lambda: Quantity(name, "", (), x, (form,), "")),
        ("together: name", lambda: OnePass(name, ("f", "g"))),
        ("paper: system", lambda: Paper(name, "", (), ())),
    ):
        with pytest.raises(ValueError, match=f"{what} = .* it names code and files"):
            make()
