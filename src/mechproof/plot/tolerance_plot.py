"""The range of a quantity within the tolerances of its sizes, relative to its nominal value.

And the shares of parts that an inspection accepts and rejects, against their inputs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_items, check_text, require
from mechproof.conformity import Shares, SimulatedShares
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
    """Draw how far a quantity deviates from nominal within the tolerances of its sizes.

    The range over all combinations of limits is shaded, its widest place marked; certified bounds
    and a Monte Carlo range are lines, with gaps where they are not known (NaN, infinite).

    Parameters
    ----------
    inputs : array_like, shape (n,)
        Where the ranges were computed.
    corners : CornerRange
        Result of `corner_range` at `inputs`.
    ax : matplotlib Axes, optional
        Axes to draw on; by default, those of a new figure of a column's width.
    certified : CertifiedRange, optional
        Result of `certified_range` at `inputs`.
    scatter : MonteCarloRange, optional
        Result of `monte_carlo_range` at `inputs`.
    labels : two strings
        Labels of the axes, with units.

    Returns
    -------
    Axes
        The axes drawn on.

    Raises
    ------
    TypeError, ValueError
        If a parameter is of the wrong kind or does not have the shape of `inputs`; the message
        names it.
    ImportError
        If matplotlib, the extra `plot`, is not installed.

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


# How each share is drawn.
LOOKS = {
    "rightly_accepted": LineStyle.FIRST,
    "wrongly_accepted": LineStyle.SECOND,
    "rightly_rejected": LineStyle.FOURTH,
    "wrongly_rejected": LineStyle.THIRD,
}


def shares(
    inputs: ArrayLike,
    exact: Shares,
    ax: Any = None,
    *,
    which: Sequence[str] = ("wrongly_rejected", "wrongly_accepted"),
    simulated: tuple[ArrayLike, SimulatedShares] | None = None,
    label: str = "input",
    look: Any = None,
) -> Axes:
    """Draw shares of parts in per cent, exact as lines and simulated as points with their errors.

    Parameters
    ----------
    inputs : array_like, shape (n,)
        What the shares depend on, such as the limit error of a gauge.
    exact : Shares
        Result of `conformity.shares` or an inspection at `inputs`.
    ax : matplotlib Axes, optional
        Axes to draw on; by default, those of a new figure of a column's width.
    which : strings
        Names of the shares to draw.
    simulated : pair, optional
        Separate inputs, and the `SimulatedShares` there; bars are a standard error each way, or up
        to the one-sided bound where no part or every part was counted.
    label : str
        Label of the inputs, with the unit.
    look : mapping, optional
        Keyword arguments of `Axes.plot` for all lines, instead of one look for each share;
        also the label of a legend.

    Returns
    -------
    Axes
        The axes drawn on.

    Raises
    ------
    TypeError, ValueError
        If a parameter is of the wrong kind or shape, or a name is not that of a share; the message
        names it.
    ImportError
        If matplotlib, the extra `plot`, is not installed.

    """
    points = check_array("inputs", inputs)
    require(points.ndim == 1, "inputs", inputs, "must have one axis")
    names = _check_names(which)
    check_text("label", label)
    check_drawn("exact", exact, Shares, "rightly_accepted", points.shape)
    (panel,) = check_axes("ax", ax, 1, HEIGHT)
    for name in names:
        drawn = {"label": name.replace("_", " "), **(LOOKS[name] if look is None else look)}
        panel.plot(points, 100 * getattr(exact, name), **drawn)
    if simulated is not None:
        places, counted = check_items("simulated", simulated, 2, "must be a pair: inputs, shares")
        colour = "#000000" if look is None else look.get("color", "#000000")
        _draw_simulated(panel, check_array("simulated[0]", places), counted, names, colour)
    panel.set_xlabel(label, fontsize=SMALL)
    panel.set_ylabel("per cent of all parts", fontsize=SMALL)
    if ax is None:
        panel.legend(frameon=False, fontsize=SMALL)
    return panel


def _check_names(which: Sequence[str]) -> tuple[str, ...]:
    allowed = f"must be among {[*LOOKS]}"
    names = (which,) if isinstance(which, str) else check_items("which", which, None, allowed)
    for name in names:
        require(name in LOOKS, "which", name, allowed)
    return names


def _draw_simulated(
    panel: Axes, points: Any, counted: SimulatedShares, names: Sequence[str], colour: Any
) -> None:
    check_drawn("simulated[1]", counted, SimulatedShares, "rightly_accepted", points.shape)
    for number, name in enumerate(names):
        share, error, lower, upper = (
            np.asarray(getattr(one, name))
            for one in (counted, counted.standard_error, counted.lower, counted.upper)
        )
        known = np.isfinite(error)
        below = np.where(known, error, share - lower)
        above = np.where(known, error, upper - share)
        panel.errorbar(
            points,
            100 * share,
            100 * np.stack([below, above]),
            fmt="o",
            color=colour,
            ms=2.2,
            elinewidth=0.7,
            capsize=1.5,
            label=None if number else f"{counted.count:,} teeth simulated",
        )
