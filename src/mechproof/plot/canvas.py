"""Shared by all pictures: matplotlib if it is installed, a temporary style, canvases and axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from threading import RLock
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from mechproof.arguments.scalars import require
from mechproof.tools.extras import require_modules

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

# A millimetre in inches, and the width of one column of a page in mm.
MILLIMETRE = 1 / 25.4
COLUMN = 85.0
# Size of letters in points: smaller ones are illegible at the width of a column.
SMALL = 7.0
# Tick distances of an axis in degrees, and the most steps that it may have.
DEGREES = (*(1e-6, 1e-5, 1e-4, 1e-3), 0.01, 0.1, 1, 2, 5, 10, 15, 30, 60, 90, 180, 360, 720, 3600)
MOST_TICKS = 12
STYLE: Mapping[str, Any] = {
    "axes.labelsize": SMALL,
    "axes.linewidth": 0.6,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 7.5,
    "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans",
    "font.size": SMALL,
    "legend.fontsize": SMALL,
    "svg.fonttype": "none",
    "xtick.labelsize": SMALL,
    "xtick.major.size": 2.5,
    "xtick.major.width": 0.6,
    "ytick.labelsize": SMALL,
    "ytick.major.size": 2.5,
    "ytick.major.width": 0.6,
}
_TURNS = RLock()


class LineStyle:
    """Lines that differ in grey as well as in colour; keyword arguments of `Axes.plot`."""

    FIRST: Mapping[str, Any] = {"color": "#000000", "lw": 1.3, "ls": "-"}
    SECOND: Mapping[str, Any] = {"color": "#1f5fa8", "lw": 1.3, "ls": (0, (6, 1.5))}
    THIRD: Mapping[str, Any] = {"color": "#1f5fa8", "lw": 1.3, "ls": "-"}
    FOURTH: Mapping[str, Any] = {"color": "#000000", "lw": 1.3, "ls": (0, (6, 1.5))}
    WRONG: Mapping[str, Any] = {"color": "#c2301c", "lw": 0.8, "ls": (0, (2, 1))}
    GUIDE: Mapping[str, Any] = {"color": "#777777", "lw": 0.6, "ls": (0, (1, 2))}
    AXIS: Mapping[str, Any] = {"color": "#999999", "lw": 0.5, "ls": "-"}
    MARK: Mapping[str, Any] = {"color": "#000000", "marker": "o", "ms": 3.2, "ls": ""}


def import_matplotlib() -> ModuleType:
    """Return matplotlib; ImportError, naming the extra, if it is missing."""
    require_modules("a picture", "plot", ("matplotlib",))
    import matplotlib

    return matplotlib


@contextmanager
def use_style(more: Mapping[str, Any] | None = None) -> Iterator[None]:
    """Set matplotlib's defaults and the style of the pictures inside the context only.

    Threads take turns, as the settings that matplotlib's context restores are global.
    """
    import_matplotlib()
    from matplotlib import style

    with _TURNS, style.context({**STYLE, **(more or {})}, after_reset=True):
        yield


def make_canvas(width: float = COLUMN, height: float = 60.0) -> Figure:
    """Return an empty figure of a size in mm, without pyplot; within `use_style`, in its style."""
    import_matplotlib()
    from matplotlib.figure import Figure

    return Figure((width * MILLIMETRE, height * MILLIMETRE))


def check_drawn(name: str, given: Any, kind: type, field: str, shape: tuple[int, ...]) -> None:
    """Raise TypeError for an object of another kind, ValueError for a `field` of another shape."""
    require(isinstance(given, kind), name, given, f"must be a {kind.__name__}", TypeError)
    found = np.shape(getattr(given, field))
    require(found == shape, name, found, f"must have the inputs' shape, {shape}")


def check_axes(name: str, given: Any, count: int, height: float) -> Sequence[Axes]:
    """Return the `count` given axes, or new ones below each other on a canvas if None is given.

    Raises TypeError unless exactly `count` axes are given.
    """
    import_matplotlib()
    from matplotlib.axes import Axes

    if given is None:
        with use_style():
            return list(make_canvas(height=height).subplots(count, sharex=True, squeeze=False).flat)
    axes = [given] if isinstance(given, Axes) else list(given) if hasattr(given, "__iter__") else []
    needed = "must be matplotlib Axes" if count == 1 else f"must be {count} matplotlib Axes"
    fits = len(axes) == count and all(isinstance(one, Axes) for one in axes)
    require(fits, name, given, needed, TypeError)
    return axes


def tick_degrees(axis: Axis, span: float) -> None:
    """Tick an axis of `span` degrees every 30 or, if that is not legible, at another round step."""
    from matplotlib.ticker import MultipleLocator

    # The last digits of a computed angle are rounding errors.
    span = float(f"{span:.9g}")
    fitting = (step for step in DEGREES if step <= span / 2 and span <= MOST_TICKS * step)
    step = 30.0 if 60 <= span <= MOST_TICKS * 30 else next(fitting, span / 2)
    axis.set_major_locator(MultipleLocator(step))


def write(value: float, digits: int = 4) -> str:
    """Return a number's text with some significant digits, and with the minus sign of axes."""
    return f"{value:.{digits}g}".replace("-", "\N{MINUS SIGN}")


def label(
    panel: Axes,
    text: str,
    place: tuple[float, float],
    aside: tuple[float, float] = (4, 3),
    **kept: Any,
) -> None:
    """Write a text at a place in the data, offset by `aside` points to the right and upwards.

    The text extends away from the place; for an offset of zero it is centred.
    """
    right, up = aside
    panel.annotate(
        text,
        place,
        aside,
        textcoords="offset points",
        ha="left" if right > 0 else "right" if right < 0 else "center",
        va="bottom" if up > 0 else "top" if up < 0 else "center",
        fontsize=SMALL,
        **kept,
    )
