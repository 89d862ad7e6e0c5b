"""The checks that the mechanisms share: conditions of a domain, published sets."""

from __future__ import annotations

from typing import Any

import pytest

from mechproof.kernel_support.facts import Condition, Sizes
from mechproof.mechanisms.parameters import check_domain, choose_published

DOMAIN = (
    Condition("R1", "0 < R1", ("R1",), lambda R1: R1 > 0, ("ratio",)),
    Condition("R2", "R2 < R1", ("R1", "R2"), lambda R1, R2: R2 < R1, ("ratio",)),
)
PUBLISHED = (Sizes("Table 1", {"R1": 66.0}, ()), Sizes("Table 2", {"R1": 80.0}, ()))


@pytest.mark.parametrize(
    ("values", "as_given", "message"),
    [
        ({"R1": -1.0}, {}, r"R1 = -1.0: must satisfy 0 < R1$"),
        ({"R1": 66.0, "R2": 70.0}, {}, r"R2 = 70.0: must satisfy R2 < R1, R1 = 66.0$"),
        ({"R1": -0.5}, {"R1": ("R", "-1/2")}, r"R = '-1/2': must satisfy 0 < R$"),
        (
            {"R1": 66.0, "R2": 70.0},
            {"R1": ("R", 66)},
            r"R2 = 70.0: must satisfy R2 < R, R = 66$",
        ),
    ],
)
def test_a_condition_that_is_not_satisfied_is_named(
    values: dict[str, Any], as_given: dict[str, tuple[str, Any]], message: str
) -> None:
    with pytest.raises(ValueError, match=f"^{message}"):
        check_domain(DOMAIN, values, as_given)


def test_only_conditions_on_the_given_parameters_are_checked() -> None:
    check_domain(DOMAIN, {"R1": 66.0, "R2": 16.0, "e": 7.0})
    check_domain(DOMAIN, {"R2": 70.0})


def test_published_sets_are_counted_from_one() -> None:
    assert choose_published(PUBLISHED, "variant", 2) == {"R1": 80.0}
    for number in (0, 3):
        with pytest.raises(ValueError, match=f"variant = {number}: must be "):
            choose_published(PUBLISHED, "variant", number)
