"""The pages of a report: what they say, that links lead somewhere, and that no text is trusted."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from html import unescape
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from derived import paper_of
from own_papers import HURT
from pages import find_faults

from mechproof.derivation import packaged_directory
from mechproof.kernels import elliptic_planetary
from mechproof.kernels.elliptic_planetary import position
from mechproof.lab.chart_points import list_workloads
from mechproof.ledger.cards import PUT, TAKEN
from mechproof.measured import find_files, read_record
from mechproof.programs.kernel import build_functions
from mechproof.report.formula_texts import LANGUAGES, formula, write_sources
from mechproof.report.mathml import write_formula
from mechproof.report.pages import read_font, read_stylesheet
from mechproof.report.pictures import chart, draw_pictures, list_charts
from mechproof.tools.cache import VARIABLE

pytestmark = pytest.mark.xdist_group("report")
# WCAG 2.2, AA: text of usual size.
LEAST_CONTRAST = 4.5
LEDGER = Path(__file__).parents[2] / "generated" / "ledger.json"
# A verdict and how many rows have it.
COUNT = r'<span class="count v-([\w-]+)"><b>(\d+)</b>'


def test_pages_are_whole_and_links_resolve(site: Path) -> None:
    assert find_faults(site) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ('href="#eq-12"', 'href="#eq-99"', "has no anchor"),
        ('href="../index.html"', 'href="../start.html"', "leads nowhere"),
        ('id="eq-12"', 'id="eq-11"', "twice"),
        ('href="../report.css"', 'href="https://example.org/x.css"', "loads https"),
        ('<html lang="en">', "<html>", "no language"),
        ("</main>", "<script></script></main>", "a <script>"),
        ("</main>", '<p onclick="x"></p></main>', "an attribute onclick"),
        ("</main>", "<p></main>", "closes"),
        ('role="img"', "", "a picture without words"),
        ('<th scope="col">symbol', "<th>symbol", "without a scope"),
        ("<h1>", "<h1></h1><h1>", "2 elements <h1>"),
    ],
)
def test_the_checker_sees_a_broken_page(
    site: Path, tmp_path: Path, old: str, new: str, fault: str
) -> None:
    for file in ("index.html", "papers/elliptic_planetary.html", "report.css"):
        text = (site / file).read_text(encoding="utf-8")
        target = tmp_path / file
        target.parent.mkdir(exist_ok=True)
        changed = text.replace(old, new) if file.startswith("papers") else text
        target.write_text(changed, encoding="utf-8")
    found = [f for f in find_faults(tmp_path) if f.startswith("papers")]
    assert any(fault in f for f in found)


def test_the_start_page_has_findings_totals_chart_and_legend(files: dict[str, str]) -> None:
    page = files["index.html"]
    assert 'href="papers/elliptic_planetary.html#finding-eq-12"' in page
    assert "off by 44.3°" in page
    for part in ("findings", "totals", "speed", "verdicts", "marks", "rungs"):
        assert f'id="{part}"' in page
    assert page.count("<svg") == 1


def test_rows_say_which_script_coq_accepts(files: dict[str, str]) -> None:
    page = files["papers/elliptic_planetary.html"]
    assert "<dt>by Coq</dt><dd>checked: elliptic_planetary_eq_1_third_equals_sign.v</dd>" in page


def test_cards_and_filters_count_what_is_printed_and_ours_apart(files: dict[str, str]) -> None:
    start = files["index.html"]
    page = files["papers/elliptic_planetary.html"]
    card = start[start.index('href="papers/elliptic_planetary.html"') :]
    card = card[: card.index("</article>")]
    printed, ours = (
        {look: int(number) for look, number in re.findall(COUNT, part)}
        for part in card.split("our own rows:")
    )
    rows = Counter(re.findall(r'<article class="row v-([\w-]+)((?: \w+)*)"', page))
    for counted, is_ours in ((printed, False), (ours, True)):
        found = Counter[str]()
        for (look, marks), number in rows.items():
            found[look] += number if ("ours" in marks.split()) is is_ours else 0
        assert counted == +found
    filters = dict(re.findall(r'<label for="show-([\w-]+)">[^<]*<small>(\d+)', page))
    assert filters == {k: str(n) for k, n in {**printed, "ours": sum(ours.values())}.items()}
    assert printed["refuted"] > 0 < ours["refuted"]


def test_every_row_has_the_anchor_of_its_id(files: dict[str, str]) -> None:
    rows = json.loads(LEDGER.read_text(encoding="utf-8"))["rows"]
    about = ("elliptic_planetary", "track_wheel")
    pages = {s: "".join(text for name, text in files.items() if f"/{s}." in name) for s in about}
    missing = [
        row["id"]
        for row in rows
        if pages.get(row["system"])
        and f'id="{row["id"].split("/")[1]}"' not in pages[row["system"]]
    ]
    assert missing == []


def test_rows_on_kernels_are_counted_apart_from_our_own_rows(files: dict[str, str]) -> None:
    start, name = files["index.html"], "papers/elliptic_planetary.html"
    card = start[start.index(f'href="{name}"') :]
    card = card[card.index("our own rows:") : card.index("</article>")]
    page = files[name]
    total = page[page.index("our own rows") : page.index("our rows on kernels")]
    assert re.findall(COUNT, total) == re.findall(COUNT, card) != []


def test_what_a_quantity_rests_on_stands_on_its_page_alone(files: dict[str, str]) -> None:
    row = 'id="row-jerk-largest-at-half-a-turn"'
    met = [name for name, text in files.items() if row in text]
    assert met == [
        "quantities/elliptic_planetary.largest_jerk.html",
        "quantities/elliptic_planetary.angle_of_largest_jerk.html",
    ]


def test_the_legend_has_the_marks_and_verdicts_that_the_pages_show(files: dict[str, str]) -> None:
    page = files["index.html"]
    legend = page[page.index('id="legend"') :]
    pages = "".join(text for name, text in files.items() if name.startswith(("papers", "quant")))
    marks = set(re.findall(r"#(mark-[\w-]+)", pages))
    assert set(re.findall(r'id="(mark-[\w-]+)"', legend)) == marks != set()
    badge = r'class="badge v-([\w-]+)"'
    assert set(re.findall(badge, legend)) == set(re.findall(badge, pages))
    assert "v-failed" in legend


def test_a_paper_has_its_rows_in_order_with_what_was_found(files: dict[str, str]) -> None:
    page = files["papers/elliptic_planetary.html"]
    places = [page.index(f'id="{name}"') for name in ("findings", "rows", "eq-1", "eq-10", "eq-12")]
    assert places == sorted(places)
    row = page[page.index('<article class="row v-refuted" id="eq-12">') :]
    row = row[: row.index("</article>")]
    for part in (
        "refuted",
        "compared with",
        "evidence",
        "132.232°",
        "proved: derivative",
        "<code>",
    ):
        assert part in row
    assert row.count("<math") >= 3
    assert page.index('id="eq-12"') < page.index('id="figure-fig-3"') < page.index('id="eq-13"')


def test_a_quantity_says_how_accurate_it_is_and_how_it_is_called(files: dict[str, str]) -> None:
    page = files["quantities/elliptic_planetary.position.html"]
    page = page.replace("\N{NO-BREAK SPACE}", " ")
    told = " ".join(str(position.__doc__).split())
    (proved,) = re.findall(r"half-angle atan, where .*?(at most \S+ eps)", told)
    record = read_record(find_files()["elliptic_planetary.position"])
    (sweep,) = (e for e in record.errors_of("kernel") if e.set == "sweep, 3301 samples")
    digits, power = f"{sweep.worst_absolute:.1e}".split("e-")
    power = power.translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))
    measured = f"over 16 turns at most {digits}·10⁻{power} rad on 3,301 points"
    for part in (
        "0 &lt; R<sub>1</sub>, R<sub>2</sub> &lt; ∞",
        "5.5 eps of the value",
        "over 16 turns of φ<sub>1</sub>",
        "in the tenth turn at most 3.9·10⁻¹³ rad, at the sizes of Table 1, variant 2",
        proved,
        measured,
        "points chosen to hurt",
        "from mechproof.kernels.elliptic_planetary import position",
        "position(phi1, 66, 16, 0.28)",
        "from mechproof.kernels.compiled.elliptic_planetary import position",
        "double elliptic_planetary_position(",
        "mechproof.formula(&#34;elliptic_planetary.position&#34;)",
        "✗",
    ):
        assert part in page
    assert page.count("<svg") == 1


# Quantities that are not written for compilers of arrays.
LOW_WORDS = ("position", "ratio", "acceleration", "jerk")


def test_the_code_on_a_page_is_that_of_its_formula(files: dict[str, str]) -> None:
    folded = r"<details><summary>([^<]+)</summary><pre><code>(.*?)</code></pre></details>"
    for name in elliptic_planetary.__all__:
        page = files[f"quantities/elliptic_planetary.{name}.html"]
        text = formula(f"elliptic_planetary.{name}")
        found = {language: unescape(code) for language, code in re.findall(folded, page, re.DOTALL)}
        refused = {"array_api"} if name in LOW_WORDS else set()
        there = {key: shown for key, shown in LANGUAGES.items() if key not in refused}
        assert found == {shown: getattr(text, key) for key, shown in there.items()}
        assert ("None for Array API (JAX, PyTorch): compilers of" in page) == bool(refused)


def test_languages_without_a_text_say_why() -> None:
    paper = paper_of("track_wheel")
    (kernel,) = (k for k in build_functions(paper).kernels if k.name == "error_sum")
    location, ledger = packaged_directory() / "track_wheel", SimpleNamespace(paper=paper)
    source: Any = SimpleNamespace(ledger=ledger, location=location, home="generated")
    found = write_sources(kernel, source)
    assert found.call == 'mechproof.formula("track_wheel.error_sum", derivations="derivations")'
    refused = {language for languages in found.refused.values() for language in languages}
    shown = {language for language, _ in found.texts}
    assert shown == {"C", "LaTeX"} == {*LANGUAGES.values()} - refused
    assert list(found.refused) == ["formulas cannot sum over axes of arbitrary length"]


@pytest.mark.parametrize(
    ("system", "given", "value"),
    [
        (
            "conformity",
            {"mean": 0.0, "true_std": 1.0, "bias": 0.0, "error_std": 0.1, "low": -2.0, "high": 2.0},
            0.9499,
        ),
        ("measurement", {"readings": [1.0, 2.0, 3.0]}, 1.0),
    ],
)
def test_hand_written_code_is_called_as_its_page_says(
    system: str, given: dict[str, object], value: float
) -> None:
    call = paper_of(system).quantities[0].call
    *imports, last = call.splitlines()
    names = dict(given)
    exec("\n".join(imports), names)
    assert eval(last, names) == pytest.approx(value, abs=1e-3)


def test_what_is_called_is_there(files: dict[str, str]) -> None:
    pages = "".join(text for name, text in files.items() if name.startswith("quantities"))
    calls = set(re.findall(r"from (mechproof\.[\w.]+) import (\w+)", pages))
    assert len(calls) == 2 * len(elliptic_planetary.__all__)
    assert all(hasattr(import_module(module), name) for module, name in calls)


def test_a_paper_without_kernels_and_measurements_has_its_pages(files: dict[str, str]) -> None:
    page = files["quantities/universal_joint.position.html"]
    assert "not measured" in page
    assert "mechproof regenerate" in page
    assert "<svg" not in page
    assert "half angle of the shafts" in page
    assert "no bound" not in files["quantities/elliptic_planetary.position.html"]
    assert "quantities/slider_crank" not in "".join(files)


def test_a_row_that_fails_is_shown_and_named(files: dict[str, str]) -> None:
    page = files["papers/größe.html"]
    row = page[page.index('<article class="row v-failed" id="eq-3">') :]
    assert "ghost" in row[: row.index("</article>")]
    assert "1 could not be judged" in files["index.html"]
    assert "Not looked for" in page


def test_nothing_of_a_paper_is_markup(files: dict[str, str]) -> None:
    for name, text in files.items():
        if name.endswith(".html"):
            assert "<script" not in text, name
            assert "<b>length" not in text, name
            assert not re.search(r'href="javascript', text), name
    assert HURT.split("=")[0] in files["papers/größe.html"]


@pytest.mark.thorough
def test_the_same_papers_give_the_same_bytes(papers: list[Path]) -> None:
    code = (
        "import sys, hashlib; from pathlib import Path; from mechproof.report import build_site;"
        "from mechproof.pipeline.verification import judge_derivations;"
        "p = [Path(a) for a in sys.argv[1:]];"
        "files = build_site(p, judge_derivations(p)).files;"
        "print(hashlib.sha256(repr(files).encode()).hexdigest())"
    )
    seen = {
        subprocess.run(
            [sys.executable, "-c", code, *map(str, papers[:2])],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(seen) == 1


@pytest.mark.slow
def test_charts_are_the_same_each_time() -> None:
    record = read_record(find_files()["elliptic_planetary.largest_ratio"])
    ((workload, count),) = list_workloads(record)
    assert chart(record, workload, count) == chart(record, workload, count)


def read_colours(text: str) -> dict[str, str]:
    return dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})", text))


def luminance(colour: str) -> float:
    parts = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    low, high = sorted(map(luminance, (one, other)))
    return (high + 0.05) / (low + 0.05)


def find_pale(colours: dict[str, str]) -> list[str]:
    """List the pairs of text and background whose contrast is too low."""
    pairs = [(n.removesuffix("-bg"), n) for n in colours if n.endswith("-bg")]
    texts = [name for name, _ in pairs] + ["ink", "soft", "link", "accent"]
    pairs += [(text, ground) for text in texts for ground in ("ground", "sheet")]
    return [str(p) for p in pairs if contrast(colours[p[0]], colours[p[1]]) < LEAST_CONTRAST]


def test_text_stands_out_in_light_and_dark() -> None:
    light, dark = read_stylesheet().split("@media (prefers-color-scheme: dark)", 1)
    dark = dark[: dark.index("@media") if "@media" in dark else None]
    for part in (light, dark):
        assert len(read_colours(part)) >= 20
        assert find_pale(read_colours(part)) == []


def test_pale_text_is_seen() -> None:
    assert find_pale({**read_colours(read_stylesheet()), "soft": "#3a3d41"})


@pytest.mark.slow
def test_a_picture_is_drawn_once_and_anew_when_it_shows_something_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(VARIABLE, str(tmp_path))
    record = read_record(find_files()["elliptic_planetary.largest_ratio"])
    said: list[str] = []
    first = draw_pictures(list_charts(record), said.append)
    assert draw_pictures(list_charts(record), said.append) == first
    assert len(said) == 1
    draw_pictures(list_charts(replace(record, taken="2001-01-01")), said.append)
    assert len(said) == 2


def test_what_a_mend_changes_is_marked_in_the_card() -> None:
    assert 'class="taken"' in write_formula(rf"x_{{{TAKEN.change('1')}}}")
    assert 'class="put"' in write_formula(PUT.change("y"))
    assert "mathcolor" not in write_formula(r"{\color{blue}{y}}")


def test_the_font_of_formulas_is_in_the_stylesheet(files: dict[str, str]) -> None:
    assert "data:font/woff2;base64," in files["report.css"]
    assert "data:font" not in read_stylesheet()
    assert len(read_font()) < 90_000


def test_rows_of_kernels_stand_on_the_page_of_their_quantity(files: dict[str, str]) -> None:
    assert 'id="row-kernel-position"' in files["quantities/elliptic_planetary.position.html"]
    assert 'id="row-kernel-position"' not in files["papers/elliptic_planetary.html"]
