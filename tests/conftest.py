"""Options, grouping and fixtures shared by all tests."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any
from zlib import crc32

import pytest

from mechproof.tools.cache import VARIABLE

# The longest groups start first, so that no worker is left waiting for another at the end.
LONGEST = (
    *("report", "compiled track_wheel", "workshop", "cluster", "verdicts wedge_linkage"),
    *("verdicts track_wheel", "verdicts oval_planetary", "verdicts tooth_thickness"),
    *("tailoring/test_tailored_bounds.py", "verdicts elliptic_planetary", "coq/test_checker.py"),
    *("codegen/test_c99.py", "codegen/test_formula_languages.py", "pieces", "roots"),
    *("kernels/test_derivatives.py", "proof/test_mutations.py", "test_readme.py", "certificates"),
)

# Of a slow test with at least `MANY` cases, one in `SHOWN` (if it has that many) runs with the
# tests that are not slow, and one in `SLOW` of the others with the slow ones; the rest are
# thorough. The choice is the same each time. If the slow part is done once for all cases
# `together`, all of them stay slow.
MANY, SHOWN, SLOW = 6, 24, 8

# Suffixes of the files that make up a derivation.
DERIVED = (".py", ".tex", ".json")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option that runs a fixed share of the thorough tests."""
    told = "run one in N of the thorough tests, the same ones each time"
    parser.addoption("--one-in", type=int, default=1, metavar="N", help=told)


def pytest_configure(config: pytest.Config) -> None:
    """Refuse a share below 1."""
    if (count := config.getoption("one_in")) < 1:
        raise pytest.UsageError(f"--one-in = {count}: must be at least 1")


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Iterator[None]:
    """Turn garbage collection off during collection, and freeze the objects that it leaves.

    Afterwards, collect garbage less often: SymPy makes many long-lived objects.
    """
    if hasattr(session.config, "workerinput") or not session.config.getoption("tx"):
        _share_papers()
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.set_threshold(50_000)
        gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a file in one worker, which loads and compiles shared parts only once."""
    _part_cases(items)
    groups = {item: _find_group(item) for item in items}
    for item, group in groups.items():
        item.add_marker(pytest.mark.xdist_group(group))
    order = {group: number for number, group in enumerate(LONGEST)}
    items.sort(key=lambda item: order.get(groups[item], len(order)))


@pytest.hookimpl(trylast=True, specname="pytest_collection_modifyitems")
def pytest_choose_share(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Deselect the thorough tests outside the share that `--one-in` asks for."""
    thorough = [item for item in items if item.get_closest_marker("thorough")]
    left_out = {*thorough} - {*_take_share(thorough, config.getoption("one_in"))}
    if left_out:
        config.hook.pytest_deselected(items=[item for item in items if item in left_out])
        items[:] = [item for item in items if item not in left_out]


def _part_cases(items: list[pytest.Item]) -> None:
    """Run a few cases of each slow test in every run, and make most of the others thorough."""
    slow: dict[str, list[pytest.Item]] = {}
    for item in items:
        mark = item.get_closest_marker("slow")
        if item.get_closest_marker("thorough"):
            _unmark(item)
        elif mark and not mark.kwargs.get("together"):
            slow.setdefault(item.nodeid.split("[")[0], []).append(item)
    for cases in slow.values():
        if len(cases) < MANY:
            continue
        shown = _take_share(cases, SHOWN) if len(cases) >= SHOWN else []
        kept = _take_share([item for item in cases if item not in shown], SLOW)
        for item in cases:
            if item not in kept:
                _unmark(item)
            if item not in kept and item not in shown:
                item.add_marker(pytest.mark.thorough)


def _unmark(item: pytest.Item) -> None:
    item.own_markers = [mark for mark in item.own_markers if mark.name != "slow"]


def _take_share(items: list[pytest.Item], count: int) -> list[pytest.Item]:
    """Return one in `count` tests, the same ones each time, ordered by a digest of their names."""
    names = {item: f"{item.path.name} {item.name}" for item in items}
    return sorted(items, key=lambda item: crc32(names[item].encode()))[::count]


def _share_papers() -> None:
    """Run each of our own derivations once per process, as long as its files do not change.

    The files are still read each time, so that code which notes the files behind a paper notes the
    same ones. Modules that a test imported before the first run stay the ones in use.
    """
    from mechproof import derivation

    run = derivation._run
    # The installed derivations, and those that commands find in the checkout.
    ours = {
        derivation.packaged_directory().resolve(),
        Path(__file__).resolve().parents[1] / "derivations",
    }
    known: dict[Path, tuple[dict[Path, bytes], Any]] = {}

    def run_once(place: Path) -> Any:
        if place.parent not in ours:
            return run(place)
        files = [*place.parent.glob("_*"), *(place.rglob("*") if place.is_dir() else [place])]
        read = {file: file.read_bytes() for file in files if file.suffix in DERIVED}
        if place not in known:
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(derivation, "_forget", lambda *names: None)
                known[place] = read, run(place)
        elif known[place][0] != read:
            known[place] = read, run(place)
        return known[place][1]

    derivation._run = run_once


def _find_group(item: pytest.Item) -> str:
    """Return the group that a test is marked with, or else its file."""
    marked = item.get_closest_marker("xdist_group")
    return str(marked.args[0] if marked else item.path.relative_to(Path(__file__).parent))


@pytest.fixture(autouse=True, scope="session")
def cache_apart(request: pytest.FixtureRequest) -> Iterator[None]:
    """Keep test verdicts out of the user's cache, in one that `--cache-clear` empties.

    A row is judged again when the prover or the row changes, so all processes of a run, and later
    runs, can share verdicts.
    """
    cache = request.config.cache
    assert cache is not None
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(VARIABLE, str(cache.mkdir("mechproof")))
        yield


@pytest.fixture(autouse=True, scope="session")
def commands_built_once() -> Iterator[None]:
    """Build an app's commands once: building them for each call takes longer than most calls."""
    from typer.main import get_command

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("typer.testing._get_command", cache(get_command))
        yield


@pytest.fixture
def judged_here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Judge equations and papers in this process: starting another takes longer than most do."""
    from command import answer_here

    for module in ("pipeline.pasted", "document.judging_workers"):
        monkeypatch.setattr(f"mechproof.{module}.run_tasks", answer_here)
