"""The figures of paper 3, redrawn from exact shares and from its simulation."""

import math
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from mechproof.conformity import Normal
from mechproof.mechanisms import ThicknessInspection
from mechproof.mechanisms.tooth_thickness_inspection import IT_120_TO_180, PUBLISHED_TOLERANCE
from mechproof.plot import Figure, shares
from mechproof.plot.canvas import LineStyle, label

from .mechanics import GAUGE_UM, K_PRINTED, RECOMMENDED_UM

# The paper's curves, by the grades of the tip diameter.
CURVES = {6: 1, 7: 2}
# Whether step 5 is as printed, and the grade.
CASES = tuple((as_printed, grade) for as_printed in (False, True) for grade in CURVES)
# The multiple of the limit error is not printed.
SIGMAS = 3
MICROMETRE = 1e-3
LARGEST_UM = GAUGE_UM / 2
TEETH, SEED = 20_000, 3
LIMITS_UM = np.linspace(0.0, LARGEST_UM, 101)
# Points of one curve are offset from those of the next, so that each can be seen.
SIMULATED_UM = [np.linspace(3.0, 21.0, 4) + 1.2 * case for case in range(len(CASES))]
LOOKS = {6: LineStyle.FIRST, 7: LineStyle.SECOND}
PRINTED_LOOKS: Mapping[int, Mapping[str, Any]] = {
    grade: {**look, "color": LineStyle.WRONG["color"], "lw": 0.8} for grade, look in LOOKS.items()
}


def inspect(limit_um: Any, grade: int, as_printed: bool = False) -> ThicknessInspection:
    """Return the inspection with gauges of these limit errors in um and a tip of a grade."""
    low, high = PUBLISHED_TOLERANCE
    limit = np.asarray(limit_um) * MICROMETRE
    gauge = Normal(np.zeros_like(limit), limit / SIGMAS)
    return ThicknessInspection.published(
        true=Normal.from_width((low + high) / 2, high - low, K_PRINTED),
        tip_diameter=Normal.from_width(0.0, IT_120_TO_180[grade], K_PRINTED),
        height=gauge,
        thickness=gauge,
        steps_as_printed=as_printed,
    )


def crossover_um(grade: int, as_printed: bool = False) -> float:
    """Return the limit error (um) of a gauge that spreads the thickness as the tip does."""
    inspection = inspect(1.0, grade, as_printed)
    spreads = [float(law.std) for law in inspection.errors if isinstance(law, Normal)]
    tip, height, thickness = spreads
    return tip / math.hypot(height, thickness)


def draw_share(canvas: Any, name: str) -> None:
    """Draw a share against the limit error of the gauge, both grades, both kinds of step 5."""
    panel, rng = canvas.subplots(), np.random.default_rng(SEED)
    for (as_printed, grade), places in zip(CASES, SIMULATED_UM, strict=True):
        looks, step = (PRINTED_LOOKS, "as printed") if as_printed else (LOOKS, "corrected")
        counted = inspect(places, grade, as_printed).simulate(rng=rng, count=TEETH)
        shares(
            LIMITS_UM,
            inspect(LIMITS_UM, grade, as_printed).shares(),
            panel,
            which=(name,),
            simulated=(places, counted),
            label="limit error of the gauge, µm",
            look={**looks[grade], "label": f"{CURVES[grade]}: tip of IT{grade}, step 5 {step}"},
        )
    for as_printed, grade in CASES:
        _mark_crossover(panel, name, grade, as_printed)
    panel.set_ylabel(f"{name.replace('_', ' ')}, % of all teeth")
    _mark_recommended(panel, "top" if name == "wrongly_rejected" else "bottom")
    handles = dict(zip(*reversed(panel.get_legend_handles_labels()), strict=True))
    canvas.legend(handles.values(), handles.keys(), loc="outside lower left", frameon=False)


def _mark_crossover(panel: Any, name: str, grade: int, as_printed: bool) -> None:
    """Mark the gauge beyond which it disturbs more than the tip diameter."""
    limit = crossover_um(grade, as_printed)
    share = 100 * getattr(inspect(limit, grade, as_printed).shares(), name)
    says = "from here on the gauge disturbs more than the tip"
    panel.plot(
        [limit], [share], **{**LineStyle.MARK, "marker": "D", "ms": 4}, mfc="#ffffff", label=says
    )


def _mark_recommended(panel: Any, end: str) -> None:
    limits = panel.get_ylim()
    panel.plot([RECOMMENDED_UM] * 2, limits, **LineStyle.GUIDE)
    panel.set_ylim(limits)
    place, aside = (limits[1], -2) if end == "top" else (limits[0], 2)
    label(panel, f"recommended: ±{RECOMMENDED_UM} µm", (RECOMMENDED_UM, place), (3, aside))


def wrongly_rejected(spread_um: float) -> float:
    """Return the percentage of good teeth rejected, as printed, for a tip of IT6 and a gauge."""
    return 100 * float(inspect(SIGMAS * spread_um, 6, as_printed=True).shares().wrongly_rejected)


CAPTION = (
    "against the limit error of the gauge, tip diameter of IT6 and IT7 (curves 1 and 2): exact "
    f"curves, points of {TEETH:,} simulated teeth with their standard errors. Thin: step 5 as "
    "printed, which counts the whole deviation of the tip diameter instead of half of it. The "
    "paper's curves are lost, and the text at hand has neither the laws nor the multiple of the "
    f"limit error: here all laws are normal and centred, tolerances span {K_PRINTED} standard "
    f"deviations and the limit error is {SIGMAS} of them. How much hangs on it: if the {GAUGE_UM} "
    f"µm of Table 1 are the full width of {SIGMAS} standard deviations (the right end), "
    f"{wrongly_rejected(GAUGE_UM / 2 / SIGMAS):.1f} % of good teeth are rejected by the printed "
    f"steps with IT6; if they are half the width of two, {wrongly_rejected(GAUGE_UM / 2):.1f} %. "
    "IT6 = 25 µm and IT7 = 40 µm are those of ISO 286-1. Diamonds: claim (b) holds from there on."
)
FIGURES = (
    Figure(
        "fig-4",
        "Fig. 4",
        "Step 5 as printed overstates what a poor tip circle costs in good teeth rejected.",
        f"Share of good teeth wrongly rejected {CAPTION}",
        "(a), curves of Figs. 4 and 5",
        partial(draw_share, name="wrongly_rejected"),
        height=95.0,
    ),
    Figure(
        "fig-5",
        "Fig. 5",
        "With half of the tip's deviation, as is right, more good teeth pass with every gauge.",
        f"Share of teeth rightly accepted {CAPTION}",
        "(a), rise with the limit error",
        partial(draw_share, name="rightly_accepted"),
        height=95.0,
    ),
)
