"""Charts draw what the records say: marks, fronts, lanes, titles; pixels are not compared."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from PIL import Image
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.lab.chart import (
    collect_first,
    describe_sources,
    draw_chart,
    draw_charts,
    draw_overview,
    draw_panels,
    pick_marks,
    write_summary,
    write_title,
)
from mechproof.lab.chart_points import (
    LOST_LANE,
    TURNS_LANE,
    ChartPoint,
    Family,
    collect_marks,
    find_best,
    find_front,
    find_usual_set,
    list_workloads,
    write_headline,
)
from mechproof.lab.record_tables import describe_proved, find_searched, find_way, list_claims
from mechproof.measured import Record, find_files, read_record, read_records, write_record

ROOT = Path(__file__).parents[2]
MEASURED = ROOT / "generated" / "measured"
PICTURES = ("elliptic_planetary.position.N_values_of_phi1", "overview")
MOST_BYTES = 120_000


@pytest.fixture(scope="module")
def record() -> Record:
    return read_record(find_files(MEASURED)["elliptic_planetary.position"])


@pytest.fixture(scope="module")
def figure(record: Record) -> Figure:
    return draw_chart(record, *list_workloads(record)[0])


def make_mark(
    name: str, time: float, error: float, turns: bool = False, family: Family = "written"
) -> ChartPoint:
    return ChartPoint(name, family, time, error, turns, 1000)


def drawn(axes: object) -> set[tuple[float, float]]:
    """Return the positions of all markers in a panel."""
    lines = [line for line in axes.get_lines() if line.get_marker() not in ("None", "", None)]  # type: ignore[attr-defined]
    return {(float(line.get_xdata()[0]), float(line.get_ydata()[0])) for line in lines}


@pytest.mark.slow
def test_every_way_is_drawn_where_the_record_says(record: Record, figure: Figure) -> None:
    workload, count = list_workloads(record)[0]
    times = {t.way: t.median for t in record.times if (t.workload, t.count) == (workload, count)}
    for axes, only in zip(figure.axes, (find_usual_set(record), ""), strict=True):
        expected = set()
        for way in record.ways:
            rows = [row for row in record.errors_of(way.name) if only in ("", row.set)]
            if way.name not in times or (not only and way.ordered):
                continue
            error = max(row.worst_scaled for row in rows if row.worst_scaled is not None)
            height = LOST_LANE if error * 2.0**-52 >= 0.1 else math.log10(error)
            if any(row.wrong_branch for row in rows):
                height = TURNS_LANE
            expected.add((times[way.name], height))
        assert drawn(axes) == expected
        assert len(expected) > 10


@pytest.mark.slow
def test_a_changed_record_moves_its_mark(record: Record, figure: Figure) -> None:
    slower = tuple(replace(t, median=2 * t.median) for t in record.times)
    other = draw_chart(replace(record, times=slower), *list_workloads(record)[0])
    assert drawn(other.axes[0]) == {(2 * x, y) for x, y in drawn(figure.axes[0])}


def test_the_front_has_what_nothing_beats() -> None:
    rows = (("a", 1, 9), ("b", 2, 9), ("c", 3, 1), ("d", 4, 2), ("e", 9, 0.5))
    marks = [make_mark(*row) for row in rows]
    assert [mark.name for mark in find_front(marks)] == ["a", "c", "e"]


@pytest.mark.parametrize(("error", "turns"), [(1.0, True), (math.inf, False), (1e15, False)])
def test_no_digit_is_not_on_the_front(error: float, turns: bool) -> None:
    marks = [make_mark("fast", 1, error, turns), make_mark("slow", 2, 1)]
    assert [mark.name for mark in find_front(marks)] == ["slow"]


def test_the_front_is_the_step_that_is_drawn(record: Record, figure: Figure) -> None:
    front = find_front(collect_marks(record, *list_workloads(record)[0]))
    (step,) = (line for line in figure.axes[1].get_lines() if line.get_drawstyle() == "steps-post")
    assert list(step.get_xdata())[1:-1] == [mark.time for mark in front]
    assert list(step.get_ydata())[1:-1] == [mark.height for mark in front]


def test_heights_are_digits_lost_and_lanes() -> None:
    cases = (
        (1e3, False, 3.0),
        (0.0, False, -1.0),
        (1e225, False, LOST_LANE),
        (2, True, TURNS_LANE),
    )
    for error, turns, height in cases:
        assert make_mark("way", 1, error, turns).height == pytest.approx(height)


def test_a_turn_of_a_few_eps_is_no_wrong_turn(record: Record) -> None:
    """At angles so large that a turn is an eps, accurate ways have as many wrong branches."""
    kernel = record.ways[0].name
    workload = list_workloads(record)[0]
    for wrong, is_wrong in ((0, True), (10_000, False)):
        rows = tuple(
            replace(row, wrong_branch=wrong) if row.way == kernel else row for row in record.sets
        )
        marks = {m.name: m for m in collect_marks(replace(record, sets=rows), *workload)}
        assert marks["tan/arctan"].turns is is_wrong
        assert not marks[kernel].turns


def test_where_no_bound_holds_nothing_is_lost(record: Record) -> None:
    worst = max(record.errors_of("kernel"), key=lambda row: row.worst_scaled or 0)
    for scaled, error in ((None, 1.151), (math.inf, math.inf)):
        lost = replace(worst, worst_scaled=scaled, infinite=1)
        rows = tuple(lost if row == worst else row for row in record.sets)
        marks = collect_marks(replace(record, sets=rows), *list_workloads(record)[0])
        remaining = [row.worst_scaled for row in rows if row.way == "kernel" and row.worst_scaled]
        assert marks[0].error == max(remaining)
        assert (marks[0].error == math.inf) is (error == math.inf)


def test_the_usual_set_is_the_one_that_most_ways_share(record: Record) -> None:
    usual = find_usual_set(record)
    assert {row.way for row in record.sets if row.set == usual} == {w.name for w in record.ways}
    free = {way.name for way in record.ways if not way.ordered}
    rows = tuple(row for row in record.sets if row.way in free)
    assert find_usual_set(replace(record, sets=rows)) == record.typical


@pytest.mark.parametrize(
    ("others", "says"),
    [
        ([("a", 2, 5)], "the least of 2 ways; none is faster"),
        ([("a", 2, 2)], "as is the only other way; none is faster"),
        ([("a", 2, 1)], "a by 1; none is faster"),
        (
            [("a", 0.5, 5e4), ("b", 2, 3)],
            "the least of 3 ways; the only faster other loses 4 digits",
        ),
        (
            [("a", 0.5, 464)],
            "the least of 2 ways; the only faster other is off by 464 eps at worst on these points",
        ),
        (
            [("a", 0.5, 1, True), ("b", 0.6, 1e15)],
            "the least of 3 ways; "
            "each of the 2 faster others somewhere loses whole turns or every digit",
        ),
        (
            [("a", 0.5, 1, True), ("b", 0.6, 9)],
            "the least of 3 ways; "
            "the best of the 2 faster others is off by 9 eps at worst on these points",
        ),
    ],
)
def test_the_title_says_what_is_seen(others: list[tuple[str, float, float]], says: str) -> None:
    marks = [make_mark("kernel", 1, 2, family="shipped"), *(make_mark(*row) for row in others)]
    seen = "The shipped kernel is off by 2 eps at worst on these points"
    assert write_headline(marks) == f"{seen}, {says}"


def test_the_verb_of_another_way_is_that_of_the_shipped_one() -> None:
    lost = [make_mark(name, time, 2.88e11) for name, time in (("kernel", 1), ("a", 2))]
    lost[0] = replace(lost[0], family="shipped")
    told = "The shipped kernel loses 11 digits (2.9e+11 eps by search), as does the only other way"
    assert write_headline(lost, 2.9e11) == f"{told}; none is faster"


@pytest.mark.parametrize(
    ("searched", "says"),
    [
        (4.512, "2 eps at worst on these points (4.51 eps by search), the least of 2 ways"),
        (1649.0, "2 eps at worst on these points (1649 eps by search), the least of 2 ways"),
        (2.0, "2 eps at worst on these points, the least of 2 ways"),
    ],
)
def test_the_title_tells_what_a_search_found_beyond_the_points(searched: float, says: str) -> None:
    marks = [make_mark("kernel", 1, 2, family="shipped"), make_mark("a", 2, 9)]
    assert says in write_headline(marks, searched)
    lost = [replace(marks[0], turns=True), marks[1]]
    assert "by search" not in write_headline(lost, searched)


def test_the_title_and_the_marks_tell_the_same(record: Record, figure: Figure) -> None:
    title = " ".join(figure.get_suptitle().split())
    shipped = record.ways[0].name
    searched = find_searched(record)[shipped]
    (found,) = (one.scaled for one in record.searched if one.way == shipped)
    claimed = [c.found for c in list_claims(record) if find_way(record, c) == shipped]
    assert searched == max(found, *claimed)
    assert f"({searched:.3g} eps by search)" in title
    labels = [text.get_text() for text in figure.axes[1].texts]
    assert any(text.startswith(f"{shipped}, {searched:.3g} by search, proved") for text in labels)


def test_the_title_is_computed_from_all_points(record: Record, figure: Figure) -> None:
    title = " ".join(figure.get_suptitle().split())
    assert title == write_title(record, *list_workloads(record)[0])
    assert f"off by {record.worst_of('kernel'):.2g} eps at worst on these points" in title


def test_names_do_not_overlap_and_the_rest_is_counted(figure: Figure) -> None:
    figure.draw_without_rendering()
    for axes in figure.axes:
        names = [text for text in axes.texts if text.arrow_patch is not None]
        boxes = [super(type(text), text).get_window_extent() for text in names]
        pairs = [(a, b) for n, a in enumerate(boxes) for b in boxes[:n]]
        assert not any(a.overlaps(b) for a, b in pairs)
        assert all(axes.bbox.count_contains(box.corners()) == 4 for box in boxes)
        assert any(text.get_text().startswith("kernel") for text in names)
        total = len([x for x in axes.get_lines() if x.get_marker() in "so^D"])
        says = axes.get_title(loc="right")
        assert says == f"{total} ways, {total - len(names)} of them without a name here"


def test_families_differ_in_shape_and_in_grey() -> None:
    from matplotlib.colors import to_rgb

    from mechproof.lab.labels import LOOKS

    assert len({look.marker for look in LOOKS.values()}) == len(LOOKS)
    weights = (0.299, 0.587, 0.114)
    greys = sorted(
        sum(w * c for w, c in zip(weights, to_rgb(look.face), strict=True))
        for look in LOOKS.values()
    )
    assert min(b - a for a, b in itertools.pairwise(greys)) > 0.15


@pytest.mark.thorough
def test_charts_are_drawn_twice_alike(record: Record, tmp_path: Path) -> None:
    first = draw_charts(record, None, tmp_path / "a")
    second = draw_charts(record, None, tmp_path / "b")
    assert [file.name for file in first] == [f"{PICTURES[0]}.png", f"{PICTURES[0]}.svg"]
    for one, two in zip(first, second, strict=True):
        assert one.read_bytes() == two.read_bytes()


def test_the_overview_has_the_best_of_each_family_and_the_front() -> None:
    records = read_records(MEASURED)[:8]
    figure = draw_panels(records)
    assert figure.get_suptitle() == write_summary(records)
    for axes, record in zip(figure.axes, records, strict=False):
        assert axes.get_title() == record.quantity.replace(".", "\n", 1)
        marks = collect_first(record)
        picked = pick_marks(marks)
        assert drawn(axes) == {(mark.time, mark.height) for mark in picked}
        assert set(picked) >= {*find_front(marks), *find_best(marks)}


def test_the_summary_counts(record: Record) -> None:
    assert write_summary([record]) == (
        "For 1 of 1 quantities nothing is more accurate than what is shipped here; "
        "for 1 it is on the Pareto front"
    )
    worse = tuple(
        replace(row, worst_scaled=1e15) if row.way.startswith("kernel") else row
        for row in record.sets
    )
    assert write_summary([replace(record, sets=worse)]) == (
        "For 0 of 1 quantities nothing is more accurate than what is shipped here; "
        "for 0 it is on the Pareto front"
    )


@pytest.mark.thorough
def test_charts_from_the_command_line(tmp_path: Path, record: Record) -> None:
    # A user's own records, of a quantity that this installation does not have.
    write_record(replace(record, quantity="gear.angle"), tmp_path / "own")
    arguments = ["chart", "--measured", str(tmp_path / "own"), "--out", str(tmp_path / "charts")]
    for more, name in (([], "gear.angle.N_values_of_phi1"), (["--overview"], "overview")):
        done = CliRunner().invoke(app, [*arguments, *more])
        assert done.exit_code == 0, done.output
        assert (tmp_path / "charts" / f"{name}.png").is_file()


@pytest.mark.slow
def test_records_of_the_folder_are_found_before_those_of_the_package(
    tmp_path: Path, record: Record, monkeypatch: pytest.MonkeyPatch
) -> None:
    quick = Path("generated", "measured", "quick")
    write_record(replace(record, quantity="gear.angle"), tmp_path / quick)
    monkeypatch.chdir(tmp_path)
    others = "thickness_error"
    for names, drawn in ((["gear"], "gear.angle"), ([], "gear.angle"), ([others], "tooth_thick")):
        done = CliRunner().invoke(app, ["chart", *names, "--out", f"charts of {names}"])
        assert done.exit_code == 0, done.output
        assert (f"records: {quick}" in done.output) == (drawn == "gear.angle")
        assert any(file.name.startswith(drawn) for file in Path(f"charts of {names}").iterdir())
    told = CliRunner().invoke(app, ["chart", "torque"]).output
    assert "quantity 'torque' is not one of gear.angle, " in told
    assert "give --measured for others" in told


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["torque"], "torque"),
        (["--overview", "torque"], "torque"),
        (["--measured", "nowhere"], "no folder with records"),
    ],
)
def test_charts_of_what_was_not_measured(arguments: list[str], says: str) -> None:
    done = CliRunner().invoke(app, ["chart", *arguments])
    assert done.exit_code == 2
    assert says in " ".join(done.output.split())


def check_picture(file: Path, says: str, records: list[Record]) -> list[str]:
    """List what is wrong with a stored picture: its size, its title, its records."""
    with Image.open(file) as picture:
        about = dict(picture.text)  # type: ignore[attr-defined]
    wrong = [] if file.stat().st_size < MOST_BYTES else ["size"]
    expected = {"Title": says, "Description": describe_sources(records)}
    return wrong + [key for key, text in expected.items() if about.get(key) != text]


def test_the_pictures_of_the_readme_are_of_the_records(record: Record) -> None:
    """Pixels depend on a machine's fonts; the texts stored in a picture do not."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    records = read_records(MEASURED)
    headline = write_title(record, *list_workloads(record)[0])
    says = {PICTURES[0]: (headline, [record]), PICTURES[1]: (write_summary(records), records)}
    for name, (text, drawn_from) in says.items():
        assert f"](docs/{name}.png)" in readme
        assert check_picture(ROOT / "docs" / f"{name}.png", text, drawn_from) == []
    assert sorted(ROOT.glob("docs/*.png")) == [ROOT / "docs" / f"{name}.png" for name in PICTURES]


def test_a_stale_picture_is_found(record: Record, tmp_path: Path) -> None:
    (picture, _) = draw_overview([record], tmp_path)
    assert check_picture(picture, write_summary([record]), [record]) == []
    later = replace(record, taken="2030-01-01T00:00:00+00:00")
    assert check_picture(picture, "another title", [later]) == ["Title", "Description"]


def test_what_is_proved_stands_beside_the_worst(record: Record, figure: Figure) -> None:
    usual, worst = ([text.get_text() for text in axes.texts] for axes in figure.axes)
    told = describe_proved(record)
    for claim in list_claims(record):
        way = find_way(record, claim)
        (name,) = (t for t in worst if t == f"{way}, {told[way]}" or t.startswith(f"{way} ("))
        assert name.endswith(f", {told[way]}")
        bound = float(told[way].rpartition(" ")[2])
        assert max(record.worst_of(way) or 0, claim.found) <= claim.proved <= bound
    assert not any("proved" in text for text in usual)
    assert "Proved: " in " ".join(figure.axes[1].get_xlabel().split())
