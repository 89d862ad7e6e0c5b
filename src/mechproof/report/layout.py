"""Layout: views in, pages and fragments out; every text from a paper is escaped."""

from __future__ import annotations

from functools import cache
from importlib.metadata import version
from importlib.resources import files

import jinja2

from mechproof.report.anchors import slugify
from mechproof.report.rows import MARKED

STYLESHEET = "report.css"
SUFFIX = ".html.jinja"


def render(template: str, **data: object) -> str:
    """Render one template; what it asks for and is not given is an error."""
    return _environment().get_template(f"{template}{SUFFIX}").render(**data)


def read_stylesheet() -> str:
    """Return the one stylesheet."""
    return files("mechproof.report").joinpath("templates", STYLESHEET).read_text(encoding="utf-8")


@cache
def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("mechproof.report"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=True,
    )
    environment.filters |= {"slug": slugify, "words": _say, "capfirst": _begin}
    environment.globals |= {"version": version("mechproof"), "meanings": MARKED}
    return environment


def _say(name: str) -> str:
    """Say the name of a module as words."""
    return _begin(name.replace("_", " "))


def _begin(text: str) -> str:
    return text[:1].upper() + text[1:]
