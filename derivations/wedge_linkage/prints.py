"""What paper 4 prints of the groups."""

from __future__ import annotations

import sympy as sp
from sympy import cos, pi, sin, sqrt

from .symbols import (
    Q,
    R,
    alpha_DE,
    alpha_KL,
    alpha_LM,
    dBC,
    dFG,
    dHI,
    dPN,
    l_AB,
    l_BC,
    l_CD,
    l_DE,
    l_EF,
    l_KL,
    l_LM,
    phi3,
    phi7,
    x1,
    x5,
    y9,
)

print_ox1 = (
    l_AB * cos(pi + phi3) + (l_BC + dBC) * cos(phi3 + 3 * pi / 2) + l_CD * cos(pi + phi3)
) + (l_CD + l_AB + x1)
print_oy1 = (
    l_AB * sin(pi + phi3) + (l_BC + dBC) * sin(phi3 + 3 * pi / 2) + l_CD * sin(pi + phi3)
) + l_BC
print_1_top = -(x1 + l_AB) * Q + l_CD * (l_BC**2 - Q) + l_BC**2 * l_AB
print_1_bottom = l_BC * ((l_AB + l_CD) * (l_AB + l_CD + x1) + Q)
print_1 = sp.atan(print_1_top / print_1_bottom)
print_2_oy = l_DE * sin(alpha_DE + phi3) + dFG - l_DE * sin(alpha_DE)
left_of_2 = l_DE * cos(alpha_DE + phi3) + l_EF
right_of_2 = l_DE * cos(alpha_DE) + l_EF + x5
print_2_ox = left_of_2 - right_of_2
print_3 = l_DE * (cos(alpha_DE + phi3) - cos(alpha_DE))
print_6_ox = l_KL * cos(alpha_KL + phi7) - (l_KL * cos(alpha_KL) - x5)
print_6_oy = dHI + l_KL * sin(alpha_KL + phi7) - l_KL * sin(alpha_KL)
print_7 = -alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_8 = pi - alpha_KL + sp.atan(sqrt(l_KL**2 - R**2) / R)
print_9_ox = l_LM * cos(alpha_LM + phi7) + dPN - l_LM * cos(alpha_LM)
print_9_oy = l_LM * sin(alpha_LM + phi7) - (l_LM * sin(alpha_LM) + y9)
print_10 = l_LM * (sin(phi7 + alpha_LM) - sin(alpha_LM))
