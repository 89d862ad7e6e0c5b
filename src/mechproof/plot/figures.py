"""The figures of a paper: their definitions in its folder, and files of them.

A derivation that is a folder may contain `pictures.py`, which binds FIGURES, a tuple of `Figure`.
It is loaded on demand, with whatever it imports: numpy, kernels, mechanisms, `mechproof.plot`.
"""

from __future__ import annotations

import re
import textwrap
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from io import BytesIO, StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from mechproof.arguments.scalars import check_real, require
from mechproof.plot.canvas import COLUMN, SMALL, make_canvas, use_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

PART: Final = "pictures"
# A style that matplotlib writes as a rule, which would apply to the whole page.
LINES = "stroke-linejoin: round; stroke-linecap: butt"
# The font that matplotlib states for each text; other machines have one of the same widths, or
# another one.
FONT = re.compile(r"font-family: 'DejaVu Sans'[^;\"]*(?:; )?")
FONTS = "font-family: 'DejaVu Sans', Verdana, sans-serif"
# Pixels per inch of a PNG: a column of 85 mm has some 740.
DPI = 220
# A letter with an index, in a caption.
NAME = re.compile(r"\b([^\W\d_]+)_(\w+)")
# Sizes in captions, in mm: a point, the average width of a letter, and the line spacing.
POINT = 25.4 / 72
LETTER, LINE = 0.54 * SMALL * POINT, 1.35 * SMALL * POINT


class DrawingError(RuntimeError):
    """Raised if a figure cannot be drawn."""


@dataclass(frozen=True)
class Figure:
    """One figure of a paper: its texts, and how it is drawn.

    Parameters
    ----------
    name : str
        Stem of its files, of small letters, digits and hyphens: "fig-3".
    number : str or None
        Number as the paper prints it, "Fig. 3"; None for a figure that the paper does not have.
    title : str
        A sentence that states what the figure shows.
    caption : str
        What is drawn, which numbers are the paper's and which are ours.
    after : str
        Number of the row of the ledger after which the report shows it.
    draw : callable
        Draws on the empty `matplotlib.figure.Figure` that it is given.
    width, height : float
        Size in mm; a column is 85 mm wide.

    Raises
    ------
    TypeError, ValueError
        If the name, `draw` or a size is invalid; the message names it.

    """

    name: str
    number: str | None
    title: str
    caption: str
    after: str
    draw: Callable[[Canvas], object]
    width: float = COLUMN
    height: float = 60.0

    def __post_init__(self) -> None:
        """Check the name, the sizes and that `draw` is callable."""
        named = isinstance(self.name, str) and re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", self.name)
        require(
            named,
            "name",
            self.name,
            "must consist of lower-case letters, digits and single hyphens",
        )
        require(callable(self.draw), "draw", self.draw, "must be callable", TypeError)
        for size in ("width", "height"):
            length = check_real(size, getattr(self, size))
            require(length > 0, size, length, "must be positive")


def find_figures(place: Path) -> tuple[Figure, ...]:
    """Return the figures of a derivation, a folder or a file; () if it has no pictures.py.

    Raises
    ------
    DerivationError
        If it cannot be loaded, binds no tuple of `Figure` to FIGURES, or has two of one name.

    """
    from mechproof.derivation import DerivationError, load_part

    module = load_part(place, PART)
    if module is None:
        return ()
    figures = getattr(module, "FIGURES", None)
    if not isinstance(figures, tuple) or not all(isinstance(f, Figure) for f in figures):
        raise DerivationError(
            f"{module.__file__}: must bind a tuple of mechproof.plot.Figure to FIGURES"
        )
    names = [figure.name for figure in figures]
    if twice := sorted({name for name in names if names.count(name) > 1}):
        raise DerivationError(
            f"{module.__file__}: two figures with the same name: {', '.join(twice)}"
        )
    return figures


def draw(figure: Figure) -> Canvas:
    """Draw a figure at its size, leaving pyplot and rcParams unchanged.

    Raises `DrawingError` with the line at which the drawing failed.
    """
    with use_style():
        canvas = make_canvas(figure.width, figure.height)
    _draw_on(figure, canvas)
    return canvas


def _draw_on(figure: Figure, canvas: Any) -> None:
    """Draw a figure on a canvas, or on the part of one that has its size."""
    with use_style():
        try:
            figure.draw(canvas)
        except Exception as error:
            raise DrawingError(_describe(figure, _find_line(error), error)) from error


def _describe(figure: Figure, line: str, error: Exception) -> str:
    """Return a line that states which figure failed, and why."""
    what = " ".join(f"{type(error).__name__}: {error}".split())
    return f"{figure.name}: {line}{what}"


def _find_line(error: Exception) -> str:
    """Return "file:line: " of the innermost line within the file of the drawing; or ""."""
    _, *frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if frame.filename == frames[0].filename]
    return f"{own[-1].filename}:{own[-1].lineno}: " if own else ""


def render_svg(figure: Figure) -> str:
    """Return a figure as one <svg> element with text as text: the same bytes each time.

    No id in it occurs in another figure, so that a page may contain several. Raises as `draw`.
    """
    return _save_svg(figure, draw(figure))


def write_files(figure: Figure, folder: Path, stem: str) -> tuple[Path, Path]:
    """Write a figure with its caption below as PNG and SVG; return the paths of the files.

    Raises as `draw`, and OSError.
    """
    canvas = _draw_with_caption(figure)
    pixels, text = _save_png(figure, canvas), _save_svg(figure, canvas)
    files = folder / f"{stem}.png", folder / f"{stem}.svg"
    folder.mkdir(parents=True, exist_ok=True)
    files[0].write_bytes(pixels)
    files[1].write_text(text, encoding="utf-8")
    return files


def _draw_with_caption(figure: Figure) -> Canvas:
    """Draw a figure at its size above its number, title and caption. Raises as `draw`."""
    number = f"{figure.number}. " if figure.number else ""
    letters = int(figure.width / LETTER)
    wrapped = textwrap.wrap(f"{number}{figure.title} {figure.caption}", letters)
    lines = [NAME.sub(r"$\\mathregular{\1_{\2}}$", line) for line in wrapped]
    room = (len(lines) + 1) * LINE
    with use_style():
        canvas = make_canvas(figure.width, figure.height + room)
        parts: Any = canvas.subfigures(2, 1, height_ratios=(figure.height, room))
        above, below = parts
        below.text(0.01, 1.0, "\n".join(lines), fontsize=SMALL, va="top", linespacing=1.3)
    _draw_on(figure, above)
    return canvas


def _save_svg(figure: Figure, canvas: Canvas) -> str:
    with use_style({"svg.hashsalt": f"{figure.name}: {figure.title}"}), _blame(figure):
        return write_svg(canvas, figure.title)


def _save_png(figure: Figure, canvas: Canvas) -> bytes:
    pixels = BytesIO()
    with use_style(), _blame(figure):
        canvas.savefig(pixels, format="png", dpi=DPI, metadata={"Title": figure.title})
    return pixels.getvalue()


@contextmanager
def _blame(figure: Figure) -> Iterator[None]:
    """Turn errors in saving into `DrawingError`, as texts are parsed only then."""
    try:
        yield
    except Exception as error:
        raise DrawingError(_describe(figure, "", error)) from error


def write_svg(canvas: Canvas, title: str) -> str:
    """Return a drawing, in the current style, as an <svg> element for use in a page."""
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    text = StringIO()
    # Unlike `savefig`, this draws once.
    drawing: Any = FigureCanvasSVG(canvas)
    drawing.print_svg(text, metadata={"Date": None, "Creator": None})
    return strip_svg(text.getvalue(), title)


def strip_svg(text: str, title: str) -> str:
    """Return the <svg> element of a text for use in a page, without style rules and unused ids."""
    body = text[text.index("<svg") :]
    body = re.sub(r"\s*<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r"\s*<defs>\s*<style.*?</defs>", "", body, count=1, flags=re.DOTALL)
    used = set(re.findall(r"#([\w.-]+)", body))
    body = re.sub(r' id="([\w.-]+)"', lambda found: found[0] if found[1] in used else "", body)
    says = f'role="img" aria-label="{escape(title)}" style="{LINES}; {FONTS}"'
    return FONT.sub("", body).replace("<svg ", f"<svg {says} ", 1)
