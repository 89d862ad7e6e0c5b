"""The figures of paper 5, as far as its printed data permit."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

from mechproof.kernels import track_wheel as kernels
from mechproof.mechanisms import TrackWheel
from mechproof.plot import Figure
from mechproof.plot.canvas import LineStyle, label, write

from .mechanics import *
from .rows.table import PRINTED_VALUES, total_by_printed_sum

# Not printed: the number of periods, the thickness and the shift. Chosen, without shift.
PERIODS, THICKNESSES, THICKNESS = 6, (10.0, 20.0, 30.0), 20.0
NO_SHIFT = (0.0, 0.0, 0.0)
MICROMETRES = 1e3
ALPHA, RHO = "\N{GREEK SMALL LETTER ALPHA}", "\N{GREEK SMALL LETTER RHO}"
FIELDS = {symbol: float(PRINTED_VALUES[symbol]) for symbol in FIVE_ERRORS}
THERMAL_SHARE = float(PRINTED_VALUES[share])
NAMES = {
    form: r"mounting surface $\Delta_\phi$",
    mounting: r"mounting $\Delta_y$",
    elastic: r"elastic deformations $\Delta_\delta$",
    setting: r"machine setting $\Delta_n$",
    wear: r"tool wear $\Delta_u$",
}
# The coefficients K_i are not printed: 1 for normal laws, sqrt(3) for uniform ones.
NORMAL, UNIFORM = 1.0, float(np.sqrt(3.0))


def published(thickness: float) -> TrackWheel:
    """Return the wheel of Table 1 with the chosen number of periods and a thickness."""
    return TrackWheel.published(z=PERIODS, H=thickness, shift=NO_SHIFT)


def collect(**changed: Any) -> Any:
    """Return the five errors of Table 1, shape (..., 5), with some of them replaced by arrays."""
    columns = [changed.get(str(symbol), field) for symbol, field in FIELDS.items()]
    return np.stack(np.broadcast_arrays(*columns), axis=-1)


def total_random(errors: Any, coefficient: float = NORMAL) -> Any:
    """Return the total by the corrected (6), with Delta_T random and a share of the total (mm)."""
    ones = np.ones(len(FIELDS))
    return kernels.error_sum_thermal(
        errors, ones, coefficient * ones, 1.0, THERMAL_SHARE, coefficient
    )


def total_systematic(errors: Any) -> Any:
    """Return the total with a systematic Delta_T, outside the root (mm)."""
    ones = np.ones(len(FIELDS))
    return kernels.error_sum(errors, ones, ones, 1.0) / (1.0 - THERMAL_SHARE)


def total_printed(form_error: Any, unit_in_mm: float) -> Any:
    """Return the total by (6) as printed, computed in a unit, against the form error (mm)."""
    kept = {symbol: value for symbol, value in PRINTED_VALUES.items() if symbol != form}
    printed = total_by_printed_sum(sp.nsimplify(unit_in_mm), SUM_OF_SQUARES.subs(kept))
    return sp.lambdify(form, printed, "numpy")(form_error)


def draw_track(canvas: Any) -> None:
    """Draw the track unrolled, its errors from the turns of Table 1, and the largest of them."""
    track, error, largest = canvas.subplots(3, 1, gridspec_kw={"height_ratios": (0.9, 1.5, 1.0)})
    angle = np.linspace(0.0, 2 * np.pi, 721)
    _draw_radius(track, np.degrees(angle), published(THICKNESS))
    for thickness in THICKNESSES:
        wheel, is_chosen = published(thickness), thickness == THICKNESS
        thin = {} if is_chosen else {"lw": 0.6}
        for values, look, name in (
            (wheel.planar_error(angle), LineStyle.SECOND, "in the plane (17)"),
            (wheel.spatial_error(angle), LineStyle.FIRST, "in space (18)"),
        ):
            shown = MICROMETRES * values
            error.plot(
                np.degrees(angle), shown, **{**look, **thin}, label=name if is_chosen else None
            )
        end = MICROMETRES * float(wheel.planar_error(angle[-1]))
        label(error, f"{thickness:g}", (360.0, end), (3, 0))
    error.set_ylim(0, 92)
    error.set_xticks(np.arange(0, 361, 60))
    error.legend(loc="upper left", frameon=False, ncols=2)
    error.set_ylabel("error, µm")
    error.set_title("Position errors from the turns of Table 1 alone")
    error.set_xlabel("polar angle φ, °   (at the right: Hₛ, mm)")
    _draw_largest(largest, published(THICKNESS), angle)


def _draw_radius(panel: Any, degrees: Any, wheel: TrackWheel) -> None:
    panel.plot(degrees, wheel.radius(np.radians(degrees)), **LineStyle.FIRST)
    levels = (wheel.R - wheel.A, wheel.R, wheel.R + wheel.A)
    for level in levels:
        panel.axhline(level, **LineStyle.GUIDE)
    panel.set_yticks(levels, [f"{level:g}" for level in levels])
    panel.set_xticks(np.arange(0, 361, 60))
    panel.set_ylabel("R, R ± A, mm")
    panel.set_title(f"Radius of the track unrolled, z = {PERIODS} chosen")


def _draw_largest(panel: Any, wheel: TrackWheel, angle: Any) -> None:
    """Draw those bars of Fig. 3 that need no shift."""
    moved = wheel.displacement(angle)
    values = {
        "X₀": np.abs(moved[:, 0]),
        "Y₀": np.abs(moved[:, 1]),
        "Z₀": np.abs(moved[:, 2]),
        "plane": wheel.planar_error(angle),
        "space": wheel.spatial_error(angle),
    }
    bars = [MICROMETRES * float(np.max(value)) for value in values.values()]
    panel.bar([*values], bars, width=0.6, color="#d5dfec", edgecolor="#000000", lw=0.7)
    for place, bar in enumerate(bars):
        label(panel, write(bar, 3), (place, bar), (0, 2))
    panel.margins(y=0.2)
    panel.set_ylabel("error, µm")
    panel.set_title(f"The largest of them, Hₛ = {THICKNESS:g} mm chosen")


def draw_growth(canvas: Any) -> None:
    """Draw the total error against the form error, by (6) corrected and as printed."""
    panel = canvas.subplots()
    forms, here = np.linspace(0.0, 0.05, 101), FIELDS[form]
    kinds: Mapping[str, tuple[Callable[[Any], Any], Mapping[str, Any]]] = {
        "(6) as printed, in mm": (lambda f: total_printed(f, 1.0), {**LineStyle.WRONG, "lw": 1.1}),
        "corrected, all Kᵢ = √3": (
            lambda f: total_random(collect(Delta_phi=f), UNIFORM),
            LineStyle.THIRD,
        ),
        r"corrected, $\Delta_T$ systematic": (
            lambda f: total_systematic(collect(Delta_phi=f)),
            LineStyle.FOURTH,
        ),
        "corrected, all Kᵢ = 1": (lambda f: total_random(collect(Delta_phi=f)), LineStyle.FIRST),
        "(6) as printed, in µm": (
            lambda f: total_printed(f, 1.0 / MICROMETRES),
            {**LineStyle.WRONG, "ls": (0, (4, 1, 1, 1)), "lw": 1.1},
        ),
    }
    panel.axvline(MICROMETRES * here, **LineStyle.GUIDE)
    for name, (rule, look) in kinds.items():
        at_table = MICROMETRES * float(rule(np.array(here)))
        says = f"{name}: {write(at_table, 3)} µm"
        panel.plot(MICROMETRES * forms, MICROMETRES * rule(forms), **look, label=says)
        panel.plot([MICROMETRES * here], [at_table], **{**LineStyle.MARK, "ms": 2.5})
    panel.set_ylim(0, 200)
    panel.set_xlabel(r"form error $\Delta_\phi$, µm")
    panel.set_ylabel("total error, µm")
    text = f"Table 1: {write(MICROMETRES * here)} µm"
    label(panel, text, (MICROMETRES * here, 0.0), (3, 3))
    canvas.legend(loc="outside lower left", frameon=False)


def largest_gain() -> float:
    """Return the percentage by which the total falls without any elastic error."""
    return float(100 * (1 - total_random(collect(Delta_delta=0.0)) / total_random(collect())))


def draw_gain(canvas: Any) -> None:
    """Draw the total against the remaining elastic error, with the rest as in Table 1."""
    panel, before = canvas.subplots(), FIELDS[elastic]
    left = np.linspace(0.0, before, 101)
    curve = total_random(collect(Delta_delta=left))
    panel.plot(MICROMETRES * left, MICROMETRES * curve, **LineStyle.FIRST)
    first, last = (MICROMETRES * float(value) for value in (curve[-1], curve[0]))
    panel.axhline(first, **LineStyle.GUIDE)
    panel.plot([MICROMETRES * before, 0.0], [first, last], **LineStyle.MARK)
    panel.annotate(
        "", (0.0, last), (0.0, first), arrowprops={"arrowstyle": "->", "lw": 0.8, "shrinkB": 3}
    )
    label(panel, f"at most {write(largest_gain(), 3)} % less", (0.0, (first + last) / 2), (5, 0))
    label(panel, f"Table 1: {write(first, 3)} µm", (MICROMETRES * before, first), (0, 5))
    label(panel, f"{write(last, 3)} µm", (0.0, last), (5, -4))
    panel.set_xlim(-2, MICROMETRES * before + 8)
    panel.set_ylim(last - 4, first + 4)
    panel.set_xlabel(r"elastic error $\Delta_\delta$ that the optimised cut leaves, µm")
    panel.set_ylabel("total error, µm")


def draw_contributions(canvas: Any) -> None:
    """Draw what each error of Table 1 contributes to the square of the total."""
    panel = canvas.subplots()
    whole = float(total_random(collect()))
    fields = {NAMES[symbol]: field for symbol, field in FIELDS.items()}
    fields[r"temperature $\Delta_T$"] = THERMAL_SHARE * whole
    ordered = sorted(fields.items(), key=lambda item: item[1])
    parts = [100 * (field / whole) ** 2 for _, field in ordered]
    panel.barh([name for name, _ in ordered], parts, color="#d5dfec", edgecolor="#000000", lw=0.7)
    for place, ((_, field), part) in enumerate(zip(ordered, parts, strict=True)):
        text = f"{part:.1f} % ({write(MICROMETRES * field, 3)} µm)"
        label(panel, text, (part, place), (3, 0))
    panel.set_xlim(0, 1.75 * max(parts))
    panel.set_xlabel(f"share of the squared total of {write(MICROMETRES * whole, 3)} µm, %")


def draw_scheme(canvas: Any) -> None:
    """Draw the track with its letters: O_1, R, A, the radius vector and the polar angle."""
    panel = canvas.subplots()
    angle = np.linspace(0.0, 2 * np.pi, 1441)
    R, A = (float(PRINTED_VALUES[symbol]) for symbol in (radius, amplitude))
    for size, look in ((R, LineStyle.GUIDE), (R + A, LineStyle.AXIS), (R - A, LineStyle.AXIS)):
        panel.plot(size * np.cos(angle), size * np.sin(angle), **look)
    panel.plot(*kernels.track(angle, R, A, PERIODS, THICKNESS)[:, :2].T, **LineStyle.FIRST)
    here = np.radians(40.0)
    x, y = (float(c) for c in kernels.track(here, R, A, PERIODS, THICKNESS)[:2])
    panel.plot([0.0, x], [0.0, y], **LineStyle.THIRD)
    panel.plot([0.0, x], [0.0, y], **LineStyle.MARK)
    turn = np.linspace(0.0, here, 60)
    panel.plot(12 * np.cos(turn), 12 * np.sin(turn), **LineStyle.THIRD)
    reach = R + A + 14
    for tip in ((reach, 0.0), (0.0, reach)):
        panel.plot([0.0, tip[0]], [0.0, tip[1]], **LineStyle.AXIS)
    label(panel, f"X₀, turn {ALPHA}", (reach, 0.0), (0, 4))
    label(panel, "Y₀, turn β", (0.0, reach), (5, -2))
    label(panel, "O₁", (0.0, 0.0), (-4, -5))
    label(panel, RHO, (0.6 * x, 0.6 * y), (-5, 4))
    label(panel, "φ", (12.0, 3.0), (3, 2))
    label(panel, "N", (x, y), (16, 8))
    for size, text, place in (
        (R + A, "R + A", -25.0),
        (R, "R", -60.0),
        (R - A, "R \u2212 A", -90.0),
    ):
        way = np.radians(place)
        tip = (size * np.cos(way), size * np.sin(way))
        panel.plot([0.0, tip[0]], [0.0, tip[1]], **LineStyle.GUIDE)
        label(panel, text, (0.62 * tip[0], 0.62 * tip[1]), (-5, -5))
    panel.set_aspect("equal")
    panel.set_axis_off()


CHOSEN = "The number of periods, the thickness and the shift are not in the text at hand"
FIGURES = (
    Figure(
        "scheme",
        None,
        "The letters of the track: a circle of radius R, shifted by A, once in each period.",
        "The track (16) with R and A of Table 1, between the circles of radius R \u2212 A and R + "
        f"A; N is a point with the radius vector {RHO} and the polar angle φ. X₀ and Y₀ are the "
        f"axes of the machine, moved to O₁, about which the part is turned by {ALPHA} and β. "
        f"{CHOSEN}: here there are {PERIODS} periods and no shift.",
        "(16), shifted circle",
        draw_scheme,
        height=90.0,
    ),
    Figure(
        "fig-3",
        "Fig. 3",
        f"At a thickness of {THICKNESS:g} mm the turns of Table 1 move the track by more in height "
        "than in its plane.",
        "From the top: the track (16), R and A of Table 1; the position error of its points from "
        "the turns of Table 1 alone, in the end plane (17) and in space (18); the largest of them, "
        f"as in the paper's bar chart. {CHOSEN}: z = {PERIODS} and Hₛ = {THICKNESS:g} mm are "
        f"chosen here (thin: {THICKNESSES[0]:g} and {THICKNESSES[-1]:g} mm), the shift is left "
        "out. So the paper's bars, whose values are lost, cannot be redrawn.",
        "Consequences, turns alone",
        draw_track,
        height=135.0,
    ),
    Figure(
        "fig-4",
        "Fig. 4",
        "By (6) as printed the total depends on the unit in which it is computed.",
        "Total error against the form error of the mounting surface, with the other errors as in "
        "Table 1, by (6) corrected and as printed; dots mark the values of Table 1. The "
        "coefficients are not in the text at hand: all are 1 (normal laws) except where √3 "
        "(uniform laws) is given. The tangential and radial errors that the paper draws cannot be "
        "recomputed: how shift and turns follow from the form error is not in the text at hand.",
        "Consequences, no form error",
        draw_growth,
        height=95.0,
    ),
    Figure(
        "fig-5",
        "Fig. 5",
        f"Without any elastic error the total would fall by {write(largest_gain(), 2)} %.",
        "Total error by the corrected (6) against the elastic error that the optimised cut "
        "leaves, with the other errors of Table 1 unchanged and all coefficients 1. The text at "
        "hand has neither the new elastic error nor what else the cut changed: the paper's graphs "
        "cannot be redrawn, only how far the total can fall at most.",
        "Fig. 5, largest possible gain",
        draw_gain,
        height=60.0,
    ),
    Figure(
        "table-1",
        "Table 1",
        "Mounting and elastic deformation make up most of the total error.",
        "Shares of the errors of Table 1 in the square of their total by the corrected (6), all "
        f"coefficients 1, Δ_T random: the paper's {100 * THERMAL_SHARE:g} % of the total. The "
        "symbol of the machine setting is uncertain in print.",
        "Consequences, shares of the errors",
        draw_contributions,
        height=55.0,
    ),
)
