"""Every share has ways, points and a workload; the points lie in its domain, or are marked."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from mechproof.derivations.conformity import PAPER, peers, points

NAMES = tuple(quantity.name for quantity in PAPER.quantities)
QUANTITIES = {quantity.name: quantity for quantity in PAPER.quantities}

# The law lies about 40 standard deviations outside the window, or as far inside it.
OUTSIDE, INSIDE = (80.0, 1.0, 0.0, 0.1, -40.0, 40.0), (1.5, 0.01, 0.0, 0.01, 1.0, 2.0)
FAR = {**dict.fromkeys(NAMES, OUTSIDE), "rightly_rejected": INSIDE}


def mark_accuracy_domain(name: str, arguments: points.Arguments) -> np.ndarray:
    quantity = QUANTITIES[name]
    assert quantity.accuracy is not None
    (relation,) = quantity.accuracy.within
    symbols = [s for argument in quantity.arguments for s in argument.symbols]
    return np.asarray(sp.lambdify(symbols, relation, "numpy")(*arguments))


def test_every_share_has_ways_and_points() -> None:
    for mapping in (peers.PEERS, points.POINTS, points.IN_CELL, points.WORKLOADS):
        assert tuple(mapping) == NAMES
    assert all(ways[0].ours for ways in peers.PEERS.values())


@pytest.mark.parametrize("name", NAMES)
def test_points_lie_in_the_domain(name: str) -> None:
    for draw in points.POINTS[name].values():
        _, std, _, error, low, high = draw(np.random.default_rng(1))
        assert np.all((std > 0) & (error > 0) & (low < high))


@pytest.mark.parametrize("name", NAMES)
def test_underflow_is_far_from_the_usual_and_met_beyond(name: str) -> None:
    usual = points.POINTS[name]["limits of 1 to 7 standard deviations"]
    assert mark_accuracy_domain(name, usual(np.random.default_rng(1))).all()
    assert not mark_accuracy_domain(name, FAR[name])


@pytest.mark.parametrize("name", NAMES)
def test_ways_agree_where_no_share_is_small(name: str) -> None:
    """Quadrature, differences and the simulation, at limits of one standard deviation."""
    arguments = tuple(np.array([v]) for v in (0.1, 1.0, 0.05, 0.3, -1.0, 1.1))
    found = [float(np.ravel(peer.compute(*arguments))[0]) for peer in peers.PEERS[name]]
    # Six standard errors of 10 000 parts.
    assert np.ptp(found) <= 6 * np.sqrt(found[0] * (1 - found[0]) / 10_000)
    exact = [f for f, p in zip(found, peers.PEERS[name], strict=True) if "simul" not in p.name]
    # SciPy's distribution function is accurate to an absolute 1e-5, the others to 16 eps.
    assert np.ptp(exact) <= 1e-5
