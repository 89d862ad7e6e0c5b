r"""LaTeX -> signs in one order: what prints alike becomes the same signs.

Blanks and sizes are dropped; arguments of `\frac`, `_` and `^` are put in braces; other braces are
removed, but what they enclosed is remembered; scripts are ordered: index, primes and stars, power.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise, takewhile

from mechproof.latex import left_scripts, printed_commands
from mechproof.latex.characters import read_script
from mechproof.latex.errors import TOO_DEEP, PrintedText, ReadingError
from mechproof.latex.latex_signs import GAPS, STAR, Token, find_close, same_sign, split_signs
from mechproof.latex.left_scripts import LEFT
from mechproof.latex.package_commands import expand_commands
from mechproof.latex.printed_commands import ACCENTS, DOTTED, TEXT, UPRIGHT, VECTORS
from mechproof.latex.printed_functions import FUNCTIONS
from mechproof.latex.printed_relations import RELATIONS
from mechproof.latex.words import AND, ELSE, IF, to_text

_ARGUMENTS = {r"\frac": 2, r"\binom": 2, **dict.fromkeys((r"\sqrt", r"\pmod", r"\pod"), 1)}
# Commands that upright words must not become: `\mathrm{int}` rounds, and no index holds a fraction.
_COMMANDS = (*_ARGUMENTS, r"\int", r"\sum", r"\prod")
# Marks that belong to the name of a letter, not its power; nobody raises to a multiplication sign.
_SUFFIXES = {r"\prime": "'", **dict.fromkeys((r"\cdot", r"\ast", r"\star"), STAR)}
_DEGREE = ("°", r"\degree")


# Letters and their other names are looked up in every print, so their signs are cached.
@lru_cache(maxsize=1 << 12)
def tokenize(latex: str) -> tuple[Token, ...]:
    """Return the signs of a print; raises `ReadingError` for unbalanced braces."""
    return tuple(token for token in read_signs(latex)[0] if token.text not in GAPS)


def list_signs(latex: str) -> list[str]:
    """Return the signs of a print without their places."""
    return [token.text for token in tokenize(latex)]


def read_signs(latex: str) -> tuple[tuple[Token, ...], tuple[tuple[int, int], ...]]:
    """Return the signs of a print with its gaps, and the spans that removed braces enclosed.

    Raises `ReadingError` for unbalanced braces and for excessive nesting.
    """
    try:
        normaliser = _Normaliser(latex)
        return tuple(normaliser.read_all()), tuple(normaliser.groups)
    except RecursionError:
        raise ReadingError(latex, 0, TOO_DEEP) from None


class _Normaliser:
    def __init__(self, latex: str) -> None:
        self.source = PrintedText(latex)
        self.raw = expand_commands(split_signs(latex))
        self.place = 0
        self.groups: list[tuple[int, int]] = []

    def read_all(self) -> list[Token]:
        signs = self._read_until("")
        if self.place < len(self.raw):
            raise self._refuse("a closing brace without an opening one")
        return signs

    def _refuse(self, reason: str, remedy: str = "") -> Exception:
        end = len(self.source.latex)
        start = self.raw[self.place].start if self.place < len(self.raw) else end
        return self.source.refuse(start, reason, remedy)

    def _peek(self) -> str:
        return self.raw[self.place].text if self.place < len(self.raw) else ""

    def _take(self) -> Token:
        if self.place >= len(self.raw):
            raise self._refuse("the print ends here, but something must follow")
        self.place += 1
        return self.raw[self.place - 1]

    def _read_until(self, closing: str) -> list[Token]:
        signs: list[Token] = []
        while self.place < len(self.raw) and self._peek() not in ("}", closing):
            if not self._is_left(signs):
                signs += self._read_item()
            signs += self._read_left() if self._is_left(signs) else self._read_scripts()
        return signs

    def _is_left(self, signs: list[Token]) -> bool:
        """Return whether scripts come next that belong to the letter after them."""
        if self._peek() not in ("_", "^", "{"):
            return False
        texts = [sign.text for sign in self.raw[self.place :]]
        first = left_scripts.skip_empty(texts, 0)
        if not texts[first:] or texts[first] not in ("_", "^"):
            return False
        before = [sign.text for sign in signs if sign.text not in GAPS]
        if left_scripts.stands_alone(before):
            return True
        base, inside = left_scripts.find_base(texts, first)
        is_parted = first > 0 or signs[-1].text in GAPS
        if self.source.latex[signs[-1].start : signs[-1].end] == r"\;" and texts[base:]:
            # Nobody prints so wide a blank before a power.
            return left_scripts.may_begin(texts[base])
        if not is_parted or not texts[base:] or not left_scripts.may_begin(texts[base]):
            return False
        between = self.source.latex[signs[-1].end : self.raw[self.place].start]
        if first > 0 and (signs[-1].text in GAPS or between.strip()):
            # An empty group after a blank begins a letter.
            return True
        if left_scripts.is_power(inside):
            raise self._refuse(
                "a script after a gap: of what precedes it, or of the letter after it?",
                r"Print x^2\cdot y for a power, x\cdot{}^2y for a script on the left.",
            )
        return True

    def _read_left(self) -> list[Token]:
        """Read the scripts to the left of a letter, the upper one first."""
        found: dict[str, list[Token]] = {}
        start = self.raw[self.place].start
        while self._is_left([]):
            mark = self._take()
            while mark.text not in ("_", "^"):
                mark = self._take()
            if mark.text in found:
                raise self.source.refuse(mark.start, f"a second {mark.text} at the same sign")
            found[mark.text] = [mark, *self._read_argument()]
        first = min(signs[0].start for signs in found.values())
        after = self._peek()
        if after != "}" and not left_scripts.may_begin(after):
            raise self.source.refuse(first, f"nothing precedes this {next(iter(found))}")
        return [Token(LEFT, start, start), *found.get("^", []), *found.get("_", [])]

    def _read_item(self) -> list[Token]:
        first = self._take()
        if first.text == "{":
            inner = self._read_until("}")
            self._close("}")
            if [t.text for t in inner] == [","]:
                return [Token(".", first.start, first.end)]
            if inner and not self._is_letter_before_index(inner):
                self.groups.append((min(t.start for t in inner), max(t.end for t in inner)))
            return inner
        if first.text in ("_", "^"):
            raise self.source.refuse(first.start, f"nothing precedes this {first.text}")
        if first.text == r"\num":
            return self._read_number()
        if first.text in printed_commands.MARKS:
            *inner, last = self._read_argument()[1:]
            if first.text == r"\boxed" or not {"+", "-"} & {t.text for t in inner}:
                self.groups[-1:] = []
            inner[-1:] = [replace(t, end=last.end) for t in inner[-1:]]
            return inner
        if first.text in printed_commands.BRACES:
            inner = self._read_argument()[1:-1]
            while self._peek() == printed_commands.BRACES[first.text]:
                self._take()
                self._read_argument()
            return inner
        if first.text in printed_commands.UNSEEN:
            self._read_argument()
            return []
        if first.text in printed_commands.STACKS and (relation := self._read_stack()):
            return [relation]
        if first.text in printed_commands.COLOURS:
            self._read_argument()
            return self._read_argument()[1:-1] if first.text == r"\textcolor" else []
        if first.text == r"\ang":
            return self._read_angle()
        if first.text in printed_commands.QUANTITIES:
            return self._read_quantity(first)
        if first.text in UPRIGHT:
            return [self._read_upright(first)]
        if first.text in TEXT:
            words, end = self._read_words()
            name = words.strip(" ,;")
            return [Token(rf"\{name}" if name in FUNCTIONS else to_text(words), first.start, end)]
        if first.text in (r"\begin", r"\end"):
            return [self._read_environment(first)]
        text = same_sign(first.text)
        return self._read_arguments(Token(text, first.start, first.end))

    def _is_letter_before_index(self, signs: Sequence[Token]) -> bool:
        r"""Return whether braces enclose one letter whose index follows: {q}_1, {\dot q}_1."""
        is_one = len(signs) == 1 or (signs[0].text in ACCENTS and len(signs) == len(r"a{q}"))
        return is_one and self._peek() == "_"

    def _read_stack(self) -> Token | None:
        """Read a relation with something above or below it; return None for any other stack."""
        place = self.place
        above, below = self._read_argument()[1:-1], self._read_argument()[1:-1]
        is_asked = any(printed_commands.QUESTION in sign.text for sign in above)
        if len(below) == 1 and below[0].text in RELATIONS and not is_asked:
            return below[0]
        self.place = place
        return None

    def _read_quantity(self, first: Token) -> list[Token]:
        r"""Read \SI{66}{mm} as a number followed by a unit in upright letters."""
        number = self._read_number() if first.text in printed_commands.MEASURES else []
        start = self.raw[self.place].start if number and self.place < len(self.raw) else first.start
        words, end = self._read_words()
        return [*number, Token(rf"\mathrm{{{words}}}", start, end)]

    def _read_number(self) -> list[Token]:
        """Read a number of siunitx, where a comma is decimal and a leading plus is dropped."""
        count = len(self.groups)
        inner = self._read_argument()[1:-1]
        del self.groups[count:]
        brackets = (b for a, b in pairwise(inner) if a.text.isdigit() and b.text == "(")
        for bracket in brackets:
            raise self.source.refuse(
                bracket.start,
                "a bracket after the digits of a number: its uncertainty, or a factor?",
                r"Print the number alone, or a product outside of \num and \SI.",
            )
        inner = inner[1:] if inner[:1] and inner[0].text == "+" else inner
        return [replace(sign, text=".") if sign.text == "," else sign for sign in inner]

    def _read_angle(self) -> list[Token]:
        r"""Read \ang{30} as a number of degrees."""
        number = self._read_number()
        end = self.raw[self.place - 1].end
        script = [Token(text, end, end) for text in ("^", "{", r"\circ", "}")]
        return [*number[:-1], *(replace(last, end=end) for last in number[-1:]), *script]

    def _read_environment(self, first: Token) -> Token:
        """Read the beginning or end of an environment; an array becomes a plain matrix."""
        inside, end = self._read_group()
        name = "".join(sign.text for sign in inside)
        has_options = name.endswith("*") or "Nice" in name
        if first.text == r"\begin" and has_options and self._peek() == "[":
            self._take()
            self._read_until("]")
            end = self._close("]").end
        if first.text == r"\begin" and name in printed_commands.WITH_COLUMNS:
            _, end = self._read_group()
        return Token(
            f"{first.text}{{{printed_commands.ENVIRONMENTS.get(name, name)}}}", first.start, end
        )

    def _read_arguments(self, command: Token) -> list[Token]:
        signs = [command]
        if command.text == r"\sqrt" and self._peek() == "[":
            opening = self._take()
            degree = self._read_until("]")
            signs += self._brace(degree, opening, self._close("]"), "[", "]")
        count = 1 if command.text in ACCENTS else _ARGUMENTS.get(command.text, 0)
        for _ in range(count):
            signs += self._read_argument()
        texts = [sign.text for sign in signs]
        is_dotted = texts[0] in VECTORS and texts[2] in DOTTED
        if is_dotted and find_close(texts[3:]) == len(texts[3:-2]):
            # A dot above a bold letter may be printed bold, too.
            signs[0], signs[2] = replace(command, text=texts[2]), replace(signs[2], text=texts[0])
        return signs

    def _read_argument(self) -> list[Token]:
        """Read an argument as TeX does, a group or a single sign; return it in braces."""
        while self._peek() in GAPS:
            self._take()
        first = self.place
        inner = self._read_item()
        opening, closing = self.raw[first], self.raw[self.place - 1]
        if opening.text == "{":
            return self._brace(inner, opening, closing)
        start, end = Token("", opening.start, opening.start), Token("", closing.end, closing.end)
        return self._brace(inner, start, end)

    def _brace(
        self, inner: list[Token], first: Token, last: Token, opening: str = "{", closing: str = "}"
    ) -> list[Token]:
        start, end = Token(opening, first.start, first.end), Token(closing, last.start, last.end)
        return [start, *inner, end]

    def _close(self, closing: str) -> Token:
        if self._peek() != closing:
            raise self._refuse(f"a {closing} is missing here")
        return self._take()

    def _read_words(self) -> tuple[str, int]:
        """Return the source text in the braces that follow, and where they end."""
        start = self.raw[self.place].end if self.place < len(self.raw) else 0
        _, end = self._read_group()
        return self.source.latex[start : self.raw[self.place - 1].start], end

    def _read_group(self) -> tuple[list[Token], int]:
        """Return the signs in the braces that follow, and where they end."""
        self._close("{")
        first, depth = self.place, 1
        while depth:
            depth += {"{": 1, "}": -1}.get(self._take().text, 0)
        return self.raw[first : self.place - 1], self.raw[self.place - 1].end

    def _read_upright(self, command: Token) -> Token:
        r"""Read `\mathrm{tg}` as the function `\tg`, `\mathrm{d}x` as the differential."""
        if self._peek() == "{":
            words, end = self._read_words()
        elif self._peek().isalpha():
            sign = self._take()
            words, end = sign.text, sign.end
        else:
            raise self._refuse(f"{command.text} needs a letter or braces here")
        if (word := to_text(words)) in (AND, *IF, *ELSE):
            return Token(word, command.start, end)
        name = re.sub(r"\\[,;:! ]|\s|\\mathrm|[{}]", "", words)
        is_word = name.isalnum() and name[0].isalpha() and len(name) > 1
        text = rf"\{name}" if is_word else rf"\mathrm{{{name}}}"
        text = rf"\operatorname{{{name}}}" if text in _COMMANDS else text
        return Token("d" if name == "d" else text, command.start, end)

    def _read_scripts(self) -> list[Token]:
        found: dict[str, list[Token]] = {}
        primes: list[Token] = []
        while self._peek() in ("_", "^", "'", *_DEGREE) or read_script(self._peek())[0]:
            mark = self._take()
            if mark.text == "'":
                primes.append(mark)
                continue
            if mark.text in ("_", "^"):
                inner = [mark, *self._read_argument()]
            else:
                inner = self._read_sign_script(mark)
            kind, inside = inner[0].text, inner[2:-1]
            if not inside:
                # An empty script, left by macros for an order that is not given.
                continue
            signs = (_SUFFIXES.get(t.text, "") for t in inside if kind == "^")
            suffixes = [*takewhile(bool, signs)]
            power = inside[len(suffixes) :]
            # Primes that share braces with a power have no place of their own.
            end = mark.start if power else inner[-1].end
            primes += [Token(sign, mark.start, end) for sign in suffixes]
            if suffixes and not power:
                continue
            if kind in found:
                raise self.source.refuse(mark.start, f"a second {kind} at the same sign")
            found[kind] = [*inner[:2], *power, inner[-1]]
        return [*found.get("_", []), *primes, *found.get("^", [])]

    def _read_sign_script(self, first: Token) -> list[Token]:
        """Read signs that are scripts in themselves: a degree, raised or lowered digits."""
        kind, text = read_script(first.text) if first.text not in _DEGREE else ("^", r"\circ")
        signs, last = [Token(text, first.start, first.end)], first
        while first.text not in _DEGREE and read_script(self._peek())[0] == kind:
            last = self._take()
            signs.append(Token(read_script(last.text)[1], last.start, last.end))
        begin, end = Token("", first.start, first.start), Token("", last.end, last.end)
        return [Token(kind, first.start, first.start), *self._brace(signs, begin, end)]
