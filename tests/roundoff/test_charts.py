"""Charts cover the places that claims state, and the worst inputs lie there."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, claims, name_claim, subjects
from derived import paper_of

from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import input_names
from mechproof.record import Chart
from mechproof.roundoff.certificate import RoundingClaim
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.running import IN_DOUBLES

pytestmark = pytest.mark.xdist_group(GROUP)


def find_covered(
    subject: ComputedStage, charts: Sequence[Chart], given: Mapping[str, Array]
) -> Array:
    """Return which points lie in a chart: `x` as drawn or its rest, and `d` for 1 - e."""
    names = input_names(subject.kernel.quantity)
    symbols = {name: sp.Symbol(f"drawn {name}") for name in ("1/k", "x", "d")}
    covered = np.zeros(len(given["x"]), bool)
    for chart in charts:
        told = {names[s]: v for s, v in chart.arguments.items()}
        x = told["phi1"] * told["R1"] / told["R2"] if chart.rest is None else chart.rest
        found = {"1/k": told["R2"] / told["R1"], "x": x, "d": 1 - told["e"]}
        unknown = [s for s in chart.within if s != chart.angle and str(s) != "R"]
        equations = [sp.expand(sp.cancel(found[n])) - symbols[n] for n in found]
        (solved,) = sp.solve(equations, unknown, dict=True)
        inside = np.ones(len(covered), bool)
        for coordinate in unknown:
            compute = sp.lambdify(list(symbols.values()), solved[coordinate])
            value = compute(*(given[name] for name in symbols))
            low, high = (
                float(end) for end in (chart.within[coordinate].inf, chart.within[coordinate].sup)
            )
            # Up to a few roundings of numbers of the size of pi.
            inside &= (value >= low * (1 - 1e-9) - 1e-15) & (value <= high * (1 + 1e-9))
        covered |= inside
    return covered


HALF = "|x| <= 22/7"
FAR = "|x| <= 2**26 and (e <= 1 - 2**-10 or |x - 2*pi*n| >= 2**-7 for all n)"
OFF = "|x| <= 22/7 and |pi - |x|| >= 2**-40"


PLAIN = "|x| <= 2**26"
TURNED = "|alpha|, |beta|, |gamma| <= "
RACK, TILTED = "alpha <= 11/14", "|tilt| <= 1 and alpha <= 11/14"
LIMITS = (
    "the sizes are within the limits (at least 0.1 %) of the set reconstructed with l_BC = 49.75, "
    "l_CD = 38, l_DE = 83"
)


@cache
def list_limits() -> dict[str, tuple[float, float]]:
    """Return the limits of the linkage's first sizes, at least 0.1 % from the nominal ones."""
    sizes = paper_of("wedge_linkage").published[0].sizes
    return {
        str(symbol): (
            float(min(size.nominal + size.lower, size.nominal * Fraction(999, 1000))),
            float(max(size.nominal + size.upper, size.nominal * Fraction(1001, 1000))),
        )
        for symbol, size in sizes.items()
    }


def are_within_limits(at: Mapping[str, Fraction]) -> bool:
    return all(low <= at[name] <= high for name, (low, high) in list_limits().items())


# Stated places as conditions on all arguments; those of the oval wheels include x.
PLACES: Mapping[str, Callable[[Mapping[str, Fraction]], bool]] = {
    "|A| <= 63/64*R and z*|phi| <= 21": lambda at: (
        64 * abs(at["A"]) <= 63 * at["R"] and at["z"] * abs(at["phi"]) <= 21
    ),
    "|A| <= 15/16*R and z*|phi| <= 22/7": lambda at: (
        16 * abs(at["A"]) <= 15 * at["R"] and at["z"] * abs(at["phi"]) <= Fraction(22, 7)
    ),
    "e <= 101/1000 or e >= 102/1000": lambda at: not 0.101 < at["e"] < 0.102,
    f"-37 mm <= x1 <= 0, and {LIMITS}": lambda at: -37 <= at["x1"] <= 0 and are_within_limits(at),
    f"-37 mm <= x1 <= -2 mm or -3/4 mm <= x1 <= 0, and {LIMITS}": lambda at: (
        (-37 <= at["x1"] <= -2 or Fraction(-3, 4) <= at["x1"] <= 0) and are_within_limits(at)
    ),
    "alpha_KL <= 22/7": lambda at: at["alpha_KL"] <= Fraction(22, 7),
    "x1 >= -l_BC*min(1, l_BC/(l_AB + l_CD))/4": lambda at: (
        at["x1"] >= -at["l_BC"] * min(1, at["l_BC"] / (at["l_AB"] + at["l_CD"])) / 4
    ),
    "-alpha_KL**2*l_KL/10 <= x5 <= l_KL/4 and alpha_KL <= 2": lambda at: (
        -(at["alpha_KL"] ** 2) * at["l_KL"] / 10 <= at["x5"] <= at["l_KL"] / 4
        and at["alpha_KL"] <= 2
    ),
    "l_KL/4 <= x5 <= l_KL and alpha_KL <= 5/4": lambda at: (
        at["l_KL"] / 4 <= at["x5"] <= at["l_KL"] and at["alpha_KL"] <= Fraction(5, 4)
    ),
    "|phi3| <= 22/7 and 1/8 <= alpha_DE <= 44/7": lambda at: (
        abs(at["phi3"]) <= Fraction(22, 7) and Fraction(1, 8) <= at["alpha_DE"] <= Fraction(44, 7)
    ),
    "|phi7| <= 22/7 and 0 <= alpha_LM <= 44/7": lambda at: (
        abs(at["phi7"]) <= Fraction(22, 7) and 0 <= at["alpha_LM"] <= Fraction(44, 7)
    ),
    "1/4 <= alpha <= 11/14 and |dh| <= 3/16*m": lambda at: (
        Fraction(1, 4) <= at["alpha"] <= Fraction(11, 14)
        and abs(at["dh"]) <= Fraction(3, 16) * at["m"]
    ),
    **{
        f"mount = 0, |phi1| <= 3/2 and e1, e2 <= {reach}": lambda at, most=Fraction(reach): (
            at["mount"] == 0
            and abs(at["phi1"]) <= Fraction(3, 2)
            and max(at["e1"], at["e2"]) <= most
        )
        for reach in ("1/2", "1/4")
    },
    "n <= 2**20": lambda at: True,
    "n <= 2**20 and thermal_share*thermal_scatter <= (1 - 2**-20)*total_scatter": lambda at: (
        at["thermal_share"] * at["thermal_scatter"]
        <= (1 - Fraction(1, 2**20)) * at["total_scatter"]
    ),
    "error - offset <= 15/16*(rho + H)": lambda at: (
        at["error"] - at["offset"] <= Fraction(15, 16) * (at["rho"] + at["H"])
    ),
    "offset <= H and error - offset <= rho + H": lambda at: (
        at["offset"] <= at["H"] and at["error"] - at["offset"] <= at["rho"] + at["H"]
    ),
    "|x| <= 3 and e2 <= 1/2": lambda at: at["x"] <= 3 and at["e2"] <= Fraction(1, 2),
    "|x| <= 22/7": lambda at: at["x"] <= Fraction(22, 7),
    "|x| <= 22/7 and |pi - |x|| >= 2**-40": lambda at: (
        at["x"] <= Fraction(22, 7) and abs(Fraction(math.pi) - at["x"]) >= Fraction(1, 2**40)
    ),
}
# Stated places as conditions on |x| and e, on the largest |angle|, or on alpha and the tilt.
STATED: Mapping[str, Callable[[Fraction, Fraction], bool]] = {
    HALF: lambda x, e: x <= Fraction(22, 7),
    FAR: lambda x, e: (
        x <= 2**26 and (e <= 1 - Fraction(1, 2**10) or abs(math.remainder(x, 2 * math.pi)) >= 2**-7)
    ),
    OFF: lambda x, e: x <= Fraction(22, 7) and abs(Fraction(math.pi) - x) >= Fraction(1, 2**40),
    PLAIN: lambda x, e: x <= 2**26,
    **{
        f"{TURNED}{reach}": lambda x, e, most=Fraction(reach): x <= most
        for reach in ("11/7", "22/7")
    },
    RACK: lambda alpha, tilt: alpha <= Fraction(11, 14),
    TILTED: lambda alpha, tilt: alpha <= Fraction(11, 14) and abs(tilt) <= 1,
}


def describe_x(at: dict[str, Fraction]) -> None:
    """Add |x|, the size of the reduced angle, to the arguments of wheels that have one."""
    if "R4" in at:
        at["x"] = abs(2 * at["phi1"] * at["R4"] / at["R5"])
    if "R1" in at and "phi1" in at:
        at["x"] = abs(at["phi1"] * at["R1"] / at["R2"])


@pytest.mark.parametrize("claim", claims(), ids=name_claim)
def test_the_worst_inputs_are_where_the_claims_say(claim: RoundingClaim) -> None:
    if not claim.where:
        return
    at = {name: Fraction(float.fromhex(text)) for name, text in claim.at.items()}
    if set(claim.where) <= PLACES.keys() and not {"e", "phi1"} <= at.keys():
        describe_x(at)
        assert any(PLACES[text](at) for text in claim.where)
        return
    if "e" in at:
        place = abs(at["phi1"] * at["R1"] / at["R2"]), at["e"]
    elif "gamma" in at:
        place = max(abs(at[str(angle)]) for angle in ("alpha", "beta", "gamma")), Fraction(0)
    else:
        place = at["alpha"], at.get("tilt", Fraction(0))
    assert any(STATED[text](*place) for text in claim.where)


def draw_small(rng: np.random.Generator, reach: float, decades: float) -> Array:
    return reach * 10.0 ** -(rng.uniform(0, decades**0.75, 4000) ** (4 / 3))


@pytest.mark.parametrize(
    ("key", "text", "lowest"),
    [
        (("position", "half-angle atan with low word"), HALF, 0.0),
        (("ratio", "half-angle quotient with low word"), HALF, 0.0),
        (("position", "half-angle atan with low word"), FAR, 0.0),
        (("ratio", "half-angle quotient with low word"), FAR, 0.0),
        (("acceleration", "half-angle quotient with low word"), OFF, 0.0),
    ],
)
def test_charts_cover_what_they_say(key: tuple[str, str], text: str, lowest: float) -> None:
    """Every stated angle and every eccentricity has coordinates in some chart."""
    subject = next(s for s in subjects().values() if (s.kernel.name, s.form.name) == key)
    charts = [chart for chart in subject.form.charts if chart.text == text]
    rng = np.random.default_rng(11)
    x = draw_small(rng, 22 / 7, 12)
    d = (1 - lowest) * draw_small(rng, 1, 12)
    if text == FAR:
        x, d = x * rng.choice((-1.0, 1.0), 4000), np.maximum(d, 2.0**-10)
    if text == OFF:
        near = np.pi + rng.choice((-1.0, 1.0), 4000) * np.maximum(
            draw_small(rng, 1e-3, 9), 2.0**-40
        )
        x = np.where(rng.integers(0, 2, 4000) == 1, x, near)
    given = {"1/k": rng.uniform(0, 1, 4000), "x": x, "d": d}
    assert find_covered(subject, charts, given).all()
    missing = [chart for chart in charts if chart is not charts[-1]]
    assert not find_covered(subject, missing, given).all()


@pytest.mark.parametrize(
    "name",
    [
        *("constant_chord", "chord_height", "thickness_change_linear", "thickness_error"),
        *("height_change", "thickness_change"),
    ],
)
def test_charts_cover_all_wheels_and_flanks(name: str) -> None:
    """All profile angles, and values of any size and sign, have coordinates in some chart."""
    subject = next(s for s in subjects().values() if s.kernel.name == name)
    rng = np.random.default_rng(13)
    given = {
        "alpha": draw_small(rng, np.pi / 4, 12),
        "m": draw_small(rng, 1e6, 12),
        "z": np.rint(1 / draw_small(rng, 1, 6)),
        **{
            argument: rng.choice((-1.0, 1.0), 4000) * draw_small(rng, 1, 12)
            for argument in ("tilt", "dh", "e_tip", "height_error")
        },
    }
    points = {argument: given[argument] for argument in subject.straight.inputs}
    form = subject.form
    assert subject.inside.holds(points, IN_DOUBLES).all()
    if len(form.charts) > 1:
        missing = replace(subject, form=replace(form, charts=form.charts[1:]))
        assert not missing.inside.holds(points, IN_DOUBLES).all()


def draw_arguments(names: Sequence[str], rng: np.random.Generator) -> dict[str, Array]:
    """Draw lengths of any order, angles, ratios, and eccentricities near 0, near 1 and between."""
    drawn: dict[str, Array] = {}
    for name in names:
        size = draw_small(rng, 1, 6)
        if name.startswith("alpha"):
            drawn[name] = np.where(rng.random(4000) < 0.5, size, rng.uniform(0, 44 / 7, 4000))
        elif name.startswith("phi"):
            drawn[name] = rng.choice((-1.0, 1.0), 4000) * 22 / 7 * size
        elif name == "mount":
            drawn[name] = np.where(rng.random(4000) < 0.5, 0.0, size)
        elif name in ("e", "e1", "e2"):
            drawn[name] = np.choose(rng.integers(0, 3, 4000), [size, 1 - size, rng.random(4000)])
        elif name in ("largest", "smallest", "quotient"):
            drawn[name] = 1 + np.where(rng.random(4000) < 0.5, size, 1 / size)
        else:
            drawn[name] = rng.choice((-1.0, 1.0), 4000) * size if name.startswith("x") else size
    if "R4" in drawn:
        # As large as x is stated to be, by the ratio of its wheels.
        drawn["phi1"] *= drawn["R5"] / drawn["R4"] / 2
    if "R1" in drawn and "phi1" in drawn:
        drawn["phi1"] *= drawn["R2"] / drawn["R1"]
    if {"x1", *list_limits()} <= drawn.keys():
        # The whole linkage: one in fifty of each size is beyond its limits.
        drawn["x1"] = rng.uniform(-40, 1, 4000)
        for name, (low, high) in list_limits().items():
            beyond = np.where(rng.random(4000) < 0.02, 1.5, 1.0)
            drawn[name] = rng.uniform(low, high, 4000) * beyond
    return drawn


PLACED = sorted(
    {(claim.quantity, claim.form) for claim in claims() if set(claim.where) <= PLACES.keys()}
    - {("acceleration", "half-angle quotient with low word")}
)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "form"), PLACED)
def test_charts_cover_the_places_they_say(name: str, form: str) -> None:
    """Charts contain the arguments where a stage is taken and its text holds, and only there."""
    subject = next(s for s in subjects().values() if (s.kernel.name, s.form.name) == (name, form))
    rng = np.random.default_rng(17)
    points = draw_arguments(subject.exact.inputs, rng)
    if subject.total:
        points = {**subject.total.draw(points, rng)}
    if "dh" in points:
        points["dh"] = points["dh"] * points["m"] * 3 / 16
    if "z" in points:
        points["z"] = np.rint(1 / points["z"])
    is_meant = []
    for values in zip(*points.values(), strict=True):
        at = dict(zip(points, map(Fraction, map(float, values)), strict=True))
        describe_x(at)
        is_meant.append(not subject.where or any(PLACES[text](at) for text in subject.where))
    with np.errstate(invalid="ignore"):
        held = subject.inside.holds(subject.complete(points, IN_DOUBLES), IN_DOUBLES)
    is_taken = is_meant & np.broadcast_to(subject.holds(points), len(held))
    assert np.sum(is_taken) > 200
    # At the very edges a coordinate may be rounded beyond its range.
    assert np.sum(held & is_taken) >= 0.998 * np.sum(is_taken)
    assert np.sum(held & ~np.array(is_meant)) <= 0.002 * len(held)
