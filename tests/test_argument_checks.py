"""Argument checks: each message reads "name = value: what is allowed", on one line."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from units import list_with_units

from mechproof.arguments import array_checks, scalars

REFUSED: list[tuple[Callable[[str, Any], object], Any, type[Exception], str]] = [
    (scalars.check_number, "1", TypeError, "'1': must be a real number, not str"),
    (scalars.check_number, True, TypeError, "True: must be a real number, not bool"),
    (scalars.check_number, 1j, TypeError, "1j: must be a real number, not complex"),
    (scalars.check_number, Decimal(1), TypeError, r"Decimal\('1'\): must be a real number"),
    (scalars.check_real, math.nan, ValueError, "nan: must be finite"),
    (scalars.check_real, 10**400, ValueError, r"10+ \.\.\. 0+: must be finite"),
    (scalars.check_real, -(10**400), ValueError, r"-10+ \.\.\. 0+: must be finite"),
    (scalars.check_not_negative, -1, ValueError, "-1: must be finite and not negative, or NaN"),
    (scalars.check_not_negative, math.inf, ValueError, "inf: must be finite and not negative"),
    (scalars.check_probability, 1, ValueError, "1: must lie between 0 and 1"),
    (scalars.check_probability, math.nan, ValueError, "nan: must lie between 0 and 1"),
    (scalars.check_count, 1.0, TypeError, "1.0: must be an integer, not float"),
    (scalars.check_count, True, TypeError, "True: must be an integer, not bool"),
    (scalars.check_count, 0, ValueError, "0: must be at least 1"),
    (scalars.check_triple, 0.1, TypeError, "0.1: must be three real numbers"),
    (scalars.check_triple, (1, 2), TypeError, r"\(1, 2\): must be three real numbers"),
    (
        array_checks.check_array,
        None,
        TypeError,
        "None: must be a real number or an array, not object",
    ),
    (array_checks.check_array, [True], TypeError, r"\[True\]: must be a real number or an array"),
    (
        array_checks.check_array,
        np.longdouble(1),
        TypeError,
        ".*: must be a real number or an array",
    ),
    (array_checks.check_array, np.ma.masked, TypeError, "masked: is a masked array; give NaN"),
    *(
        (check, value, TypeError, ".*: carries a unit; give plain numbers")
        for check in (array_checks.check_array, scalars.check_number)
        for value in list_with_units([1.0, 2.0])
    ),
    (
        array_checks.check_array,
        [[1, 2], [3]],
        ValueError,
        r"\[\[1, 2\], \[3\]\]: must .* of one length",
    ),
    (array_checks.check_flag, "no", TypeError, "'no': must be True or False, not str"),
    (array_checks.check_flag, 1, TypeError, "1: must be True or False, not int"),
    (array_checks.check_generator, None, TypeError, r"None: must be a numpy\.random\.Generator"),
    (array_checks.check_shape, (2, -1), ValueError, "-1: must be at least 0"),
    (scalars.check_text, b"mm", TypeError, "b'mm': must be a string"),
    (scalars.check_function, 3, TypeError, "3: must be a function"),
    (array_checks.check_finite, [1, math.inf], ValueError, r"\[1, inf\]: must be finite"),
    (array_checks.check_finite, 10**400, ValueError, r"10+ \.\.\. 0+: must be finite"),
    (array_checks.check_finite, 1e151, ValueError, r".*between -1e\+150 and 1e\+150"),
    (array_checks.check_scale, [0, -1], ValueError, r"\[0, -1\]: must not be negative"),
    (
        array_checks.check_pair,
        (1, 2, 3),
        TypeError,
        r"\(1, 2, 3\): must be a pair \(lower, upper\)",
    ),
]


@pytest.mark.parametrize(("check", "value", "error", "says"), REFUSED)
def test_what_is_not_allowed_is_named(
    check: Callable[[str, Any], object], value: Any, error: type[Exception], says: str
) -> None:
    with pytest.raises(error, match=f"^size = {says}"):
        check("size", value)


def test_components_and_limits_are_named() -> None:
    with pytest.raises(TypeError, match=r"^shift\[2\] = '3': must be a real number"):
        scalars.check_triple("shift", (1, 2, "3"))
    with pytest.raises(ValueError, match=r"^limits \(lower, upper\) = \(1, 1\): the lower limit"):
        array_checks.check_pair("limits", (1, 1))
    with pytest.raises(TypeError, match=r"^limits\[1\] = '2': must be a real number"):
        array_checks.check_pair("limits", (1, "2"))


def test_a_message_has_one_line() -> None:
    table = np.ma.masked_array(np.eye(3), np.eye(3, dtype=bool))
    with pytest.raises(TypeError, match=r"^table = masked_array\(.*\): is a masked array;"):
        array_checks.check_array("table", table)


def test_what_is_allowed_comes_back() -> None:
    assert scalars.check_number("x", Fraction(1, 2)) == 0.5
    assert math.isnan(scalars.check_number("x", math.nan))
    assert scalars.check_real("x", np.float32(0.5)) == 0.5
    assert math.isnan(scalars.check_not_negative("x", math.nan))
    assert scalars.check_count("n", np.int8(2), least=2) == 2
    assert scalars.check_triple("x", np.arange(3)) == (0, 1, 2)
    assert array_checks.check_array("x", [1, np.nan]).dtype == np.float64
    assert np.isnan(array_checks.check_scale("x", np.nan))
    assert array_checks.check_pair("x", (-np.inf, np.inf)) == (-np.inf, np.inf)


def test_scalars_are_checked_without_numpy() -> None:
    code = "import sys, mechproof.arguments.scalars; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_of_a_long_value_both_ends_are_shown() -> None:
    with pytest.raises(
        ValueError, match=r"^x = \[0, 1, 2, .* \.\.\. .*, 998, 999\]: is long$"
    ) as told:
        scalars.refuse("x", list(range(1000)), "is long")
    assert len(str(told.value)) < 230
    with pytest.raises(ValueError, match=r"^x = \[0, 1, 2\]: is short$"):
        scalars.refuse("x", [0, 1, 2], "is short")
