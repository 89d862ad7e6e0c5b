"""Shares of parts that an inspection accepts and rejects, against what it depends on."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from mechproof.arguments.array_checks import check_array
from mechproof.arguments.scalars import check_items, check_text, require
from mechproof.conformity import Shares, SimulatedShares
from mechproof.plot.canvas import SMALL, LineStyle, check_axes, check_drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes

HEIGHT = 65.0
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
        Of `conformity.shares` or an inspection, at `inputs`.
    ax : matplotlib Axes, optional
        To draw on; without, on a new figure of a column's width.
    which : strings
        Names of the shares to draw.
    simulated : pair, optional
        Inputs of their own, and the `SimulatedShares` there; bars are a standard error each way,
        up to the one-sided bound where no part or every part was counted.
    label : str
        What the inputs are, with the unit.
    look : mapping, optional
        Keyword arguments of `Axes.plot` for all lines, instead of one look for each share;
        also the label of a legend.

    Returns
    -------
    Axes
        On which it was drawn.

    Raises
    ------
    TypeError, ValueError
        Names the parameter that is of another kind or shape, or a share that is none.
    ImportError
        Without matplotlib: the extra `plot`.

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
