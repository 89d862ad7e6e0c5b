"""Mechanism formulas from printed equations to proved verdicts and accurate NumPy kernels.

`EllipticPlanetary` and `TrackWheel` are mechanisms with checked parameters;
`check` judges the equations in a paper's source, `judge_equation` a single equation;
`export` writes pitch curves and motions for other programs;
`formula` writes a quantity in LaTeX, C, Octave, JavaScript and other languages;
`bound` proves bounds on the rounding error of a formula;
`choose` finds the cheapest way to compute a quantity to within a given error;
`tailor` makes a kernel for fixed parameters and a given error;
`mechproof.kernels.<system>` has the plain array functions beneath them. Everything is imported on
first use, so `import mechproof` costs next to nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, NoReturn

from mechproof.tools.notebook import Displayed

if TYPE_CHECKING:
    from mechproof import (
        conformity as conformity,
        kernels as kernels,
        laws as laws,
        measurement as measurement,
        mechanisms as mechanisms,
        plot as plot,
        tolerance as tolerance,
    )
    from mechproof.choice import choose
    from mechproof.document.checking import check
    from mechproof.exports import export
    from mechproof.mechanisms import (
        CylindricalPair,
        EllipticPlanetary,
        OvalPair,
        OvalPlanetary,
        ThicknessInspection,
        ToothThickness,
        TrackWheel,
        WedgeLinkage,
    )
    from mechproof.pipeline.bounding import bound
    from mechproof.pipeline.pasted import judge_equation
    from mechproof.report.formula_texts import formula
    from mechproof.tailoring import tailor

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
    "bound",
    "check",
    "choose",
    "export",
    "formula",
    "judge_equation",
    "tailor",
]

# Packages available as attributes without an import of their own.
PACKAGES = ("conformity", "kernels", "laws", "measurement", "mechanisms", "plot", "tolerance")
# The module that defines each public name.
HOMES = dict.fromkeys(__all__, "mechproof.mechanisms") | {
    "bound": "mechproof.pipeline.bounding",
    "check": "mechproof.document.checking",
    "choose": "mechproof.choice",
    "export": "mechproof.exports",
    "formula": "mechproof.report.formula_texts",
    "judge_equation": "mechproof.pipeline.pasted",
    "tailor": "mechproof.tailoring",
}


def _show(shown: object) -> str | None:
    """Return an object as a report shows it, None without the `derive` extra."""
    try:
        from mechproof.report.notebook_pieces import show
    except ModuleNotFoundError as error:
        if (error.name or "").startswith("mechproof"):
            raise
        return None
    return show(shown)


Displayed._show = staticmethod(_show)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("mechproof")
    if name in PACKAGES:
        return import_module(f"mechproof.{name}")
    if name not in HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        return getattr(import_module(HOMES[name]), name)
    except ModuleNotFoundError as error:
        if (error.name or "").startswith("mechproof"):
            raise
        return _stand_in(name, error)


def _stand_in(name: str, error: ModuleNotFoundError) -> Callable[..., NoReturn]:
    """Return a function that only raises ImportError: names can be imported without extras."""
    from mechproof.tools.extras import describe_missing

    message = describe_missing(f"mechproof.{name}", "derive", error.name)

    def refuse(*arguments: object, **named: object) -> NoReturn:
        raise ImportError(message)

    return refuse


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, *PACKAGES})
