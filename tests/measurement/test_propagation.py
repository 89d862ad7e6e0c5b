"""The law of propagation of uncertainty, against GTC, Monte Carlo and closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from mechproof.kernels import elliptic_planetary as kernels
from mechproof.measurement import Estimate, propagate, to_ufloat

SIZES = {"R1": Estimate(66.0, 0.02), "R2": Estimate(16.0, 0.01), "e": Estimate(0.475, 0.001)}
CARRIER = 0.7


def test_coefficients_are_those_of_the_kernel() -> None:
    result = propagate(kernels.position, {"phi1": CARRIER, **SIZES})
    assert result.value == kernels.position(CARRIER, 66, 16, 0.475)
    step = 1e-5
    low, high = (kernels.position(CARRIER, 66, 16, 0.475 + s * step) for s in (-1, 1))
    assert result.sensitivities["e"] == pytest.approx((high - low) / (2 * step), rel=1e-8)
    parts = result.contributions
    assert parts["e"] == pytest.approx(abs(result.sensitivities["e"]) * 0.001, rel=1e-14)
    assert result.uncertainty == pytest.approx(math.hypot(*parts.values()), rel=1e-14)


def test_it_agrees_with_gtc() -> None:
    gtc = pytest.importorskip("GTC", reason="needs GTC, of the extra bench")
    free = math.inf
    inputs = {
        n: gtc.ureal(x.value, x.uncertainty, free, n, independent=False) for n, x in SIZES.items()
    }
    gtc.set_correlation(0.6, inputs["R1"], inputs["R2"])
    k = inputs["R1"] / inputs["R2"]
    x = k * CARRIER
    e = inputs["e"]
    theirs = (1 + k) * CARRIER + 2 * gtc.atan2(e * gtc.sin(x), 1 - e * gtc.cos(x))
    ours = propagate(kernels.position, {"phi1": CARRIER, **SIZES}, correlations={("R1", "R2"): 0.6})
    assert ours.value == pytest.approx(gtc.value(theirs), rel=1e-14)
    assert ours.uncertainty == pytest.approx(gtc.uncertainty(theirs), rel=1e-12)
    for name, part in ours.contributions.items():
        assert part == pytest.approx(abs(gtc.component(theirs, inputs[name])), rel=1e-12)


def test_degrees_of_freedom_agree_with_gtc() -> None:
    gtc = pytest.importorskip("GTC", reason="needs GTC, of the extra bench")
    given = {"R1": (66.0, 0.02, 4), "R2": (16.0, 0.01, 9), "e": (0.475, 0.001, 50)}
    k = gtc.ureal(*given["R1"]) / gtc.ureal(*given["R2"])
    e = gtc.ureal(*given["e"])
    theirs = 1 + k * (1 + e) / (1 - e)
    ours = propagate(kernels.largest_ratio, {n: Estimate(*x) for n, x in given.items()})
    assert ours.degrees_of_freedom == pytest.approx(gtc.dof(theirs), rel=1e-10)
    correlated = propagate(
        kernels.largest_ratio,
        {n: Estimate(*x) for n, x in given.items()},
        correlations={("R1", "R2"): 0.5},
    )
    assert math.isnan(correlated.degrees_of_freedom)


def test_it_agrees_with_monte_carlo() -> None:
    count = 200_000
    means = [x.value for x in SIZES.values()]
    spread = [x.uncertainty for x in SIZES.values()]
    matrix = np.eye(3)
    matrix[0, 1] = matrix[1, 0] = -0.4
    drawn = np.random.default_rng(7).multivariate_normal(
        means, np.outer(spread, spread) * matrix, count
    )
    simulated = kernels.position(CARRIER, *drawn.T).std(ddof=1)
    result = propagate(
        kernels.position, {"phi1": CARRIER, **SIZES}, correlations={("R1", "R2"): -0.4}
    )
    # The sample's deviation scatters by 1/sqrt(2 n) = 0.16 %: 6 of them is a false alarm of 2e-9;
    # the second order adds less than 0.01 %.
    assert result.uncertainty == pytest.approx(simulated, rel=6 * 0.0016)


def test_what_has_no_kernel_is_differenced() -> None:
    result = propagate(lambda a, b: a * b, {"a": Estimate(3.0, 0.1), "b": Estimate(2.0, 0.2)})
    assert result.sensitivities["a"] == pytest.approx(2.0, rel=1e-12)
    assert result.uncertainty == pytest.approx(math.hypot(0.2, 0.6), rel=1e-12)


def test_arrays_of_exact_inputs_give_arrays() -> None:
    angles = np.linspace(0, 2, 5)
    whole = propagate(kernels.position, {"phi1": angles, **SIZES})
    single = [propagate(kernels.position, {"phi1": x, **SIZES}).uncertainty for x in angles]
    np.testing.assert_allclose(whole.uncertainty, single, rtol=1e-14)
    with pytest.raises(ValueError, match="estimate"):
        _ = whole.estimate


def test_ufloats_come_in_with_their_correlations_and_go_out() -> None:
    uncertainties = pytest.importorskip("uncertainties", reason="an optional package")
    scale = uncertainties.ufloat(1.0, 0.01)
    inputs = {"a": 2 * scale, "b": 3 * scale}
    result = propagate(lambda a, b: a - b, inputs)
    assert result.uncertainty == pytest.approx((inputs["a"] - inputs["b"]).std_dev, rel=1e-9)
    back = to_ufloat(result.estimate)
    assert back.nominal_value == pytest.approx(-1.0)
    assert back.std_dev == pytest.approx(0.01, rel=1e-9)


def test_without_the_package_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "uncertainties", None)
    with pytest.raises(ImportError, match="a ufloat needs uncertainties, the extra uncertain: pip"):
        to_ufloat(Estimate(1.0, 0.1))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({("R1", "x"): 0.5}, "must be two of"),
        ({("R1", "R2"): 1.5}, "between -1 and 1"),
        ({("R1", "R2"): 0.5, ("R2", "R1"): 0.5}, "twice"),
        ({("R1", "R2"): 0.9, ("R2", "e"): 0.9, ("R1", "e"): -0.9}, "negative eigenvalue"),
    ],
)
def test_wrong_correlations_are_refused(given: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        propagate(kernels.largest_ratio, SIZES, correlations=given)


def test_a_budget_is_printed_largest_first() -> None:
    text = str(propagate(kernels.largest_ratio, SIZES))
    assert text.splitlines()[0].startswith("12.58")
    assert text.index("  e:") < text.index("  R2:") < text.index("  R1:")
