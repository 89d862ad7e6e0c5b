"""The figures of paper 4, redrawn from the kernels for both reconstructed sets of sizes."""

from collections.abc import Mapping
from functools import cache, partial
from typing import Any

import numpy as np

from mechproof.kernels import wedge_linkage as kernels
from mechproof.mechanisms import WedgeLinkage
from mechproof.plot import Figure
from mechproof.plot.canvas import LineStyle, label, write
from mechproof.tolerance import certified_range, corner_range

from .rows import boundaries
from .rows.boundaries import BOUNDARY_II, BOUNDARY_III, BOUNDARY_IV
from .rows.sizes import ANGLES, LEGIBLE, Signs

SETS = {number: WedgeLinkage.published_sizes(number) for number in (1, 2)}
START, CROSSING, PRINTED_DEVIATION = map(
    float, (boundaries.START, boundaries.CROSSING, boundaries.DEVIATION)
)
STROKE = np.linspace(START, 0.0, 401)
# Where the certified bound is drawn: alpha_KL passes an extremum within its tolerance at the upper
# boundary of the first set, nowhere at that of the second.
CERTIFIED = {1: np.linspace(-38.2, -36.2, 11), 2: np.linspace(-40.0, -5.0, 8)}
MICROMETRES = 1e3
# The sides of the polygons, and the places of their letters. Lengths that are lost, or that have no
# influence, are chosen (mm).
POLYGONS = ("ABCD", "DEFG", "HIKL", "LMNP")
CHOSEN = {"EF": 14.0, "FG": 14.0, "HI": 14.0, "IK": 60.0, "MN": 20.0, "NP": 10.0}
ASIDE_OF = {
    "A": (4, 3), "B": (-4, 4), "C": (4, -4), "D": (-4, 3), "E": (-4, -4), "F": (4, -6),
    "G": (-4, 4), "H": (4, -4), "I": (-3, 4), "K": (4, -4), "L": (5, 0), "M": (3, 5),
    "N": (-4, -5), "P": (0, -5),
}  # fmt: skip
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
    """Return the sizes by their legible digits, and the nominal size where there are none."""
    legible = {str(size): float(digits) for size, digits in LEGIBLE.items() if size not in ANGLES}
    return {name: legible.get(name, size.nominal) for name, size in SETS[1].items()}


@cache
def legible_end() -> float:
    """Return the displacement up to which the guide can follow with the legible digits."""
    from scipy.optimize import brentq

    sizes: Any = {name: legible_sizes()[name] for name in ("l_AB", "l_BC", "l_CD")}
    return float(brentq(lambda x1: float(kernels.guide_radicand(x1, **sizes)), -10.0, 0.0))


def towards(length: float, angle: float) -> Any:
    """Return a vector of the plane by its length and its direction."""
    return length * np.array([np.cos(angle), np.sin(angle)])


def place_pairs(x1: float) -> dict[str, Any]:
    """Return the places of the pairs of Fig. 2, D at (0, 0), by the kernels and the first set."""
    size = {name: value.nominal for name, value in SETS[1].items()}
    lever = float(kernels.lever_angle(x1, size["l_AB"], size["l_BC"], size["l_CD"]))
    run = float(kernels.rod_displacement(lever, size["l_DE"], size["alpha_DE"]))
    push = float(kernels.clearance(run, size["l_GH"]))
    turn = float(kernels.roller_lever_angle(push, size["l_KL"], size["alpha_KL"]))
    at = {"D": np.zeros(2), "A": np.array([size["l_AB"] + size["l_CD"] + x1, size["l_BC"]])}
    at["C"] = -towards(size["l_CD"], np.pi + lever)
    at["B"] = at["A"] + towards(size["l_AB"], np.pi + lever)
    at["E"] = towards(size["l_DE"], size["alpha_DE"] + lever)
    at["F"] = at["E"] + towards(CHOSEN["EF"], 0.0)
    rod = towards(size["l_DE"], size["alpha_DE"]) + np.array([CHOSEN["EF"], CHOSEN["FG"]])
    at["G"] = rod + towards(run, 0.0)
    at["H"] = rod + towards(size["l_GH"] + push, 0.0)
    still = rod + np.array([size["l_GH"], CHOSEN["HI"]])
    at["L"] = still + towards(CHOSEN["IK"], 0.0) + towards(size["l_KL"], size["alpha_KL"])
    at["K"] = at["L"] - towards(size["l_KL"], size["alpha_KL"] + turn)
    at["I"] = at["K"] - towards(CHOSEN["IK"], 0.0)
    at["M"] = at["L"] + towards(size["l_LM"], size["alpha_LM"] + turn)
    guide = at["L"][0] + size["l_LM"] * np.cos(size["alpha_LM"]) + CHOSEN["NP"]
    at["P"] = np.array([guide, at["M"][1] - CHOSEN["MN"]])
    at["N"] = np.array([at["M"][0], at["P"][1]])
    return at


def draw_scheme(canvas: Any) -> None:
    """Draw the sides of the four polygons at the start and at the end of the stroke."""
    panel = canvas.subplots()
    for x1, look in ((START, LineStyle.SECOND), (0.0, LineStyle.FIRST)):
        at = place_pairs(x1)
        says = f"x₁ = {write(x1)} mm" if x1 else "x₁ = 0"
        for place, chain in enumerate(POLYGONS):
            points = np.array([at[name] for name in chain])
            panel.plot(*points.T, **look, label="" if place else says)
            panel.plot(*points.T, **{**LineStyle.MARK, "color": look["color"], "ms": 2.2})
    for name, aside in ASIDE_OF.items():
        label(panel, name, tuple(at[name]), aside)
    panel.set_aspect("equal")
    panel.set_axis_off()
    panel.legend(loc="lower right", frameon=False)


def draw_boundaries(canvas: Any, number: int) -> None:
    """Draw the boundaries of a set, their differences, and the certified bound."""
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
    for panel in (spread, turn):
        panel.set_xlabel("pusher x₁, mm")


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
    """Draw what exceeds II: another corner, and the bound certified for the whole box."""
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
        "From the top: positions, and the curve of the legible digits, which breaks off; by how "
        "much III lies above IV; deviation from the nominal position, with the printed "
        f"±{PRINTED_DEVIATION:g} %; the spread and its largest value; and, near the place where "
        "\N{GREEK SMALL LETTER ALPHA}_KL begins to act the other way, what lies above II: other "
        "combinations of limits, and the bound certified for all sizes between the limits."
    )


FIGURES = (
    Figure(
        "scheme",
        "Fig. 2",
        "The letters of the equations: four closed polygons, one for each Assur group.",
        "Sides of the polygons ABCD, DEFG, HIKL and LMNP with the first set of reconstructed "
        "sizes, at the start and at the end of the stroke; D and L are fixed, A moves with the "
        "pusher, G with the rod, H with the link 5' and P with the wedge. Lengths that are lost or "
        "have no influence, EF, FG, HI, IK, MN and NP, are chosen, and with them the place of L.",
        "links 1 to 9",
        draw_scheme,
        height=95.0,
    ),
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
        "With another reconstruction the range is widest before the end of the stroke.",
        write_caption(2),
        "deviation nearer the start",
        partial(draw_boundaries, number=2),
        height=200.0,
    ),
)
