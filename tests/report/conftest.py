"""A report of one paper of the package and three of a user's own."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Sequence
from importlib.resources.abc import Traversable
from pathlib import Path

import pytest
from own_papers import TESTS, write_hostile, write_slider_crank

from mechproof.derivation import packaged_directory
from mechproof.measured import Record
from mechproof.pipeline.verification import judge_derivations
from mechproof.report import build_site, judged_derivations, write_folder
from mechproof.report.judged_derivations import read_records

# The quantities whose measurements are shown in every run; thorough runs show them all: a chart
# takes longer than the rest of its page.
SHOWN = ("position", "ratio", "largest_ratio", "eccentricity_of_extremes")


def build(locations: Sequence[Path]) -> dict[str, str]:
    return dict(build_site(locations, judge_derivations(locations)).files)


def read_shown(folder: Traversable, names: Iterable[str]) -> Sequence[Record]:
    """Read the records of those quantities that are in `SHOWN`."""
    return read_records(folder, [name for name in names if name.partition(".")[2] in SHOWN])


@pytest.fixture(scope="session")
def papers(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Return the files of a user's own papers, in a folder of derivations."""
    folder = tmp_path_factory.mktemp("own") / "derivations"
    shutil.copytree(TESTS / "own_paper" / "derivations", folder)
    return [folder / "universal_joint.py", write_slider_crank(folder), write_hostile(folder)]


@pytest.fixture(scope="session")
def files(papers: list[Path], request: pytest.FixtureRequest) -> dict[str, str]:
    """Return the texts of the report's files by their names."""
    with pytest.MonkeyPatch.context() as patch:
        if request.config.getoption("markexpr") != "thorough":
            patch.setattr(judged_derivations, "read_records", read_shown)
        return build([packaged_directory() / "elliptic_planetary", *papers])


@pytest.fixture(scope="session")
def site(files: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder into which the report is written."""
    folder = tmp_path_factory.mktemp("site") / "a report"
    write_folder(folder, files)
    return folder
