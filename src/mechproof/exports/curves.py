"""Pitch curves in mm: from a mechanism at an angle of its carrier to wheels in CAD formats.

DXF and SVG have true circles and ellipses, and ovals as closed lines. Numbers in CSV, including
those of the motion, read back exactly. Teeth are cut by ncgears, a separate young library (alpha):
it generates outlines, checks the pair for interference and for errors of the motion, and refuses
pairs it cannot cut. Its results are its own; nothing about them is proved here.
"""

from __future__ import annotations

import csv
import os
from collections.abc import Iterable, Sequence
from io import StringIO
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.etree.ElementTree import Element, SubElement, indent, tostring

import numpy as np
from numpy.typing import NDArray

from mechproof.arguments.scalars import check_count, check_real, refuse, require
from mechproof.mechanisms import OvalPair, OvalPlanetary
from mechproof.mechanisms.teeth import find_oval_teeth
from mechproof.plot.motion_plot import Planetary, Wheel, check_planetary, place_wheels
from mechproof.tools.extras import require_modules

Array = NDArray[np.float64]
# Points of an outline at first and at most; they are doubled until the chords are close enough.
FIRST, MOST = 64, 2**20


def place_in_mm(mechanism: Planetary, phi1: float, a: Any) -> tuple[Wheel, ...]:
    """Return the wheels 4, 5, 6, 3; `a` is the major semi-axis if the mechanism has no size.

    Raises ValueError if `a` is not needed, or is needed but missing or invalid.
    """
    wheels = place_wheels(mechanism, phi1)
    if not (isinstance(mechanism, OvalPlanetary) and isinstance(mechanism.pair, OvalPair)):
        require(a is None, "a", a, "leave it out; the mechanism has sizes")
        return wheels
    if a is None:
        refuse("a", a, "must be the major semi-axis (mm), since an OvalPair has no size")
    size = check_real("a", a)
    require(size > 0, "a", a, "must be positive")
    return tuple(w._replace(axis=w.axis * size, a=w.a * size) for w in wheels)


def measure_centres(wheels: tuple[Wheel, ...]) -> float:
    """Return the distance of the centres A and C (mm)."""
    return float(np.hypot(*(wheels[1].axis - wheels[0].axis)))


def find_ellipse(wheel: Wheel) -> tuple[Array, Array, float]:
    """Return the centre, the major semi-axis as a vector and the ratio minor/major of an ellipse.

    A wheel with one lobe is an ellipse that turns about the focus opposite the longest radius.
    """
    along = np.array([np.cos(wheel.turned), np.sin(wheel.turned)])
    return wheel.axis + wheel.a * wheel.e * along, wheel.a * along, float(np.sqrt(1 - wheel.e**2))


def trace_outline(wheel: Wheel, tolerance: float) -> Array:
    """Return points of a closed curve, shape (n, 2), without repeating the first.

    The curve deviates from the chords by at most the tolerance (mm), judged at their middle angles.
    Raises ValueError if that takes too many points.
    """
    count = FIRST
    while count <= MOST:
        angles = wheel.turned + np.linspace(0.0, 2 * np.pi, 2 * count, endpoint=False)
        points = wheel.point(angles)
        ends, between = points[::2], points[1::2]
        chords = np.roll(ends, -1, axis=0) - ends
        gaps = between - ends
        away = np.abs(chords[:, 0] * gaps[:, 1] - chords[:, 1] * gaps[:, 0])
        if np.max(away / np.hypot(*chords.T)) <= tolerance / 2:
            return ends
        count *= 2
    raise ValueError(f"tolerance = {tolerance!r}: needs more than {MOST} points")


# Step of the carrier angle in a table of the motion (degrees).
STEP = 1.0


def write_outlines(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return a line for each point of the closed outlines; the last point repeats the first."""
    rows = []
    for wheel in wheels:
        points = trace_outline(wheel, tolerance).tolist()
        rows += [(wheel.number, *point) for point in (*points, points[0])]
    return _write(("wheel", "x_mm", "y_mm"), rows)


def write_motion(mechanism: Planetary, degrees: bool) -> str:
    """Return a line for each degree of a turn of the carrier: position, ratio, acceleration."""
    whole = np.arange(0.0, 360.0 + STEP / 2, STEP)
    angles = whole if degrees else np.radians(whole)
    columns = (
        angles,
        mechanism.position(angles, degrees=degrees),
        mechanism.ratio(angles, degrees=degrees),
        mechanism.acceleration(angles, degrees=degrees),
    )
    unit = "deg" if degrees else "rad"
    names = f"phi1_{unit}", f"phi3_{unit}", "ratio", f"acceleration_per_{unit}"
    return _write(names, zip(*(c.tolist() for c in columns), strict=True))


def _write(names: Sequence[str], rows: Iterable[Sequence[float]]) -> str:
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    writer.writerows(rows)
    return text.getvalue()


# Millimetres around the wheels.
MARGIN = 5.0


def write_svg(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return the text of an SVG picture to scale in mm; y points up inside its group."""
    outlines = np.concatenate([wheel.outline() for wheel in wheels])
    low, high = outlines.min(axis=0) - MARGIN, outlines.max(axis=0) + MARGIN
    width, height = (high - low).tolist()
    picture = Element(
        "svg",
        xmlns="http://www.w3.org/2000/svg",
        width=f"{width!r}mm",
        height=f"{height!r}mm",
        viewBox=f"{float(low[0])!r} {float(-high[1])!r} {width!r} {height!r}",
    )
    distance = measure_centres(wheels)
    SubElement(picture, "title").text = f"Pitch curves, centre distance {distance!r} mm"
    style = {"fill": "none", "stroke": "black", "stroke-width": "0.2"}
    group = SubElement(picture, "g", {"transform": "scale(1 -1)", **style})
    for wheel in wheels:
        _add_svg_curve(group, wheel, tolerance).set("id", f"wheel_{wheel.number}")
    (x1, y1), (x2, y2) = (w.axis.tolist() for w in wheels[:2])
    ends = {"x1": repr(x1), "y1": repr(y1), "x2": repr(x2), "y2": repr(y2)}
    SubElement(group, "line", {"id": "centres", **ends})
    indent(picture)
    return tostring(picture, encoding="unicode") + "\n"


def _add_svg_curve(group: Element, wheel: Wheel, tolerance: float) -> Element:
    if wheel.e == 0:
        x, y = wheel.axis.tolist()
        return SubElement(group, "circle", cx=repr(x), cy=repr(y), r=repr(float(wheel.a)))
    if wheel.lobes == 1:
        (x, y), _, ratio = find_ellipse(wheel)
        x, y, turned = float(x), float(y), float(np.degrees(wheel.turned))
        return SubElement(
            group,
            "ellipse",
            cx=repr(x),
            cy=repr(y),
            rx=repr(float(wheel.a)),
            ry=repr(float(wheel.a) * ratio),
            transform=f"rotate({turned!r} {x!r} {y!r})",
        )
    points = " L ".join(f"{x!r} {y!r}" for x, y in trace_outline(wheel, tolerance).tolist())
    return SubElement(group, "path", d=f"M {points} Z")


# The colour of each wheel's layer.
COLOURS = {4: 1, 5: 5, 6: 3, 3: 6}


def write_dxf(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return the text of a DXF drawing: one layer for each wheel, one for the centre distance.

    Raises ImportError without ezdxf: the extra `cad`.
    """
    ezdxf = import_ezdxf()
    drawing = ezdxf.new("R2010", setup=["linetypes", "dimstyles"], units=ezdxf.units.MM)
    space = drawing.modelspace()
    for wheel in wheels:
        layer = drawing.layers.add(f"WHEEL_{wheel.number}", color=COLOURS[wheel.number]).dxf.name
        _add_dxf_curve(space, wheel, {"layer": layer}, tolerance)
        space.add_point(wheel.axis.tolist(), dxfattribs={"layer": layer})
    drawing.layers.add("CENTRES", linetype="CENTER")
    ends = [wheels[0].axis.tolist(), wheels[1].axis.tolist()]
    space.add_line(*ends, dxfattribs={"layer": "CENTRES"})
    away = measure_centres(wheels) / 10
    dimension = space.add_aligned_dim(*ends, distance=away, dxfattribs={"layer": "CENTRES"})
    dimension.render()
    text = StringIO()
    drawing.write(text)
    return text.getvalue()


def _add_dxf_curve(space: Any, wheel: Wheel, attributes: dict[str, str], tolerance: float) -> None:
    if wheel.e == 0:
        space.add_circle(wheel.axis.tolist(), wheel.a, dxfattribs=attributes)
    elif wheel.lobes == 1:
        centre, major, ratio = find_ellipse(wheel)
        space.add_ellipse(centre.tolist(), major.tolist(), ratio, dxfattribs=attributes)
    else:
        outline = trace_outline(wheel, tolerance).tolist()
        space.add_lwpolyline(outline, close=True, dxfattribs=attributes)


def import_ezdxf() -> ModuleType:
    """Import ezdxf; an ImportError names the extra."""
    require_modules("DXF", "cad", ("ezdxf",))
    import ezdxf
    import ezdxf.units

    return ezdxf


def cut_teeth(
    mechanism: Planetary,
    teeth: int,
    folder: str | os.PathLike[str],
    *,
    a: float | None = None,
    **options: Any,
) -> Any:
    """Cut teeth on the wheels 6 and 3 with ncgears. Needs the extra `cad`.

    Parameters
    ----------
    mechanism : EllipticPlanetary or OvalPlanetary
        The mechanism of the wheels; each turns once while the other does.
    teeth : int
        Number of teeth of each wheel, at least 3; the module follows: pi*module*teeth is the
        perimeter of the pitch curve.
    folder : path
        The folder for the files of ncgears.
    a : float, optional
        As for `export`.
    options
        Other arguments of `ncgears.generate`, such as `pressure_angle_deg` or `clearance`.

    Returns
    -------
    ncgears.GearPair
        With outlines in mm, `center_distance`, `maximum_transmission_error`, `export_dxf`.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names it.
    ImportError
        Without ncgears or SymPy.
    ncgears.GenerationError
        If ncgears cannot cut the wheels, as for great eccentricity with few teeth.

    """
    require_modules("cut_teeth", "cad", ("ncgears", "sympy"))
    import ncgears
    import sympy as sp

    check_planetary(mechanism)
    is_path = isinstance(folder, str | os.PathLike)
    require(is_path, "folder", folder, "must be the path of a folder", TypeError)
    count = check_count("teeth", teeth, least=3)
    driver = place_in_mm(mechanism, 0.0, a)[2]
    phi = sp.Symbol("phi", real=True)
    x = driver.lobes * phi
    e = sp.Float(driver.e)
    # The driver begins at its longest radius, where the driven wheel is fastest.
    law = phi + 2 * sp.atan(e * sp.sin(x) / (1 - e * sp.cos(x))) / driver.lobes
    (cut,) = find_oval_teeth(driver.a, driver.e, teeth=(count, count), lobes=driver.lobes)
    given = {"name": "pair_6_3", "output_directory": str(Path(folder)), **options}
    return ncgears.generate(law, teeth=count, module=cut.module, **given)
