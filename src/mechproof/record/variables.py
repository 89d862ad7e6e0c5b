"""The meaning of a paper's letters: its variables, its other notation, and parts of the domain."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from operator import add
from types import MappingProxyType

import sympy as sp

Power = int | Fraction


@dataclass(frozen=True)
class Dimension:
    """Exponents of the base quantities; angles and pure numbers have none.

    The exponent of the angle is kept besides: it decides how a value is shown but is never
    compared.
    """

    length: Power = 0
    mass: Power = 0
    time: Power = 0
    temperature: Power = 0
    current: Power = 0
    amount: Power = 0
    angle: Power = field(default=0, compare=False)

    @property
    def is_angle(self) -> bool:
        """Return whether values are shown in degrees too."""
        return self == NUMBER and self.angle == 1

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(*map(add, self._exponents, other._exponents))

    def __pow__(self, power: Power) -> Dimension:
        return Dimension(*(one * power for one in self._exponents))

    def __truediv__(self, other: Dimension) -> Dimension:
        return self * other**-1

    @property
    def powers(self) -> tuple[Power, ...]:
        """Return the powers of the base quantities, in the order of the fields."""
        return self._exponents[:-1]

    @property
    def _exponents(self) -> tuple[Power, ...]:
        return tuple(vars(self).values())

    def __str__(self) -> str:
        # The order and the signs are those of ISO 80000-1.
        powers = zip("LMTΘIN", self.powers, strict=True)
        return "·".join(n if p == 1 else f"{n}^{p}" for n, p in powers if p) or "1"


NUMBER = Dimension()
ANGLE = Dimension(angle=1)
LENGTH = Dimension(length=1)
SPEED = Dimension(length=1, time=-1)
FREQUENCY = Dimension(time=-1)


@dataclass(frozen=True)
class Variable:
    r"""A symbol of the paper: its meaning, its dimension, its values, its sign convention.

    `within` is an interval (or `S.Naturals` for a count). `given` defines the symbol in terms of
    others (a = (R1 - R2)/2) and is substituted before anything is decided. `latex` are the ways it
    is printed, whole idioms included (`\varphi_3'`, `\rho(\varphi_5)`,
    `\frac{d\varphi_3}{d\varphi_1}`); without one it cannot be printed. A family (`IndexedBase`) is
    printed with its indices, for which `#` stands (`K_#(t)`; by default at the end, `_#`). `letter`
    is how one of our own symbols, whose name is a word, is typeset; it is never read.
    """

    symbol: sp.Symbol | sp.IndexedBase | sp.MatrixSymbol
    meaning: str
    dimension: Dimension = NUMBER
    within: sp.Set = sp.S.Reals
    given: sp.Expr | None = None
    sign: str = ""
    latex: tuple[str, ...] = ()
    letter: str = ""


def family_of(matrix: sp.MatrixSymbol) -> sp.IndexedBase:
    """Return the family whose members stand for the entries of a matrix when these are compared."""
    return sp.IndexedBase(str(matrix.name), real=True)


def list_given(variables: Iterable[Variable]) -> dict[sp.Symbol, sp.Expr]:
    """Return the symbols that are defined by others, with their values."""
    return {v.symbol: v.given for v in variables if v.given is not None}


@dataclass(frozen=True)
class Scope:
    """Letters with another meaning in the named rows; None makes one a bound index."""

    rows: tuple[str, ...]
    names: Mapping[str, sp.Symbol | sp.IndexedBase | sp.MatrixSymbol | None]


@dataclass(frozen=True)
class Notation:
    r"""How a paper prints anything but symbols, as far as a reader must be told.

    `factors` are names that multiply a bracket after them (`a(1-e^2)`). `functions` adds to or
    replaces the names of functions in the table of `mechproof.latex`. `lower_limit` is where an
    integral printed without limits starts. `branch` is a letter that is 1 or -1: if only one side
    has a double sign, it says whether the upper sign is meant. `indices` are the symbols of index
    letters (default: an integer symbol of that name). `scopes` are letters used twice. `moving`
    maps letters that depend on another one to that letter and the symbols of their derivatives by
    it, in rising order; a prime after a bracket is a derivative by `primed`. `name_unit` returns
    the unit with a printed name, nothing for anything else: if given, units are read after numbers.
    `weigh_unit` returns the factor that such a unit is next to letters, in symbols of its base
    units, nothing if it cannot appear there; `units` are those of letters. `phases` are pairs of
    letters, or of a letter and pi, that are adjacent in an angle: a function without brackets takes
    both, `\cos\omega t`. `dimensions` are those of letters with a unit: they distinguish brackets
    that multiply a letter from those that contain an argument. `called` are letters that are
    functions of another one: the content of a bracket after them replaces that one, as it does
    after the `bracketed` letters of `moving` and matrices, which never appear without a bracket.
    `parameters` are the letters on which both letters of a derivative depend: t for dy/dx of x(t)
    and y(t). `imaginary` is the letter of the imaginary unit; e is then Euler's number.
    """

    factors: tuple[str, ...] = ()
    functions: Mapping[str, Callable[..., sp.Expr]] = field(
        default_factory=lambda: MappingProxyType({})
    )
    lower_limit: sp.Expr | None = None
    branch: sp.Symbol | None = None
    indices: tuple[sp.Symbol, ...] = ()
    scopes: tuple[Scope, ...] = ()
    moving: Mapping[sp.Basic, tuple[sp.Basic, tuple[sp.Basic, ...]]] = field(
        default_factory=lambda: MappingProxyType({})
    )
    primed: sp.Symbol | None = None
    name_unit: Callable[[str], str] | None = None
    weigh_unit: Callable[[str], sp.Expr | None] | None = None
    units: Mapping[sp.Basic, sp.Expr] = field(default_factory=lambda: MappingProxyType({}))
    phases: frozenset[tuple[sp.Basic, sp.Basic]] = frozenset()
    dimensions: Mapping[sp.Basic, Dimension] = field(default_factory=lambda: MappingProxyType({}))
    parameters: Mapping[sp.Basic, sp.Symbol] = field(default_factory=lambda: MappingProxyType({}))
    called: Mapping[sp.Basic, sp.Symbol] = field(default_factory=lambda: MappingProxyType({}))
    bracketed: frozenset[str] = frozenset()
    imaginary: str = ""


@dataclass(frozen=True)
class Part:
    """A part of the domain in words and in mathematics: narrower sets, additional relations."""

    text: str
    within: Mapping[sp.Symbol, sp.Set] = field(default_factory=lambda: MappingProxyType({}))
    where: tuple[sp.Basic, ...] = ()
