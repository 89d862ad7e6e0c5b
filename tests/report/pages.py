"""Requirements on every page of a report, as faults found in its text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

VOID = {"meta", "link", "br", "input", "img", "hr", "wbr", "source", "col", "base"}
# Elements that would load or run something.
FORBIDDEN = {"script", "iframe", "object", "embed", "img", "style", "base", "form"}


@dataclass
class Page(HTMLParser):
    """The elements of a page that the checks need, and the faults met while reading it."""

    ids: list[str] = field(default_factory=list)
    links: list[str] = field(default_factory=list)
    loads: list[str] = field(default_factory=list)
    tags: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)
    open: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__(convert_charrefs=True)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = {name: value or "" for name, value in attrs}
        self.tags[tag] += 1
        self.ids += [found["id"]] if "id" in found else []
        self.links += [found["href"]] if tag == "a" else []
        self.loads += [found["href"]] if tag == "link" else []
        if tag in FORBIDDEN:
            self.faults.append(f"a <{tag}>")
        self.faults += [f"an attribute {name}" for name in found if name.startswith("on")]
        if tag == "html" and not found.get("lang"):
            self.faults.append("no language")
        if tag == "svg" and not (found.get("role") == "img" and found.get("aria-label")):
            self.faults.append("a picture without words")
        if tag == "th" and "scope" not in found:
            self.faults.append("a heading of a table without a scope")
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag in VOID:
            return
        if not self.open or self.open[-1] != tag:
            self.faults.append(f"</{tag}> closes {self.open[-1:]}")
        else:
            self.open.pop()


def read_page(text: str) -> Page:
    page = Page()
    page.feed(text)
    page.close()
    return page


def find_faults(folder: Path) -> list[str]:
    """List the faults of all pages in a folder, each with the page it is on."""
    pages = {
        str(file.relative_to(folder)): read_page(file.read_text(encoding="utf-8"))
        for file in sorted(folder.rglob("*.html"))
    }
    return [f"{name}: {fault}" for name in pages for fault in _check(name, pages, folder)]


def _check(name: str, pages: dict[str, Page], folder: Path) -> Iterator[str]:
    page = pages[name]
    yield from page.faults
    yield from (f"<{tag}> is not closed" for tag in page.open)
    yield from (f"id {i} twice" for i, count in Counter(page.ids).items() if count > 1)
    for tag in ("html", "title", "h1", "main", "nav", "header", "footer"):
        if not page.tags[tag] or (tag in ("h1", "main") and page.tags[tag] > 1):
            yield f"{page.tags[tag]} elements <{tag}>"
    for link in page.links:
        yield from _follow(link, name, pages, folder)
    for load in page.loads:
        if urlsplit(load).scheme or not (folder / name).parent.joinpath(unquote(load)).is_file():
            yield f"loads {load}"


def _follow(link: str, name: str, pages: dict[str, Page], folder: Path) -> Iterator[str]:
    parts = urlsplit(link)
    if parts.scheme in ("http", "https"):
        return
    target = (folder / name).parent.joinpath(unquote(parts.path)).resolve() if parts.path else None
    found = str(target.relative_to(folder.resolve())) if target else name
    if parts.scheme or found not in pages:
        yield f"link {link} leads nowhere"
    elif parts.fragment and unquote(parts.fragment) not in pages[found].ids:
        yield f"link {link} has no anchor"
