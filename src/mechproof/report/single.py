"""One file: the files of a report in, one page that holds them all out.

Each page becomes a part of it. What is named in a page is named by its path, too, and its links
lead within the file.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Container, Mapping
from dataclasses import dataclass
from functools import partial
from html import unescape
from pathlib import Path
from urllib.parse import quote, unquote

from mechproof.report.pages import STYLESHEET, render
from mechproof.tools.made import ForeignFileError

# What every page says before its stylesheet.
MADE = '<meta name="generator" content="mechproof '
MOST_OF_HEAD = 1000

_BODY = re.compile(r'<main id="main" class="page">\n(.*)</main>', re.DOTALL)
_TITLE = re.compile(r"<h1>(.*?)</h1>", re.DOTALL)
# Names in pictures are digests of what is drawn, and stay.
_PICTURE = re.compile(r"(<svg\b.*?</svg>)", re.DOTALL)
_NAMING = re.compile(r'(?<=\s)(id|for|name|aria-labelledby|href)="([^"]*)"')


@dataclass(frozen=True)
class JoinedPage:
    """A page as a part of the one."""

    path: str
    title: str
    body: str

    @property
    def is_of_a_paper(self) -> bool:
        """Tell whether it stands in the list of pages, which is as long as that of any page."""
        return self.path.startswith("papers/")


def check_file(file: Path) -> None:
    """Raise `ForeignFileError` for what is there and is no report."""
    if not file.exists():
        return
    if not file.is_file() or MADE.encode() not in file.read_bytes()[:MOST_OF_HEAD]:
        raise ForeignFileError(f"{file}: is there and is no report of mechproof; name another file")


def join_pages(files: Mapping[str, str]) -> str:
    """Return one page of all pages of a report, the start page first."""
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
    """Return the link within the file where what it leads to is there."""
    place, _, name = unquote(unescape(link)).partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(path), place)) if place else path
    if target not in pages:
        return link
    return f"#{quote(f'{target}/{name}' if name else target)}"
