r"""Displays of packages and of old TeX -> those of amsmath: empheq, numcases, \eqalign, \over.

The replacement of a command or an environment is located where that was.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial

from mechproof.latex.latex_signs import find_brace
from mechproof.latex.words import ITALICS, OPENS_TEXT, OPENS_WORDS
from mechproof.sources.located_text import LocatedText, join
from mechproof.sources.macros import Macro

_GROUP = r"\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}"
# Environments around a display, or in its place.
FRAMES = ("empheq", "numcases", "subnumcases", "subeqnarray", "xalignat", "xxalignat")
_FRAME = re.compile(
    rf"\\begin\{{empheq\}}\s*(?:\[(?P<options>(?:[^\[\]{{}}]|{_GROUP})*)\])?\s*"
    r"\{(?P<kind>[a-z]+\*?)(?:=(?P<columns>\d+))?\}"
    rf"|\\begin\{{(?P<sub>sub)?numcases\}}\s*(?P<before>{_GROUP})"
    r"|\\begin\{(?P<other>subeqnarray|xx?alignat\*?)\}|\\end\{(?P<end>empheq|(?:sub)?numcases"
    r"|subeqnarray|xx?alignat\*?)\}"
)
_OTHERS = {
    "subeqnarray": (r"\begin{subequations}\begin{eqnarray}", r"\end{eqnarray}\end{subequations}")
}
_LEFT = re.compile(rf"(?:\A|,)\s*left\s*=\s*(?P<left>{_GROUP}|(?:\\.|[^,\\])*)")
# A brace that only holds equations together.
_BRACE = re.compile(r"\\empheq(?:big)?l?brace|\\[,;:!]|[{}\s]|\\displaystyle|\\left\\\{|\\right\.")
_FUNCTION_BRACE = re.compile(r"\\empheq(?:big)?lbrace")
_ROW_END = re.compile(r"\\\\")
_UNNUMBERED = re.compile(r"\\(?:nonumber|notag)(?![A-Za-z])")
ONE = (None,)
# Macros of packages and old TeX that matter for separating or numbering equations.
BUILT_IN: Mapping[str, Macro] = {
    r"\qq": Macro(r"\quad\text{#1}\quad ", ONE, has_star=True),
    r"\qc": Macro(r",\quad ", has_star=True),
    **{
        rf"\q{word}": Macro(rf"\quad\text{{{word}}}\quad ", has_star=True)
        for word in ("and", "or", "if", "for", "where")
    },
    **dict.fromkeys((r"\boxed", r"\Aboxed"), Macro("#1", ONE)),
    r"\vv": Macro(r"\vec{#1}", ONE),
    r"\textcolor": Macro("#3", ("", None, None)),
    r"\lefteqn": Macro("#1", ONE),
    r"\MoveEqLeft": Macro("", ("",)),
    r"\eqalign": Macro(r"\begin{aligned}#1\end{aligned}", ONE),
    **{
        rf"\{kind}": Macro(rf"\begin{{{kind}}}#1\end{{{kind}}}", ONE)
        for kind in ("matrix", "pmatrix")
    },
    r"\cases": Macro(r"\begin{cases*}#1\end{cases*}", ONE),
    **dict.fromkeys((r"\qedhere", r"\qed", r"\xspace", r"\allowbreak"), Macro("")),
}
_LENGTH = r"-?(?:\d+\.?\d*|\.\d+)\s*(?:pt|e[mx]|[cm]m|mu|in|pc|bp)"
_ROUND = r"(?:[^()]|\((?:[^()]|\([^()]*\))*\))*"
_BOX = rf"f?colorbox(?:\s*{_GROUP})?\s*{_GROUP}|f(?:rame)?box"
# Spellings that print like another one, which replaces them; a line break in front is kept.
_ALIKE = tuple(
    (re.compile(rf"(?P<kept>\\\\)|{pattern}"), written)
    for pattern, written in (
        (r"\\cr(?![A-Za-z])", r"\\\\ "),
        # An equation number in old TeX.
        (r"\\l?eqno(?![A-Za-z])\s*\{?\s*\(?(?P<tag>[\w.*'-]+)\)?\s*\}?", r"\\tag{\g<tag>}"),
        (rf"\\(?:[mh]?kern|[mh]skip)\s*{_LENGTH}|\\[mhv]space\*?\s*\{{\s*-[^{{}}]*\}}", " "),
        (r"\\(?:mspace|vspace\*?)\s*\{[^{}]*\}", " "),
        (r"\\hspace\*?\s*\{[^{}]*\}|\\hfill?(?![A-Za-z])", r"\\quad "),
        (r"\\(?:hbox|textnormal)(?=\s*\{)", r"\\text"),
        (r"\\textsubscript\s*\{\$?(?P<below>[^{}$]*)\$?\}", r"_{\g<below>}"),
        # A word in italics between wide gaps is no product.
        (
            rf"(?<=quad)\s*(?P<word>{'|'.join(ITALICS)})\s*(?=\\q?quad(?![A-Za-z]))",
            r"\\text{ \g<word> }",
        ),
        (r"\\lbrace(?![A-Za-z])", r"\\{"),
        (r"\\rbrace(?![A-Za-z])", r"\\}"),
        (r"\\begin\{array\}\s*\[[tcb]\]", r"\\begin{array}"),
        # A comma or a point in words.
        (rf"{OPENS_WORDS}[\s~]*(?P<mark>[.,;])[\s~]*\}}", r"\g<mark> "),
        (r"\\text\s*\{\s*d\s*\}", r"\\mathrm{d}"),
        # Matrices of the package physics in brackets: their rows are not those of the display.
        (rf"\\s?mqty\s*\((?P<rows>{_ROUND})\)", r"\\pmqty{\g<rows>}"),
        (r"\\s?mqty\s*\[(?P<rows>[^\[\]]*)\]", r"\\bmqty{\g<rows>}"),
        (r"\\s?mqty\s*\|(?P<rows>[^|]*)\|", r"\\vmqty{\g<rows>}"),
        # A formula among words that has a frame or a coloured background.
        (rf"\\(?:{_BOX})\s*\{{\s*\$(?P<inside>[^$]*)\$\s*\}}", r"{\g<inside>}"),
        # Options that tell siunitx how to print a number.
        (
            r"(?P<name>\\(?:SI|qty|num|si|unit|ang)(?![A-Za-z]))\s*\[[^\[\]]*=[^\[\]]*\](?=\s*\{)",
            r"\g<name>",
        ),
    )
)
_WORDED = re.compile(r"\\begin\{d?cases\*\}.*?\\end\{d?cases\*\}", re.DOTALL)
_CONDITION = re.compile(r"&((?:(?!\\\\|&|\\end\b).)*)", re.DOTALL)
# Words with a formula among them.
_MIXED_WORDS = re.compile(rf"{OPENS_TEXT}(?P<words>[^{{}}$]*\$(?:[^{{}}]|\{{[^{{}}]*\}})*)\}}")
_OVER = re.compile(r"\\over(?![A-Za-z])\s?")
_BRACED = re.compile(r"\\(?:under|over)(?:brace|bracket)\s*(?=\{)")
_SAID = re.compile(r"\s*[_^]\s*(?P<label>\{)\s*(?::?=:?|\\equiv|\\triangleq|\\coloneqq)")
# Labels that state no equation: words may say more, and a number may be the value in one case.
_OPEN = re.compile(r"\s*-?[\d.]+\s*\}|.*\\(?:text|mbox)", re.DOTALL)
_DELIMITER = re.compile(r"\\(?P<side>left|right)(?![A-Za-z])|\\.|[{}]", re.DOTALL)


@dataclass(frozen=True)
class _Frame:
    """The replacements for beginning and end of a display, and whether its rows have numbers."""

    head: str
    tail: str
    has_numbered_rows: bool = False


def write_frames(text: LocatedText) -> LocatedText:
    """Return a text with packages' environments around displays replaced by those of amsmath."""
    opened: list[tuple[_Frame, int]] = []

    def write(match: re.Match[str]) -> str | None:
        if not match["end"]:
            opened.append((_write_frame(match), match.end()))
            return opened[-1][0].head
        if not opened:
            return None
        frame, start = opened.pop()
        more = _count_rows(text.string[start : match.start()]) - 1
        step = rf"\addtocounter{{equation}}{{{more}}}" if frame.has_numbered_rows else ""
        return frame.tail + step

    return text.replace(_FRAME, write)


def _write_frame(match: re.Match[str]) -> _Frame:
    if other := match["other"]:
        return _Frame(*_OTHERS.get(other, (r"\begin{alignat}", r"\end{alignat}")))
    if before := match["before"]:
        return _hold_values(before[1:-1], "cases*", has_numbered_rows=not match["sub"])
    kind = match["kind"]
    found = _LEFT.search(match["options"] or "")
    if found and _BRACE.sub("", found["left"]):
        before = _FUNCTION_BRACE.sub("", found["left"])
        return _hold_values(before, "cases", has_numbered_rows=kind in ("align", "gather"))
    columns = f"{{{match['columns']}}}" if match["columns"] else ""
    return _Frame(rf"\begin{{{kind}}}{columns}", rf"\end{{{kind}}}")


def _hold_values(before: str, kind: str, *, has_numbered_rows: bool) -> _Frame:
    """Return the frame of a function whose values are printed after a brace."""
    head = rf"\begin{{equation}}{before}\begin{{{kind}}}"
    return _Frame(head, rf"\end{{{kind}}}\end{{equation}}", has_numbered_rows)


def _count_rows(body: str) -> int:
    rows = _ROW_END.split(body)
    return sum(bool(row.strip()) and not _UNNUMBERED.search(row) for row in rows)


def write_plainly(body: LocatedText) -> LocatedText:
    """Return a display in the commands of amsmath."""
    for pattern, written in _ALIKE:
        body = body.replace(pattern, partial(_write, written))
    body = body.replace(_MIXED_WORDS, lambda found: _part_words(found["words"]))
    return _write_fractions(_write_conditions(body))


def list_braced(latex: LocatedText) -> Iterator[LocatedText]:
    r"""Yield the labels of braces that state equations, \underbrace{a}_{=b}, as b=a."""
    string = latex.string
    for match in _BRACED.finditer(string):
        end = find_brace(string, match.end())
        said = _SAID.match(string, end + 1) if end is not None else None
        close = find_brace(string, said.start("label")) if said else None
        if said and close and not _OPEN.match(string, said.end(), close + 1):
            above = latex[match.end() + 1 : end]
            yield join([latex[said.end() : close], latex.put("=", said.start()), above])


def _write(written: str, match: re.Match[str]) -> str:
    return match["kept"] or match.expand(written)


def _write_conditions(body: LocatedText) -> LocatedText:
    r"""Write the second column of cases, words with formulas, as formulas with \text."""

    def write(cases: re.Match[str]) -> LocatedText:
        inside = body[cases.start() : cases.end()]
        return inside.replace(_CONDITION, lambda found: f"&{_part_words(found[1])}")

    return body.replace(_WORDED, write)


def _part_words(text: str) -> str:
    r"""Return words with formulas between dollars as formulas with \text."""
    pieces = text.split("$")
    words = (rf"\text{{{piece}}}" if piece.strip(" ,.;~\n") else piece for piece in pieces[::2])
    formulas = [*pieces[1::2], ""]
    return " ".join(f"{w} {f}" for w, f in zip(words, formulas, strict=False))


def _write_fractions(text: LocatedText) -> LocatedText:
    r"""Write {a\over b} as {\frac{a}{b}}; \over without braces around it is left unchanged."""
    for match in reversed(list(_OVER.finditer(text.string))):
        start = _find_group(text.string[: match.start()])
        end = None if start is None else find_brace(text.string, start)
        if start is not None and end is not None:
            above, below = text[start + 1 : match.start()], text[match.end() : end]
            opening, closing = text.put(r"\frac{", start), text.put("}", end)
            middle = text.put("}{", match.start())
            written = [opening, above, middle, below, closing]
            text = join([text[: start + 1], *written, text[end:]])
    return text


def _find_group(string: str) -> int | None:
    r"""Return the beginning of the group that a text leaves open, None if \left began it."""
    opened: list[int | None] = []
    for match in _DELIMITER.finditer(string):
        if match["side"] == "left" or match[0] == "{":
            opened.append(match.start() if match[0] == "{" else None)
        elif opened and (match["side"] == "right" or match[0] == "}"):
            opened.pop()
    return opened[-1] if opened else None
