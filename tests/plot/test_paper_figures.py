"""Every figure of the papers has legible text, claims that match the ledger, and a sound file.

The curves are compared with the kernels in `test_plotted_data.py`.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import matplotlib as mpl
import pytest
from drawn import (
    NAMES,
    boxes,
    cut_off,
    drawn,
    figures,
    ledger,
    overlaps,
    struck,
    words,
    write_texts,
)
from PIL import Image

from mechproof.derivation import packaged_directory
from mechproof.plot.canvas import COLUMN, MILLIMETRE, SMALL, make_canvas, use_style
from mechproof.plot.figures import DPI, find_figures, render_svg, write_files

ALL = [(system, name) for system, names in NAMES.items() for name in names]


@pytest.mark.slow
@pytest.mark.parametrize("pair", ALL, ids=".".join)
def test_text_can_be_read(pair: tuple[str, str]) -> None:
    written = boxes(*pair)
    assert not overlaps(written)
    assert not cut_off(drawn(*pair), written)
    assert not [text for panel in drawn(*pair).axes for text in struck(panel, written)]
    assert min(text.get_fontsize() for text in written) >= SMALL


def test_every_figure_is_tested() -> None:
    with_pictures = {path.parent.name for path in packaged_directory().glob("*/pictures.py")}
    assert with_pictures == set(NAMES)
    assert all(tuple(figures(system)) == names for system, names in NAMES.items())


def test_figures_of_a_paper_are_found_in_its_folder() -> None:
    found = find_figures(packaged_directory() / "tooth_thickness")
    assert tuple(figure.name for figure in found) == NAMES["tooth_thickness"]


@pytest.mark.slow
@pytest.mark.parametrize("pair", ALL, ids=".".join)
def test_figure_says_what_it_is(pair: tuple[str, str]) -> None:
    system, name = pair
    figure = figures(system)[name]
    assert f"{system} {figure.after}" in ledger()
    assert figure.title.endswith(".")
    assert len(figure.caption) > len(figure.title)
    assert drawn(*pair).get_size_inches()[0] == pytest.approx(figure.width * MILLIMETRE)
    assert figure.width == COLUMN


def test_the_check_of_text_sees_what_cannot_be_read() -> None:
    with use_style():
        canvas = make_canvas()
        panel = canvas.subplots()
        panel.set_axis_off()
        panel.plot([0, 1], [0, 1])
        for x, text in ((0.4, "one text"), (0.45, "another"), (0.98, "beyond the edge")):
            canvas.text(x, 0.5, text)
    written = write_texts(canvas)
    assert overlaps(written) == [("one text", "another")]
    assert cut_off(canvas, written) == ["beyond the edge"]
    assert struck(panel, written) == ["another"]


def test_svg_is_one_element_the_same_each_time_and_shares_no_id() -> None:
    seen: set[str] = set()
    for system, name in (("oval_planetary", "fig-2"), ("elliptic_planetary", "table-3")):
        figure = figures(system)[name]
        text = render_svg(figure)
        assert text == render_svg(figure)
        root = ET.fromstring(text)
        assert root.tag.endswith("svg")
        assert root.get("aria-label") == figure.title
        assert "<style" not in text
        assert not re.search(r"\d{4}-\d\d-\d\dT", text)
        ids = re.findall(r' id="([^"]+)"', text)
        assert len(ids) == len(set(ids))
        assert seen.isdisjoint(ids)
        seen |= set(ids)
        assert set(ids) == set(re.findall(r"(?:href=\"|url\()#([\w.-]+)", text))


def read_words(svg: str) -> str:
    """Return the text of a drawing, with its lines joined."""
    return " ".join("".join(ET.fromstring(svg).itertext()).split())


@pytest.mark.slow
def test_files_have_the_caption_below_the_drawing(tmp_path: Path) -> None:
    figure = figures("tooth_thickness")["fig-4"]
    png, svg = write_files(figure, tmp_path, "told")
    told = read_words(svg.read_text(encoding="utf-8"))
    assert f"{figure.number}. {figure.title} {figure.caption}" in told
    assert figure.caption not in read_words(render_svg(figure))
    bare = [round(side * DPI / 25.4) for side in (figure.width, figure.height)]
    with Image.open(png) as whole:
        assert abs(whole.width - bare[0]) <= 1
        assert whole.height > 1.2 * bare[1]


def test_letters_of_a_caption_have_their_indices_below(tmp_path: Path) -> None:
    figure = figures("track_wheel")["table-1"]
    assert "Δ_T" in figure.caption
    told = read_words(write_files(figure, tmp_path, "told")[1].read_text(encoding="utf-8"))
    assert "_" not in told
    assert "all coefficients 1, ΔT random".replace(" ", "") in told.replace(" ", "")


def test_text_in_the_svg_is_text() -> None:
    text = render_svg(figures("elliptic_planetary")["fig-3"])
    assert text.count("font-family") == 1
    assert "R₁ = 66 mm" in "".join(ET.fromstring(text).itertext())


def test_drawing_leaves_settings_and_files_alone(tmp_path: Path) -> None:
    before = dict(mpl.rcParams)
    mpl.rcParams["lines.linewidth"] = 7.0
    try:
        one = write_files(figures("elliptic_planetary")["table-3"], tmp_path, "a")
        assert mpl.rcParams["lines.linewidth"] == 7.0
    finally:
        mpl.rcParams["lines.linewidth"] = before["lines.linewidth"]
    other = write_files(figures("elliptic_planetary")["table-3"], tmp_path, "b")
    assert [file.read_bytes() for file in one] == [file.read_bytes() for file in other]
    assert dict(mpl.rcParams) == before


# Numbers that figures mark, with the rows of the ledger that contain them.
MARKED = (
    ("elliptic_planetary", "fig-3", "(12), size of its error", ("45.0", "72.6")),
    ("elliptic_planetary", "fig-3", "(12), size of its error", ("43.6", "67.5")),
    ("elliptic_planetary", "table-3", "Table 3, interval 1", ("-0.93", "1.64")),
    ("elliptic_planetary", "table-3", "Table 3, interval 2", ("-0.98", "2.72")),
    ("elliptic_planetary", "table-3", "Table 3, interval 3", ("0.68", "0.28")),
    ("elliptic_planetary", "table-3", "Table 3, interval 4", ("-0.89", "2.02")),
    ("wedge_linkage", "fig-4-set-2", "crossing", ("-29.4",)),
    ("track_wheel", "fig-5", "Fig. 5, largest possible gain", ("19.3",)),
)


@pytest.mark.parametrize(("system", "name", "row", "numbers"), MARKED)
def test_what_is_marked_is_what_the_ledger_says(
    system: str, name: str, row: str, numbers: tuple[str, ...]
) -> None:
    said = ledger()[f"{system} {row}"]
    printed = said["print"] or said["paraphrase"]
    for number in numbers:
        assert number in printed
        assert number in words(system, name)


def test_the_corrected_interval_is_drawn() -> None:
    right = ledger()["elliptic_planetary Table 3, interval 3"]["corrected_latex"]
    assert "0.56" in right
    assert "0.68 ± 0.56° by u" in words("elliptic_planetary", "table-3")


# Numbers from the ledger's notes and findings, and the figures that mark them.
SAID = (
    ("elliptic_planetary", "fig-3-rates", ("12.59", "2.468")),
    ("oval_planetary", "fig-2", ("± 22.6°", "± 11.5°", "-180° a turn", "-280° a turn", "10.2°")),
    ("wedge_linkage", "fig-4", ("-29.37", "24.8 mm at -40 mm", "-10.6 %", "+9.5 %", "-4.65")),
    ("wedge_linkage", "fig-4-set-2", ("23.6 mm at -31.8 mm",)),
    ("track_wheel", "fig-3", ("70.5",)),
    ("track_wheel", "fig-4", ("178", "128", "83.7", "72", "71.2")),
)


@pytest.mark.slow
@pytest.mark.parametrize(("system", "name", "numbers"), SAID)
def test_numbers_are_marked(system: str, name: str, numbers: tuple[str, ...]) -> None:
    for number in numbers:
        assert number in words(system, name)


def test_captions_say_what_the_gauge_of_table_1_costs_in_both_readings() -> None:
    for figure in figures("tooth_thickness").values():
        assert "8.4 % of good teeth" in figure.caption
        assert "48.0 %" in figure.caption


NOT_THE_PAPERS = {
    "wedge_linkage": ("fig-4", "fig-4-set-2"),
    "track_wheel": ("fig-3", "fig-4", "fig-5"),
    "tooth_thickness": ("fig-4", "fig-5"),
}
WORDS = ("reconstructed set", "not in the text at hand", "text at hand has neither")


@pytest.mark.parametrize("system", NOT_THE_PAPERS)
def test_captions_say_what_is_not_the_papers(system: str) -> None:
    for name in NOT_THE_PAPERS[system]:
        assert any(words in figures(system)[name].caption for words in WORDS)
