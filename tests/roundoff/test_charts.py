"""Charts cover what claims say, and the worst inputs lie there."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from certified import GROUP, claims, name_claim, subjects

from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import input_names
from mechproof.record import Chart
from mechproof.roundoff.certificate import (
    RoundingClaim,
)
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.running import IN_DOUBLES

pytestmark = pytest.mark.xdist_group(GROUP)


def find_covered(
    subject: ComputedStage, charts: Sequence[Chart], given: Mapping[str, Array]
) -> Array:
    """Say which points are in a chart: `x` as drawn, or what is left of it, and `d` for 1 - e."""
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
            # By a few roundings of numbers of the size of pi.
            inside &= (value >= low * (1 - 1e-9) - 1e-15) & (value <= high * (1 + 1e-9))
        covered |= inside
    return covered


HALF = "|x| <= 22/7"
FAR = "|x| <= 2**26 and e <= 1 - 2**-10"
OFF = "|x| <= 22/7 and |pi - |x|| >= 2**-40"


PLAIN = "|x| <= 2**26"
TURNED = "|alpha|, |beta|, |gamma| <= "
RACK, TILTED = "alpha <= 11/14", "|tilt| <= 1 and alpha <= 11/14"
# The same of the size of x and of e, of the largest size of an angle, and of alpha and the tilt.
STATED: Mapping[str, Callable[[Fraction, Fraction], bool]] = {
    HALF: lambda x, e: x <= Fraction(22, 7),
    FAR: lambda x, e: x <= 2**26 and e <= 1 - Fraction(1, 2**10),
    OFF: lambda x, e: x <= Fraction(22, 7) and abs(Fraction(math.pi) - x) >= Fraction(1, 2**40),
    PLAIN: lambda x, e: x <= 2**26,
    **{
        f"{TURNED}{reach}": lambda x, e, most=Fraction(reach): x <= most
        for reach in ("11/7", "22/7")
    },
    RACK: lambda alpha, tilt: alpha <= Fraction(11, 14),
    TILTED: lambda alpha, tilt: alpha <= Fraction(11, 14) and abs(tilt) <= 1,
}


@pytest.mark.parametrize("claim", claims(), ids=name_claim)
def test_the_worst_inputs_are_where_the_claims_say(claim: RoundingClaim) -> None:
    at = {name: Fraction(float.fromhex(text)) for name, text in claim.at.items()}
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
        (("position", "half-angle atan with low word"), HALF, 0.5),
        (("ratio", "half-angle quotient with low word"), HALF, 0.0),
        (("position", "half-angle atan with low word"), FAR, 0.5),
        (("ratio", "half-angle quotient with low word"), FAR, 0.0),
        (("acceleration", "half-angle quotient with low word"), OFF, 0.0),
    ],
)
def test_charts_cover_what_they_say(key: tuple[str, str], text: str, lowest: float) -> None:
    """Every angle that is told and every eccentricity has coordinates in some chart."""
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
    """All profile angles, sizes of any order and signs have coordinates in some chart."""
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
