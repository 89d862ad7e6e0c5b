"""The verdict cache: which rows are judged again, and which are not."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from weights import first_of

from mechproof.derivation import DerivationError
from mechproof.ledger import verdict_cache
from mechproof.ledger.verdict_cache import VerdictCache
from mechproof.pipeline import opening, verification
from mechproof.pipeline.verification import judge_derivations
from mechproof.proof import algebra
from mechproof.proof.verdict import Verdict
from mechproof.tools.cache import VARIABLE

HEAD = """
import os, time
from sympy import Interval, Lambda, S, Function, cos, sin, symbols
from mechproof.record import *
x, y = symbols("x y", real=True)
class Own(Function):
    pass
def paper(*rows, kernel=None, slopes=SLOPES, **words):
    variables = (Variable(x, "a number", **words), Variable(y, "another"))
    arguments = Argument("x", (x,), "a number"), Argument("y", (y,), "another")
    forms = (Form("as it stands", kernel),) if kernel else ()
    quantities = kernel is not None and (
        Quantity("area", "Area.", arguments, kernel, forms, "mine", slopes=slopes),
    )
    return Paper(
        "mine", "my notes", variables, rows, quantities=quantities or (), derivatives=True
    )
"""
ROWS = (
    'Equation("(1)", "1", Equality(sin(x)**2 + cos(x)**2, S.One))',
    'Equation("(2)", "2", Equality((x + y)**2, x**2 + 2*x*y + y**2))',
    'Equation("(3)", "3", Equality(x + y, x - y))',
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "cache"))
    return tmp_path


@pytest.fixture
def judged(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[str]]:
    """Return a function that judges a paper of given rows and lists those not from the cache."""

    def run(*rows: str, words: str = "", use_cache: bool = True) -> list[str]:
        numbers: list[str] = []
        add = verification._Progress.add

        def note(paper: verification._Progress, number: int, result: object) -> None:
            numbers.append(paper.tasks[number])
            add(paper, number, result)

        file = folder / "mine.py"
        text = f"{HEAD}\nPAPER = paper({', '.join((*rows, words))})\n"
        file.write_text(text, encoding="utf-8")
        with monkeypatch.context() as patch:
            patch.setattr(verification._Progress, "add", note)
            (ledger,) = judge_derivations([file], use_cache=use_cache, processes=1)
        run.judgements = ledger.judgements  # type: ignore[attr-defined]
        return sorted(numbers)

    return run


def test_only_rows_that_changed_are_judged(judged: Callable[..., list[str]]) -> None:
    assert judged(*ROWS) == ["(1)", "(2)", "(3)"]
    first = judged.judgements  # type: ignore[attr-defined]
    assert judged(*ROWS) == []
    assert judged.judgements == first  # type: ignore[attr-defined]
    edited = ROWS[1].replace("2*x*y", "3*x*y")
    assert judged(ROWS[0], edited, ROWS[2]) == ["(2)"]
    verdicts = [j.verdict for j in judged.judgements]  # type: ignore[attr-defined]
    assert verdicts == [Verdict.PROVED, Verdict.REFUTED, Verdict.REFUTED]
    assert judged(*ROWS, edited.replace("(2)", "(4)")) == ["(2)", "(4)"]


@pytest.mark.parametrize(
    ("old", "new"),
    first_of(
        [
            ('"(3)"', '"(3a)"'),
            ('"3", ', '"three", '),
            ("x - y)", "x - y), note='so'"),
            ("x - y)", "x - y), holds_on=Part('y = 0', where=(y >= 0,))"),
            ("x - y)", "x - y), on=Part('x > 0', within={x: Interval.open(0, 1)})"),
            ("x - y)", "x - y), corrected=Correction('c', Equality(x, x))"),
            ("x - y)", "x - y), readings=(Reading('r', Equality(x, x)),)"),
        ]
    ),
)
def test_whatever_enters_a_row_counts(judged: Callable[..., list[str]], old: str, new: str) -> None:
    judged(*ROWS)
    edited = ROWS[2].replace(old, new)
    assert edited != ROWS[2]
    assert len(judged(*ROWS[:2], edited)) == 1


@pytest.mark.parametrize(
    "words",
    first_of(["within=Interval(0, 1)", "given=2*y", "dimension=LENGTH", "within=S.Naturals"]),
)
def test_the_domain_counts(judged: Callable[..., list[str]], words: str) -> None:
    judged(*ROWS)
    assert len(judged(*ROWS, words=words)) == 3


def test_words_about_a_symbol_do_not(judged: Callable[..., list[str]]) -> None:
    judged(*ROWS)
    assert judged(*ROWS, words="sign='to the right'") == []


def test_rows_of_a_copied_folder_are_known(judged: Callable[..., list[str]], folder: Path) -> None:
    judged(*ROWS)
    known = VerdictCache(folder / "mine.py").load()
    assert len(known) == len(ROWS)
    copies = [folder / "here" / "mine", folder / "there" / "mine", folder / "there" / "other"]
    for copy in copies:
        copy.mkdir(parents=True)
    VerdictCache(copies[0]).save(known)
    assert VerdictCache(copies[1]).load() == known
    assert VerdictCache(copies[2]).load() == VerdictCache(folder / "there" / "mine.py").load() == {}


def test_without_the_cache_all_rows_are_judged(
    judged: Callable[..., list[str]], folder: Path
) -> None:
    assert judged(*ROWS, use_cache=False) == ["(1)", "(2)", "(3)"]
    assert not (folder / "cache").exists()
    judged(*ROWS)
    assert judged(*ROWS, use_cache=False) == ["(1)", "(2)", "(3)"]


def test_another_rung_judges_anew(
    judged: Callable[..., list[str]], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The keys depend on a copy of the prover's sources, in which one rung is then edited."""
    copies = folder / "proof"
    shutil.copytree(Path(algebra.__file__).parent, copies)
    monkeypatch.setattr(verdict_cache, "prover_sources", lambda: sorted(copies.glob("*.py")))
    judged(*ROWS)
    assert judged(*ROWS) == []
    rung = copies / "algebra.py"
    rung.write_text(rung.read_text(encoding="utf-8") + "\n# edited\n", encoding="utf-8")
    assert len(judged(*ROWS)) == 3
    assert judged(*ROWS) == []


def test_the_verdict_of_another_prover_replaces_the_old_one(
    judged: Callable[..., list[str]], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judged(*ROWS)
    source = folder / "rung.py"
    source.write_text("# a rung that proves everything\n")
    monkeypatch.setattr(verdict_cache, "prover_sources", lambda: [source])
    rung = verification.judge
    monkeypatch.setattr(
        verification, "judge", lambda *row: replace(rung(*row), verdict=Verdict.PROVED)
    )
    judged(*ROWS)
    verdicts = [j.verdict for j in judged.judgements]  # type: ignore[attr-defined]
    assert verdicts == [Verdict.PROVED] * 3


def test_the_sources_of_the_prover_are_all_it_imports() -> None:
    """A change in a module that verdicts depend on but no key covers would go unnoticed.

    The two exceptions show and store verdicts and so change none.
    """
    other = (
        "from mechproof.tools.cache import Store, make_key, name_place",
        "from mechproof.tools.notebook import Displayed",
    )
    names = {path.name for path in verdict_cache.prover_sources()}
    assert {"judge.py", "ladder.py", "algebra.py", "domain.py", "statements.py"} <= names
    for path in verdict_cache.prover_sources():
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith(("from mechproof", "import mechproof")):
                module = line.split()[1]
                is_covered = (
                    module.removeprefix("mechproof.").partition(".")[0] in verdict_cache.LAYERS
                )
                assert is_covered or line in other, f"{path}: {line}"


@pytest.mark.parametrize(
    "text",
    first_of(
        [
            b"",
            b"{",
            b"[]",
            b"\xff",
            b"null",
            b'{"a": 1}',
            b'{"a": {"verdict": "TRUE", "evidence": []}}',
        ]
    ),
)
def test_a_corrupt_cache_is_ignored_and_rewritten(
    judged: Callable[..., list[str]], folder: Path, text: bytes
) -> None:
    judged(*ROWS)
    (file,) = (folder / "cache").glob("*.json")
    good = json.loads(file.read_text())
    file.write_bytes(text)
    assert len(judged(*ROWS)) == 3
    assert json.loads(file.read_text()) == good


@pytest.mark.slow
def test_derivatives_are_kept_by_what_they_are_made_from(
    judged: Callable[..., list[str]],
) -> None:
    slopes = "derivatives of kernel area"
    assert judged(words="kernel=x**2*sin(y)") == [slopes, "kernel area"]
    assert judged(words="kernel=x**2*sin(y)") == []
    assert judged(words="kernel=x**3*sin(y)") == [slopes, "kernel area"]
    assert judged(words="kernel=x**3*sin(y), slopes=Accuracy(5)") == [slopes]
    assert judged(words="kernel=x**3*sin(y), slopes=None") == []


@pytest.mark.parametrize("end", ["", ", legal"])
def test_a_row_with_the_number_of_one_on_derivatives_is_refused(
    judged: Callable[..., list[str]], end: str
) -> None:
    number = f"derivatives of kernel area{end}"
    with pytest.raises(DerivationError, match=rf"rows given twice .*: \['{number}'\]"):
        judged(ROWS[0].replace("(1)", number), words="kernel=x**2*sin(y)")


def test_derivatives_are_made_anew_by_another_program(
    judged: Callable[..., list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    judged(words="kernel=x**2*sin(y)")
    monkeypatch.setattr(opening, "digest_program", lambda: "another")
    assert judged(words="kernel=x**2*sin(y)") == ["derivatives of kernel area"]


def test_a_corrupt_entry_is_judged_anew(judged: Callable[..., list[str]], folder: Path) -> None:
    judged(*ROWS)
    (file,) = (folder / "cache").glob("*.json")
    entries = json.loads(file.read_text())
    spoilt = next(key for key, entry in entries.items() if entry[0]["number"] == "(2)")
    del entries[spoilt][0]["rung"]
    file.write_text(json.dumps(entries))
    assert judged(*ROWS) == ["(2)"]
    assert judged(*ROWS) == []


def test_the_cache_holds_the_last_run_only(judged: Callable[..., list[str]], folder: Path) -> None:
    judged(*ROWS)
    judged(ROWS[0])
    (file,) = (folder / "cache").glob("*.json")
    assert len(json.loads(file.read_text())) == 1


def test_a_folder_that_cannot_be_written_is_a_warning(
    judged: Callable[..., list[str]], folder: Path
) -> None:
    (folder / "cache").write_text("a file")
    with pytest.warns(RuntimeWarning, match="nothing is cached in .*cache: File exists"):
        assert len(judged(*ROWS)) == 3


def test_what_no_key_covers_and_what_no_rung_read_is_judged_each_time(
    judged: Callable[..., list[str]],
) -> None:
    own = 'Equation("(o)", "o", Equality(Own(x), Own(x)))'
    unread = 'Equation("(u)", "u", Holds(S.true))'
    judged(*ROWS, own, unread)
    assert judged(*ROWS, own, unread) == ["(o)", "(u)"]


@pytest.mark.parametrize(
    ("act", "reason"),
    [("os._exit(3)", "its process ended with status 3"), ("time.sleep(600)", "no answer within")],
)
def test_a_row_that_dies_or_hangs_is_an_error_and_the_others_are_kept(
    folder: Path, act: str, reason: str
) -> None:
    file = folder / "mine.py"
    row = 'Equation("(f)", "f", Equality(x, y), note=Fatal("n"))'
    text = (
        f"{HEAD}\nHERE = os.getpid()\nclass Fatal(str):\n    def __bool__(self):\n"
        f"        {act} if os.getpid() != HERE else None\n        return True\n"
        f"PAPER = paper({row}, {', '.join(ROWS)})\n"
    )
    file.write_text(text, encoding="utf-8")
    (ledger,) = judge_derivations([file], processes=1, limit=5.0)
    (failure,) = ledger.failures
    assert failure.startswith(f"{file}: row (f): {reason}")
    assert len(VerdictCache(file).load()) == len(ROWS) == len(ledger.judgements)
