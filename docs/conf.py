"""The documentation as a site: `sphinx-build -W docs site`, the report in it with `-t report`."""

import re
import subprocess
import sys
from importlib.metadata import version as read_version
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert

project = "mechproof"
author = "The mechproof authors"
copyright = "2026, the mechproof authors"
release = version = read_version("mechproof")

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
]
exclude_patterns = ["tour.ipynb"]
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 3
# Files of the repository that pages point to are no pages of the site.
suppress_warnings = ["myst.xref_missing"]

# Docstrings are plain text in which `code` stands between single backticks.
default_role = "code"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
autodoc_member_order = "bysource"
autosummary_generate = True
python_use_unqualified_type_names = True

html_math_renderer = "mathml"
html_theme = "furo"
html_title = "mechproof"
html_static_path: list[str] = []


def plain(app: Any, what: str, name: str, found: Any, options: Any, lines: list[str]) -> None:
    """Take docstrings as plain text: formulas hold characters that are markup to Sphinx."""
    if name.startswith("mechproof.kernels."):
        # The formulas of kernels stand in lines of their own, as in the source.
        lines[:] = ["::", "", *(f"   {line}" for line in lines), ""]
    else:
        lines[:] = [re.sub(r"\||(?<!^)(?<!\*)\*(?!\*)", r"\\\g<0>", line) for line in lines]


def write_math(translator: Any, node: nodes.math | nodes.math_block) -> None:
    """Write a formula as MathML, which browsers show without a script."""
    display = "block" if isinstance(node, nodes.math_block) else "inline"
    translator.body.append(convert(node.astext(), display=display))
    raise nodes.SkipNode


def write_report(app: Any, exception: Exception | None) -> None:
    """Write the pages of the papers and of their quantities into the site."""
    if exception is None and app.tags.has("report"):
        command = [sys.executable, "-m", "mechproof", "report", "--out"]
        subprocess.run([*command, f"{app.outdir}/report"], check=True)


def setup(app: Any) -> None:
    """Register what is done to docstrings and formulas, and what stands beside the pages."""
    app.connect("build-finished", write_report)
    app.connect("autodoc-process-docstring", plain)
    app.add_html_math_renderer("mathml", (write_math, None), (write_math, None))
