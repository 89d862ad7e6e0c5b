"""FPCore is read as written; what is not straight-line code in doubles is refused by line."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb

from mechproof.fpcore import DEEPEST, FPCoreError, read_cores
from mechproof.roundoff.running import IN_BALLS, IN_DOUBLES, run

TEXT = """; two of them
(FPCore (x y*)
  :name "first" :cite (someone) :precision binary64
  :pre (and (<= 1/2 x 2) (> 0x1.8p1 y* (- 1)))
  (let ([t (+ x 0.1)] [x y*])
    (fma t (sqrt (fabs x)) (exp (- PI)))))
(FPCore second (a)
  :pre (>= 3 a -1e-2)
  (let* ([b (* a a)] [c (/ b 3)]) (- c 1e23)))
"""


def test_cores_compute_what_they_say() -> None:
    first, second = read_cores(TEXT)
    assert (first.name, first.line, second.name, second.line) == ("first", 2, "second", 7)
    assert first.box == {
        "x": (Fraction(1, 2), Fraction(2)),
        "y*": (Fraction(-1), Fraction(3)),
    }
    assert second.box == {"a": (Fraction(-1, 100), Fraction(3))}
    given = {"x": arb(0.7), "y*": arb(-2.3)}
    (found,) = run(first.straight, given, IN_BALLS)
    # The names of a let are bound simultaneously: its x is y*.
    exact = (arb(0.7) + arb(1) / 10) * arb(2.3).sqrt() + (-arb.pi()).exp()
    assert found.overlaps(exact)
    (double,) = run(second.straight, {"a": np.float64(0.3)}, IN_DOUBLES)
    assert double == np.float64(0.3) * np.float64(0.3) / 3 - 1e23


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("(FPCore (x) :pre (<= 0 x 1)\n (if (< x 1) x 1))", "line 2: if is not straight-line"),
        ("(FPCore (x) :pre (<= 0 x 1)\n\n (while (< x 1) ([x 0 x]) x))", "line 3: while"),
        ("(FPCore (x) :pre (<= 0 x 1) (pow x 2))", "pow is not straight-line"),
        ("(FPCore (x) :pre (<= 0 x 1) (+ x x x))", "+ does not take 3 operands"),
        ("(FPCore (x) :pre (<= 0 x 1) (+ x z))", "z is neither an argument nor a number"),
        ("(FPCore (x)\n :precision binary32 :pre (<= 0 x 1) x)", "line 2: :precision binary32"),
        ("(FPCore (x) :round toZero :pre (<= 0 x 1) x)", "only nearestEven"),
        ("(FPCore (x) x)", ":pre gives no lower bound for x"),
        ("(FPCore (x) :pre (<= 0 x) x)", "no upper bound for x"),
        ("(FPCore (x) :pre (<= 2 x 1) x)", "the range of x, [2, 1], is empty"),
        ("(FPCore (x y)\n :pre (and (<= 0 x 1)\n (<= x y 1)) x)", "line 3: :pre must compare"),
        ("(FPCore (x) :pre (or (<= 0 x 1) (<= 2 x 3)) x)", "or in :pre is not a box"),
        ("(FPCore (x x) :pre (<= 0 x 1) x)", "the argument x is repeated"),
        ("(FPCore ((A 3)) :pre (<= 0 x 1) x)", "an argument is a name"),
        ("(FPCore (x) :pre (<= 0 x 1) ())", "() computes nothing"),
        ("(FPCore (x) :pre (<= 0 x 1) (let ([y]) y))", "a binding is [name value]"),
        ("(FPCore (x) :pre (<= 0 x 1) 1e999)", "1e999 is beyond the range of doubles"),
        ("(FPCore (x) :pre (<= 0 x 1) (! :precision binary64 x))", "! is not straight-line"),
        ("(FPCore (x) :pre (<= 0 x 1) (+ x 1)", "line 1: ( is not closed"),
        ("(FPCore (x] x)", "] closes nothing"),
        ('(FPCore (x) :name "x', "a text in quotes is not closed"),
        ("; nothing\n", "there is no FPCore"),
        ("x", "an FPCore begins with (FPCore"),
        ("(" * (DEEPEST + 2), f"nested more than {DEEPEST} deep"),
    ],
)  # fmt: skip
def test_what_is_not_read_is_told_with_its_line(text: str, told: str) -> None:
    with pytest.raises(FPCoreError, match=r"^(line|there)") as error:
        read_cores(text)
    assert told in str(error.value)
