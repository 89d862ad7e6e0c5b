"""Export: from a mechanism and a file name to the file, in the format given by its suffix."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

import numpy as np

from mechproof.arguments.array_checks import check_flag
from mechproof.arguments.scalars import check_real, refuse, require
from mechproof.exports.curves import place_in_mm, write_dxf, write_motion, write_outlines, write_svg
from mechproof.mechanisms.units import Units
from mechproof.plot.canvas import make_canvas, use_style
from mechproof.plot.motion_plot import Planetary, Wheel, check_planetary, pitch_curves, place_wheels
from mechproof.tools.files import write_whole

# Frames in a turn of the carrier and in a second, width and height (mm), dots per inch.
FRAMES, PER_SECOND, SIZE, DOTS = 60, 20, 85.0, 100


def animate(mechanism: Planetary, file: Path, phi1: float) -> None:
    """Animate one turn of the carrier from `phi1`. Raises ImportError without matplotlib."""
    with use_style({"figure.dpi": DOTS}):
        canvas = make_canvas(SIZE, SIZE)
        from matplotlib.animation import FuncAnimation, PillowWriter

        # A layout that follows the labels would shake.
        canvas.set_layout_engine("none")
        panel = canvas.subplots()
        limits = _find_limits(mechanism)

        def draw(angle: float) -> tuple[Any, ...]:
            panel.clear()
            pitch_curves(mechanism, angle, panel)
            panel.set(xlim=limits, ylim=limits)
            return ()

        angles = (phi1 + np.linspace(0.0, 2 * np.pi, FRAMES, endpoint=False)).tolist()
        film = FuncAnimation(canvas, draw, frames=angles, interval=1000 / PER_SECOND)
        if file.suffix.lower() == ".gif":
            film.save(str(file), writer=PillowWriter(fps=PER_SECOND))
        else:
            file.write_text(film.to_jshtml(fps=PER_SECOND), encoding="utf-8")


def _find_limits(mechanism: Planetary) -> tuple[float, float]:
    """Return axis limits that hold all wheels at every angle."""
    sun, satellite, driver, output = place_wheels(mechanism, 0.0)
    centre = float(np.hypot(*satellite.axis))
    farthest = [sun.a * (1 + sun.e), output.a * (1 + output.e)]
    farthest += [centre + w.a * (1 + w.e) for w in (satellite, driver)]
    edge = 1.05 * max(farthest)
    return -edge, edge


# Writers of the pitch curves, by the suffix of the file.
CURVES: dict[str, Callable[[tuple[Wheel, ...], float], str]] = {
    ".dxf": write_dxf,
    ".svg": write_svg,
    ".csv": write_outlines,
}
FILMS = (".gif", ".html")
# Largest deviation of a chord of a polyline from its curve (mm).
TOLERANCE = 1e-3


def export(
    mechanism: Planetary,
    path: str | os.PathLike[str],
    *,
    phi1: Any = 0.0,
    degrees: bool = False,
    a: float | None = None,
    tolerance: float = TOLERANCE,
    what: Literal["curves", "motion"] = "curves",
) -> Path:
    """Write the pitch curves of a planetary mechanism in mm, or its motion, for other programs.

    Parameters
    ----------
    mechanism : EllipticPlanetary or OvalPlanetary
        The wheels.
    path : path
        The output file; its suffix gives the format. .dxf (needs ezdxf: the extra `cad`), .svg and
        .csv hold the curves in mesh, in mm. .gif and .html hold an animation of one turn of the
        carrier (needs matplotlib: the extra `plot`), with lengths of an `OvalPair` in units of a;
        the page loads its button icons from the internet. An existing file is replaced.
    phi1 : float
        Carrier angle at which the wheels are drawn or an animation begins (rad).
    degrees : bool
        Whether angles are in degrees, including those of a table.
    a : float, optional
        Major semi-axis of the wheels (mm) for a mechanism with an `OvalPair`, which has no size.
    tolerance : float
        Largest deviation of a chord from its curve (mm). In DXF and SVG, circles and ellipses have
        no chords and ovals are closed polylines. In CSV, all curves are closed polylines, and the
        last point repeats the first.
    what : "curves" or "motion"
        "motion" is a table of one turn of the carrier, one line per degree, with position, ratio
        and acceleration; .csv only.

    Returns
    -------
    Path
        The path of the file.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names it.
    ImportError
        If the library for the format is missing.

    """
    check_planetary(mechanism)
    is_path = isinstance(path, str | os.PathLike)
    require(is_path, "path", path, "must be the path of a file", TypeError)
    file = Path(path)
    in_degrees = check_flag("degrees", degrees)
    angle = check_real("phi1", Units(in_degrees).take("phi1", phi1, "rad"))
    error = check_real("tolerance", tolerance)
    require(error > 0, "tolerance", tolerance, "must be positive")
    kind = file.suffix.lower()
    if what == "motion":
        require(kind == ".csv", "path", path, "must end in .csv for a table of the motion")
        write_whole(file, write_motion(mechanism, in_degrees))
    elif what != "curves":
        refuse("what", what, "must be 'curves' or 'motion'")
    elif kind in FILMS:
        require(a is None, "a", a, "leave it out; an animation does not use it")
        animate(mechanism, file, angle)
    elif kind in CURVES:
        write_whole(file, CURVES[kind](place_in_mm(mechanism, angle, a), error))
    else:
        refuse("path", path, f"must end in {', '.join((*CURVES, *FILMS))}")
    return file
