"""The search for drives that dwell, against dense grids; cases left open, and refused input."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import flint
import numpy as np
import pytest
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from mechproof import CylindricalPair, OvalPair, OvalPlanetary
from mechproof.kernels import oval_planetary as kernels
from mechproof.mechanisms.dwells import ball_decisions, band_dwells, ratio
from mechproof.mechanisms.dwells.ratio import Span

DEGREE = math.radians(1)


@pytest.fixture(autouse=True)
def precision() -> Iterator[None]:
    with flint.ctx.workprec(128):
        yield


def find_least_range(k: float, e: float, width: float, samples: int = 2000) -> float:
    """Return the least range of phi3 over a carrier angle of `width`, anywhere in a period."""
    step = width / samples
    phi = np.arange(math.ceil(math.pi / k / step) + samples + 2) * step
    phi3 = kernels.position_cylindrical(phi, k, 1.0, e)
    window = slice(samples // 2, -(samples // 2))
    spread = maximum_filter1d(phi3, samples + 1) - minimum_filter1d(phi3, samples + 1)
    return float(spread[window].min())


def find_longest_rest(k: float, e: float, eta: float, samples: int = 20000) -> float:
    period = math.pi / k
    phi = np.arange(2 * samples) * (period / samples)
    (moving,) = np.nonzero(np.abs(kernels.ratio_cylindrical(phi, k, 1.0, e)) > eta)
    return (np.diff(moving).max() - 1) * period / samples if moving.size else math.inf


def grid(spans: list[Span], limit: Fraction) -> Iterator[tuple[float, bool]]:
    """Yield eccentricities of the whole range and near span ends, and whether a span holds them."""
    ends = [float(end) * near for s in spans for end in s[1:3] for near in (0.999, 1.001)]
    for e in (*np.linspace(0.002, float(limit), 30), *ends):
        if 0 < e <= limit:
            yield float(e), any(s.low <= e <= s.high for s in spans)


# Teeth, carrier angle and band in degrees, eta, limit of e2; in at least three the output returns
# by more than the band, in two R4/R5 is below 1, in one it is 1.
CASES = [
    (30, 20, 20, 0.1, 0.02, Fraction(1, 3)),
    (18, 17, 35, 0.1, 0.05, Fraction(1, 3)),
    (26, 25, 20, 0.5, 0.1, Fraction(3, 5)),
    (20, 30, 20, 0.1, 0.05, Fraction(3, 5)),
    (39, 43, 50, 0.5, 0.02, Fraction(1, 3)),
    (25, 25, 20, 0.1, 0.02, Fraction(1, 3)),
    (40, 20, 10, 0.1, 0.1, Fraction(1, 3)),
    (17, 40, 80, 0.5, 0.1, Fraction(3, 5)),
]


@pytest.mark.parametrize("case", CASES)
def test_a_band_misses_nothing_and_finds_nothing_else(case: tuple[Any, ...]) -> None:
    z4, z5, degrees, band, _, limit = case
    k, width, half = Fraction(z4, z5), degrees * DEGREE, band * DEGREE
    spans = band_dwells.find_spans(
        k, band_dwells.BandRequest(Fraction(width), Fraction(half), limit)
    )
    for e, inside in grid(spans, limit):
        if k == 1 and math.asin(e) <= half:
            assert not inside
            continue
        # The sampled range is too small by the square of the sample spacing.
        spread = find_least_range(float(k), e, width) / (2 * half)
        assert inside == (spread <= 1) or abs(spread - 1) < 1e-4, e


@pytest.mark.parametrize("case", CASES)
def test_a_ratio_misses_nothing_and_finds_nothing_else(case: tuple[Any, ...]) -> None:
    z4, z5, degrees, _, eta, limit = case
    k, width = Fraction(z4, z5), degrees * DEGREE
    spans = ratio.find_spans(k, ratio.RestRequest(Fraction(width), Fraction(eta), limit))
    for e, inside in grid(spans, limit):
        longest = find_longest_rest(float(k), e, eta)
        # A sampled rest is too short by two samples, 9e-3 degrees.
        clear = abs(longest - width) > 2 * math.pi / float(k) / 20000
        assert inside == (width <= longest < math.inf) or not clear, e


def test_the_table_is_complete_and_its_drives_dwell() -> None:
    band = math.radians(0.1)
    found = OvalPlanetary.find_dwells(math.radians(20), band=band, teeth=(18, 24))
    assert found.complete
    # In 7 pairs the ratio is 1; all other ratios differ.
    assert (found.pairs, found.ratios) == (49, 43)
    assert [d.width for d in found.candidates] == sorted(
        (d.width for d in found.candidates), reverse=True
    )
    for dwell in found.candidates:
        drive = OvalPlanetary.of_dwell(dwell, dwell.best, module=2)
        start, end = drive.longest_dwell(band=band)
        assert end - start == pytest.approx(dwell.width, rel=1e-9)
        phi3 = drive.position(np.linspace(start, end, 2001))
        assert np.ptp(phi3) <= 2 * band * (1 + 1e-6)
        assert drive.pair == CylindricalPair(dwell.z4, dwell.z5)
        if dwell.exact is not None:
            assert OvalPlanetary.of_dwell(dwell).classify().kind == "intermittent"
    text = str(found)
    assert text.splitlines()[-1].startswith("complete: ")
    assert f"{len(found)} found; 49 pairs of tooth numbers" in text


def test_the_exact_dwell_that_convexity_just_allows() -> None:
    (dwell,) = OvalPlanetary.find_dwells(0.01, eta="0.01", teeth=(40, 40)).candidates[:1]
    assert (dwell.z4, dwell.z5) == (40, 40)
    by_ratio = ratio.find_spans(
        Fraction(2), ratio.RestRequest(Fraction("0.01"), Fraction("0.01"), Fraction(1, 3))
    )
    assert [span.exact for span in by_ratio] == [Fraction(1, 3)]
    assert by_ratio[0].high == Fraction(1, 3)


def test_ranks() -> None:
    def ranked(rank: Any) -> list[Any]:
        return list(
            OvalPlanetary.find_dwells(0.3, eta="0.05", teeth=(18, 22), rank=rank).candidates
        )

    by_width, by_step, by_teeth = map(ranked, ("width", "step", "teeth"))
    assert set(by_width) == set(by_step) == set(by_teeth)
    steps = [abs(d.step) for d in by_step]
    assert steps == sorted(steps, reverse=True)
    assert [d.z4 + d.z5 for d in by_teeth] == sorted(d.z4 + d.z5 for d in by_teeth)
    for dwell in by_step:
        drive = OvalPlanetary.of_dwell(dwell)
        assert drive.position(drive.extremes().period) == pytest.approx(dwell.step, abs=1e-12)


def test_what_is_left_out_is_said() -> None:
    # 0.04 rad in a period of pi: within the band of 0.06.
    found = OvalPlanetary.find_dwells(0.3, band=0.03, teeth=(80, 81))
    assert not found.complete
    assert {(z4, z5) for z4, z5, _ in found.open} == {(80, 81), (81, 80)}
    assert "open: 81/80, in a period the output drifts by no more than the band" in str(found)
    long = str(OvalPlanetary.find_dwells(0.1, eta=0.1, teeth=(18, 30)))
    assert "more, in .candidates" in long


def test_balls_that_cannot_tell_leave_it_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ball_decisions.EnclosedDrive, "moved", lambda self, d: flint.arb(0, 1))
    found = OvalPlanetary.find_dwells(0.3, band=0.001, teeth=(18, 20))
    assert len(found.open) == found.ratios - 1


@pytest.mark.parametrize(
    ("drive", "place"),
    [
        (OvalPlanetary(CylindricalPair(30, 20), "0.205"), math.pi / 3),
        (OvalPlanetary(CylindricalPair(20, 30), "0.19"), 0.0),
        (OvalPlanetary(CylindricalPair(20, 30), "0.3"), None),
        (OvalPlanetary(CylindricalPair(25, 25), "0.3"), None),
        (OvalPlanetary(OvalPair("0.2", 0.4), "0.3"), None),
    ],
)
def test_the_longest_dwell_of_a_drive(drive: OvalPlanetary, place: float | None) -> None:
    band = 0.002
    start, end = drive.longest_dwell(band=band)
    phi = np.linspace(start, end, 4001)
    assert np.ptp(drive.position(phi)) == pytest.approx(2 * band, rel=1e-5)
    assert place is None or (start + end) / 2 == pytest.approx(place, abs=1e-12)
    begin, stop = drive.longest_dwell(eta="0.1")
    assert np.abs(drive.ratio(np.linspace(begin, stop, 999))).max() <= 0.1 * (1 + 1e-9)


def test_drives_that_always_or_never_dwell() -> None:
    small = OvalPlanetary(CylindricalPair(25, 25), "0.001")
    assert small.longest_dwell(band=0.002) == (-math.inf, math.inf)
    assert small.longest_dwell(eta="0.1") == (-math.inf, math.inf)
    fast = OvalPlanetary(CylindricalPair(50, 10), "0.1")
    assert np.isnan(fast.longest_dwell(eta="0.1")).all()
    with pytest.raises(ValueError, match=r"band = 0\.7: must be below half the output's advance"):
        OvalPlanetary(CylindricalPair(30, 20), "0.2").longest_dwell(band=0.7)


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({}, TypeError, "band = None: give exactly one of band and eta"),
        ({"eta": "0.1", "band": 0.1}, TypeError, "band = 0.1: give exactly one of band and eta"),
        ({"eta": 0}, ValueError, "eta = 0: must be above 0"),
        ({"eta": 1.0}, ValueError, "eta = 1.0: must be above 0 and below 1"),
        ({"band": -0.1}, ValueError, "band = -0.1"),
        ({"band": math.nan}, ValueError, "band = nan: must be finite"),
        ({"band": 0.1, "width": 0}, ValueError, "width = 0: must be positive"),
        ({"band": 0.1, "width": "wide"}, ValueError, "width = 'wide'"),
        ({"band": 0.1, "teeth": (20, 17)}, ValueError, r"teeth = \(20, 17\)"),
        ({"band": 0.1, "teeth": (0, 17)}, ValueError, "teeth = 0: must be at least 1"),
        ({"band": 0.1, "teeth": 17}, TypeError, "teeth = 17: must be two"),
        ({"band": 0.1, "largest_e": 1}, ValueError, "largest_e = 1: must be above 0 and below 1"),
        ({"band": 0.1, "rank": "beauty"}, ValueError, "rank = 'beauty': must be one of width"),
    ],
)
def test_what_cannot_be_asked(given: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        OvalPlanetary.find_dwells(**{"width": 0.3, **given})
