"""The equations of paper 4 as it prints them, and what is read from them."""

from __future__ import annotations

import sympy as sp

from mechproof.latex import Reader
from mechproof.record import Equation

from .symbols import LENGTH_OF_Q, NOTATION, PRINTED_VARIABLES

GROUP_1 = Equation(
    "group 1",
    r"\vec{AB}+\vec{BC}+\vec{CD}=\vec{AD}",
)
GROUP_1_OX = Equation(
    "group 1, Ox",
    r"l_{AB}\cos(\pi+\varphi_3)+(l_{BC}+\delta_{BC})\cos(\varphi_3+\tfrac{3\pi}2)"
    r"+l_{CD}\cos(\pi+\varphi_3)=-(l_{CD}+l_{AB}+x_1)",
)
GROUP_1_OY = Equation(
    "group 1, Oy",
    r"l_{AB}\sin(\pi+\varphi_3)+(l_{BC}+\delta_{BC})\sin(\varphi_3+\tfrac{3\pi}2)"
    r"+l_{CD}\sin(\pi+\varphi_3)=-l_{BC}",
)
EQUATION_Q = Equation(
    "(1), Q",
    r"Q=\left[l_{BC}^4+x_1l_{BC}^2(2l_{CD}+2l_{AB}+x_1)\right]^{1/2}",
)
EQUATION_1 = Equation(
    "(1)",
    r"\varphi_3(x_1)=\arctan\dfrac{-(x_1+l_{AB})Q+l_{CD}(l_{BC}^2-Q)+l_{BC}^2l_{AB}}"
    r"{l_{BC}\left[(l_{AB}+l_{CD})(l_{AB}+l_{CD}+x_1)+Q\right]}",
)
GROUP_2 = Equation(
    "group 2",
    r"\vec{DE}+\vec{EF}+\vec{FG}=\vec{DG}",
)
EQUATION_2_OX = Equation(
    "(2), Ox",
    r"l_{DE}\cos(\alpha_{DE}+\varphi_3)+l_{EF}=l_{DE}\cos\alpha_{DE}+l_{EF}+x_5",
)
EQUATION_2_OY = Equation(
    "(2), Oy",
    r"l_{DE}\sin(\alpha_{DE}+\varphi_3)+\delta_{FG}=l_{DE}\sin\alpha_{DE}",
)
EQUATION_3 = Equation(
    "(3)",
    r"x_5(\varphi_3)=l_{DE}\left[\cos(\alpha_{DE}+\varphi_3)-\cos\alpha_{DE}\right]",
)
EQUATION_5 = Equation(
    "(5)",
    r"\vec{HI}+\vec{IK}+\vec{KL}=\vec{HL}",
)
EQUATION_6_OX = Equation(
    "(6), Ox",
    r"l_{KL}\cos(\alpha_{KL}+\varphi_7)=l_{KL}\cos\alpha_{KL}-x_5",
)
EQUATION_6_OY = Equation(
    "(6), Oy",
    r"\delta_{HI}+l_{KL}\sin(\alpha_{KL}+\varphi_7)=l_{KL}\sin\alpha_{KL}",
)
EQUATION_7 = Equation(
    "(7)",
    r"\varphi_7(x_5)=-\alpha_{KL}+\arctan\dfrac{(l_{KL}^2-R^2)^{1/2}}{R}\text{ for }R>0",
)
EQUATION_8 = Equation(
    "(8)",
    r"\varphi_7(x_5)=\pi-\alpha_{KL}+\arctan\dfrac{(l_{KL}^2-R^2)^{1/2}}{R}\text{ for }R<0",
)
GROUP_4 = Equation(
    "group 4",
    r"\vec{LM}+\vec{MN}+\vec{NP}=\vec{LP}",
)
EQUATION_9_OX = Equation(
    "(9), Ox",
    r"l_{LM}\cos(\alpha_{LM}+\varphi_7)+\delta_{PN}=l_{LM}\cos\alpha_{LM}",
)
EQUATION_9_OY = Equation(
    "(9), Oy",
    r"l_{LM}\sin(\alpha_{LM}+\varphi_7)=l_{LM}\sin\alpha_{LM}+y_9",
)
EQUATION_10 = Equation(
    "(10)",
    r"y_9(\varphi_7)=l_{LM}\left[\sin(\varphi_7+\alpha_{LM})-\sin\alpha_{LM}\right]",
)
EQUATION_4 = Equation(
    "(4)",
    r"x_{5'}(x_5)=0\text{ if }x_5(\varphi_2)<l_{G'H''},\ "
    r"x_5(\varphi_2)-l_{G'H''}\text{ if }x_5(\varphi_2)>l_{G'H''}",
)
EQUATION_R = Equation("(7) and (8), R", r"R=l_{KL}\cos\alpha_{KL}-x_5")

READER = Reader((*PRINTED_VARIABLES, LENGTH_OF_Q), NOTATION)
_, PRINTED_Q = READER.members(EQUATION_Q)
_, PRINTED_R = READER.members(EQUATION_R)
_, print_1 = READER.members(EQUATION_1)
print_1_top, print_1_bottom = sp.fraction(print_1.args[0])
left_of_2, right_of_2 = READER.members(EQUATION_2_OX)
_, print_3 = READER.members(EQUATION_3)
_, print_4 = READER.members(EQUATION_4)
print_6_ox = sp.Add(*map(sp.Mul, (1, -1), READER.members(EQUATION_6_OX)))
_, print_7 = READER.members(EQUATION_7)
_, print_8 = READER.members(EQUATION_8)
_, print_10 = READER.members(EQUATION_10)
