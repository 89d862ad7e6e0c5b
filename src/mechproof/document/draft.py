"""A first block of letters, to be confirmed: the letters of a paper and what its words say of them.

Nothing of a draft is used before it stands in the paper.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from mechproof.document.complex_parts import find_imaginary_unit
from mechproof.document.drafted_lines import ask_refused
from mechproof.document.extremes import ask_extremes, find_extremes
from mechproof.document.rows import Document
from mechproof.document.said_values import ask_what_follows, propose_relations, propose_values
from mechproof.latex.left_scripts import GREEK
from mechproof.nomenclature.counting_letters import find_counts
from mechproof.nomenclature.inline import (
    RATE,
    Inline,
    find_inline,
    find_printed_units,
)
from mechproof.nomenclature.letters import (
    INDICES,
    Collected,
    collect_letters,
    drop_transposition,
    is_vector,
    name_symbol,
    print_member,
)
from mechproof.nomenclature.said import Said, find_pi, find_said
from mechproof.nomenclature.shapes import find_sizes
from mechproof.sources.displays import Printed, find_displays
from mechproof.sources.files import Source

_RATE = re.compile(
    r"\\d{0,2}dot\s*(?:\{\s*)?(\\[A-Za-z]+(?:\s*\{\w+\})?|[A-Za-z])([^{}]*(?:\{[^{}]*\})?[^{}]*)\}?(.*)\Z",
    re.DOTALL,
)
# Seconds to find out whether a letter is a matrix.
_LIMIT = 10.0
# The arguments of a letter.
_ARGUMENTS = re.compile(r"(?<=.)\([^()]*\)\Z")
_DEPENDS = re.compile(r"(.+?)'*\((\\?[A-Za-z]+)\)\Z", re.DOTALL)
# A derivative of a letter by another.
_D = r"(?:d|\\mathrm\s*\{?\s*d\s*\}?)\s*"
_INDEX = r"_(?:\w|\{\w+\}|(?:\{\s*)?\\(?:text|mathrm|mbox)\s*\{[^{}]*\}\s*\}?)"
_QUOTIENT = re.compile(
    rf"\\frac\s*\{{\s*{_D}(?:\^\s*\{{?\d\}}?)?\s*"
    rf"(?P<of>\\?[A-Za-z]+(?:{_INDEX})?)\s*\}}\s*\{{\s*{_D}(?P<by>\\?[A-Za-z]+)[^{{}}]*\}}"
)
_RESPECT = re.compile(
    r"(?P<noun>\b(?:primes?|dash(?:es)?|derivatives?)\b[^$.]{0,60})?"
    r"\bwith\s+respect\s+to\s+(?:the\s+[\w\s-]{1,40}?)?\$(?P<by>[^$]{1,20})\$"
)
_EXTREME = re.compile(r"_\{?\s*(?:\\mathrm\s*\{|\\text\s*\{|\\)?(?:max|min)\b")
_FUNCTION = re.compile(r"\$\s*(\\?[A-Za-z]+)\s*\(\s*(\\?[A-Za-z]+)\s*\)\s*\$")
# A letter e: any, and one that is raised.
_E = re.compile(r"(?<![A-Za-z\\{])(?<!\\mathrm )(?<!\\rm )e(?![A-Za-z_}])")
_RAISED_E = re.compile(_E.pattern + r"\s*\^(?!\s*\{?\s*(?:\d|\*|\\ast|\\star))")
# A letter that is printed to be zero.
_ZERO = re.compile(r"\s*(\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*=\s*0\s*[.,;]?\s*")
# What is said to count, and how the block says so.
_COUNTING = re.compile(
    r"(?P<letter>\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*\\in\s*\\mathbb\s*"
    r"\{?\s*(?P<set>[NZ])\s*\}?(?P<zero>_\{?0\}?)?"
)
_EULER = ["# It is raised to powers: Euler's number.", "e :", r"let e=\mathrm{e}"]
# What is never negative: not what is said of it, the position of a mass or a mass ratio.
_POSITIVE = re.compile(
    r"(?:(?!(?:of|in|at|on|along|by|for|to|from|between|per)\b)[\w-]+\s+)*"
    r"(?:radius|radii|diameters?|lengths?|mass(?:es)?)(?!\s+of\s+curvature)"
    r"(?:\s+(?:of|in|at|on|for|to|from|between|and)\b|[^\w\s]|\s*\Z)",
    re.IGNORECASE,
)
# A word below a letter, as it is read.
_WORD_BELOW = re.compile(r"_\{\\([A-Za-z]+)\}")
# Letters that could be something else where nothing declares them.
_ASKED = {
    "e": r"a letter here, Euler's number elsewhere",
    "d": "a letter here, a differential elsewhere",
    "i": "a letter here, an index or the imaginary unit elsewhere",
}


@dataclass
class _Entry:
    """A letter: its prints, and the letter that it depends on."""

    names: dict[str, None] = field(default_factory=dict)
    running: str = ""


def draft_block(source: Source) -> str:
    """Return a block of letters for a paper; what was found in its words says where."""
    displays = list(find_displays(source.text))
    prints = [printed.latex.string for printed in displays]
    unit = find_imaginary_unit(prints)
    said = dict(find_said(source))
    has_euler = _is_euler(prints)
    plain = [_E.sub(r"\\mathrm{e}", latex) for latex in prints] if has_euler else prints
    counting = [match for latex in prints for match in _COUNTING.finditer(latex)]
    plain = [_COUNTING.sub(r"\g<letter>>0", latex) for latex in plain]
    collected = collect_letters(plain, guess=True, imaginary=unit, said=said)
    if find_pi(said):
        collected.letters.append(r"\pi")
    letters = [*collected.letters, *collected.guessed]
    found = find_sizes(plain, collected)
    shapes = Document(replace(source, lines=[], has_block=False)).find_sizes(_LIMIT) | found.known
    unclear = [x for x in letters if name_symbol(x) in found.unclear or _is_motion(x, shapes)]
    stems = {name_symbol(_strip_arguments(x)) for x in unclear}
    shapes = {name: size for name, size in shapes.items() if name not in stems}
    functions = _list_functions(source)
    respect = _find_running(source, displays, letters, functions)
    entries = _list_entries(collected, shapes, prints, respect, functions)
    inline = _find_inline(source, entries)
    values = [one.value for _, one in inline if one.number is None]
    for base, by in map(_split, collect_letters(values, guess=True, imaginary=unit).letters):
        entries.setdefault(name_symbol(base), _Entry({base: None}, by))
    for name, one in inline:
        known = said.get(name, Said("", "", one.line))
        for rate in RATE.finditer(f"{one.letter}={one.value}"):
            if moving := entries.get(name_symbol(rate[1])):
                moving.running = moving.running or "t"
        said[name] = replace(known, unit=known.unit or one.unit)
    shown = {
        name_symbol(_show(one)): name for name, entry in entries.items() for one in entry.names
    }
    for letter, measure, offset in find_printed_units(displays):
        name = shown.get(name_symbol(letter), "")
        known = said.get(name, Said("", "", source.files.locate(offset).line))
        said[name] = replace(known, unit=known.unit or measure)
    lines = [
        line
        for name, entry in entries.items()
        for line in _write(name, entry, shapes.get(name), said.get(name))
    ]
    for family in collected.families:
        members = {x: print_member(family, x) for x in INDICES}
        index = next((x for x in members if name_symbol(members[x]) in said), INDICES[0])
        about = said.get(name_symbol(members[index]))
        lines += _write(family, _Entry({members[index]: None}, index), None, about)
    lines += [f"[{x}] 3x3 :" for x in letters if name_symbol(x) in found.crosses]
    for name in dict.fromkeys(map(_strip_arguments, unclear)):
        lines.append(f"# {name} has several sizes: declare a letter for each, and say where it is")
        lines.append(f"# which: in (1): {name} is …")
    lines += _EULER if has_euler else []
    met = find_counts((x for x in plain if x not in collected.unread), ())
    counts = dict.fromkeys(map(name_symbol, met), "natural")
    for match in counting:
        is_natural = match["set"] == "N" and not match["zero"]
        counts[name_symbol(match["letter"])] = "natural" if is_natural else "integer"
    counted = ((kind, entries[name].names) for name, kind in counts.items() if name in entries)
    lines += [f"{kind} {next(iter(names))}" for kind, names in counted]
    running = {name: one.running for one in entries.values() for name in one.names}
    lines += propose_values(displays, running, said, inline)
    lines += propose_relations(source, [*running])
    lines += find_extremes(source, running)
    lines += ask_extremes(displays, running)
    for display in displays:
        if zero := _ZERO.fullmatch(display.latex.string):
            lines.append(f"# {display.name}: a constant of integration, which is zero throughout?")
            lines.append(f"# let {zero[1]}=0")
    depending = {name for name, entry in entries.items() if entry.running}
    factors = [x for x in collected.factors if name_symbol(x).rstrip("'") not in depending]
    if factors:
        lines.append("# A bracket follows each of these: they are taken to multiply it.")
        lines += [f"factor {name}" for name in factors]
    lines += [f"imaginary {unit}"] if unit else []
    lines += [f"function {name} is {meant}" for name, meant in collected.functions.items()]
    lines = ask_refused(lines, source)
    lines += ask_what_follows(source, displays)
    for display, latex in zip(displays, plain, strict=True):
        if error := collected.unread.get(latex):
            place = source.files.locate(display.latex.offsets[0])
            lines.append(f"# {display.name}, line {place.line}: its letters are missing here:")
            lines.append(f"#   {' '.join(error.reason.split())}")
    return "\n".join(["%% mechproof", *(f"%% {line}" for line in lines), "%% end", ""])


def _find_inline(source: Source, entries: Mapping[str, _Entry]) -> list[tuple[str, Inline]]:
    """Return what sentences say of letters: of each one size only, and one formula."""
    found: dict[tuple[str, bool], dict[str, Inline]] = {}
    for one in find_inline(source, [name for entry in entries.values() for name in entry.names]):
        kind = name_symbol(one.letter), one.number is None
        found.setdefault(kind, {}).setdefault(one.value, one)
    single = ((name, [*ones.values()]) for (name, _), ones in found.items())
    return [(name, ones[0]) for name, ones in single if len(ones) == 1]


def _is_euler(prints: Sequence[str]) -> bool:
    """Return whether a letter e is met, and only where it is raised to what is no number."""
    met = [match for latex in prints for match in _E.finditer(latex)]
    raised = [match for latex in prints for match in _RAISED_E.finditer(latex)]
    return bool(met) and len(met) == len(raised)


def _list_functions(source: Source) -> dict[str, str]:
    r"""Return what words say that letters are functions of, $s(\varphi)$, if it is but one."""
    said: dict[str, dict[str, None]] = {}
    for match in _FUNCTION.finditer(source.text.string):
        said.setdefault(name_symbol(match[1]), {})[match[2]] = None
    return {name: next(iter(by)) for name, by in said.items() if len(by) == 1}


def _find_running(
    source: Source,
    displays: Sequence[Printed],
    letters: Sequence[str],
    functions: Mapping[str, str],
) -> str:
    """Return the letter with respect to which words differentiate, if it is but one.

    They tell what primes are, or a prime is printed next: primes may also be of other coordinates.
    So do words by which what is printed with a prime is a function of it.
    """
    primed = {name_symbol(_split(x)[0].rstrip("'")) for x in letters if "'" in x}
    said = []
    for match in _RESPECT.finditer(source.text.string):
        offset = source.text.offsets[match.start()]
        behind = (one.latex.string for one in displays if one.latex.offsets[0] > offset)
        if match["noun"] or "'" in next(behind, ""):
            said.append(match["by"])
    said += [by for name, by in functions.items() if name in primed]
    found = {name_symbol(one): one for one in said}
    return next(iter(found.values())) if len(found) == 1 else ""


def _list_entries(
    collected: Collected,
    shapes: Mapping[str, tuple[int, int]],
    prints: Sequence[str],
    respect: str,
    said: Mapping[str, str],
) -> dict[str, _Entry]:
    """Return the letters by the names of their symbols; a derivative says what its letter is of.

    So do words, `said`, of a letter whose value is printed at one place only, w(l).
    Vectors and matrices are not differentiated: their derivatives are letters of their own, as the
    largest and least values of any are. Primes are derivatives by the letter `respect`, if words
    name one.
    """
    entries: dict[str, _Entry] = {}
    quotients = [match for latex in prints for match in _QUOTIENT.finditer(latex)]
    by = {name_symbol(match["of"]): match["by"] for match in quotients}
    met = drop_transposition([*collected.letters, *collected.guessed], prints)
    letters = [letter for letter in met if not _EXTREME.search(letter)]
    by |= {name: running for name, running in said.items() if running in letters}
    for base, running in map(_split, letters):
        if running:
            by.setdefault(name_symbol(base), running)
    for letter in letters:
        base, running = _split(letter)
        if base.endswith("'") and respect in letters:
            by.setdefault(name_symbol(base.rstrip("'")), respect)
    functions = _find_functions(letters, shapes, prints)
    for letter in letters:
        stem = _strip_arguments(letter)
        if name_symbol(stem) in functions:
            whole = functions[name_symbol(stem)]
            entry = entries.setdefault(name_symbol(whole), _Entry())
            entry.names |= {whole: None, stem: None}
            continue
        base, running = _split(letter)
        plain = base.rstrip("'")
        if by.get(name_symbol(plain), "t") != "t":
            base = plain
        running = by.get(name_symbol(base), "")
        if running and (is_vector(base) or {name_symbol(base), name_symbol(letter)} & {*shapes}):
            base, running = letter, ""
        entry = entries.setdefault(name_symbol(base), _Entry())
        entry.names[base] = None
        entry.running = entry.running or running
    extremes = (letter for letter in met if letter not in letters)
    return entries | {name_symbol(letter): _Entry({letter: None}) for letter in extremes}


def _find_functions(
    letters: Sequence[str], shapes: Mapping[str, tuple[int, int]], prints: Sequence[str]
) -> dict[str, str]:
    """Return the matrices that are never printed without arguments, and their first print."""
    found: dict[str, str] = {}
    for letter in letters:
        stem = _strip_arguments(letter)
        alone = re.compile(rf"{re.escape(stem)}(?![\w{{]|\s*(?:\\left\s*)?\()")
        if stem != letter and name_symbol(letter) in shapes and not any(map(alone.search, prints)):
            found.setdefault(name_symbol(stem), letter)
    return found


def _is_motion(letter: str, shapes: Mapping[str, tuple[int, int]]) -> bool:
    """Return whether a number x(t) has the name of a matrix x."""
    is_matrix = name_symbol(letter) in shapes or is_vector(letter) or not _DEPENDS.match(letter)
    return not is_matrix and name_symbol(_strip_arguments(letter)) in shapes


def _strip_arguments(letter: str) -> str:
    return _ARGUMENTS.sub("", letter).strip()


def _split(letter: str) -> tuple[str, str]:
    r"""Return a letter and what it is a function of: x and t of \dot x and of x(t)."""
    if rate := _RATE.match(letter):
        letter = rate[1] + rate[2] + rate[3]
        depends = _DEPENDS.match(letter)
        return (depends[1].strip() if depends and depends[2] == "t" else letter), "t"
    if depends := _DEPENDS.match(letter):
        return depends[1].strip(), depends[2]
    return letter, ""


def _write(
    name: str, entry: _Entry, size: tuple[int, int] | None, found: Said | None
) -> Iterator[str]:
    first, *alike = entry.names
    if is_vector(first) and not size:
        yield "# A vector or a matrix? Give its size after the name: 3x1"
    if first in _ASKED:
        yield f"# {_ASKED[first]}:"
    if found:
        yield f"# line {found.line} says:"
    running = f"({entry.running})" if entry.running else ""
    others = "".join(f" | {other}" for other in alike)
    shape = f" {size[0]}x{size[1]}" if size else ""
    unit = f" [{found.unit}]" if found and found.unit else ""
    meaning = f"{found.meaning if found else ''}{unit}".strip()
    if found and not running and _POSITIVE.match(found.meaning):
        meaning += f" {{{first}>0}}"
    yield _show(f"{first}{running}{others}{shape} : {meaning}".rstrip())


def _show(line: str) -> str:
    return _WORD_BELOW.sub(_write_upright, line)


def _write_upright(match: re.Match[str]) -> str:
    r"""Write a word below a letter as it may be printed: \mathrm{in}, which is read as \in."""
    is_macro = match[1] in GREEK or match[1] in ("max", "min")
    return match[0] if is_macro else rf"_{{\mathrm{{{match[1]}}}}}"
