"""Rewrites are exact, say where they are legal, and give good names."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from sympy.codegen.cfunctions import expm1, hypot, log1p

from mechproof.programs import rounding_functions
from mechproof.programs.evaluation import Evaluation, arrange, entries, map_entries, unused_name
from mechproof.programs.lowering import FUNCTIONS
from mechproof.programs.operations import SYMBOLIC
from mechproof.programs.rewrites import REWRITES, apply_rewrites
from mechproof.programs.rounding_functions import ArctanQuotient, ProductRest
from mechproof.programs.step_names import share_subexpressions, suggest_name

# Functions that exist only for the way they round.
ROUNDED = [
    hypot,
    expm1,
    log1p,
    *(f for f in vars(rounding_functions).values() if isinstance(f, type)),
]
TINY = mp.mpf(10) ** -50
a, b, c, d, x, y = sp.symbols("a b c d x y", real=True)


def start(output: sp.Basic) -> Evaluation:
    return arrange(frozenset(output.free_symbols), [], output)


def expand(evaluation: Evaluation) -> sp.Basic:
    """Insert all steps, and replace functions that exist for their rounding by exact ones."""
    values = evaluation.step_values()

    def write(expression: sp.Expr) -> sp.Expr:
        expression = expression.xreplace(values)
        for function in ROUNDED:
            expression = expression.replace(function, SYMBOLIC[FUNCTIONS[function.__name__]])
        return expression

    return map_entries(write, evaluation.output)


def largest_difference(first: sp.Basic, second: sp.Basic, points: int = 5) -> mp.mpf:
    """Evaluate both at random points of (0, 1) to 60 digits; sums have three terms."""
    # Two different analytic functions agree to 50 digits at a random point with probability
    # about 1e-50, so neither false alarms nor missed differences occur.
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
    """Write out sums with three terms, with a symbol for each element."""
    counts = {
        s for t in expression.atoms(sp.Sum) for limit in t.limits for s in limit[2].free_symbols
    }
    expression = expression.subs(dict.fromkeys(counts, 3)).doit()
    items = sorted(expression.atoms(sp.Indexed), key=str)
    return expression.xreplace({item: sp.Symbol(f"item_{i:02}") for i, item in enumerate(items)})


CASES = {
    "low_word": arrange(frozenset({a, b}), [(x, a * b)], sp.sin(x) + sp.cos(2 * x)),
    "low_sum": arrange(
        frozenset({a, b}),
        [(x, a * b), (y, ProductRest(a, b, x))],
        b * (2 + a) + sp.sin(x + y),
    ),
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
    "quotient_arc": sp.atan(a / (1 + b * c)) + sp.atan(a) + sp.atan(a / 3),
    "cosine_minus_one": a * (sp.cos(x) * sp.cos(y) - 1) + sp.cos(x) * sp.sin(y),
    "hypotenuse": sp.sqrt(a**2 + b**2 + c**2) + sp.sqrt(x**2 + y**2) + sp.sqrt(a + b**2),
    "conjugate_root": a * sp.cos(x) + sp.sqrt(b**2 - a**2 * sp.sin(x) ** 2),
    "difference_of_functions": a * sp.sin(x + b) - a * sp.sin(x) + sp.atan(a + 1) - sp.atan(a),
    "difference_of_roots": x * (b - sp.sqrt(b**2 - 4 * a * c / 9)) + sp.sqrt(1 + a) - sp.sqrt(a),
    "difference_of_squares": 1 / sp.sqrt(b**2 - 4 * a**2 * x**2) + b**2 + a**2,
    "clenshaw": arrange(
        frozenset({a, b}),
        [(x, a * b)],
        a + b * sp.sin(x) + 2 * sp.sin(3 * x) - sp.sin(4 * x) / b,
    ),
    "in_single": arrange(frozenset({a, b}), [(x, a * b), (c, b**2)], a + c * sp.sin(x) * sp.cos(x)),
    "expm1_log1p": a * (sp.exp(b * x) - 1) + sp.log(1 + x * y),
    "name_coefficients": sp.ImmutableMatrix(
        [a * sp.sin(b) * x + sp.sin(a) * y + c, (a + b) * x - y + d]
    ),
}


def test_every_rewrite_has_a_case() -> None:
    # A rewrite that is exact only up to a bound is proved to keep that bound.
    assert {*CASES, "taylor"} == set(REWRITES)


@pytest.mark.parametrize("name", CASES)
def test_rewrite_changes_the_form_and_not_the_value(name: str) -> None:
    before = CASES[name] if isinstance(CASES[name], Evaluation) else start(CASES[name])
    after = REWRITES[name](before)
    assert after != before
    assert largest_difference(expand(before), expand(after)) < TINY


def test_the_comparison_rejects_a_slightly_wrong_form() -> None:
    wrong = CASES["conjugate_root"] + sp.Rational(1, 10**40)
    assert largest_difference(CASES["conjugate_root"], wrong) > TINY


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
    assert largest_difference(before.output, expand(after)) > 1


def angle_with_low_word(angle: sp.Symbol, rewrites: tuple[str, ...]) -> Evaluation:
    """Rewrite a quotient in sines and cosines of an angle that is itself a step, (a/b)*c."""
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
        assert largest_difference(expand(opaque), exact) < TINY


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
    assert largest_difference(expand(opaque), sp.sin(2 * a * b)) < TINY


@pytest.mark.parametrize("rewrites", [("low_sum",), ("low_word",), ("low_word", "low_sum")])
def test_low_sum_is_exact_whatever_the_product_is_rounded_to(rewrites: tuple[str, ...]) -> None:
    """(2 + k)*c + sin x, x = k*c, k = a/b; without both rewrites it depends on the roundings."""
    k = sp.Symbol("k", real=True)
    started = arrange(frozenset({a, b, c}), [(k, a / b), (x, k * c)], (2 + k) * c + sp.sin(x))
    done = apply_rewrites(started, rewrites)
    steps = [step for step in done.steps if step[0] not in (k, x)]
    opaque = arrange(done.inputs | {k, x}, steps, done.output)
    off = largest_difference(expand(opaque), (2 + a / b) * c + sp.sin(a / b * c))
    assert (off < TINY) == (len(rewrites) == 2)


def test_low_sum_leaves_other_products_alone() -> None:
    started = CASES["low_sum"]
    for output in (b * (2 + c), c * (2 + a), b * (2 - a), a * b):
        other = arrange(started.inputs | {c}, started.steps, output + y)
        assert REWRITES["low_sum"](other) == other


def test_low_product_leaves_out_only_the_product_of_the_rests() -> None:
    done = REWRITES["low_product"](CASES["low_product"])
    named = {str(symbol): symbol for symbol, _ in done.steps}
    one, other, high = named["one_minus_a"], named["two_plus_three_b"], named["x_high"]
    # The roundings of both factors and of their product are free symbols here.
    rounded = {one, other, high}
    steps = [step for step in done.steps if step[0] not in rounded]
    opaque = expand(arrange(done.inputs | rounded, steps, done.output))
    left_out = (1 - a - one) * (2 + 3 * b - other)
    exact = (1 - a) * (2 + 3 * b) + one * c
    assert largest_difference(opaque + left_out, exact) < TINY
    assert largest_difference(opaque, exact) > TINY


def test_small_arc_leaves_other_arcs_alone() -> None:
    done = REWRITES["small_arc"](CASES["small_arc"])
    assert done.output.count(sp.atan) == 2
    assert str(dict(done.steps)[y]) == "SmallArctan(TangentQuotient(c, a, 1, 0, b))"


@pytest.mark.parametrize(
    ("x_value", "y_value", "angle"),
    [(c * b, x / 2, "b*half_c"), (c * b, x / 3, "x/3"), (a * b, x / 2, "x/2")],
)
def test_small_arc_halves_what_is_prepared(x_value: sp.Expr, y_value: sp.Expr, angle: str) -> None:
    steps = [(c, a / 3), (x, x_value), (y, sp.tan(y_value)), (d, sp.atan(a * y / (1 + b * y**2)))]
    done = REWRITES["small_arc"](arrange(frozenset({a, b}), steps, c + d))
    assert str(dict(done.steps)[d]) == f"SmallArctan(TangentQuotient({angle}, a, 1, 0, b))"


def test_small_arc_adds_the_rest_of_a_sum() -> None:
    steps = [(c, 1 - a), (x, sp.tan(b)), (y, sp.atan(a * x / (c + (1 + a) * x**2)))]
    before = arrange(frozenset({a, b}), steps, y)
    done = REWRITES["small_arc"](before)
    found = {str(symbol): value for symbol, value in done.steps}
    assert str(found["c_low"]) == "SumRest(1, -a, c)"
    assert str(found["y"]) == "SmallArctan(TangentQuotient(b, a, c, c_low, a + 1))"
    # A larger term would not leave a rest that is a double.
    assert sp.Le(sp.Abs(a), 1) in done.obligations
    # The rounded c is a free symbol here, as a rest of it must make up for it.
    opaque = arrange(frozenset({a, b, c}), [s for s in done.steps if s[0] != c], done.output)
    exact = sp.atan(a * sp.tan(b) / (1 - a + (1 + a) * sp.tan(b) ** 2))
    assert largest_difference(expand(opaque), exact) < TINY
    rounded = arrange(frozenset({a, b, c}), [s for s in before.steps if s[0] != c], before.output)
    assert largest_difference(expand(rounded), exact) > TINY


def test_quotient_arc_leaves_other_arcs_alone() -> None:
    done = REWRITES["quotient_arc"](start(CASES["quotient_arc"]))
    assert done.output.count(sp.atan) == 2
    assert done.output.has(ArctanQuotient(a, 1 + b * c))


def test_the_sides_of_a_tangent_do_not_vanish_together() -> None:
    done = angle_with_low_word(x, ("low_word", "half_angle_tangent"))
    p, q = (s for name in ("opposite", "adjacent") for s, _ in done.steps if str(s) == name)
    for below, relations in (
        (a * q**2 + (2 + b) * p**2, ["b + 2 > 0", "a > 0"]),
        (q**2 + b * p**2, ["b > 0"]),
    ):
        arc = arrange(done.inputs, done.steps, sp.atan(p * q / below))
        assert [str(r) for r in REWRITES["quotient_arc"](arc).obligations] == relations
    for below in (a * q**2 + p, a * q**2 + b, p**2 - q, 1 + p * q):
        arc = arrange(done.inputs, done.steps, sp.atan(a / below))
        (relation,) = REWRITES["quotient_arc"](arc).obligations
        assert relation == (below.xreplace(arc.step_values()) > 0)


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


@pytest.mark.parametrize("expression", [a / 2 + b / 2, 2 * sp.atan2(a, b), sp.pi * sp.atan2(a, b)])
def test_a_name_with_a_gap_gives_way(expression: sp.Expr) -> None:
    assert suggest_name(expression) == "term"


OBLIGATIONS = {
    "positive_atan2": "2 - a*cos(x) > 0",
    "low_product": "Abs(a) <= 1",
    "small_arc": "a**2 <= 4*b/3",
    "quotient_arc": "b*c + 1 > 0",
    "difference_of_functions": "a*(a + 1) + 1 > 0",
    "conjugate_root": "-a**2 + b**2 >= 0",
}


@pytest.mark.parametrize("name", OBLIGATIONS)
def test_a_rewrite_that_is_not_always_legal_obliges_the_prover(name: str) -> None:
    before = CASES[name] if isinstance(CASES[name], Evaluation) else start(CASES[name])
    relations = {str(sp.simplify(r)) for r in REWRITES[name](before).obligations}
    expected = str(
        sp.simplify(sp.sympify(OBLIGATIONS[name], locals={str(s): s for s in (a, b, c, x)}))
    )
    assert expected in relations


def test_obligations_are_in_the_inputs_and_stay_with_later_rewrites() -> None:
    started = arrange(frozenset({a, b}), [(x, a * b)], sp.atan2(sp.sin(x), 2 - sp.cos(x)))
    done = apply_rewrites(started, ("positive_atan2", "half_angle_tangent"))
    assert [str(r) for r in share_subexpressions(done).obligations] == ["2 - cos(a*b) > 0"]


def test_a_series_by_clenshaw_has_one_sine() -> None:
    done = REWRITES["clenshaw"](CASES["clenshaw"])
    assert sum(e.count(sp.sin) for e in done.expressions()) == 1
    assert sum(e.count(sp.cos) for e in done.expressions()) == 1


def test_one_sine_is_no_series() -> None:
    before = arrange(frozenset({a, b}), [(x, a * b)], a + sp.sin(x))
    assert REWRITES["clenshaw"](before) == before


@pytest.mark.parametrize("function", [sp.Max, sp.Min])
def test_steps_come_in_the_order_of_the_arguments_in_every_run(function: type[sp.Expr]) -> None:
    # If taken from a set, whose order varies, 20 steps would be in order in one of 20! runs.
    steps = tuple((sp.Symbol(f"s{n}", real=True), x + n) for n in range(20))
    greatest = function(*(symbol for symbol, _ in steps))
    found = arrange(frozenset({x}), steps, greatest)
    assert [symbol for symbol, _ in found.steps] == list(greatest.args)
