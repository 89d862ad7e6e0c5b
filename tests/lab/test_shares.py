"""Shares of parts: the oracle agrees with mpmath, and each way fails where it is expected to."""

from __future__ import annotations

from functools import cache

import mpmath as mp
import numpy as np
import pytest
from weights import first_of

from mechproof.lab.oracle import Errors, Truth, find_errors, find_truth
from mechproof.lab.sampling.named_sets import REPORT, draw_points
from mechproof.lab.sampling.point_sets import list_sets
from mechproof.lab.subject import Subject, find_subjects
from mechproof.lab.ways import Arguments

EPS = float(np.finfo(float).eps)
BOUND = 1e-12
OURS = "mechproof.conformity"
NAMES = ("rightly_accepted", "wrongly_accepted", "rightly_rejected", "wrongly_rejected")


@cache
def subject(name: str) -> Subject:
    (found,) = find_subjects((f"conformity.{name}",))
    return found


def columns(*rows: tuple[float, ...]) -> Arguments:
    return tuple(np.array(rows).T)


# Limits of 3 to 8 standard deviations, an error of a tenth of the spread.
LADDER = columns(*((0.0, 1.0, 0.0, 0.1, -reach, reach) for reach in (3.0, 4.0, 5.0, 6.0, 7.0, 8.0)))


@cache
def truth_of_ladder(name: str) -> Truth:
    truth = find_truth(subject(name), LADDER)
    assert truth.undecided == 0
    return truth


def run(name: str, form: str, arguments: Arguments, truth: Truth) -> Errors:
    way = next(s for s in subject(name).ways if s.name == form)
    with np.errstate(all="ignore"):
        return find_errors(way.compute(*arguments), truth)


def relative(errors: Errors) -> np.ndarray:
    return errors.scaled * EPS


def integrate_independently(name: str, row: tuple[float, ...]) -> mp.mpf:
    """Integrate over the true deviation in pieces, with M's tails from the error function."""
    mean, std, bias, error, low, high = map(mp.mpf, row)

    def tail(z: mp.mpf) -> mp.mpf:
        return mp.erfc(z / mp.sqrt(2)) / 2

    def integrand(y: mp.mpf) -> mp.mpf:
        out = tail((high - bias - y) / error) + tail((y + bias - low) / error)
        density = mp.exp(-(((y - mean) / std) ** 2) / 2) / std / mp.sqrt(2 * mp.pi)
        return density * (out if name.endswith("rejected") else 1 - out)

    reach = [k * error for k in (0, 1, 3, 8, 20)]
    marks = {
        limit - bias + side * step for limit in (low, high) for side in (1, -1) for step in reach
    }
    marks |= {mean + k * std for k in (-40, -20, -8, -3, 0, 3, 8, 20, 40)} | {low, high}
    inner = name in ("rightly_accepted", "wrongly_rejected")
    total = mp.mpf(0)
    for start, end in zip(sorted(marks), sorted(marks)[1:], strict=False):
        if (low <= start and end <= high) == inner:
            total += mp.quad(integrand, [start, end])
    return total


@pytest.mark.slow
@pytest.mark.parametrize("name", first_of(NAMES))
@pytest.mark.parametrize(
    "row",
    [
        (0.1, 1.0, 0.05, 0.3, -2.0, 2.5),
        (0.0, 1.0, 0.0, 0.25, -11.0, 12.0),
        (0.0, 1.0, 2.0, 3.0, 0.0, 1.0),
        (0.0, 1.0, -0.5, 1e-3, -4.0, 1.5),
    ],
)
def test_the_oracle_equals_mpmath(name: str, row: tuple[float, ...]) -> None:
    truth = find_truth(subject(name), columns(row))
    assert truth.undecided == 0
    with mp.workdps(40):
        expected = integrate_independently(name, row)
        found = mp.mpf(float(truth.high[0])) + mp.mpf(float(truth.low[0]))
        # The pieces end 40 spreads from the mean; mpmath's rule is adapted to 40 digits.
        assert abs(found - expected) <= mp.mpf(10) ** -18 * expected


def test_the_four_definitions_add_up() -> None:
    total = sum(truth_of_ladder(n).high for n in NAMES) + sum(truth_of_ladder(n).low for n in NAMES)
    assert np.all(np.abs(total - 1) <= 4 * EPS)


def test_the_sets_reach_the_tails() -> None:
    far = next(s for s in list_sets(subject("wrongly_rejected")) if s.name == "tails to 1e-300")
    points = tuple(a[::3] for a in draw_points(far, REPORT))
    truth = find_truth(subject("wrongly_rejected"), points)
    assert np.min(truth.high) < 1e-100
    assert np.max(relative(run("wrongly_rejected", OURS, points, truth))) <= BOUND


@pytest.mark.parametrize("form", ["Owen's T", "multivariate_normal"])
@pytest.mark.parametrize("name", ["wrongly_accepted", "wrongly_rejected"])
def test_differences_lose_the_digits_of_the_share(form: str, name: str) -> None:
    """Their error is a few eps of one: a share of 10**-n has lost n digits."""
    truth = truth_of_ladder(name)
    errors = run(name, form, LADDER, truth)
    assert np.all(errors.absolute <= 16 * EPS)
    lost = np.log10(relative(errors) / EPS)
    digits = -np.log10(truth.high)
    left = (digits > 4) & (digits < 14)
    # A rounding may be small by chance, but not all of them.
    assert np.all(np.abs(lost - digits)[left] < 3)
    assert np.median(np.abs(lost - digits)[left]) < 1.5
    assert lost[-1] > 14
    assert np.all(relative(run(name, OURS, LADDER, truth)) <= BOUND)


@pytest.mark.parametrize(("count", "seen"), [("1e+04", 1e-3), ("1e+06", 1e-5)])
def test_a_simulation_sees_nothing_below_its_count(count: str, seen: float) -> None:
    truth = truth_of_ladder("wrongly_accepted")
    errors = relative(run("wrongly_accepted", f"simulation, {count} parts", LADDER, truth))
    # Below a tenth of a part per count the estimate is 0 or ten times the share: nothing is right.
    unseen = truth.high < 0.1 / float(count)
    assert unseen.sum() >= 3
    is_zero = np.abs(errors[unseen] - 1) < 1e-9
    assert np.all(is_zero | (errors[unseen] > 9))
    # Fewer than 0.1 parts are expected in all: more than three at 4e-6 (Poisson), with any seed.
    expected = float(count) * truth.high[unseen]
    assert expected.sum() < 0.1
    assert np.sum(expected * (1 + errors[unseen]) * ~is_zero) < 3.5
    # Five binomial standard errors.
    assert errors[0] <= 5 / np.sqrt(float(count) * truth.high[0])
    assert errors[0] > seen


def test_quad_misses_a_peak_that_is_narrow_in_a_wide_range() -> None:
    """Wrongly accepted parts lie within a few errors of a limit; the range is infinite."""
    lost = []
    for error in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5):
        row = columns((0.0, 1.0, 0.0, error, -2.0, 2.5))
        truth = find_truth(subject("wrongly_accepted"), row)
        lost += relative(run("wrongly_accepted", "scipy.integrate.quad", row, truth)).tolist()
        assert relative(run("wrongly_accepted", OURS, row, truth))[0] <= BOUND
    assert lost[0] < 1e-6
    assert lost[-1] > 0.5


def test_a_share_of_one_is_right_in_every_way() -> None:
    """A share near one does not cancel: all ways but the simulations have its digits."""
    truth = truth_of_ladder("rightly_accepted")
    for form in (OURS, "Owen's T", "multivariate_normal", "scipy.integrate.quad"):
        assert np.all(relative(run("rightly_accepted", form, LADDER, truth)) < 1e-8), form
