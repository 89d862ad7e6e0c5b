"""Inverse design of inspections: the acceptance limits and the gauge for a wanted risk.

A risk is monotonic in the guard band: whatever is accepted within narrower acceptance limits is
accepted within wider ones.

For errors that are symmetric about 0 and most dense there, |S0 + f*S1| > x becomes more likely as f
grows, for every x (Birnbaum 1948, on comparable peakedness). So

- a conforming part at the distances a, b >= 0 from both limits is rejected with the probability
  P(|S| > a)/2 + P(|S| > b)/2: the producer's risk rises;
- a part beyond a limit by a, in a field of width T, is accepted with the probability
  P(|S| > a)/2 - P(|S| > a + T)/2. Both terms rise: the consumer's risk is the chance `near` of
  being measured on the good side of the limit, less the chance `far` of being measured beyond the
  other one. It may fall again where the errors are as wide as the field. The least f with
  near(f) = wanted + far(f) is reached from below by solving near(f) = wanted + far(last f).

Sources: JCGM 106:2012, clauses 8 and 9; Z. W. Birnbaum, On random variables with comparable
peakedness, Annals of Mathematical Statistics 19 (1948).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from mechproof.arguments.scalars import check_probability, choose_one, refuse, require
from mechproof.conformity import Law, Shares
from mechproof.mechanisms.inversion import invert

Window = tuple[float, float]
Function = Callable[[float], float]
# Shares as a function of a factor on the errors, the tolerance limits and the acceptance limits.
Scaled = Callable[[float, Window, Window], Shares]
NAMES = {"consumer_risk": "wrongly_accepted", "producer_risk": "wrongly_rejected"}
# Factors of the errors are sought between 2**-FAR and 2**FAR, the largest risk by octaves.
FAR, OCTAVES = 60, range(-20, 21)
# From below, one step usually suffices; only near the largest risk are many needed.
STEPS = 100
EPS = float(np.finfo(float).eps)
# Twice the tolerance of shares by quadrature, and far below any jump that matters.
NEAR = 2e-8


def choose_risk(consumer_risk: float | None, producer_risk: float | None) -> tuple[str, float]:
    """Return the name and value of the one risk given."""
    name, risk = choose_one({"consumer_risk": consumer_risk, "producer_risk": producer_risk})
    return name, check_probability(name, risk)


def get_risk(name: str, shares: Shares) -> float:
    """Return a global risk; ValueError if there are several."""
    risk = getattr(shares, NAMES[name])
    require(np.ndim(risk) == 0, name, risk, "must be of one set of laws and limits, not of many")
    return float(risk)


def check_symmetric(name: str, law: Law) -> None:
    """Raise ValueError unless a law is symmetric about 0."""
    ends = law.knots()
    symmetric = np.all(ends[..., 0] == -ends[..., -1]) and np.all(getattr(law, "mean", 0.0) == 0)
    require(symmetric, name, law, "must be symmetric about 0: else a risk may fall as errors grow")


def find_acceptance(
    name: str, risk: float, shares: Callable[[Window], Shares], tolerance: Window, reach: float
) -> Window:
    """Return acceptance limits with the same guard band at both tolerance limits.

    No deviation that occurs, true or measured, lies further than `reach` from 0.
    """
    low, high = tolerance
    sign, most = (1 if name == "producer_risk" else -1), _find_most(name, shares(tolerance))
    conform = "conform" if name == "producer_risk" else "do not conform"
    require(risk < most, name, risk, f"must be below {most!r}, the share of teeth that {conform}")

    def rise(guard: float) -> float:
        limits = low + guard, high - guard
        if limits[0] >= limits[1]:
            return most if name == "producer_risk" else 0.0
        return sign * get_risk(name, shares(limits))

    guard = _invert(rise, sign * risk, -reach, min((high - low) / 2, reach))
    reached = abs(rise(guard))
    close = math.isclose(reached, risk, rel_tol=NEAR, abs_tol=NEAR)
    allowed = f"is not reached: with fixed values the risk jumps to {reached!r}"
    require(close, name, risk, allowed)
    return low + guard, high - guard


def find_factor(name: str, risk: float, shares: Scaled, tolerance: Window) -> float:
    """Return the factor of the errors up to which the risk is at most the one wanted."""
    least = get_risk(name, shares(0.0, tolerance, tolerance))
    near, far = _split(name, shares, tolerance)
    found = _climb(near, far, risk) if risk > least else None
    if found is None:
        if name == "producer_risk":
            most = (
                f"{_find_most(name, shares(0.0, tolerance, tolerance))!r}, the share that conforms"
            )
        else:
            most = f"about {_find_peak(lambda f: near(f) - far(f)):.5g}, the largest found"
        allowed = f"must lie between {least!r}, that of a gauge without error, and {most}"
        refuse(name, risk, allowed)
    return found


def _find_most(name: str, shares: Shares) -> float:
    """Return the share of parts that conform, or of those that do not."""
    right = shares.rightly_accepted if name == "producer_risk" else shares.rightly_rejected
    return get_risk(name, shares) + float(right)


def _split(name: str, shares: Scaled, tolerance: Window) -> tuple[Function, Function]:
    """Return two increasing functions of the factor whose difference is the risk."""
    low, high = tolerance
    if name == "producer_risk":
        return lambda f: get_risk(name, shares(f, tolerance, tolerance)), lambda f: 0.0
    below, above = (-math.inf, high), (low, math.inf)
    beyond = [(below, (-math.inf, low)), (above, (high, math.inf))]
    both = math.isfinite(high - low)
    return _add(name, shares, [(below, below), (above, above)]), (
        _add(name, shares, beyond) if both else lambda f: 0.0
    )


def _add(name: str, shares: Scaled, windows: Sequence[tuple[Window, Window]]) -> Function:
    return lambda f: sum(get_risk(name, shares(f, *pair)) for pair in windows)


def _climb(near: Function, far: Function, wanted: float) -> float | None:
    """Return the least root of near - far = wanted; None if there is none."""
    target = wanted
    for _ in range(STEPS):
        found = _solve(near, target)
        if found is None:
            return None
        raised = wanted + far(found)
        if raised <= target * (1 + EPS):
            return found
        target = raised
    return None


def _solve(rise: Function, target: float) -> float | None:
    """Return where an increasing function of a positive number takes a value; None if nowhere."""
    exponent = 0
    while exponent < FAR and rise(2.0**exponent) < target:
        exponent += 1
    while exponent > -FAR and rise(2.0 ** (exponent - 1)) > target:
        exponent -= 1
    if abs(exponent) == FAR:
        return None
    return _invert(rise, target, 2.0 ** (exponent - 1), 2.0**exponent)


def _invert(rise: Function, wanted: float, low: float, high: float) -> float:
    ends = (np.array([end]) for end in (wanted, low, high))
    found = invert(lambda x: np.array([rise(v) for v in x.tolist()]), *ends, failure="no risk")
    return float(found[0])


def _find_peak(risk: Function) -> float:
    """Return the largest value found: the highest of octaves, refined."""
    from scipy.optimize import minimize_scalar

    top = max(OCTAVES, key=lambda k: risk(2.0**k))
    found = minimize_scalar(
        lambda x: -risk(2.0**x),
        bounds=(top - 1, top + 1),
        method="bounded",
        options={"xatol": 1e-3},
    )
    return -float(found.fun)
