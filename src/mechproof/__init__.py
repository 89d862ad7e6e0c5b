"""Mechanism formulas from print to proved verdicts and accurate NumPy kernels.

`EllipticPlanetary` and `TrackWheel` are mechanisms with checked parameters;
`choose` names the cheapest way to compute a quantity to a given error;
`mechproof.kernels.<system>` has the plain functions of arrays below them. Everything is imported
when it is first used: `import mechproof` costs next to nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mechproof.choice import choose
    from mechproof.elliptic_planetary import EllipticPlanetary
    from mechproof.oval_planetary import CylindricalPair, OvalPair, OvalPlanetary
    from mechproof.tooth_thickness import ToothThickness
    from mechproof.tooth_thickness_inspection import ThicknessInspection
    from mechproof.track_wheel import TrackWheel
    from mechproof.wedge_linkage import WedgeLinkage

__all__ = [
    "CylindricalPair",
    "EllipticPlanetary",
    "OvalPair",
    "OvalPlanetary",
    "ThicknessInspection",
    "ToothThickness",
    "TrackWheel",
    "WedgeLinkage",
    "__version__",
    "choose",
]

# The module in which each public name lives.
HOMES = {
    "CylindricalPair": "mechproof.oval_planetary",
    "EllipticPlanetary": "mechproof.elliptic_planetary",
    "OvalPair": "mechproof.oval_planetary",
    "OvalPlanetary": "mechproof.oval_planetary",
    "ThicknessInspection": "mechproof.tooth_thickness_inspection",
    "ToothThickness": "mechproof.tooth_thickness",
    "TrackWheel": "mechproof.track_wheel",
    "WedgeLinkage": "mechproof.wedge_linkage",
    "choose": "mechproof.choice",
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("mechproof")
    if name not in HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
