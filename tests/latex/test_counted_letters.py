r"""Arguments and factors of functions and letters: \cos nx, \cos bx\,dx, s(s-a), with twins."""

from __future__ import annotations

import pytest
import sympy as sp

from mechproof.latex import Reader, ReadingError
from mechproof.record import Notation, Variable

x, y, s = sp.symbols("x y s", real=True)
n = sp.Symbol("n", integer=True, positive=True)
READER = Reader(
    tuple(Variable(letter, "", latex=(str(letter),)) for letter in (x, y, s, n)),
    Notation(factors=("n", "y")),
)
READ = {
    r"\cos nx": sp.cos(n * x),
    r"\sin^2nx": sp.sin(n * x) ** 2,
    r"\sin 2nx": sp.sin(2 * n * x),
    r"\cos nx\sin ny": sp.cos(n * x) * sp.sin(n * y),
    r"\sin(n+1)x": sp.sin((n + 1) * x),
    r"\sum_{k=1}^n\cos kx": sp.Sum(
        sp.cos(sp.Symbol("k", integer=True) * x), (sp.Symbol("k", integer=True), 1, n)
    ),
    r"s(s-x)": s * (s - x),
    r"n2^{n-1}": n * 2 ** (n - 1),
    r"s^2(1-xs^2)": s**2 * (1 - x * s**2),
    r"s(s(s+1)+1)": s * (s * (s + 1) + 1),
}
REFUSED = (
    *(r"\cos xy", r"\cos nxy", r"\cos xn", r"\cos nk", r"\int_0^1\cos xu^2\,du"),
    *(r"\int_0^1\cos x\,u\,du", r"\int_0^1\cos xyu\,du", r"\int_0^1\cos xy\,du"),
    *("x2^n", "y2^n", "n2", "n2x^2"),
    *("s(x-y)", "s(x)", "s(s(x))", "s(x(s))"),
)


@pytest.mark.parametrize("latex", READ)
def test_what_is_read(latex: str) -> None:
    read = READER.parse(latex)
    (member,) = read.chains[0].members
    assert read.meaning().of(member) == READ[latex]


def test_brackets_in_brackets_are_read_once() -> None:
    depth = 40
    (member,) = READER.parse("s(" * depth + "s" + ")" * depth).chains[0].members
    assert READER.parse("s").meaning().of(member) == s ** (depth + 1)


def test_an_integral_is_over_what_stands_behind_a_letter() -> None:
    read = READER.parse(r"\int_0^1\cos xu\,du")
    integral = read.meaning().of(read.chains[0].members[0])
    assert integral.function == sp.cos(x * integral.limits[0][0])


def test_an_upright_d_is_no_letter() -> None:
    d = sp.Symbol("d", real=True)
    reader = Reader((*READER.variables, Variable(d, "", latex=("d",))))
    (member,) = reader.parse(r"\int_0^1dx\,\mathrm dx").chains[0].members
    assert reader.parse(r"\int_0^1dx\,\mathrm dx").meaning().of(member).doit() == d / 2
    with pytest.raises(ReadingError, match="a differential, or d"):
        reader.parse(r"\int_0^1dx\,dx")
    # An integral needs a differential, and one on the other side is not its own.
    (member, _) = reader.parse(r"\int_0^1x\,dx=d").chains[0].members
    assert reader.parse(r"\int_0^1x\,dx=d").meaning().of(member).doit() == sp.Rational(1, 2)
    with pytest.raises(ReadingError, match="a differential, or d"):
        reader.parse(r"\int_0^1x\,dx+d")


@pytest.mark.parametrize("latex", REFUSED)
def test_what_is_refused(latex: str) -> None:
    with pytest.raises(ReadingError):
        READER.parse(latex)
