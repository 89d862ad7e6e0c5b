"""The letters of a draft: those of displays, with what they depend on by prints and words."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from mechproof.nomenclature.shown_letters import (
    Collected,
    drop_transposition,
    is_vector,
    name_symbol,
)
from mechproof.nomenclature.symbol_names import leave_pairs
from mechproof.sources.displays import Printed
from mechproof.sources.paper_files import Source

_RATE = re.compile(
    r"\\d{0,2}dot\s*(?:\{\s*)?(\\[A-Za-z]+(?:\s*\{\w+\})?|[A-Za-z])([^{}]*(?:\{[^{}]*\})?[^{}]*)\}?(.*)\Z",
    re.DOTALL,
)
# The arguments of a letter.
_ARGUMENTS = re.compile(r"(?<=.)\([^()]*\)\Z")
_DEPENDS = re.compile(r"(.+?)'*\((\\?[A-Za-z]+)\)\Z", re.DOTALL)
# A derivative of a letter by another.
_D = r"(?:d|\\mathrm\s*\{?\s*d\s*\}?)\s*"
_INDEX = r"_(?:\w|\{\w+\}|(?:\{\s*)?\\(?:text|mathrm|mbox)\s*\{[^{}]*\}\s*\}?)"
_OF = rf"{_D}(?:\^\s*\{{?\d\}}?)?\s*(?P<of>\\?[A-Za-z]+(?:{_INDEX})?)\s*"
_BY = rf"{_D}(?P<by>\\?[A-Za-z]+)"
_QUOTIENTS = (
    re.compile(rf"\\frac\s*\{{\s*{_OF}\}}\s*\{{\s*{_BY}[^{{}}]*\}}"),
    re.compile(rf"(?<![A-Za-z\\]){_OF}/\s*{_BY}"),
)
_RESPECT = re.compile(
    r"(?P<noun>\b(?:primes?|dash(?:es)?|derivatives?)\b[^$.]{0,60})?"
    r"\bwith\s+respect\s+to\s+(?:the\s+[\w\s-]{1,40}?)?\$(?P<by>[^$]{1,20})\$"
)
# What primes are by, as the chain rule tells: s'\dot\theta.
_CHAINED = re.compile(r"(?<!')'\s*(?:\\cdot\s*|\\,\s*)?\\dot\s*\{?\s*(\\?[A-Za-z]+)")
_EXTREME = re.compile(r"_\{?\s*(?:\\mathrm\s*\{|\\text\s*\{|\\)?(?:max|min)\b")
_FUNCTION = re.compile(r"\$\s*(\\?[A-Za-z]+)\s*\(\s*(\\?[A-Za-z]+)\s*\)\s*\$")


@dataclass
class DraftedLetter:
    """A letter: its prints, and the letter that it depends on."""

    names: dict[str, None] = field(default_factory=dict)
    running: str = ""


def list_entries(
    collected: Collected,
    shapes: Mapping[str, tuple[int, int]],
    prints: Sequence[str],
    respect: str,
    said: Mapping[str, str],
) -> dict[str, DraftedLetter]:
    """Return the letters by the names of their symbols; a derivative says what its letter is of.

    So do words, `said`, of a letter whose value is printed at one place only, w(l).
    Vectors and matrices are not differentiated: their derivatives are letters of their own, as the
    largest and least values of any are. Primes are derivatives by the letter `respect`, if words
    name one.
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
        # \dot s of s(\theta) is by the chain rule.
        running = by.get(name_symbol(split_letter(letter)[0]), "t")
        if running != "t" and name_symbol(running) in entries:
            entries[name_symbol(running)].running = "t"
    extremes = (letter for letter in met if _EXTREME.search(letter))
    return entries | {name_symbol(letter): DraftedLetter({letter: None}) for letter in extremes}


def _find_functions(
    letters: Sequence[str], shapes: Mapping[str, tuple[int, int]], prints: Sequence[str]
) -> dict[str, str]:
    """Return the matrices with arguments, and their first print; without any they have one size."""
    found: dict[str, str] = {}
    for letter in letters:
        stem = strip_arguments(letter)
        alone = re.compile(rf"{re.escape(stem)}(?![\w{{]|\s*(?:\\left\s*)?\()")
        size, plain = (shapes.get(name_symbol(one)) for one in (letter, stem))
        if stem != letter and size and (size == plain or not any(map(alone.search, prints))):
            found.setdefault(name_symbol(stem), letter)
    return found


def list_functions(source: Source) -> dict[str, str]:
    r"""Return what words say that letters are functions of, $s(\varphi)$, if it is but one."""
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
    """Return the letter with respect to which words differentiate, if it is but one.

    They tell what primes are, or a prime is printed next: primes may also be of other coordinates.
    So do words by which what is printed with a prime is a function of it, and the chain rule.
    """
    primed = {name_symbol(split_letter(x)[0].rstrip("'")) for x in letters if "'" in x}
    said = []
    for match in _RESPECT.finditer(source.text.string):
        offset = source.text.offsets[match.start()]
        behind = (one.latex.string for one in displays if one.latex.offsets[0] > offset)
        if match["noun"] or "'" in next(behind, ""):
            said.append(match["by"])
    said += [by for name, by in functions.items() if name in primed]
    said += [by for one in displays for by in _CHAINED.findall(one.latex.string)]
    found = {name_symbol(one): one for one in said}
    return next(iter(found.values())) if len(found) == 1 else ""


def is_motion(letter: str, shapes: Mapping[str, tuple[int, int]]) -> bool:
    """Return whether a number x(t) has the name of a matrix x."""
    is_matrix = name_symbol(letter) in shapes or is_vector(letter) or not _DEPENDS.match(letter)
    return not is_matrix and name_symbol(strip_arguments(letter)) in shapes


def strip_arguments(letter: str) -> str:
    """Return a letter without what stands in a bracket behind it."""
    return _ARGUMENTS.sub("", letter).strip()


def split_letter(letter: str) -> tuple[str, str]:
    r"""Return a letter and what it is a function of: x and t of \dot x and of x(t)."""
    if rate := _RATE.match(letter):
        letter = rate[1] + rate[2] + rate[3]
        depends = _DEPENDS.match(letter)
        return (depends[1].strip() if depends and depends[2] == "t" else letter), "t"
    if depends := _DEPENDS.match(letter):
        return depends[1].strip(), depends[2]
    return letter, ""
