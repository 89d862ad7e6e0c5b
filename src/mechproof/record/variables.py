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
    r"""How a paper prints what is not a symbol, as far as a reader has to be told.

    `factors` are names that multiply a bracket after them (`a(1-e^2)`). `functions` adds to or
    replaces the names of functions in the table of `mechproof.latex`. `lower_limit` is where an
    integral printed without limits starts. `branch` is a letter that is 1 or -1: of a double sign
    on one side only it says whether the upper one is meant. `indices` are the symbols of index
    letters (left out: an integer symbol of that name). `scopes` are letters used twice. `moving`
    are letters that depend on another: that one, and the symbols of their derivatives by it, the
    first one first; a prime behind a bracket is a derivative by `primed`. `name_unit` returns the
    unit that is printed so, nothing for what is none: units are read behind numbers then.
    `weigh_unit` returns what such a unit is beside letters, in symbols of the units that it is
    made of, nothing where it cannot stand there; `units` are those of letters. `phases` are pairs
    of letters, or one and pi, that stand side by side in an angle: a function without brackets
    takes both, `\cos\omega t`. `dimensions` are those of letters with a unit: they tell the
    brackets that multiply one from those that hold an argument. `called` are letters that are
    functions of one: what stands in a bracket behind them is put for that, as it is for
    `bracketed` letters of `moving` and matrices, which never stand without a bracket. `parameters`
    are the letters by which derivatives go that are printed by one that these give, dy/dx of x(t)
    and y(t). `imaginary` is the letter of the imaginary unit; e is Euler's number beside it.
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
