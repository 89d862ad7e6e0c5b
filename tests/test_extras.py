"""Extras: what a user is told to install, and what still works without them."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest
from command import PROVED, run, write

from mechproof.codegen.backends import numpy as numpy_backend
from mechproof.tools import extras


class Installed(metadata.Distribution):
    """A distribution whose only file is direct_url.json, holding `url`, or that has none."""

    def __init__(self, url: str | None) -> None:
        self.url = url

    def read_text(self, filename: str) -> str | None:
        wanted = filename == "direct_url.json" and self.url is not None
        return json.dumps({"url": self.url}) if wanted else None

    def locate_file(self, path: object) -> Path:
        raise NotImplementedError


def install_from(url: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "distribution", lambda name: Installed(url))


@pytest.mark.parametrize("url", [None, "https://example.org/mechproof.zip", "file:///not/there"])
def test_without_a_folder_the_package_is_named(
    url: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    install_from(url, monkeypatch)
    assert extras.suggest_install("fast") == "pip install 'mechproof[fast]'"


def test_the_folder_that_was_installed_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "with a blank"
    folder.mkdir()
    (folder / "pyproject.toml").touch()
    install_from(folder.as_uri(), monkeypatch)
    assert extras.suggest_install("derive") == f"pip install '{folder}[derive]'"


def test_what_is_not_there_is_named_with_the_command() -> None:
    with pytest.raises(ImportError, match=re.escape("a drawing needs no_such_module, the extra x")):
        extras.require_modules("a drawing", "x", ("json", "no_such_module"))


# Stands in for a plain install: the finder does not find packages that only extras bring.
PLAIN = """
import importlib.machinery as m
find, gone = m.PathFinder.find_spec, ("flint", "jinja2", "sympy", "uncertainties")
m.PathFinder.find_spec = classmethod(
    lambda cls, name, *rest: None if name.partition(".")[0] in gone else find(name, *rest)
)
from mechproof import *
from mechproof.measurement import Estimate, to_ufloat
try:
    CALL
except ImportError as error:
    print(error)
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("call", "what", "extra"),
    [
        ("bound('x + y')", "mechproof.bound needs sympy", "derive"),
        ("check('x=x')", "mechproof.check needs sympy", "derive"),
        ("formula('elliptic_planetary.ratio')", "mechproof.formula needs sympy", "derive"),
        ("OvalPlanetary.find_dwells(0.3, eta=0.1)", "find_dwells needs flint", "derive"),
        ("to_ufloat(Estimate(1, 0.1))", "a ufloat needs uncertainties", "uncertain"),
        ("print(EllipticPlanetary(60, 20, 0.3).radius_ratio)", "3.0", ""),
    ],
)
def test_a_plain_install_has_all_names_and_tells_what_a_call_lacks(
    call: str, what: str, extra: str
) -> None:
    command = [sys.executable, "-c", PLAIN.replace("CALL", call)]
    done = subprocess.run(command, capture_output=True, text=True)
    told = f", the extra {extra}: {extras.suggest_install(extra)}" if extra else ""
    assert (done.stdout, done.stderr) == (f"{what}{told}\n", "")


def test_versions_that_differ_from_the_pinned_ones_are_named(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert extras.list_other_versions("regenerate") == []
    pinned = ["sympy==1.14.0; extra == 'regenerate'", "none==1.0 ; extra == 'regenerate'"]
    monkeypatch.setattr(extras, "requires", lambda name: [*pinned, "numpy>=2", "x==1; extra=='y'"])
    monkeypatch.setattr(extras, "_find_version", {"sympy": "1.15.0", "none": "missing"}.get)
    said = ["sympy 1.15.0 instead of 1.14.0", "none missing instead of 1.0"]
    assert extras.list_other_versions("regenerate") == said


def test_only_what_is_written_needs_the_formatter(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (numpy_backend, extras):
        monkeypatch.setattr(module, "find_spec", lambda name: None if name == "ruff" else object())
    assert numpy_backend.format_source("x = ( 1)\n") == "x = ( 1)\n"
    (tmp_path / "derivations").mkdir()
    write(tmp_path / "derivations", PROVED)
    result = run("regenerate", "--root", str(tmp_path))
    assert (result.exit_code, list(tmp_path.iterdir())) == (1, [tmp_path / "derivations"])
    said = "generated code needs ruff, the extra regenerate: pip install"
    assert said in " ".join(result.output.split())
