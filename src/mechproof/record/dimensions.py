"""Physical dimensions, and those that the papers need most."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from operator import add

Power = int | Fraction


@dataclass(frozen=True)
class Dimension:
    """Exponents of the base quantities; angles and pure numbers have none.

    That of the angle is kept beside them: it tells how a value is shown and is compared nowhere.
    """

    length: Power = 0
    mass: Power = 0
    time: Power = 0
    temperature: Power = 0
    current: Power = 0
    amount: Power = 0
    angle: Power = field(default=0, compare=False)

    @property
    def is_angle(self) -> bool:
        """Return whether values are shown in degrees too."""
        return self == NUMBER and self.angle == 1

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(*map(add, self._exponents, other._exponents))

    def __pow__(self, power: Power) -> Dimension:
        return Dimension(*(one * power for one in self._exponents))

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    @property
    def powers(self) -> tuple[Power, ...]:
        """Return the powers of the base quantities, in their order above."""
        return self._exponents[:-1]

    @property
    def _exponents(self) -> tuple[Power, ...]:
        return tuple(vars(self).values())

    def __str__(self) -> str:
        # As ISO 80000-1 prints them.
        powers = zip("LMTΘIN", self.powers, strict=True)
        return "·".join(n if p == 1 else f"{n}^{p}" for n, p in powers if p) or "1"


NUMBER = Dimension()
ANGLE = Dimension(angle=1)
LENGTH = Dimension(length=1)
SPEED = Dimension(length=1, time=-1)
FREQUENCY = Dimension(time=-1)
