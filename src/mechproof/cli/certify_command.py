"""The command that writes what is proved as scripts of Coq, and has Coq check them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from mechproof.cli import options
from mechproof.cli.options import (
    ending,
    fail,
    find_locations,
    find_places,
    read_out,
    refuse,
    say,
    show_progress,
)
from mechproof.pipeline.judging import PipelineError
from mechproof.pipeline.verification import LIMIT
from mechproof.sources.paper_files import SUFFIXES
from mechproof.tools.made import ForeignFileError

if TYPE_CHECKING:
    from mechproof.pipeline.row_scripts import Certified


def certify(
    papers: options.Papers = None,
    out: Annotated[
        Path,
        typer.Option(metavar="FOLDER", help="The folder to write the scripts to.", parser=read_out),
    ] = Path("coq"),
    check: Annotated[
        bool,
        typer.Option("--check", help="Have Coq check the scripts, and write the coverage page."),
    ] = False,
    record: Annotated[
        bool,
        typer.Option(
            "--record",
            help="With --check: record the page and digests in DIR/../generated, and skip "
            "scripts that are recorded there and have not changed.",
        ),
    ] = False,
    one_in: Annotated[
        int,
        typer.Option("--one-in", metavar="N", min=1, help="Check only every N-th script."),
    ] = 1,
    functions: Annotated[
        bool,
        typer.Option(
            "--functions",
            help="Instead: have Coq prove bounds of the elementary functions of compiled kernels.",
        ),
    ] = False,
    derivations: options.Derivations = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Write a Coq script for every row that is PROVED, REFUTED or CONDITIONAL, for `make`.

    Each script states its row in the letters of the paper, with the domain as hypotheses. Before
    it is written, its text is read back and compared with the row. Scripts recorded as refused by
    Coq are left out. With --check, Coq checks all scripts, those that it does not accept are
    removed, and COQ.md lists the file of every row, or why it has none. With --functions, Coq
    proves error bounds of sine, cosine, tangent and small arctangent as compiled kernels compute
    them: what rounding adds, and how far their polynomials are off.

    Exit status 0: the scripts are written, and agree with the record if there is one; 1: Coq is not
    installed, or does not accept a script that is recorded as accepted; a row hangs or crashes, or
    a derivation fails; or a function has no proved bound; 2: bad usage.
    """
    from mechproof.pipeline.row_scripts import certify as certify_papers

    if functions:
        if papers or check or record or one_in > 1:
            refuse("--functions: takes no papers and no --check, --record or --one-in")
        _prove_functions(out)
        return
    if record and (not check or one_in > 1 or papers):
        refuse("--record: needs --check, and all scripts of all papers")
    places = find_places(derivations, None)
    stages = certify_papers(
        find_locations(papers or (), places, SUFFIXES),
        out,
        places.generated,
        check=check,
        record=record,
        one_in=one_in,
        use_cache=not no_cache,
        limit=limit,
        progress=show_progress,
    )
    with ending(PipelineError, fail):
        for done in stages:
            _describe(done, out)


def _prove_functions(out: Path) -> None:
    from mechproof.arithmetic.intervals import EPS
    from mechproof.coq.checker import CheckerError
    from mechproof.pipeline.bound_scripts import DIGITS, prove_functions_in_coq

    refused = (CheckerError, ForeignFileError, OSError)
    with ending(refused, fail), show_progress("running Coq") as report:
        found = prove_functions_in_coq(out, report)
    for one in found:
        told = f"no proof in Coq: {one.reason}"
        if one.bound is not None:
            told = f"rounding adds at most {float(one.bound) / EPS:.{DIGITS}g} eps"
            if one.off is not None:
                told += f", its polynomial is off by at most {float(one.off) / EPS:g} eps"
            told += f" ({out / one.file})"
        say(f"{one.name}: {told}")
    if not all(one.file for one in found):
        raise typer.Exit(1)


def _describe(done: Certified, out: Path) -> None:
    if done.coverage is None:
        say(f"{out}: {done.written} scripts of {done.rows} rows; `make -C {out}` checks them")
        if done.left_out:
            say(f"left out: {done.left_out} scripts recorded as refused by Coq")
        return
    say(done.coverage.count())
    if done.lost:
        fail("\n".join(f"not as recorded: {line}" for line in done.lost))
