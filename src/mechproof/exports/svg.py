"""SVG in millimetres: circles and ellipses as such, ovals as closed paths."""

from __future__ import annotations

from xml.etree.ElementTree import Element, SubElement, indent, tostring

import numpy as np

from mechproof.exports.curves import find_ellipse, measure_centres, trace_outline
from mechproof.plot.pitch_curve_plot import Wheel

# Millimetres around the wheels.
MARGIN = 5.0


def write_svg(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return the text of a picture of its size in mm; y points up inside its group."""
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
        _add_curve(group, wheel, tolerance).set("id", f"wheel_{wheel.number}")
    (x1, y1), (x2, y2) = (w.axis.tolist() for w in wheels[:2])
    ends = {"x1": repr(x1), "y1": repr(y1), "x2": repr(x2), "y2": repr(y2)}
    SubElement(group, "line", {"id": "centres", **ends})
    indent(picture)
    return tostring(picture, encoding="unicode") + "\n"


def _add_curve(group: Element, wheel: Wheel, tolerance: float) -> Element:
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
