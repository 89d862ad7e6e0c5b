"""Formulas in other languages, run by their own interpreters, keep the bounds of the kernels."""

from __future__ import annotations

import ast
import ctypes
import json
import math
import re
import shutil
import subprocess
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import array_api_strict as standard
import numpy as np
import pytest
import sympy as sp
from c_libraries import STRICT, compile_files, needs_compiler
from derived import paper_of
from quantities import KERNELS, find_subject
from trial import load_source, paper_of as make_paper, quantity_of, x
from weights import first_of

import mechproof
from mechproof.cli.emit_command import SCRIPTS as COMMANDS
from mechproof.codegen.backends.standalone_functions import render_scripts
from mechproof.codegen.languages import SCRIPTS
from mechproof.lab.oracle import Truth, find_truth
from mechproof.lab.sampling.named_sets import choose_evenly, join
from mechproof.lab.worst_search import compare, draw_sets, mark_accuracy_domain
from mechproof.record.substitution import resolve

SYSTEMS = sorted({name.partition(".")[0] for name in KERNELS})
Points = tuple[Any, ...]
Values = dict[str, Any]


@cache
def points_of(name: str) -> Points:
    """Draw a few points from each set on which kernels are searched."""
    drawn = draw_sets(find_subject(name), 20271, 0.02)
    few = (tuple(c[choose_evenly(len(c), 4)] for c in part) for part in drawn)
    return tuple(np.asarray(column, float) for column in join(*few))


@cache
def truth_of(name: str) -> tuple[Truth, Any]:
    subject = find_subject(name)
    points = points_of(name)
    return find_truth(subject, points), mark_accuracy_domain(subject, points)


def worst(name: str, found: Any) -> float:
    """Return the largest error, in the units of the bound that tests hold the NumPy kernel to."""
    truth, within = truth_of(name)
    scaled = compare(lambda *_: found, points_of(name), truth)
    return float(np.max(np.where(within, scaled, -1.0)))


def bound_of(name: str) -> float:
    accuracy = find_subject(name).quantity.accuracy
    assert accuracy is not None
    return accuracy.ulp


def execute(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


def run_javascript(files: dict[str, str], names: list[str], folder: Path) -> Values:
    (module,) = files
    calls = []
    for name in names:
        rows = write_rows(points_of(name))
        function = name.replace(".", "_")
        calls.append(f"show([{rows}].map(row => m.{function}(...row)));")
    show = "const show = (v) => console.log(JSON.stringify(v.flat(), (k, n) => "
    show += "typeof n === 'number' && !Number.isFinite(n) ? String(n) : n));"
    (folder / "run.mjs").write_text(
        f'import * as m from "./{module}";\n{show}\n' + "\n".join(calls)
    )
    lines = execute(["node", "run.mjs"], folder).splitlines()
    return {name: read_numbers(json.loads(line)) for name, line in zip(names, lines, strict=True)}


def write_rows(points: Points) -> str:
    rows = zip(*(column.tolist() for column in points), strict=True)
    text = ",".join(repr([*row]) for row in rows)
    return text.replace("inf", "Infinity").replace("nan", "NaN")


def read_numbers(values: list[Any]) -> Any:
    return np.array([float(str(v).replace("Infinity", "inf")) for v in values])


def run_octave(files: dict[str, str], names: list[str], folder: Path) -> Values:
    lines = []
    for name in names:
        columns = ", ".join(write_matrix(column) for column in points_of(name))
        function = name.replace(".", "_")
        lines.append(f"r = {function}({columns})'; printf('%.17g ', r(:)); printf('\\n');")
    (folder / "calls.m").write_text("1;\n" + "\n".join(lines))
    command = ["octave", "--no-gui", "--no-init-file", "--quiet", "calls.m"]
    found = execute(command, folder).splitlines()
    return {
        name: np.array([*map(float, line.split())]) for name, line in zip(names, found, strict=True)
    }


def write_matrix(column: Any) -> str:
    rows = np.atleast_2d(column.T).T.tolist()
    text = ";".join(" ".join(map(repr, row)) for row in rows)
    return f"[{text}]".replace("inf", "Inf").replace("nan", "NaN")


def run_python(files: dict[str, str], names: list[str], folder: Path) -> Values:
    module = load_source(*files.values(), folder)
    return {
        name: np.ravel(getattr(module, name.replace(".", "_"))(*points_of(name))) for name in names
    }


def run_array_api(files: dict[str, str], names: list[str], folder: Path) -> Values:
    """Run the formulas with the library that has what the standard defines and nothing else."""
    module = load_source(*files.values(), folder)
    values: Values = {}
    for name in names:
        points = [standard.asarray(column) for column in points_of(name)]
        with np.errstate(all="ignore"):
            found = getattr(module, name.replace(".", "_"))(*points, xp=standard)
        values[name] = np.ravel(np.asarray(found))
    return values


def run_structured_text(files: dict[str, str], names: list[str], folder: Path) -> Values:
    """Interpret Structured Text: assignments, IF, RETURN and functions."""
    (text,) = files.values()
    functions = read_structured_text(text)
    values: Values = {}
    for name in names:
        function = functions[name.replace(".", "_").upper()]
        rows = zip(*(column.tolist() for column in points_of(name)), strict=True)
        values[name] = np.array([function(*row) for row in rows])
    return values


RUN = {
    "array_api": (run_array_api, "python3"),
    "javascript": (run_javascript, "node"),
    "octave": (run_octave, "octave"),
    "python": (run_python, "python3"),
    "structured_text": (run_structured_text, "python3"),
}


def read_structured_text(text: str) -> dict[str, Any]:
    """Return the functions of a source by name; outside the domain they give NaN, like NumPy."""
    text = re.sub(r"\(\*.*?\*\)", "", text, flags=re.S)
    spelled = {"TAN": np.tan, "SIN": np.sin, "COS": np.cos, "ATAN": np.arctan, "SQRT": np.sqrt}
    spelled |= {"ABS": abs, "ATAN2": np.arctan2, "EXP": np.exp, "ASIN": np.arcsin, "LN": np.log}
    known: dict[str, Any] = {**spelled, "EXPT": np.power, "ACOS": np.arccos, "TRUE": True}
    known["SEL"] = lambda which, off, on: on if which else off
    for head, body in re.findall(r"FUNCTION (\w+ : \w+)\n(.*?)END_FUNCTION", text, re.S):
        name = head.split()[0].upper()
        inputs = re.findall(r"\w+", re.search(r"VAR_INPUT(.*?)END_VAR", body, re.S)[1])  # type: ignore[index]
        inputs = [word.upper() for word in inputs if word != "LREAL"]
        code = re.sub(r"VAR\w*.*?END_VAR", "", body, flags=re.S)
        statements = [line.strip() for line in code.splitlines() if line.strip()]
        known[name] = _make(name, inputs, statements, known)
    return known


def _make(name: str, inputs: list[str], statements: list[str], known: dict[str, Any]) -> Any:
    def call(*values: float) -> Any:
        scope = dict(zip(inputs, map(np.float64, values), strict=True))
        taken = [True]
        for statement in statements:
            match statement.removesuffix(";").split(maxsplit=1):
                case ["IF", condition]:
                    taken.append(bool(_evaluate(condition.removesuffix(" THEN"), scope, known)))
                case ["END_IF"]:
                    taken.pop()
                case ["RETURN"] if all(taken):
                    break
                case [target, value] if all(taken):
                    with np.errstate(all="ignore"):
                        scope[target.upper()] = _evaluate(value.removeprefix(":= "), scope, known)
        return scope[name] if scope.get("VALID", True) else math.nan

    return call


def _evaluate(text: str, scope: dict[str, Any], known: dict[str, Any]) -> Any:
    python = re.sub(r"LREAL#", "", text)
    python = re.sub(r"(?<![<>:])=", "==", python)
    python = re.sub(r"[A-Za-z_]\w*(?<!\de)", lambda word: word[0].upper(), python)
    for sign in ("AND", "OR", "NOT"):
        python = re.sub(rf"\b{sign}\b", sign.lower(), python)
    return eval(compile(ast.parse(python, mode="eval"), "", "eval"), known, scope)


@pytest.mark.slow
@pytest.mark.parametrize("language", SCRIPTS)
@pytest.mark.parametrize("system", SYSTEMS)
def test_formulas_keep_the_bounds_of_the_kernels(
    system: str, language: str, tmp_path: Path
) -> None:
    run, program = RUN[language]
    if shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    files, refused = render_scripts(paper_of(system), language)
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    left_out = {reason.split()[0] for reason in refused}
    names = [n for n in KERNELS if n.startswith(f"{system}.") and n not in left_out]
    assert len(names) > 1
    for name, found in run(files, names, tmp_path).items():
        shape = truth_of(name)[0].high.shape
        assert worst(name, found.reshape(shape)) <= bound_of(name), (name, language)


def test_a_wrong_coefficient_is_seen(tmp_path: Path) -> None:
    name = "elliptic_planetary.position"
    files, _ = render_scripts(paper_of("elliptic_planetary"), "javascript")
    wrong = {
        file: text.replace(" + 2.0 * ", " + 2.000000000001 * ") for file, text in files.items()
    }
    for file, text in wrong.items():
        (tmp_path / file).write_text(text)
    assert wrong != files
    assert worst(name, run_javascript(wrong, [name], tmp_path)[name]) > bound_of(name)


@pytest.mark.parametrize("language", ["javascript", "octave", "python"])
def test_the_digits_are_those_of_numpy(language: str, tmp_path: Path) -> None:
    """Rests of products agree; a tangent may differ in the last digit between libraries.

    The form may also differ: NumPy's kernel uses the same form for all elements of an array.
    """
    run, program = RUN[language]
    if shutil.which(program) is None:
        pytest.skip(f"there is no {program}")
    name = "elliptic_planetary.position"
    files, _ = render_scripts(paper_of("elliptic_planetary"), language)
    for file, text in files.items():
        (tmp_path / file).write_text(text)
    found = run(files, [name], tmp_path)[name]
    kernel = import_module("mechproof.kernels.elliptic_planetary").position
    wanted = kernel(*points_of(name))
    near = np.abs(found - wanted) <= 2 * bound_of(name) * np.spacing(np.abs(wanted))
    assert (near | ~truth_of(name)[1]).all()
    assert np.mean(found == wanted) > 0.5


def test_formulas_of_a_quantity_need_nothing_beside_them(tmp_path: Path) -> None:
    found = mechproof.formula("elliptic_planetary.position")
    assert repr(found) == "Formula(name='elliptic_planetary.position')"
    names = ["latex", "mathml", "sympy", *SCRIPTS, "c"]
    names.remove("array_api")
    texts = [getattr(found, name) for name in names]
    texts.append(mechproof.formula("elliptic_planetary.position_tan_half").array_api)
    for text in texts:
        flat = re.sub(r"\s+(//|%|#|\*)?\s*", " ", text)
        assert "0 < R1, R2 < oo, 0 <= e < 1, R2 < R1" in flat
        assert "integral (9) of equation (8)" in flat
    assert r"\varphi_1" in found.latex
    assert "<mi>φ</mi>" in found.mathml


@pytest.mark.parametrize("name", ["elliptic_planetary.position", "track_wheel.displacement"])
def test_sympy_source_gives_the_definition(name: str) -> None:
    system, _, quantity = name.partition(".")
    scope: dict[str, Any] = {}
    exec(mechproof.formula(name).sympy, scope)
    definition = find_subject(name).quantity.definition
    assert scope[quantity] == resolve(definition, paper_of(system).given)


@needs_compiler
def test_the_source_in_c_is_whole(tmp_path: Path) -> None:
    text = mechproof.formula("elliptic_planetary.ratio").c
    library = compile_files(tmp_path, {"ratio.c": text}, STRICT)
    library.elliptic_planetary_ratio.restype = ctypes.c_double
    given = [ctypes.c_double(v) for v in (1.0, 66, 16, 0.475)]
    assert library.elliptic_planetary_ratio(*given) == pytest.approx(
        mechproof.EllipticPlanetary.published(2).ratio(1.0), rel=1e-15
    )


@pytest.mark.parametrize("name", [3, "position", "elliptic_planetary.speed"])
def test_what_has_no_formula_is_refused(name: Any) -> None:
    with pytest.raises((TypeError, ValueError), match=r"^name = .*must be"):
        mechproof.formula(name)


def test_what_a_language_cannot_compute_is_named() -> None:
    _, refused = render_scripts(paper_of("track_wheel"), "structured_text")
    assert "track_wheel.radius in structured_text: the language has no floor" in refused
    with pytest.raises(NotImplementedError, match="sum over"):
        _ = mechproof.formula("track_wheel.error_sum").octave


def test_there_is_a_command_for_each_language() -> None:
    assert {name.replace("-", "_") for name in COMMANDS} == SCRIPTS.keys() - {"python"}


def test_names_that_mean_something_else_are_spelled_otherwise() -> None:
    size, let = sp.symbols("size let", real=True)
    capital = sp.Symbol("X", real=True)
    paper = make_paper(quantity_of(sp.sin(x) * size + let * capital, x, size, let, capital))
    (octave,) = render_scripts(paper, "octave")[0].values()
    assert "system_f(x, size_, let, X)" in octave
    (script,) = render_scripts(paper, "javascript")[0].values()
    assert "system_f(x, size, let_, X)" in script
    (text,) = render_scripts(paper, "structured_text")[0].values()
    assert "v_X : LREAL" in text


@pytest.mark.parametrize("number", [0.1, 2.0**27 + 1, 5e-324, 1e23, 2 / 3])
@pytest.mark.parametrize("language", SCRIPTS)
def test_numbers_are_read_back_exactly(number: float, language: str) -> None:
    text = SCRIPTS[language].syntax.number(number)
    assert float(text.removeprefix("LREAL#")) == number
    in_single = float(np.float32(number)) == number
    assert (language != "structured_text") or text.startswith("LREAL#") != in_single


@pytest.mark.slow
@pytest.mark.parametrize(
    "system", first_of(["tooth_thickness", "elliptic_planetary", "oval_planetary"])
)
def test_structured_text_is_read_by_its_grammar(system: str) -> None:
    """The grammar is another project's, of the language as controllers implement it."""
    parse = pytest.importorskip("blark.parse")
    (text,) = render_scripts(paper_of(system), "structured_text")[0].values()
    assert parse.parse_source_code(text).exception is None
    assert parse.parse_source_code(text.replace(":=", "=")).exception is not None
