"""Coq itself accepts what is proved, and refuses one wrong row for each kind of proof."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from sympy import (
    Derivative,
    Eq,
    Ge,
    Gt,
    IndexedBase,
    Integer,
    Integral,
    KroneckerDelta,
    Le,
    Lt,
    Ne,
    Rational,
    Sum,
    atan,
    atan2,
    cos,
    pi,
    sin,
    sqrt,
    symbols,
    tan,
)

from mechproof.coq import checker
from mechproof.coq.checker import check_files, find_assumptions
from mechproof.coq.scripts import LIBRARIES, PLAIN, read_library, write_script
from mechproof.coq.terms import give_laws, list_letters
from mechproof.coq.theorems import Theorem

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed")

e, v, x, y = symbols("e v x y", real=True)
POINT = {e: Rational(1, 2), v: Rational(1, 3), x: Rational(3, 4), y: Rational(5, 6)}
SHARE = (Ge(e, 0, evaluate=False), Lt(e, 1, evaluate=False))

LENGTHS = (
    Ge(y**2 - x**2, 0, evaluate=False),
    Ge(1 - x**2 / y**2, 0, evaluate=False),
    Lt(0, y, evaluate=False),
)
# The same integral over half the angle.
DOUBLED = Integral(2 / (1 - e * cos(2 * v)), (v, 0, x / 2))
TURNED = atan2(e * sin(x), 1 - e * cos(x))
HALF_TURN = (Gt(x, -pi, evaluate=False), Lt(x, pi, evaluate=False), Ne(cos(x / 2), 0))
# Written once, as a shared part.
ROOTS = sqrt(sqrt(2) + sqrt(3) + atan2(1, -2, evaluate=False))
FROM_ZERO = (Ge(x, 0, evaluate=False), Le(x, 1, evaluate=False))
VECTOR = (Ne(x**2 + y**2, 0),)
q = IndexedBase("q")
i, j, n = symbols("i j n", integer=True)
PICKED = Sum(KroneckerDelta(i, j) * q[i] * q[j], (i, 1, n), (j, 1, n))
WITHIN = (Lt(0, x, evaluate=False), Lt(0, y, evaluate=False), *SHARE)
TURN = (Lt(x, 1, evaluate=False), Lt(0, x, evaluate=False))
RATIO = (1 - e**2) / (1 - e * cos(x))
POLE = Ne(1 - e * cos(x), 0)
APART = Lt(0, y**2 - x**2, evaluate=False)
TURNING = 2 * tan(x) / (1 + 4 * x**2) + atan(2 * x) / cos(x) ** 2


def state(conclusion: object, *hypotheses: object) -> Theorem:
    met = set().union(*(part.free_symbols for part in (conclusion, *hypotheses)))
    letters = tuple(sorted(met, key=str))
    return Theorem(letters, hypotheses, conclusion, {s: POINT[s] for s in letters})


def state_sums(conclusion: object, of_all: bool = True) -> Theorem:
    letters = list_letters(conclusion)
    point = {n: Integer(2), **give_laws(letters, [conclusion], 1)}
    return Theorem(letters, (), conclusion, point, of_all)


def equal(left: object, right: object) -> object:
    return Eq(left, right, evaluate=False)


# A true statement and a wrong one for each kind of proof.
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
    "derivative": (
        state(equal(Derivative(RATIO, x), RATIO * e * sin(x) / (e * cos(x) - 1)), *SHARE, POLE),
        state(equal(Derivative(RATIO, x), RATIO * e * sin(x) / (1 - e * cos(x))), *SHARE, POLE),
    ),
    "derivative of a root": (
        state(equal(Derivative(sqrt(y**2 - x**2), x), -x / sqrt(y**2 - x**2)), *WITHIN[:2], APART),
        state(equal(Derivative(sqrt(y**2 - x**2), x), x / sqrt(y**2 - x**2)), *WITHIN[:2], APART),
    ),
    "derivative of an arctangent": (
        state(equal(Derivative(atan(2 * x) * tan(x), x), TURNING), Ne(cos(x), 0)),
        state(equal(Derivative(atan(3 * x) * tan(x), x), TURNING), Ne(cos(x), 0)),
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
    "shared numbers": (
        state(Lt(ROOTS * cos(ROOTS), -sin(ROOTS) - Rational(1, 3), evaluate=False)),
        state(Lt(ROOTS * cos(ROOTS), -sin(ROOTS) - 4, evaluate=False)),
    ),
    "integral": (
        state(equal(Integral(cos(e * v) * e, (v, 0, x)), sin(e * x)), *SHARE),
        state(equal(Integral(cos(e * v) * e, (v, 0, x)), cos(e * x)), *SHARE),
    ),
    "two integrals": (
        state(equal(Integral(1 / (1 - e * cos(v)), (v, 0, x)), DOUBLED), *SHARE),
        state(equal(Integral(1 / (1 + e * cos(v)), (v, 0, x)), DOUBLED), *SHARE),
    ),
    "need of an integrand": (
        state(Ne(1 - e * cos(v), 0), *SHARE),
        state(Ne(1 - cos(v), 0), *SHARE),
    ),
    "vector to the right": (
        state(equal(atan(e * sin(x) / (1 - e * cos(x))), TURNED), *SHARE, Ne(1 - e * cos(x), 0)),
        state(equal(atan(e * sin(x) / (1 + e * cos(x))), TURNED), *SHARE, Ne(1 + e * cos(x), 0)),
    ),
    "multiple of a vector": (
        state(equal(atan2(2 * v * x, 2 * v * y), atan2(x, y)), *VECTOR, Lt(0, v, evaluate=False)),
        state(equal(atan2(2 * v * x, 2 * v * y), atan2(x, y)), *VECTOR),
    ),
    "arctangents by derivatives": (
        state(equal(2 * atan((1 + e) / (1 - e) * tan(x / 2)), x + 2 * TURNED), *SHARE, *HALF_TURN),
        state(equal(2 * atan((1 + e) / (1 - e) * tan(x / 2)), x - 2 * TURNED), *SHARE, *HALF_TURN),
    ),
    "integral at a point": (
        replace(state(Ne(Integral(cos(e * v), (v, 0, x)), sin(x))), of_all=False),
        replace(state(equal(Integral(cos(e * v), (v, 0, x)), sin(x))), of_all=False),
    ),
    "vector of numbers": (
        state(Lt(atan2(1, -2, evaluate=False), Rational(27, 10), evaluate=False)),
        state(Lt(atan2(1, -2, evaluate=False), Rational(26, 10), evaluate=False)),
    ),
    "rise": (
        state(
            Le(sin(x), 2 * x, evaluate=False), Ge(x, 0, evaluate=False), Le(x, 1, evaluate=False)
        ),
        state(
            Le(2 * x, sin(x), evaluate=False), Ge(x, 0, evaluate=False), Le(x, 1, evaluate=False)
        ),
    ),
    "power": (
        state(Lt(0, x * y**v, evaluate=False), Lt(0, x, evaluate=False), Lt(0, y, evaluate=False)),
        state(Lt(0, -x * y**v, evaluate=False), Lt(0, x, evaluate=False), Lt(0, y, evaluate=False)),
    ),
    "square": (
        state(Le((x * cos(v) + y * sin(v)) ** 2, x**2 + y**2, evaluate=False)),
        state(Le(x**2 + y**2, (x * cos(v) + y * sin(v)) ** 2, evaluate=False)),
    ),
    "whole turn": (
        state(equal(sin(v * (x + 2 * pi / v)), sin(v * x)), Lt(0, v, evaluate=False)),
        state(equal(sin(v * (x + pi / v)), sin(v * x)), Lt(0, v, evaluate=False)),
    ),
    "point": (
        replace(state(Lt(sin(x), cos(x), evaluate=False)), of_all=False),
        replace(state(Lt(cos(x), sin(x), evaluate=False)), of_all=False),
    ),
    "sums": (
        state_sums(equal(PICKED, Sum(q[i] ** 2, (i, 1, n)))),
        state_sums(equal(PICKED, Sum(q[i], (i, 1, n)) ** 2)),
    ),
    "order of sums": (
        state_sums(
            equal(
                Sum(q[i] * sin(q[j]), (i, 1, n), (j, 1, n)),
                Sum(q[j] * sin(q[i]), (i, 1, n), (j, 1, n)),
            )
        ),
        state_sums(
            equal(
                Sum(q[i] * sin(q[j]), (i, 1, n), (j, 1, n)),
                Sum(q[j] * sin(q[j]), (i, 1, n), (j, 1, n)),
            )
        ),
    ),
    "sums at a point": (
        state_sums(Ne(PICKED, Sum(q[i], (i, 1, n)) ** 2), of_all=False),
        state_sums(equal(PICKED, Sum(q[i], (i, 1, n)) ** 2), of_all=False),
    ),
    "distances from bounds": (
        state(Lt(0, x + y + (y - x) * e**2, evaluate=False), *WITHIN),
        state(Lt(0, x - y + (y - x) * e**2, evaluate=False), *WITHIN),
    ),
    "size": (
        state(Le(x**2, y**2, evaluate=False), Le(abs(x), y, evaluate=False)),
        state(Le(x**2, y**2, evaluate=False), Le(x, y, evaluate=False)),
    ),
    "two roots": (
        state(equal(sqrt(x) * sqrt(1 - e), sqrt(x * (1 - e))), *WITHIN),
        state(equal(sqrt(x) * sqrt(1 + e), sqrt(x * (1 - e))), *WITHIN),
    ),
    "root of a quotient": (
        state(equal(sqrt(1 + x**2 / y**2) * y, sqrt(x**2 + y**2)), *WITHIN),
        state(equal(sqrt(1 + x**2 / y**2) * x, sqrt(x**2 + y**2)), *WITHIN),
    ),
    "square of a cosine": (
        state(Le(sin(x) ** 2, 1 + e**2 - 2 * e * cos(x), evaluate=False), *SHARE),
        state(Le(1 + e**2 - 2 * e * cos(x), sin(x) ** 2, evaluate=False), *SHARE),
    ),
    "twice an arctangent": (
        state(equal(cos(2 * atan(x) + y) * (1 + x**2), cos(y) * (1 - x**2) - 2 * x * sin(y))),
        state(equal(cos(2 * atan(x) + y) * (1 + x**2), cos(y) * (1 - x**2) + 2 * x * sin(y))),
    ),
    "opposite arctangents": (
        state(
            equal(atan((x - e) / (1 + x * e)), atan(x) - atan(e)), Ge(x, 0, evaluate=False), *SHARE
        ),
        state(
            equal(atan((x - e) / (1 + x * e)), atan(x) + atan(e)), Ge(x, 0, evaluate=False), *SHARE
        ),
    ),
    "witness": (
        state(Lt(0, 1 + x**2, evaluate=False), *SHARE, Le(e, x, evaluate=False)),
        state(Lt(0, 1 + x**2, evaluate=False), *SHARE, Lt(x, e, evaluate=False)),
    ),
}


AXIOM = "axiom.v"


@pytest.fixture(scope="module")
def planted(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, str]]:
    """Return a folder with compiled libraries, and the faults found in a script with an axiom."""
    folder = tmp_path_factory.mktemp("coq")
    for name in LIBRARIES:
        (folder / f"{name}.v").write_text(read_library(name), encoding="utf-8")
    text = write_script("axiom", [state(equal(Integer(1), Integer(1)))])
    text = text.replace("Theorem", "Axiom wrong : 1 = 2.\nTheorem")
    text = text.replace("at_point.", "pose proof wrong. lra.")
    text = text.replace(f"Import {LIBRARIES[0]}.", f"Import {LIBRARIES[-1]}.")
    (folder / AXIOM).write_text(text, encoding="utf-8")
    return folder, dict(check_files(folder, [AXIOM]))


@pytest.fixture(scope="module")
def proved(planted: tuple[Path, dict[str, str]]) -> set[str]:
    """Return the modules whose theorems Coq all accepts, in one run that goes on after errors."""
    folder, _ = planted
    texts = [f"Require Import {LIBRARIES[-1]}."]
    for name, pair in PAIRS.items():
        for kind, theorem in zip(("true", "wrong"), pair, strict=True):
            module = f"{name}_{kind}".replace(" ", "_")
            script = write_script(name, [theorem], 0 if name.startswith("shared") else PLAIN)
            script = re.sub(r"^(Require|Open) .*", "", script, flags=re.MULTILINE)
            script = script.replace("Qed.", "Qed.\nAbort All.")
            texts.append(f"Module {module}.\nOpen Scope R_scope.\n{script}\nEnd {module}.")
            texts.append(f"Check {module}.all_parts.")
    told = subprocess.run(
        ["coqtop", "-q", "-w", "none"],
        input="\n".join(texts),
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    return set(re.findall(r"^(\w+)\.all_parts\n", told.stdout, re.MULTILINE))


@pytest.mark.slow(together=True)
@needs_coq
@pytest.mark.parametrize("name", PAIRS)
def test_coq_accepts_the_true_and_refuses_the_wrong(name: str, proved: set[str]) -> None:
    module = name.replace(" ", "_")
    assert {f"{module}_true", f"{module}_wrong"} & proved == {f"{module}_true"}


@pytest.mark.slow
@needs_coq
def test_an_axiom_is_seen(planted: tuple[Path, dict[str, str]]) -> None:
    assert planted[1] == {AXIOM: "assumes axiom.wrong"}


def test_of_many_scripts_the_one_that_assumes_more_is_found(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def find_beyond(folder: Path, names: Sequence[str]) -> str:
        return "assumes wrong" if "c.v" in names else ""

    monkeypatch.setattr(checker, "_find_beyond", find_beyond)
    names = [f"{letter}.v" for letter in "abcde"]
    assert checker._check_assumptions(tmp_path, names) == {
        name: "assumes wrong" if name == "c.v" else "" for name in names
    }


def test_only_the_published_assumptions_pass() -> None:
    told = "Axioms:\nClassicalDedekindReals.sig_not_dec : forall P : Prop,\n  {~ ~ P} + {~ P}\n"
    assert find_assumptions(told) == set()
    assert find_assumptions(f"{told}Mine.wrong : 1 = 2\nMine.long\n  : 1 = 2\n") == {
        "Mine.wrong",
        "Mine.long",
    }


@pytest.mark.parametrize("name", LIBRARIES)
def test_nothing_is_left_unproved_in_what_scripts_require(name: str) -> None:
    for word in ("Axiom", "Admitted", "admit", "Parameter", "Conjecture", "Hypothesis", "Variable"):
        assert word not in read_library(name)
