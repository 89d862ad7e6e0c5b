"""Four-bar linkage: the rocker's angle in both branches of its assembly, and its velocity ratio."""

from sympy import FiniteSet, Interval, Symbol, acos, atan2, cos, diff, oo, pi, sin, sqrt

from mechproof.record import (
    LENGTH,
    Argument,
    Correction,
    Equation,
    Form,
    Paper,
    PublishedSizes,
    Quantity,
    Variable,
)

theta, sigma = Symbol("theta", real=True), Symbol("sigma", real=True)
phi, ratio = Symbol("phi", real=True), Symbol("phi_prime", real=True)
a, b, c, d = (Symbol(name, positive=True) for name in "abcd")
positive = Interval.open(0, oo)

# The mechanics. From the rocker's pivot to the crank pin it is the diagonal; the rocker lies beside
# it by the angle that the triangle of diagonal, rocker and coupler has there.
DIAGONAL = sqrt(a**2 + d**2 - 2 * a * d * cos(theta))
COSINE = (DIAGONAL**2 + c**2 - b**2) / (2 * c * DIAGONAL)
ROCKER = pi - atan2(a * sin(theta), d - a * cos(theta)) - sigma * acos(COSINE)
# The loop a + b = d + c, of which the coupler is as long as it is.
CLOSURE = (d + c * cos(phi) - a * cos(theta)) ** 2 + (c * sin(phi) - a * sin(theta)) ** 2 - b**2
RATIO = -diff(CLOSURE, theta) / diff(CLOSURE, phi)
SHORT = a * (d * sin(theta) + c * sin(theta - phi)) / (c * (d * sin(phi) + a * sin(theta - phi)))

FREUDENSTEIN = r"\frac da\cos\varphi-\frac dc\cos\theta+\frac{a^2%sb^2+c^2+d^2}{2ac}"
FREUDENSTEIN += r"-\cos(\theta-\varphi)=0"
VELOCITY = r"\varphi'=\frac{a\left[d\sin\theta+c\sin(\theta-\varphi)\right]}"
VELOCITY += r"{c\left[d\sin\varphi+a\sin(\theta-\varphi)\right]}"

SIZES = tuple(
    Argument(str(s), (s,), meaning, "mm", usual=(1, 1000))
    for s, meaning in ((a, "crank"), (b, "coupler"), (c, "rocker"), (d, "frame"))
)
CRANK = Argument("theta", (theta,), "angle of the crank", "rad", usual=(0, 10, 1000))
OUTPUT = Argument("phi", (phi,), "angle of the rocker", "rad", usual=(0, 10, 1000))
BRANCH = Argument("sigma", (sigma,), "branch of the assembly, 1 or -1")
SOURCE = "a textbook's chapter on four-bar linkages"

PAPER = Paper(
    system="four_bar",
    citation="A textbook's four-bar linkage, with a misprint",
    variables=(
        Variable(theta, "angle of the crank", latex=(r"\theta",)),
        Variable(phi, "angle of the rocker", latex=(r"\varphi",)),
        Variable(ratio, "ratio of the angular velocities", latex=(r"\varphi'",)),
        Variable(sigma, "branch of the assembly", within=FiniteSet(-1, 1), latex=(r"\sigma",)),
        Variable(a, "crank", LENGTH, positive, latex=("a",)),
        Variable(b, "coupler", LENGTH, positive, latex=("b",)),
        Variable(c, "rocker", LENGTH, positive, latex=("c",)),
        Variable(d, "frame", LENGTH, positive, latex=("d",)),
    ),
    # The crank turns round: it is the shortest, and with the longest shorter than the others.
    where=(a + d < b + c, a + b < c + d, a + c < b + d),
    rows=(
        Equation(
            "(1)",
            FREUDENSTEIN % "-",
            residual=CLOSURE / (2 * a * c),
        ),
        Equation(
            "(2)",
            FREUDENSTEIN % "+",
            residual=CLOSURE / (2 * a * c),
            corrected=Correction(FREUDENSTEIN % "-"),
        ),
        Equation("(3)", VELOCITY, derived={ratio: RATIO}),
    ),
    quantities=(
        Quantity(
            "rocker",
            "Compute the angle of the rocker.",
            (CRANK, *SIZES, BRANCH),
            ROCKER,
            (Form("diagonal", ROCKER),),
            SOURCE,
            unit="rad",
        ),
        Quantity(
            "velocity_ratio",
            "Compute the ratio of the angular velocities of rocker and crank.",
            (CRANK, OUTPUT, SIZES[0], *SIZES[2:]),
            RATIO,
            (Form("equation (3)", SHORT),),
            SOURCE,
        ),
    ),
    published=(PublishedSizes("example 1", {a: 40, b: 120, c: 80, d: 100}),),
)
