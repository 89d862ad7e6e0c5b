"""Bounds of compiled kernels: what runs is what is proved, and what is wrong is refused."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from functools import cache
from importlib import import_module
from importlib.resources import files
from typing import Any

import numpy as np
import pytest
from compiled import grouped
from derived import paper_of
from flint import arb

from mechproof.codegen.elementary.formats import DOUBLE
from mechproof.codegen.elementary.functions import Function, build
from mechproof.codegen.kernel import input_names, list_functions
from mechproof.codegen.program import Operation, Program
from mechproof.measured import KERNELS
from mechproof.proof.balls import working_precision
from mechproof.roundoff import elementary
from mechproof.roundoff import subject as subject_module
from mechproof.roundoff.bound import Bar, Evaluation
from mechproof.roundoff.certificate import Claim, holds
from mechproof.roundoff.compiled import COMPILED, WAY, find_part
from mechproof.roundoff.elementary import prove
from mechproof.roundoff.ends import AT_ENDS
from mechproof.roundoff.files import find_certificate
from mechproof.roundoff.fused import fma
from mechproof.roundoff.germs import Frame
from mechproof.roundoff.intervals import ONE, Interval, careful
from mechproof.roundoff.profiles import Profile
from mechproof.roundoff.reduction import bound_reduction, find_nearest
from mechproof.roundoff.regions import list_regions
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run
from mechproof.roundoff.scales import find_scaled
from mechproof.roundoff.steps import Step, Straight
from mechproof.roundoff.subject import Subject, list_subjects
from mechproof.roundoff.symmetry import find_parities
from mechproof.roundoff.worst import draw

EPS = 2.0**-52
SYSTEMS = {
    "elliptic_planetary": ("ratio", "position", "acceleration"),
    "track_wheel": ("rotation", "displacement"),
}
NAMES = [f"{system}.{name}" for system, names in SYSTEMS.items() for name in names]
TRUTH: dict[str, Callable[..., arb]] = {
    "tan": arb.tan,
    "sin": arb.sin,
    "cos": arb.cos,
    "small_arctan": arb.atan,
    "arctan_quotient": lambda a, b: (a / b).atan(),
}


@cache
def subjects() -> tuple[Subject, ...]:
    found = []
    for system, names in SYSTEMS.items():
        paper = paper_of(system)
        kernels = [k for k in list_functions(paper) if k.name in names and k.is_shipped]
        found += [s for kernel in kernels for s in list_subjects(kernel, paper)]
    return tuple(found)


def compiled_subjects(name: str) -> Iterator[Subject]:
    return (s for s in subjects() if s.way == WAY and s.kernel.name == name.partition(".")[2])


def draw_points(subject: Subject, count: int, seed: int) -> Iterator[dict[str, Any]]:
    rng = np.random.default_rng(seed)
    for chart in subject.form.charts:
        for region in list_regions(chart):
            points = draw(subject, region, region.box, count, rng)
            inside = np.broadcast_to(subject.holds(points), count)
            yield {name: column[inside] for name, column in points.items()}


def list_arguments(subject: Subject, points: Mapping[str, Any]) -> list[Any]:
    """Return the arguments of a kernel, components put together."""
    names = input_names(subject.kernel.quantity)
    columns = [
        np.stack([points[names[s]] for s in argument.symbols], axis=-1)
        for argument in subject.kernel.quantity.arguments
    ]
    return [column[:, 0] if column.shape[1] == 1 else column for column in columns]


def measure_apart(
    subject: Subject, points: Mapping[str, Any], one: np.ndarray, other: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return how far two results are apart, and the scale of that; the scale is computed, too."""
    if subject.scale is None:
        return np.abs(one - other), np.abs(one)
    scale = np.broadcast_to(run(subject.scale, points, IN_DOUBLES)[0], len(one))
    if subject.map is None:
        return np.abs(one - other), scale.reshape(-1, *[1] * (one.ndim - 1))
    point, shift = (
        np.linalg.norm([points[name] for name in names], axis=0)
        for names in (subject.map.points, subject.map.shift)
    )
    return np.linalg.norm(one - other, axis=-1), scale * point + shift


@pytest.mark.parametrize("name", grouped(NAMES))
def test_what_is_proved_is_what_runs(name: str) -> None:
    """The steps in doubles have the bits of the kernels that numba compiles."""
    system, _, quantity = name.partition(".")
    kernel = getattr(import_module(f"mechproof.kernels.compiled.{system}"), quantity)
    for subject in compiled_subjects(name):
        for points in draw_points(subject, 400, 8):
            wanted = kernel(*list_arguments(subject, points))
            found = subject.compute(points)
            assert found.shape[1] > 50
            assert np.array_equal(np.moveaxis(found, 0, -1).ravel(), wanted.ravel())


@cache
def claims(system: str) -> tuple[Claim, ...]:
    certificate = find_certificate(files(KERNELS), system)
    assert certificate is not None
    return certificate.claims


@pytest.mark.parametrize("name", grouped(NAMES))
def test_both_kernels_differ_by_no_more_than_both_bounds(name: str) -> None:
    """On drawn points, and some ulps around those that are off most in any way."""
    system, _, quantity = name.partition(".")
    plain, fast = (
        getattr(import_module(f"mechproof.kernels{package}.{system}"), quantity)
        for package in ("", ".compiled")
    )
    rng = np.random.default_rng(3)
    for subject in compiled_subjects(name):
        told = [c for c in claims(system) if (c.quantity, c.form) == (quantity, subject.form.name)]
        (proved,) = (c.proved for c in told if c.way == WAY)
        both = proved + max(c.proved for c in told if c.way != WAY)
        hurting = {
            argument: np.concatenate([shake(float.fromhex(c.at[argument]), rng) for c in told])
            for argument in told[0].at
        }
        inside = np.broadcast_to(subject.holds(hurting), (len(told) * SHAKEN,))
        hurting = {argument: column[inside] for argument, column in hurting.items()}
        for points in (*draw_points(subject, 1000, 12), hurting):
            given = list_arguments(subject, points)
            apart, scale = measure_apart(subject, points, plain(*given), fast(*given))
            assert np.all(apart <= both * EPS * scale * (1 + 2.0**-40))


SHAKEN = 200


def shake(value: float, rng: np.random.Generator) -> np.ndarray:
    moved: np.ndarray = value + rng.integers(-9, 10, SHAKEN) * np.spacing(value)
    return moved


@pytest.mark.parametrize("name", ["elliptic_planetary.position", "track_wheel.rotation"])
def test_a_bound_lowered_by_a_tenth_is_refused(name: str) -> None:
    system, _, quantity = name.partition(".")
    subject = next(compiled_subjects(name))
    (claim,) = (
        c
        for c in claims(system)
        if (c.quantity, c.form, c.way) == (quantity, subject.form.name, WAY)
    )
    assert not holds(subject, replace(claim, proved=0.9 * claim.proved))


def test_a_claim_about_other_steps_or_functions_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    subject = next(compiled_subjects("track_wheel.rotation"))
    (claim,) = (c for c in claims("track_wheel") if (c.quantity, c.way) == ("rotation", WAY))
    assert subject.computed is not None
    for field in ("straight", "computed"):
        steps = getattr(subject, field)
        lost = replace(steps, steps=steps.steps[:-1])
        assert not holds(replace(subject, **{field: lost}), claim)
    changed = change("cos", lambda step: replace(step, kind="add") if step.kind == "fma" else step)
    monkeypatch.setattr(subject_module, "build", lambda *_: changed)
    assert not holds(subject, claim)


def test_what_is_proved_of_a_function_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """With worse functions the bound of a kernel is higher, with exact ones lower."""
    subject = next(compiled_subjects("elliptic_planetary.position"))
    region = next(list_regions(subject.form.charts[0]))
    boxes = np.array([[(0.3, 0.31) if np.isfinite(side[1]) else side for side in region.box]])
    whole = subject.bound(region, boxes)
    for factor in (0.0, 2.0):

        def scaled(kind: str, factor: float = factor) -> Profile:
            profile = prove(kind)
            unreduced = None if profile.unreduced is None else factor * profile.unreduced
            return replace(profile, highest=factor * profile.highest, unreduced=unreduced)

        monkeypatch.setattr(subject_module, "prove", scaled)
        assert np.sign(subject.bound(region, boxes) - whole) == np.sign(factor - 1)


def test_fused_ends_hold_what_is_fused_between_them() -> None:
    rng = np.random.default_rng(9)
    for signs in ((1, 1), (-1, 1), (1, -1), (-1, -1)):
        low = rng.uniform(0, 2, (3, 500))
        high = low * (1 + rng.uniform(0, 1, (3, 500)))
        a, b = (
            Interval(least, most) if sign > 0 else Interval(-most, -least)
            for sign, least, most in zip(signs, low, high, strict=False)
        )
        c = Interval(-high[2], -low[2])
        found = AT_ENDS["fma"](a, b, c)
        for share in np.linspace(0, 1, 9):
            x, y, z = (i.low + share * (i.high - i.low) for i in (a, b, c))
            inner = fma(*(np.clip(v, i.low, i.high) for v, i in ((x, a), (y, b), (z, c))))
            assert np.all((found.span.low <= inner) & (inner <= found.span.high))
    unknown = Interval(-low[0], high[0])
    assert not AT_ENDS["fma"](unknown, unknown, c).span.is_finite.any()


def test_fused_products_are_rounded_once() -> None:
    rng = np.random.default_rng(2)
    a, b = rng.normal(size=(2, 4000)) * 2.0 ** rng.integers(-40, 40, (2, 4000))
    near = -a * b * (1 + rng.integers(-2, 3, 4000) * EPS)
    c = np.where(rng.random(4000) < 0.6, near, rng.normal(size=4000) * 2.0 ** rng.integers(-60, 60))
    # Ties but for the rest of the product.
    a[:3], b[:3], c[:3] = 1 + EPS, [1 - EPS, 1 + EPS, 0.5], [2.0**53, -(2.0**54), 2.0**52]
    exact = [Fraction(x) * Fraction(y) + Fraction(z) for x, y, z in zip(a, b, c, strict=True)]
    assert fma(a, b, c).tolist() == [float(value) for value in exact]


def draw_arguments(kind: str, count: int) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(6)
    size = 2.0 ** rng.uniform(-30, 26, count) * rng.choice([-1, 1], count)
    if kind == "small_arctan":
        return (rng.uniform(-1, 1, count) * 3**-0.5,)
    if kind == "arctan_quotient":
        near = size * (1 + rng.integers(-3, 4, count) * EPS)
        return size, np.where(rng.random(count) < 0.3, near, rng.normal(size=count) * 9.0)
    quarters = np.rint(rng.uniform(0, 4e7, count) ** rng.uniform(0, 1, count)) * np.pi / 4
    return (np.where(rng.random(count) < 0.5, size, quarters),)


def look_up(kind: str, arguments: tuple[np.ndarray, ...]) -> np.ndarray:
    profile = prove(kind)
    if not profile.is_of_angles:
        with np.errstate(over="ignore"):
            size = np.abs(arguments[0] / (arguments[1] if len(arguments) > 1 else 1.0))
        return profile.of_size(Interval(size, size))
    (angle,) = arguments
    given = Interval(angle, angle)
    return profile.of_angle(given, given)


@pytest.mark.parametrize("kind", TRUTH)
def test_elementary_functions_are_off_by_no_more_than_is_proved(kind: str) -> None:
    arguments = draw_arguments(kind, 3000)
    found = COMPILED[kind](*arguments)
    errors = []
    with working_precision(300):
        for value, *given in zip(found, *arguments, strict=True):
            true = TRUTH[kind](*map(arb, map(float, given)))
            errors.append(float(abs(arb(float(value)) / true - 1)) / EPS)
    # The last quotient of a tangent is not among what is proved of its two parts.
    last = 0.5 if kind == "tan" else 0.0
    proved = look_up(kind, arguments)
    assert np.all(errors <= proved + last)
    assert max(errors) > 0.3 * prove(kind).most


@pytest.mark.parametrize("name", NAMES)
def test_without_roundings_compiled_steps_have_the_value_of_the_others(name: str) -> None:
    for subject in compiled_subjects(name):
        for points in draw_points(subject, 5, 4):
            for values in zip(*points.values(), strict=True):
                with working_precision(300):
                    given = dict(zip(points, map(arb, map(float, values)), strict=True))
                    pairs = zip(
                        run(subject.straight, given, IN_BALLS),
                        run(subject.exact, given, IN_BALLS),
                        strict=True,
                    )
                    assert all(abs(one - other) < arb(2) ** -150 for one, other in pairs)


def test_what_a_small_arctangent_is_not_meant_for_has_no_bound() -> None:
    profile = prove("small_arctan")
    large = Interval(np.array([0.5, 0.5]), np.array([0.6, 0.6]))
    assert np.isnan(profile.of_size(large)).all()
    found = profile.of_size(profile.limit(large, np.array([2.0**-40, np.inf])))
    assert found[0] <= profile.most
    assert np.isnan(found[1])


def test_half_turns_that_no_region_takes_off_have_no_bound() -> None:
    reduced = Straight(("y",), (Step("r", "pi_off", ("y",), 0.5),), ("r",))
    low, high = np.array([0.5, 0.5, 100.0]), np.array([1.5, 1.6, 100.1])
    frame = Frame([Interval(low, high)], [True])
    with careful(moves=False):
        evaluation = Evaluation(reduced, frame, {"y": frame.variable(0)}, {}, None)
        found = evaluation.sum_errors("r", Bar(None, True))
    assert found.tolist() == [0.0, np.inf, np.inf]


def test_angles_that_are_not_reduced_have_no_bound() -> None:
    far = np.array([2 * DOUBLE.largest, np.nan])
    assert np.isnan(prove("sin").of_angle(Interval(far, far), Interval(far, far))).all()


def test_the_steepest_quotients_have_a_bound() -> None:
    size = np.array([1e300, 2.0**45, 1.0, 0.0])
    found = prove("arctan_quotient").of_size(Interval(size, size))
    assert np.all(found <= prove("arctan_quotient").most)


def test_no_double_is_nearer_to_a_quarter_turn() -> None:
    """Doubles next to multiples of pi/2, the nearest of the whole range among them."""
    least = find_nearest(DOUBLE.largest)
    with working_precision(200):
        near = [arb(n) * arb.pi() / 2 for n in (*range(1, 2000), *range(2**25, 2**25 + 2000))]
        rests = [float(abs(arb(float(x)) - x)) for x in near]
    assert 0 < least <= min(rests)


def change(kind: str, edit: Callable[[Operation], Operation]) -> Function:
    function = build(kind, DOUBLE)
    operations = tuple(map(edit, function.program.operations))
    assert operations != function.program.operations
    program = Program(function.program.inputs, operations, function.program.outputs)
    return replace(function, program=program)


def prove_changed(kind: str, changed: Function, monkeypatch: pytest.MonkeyPatch) -> float:
    # What is proved of the function itself is kept: it must not be of the changed one.
    with monkeypatch.context() as patch:
        patch.setattr(elementary, "build", lambda *_: changed)
        return prove.__wrapped__(kind).most


@pytest.mark.parametrize("kind", TRUTH)
def test_a_wrong_coefficient_has_a_larger_bound(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    low = max(
        abs(o)
        for step in build(kind, DOUBLE).program.operations
        if step.kind == "fma"
        for o in step.operands[2:]
        if not isinstance(o, str)
    )

    def edit(step: Operation) -> Operation:
        last = step.operands[-1]
        if step.kind != "fma" or isinstance(last, str) or abs(last) != low:
            return step
        return replace(step, operands=(*step.operands[:2], last * (1 + 2.0**-40)))

    assert prove_changed(kind, change(kind, edit), monkeypatch) > 10 * prove(kind).most


def test_a_low_word_of_the_wrong_sign_has_a_larger_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    def edit(step: Operation) -> Operation:
        small = [isinstance(o, float) and 0 < abs(o) < 1e-10 for o in step.operands]
        return replace(step, kind="add") if step.kind == "subtract" and any(small) else step

    changed = change("arctan_quotient", edit)
    found = prove_changed("arctan_quotient", changed, monkeypatch)
    assert found > prove("arctan_quotient").most + 0.3


def test_a_reduction_by_fewer_words_is_refused() -> None:
    words = (-1.5707963267948966, -6.123233995736766e-17, 1.4973849048591698e-33)
    per = 0.6366197723675814
    assert 0 < bound_reduction(per, words).far < 0.1
    assert bound_reduction(per, (*words[:2], 0.0)).near > 1e6
    for wrong in (words[:2], (words[0], -words[1], words[2])):
        with pytest.raises(ValueError, match="quarter turn"):
            bound_reduction(per, wrong)
    with pytest.raises(ValueError, match="nearest"):
        bound_reduction(per * (1 + 2.0**-30), words)
    with pytest.raises(ValueError, match="may be rounded"):
        bound_reduction(per, (words[0] + 2.0**-20, *words[1:]))


def test_a_decision_without_a_rule_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def swap(step: Operation) -> Operation:
        return replace(step, kind="rint") if step.kind == "floor" else step

    # Halves of odd numbers rounded to even ones: the sign is another.
    with pytest.raises(ValueError, match="decides what rounding does"):
        prove_changed("cos", change("cos", swap), monkeypatch)


@pytest.mark.parametrize("added", [2 - EPS, 2.0**60])
def test_numbers_of_quarter_turns_that_are_rounded_are_refused(
    added: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a rounding 2 - eps has the signs of 1, but no large number is off by it."""

    def add(step: Operation) -> Operation:
        wrong = step.kind == "add" and step.operands[1:] == (1.0,)
        return replace(step, operands=(step.operands[0], added)) if wrong else step

    with pytest.raises(ValueError, match="may be rounded"):
        prove_changed("cos", change("cos", add), monkeypatch)


@pytest.mark.parametrize(("one", "other"), [("a", "b"), ("b", "a")])
def test_the_sign_of_another_argument_is_refused(
    one: str, other: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def swap(step: Operation) -> Operation:
        signed = step.kind == "copysign" and step.operands[1] == one
        return replace(step, operands=(step.operands[0], other)) if signed else step

    with pytest.raises(ValueError, match="the sign is not that of"):
        prove_changed("arctan_quotient", change("arctan_quotient", swap), monkeypatch)


def test_an_arctangent_of_more_than_a_quotient_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where the larger size is 1 the smaller one is the quotient."""
    steps = build("arctan_quotient", DOUBLE).program.operations
    (quotient,) = (step for step in steps if step.kind == "divide")
    last = [step for step in steps if step.kind == "fma"][-1]

    def swap(step: Operation) -> Operation:
        if step is not last:
            return step
        return replace(step, operands=(*step.operands[:2], quotient.operands[0]))

    assert last.operands[2] == quotient.result
    with pytest.raises(ValueError, match="scaled"):
        prove_changed("arctan_quotient", change("arctan_quotient", swap), monkeypatch)


def test_what_does_not_vanish_with_a_function_has_no_bound(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Sines for cosines and cosines for sines: one at 0 is off by more than any share of none."""

    def swap(step: Operation) -> Operation:
        condition, *both = step.operands
        inner = step.kind == "choose" and step is chosen
        return replace(step, operands=(condition, *both[::-1])) if inner else step

    chosen = next(s for s in build("sin", DOUBLE).program.operations if s.kind == "choose")
    assert prove_changed("sin", change("sin", swap), monkeypatch) == np.inf


def test_what_is_negated_is_not_compared() -> None:
    for step in (Step("q", "greater", ("y", 1), 0.0), Step("q", "choose", (1, "y", 1), 0.0)):
        with pytest.raises(ValueError, match="negated"):
            find_parities(Straight(("y",), (step,), ("q",)), {"y": -1})


def test_another_comparison_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def turn(step: Operation) -> Operation:
        return replace(step, operands=step.operands[::-1]) if step.kind == "greater" else step

    with pytest.raises(ValueError, match="only the sizes of both arguments"):
        prove_changed("arctan_quotient", change("arctan_quotient", turn), monkeypatch)


def test_a_scale_that_stays_is_refused() -> None:
    part = Step("t", "copy", (1.0,), 0.0, scaled="y")
    for kind, operands in (("add", ("t", 1)), ("arctan", ("t",)), ("square", ("t",))):
        with pytest.raises(ValueError, match="scaled"):
            find_scaled(Straight(("y",), (part, Step("q", kind, operands, 0.5)), ("q",)))
    whole = find_scaled(Straight(("y",), (part, Step("q", "divide", ("t", "t"), 0.5)), ("q",)))
    assert whole.scaled == ("t",)


def test_of_what_is_scaled_no_difference_is_exact() -> None:
    """Doubles so near to one another have an exact difference, but nobody knows these doubles."""
    steps = (
        Step("one", "multiply", ("y", 1.0), 0.0, scaled="y"),
        Step("other", "multiply", ("y", 1.0), 0.0, scaled="y"),
        Step("most", "multiply", ("other", 0.75), 0.5),
        Step("left", "subtract", ("one", "most"), 0.5),
        Step("q", "divide", ("left", "one"), 0.5),
    )
    straight = Straight(("y",), steps, ("q",))
    errors = []
    for some in (straight, find_scaled(straight)):
        frame = Frame([Interval(np.array([1.0]), np.array([1.0]))], [True])
        evaluation = Evaluation(some, frame, {"y": frame.variable(0)}, {}, None)
        errors.append(evaluation.list_errors("q", Bar(None, True))["left"])
    assert errors[0] == 0 < errors[1]


def test_an_argument_that_is_limited_may_be_off_by_nothing_held() -> None:
    """The exact argument is legal, the computed one may not be: all its roundings count."""
    steps = (Step("w", "square", ("y",), 0.5), Step("q", "arctan", ("w",), 1.0, "small_arctan"))
    side = Interval(np.array([0.75]), np.array([0.76]))
    frame = Frame([side], [True])
    for held in ((), ("w",)):
        straight = Straight(("y",), steps, ("q",), held)
        refused = pytest.raises(ValueError, match="held: ") if held else nullcontext()
        with careful(moves=False), refused:
            evaluation = Evaluation(straight, frame, {"y": frame.variable(0)}, {}, None, prove)
            assert evaluation.sum_errors("q", Bar(None, True)) < 3


def test_a_fused_sum_that_cancels_leaves_its_terms_their_roundings() -> None:
    """The spacing of what is left bounds the rounding of the sum alone."""
    steps = (
        Step("p", "multiply", ("a", "b"), 0.5),
        Step("n", "negate", ("p",), 0.0),
        Step("q", "fma", ("a", "b", "n"), 0.5),
    )
    side = Interval(np.array([1.0]), np.array([1.0 + 2.0**-20]))
    frame = Frame([side, side], [True, True])
    given = {"a": frame.variable(0), "b": frame.variable(1)}
    with careful(moves=False):
        evaluation = Evaluation(Straight(("a", "b"), steps, ("q",)), frame, given, {}, None)
        errors = evaluation.list_errors("q", Bar(frame.constant(ONE), False))
    a, b = 1 + np.random.default_rng(3).integers(0, 2**32, (2, 10000)) * EPS
    off = np.max(np.abs(fma(a, b, -(a * b)))) / EPS
    assert 0.45 < off <= errors["p"] < 0.51
    assert errors["q"] < 2.0**-18


def test_parts_of_another_program_are_refused() -> None:
    program = build("tangent_quotient", DOUBLE).program
    assert find_part(program, "tangent_above") != find_part(program, "tangent_below")
    with pytest.raises(ValueError, match="no part of"):
        find_part(build("sin", DOUBLE).program, "tangent_above")
