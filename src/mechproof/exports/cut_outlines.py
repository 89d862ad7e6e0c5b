"""Teeth on the pair 6-3: our law of its motion, handed to ncgears, which cuts them.

ncgears is a young library (alpha) of its own: it generates outlines, checks the pair for
interference and for errors of the motion, and refuses what it cannot cut. What it makes is its own
result; nothing of it is proved here.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from mechproof.arguments.scalars import check_count, require
from mechproof.exports.curves import place_in_mm
from mechproof.mechanisms.teeth import find_oval_teeth
from mechproof.plot.motion_plot import Planetary, check_planetary
from mechproof.tools.extras import require_modules


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
        Whose wheels; each turns once while the other does.
    teeth : int
        Number of teeth of each wheel, at least 3; the module follows: pi*module*teeth is the
        perimeter of the pitch curve.
    folder : path
        Where ncgears writes its files.
    a : float, optional
        As for `export`.
    options
        Further arguments of `ncgears.generate`, such as `pressure_angle_deg` or `clearance`.

    Returns
    -------
    ncgears.GearPair
        With outlines in mm, `center_distance`, `maximum_transmission_error`, `export_dxf`.

    Raises
    ------
    TypeError, ValueError
        For what is not allowed; the message names it.
    ImportError
        Without ncgears or SymPy.
    ncgears.GenerationError
        What ncgears cannot cut, such as wheels of great eccentricity with few teeth.

    """
    require_modules("cut_teeth", "cad", ("ncgears", "sympy"))
    import ncgears
    import sympy as sp

    check_planetary("mechanism", mechanism)
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
