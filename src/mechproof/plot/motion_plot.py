"""The motion of a planetary mechanism over one period: position, ratio and acceleration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from mechproof.arguments.scalars import require
from mechproof.mechanisms import EllipticPlanetary, OvalPlanetary
from mechproof.plot.canvas import SMALL, LineStyle, check_axes, label, tick_degrees, write

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from mechproof.mechanisms.units import Extremes

Planetary = EllipticPlanetary | OvalPlanetary

# Samples of a period: a step is less than a printer's dot.
SAMPLES = 721
HEIGHT = 110.0
LABELS = ("position φ₃, °", "ratio dφ₃/dφ₁", "acceleration d²φ₃/dφ₁²")


def motion(mechanism: Planetary, axes: Any = None, *, eta: Any = None) -> Sequence[Axes]:
    """Draw position, ratio and acceleration over one period of the ratio.

    The extremes of the ratio are marked with their values, in closed form; where the ratio is the
    same throughout, none. Of an `OvalPlanetary` the kind of motion is written above, and where
    the output rests is shaded: |ratio| <= eta.

    Parameters
    ----------
    mechanism : EllipticPlanetary or OvalPlanetary
        What moves; angles are drawn in degrees, with a tick every 30.
    axes : three matplotlib Axes, optional
        To draw on, from the top; without, on a new figure of a column's width.
    eta : real number or decimal string, optional
        |ratio| up to which the output counts as at rest, as in `OvalPlanetary.classify`.

    Returns
    -------
    three Axes
        Of position, ratio and acceleration.

    Raises
    ------
    TypeError, ValueError
        For another mechanism or other axes; for `eta` with an `EllipticPlanetary`, which has no
        rests; and as `OvalPlanetary.classify`.
    ImportError
        Without matplotlib: the extra `plot`.

    """
    check_planetary("mechanism", mechanism)
    extremes, title, rests = _describe(mechanism, eta)
    panels = check_axes("axes", axes, 3, HEIGHT)
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


def check_planetary(name: str, mechanism: Any) -> None:
    """Raise TypeError for what is no planetary mechanism."""
    known = isinstance(mechanism, EllipticPlanetary | OvalPlanetary)
    allowed = "must be an EllipticPlanetary or an OvalPlanetary"
    require(known, name, mechanism, allowed, TypeError)


def _describe(
    mechanism: Planetary, eta: Any
) -> tuple[Extremes, str, Sequence[tuple[float, float]]]:
    """Return extremes of the ratio, a headline and the rests of the first period."""
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
    """Cut an interval to the first period, on which it comes back."""
    copies = [(span[0] + turn * period, span[1] + turn * period) for turn in (-1, 0, 1)]
    cut = [(max(start, 0.0), min(end, period)) for start, end in copies]
    return [(start, end) for start, end in cut if start < end]


def _mark_extremes(panel: Axes, extremes: Extremes) -> None:
    """Mark both extremes of the ratio with their values, inside the first period."""
    if extremes.maximum == extremes.minimum:
        return
    from matplotlib.patheffects import withStroke

    # The line at zero may run behind.
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
