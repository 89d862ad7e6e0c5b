"""Printing of a value with its uncertainty."""

import math
from fractions import Fraction

import numpy as np
import pytest

from mechproof.measurement import Estimate
from mechproof.measurement.estimate import format_expanded, format_shorthand

ROUNDING = [
    (0.68, 0.28, "0.68(28)", "0.68 ± 0.28"),
    (-0.93, 0.82, "-0.93(82)", "-0.93 ± 0.82"),
    (-0.98, 1.36, "-1.0(14)", "-1.0 ± 1.4"),
    (0.682, 0.0949, "0.682(95)", "0.682 ± 0.095"),
    (0.682, 0.095, "0.68(10)", "0.68 ± 0.10"),
    (0.682, 0.096, "0.68(10)", "0.68 ± 0.10"),
    (0.682, 0.0999, "0.68(10)", "0.68 ± 0.10"),
    (6.82, 0.96, "6.8(10)", "6.8 ± 1.0"),
    (68.2, 9.6, "68(10)", "68 ± 10"),
    (682.0, 96.0, "680(100)", "680 ± 100"),
    (1234.5, 28.05, "1234(28)", "1234 ± 28"),
    (1235.5, 28.05, "1236(28)", "1236 ± 28"),
    (1235.0, 280.0, "1240(280)", "1240 ± 280"),
    (0.125, 0.105, "0.12(10)", "0.12 ± 0.10"),
    (0.135, 0.115, "0.14(12)", "0.14 ± 0.12"),
    (0.3, 25.0, "0(25)", "0 ± 25"),
    (-0.001, 0.28, "0.00(28)", "0.00 ± 0.28"),
    (0.0, 0.28, "0.00(28)", "0.00 ± 0.28"),
    (9.9996, 0.028, "10.000(28)", "10.000 ± 0.028"),
    (100.0, 1e-3, "100.0000(10)", "100.0000 ± 0.0010"),
    (100.02147, 0.00035, "100.02147(35)", "100.02147 ± 0.00035"),
    (2.0, 3, "2.0(30)", "2.0 ± 3.0"),
    (1.234e-12, 3e-13, "1.23(30)e-12", "1.23e-12 ± 0.30e-12"),
    (3e-13, 1.234e-12, "0.3(12)e-12", "0.3e-12 ± 1.2e-12"),
    (1.23e20, 2.8e19, "1.23(28)e20", "1.23e20 ± 0.28e20"),
    (9.99996e15, 2.8e12, "1.00000(28)e16", "1.00000e16 ± 0.00028e16"),
    (5e-324, 5e-324, "5.0(50)e-324", "5.0e-324 ± 5.0e-324"),
    (0.68, 0.0, "0.68(0)", "0.68 ± 0"),
    (0.68, math.nan, "0.68(nan)", "0.68 ± nan"),
    (math.nan, 0.28, "nan(0.28)", "nan ± 0.28"),
    (math.inf, 0.28, "inf(0.28)", "inf ± 0.28"),
]


@pytest.mark.parametrize(("value", "uncertainty", "shorthand", "expanded"), ROUNDING)
def test_value_and_uncertainty_are_rounded_together(
    value: float, uncertainty: float, shorthand: str, expanded: str
) -> None:
    assert format_shorthand(value, uncertainty) == shorthand
    assert format_expanded(value, uncertainty) == expanded


def test_shorthand_reads_back_within_the_rounding() -> None:
    rng = np.random.default_rng(1)
    for value, decade in zip(rng.normal(size=2000), rng.uniform(-7, 9, 2000), strict=True):
        uncertainty = 10.0**decade
        text = format_shorthand(value, uncertainty)
        mantissa, _, rest = text.partition("(")
        digits, _, power = rest.partition(")")
        scale = Fraction(10) ** int(power[1:] or 0)
        last = Fraction(10) ** -len(mantissa.partition(".")[2])
        read_value = Fraction(mantissa) * scale
        read_uncertainty = int(digits) * last * scale
        # With two digits, 0.5 in 10.5; when rounded to the next decade, 5 in 95.
        assert abs(read_uncertainty / Fraction(uncertainty) - 1) <= Fraction(5, 95)
        # Half a unit in the last place, which is at most a tenth of a two-digit uncertainty.
        assert abs(read_value - Fraction(value)) <= read_uncertainty / 20


def test_units() -> None:
    estimate = Estimate(0.68, 0.28, 191, "°")
    assert str(estimate) == "0.68(28)°"
    assert str(estimate.expand(2)) == "0.68° ± 0.56° (k = 2)"
    assert str(estimate.cover(0.95)) == "0.68° ± 0.55° (k = 1.97, p = 95 %)"
    assert str(Estimate(4.161, 0.012, unit="mm")) == "4.161(12) mm"
    assert str(Estimate(4.161, 0.012).expand(2.5)) == "4.161 ± 0.030 (k = 2.5)"
    assert str(Estimate(2e-9, 1e-10, unit="m").expand(1)) == "2.00e-9 m ± 0.10e-9 m (k = 1)"
