"""The numbers of equations, as LaTeX counts them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_LEVELS = ("chapter", "section", "subsection")
_SHOWN = re.compile(
    r"\\(?P<kind>arabic|Alph|alph|Roman|roman)\s*\{(?P<counter>\w+)\}|\\the(?P<the>[a-z]+)"
)
_ROMAN = ("", "i", "ii", "iii", "iv", "v", "vi", "vii", "viii", "ix", "x", "xi", "xii", "xiii")


@dataclass
class Counter:
    """The number of the next equation, as LaTeX counts."""

    count: int = 0
    letter: int = -1
    below: int = 0
    within: str = ""
    shown: str = ""
    first: str = ""
    sections: dict[str, int] = field(default_factory=lambda: dict.fromkeys(_LEVELS, 0))

    def step(self) -> str:
        """Return the next number."""
        if self.letter >= 0:
            self.letter += 1
            return f"({self._show_count()}{chr(ord('a') + self.letter - 1)})"
        self.count, self.below = self.count + 1, 0
        return f"({self._show_count()})"

    def step_below(self, *, is_new: bool) -> str:
        """Return the next number with a letter, below the preceding number or below a new one."""
        if is_new or not self.below:
            self.count, self.below = self.count + 1, 0
        self.below += 1
        return f"({self._show_count()}{chr(ord('a') + self.below - 1)})"

    def _show_count(self) -> str:
        if self.shown:
            return _SHOWN.sub(self._show, self.shown).replace("{", "").replace("}", "")
        prefix = self._show_section(self.within) + "." if self.within in _LEVELS else ""
        return f"{prefix}{self.count}"

    def _show(self, match: re.Match[str]) -> str:
        r"""Return the text of a counter in the definition of \theequation."""
        name = match["the"] or match["counter"]
        if match["the"] and name in _LEVELS:
            return self._show_section(name)
        number = self.count if name == "equation" else self.sections.get(name, 0)
        return _print_count(number, match["kind"] or "arabic")

    def _show_section(self, level: str) -> str:
        """Return the number of a section, preceded by the numbers of the enclosing sections."""
        levels = _LEVELS[: _LEVELS.index(level) + 1]
        first = next((n for n, one in enumerate(levels) if self.sections[one]), len(levels) - 1)
        numbers = [str(self.sections[one]) for one in levels[first:]]
        if self.first and levels[first] == self.first:
            numbers[0] = _print_count(self.sections[self.first], "Alph")
        return ".".join(numbers)

    def begin_appendix(self) -> None:
        """Count the sections of the appendix by letters."""
        self.first = "chapter" if self.sections["chapter"] else "section"
        self.sections = dict.fromkeys(_LEVELS, 0)

    def enter(self, level: str) -> None:
        """Begin a section; numbers that are counted within it restart."""
        self.sections[level] += 1
        for lower in _LEVELS[_LEVELS.index(level) + 1 :]:
            self.sections[lower] = 0
        if self.within in _LEVELS[_LEVELS.index(level) :]:
            self.count = 0

    def group(self, edge: str) -> None:
        """Enter or leave subequations, which share a number and have a letter each."""
        self.count += edge == "begin"
        self.letter = 0 if edge == "begin" else -1


def _print_count(number: int, kind: str) -> str:
    """Return a number as LaTeX prints a counter."""
    if kind in ("Alph", "alph"):
        letter = chr(ord("a") + number - 1) if number else ""
        return letter.upper() if kind == "Alph" else letter
    if kind in ("Roman", "roman") and number < len(_ROMAN):
        return _ROMAN[number].upper() if kind == "Roman" else _ROMAN[number]
    return str(number)
