"""An unproved kernel stops every command that would ship it; its rivals may be wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from command import run
from weights import first_of

from mechproof.record import Claim

HEAD = """
from sympy import *
from mechproof.record import *
x, y = symbols("x y", real=True)
RIGHT, POSITIVE = Form("sine", sin(x)), {x: Interval.open(0, oo)}
def within_one(code):
    gap = code.output() - x - 1/(1 + x**2)
    return Conjunction((Holds(Le(gap, 1, evaluate=False)), Holds(Ge(gap, -1, evaluate=False))))
def paper(definition, *forms, rows=()):
    argument = Argument("x", (x,), "a number", usual=(0, 1, 10))
    quantity = Quantity("q", "Compute q.", (argument,), definition, forms, "my notes")
    given = Variable(y, "its sine", given=sin(x))
    return Paper("mine", "my notes", (Variable(x, "a number"), given), rows, quantities=(quantity,))
"""
REFUSED = {
    "another function": ('sin(x), Form("cosine", cos(x))', "kernel q is REFUTED", "At x = "),
    "a first form of two": (
        'sin(x), Form("cosine", cos(x), when=x > 1), RIGHT',
        "kernel q, cosine is REFUTED",
        "At x = ",
    ),
    "true on a part": (
        'Abs(x), Form("no sign", x, holds_on=Part("x > 0", POSITIVE))',
        "kernel q is CONDITIONAL",
        "At x = -",
    ),
    "a bound that is too small": (
        'sin(x), Form("its line", x, bound=S.One, on=Part("x > 0", POSITIVE), '
        "states=lambda code: Holds(Le(code.output() - sin(x), 1)))",
        "kernel q is REFUTED",
        "At x = ",
    ),
    "rows that define": (
        'sin(x), Form("sine", sin(x), states=lambda code: Definition(y, code.output()))',
        "kernel q is DEFINITION",
        "",
    ),
}
COMMANDS = (("verify",), ("regenerate",), ("regenerate", "--check"), ("emit", "c"))
ACCEPTED = {
    "wrong rivals": 'sin(x), RIGHT, Form("cosine", cos(x), key="printed")',
    "a definition that is declared": 'y, Form("sine", sin(x))',
    "a large constant": 'x*Rational("6.02214076e23"), Form("f", x*Rational("6.02214076e23"))',
    "a tangent without a name": '1/(1 + tan(x/2)**2), Form("f", 1/(1 + tan(x/2)**2))',
    "where sides differ": (
        "Piecewise((sin(x)/x, Ne(x, 0)), (1, True)), "
        'Form("f", Piecewise((sin(x)/x, Ne(x, 0)), (1, True)))'
    ),
    "a proved bound": 'x + 1/(1 + x**2), Form("its line", x, bound=S.One, states=within_one)',
}


def write(folder: Path, arguments: str) -> Path:
    derivations = folder / "derivations"
    derivations.mkdir()
    text = f"{HEAD}\nPAPER = paper({arguments})\n"
    (derivations / "mine.py").write_text(text, encoding="utf-8")
    return derivations


@pytest.mark.parametrize("name", first_of(REFUSED))
def test_a_kernel_that_is_not_proved_is_not_shipped(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    arguments, verdict, where = REFUSED[name]
    write(tmp_path, arguments)
    monkeypatch.chdir(tmp_path)
    for command in COMMANDS:
        result = run(*command)
        assert result.exit_code == 1, (command, result.output)
        assert f"mine: {verdict}, but only proved rows are shipped: " in result.output
        assert where in result.output
    assert [path.name for path in tmp_path.iterdir()] == ["derivations"]


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(ACCEPTED))
def test_what_is_proved_is_shipped(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path, ACCEPTED[name])
    monkeypatch.chdir(tmp_path)
    for command in COMMANDS:
        result = run(*command)
        assert result.exit_code == 0, (command, result.output)


@pytest.mark.parametrize(
    "arguments",
    first_of(
        [
            'Abs(x), Form("no sign", x, on=Part("x > 0", POSITIVE))',
            'sin(x), Form("line", x, on=Part("x = 0", {x: FiniteSet(0)}))',
            'sin(x), Form("cosine", cos(x), states=lambda code: Equality(S.One, S.One))',
            'sin(x), Form("line", x, bound=S.One, states=lambda code: Equality(S.One, S.One))',
        ]
    ),
    ids=["of a part", "of a point", "of something else", "of no bound"],
)
def test_a_row_that_says_less_than_the_definition_is_found_by_running(
    arguments: str, tmp_path: Path
) -> None:
    folder, out = write(tmp_path, arguments), tmp_path / "c"
    for command in (("regenerate",), ("emit", "c", "--out", str(out))):
        result = run(*command, "--derivations", str(folder))
        assert result.exit_code == 1
        assert "its program gives" in result.output
        assert "its definition" in result.output
    assert [path.name for path in tmp_path.iterdir()] == ["derivations"]


def test_a_row_of_the_paper_cannot_stand_for_the_row_of_a_kernel(tmp_path: Path) -> None:
    row = 'Claim("kernel q", "q", Equality(x, x))'
    folder = write(tmp_path, f'sin(x), Form("cosine", cos(x)), rows=({row},)')
    result = run("verify", "--derivations", str(folder))
    assert result.exit_code == 1
    assert "rows given twice by the paper and its forms: ['kernel q']" in result.output


def test_a_row_stands_on_the_page_of_a_quantity_that_there_is(tmp_path: Path) -> None:
    says = 'Claim("as a cosine", "q", Equality(sin(x), cos(x - pi/2)), marks=("ours",)'
    folder = write(tmp_path, f'sin(x), Form("sine", sin(x)), rows=({says}, quantities=("p",)),)')
    result = run("verify", "--derivations", str(folder))
    assert result.exit_code == 1
    assert "rows name unknown quantities: ['p']" in result.output


def test_a_printed_row_stands_in_its_paper() -> None:
    with pytest.raises(ValueError, match="only rows marked 'ours' name them"):
        Claim("(1)", "q", quantities=("q",))
