r"""Commands of packages that abbreviate plain LaTeX: \dv{x}{t} is \frac{dx}{dt}.

The packages are physics, derivative, diffcoeff, esdiff, commath, mathtools, nicefrac, xfrac and
tensor.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise

from mechproof.latex.latex_signs import (
    CLOSED_BY,
    CLOSING,
    Token,
    join,
    measure_depths,
    split_signs,
)

# Stands for an argument that may be a single sign without braces.
_ANY = "."
# Marks in front of an argument's number in a body: insert it unchanged; in brackets, if given; with
# commas between its lines.
_PLAIN, _IN_BRACKETS, _IN_LINE = "#", "@", "?"
_NUMBERED = re.compile(f"[{_PLAIN}{_IN_BRACKETS}{_IN_LINE}](\\d)")
# How the arguments of a call begin, and what it then stands for; the first that fits is used.
_Forms = tuple[tuple[str, str], ...]


def _derive(sign: str) -> _Forms:
    """Return the forms of a derivative of physics, whose operand may follow the command."""
    return (
        ("[{{", rf"\frac{{{sign}^{{#1}}@2}}{{{sign}#3^{{#1}}}}"),
        ("[.", rf"\frac{{{sign}^{{#1}}}}{{{sign}#2^{{#1}}}}"),
        ("{{", rf"\frac{{{sign}@1}}{{{sign}#2}}"),
        (".", rf"\frac{{{sign}}}{{{sign}#1}}"),
    )


def _name(*names: str) -> Iterator[str]:
    """Yield commands with and without the star, which only changes the shape of the fraction."""
    yield from (rf"\{name}{star}" for name in names for star in ("", "*"))


def _enclose(opening: str, closing: str) -> _Forms:
    return (("[.", f"{opening}#2{closing}"), (".", f"{opening}#1{closing}"))


def _set_out(kind: str) -> _Forms:
    """Return the form of a matrix whose entries are in braces."""
    return (("{", rf"\begin{{{kind}}}#1\end{{{kind}}}"),)


_ENCLOSED = ("pmatrix", "bmatrix", "vmatrix")
_MIXED = ("{{{", r"\frac{\partial^{2}@1}{\partial#2\partial#3}")
_BARS, _NORM = _enclose(r"\left|", r"\right|"), _enclose(r"\left\|", r"\right\|")
_FRACTION: _Forms = (("..", r"\frac{#1}{#2}"),)
_BARE = f"{_PLAIN}1"
_ITSELF: _Forms = ((_ANY, _BARE),)
_COMMANDS: Mapping[str, _Forms] = {
    **dict.fromkeys(_name("dv"), _derive("d")),
    **dict.fromkeys(_name("pdv"), (_MIXED, *_derive(r"\partial"))),
    **dict.fromkeys((r"\dd", r"\odif"), (("[{", "d^{#1}#2"), ("{", "d#1"), ("", "d"))),
    **dict.fromkeys((r"\dif", r"\dl"), (("", "d"),)),
    **dict.fromkeys((r"\abs", r"\abs*", r"\vqty"), _BARS),
    **dict.fromkeys((r"\norm", r"\norm*"), _NORM),
    # With two arguments it is siunitx's command for a number and its unit, and is kept.
    r"\qty": (
        *(("{{", ""), ("{", r"\left\{#1\right\}")),
        *(("(", r"\left(#1\right)"), ("[", r"\left[#1\right]"), ("|", r"\left|#1\right|")),
    ),
    r"\pqty": _enclose(r"\left(", r"\right)"),
    **dict.fromkeys((r"\bqty", r"\Bqty"), _enclose(r"\left[", r"\right]")),
    r"\eval": (("{", r"\left.#1\right|"),),
    **dict.fromkeys(
        (r"\mqty", r"\smqty"),
        tuple(
            (opening, rf"\begin{{{kind}}}#1\end{{{kind}}}")
            for opening, kind in zip("{([|", ("matrix", *_ENCLOSED), strict=True)
        ),
    ),
    **{rf"\{s}{kind[0]}mqty": _set_out(kind) for kind in _ENCLOSED for s in ("", "s")},
    **dict.fromkeys((r"\mdet", r"\smdet"), _set_out("vmatrix")),
    **dict.fromkeys((r"\vb", r"\vb*"), ((".", r"\mathbf{#1}"),)),
    **dict.fromkeys((r"\va", r"\va*"), ((".", r"\vec{#1}"),)),
    **dict.fromkeys((r"\vu", r"\vu*"), ((".", r"\hat{\mathbf{#1}}"),)),
    r"\vdot": (("", r"\cdot"),),
    **dict.fromkeys((r"\cross", r"\cp"), (("", r"\times"),)),
    **dict.fromkeys((r"\nicefrac", r"\sfrac", r"\flatfrac"), _FRACTION),
    r"\prescript": (("...", "{}^{#1}_{#2}#3"),),
    **dict.fromkeys(
        _name("tensor"),
        (("[..", "{}#1#2#3"), ("[..", "{}#1#2"), ("..", "#1#2"), ("..", "#1")),
    ),
    r"\indices": (("{", "#1"),),
    **dict.fromkeys((r"\ensuremath", r"\smash", r"\mathclap"), _ITSELF),
    r"\substack": ((_ANY, f"{_IN_LINE}1"),),
    **{rf"\math{kind}": _ITSELF for kind in ("rel", "bin", "ord", "op", "open", "close", "inner")},
}
# Commands of the packages derivative, diffcoeff, esdiff and commath, with the sign they print:
# their first argument is differentiated, the second gives the variables.
_DERIVATIVES = {
    **dict.fromkeys(_name("odv", "od", "dod", "tod", "diff"), "d"),
    **dict.fromkeys(_name("pdv", "pd", "dpd", "tpd", "diffp"), r"\partial"),
}


def expand_commands(signs: Sequence[Token]) -> list[Token]:
    """Return the signs with commands of packages expanded; calls of unknown form are kept."""
    expanded: list[Token] = []
    place = 0
    while place < len(signs):
        found = next(_find_calls(signs, place), None)
        if found is None or not found[0]:
            expanded.append(signs[place])
            place += 1
            continue
        body, arguments, end = found
        written = _fill(_split(body), [expand_commands(one) for one in arguments])
        start, stop = signs[place].start, signs[end - 1].end
        expanded += (replace(t, start=start, end=stop) if t.end < 0 else t for t in written)
        place = end
    return expanded


def write_out(latex: str) -> str:
    """Return a print with commands of packages written out, for readers that do not know them."""
    signs = split_signs(latex)
    for place, sign in enumerate(signs):
        body, arguments, end = next(_find_calls(signs, place), ("", [], 0))
        if body:
            inside = [latex[x[0].start : x[-1].end] if x else "" for x in arguments]
            parts = _NUMBERED.split(body)
            parts[1::2] = [write_out(inside[int(number) - 1]) for number in parts[1::2]]
            before, after = latex[: sign.start], latex[signs[end - 1].end :]
            return join([before, *parts, write_out(after)])
    return latex


def _find_calls(
    signs: Sequence[Token], place: int
) -> Iterator[tuple[str, list[Sequence[Token]], int]]:
    """Yield each body that a call may stand for, its arguments, and where the call ends."""
    yield from _find_derivatives(signs, place)
    for form, body in _COMMANDS.get(signs[place].text, ()):
        arguments: list[Sequence[Token]] = []
        end = place + 1
        for opening in form:
            argument, end = _read_argument(signs, end, opening)
            if not end:
                break
            arguments.append(argument)
            if not argument and body != _BARE and f"{_PLAIN}{len(arguments)}" in body:
                break
        else:
            yield body, arguments, end


def _find_derivatives(
    signs: Sequence[Token], place: int
) -> Iterator[tuple[str, list[Sequence[Token]], int]]:
    r"""Yield \odv[order=2]{x}{t} and \pdv[2,1]{f}{x,y} as fractions."""
    name = signs[place].text
    if name not in _DERIVATIVES:
        return
    option, start = _read_argument(signs, place + 1, "[")
    of, end = _read_argument(signs, start or place + 1, _ANY)
    by, end = _read_argument(signs, end, _ANY) if end else ((), 0)
    letters = _part(by)
    if not end or (name in _COMMANDS and len(letters) == 1):
        return
    sign, said = _DERIVATIVES[name], "".join(token.text for token in option)
    orders = said.removeprefix("order=").strip("{}").split(",") if said else ["1"] * len(letters)
    if len(orders) != len(letters) or "=" in "".join(orders):
        return
    total = str(sum(map(int, orders))) if all(map(str.isdigit, orders)) else "+".join(orders)
    below = "".join(f"{sign}#{n}{_raise(order)}" for n, order in enumerate(orders, 2))
    yield rf"\frac{{{sign}{_raise(total)}@1}}{{{below}}}", [of, *letters], end


def _raise(order: str) -> str:
    return "" if order == "1" else f"^{{{order}}}"


def _part(signs: Sequence[Token]) -> list[Sequence[Token]]:
    """Return the parts of an argument between its commas."""
    depths = measure_depths(sign.text for sign in signs)
    commas = [n for n, depth in enumerate(depths) if not depth and signs[n].text == ","]
    return [signs[a + 1 : b] for a, b in pairwise([-1, *commas, len(signs)])]


def _read_argument(signs: Sequence[Token], place: int, opening: str) -> tuple[Sequence[Token], int]:
    """Return an argument and where it ends; ((), 0) if none begins with `opening`."""
    first = signs[place].text if place < len(signs) else ""
    if opening == _ANY and first != "{":
        is_sign = first.isalnum() or (first.startswith("\\") and first != r"\\")
        return (signs[place : place + 1], place + 1) if is_sign else ((), 0)
    if first != "{" if opening == _ANY else first != opening:
        return (), 0
    depth = 0
    for end in range(place + 1, len(signs)):
        text = signs[end].text
        if not depth and text == CLOSED_BY.get(first, "|"):
            return signs[place + 1 : end], end + 1
        depth += (text in CLOSED_BY) - (text in CLOSING)
    return (), 0


@cache
def _split(body: str) -> tuple[Token, ...]:
    """Return the signs of a body, marked as having no place in the source."""
    return tuple(replace(sign, start=-1, end=-1) for sign in split_signs(body))


def _fill(body: Sequence[Token], arguments: Sequence[Sequence[Token]]) -> Iterator[Token]:
    signs = iter(body)
    for sign in signs:
        if sign.text not in (_PLAIN, _IN_BRACKETS, _IN_LINE):
            yield sign
            continue
        argument = arguments[int(next(signs).text) - 1]
        if sign.text == _IN_LINE:
            argument = [replace(x, text=",") if x.text == r"\\" else x for x in argument]
        has_brackets = sign.text == _IN_BRACKETS and argument
        yield from (
            [replace(sign, text="("), *argument, replace(sign, text=")")]
            if has_brackets
            else argument
        )
