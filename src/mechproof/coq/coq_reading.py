"""Statements of Coq, read back from their text alone.

The reader knows the terms and the precedences of Coq's real numbers, and nothing of the writer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TypeAlias

import sympy as sp

_TOKENS = re.compile(r"\s*(/\\|\\/|->|=>|<=|>=|<>|:=|\d+|[A-Za-z_][\w']*|[-+*/^()=<>:,.])")
_STATEMENT = re.compile(r"^(?:Theorem|Lemma) (\w+) : ((?:.|\n)*?)\.\nProof\.", re.MULTILINE)
_DEFINITION = re.compile(r"^Definition (shared_\d+) : R := (.*)\.$", re.MULTILINE)
_GROUP = r"[\w' ]+ : [\w>\- ]+"
# Rounding to the nearest double, in statements on programs.
ROUNDED = sp.Function("rounded")
_FUNCTIONS: Mapping[str, Callable[..., sp.Expr]] = {
    "sin": sp.sin,
    "cos": sp.cos,
    "tan": sp.tan,
    "atan": sp.atan,
    "atan2": sp.atan2,
    "asin": sp.asin,
    "acos": sp.acos,
    "exp": sp.exp,
    "ln": sp.log,
    "sqrt": sp.sqrt,
    "Rabs": sp.Abs,
    "sinh": sp.sinh,
    "cosh": sp.cosh,
    "tanh": sp.tanh,
    "Rmin": sp.Min,
    "Rmax": sp.Max,
    "rounded": ROUNDED,
}
_TWO_ARGUMENTS = ("Rmin", "Rmax", "atan2")
_RELATIONS: Mapping[str, Callable[..., sp.Basic]] = {
    "=": sp.Eq,
    "<>": sp.Ne,
    "<": sp.Lt,
    "<=": sp.Le,
    ">": sp.Gt,
    ">=": sp.Ge,
}


@dataclass(frozen=True)
class Joined:
    """Relations joined by one sign, in their order, and whether in parentheses."""

    sign: str
    parts: tuple[sp.Basic | Joined, ...]
    is_enclosed: bool = False


Read: TypeAlias = sp.Basic | Joined


@dataclass(frozen=True)
class ReadStatement:
    """A statement as read: quantifier, variables with kinds, hypotheses, conclusions."""

    name: str
    quantifier: str
    variables: tuple[tuple[str, str], ...]
    hypotheses: tuple[Read, ...]
    conclusions: tuple[Read, ...]


def read_script(text: str) -> list[ReadStatement]:
    """Read every theorem and lemma of a file, with definitions written out.

    Raises ValueError for text that it does not know.
    """
    defined: dict[str, sp.Expr] = {}
    for name, term in _DEFINITION.findall(text):
        defined[name] = _read_term(term, defined)
    return [_read(name, body, defined) for name, body in _STATEMENT.findall(text)]


def _read_term(text: str, letters: Mapping[str, sp.Expr]) -> sp.Expr:
    parser = _Parser(text, letters)
    term = parser.sum()
    parser.end()
    return term


def _read(name: str, body: str, defined: Mapping[str, sp.Expr]) -> ReadStatement:
    found = re.match(rf"(forall|exists) ({_GROUP}|\({_GROUP}\)(?: \({_GROUP}\))*),\s", body)
    quantifier, binders = found.groups() if found else ("", "")
    variables = tuple(_read_binders(binders))
    letters = {letter: sp.Symbol(letter) for letter, kind in variables if kind == "R"}
    parser = _Parser(body[found.end() :] if found else body, {**defined, **letters})
    parser.wholes = {letter: sp.Symbol(letter) for letter, kind in variables if kind == "nat"}
    parser.ranks = {letter: kind.count("nat") for letter, kind in variables if "->" in kind}
    *hypotheses, conclusion = parser.implications()
    parser.end()
    parts: tuple[Read, ...] = (conclusion,)
    if isinstance(conclusion, Joined) and not conclusion.is_enclosed:
        parts = conclusion.parts
    return ReadStatement(name, quantifier, variables, tuple(hypotheses), parts)


def _read_binders(text: str) -> Iterator[tuple[str, str]]:
    """Yield the letters of groups, each with the kind of its group."""
    for letters, kind in re.findall(r"([\w' ]+) : ([^():]+)", text):
        for letter in letters.split():
            yield letter, kind.strip()


class _Parser:
    """A recursive-descent parser with a method for each level of precedence."""

    def __init__(self, text: str, letters: Mapping[str, sp.Expr]) -> None:
        self.letters = letters
        # The letters of whole numbers, and the families of numbers with the number of their
        # indices.
        self.wholes: Mapping[str, sp.Symbol] = {}
        self.ranks: Mapping[str, int] = {}
        self.tokens = _TOKENS.findall(text)
        if "".join(self.tokens) != re.sub(r"\s+", "", text):
            raise ValueError(f"Coq text: an unknown sign in {text[:60]!r}")
        self.at = 0

    @property
    def next(self) -> str:
        """Return the next token, or the empty string at the end."""
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, *expected: str) -> str:
        """Consume a token, which must be one of those expected if any are named."""
        token = self.next
        if not token or (expected and token not in expected):
            raise ValueError(f"Coq text: {token!r} where {expected or 'a term'} was expected")
        self.at += 1
        return token

    def end(self) -> None:
        """Raise ValueError unless all tokens are consumed."""
        if self.next:
            raise ValueError(f"Coq text: {self.next!r} after the end")

    def implications(self) -> list[Read]:
        """Read relations joined by arrows, the last one preceded by its named terms."""
        found = [self.relations()]
        while self.next == "->":
            self.take()
            self.named()
            found.append(self.relations())
        return found

    def named(self) -> None:
        """Read terms with names, each of which may use the names before it."""
        while self.next == "let":
            self.take()
            name = self.take()
            self.take(":=")
            self.letters = {**self.letters, name: self.sum()}
            self.take("in")

    def relations(self) -> Read:
        """Read relations joined by one kind of sign, either all "and" or all "or"."""
        found = [self.relation()]
        sign = self.next if self.next in ("/\\", "\\/") else ""
        while sign and self.next == sign:
            self.take()
            found.append(self.relation())
        return Joined(sign, tuple(found)) if sign else found[0]

    def relation(self) -> Read:
        """Read two terms and the sign between them, a derivative, or relations in parentheses."""
        if self.next == "is_derive":
            return self.derivative()
        start = self.at
        try:
            left = self.sum()
            relate = _RELATIONS[self.take(*_RELATIONS)]
        except ValueError:
            self.at = start
            self.take("(")
            inner = self.relations()
            self.take(")")
            return replace(inner, is_enclosed=True) if isinstance(inner, Joined) else inner
        return relate(left, self.sum(), evaluate=False)

    def derivative(self) -> sp.Basic:
        """Read the statement of the derivative that a function has at its own letter."""
        self.take("is_derive")
        letter, body = self.function("R")
        place, slope = self.atom(), self.atom()
        if place != letter:
            raise ValueError(f"Coq text: the derivative by {letter} is taken at {place}")
        return sp.Eq(sp.Derivative(body, letter, evaluate=False), slope, evaluate=False)

    def sum(self) -> sp.Expr:
        """Read terms with plus and minus between them."""
        total = self.product()
        while self.next in ("+", "-"):
            sign = self.take()
            term = self.product()
            total = sp.Add(total, term if sign == "+" else -term, evaluate=False)
        return total

    def product(self) -> sp.Expr:
        """Read factors with times and over between them, from the left."""
        total = self.signed()
        while self.next in ("*", "/"):
            sign = self.take()
            factor = self.signed()
            factor = factor if sign == "*" else sp.Pow(factor, -1, evaluate=False)
            total = sp.Mul(total, factor, evaluate=False)
        return total

    def signed(self) -> sp.Expr:
        """Read a power, possibly after a minus or a sign of inversion."""
        if self.next == "-":
            self.take()
            return sp.Mul(-1, self.signed(), evaluate=False)
        if self.next == "/":
            self.take()
            return sp.Pow(self.signed(), -1, evaluate=False)
        return self.power()

    def power(self) -> sp.Expr:
        """Read an atom and its whole exponent."""
        base = self.application()
        if self.next != "^":
            return base
        self.take()
        return sp.Pow(base, int(self.take()), evaluate=False)

    def application(self) -> sp.Expr:
        """Read a function with its arguments, or an atom."""
        if self.next == "RInt":
            return self.integral()
        if self.next in ("sum_to", "kronecker", "INR") or self.next in self.ranks:
            return self.indexed()
        if self.next not in _FUNCTIONS or self.next in self.letters:
            return self.atom()
        name = self.take()
        arguments = [self.atom() for _ in range(2 if name in _TWO_ARGUMENTS else 1)]
        return _FUNCTIONS[name](*arguments, evaluate=False)

    def integral(self) -> sp.Expr:
        """Read an integral: a function of its own letter, and both limits."""
        self.take("RInt")
        letter, body = self.function("R")
        return sp.Integral(body, (letter, self.atom(), self.atom()))

    def function(self, kind: str) -> tuple[sp.Symbol, sp.Expr]:
        """Read a function of its own letter, a real number (R) or a whole one (nat)."""
        self.take("(")
        self.take("fun")
        name = self.take()
        for expected in (":", kind, "=>"):
            self.take(expected)
        letter, outside = sp.Symbol(name), (self.letters, self.wholes)
        if kind == "nat":
            self.wholes = {**self.wholes, name: letter}
        else:
            self.letters = {**self.letters, name: letter}
        body = self.sum()
        self.letters, self.wholes = outside
        self.take(")")
        return letter, body

    def indexed(self) -> sp.Expr:
        """Read a sum, a Kronecker delta, a whole number, or a number of a family."""
        name = self.take()
        if name == "sum_to":
            return self.total()
        if name == "INR":
            return self.whole()
        if name == "kronecker":
            return sp.KroneckerDelta(self.whole(), self.whole())
        indices = [self.whole() for _ in range(self.ranks[name])]
        return sp.Indexed(sp.IndexedBase(name), *indices)

    def whole(self) -> sp.Symbol:
        """Read the letter of a whole number."""
        token = self.take()
        if token not in self.wholes:
            raise ValueError(f"Coq text: {token!r} where a whole number was expected")
        return self.wholes[token]

    def total(self) -> sp.Expr:
        """Read a sum that starts from 1: its end, and a function of its own index."""
        end = self.whole()
        index, body = self.function("nat")
        return sp.Sum(body, (index, 1, end))

    def atom(self) -> sp.Expr:
        """Read a letter, a number, or a term in parentheses."""
        token = self.take()
        if token in self.letters:
            return self.letters[token]
        if token.isdigit():
            return sp.Integer(token)
        if token == "PI":
            return sp.pi
        if token == "(":
            inner = self.sum()
            self.take(")")
            return inner
        raise ValueError(f"Coq text: {token!r} is not known")
