"""What the symbols of paper 1 are given by, and those that the proofs need besides."""

from sympy import Interval, S, oo

from mechproof.latex import Reader
from mechproof.record import ANGLE, LENGTH, Variable

from .._metrology import TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES
from .symbols import (
    AC,
    BC,
    BD,
    CD,
    DE,
    PRINT,
    R1,
    R2,
    VC,
    VD,
    C,
    E,
    T,
    U,
    a,
    a1,
    at_b,
    at_c,
    at_d,
    b1,
    e,
    focal_radius,
    k,
    nearest,
    nu,
    omega1,
    omega3,
    phi1,
    phi5,
    rho,
    theta,
    turns,
    x,
)

PRINTED_VARIABLES = PRINT.give(
    {
        a: (R1 - R2) / 2,
        phi5: -R1 / R2 * phi1,
        x: k * phi1,
        a1: 1 + e**2,
        b1: 2 * e,
        rho: focal_radius.subs(theta, phi5),
        AC: at_c,
        BC: at_b - at_c,
        CD: at_c - at_d,
        BD: at_b - at_d,
        DE: at_d,
        VC: omega1 * at_c,
        VD: omega3 * at_d,
        C: S.Zero,
    }
)
VARIABLES = (
    *PRINTED_VARIABLES,
    *TYPE_A_VARIABLES,
    *ENCODER_VARIABLES,
    Variable(k, "ratio of the cylindrical radii", given=R1 / R2),
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e),
    Variable(at_b, "coordinate of B on the line A-C", LENGTH),
    Variable(at_c, "coordinate of C", LENGTH, Interval.open(0, oo)),
    Variable(at_d, "coordinate of D", LENGTH),
    Variable(U, "tg(x/2) as a variable of integration's limit"),
    Variable(turns, "whole turns of x", within=S.Naturals0),
    Variable(nu, "number of terms of a series", within=Interval.open(0, oo)),
    Variable(E, "e**nu", within=Interval.open(0, oo)),
    Variable(T, "nu*x", ANGLE),
)
READER = Reader(VARIABLES, PRINT.notation)
