"""The range of a quantity within the tolerances of its sizes, beside its nominal value."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_items, check_text, require
from mechproof.plot.canvas import SMALL, LineStyle, check_axes, check_drawn, write
from mechproof.tolerance import CertifiedRange, CornerRange, MonteCarloRange

if TYPE_CHECKING:
    from matplotlib.axes import Axes

HEIGHT = 65.0


def tolerance(
    inputs: ArrayLike,
    corners: CornerRange,
    ax: Any = None,
    *,
    certified: CertifiedRange | None = None,
    scatter: MonteCarloRange | None = None,
    labels: tuple[str, str] = ("input", "deviation from nominal"),
) -> Axes:
    """Draw by how much a quantity deviates from nominal within the tolerances of its sizes.

    The range over all combinations of limits is shaded, its widest place marked; the certified
    bounds and a Monte Carlo range are lines. Where they are not known (NaN, infinite) is a gap.

    Parameters
    ----------
    inputs : array_like, shape (n,)
        Where the ranges were computed.
    corners : CornerRange
        Of `corner_range`, at `inputs`.
    ax : matplotlib Axes, optional
        To draw on; without, on a new figure of a column's width.
    certified : CertifiedRange, optional
        Of `certified_range`, at `inputs`.
    scatter : MonteCarloRange, optional
        Of `monte_carlo_range`, at `inputs`.
    labels : two strings
        What the axes show, with units.

    Returns
    -------
    Axes
        On which it was drawn.

    Raises
    ------
    TypeError, ValueError
        Names the parameter that is of another kind, or of another shape than `inputs`.
    ImportError
        Without matplotlib: the extra `plot`.

    """
    points = check_array("inputs", inputs)
    require(points.ndim == 1 and points.size > 1, "inputs", inputs, "must be two points or more")
    kinds = {"corners": CornerRange, "certified": CertifiedRange, "scatter": MonteCarloRange}
    ranges = {"corners": corners, "certified": certified, "scatter": scatter}
    for name, given in ranges.items():
        if given is not None or name == "corners":
            check_drawn(name, given, kinds[name], "lower", points.shape)
    across, upward = check_items("labels", labels, 2, "must be two texts")
    check_text("labels[0]", across), check_text("labels[1]", upward)
    (panel,) = check_axes("ax", ax, 1, HEIGHT)
    nominal = np.asarray(corners.nominal)
    lower, upper = np.asarray(corners.lower) - nominal, np.asarray(corners.upper) - nominal
    panel.axhline(0.0, **LineStyle.AXIS)
    panel.fill_between(points, lower, upper, color="#d5dfec", lw=0)
    panel.plot(points, upper, **LineStyle.FIRST, label="all combinations of limits")
    panel.plot(points, lower, **LineStyle.FIRST)
    for given, look, label in (
        (certified, LineStyle.WRONG, "certified bounds"),
        (scatter, LineStyle.SECOND, "range of given probability"),
    ):
        if given is not None:
            _draw_ends(panel, points, given.lower - nominal, given.upper - nominal, look, label)
    _mark_widest(panel, points, lower, upper)
    panel.set_xlabel(across, fontsize=SMALL)
    panel.set_ylabel(upward, fontsize=SMALL)
    panel.legend(frameon=False, fontsize=SMALL, loc="upper left", bbox_to_anchor=(0, -0.2))
    return panel


def _draw_ends(
    panel: Axes, points: NDArray[np.float64], lower: Any, upper: Any, look: Any, label: str
) -> None:
    for values, name in ((upper, label), (lower, None)):
        panel.plot(points, np.where(np.isfinite(values), values, np.nan), **look, label=name)


def _mark_widest(panel: Axes, points: NDArray[np.float64], lower: Any, upper: Any) -> None:
    """Mark the widest place of the range, if it is known anywhere."""
    spread = upper - lower
    if np.isnan(spread).all():
        return
    widest = int(np.nanargmax(spread))
    place = points[widest]
    panel.plot([place, place], [lower[widest], upper[widest]], color="#000000", lw=0.8, marker="_")
    panel.set_title(f"widest {write(spread[widest])} at {write(place)}", loc="left", fontsize=SMALL)
