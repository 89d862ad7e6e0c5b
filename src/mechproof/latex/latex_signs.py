"""LaTeX -> its signs one by one, without blanks and sizes, with one spelling for each sign."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from mechproof.latex.characters import GREEK, spell
from mechproof.latex.words import AND

# The optional spacing after \\, which ends a row.
_LENGTH = r"[\d.]+\s*(?:p[xtc]|e[mx]|[cm]m|in|bp|mu)|[\d.]*\\(?:jot|[a-z]*skip(?:amount)?)"
SPACING = rf"\*?(?:\s*\[\s*-?(?:{_LENGTH})\s*\])?"
_SETTING = re.compile(rf"\\(?:arraycolsep|tabcolsep)\s*=?\s*(?:{_LENGTH})")
_SIGN = re.compile(rf"\\\\{SPACING}|{_SETTING.pattern}|\\[A-Za-z]+\*?|\\.|\\$|\s+|.", re.DOTALL)
_BLANK = (
    *(r"\,", r"\:", r"\>", r"\!", r"\thinspace", r"\medspace", r"\negthinspace", r"\displaystyle"),
    *(r"\textstyle", r"\limits", r"\nolimits", r"\big", r"\Big", r"\bigg"),
    *(r"\Bigg", r"\mathstrut", r"\it", r"\hline"),
    # Characters that join letters and print nothing.
    *"\u200c\u200d",
)
# Blanks that may separate two statements or have no meaning.
WIDE, NARROW = r"\quad", "\\ "
GAPS = {
    **dict.fromkeys((r"\quad", r"\qquad"), WIDE),
    **dict.fromkeys(
        ("\\ ", "\\\n", "\\", "~", r"\;", r"\enspace", r"\thickspace", r"\space"), NARROW
    ),
}
# Old commands that set the type of a whole group -> the new ones that take an argument.
_TYPES = {**{r"\rm": r"\mathrm", r"\bf": r"\mathbf", r"\sf": r"\mathsf"}, r"\cal": r"\mathcal"}
# A command, or the brace of a group, with the command that sets its type.
_COMMAND = re.compile(rf"\\[A-Za-z]+\*?|\{{(?:({'|'.join(map(re.escape, _TYPES))})(?![A-Za-z]))?")
_OPENING = (r"\left", r"\bigl", r"\Bigl", r"\biggl", r"\Biggl")
_CLOSING = (r"\right", r"\bigr", r"\Bigr", r"\biggr", r"\Biggr")
# Bars whose size command says whether they open or close; a plain bar does not.
_BARS = {
    **{(size, "."): r"\left." for size in _OPENING},
    **{(size, bar): r"\lvert" for size in _OPENING for bar in ("|", r"\vert")},
    **{(size, bar): r"\rvert" for size in _CLOSING for bar in ("|", r"\vert")},
}
_SAME = {
    **dict.fromkeys((r"\dfrac", r"\tfrac", r"\cfrac"), r"\frac"),
    **dict.fromkeys((r"\dbinom", r"\tbinom"), r"\binom"),
    **dict.fromkeys((r"\leq", r"\leqslant"), r"\le"),
    **dict.fromkeys((r"\geq", r"\geqslant"), r"\ge"),
    **dict.fromkeys((r"\ldots", r"\cdots", r"\dotsc", r"\hdots"), r"\dots"),
    "*": r"\cdot",
    **dict.fromkeys((r"\Vert", r"\lVert", r"\rVert"), r"\|"),
    **{r"\rightarrow": r"\to", r"\longrightarrow": r"\to", r"\land": AND},
    **{r"\vert": "|", r"\lbrack": "[", r"\rbrack": "]"},
    **{r"\neq": r"\ne", r"\simeq": r"\approx", r"\textbf": r"\mathbf"},
    **dict.fromkeys((r"\boldsymbol", r"\pmb"), r"\bm"),
    # Accents that amsmath puts above other accents.
    **{f"\\{name.title()}": f"\\{name}" for name in ("vec", "hat", "tilde", "bar", "dot", "ddot")},
    **dict.fromkeys((r"\triangleq", r"\coloneqq", r"\doteq", r"\coloneq"), "="),
    r"\lt": "<",
    r"\gt": ">",
    r"\{": "[",
    r"\}": "]",
    # In Markdown a backslash marks a literal bracket.
    r"\(": "(",
    r"\)": ")",
}
# A star above a letter is part of its name, as a prime is.
STAR = "^*"
SUFFIXES = ("'", STAR)
# Double signs: plus-minus and minus-plus.
DOUBLE = re.compile(r"\\(?:pm|mp)(?![A-Za-z])|[±∓]")
# Dot and cross, which mean the same between numbers.
DOTS = (r"\cdot", r"\times")


@dataclass(frozen=True)
class Token:
    """A sign and its place in the source."""

    text: str
    start: int
    end: int


# Signs that open groups, besides environments -> the signs that close them.
CLOSED_BY = {
    **{"(": ")", "[": "]", "{": "}", r"\lvert": r"\rvert"},
    **{r"\lfloor": r"\rfloor", r"\lceil": r"\rceil", r"\langle": r"\rangle"},
}
CLOSING = tuple(CLOSED_BY.values())


def measure_depths(texts: Iterable[str]) -> Iterator[int]:
    """Yield the number of brackets and environments around each sign."""
    depth = 0
    for text in texts:
        depth -= text in CLOSING or text.startswith(r"\end{")
        yield depth
        depth += text in CLOSED_BY or text.startswith(r"\begin{")


def find_close(texts: Sequence[str]) -> int:
    """Return the place of the sign that closes the first one, or the number of texts."""
    return next((n for n, depth in enumerate(measure_depths(texts)) if n and not depth), len(texts))


def find_brace(latex: str, start: int) -> int | None:
    """Return the place of the brace that closes the one at `start`, or None if none does."""
    depth = 0
    for token in re.finditer(r"\\.|[{}]", latex[start:], re.DOTALL):
        depth += {"{": 1, "}": -1}.get(token[0], 0)
        if depth == 0:
            return start + token.start()
    return None


@lru_cache(1024)
def same_sign(sign: str) -> str:
    r"""Return the sign as which a sign is read: \le for \leq and for the character ≤."""
    (first, *others) = spell(sign) if len(sign) == 1 else (sign,)
    return sign if others else _SAME.get(first, first)


def find_command(latex: str, place: int) -> str:
    """Return the command or brace that begins at a place, "" for any other sign."""
    match = _COMMAND.match(latex, place)
    return _TYPES.get(match[1], match[0]) if match else ""


def _find_signs(latex: str) -> Iterator[Token]:
    for match in _SIGN.finditer(latex):
        if _SETTING.fullmatch(match[0]):
            continue
        if match[0].startswith(r"\\"):
            yield Token(r"\\", match.start(), match.start() + 2)
            continue
        if match[0][1:-1] in GREEK and match[0].endswith("*"):
            # No letter has a starred form: the star is a multiplication sign.
            yield Token(match[0][:-1], match.start(), match.end() - 1)
            yield Token("*", match.end() - 1, match.end())
            continue
        for text in spell(match[0]) if len(match[0]) == 1 else (match[0],):
            yield Token(text, match.start(), match.end())


def split_signs(latex: str) -> list[Token]:
    """Return the signs of a print in order, including the gaps that may separate statements."""
    signs: list[Token] = []
    size, place = "", 0
    for sign in _find_signs(latex):
        if sign.text.isspace() or sign.text in _BLANK:
            continue
        if sign.text in (*_OPENING, *_CLOSING):
            size, place = sign.text, sign.start
            continue
        if size in _OPENING and sign.text == "." and _closes_nothing(signs):
            # The bracket continues on another line: \left(a\right.\left.b\right).
            while signs.pop().text in GAPS.values():
                pass
            size = ""
            continue
        if sign.text in _TYPES and signs and signs[-1].text == "{":
            # {\rm kN} is \mathrm{kN}.
            command = replace(signs[-1], text=_TYPES[sign.text])
            signs[-1:] = [command, replace(sign, text="{")]
            continue
        if size in _CLOSING and sign.text == ".":
            sign = replace(sign, text=r"\right.")
        text = _BARS.get((size, sign.text), GAPS.get(sign.text, sign.text))
        if text == "=" and signs and signs[-1].end == sign.start and signs[-1].text in ("<", ">"):
            text = {"<": r"\le", ">": r"\ge"}[signs[-1].text]
            sign = replace(sign, start=signs.pop().start)
        if text == "=" and signs and signs[-1].end == sign.start and signs[-1].text == ":":
            sign = replace(sign, start=signs.pop().start)
        start = place if size and text in CLOSED_BY else sign.start
        signs.append(Token(text, start, sign.end))
        size = ""
    return signs


def _closes_nothing(signs: list[Token]) -> bool:
    texts = [sign.text for sign in signs if sign.text not in GAPS.values()]
    return texts[-1:] == [r"\right."]


def join(texts: Sequence[str] | Iterator[str]) -> str:
    r"""Join pieces of LaTeX, with a blank between a command and a letter, as in \sin x."""
    joined = ""
    for text in texts:
        apart = re.search(r"\\[A-Za-z]+$", joined) and re.match(r"[A-Za-z]", text)
        joined += f" {text}" if apart else text
    return joined


def is_printed_without(texts: Sequence[str], place: int) -> bool:
    r"""Return whether \sin(a+b), before the letter at a place, also stands without that letter."""
    opened = (n for n in range(place) if texts[n] == "(" and n + find_close(texts[n:]) == place - 1)
    wave = texts[next(opened, place) - 1 : place]
    starts = (n for n in range(len(texts)) if texts[n : n + len(wave)] == wave)
    return len(wave) > 1 and any(texts[n + len(wave) :][:1] != [texts[place]] for n in starts)
