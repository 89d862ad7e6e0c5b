"""What the symbols of paper 1 mean and how it prints them."""

from sympy import Interval, S, oo

from mechproof.latex import Reader
from mechproof.record import ANGLE, FREQUENCY, LENGTH, SPEED, Notation, Variable

from .._metrology import TYPE_A_VARIABLES
from .._readings import ENCODER_VARIABLES
from .symbols import (
    AC,
    BC,
    BD,
    CD,
    DE,
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
    phi3,
    phi5,
    ratio_symbol,
    rho,
    slope,
    theta,
    turns,
    x,
)

VARIABLES = (
    Variable(
        phi1,
        "angle of the carrier 1",
        ANGLE,
        sign="positive in its direction of rotation",
        latex=(r"\varphi_1",),
    ),
    Variable(phi3, "angle of wheel 3", ANGLE, latex=(r"\varphi_3",)),
    Variable(R1, "radius of the epicycle 4", LENGTH, Interval.open(0, oo), latex=("R_1",)),
    Variable(R2, "radius of the satellite wheel 5", LENGTH, Interval.open(0, oo), latex=("R_2",)),
    Variable(e, "eccentricity of the ellipse", within=Interval.Ropen(0, 1), latex=("e",)),
    Variable(a, "major semi-axis of the ellipse", LENGTH, given=(R1 - R2) / 2, latex=("a",)),
    Variable(
        phi5,
        "rotation of wheel 6 against the carrier",
        ANGLE,
        given=-R1 / R2 * phi1,
        latex=(r"\varphi_5",),
    ),
    Variable(k, "ratio of the cylindrical radii", given=R1 / R2),
    Variable(
        x,
        "rotation of wheel 6 against the carrier, reversed",
        ANGLE,
        given=k * phi1,
        latex=("x", r"\frac{R_1}{R_2}\varphi_1"),
    ),
    Variable(a1, "1 + e^2", given=1 + e**2, latex=("a_1",)),
    Variable(b1, "2 e", given=2 * e, latex=("b_1",)),
    Variable(nearest, "least focal distance over a, a sum of its own", given=1 - e),
    Variable(
        rho,
        "radius CD",
        LENGTH,
        given=focal_radius.subs(theta, phi5),
        latex=(r"\rho(\varphi_5)", r"\rho"),
    ),
    Variable(
        omega1,
        "angular velocity of the carrier",
        FREQUENCY,
        Interval.open(0, oo),
        latex=(r"\omega_1",),
    ),
    Variable(omega3, "angular velocity of wheel 3", FREQUENCY, latex=(r"\omega_3",)),
    Variable(at_b, "coordinate of B on the line A-C", LENGTH),
    Variable(at_c, "coordinate of C", LENGTH, Interval.open(0, oo)),
    Variable(at_d, "coordinate of D", LENGTH),
    Variable(AC, "from A to C", LENGTH, given=at_c, latex=("AC",)),
    Variable(BC, "from C to B", LENGTH, given=at_b - at_c, latex=("BC",)),
    Variable(CD, "from D to C", LENGTH, given=at_c - at_d, latex=("CD",)),
    Variable(BD, "from D to B", LENGTH, given=at_b - at_d, latex=("BD",)),
    Variable(DE, "from E to D", LENGTH, given=at_d, latex=("DE",)),
    Variable(
        VC, "velocity of C, positive with the carrier", SPEED, given=omega1 * at_c, latex=("V_C",)
    ),
    Variable(
        VD, "velocity of D, positive with the carrier", SPEED, given=omega3 * at_d, latex=("V_D",)
    ),
    Variable(U, "tg(x/2) as a variable of integration's limit"),
    Variable(C, "constant of integrals that start at 0", given=S.Zero, latex=("C",)),
    *TYPE_A_VARIABLES,
    Variable(ratio_symbol, "analogue of the angular velocity", latex=(r"\varphi_3'",)),
    Variable(
        slope, "derivative of the position function", latex=(r"\frac{d\varphi_3}{d\varphi_1}",)
    ),
    *ENCODER_VARIABLES,
    Variable(turns, "whole turns of x", within=S.Naturals0),
    Variable(nu, "number of terms of a series", within=Interval.open(0, oo)),
    Variable(E, "e**nu", within=Interval.open(0, oo)),
    Variable(T, "nu*x", ANGLE),
)
# Integrals without limits start at 0, where phi10 = phi30 = 0.
NOTATION = Notation(factors=("a",), lower_limit=S.Zero)
READER = Reader(VARIABLES, NOTATION)
