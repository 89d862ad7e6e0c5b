"""The README, the pages in docs and the docstrings show what a user really gets."""

from __future__ import annotations

import doctest
import json
import re
import shlex
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.derivation import packaged_directory
from mechproof.document.checking import check
from mechproof.plot.figures import find_figures, render_svg
from mechproof.proof.verdict import MEANINGS, Verdict
from mechproof.record import MARKS

ROOT = Path(__file__).parents[1]
PAGES = {
    file.relative_to(ROOT).as_posix(): file.read_text(encoding="utf-8")
    for file in (ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md")))
}
README = PAGES["README.md"]
BLOCKS = {name: re.findall(r"```python\n(.*?)```", text, re.DOTALL) for name, text in PAGES.items()}
# Beginnings of the lines that a user types.
TYPED = (">>", "..", "$ ")
COMMANDS = re.findall(r"```sh\n(.*?)\n```", README, re.DOTALL)
MODULES = [block for block in BLOCKS["docs/verify.md"] if ">>>" not in block]
DOCUMENTED = [
    ".".join(file.relative_to(ROOT / "src").with_suffix("").parts).removesuffix(".__init__")
    for file in sorted(ROOT.glob("src/**/*.py"))
    if ">>> " in file.read_text(encoding="utf-8")
]


@pytest.mark.slow(together=True)
@pytest.mark.parametrize("name", [name for name, blocks in BLOCKS.items() if blocks])
def test_examples_print_what_they_show(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "slider_crank.py").write_text(*MODULES, encoding="utf-8")
    examples = "\n".join(block for block in BLOCKS[name] if ">>>" in block)
    test = doctest.DocTestParser().get_doctest(examples, {}, name, name, 0)
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test)
    assert result.attempted > 0
    assert result.failed == 0


@pytest.mark.slow(together=True)
@pytest.mark.parametrize("module", DOCUMENTED)
def test_docstrings_print_what_they_show(module: str) -> None:
    result = doctest.testmod(import_module(module))
    assert result.attempted > 0
    assert result.failed == 0


@pytest.mark.slow
def test_the_example_of_jax_prints_what_its_comments_say() -> None:
    (block,) = (block for block in BLOCKS["docs/export.md"] if "import jax" in block)
    command = [sys.executable, "-c", block]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines() == re.findall(r"print.*  # (.*)", block)
    assert len(done.stdout.splitlines()) > 2


CONSOLES = {
    name: found
    for name, text in PAGES.items()
    if (found := re.findall(r"```console\n(\$ .*?)```", text, re.DOTALL))
}


@pytest.mark.parametrize("name", CONSOLES)
def test_commands_print_what_is_shown(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three dots stand for whatever else a command prints."""
    monkeypatch.chdir(tmp_path)
    for block in CONSOLES[name]:
        for shown in re.split(r"^\$ mechproof ", block, flags=re.MULTILINE)[1:]:
            command, _, printed = shown.partition("\n")
            output = CliRunner().invoke(app, shlex.split(command)).stdout
            parts = [re.escape(part) for part in printed.split("...\n")]
            assert re.fullmatch(r"(?s:.*)".join(parts), output), (command, output)


@pytest.mark.parametrize("name", sorted(name for name in PAGES if name.startswith("docs/tasks/")))
def test_a_task_takes_less_than_ten_lines(name: str) -> None:
    blocks = re.findall(r"```\w+\n(.*?)```", PAGES[name], re.DOTALL)
    assert 0 < sum(len(block.splitlines()) for block in blocks) < 16
    typed = [line for block in blocks for line in block.splitlines() if line[:2] in TYPED]
    assert 0 < len(typed) < 10


@pytest.mark.slow
def test_the_paper_shown_has_the_outcomes_shown() -> None:
    page = PAGES["docs/check.md"]
    (paper,) = re.findall(r"```latex\n(.*?)```", page, re.DOTALL)
    (shown,) = re.findall(r"```text\n(.*?)\n```", page, re.DOTALL)
    rows = [f"{row.name}  {row.outcome}" for row in check("paper.tex", paper).rows]
    assert rows == shown.splitlines()


def test_the_excerpt_of_the_findings_is_the_ledger() -> None:
    ledger = json.loads((ROOT / "generated" / "ledger.json").read_text("utf-8"))
    known = {
        f"**{f['system']}, {f['number']}**: {' '.join((f['verdict'], *marks(f)))}. {f['wrong']}"
        f"{cost} Right: $`{f['corrected_latex']}`$"
        for f in ledger["findings"]
        for cost in ("", *(f" *{cost['text']}.*" for cost in f["costs"]))
    }
    excerpt = README.split("from the ledger:\n\n- ")[1].split("\n\n")[0]
    shown = [item.replace("\n  ", " ") for item in excerpt.split("\n- ")]
    assert [item for item in shown if item not in known] == []
    assert len(set(shown)) == 5


def marks(finding: dict[str, list[str]]) -> list[str]:
    return [f"*{', '.join(finding['marks'])}*"] if finding["marks"] else []


def test_verdicts_and_marks_mean_what_the_program_says() -> None:
    assert set(MEANINGS) == set(Verdict)
    for head, sign, meanings in (("verdict", "`", MEANINGS), ("mark", "*", MARKS)):
        text = PAGES["docs/verdicts.md"].split(f"| {head} | meaning |\n|---|---|\n")[1]
        rows = [f"| {sign}{name}{sign} | {meaning} |" for name, meaning in meanings.items()]
        assert text.split("\n\n")[0].splitlines() == rows


@pytest.mark.parametrize("name", PAGES)
def test_links_lead_somewhere(name: str) -> None:
    for target in re.findall(r"\]\(([^)]+)\)", PAGES[name]):
        file, _, anchor = target.partition("#")
        place = (ROOT / name).parent / file
        assert place.exists(), target
        headings = re.findall(r"^#+ (.+)$", place.read_text("utf-8"), re.M) if anchor else []
        assert not anchor or anchor in [h.lower().replace(" ", "-") for h in headings], target


def test_the_picture_is_the_papers_figure() -> None:
    figures = {f.name: f for f in find_figures(packaged_directory() / "elliptic_planetary")}
    picture = (ROOT / "docs" / "elliptic_planetary.fig-3.svg").read_text(encoding="utf-8")
    drawn = render_svg(figures["fig-3"])
    assert list_texts(picture) == list_texts(drawn)
    assert f'aria-label="{figures["fig-3"].title}"' in picture


def list_texts(svg: str) -> list[str]:
    return re.findall(r">([^<>]*\S[^<>]*)<", svg)


def test_the_example_module_is_verified(tmp_path: Path) -> None:
    (module,) = MODULES
    assert sum(1 for line in module.splitlines() if line) <= 34
    file = tmp_path / "slider_crank.py"
    file.write_text(module, encoding="utf-8")
    result = CliRunner().invoke(app, ["verify", str(file), "--json", str(tmp_path / "rows.json")])
    assert result.exit_code == 0, result.output
    rows = json.loads((tmp_path / "rows.json").read_text(encoding="utf-8"))["rows"]
    assert [row["verdict"] for row in rows] == ["PROVED", "REFUTED"]
    assert "corrected form: PROVED" in str(rows[1]["evidence"])


@pytest.mark.skipif(not (ROOT / ".ci" / "run").exists(), reason="not a checkout")
def test_ci_calls_the_test_command() -> None:
    assert len(COMMANDS) == 2
    assert COMMANDS[0].endswith("mechproof verify")
    assert COMMANDS[1] in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
