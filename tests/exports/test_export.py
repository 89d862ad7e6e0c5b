"""Files for other programs are reopened with those programs' libraries and measured."""

from __future__ import annotations

import csv
import math
import re
from importlib import import_module
from io import StringIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest
from PIL import Image

import mechproof
from mechproof import CylindricalPair, EllipticPlanetary, OvalPair, OvalPlanetary, export
from mechproof.exports import cut_teeth
from mechproof.exports.curves import place_in_mm, trace_outline
from mechproof.mechanisms.teeth import find_oval_teeth
from mechproof.tools import extras

ELLIPTIC = EllipticPlanetary.published(1)
OVAL = OvalPlanetary(CylindricalPair(30, 20), "0.2")
OVALS = OvalPlanetary(OvalPair("0.3"), "0.2")
DRIVES = ((ELLIPTIC, None, 50.0), (OVAL, None, 50.0), (OVALS, 40.0, 80.0))
TOLERANCE = 1e-3
ANGLE = 30.0


def open_drawing(mechanism: Any, a: float | None, folder: Path) -> Any:
    """Write a drawing, and return it as read back without faults."""
    path = export(mechanism, folder / "pair.dxf", phi1=ANGLE, degrees=True, a=a)
    drawing = ezdxf.readfile(path)
    assert drawing.audit().errors == []
    return drawing


def distance_to(wheel: Any, points: Any) -> Any:
    """Return the distances of points from a pitch curve along its rays (mm)."""
    away = np.asarray(points) - wheel.axis
    angles = np.arctan2(away[:, 1], away[:, 0])
    return np.abs(np.hypot(*away.T) - wheel.radius(angles))


@pytest.mark.parametrize(("mechanism", "a", "distance"), DRIVES, ids=lambda v: str(v))
def test_a_drawing_opened_again_has_the_curves(
    mechanism: Any, a: float | None, distance: float, tmp_path: Path
) -> None:
    drawing = open_drawing(mechanism, a, tmp_path)
    assert drawing.units == ezdxf.units.MM
    wheels = {wheel.number: wheel for wheel in place_in_mm(mechanism, np.radians(ANGLE), a)}
    for number, wheel in wheels.items():
        (curve,) = (
            drawing.modelspace()
            .query(f'*[layer=="WHEEL_{number}"]')
            .query("CIRCLE ELLIPSE LWPOLYLINE")
        )
        if curve.dxftype() == "LWPOLYLINE":
            assert curve.closed
            points = np.array(curve.get_points("xy"))
            assert not np.array_equal(points[0], points[-1])
            middles = (points + np.roll(points, -1, axis=0)) / 2
            # Vertices lie on the curve, and no chord is farther off than the tolerance.
            assert distance_to(wheel, points).max() <= 1e-13 * wheel.a
            assert distance_to(wheel, middles).max() <= TOLERANCE
        else:
            steps = np.linspace(0.0, 2 * np.pi, 50)
            points = np.array(
                [[*v][:2] for v in curve.vertices(steps)]
                if curve.dxftype() == "ELLIPSE"
                else [[*v][:2] for v in curve.vertices(np.degrees(steps))]
            )
            # Some 50 roundings of a radius.
            assert distance_to(wheel, points).max() <= 1e-13 * wheel.a
            if curve.dxftype() == "ELLIPSE":
                assert (curve.dxf.start_param, curve.dxf.end_param) == (0, 2 * math.pi)
        (centre,) = drawing.modelspace().query(f'POINT[layer=="WHEEL_{number}"]')
        assert [*centre.dxf.location][:2] == pytest.approx(wheel.axis, abs=1e-12)
    (line,) = drawing.modelspace().query('LINE[layer=="CENTRES"]')
    assert line.dxf.start.distance(line.dxf.end) == pytest.approx(distance, rel=1e-14)
    (measured,) = drawing.modelspace().query("DIMENSION")
    assert measured.get_measurement() == pytest.approx(distance, rel=1e-12)


def test_the_measure_sees_a_wheel_that_is_turned(tmp_path: Path) -> None:
    drawing = open_drawing(OVAL, None, tmp_path)
    (curve,) = drawing.modelspace().query('LWPOLYLINE[layer=="WHEEL_6"]')
    wheel = place_in_mm(OVAL, np.radians(ANGLE + 0.1), None)[2]
    assert distance_to(wheel, np.array(curve.get_points("xy"))).max() > TOLERANCE


@pytest.mark.parametrize(("mechanism", "a", "distance"), DRIVES, ids=lambda v: str(v))
def test_wheels_in_mesh_touch_and_roll(mechanism: Any, a: float | None, distance: float) -> None:
    """The curves of 6 and 3 touch on the line of centres, and are equally long."""
    *_, driver, output = place_in_mm(mechanism, np.radians(ANGLE), a)
    towards = np.radians(ANGLE)
    both = float(driver.radius(towards + np.pi) + output.radius(towards))
    assert both == pytest.approx(distance, rel=1e-13)
    lengths = [find_oval_teeth(w.a, w.e, lobes=w.lobes)[0].perimeter for w in (driver, output)]
    assert lengths[0] == lengths[1]


def test_a_picture_has_its_size_in_millimetres(tmp_path: Path) -> None:
    for mechanism, a, distance in DRIVES:
        text = export(mechanism, tmp_path / "pair.svg", phi1=ANGLE, degrees=True, a=a).read_text()
        root = ElementTree.fromstring(text)
        assert root.attrib["width"].endswith("mm")
        box = [*map(float, root.attrib["viewBox"].split())]
        assert float(root.attrib["width"].removesuffix("mm")) == box[2]
        name = "{http://www.w3.org/2000/svg}"
        line = root.find(f".//{name}line")
        assert line is not None
        ends = [float(line.attrib[k]) for k in ("x1", "y1", "x2", "y2")]
        assert math.dist(ends[:2], ends[2:]) == pytest.approx(distance, rel=1e-14)
        paths = [p.attrib["d"] for p in root.iter(f"{name}path")]
        assert all(path.endswith("Z") for path in paths)
        assert len(root.findall(f".//{name}g/*")) == 5


def test_tables_are_read_back_exactly(tmp_path: Path) -> None:
    path = export(ELLIPTIC, tmp_path / "motion.csv", what="motion", degrees=True)
    head, *rows = csv.reader(StringIO(path.read_text()))
    assert head == ["phi1_deg", "phi3_deg", "ratio", "acceleration_per_deg"]
    table = np.array(rows, float)
    assert np.array_equal(table[:, 0], np.arange(361.0))
    assert np.array_equal(table[:, 1], ELLIPTIC.position(table[:, 0], degrees=True))
    head, *rows = csv.reader(StringIO(export(OVAL, tmp_path / "pair.csv").read_text()))
    assert head == ["wheel", "x_mm", "y_mm"]
    outline = [row[1:] for row in rows if row[0] == "3"]
    assert outline[0] == outline[-1]
    wanted = trace_outline(place_in_mm(OVAL, 0.0, None)[3], TOLERANCE)
    assert np.array_equal(np.array(outline[:-1], float), wanted)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["drive.gif", "drive.html"])
def test_wheels_move(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("mechproof.exports.export"), "FRAMES", 3)
    path = export(OVALS, tmp_path / name)
    if name.endswith("gif"):
        film = Image.open(path)
        assert film.n_frames == 3
        first = np.asarray(film.convert("L"))
        film.seek(1)
        assert not np.array_equal(first, np.asarray(film.convert("L")))
    else:
        assert path.read_text().count("data:image/png") == 3


@pytest.mark.slow
def test_teeth_are_cut_for_our_law(tmp_path: Path) -> None:
    """The centre distance that ncgears finds from the law alone is the mechanism's."""
    pair = cut_teeth(ELLIPTIC, 16, tmp_path, samples=1024)
    assert pair.center_distance == pytest.approx(ELLIPTIC.R1 - ELLIPTIC.R2, rel=1e-9)
    assert (pair.drive_teeth, pair.driven_teeth) == (16, 16)
    assert pair.maximum_transmission_error < 1e-4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "more", "message"),
    [
        ("pair.gif", {"a": 3.0}, "^a = 3.0: .*leave it out"),
        ("pair.dwg", {}, r"^path = .*must end in \.dxf"),
        ("pair.dxf", {"a": 3.0}, "^a = 3.0: .*leave it out"),
        ("pair.dxf", {"tolerance": 0}, "^tolerance = 0: must be positive"),
        ("pair.dxf", {"tolerance": 1e-30}, "^tolerance = .*points"),
        ("pair.dxf", {"what": "motion"}, r"^path = .*must end in \.csv"),
        ("pair.csv", {"what": "all"}, "^what = 'all': must be"),
        ("pair.csv", {"phi1": "x"}, "^phi1 = 'x'"),
    ],
)
def test_what_cannot_be_written_is_refused(
    name: str, more: dict[str, Any], message: str, tmp_path: Path
) -> None:
    with pytest.raises((TypeError, ValueError), match=message):
        export(OVAL, tmp_path / name, **more)
    assert [*tmp_path.iterdir()] == []


def test_a_pair_without_a_size_needs_one(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"^a = None: must be the major semi-axis"):
        export(OVALS, tmp_path / "pair.dxf")
    with pytest.raises(TypeError, match=r"^mechanism\b"):
        export(mechproof.TrackWheel(41.5, 3.75, 6, 20), tmp_path / "pair.dxf")  # type: ignore[arg-type]


@pytest.mark.parametrize("library", ["ezdxf", "ncgears"])
def test_the_extra_is_named(library: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda name: None if name == library else name)
    calls: dict[str, Any] = {
        "ezdxf": lambda: export(OVAL, tmp_path / "pair.dxf"),
        "ncgears": lambda: cut_teeth(OVAL, 30, tmp_path),
    }
    with pytest.raises(
        ImportError, match=rf"needs {library}.*{re.escape(extras.suggest_install('cad'))}"
    ):
        calls[library]()
