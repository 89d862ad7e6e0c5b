"""Physical dimensions, and those that the papers need most."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

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
    angle: Power = field(default=0, compare=False)

    @property
    def is_angle(self) -> bool:
        """Return whether values are shown in degrees too."""
        return self == NUMBER and self.angle == 1

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(
            self.length + other.length,
            self.mass + other.mass,
            self.time + other.time,
            self.temperature + other.temperature,
            self.angle + other.angle,
        )

    def __pow__(self, power: Power) -> Dimension:
        return Dimension(
            self.length * power,
            self.mass * power,
            self.time * power,
            self.temperature * power,
            self.angle * power,
        )

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    @property
    def powers(self) -> tuple[Power, Power, Power, Power]:
        """Return the powers of length, mass, time and temperature."""
        return self.length, self.mass, self.time, self.temperature

    def __str__(self) -> str:
        powers = zip("LMTK", self.powers, strict=True)
        return "·".join(n if p == 1 else f"{n}^{p}" for n, p in powers if p) or "1"


NUMBER = Dimension()
ANGLE = Dimension(angle=1)
LENGTH = Dimension(length=1)
SPEED = Dimension(length=1, time=-1)
FREQUENCY = Dimension(time=-1)
