"""Random statements from fixed seeds: what is proved must hold at points the prover never saw."""

import random
from contextlib import suppress

import pytest
import sympy as sp
from weights import first_of

from mechproof.arithmetic.balls import evaluate, truth
from mechproof.proof.judge import judge
from mechproof.proof.verdict import Verdict
from mechproof.record import Claim, Equality, Holds, Paper, Variable

x, y = sp.symbols("x y", real=True)
p, q = sp.symbols("p q", positive=True)
n, k = sp.symbols("n k", integer=True, positive=True)
A = sp.IndexedBase("A", real=True)
PAPER = Paper(
    "random",
    "nowhere",
    (
        *(Variable(symbol, "a number") for symbol in (x, y, A)),
        *(Variable(symbol, "a size", within=sp.Interval.open(0, sp.oo)) for symbol in (p, q)),
        Variable(n, "a count", within=sp.S.Naturals),
    ),
    (),
)
LEAVES = (x, y, p, q, n, sp.S(1), sp.S(2), sp.S(-1), sp.S.Half)
UNARY = (
    sp.sqrt,
    sp.sin,
    sp.cos,
    sp.Abs,
    sp.exp,
    sp.atan,
    sp.sign,
    sp.floor,
    lambda e: e**2,
    lambda e: e**3,
    lambda e: 1 / e,
    lambda e: e**n,
    lambda e: (-1) ** n * e,
)
BINARY = (sp.Add, sp.Mul, lambda a, b: a - b, sp.Max, sp.atan2)
UPPER = (n, n + 1, n - 1, n - 5, 2 * n, n / 2, x, sp.S(3), sp.S(0))
SUMMANDS = (sp.S(1), k, k**2, x, A[k], A[k] ** 2, x * A[k], A[k] - k, (-1) ** k, 1 / k)
ROUNDS = 20


def expression(draw: random.Random, depth: int) -> sp.Expr:
    if depth == 0:
        return draw.choice(LEAVES)
    if draw.random() < 0.5:
        return draw.choice(UNARY)(expression(draw, depth - 1))
    return draw.choice(BINARY)(expression(draw, depth - 1), expression(draw, depth - 1))


def real_expression(draw: random.Random, depth: int) -> sp.Expr:
    """Draw expressions until SymPy evaluates one to a finite expression over the reals."""
    while True:
        with suppress(ValueError):
            drawn = expression(draw, depth)
            if not drawn.has(sp.zoo, sp.nan, sp.oo, sp.I):
                return drawn


def random_sum(draw: random.Random) -> sp.Expr:
    index = sp.Symbol("k", integer=True)
    summand = draw.choice(SUMMANDS).subs(k, index)
    return sp.Sum(summand, (index, draw.choice((0, 1, 1, 2)), draw.choice(UPPER)))


def point(draw: random.Random) -> dict[sp.Basic, sp.Rational]:
    numbers = {s: sp.Rational(draw.randint(-9, 9), draw.randint(1, 5)) for s in (x, y)}
    sizes = {s: sp.Rational(draw.randint(1, 30), draw.randint(1, 9)) for s in (p, q)}
    entries = {A[i]: sp.Rational(draw.randint(-9, 9), 7) for i in range(-20, 30)}
    return numbers | sizes | entries | {n: sp.Integer(draw.randint(1, 9))}


def at(side: sp.Expr, values: dict[sp.Basic, sp.Rational]) -> sp.Expr:
    return side.subs(n, values[n])


@pytest.mark.slow
@pytest.mark.parametrize("seed", first_of(range(3)))
def test_what_is_proved_of_a_sign_holds_everywhere(seed: int) -> None:
    draw = random.Random(seed)
    for _ in range(ROUNDS):
        left = real_expression(draw, draw.randint(1, 4))
        relation = draw.choice((sp.Ge, sp.Gt, sp.Ne))(left, 0, evaluate=False)
        if judge(Claim("c", "c", Holds(relation)), PAPER).verdict is not Verdict.PROVED:
            continue
        for values in (point(draw) for _ in range(30)):
            assert truth(relation, values) is not False, (relation, values)


@pytest.mark.slow
@pytest.mark.parametrize("seed", first_of(range(3)))
def test_what_is_proved_equal_is_equal_everywhere(seed: int) -> None:
    draw = random.Random(seed)
    for _ in range(ROUNDS):
        left = real_expression(draw, draw.randint(1, 3)) + draw.choice((0, 1)) * random_sum(draw)
        other = draw.choice((sp.expand, sp.factor, sp.together, sp.expand_trig, sp.powdenest))
        changed = draw.choice((0, 0, 1, x, 1 / sp.S(10**6)))
        right = other(left) + changed * draw.choice((1, random_sum(draw)))
        if judge(Claim("c", "c", Equality(left, right)), PAPER).verdict is not Verdict.PROVED:
            continue
        for values in (point(draw) for _ in range(30)):
            balls = [evaluate(at(side, values), values) for side in (left, right)]
            if all(ball.is_finite() for ball in balls):
                assert balls[0].overlaps(balls[1]), (left, right, values)
