"""A first block of letters, to be confirmed: a paper's letters and what its text says of them.

No part of a draft is used before it is copied into the paper.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from mechproof.document.double_signs import find_imaginary_unit
from mechproof.document.drafts import drafted_lines
from mechproof.document.drafts.said_values import (
    ask_extremes,
    ask_functions,
    ask_givens,
    ask_places,
    ask_what_follows,
    find_extremes,
    propose_conditions,
    propose_relations,
    propose_values,
)
from mechproof.document.numbers.size_tables import find_head_units
from mechproof.document.source_rows import Document
from mechproof.nomenclature.inline import RATE, Inline, find_inline, find_printed_units
from mechproof.nomenclature.possible_matrices import UNIT_MATRIX, write_unit
from mechproof.nomenclature.said import Said, find_pi, find_said, find_units
from mechproof.nomenclature.shapes import find_sizes
from mechproof.nomenclature.shown_letters import (
    Collected,
    collect_letters,
    find_places,
    name_symbol,
)
from mechproof.sources.displays import find_displays
from mechproof.sources.paper_files import LATEX_BLOCK, MARKDOWN_BLOCK, Source, is_markdown_name

# Seconds allowed for finding the sizes of matrices.
_LIMIT = 10.0
# A letter e anywhere, also raised after other letters, Ae^{-t}; and one raised to a power other
# than a number.
_E = re.compile(
    r"(?:(?<![A-Za-z\\{])(?<!\\mathrm )(?<!\\rm )"
    r"|(?<![A-Za-z\\])(?P<before>[A-Za-z]{1,3})(?=e\s*\^))e(?![A-Za-z_}])"
)
_RAISED_E = re.compile(_E.pattern + r"\s*\^(?!\s*\{?\s*(?:\d|\*|\\ast|\\star))")
_EULER = ["# It is raised to powers: Euler's number.", "e :", r"let e=\mathrm{e}", "factor e"]


def draft_block(source: Source) -> str:
    """Return a draft block of letters for a paper, with line numbers for what its text says."""
    displays = list(find_displays(source.text))
    prints = [printed.latex.string for printed in displays]
    unit = find_imaginary_unit(prints)
    said = dict(find_said(source))
    has_euler = _is_euler(prints)
    euler = r"\g<before>\\mathrm{e}"
    plain = [_E.sub(euler, latex) for latex in prints] if has_euler else prints
    plain = [drafted_lines.COUNTING.sub(r"\g<letter>>0", latex) for latex in plain]
    collected = collect_letters(plain, guess=True, imaginary=unit, said=said)
    if find_pi(said):
        collected.letters.append(r"\pi")
    letters = [*collected.letters, *collected.guessed]
    formulas = (one for one in find_inline(source, letters) if one.number is None)
    found = find_sizes([*plain, *(f"{x.letter}={x.value}" for x in formulas)], collected)
    document = Document(replace(source, lines=[], has_block=False))
    shapes = document.find_sizes(_LIMIT) | found.known
    unclear = [
        x for x in letters if name_symbol(x) in found.unclear or drafted_lines.is_motion(x, shapes)
    ]
    stems = {name_symbol(drafted_lines.strip_arguments(x)) for x in unclear}
    shapes = {name: size for name, size in shapes.items() if name not in stems}
    functions = drafted_lines.list_functions(source)
    respect = drafted_lines.find_running(source, displays, letters, functions)
    entries = drafted_lines.list_entries(collected, shapes, prints, respect, functions)
    inline, beside = _add_inline(source, entries, unit)
    _take_inline(inline, entries, said)
    heads = find_head_units(document.tables, document.symbols.reader())
    measures = [*find_printed_units(displays), *find_units(source), *heads]
    _take_units(measures, entries, said, source)
    running = {name: one.running for one in entries.values() for name in one.names}
    called = {**collected.functions, **beside.functions}
    readable = (x for x in plain if x not in collected.unread)
    # A matrix needs no `factor` line: a bracket after it multiplies it unless it is an argument.
    brackets = dict.fromkeys([*collected.factors, *beside.factors])
    places = find_places(brackets, prints)
    factors = [x for x in brackets if name_symbol(x) not in shapes and x not in places]
    lines = [
        *chain.from_iterable(
            drafted_lines.write_letter(name, entry, shapes.get(name), said.get(name))
            for name, entry in entries.items()
        ),
        *drafted_lines.write_families(collected.families, said),
        *(f"[{x}] 3x3 :" for x in letters if name_symbol(x) in found.crosses),
        *drafted_lines.ask_sizes(map(drafted_lines.strip_arguments, unclear)),
        *(_EULER if has_euler else ()),
        *_write_unit_matrices(prints, entries, shapes, said),
        *drafted_lines.write_counts(prints, readable, entries, said, source.text.string),
        *propose_values(displays, running, said, inline),
        *propose_relations(source, [*running], displays),
        *propose_conditions(source, [*running], displays),
        *find_extremes(source, displays, running),
        *ask_extremes(displays, running),
        *ask_places(source, displays, running),
        *ask_givens(displays, inline),
        *drafted_lines.ask_zeros(displays),
        *drafted_lines.write_factors(factors, entries, prints),
        *ask_functions(places, running),
        *((f"imaginary {unit}",) if unit else ()),
        *(f"function {name} is {meant}" for name, meant in called.items()),
    ]
    lines = drafted_lines.ask_refused(lines, source)
    lines += ask_what_follows(source, displays)
    lines += drafted_lines.describe_unread(displays, plain, collected, source)
    is_markdown = is_markdown_name(source.files.names[0])
    first, mark, last = MARKDOWN_BLOCK if is_markdown else LATEX_BLOCK
    return "\n".join([first, *(f"{mark}{line}" for line in lines), last, ""])


def _write_unit_matrices(
    prints: Sequence[str],
    entries: Mapping[str, drafted_lines.DraftedLetter],
    shapes: Mapping[str, tuple[int, int]],
    said: Mapping[str, Said],
) -> Iterator[str]:
    """Yield values of unit matrices: letters I or 1 that are only added, or alone on a side."""
    for name, entry in entries.items():
        rows, columns = shapes.get(name, (0, 1))
        letter = next(iter(entry.names))
        if rows != columns or name in said or not UNIT_MATRIX.fullmatch(letter):
            continue
        places = [
            m
            for x in prints
            for m in re.finditer(rf"(?<![\w{{\\]){re.escape(letter)}(?![\w{{])", x)
        ]
        if places and all(map(_is_summand, places)):
            yield "# It is only added, so taken to be the unit matrix."
            yield f"let {letter}={write_unit(rows)}"


def _is_summand(place: re.Match[str]) -> bool:
    before, after = place.string[: place.start()], place.string[place.end() :]
    is_first = re.search(r"(?:\A|[-+=&(\[])\s*\Z", before)
    is_last = re.match(r"[\s.,;]*(?:\Z|[-+=&)\]]|\\\\|\\right)", after)
    # An equation with the letter alone on its left defines it.
    is_defined = re.fullmatch(r"\s*", before) and re.match(r"\s*&?=", after)
    return bool(is_first and is_last and not is_defined)


def _take_inline(
    inline: Sequence[tuple[str, Inline]],
    entries: Mapping[str, drafted_lines.DraftedLetter],
    said: dict[str, Said],
) -> None:
    """Enter the units that sentences give letters, and that letters with rates move."""
    for name, one in inline:
        known = said.get(name, Said("", "", one.line))
        if one.by and (depending := entries.get(name)):
            depending.running = depending.running or one.by
        for rate in RATE.finditer(f"{one.letter}={one.value}"):
            if moving := entries.get(name_symbol(rate[1])):
                moving.running = moving.running or "t"
        said[name] = replace(known, unit=known.unit or one.unit)


def _take_units(
    measures: Sequence[tuple[str, str, int]],
    entries: Mapping[str, drafted_lines.DraftedLetter],
    said: dict[str, Said],
    source: Source,
) -> None:
    """Enter the printed units of letters; those of displays come first."""
    shown = {
        name_symbol(drafted_lines.show_line(one)): name
        for name, entry in entries.items()
        for one in entry.names
    }
    for letter, measure, offset in measures:
        name = shown.get(name_symbol(letter), "")
        known = said.get(name, Said("", "", source.files.locate(offset).line))
        said[name] = replace(known, unit=known.unit or measure)


def _add_inline(
    source: Source, entries: dict[str, drafted_lines.DraftedLetter], unit: str
) -> tuple[list[tuple[str, Inline]], Collected]:
    """Enter the letters of formulas that sentences give for letters, and of those for these.

    Returns the formulas, each with the name it defines, and what was collected from them.
    """
    while True:
        inline, count = _find_inline(source, entries), len(entries)
        values = [one.value for _, one in inline if one.number is None]
        beside = collect_letters(values, guess=True, imaginary=unit)
        for base, by in map(drafted_lines.split_letter, [*beside.letters, *beside.guessed]):
            entries.setdefault(name_symbol(base), drafted_lines.DraftedLetter({base: None}, by))
        if len(entries) == count:
            return inline, beside


def _find_inline(
    source: Source, entries: Mapping[str, drafted_lines.DraftedLetter]
) -> list[tuple[str, Inline]]:
    """Return the sizes and formulas that sentences give letters, if unique for the letter."""
    found: dict[tuple[str, bool], dict[object, Inline]] = {}
    for one in find_inline(source, [name for entry in entries.values() for name in entry.names]):
        kind = name_symbol(one.letter), one.number is None
        value = (one.number.value, one.unit) if one.number else one.value
        found.setdefault(kind, {}).setdefault(value, one)
    # A formula or zero for one case does not compete with a value that holds throughout.
    single = (
        (name, [x for x in ones.values() if not _is_of_case(x)] or [*ones.values()])
        for (name, _), ones in found.items()
    )
    return [(name, ones[0]) for name, ones in single if len(ones) == 1]


def _is_of_case(one: Inline) -> bool:
    return one.is_case and (one.number is None or one.number.value == 0)


def _is_euler(prints: Sequence[str]) -> bool:
    """Return whether there is a letter e that is only raised to powers other than numbers."""
    met = [match for latex in prints for match in _E.finditer(latex)]
    raised = [match for latex in prints for match in _RAISED_E.finditer(latex)]
    return bool(met) and len(met) == len(raised)
