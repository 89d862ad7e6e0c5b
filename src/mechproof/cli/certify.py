"""The command that writes what is proved as scripts of Coq, and has Coq check them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from mechproof.cli import options
from mechproof.cli.console import fail, refuse, say, show_progress
from mechproof.cli.judging import judge_papers, refuse_failures
from mechproof.cli.paths import find_locations, find_places, read_out
from mechproof.pipeline.verification import LIMIT
from mechproof.sources.files import SUFFIXES
from mechproof.tools.made import ForeignFileError


def certify(
    papers: options.Papers = None,
    out: Annotated[
        Path,
        typer.Option(metavar="FOLDER", help="The folder that the scripts go to.", parser=read_out),
    ] = Path("coq"),
    check: Annotated[
        bool, typer.Option("--check", help="Have Coq check them, and write the coverage page.")
    ] = False,
    record: Annotated[
        bool,
        typer.Option(
            "--record",
            help="With --check: keep page and digests in DIR/../generated, and take over what "
            "is recorded there and has not changed.",
        ),
    ] = False,
    one_in: Annotated[
        int,
        typer.Option("--one-in", metavar="N", min=1, help="Have every N-th script checked alone."),
    ] = 1,
    derivations: options.Derivations = None,
    no_cache: options.NoCache = False,
    limit: options.Limit = LIMIT,
) -> None:
    """Write a Coq script for every row that is PROVED, REFUTED or CONDITIONAL, for `make`.

    Each states its row in the letters of the paper, with the domain as hypotheses, and is read
    back from its text and compared with the row before it is written. What Coq refuses by the
    record is left out. With --check all scripts are checked, those that Coq does not accept are
    removed, and COQ.md says of every row which file it has, or why it has none.

    Exit status 0: written, and as recorded where there is a record; 1: Coq is not installed, or
    does not accept a script that is recorded as accepted, a row hangs or crashes, or a derivation
    fails; 2: bad usage.
    """
    from mechproof.coq.checker import RECORD_LIMIT, CheckerError
    from mechproof.coq.coverage import check_folder, keep_record, read_known, read_refused
    from mechproof.coq.folder import write_folder
    from mechproof.pipeline.row_scripts import write_row_scripts

    if record and (not check or one_in > 1 or papers):
        refuse("--record: with --check, of all papers and all their scripts")
    places = find_places(derivations, None)
    locations = find_locations(papers or (), places, SUFFIXES)
    ledgers = judge_papers(locations, use_cache=not no_cache, limit=limit)
    refuse_failures(ledgers)
    try:
        with show_progress("writing scripts") as tell:
            certificates = write_row_scripts(dict(zip(locations, ledgers, strict=True)), tell)
        known, refused = read_known(places.generated), read_refused(places.generated)
        left = [c for c in certificates if not check and c.text and refused.get(c.id) == c.digest]
        write_folder(out, [c for c in certificates if c not in left])
        written = sum(bool(c.text) for c in certificates) - len(left)
        say(f"{out}: {written} scripts of {len(certificates)} rows; `make -C {out}` checks them")
        if left:
            say(f"left out: {len(left)} scripts that Coq refuses by the record")
        if not check:
            return
        with show_progress("running Coq") as tell:
            if record:
                coverage = check_folder(out, certificates, tell, known=known, limit=RECORD_LIMIT)
            else:
                coverage = check_folder(out, certificates, tell, one_in=one_in)
        if record:
            keep_record(places.generated, coverage)
    except (CheckerError, ForeignFileError, OSError, ValueError) as error:
        fail(str(error))
    say(coverage.count())
    if lost := [] if record else coverage.find_lost(known):
        fail("\n".join(f"not as recorded: {line}" for line in lost))
