"""Rewrites are exact, names are good, bad records are refused, and the formula decides the file."""

from __future__ import annotations

import dataclasses
import importlib
import importlib.util
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from mechproof.codegen.backend import format_source, render_module, render_template
from mechproof.codegen.domain import set_relations
from mechproof.codegen.evaluation import Evaluation, arrange, entries, start_evaluation, unused_name
from mechproof.codegen.kernel import build_kernel, evaluate_quantity, take_shortcut
from mechproof.codegen.names import suggest_name
from mechproof.codegen.numpy_printer import NumpyPrinter
from mechproof.codegen.rewrites import REWRITES, apply_rewrites
from mechproof.codegen.subexpressions import count_operations, share_subexpressions
from mechproof.derivations import elliptic_planetary, track_wheel
from mechproof.record import Argument, Form, Paper, Quantity, Variable

ELLIPTIC, TRACK = elliptic_planetary.PAPER, track_wheel.PAPER
QUANTITIES = [
    (paper, version)
    for paper in (ELLIPTIC, TRACK)
    for quantity in paper.quantities
    for version in (quantity, take_shortcut(quantity))
    if version is not None
]
a, b, c, d, x, y = sp.symbols("a b c d x y", real=True)


def start(output: sp.Basic) -> Evaluation:
    return arrange(frozenset(output.free_symbols), [], output)


def largest_difference(first: sp.Basic, second: sp.Basic, points: int = 5) -> mp.mpf:
    """Evaluate both at random points of (0, 1) to 60 digits; sums have three terms."""
    # Two different analytic functions agree to 50 digits at a random point with probability
    # about 1e-50: no false alarm, and none missed.
    random = np.random.default_rng(7)
    worst = mp.mpf(0)
    with mp.workdps(60):
        for left, right in zip(entries(first), entries(second), strict=True):
            left, right = instance(left), instance(right)
            symbols = sorted(left.free_symbols | right.free_symbols, key=str)
            functions = [sp.lambdify(symbols, side, "mpmath") for side in (left, right)]
            for _ in range(points):
                values = [mp.mpf(float(v)) for v in sorted(random.random(len(symbols)))]
                worst = max(worst, abs(functions[0](*values) - functions[1](*values)))
    return worst


def instance(expression: sp.Expr) -> sp.Expr:
    """Write sums out for three terms, with a symbol for each element."""
    counts = {
        s for t in expression.atoms(sp.Sum) for limit in t.limits for s in limit[2].free_symbols
    }
    expression = expression.subs(dict.fromkeys(counts, 3)).doit()
    items = sorted(expression.atoms(sp.Indexed), key=str)
    return expression.xreplace({item: sp.Symbol(f"item_{i:02}") for i, item in enumerate(items)})


CASES = {
    "low_word": arrange(frozenset({a, b}), [(x, a * b)], sp.sin(x) + sp.cos(2 * x)),
    "low_product": arrange(
        frozenset({a, b, c}), [(x, (1 - a) * (2 + 3 * b)), (y, (1 - a) * c)], x + y
    ),
    "positive_atan2": sp.atan2(a * sp.sin(x), 2 - a * sp.cos(x)),
    "half_angle_tangent": a * sp.sin(x) / (1 + a**2 - 2 * a * sp.cos(x)) ** 2 + sp.cos(y) / (2 + b),
    "small_arc": arrange(
        frozenset({a, b, c}),
        [(x, sp.tan(c)), (y, sp.atan(a * x / (1 + b * x**2)))],
        y + sp.atan(a * x / (1 + b * x + x**2)) + sp.atan(a),
    ),
    "cosine_minus_one": a * (sp.cos(x) * sp.cos(y) - 1) + sp.cos(x) * sp.sin(y),
    "hypotenuse": sp.sqrt(a**2 + b**2 + c**2) + sp.sqrt(x**2 + y**2) + sp.sqrt(a + b**2),
    "conjugate_root": a * sp.cos(x) + sp.sqrt(b**2 - a**2 * sp.sin(x) ** 2),
    "difference_of_squares": 1 / sp.sqrt(b**2 - 4 * a**2 * x**2) + b**2 + a**2,
    "name_coefficients": sp.ImmutableMatrix(
        [a * sp.sin(b) * x + sp.sin(a) * y + c, (a + b) * x - y + d]
    ),
}


def test_every_rewrite_has_a_case() -> None:
    assert set(CASES) == set(REWRITES)


@pytest.mark.parametrize("name", CASES)
def test_rewrite_changes_the_form_and_not_the_value(name: str) -> None:
    before = CASES[name] if isinstance(CASES[name], Evaluation) else start(CASES[name])
    after = REWRITES[name](before)
    assert after != before
    assert largest_difference(before.expanded(), after.expanded()) < mp.mpf(10) ** -50


@pytest.mark.parametrize(("paper", "quantity"), QUANTITIES, ids=[q.name for _, q in QUANTITIES])
def test_kernel_evaluation_is_its_form_exactly(paper: Paper, quantity: Quantity) -> None:
    started = start_evaluation(quantity, paper).expanded()
    printed = evaluate_quantity(quantity, paper).expanded()
    assert largest_difference(started, printed) < mp.mpf(10) ** -50
    if quantity.form.bound is None:
        defined = dataclasses.replace(quantity, form=Form("definition", quantity.definition))
        exact = start_evaluation(defined, paper).expanded()
        assert largest_difference(started, exact) < mp.mpf(10) ** -50


def test_the_comparison_rejects_a_slightly_wrong_form() -> None:
    wrong = CASES["conjugate_root"] + sp.Rational(1, 10**40)
    assert largest_difference(CASES["conjugate_root"], wrong) > mp.mpf(10) ** -50


def test_half_angle_factors_coefficients() -> None:
    done = REWRITES["half_angle_tangent"](start(2 * a * sp.sin(x) / (1 - a * sp.cos(x))))
    steps = {str(symbol): value for symbol, value in done.steps}
    assert steps["one_minus_a"] == 1 - a
    assert steps["one_plus_a"] == 1 + a
    assert str(done.output) == "4*a*t/(one_minus_a + one_plus_a*t**2)"


def test_cancelled_ones_are_gone() -> None:
    done = REWRITES["cosine_minus_one"](start(sp.cos(x) * sp.cos(y) - 1))
    assert done.output.as_coeff_Add()[0] == 0
    assert not done.output.has(sp.cos)


def test_positive_atan2_is_wrong_on_the_other_side() -> None:
    before = start(sp.atan2(y, -x))
    after = REWRITES["positive_atan2"](before)
    assert largest_difference(before.output, after.expanded()) > 1


def angle_with_low_word(angle: sp.Symbol, rewrites: tuple[str, ...]) -> Evaluation:
    """Rewrite a quotient of an angle that is a step, (a/b)*c."""
    k = sp.Symbol("k", real=True)
    output = a * sp.sin(angle) / (2 - sp.cos(angle)) + sp.cos(angle)
    started = arrange(frozenset({a, b, c}), [(k, a / b), (angle, k * c)], output)
    return apply_rewrites(started, rewrites)


@pytest.mark.parametrize("rewrites", [("low_word",), ("low_word", "half_angle_tangent")])
def test_low_word_is_exact_whatever_the_product_is_rounded_to(rewrites: tuple[str, ...]) -> None:
    done = angle_with_low_word(x, rewrites)
    exact = (a * sp.sin(x) / (2 - sp.cos(x)) + sp.cos(x)).subs(x, a / b * c)
    # The roundings of a/b and of k*c are free symbols here.
    k = next(symbol for symbol, _ in done.steps if str(symbol) == "k")
    for rounded in ({x}, {k}, {x, k}):
        steps = [step for step in done.steps if step[0] not in rounded]
        opaque = arrange(done.inputs | rounded, steps, done.output)
        assert largest_difference(opaque.expanded(), exact) < mp.mpf(10) ** -50


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (a, "the angle x is not a step that multiplies two symbols"),
        (a * b * c, "the angle x is not a step that multiplies two symbols"),
        (3 * a * b, "the angle x has a factor 3, not a power of two"),
        (-a * b, "the angle x has a factor -1, not a power of two"),
    ],
)
def test_low_word_needs_a_product_of_two_symbols(value: sp.Expr, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        REWRITES["low_word"](arrange(frozenset({a, b, c}), [(x, value)], sp.sin(x)))


def test_low_word_of_a_doubled_product() -> None:
    done = REWRITES["low_word"](arrange(frozenset({a, b}), [(x, 2 * a * b)], sp.sin(x)))
    opaque = arrange(frozenset({a, b, x}), [s for s in done.steps if s[0] != x], done.output)
    assert largest_difference(opaque.expanded(), sp.sin(2 * a * b)) < mp.mpf(10) ** -50


def test_low_product_leaves_out_only_the_product_of_the_rests() -> None:
    done = REWRITES["low_product"](CASES["low_product"])
    named = {str(symbol): symbol for symbol, _ in done.steps}
    one, other, high = named["one_minus_a"], named["two_plus_three_b"], named["x_high"]
    # The roundings of both factors and of their product are free symbols here.
    rounded = {one, other, high}
    steps = [step for step in done.steps if step[0] not in rounded]
    opaque = arrange(done.inputs | rounded, steps, done.output).expanded()
    left_out = (1 - a - one) * (2 + 3 * b - other)
    exact = (1 - a) * (2 + 3 * b) + one * c
    assert largest_difference(opaque + left_out, exact) < mp.mpf(10) ** -50
    assert largest_difference(opaque, exact) > mp.mpf(10) ** -50


def test_small_arc_leaves_other_arcs_alone() -> None:
    done = REWRITES["small_arc"](CASES["small_arc"])
    assert done.output.count(sp.atan) == 2
    assert str(dict(done.steps)[y]) == "SmallArctan(a*TangentQuotient(c, 1, b))"


def test_homogeneous_half_angle_keeps_its_factors() -> None:
    steps = {str(s): v for s, v in angle_with_low_word(x, ("low_word", "half_angle_tangent")).steps}
    assert str(steps["opposite"]) == "t + t_low"
    assert str(steps["adjacent"]) == "-t*t_low + 1"
    assert str(steps["x_low"]) == "c*k_low + ProductRest(c, k, x)"


def test_small_tangent_is_its_argument() -> None:
    # The bound of the docstring, at its ends and between; the series decides the sign.
    with mp.workdps(60):
        for y in (mp.mpf(10) ** -40, mp.mpf(2) ** -27, mp.mpf("0.5"), mp.mpf(1)):
            assert 0 <= mp.tan(y) / y - 1 <= y**2
        assert mp.tan(mp.mpf("1.2")) / mp.mpf("1.2") - 1 > 0.8


def test_unknown_rewrite_is_named() -> None:
    with pytest.raises(ValueError, match="rewrite 'simplify' is not one of"):
        apply_rewrites(start(x), ("simplify",))


def test_shared_subexpressions_are_named_once_and_sums_keep_their_order() -> None:
    done = share_subexpressions(start(sp.sin(x) * a + sp.sin(x) ** 2 + sp.exp(a + b) * (a + b)))
    assert {str(s) for s, _ in done.steps} == {"sin_x", "a_plus_b"}
    assert count_operations(done) < count_operations(start(done.expanded()))
    assert share_subexpressions(start(a + b + c)).steps == ()


@pytest.mark.parametrize(
    ("expression", "name"),
    [(1 - a, "one_minus_a"), (a - b, "a_minus_b"), (sp.sin(x), "sin_x"), (x**2, "x_squared")],
)
def test_names(expression: sp.Expr, name: str) -> None:
    assert suggest_name(expression) == name
    assert unused_name(name, {name}) == f"{name}_2"


def test_a_long_name_gives_way() -> None:
    assert suggest_name(sp.sin(a + b) * sp.cos(x + y) * c) == "term"


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x / 2, "x / 2"),
        (-2 * a * x, "-2 * a * x"),
        (1 - a, "1 - a"),
        ((1 - a) / (1 + a), "(1 - a) / (1 + a)"),
        (x**3, "x * x ** 2"),
        (1 / (a * x), "1 / (a * x)"),
        (a * x / b, "a / b * x"),
        (x * (a - b), "(a - b) * x"),
        (sp.sqrt(sp.Rational(1, 3)) * x, "np.sqrt(3) / 3 * x"),
        (-(a + b) * x, "(-a - b) * x"),
        (sp.Piecewise((x, x >= 0), (a, True)), "choose_where(x >= 0, x, a)"),
    ],
)
def test_printed_expressions(expression: sp.Expr, text: str) -> None:
    printed = NumpyPrinter({}, frozenset({x})).print_expression(expression)
    assert printed == text


def test_what_has_no_row_is_refused() -> None:
    with pytest.raises(NotImplementedError, match=r"zeta|no row"):
        NumpyPrinter({}, frozenset()).print_expression(sp.zeta(x))
    with pytest.raises(ValueError, match="Interval, Naturals or Reals"):
        set_relations(x, sp.FiniteSet(1, 2))


def quantity_of(expression: sp.Basic, *symbols: sp.Symbol, names: str = "") -> Quantity:
    arguments = tuple(
        Argument(name, (symbol,), "a number")
        for name, symbol in zip(names.split() or map(str, symbols), symbols, strict=True)
    )
    return Quantity("f", "Compute f.", arguments, expression, Form("direct", expression), "here")


def paper_of(quantity: Quantity, *variables: Variable) -> Paper:
    return Paper("system", "citation", variables, (), quantities=(quantity,))


@pytest.mark.parametrize(
    ("quantity", "message"),
    [
        (quantity_of(a + b, a), r"symbols without a value: \['b'\]"),
        (quantity_of(sp.sin(a), a, b), r"arguments that do not occur: \['b'\]"),
        (quantity_of(a + b, a, b, names="a lambda"), "'lambda' cannot name a variable"),
        (quantity_of(a + b, a, b, names="a np"), "'np' cannot name a variable"),
        (quantity_of(a + b, a, b, names="a b+c"), r"'b\+c' cannot name a variable"),
    ],
)
def test_bad_quantities_are_refused(quantity: Quantity, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        build_kernel(quantity, paper_of(quantity))


def test_a_domain_needs_a_parameter_to_mask() -> None:
    quantity = quantity_of(sp.Matrix([a, b]), a, b)
    positive = sp.Interval.open(0, sp.oo)
    with pytest.raises(ValueError, match="no parameter through which"):
        build_kernel(quantity, paper_of(quantity, Variable(b, "a number", within=positive)))


def test_template_keys_are_the_data_keys(tmp_path: Path) -> None:
    (tmp_path / "t.jinja").write_text("{{ one }} {{ two }}")
    assert render_template("t.jinja", {"one": 1, "two": 2}, tmp_path) == "1 2"
    for data in ({"one": 1}, {"one": 1, "two": 2, "three": 3}):
        with pytest.raises(ValueError, match=r"asks for \['one', 'two'\]"):
            render_template("t.jinja", data, tmp_path)


def test_templates_hold_no_formula() -> None:
    folder = Path(render_template.__code__.co_filename).parent / "templates"
    for template in folder.glob("*.jinja"):
        assert not any(f"np.{f}(" in template.read_text() for f in ("sin", "cos", "tan", "sqrt"))


def test_source_that_is_not_python_is_refused() -> None:
    with pytest.raises(ValueError, match="formatter rejects"):
        format_source("def f(:\n")


def load(paper: Paper, folder: Path) -> ModuleType:
    """Import the rendered module from a package of its own."""
    package = folder / f"package_{len(list(folder.iterdir()))}"
    package.mkdir()
    files = {"__init__.py": "", "kernels.py": render_module(paper)}
    for name, text in files.items():
        (package / name).write_text(text)
    for name in (package.name, f"{package.name}.kernels"):
        path = package / ("__init__.py" if name == package.name else "kernels.py")
        spec = importlib.util.spec_from_file_location(name, path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)
    return module


def test_a_changed_coefficient_changes_the_kernel(tmp_path: Path) -> None:
    def scaled(factor: sp.Expr) -> Paper:
        ratio = ELLIPTIC.quantities[0]
        expression = ratio.form.expression.subs(elliptic_planetary.k, factor)
        form = dataclasses.replace(ratio.form, expression=expression)
        return dataclasses.replace(ELLIPTIC, quantities=(dataclasses.replace(ratio, form=form),))

    k = elliptic_planetary.k
    same, changed = (load(scaled(f), tmp_path) for f in (k, sp.Rational(11, 10) * k))
    arguments = (0.3, 66, 16, 0.475)
    shipped = importlib.import_module("mechproof.kernels.elliptic_planetary")
    assert same.ratio(*arguments) == shipped.ratio(*arguments)
    deviation = (changed.ratio(*arguments) - 1) / (same.ratio(*arguments) - 1)
    assert deviation == pytest.approx(1.1, rel=1e-14)


def test_rendering_does_not_depend_on_the_hash_seed() -> None:
    script = (
        "import hashlib, sys; sys.path.insert(0, sys.argv[1]); import test_codegen as t;"
        "text = t.render_module(t.ELLIPTIC) + t.render_module(t.TRACK);"
        "print(hashlib.sha256(text.encode()).hexdigest())"
    )
    digests = {
        subprocess.run(
            [sys.executable, "-c", script, str(Path(__file__).parent)],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "4242")
    }
    assert len(digests) == 1
