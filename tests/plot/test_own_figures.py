"""Figures in a user's own folder: found, drawn by the command, and refused where wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.derivation import DerivationError
from mechproof.plot.figures import Figure, find_figures

PAPER = """
from sympy import Symbol
from mechproof.record import Equation, Paper, Variable
x = Symbol("x", real=True)
PAPER = Paper(
    system="mine",
    citation="a note",
    variables=(Variable(x, "a number", latex=("x",)),),
    rows=(Equation("(1)", "x=x"),),
)
"""
PICTURES = """
from mechproof.plot import Figure
from . import PAPER

def draw(canvas):
    canvas.subplots().plot([0, 1], [1, 0])

FIGURES = (
    Figure("fig-1", "Fig. 1", "A line falls.", PAPER.citation, "(1)", draw),
)
"""


@pytest.fixture
def place(tmp_path: Path) -> Path:
    folder = tmp_path / "derivations" / "mine"
    folder.mkdir(parents=True)
    (folder / "__init__.py").write_text(PAPER, encoding="utf-8")
    (folder / "pictures.py").write_text(PICTURES, encoding="utf-8")
    return folder


def test_figures_of_a_folder_of_ones_own_are_found(place: Path) -> None:
    (figure,) = find_figures(place)
    assert (figure.name, figure.caption, figure.after) == ("fig-1", "a note", "(1)")


def test_a_derivation_without_pictures_has_no_figures(place: Path) -> None:
    (place / "pictures.py").unlink()
    assert find_figures(place) == ()
    (place.parent / "single.py").write_text(PAPER, encoding="utf-8")
    assert find_figures(place.parent / "single.py") == ()


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("FIGURES = 3", "must bind a tuple of mechproof.plot.Figure"),
        ("FIGURES = (1,)", "must bind a tuple of mechproof.plot.Figure"),
        ("pass", "must bind a tuple of mechproof.plot.Figure"),
        (PICTURES + "FIGURES += FIGURES", "two figures with the same name: fig-1"),
        ("1 / 0", "pictures.py:1: ZeroDivisionError"),
    ],
)
def test_what_is_wrong_with_pictures_is_said(place: Path, text: str, says: str) -> None:
    (place / "pictures.py").write_text(text, encoding="utf-8")
    with pytest.raises(DerivationError, match=says):
        find_figures(place)


@pytest.mark.parametrize(
    ("changed", "error", "says"),
    [
        ({"name": "Fig 1"}, ValueError, "name = 'Fig 1'"),
        ({"name": "../x"}, ValueError, "name"),
        ({"draw": None}, TypeError, "draw = None"),
        ({"width": 0.0}, ValueError, "width = 0.0: must be positive"),
        ({"height": "tall"}, TypeError, "height = 'tall'"),
    ],
)
def test_a_figure_checks_what_it_is_given(
    changed: dict[str, object], error: type[Exception], says: str
) -> None:
    given = {
        "name": "fig-1",
        "number": None,
        "title": "A line.",
        "caption": "A line falls.",
        "after": "(1)",
        "draw": print,
    }
    with pytest.raises(error, match=says):
        Figure(**{**given, **changed})


def test_the_command_writes_both_kinds_and_says_what_they_show(place: Path, tmp_path: Path) -> None:
    out = tmp_path / "figures"
    done = CliRunner().invoke(
        app, ["figures", "--derivations", str(place.parent), "--out", str(out)]
    )
    assert done.exit_code == 0, done.output
    assert sorted(path.name for path in out.iterdir()) == ["mine.fig-1.png", "mine.fig-1.svg"]
    for kind in ("png", "svg"):
        assert f"mine.fig-1.{kind}: A line falls." in done.output.replace("\n", "")
    assert (out / "mine.fig-1.svg").read_text(encoding="utf-8").startswith("<svg ")


def test_the_command_fails_where_there_is_nothing_to_draw(place: Path, tmp_path: Path) -> None:
    (place / "pictures.py").unlink()
    done = CliRunner().invoke(app, ["figures", str(place), "--out", str(tmp_path / "figures")])
    assert done.exit_code == 1
    assert "no figures" in done.stderr


def test_the_command_says_which_drawing_fails(place: Path, tmp_path: Path) -> None:
    broken = PICTURES.replace("[1, 0]", "[1, 0, 2]")
    (place / "pictures.py").write_text(broken, encoding="utf-8")
    done = CliRunner().invoke(app, ["figures", str(place), "--out", str(tmp_path / "figures")])
    assert done.exit_code == 1
    assert "fig-1" in done.stderr
    assert "pictures.py:6: ValueError" in done.stderr


def test_the_command_draws_the_others_and_names_every_failure_once(
    place: Path, tmp_path: Path
) -> None:
    (place / "pictures.py").write_text(
        PICTURES + 'for name, act in (("bad", lambda canvas: 1 / 0),'
        ' ("odd", lambda canvas: canvas.text(0, 0, r"$\\frac$"))):\n'
        '    FIGURES = (Figure(name, None, "A title", "", "(1)", act), *FIGURES)\n',
        encoding="utf-8",
    )
    out = tmp_path / "figures"
    done = CliRunner().invoke(app, ["figures", str(place), "--out", str(out)])
    assert done.exit_code == 1
    odd, bad = done.stderr.splitlines()
    assert bad.startswith(f"mine bad: {place.resolve()}/pictures.py:11: ZeroDivisionError")
    assert odd.startswith("mine odd: ValueError: ")
    assert sorted(path.name for path in out.iterdir()) == ["mine.fig-1.png", "mine.fig-1.svg"]
