r"""Letters printed as matrices usually are: [R], R^T, \det R, (I-R)^{-1} next to a factor.

Letters that are printed or described as unit matrices are found, too.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from mechproof.latex.printed_commands import ACCENTS
from mechproof.nomenclature.block import Block
from mechproof.nomenclature.shown_letters import name_symbol

# Letters that usually are unit matrices, I, \mathbf{1}, I_3, E; and a bold 1, which always is.
UNIT_MATRIX = re.compile(
    r"(?:\\(?:mathbf|mathbb|mathrm|bm|boldsymbol)\s*\{?\s*)?[IE1]\s*\}?(?:_\{?\s*\d[^{}]*\}?)?"
)
_BOLD_ONE = re.compile(r"\\(?:mathbf|bm|boldsymbol)\s*\{?\s*1\s*\}?(?:_\{?\s*\d+\s*\}?)?")
_BREAK = r"\\"
_SAID_UNIT = re.compile(r"\b(?:unit|identity) matrix\b|\bEinheitsmatrix\b", re.IGNORECASE)
_ACCENT = "|".join(accent[1:] for accent in ACCENTS)
_INDEX = r"(?:_(?:\w|\\[A-Za-z]+|\{[^{}]*\}))?"
_LETTER = (
    rf"(?P<letter>(?:\\(?:{_ACCENT})\s*(?:\{{[^{{}}]*\}}|[A-Za-z])|\\[A-Za-z]+|[A-Za-z]){_INDEX})"
)
_CAPITAL = rf"[A-Z]{_INDEX}"
_TERM = rf"(?:1|{_CAPITAL}(?:\s*{_CAPITAL})*)"
_LEFT, _RIGHT = r"(?:\\left\s*)?", r"(?:\s*\\right)?"
# Optional arguments in square brackets: of a line break, a root, an arrow, an environment.
_OPTION = re.compile(
    r"\\\\\s*\[[^\]]*\]|\\(?:sqrt|smash|x[a-z]+arrow|begin\{[^{}]*\})\s*\[[^\]]*\]"
)
# With limits after it, the bracket is the value of an integral between them.
_BRACKETED = rf"\[\s*{_LETTER}{_RIGHT}\s*\](?!\s*_)"
_SURE_T = (
    r"\{?\s*\\(?:(?:top|intercal)(?![A-Za-z])|(?:math|text)?(?:rm|sf)\s*\{?\s*T|text\s*\{\s*T)"
)
_PLAIN_T = r"(?:T|\{\s*T\s*\})"
_DOUBLE = r"\\(?:overline|bar)\s*\{\s*\\(?:overline|bar)\s*(?:\{[^{}]*\}|[A-Za-z])\s*\}"
_GROUP = (
    r"S[OE]\s*\([^()]*\)|\\(?:mathrm|text|operatorname)\s*\{\s*S[OE]\s*\}|"
    r"\\mathbb\s*\{?\s*[RC]\s*\}?\s*\^"
)
# Letters before it in a word; letters of a command do not count.
_WITHIN = r"(?<![A-Za-z\\])[A-Za-z]*?"
_SIGNS = (
    rf"(?P<shown>{_BRACKETED})",
    rf"{_WITHIN}(?P<shown>{_LETTER}\s*\^\s*(?:{_SURE_T}))",
    rf"{_WITHIN}(?P<shown>(?P<letter>{_CAPITAL})\s*\^\s*{_PLAIN_T})",
    rf"{_WITHIN}(?P<shown>{_LETTER}\s*\\in\s*(?:{_GROUP}))",
    rf"(?P<shown>(?P<letter>{_DOUBLE}))",
)
_TRANSPOSED = rf"{_WITHIN}(?P<shown>{_LETTER}\s*\^\s*{_PLAIN_T})"
_SANS_SERIF = re.compile(rf"\\mathsf\s*\{{?\s*([A-Z])\s*\}}?({_INDEX})")
# Functions of matrices, with the capital letters in their arguments.
_OF_MATRICES = re.compile(
    r"\\(?:det|(?:operatorname|mathrm|text)\s*\{\s*(?:det|tr|Tr|rank|adj)\s*\})(?![A-Za-z])\s*"
    rf"(?:{_LEFT}[(\[]([^()\[\]]*)[)\]]|({_CAPITAL}))"
)
_SUM = re.compile(
    rf"{_LEFT}[(\[](\s*{_TERM}(?:\s*[-+]\s*{_TERM})+){_RIGHT}\s*[)\]]\s*\^\s*\{{\s*-\s*1\s*\}}"
)
# An exponential that is equated to a unit matrix, or to one plus more terms: the accented letters
# and capitals in its exponent may be matrices.
_EXPONENTIAL = re.compile(
    r"(?:e|\\mathrm\s*\{?\s*e\s*\}?)\s*\^\s*\{(?P<raised>(?:[^{}]|\{[^{}]*\})*)\}"
    rf"|\\exp\s*{_LEFT}[(\[](?P<called>[^()\[\]]*?){_RIGHT}\s*[)\]]"
)
_BESIDE_UNIT = re.compile(
    r"\s*&?\s*=\s*&?\s*(?:[IE]|\\mathrm\s*\{\s*[IE]\s*\})(?:_\w|_\{\w*\})?\s*(?:[-+]|\Z)"
)
_ACCENTED = re.compile(rf"\\(?:{_ACCENT})\s*(?:\{{[^{{}}]*\}}|\\?[A-Za-z]+){_INDEX}")
_BEFORE, _BEHIND = re.compile(r"[\w)\]}]\s*\Z"), re.compile(r"\s*(?:\\left|[\w(\[])")
_UNIT = re.compile(r"(?<![A-Za-z_{])[IE1](?![A-Za-z_\d])")


def list_units(block: Block) -> Iterator[str]:
    """Yield values for square matrices described as unit matrices, or printed as a bold 1."""
    given = {name_symbol(text.partition("=")[0]) for text in block.values}
    for letter in block.letters:
        name, (rows, columns) = letter.names[0], letter.shape or (0, 0)
        is_unit = _SAID_UNIT.search(letter.meaning) or _BOLD_ONE.fullmatch(name)
        if is_unit and rows == columns > 0 and name_symbol(name) not in given:
            yield f"{name}={write_unit(rows)}"


def write_unit(rows: int) -> str:
    """Return the unit matrix with that many rows, in LaTeX."""
    lines = (["0"] * n + ["1"] + ["0"] * (rows - 1 - n) for n in range(rows))
    return rf"\begin{{pmatrix}}{_BREAK.join(map('&'.join, lines))}\end{{pmatrix}}"


def find_possible_matrices(
    letters: Collection[str], prints: Iterable[str]
) -> Iterator[tuple[str, str]]:
    """Yield the names of letters that are printed as matrices usually are, with such a print."""
    names = {*map(name_symbol, letters)}
    # If T is a letter of the paper, it may be an exponent.
    signs = _SIGNS if "T" in names else (*_SIGNS, _TRANSPOSED)
    patterns = [re.compile(sign) for sign in signs]
    for latex in prints:
        text = _OPTION.sub(" ", latex)
        for name, shown in _find_shown(text, patterns):
            if name in names:
                yield name, shown


def _find_shown(text: str, patterns: Iterable[re.Pattern[str]]) -> Iterator[tuple[str, str]]:
    for pattern in patterns:
        for found in pattern.finditer(text):
            yield name_symbol(found["letter"].strip()), found["shown"].strip()
    for found in _SANS_SERIF.finditer(text):
        yield name_symbol(rf"\mathrm{{{found[1]}}}{found[2]}"), found[0].strip()
    for found in _OF_MATRICES.finditer(text):
        yield from _list_capitals(found[1] or found[2], found[0])
    for found in _EXPONENTIAL.finditer(text):
        if _BESIDE_UNIT.match(text, found.end()):
            exponent = found["raised"] or found["called"] or ""
            accented = _ACCENTED.findall(exponent)
            yield from ((name_symbol(letter), found[0].strip()) for letter in accented)
            yield from () if accented else _list_capitals(exponent, found[0])
    for found in _SUM.finditer(text):
        is_factor = _BEFORE.search(text[: found.start()]) or _BEHIND.match(text, found.end())
        if is_factor and _UNIT.search(found[1]):
            yield from _list_capitals(found[1], found[0])


def _list_capitals(text: str, shown: str) -> Iterator[tuple[str, str]]:
    for letter in re.findall(rf"(?<![A-Za-z\\_{{]){_CAPITAL}", text):
        yield name_symbol(letter), shown.strip()
