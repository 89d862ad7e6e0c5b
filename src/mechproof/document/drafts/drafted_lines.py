"""Lines of a draft: findings about letters, and questions about what needs confirming.

The letters are those of displays, with the letters that they depend on by prints and by text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain, pairwise

from mechproof.document.source_rows import Document
from mechproof.latex.characters import GREEK
from mechproof.latex.words import OPENS_WORDS
from mechproof.nomenclature.block import BlockError
from mechproof.nomenclature.counting_letters import find_counted, find_counts
from mechproof.nomenclature.said import Said
from mechproof.nomenclature.shown_letters import (
    INDICES,
    Collected,
    drop_transposition,
    is_vector,
    name_symbol,
    print_member,
)
from mechproof.nomenclature.symbol_names import leave_pairs
from mechproof.sources.displays import Printed
from mechproof.sources.located_text import Files
from mechproof.sources.paper_files import Source

# A letter that is printed to be zero.
_ZERO = re.compile(r"\s*(\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*=\s*0\s*[.,;]?\s*")
# A letter that is printed to be a whole number, k\in\mathbb N.
COUNTING = re.compile(
    r"(?P<letter>\\?[A-Za-z]+(?:_(?:\w|\{\w+\}))?)\s*\\in\s*\\mathbb\s*"
    r"\{?\s*(?P<set>[NZ])\s*\}?(?P<zero>_\{?0\}?)?"
)
# Words that make a letter a whole number.
_NUMBER = re.compile(r"\b(?:number|count|order|index|integer)", re.IGNORECASE)
# Quantities that are never negative. The position of a mass or a mass ratio is not among them.
_POSITIVE = re.compile(
    r"(?:(?!(?:of|in|at|on|along|by|for|to|from|between|per)\b)[\w-]+\s+)*"
    r"(?:radius|radii|diameters?|lengths?|mass(?:es)?|stiffness(?:es)?|spring|damper"
    r"|(?:spring|damping)\s+(?:rate|constant|coefficient))(?!\s+of\s+curvature)"
    r"(?:\s+(?:of|in|at|on|for|to|from|between|and)\b|[^\w\s]|\s*\Z)",
    re.IGNORECASE,
)
# A word in a letter's index, as it is read.
_WORD_BELOW = re.compile(r"(?<=_\{)\\([A-Za-z]+)(?=[,}])|(?<=,)\\([A-Za-z]+)(?=\})")
# Letters that could mean something else if undeclared.
_ASKED = {
    "e": r"a letter here, Euler's number elsewhere",
    "d": "a letter here, a differential elsewhere",
    "i": "a letter here, an index or the imaginary unit elsewhere",
}
_RATE = re.compile(
    r"\\d{0,2}dot\s*(?:\{\s*)?(\\[A-Za-z]+(?:\s*\{\w+\})?|[A-Za-z])([^{}]*(?:\{[^{}]*\})?[^{}]*)\}?(.*)\Z",
    re.DOTALL,
)
# The arguments of a letter.
_ARGUMENTS = re.compile(r"(?<=.)\([^()]*\)\Z")
_DEPENDS = re.compile(r"(.+?)'*\((\\?[A-Za-z]+)\)\Z", re.DOTALL)
# A derivative of a letter by another.
_D = r"(?:d|\\mathrm\s*\{?\s*d\s*\}?)\s*"
_INDEX = rf"_(?:\w|\{{\w+\}}|(?:\{{\s*)?{OPENS_WORDS}[^{{}}]*\}}\s*\}}?)"
_OF = rf"{_D}(?:\^\s*\{{?\d\}}?)?\s*(?P<of>\\?[A-Za-z]+(?:{_INDEX})?)\s*"
# A derivative by \dot q shows no letter that the other one depends on.
_ACCENT = r"\\(?:d+ot|vec|bar|hat|tilde|math[a-z]+|bm)(?![A-Za-z])"
_BY = rf"{_D}(?P<by>(?!{_ACCENT})\\?[A-Za-z]+(?:{_INDEX})?)"
_QUOTIENTS = (
    re.compile(rf"\\frac\s*\{{\s*{_OF}\}}\s*\{{\s*{_BY}[^{{}}]*\}}"),
    re.compile(rf"(?<![A-Za-z\\]){_OF}/\s*{_BY}"),
)
_RESPECT = re.compile(
    r"(?P<noun>\b(?:primes?|dash(?:es)?|derivatives?)\b[^$.]{0,60})?"
    r"\bwith\s+respect\s+to\s+(?:the\s+[\w\s-]{1,40}?)?\$(?P<by>[^$]{1,20})\$"
)
# The variable of a prime, which the chain rule shows: s'\dot\theta.
_CHAINED = re.compile(r"(?<!')'\s*(?:\\cdot\s*|\\,\s*)?\\dot\s*\{?\s*(\\?[A-Za-z]+)")
_EXTREME = re.compile(r"_\{?\s*(?:\\mathrm\s*\{|\\text\s*\{|\\)?(?:max|min)\b")
_FUNCTION = re.compile(r"\$\s*(\\?[A-Za-z]+)\s*\(\s*((?!\\pi\s*\))\\?[A-Za-z]+)\s*\)\s*\$")


def write_letter(
    name: str, entry: DraftedLetter, size: tuple[int, int] | None, found: Said | None
) -> Iterator[str]:
    """Yield the line that declares a letter, after questions about it and its place in the text."""
    first, *alike = entry.names
    if is_vector(first) and not size:
        yield "# A vector or a matrix? Give its size after the name: 3x1"
    if first in _ASKED:
        yield f"# {_ASKED[first]}:"
    if found:
        yield f"# line {found.line} says:"
    running = f"({entry.running})" if entry.running and not size else ""
    others = "".join(f" | {other}" for other in alike)
    shape = f" {size[0]}x{size[1]}" if size else ""
    unit = f" [{found.unit}]" if found and found.unit else ""
    meaning = f"{found.meaning if found else ''}{unit}".strip()
    if found and not running and _POSITIVE.match(found.meaning):
        meaning += f" {{{first}>0}}"
    yield show_line(f"{first}{running}{others}{shape} : {meaning}".rstrip())


def write_families(families: Iterable[str], said: Mapping[str, Said]) -> Iterator[str]:
    """Yield the lines of families, whose members occur in sums."""
    for family in families:
        members = {x: print_member(family, x) for x in INDICES}
        index = next((x for x in members if name_symbol(members[x]) in said), INDICES[0])
        found = said.get(name_symbol(members[index]))
        yield from write_letter(family, DraftedLetter({members[index]: None}, index), None, found)


def write_counts(
    prints: Sequence[str],
    plain: Iterable[str],
    entries: Mapping[str, DraftedLetter],
    said: Mapping[str, Said],
    words: str,
) -> Iterator[str]:
    r"""Yield lines for letters that count: k of k\in\mathbb{N}, and n of \sum^n in plain prints.

    The latter is only a question if the text gives the letter a meaning that is no count.
    """
    counts = dict.fromkeys(map(name_symbol, find_counted(words, prints)), "natural")
    for name in map(name_symbol, find_counts(plain, ())):
        meaning = said[name].meaning if name in said else ""
        counts[name] = "natural" if not meaning or _NUMBER.search(meaning) else "# natural"
    for match in (match for latex in prints for match in COUNTING.finditer(latex)):
        is_natural = match["set"] == "N" and not match["zero"]
        counts[name_symbol(match["letter"])] = "natural" if is_natural else "integer"
    counted = ((kind, entries[name].names) for name, kind in counts.items() if name in entries)
    yield from (f"{kind} {next(iter(names))}" for kind, names in counted)


def write_factors(
    factors: Iterable[str], entries: Mapping[str, DraftedLetter], prints: Sequence[str]
) -> Iterator[str]:
    r"""Yield the letters that a bracket after them multiplies, as they depend on nothing.

    A fraction after \tan\alpha may also belong to the argument, so that is a question.
    """
    depending = {name for name, entry in entries.items() if entry.running}
    found = [x for x in factors if name_symbol(x).rstrip("'") not in depending]
    asked = [x for x in found if any(rf"{x}\frac" in latex for latex in prints)]
    if len(found) > len(asked):
        yield "# Each of these is followed by a bracket and taken to multiply it."
        yield from (f"factor {name}" for name in found if name not in asked)
    for name in asked:
        yield f"# A fraction follows {name}: a factor, or part of its argument?"
        yield f"# factor {name}"


def ask_sizes(letters: Iterable[str]) -> Iterator[str]:
    """Yield questions about matrices of several sizes."""
    for name in dict.fromkeys(letters):
        yield f"# {name} has several sizes: declare a letter for each, and where it is meant:"
        yield f"# in (1): {name} is …"


def ask_zeros(displays: Iterable[Printed]) -> Iterator[str]:
    """Yield questions about letters that are printed to be zero."""
    for display in displays:
        if zero := _ZERO.fullmatch(display.latex.string):
            yield f"# {display.name}: is this a constant of integration that is zero throughout?"
            yield f"# let {zero[1]}=0"


def describe_unread(
    displays: Sequence[Printed], plain: Sequence[str], collected: Collected, source: Source
) -> Iterator[str]:
    """Yield the displays that could not be read, whose letters are therefore missing."""
    for display, latex in zip(displays, plain, strict=True):
        if error := collected.unread.get(latex):
            place = source.files.locate(display.latex.offsets[0])
            yield f"# {display.name}, line {place.line}: its letters are missing here:"
            yield f"#   {' '.join(error.reason.split())}"


def ask_refused(lines: Sequence[str], source: Source) -> list[str]:
    """Return a draft's lines; those that a check would refuse are commented out with the reason."""
    # Prints may be wrapped, but an entry of a block is one line.
    kept = [" ".join(line.split("\n")) for line in lines]
    while refused := _find_refused(kept, source):
        asked = ([refused[n], f"# {x}"] if n in refused else [x] for n, x in enumerate(kept, 1))
        kept = list(chain.from_iterable(asked))
    return kept


def _find_refused(lines: Sequence[str], source: Source) -> dict[int, str]:
    """Return the reasons for refused lines by line number, counted from 1."""
    files = Files([*source.files.names], [*source.files.contents])
    text = files.add("draft", "\n".join(lines))
    ends = [-1, *(n for n, sign in enumerate(f"{text.string}\n") if sign == "\n")]
    drafted = [text[start + 1 : end] for start, end in pairwise(ends)]
    said = [line for line in drafted if line.string[:1] not in ("", "#")]
    try:
        Document(replace(source, files=files, lines=said, has_block=True))
    except BlockError as error:
        faults = ((x.number, x.reason.partition("\n")[0]) for x in error.faults if x.number)
        return {
            n: f"# {reason}" if reason.endswith("?") else f"# {reason}:" for n, reason in faults
        }
    except ValueError:
        # No single line is refused, so the check itself will report the error.
        pass
    return {}


def show_line(line: str) -> str:
    """Return a line with the words in indices as they may be printed."""
    return _WORD_BELOW.sub(_write_upright, line)


def _write_upright(match: re.Match[str]) -> str:
    r"""Write a word in an index as it may be printed: \mathrm{in}, as \in would be a sign."""
    word = match[1] or match[2]
    is_macro = word in GREEK or word in ("max", "min")
    return match[0] if is_macro else rf"\mathrm{{{word}}}"


@dataclass
class DraftedLetter:
    """A drafted letter: its prints, and the letter that it depends on, or ""."""

    names: dict[str, None] = field(default_factory=dict)
    running: str = ""


def list_entries(
    collected: Collected,
    shapes: Mapping[str, tuple[int, int]],
    prints: Sequence[str],
    respect: str,
    said: Mapping[str, str],
) -> dict[str, DraftedLetter]:
    """Return drafted letters by symbol name; a derivative shows what its letter depends on.

    So does the text, `said`, for a letter whose value is printed at one place only, w(l). Vectors
    and matrices are not differentiated: their derivatives are letters of their own, as are largest
    and least values. Primes are derivatives by the letter `respect`, unless it is "".
    """
    entries: dict[str, DraftedLetter] = {}
    quotients = [match for latex in prints for one in _QUOTIENTS for match in one.finditer(latex)]
    by = {name_symbol(match["of"]): match["by"] for match in quotients}
    met = drop_transposition([*collected.letters, *collected.guessed], prints)
    letters = [letter for letter in leave_pairs(met, prints) if not _EXTREME.search(letter)]
    by |= {name: running for name, running in said.items() if running in letters}
    if respect in letters:
        primed = (base.rstrip("'") for base, _ in map(split_letter, letters) if "'" in base)
        by = dict.fromkeys(map(name_symbol, primed), respect) | by
    for base, running in map(split_letter, letters):
        if running:
            by.setdefault(name_symbol(base), running)
    functions = _find_functions(letters, shapes, prints)
    for letter in letters:
        stem = strip_arguments(letter)
        if name_symbol(stem) in functions:
            whole = functions[name_symbol(stem)]
            entry = entries.setdefault(name_symbol(whole), DraftedLetter())
            entry.names |= {whole: None, stem: None}
            continue
        base, running = split_letter(letter)
        plain = base.rstrip("'")
        if by.get(name_symbol(plain), "t") != "t":
            base = plain
        running = by.get(name_symbol(base), "")
        if running and (is_vector(base) or {name_symbol(base), name_symbol(letter)} & {*shapes}):
            base, running = letter, ""
        entry = entries.setdefault(name_symbol(base), DraftedLetter())
        entry.names[base] = None
        entry.running = entry.running or running
    for letter in filter(_RATE.match, letters):
        # \dot s of s(\theta) follows from the chain rule, so that \theta depends on time.
        running = by.get(name_symbol(split_letter(letter)[0]), "t")
        if running != "t" and name_symbol(running) in entries:
            entries[name_symbol(running)].running = "t"
    extremes = (letter for letter in met if _EXTREME.search(letter))
    return entries | {name_symbol(letter): DraftedLetter({letter: None}) for letter in extremes}


def _find_functions(
    letters: Sequence[str], shapes: Mapping[str, tuple[int, int]], prints: Sequence[str]
) -> dict[str, str]:
    """Return matrices with arguments by stem, with their first print, if the stem has one size."""
    found: dict[str, str] = {}
    for letter in letters:
        stem = strip_arguments(letter)
        alone = re.compile(rf"{re.escape(stem)}(?![\w{{]|\s*(?:\\left\s*)?\()")
        size, plain = (shapes.get(name_symbol(one)) for one in (letter, stem))
        if stem != letter and size and (size == plain or not any(map(alone.search, prints))):
            found.setdefault(name_symbol(stem), letter)
    return found


def list_functions(source: Source) -> dict[str, str]:
    r"""Return the letters' variables according to the text, $s(\varphi)$, if it names just one."""
    said: dict[str, dict[str, None]] = {}
    for match in _FUNCTION.finditer(source.text.string):
        said.setdefault(name_symbol(match[1]), {})[match[2]] = None
    return {name: next(iter(by)) for name, by in said.items() if len(by) == 1}


def find_running(
    source: Source,
    displays: Sequence[Printed],
    letters: Sequence[str],
    functions: Mapping[str, str],
) -> str:
    r"""Return the letter that derivatives in the text are taken with respect to, or "".

    Sources are words about primes or just before a primed display, $s(\varphi)$ in the text for a
    primed letter s, and the chain rule. "" is returned unless they all name one letter, as primes
    may also mark other coordinates.
    """
    primed = {name_symbol(split_letter(x)[0].rstrip("'")) for x in letters if "'" in x}
    said = []
    for match in _RESPECT.finditer(source.text.string):
        offset = source.text.offsets[match.start()]
        after = (one.latex.string for one in displays if one.latex.offsets[0] > offset)
        if match["noun"] or "'" in next(after, ""):
            said.append(match["by"])
    said += [by for name, by in functions.items() if name in primed]
    said += [by for one in displays for by in _CHAINED.findall(one.latex.string)]
    found = {name_symbol(one): one for one in said}
    return next(iter(found.values())) if len(found) == 1 else ""


def is_motion(letter: str, shapes: Mapping[str, tuple[int, int]]) -> bool:
    """Return whether x(t) is a number although a matrix has the name x."""
    is_matrix = name_symbol(letter) in shapes or is_vector(letter) or not _DEPENDS.match(letter)
    return not is_matrix and name_symbol(strip_arguments(letter)) in shapes


def strip_arguments(letter: str) -> str:
    """Return a letter without the bracketed arguments after it."""
    return _ARGUMENTS.sub("", letter).strip()


def split_letter(letter: str) -> tuple[str, str]:
    r"""Return a letter and its variable: x and t for both \dot x and x(t)."""
    if rate := _RATE.match(letter):
        letter = rate[1] + rate[2] + rate[3]
        depends = _DEPENDS.match(letter)
        return (depends[1].strip() if depends and depends[2] == "t" else letter), "t"
    if depends := _DEPENDS.match(letter):
        return depends[1].strip(), depends[2]
    return letter, ""
