"""The figures of paper 1, redrawn from the kernels."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from mechproof.kernels.forms.elliptic_planetary import position_printed
from mechproof.mechanisms import EllipticPlanetary
from mechproof.plot import Figure
from mechproof.plot.canvas import Look, label, write

from .readings import HALF_WIDTHS, READINGS

MECHANISMS = {number: EllipticPlanetary.published(number) for number in READINGS}
LOOKS = {1: Look.FIRST, 2: Look.SECOND, 3: Look.FIRST, 4: Look.SECOND}
# Variants of the same radii, drawn in one panel.
PAIRS = ((1, 2), (3, 4))
HALF_TURN = 180.0


def name_variant(number: int) -> str:
    """Return what a variant is, in the letters of Table 1."""
    return f"variant {number}, e = {MECHANISMS[number].e:g}"


def branch_end(number: int) -> float:
    """Return the carrier angle (degrees) where the arctangent of (12) falls back first."""
    return HALF_TURN / MECHANISMS[number].radius_ratio


def lack_at_branch_end(number: int) -> float:
    """Return by how many degrees (12) is too small just before it falls back."""
    mechanism = MECHANISMS[number]
    end = np.nextafter(np.radians(branch_end(number)), 0.0)
    printed = position_printed(end, mechanism.R1, mechanism.R2, mechanism.e)
    return float(np.degrees(mechanism.position(end) - printed))


def cut_branches(number: int, degrees: Any) -> Any:
    """Return (12) as printed in degrees, NaN where it falls back, so that no line joins that."""
    mechanism = MECHANISMS[number]
    printed = position_printed(np.radians(degrees), mechanism.R1, mechanism.R2, mechanism.e)
    falls = np.flatnonzero(np.diff(printed) < 0)
    return np.insert(degrees, falls + 1, np.nan), np.insert(
        np.degrees(printed), falls + 1, np.nan
    )


def draw_positions(canvas: Any) -> None:
    """Draw position functions of the four variants, and (12) as printed."""
    panels = canvas.subplots(2, 1, sharex=True)
    degrees = np.linspace(0.0, HALF_TURN, 1441)
    for panel, pair in zip(panels, PAIRS, strict=True):
        for number in pair:
            mechanism = MECHANISMS[number]
            right = np.degrees(mechanism.position(np.radians(degrees)))
            panel.plot(degrees, right, **LOOKS[number], label=name_variant(number))
            panel.plot(*cut_branches(number, degrees), **Look.WRONG)
        _mark_branch_end(panel, pair)
        panel.set_ylabel("output φ₃, °")
        panel.set_title(f"R₁ = {mechanism.R1:g} mm, R₂ = {mechanism.R2:g} mm")
        panel.legend(loc="upper left", frameon=False)
    panels[-1].set_xlabel("carrier φ₁, °")
    panels[-1].set_xticks(np.arange(0, 181, 30))


def _mark_branch_end(panel: Any, pair: Sequence[int]) -> None:
    """Mark where (12) falls back first, and by how much it is too small just before."""
    end = branch_end(pair[0])
    panel.axvline(end, **Look.GUIDE)
    for number in pair:
        right = float(np.degrees(MECHANISMS[number].position(np.radians(end))))
        printed = right - lack_at_branch_end(number)
        panel.plot([end, end], [printed, right], color="#c2301c", lw=1.0, marker="_", ms=4)
    lacks = " and ".join(f"{lack_at_branch_end(number):.1f}°" for number in pair)
    top = panel.get_ylim()[1]
    text = f"(12) as printed: at {end:.1f}° too small\nby {lacks}, then it falls back"
    label(panel, text, (HALF_TURN, 0.02 * top), (-0.1, 0.1), color="#c2301c")
