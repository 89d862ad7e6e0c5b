"""The arc integral on one Gauss panel agrees with the same integral over many panels."""

from __future__ import annotations

import numpy as np
import pytest

from mechproof.conformity import arc as conformity_arc
from mechproof.conformity.arc import LENGTHS, choose_size, integrate_arc, make_panel

PARTS, ORDER = 60, 32
CUT = 45.0  # nats; beyond lies less than 1e-19 of the integral
Array = np.ndarray


def integrate_finely(p: Array, q: Array, one: Array, square: Array) -> Array:
    """Return the integral over log(1/u) on 60 equal parts, at most 0.75 long, of 32 nodes each."""
    ahead = q - p + CUT
    length = np.minimum(
        0.5 * np.log1p((ahead + np.hypot(ahead, 2 * np.sqrt(CUT * p))) / (2 * p)), CUT
    )
    nodes, weights = np.polynomial.legendre.leggauss(ORDER)
    place = ((np.arange(PARTS)[:, None] + (1 + nodes) / 2) / PARTS).ravel()
    y = place * length[:, None]
    u = np.exp(-y)
    p, q, one, square = (v[:, None] for v in (p, q, one, square))
    exponent = p * np.expm1(2 * y) + q * np.expm1(-2 * y)
    values = np.exp(-exponent) * u * (one + square) / (one + square * u * u)
    return values @ np.tile(weights / 2 / PARTS, PARTS) * length / (2 * np.pi)


def draw_arcs(count: int) -> tuple[Array, ...]:
    """Draw arcs at both ends: I(0, beta) falls if q <= p + 1/2, I(beta, pi) if 2 (p - q) > cos."""
    rng = np.random.default_rng(1)
    p = 10 ** rng.uniform(-29, np.log10(700), count)
    ahead = np.where(
        rng.random(count) < 0.2, -0.5 * rng.random(count), 10 ** rng.uniform(-6, 2, count)
    )
    q = np.maximum(p - ahead, 0) * 10 ** rng.choice([0, rng.uniform(-9, 0)], count)
    near_one = 1 - 10 ** rng.uniform(-16, 0, count)
    square = np.where(rng.random(count) < 0.3, near_one, 10 ** rng.uniform(-16, 0, count))
    other = 2 * (p - q) > (1 - square) / (1 + square)
    one = np.ones(count)
    return p, q, np.where(other, square, one), np.where(other, one, square)


@pytest.mark.slow
def test_one_panel_is_as_good_as_sixty() -> None:
    arcs = draw_arcs(4000)
    error = np.abs(integrate_arc(*arcs) / integrate_finely(*arcs) - 1)
    # The part cut off, 1.3e-14, plus the error of the nodes.
    assert np.max(error) < 1e-13
    assert np.ptp(choose_size(*arcs[:2])) > 0.9 * len(LENGTHS)


@pytest.mark.parametrize("length", LENGTHS[:45:4])
def test_every_decay_that_fills_a_panel(length: float) -> None:
    """From p = q, a bell, to q = 0; the drop fills the panel, or just exceeds the previous one."""
    reach = np.repeat([length * 0.999, max(length / 1.25, length - 0.2) * 1.001], 9)
    share = np.tile(np.linspace(0, 1, 9), 2)
    drop = conformity_arc.DROP
    p = drop / (np.expm1(2 * reach) + share * np.expm1(-2 * reach))
    q = share * p
    for one, square in ((1.0, 1e-6), (1.0, 0.1), (1.0, 1.0)):
        arcs = p, q, np.full(18, one), np.full(18, square)
        error = np.abs(integrate_arc(*arcs) / integrate_finely(*arcs) - 1)
        assert np.max(error) < 1e-13


@pytest.mark.slow
def test_the_comparison_sees_too_few_nodes(monkeypatch: pytest.MonkeyPatch) -> None:
    arcs = draw_arcs(500)
    exact = integrate_finely(*arcs)
    fewer = tuple((longest, count - 4) for longest, count in conformity_arc.NODE_COUNTS)
    monkeypatch.setattr(conformity_arc, "NODE_COUNTS", fewer)
    make_panel.cache_clear()
    error = np.abs(integrate_arc(*arcs) / exact - 1)
    make_panel.cache_clear()
    assert np.max(error) > 1e-12
