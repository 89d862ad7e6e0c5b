"""Bounds of elementary functions hold; those of altered functions are worse or refused."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from alterations import change, prove_changed
from flint import arb

from mechproof.arithmetic.balls import working_precision
from mechproof.arithmetic.intervals import EPS, Interval
from mechproof.programs.elementary.formats import DOUBLE
from mechproof.programs.elementary.function_programs import build
from mechproof.programs.program import Operation
from mechproof.roundoff.compiled_kernels import COMPILED, find_part
from mechproof.roundoff.elementary_errors import prove

TRUTH: dict[str, Callable[..., arb]] = {
    "tan": arb.tan,
    "sin": arb.sin,
    "cos": arb.cos,
    "small_arctan": arb.atan,
    "arctan_quotient": lambda a, b: (a / b).atan(),
    "arctan2": arb.atan2,
}


def draw_arguments(kind: str, count: int) -> tuple[np.ndarray, ...]:
    rng = np.random.default_rng(6)
    size = 2.0 ** rng.uniform(-30, 26, count) * rng.choice([-1, 1], count)
    if kind == "small_arctan":
        return (rng.uniform(-1, 1, count) * 3**-0.5,)
    if kind in ("arctan_quotient", "arctan2"):
        near = size * (1 + rng.integers(-3, 4, count) * EPS)
        return size, np.where(rng.random(count) < 0.3, near, rng.normal(size=count) * 9.0)
    quarters = np.rint(rng.uniform(0, 4e7, count) ** rng.uniform(0, 1, count)) * np.pi / 4
    return (np.where(rng.random(count) < 0.5, size, quarters),)


def look_up(kind: str, arguments: tuple[np.ndarray, ...]) -> np.ndarray:
    error_table = prove(kind)
    if not error_table.is_of_angles:
        with np.errstate(over="ignore"):
            size = np.abs(arguments[0] / (arguments[1] if len(arguments) > 1 else 1.0))
        return error_table.of_size(Interval(size, size))
    (angle,) = arguments
    given = Interval(angle, angle)
    return error_table.of_angle(given, given)


@pytest.mark.parametrize("kind", TRUTH)
def test_elementary_functions_are_off_by_no_more_than_is_proved(kind: str) -> None:
    arguments = draw_arguments(kind, 3000)
    found = COMPILED[kind](*arguments)
    errors = []
    with working_precision(300):
        for value, *given in zip(found, *arguments, strict=True):
            true = TRUTH[kind](*map(arb, map(float, given)))
            errors.append(float(abs(arb(float(value)) / true - 1)) / EPS)
    # The bounds proved for a tangent's two parts do not include their final quotient.
    last = 0.5 if kind == "tan" else 0.0
    proved = look_up(kind, arguments)
    assert np.all(errors <= proved + last)
    assert max(errors) > 0.3 * prove(kind).most


def test_what_a_small_arctangent_is_not_meant_for_has_no_bound() -> None:
    error_table = prove("small_arctan")
    large = Interval(np.array([0.5, 0.5]), np.array([0.6, 0.6]))
    assert np.isnan(error_table.of_size(large)).all()
    found = error_table.of_size(error_table.limit(large, np.array([2.0**-40, np.inf])))
    assert found[0] <= error_table.most
    assert np.isnan(found[1])


def test_the_steepest_quotients_have_a_bound() -> None:
    size = np.array([1e300, 2.0**45, 1.0, 0.0])
    found = prove("arctan_quotient").of_size(Interval(size, size))
    assert np.all(found <= prove("arctan_quotient").most)


@pytest.mark.slow
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


@pytest.mark.parametrize(
    ("kind", "one", "other"),
    [("arctan_quotient", "a", "b"), ("arctan_quotient", "b", "a"), ("arctan2", "a", "b")],
)
def test_the_sign_of_another_argument_is_refused(
    kind: str, one: str, other: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def swap(step: Operation) -> Operation:
        signed = step.kind == "copysign" and step.operands[1] == one
        return replace(step, operands=(step.operands[0], other)) if signed else step

    with pytest.raises(ValueError, match="does not change its sign with"):
        prove_changed(kind, change(kind, swap), monkeypatch)


def test_a_point_behind_is_not_taken_for_one_ahead(monkeypatch: pytest.MonkeyPatch) -> None:
    def swap(step: Operation) -> Operation:
        if step.kind != "choose" or step.operands[0] != behind.result:
            return step
        condition, *both = step.operands
        return replace(step, operands=(condition, *both[::-1]))

    behind = next(s for s in build("arctan2", DOUBLE).program.operations if s.kind == "less")
    assert prove_changed("arctan2", change("arctan2", swap), monkeypatch) > 1e10


@pytest.mark.parametrize("place", ["the limit", "what has the sign"])
def test_no_other_sign_is_decided(place: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A negative zero is not below zero."""

    def move(step: Operation) -> Operation:
        if place == "the limit":
            return replace(step, operands=(step.operands[0], 1.0)) if step.kind == "less" else step
        is_one = step.kind == "copysign" and step.operands[0] == 1.0
        return replace(step, operands=(0.0, step.operands[1])) if is_one else step

    with pytest.raises(ValueError, match="only the last argument is compared with zero"):
        prove_changed("arctan2", change("arctan2", move), monkeypatch)


def test_an_arctangent_of_more_than_a_quotient_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where the larger operand is 1, the smaller one equals the quotient."""
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
    """Sine and cosine are swapped: a value of 1 where 0 is due exceeds every relative bound."""

    def swap(step: Operation) -> Operation:
        condition, *both = step.operands
        inner = step.kind == "choose" and step is chosen
        return replace(step, operands=(condition, *both[::-1])) if inner else step

    chosen = next(s for s in build("sin", DOUBLE).program.operations if s.kind == "choose")
    assert prove_changed("sin", change("sin", swap), monkeypatch) == np.inf


def test_another_comparison_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def turn(step: Operation) -> Operation:
        return replace(step, operands=step.operands[::-1]) if step.kind == "greater" else step

    with pytest.raises(ValueError, match="only the sizes of both arguments"):
        prove_changed("arctan_quotient", change("arctan_quotient", turn), monkeypatch)


def test_parts_of_another_program_are_refused() -> None:
    program = build("tangent_quotient", DOUBLE).program
    assert find_part(program, "tangent_above") != find_part(program, "tangent_below")
    with pytest.raises(ValueError, match="not a part of"):
        find_part(build("sin", DOUBLE).program, "tangent_above")
