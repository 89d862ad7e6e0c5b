"""Layout: views in, pages and fragments out; every text from a paper is escaped."""

from __future__ import annotations

import re
from base64 import b64encode
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from itertools import cycle

import jinja2
from markupsafe import Markup, escape

from mechproof.codegen.docstrings import capitalise, tell_unit
from mechproof.proof.anchors import slugify
from mechproof.report.formulas import write_print
from mechproof.report.phrases import set_prose
from mechproof.report.row_views import MARKED

STYLESHEET = "report.css"
SUFFIX = ".html.jinja"
DOI = re.compile(r"(?<=doi )(10\.\d{4,9}/[^\s,;]*[\w/])", re.IGNORECASE)


def render(template: str, **data: object) -> str:
    """Render one template; what it asks for and is not given is an error."""
    return _environment().get_template(f"{template}{SUFFIX}").render(**data)


def read_stylesheet() -> str:
    """Return the one stylesheet."""
    return files("mechproof.report").joinpath("templates", STYLESHEET).read_text(encoding="utf-8")


def read_font() -> str:
    """Return the rule of the stylesheet that holds the font of formulas."""
    font = files("mechproof.report").joinpath("font", "mechproof-math.woff2").read_bytes()
    data = b64encode(font).decode("ascii")
    source = f"url(data:font/woff2;base64,{data}) format('woff2')"
    # The font's own height, made for its largest signs, would part lines and rows of matrices.
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
        "print": write_print,
        "prose": set_prose,
        "slug": slugify,
        "unit": tell_unit,
        "words": _say,
        "capfirst": capitalise,
    }
    environment.globals |= {"version": version("mechproof"), "meanings": MARKED}
    return environment


def _cite(text: str) -> Markup:
    """Link the DOI of a citation."""
    link = Markup('<a href="https://doi.org/{0}">{0}</a>')
    parts = DOI.split(text)
    return Markup("").join(
        link.format(part) if odd else escape(part) for odd, part in zip(cycle((0, 1)), parts)
    )


def _say(name: str) -> str:
    """Say the name of a module as words."""
    return capitalise(name.replace("_", " ").replace("non ", "non-"))
