"""The figures of paper 2, redrawn from the kernels."""

from typing import Any

import numpy as np

from mechproof.mechanisms import OvalPlanetary
from mechproof.plot import Figure
from mechproof.plot.canvas import LineStyle, label, write

from .rows.readings import READINGS

MECHANISMS = {number: OvalPlanetary.published(number) for number in READINGS}
# |ratio| up to which the output counts as at rest; the paper states none.
ETA = "0.01"
CLASSIFIED = {number: mechanism.classify(ETA) for number, mechanism in MECHANISMS.items()}
SWINGING, TURNING = (1, 2), (3, 4)
LOOKS = {1: LineStyle.FIRST, 2: LineStyle.SECOND, 3: LineStyle.FIRST, 4: LineStyle.SECOND}
TURN = np.linspace(0.0, 2 * np.pi, 1441)
INTERMITTENT = 3


def degrees(angle: float) -> str:
    """Write an angle in degrees."""
    return f"{write(np.degrees(angle), 3)}°"


def name_variant(number: int) -> str:
    """Return the number of a variant and its kind of motion."""
    return f"variant {number}, {CLASSIFIED[number].kind}"


def draw_positions(canvas: Any) -> None:
    """Draw position functions of the four variants over a turn, and the dwell of one."""
    swing, turn, rest = canvas.subplots(3, 1, gridspec_kw={"height_ratios": (1.15, 1.15, 0.9)})
    _draw_swings(swing)
    _draw_turns(turn)
    _draw_dwell(rest)
    for panel in (swing, turn):
        panel.set_ylabel("output φ₃, rad")
        panel.set_xticks(
            np.linspace(0, 2 * np.pi, 7), ["0", "π/3", "2π/3", "π", "4π/3", "5π/3", "2π"]
        )
        panel.set_xlabel("carrier φ₁, rad")
    swing.sharex(turn)


def _draw_swings(panel: Any) -> None:
    """Draw the variants without drift, with their amplitudes, and one read in the other sense."""
    panel.axhline(0.0, **LineStyle.AXIS)
    for number in SWINGING:
        position, amplitude = MECHANISMS[number].position(TURN), CLASSIFIED[number].amplitude
        says = f"{name_variant(number)}, ± {degrees(amplitude)}"
        panel.plot(TURN, position, **LOOKS[number], label=says)
        panel.axhline(amplitude, **LineStyle.GUIDE)
        panel.axhline(-amplitude, **LineStyle.GUIDE)
    first = SWINGING[0]
    mirrored = -MECHANISMS[first].position(TURN)
    says = f"variant {first} by (10) in the carrier's sense"
    panel.plot(TURN, mirrored, **LineStyle.WRONG, label=says)
    panel.set_ylim(-0.45, 1.0)
    panel.set_yticks([-0.4, -0.2, 0.0, 0.2, 0.4])
    panel.legend(loc="upper left", frameon=False)
    panel.set_title("Variants 1 and 2: no drift")


def _draw_turns(panel: Any) -> None:
    """Draw the variants that advance, with their mean drift, and where one of them rests."""
    for number in TURNING:
        drift = CLASSIFIED[number].drift
        says = f"{name_variant(number)}, {degrees(drift)} a turn"
        panel.plot(TURN, MECHANISMS[number].position(TURN), **LOOKS[number], label=says)
        panel.plot([0.0, 2 * np.pi], [0.0, drift], **LineStyle.GUIDE)
    resting = CLASSIFIED[INTERMITTENT]
    for start, end in resting.rests:
        for first in np.arange(start, 2 * np.pi, resting.period):
            panel.axvspan(first, first + end - start, ymax=0.75, color="#dddddd", lw=0)
    panel.set_ylim(-5.2, 2.1)
    panel.set_yticks([-4, -2, 0])
    panel.legend(loc="upper left", frameon=False)
    panel.set_title("Variants 3 and 4: drift (dotted), rests (grey)")


def _draw_dwell(panel: Any) -> None:
    """Draw the ratio of the variant that rests, near its double zero."""
    ((start, end),), eta = CLASSIFIED[INTERMITTENT].rests, float(ETA)
    middle, width = (start + end) / 2, end - start
    angle = np.linspace(middle - 1.6 * width, middle + 1.6 * width, 401)
    panel.axvspan(np.degrees(start), np.degrees(end), color="#dddddd", lw=0)
    panel.axhline(0.0, **LineStyle.AXIS)
    panel.axhline(-eta, **LineStyle.GUIDE)
    panel.plot(np.degrees(angle), MECHANISMS[INTERMITTENT].ratio(angle), **LineStyle.FIRST)
    panel.plot([np.degrees(middle)], [0.0], **LineStyle.MARK)
    panel.set_ylim(top=0.03)
    label(panel, "double zero", (np.degrees(middle), 0.0), (0, 5))
    panel.set_title(f"Variant {INTERMITTENT} near rest: |ratio| ≤ {eta:g} over {degrees(width)}")
    panel.set_ylabel("ratio dφ₃/dφ₁")
    panel.set_xlabel("carrier φ₁, °")


FIGURES = (
    Figure(
        "fig-2",
        "Fig. 2",
        "Two variants swing without drift, one rests three times in a turn, one turns one way.",
        "Position functions of the four variants over a turn of the carrier, positive with it; "
        "axes in rad as in the paper, of whose curves nothing else survives. Amplitudes, kinds of "
        "motion and drifts (dotted) follow from the parameters by theorems of the ledger. The thin "
        "line is variant 1 by (10) with the output counted in the carrier's sense: the wrong way "
        f"round. Grey: |ratio| ≤ {ETA}, a limit of ours; the ratio itself only touches zero at one "
        "point, without changing its sign.",
        "(11)",
        draw_positions,
        height=150.0,
    ),
)
