from __future__ import annotations

from typing import Any

import pytest

import mechproof
from mechproof import choice, choose

# Fast and without error, and not to be chosen.
REFUSED = ("wrong", "lossy", "in order", "in part", "enclosed")


def form(name: str, verdict: str | None = "PROVED", bound: str | None = None) -> dict[str, Any]:
    return {
        "name": name,
        "verdict": verdict,
        "bound": bound,
        "ordered": name == "in order",
        "proved_on": "here" if name == "in part" else None,
    }


def errors(**worst: float) -> dict[str, Any]:
    names = {"fine": 1e-15, "coarse": 1e-3} | dict.fromkeys(REFUSED, 0.0) | worst
    found = {n: {"worst": w, "bound": None, "lost": int(n == "lossy")} for n, w in names.items()}
    found["coarse"]["bound"] = 2 * names["coarse"]
    return found


def timed(form: str, workload: str, count: int, median: float) -> dict[str, Any]:
    quartiles = {"lower": 0.95 * median, "upper": 1.05 * median}
    return {
        "form": form,
        "workload": workload,
        "count": count,
        "rounds": 3,
        "median": median,
        **quartiles,
    }


TIMES = {"fine": 10.0, "coarse": 2.0} | dict.fromkeys(REFUSED, 1.0)
RECORD = {
    "quantity": "gear.angle",
    "unit": "rad",
    "forms": [form("fine"), form("coarse", bound="e"), form("wrong", "REFUTED"), form("lossy"),
              form("in order"), form("in part"), form("enclosed", "ENCLOSED")],
    "ranges": {"phi": [0.0, 5.0], "e": [0.0, 0.9], "z": [4.0, 9.0]},
    "boxes": [
        {"box": {"e": [0.0, 0.5], "z": [4.0, 9.0]}, "errors": errors()},
        {"box": {"e": [0.5, 0.9], "z": [4.0, 9.0]}, "errors": errors(coarse=0.2, fine=3e-15)},
    ],
    "times": [
        timed(n, "w", count, t * scale)
        for n, t in TIMES.items()
        for count, scale in ((1000, 3.0), (100_000, 1.0))
    ],
}  # fmt: skip


@pytest.fixture
def records(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(choice, "_records", lambda: {"gear.angle": RECORD})


@pytest.mark.usefixtures("records")
class TestDecision:
    def test_cheapest_that_meets_the_request(self) -> None:
        chosen = choose("angle", error=0.01, e=(0, 0.5))
        # The proved bound is larger than what was measured, so it counts.
        assert (chosen.form, chosen.error, chosen.bound) == ("coarse", 2e-3, 2e-3)
        assert chosen.better is not None
        assert (chosen.better.form, chosen.better.time) == ("fine", 10.0)
        assert str(chosen) == (
            "gear.angle: coarse, error 0.002 rad (proved bound), 2 ns per point; the next "
            "better: fine, error 1e-15 rad (measured), 10 ns per point."
        )

    def test_a_wider_range_needs_more(self) -> None:
        chosen = choose("gear.angle", error=0.01)
        assert (chosen.form, chosen.error) == ("fine", 3e-15)
        assert str(chosen).endswith("nothing measured has half the error.")

    def test_the_others_are_explained(self) -> None:
        exact = choose("angle", error=1e-9, e=(0, 0.5))
        assert [other.form for other in exact.others] == ["coarse"]
        assert exact.explain().splitlines()[1:] == [
            "not coarse, error 0.002 rad (proved bound), 2 ns per point: not accurate enough"
        ]
        rough = choose("angle", error=0.01, e=(0, 0.5))
        assert rough.explain().splitlines()[1:] == [
            "not fine, error 1e-15 rad (measured), 10 ns per point: 5 times the time"
        ]

    def test_an_edge_belongs_to_the_box_below(self) -> None:
        assert choose("angle", error=0.01, e=0.5).form == "coarse"
        assert choose("angle", error=0.01, e=0.51).form == "fine"
        assert choose("angle", error=0.01, e=0).form == "coarse"
        assert choose("angle", error=0.01, e=0.2, z=4).form == "coarse"
        assert choose("angle", error=0.01, e=[0, 0.2], z=9).form == "coarse"

    def test_the_time_is_that_of_the_nearest_size(self) -> None:
        assert choose("angle", error=1e-9, size=500).time == 30.0
        assert choose("angle", error=1e-9, size=500).count == 1000

    def test_the_most_expensive_workload_counts(self, monkeypatch: pytest.MonkeyPatch) -> None:
        other = timed("coarse", "v", 100_000, 20.0)
        slower = {**RECORD, "times": [*RECORD["times"], other]}
        monkeypatch.setattr(choice, "_records", lambda: {"gear.angle": slower})
        chosen = choose("angle", error=0.01, e=(0, 0.5))
        assert (chosen.form, chosen.better) == ("fine", None)

    def test_of_forms_as_fast_the_most_accurate(self, monkeypatch: pytest.MonkeyPatch) -> None:
        rows = [timed("coarse", "w", 100_000, 9.8), timed("fine", "w", 100_000, 10.0)]
        monkeypatch.setattr(choice, "_records", lambda: {"gear.angle": {**RECORD, "times": rows}})
        chosen = choose("angle", error=0.01, e=(0, 0.5))
        assert chosen.form == "fine"
        assert "not told apart in time" in chosen.explain()
        rows[0] = timed("coarse", "w", 100_000, 8.0)
        assert choose("angle", error=0.01, e=(0, 0.5)).form == "coarse"

    def test_nothing_qualifies(self) -> None:
        with pytest.raises(ValueError, match=r"reaches it; gear\.angle: fine, error 3e-15 rad"):
            choose("angle", error=1e-16)

    @pytest.mark.parametrize(
        ("arguments", "says"),
        [
            ({"quantity": "speed", "error": 1.0}, "quantity = 'speed': .*gear.angle"),
            ({"error": 0.0}, "error = 0.0: must be positive"),
            ({"error": float("nan")}, "error = nan"),
            ({"error": 1.0, "k": 2.0}, "k = 2.0: .*arguments phi, e, z"),
            ({"error": 1.0, "size": 0}, "size = 0: must be at least 1"),
            (
                {"error": 1.0, "e": (0.1, 0.2, 0.3)},
                r"e = \(0.1, 0.2, 0.3\): must be a size, or two",
            ),
            ({"error": 1.0, "e": (0.5, 0.1)}, r"e = \(0.5, 0.1\)"),
            ({"error": 1.0, "phi": (0.0, 7.0)}, "phi = .*from 0.0 to 5.0"),
        ],
    )
    def test_bad_requests(self, arguments: dict[str, Any], says: str) -> None:
        with pytest.raises(ValueError, match=says):
            choose(**{"quantity": "angle", **arguments})


def test_first_order_for_a_milliradian_and_a_micrometre() -> None:
    chosen = choose("displacement", error=1e-3, points=(0, 50), angles=(0, 1e-3), shift=(0, 1))
    assert chosen.form == "first order"
    assert chosen.bound == chosen.error <= 1e-3


def test_every_digit_needs_the_exact_form() -> None:
    chosen = choose("displacement", error=1e-13, points=(0, 50), angles=(0, 1e-3))
    assert chosen.form != "first order"
    # A share of 1e-12 to twelve digits: no simulation.
    assert "simulation" not in choose("wrongly_accepted", error=1e-6).form


@pytest.mark.parametrize("share", ["wrongly_accepted", "wrongly_rejected"])
def test_shares_are_computed_and_not_simulated(share: str) -> None:
    """A simulation that reaches a thousandth costs more than every digit."""
    chosen = choose(share, error=1e-3)
    assert "simulation" not in chosen.form
    assert chosen.error < 1e-12
    (simulated,) = (o for o in chosen.others if o.form == "simulation, 1e+06 parts")
    assert simulated.error <= 1e-3
    # Each part takes two normal numbers; the sum of a million goes into one share.
    assert simulated.time > 1000 * chosen.time
    assert f"not {simulated._describe()}" in chosen.explain()
    assert "times the time" in chosen.explain()


def test_the_lazy_entry() -> None:
    assert mechproof.choose is choose
