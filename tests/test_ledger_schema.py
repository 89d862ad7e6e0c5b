"""The JSON of the ledger conforms to its schema, and the ids of its rows are unique."""

from __future__ import annotations

import json
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest
from command import OPEN, PROVED, run, write
from jsonschema import Draft202012Validator

from mechproof.ledger.judged import SCHEMA
from mechproof.proof.verdict import Verdict

ROOT = Path(__file__).parents[1]
WRONG = 'Equation("(3)", "\\\\alpha=3", Equality(sin(x), cos(x)))'
SENTENCE = r'Claim("sentence", "x\\text{ is always below }y", Equality(x, y))'
BLOCK = "%% mechproof\n%% r ; l : lengths [mm]\n%% k : ratio\n%% end\n"
SOURCE = BLOCK + "\\begin{equation}k=\\frac rl\\end{equation}\n$$k=\\frac lr$$\n$$q=3r$$\n"

Ledger = dict[str, Any]


@pytest.fixture(scope="module")
def schema() -> Draft202012Validator:
    found = json.loads(files("mechproof.ledger").joinpath("ledger.schema.json").read_text("utf-8"))
    Draft202012Validator.check_schema(found)
    return Draft202012Validator(found)


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Ledger:
    """Return the JSON ledger of a derivation and a source, judged together."""
    folder = tmp_path_factory.mktemp("ledgers")
    (folder / "source.tex").write_text(SOURCE)
    papers = [write(folder, PROVED, OPEN, WRONG, SENTENCE), folder / "source.tex"]
    run("verify", *map(str, papers), "--no-cache", "--json", str(folder / "rows.json"))
    found: Ledger = json.loads((folder / "rows.json").read_bytes())
    return found


def test_the_ledger_of_the_package_is_valid(schema: Draft202012Validator) -> None:
    ledger = json.loads((ROOT / "generated" / "ledger.json").read_text(encoding="utf-8"))
    assert [error.message for error in schema.iter_errors(ledger)] == []
    ids = [row["id"] for row in ledger["rows"]]
    assert len(set(ids)) == len(ids)


def test_the_ledger_of_own_papers_is_valid(schema: Draft202012Validator, own: Ledger) -> None:
    assert [error.message for error in schema.iter_errors(own)] == []
    assert own["$schema"] == SCHEMA == schema.schema["$id"]
    assert [paper["system"] for paper in own["papers"]] == ["mine", "source"]
    assert {row["state"] for row in own["left"]} == {"not read"}
    assert schema.schema["$defs"]["verdict"]["enum"] == [verdict.value for verdict in Verdict]


def test_numbers_are_numbers_beside_their_text(own: Ledger) -> None:
    wrong = next(row for row in own["rows"] if row["id"] == "mine/eq-3")
    first = wrong["evidence"][0]
    assert first["dimension"] in ("1", "angle")
    assert {"text", "value"} <= first["at"]["x"].keys()
    assert abs(first["printed"]["value"] - first["rebuilt"]["value"]) > first["printed"]["radius"]
    (finding,) = (f for f in own["findings"] if f["id"] == "mine/eq-3")
    assert finding["costs"][0]["values"]["printed"]["text"] in finding["costs"][0]["text"]


def test_a_paraphrase_is_no_print(own: Ledger) -> None:
    found = {row["id"]: (row["print"], row["paraphrase"]) for row in own["rows"]}
    assert found["mine/eq-3"] == (r"\alpha=3", "")
    assert found["mine/row-sentence"] == ("", r"x\text{ is always below }y")
    assert all(row["print"] for row in own["rows"] if row["system"] == "source")


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda ledger: ledger["rows"][0].pop("id"), "'id' is a required property"),
        (lambda ledger: ledger["rows"][0].update(id="mine"), "does not match"),
        (lambda ledger: ledger["rows"][0].update(verdict="TRUE"), "is not one of"),
        (lambda ledger: ledger["rows"][0].update(extra=1), "Additional properties"),
        (lambda ledger: ledger["rows"][0].update(cites=["52"]), "does not match"),
        (lambda ledger: ledger["papers"][0].update(doi="doi 10.1/2"), "does not match"),
        (lambda ledger: ledger["papers"][0].update(sentences=-1), "less than the minimum"),
        (lambda ledger: ledger["findings"][0]["costs"].append("44.3°"), "is not of type 'object'"),
        (lambda ledger: ledger.update({"$schema": "urn:other"}), "was expected"),
        (lambda ledger: ledger.pop("papers"), "'papers' is a required property"),
    ],
)
def test_what_is_no_ledger_is_refused(
    schema: Draft202012Validator, own: Ledger, spoil: Callable[[Ledger], object], says: str
) -> None:
    spoilt = json.loads(json.dumps(own))
    spoil(spoilt)
    assert any(says in error.message for error in schema.iter_errors(spoilt))
