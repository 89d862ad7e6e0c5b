"""Units as they are written in brackets -> physical dimensions, and their sizes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

import sympy as sp

from mechproof.record.variables import ANGLE, LENGTH, NUMBER, Dimension, Variable


@dataclass(frozen=True)
class Unit:
    """A physical dimension, the size of the unit in SI units (rad for angles), and its print."""

    dimension: Dimension
    scale: sp.Expr = sp.S.One
    name: str = field(default="", compare=False)

    def __mul__(self, other: Unit) -> Unit:
        return Unit(self.dimension * other.dimension, self.scale * other.scale)

    def __pow__(self, power: int | Fraction) -> Unit:
        return Unit(self.dimension**power, self.scale**power)

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1


ONE = Unit(NUMBER)
_NAMES = ("m", "kg", "s", "K", "A", "mol")
_TIME, _MASS = Dimension(time=1), Dimension(mass=1)
_TEMPERATURE, _CURRENT = Dimension(temperature=1), Dimension(current=1)
_AMOUNT = Dimension(amount=1)
_FORCE = _MASS * LENGTH / _TIME**2
_POWER = _FORCE * LENGTH / _TIME
_VOLTAGE, _CHARGE = _POWER / _CURRENT, _CURRENT * _TIME
_FLUX = _VOLTAGE * _TIME
_TURN, _TEN = 2 * sp.pi, sp.Integer(10)
_DEGREE = sp.pi / 180
# One revolution per minute, in radians per second.
REVOLUTIONS = _TURN / 60
_BY_THE_MINUTE = ("rpm", "r/min", "rev/min", "U/min", "1/min", "min^-1")
# The micro sign, and the letter that looks like it.
_MICRO = {"u": -6, "µ": -6, "μ": -6}
_PREFIXES = {"p": -12, "n": -9, **_MICRO, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9}


def _list_multiples(unit: str, prefixes: str) -> Mapping[str, sp.Expr]:
    """Return the sizes of a coherent unit, without and with some prefixes."""
    return {unit: _TEN**0, **{f"{one}{unit}": _TEN ** _PREFIXES[one] for one in prefixes}}


_SCALES: Mapping[Dimension, Mapping[str, sp.Expr]] = {
    LENGTH: {
        **_list_multiples("m", "nuµμmcdk"),
        **{"in": sp.Rational("0.0254"), "ft": sp.Rational("0.3048")},
    },
    LENGTH**3: {"l": _TEN**-3, "L": _TEN**-3, "ml": _TEN**-6},
    _TIME: {
        **_list_multiples("s", "uµμm"),
        **{"min": sp.Integer(60), "h": sp.Integer(3600)},
        **dict.fromkeys(("day", "days"), sp.Integer(86400)),
    },
    _MASS: {"kg": _TEN**0, "g": _TEN**-3, "t": _TEN**3, "mg": _TEN**-6},
    _TEMPERATURE: {"K": _TEN**0},
    _CURRENT: _list_multiples("A", "uµμmk"),
    _AMOUNT: _list_multiples("mol", "mk"),
    NUMBER / _TIME: _list_multiples("Hz", "kMG"),
    _FORCE: _list_multiples("N", "mkM"),
    _FORCE * _TIME: {"Ns": _TEN**0, "kNs": _TEN**3},
    _FORCE * LENGTH: {
        **{"Nm": _TEN**0, "kNm": _TEN**3, "Nmm": _TEN**-3, **_list_multiples("J", "mkMG")},
        **{"kWh": 36 * _TEN**5, "Wh": sp.Integer(3600)},
    },
    _FORCE / LENGTH**2: {**_list_multiples("Pa", "hkMG"), "bar": _TEN**5, "mbar": _TEN**2},
    _POWER: {**_list_multiples("W", "mkMG"), **_list_multiples("VA", "k")},
    _CHARGE: {
        **_list_multiples("C", "pnuµμm"),
        **{"Ah": sp.Integer(3600), "mAh": sp.Rational("3.6")},
    },
    _VOLTAGE: _list_multiples("V", "uµμmk"),
    _VOLTAGE / _CURRENT: {
        name: scale
        for ohm in ("Ω", "\u2126", "Ohm")
        for name, scale in _list_multiples(ohm, "mkM").items()
    },
    _CURRENT / _VOLTAGE: _list_multiples("S", "m"),
    _CHARGE / _VOLTAGE: _list_multiples("F", "pnuµμm"),
    _FLUX: {**_list_multiples("Wb", "m"), "Vs": _TEN**0},
    _FLUX / _CURRENT: _list_multiples("H", "uµμm"),
    _FLUX / LENGTH**2: _list_multiples("T", "m"),
}
# Angles and numbers have the same dimension here.
_ANGLES = {
    **{"rad": _TEN**0, "mrad": _TEN**-3, "deg": _DEGREE, "°": _DEGREE},
    **{"'": _DEGREE / 60, '"': _DEGREE / 3600},
}
_BASE: Mapping[str, Unit] = {
    **dict.fromkeys(("", "1", "-"), ONE),
    "%": Unit(NUMBER, _TEN**-2),
    # Not a multiple of K, as its zero differs.
    "°C": Unit(_TEMPERATURE, sp.nan),
    **{name: Unit(ANGLE, scale) for name, scale in _ANGLES.items()},
    **dict.fromkeys(_BY_THE_MINUTE, Unit(ANGLE / _TIME, REVOLUTIONS)),
    **{name: Unit(d, scale) for d, units in _SCALES.items() for name, scale in units.items()},
}
# Macros of siunitx, and of LaTeX itself.
_SPELLED: Mapping[str, str] = {
    **{"metre": "m", "meter": "m", "second": "s", "gram": "g", "newton": "N", "radian": "rad"},
    **{"degree": "°", "pascal": "Pa", "joule": "J", "watt": "W", "hertz": "Hz", "kelvin": "K"},
    **{"ampere": "A", "volt": "V", "ohm": "Ω", "Omega": "Ω", "farad": "F", "henry": "H"},
    **{"tesla": "T", "weber": "Wb", "coulomb": "C", "siemens": "S", "mole": "mol"},
    **{"minute": "min", "hour": "h", "tonne": "t", "celsius": "°C", "percent": "%"},
    **{"milli": "m", "centi": "c", "deci": "d", "kilo": "k", "micro": "µ", "nano": "n"},
    **{"mega": "M", "giga": "G", "mu": "µ", "per": "/", "cdot": "·", "squared": "^2"},
    **{"cubed": "^3", "kilogram": "kg", "mm": "mm", "cm": "cm", "kg": "kg", "rad": "rad"},
    **{"min": "min", "textmu": "µ", "um": "µm", "us": "µs"},
    **{name: name for name in ("m", "km", "g", "s", "ms", "N", "kN", "MN", "Pa", "kPa", "MPa")},
    **{name: name for name in ("GPa", "J", "kJ", "W", "kW", "MW", "Hz", "kHz", "V", "A", "K")},
}
_JOINED = (
    *("milli", "centi", "deci", "kilo", "micro", "nano", "mega", "giga"),
    *("per", "mu", "textmu"),
)
_MACRO = re.compile(r"\\([A-Za-z]+)\s*")
# Powers in front of a unit, as in \square\milli\metre.
_RAISED = {"square": "squared", "cubic": "cubed"}
_RAISED_BEFORE = re.compile(
    rf"\\(square|cubic)\s*((?:\\(?:{'|'.join(_JOINED)})\s*)*\\[A-Za-z]+\s*|\s[A-Za-z]+\s*)"
)
_FACTOR = re.compile(
    r"(?P<unit>[^\s·*/^()\d-][^\s·*/^()\d-]*|1)(?:\^?\{?(?P<power>-?\d+(?:/\d+)?)\}?)?\s*"
)
# The divisor in brackets, as in W/(m K), and a dot between units, as in kN.m.
_BELOW = re.compile(r"/\s*\(([^()/]*)\)")
_DOT = re.compile(r"(?<=[A-Za-z])\.(?=[A-Za-z])")
_BRACED = re.compile(r"\^\{(-?\d+)\}")
_SIGN = re.compile(r"\s*([·*/]?)\s*")


def _make_symbols() -> Iterator[Variable]:
    """Yield the SI units as letters that no print shows."""
    for place, name in enumerate(_NAMES):
        dimension = Dimension(*(int(n == place) for n in range(len(_NAMES))))
        symbol = sp.Symbol(f"[{name}]", positive=True)
        within, letter = sp.Interval.open(0, sp.oo), rf"\mathrm{{{name}}}"
        yield Variable(symbol, f"the unit {name}", dimension, within, letter=letter)


UNITS = tuple(_make_symbols())


class UnitError(ValueError):
    """An unknown unit."""


def is_share(unit: Unit) -> bool:
    """Return whether a unit is the percent sign."""
    return unit == _BASE["%"]


def drop_braces(text: str) -> str:
    """Return a unit without the braces around its exponents."""
    return _BRACED.sub(r"^\1", text)


def spell_unit(text: str) -> str:
    r"""Return a unit without macros: mm/s for \milli\metre\per\second."""

    def spell(match: re.Match[str]) -> str:
        name = match[1]
        known = _SPELLED.get(name, match[0])
        return known if name in _JOINED or known[0] in "/^·" else f"{known} "

    text = _RAISED_BEFORE.sub(lambda found: rf"{found[2]}\{_RAISED[found[1]]} ", text)
    text = _DOT.sub("·", text.replace(r"\%", "%"))
    return re.sub(r"\s+(?=[\^/])", "", _MACRO.sub(spell, text)).strip()


def is_unit(text: str) -> bool:
    """Return whether a word names a unit, with or without a prefix."""
    return text in _BASE


def read_unit(text: str) -> Unit:
    """Return a unit such as mm, m/s^2, N m or 1/s.

    Raises `UnitError` naming the unknown part.
    """
    text = drop_braces(text.strip())
    text = _BELOW.sub(lambda below: "/" + re.sub(r"[\s·*]+", "/", below[1].strip()), text)
    if text in _BASE:
        return _BASE[text]
    found, place, sign = ONE, 0, ""
    while place < len(text):
        factor = _FACTOR.match(text, place)
        if factor is None or factor["unit"] not in _BASE:
            wrong = factor["unit"] if factor else text[place:]
            raise UnitError(f"the unit {wrong!r} of [{text}] is not known")
        said = factor["power"] or "1"
        power = Fraction(said) if "/" in said else int(said)
        found *= _BASE[factor["unit"]] ** (-power if sign == "/" else power)
        between = _SIGN.match(text, factor.end())
        sign, place = (between[1], between.end()) if between else ("", len(text))
    return found


def name_in_si(dimension: Dimension) -> str:
    """Return the SI unit of a dimension: N if it has a name, else a product such as m^2 kg s^-1."""
    named = _SCALES.get(dimension, {})
    if name := next((name for name, scale in named.items() if scale == 1), ""):
        return name
    powers = zip(_NAMES, dimension.powers, strict=True)
    shown = (name if power == 1 else f"{name}^{power}" for name, power in powers if power)
    return " ".join(shown) or "1"


def weigh_unit(name: str) -> sp.Expr | None:
    """Return a unit in symbols of the SI units; None for revolutions per minute.

    A statement about quantities holds for units of any size: their symbols are positive numbers.
    """
    unit = read_unit(name)
    if unit.scale == REVOLUTIONS or not unit.scale.is_finite:
        return None
    return unit.scale * weigh(unit.dimension)


def weigh(dimension: Dimension) -> sp.Expr:
    """Return the SI unit of a dimension in the symbols of the base units."""
    powers = zip(UNITS, dimension.powers, strict=True)
    return sp.Mul(*(v.symbol**power for v, power in powers))
