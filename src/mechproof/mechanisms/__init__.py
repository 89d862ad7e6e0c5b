"""The mechanisms of the papers, with checked parameters; angles in radians, lengths in mm.

Users, the laboratory and the layers above may import it; it imports the kernels, `conformity`,
`tolerance` and NumPy, and SciPy inside the functions that need it. A mechanism is loaded when its
name is first used.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mechproof.mechanisms.elliptic_planetary import EllipticPlanetary
    from mechproof.mechanisms.oval_pairs import CylindricalPair, OvalPair
    from mechproof.mechanisms.oval_planetary import OvalPlanetary
    from mechproof.mechanisms.tooth_thickness import ToothThickness
    from mechproof.mechanisms.tooth_thickness_inspection import ThicknessInspection
    from mechproof.mechanisms.track_wheel import TrackWheel
    from mechproof.mechanisms.wedge_linkage import WedgeLinkage

__all__ = [
    "CylindricalPair",
    "EllipticPlanetary",
    "OvalPair",
    "OvalPlanetary",
    "ThicknessInspection",
    "ToothThickness",
    "TrackWheel",
    "WedgeLinkage",
]

# The module of this package in which each public name lives.
HOMES = {
    "CylindricalPair": "oval_pairs",
    "EllipticPlanetary": "elliptic_planetary",
    "OvalPair": "oval_pairs",
    "OvalPlanetary": "oval_planetary",
    "ThicknessInspection": "tooth_thickness_inspection",
    "ToothThickness": "tooth_thickness",
    "TrackWheel": "track_wheel",
    "WedgeLinkage": "wedge_linkage",
}


def __getattr__(name: str) -> Any:
    if name not in HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
