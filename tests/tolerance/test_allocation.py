"""Tolerances allocated for a wanted width, which the certified range then keeps."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np
import pytest

from mechproof import WedgeLinkage
from mechproof.kernels import wedge_linkage
from mechproof.tolerance import allocate_tolerances, contributions, corner_range

NOMINAL = asdict(WedgeLinkage.published(1))
CHOSEN = ("l_BC", "l_DE", "l_GH")


def test_all_contribute_equally_and_the_width_is_met() -> None:
    found = allocate_tolerances("wedge_linkage", "position", [-37.1, -25.0], NOMINAL, 1.0)
    assert 0.99 <= found.width.max() <= 1.0
    effects = np.array([*found.effects.values()])
    np.testing.assert_allclose(effects, effects[0], rtol=1e-12)
    assert set(found.effects) == set(NOMINAL)


def test_costs_are_made_least() -> None:
    costs = {"l_BC": 1.0, "l_DE": 4.0, "l_GH": 1.0}
    found = allocate_tolerances(
        "wedge_linkage", "position", -37.1, NOMINAL, 1.0, names=CHOSEN, costs=costs
    )
    widths = {name: found.sizes[name].tolerance for name in CHOSEN}
    slopes = {name: found.effects[name] / widths[name] for name in CHOSEN}
    # At the least cost a/T**2 is proportional to |c| (Lagrange).
    rates = [costs[name] / widths[name] ** 2 / slopes[name] for name in CHOSEN]
    np.testing.assert_allclose(rates, rates[0], rtol=1e-9)
    assert found.sizes["l_LM"].tolerance == 0


def test_no_corner_leaves_the_width() -> None:
    found = allocate_tolerances("wedge_linkage", "position", -37.1, NOMINAL, 0.5, names=CHOSEN)
    corners = corner_range(wedge_linkage.position, [-37.1], found.sizes)
    assert float(corners.upper[0] - corners.lower[0]) <= 0.5
    assert float(found.range.lower[0]) <= float(corners.lower[0])


def test_contributions_of_a_kernel_are_exact() -> None:
    sizes = WedgeLinkage.published_sizes(1)
    found = contributions(wedge_linkage.position, [-30.0], sizes)
    exact = wedge_linkage.sensitivities([-30.0], **NOMINAL)[0]
    named = dict(zip(NOMINAL, exact, strict=True))
    for name, slope in zip(found.names, found.sensitivities[0], strict=True):
        assert slope == pytest.approx(named[name], rel=1e-11)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"width": 0.0}, "width = 0.0: must be positive"),
        ({"quantity": "velocity"}, "no kernel of its derivatives"),
        ({"names": ["l_BC", "l_XY"]}, "l_XY"),
        ({"costs": {"l_BC": 1.0}}, "costs"),
        ({"names": ["l_BC"], "costs": {"l_BC": -1.0}}, "costs"),
    ],
)
def test_wrong_arguments_are_named(change: dict[str, Any], message: str) -> None:
    given = {"quantity": "position", "width": 1.0, **change}
    with pytest.raises(ValueError, match=message):
        allocate_tolerances("wedge_linkage", inputs=-30.0, nominal=NOMINAL, **given)
