"""Lines of a draft as a check would read them: what it refuses is left as a question."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from mechproof.document.rows import Document
from mechproof.nomenclature.block import BlockError
from mechproof.sources.files import Source
from mechproof.sources.text import Files


def ask_refused(lines: Sequence[str], source: Source) -> list[str]:
    """Return the lines of a draft, those that a check would refuse as comments that say why."""
    kept = [*lines]
    while refused := _find_refused(kept, source):
        kept = [x for n, line in enumerate(kept, 1) for x in _ask(line, refused.get(n, ""))]
    return kept


def _ask(line: str, reason: str) -> list[str]:
    return [f"# {reason.splitlines()[0]}:", f"# {line}"] if reason else [line]


def _find_refused(lines: Sequence[str], source: Source) -> dict[int, str]:
    """Return the lines that are refused by their numbers, counted from 1, with the reasons."""
    files = Files([*source.files.names], [*source.files.contents])
    text = files.add("draft", "\n".join(lines))
    ends = [-1, *(n for n, sign in enumerate(f"{text.string}\n") if sign == "\n")]
    drafted = [text[start + 1 : end] for start, end in pairwise(ends)]
    said = [line for line in drafted if line.string[:1] not in ("", "#")]
    try:
        Document(replace(source, files=files, lines=said, has_block=True))
    except BlockError as error:
        return {fault.number: fault.reason for fault in error.faults if fault.number}
    except ValueError:
        # It is no line of its own that is refused: the check will say it.
        pass
    return {}
