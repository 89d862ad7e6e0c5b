r"""Macros that \newcommand, \def and others define, expanded at their calls."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mechproof.latex.latex_signs import find_brace, join as join_signs
from mechproof.sources.located_text import LocatedText, join
from mechproof.sources.paper_files import DocumentError

# Work limit: calls expanded in one display; more mean that macros call each other in a circle.
MOST_CALLS = 10_000
_COMMAND = re.compile(r"\\(?:begin|end)\{[A-Za-z@]+\*?\}|\\[A-Za-z@]+")
_NAME = r"\s*\{?\s*(\\[A-Za-z@]+)\s*\}?"
_DEFINING = re.compile(
    rf"\\(?:(?:(?:re)?new|provide)command\*?|DeclareRobustCommand\*?|DeclareSIUnit(?:\s*\[[^]]*\])?){_NAME}"
    rf"|\\(?:New|Renew|Provide|Declare)DocumentCommand{_NAME}"
    rf"|\\DeclarePairedDelimiter{_NAME}|\\DeclareMathOperator(\*?){_NAME}"
    r"|\\(?:re)?newenvironment\*?\s*\{([A-Za-z@]+\*?)\}"
    r"|\\def\s*(\\[A-Za-z@]+)((?:#\d)*)(\\[A-Za-z@]+)?|\\let\s*(\\[A-Za-z@]+)\s*=?\s*(\\[A-Za-z@]+)"
)
_COUNT = re.compile(r"\s*\[(\d)\]")
# The argument list of \NewDocumentCommand with arguments in brackets or braces, and one of them.
_SPECIFIED = re.compile(r"\s*\{(?:\s*(?:m|o|O\s*\{[^{}]*\}))*\s*\}")
_ARGUMENT = re.compile(r"(m|o|O)\s*(?:\{([^{}]*)\})?")
# A test in a body for whether a call has an argument.
_ASKING = re.compile(r"\\If(?P<not>No)?Value(?P<ways>TF|T|F)\s*\{\s*#(?P<number>\d)\s*\}")
_OPTION = re.compile(r"\s*\[([^\[\]]*)\]")
_PARAMETER = re.compile(r"#(\d)")


@dataclass(frozen=True)
class Macro:
    """A body with parameters #1, #2 ..., and for each the default value, None if it is required.

    If it `has_star`, a call may have a star, which changes nothing but sizes.
    """

    body: str
    arguments: tuple[str | None, ...] = ()
    has_star: bool = False


@dataclass(frozen=True)
class Defined:
    """A macro, its name, and the place of the text from which it is known."""

    name: str
    macro: Macro
    place: int


def find_macros(text: LocatedText) -> tuple[list[Defined], LocatedText]:
    """Return the macros that a text defines, in order, and the text without their definitions."""
    macros: list[Defined] = []
    parts, last, string = [], 0, text.string
    for match in _DEFINING.finditer(string):
        if match.start() < last:
            continue
        found, end = _read_definition(string, match)
        # How equation numbers are formatted is read where equations are counted.
        if found and r"\theequation" not in found:
            parts.append(text[last : match.start()])
            place = sum(map(len, parts))
            macros += [Defined(name, macro, place) for name, macro in found.items()]
            last = end
    return macros, join([*parts, text[last:]])


def _read_definition(string: str, match: re.Match[str]) -> tuple[dict[str, Macro], int]:
    """Return the macros that are defined at a place, and the end of the definition."""
    new, specified, paired, starred, operator, environment = match.groups()[:6]
    defined, parameters, delimiter, let, other = match.groups()[6:]
    if let:
        return {let: Macro(other)}, match.end()
    arguments: tuple[str | None, ...] = (None,) * (parameters or "").count("#")
    place = match.end()
    if (new or environment) and (found := _COUNT.match(string, place)):
        arguments, place = (None,) * int(found[1]), found.end()
        if found := _OPTION.match(string, place):
            arguments, place = (found[1], *arguments[1:]), found.end()
    if specified:
        if not (found := _SPECIFIED.match(string, place)):
            return {}, place
        kinds = _ARGUMENT.findall(found[0])
        arguments = tuple(None if kind == "m" else default for kind, default in kinds)
        place = found.end()
    argument = _read_argument(string, place)
    name = new or specified or paired or operator or environment or defined
    if argument is None or string[place:].lstrip()[:1] != "{":
        return {}, match.end()
    body, end = argument
    if operator:
        body = rf"\operatorname{starred}{{{body}}}"
    if delimiter:
        # The macro wraps the text between two commands: \def\be#1\ee{…#1…}.
        before, _, after = body.partition("#1")
        is_pair = parameters == "#1" and after and "#" not in before + after
        return {name: Macro(before), delimiter: Macro(after)} if is_pair else {}, end
    closing = _read_argument(string, end) if paired or environment else None
    if environment:
        begin, finish = rf"\begin{{{name}}}", rf"\end{{{name}}}"
        if closing is None or begin in body:
            return {}, end
        return {begin: Macro(body, arguments), finish: Macro(closing[0])}, closing[1]
    if closing:
        macro = Macro(rf"\left{body}#2\right{closing[0]}", ("", None), has_star=True)
        return {name: macro}, closing[1]
    return {name: Macro(body, arguments)}, end


def expand(text: LocatedText, macros: Mapping[str, Macro]) -> LocatedText:
    """Replace calls of macros by their bodies.

    A body is located where its call is. Raises `DocumentError` for macros that call each other in a
    circle and for calls without their arguments.
    """
    done: list[LocatedText] = []
    for _ in range(MOST_CALLS):
        found = next((m for m in _COMMAND.finditer(text.string) if m[0] in macros), None)
        if found is None:
            return join([*done, text])
        body, end = _call(text.string, found, macros[found[0]])
        done.append(text[: found.start()])
        text = text.put(body, found.start()) + text[end:]
    raise DocumentError(f"{found[0] if found else ''}: macros that call each other endlessly")


def _call(string: str, found: re.Match[str], macro: Macro) -> tuple[str, int]:
    """Return the expansion of a call, and the end of the call."""
    given, end = [], found.end()
    end += macro.has_star and string.startswith("*", end)
    for default in macro.arguments:
        if default is not None:
            option = _OPTION.match(string, end)
            given.append(option[1] if option else default)
            end = option.end() if option else end
            continue
        argument = _read_argument(string, end)
        if argument is None:
            raise DocumentError(f"{found[0]} needs {len(macro.arguments)} arguments")
        given.append(argument[0])
        end = argument[1]
    parts = _PARAMETER.split(_choose(macro.body, given))
    parts[1::2] = [(given[int(n) - 1 :] or [f"#{n}"])[0] for n in parts[1::2]]
    # A space is needed where a command's name would run into the next letter.
    after = string[end : end + 1]
    return join_signs([*parts, after]).removesuffix(after), end


def _choose(body: str, given: Sequence[str]) -> str:
    r"""Return a body with its tests for given arguments decided: \IfValueT{#1}{^{#1}}."""
    while found := _ASKING.search(body):
        ways, end = dict[str, str](), found.end()
        for way in found["ways"]:
            ways[way], end = _read_argument(body, end) or ("", len(body))
        has_value = any(given[int(found["number"]) - 1 :][:1]) != bool(found["not"])
        chosen = ways.get("T" if has_value else "F", "")
        body = join_signs([body[: found.start()], chosen, body[end:]])
    return body


def _read_argument(string: str, place: int) -> tuple[str, int] | None:
    """Return the content of braces, or the next sign, and its end; None if the text ends."""
    start = len(string) - len(string[place:].lstrip())
    if start >= len(string):
        return None
    if string[start] != "{":
        command = _COMMAND.match(string, start)
        end = command.end() if command else start + 1
        return string[start:end], end
    close = find_brace(string, start)
    return None if close is None else (string[start + 1 : close], close + 1)
