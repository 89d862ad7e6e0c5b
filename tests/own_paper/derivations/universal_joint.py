"""Universal joint: position, ratio and acceleration of the driven shaft; one formula misprinted."""

from sympy import Eq, Interval, Matrix, Rational, S, Symbol, atan2, cos, diff, pi, sin, solve

from mechproof.record import (
    Accuracy,
    Argument,
    Conjunction,
    Correction,
    Equality,
    Equation,
    Form,
    Paper,
    PublishedSizes,
    Quantity,
    Singular,
    Variable,
)

theta, beta = (Symbol(name, real=True) for name in ("theta", "beta"))
turns = Symbol("m", integer=True)

# The mechanics. The pins of the cross are perpendicular; each is perpendicular to its own shaft.
driving_pin = Matrix([0, cos(theta), sin(theta)])
across, upward = Matrix([-sin(beta), cos(beta), 0]), Matrix([0, 0, 1])
tangent = Symbol("t", real=True)
(tangent_of_phi,) = solve((upward - tangent * across).dot(driving_pin), tangent)
slope = diff(tangent_of_phi, theta) / (1 + tangent_of_phi**2)

POSITION = theta + atan2(
    (1 - cos(beta)) * sin(theta) * cos(theta), cos(beta) * cos(theta) ** 2 + sin(theta) ** 2
)
BELOW = 1 - sin(beta) ** 2 * cos(theta) ** 2
RATIO = cos(beta) / BELOW
ACCELERATION = -cos(beta) * sin(beta) ** 2 * sin(2 * theta) / BELOW**2
PRINTED = cos(beta) / (1 - sin(beta) ** 2 * sin(theta) ** 2)
STABLE = cos(theta) ** 2 * cos(beta) ** 2 + sin(theta) ** 2

ANGLES = (
    Argument("theta", (theta,), "angle of the driving shaft", "rad", usual=(0, 10, 1000)),
    Argument("beta", (beta,), "angle between the shafts", "rad", usual=(0, 0.5, 1.5)),
)
SINGULAR = (
    Singular(Eq(theta, pi * turns)),
    Singular(Eq(theta, pi / 2 + pi * turns)),
    Singular(Eq(beta, pi / 2)),
    Singular(Eq(beta, 0)),
)
SOURCE = "a textbook's chapter on universal joints"

PAPER = Paper(
    system="universal_joint",
    citation="A textbook with a misprint",
    variables=(
        Variable(theta, "angle of the driving shaft"),
        Variable(beta, "angle between the shafts", within=Interval.Ropen(0, pi / 2)),
    ),
    rows=(
        Equation(
            "(1)", r"\varphi'=\frac{\cos\beta}{1-\sin^2\beta\cos^2\theta}", Equality(RATIO, slope)
        ),
        Equation(
            "(2)",
            r"\varphi'=\frac{\cos\beta}{1-\sin^2\beta\sin^2\theta}",
            Equality(PRINTED, slope),
            corrected=Correction(
                r"\frac{\cos\beta}{1-\sin^2\beta\cos^2\theta}", Equality(RATIO, slope)
            ),
        ),
        Equation(
            "(3)",
            r"\varphi=\theta+\mathrm{arctg}\frac{(1-\cos\beta)\sin\theta\cos\theta}"
            r"{\cos\beta\cos^2\theta+\sin^2\theta}",
            Conjunction(
                (Equality(diff(POSITION, theta), slope), Equality(POSITION.subs(theta, 0), S.Zero))
            ),
        ),
    ),
    quantities=(
        Quantity(
            "position",
            "Compute the angle of the driven shaft, over any number of turns.",
            ANGLES,
            POSITION,
            (
                Form(
                    "half angle of the shafts",
                    theta
                    + atan2(
                        2 * sin(beta / 2) ** 2 * sin(theta) * cos(theta),
                        cos(beta) * cos(theta) ** 2 + sin(theta) ** 2,
                    ),
                ),
                Form("as defined", POSITION, key="direct"),
            ),
            SOURCE,
            unit="rad",
            accuracy=Accuracy(8, within=(abs(theta) <= 1000, abs(theta) >= Rational(1, 10**290))),
            singular=SINGULAR,
            period=pi,
        ),
        Quantity(
            "ratio",
            "Compute the ratio of the shafts' angular velocities.",
            ANGLES,
            RATIO,
            (
                Form("sum of squares", cos(beta) / STABLE),
                Form("difference", RATIO, key="direct"),
                Form("misprinted (2)", PRINTED, key="printed", source=f"{SOURCE}, equation (2)"),
            ),
            SOURCE,
            singular=SINGULAR,
        ),
        Quantity(
            "acceleration",
            "Compute the derivative of the ratio by the angle of the driving shaft.",
            ANGLES,
            ACCELERATION,
            (Form("sum of squares", -cos(beta) * sin(beta) ** 2 * sin(2 * theta) / STABLE**2),),
            SOURCE,
            singular=SINGULAR,
        ),
    ),
    published=(PublishedSizes("example 1", {beta: pi / 6}),),
)
