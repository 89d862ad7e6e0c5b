"""Export: in, a mechanism and the name of a file; out, the file, of the kind that its name says."""

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

# Pictures of a turn of the carrier, so many in a second, so wide and high (mm), dots per inch.
FRAMES, PER_SECOND, SIZE, DOTS = 60, 20, 85.0, 100


def animate(mechanism: Planetary, file: Path, phi1: float) -> None:
    """Write a turn of the carrier from an angle on. Raises ImportError without matplotlib."""
    with use_style({"figure.dpi": DOTS}):
        canvas = make_canvas(SIZE, SIZE)
        from matplotlib.animation import FuncAnimation, PillowWriter

        # What moves with the labels would shake.
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
    """Return limits that hold all wheels at every angle."""
    sun, satellite, driver, output = place_wheels(mechanism, 0.0)
    centre = float(np.hypot(*satellite.axis))
    farthest = [sun.a * (1 + sun.e), output.a * (1 + output.e)]
    farthest += [centre + w.a * (1 + w.e) for w in (satellite, driver)]
    edge = 1.05 * max(farthest)
    return -edge, edge


# What writes the pitch curves, by the end of the file's name.
CURVES: dict[str, Callable[[tuple[Wheel, ...], float], str]] = {
    ".dxf": write_dxf,
    ".svg": write_svg,
    ".csv": write_outlines,
}
FILMS = (".gif", ".html")
# How far a chord of a polyline may be off its curve (mm).
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
        What is written is told by its end: .dxf (needs ezdxf: the extra `cad`), .svg and .csv are
        the curves in mesh, in mm; .gif and .html an animation of one turn of the carrier (needs
        matplotlib: the extra `plot`), lengths of an `OvalPair` in units of a; the page takes the
        signs on its buttons from the internet. A file that is there is replaced.
    phi1 : float
        Angle of the carrier at which the wheels are drawn, or an animation begins (rad).
    degrees : bool
        Whether angles are in degrees, those of a table, too.
    a : float, optional
        Major semi-axis of the wheels (mm) for a mechanism with an `OvalPair`, which has no size.
    tolerance : float
        How far a chord may be off its curve (mm). Circles and ellipses have no chords in DXF and
        SVG; ovals are closed polylines there. In CSV all are, and the last point is the first.
    what : "curves" or "motion"
        "motion" is a table of one turn of the carrier, a line for each degree: position, ratio and
        acceleration; .csv only.

    Returns
    -------
    Path
        Of the file.

    Raises
    ------
    TypeError, ValueError
        For what is not allowed; the message names it.
    ImportError
        Without the library that a kind of file needs.

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
        require(kind == ".csv", "path", path, "a table of the motion must end in .csv")
        write_whole(file, write_motion(mechanism, in_degrees))
    elif what != "curves":
        refuse("what", what, "must be 'curves' or 'motion'")
    elif kind in FILMS:
        require(a is None, "a", a, "is of no use to an animation; leave it out")
        animate(mechanism, file, angle)
    elif kind in CURVES:
        write_whole(file, CURVES[kind](place_in_mm(mechanism, angle, a), error))
    else:
        refuse("path", path, f"must end in {', '.join((*CURVES, *FILMS))}")
    return file
