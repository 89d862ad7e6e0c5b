"""The inverse of the position, checked by balls against the error that an eps of it allows."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from quantities import find_subject

from mechproof import CylindricalPair as Pair, EllipticPlanetary, OvalPlanetary
from mechproof.kernel_support.order import step_ulps
from mechproof.lab.oracle import Truth, find_truth
from mechproof.lab.subject import Subject
from mechproof.lab.ways import Array

EPS = float(np.finfo(float).eps)
TINIEST = float(np.finfo(float).smallest_subnormal)
ALLOWED = 4
ECCENTRICITIES = (0.0, 0.28, 0.475, 0.9, 0.99, 0.999999, 1 - 1e-12)
Mechanism = EllipticPlanetary | OvalPlanetary
MECHANISMS: dict[str, Mechanism] = {
    **{f"elliptic 66/16, {e!r}": EllipticPlanetary(66, 16, e) for e in ECCENTRICITIES},
    **{f"elliptic 50.3/50.2, {e!r}": EllipticPlanetary(50.3, 50.2, e) for e in (0.475, 0.99)},
    "intermittent": OvalPlanetary.published(3),
    "intermittent at zero": OvalPlanetary(Pair(20, 30), Fraction(1, 5)),
    "one-way": OvalPlanetary.published(4),
    "with the carrier": OvalPlanetary(Pair(20, 30), 0.1),
    "uniform": OvalPlanetary(Pair(20, 30), 0.0),
    "steep": OvalPlanetary(Pair(1, 3000), 0.99),
    "steepest": OvalPlanetary(Pair(1, 4e12), 1 - 1e-12),
    "fastest": OvalPlanetary(Pair(4e12, 1), 1 - 1e-12),
}
# The worst targets that searches met.
WORST: dict[str, tuple[float, ...]] = {}


def sizes_of(mechanism: Mechanism) -> tuple[float, float, float]:
    if isinstance(mechanism, EllipticPlanetary):
        return mechanism.R1, mechanism.R2, mechanism.e
    pair = mechanism.pair
    assert isinstance(pair, Pair)
    return float(pair.R4), float(pair.R5), float(mechanism.e2)


def find_position(kind: type[Mechanism]) -> Subject:
    is_elliptic = kind is EllipticPlanetary
    name = "elliptic_planetary.position" if is_elliptic else "oval_planetary.position_cylindrical"
    return find_subject(name)


def find_bar(kind: type[Mechanism]) -> float:
    """Return the stated accuracy of the position, in eps."""
    accuracy = find_position(kind).quantity.accuracy
    assert accuracy is not None
    return float(accuracy.ulp)


def truth_of(mechanism: Mechanism, phi1: Array) -> Truth:
    subject = find_position(type(mechanism))
    return find_truth(subject, (phi1, *map(np.array, sizes_of(mechanism))))


def draw_targets(name: str, seed: int) -> Array:
    """Draw output angles: evenly, logarithmically, and where the carrier is at a singular point."""
    mechanism, rng = MECHANISMS[name], np.random.default_rng(seed)
    r1, r2, e = sizes_of(mechanism)
    turns = np.pi * r2 / r1 * np.array([0.5, 1, 2, 3, 101, 100_000])
    width = 10.0 ** rng.uniform(-14, 1, 10) * (1 - e) * r2 / r1
    at = [np.add.outer(turns[:4], width).ravel(), turns, np.nextafter(turns, 0)]
    at += [rng.uniform(-1e6, 1e6, 12), rng.uniform(-30, 30, 12)]
    singular = np.concatenate(at)
    x = 2 * singular * r1 / r2
    # Beyond these limits no accuracy of the position is stated.
    reached = mechanism.position(singular[(np.abs(singular) <= 1e6) & (np.abs(x) <= 2.0**26)])
    ladder = 10.0 ** rng.uniform(-290, 1, 20) * rng.choice([-1, 1], 20)
    return np.concatenate([reached, ladder, WORST.get(name, ())])


def measure_residual(name: str, targets: Array) -> Array:
    """Return |position(found) - target| relative to the effect of an eps of position and angle.

    The ratio converts an error of the angle to one of the position, but near e = 1 the ratio
    changes within an ulp of the angle, so the position is evaluated at both neighbours instead.
    The position of the oval pair is the difference of two terms; its eps is that of the larger.
    """
    mechanism = MECHANISMS[name]
    return residual_of(mechanism, targets, np.asarray(mechanism.carrier_angle(targets)))


def residual_of(mechanism: Mechanism, targets: Array, found: Array) -> Array:
    assert np.isfinite(found).all()
    at = truth_of(mechanism, found)
    beside = [truth_of(mechanism, step_ulps(found, np.array(n))) for n in (-1, 1)]
    assert not at.undecided
    change = np.max([np.abs((b.high - at.high) + (b.low - at.low)) for b in beside], axis=0)
    limit = EPS * np.maximum(at.scale, np.abs(targets)) + change
    residual = np.abs((at.high - targets) + at.low)
    return np.asarray(residual / np.maximum(limit, TINIEST))


@pytest.mark.slow
@pytest.mark.parametrize("name", MECHANISMS)
def test_residual_within_the_conditioning(name: str) -> None:
    assert measure_residual(name, draw_targets(name, 20240901)).max() <= ALLOWED


LADDER = [1 - 10.0**-j for j in (1, 3, 9, 12, 15)]


def miss_position(mechanism: Mechanism, targets: Array, found: Array) -> float:
    """Return how far, in eps, the exact position misses the target beyond one ulp of the angle."""
    at = truth_of(mechanism, found)
    beside = [truth_of(mechanism, step_ulps(found, np.array(n))) for n in (-1, 1)]
    change = np.max([np.abs((b.high - at.high) + (b.low - at.low)) for b in beside], axis=0)
    beyond = np.abs((at.high - targets) + at.low) - change
    scale = EPS * np.maximum(at.scale, np.abs(targets))
    return float((beyond / np.maximum(scale, TINIEST)).max())


def draw_ladder_targets(mechanism: Mechanism) -> Array:
    """Draw positions of small, usual and large angles, and positions in the steep places."""
    r1, r2, e = sizes_of(mechanism)
    random = np.random.default_rng(99)
    usual = random.uniform(-30, 30, 30)
    phi1 = np.concatenate([10.0 ** random.uniform(-300, 1, 10), usual])
    phi1 = np.concatenate([phi1, random.uniform(-1, 1, 20) * min(2.0**25 * r2 / r1, 1e6)])
    phi1 = np.concatenate([phi1, np.pi * r2 / r1 * np.arange(1, 9) * (1 - e * 1e-3)])
    # Angles drawn at random hit no steep place.
    steep = mechanism.position(2 * np.pi * r2 / r1 * np.arange(1, 4))
    around = np.add.outer(steep, usual).ravel()
    return np.concatenate([mechanism.position(phi1), around])


@pytest.mark.slow
@pytest.mark.parametrize("e", LADDER, ids=repr)
@pytest.mark.parametrize("sizes", [(66.0, 16.0), (50.3, 50.2), (1.0, 4e15)], ids=str)
def test_the_bound_holds_up_to_e_1(sizes: tuple[float, float], e: float) -> None:
    """The neighbours' positions, each off by its stated accuracy, enclose the target."""
    elliptic = sizes[0] > sizes[1]
    mechanism = EllipticPlanetary(*sizes, e) if elliptic else OvalPlanetary(Pair(*sizes), e)
    targets = draw_ladder_targets(mechanism)
    found = np.asarray(mechanism.carrier_angle(targets))
    assert miss_position(mechanism, targets, found) <= 2 * find_bar(type(mechanism))


@pytest.mark.parametrize("kind", [EllipticPlanetary, OvalPlanetary])
def test_the_documentation_tells_the_bound(kind: type[Mechanism]) -> None:
    told = " ".join((kind.carrier_angle.__doc__ or "").split())
    assert f"at most {2 * find_bar(kind):g}*eps" in told
    assert f"({find_bar(kind):g} eps of the" in told


def test_an_angle_a_few_ulps_off_would_be_seen_near_e_1() -> None:
    """Four ulps is what a search that stops at 4 eps of the angle may be off by."""
    mechanism = EllipticPlanetary(66, 16, LADDER[-1])
    targets = draw_ladder_targets(mechanism)
    found = step_ulps(np.asarray(mechanism.carrier_angle(targets)), np.array(4))
    assert miss_position(mechanism, targets, found) > 1000 * find_bar(EllipticPlanetary)


@pytest.mark.parametrize("name", ["elliptic 66/16, 0.475", "one-way"])
def test_a_worse_angle_would_be_seen(name: str) -> None:
    mechanism, targets = MECHANISMS[name], draw_targets(name, 20240901)
    found = mechanism.carrier_angle(targets)
    worse = residual_of(mechanism, targets, step_ulps(found, np.array(20)))
    # Off by twenty ulps, where the limit allows one of the angle and an eps of the position.
    assert np.median(worse) > ALLOWED


@pytest.mark.parametrize("name", MECHANISMS)
def test_it_converges_beyond_the_bar(name: str) -> None:
    """There is an answer even where doubles no longer determine the turn of the angle."""
    far = np.array([1e8, 1e12, 1e16, 1e17, 1e100, 1e300, 1e-300, 5e-324])
    assert np.isfinite(MECHANISMS[name].carrier_angle(np.concatenate([far, -far]))).all()


@pytest.mark.parametrize("sign", [-1, 1])
@pytest.mark.parametrize("kind", [EllipticPlanetary, OvalPlanetary])
def test_the_bracket_holds_the_angle(
    kind: type[Mechanism], sign: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a position as wrong as its bound allows, the bracket holds and the search converges."""
    exact, factor = kind.position, 1 + sign * find_bar(kind) * EPS
    chosen = [name for name, mechanism in MECHANISMS.items() if isinstance(mechanism, kind)]
    targets = {name: draw_targets(name, 5) for name in chosen}
    monkeypatch.setattr(kind, "position", lambda self, phi1: exact(self, phi1) * factor)
    for name in chosen:
        assert np.isfinite(MECHANISMS[name].carrier_angle(targets[name])).all(), name
