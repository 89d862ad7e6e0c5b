"""The store behind all caches: where it is, what counts as absent, and what a write leaves."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from import_graph import find_reached, read_graph

from mechproof.ledger import verdict_cache as verdicts
from mechproof.pipeline import stages
from mechproof.roundoff import certificate_files as certificates
from mechproof.tools import cache
from mechproof.tools.cache import MOST_KEYS, VARIABLE, Store, cache_folder, make_key, name_place

# The worker of test_layers.py also runs this file: it has read the imports of all modules.
pytestmark = pytest.mark.xdist_group("test_layers.py")


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Store:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    return Store("ledgers/mine.json")


def test_what_is_written_is_read_and_replaces_what_was_there(store: Store) -> None:
    assert store.read() == {}
    store.write({"a": [1, 2], "b": None})
    assert store.read() == {"a": [1, 2], "b": None}
    store.write({"c": "three"})
    assert store.read() == {"c": "three"}
    assert [path.name for path in store.file.parent.iterdir()] == ["mine.json"]


@pytest.mark.parametrize("text", [b"", b"{", b"[]", b"null", b"\xff", b"1"])
def test_what_is_damaged_is_as_good_as_absent(store: Store, text: bytes) -> None:
    store.write({"a": 1})
    store.file.write_bytes(text)
    assert store.read() == {}
    store.add(["b"])
    assert store.read() == {"b": None}


def test_an_interrupted_write_leaves_the_old_entries(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    store.write({"a": 1})

    def stop(*files: Path) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr("os.replace", stop)
        with pytest.raises(KeyboardInterrupt):
            store.write({"b": 2})
    assert store.read() == {"a": 1}


def test_keys_are_kept_once_and_the_oldest_are_forgotten(store: Store) -> None:
    store.add(map(str, range(MOST_KEYS)))
    store.add(["5", "new"])
    assert len(store.read()) == MOST_KEYS
    assert {"0", "new"} - store.read().keys() == {"0"}
    assert list(store.read())[-1] == "new"


def test_what_cannot_be_kept_is_told_once(store: Store, tmp_path: Path) -> None:
    (tmp_path / "cache").write_text("a file")
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("default")
        for name in ("validated.json", "certified.json", "mine.json"):
            Store(name).add(["a"])
    (warning,) = told
    assert str(warning.message) == f"nothing is cached in {tmp_path / 'cache'}: File exists"
    assert warning.category is RuntimeWarning
    assert store.read() == {}


def test_a_key_is_of_files_versions_and_texts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "source.py"
    source.write_text("1")
    key = make_key([source], ["sympy"], "text")
    assert make_key([source], ["sympy"], "text") == key
    others = {make_key([source], ["numpy"], "text"), make_key([source], ["sympy"], "other")}
    source.write_text("2")
    others.add(make_key([source], ["sympy"], "text"))
    source.write_text("1")
    monkeypatch.setattr(cache, "version", lambda name: "another")
    others.add(make_key([source], ["sympy"], "text"))
    assert len(others | {key}) == 5


def test_another_place_has_another_name(tmp_path: Path) -> None:
    names = {name_place(tmp_path / name) for name in ("a.py", "b/a.py", "b.py")}
    assert len(names) == 3
    assert name_place(tmp_path / "b" / ".." / "a.py") in names


def reached(*starts: str) -> set[str]:
    """Return the modules that `starts` import, directly or not, except those that handle files.

    `processes` is reached only through the loader, whose time it limits.
    """
    graph = {module: kinds.run for module, kinds in read_graph().items()}
    finding = ("chosen", "derivation", "measured", "tools")
    found = {module.removeprefix("mechproof.") for module in find_reached(graph, *starts)}
    return {module for module in found if not module.startswith(finding)}


@pytest.mark.slow
def test_what_passed_rests_on_all_that_validates() -> None:
    modules = reached("mechproof.lab.validation", "mechproof.lab.subject")
    assert {module.partition(".")[0] for module in modules} <= set(stages.LAYERS)


def test_a_verdict_rests_on_all_that_judges() -> None:
    modules = reached("mechproof.proof.judge", "mechproof.proof.ladder")
    layers = {module.partition(".")[0] for module in modules}
    assert layers == {*verdicts.LAYERS}


def test_a_certificate_rests_on_all_that_proves_it() -> None:
    """Modules that make programs count through the program itself, which the keys contain."""
    before = ("record", "codegen.", "programs.")
    files = {f"{m.replace('.', '/')}.py" for m in reached("mechproof.roundoff.certificate")}
    package = Path(cache.__file__).parents[1]
    covered = {
        path.relative_to(package).as_posix()
        for pattern in certificates.SOURCES
        for path in package.glob(pattern)
    }
    missed = {file for file in files - covered if (package / file).is_file()}
    assert {m for m in missed if not m.replace("/", ".").startswith(before)} == set()
    assert {"arithmetic/ball_functions.py", "kernel_support/error_free.py"} <= covered


@pytest.mark.parametrize(
    ("platform", "variables", "folder"),
    [
        ("linux", {"XDG_CACHE_HOME": "/c"}, "/c/mechproof"),
        ("linux", {"HOME": "/h"}, "/h/.cache/mechproof"),
        ("darwin", {"HOME": "/h"}, "/h/Library/Caches/mechproof"),
        ("linux", {"XDG_CACHE_HOME": "/c", VARIABLE: "/m"}, "/m"),
    ],
)
def test_the_folder_is_that_of_the_platform(
    monkeypatch: pytest.MonkeyPatch, platform: str, variables: dict[str, str], folder: str
) -> None:
    for name in ("XDG_CACHE_HOME", VARIABLE):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("sys.platform", platform)
    assert cache_folder() == Path(folder)
