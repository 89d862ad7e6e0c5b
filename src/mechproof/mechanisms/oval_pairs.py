"""The pair 4-5, oval or cylindrical, next to the oval pair 6-3, and the kinds of their motion.

Two oval pairs, or a cylindrical and an oval one, act like one oval pair: with x being twice the
angle of its driver, wheel 3 turns against the carrier at the speed
1 - ratio = rate*(1 - e**2)/(1 + e**2 - 2*e*cos(x)), which falls from x = 0 to x = pi. The theorems
hold for exact numbers and for floats.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import InitVar, asdict, dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NamedTuple

from mechproof.kernels import oval_planetary as kernels
from mechproof.mechanisms.parameters import Given, Number, check_domain, check_number
from mechproof.mechanisms.units import Units


@dataclass(frozen=True)
class OvalPair:
    """Pair 4-5 of congruent ovals.

    Parameters
    ----------
    e : real number or decimal string
        Eccentricity of the generating ellipse, 0 <= e < 1.
    mount : real number or decimal string
        Turn of wheel 6 on its shaft (rad), forward from its position in the paper, where the major
        axes of 5 and 6 are at right angles.
    degrees : bool
        Whether the mount is in degrees; not a field.

    """

    e: Given
    mount: Given = Fraction(0)
    degrees: InitVar[bool] = field(default=False, kw_only=True)

    def __post_init__(self, degrees: bool) -> None:
        """Check the parameters; exact ones stay exact."""
        units = Units(degrees)
        e, mount = units.take("e", self.e, "1"), self.mount
        if isinstance(mount, str | Decimal | Fraction | int):
            mount = check_number("mount", mount)
        # A mount of zero stays exact.
        if not (isinstance(mount, Fraction) and mount == 0):
            mount = units.take(
                "mount", float(mount) if degrees and isinstance(mount, Fraction) else mount, "rad"
            )
        object.__setattr__(self, "e", check_size("e", e, kernel_name="e1"))
        object.__setattr__(self, "mount", check_number("mount", mount))


@dataclass(frozen=True)
class CylindricalPair:
    """Pair 4-5 of cylindrical wheels.

    Parameters
    ----------
    R4, R5 : real number or decimal string
        Radii of the sun 4 and of the satellite's wheel 5 (mm), positive.

    """

    R4: Given
    R5: Given

    def __post_init__(self) -> None:
        """Check the parameters; exact ones stay exact."""
        Units().set_fields(self, dict.fromkeys(asdict(self), "mm"), check_size)


def check_size(name: str, value: Any, kernel_name: str = "") -> Number:
    """Return the number, exact if given so, after checking the kernels' conditions on it."""
    number = check_number(name, value)
    called = kernel_name or name
    check_domain(kernels.DOMAIN, {called: number}, {called: (name, value)})
    return number


Kind = Literal["rest", "reciprocating", "pilgrim-step", "intermittent", "one-way"]


class Classified(NamedTuple):
    """Kind of the output's motion and its characteristics.

    `drift` is the mean advance in one turn of the carrier, `amplitude` half the range of phi3
    without its drift, `minimum` and `maximum` the extremes of the ratio, `period` the carrier angle
    after which it repeats. `rests` are the intervals of the carrier angle in one period in which
    |ratio| is at most the stated eta; for eta = 0 they are single points.
    """

    kind: Kind
    drift: float
    amplitude: float
    minimum: float
    maximum: float
    period: float
    rests: tuple[tuple[float, float], ...]


# The characteristics of a motion that are angles, and their unit.
ANGLES = dict.fromkeys(("drift", "amplitude", "period", "rests"), "rad")


class OnePair(NamedTuple):
    """One oval pair that acts like both: driver at rate*(phi1 - phase), eccentricity, and 1 - e."""

    rate: Number
    e: Number
    one_minus_e: Number
    phase: float

    @property
    def slowest(self) -> Number:
        """Speed of wheel 3 against the carrier at x = pi."""
        return self.rate * self.one_minus_e / (1 + self.e)

    @property
    def fastest(self) -> Number:
        """Speed of wheel 3 against the carrier at x = 0."""
        return self.rate * (1 + self.e) / self.one_minus_e


def classify(one: OnePair, eta: Number) -> Classified:
    """Return the kind of motion and its characteristics; `eta` as in `OvalPlanetary.classify`."""
    low, mean, high = 1 - one.fastest, 1 - one.rate, 1 - one.slowest
    return Classified(
        kind=_find_kind(low, mean, high, eta),
        drift=2 * math.pi * float(mean),
        amplitude=math.atan2(one.e, math.sqrt(one.one_minus_e * (1 + one.e))),
        minimum=float(low),
        maximum=float(high),
        period=math.pi / float(one.rate),
        rests=_find_rests(one, eta),
    )


def compose(e1: float, e2: float, mount: float) -> OnePair:
    """Return the pair that acts like two at any mounting angle, by sums that do not cancel."""
    turn = cmath.rect(1.0, -2 * mount)
    shared = 4 * e1 * e2 * math.cos(mount) ** 2
    across, along = (e1 - e2) ** 2 + shared, (1 - e1 * e2) ** 2 + shared
    e = math.sqrt(across / along)
    one_minus_e = (1 - e1) * (1 + e1) * (1 - e2) * (1 + e2) / along / (1 + e)
    phase = cmath.phase(e1 + e2 * turn) - cmath.phase(1 + e1 * e2 * turn)
    return OnePair(1.0, e, one_minus_e, phase / 2)


def _find_kind(low: Number, mean: Number, high: Number, eta: Number) -> Kind:
    if -eta <= low and high <= eta:
        return "rest"
    if low < -eta and high > eta:
        return "reciprocating" if -eta <= mean <= eta else "pilgrim-step"
    return "one-way" if low > eta or high < -eta else "intermittent"


def _find_rests(one: OnePair, eta: Number) -> tuple[tuple[float, float], ...]:
    """Return the intervals of phi1 in which |ratio| <= eta, over one period of the ratio."""
    rate, p, q = one.rate, 1 + one.e, one.one_minus_e
    # The same products as in _angle_at, so that rounding cannot make a root's argument negative.
    if rate * q > (1 + eta) * p or rate * p < (1 - eta) * q:
        return ()
    near = 0.0 if rate * p <= (1 + eta) * q else _angle_at(one, 1 + eta)
    far = math.pi if rate * q >= (1 - eta) * p else _angle_at(one, 1 - eta)
    if near == 0 and far == math.pi:
        spans = [(0.0, 2 * math.pi)]
    elif near == 0:
        spans = [(-far, far)]
    elif far == math.pi:
        spans = [(near, 2 * math.pi - near)]
    else:
        spans = [(near, far), (2 * math.pi - far, 2 * math.pi - near)]
    scale = 2 * float(one.rate)
    return tuple((one.phase + start / scale, one.phase + end / scale) for start, end in spans)


def _angle_at(one: OnePair, speed: Number) -> float:
    """Return x in [0, pi] where wheel 3 has the speed 1 - ratio; the speed falls with x."""
    p, q = 1 + one.e, one.one_minus_e
    above, below = q * (one.rate * p - speed * q), p * (speed * p - one.rate * q)
    return 2 * math.atan2(math.sqrt(above), math.sqrt(below))
