"""What all pictures share: matplotlib where it is installed, and a style that none keeps."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import AbstractContextManager
from types import ModuleType
from typing import Any

__all__ = ["MILLIMETRE", "STYLE", "import_matplotlib", "use_style"]

# An inch is 25.4 mm.
MILLIMETRE = 1 / 25.4
STYLE: Mapping[str, Any] = {
    "axes.linewidth": 0.6,
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 8,
    "axes.labelsize": 7.5,
    "figure.constrained_layout.use": True,
    "font.family": "DejaVu Sans",
    "font.size": 7.5,
    "legend.fontsize": 7,
    "lines.linewidth": 1.2,
    "svg.fonttype": "none",
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
}


def import_matplotlib() -> ModuleType:
    """Return matplotlib; ImportError names the extra where it is missing."""
    try:
        import matplotlib
    except ImportError as error:
        raise ImportError(
            "pictures need matplotlib: pip install 'mechproof[plot]', or '.[plot]' in its folder"
        ) from error
    return matplotlib


def use_style(more: Mapping[str, Any] | None = None) -> AbstractContextManager[None]:
    """Hold matplotlib's defaults with the style of the pictures inside the context alone."""
    matplotlib = import_matplotlib()
    settings: dict[Any, Any] = {**matplotlib.rcParamsDefault, **STYLE, **(more or {})}
    settings.pop("backend", None)
    context: AbstractContextManager[None] = matplotlib.rc_context(settings)
    return context
