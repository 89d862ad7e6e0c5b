"""Certificates: the proved bounds on the rounding errors of a system's kernels, as data.

A claim about a kernel's stage is the largest bound over all boxes. To check it, the domain is cut
again as the claim's text of cuts says, and every box is bounded anew. FPTaylor and PRECiSA (Titolo
et al. 2018) write proofs for HOL Light and PVS; nothing as strong is claimed here, as the same code
finds and checks a claim. Each claim also has the worst input found.
"""

from __future__ import annotations

import json
import math
import zlib
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from mechproof.arithmetic.cover import WORST, Cover, Cuts, are_below, cover_below, cut_again
from mechproof.arithmetic.intervals import Array
from mechproof.programs.kernel import Kernel
from mechproof.record import Form, Paper, Quantity
from mechproof.roundoff.compiled_kernels import WAY as COMPILED
from mechproof.roundoff.computed_stages import ComputedStage
from mechproof.roundoff.kernel_stages import list_computed_stages
from mechproof.roundoff.regions import ChartRegion, list_regions
from mechproof.roundoff.steps import NORMAL
from mechproof.roundoff.term_sums import SEARCHED
from mechproof.roundoff.worst import WorstRounding, find_worst, judge
from mechproof.tools.json_rows import read_fields, write_lines

# The most boxes, over all regions, that a proof of a bound may use. Boxes with many sides get
# fewer, as a cut is tried across each side, and so do programs that linear forms bound; maps, which
# have the most roundings, get more.
MOST, MOST_OF_MANY, MANY_SIDES, MOST_WITH_FORMS, MOST_OF_MAPS = 16000, 300, 10, 6000, 20000
# Where the search for the lowest bound starts and gives up, in eps, and its resolution as a share
# of the bound.
FIRST, LAST, RESOLUTION = 4.0, 2.0**20, 0.01
DIGITS = 2
SEED = 1


@dataclass(frozen=True)
class RoundingClaim:
    """A bound on the error of a stage in eps of its scale, and the worst error found.

    `where` restricts the arguments, empty for all; `each` is what each term of a set after the
    first adds to the bound; `boxes` is the number of boxes of the proof and `cuts` encodes them;
    `open` names the first box not proved, if any; `program` is the hash of steps and coordinates;
    `at` has the arguments of the worst error as hexadecimal texts.
    """

    quantity: str
    form: str
    way: str
    where: tuple[str, ...]
    proved: float
    each: float
    found: float
    at: Mapping[str, str]
    boxes: int
    open: str
    assumptions: tuple[str, ...]
    program: str
    cuts: str


@dataclass(frozen=True)
class Certificate:
    """All claims of a system."""

    system: str
    claims: tuple[RoundingClaim, ...]


def write_certificate(certificate: Certificate) -> str:
    """Return the text of a certificate, in JSON."""
    return "\n".join(write_lines(certificate))


def read_certificate(text: str, where: str) -> Certificate:
    """Read a certificate's text; ValueError, with `where`, for one with wrong fields."""
    return read_fields(Certificate, json.loads(text), where)


def certify(
    stages: Iterable[ComputedStage], known: Sequence[RoundingClaim]
) -> tuple[RoundingClaim, ...]:
    """Prove a bound for every stage; known claims that still hold are kept unchanged."""
    kept = {(claim.quantity, claim.form, claim.way): claim for claim in known}
    shown: list[tuple[tuple[object, ...], RoundingClaim]] = []
    for subject in stages:
        claim, alike = kept.get(_key(subject)), [c for b, c in shown if b == subject.basis]
        if not (claim and holds(subject, claim, alike)):
            claim = make_claim(subject, claim)
        shown.append((subject.basis, claim))
    return tuple(claim for _, claim in shown)


def list_stages(kernel: Kernel, paper: Paper) -> list[ComputedStage]:
    """List a kernel's stages to prove; ValueError, naming it, for a chart that cannot be used."""
    try:
        return [*list_computed_stages(kernel, paper)]
    except ValueError as error:
        raise ValueError(f"{paper.system}.{kernel.name}: {error}") from error


def describe_proofs(paper: Paper, certificate: Certificate | None) -> Paper:
    """Return the paper with forms whose `proved` text states the claims about them."""
    if certificate is None:
        return paper
    claims: dict[tuple[str, str], list[RoundingClaim]] = {}
    for claim in certificate.claims:
        claims.setdefault((claim.quantity, claim.form), []).append(claim)
    quantities = tuple(
        replace(q, forms=tuple(_describe_form(q, form, claims) for form in q.forms))
        for q in paper.quantities
    )
    return replace(paper, quantities=quantities)


def _describe_form(
    quantity: Quantity, form: Form, known: Mapping[tuple[str, str], list[RoundingClaim]]
) -> Form:
    claims = known.get((quantity.name, form.name))
    if not claims:
        return form
    name = f" of {form.name}" if len(quantity.shipped) > 1 else ""
    where = describe_place(claims[0].where)
    of_all = [text for text in claims[0].assumptions if all(text in c.assumptions for c in claims)]
    resting = f", as long as {' and '.join(of_all)}" if of_all else ""
    told = "; ".join(_describe(claim, of_all) for claim in claims)
    return replace(form, proved=f"Proved{name}{where}{resting}: {told}.")


def describe_place(places: Sequence[str]) -> str:
    """Return a clause to append on where something is proved; empty if for all arguments."""
    return f", where {' or '.join(places)}" if places else ""


def _describe(claim: RoundingClaim, told: Sequence[str]) -> str:
    if claim.open:
        return f"nothing {claim.way}, open at {claim.open}"
    rests = [text for text in claim.assumptions if text not in told]
    by = claim.way if claim.way == COMPILED else f"with {claim.way}"
    given = f" with {' and '.join(rests)}" if rests else f" {by}"
    size = f" where n = {SEARCHED}" if claim.each else ""
    return f"at most {describe_bound(claim)} eps{given}, found {claim.found:g}{size}"


def describe_bound(claim: RoundingClaim) -> str:
    """Write a bound in eps with all its digits: rounded down, it would not be a bound."""
    return f"{claim.proved:g}" + (f" + {claim.each:g}*(n - 1)" if claim.each else "")


def _key(subject: ComputedStage) -> tuple[str, str, str]:
    return subject.kernel.name, subject.form.name, subject.way


def holds(
    subject: ComputedStage, claim: RoundingClaim, shown: Sequence[RoundingClaim] = ()
) -> bool:
    """Return whether a claim is about these steps and proved, with no worse error at its input.

    A bound in `shown`, already proved for the same steps computed in another way, is not proved
    again.
    """
    told = claim.program, claim.assumptions, claim.where, claim.each
    if told != (subject.digest, subject.assumptions, subject.where, subject.each):
        return False
    off, most = _measure_again(subject, claim), claim.proved + subject.more
    if not (0 <= off.eps <= most and 0 <= claim.found <= most):
        return False
    # NumPy's functions differ between hosts; plain arithmetic does not.
    if subject.assumptions == (NORMAL,) and claim.found != _round(off.eps, math.floor):
        return False
    bounds = [(one.proved, one.boxes, one.open, one.cuts) for one in shown]
    if (claim.proved, claim.boxes, claim.open, claim.cuts) in bounds:
        return True
    if claim.open:
        covers = cover_all(subject, claim.proved, _limit(subject))
        return (_count(covers), _describe_open(covers)) == (claim.boxes, claim.open)
    return is_shown(subject, claim)


def is_shown(subject: ComputedStage, claim: RoundingClaim) -> bool:
    """Return whether the claim's boxes cover all regions and its bound is nearly their largest."""
    try:
        heights = np.concatenate([*_bound_again(subject, read_cuts(claim.cuts))])
    except ValueError:
        return False
    # Two units of the last digit, as the largest bound may itself be a number of so few digits.
    is_least = claim.proved - heights.max() < 2 * 10**-DIGITS
    return bool(
        len(heights) == claim.boxes and is_least and np.all(are_below(heights, claim.proved))
    )


def _bound_again(subject: ComputedStage, cuts: Cuts) -> Iterator[Array]:
    """Yield the bounds of each region's boxes; ValueError for cuts that do not fit the regions."""
    for region in _list_regions(subject):
        boxes, cuts = cut_again(region.box, region.count_first(), cuts)
        yield subject.bound(region, boxes)
    if len(cuts):
        raise ValueError(f"cuts left over after all regions: {cuts.tolist()}")


def _list_regions(subject: ComputedStage) -> Iterator[ChartRegion]:
    for chart in subject.form.charts:
        yield from list_regions(chart)


def _round(eps: float, to: Callable[[float], int]) -> float:
    cut: float = to(eps * 10**DIGITS) / 10**DIGITS
    return cut


def _measure_again(subject: ComputedStage, claim: RoundingClaim) -> WorstRounding:
    at = {name: float.fromhex(text) for name, text in claim.at.items()}
    points = {name: np.array([value]) for name, value in at.items()}
    return WorstRounding(float(judge(subject, points)[0]), at)


def cover_all(subject: ComputedStage, aim: float, most: int) -> list[tuple[ChartRegion, Cover]]:
    """Prove region by region that the error is at most `aim`, up to the first that stays open."""
    covers: list[tuple[ChartRegion, Cover]] = []
    for region in _list_regions(subject):
        bound = partial(subject.bound, region)
        left = most - _count(covers)
        cover = cover_below(bound, region.box, aim, left, region.count_first())
        covers.append((region, cover))
        if cover.open is not None:
            break
    return covers


def _limit(subject: ComputedStage) -> int:
    """Return the most boxes that a proof of a bound may use."""
    sides = max(len(region.box) for region in _list_regions(subject))
    if sides >= MANY_SIDES:
        return MOST_OF_MANY
    if subject.map:
        return MOST_OF_MAPS
    return MOST_WITH_FORMS if subject.has_forms else MOST


def _count(covers: Sequence[tuple[ChartRegion, Cover]]) -> int:
    return sum(cover.count for _, cover in covers)


def _describe_open(covers: Sequence[tuple[ChartRegion, Cover]]) -> str:
    region, cover = covers[-1]
    return "" if cover.open is None else f"{region.describe()}: {cover.open}"


def make_claim(subject: ComputedStage, known: RoundingClaim | None = None) -> RoundingClaim:
    """Return a claim with nearly the lowest provable bound and the worst input found.

    The input of a known claim is used if its error is larger. Raises ArithmeticError if an input's
    error exceeds the proved bound: the proof would be wrong.
    """
    before = [_measure_again(subject, known)] if known else []
    least = max((found.eps for found in before), default=0.0) - subject.more
    proved = _lower_bound(subject, max(least, 0.0))
    covers = cover_all(subject, proved, _limit(subject))
    if not _describe_open(covers):
        proved = min(proved, _round(max(cover.worst[0][0] for _, cover in covers), math.ceil))
    worst = max((_search(subject, covers), *before), key=lambda found: found.eps)
    if worst.eps > proved + subject.more:
        at = {name: value.hex() for name, value in worst.at.items()}
        raise ArithmeticError(
            f"{'.'.join(_key(subject))}: {worst.eps} eps at {at}, although at most "
            f"{proved + subject.more} are proved"
        )
    return RoundingClaim(
        *_key(subject),
        where=subject.where,
        proved=proved,
        each=subject.each,
        found=_round(worst.eps, math.floor),
        at={name: float(value).hex() for name, value in worst.at.items()},
        boxes=_count(covers),
        open=_describe_open(covers),
        assumptions=subject.assumptions,
        program=subject.digest,
        cuts=write_cuts([cover.cuts for _, cover in covers]),
    )


def _lower_bound(subject: ComputedStage, low: float) -> float:
    """Return nearly the lowest provable bound above `low`, in hundredths of an eps; or infinity."""
    high = max(FIRST, 2 * low)
    while _describe_open(cover_all(subject, high, _limit(subject))):
        low, high = high, 2 * high
        if high > LAST:
            return math.inf
    while high - low > RESOLUTION * high:
        middle = round((low + high) / 2, DIGITS)
        if not low < middle < high:
            break
        if _describe_open(cover_all(subject, middle, _limit(subject))):
            low = middle
        else:
            high = middle
    return round(high, DIGITS)


def _search(subject: ComputedStage, covers: Sequence[tuple[ChartRegion, Cover]]) -> WorstRounding:
    """Search from whole regions and, as another place may be worse, from the highest boxes."""
    boxes = [(height, region, box) for region, cover in covers for height, box in cover.worst]
    highest = sorted(boxes, key=lambda entry: -entry[0])[:WORST]
    starts = (
        [(region, region.box) for region, _ in covers],
        [(region, box) for _, region, box in highest],
    )
    return max((find_worst(subject, s, SEED) for s in starts), key=lambda found: found.eps)


def write_cuts(cuts: Sequence[Cuts]) -> str:
    """Return the cuts of boxes, concatenated, as compressed Base64 text."""
    return b64encode(zlib.compress(np.concatenate(cuts).tobytes(), 9)).decode("ascii")


def read_cuts(text: str) -> Cuts:
    """Return the cuts in a text; ValueError for a text that encodes none."""
    try:
        return np.frombuffer(zlib.decompress(b64decode(text, validate=True)), np.int8)
    except zlib.error as error:
        raise ValueError(f"{text[:20]!r} cannot be read as cuts: {error}") from error
