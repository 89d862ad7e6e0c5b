"""DXF for CAD: circles and ellipses as such, ovals as closed polylines; lengths in mm."""

from __future__ import annotations

from io import StringIO
from types import ModuleType
from typing import Any

from mechproof.exports.curves import find_ellipse, measure_centres, trace_outline
from mechproof.plot.pitch_curve_plot import Wheel
from mechproof.tools.extras import require_modules

# The unit of a drawing that is millimetres, and the colour of each wheel's layer.
COLOURS = {4: 1, 5: 5, 6: 3, 3: 6}


def write_dxf(wheels: tuple[Wheel, ...], tolerance: float) -> str:
    """Return the text of a drawing: a layer for each wheel, one with the distance of centres.

    Raises ImportError without ezdxf: the extra `cad`.
    """
    ezdxf = import_ezdxf()
    drawing = ezdxf.new("R2010", setup=["linetypes", "dimstyles"], units=ezdxf.units.MM)
    space = drawing.modelspace()
    for wheel in wheels:
        layer = drawing.layers.add(f"WHEEL_{wheel.number}", color=COLOURS[wheel.number]).dxf.name
        _add_curve(space, wheel, {"layer": layer}, tolerance)
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


def _add_curve(space: Any, wheel: Wheel, attributes: dict[str, str], tolerance: float) -> None:
    if wheel.e == 0:
        space.add_circle(wheel.axis.tolist(), wheel.a, dxfattribs=attributes)
    elif wheel.lobes == 1:
        centre, major, ratio = find_ellipse(wheel)
        space.add_ellipse(centre.tolist(), major.tolist(), ratio, dxfattribs=attributes)
    else:
        outline = trace_outline(wheel, tolerance).tolist()
        space.add_lwpolyline(outline, close=True, dxfattribs=attributes)


def import_ezdxf() -> ModuleType:
    """Import ezdxf; ImportError that names the extra."""
    require_modules("DXF", "cad", ("ezdxf",))
    import ezdxf
    import ezdxf.units

    return ezdxf
