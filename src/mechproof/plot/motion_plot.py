"""Planetary mechanisms: their motion over one period, and their wheels in mesh, to scale."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import check_real, require
from mechproof.kernels import oval_planetary as oval_kernels
from mechproof.mechanisms import CylindricalPair, EllipticPlanetary, OvalPlanetary
from mechproof.mechanisms.units import Units
from mechproof.plot.canvas import SMALL, LineStyle, check_axes, label, tick_degrees, write

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from mechproof.mechanisms.units import Extremes

Planetary = EllipticPlanetary | OvalPlanetary

# Number of samples of a period, so that a step is smaller than a printer's dot.
SAMPLES = 721
MOTION_HEIGHT = 110.0
LABELS = ("position φ₃, °", "ratio dφ₃/dφ₁", "acceleration d²φ₃/dφ₁²")
Array = NDArray[np.float64]

HEIGHT = 85.0


def motion(mechanism: Planetary, axes: Any = None, *, eta: Any = None) -> Sequence[Axes]:
    """Draw position, ratio and acceleration over one period of the ratio.

    The extremes of the ratio are marked with their values, from closed forms, unless the ratio is
    constant. For an `OvalPlanetary` the kind of motion is in the title, and intervals in which the
    output rests, |ratio| <= eta, are shaded.

    Parameters
    ----------
    mechanism : EllipticPlanetary or OvalPlanetary
        The mechanism; angles are drawn in degrees, with a tick every 30.
    axes : three matplotlib Axes, optional
        Axes to draw on, from the top; by default, those of a new figure of a column's width.
    eta : real number or decimal string, optional
        |ratio| up to which the output counts as at rest, as in `OvalPlanetary.classify`.

    Returns
    -------
    three Axes
        Those of position, ratio and acceleration.

    Raises
    ------
    TypeError, ValueError
        For any other mechanism or axes; for `eta` with an `EllipticPlanetary`, which has no rests;
        and as `OvalPlanetary.classify`.
    ImportError
        If matplotlib, the extra `plot`, is not installed.

    """
    check_planetary(mechanism)
    extremes, title, rests = _describe(mechanism, eta)
    panels = check_axes("axes", axes, 3, MOTION_HEIGHT)
    angles = np.linspace(0.0, extremes.period, SAMPLES)
    curves = (
        np.degrees(mechanism.position(angles)),
        mechanism.ratio(angles),
        mechanism.acceleration(angles),
    )
    for panel, values, name in zip(panels, curves, LABELS, strict=True):
        for start, end in rests:
            panel.axvspan(np.degrees(start), np.degrees(end), color="#dddddd", lw=0)
        panel.axhline(0.0, **LineStyle.AXIS)
        panel.plot(np.degrees(angles), values, **LineStyle.FIRST)
        panel.set_ylabel(name, fontsize=SMALL)
    tick_degrees(panels[-1].xaxis, float(np.degrees(extremes.period)))
    tick_degrees(panels[0].yaxis, float(np.ptp(curves[0])))
    panels[0].set_title(title, loc="left", fontsize=SMALL)
    panels[-1].set_xlabel("carrier φ₁, ° (one period of the ratio)", fontsize=SMALL)
    _mark_extremes(panels[1], extremes)
    return panels


def check_planetary(mechanism: Any) -> None:
    """Raise TypeError unless the object is a planetary mechanism."""
    known = isinstance(mechanism, EllipticPlanetary | OvalPlanetary)
    allowed = "must be an EllipticPlanetary or an OvalPlanetary"
    require(known, "mechanism", mechanism, allowed, TypeError)


def _describe(
    mechanism: Planetary, eta: Any
) -> tuple[Extremes, str, Sequence[tuple[float, float]]]:
    """Return the extremes of the ratio, a title, and the rests in the first period."""
    extremes = mechanism.extremes()
    if isinstance(mechanism, EllipticPlanetary):
        require(eta is None, "eta", eta, "an EllipticPlanetary has no rests; leave it out")
        advance = mechanism.position(extremes.period) / extremes.period * 2 * np.pi
        return extremes, _write_kind("one-way", advance), ()
    found = mechanism.classify(eta)
    title = _write_kind(found.kind, found.drift)
    if rest := sum(end - start for start, end in found.rests):
        title += f"\nat rest over {write(np.degrees(rest))}° of {write(np.degrees(found.period))}°"
    rests = [part for span in found.rests for part in _wrap(span, found.period)]
    return extremes, title, rests


def _write_kind(kind: str, drift: float) -> str:
    return f"{kind}, {write(np.degrees(drift))}° in a turn of the carrier"


def _wrap(span: tuple[float, float], period: float) -> list[tuple[float, float]]:
    """Return the parts of an interval, repeated with the period, that lie in the first period."""
    copies = [(span[0] + turn * period, span[1] + turn * period) for turn in (-1, 0, 1)]
    cut = [(max(start, 0.0), min(end, period)) for start, end in copies]
    return [(start, end) for start, end in cut if start < end]


def _mark_extremes(panel: Axes, extremes: Extremes) -> None:
    """Mark both extremes of the ratio with their values, inside the first period."""
    if extremes.maximum == extremes.minimum:
        return
    from matplotlib.patheffects import withStroke

    # A halo, because the line at zero may run behind the text.
    halo = withStroke(linewidth=2, foreground="#ffffff")
    panel.margins(y=0.25)
    for value, place, upward in (
        (extremes.maximum, extremes.at_maximum, 1),
        (extremes.minimum, extremes.at_minimum, -1),
    ):
        inside = np.degrees(place % extremes.period)
        panel.plot([inside], [value], **LineStyle.MARK)
        share = inside / np.degrees(extremes.period)
        sideways = 0.1 if share < 0.2 else -0.1 if share > 0.8 else 0.0
        text = f"{write(value)} at {write(inside)}°"
        label(panel, text, (float(inside), value), (sideways, 4.0 * upward), path_effects=[halo])


class Wheel(NamedTuple):
    """A pitch curve: its number in the paper, its axis, and the direction of its longest radius.

    Its radii about the axis are a (1 - e^2)/(1 - e cos(lobes (angle - turned))); e = 0 is a circle.
    """

    number: int
    axis: Array
    a: float
    e: float
    lobes: int
    turned: float

    def radius(self, angle: Any) -> Any:
        """Return the radius in a direction of the frame (rad)."""
        wave = np.cos(self.lobes * (np.asarray(angle) - self.turned))
        return self.a * (1 - self.e**2) / (1 - self.e * wave)

    def point(self, angle: Any) -> Array:
        """Return the point of the curve in a direction of the frame (rad), shape (..., 2)."""
        ray = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        return np.asarray(self.axis + np.asarray(self.radius(angle))[..., np.newaxis] * ray)

    def outline(self) -> Array:
        """Return points of the closed curve, shape (n, 2)."""
        return self.point(np.linspace(0.0, 2 * np.pi, SAMPLES))


def pitch_curves(
    mechanism: Planetary, phi1: float, ax: Any = None, *, degrees: bool = False
) -> Axes:
    """Draw the wheels in mesh at the carrier angle `phi1` (rad), to scale.

    Each wheel is labelled with its number; a line shows its longest radius; B and D are the points
    of contact. Lengths are in mm or, for an `OvalPair`, whose size is not given, in units of the
    major semi-axis a.

    Parameters
    ----------
    mechanism : EllipticPlanetary or OvalPlanetary
        The wheels.
    phi1 : float
        Angle of the carrier (rad).
    degrees : bool
        Whether the angle is in degrees.
    ax : matplotlib Axes, optional
        Axes to draw on; by default, those of a new figure of a column's width.

    Returns
    -------
    Axes
        The axes drawn on.

    Raises
    ------
    TypeError, ValueError
        For any other mechanism, an angle that is no finite number, or anything but Axes.
    ImportError
        If matplotlib, the extra `plot`, is not installed.

    """
    check_planetary(mechanism)
    angle = check_real("phi1", Units(degrees).take("phi1", phi1, "rad"))
    (panel,) = check_axes("ax", ax, 1, HEIGHT)
    wheels = place_wheels(mechanism, angle)
    for wheel in wheels:
        _draw_wheel(panel, wheel, angle)
    _draw_line_of_centres(panel, wheels, angle)
    panel.set_aspect("equal")
    is_sized = isinstance(mechanism, EllipticPlanetary) or isinstance(
        mechanism.pair, CylindricalPair
    )
    panel.set_xlabel("mm" if is_sized else "lengths in units of a", fontsize=SMALL)
    panel.set_title(
        f"φ₁ = {write(np.degrees(angle))}°, φ₃ = {write(np.degrees(mechanism.position(angle)))}°",
        loc="left",
        fontsize=SMALL,
    )
    return panel


def place_wheels(mechanism: Planetary, phi1: float) -> tuple[Wheel, Wheel, Wheel, Wheel]:
    """Return the wheels 4, 5, 6, 3 at a carrier angle, in the fixed frame."""
    if isinstance(mechanism, EllipticPlanetary):
        return _place_elliptic(mechanism, phi1)
    return _place_oval(mechanism, phi1)


def _place_elliptic(mechanism: EllipticPlanetary, phi1: float) -> tuple[Wheel, Wheel, Wheel, Wheel]:
    """Place the wheels; at zero the far end of wheel 6 points to A, that of wheel 3 away from C."""
    large, small, e = mechanism.R1, mechanism.R2, mechanism.e
    a, origin = (large - small) / 2, np.zeros(2)
    centre = 2 * a * np.array([np.cos(phi1), np.sin(phi1)])
    satellite = phi1 - mechanism.radius_ratio * phi1
    return (
        Wheel(4, origin, large, 0.0, 1, 0.0),
        Wheel(5, centre, small, 0.0, 1, satellite),
        Wheel(6, centre, a, e, 1, np.pi + satellite),
        Wheel(3, origin, a, e, 1, np.pi + float(mechanism.position(phi1))),
    )


def _place_oval(mechanism: OvalPlanetary, phi1: float) -> tuple[Wheel, Wheel, Wheel, Wheel]:
    """Place the wheels; at zero the major axes of 4 and unmounted 6 lie on A-C, of 5, 3 across."""
    pair, e2, origin, across = mechanism.pair, float(mechanism.e2), np.zeros(2), np.pi / 2
    mount = 0.0
    if isinstance(pair, CylindricalPair):
        radii, e1 = (float(pair.R4), float(pair.R5)), 0.0
        turn = radii[0] / radii[1] * phi1
    else:
        radii, e1, mount = (1.0, 1.0), float(pair.e), float(pair.mount)
        turn = drive(e1, phi1)
    a = sum(radii) / 2
    centre = 2 * a * np.array([np.cos(phi1), np.sin(phi1)])
    satellite = phi1 + turn
    output = across - drive(e2, mount) + float(mechanism.position(phi1))
    return (
        Wheel(4, origin, radii[0], e1, 2, 0.0),
        Wheel(5, centre, radii[1], e1, 2, across + satellite),
        Wheel(6, centre, a, e2, 2, satellite + mount),
        Wheel(3, origin, a, e2, 2, output),
    )


def drive(e: float, angle: float) -> float:
    """Return how far an oval pair turns its driven wheel if its driver turns by `angle`."""
    return angle - float(oval_kernels.position_cylindrical(angle, 1.0, 1.0, e))


# How each wheel is drawn, and the place of its number in degrees from the line A-C.
LOOKS = {
    4: (LineStyle.FIRST, 120),
    5: (LineStyle.FIRST, 60),
    6: (LineStyle.SECOND, -60),
    3: (LineStyle.SECOND, -120),
}
# Distance of names from their points, in typographic points.
AWAY = 4.5


def _draw_wheel(panel: Axes, wheel: Wheel, angle: float) -> None:
    look, aside = LOOKS[wheel.number]
    panel.plot(*wheel.outline().T, **look, label=f"wheel {wheel.number}")
    longest, direction = wheel.turned, angle + np.radians(aside)
    thin = {"color": look["color"], "lw": 0.5, "ls": "-"}
    panel.plot(*np.stack([wheel.axis, wheel.point(longest)]).T, **thin)
    panel.plot(*wheel.axis, color=look["color"], marker="+", ms=5)
    x, y = wheel.point(direction).tolist()
    panel.text(
        x,
        y,
        str(wheel.number),
        fontsize=SMALL,
        ha="center",
        va="center",
        bbox={"boxstyle": "circle,pad=0.15", "fc": "#ffffff", "ec": look["color"], "lw": 0.5},
    )


def _draw_line_of_centres(panel: Axes, wheels: Sequence[Wheel], angle: float) -> None:
    """Draw the carrier from A to C, and the contacts B of 4 and 5, D of 6 and 3."""
    sun, satellite, _, output = wheels
    ray = np.array([np.cos(angle), np.sin(angle)])
    places = {"A": sun.axis, "C": satellite.axis, "B": sun.point(angle), "D": output.point(angle)}
    panel.plot(*np.stack([places["A"], places["C"]]).T, **LineStyle.GUIDE)
    # The curves cross the line A-C at right angles: near it, the names of contacts point away from
    # each other, and those of the axes are next to it.
    near, far = sorted("BD", key=lambda name: float(places[name] @ ray))
    turned = {near: 205, far: 25, "A": 110, "C": 70}
    for name, place in places.items():
        if name in "BD":
            panel.plot(*place, **LineStyle.MARK)
        direction = angle + np.radians(turned[name])
        aside = (AWAY * np.cos(direction), AWAY * np.sin(direction))
        label(panel, name, tuple(place), aside)
