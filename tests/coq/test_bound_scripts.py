"""Bounds of programs in Coq: scripts state what they should, and Coq refuses wrong ones."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from mechproof.coq.checker import check_files, is_installed
from mechproof.coq.rounding_scripts import (
    BoundTheorem,
    ElementaryCase,
    list_elementary,
    write_bound_script,
)
from mechproof.coq.script_comparison import ReadBackError, compare_bound_script
from mechproof.coq.scripts import ROUNDINGS, read_library
from mechproof.coq.terms import UnwritableError
from mechproof.pipeline.bound_scripts import prove_in_coq
from mechproof.pipeline.bounding import read_boundings
from mechproof.roundoff.boxed import Convention, find_worst_input, put_in_box
from mechproof.roundoff.steps import HALF, Step, StraightLineProgram

CORES = """
(FPCore (u v T) :name "doppler1" :pre (and (<= -100 u 100) (<= 20 v 20000) (<= -30 T 50))
  (let ([t1 (+ 331.4 (* 0.6 T))]) (/ (* (- t1) v) (* (+ t1 u) (+ t1 u)))))
(FPCore (x) :name "root" :pre (<= 1/3 x 7) (sqrt (- (fma x x 2) (* 0.1 x))))
(FPCore (x y) :name "waves" :pre (and (<= -1 x 1) (<= 1/4 y 1))
  (+ (* (sin x) (cos y)) (- (atan (tan (* x y))) (log (+ (exp x) y)))))
"""
WAVES = 2
needs_coq = pytest.mark.skipif(not is_installed(), reason="Coq is not installed")
ONE, TWO = Fraction(1), Fraction(2)


def state(number: int, bound: Fraction, folder: Path, relative: bool = False) -> BoundTheorem:
    file = folder / "cores.fpcore"
    file.write_text(CORES, encoding="utf-8")
    bounding = read_boundings(file)[number]
    program = put_in_box(bounding.straight, bounding.ranges, Convention(ulps=HALF))
    return BoundTheorem(program.straight, program.ranges, bound, relative)


@pytest.mark.parametrize("relative", [False, True])
@pytest.mark.parametrize("number", [0, 1, WAVES])
def test_a_script_says_what_it_was_written_from(
    number: int, relative: bool, tmp_path: Path
) -> None:
    theorem = state(number, Fraction(1, 10**12), tmp_path, relative)
    compare_bound_script(write_bound_script("it", theorem), theorem)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("w4 := w1 + w3", "w4 := w1 - w3"),
        ("w4 := w1 + w3", "w4 := w1"),
        ("v4 := rounded (v1 + v3)", "v4 := v1 + v3"),
        ("v8 := rounded (v7 * v7)", "v8 := rounded (v7 * v6)"),
        ("v5 := - v4", "v5 := v4"),
        ("w1 := 1657 / 5", "w1 := 1658 / 5"),
        ("2915025227559731 /", "2915025227559732 /"),
        ("u <= 100 ->", "u <= 99 ->"),
        ("-100 <= u", "-100 < u"),
        ("(v9 - w9)", "(v9 - v9)"),
        ("(v9 - w9)", "(w9 - w9)"),
        ("(v9 - w9)", "(v9 - w8)"),
        ("<= 1 / 1000000000000.", "<= 1 / 100000000000."),
        ("forall u v T", "forall u T v"),
        ("Theorem bound", "Theorem more : 0 <= 1.\nProof. lra. Qed.\nTheorem bound"),
    ],
)
def test_another_statement_is_caught(old: str, new: str, tmp_path: Path) -> None:
    theorem = state(0, Fraction(1, 10**12), tmp_path)
    text = write_bound_script("it", theorem)
    assert text.count(old) == 1
    with pytest.raises(ReadBackError):
        compare_bound_script(text.replace(old, new), theorem)


@pytest.mark.parametrize(
    ("step", "said"),
    [
        (Step("r", "sinh", ("x",), HALF), "the analysis does not know sinh"),
        (
            Step("r", "multiply", ("x", "x"), 1.0),
            "multiply within 1 ulp: the analysis rounds to nearest",
        ),
        (Step("q", "multiply", ("x", "x"), HALF), "exactly one output, the result of a step"),
    ],
)
def test_what_the_analysis_has_not_is_named(step: Step, said: str) -> None:
    outputs = ("r",) if step.result == "r" else ("q", "x")
    straight = StraightLineProgram(("x",), (step,), outputs)
    with pytest.raises(UnwritableError, match=said):
        write_bound_script("it", BoundTheorem(straight, {"x": (ONE, TWO)}, ONE))


def test_a_title_ends_no_comment(tmp_path: Path) -> None:
    theorem = state(0, ONE, tmp_path)
    text = write_bound_script('*) Axiom a : 1 = 2. (* "', theorem)
    assert text.splitlines()[0] == "(* ) Axiom a : 1 = 2. (  *)"
    compare_bound_script(text, theorem)


@needs_coq
def test_where_nothing_is_proved_coq_is_not_asked(tmp_path: Path) -> None:
    file = tmp_path / "cores.fpcore"
    file.write_text('(FPCore (x) :name "pole" :pre (<= 0 x 1) (/ 1 x))', encoding="utf-8")
    folder = tmp_path / "coq"
    (one,) = prove_in_coq(read_boundings(file), [math.inf], Convention(), folder)
    assert one.reason == "there is no bound to begin with"
    assert not one.file
    assert not [*folder.glob("bound*")]


def test_nothing_is_left_unproved_in_the_analysis() -> None:
    for word in ("Axiom", "Admitted", "admit", "Parameter", "Conjecture", "Hypothesis", "Variable"):
        assert word not in read_library(ROUNDINGS)


def find_case(name: str) -> ElementaryCase:
    (case,) = (case for case in list_elementary() if case.name == name)
    return case


@pytest.mark.parametrize("case", [*list_elementary()], ids=lambda case: case.name)
def test_an_elementary_function_is_stated_as_it_is_computed(case: ElementaryCase) -> None:
    theorem = case.state(Fraction(2))
    compare_bound_script(write_bound_script("it", theorem, case.enclosure), theorem, case.enclosure)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("(sin rest)", "(cos rest)"),
        ("w14 - (sin", "w14 + (sin"),
        ("w14 - (sin", "w13 - (sin"),
        ("0 <= rest -> rest", "1 / 8 <= rest -> rest"),
        ("<= 1 / 18014398509481984.", "<= 1 / 18014398509481983."),
    ],
)
def test_another_enclosure_is_caught(old: str, new: str) -> None:
    case = find_case("sin_0")
    theorem = case.state(Fraction(2))
    text = write_bound_script("it", theorem, case.enclosure)
    head, enclosed = text.split("Theorem enclosed")
    assert enclosed.count(old) == 1, enclosed
    altered = f"{head}Theorem enclosed{enclosed.replace(old, new)}"
    with pytest.raises(ReadBackError):
        compare_bound_script(altered, theorem, case.enclosure)
    with pytest.raises(ReadBackError):
        compare_bound_script(text, theorem)


def write_bounds(folder: Path) -> dict[str, str]:
    """Return scripts by name: of bounds that hold, and of bounds and programs that fail."""
    # FPTaylor proves 1.06e-13 for the first. For each, a bound below the worst error found fails.
    bounds = {
        "first": (0, Fraction(985, 10**16)),
        "second": (1, Fraction(13, 10**16)),
        "share": (1, Fraction(9, 10**16)),
        "waves": (WAVES, Fraction(1, 10**15)),
    }
    texts = {}
    for name, (number, bound) in bounds.items():
        theorem = state(number, bound, folder, relative=name == "share")
        convention = Convention(relative=theorem.relative, ulps=HALF)
        program = put_in_box(theorem.straight, theorem.ranges, convention)
        worst = find_worst_input(program, (program.box,))
        assert worst is not None
        # NumPy's functions may be off by more than half an ulp.
        found = Fraction(worst.error) * (Fraction(1, 2) if number == WAVES else Fraction(99, 100))
        for kind, at_most in (("holds", bound), ("fails", found)):
            texts[f"{name}_{kind}"] = write_bound_script(name, replace(theorem, bound=at_most))
    # Another program than the one that is stated, and a divisor that may vanish.
    text = write_bound_script("it", state(0, Fraction(1, 10**12), folder))
    wrong = {
        "other": text.replace("Rounded (Sum 2 0)", "Rounded (Difference 2 0)"),
        "unrounded": text.replace("Rounded (Sum 2 0)", "Exact (Sum 2 0)"),
        "smaller_box": text.replace("(100, 1)%Z)", "(99, 1)%Z)"),
        "pole": text.replace("-100 <= u", "-400 <= u").replace("((-100, 1)", "((-400, 1)"),
    }
    waves = write_bound_script("it", state(WAVES, Fraction(1, 10**12), folder))
    wrong |= {
        "tangent": waves.replace("x <= 1 ->", "x <= 2 ->").replace(
            "((-1, 1)%Z, (1,", "((-1, 1)%Z, (2,"
        ),
        "logarithm": waves.replace("1 / 4 <=", "-1 <=").replace("((1, 4)%Z", "((-1, 1)%Z"),
        "sine": waves.replace("Called Sine", "Called Cosine"),
    }
    assert not {text, waves} & {*wrong.values()}
    return texts | {f"{name}_fails": altered for name, altered in wrong.items()}


def write_enclosures(name: str) -> dict[str, str]:
    """Return scripts on a program's distance from its function: one that holds, two that fail."""
    case = find_case(name)
    assert case.enclosure is not None
    near = replace(case.enclosure, off=Fraction(1, 2**70))
    return {
        f"{name}_holds": write_bound_script("it", case.state(Fraction(7, 10)), case.enclosure),
        f"{name}_near_fails": write_bound_script("it", case.state(Fraction(7, 10)), near),
        f"{name}_half_fails": write_bound_script("it", case.state(Fraction(1, 2)), case.enclosure),
    }


def judge(texts: Mapping[str, str], folder: Path) -> None:
    """Assert that Coq accepts the scripts that hold and refuses those named to fail."""
    for name, text in {ROUNDINGS: read_library(ROUNDINGS), **texts}.items():
        (folder / f"{name}.v").write_text(text, encoding="utf-8")
    for file, fault in check_files(folder, [f"{name}.v" for name in texts]).items():
        assert bool(fault) == file.endswith("_fails.v"), (file, fault)


@pytest.mark.slow
@needs_coq
def test_coq_accepts_what_holds_and_nothing_else(tmp_path: Path) -> None:
    # Coq lists the assumptions of all scripts in the time that it takes for one.
    judge(write_bounds(tmp_path) | write_enclosures("sin_0"), tmp_path)


@pytest.mark.thorough
@needs_coq
def test_coq_encloses_another_function(tmp_path: Path) -> None:
    judge(write_enclosures("small_arctan"), tmp_path)
