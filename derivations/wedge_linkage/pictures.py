"""The figures of paper 4, redrawn from the kernels for both reconstructed sets of sizes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, partial
from typing import Any

import numpy as np

from mechproof.kernels import wedge_linkage as kernels
from mechproof.mechanisms import WedgeLinkage
from mechproof.plot import Figure
from mechproof.plot.canvas import LineStyle, label, write
from mechproof.tolerance import certified_range, corner_range

from . import boundaries
from .boundaries import BOUNDARY_II, BOUNDARY_III, BOUNDARY_IV
from .sizes import LEGIBLE, Signs

SETS = {number: WedgeLinkage.published_sizes(number) for number in (1, 2)}
START, CROSSING, PRINTED_DEVIATION = map(
    float, (boundaries.START, boundaries.CROSSING, boundaries.DEVIATION)
)
STROKE = np.linspace(START, 0.0, 401)
# Where the certified bound is drawn: alpha_KL turns within its tolerance at the upper boundary of
# the first set, nowhere at that of the second.
CERTIFIED = {1: np.linspace(-38.2, -36.2, 11), 2: np.linspace(-40.0, -5.0, 8)}
MICROMETRES = 1e3
WRONG = LineStyle.WRONG["color"]


def move(number: int, x1: Any, signs: Signs | None = None) -> Any:
    """Return y9 at the nominal sizes, or at the limits that the signs name."""
    values: Any = {name: size.nominal for name, size in SETS[number].items()}
    for symbol, sign in (signs or {}).items():
        values[str(symbol)] = SETS[number][str(symbol)].limits[sign > 0]
    return kernels.position(x1, **values)


def find_lower(number: int) -> Any:
    """Return the lower boundary: IV to the left of where it crosses III, III to the right."""
    three, four = (move(number, STROKE, signs) for signs in (BOUNDARY_III, BOUNDARY_IV))
    return np.where(crossing(number) > STROKE, four, three)


@cache
def crossing(number: int) -> float:
    """Return the displacement at which III and IV cross."""
    from scipy.optimize import brentq

    def apart(x1: float) -> float:
        return float(move(number, x1, BOUNDARY_III) - move(number, x1, BOUNDARY_IV))

    return float(brentq(apart, START, -20.0))


def legible_sizes() -> Any:
    """Return the digits as they are legible, of what has none the nominal size."""
    legible = {str(symbol): float(digits) for symbol, _, digits, *_ in LEGIBLE}
    return {name: legible.get(name, size.nominal) for name, size in SETS[1].items()}


@cache
def legible_end() -> float:
    """Return the displacement at which the guide of the legible digits follows no longer."""
    from scipy.optimize import brentq

    sizes: Any = {name: legible_sizes()[name] for name in ("l_AB", "l_BC", "l_CD")}
    return float(brentq(lambda x1: float(kernels.guide_radicand(x1, **sizes)), -10.0, 0.0))


def draw_boundaries(canvas: Any, number: int) -> None:
    """Draw the boundaries of a set, what they differ by, and the certified bound."""
    ratios = {"height_ratios": (1.5, 0.9, 1.0, 0.8, 1.0)}
    position, order, deviation, spread, turn = canvas.subplots(5, 1, gridspec_kw=ratios)
    _draw_positions(position, number)
    _draw_order(order, number)
    _draw_deviation(deviation, number)
    _draw_spread(spread, number)
    _draw_turn(turn, number)
    for panel in (position, order, deviation, spread):
        panel.set_xlim(START - 3, 1)
    for panel in (position, order, deviation):
        panel.axvline(CROSSING, **LineStyle.GUIDE)
    turn.set_xlabel("pusher x₁, mm")


def _draw_positions(panel: Any, number: int) -> None:
    curves: Mapping[str, tuple[Any, Any]] = {
        "I": (move(number, STROKE), LineStyle.FIRST),
        "II": (move(number, STROKE, BOUNDARY_II), LineStyle.THIRD),
        "IV": (find_lower(number), LineStyle.SECOND),
    }
    for name, (values, look) in curves.items():
        panel.plot(STROKE, values, **look)
        label(panel, name, (START, values[0]), (-3, 0))
    middle = STROKE.size // 2
    label(panel, "III", (STROKE[middle], find_lower(number)[middle]), (3, -5))
    end = legible_end()
    short = np.linspace(np.nextafter(end, 0.0), 0.0, 101)
    moved = kernels.position(short, **legible_sizes())
    panel.plot(short, moved, **{**LineStyle.WRONG, "lw": 1.3})
    text = f"legible digits\nend at {write(end, 3)} mm"
    label(panel, text, (0.0, moved[0]), (-0.1, -3), color=WRONG)
    panel.set_ylabel("wedge y₉, mm")
    panel.set_title(f"Reconstructed set {number} of sizes")


def _draw_order(panel: Any, number: int) -> None:
    three, four = (move(number, STROKE, signs) for signs in (BOUNDARY_III, BOUNDARY_IV))
    panel.axhline(0.0, **LineStyle.AXIS)
    panel.plot(STROKE, MICROMETRES * (three - four), **LineStyle.FIRST)
    place = crossing(number)
    panel.plot([place], [0.0], **LineStyle.MARK)
    label(panel, f"cross at {write(place)}", (place, 0.0), (5, 3))
    panel.set_ylabel("III \N{MINUS SIGN} IV, µm")


def _draw_deviation(panel: Any, number: int) -> None:
    nominal = move(number, STROKE)
    moved = nominal < 0
    boundaries = (
        (move(number, STROKE, BOUNDARY_II), LineStyle.THIRD, -1),
        (find_lower(number), LineStyle.SECOND, 1),
    )
    for values, look, upward in boundaries:
        share = 100 * (values[moved] / nominal[moved] - 1)
        panel.plot(STROKE[moved], share, **look)
        panel.plot([START], [share[0]], **LineStyle.MARK)
        text = f"{share[0]:+.1f} %".replace("-", "\N{MINUS SIGN}")
        label(panel, text, (START, share[0]), (3, 6 * upward))
    for limit in (PRINTED_DEVIATION, -PRINTED_DEVIATION):
        panel.axhline(limit, **LineStyle.GUIDE)
    panel.axhline(0.0, **LineStyle.AXIS)
    panel.set_ylim(-26, 26)
    panel.set_yticks([-20, -10, 0, 10, 20])
    panel.set_ylabel("from I, %")


def _draw_spread(panel: Any, number: int) -> None:
    spread = move(number, STROKE, BOUNDARY_II) - find_lower(number)
    panel.plot(STROKE, spread, **LineStyle.FIRST)
    widest = int(np.argmax(spread))
    place = (float(STROKE[widest]), float(spread[widest]))
    panel.plot(*place, **LineStyle.MARK)
    text = f"{write(place[1], 3)} mm at {write(place[0], 3)} mm"
    label(panel, text, place, (4, 3))
    panel.set_ylim(0, 32)
    panel.set_ylabel("II \N{MINUS SIGN} lower, mm")


def _draw_turn(panel: Any, number: int) -> None:
    """Draw what lies above II: another corner, and the bound certified for the whole box."""
    from . import PAPER

    sizes, places = SETS[number], CERTIFIED[number]
    near = np.linspace(places[0], places[-1], 201)
    above = corner_range(kernels.position, near, sizes).upper - move(number, near, BOUNDARY_II)
    bound = certified_range(PAPER, "position", places, sizes).upper
    beyond = bound - move(number, places, BOUNDARY_II)
    panel.plot(near, MICROMETRES * above, **LineStyle.FIRST, label="largest of all corners")
    look = {"color": WRONG, "marker": "o", "ms": 3, "ls": "", "mfc": "#ffffff"}
    panel.plot(places, MICROMETRES * beyond, **look, label="certified bound")
    panel.set_ylim(-1.5, 14)
    panel.set_xticks(np.linspace(places[0], places[-1], 3))
    panel.legend(loc="upper right", frameon=False)
    panel.set_ylabel("above II, µm")


def write_caption(number: int) -> str:
    """Write what the figure of a set shows."""
    chosen = ", ".join(f"{name} = {SETS[number][name].nominal:g}" for name in ("l_BC", "l_CD"))
    return (
        f"Transfer function I and its boundaries II to IV with the reconstructed set {number} of "
        f"sizes ({chosen}, l_DE = {SETS[number]['l_DE'].nominal:g} mm), a calibration: the printed "
        f"crossing of III and IV at {write(CROSSING)} mm (dotted) was used to choose it and "
        "confirms nothing. "
        "From the top: positions, with the curve that the legible digits give, which ends; by how "
        "much III lies above IV; deviation from the nominal position, with the printed "
        f"±{PRINTED_DEVIATION:g} %; the "
        "spread and its largest value; and, near the place where the influence of alpha_KL turns "
        "within its tolerance, what lies above II: other corners, and the bound certified for all "
        "sizes between the limits."
    )


FIGURES = (
    Figure(
        "fig-4",
        "Fig. 4",
        "The range of the wedge is widest at the end of the stroke, and II is not quite its top.",
        write_caption(1),
        "deviation nearer the start",
        partial(draw_boundaries, number=1),
        height=200.0,
    ),
    Figure(
        "fig-4-set-2",
        "Fig. 4",
        "With the other reconstruction the range is widest before the end of the stroke.",
        write_caption(2),
        "deviation nearer the start",
        partial(draw_boundaries, number=2),
        height=200.0,
    ),
)
