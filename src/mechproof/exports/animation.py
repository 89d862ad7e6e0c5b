"""The wheels in motion: a GIF, or a page that plays in a browser."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from mechproof.plot.canvas import make_canvas, use_style
from mechproof.plot.motion_plot import Planetary
from mechproof.plot.pitch_curve_plot import pitch_curves, place_wheels

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
