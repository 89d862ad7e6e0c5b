"""Slopes of the stages of paper 4, closed and from the differentiated projections."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp
from sympy import cos, sin

from .mechanics import group_1, group_3
from .symbols import (
    alpha_DE,
    alpha_KL,
    alpha_LM,
    dBC,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_KL,
    l_LM,
    phi3,
    phi7,
    reach,
    x1,
    x5,
    x5_driven,
)

lever_slopes = {
    x1: -cos(phi3) / reach,
    l_AB: (1 - cos(phi3)) / reach,
    l_CD: (1 - cos(phi3)) / reach,
    l_BC: -sin(phi3) / reach,
}
roller_slopes = {
    x5: 1 / (l_KL * sin(alpha_KL + phi7)),
    l_KL: (cos(alpha_KL + phi7) - cos(alpha_KL)) / (l_KL * sin(alpha_KL + phi7)),
    alpha_KL: sin(alpha_KL) / sin(alpha_KL + phi7) - 1,
}


rod_slopes = {
    phi3: -l_DE * sin(alpha_DE + phi3),
    l_DE: cos(alpha_DE + phi3) - cos(alpha_DE),
    alpha_DE: l_DE * (sin(alpha_DE) - sin(alpha_DE + phi3)),
}
wedge_slopes = {
    phi7: l_LM * cos(alpha_LM + phi7),
    l_LM: sin(alpha_LM + phi7) - sin(alpha_LM),
}


def slope_by_projections(
    projections: Iterable[sp.Expr], unknowns: Sequence[sp.Symbol], size: sp.Symbol
) -> sp.Expr:
    """Return the derivative of the first unknown, from the differentiated equations."""
    equations = sp.Matrix(list(projections))
    rates = equations.jacobian(list(unknowns)).cramer_solve(-equations.diff(size))
    return sp.expand(sp.cancel(rates[0]))


def lever_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi3 from both projections of group 1."""
    return slope_by_projections(group_1.subs(dBC, reach - l_BC), (phi3, reach), size)


def roller_slope(size: sp.Symbol) -> sp.Expr:
    """Return the derivative of varphi7 from the projection of group 3 on Ox."""
    return slope_by_projections([group_3[0].subs(x5_driven, x5)], (phi7,), size)
