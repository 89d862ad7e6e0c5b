"""The report in a real browser: no errors, every formula has a size, nothing overflows."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import Browser, find_browser, start_browser
from weights import first_of

pytestmark = [
    pytest.mark.xdist_group("report"),
    pytest.mark.slow(together=True),
    pytest.mark.skipif(find_browser() is None, reason="there is no Chromium on this machine"),
]
# A page of each kind, and that of a paper that would run scripts.
EACH_KIND = tuple(
    f"{name}.html"
    for name in (
        *("index", "papers/elliptic_planetary", "papers/größe"),
        "quantities/elliptic_planetary.position",
    )
)
EVERY = "**/*.html"
# A script that lists the faults of the open page in words.
INSPECT = r"""
(() => {
  const faults = [];
  const say = (what, element) => faults.push(
    `${what}: <${element.localName} class="${element.getAttribute("class") || ""}"> `
    + element.textContent.trim().slice(0, 60));
  for (const fold of document.querySelectorAll("details")) fold.open = true;
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width)
    faults.push(`the page is ${document.documentElement.scrollWidth} px wide, not ${width}`);
  for (const math of document.querySelectorAll("math")) {
    const box = math.getBoundingClientRect();
    if (!(box.width > 0 && box.height > 0)) say("a formula without a size", math);
  }
  const scrolls = (element) => {
    for (let e = element; e && e !== document.body; e = e.parentElement)
      if (getComputedStyle(e).overflowX !== "visible") return true;
    return false;
  };
  for (const element of document.body.querySelectorAll("*")) {
    if (element.closest("svg, math") || element.classList.contains("skip")) continue;
    for (const node of element.childNodes) {
      if (node.nodeType !== Node.TEXT_NODE || !node.data.trim() || scrolls(element)) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const block = element.closest("p, li, dd, dt, td, th, h1, h2, h3, h4, article, figcaption");
      const limit = Math.min(width, block ? block.getBoundingClientRect().right : width);
      for (const box of range.getClientRects())
        if (box.right > limit + 1) { say("text sticks out", element); break; }
    }
  }
  for (const math of document.querySelectorAll("math")) {
    if (!scrolls(math) && math.getBoundingClientRect().right > width + 1)
      say("a formula sticks out", math);
  }
  for (const text of document.querySelectorAll("svg text")) {
    const box = text.getBoundingClientRect(), sheet = text.closest("svg").getBoundingClientRect();
    if (box.left < sheet.left - 2 || box.right > sheet.right + 2
        || box.top < sheet.top - 2 || box.bottom > sheet.bottom + 2) say("cut off", text);
  }
  return faults;
})()
"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with start_browser() as started:
        yield started


def inspect(browser: Browser, page: Path, width: int) -> list[str]:
    browser.resize(width)
    browser.open(page)
    found: list[str] = browser.evaluate(INSPECT)
    return [*browser.complaints, *found]


@pytest.mark.parametrize(
    ("names", "width"), first_of([(EACH_KIND, 400), ((EVERY,), 400), ((EVERY,), 1400)])
)
def test_every_page_shows_all_it_has(
    browser: Browser, site: Path, names: tuple[str, ...], width: int
) -> None:
    pages = sorted(page for name in names for page in site.glob(name))
    assert len(pages) == len(names) if names is EACH_KIND else len(pages) >= 12
    faults = {page.name: inspect(browser, page, width) for page in pages}
    assert {name: found for name, found in faults.items() if found} == {}


def test_no_script_of_a_paper_runs(browser: Browser, site: Path) -> None:
    for page in (site / "index.html", site / "papers" / "größe.html"):
        browser.open(page)
        assert "hurt" not in browser.evaluate("document.title").casefold()


def test_the_filter_shows_one_verdict_or_our_rows_and_what_a_link_points_at(
    browser: Browser, site: Path
) -> None:
    browser.open(site / "papers" / "elliptic_planetary.html")
    shown = """[...document.querySelectorAll('.row')]
        .filter(row => row.getClientRects().length).map(row => row.className)"""
    every = browser.evaluate(shown)
    assert browser.evaluate("document.getElementById('show-refuted').click()") is None
    refuted = browser.evaluate(shown)
    assert set(refuted) == {"row v-refuted"}
    number = "document.querySelector('[for=show-refuted] small').textContent"
    assert 0 < len(refuted) == int(browser.evaluate(number)) < len(every)
    assert browser.evaluate("document.getElementById('show-ours').click()") is None
    ours = browser.evaluate(shown)
    assert {"row v-refuted ours", "row v-proved plain ours"} <= {*ours}
    assert all(name.endswith(" ours") for name in ours)
    browser.evaluate("location.hash = '#eq-3'")
    assert "row v-proved plain" in browser.evaluate(shown)


def test_colours_follow_the_preference(browser: Browser, site: Path) -> None:
    browser.open(site / "index.html")
    grounds = []
    for scheme in ("light", "dark"):
        browser.prefer(scheme)
        grounds.append(browser.evaluate("getComputedStyle(document.body).backgroundColor"))
    browser.prefer("light")
    assert grounds[0] != grounds[1]


@pytest.mark.parametrize(
    ("body", "fault"),
    [
        ("<div style='width:3000px'>x</div>", "the page is"),
        ("<p style='width:40px'>unbreakableunbreakable</p>", "text sticks out"),
        ("<math><mrow></mrow></math>", "without a size"),
        ("<math><mspace width='2000px'></mspace><mi>x</mi></math>", "a formula sticks out"),
        ("<svg width='50'><text x='40' y='20'>too far</text></svg>", "cut off"),
        ("<script>throw new Error('broken')</script>", "Uncaught"),
        ("<script>console.error('complaint')</script>", "complaint"),
        ("<link rel='stylesheet' href='missing.css'>", "ERR_FILE_NOT_FOUND"),
    ],
)
def test_the_inspector_sees_a_broken_page(
    browser: Browser, tmp_path: Path, body: str, fault: str
) -> None:
    page = tmp_path / "broken.html"
    page.write_text(f"<!doctype html><title>x</title>{body}", encoding="utf-8")
    assert any(fault in found for found in inspect(browser, page, 400))


def test_the_inspector_lets_scrolling_boxes_pass(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "scrolls.html"
    body = "<div style='overflow-x:auto'><p style='width:2000px'>x</p></div>"
    page.write_text(f"<!doctype html><title>x</title>{body}", encoding="utf-8")
    assert inspect(browser, page, 400) == []
