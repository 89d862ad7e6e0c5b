"""Coq itself: accepts what is proved, and refuses one wrong row of each kind of proof."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from command import PROVED, run, write
from sympy import (
    Eq,
    Ge,
    Integer,
    Le,
    Lt,
    Rational,
    atan,
    atan2,
    cos,
    pi,
    sin,
    sqrt,
    symbols,
    tan,
)

from mechproof.coq.checker import check_files, find_assumptions
from mechproof.coq.folder import PRELUDE, read_prelude
from mechproof.coq.scripts import write_script
from mechproof.coq.theorems import Theorem

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed")

e, x, y = symbols("e x y", real=True)
POINT = {e: Rational(1, 2), x: Rational(3, 4), y: Rational(5, 6)}
SHARE = (Ge(e, 0, evaluate=False), Lt(e, 1, evaluate=False))

LENGTHS = (
    Ge(y**2 - x**2, 0, evaluate=False),
    Ge(1 - x**2 / y**2, 0, evaluate=False),
    Lt(0, y, evaluate=False),
)
TURN = (Lt(x, 1, evaluate=False), Lt(0, x, evaluate=False))


def state(conclusion: object, *hypotheses: object) -> Theorem:
    met = set().union(*(part.free_symbols for part in (conclusion, *hypotheses)))
    letters = tuple(sorted(met, key=str))
    return Theorem(letters, hypotheses, conclusion, {s: POINT[s] for s in letters})


def equal(left: object, right: object) -> object:
    return Eq(left, right, evaluate=False)


# A true statement for each kind of proof, and a wrong one beside it.
PAIRS = {
    "rational": (
        state(equal((1 - e**2) / (1 - e), 1 + e), *SHARE),
        state(equal((1 - e**2) / (1 - e), 1 - e), *SHARE),
    ),
    "trigonometric": (
        state(equal(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y))),
        state(equal(sin(x + y), sin(x) * cos(y) - cos(x) * sin(y))),
    ),
    "tangent": (
        state(equal(1 + tan(x) ** 2, 1 / cos(x) ** 2), Lt(0, cos(x), evaluate=False)),
        state(equal(1 + tan(x) ** 2, 1 / cos(x)), Lt(0, cos(x), evaluate=False)),
    ),
    "radicals": (
        state(equal(sqrt(x**2 * (1 - e)), x * sqrt(1 - e)), Ge(x, 0, evaluate=False), *SHARE),
        state(equal(sqrt(x**2 * (1 - e)), -x * sqrt(1 - e)), Ge(x, 0, evaluate=False), *SHARE),
    ),
    "hypothesis": (
        state(equal(sqrt(x**2), x), Ge(x, 0, evaluate=False)),
        state(equal(sqrt(x**2), x)),
    ),
    "quotient": (
        state(equal(sqrt(1 - x**2 / y**2), sqrt(y**2 - x**2) / y), *LENGTHS),
        state(equal(sqrt(1 - x**2 / y**2), sqrt(y**2 - x**2) / x), *LENGTHS),
    ),
    "arctangent": (
        state(equal(atan(2 * e / (1 - e**2)), 2 * atan(e)), *SHARE),
        state(equal(atan(2 * e / (1 + e**2)), 2 * atan(e)), *SHARE),
    ),
    "vector": (
        state(equal(1 + atan2(sin(x), (x**2 - 1) / (x - 1)), 1 + atan2(sin(x), x + 1)), *TURN),
        state(equal(1 + atan2(sin(x), (x**2 - 1) / (x - 1)), 1 + atan2(sin(x), x - 1)), *TURN),
    ),
    "order": (
        state(
            Le((1 - e) / (1 + e), (1 - e**2) / (1 + e**2 - 2 * e * cos(x)), evaluate=False), *SHARE
        ),
        state(
            Le((1 + e) / (1 - e), (1 - e**2) / (1 + e**2 - 2 * e * cos(x)), evaluate=False), *SHARE
        ),
    ),
    "number": (
        state(Lt(abs(sqrt(2) * pi - Rational(4443, 1000)), Rational(1, 2000), evaluate=False)),
        state(Lt(abs(sqrt(2) * pi - Rational(4444, 1000)), Rational(1, 2000), evaluate=False)),
    ),
    "point": (
        replace(state(Lt(sin(x), cos(x), evaluate=False)), of_all=False),
        replace(state(Lt(cos(x), sin(x), evaluate=False)), of_all=False),
    ),
    "witness": (
        state(Lt(0, 1 + x**2, evaluate=False), *SHARE, Le(e, x, evaluate=False)),
        state(Lt(0, 1 + x**2, evaluate=False), *SHARE, Lt(x, e, evaluate=False)),
    ),
}


@pytest.fixture(scope="module")
def outcomes(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What Coq says of each statement, by its name and whether it is true."""
    folder = tmp_path_factory.mktemp("coq")
    (folder / PRELUDE).write_text(read_prelude(), encoding="utf-8")
    names = []
    for name, pair in PAIRS.items():
        for kind, theorem in zip(("true", "wrong"), pair, strict=True):
            file = folder / f"{name}_{kind}.v"
            file.write_text(write_script(name, [theorem]), encoding="utf-8")
            names.append(file.name)
    return dict(check_files(folder, names))


@needs_coq
@pytest.mark.parametrize("name", PAIRS)
def test_coq_accepts_the_true_and_refuses_the_wrong(name: str, outcomes: dict[str, str]) -> None:
    assert outcomes[f"{name}_true.v"] == ""
    assert outcomes[f"{name}_wrong.v"].startswith("Coq: line ")


@needs_coq
def test_an_axiom_is_seen(tmp_path: Path) -> None:
    (tmp_path / PRELUDE).write_text(read_prelude(), encoding="utf-8")
    text = write_script("axiom", [state(equal(Integer(1), Integer(1)))])
    text = text.replace("Theorem", "Axiom wrong : 1 = 2.\nTheorem")
    text = text.replace("at_point.", "pose proof wrong. lra.")
    (tmp_path / "axiom.v").write_text(text, encoding="utf-8")
    assert check_files(tmp_path, ["axiom.v"]) == {"axiom.v": "assumes wrong"}


def test_only_the_published_assumptions_pass() -> None:
    told = "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P : Prop,\n  {~ ~ P} + {~ P}\n"
    assert find_assumptions(told) == set()
    assert find_assumptions(f"{told}Mine.wrong : 1 = 2\nMine.long\n  : 1 = 2\n") == {
        "Mine.wrong",
        "Mine.long",
    }


def test_nothing_is_left_unproved_in_what_all_require() -> None:
    for word in ("Axiom", "Admitted", "admit", "Parameter", "Conjecture", "Hypothesis", "Variable"):
        assert word not in read_prelude()


def test_the_command_writes_a_folder_and_refuses_another(tmp_path: Path) -> None:
    file, out = write(tmp_path, PROVED), tmp_path / "coq"
    result = run("certify", str(file), "--out", str(out))
    assert result.exit_code == 0, result.output
    assert "1 scripts of 1 rows" in result.output.replace("\n", " ")
    assert sorted(path.suffix for path in out.iterdir()) == ["", ".sha256", ".v", ".v"]
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "notes.txt").write_text("mine")
    assert run("certify", str(file), "--out", str(tmp_path / "other")).exit_code == 1
    assert run("certify", str(file), "--out", str(out), "--record").exit_code == 2


@needs_coq
def test_the_command_has_coq_check(tmp_path: Path) -> None:
    file, out = write(tmp_path, PROVED), tmp_path / "coq"
    result = run("certify", str(file), "--out", str(out), "--check")
    assert result.exit_code == 0, result.output
    assert "1 of 1 rows are accepted" in result.output.replace("\n", " ")
    assert "mine_eq_1.v" in (out / "COQ.md").read_text(encoding="utf-8")
