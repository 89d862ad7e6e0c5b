"""Certificates: what is proved of the rounding errors of a system's kernels, as data.

A claim of a kernel's stage is the largest bound over all boxes; who checks it divides the domain
anew until every box is below it. The worst input found stands beside it.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from mechproof.codegen.kernel import list_functions
from mechproof.json_rows import read_fields, write_lines
from mechproof.record import Form, Paper, Quantity
from mechproof.roundoff.assumptions import NORMAL
from mechproof.roundoff.cover import Cover, cover_below, lower_bound
from mechproof.roundoff.regions import Region, list_regions
from mechproof.roundoff.subject import Subject, list_subjects
from mechproof.roundoff.worst import Found, find_worst, measure

# Boxes when a bound is looked for, and the most of all regions when it is checked.
MOST, MOST_CHECKED = 7000, 20000
# A claim is so much above what the search for it came down to, so that fewer boxes show it.
SLACK = 1.01
DIGITS = 2
SEEDS = (1,)


@dataclass(frozen=True)
class Claim:
    """A bound of the error of a stage in eps of its scale, and the worst error found.

    `where` says for which arguments, `program` is the hash of steps and coordinates, `boxes` how
    many show the bound, `open` what is not shown; `at` has the arguments as hexadecimal texts.
    """

    quantity: str
    form: str
    way: str
    where: tuple[str, ...]
    proved: float
    found: float
    at: Mapping[str, str]
    boxes: int
    open: str
    assumptions: tuple[str, ...]
    program: str


@dataclass(frozen=True)
class Certificate:
    """All claims of a system."""

    system: str
    claims: tuple[Claim, ...]


def write_certificate(certificate: Certificate) -> str:
    """Return the text of a certificate."""
    return "\n".join(write_lines(certificate))


def read_certificate(text: str, where: str) -> Certificate:
    """Read a certificate; ValueError names what it should not have."""
    return read_fields(Certificate, json.loads(text), where)


def certify(paper: Paper, known: Certificate | None) -> Certificate | None:
    """Prove a bound of every stage with charts; what is known and holds stays as it is.

    None for a paper without charts.
    """
    kept = {(c.quantity, c.form, c.way): c for c in known.claims} if known else {}
    claims = []
    for subject in _list_all(paper):
        claim = kept.get(_key(subject))
        claims.append(claim if claim and holds(subject, claim) else make_claim(subject, claim))
    return Certificate(paper.system, tuple(claims)) if claims else None


def list_digests(paper: Paper) -> list[str]:
    """List the hashes of all that a paper's certificate is about."""
    return [subject.digest for subject in _list_all(paper)]


def tell_proofs(paper: Paper, certificate: Certificate | None) -> Paper:
    """Return the paper with what is proved told by its forms."""
    if certificate is None:
        return paper
    texts: dict[tuple[str, str], list[Claim]] = {}
    for claim in certificate.claims:
        texts.setdefault((claim.quantity, claim.form), []).append(claim)
    quantities = tuple(
        replace(q, forms=tuple(_tell_form(q, form, texts) for form in q.forms))
        for q in paper.quantities
    )
    return replace(paper, quantities=quantities)


def _tell_form(
    quantity: Quantity, form: Form, texts: Mapping[tuple[str, str], list[Claim]]
) -> Form:
    claims = texts.get((quantity.name, form.name))
    if not claims:
        return form
    name = f" of {form.name}" if len(quantity.shipped) > 1 else ""
    where = " or ".join(claims[0].where)
    told = "; ".join(map(_tell, claims))
    return replace(form, proved=f"Proved{name}, where {where}: {told}.")


def _tell(claim: Claim) -> str:
    if claim.open:
        return f"nothing {claim.way}, open at {claim.open}"
    rests = [text for text in claim.assumptions if text != NORMAL]
    given = f" with {' and '.join(rests)}" if rests else f" {claim.way}"
    return f"at most {claim.proved:g} eps{given}, found {claim.found:g}"


def _list_all(paper: Paper) -> Iterator[Subject]:
    return (s for kernel in list_functions(paper) for s in list_subjects(kernel, paper))


def _key(subject: Subject) -> tuple[str, str, str]:
    return subject.kernel.name, subject.form.name, subject.way


def holds(subject: Subject, claim: Claim) -> bool:
    """Say whether a claim is about these steps and proved, and its input not off by more."""
    told = claim.program, claim.assumptions, claim.where
    if told != (subject.digest, subject.assumptions, subject.where):
        return False
    off = _measure_again(subject, claim)
    if not 0 <= off.eps <= claim.proved or claim.found > claim.proved:
        return False
    # A wrong claim is known by one box too many.
    most = MOST_CHECKED if claim.open else claim.boxes
    return count_boxes(subject, claim.proved, most) == (claim.boxes, claim.open)


def _measure_again(subject: Subject, claim: Claim) -> Found:
    at = {name: float.fromhex(text) for name, text in claim.at.items()}
    points = {name: np.array([value]) for name, value in at.items()}
    return Found(float(measure(subject, points)[0]), at)


def count_boxes(subject: Subject, claimed: float, most: int) -> tuple[int, str]:
    """Return how many boxes show that the error is at most as claimed, and what stays open."""
    total = 0
    for region in _list_regions(subject):
        bound = partial(subject.bound, region)
        count, worst = cover_below(bound, region.box, claimed, most - total)
        total += count
        if worst is not None:
            return total, f"{region.describe()}: {worst}"
    return total, ""


def make_claim(subject: Subject, known: Claim | None = None) -> Claim:
    """Look for the lowest bound that can be shown and for the input that comes nearest to it.

    An input that was known before counts if it is off by more.
    """
    regions = list(_list_regions(subject))
    starts = [(partial(subject.bound, region), region.box) for region in regions]
    cover = lower_bound(starts, MOST)
    bound = cover.bound * SLACK
    proved = math.ceil(bound * 10**DIGITS) / 10**DIGITS if math.isfinite(bound) else math.inf
    before = [_measure_again(subject, known)] if known else []
    worst = max((*_search(subject, regions, cover), *before), key=lambda found: found.eps)
    count, stays_open = count_boxes(subject, proved, MOST_CHECKED)
    return Claim(
        *_key(subject),
        where=subject.where,
        proved=proved,
        found=math.floor(worst.eps * 10**DIGITS) / 10**DIGITS,
        at={name: float(value).hex() for name, value in worst.at.items()},
        boxes=count,
        open=stays_open,
        assumptions=subject.assumptions,
        program=subject.digest,
    )


def _list_regions(subject: Subject) -> Iterator[Region]:
    return (region for chart in subject.form.charts for region in list_regions(chart))


def _search(subject: Subject, regions: Sequence[Region], cover: Cover) -> Iterator[Found]:
    """Search from the worst boxes, those of each region together."""
    for number in sorted({number for number, _ in cover.worst}):
        boxes = [box for of, box in cover.worst if of == number]
        for seed in SEEDS:
            yield find_worst(subject, regions[number], boxes, seed)
