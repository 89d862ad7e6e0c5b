"""The figures of paper 1, redrawn from the kernels."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from mechproof.kernels.forms.elliptic_planetary import position_printed
from mechproof.mechanisms import EllipticPlanetary
from mechproof.plot import Figure
from mechproof.plot.canvas import LineStyle, label, write

from .rows.readings import HALF_WIDTHS, READINGS

MECHANISMS = {number: EllipticPlanetary.published(number) for number in READINGS}
LOOKS = {1: LineStyle.FIRST, 2: LineStyle.SECOND, 3: LineStyle.FIRST, 4: LineStyle.SECOND}
# Variants of the same radii, drawn in one panel.
PAIRS = ((1, 2), (3, 4))
HALF_TURN = 180.0
RED = LineStyle.WRONG["color"]
BRACKET = {"color": RED, "lw": 1.0, "marker": "_", "ms": 4}


def name_variant(number: int) -> str:
    """Return the name of a variant with its eccentricity, in the letters of Table 1."""
    return f"variant {number}, e = {MECHANISMS[number].e:g}"


def branch_end(number: int) -> float:
    """Return the carrier angle (degrees) where the arctangent of (12) first falls back."""
    return HALF_TURN / MECHANISMS[number].radius_ratio


def lack_at_branch_end(number: int) -> float:
    """Return by how many degrees (12) is too small just before it falls back."""
    mechanism = MECHANISMS[number]
    end = np.nextafter(np.radians(branch_end(number)), 0.0)
    printed = position_printed(end, mechanism.R1, mechanism.R2, mechanism.e)
    return float(np.degrees(mechanism.position(end) - printed))


def cut_branches(number: int, degrees: Any) -> Any:
    """Return (12) as printed in degrees, NaN where it falls back, to interrupt the line there."""
    mechanism = MECHANISMS[number]
    printed = position_printed(np.radians(degrees), mechanism.R1, mechanism.R2, mechanism.e)
    falls = np.flatnonzero(np.diff(printed) < 0)
    return np.insert(degrees, falls + 1, np.nan), np.insert(np.degrees(printed), falls + 1, np.nan)


def draw_positions(canvas: Any) -> None:
    """Draw position functions of the four variants, and (12) as printed."""
    panels = canvas.subplots(2, 1, sharex=True)
    degrees = np.linspace(0.0, HALF_TURN, 1441)
    for panel, pair in zip(panels, PAIRS, strict=True):
        for number in pair:
            mechanism = MECHANISMS[number]
            right = np.degrees(mechanism.position(np.radians(degrees)))
            panel.plot(degrees, right, **LOOKS[number], label=name_variant(number))
            panel.plot(*cut_branches(number, degrees), **LineStyle.WRONG)
        _mark_branch_end(panel, pair)
        panel.set_ylabel("output φ₃, °")
        panel.set_title(f"R₁ = {mechanism.R1:g} mm, R₂ = {mechanism.R2:g} mm")
        panel.legend(loc="upper left", frameon=False)
    panels[-1].set_xlabel("carrier φ₁, °")
    panels[-1].set_xticks(np.arange(0, 181, 30))


def _mark_branch_end(panel: Any, pair: Sequence[int]) -> None:
    """Mark by how much (12) is too small just before it first falls back."""
    end = branch_end(pair[0])
    right = float(np.degrees(MECHANISMS[pair[0]].position(np.radians(end))))
    lacks = [lack_at_branch_end(number) for number in pair]
    for lack in lacks:
        panel.plot([end, end], [right - lack, right], **BRACKET)
    text = " and ".join(f"{lack:.1f}°" for lack in lacks)
    says = f"(12) as printed: too small\nby {text} at {end:.1f}°"
    panel.plot([], [], **LineStyle.WRONG, label=says)


def draw_rates(canvas: Any) -> None:
    """Draw ratio and acceleration of the four variants over a turn of the carrier."""
    rows = canvas.subplots(4, 1, sharex=True)
    degrees = np.linspace(0.0, HALF_TURN, 1441)
    for pair, panels in zip(PAIRS, (rows[:2], rows[2:]), strict=True):
        for number in pair:
            mechanism, angle = MECHANISMS[number], np.radians(degrees)
            look = {**LOOKS[number], "label": name_variant(number)}
            panels[0].plot(degrees, mechanism.ratio(angle), **look)
            panels[1].plot(degrees, mechanism.acceleration(angle), **look)
        _mark_extremes(panels[0], pair)
        panels[0].set_ylabel("dφ₃/dφ₁")
        panels[1].set_ylabel("d²φ₃/dφ₁²")
        panels[1].axhline(0.0, **LineStyle.AXIS)
        panels[0].set_title(f"R₁ = {mechanism.R1:g} mm, R₂ = {mechanism.R2:g} mm")
        low, high = panels[1].get_ylim()
        panels[1].set_ylim(low, high + (high - low))
        panels[1].legend(loc="upper left", frameon=False)
    rows[-1].set_xlabel("carrier φ₁, °")
    rows[-1].set_xticks(np.arange(0, 181, 30))


def _mark_extremes(panel: Any, pair: Sequence[int]) -> None:
    """Mark the extremes of the ratio: the largest a period later, the smallest after half of it."""
    panel.margins(y=0.2)
    for number, upward in zip(pair, (-1, 1), strict=True):
        extremes = MECHANISMS[number].extremes()
        low, crest = np.degrees([extremes.at_minimum, extremes.period])
        panel.plot([low, crest], [extremes.minimum, extremes.maximum], **LineStyle.MARK)
        above = 4 if upward > 0 else -9
        label(panel, write(extremes.maximum), (crest, extremes.maximum), (0, above))
        label(panel, write(extremes.minimum), (low, extremes.minimum), (0, -4 * upward))


def draw_intervals(canvas: Any) -> None:
    """Draw the intervals of Table 3, and that of variant 3 according to its u."""
    panel = canvas.subplots()
    panel.axvline(0.0, **LineStyle.AXIS)
    for number, line in READINGS.items():
        mean, printed = float(line.mean), float(HALF_WIDTHS[number])
        right = 2 * float(line.uncertainty)
        if np.isclose(printed, right):
            _draw_interval(panel, number, mean, right, "", "#000000")
        else:
            _draw_interval(panel, number - 0.17, mean, right, "by u", "#000000")
            _draw_interval(panel, number + 0.17, mean, printed, "printed", RED)
    panel.set_yticks([*READINGS], [f"variant {number}" for number in READINGS])
    panel.set_ylim(max(READINGS) + 0.6, min(READINGS) - 0.6)
    panel.set_xlabel("mean error of φ₃ with mean ± 2u, °")


def _draw_interval(
    panel: Any, place: float, mean: float, half: float, says: str, colour: str
) -> None:
    panel.errorbar(mean, place, xerr=half, fmt="o", color=colour, capsize=3, elinewidth=1.2, ms=3.5)
    panel.text(
        1.02,
        place,
        f"{mean:.2f} ± {half:.2f}° {says}".replace("-", "\N{MINUS SIGN}"),
        transform=panel.get_yaxis_transform(),
        va="center",
        color=colour,
    )


FIGURES = (
    Figure(
        "fig-3",
        "Fig. 3",
        "Equation (12) as printed falls behind the position function and jumps.",
        "Position functions of the four variants of Table 1 over half a turn of the carrier: thick "
        "lines are the integral of (8), thin ones (12) as printed, cut where it falls back. Up to "
        "there, on the first branch of its arctangent, (12) is too small by up to "
        f"{lack_at_branch_end(1):.1f}° for e = {MECHANISMS[1].e:g} and "
        f"{lack_at_branch_end(2):.1f}° for e = {MECHANISMS[2].e:g}, whatever the radii. The text "
        "at hand names no axes of this figure and says that (8) was used; which formula its curves "
        "show cannot be seen.",
        "Fig. 3, formula used",
        draw_positions,
        height=125.0,
    ),
    Figure(
        "fig-3-rates",
        None,
        "The larger the eccentricity, the more the ratio swings; it never changes its sign.",
        "Ratio (8) of the four variants and its derivative, the analogue of the acceleration, "
        "of which the text at hand has no formula. Dots mark the extremes of the ratio, known in "
        "closed form: the largest where the satellite has made whole turns, the smallest half a "
        "turn later.",
        "different non-uniformity",
        draw_rates,
        height=140.0,
    ),
    Figure(
        "table-3",
        "Table 3",
        "The interval of variant 3 is half as wide as its uncertainty makes it.",
        "Mean error and interval mean ± 2u of each variant, from the mean and the u of Table 3. "
        "The printed half-width of variant 3, thin, is once u: either it should be "
        f"{2 * float(READINGS[3].uncertainty):.2f}°, or u should be "
        f"{float(HALF_WIDTHS[3]) / 2:.2f}°; which of the two is not decided. Either way the "
        "interval excludes a mean error of zero.",
        "Table 3, interval 3",
        draw_intervals,
        height=62.0,
    ),
)
