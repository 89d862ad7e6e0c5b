"""Bounds over boxes hold for computed values, and are as tight as those of other tools."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from mechproof.arithmetic.cover import Largest, bound_largest
from mechproof.fpcore import Core, read_cores
from mechproof.roundoff.boxed import BoxedProgram, Convention, find_worst_input, measure, put_in_box

FILE = Path(__file__).parents[2] / "docs" / "fpbench" / "benchmarks.fpcore"
DOUBLES, REAL = Convention(ulps=0.5), Convention(rounded_inputs=True, ulps=0.5)
RELATIVE = Convention(relative=True)
COARSE = 0.02
# Bounds of these programs under these conventions by FPTaylor (Solovyev et al. 2018), the last by
# Gappa (Daumas and Melquiond 2010) with its box cut into parts.
QUICK = {
    "verhulst": (1.811e-16, 2.496e-16),
    "rigidBody1": (2.132e-13, 2.949e-13),
    "doppler1": (1.061e-13, 1.287e-13),
    "carbonGas": (5.140e-9, 6.076e-9),
    "himmilbeau": (4.406e-13, 8.509e-13),
}


@cache
def cores() -> dict[str, Core]:
    return {core.name: core for core in read_cores(FILE.read_text("utf-8"))}


def program_of(name: str, convention: Convention) -> BoxedProgram:
    core = cores()[name]
    return put_in_box(core.straight, core.box, convention)


def bound_of(program: BoxedProgram, tolerance: float = COARSE, parts: int = 20_000) -> Largest:
    return bound_largest(program.bound, program.box, tolerance, parts)


@pytest.mark.slow
@pytest.mark.parametrize("name", QUICK)
def test_bounds_are_as_tight_as_those_of_others_and_nothing_exceeds_them(name: str) -> None:
    for convention, other in zip((DOUBLES, REAL), QUICK[name], strict=True):
        program = program_of(name, convention)
        largest = bound_of(program)
        assert largest.bound <= 1.02 * other
        assert largest.reached <= largest.bound <= (1 + COARSE) * largest.reached
        worst = find_worst_input(program, (program.box, *largest.highest))
        assert worst is not None
        assert 0.75 * largest.bound <= worst.error <= largest.bound


def test_a_bound_that_is_too_low_is_exceeded_by_an_input() -> None:
    """The twin: leaving out one step's rounding lowers the bound, and the search exceeds it."""
    program = program_of("verhulst", DOUBLES)
    steps = tuple(
        replace(step, ulps=0.0) if step.kind == "divide" else step
        for step in program.straight.steps
    )
    wrong = replace(program, straight=replace(program.straight, steps=steps))
    worst = find_worst_input(wrong, (wrong.box,))
    assert worst is not None
    assert worst.error > bound_of(wrong).bound
    assert measure(program, worst.at) == worst.error


def test_inputs_that_are_not_rounded_are_exceeded_by_real_ones() -> None:
    real, doubles = (program_of("verhulst", convention) for convention in (REAL, DOUBLES))
    worst = find_worst_input(real, (real.box,))
    assert worst is not None
    assert bound_of(doubles).bound < worst.error < bound_of(real).bound
    assert all(float(value) != value for value in worst.at.values())


@pytest.mark.slow
def test_relative_errors_are_bounded_where_the_value_does_not_vanish() -> None:
    program = program_of("predatorPrey", RELATIVE)
    worst = find_worst_input(program, (program.box,))
    largest = bound_of(program)
    assert worst is not None
    assert 0.7 * largest.bound <= worst.error <= largest.bound < 6e-16
    # A sum of squares that is zero where no input is zero.
    assert bound_of(program_of("himmilbeau", RELATIVE), parts=2000).bound == np.inf


@pytest.mark.parametrize("tiny", [Fraction(2) ** -1070, Fraction(2) ** -600])
def test_what_falls_below_the_normal_range_is_not_searched(tiny: Fraction) -> None:
    """There the rounding of an input or a product is not bounded by a share of its value."""
    (core,) = read_cores("(FPCore (x) :pre (<= 0 x 1) (* x x))")
    program = put_in_box(core.straight, core.box, Convention(True, True))
    assert measure(program, {"x": tiny / 3}) == -1.0
    assert measure(program, {"x": Fraction(1, 3)}) > 0
    near = find_worst_input(program, (((0.0, float(tiny)),),))
    assert near is None or near.error <= bound_of(program).bound


def test_what_vanishes_with_an_input_keeps_a_relative_bound() -> None:
    """For x/(x + 1) on [0, 999]: two roundings of half an ulp each, down to zero."""
    largest = bound_of(program_of("t_div_t1", RELATIVE))
    assert largest.bound <= 2.04 * 2.0**-53


def test_a_pole_is_named() -> None:
    (core,) = read_cores("(FPCore (x) :pre (<= -1 x 1) (/ 1 (- x 0.5)))")
    largest = bound_of(put_in_box(core.straight, core.box, DOUBLES))
    assert largest.bound == np.inf
    assert largest.open is not None
    ((low, high),) = largest.open
    assert low <= 0.5 <= high


def test_the_errors_of_numbers_are_known_with_their_signs() -> None:
    """The differences are exact: only the numbers themselves have errors."""
    text = "(FPCore (x) :pre (<= 0.0625 x 0.125) (- {} x))"
    for number, wrong in (("(/ 1 10)", Fraction(1, 10)), ("(- 0.3 0.2)", Fraction(1, 10))):
        (core,) = read_cores(text.format(number))
        largest = bound_of(put_in_box(core.straight, core.box, DOUBLES))
        double = 0.1 if number.startswith("(/") else 0.3 - 0.2
        off = abs(Fraction(double) - wrong)
        assert off <= Fraction(largest.bound) <= off * (1 + Fraction(2) ** -40)


def test_equal_numbers_are_computed_once() -> None:
    (core,) = read_cores("(FPCore (x y) :pre (<= 1 x y 2) (- (+ (* x y) 1) (* y x)))".replace(
        "(<= 1 x y 2)", "(and (<= 1 x 2) (<= 1 y 2))"))  # fmt: skip
    program = put_in_box(core.straight, core.box, DOUBLES)
    assert [step.kind for step in program.straight.steps] == ["multiply", "add", "subtract"]


def test_ranges_are_of_doubles_or_of_real_numbers() -> None:
    (core,) = read_cores("(FPCore (x) :pre (<= 1/10 x 1/3) (+ x 1))")
    ends = {c: put_in_box(core.straight, core.box, c).box[0] for c in (DOUBLES, REAL)}
    assert ends[DOUBLES] == (0.1, 1 / 3)
    assert ends[REAL] == (np.nextafter(0.1, 0), np.nextafter(1 / 3, 1))


def test_measuring_refuses_what_is_outside() -> None:
    program = program_of("verhulst", DOUBLES)
    assert measure(program, {"x": Fraction(1, 2)}) == -1.0


@pytest.mark.thorough
@pytest.mark.parametrize("relative", [False, True])
@pytest.mark.parametrize("rounded", [False, True])
@pytest.mark.parametrize("name", cores())
def test_no_search_exceeds_a_bound_of_the_benchmarks(
    name: str, rounded: bool, relative: bool
) -> None:
    program = program_of(name, Convention(rounded, relative))
    largest = bound_of(program, COARSE, 50_000)
    worst = find_worst_input(program, (program.box, *largest.highest))
    assert worst is None or worst.error <= largest.bound
