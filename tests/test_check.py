"""The command that judges one pasted equation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from mechproof.cli import app


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["check", *arguments])


CHECKED = [
    # Three formulas of textbooks, the third with a misprint, then what the options say.
    ([r"\int_0^x \frac{dt}{1+t^2} = \mathrm{arctg}\,x"], ["PROVED"]),
    ([r"\sin\alpha+\sin\beta=2\sin\frac{\alpha+\beta}{2}\cos\frac{\alpha-\beta}{2}"], ["PROVED"]),
    ([r"\cos 3x=4\cos^3 x-3\sin x"], ["REFUTED"]),
    ([r"\sin^2x+\cos^2x=1=\mathrm{tg}\,x\,\mathrm{ctg}\,x"], ["PROVED", "PROVED"]),
    ([r"\sqrt{x^2}=x"], ["REFUTED"]),
    ([r"\sqrt[3]{-8}=-2"], ["PROVED"]),
    ([r"\sqrt{x^2}=x", "--where", "x>0"], ["PROVED"]),
    ([r"\frac{AC}{BD}\cdot BD=AC", "--name", "AC", "--name", "BD"], ["PROVED"]),
    (["a(1+x)=a+ax", "--factor", "a"], ["PROVED"]),
    (["k^2=x^4", "--let", "k=x^2"], ["PROVED"]),
    (["y=2x"], ["DEFINITION"]),
    ([r"\int\cos x=\sin x"], ["ILL_FORMED"]),
    ([r"\int\cos x\,dx=\sin x+C", "--from", "0", "--let", "C=0"], ["PROVED"]),
    (
        [
            r"\sum_{k=1}^n(q_k-\bar q)^2=\sum_{k=1}^n q_k^2-n\bar q^2",
            "--let",
            r"\bar q=\frac1n\sum_{k=1}^n q_k",
        ],
        ["PROVED"],
    ),
    ([r"(-1)^{2m}=1", "--natural", "m"], ["PROVED"]),
    ([r"x+a>x", "--where", "a>0"], ["PROVED"]),
]


@pytest.mark.parametrize(("arguments", "verdicts"), CHECKED, ids=[c[0][0] for c in CHECKED])
def test_an_equation_is_judged(arguments: list[str], verdicts: list[str], tmp_path: Path) -> None:
    file = tmp_path / "rows.json"
    done = run(*arguments, "--json", str(file))
    assert done.exit_code == 0, done.output
    rows = json.loads(file.read_text(encoding="utf-8"))["rows"]
    assert [row["verdict"] for row in rows] == verdicts
    assert all(f"read as   {row['read_as']}" in done.output for row in rows)
    assert "What is not said is taken so" in done.output


def test_what_a_letter_is_taken_for_is_told() -> None:
    done = run(r"\frac1n\sum_{k=1}^n x=x", "--where", "0<x<1")
    assert "taken as  n: a natural number" in done.output
    assert "taken as  x: in Interval.open(0, 1)" in done.output


REFUSED = [
    (["f(x)=1"], "--factor 'f'"),
    (["e^x=1"], "--name 'e'"),
    ([r"\int_0^1 e^x\,dx=1"], "--name 'e'"),
    ([r"\frac{d}{dx}x=1"], "--name 'd'"),
    ([r"x\pm y=1"], "no meaning"),
    ([r"\int\cos x\,dx=\sin x"], "--from 0"),
    ([r"\int\cos x\,dx=\sin x+C", "--from", "0"], "--let 'C=0'"),
    (["9^{9^{9^9}}=1"], "not worked out"),
    (["x+1"], "no relation sign"),
    (["x=1", "--let", "x^2=1"], "letter=expression"),
    (["x=1", "--where", "x"], "no relation sign"),
]


@pytest.mark.parametrize(("arguments", "told"), REFUSED, ids=[" ".join(r[0]) for r in REFUSED])
def test_what_cannot_be_read_without_a_guess_is_refused(arguments: list[str], told: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert told in done.output


def test_what_takes_too_long_fails() -> None:
    done = run(r"\sin x=x", "--limit", "0")
    assert done.exit_code == 1
    assert "no answer within the time limit" in done.output
