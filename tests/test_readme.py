"""What the README shows is what a user gets."""

from __future__ import annotations

import doctest
import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mechproof.cli import app
from mechproof.record import MARKS

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
COMMANDS = re.findall(r"```sh\n(.*?)\n```", README, re.DOTALL)
MODULES = [block for block in BLOCKS if ">>>" not in block]


def test_examples_print_what_they_show() -> None:
    examples = "\n".join(block for block in BLOCKS if ">>>" in block)
    test = doctest.DocTestParser().get_doctest(examples, {}, "README.md", "README.md", 0)
    result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test)
    assert result.attempted > 0
    assert result.failed == 0


def test_the_excerpt_of_the_findings_is_the_ledger() -> None:
    ledger = json.loads((ROOT / "generated" / "ledger.json").read_text("utf-8"))
    known = {
        f"**{f['system']}, {f['number']}**: {' '.join((f['verdict'], *marks(f)))}. {f['wrong']}"
        f"{cost} Right: $`{f['corrected_latex']}`$"
        for f in ledger["findings"]
        for cost in ("", *(f" *{cost}.*" for cost in f["costs"]))
    }
    excerpt = README.split("from the ledger:\n\n- ")[1].split("\n\n")[0]
    shown = [item.replace("\n  ", " ") for item in excerpt.split("\n- ")]
    assert [item for item in shown if item not in known] == []
    assert len(set(shown)) == 5


def marks(finding: dict[str, list[str]]) -> list[str]:
    return [f"*{', '.join(finding['marks'])}*"] if finding["marks"] else []


def test_marks_mean_what_the_record_says() -> None:
    table = README.split("| mark | meaning |\n|---|---|\n")[1].split("\n\n")[0]
    assert table.splitlines() == [f"| *{mark}* | {meaning} |" for mark, meaning in MARKS.items()]


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
