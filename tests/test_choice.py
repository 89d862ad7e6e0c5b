from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import mechproof
from mechproof import choose
from mechproof.choice import EXTRAS
from mechproof.measured import (
    Cell,
    CellErrors,
    Kind,
    Machine,
    MeasuredTailoring,
    MeasuredWay,
    Record,
    Timing,
    write_record,
)
from mechproof.tools.extras import suggest_install

# Ways that are fast and without error, but must not be chosen.
REFUSED = ("wrong", "lossy", "in order", "in part", "enclosed")


WORST = {"fine": 1e-15, "coarse": 1e-3} | dict.fromkeys(REFUSED, 0.0)
TIMES = {"fine": 10.0, "coarse": 2.0} | dict.fromkeys(REFUSED, 1.0)


def way(name: str, verdict: str = "PROVED", kind: Kind = "form", bound: str = "") -> MeasuredWay:
    part = "here" if name == "in part" else ""
    return MeasuredWay(name, kind, verdict, proved_on=part, bound=bound, ordered=name == "in order")


def errors(cell: int, **worst: float) -> list[CellErrors]:
    named = WORST | worst
    bounds = {"coarse": 2 * named["coarse"]}
    return [
        CellErrors(cell, name, error, bounds.get(name), int(name == "lossy"))
        for name, error in named.items()
    ]


def timed(way: str, workload: str, count: int, median: float) -> Timing:
    return Timing(workload, way, count, 3, median, 0.95 * median, 1.05 * median, None)


RECORD = Record(
    quantity="gear.angle",
    unit="rad",
    taken="2026-01-01T00:00:00+00:00",
    quick=True,
    machine=Machine("none", 1, (), "none", "3.11", {}),
    load=None,
    seeds={},
    scale="the value",
    bound=4.0,
    typical=None,
    ranges={"phi": (0.0, 5.0), "e": (0.0, 0.9), "z": (4.0, 9.0)},
    searched=(),
    ufuncs={},
    ways=(
        way("fine"),
        way("coarse", bound="e"),
        way("wrong", "REFUTED"),
        way("lossy"),
        way("in order"),
        way("in part"),
        way("enclosed", "ENCLOSED"),
    ),
    sets=(),
    cells=(
        Cell({"e": (0.0, 0.5), "z": (4.0, 9.0)}, 9, 0),
        Cell({"e": (0.5, 0.9), "z": (4.0, 9.0)}, 9, 0),
    ),
    cell_errors=(*errors(0), *errors(1, coarse=0.2, fine=3e-15)),
    tailored=(),
    times=tuple(
        timed(name, "w", count, time * scale)
        for name, time in TIMES.items()
        for count, scale in ((1000, 3.0), (100_000, 1.0))
    ),
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_record(RECORD, tmp_path)
    return tmp_path


class TestDecision:
    def test_cheapest_that_meets_the_request(self, folder: Path) -> None:
        chosen = choose("angle", error=0.01, e=(0, 0.5), measured=folder)
        # The proved bound is larger than the measured error, so it counts.
        assert (chosen.way, chosen.error, chosen.bound) == ("coarse", 2e-3, 2e-3)
        assert chosen.better is not None
        assert (chosen.better.way, chosen.better.time) == ("fine", 10.0)
        assert str(chosen) == (
            "gear.angle: coarse, error 0.002 rad (proved bound), 2 ns per point; the next "
            "more accurate: fine, error 1e-15 rad (measured), 10 ns per point."
        )

    def test_a_wider_range_needs_more(self, folder: Path) -> None:
        chosen = choose("gear.angle", error=0.01, measured=folder)
        assert (chosen.way, chosen.error) == ("fine", 3e-15)
        assert str(chosen).endswith("nothing measured has half the error.")

    def test_the_others_are_explained(self, folder: Path) -> None:
        exact = choose("angle", error=1e-9, e=(0, 0.5), measured=folder)
        assert [other.way for other in exact.others] == ["coarse"]
        assert exact.explain().splitlines()[1:] == [
            "not coarse, error 0.002 rad (proved bound), 2 ns per point: not accurate enough"
        ]
        rough = choose("angle", error=0.01, e=(0, 0.5), measured=folder)
        assert rough.explain().splitlines()[1:] == [
            "not fine, error 1e-15 rad (measured), 10 ns per point: 5 times the time"
        ]

    def test_an_edge_belongs_to_the_box_below(self, folder: Path) -> None:
        assert choose("angle", error=0.01, e=0.5, measured=folder).way == "coarse"
        assert choose("angle", error=0.01, e=0.51, measured=folder).way == "fine"
        assert choose("angle", error=0.01, e=0, measured=folder).way == "coarse"
        assert choose("angle", error=0.01, e=0.2, z=4, measured=folder).way == "coarse"
        assert choose("angle", error=0.01, e=[0, 0.2], z=9, measured=folder).way == "coarse"

    def test_the_time_is_that_of_the_nearest_size(self, folder: Path) -> None:
        assert choose("angle", error=1e-9, size=500, measured=folder).time == 30.0
        assert choose("angle", error=1e-9, size=500, measured=folder).count == 1000

    def test_the_most_expensive_workload_counts(self, folder: Path) -> None:
        other = timed("coarse", "v", 100_000, 20.0)
        write_record(replace(RECORD, times=(*RECORD.times, other)), folder)
        chosen = choose("angle", error=0.01, e=(0, 0.5), measured=folder)
        assert (chosen.way, chosen.better) == ("fine", None)

    def test_of_forms_as_fast_the_most_accurate(self, folder: Path) -> None:
        fine = timed("fine", "w", 100_000, 10.0)
        write_record(replace(RECORD, times=(timed("coarse", "w", 100_000, 9.8), fine)), folder)
        chosen = choose("angle", error=0.01, e=(0, 0.5), measured=folder)
        assert chosen.way == "fine"
        assert "not shown to be slower" in chosen.explain()
        write_record(replace(RECORD, times=(timed("coarse", "w", 100_000, 8.0), fine)), folder)
        assert choose("angle", error=0.01, e=(0, 0.5), measured=folder).way == "coarse"

    def test_what_needs_an_extra_is_taken_where_it_is_installed(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        compiled = replace(way("kernel, compiled", kind="kernel"), needs="fast")
        more = [replace(e, way=compiled.name) for e in RECORD.cell_errors if e.way == "fine"]
        record = replace(
            RECORD,
            ways=(*RECORD.ways, compiled),
            cell_errors=(*RECORD.cell_errors, *more),
            times=(*RECORD.times, timed(compiled.name, "w", 100_000, 1.0)),
        )
        write_record(record, folder)
        monkeypatch.setitem(EXTRAS, "fast", "json")
        chosen = choose("angle", error=1e-9, measured=folder)
        assert (chosen.way, chosen.needs) == ("kernel, compiled", "fast")
        assert chosen.function == "mechproof.kernels.compiled.gear.angle"
        assert chosen.faster is None
        monkeypatch.setitem(EXTRAS, "fast", "no_such_package")
        chosen = choose("angle", error=1e-9, measured=folder)
        assert (chosen.way, chosen.needs) == ("fine", "")
        assert chosen.faster is not None
        assert chosen.faster.way == "kernel, compiled"
        assert str(chosen).endswith(
            f" With {suggest_install('fast')}: kernel, compiled, error 3e-15 rad (measured), "
            "1 ns per point."
        )
        assert not any(other.needs for other in chosen.others)
        coarse = choose("angle", error=0.01, e=(0, 0.5), measured=folder)
        assert coarse.way == "coarse"
        assert coarse.faster is not None
        monkeypatch.setitem(EXTRAS, "fast", "json")
        assert choose("angle", error=0.01, e=(0, 0.5), measured=folder).needs == "fast"

    def test_a_kernel_may_be_tailored_to_numbers_and_an_error(
        self, folder: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        made = [
            MeasuredTailoring(f"tailored to {asked:g}", "w", asked, asked / 2, {}, (0, 1), (7,))
            for asked in (1e-3, 1e-6, 1e-12)
        ]
        times = (timed(t.name, "w", 100_000, 0.5 + i) for i, t in enumerate(made))
        record = replace(RECORD, tailored=tuple(made), times=(*RECORD.times, *times))
        write_record(record, folder)
        monkeypatch.setattr("mechproof.choice.EXTRAS", {"fast": "json", "derive": "json"})
        sizes = {"e": 0.2, "z": 4.0}
        chosen = choose("angle", error=1e-5, measured=folder, **sizes)
        # The one tailored to the largest error that does not exceed the one asked for.
        assert (chosen.way, chosen.time, chosen.error) == ("tailored", 1.5, 1e-5)
        assert chosen.function == "mechproof.tailor('gear.angle', error=1e-05, e=0.2, z=4.0)"
        ranged = choose("angle", error=1e-5, measured=folder, e=(0.1, 0.2), z=4.0)
        assert ranged.way == "fine"
        assert choose("angle", error=1e-14, measured=folder, **sizes).way == "fine"
        monkeypatch.setattr("mechproof.choice.EXTRAS", {"fast": "nothing", "derive": "json"})
        without = choose("angle", error=1e-5, measured=folder, **sizes)
        assert without.way == "fine"
        assert f"With {suggest_install('derive,fast')}: tailored" in str(without)

    def test_nothing_qualifies(self, folder: Path) -> None:
        says = r"for all sizes of phi 0 to 5, e 0 to 0\.9, z 4 to 9; gear\.angle: fine, error 3e-15"
        with pytest.raises(ValueError, match=says):
            choose("angle", error=1e-16, measured=folder)

    @pytest.mark.parametrize(
        ("arguments", "says"),
        [
            ({"quantity": "speed", "error": 1.0}, "quantity = 'speed': .*gear.angle"),
            ({"error": 0.0}, "error = 0.0: must be positive"),
            ({"error": float("nan")}, "error = nan"),
            ({"error": 1.0, "k": 2.0}, "k = 2.0: .*arguments phi, e, z"),
            ({"error": 1.0, "size": 0}, "size = 0: must be at least 1"),
            ({"error": 1.0, "e": (0.5, 0.1)}, r"e = \(0.5, 0.1\)"),
            ({"error": 1.0, "phi": (0.0, 7.0)}, "phi = .*from 0.0 to 5.0"),
        ],
    )
    def test_bad_requests(self, folder: Path, arguments: dict[str, Any], says: str) -> None:
        with pytest.raises(ValueError, match=says):
            choose(**{"quantity": "angle", "measured": folder, **arguments})

    def test_a_peer_counts_by_what_was_measured(self, folder: Path) -> None:
        solver = way("solver", "MEASURED", "peer")
        rough = [CellErrors(0, "solver", 1e-9, None, 0), CellErrors(1, "solver", 1.0, None, 0)]
        record = replace(
            RECORD,
            ways=(*RECORD.ways, solver),
            cell_errors=(*RECORD.cell_errors, *rough),
            times=(*RECORD.times, timed("solver", "w", 100_000, 1.0)),
        )
        write_record(record, folder)
        chosen = choose("angle", error=1e-8, e=(0, 0.5), measured=folder)
        assert (chosen.way, chosen.error, chosen.bound) == ("solver", 1e-9, None)
        assert choose("angle", error=1e-8, measured=folder).way == "fine"

    def test_a_quantity_without_cells_has_no_ranges(self, folder: Path) -> None:
        write_record(replace(RECORD, cells=(), cell_errors=(), ranges={}), folder)
        with pytest.raises(ValueError, match=r"angle.*not measured over ranges"):
            choose("angle", error=1.0, measured=str(folder))

    def test_a_folder_without_records_is_named(self, tmp_path: Path) -> None:
        wanted = r"measured = .*nowhere'\): must be a folder with records"
        with pytest.raises(ValueError, match=wanted):
            choose("angle", error=1.0, measured=tmp_path / "nowhere")


def test_first_order_for_a_milliradian_and_a_micrometre(monkeypatch: pytest.MonkeyPatch) -> None:
    """The model is the cheapest way; of the exact kernels, the compiled one is."""
    asked = {"points": (0, 50), "angles": (0, 1e-3), "shift": (0, 1)}
    exact = choose("displacement", error=1e-13, **asked)
    assert (exact.way, exact.needs) == ("kernel, compiled", "fast")
    for _ in range(2):
        chosen = choose("displacement", error=1e-3, **asked)
        assert chosen.way == "first order in the angles"
        assert exact.error < chosen.error
        assert chosen.bound == chosen.error <= 1e-3
        # The second time no extra is found.
        monkeypatch.setattr("mechproof.choice.find_spec", lambda name: None)


def test_every_digit_needs_the_exact_form() -> None:
    chosen = choose("displacement", error=1e-13, points=(0, 50), angles=(0, 1e-3))
    assert chosen.way != "first order in the angles"
    # At this error a share is not simulated.
    assert "simulation" not in choose("wrongly_accepted", error=1e-6).way


@pytest.mark.parametrize("share", ["wrongly_accepted", "wrongly_rejected"])
def test_shares_are_computed_and_not_simulated(share: str) -> None:
    """A simulation accurate to a thousandth costs more than computing every digit."""
    chosen = choose(share, error=1e-3)
    assert "simulation" not in chosen.way
    assert chosen.error < 1e-12
    (simulated,) = (o for o in chosen.others if o.way == "simulation, 1e+06 parts")
    assert simulated.error <= 1e-3
    # Each part takes two normal numbers, and a million parts make one share.
    assert simulated.time > 1000 * chosen.time
    assert f"not {simulated._describe()}" in chosen.explain()
    assert "times the time" in chosen.explain()


def test_the_lazy_entry() -> None:
    assert mechproof.choose is choose


NO_RANGES = [
    ((0.1, 0.2, 0.3), r"R2 = \(0.1, 0.2, 0.3\): must be a size or an ordered pair"),
    ("16", r"R2\[0\] = '1': must be a real number"),
    ((1.0, "2"), r"R2\[1\] = '2': must be a real number, not str"),
    (None, r"R2 = None: must be a real number"),
]


@pytest.mark.parametrize(("given", "says"), NO_RANGES)
def test_what_is_no_range_is_named(given: Any, says: str) -> None:
    with pytest.raises(TypeError, match=f"^{says}"):
        choose("elliptic_planetary.position", error=1e-6, R2=given)
