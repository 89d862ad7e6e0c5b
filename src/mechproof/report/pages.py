"""Layout: takes rows and other views, returns pages and fragments; all text is escaped.

One file can contain all pages as its parts. Ids in a page then begin with the path of the page, and
links lead to places within the file.
"""

from __future__ import annotations

import posixpath
import re
from base64 import b64encode
from collections.abc import Container, Mapping
from dataclasses import dataclass, field
from functools import cache, partial
from html import unescape
from importlib.metadata import version
from importlib.resources import files
from itertools import cycle
from pathlib import Path
from types import MappingProxyType
from urllib.parse import quote, unquote

import jinja2
from markupsafe import Markup, escape

from mechproof.codegen.docstrings import capitalise, describe_unit
from mechproof.ledger.judged import PLAIN
from mechproof.proof.anchors import slugify
from mechproof.proof.verdict import Judgement, Left, Verdict
from mechproof.record import MARKS, Paper, Row
from mechproof.report.formulas import write_lines, write_print
from mechproof.report.mathml import write_formula
from mechproof.report.phrases import (
    LEFT,
    NOT_JUDGED,
    VerdictStyle,
    look_of,
    set_numbers,
    set_prose,
    set_reason,
    set_value,
)
from mechproof.sources.located_text import Place
from mechproof.tools.made import ForeignFileError

# Evidence beyond this number of items is folded away.
SHOWN = 4
# Length of LaTeX above which a formula is folded away, and above which it is no longer typeset.
LONG, LONGEST = 500, 3000
MARKED = {**MARKS, "as typed": "its statement was typed by hand, not read from the print"}
STYLESHEET = "report.css"
SUFFIX = ".html.jinja"
DOI = re.compile(r"(?<=doi )(10\.\d{4,9}/[^\s,;]*[\w/])", re.IGNORECASE)


@dataclass(frozen=True)
class RowView:
    """A row of a page with what is `judged` of it; if nothing is, `failure` may say why.

    `symbols` map the paper's symbols to their prints, `place` is one in a paper's own source.
    """

    anchor: str
    number: str
    look: VerdictStyle
    marks: tuple[str, ...]
    printed_latex: str
    read_as: str = ""
    judged: Judgement | None = None
    symbols: Mapping[str, str] = field(default_factory=dict)
    checked: str = ""
    failure: str = ""
    place: Place | None = None

    @property
    def is_plain(self) -> bool:
        """Return whether the row, judged or for reading only, needs no attention."""
        return self.judged.verdict in PLAIN if self.judged else not self.look.word

    @property
    def rung(self) -> str:
        """Return what shows the verdict, if anything does."""
        row = self.judged
        return row.rung if row and row.verdict is not Verdict.NOT_CHECKABLE else ""


def name_symbols(paper: Paper) -> dict[str, str]:
    """Return the prints of the symbols that evidence names."""
    printed = {str(v.symbol): v.latex[0] for v in paper.variables if v.latex}
    return {name: latex for name, latex in printed.items() if "#" not in latex}


def describe_row(
    row: Judgement,
    anchor: str,
    symbols: Mapping[str, str],
    checks: Mapping[str, str] = MappingProxyType({}),
) -> RowView:
    """Return the view of a judgement; `symbols` map the paper's symbols to their prints.

    `checks` tell by the ids of rows whether Coq has checked them.
    """
    return RowView(
        anchor,
        row.number,
        look_of(row.verdict),
        row.marks,
        row.printed_latex,
        row.read_as,
        row,
        symbols,
        checks.get(row.id, ""),
        place=row.place,
    )


def describe_failure(row: Row, anchor: str, failure: str) -> RowView:
    """Return the view of a row that could not be judged."""
    return RowView(
        anchor, row.number, NOT_JUDGED, row.marks, row.printed_latex, row.read_as, failure=failure
    )


def describe_left(row: Left, anchor: str) -> RowView:
    """Return the view of a row of a paper's own source that has no verdict."""
    says = ". ".join(filter(None, (row.reason, row.remedy)))
    look, latex = LEFT[row.state], row.printed_latex
    return RowView(anchor, row.number, look, (), latex, failure=says, place=row.place)


def describe_print(row: Row, anchor: str) -> RowView:
    """Return the view of a row that nobody has judged: its print, and how it is read."""
    look = VerdictStyle("unjudged", "", "", "")
    return RowView(anchor, row.number, look, row.marks, row.printed_latex, row.read_as)


def _write_compared(latex: str) -> Markup:
    if len(latex) > LONGEST:
        return Markup('<code class="latex">{}</code>').format(latex)
    return write_lines(latex)


def _write_symbol(name: str, symbols: Mapping[str, str]) -> Markup:
    return write_formula(symbols[name]) if name in symbols else set_prose(name)


def render(template: str, **data: object) -> str:
    """Render one template; missing data is an error."""
    return _environment().get_template(f"{template}{SUFFIX}").render(**data)


def read_stylesheet() -> str:
    """Return the text of the stylesheet."""
    return files("mechproof.report").joinpath("templates", STYLESHEET).read_text(encoding="utf-8")


def read_font() -> str:
    """Return the rule of the stylesheet that embeds the font of formulas."""
    font = files("mechproof.report").joinpath("font", "mechproof-math.woff2").read_bytes()
    data = b64encode(font).decode("ascii")
    source = f"url(data:font/woff2;base64,{data}) format('woff2')"
    # The font's own line height, made for its largest signs, would spread lines and rows of
    # matrices.
    height = "ascent-override: 90%; descent-override: 35%; line-gap-override: 0%"
    return f'@font-face {{ font-family: "Mechproof Math"; {height}; src: {source}; }}\n'


@cache
def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("mechproof.report"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=True,
    )
    environment.filters |= {
        "cite": _cite,
        "compared": _write_compared,
        "numbers": set_numbers,
        "print": write_print,
        "prose": set_prose,
        "reason": set_reason,
        "slug": slugify,
        "symbol": _write_symbol,
        "unit": describe_unit,
        "value": set_value,
        "words": _say,
        "capfirst": capitalise,
    }
    environment.globals |= {"version": version("mechproof"), "meanings": MARKED}
    environment.globals |= {"shown": SHOWN, "long": LONG}
    return environment


def _cite(text: str) -> Markup:
    """Link the DOI of a citation."""
    link = Markup('<a href="https://doi.org/{0}">{0}</a>')
    parts = DOI.split(text)
    return Markup("").join(
        link.format(part) if odd else escape(part) for odd, part in zip(cycle((0, 1)), parts)
    )


def _say(name: str) -> str:
    """Write the name of a module as words."""
    return capitalise(name.replace("_", " ").replace("non ", "non-"))


# The tag that every page has in front of its stylesheet, by which a report is recognised.
MADE = '<meta name="generator" content="mechproof '
MOST_OF_HEAD = 1000

_BODY = re.compile(r'<main id="main" class="page">\n(.*)</main>', re.DOTALL)
_TITLE = re.compile(r"<h1>(.*?)</h1>", re.DOTALL)
# Names in pictures are digests of what is drawn, and are kept.
_PICTURE = re.compile(r"(<svg\b.*?</svg>)", re.DOTALL)
_NAMING = re.compile(r'(?<=\s)(id|for|name|aria-labelledby|href)="([^"]*)"')


@dataclass(frozen=True)
class JoinedPage:
    """A page as a part of the single file."""

    path: str
    title: str
    body: str

    @property
    def is_of_a_paper(self) -> bool:
        """Return whether it is the page of a paper, which the list of pages shows."""
        return self.path.startswith("papers/")


def check_file(file: Path) -> None:
    """Raise `ForeignFileError` if the file exists and is not a report."""
    if not file.exists():
        return
    if not file.is_file() or MADE.encode() not in file.read_bytes()[:MOST_OF_HEAD]:
        raise ForeignFileError(f"{file}: exists and is not a mechproof report; name another file")


def join_pages(files: Mapping[str, str]) -> str:
    """Return a single page with all pages of a report, the start page first."""
    pages = {path: text for path, text in files.items() if path != STYLESHEET}
    joined = [_cut_out(path, text, pages) for path, text in pages.items()]
    return render("single", style=files[STYLESHEET], pages=joined)


def _cut_out(path: str, text: str, pages: Container[str]) -> JoinedPage:
    body, title = _BODY.search(text), _TITLE.search(text)
    assert body, path
    assert title, path
    rename = partial(_rename, path=path, pages=pages)
    pieces = _PICTURE.split(body[1])
    pieces[::2] = [_NAMING.sub(rename, piece) for piece in pieces[::2]]
    return JoinedPage(path, unescape(title[1]), "".join(pieces))


def _rename(match: re.Match[str], path: str, pages: Container[str]) -> str:
    attribute, value = match.groups()
    if attribute == "href":
        return f'href="{_lead(value, path, pages)}"'
    names = " ".join(f"{path}/{name}" for name in value.split(" "))
    return f'{attribute}="{names}"'


def _lead(link: str, path: str, pages: Container[str]) -> str:
    """Return the link to a place within the file if its target is there, otherwise the old link."""
    place, _, name = unquote(unescape(link)).partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(path), place)) if place else path
    if target not in pages:
        return link
    return f"#{quote(f'{target}/{name}' if name else target)}"
