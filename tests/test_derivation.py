"""Finding and loading derivations: files, folders, shared modules, faults, names."""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from mechproof.derivation import (
    DerivationError,
    find_systems,
    load_paper,
    load_part,
    packaged_directory,
)
from mechproof.pipeline.verification import judge_derivations
from mechproof.record import RESERVED, Argument, Paper

SHARED = 'CITATION = "my notes"\n'
PAPER = "from mechproof.record import Paper\n"
X = sp.Symbol("x", real=True)


def write(folder: Path, **files: str) -> Path:
    """Write modules; a double underscore in a name separates a folder from what it contains."""
    for name, text in files.items():
        file = folder.joinpath(*name.split("__")).with_suffix(".py")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return folder


def write_folder(folder: Path) -> Path:
    """Write a large system as a folder, a small one as a file, and the module that both share."""
    (folder / "large").mkdir(parents=True)
    (folder / "large" / "__init__.py").write_text("from .paper import PAPER\n")
    paper = f'{PAPER}from .._shared import CITATION\nPAPER = Paper("large", CITATION, (), ())\n'
    small = f'{PAPER}from ._shared import CITATION\nPAPER = Paper("small", CITATION, (), ())\n'
    peers = "from .paper import PAPER as OTHER\nPEERS = {}\n"
    return write(folder, _shared=SHARED, large__paper=paper, large__peers=peers, small=small)


def test_systems_are_files_and_folders(tmp_path: Path) -> None:
    write_folder(tmp_path)
    (tmp_path / "data").mkdir()
    (tmp_path / "_drafts").mkdir()
    (tmp_path / "_drafts" / "__init__.py").touch()
    (tmp_path / ".#small.py").touch()
    assert find_systems(tmp_path) == {"large": tmp_path / "large", "small": tmp_path / "small.py"}


def test_a_system_has_one_home(tmp_path: Path) -> None:
    write_folder(tmp_path)
    (tmp_path / "large.py").touch()
    with pytest.raises(DerivationError, match="both a file and a folder of large"):
        find_systems(tmp_path)


def test_relative_imports_work_in_any_folder(tmp_path: Path) -> None:
    papers = [load_paper(place) for place in find_systems(write_folder(tmp_path)).values()]
    assert [(p.system, p.citation) for p in papers] == [(s, "my notes") for s in ("large", "small")]


def test_two_folders_do_not_meet(tmp_path: Path) -> None:
    one, other = write_folder(tmp_path / "one"), write_folder(tmp_path / "other")
    (other / "_shared.py").write_text('CITATION = "others"\n')
    found = [load_paper(folder / "large").citation for folder in (one, other, one)]
    assert found == ["my notes", "others", "my notes"]


def test_an_edited_file_is_read_again(tmp_path: Path) -> None:
    write_folder(tmp_path)
    for citation in ("their notes", "our notes !", "his notes !"):  # equally long, in one second
        (tmp_path / "_shared.py").write_text(f'CITATION = "{citation}"\n')
        assert load_paper(tmp_path / "large").citation == citation
        assert load_paper(tmp_path / "small.py").citation == citation
    assert not list(tmp_path.rglob("__pycache__"))


def test_a_room_of_a_paper_may_be_a_folder(tmp_path: Path) -> None:
    place = write_folder(tmp_path) / "large"
    paper = (place / "paper.py").read_text()
    write(place, paper=paper.replace(".._shared", ".rows"))
    write(place, rows__notes="from ..._shared import CITATION\n")
    (place / "rows" / "__init__.py").write_text("from .notes import CITATION\n")
    assert load_paper(place).citation == "my notes"
    write(place, rows__notes='CITATION = "theirs"\n')
    assert load_paper(place).citation == "theirs"
    write(place, rows__notes="\n1 / 0\n")
    with pytest.raises(DerivationError, match=r"rows/notes\.py:2: ZeroDivisionError"):
        load_paper(place)


def test_no_modules_are_left_of_earlier_loads(tmp_path: Path) -> None:
    write_folder(tmp_path)
    load_paper(tmp_path / "large")
    before = set(sys.modules)
    load_paper(tmp_path / "large")
    assert len(set(sys.modules) - before) == len(before - set(sys.modules))


def test_a_file_may_have_any_name(tmp_path: Path) -> None:
    file = tmp_path / "draft-2.1.py"
    file.write_text(f'{PAPER}PAPER = Paper("draft", "", (), ())\n')
    assert load_paper(file).system == "draft"


def test_packaged_papers_are_modules_of_the_package() -> None:
    places = find_systems(packaged_directory())
    load_paper(places["elliptic_planetary"])
    assert "mechproof.derivations.elliptic_planetary" in sys.modules


def test_parts_share_the_modules_of_the_paper(tmp_path: Path) -> None:
    place = write_folder(tmp_path) / "large"
    paper = load_paper(place)
    for location in (place, place / "__init__.py"):
        part = load_part(location, "peers")
        assert part is not None
        assert part.OTHER is paper
    assert load_part(place, "points") is None
    assert load_part(tmp_path / "small.py", "peers") is None


def test_a_part_is_found_before_its_paper_was_loaded(tmp_path: Path) -> None:
    part = load_part(write_folder(tmp_path) / "large", "peers")
    assert part is not None
    assert part.OTHER.system == "large"


@pytest.mark.parametrize(
    ("name", "text", "line"),
    [
        ("large__paper", "import sympy\n\nimport nowhere\n", 3),
        ("large__paper", "x = 1\nx = (\n", 2),
        ("_shared", "\n\n\n1 / 0\n", 4),
        ("large__paper", "import sympy\nsympy.Symbol(1)\n", 2),
        ("large__paper", f"{PAPER}\nraise SystemExit(3)\n", 3),
        ("large__paper", f'{PAPER}PAPER = Paper("../x", "", (), ())\n', 2),
    ],
)
def test_a_fault_is_named_with_file_and_line(
    tmp_path: Path, name: str, text: str, line: int
) -> None:
    write(write_folder(tmp_path), **{name: text})
    file = tmp_path.joinpath(*name.split("__")).with_suffix(".py")
    with pytest.raises(DerivationError) as caught:
        load_paper(tmp_path / "large")
    assert str(caught.value).startswith(f"{file}:{line}: ")


def test_a_fault_in_a_library_below_is_charged_to_the_derivation(tmp_path: Path) -> None:
    write(tmp_path, lib__site__library="1 / 0\n")
    path = tmp_path / "lib" / "site"
    write(tmp_path, mine=f"import sys\nsys.path.insert(0, {str(path)!r})\nimport library\n")
    with pytest.raises(DerivationError, match=r"mine\.py:3: ZeroDivisionError"):
        load_paper(tmp_path / "mine.py")
    sys.path.remove(str(path))


def test_a_fault_of_a_part_is_named(tmp_path: Path) -> None:
    write(write_folder(tmp_path), large__peers="\nimport nowhere\n")
    with pytest.raises(DerivationError, match=r"peers\.py:2: ModuleNotFoundError"):
        load_part(tmp_path / "large", "peers")


@pytest.mark.parametrize("text", ["", "PAPER = 1\n"])
def test_a_derivation_binds_a_paper(tmp_path: Path, text: str) -> None:
    with pytest.raises(DerivationError, match=r"mine\.py: must bind a mechproof\.record\.Paper"):
        load_paper(write(tmp_path, mine=text) / "mine.py")


def test_what_does_not_exist_is_said(tmp_path: Path) -> None:
    with pytest.raises(DerivationError, match=r"gone\.py: does not exist"):
        load_paper(tmp_path / "gone.py")


def test_two_papers_of_one_name_are_refused(tmp_path: Path) -> None:
    text = f'{PAPER}PAPER = Paper("same", "", (), ())\n'
    with pytest.raises(DerivationError, match=r"other\.py: its paper has the same name"):
        judge_derivations(list(find_systems(write(tmp_path, mine=text, other=text)).values()))


@pytest.mark.parametrize(
    "system", ["../../x", "", "class", "__init__", "_x", "a b", "1x", "a.b", *RESERVED]
)
def test_a_system_is_the_name_of_a_module(system: str) -> None:
    with pytest.raises(ValueError, match="paper: system = "):
        Paper(system, "", (), ())


def test_numbers_of_sympy_are_taken_as_numbers() -> None:
    argument = Argument("x", (X,), "", default=sp.pi, usual=(-sp.Rational(1, 2), 0, Fraction(1, 4)))
    assert (argument.default, argument.usual) == (float(sp.pi), (-0.5, 0, 0.25))
    assert all(isinstance(edge, int | float) for edge in argument.usual)


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"usual": (0, X)}, "argument 'x': usual = x: must be a number"),
        ({"usual": (0, "1")}, "argument 'x': usual = '1': must be a number"),
        ({"usual": (0, sp.oo)}, "argument 'x': usual = oo: must be a number"),
        ({"usual": (0, sp.I)}, "argument 'x': usual = I: must be a number"),
        ({"default": float("nan")}, "argument 'x': default = nan: must be a number"),
        ({"usual": (1,)}, r"argument 'x': usual = \(1,\): must be two or more rising"),
        ({"usual": (0, 2, 2)}, r"argument 'x': usual = \(0, 2, 2\): must be two or more rising"),
    ],
)
def test_an_argument_with_other_sizes_is_refused(given: dict[str, Any], told: str) -> None:
    with pytest.raises(ValueError, match=told):
        Argument("x", (X,), "", **given)
