"""Files of a paper -> one text: LaTeX with its inputs, or Markdown, without comments.

The block of letters is in comments (`%% mechproof` to `%% end`; in Markdown between
`<!-- mechproof` and `-->`), or in a file next to the paper with the same name, `.letters`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from mechproof.sources.located_text import Files, LocatedText, Place, join

STDIN = "-"
BESIDE = ".letters"
MARKDOWN = (".md", ".markdown", ".mmd")
# Endings of the names of papers' files.
SUFFIXES = (".tex", ".ltx", ".txt", *MARKDOWN)
_DEEPEST = 20
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%[^\n]*")
# Environments that state no equations: listings, drawings, and algorithms, where n=n+1 assigns.
_VERBATIM = re.compile(
    r"\\begin\{(verbatim\*?|[BLV]?Verbatim|lstlisting|comment|minted|filecontents\*?|tikzpicture"
    r"|algorithm(?:ic|2e)?\*?|thebibliography)\}.*?\\end\{\1\}",
    re.DOTALL,
)
# \if..., \else and \fi of TeX, and the declaration of a switch by which an author decides.
_BRANCH = re.compile(r"\\(?:(?!iff\b|ifthenelse)if[a-zA-Z]*|else|fi)(?![a-zA-Z])")
_DECIDED = re.compile(r"\\newif\s*\\if([a-zA-Z]+)")
_VERB = re.compile(
    r"\\(?:verb\*?|(?:lst|mint)inline(?:\[[^\[\]]*\])?(?:\{[a-z]+\})?)([^A-Za-z*\s{\[]).*?\1"
)
_END = re.compile(r"\\end\{document\}|\\endinput(?![A-Za-z])")
_FENCE = re.compile(r"^(```|~~~).*?^\1\s*$|<!--.*?-->", re.DOTALL | re.MULTILINE)
# A fenced formula is a display.
_MATH = re.compile(r"^```math\s*$(?P<body>.*?)^```\s*$", re.DOTALL | re.MULTILINE)
# So is a directive, whose option lines may contain a label; comments are matched to skip them.
_DIRECTIVE = re.compile(
    r"<!--.*?-->|^[ \t]*(?P<fence>`{3,}|:{3,})\{math\}[ \t]*$"
    r"(?P<options>(?:\n[ \t]*:[a-z-]+:[^\n]*)*)(?P<body>.*?)^[ \t]*(?P=fence)[ \t]*$",
    re.DOTALL | re.MULTILINE,
)
_LABELLED = re.compile(r":label:[ \t]*(\S+)")
_REFERENCE = re.compile(r"\{eq\}`([^`<>]+)`")
# A formula on a line of its own is a display.
_ALONE = re.compile(r"^\s*\$(?!\$)(?P<body>[^$\n]+)\$\s*$", re.MULTILINE)
# A backslash that keeps Markdown from reading emphasis.
_ESCAPED = re.compile(r"\\(_)")
_INPUT = re.compile(r"\\(?:input|include|subfile)\s*\{([^{}]*)\}")
# How a block of letters begins, what its lines begin with, and how it ends.
LATEX_BLOCK = "%% mechproof", "%% ", "%% end"
MARKDOWN_BLOCK = "<!-- mechproof", "", "-->"
_BLOCK = re.compile(r"^%%\s*mechproof\s*$(.*?)^%%\s*end\s*$", re.DOTALL | re.MULTILINE)
_OPENED = re.compile(r"^%%\s*mechproof\s*$|^<!--\s*mechproof\s*$", re.MULTILINE)
_HIDDEN = re.compile(r"^<!--\s*mechproof\s*$(.*?)^-->\s*$", re.DOTALL | re.MULTILINE)
_LINE = re.compile(r"[^\n]+")
_MARK = re.compile(r"%+\s?")


class DocumentError(ValueError):
    """A file of a paper, or its block of letters, cannot be read."""


@dataclass
class Source:
    """The text of a paper, the lines of its blocks of letters, and the inputs that were not read.

    Piped text has no `folder`.
    """

    files: Files
    text: LocatedText
    folder: Path | None = None
    lines: list[LocatedText] = field(default_factory=list)
    has_block: bool = False
    missing: list[tuple[Place, str]] = field(default_factory=list)

    @cached_property
    def places(self) -> dict[int, int]:
        """Return the places in the text by their offsets in the files."""
        return {offset: place for place, offset in enumerate(self.text.offsets)}


def read_source(path: str, content: str | None = None) -> Source:
    """Read a paper; `content` is its text if it comes from elsewhere, from stdin or a test.

    Raises `DocumentError` for a file that cannot be read and for a block without an end.
    """
    folder = Path(path).resolve().parent if content is None else None
    source = Source(Files(), LocatedText("", ()), folder)
    source.text = _read(path, _open(Path(path)) if content is None else content, source, ())
    beside = Path(path).with_suffix(BESIDE) if content is None else None
    if beside and beside.is_file():
        source.has_block = True
        _take_lines(source.files.add(str(beside), _open(beside)), source)
    return source


def is_file(name: str) -> bool:
    """Return whether there is a file; an equation may be no valid name at all."""
    try:
        return Path(name).is_file()
    except (OSError, ValueError):
        return False


def is_markdown_name(name: str) -> bool:
    """Return whether a file is Markdown, by its name."""
    return Path(name).suffix in MARKDOWN


def _open(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        told = "a character that is not UTF-8. Save the file as UTF-8."
        raise DocumentError(f"{path}:{line}: {told}") from error
    except OSError as error:
        raise DocumentError(f"{path}: {error.strerror}") from error


def _read(name: str, content: str, source: Source, above: tuple[str, ...]) -> LocatedText:
    """Return the text of a file without comments, with the files that it inputs inserted."""
    text = source.files.add(name, content)
    is_markdown = is_markdown_name(name)
    patterns = (_HIDDEN, _BLOCK) if is_markdown else (_BLOCK,)
    found = (match for pattern in patterns for match in pattern.finditer(content))
    blocks = sorted(found, key=lambda match: match.start())
    if len(blocks) < len(_OPENED.findall(content)):
        *_, end = MARKDOWN_BLOCK if is_markdown else LATEX_BLOCK
        raise DocumentError(f"{name}: its block of letters has no end: add a line {end}")
    for match in blocks:
        source.has_block = True
        _take_lines(text[match.start(1) : match.end(1)], source)
    if is_markdown:
        shown = _show(text.replace(_BLOCK, lambda match: "\n"), _DIRECTIVE)
        shown = shown.replace(_REFERENCE, lambda match: rf"\eqref{{{match[1]}}}")
        shown = _show(shown, _MATH)
        shown = shown.replace(_FENCE, lambda match: "\n")
        return _show(shown.replace(_ESCAPED, lambda match: match[1]), _ALONE)
    plain = text.replace(_VERBATIM, lambda match: "\n").replace(_COMMENT, lambda match: match[1])
    plain = _drop_false(plain.replace(_VERB, lambda match: " "))
    if last := _END.search(plain.string):
        plain = plain[: last.start()]
    return _insert(plain, source, (*above, name))


def _drop_false(text: LocatedText) -> LocatedText:
    r"""Leave out the branches that are not printed: of \iffalse, and of an \ifdraft of the paper.

    Such a switch is false until \drafttrue sets it.
    """
    decided = _DECIDED.findall(text.string)
    text = text.replace(_DECIDED, lambda _: " ")
    known = {r"\iffalse": False, r"\iftrue": True}
    for name in decided:
        ways = re.findall(rf"\\{name}(true|false)(?![A-Za-z])", text.string)
        known[rf"\if{name}"] = ways[-1:] == ["true"]
    parts, last = [], 0
    # For each open branch, whether it is printed; None if that is not known.
    opened: list[bool | None] = []
    for match in _BRANCH.finditer(text.string):
        if False not in opened:
            parts.append(text[last : match.start()])
            last = match.start()
        if match[0] == r"\else" and opened:
            opened[-1] = None if opened[-1] is None else not opened[-1]
        elif match[0] == r"\fi" and opened:
            opened.pop()
        elif match[0] not in (r"\else", r"\fi"):
            opened.append(known.get(match[0]))
        last = match.end()
    return text if False in opened else join([*parts, text[last:]])


def _show(text: LocatedText, pattern: re.Pattern[str]) -> LocatedText:
    """Turn the body of each match of a pattern into a display between dollars, with its label."""

    def show(match: re.Match[str]) -> LocatedText | None:
        found = match.groupdict()
        if found["body"] is None:
            return None
        label = _LABELLED.search(found.get("options") or "")
        head = f"$$\\label{{{label[1]}}}" if label else "$$"
        body = text[match.start("body") : match.end("body")]
        return join([text.put(head, match.start()), body, text.put("$$", match.end("body") - 1)])

    return text.replace(pattern, show)


def _take_lines(block: LocatedText, source: Source) -> None:
    for match in _LINE.finditer(block.string):
        mark = _MARK.match(match[0].lstrip())
        line = block[match.start() : match.end()].strip()
        line = line[mark.end() :].strip() if mark else line
        is_edge = line.string in ("mechproof", "end", *MARKDOWN_BLOCK)
        if len(line) and not (is_edge or line.string.startswith("#")):
            source.lines.append(line)


def _insert(text: LocatedText, source: Source, above: tuple[str, ...]) -> LocatedText:
    def insert(match: re.Match[str]) -> str | LocatedText:
        place = source.files.locate(text.offsets[match.start()])
        file = _find(match[1], above, place, source)
        return _read(str(file), _open(file), source, above) if file else ""

    return text.replace(_INPUT, insert)


def _find(name: str, above: tuple[str, ...], place: Place, source: Source) -> Path | None:
    """Return the file that is input; record it as missing if the paper's folder lacks it."""
    if (folder := source.folder) is None:
        source.missing.append((place, f"{name} is not read: piped input has no folder"))
        return None
    for file in (folder / name, folder / f"{name}.tex"):
        if not file.resolve().is_relative_to(folder):
            source.missing.append((place, f"{name} is not read: it is outside {folder}"))
            return None
        if file.is_file():
            if len(above) > _DEEPEST:
                raise DocumentError(f"{place}: files input each other, {_DEEPEST} levels deep")
            return file
    source.missing.append((place, f"{name} is not read: there is no such file"))
    return None
