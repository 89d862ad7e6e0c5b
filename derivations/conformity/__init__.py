"""Shares of rightly and wrongly accepted and rejected parts by JCGM 106, for two normal laws.

The definitions integrate over the finite window: the density of the true deviation times the
probability of acceptance or rejection, or the density of the measured deviation times the
probability of nonconformity given that; the fourth share is the rest of the nonconforming parts.
"""

from sympy import Expr, Integral, Le, Max, Min, Or, S, exp, pi, sqrt, symbols

from mechproof.record import *

from .._metrology import POSITIVE, normal_between, normal_outside

mu, bias, low, high, m, y = symbols("mu b L U m y", real=True)
sigma, s = symbols("sigma s", positive=True)

ARGUMENTS = (
    Argument("mean", (mu,), "mean of the true deviation", "mm"),
    Argument(
        "true_std", (sigma,), "standard deviation of the true deviation", "mm", usual=(0.01, 1)
    ),
    Argument("bias", (bias,), "mean of the measurement error", "mm"),
    Argument(
        "error_std",
        (s,),
        "standard deviation of the measurement error",
        "mm",
        usual=(0.001, 0.1, 1),
    ),
    Argument("low", (low,), "lower limit of tolerance and acceptance", "mm"),
    Argument("high", (high,), "upper limit of tolerance and acceptance", "mm"),
)
VARIABLES = (
    *(
        Variable(symbol, argument.meaning, LENGTH, POSITIVE if symbol.is_positive else S.Reals)
        for argument in ARGUMENTS
        for symbol in argument.symbols
    ),
    Variable(y, "true deviation", LENGTH),
    Variable(m, "measured deviation", LENGTH),
)

# The measured deviation is normal, and so is the true deviation given the measured one.
MEASURED, VARIANCE = mu + bias, sigma**2 + s**2
GIVEN_MEAN = mu + sigma**2 / VARIANCE * (m - MEASURED)
GIVEN_VARIANCE = sigma**2 * s**2 / VARIANCE


def beyond(at: Expr) -> Expr:
    """How far a mean lies outside the limits, 0 inside."""
    return Max(0, low - at, at - high)


def within(at: Expr) -> Expr:
    """How far a mean lies inside the limits, 0 outside."""
    return Max(0, Min(at - low, high - at))


def over_window(centre: Expr, variance: Expr, chance: Expr, distances: tuple[Expr, Expr]) -> Expr:
    """Integrate a normal density times a probability over the window.

    A ball integral has an absolute tolerance: exp(-exponent), which no share of parts at these
    distances of the true and of the measured deviation from their means exceeds, is taken out as a
    factor.
    """
    (true, measured), z = distances, m - centre
    exponent = Max(true**2 / sigma**2, measured**2 / VARIANCE) / 2
    scaled = exp(exponent - z**2 / (2 * variance)) / sqrt(2 * pi * variance)
    return exp(-exponent) * Integral(scaled * chance, (m, low, high))


WRONGLY_ACCEPTED = over_window(
    MEASURED,
    VARIANCE,
    normal_outside(GIVEN_MEAN, GIVEN_VARIANCE, low, high),
    (within(mu), beyond(MEASURED)),
)
DEFINITIONS = {
    "rightly_accepted": over_window(
        mu, sigma**2, normal_between(m + bias, s**2, low, high), (beyond(mu), beyond(MEASURED))
    ),
    "wrongly_accepted": WRONGLY_ACCEPTED,
    "rightly_rejected": normal_outside(mu, sigma**2, low, high) - WRONGLY_ACCEPTED,
    "wrongly_rejected": over_window(
        mu, sigma**2, normal_outside(m + bias, s**2, low, high), (beyond(mu), within(MEASURED))
    ),
}

# Shares of the parts between the limits.
CONFORMING = ("rightly_accepted", "wrongly_rejected")

# The relative error; shares whose likeliest part lies beyond this many nats (1e-200) underflow.
RELATIVE = 1e-12
MOST_NATS = 460
FAR = f"the density of the likeliest part of the share is at least exp(-{MOST_NATS}) of its peak"
CALL = """\
from mechproof.conformity import Normal, shares

shares(Normal(mean, true_std), Normal(bias, error_std), (low, high)).{}"""


def clip(at: Expr) -> Expr:
    """Return the place between the limits that is nearest to `at`."""
    return Max(low, Min(at, high))


def far_from_underflow(name: str) -> Or:
    """State that the likeliest part of a share is within MOST_NATS nats."""
    true = (low, high, clip(mu)) if name in CONFORMING else (Min(mu, low), Max(mu, high))
    places = []
    for at in true:
        near = at + bias
        accepted = name.endswith("accepted")
        measured = (clip(near),) if accepted else (Min(near, low), Max(near, high))
        places += [((at - mu) / sigma, (other - near) / s) for other in measured]
    return Or(*(Le((one**2 + other**2) / 2, MOST_NATS) for one, other in places))


def share(name: str, definition: Expr) -> Quantity:
    """Return one of the four shares as a quantity."""
    return Quantity(
        name,
        f"Compute the share of the {name.replace('_', ' ')} parts, for two normal laws.",
        ARGUMENTS,
        definition,
        (),
        "JCGM 106:2012, 9.5",
        accuracy=Accuracy(RELATIVE * 2**52, within=(far_from_underflow(name),), where=FAR),
        call=CALL.format(name),
    )


ROWS = (
    ours(
        "true deviation, given what is measured",
        r"f(y)\,f(m\mid y)=f(m)\,f(y\mid m)",
        all_of(
            Equality(
                (y - mu) ** 2 / sigma**2 + (m - y - bias) ** 2 / s**2,
                (m - MEASURED) ** 2 / VARIANCE + (y - GIVEN_MEAN) ** 2 / GIVEN_VARIANCE,
            ),
            Equality(sigma**2 * s**2, VARIANCE * GIVEN_VARIANCE),
        ),
        note="Exponents and variances of the normal laws; by it a share of parts is an integral "
        "over the measured deviation as well.",
        quantities=tuple(DEFINITIONS),
    ),
)

PAPER = Paper(
    system="conformity",
    citation="JCGM 106:2012",
    variables=VARIABLES,
    rows=ROWS,
    where=(low < high,),
    quantities=tuple(share(name, definition) for name, definition in DEFINITIONS.items()),
)
