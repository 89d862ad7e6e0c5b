"""Consecutive identities of a table, each with a false twin: none convicted, no twin accepted.

From the NIST Digital Library of Mathematical Functions, sections 4.21 and 4.35, in order and for
real arguments: a ± makes two rows, a chain one row per equals sign; where a root's sign depends on
the quadrant, the last column gives it. 4.21.34 and 4.21.37 to 4.21.40 are complex and left out.
"""

import csv
from pathlib import Path

import pytest
from weights import first_of

from mechproof.pipeline.pasted import judge_pasted
from mechproof.pipeline.pasted_letters import Pasted
from mechproof.proof.verdict import Verdict

TABLE = Path(__file__).with_suffix("").with_name("textbook_identities.tsv")
LINES = csv.reader(TABLE.open(encoding="utf-8"), delimiter="\t", quoting=csv.QUOTE_NONE)
ROWS = list(map(tuple, LINES))[1:]
# Roots of squares whose sign depends on the quadrant, and statements about every n: not proved yet.
OPEN = {"4.21.21", "4.21.22", "4.21.23", "4.21.35", "4.35.20", "4.35.22", "4.35.33"}


def judge(latex: str, where: str) -> Verdict:
    (judgement,) = judge_pasted(Pasted(latex, where=(where,) if where else ())).judgements
    return judgement.verdict


def test_a_hundred_identities_are_listed() -> None:
    assert len(ROWS) >= 100


@pytest.mark.slow
@pytest.mark.parametrize(("number", "printed", "twin", "where"), first_of(ROWS, 40))
def test_an_identity_is_not_convicted_and_its_twin_not_accepted(
    number: str, printed: str, twin: str, where: str
) -> None:
    accepted = {Verdict.PROVED, Verdict.CONDITIONAL, Verdict.CONVENTION, Verdict.DEFINITION}
    verdict = judge(printed, where)
    assert verdict not in {Verdict.REFUTED, Verdict.ILL_FORMED}
    assert verdict is Verdict.PROVED or number in OPEN
    assert judge(twin, where) not in {*accepted, Verdict.ENCLOSED}
