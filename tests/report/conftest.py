"""A report of one paper of the package and of three of a user's own."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest
from own_papers import TESTS, write_hostile, write_slider_crank

from mechproof.derivation import packaged_directory
from mechproof.report import build_site, write_folder
from mechproof.verification import judge_derivations


def build(locations: Sequence[Path]) -> dict[str, str]:
    return dict(build_site(locations, judge_derivations(locations)).files)


@pytest.fixture(scope="session")
def papers(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """The files of a user's own papers, in a folder of derivations."""
    folder = tmp_path_factory.mktemp("own") / "derivations"
    shutil.copytree(TESTS / "own_paper" / "derivations", folder)
    return [folder / "universal_joint.py", write_slider_crank(folder), write_hostile(folder)]


@pytest.fixture(scope="session")
def files(papers: list[Path]) -> dict[str, str]:
    """The files of the report by their names."""
    return build([packaged_directory() / "elliptic_planetary", *papers])


@pytest.fixture(scope="session")
def site(files: dict[str, str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report in a folder."""
    folder = tmp_path_factory.mktemp("site") / "a report"
    write_folder(folder, files)
    return folder
