"""Proofs of equalities with sums: each sum in closed form, then an equality of numbers.

A sum of products is added up term by term, from the innermost index: a Kronecker delta picks one
term, and a factor without the index is counted. Sums that remain become letters of a separate
theorem.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import count, permutations

import sympy as sp

from mechproof.coq.first_tactics import introduce
from mechproof.coq.terms import (
    Names,
    UnwritableError,
    name_letters,
    name_symbols,
    write_at,
    write_term,
)
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_free, find_parts

_CLOSE = "by_depth ltac:(zero)"


@dataclass(frozen=True)
class _Term:
    """A number times factors that depend on indices; `picked` is the index it is pinned to."""

    number: sp.Expr
    body: sp.Expr
    picked: sp.Basic | None = None


@dataclass(frozen=True)
class _Closed:
    """The closed form of a sum: in letters for remaining sums, and as text with these sums."""

    total: sp.Sum
    value: sp.Expr
    text: str
    lines: tuple[str, ...]


class SumProof:
    """The proof of an equality with sums: a `plain` theorem without sums, and the way to it."""

    def __init__(self, theorem: Theorem) -> None:
        if not isinstance(theorem.conclusion, sp.Eq):
            raise UnwritableError("with sums only equalities are proved")
        self.theorem = theorem
        self.whole = sp.Tuple(theorem.conclusion, *theorem.hypotheses)
        self.names = dict(name_letters(theorem.symbols, self.whole))
        # The sums that remain, by their forms, each with its letter and its text.
        self.left: dict[sp.Basic, tuple[sp.Symbol, str]] = {}
        self.values: dict[sp.Basic, sp.Expr] = {}
        self.found: list[_Closed] = []
        for total in _list_sums(self.whole):
            self.found.append(self._close(total))
        self.plain = self._state_plain()

    def write(self, name: str) -> Iterator[str]:
        """Yield the tactics; `name` is that of the plain theorem."""
        yield introduce(self.theorem, {s: self._bare(s) for s in self.theorem.symbols})
        for number, closed in enumerate(self.found, start=1):
            written = write_term(closed.total, self._known(number - 1))
            if written == closed.text:
                continue
            yield f"assert (E{number} : {written} = {closed.text})."
            yield "{"
            yield from (f"  {line}" for line in closed.lines)
            yield "}"
            yield f"try rewrite E{number} in *."
        texts = self._texts
        values = " ".join(texts.get(s) or self.names[s] for s in self.plain.symbols)
        known = {**self.names, **texts}
        left, right = (write_term(side, known) for side in self.plain.conclusion.args)
        listed = [f"given H{n}" for n, _ in enumerate(self.theorem.hypotheses, start=1)]
        shown = "apply sum_not_negative; intros; structure"
        given = " | ".join([*listed, *(shown for letter in self._list_positive())])
        shown = f"apply ({name} {values})" + (f"; [ {given} ]" if given else "")
        yield f"transitivity {left}; [ {_CLOSE} | ]."
        yield f"transitivity {right}; [ {shown} | {_CLOSE} ]."

    def _bare(self, symbol: sp.Basic) -> str:
        whole = sp.Tuple(symbol)
        name: str = self.names[whole if whole in self.names else symbol]
        return name

    @property
    def _texts(self) -> Names:
        """Return the text of the sum that each letter stands for."""
        return dict(self.left.values())

    def _known(self, number: int) -> Names:
        """Return the names with the first sums in closed form."""
        return {**self.names, **{c.total: c.text for c in self.found[:number]}}

    def _state_plain(self) -> Theorem:
        conclusion, *hypotheses = (
            relation.func(*(_put(side, self.values) for side in relation.args), evaluate=False)
            for relation in self.whole
        )
        letters = [letter for letter, _ in self.left.values()]
        hypotheses += (sp.Ge(s, 0, evaluate=False) for s in self._list_positive())
        symbols = (*(s for s in self.theorem.symbols if isinstance(s, sp.Symbol)), *letters)
        point = {s: self.theorem.witness[s] for s in symbols if s in self.theorem.witness}
        sums = {letter: form for form, (letter, _) in self.left.items()}
        point |= {letter: write_at(sums[letter], self.theorem.witness) for letter in letters}
        return replace(
            self.theorem,
            symbols=symbols,
            hypotheses=tuple(hypotheses),
            conclusion=conclusion,
            witness=point,
            points=(),
        )

    def _list_positive(self) -> list[sp.Symbol]:
        """List the letters of remaining sums that are non-negative."""
        return [letter for form, (letter, _) in self.left.items() if form.is_nonnegative]

    def _close(self, total: sp.Sum) -> _Closed:
        """Add up a sum whose inner sums have been added up before."""
        indices = [limit[0] for limit in total.limits]
        if find_free(total) & set(indices):
            raise UnwritableError("a sum whose limits contain its indices is not added up")
        known = self._known(len(self.found))
        proof = _Levels(self, total, known)
        value = proof.run()
        self.values[total] = value
        # A sum that remains keeps its text.
        is_left = len(indices) == 1 and value.is_Symbol
        text = write_term(total, known) if is_left else proof.text
        return _Closed(total, value, text, tuple(proof.lines))

    def name(self, form: sp.Basic, text: str) -> sp.Symbol:
        """Return the letter of a remaining sum, the same one for each equal form."""
        if form not in self.left:
            taken = {str(s) for s in (*self.theorem.symbols, *self._texts)}
            name = next(n for n in map("total{}".format, count(1)) if n not in taken)
            self.left[form] = (sp.Symbol(name, real=True), text)
        return self.left[form][0]


class _Levels:
    """The addition of one sum, index by index from the innermost."""

    def __init__(self, proof: SumProof, total: sp.Sum, known: Names) -> None:
        self.proof, self.total, self.known = proof, total, known
        self.indices = [limit[0] for limit in total.limits]
        self.ends = [limit[2] for limit in total.limits]
        self.names = self._name_indices()
        self.lines: list[str] = []
        self.text = ""

    def _name_indices(self) -> Names:
        """Name the indices as `write_term` does, the outermost first."""
        names = dict(self.known)
        for index in reversed(self.indices):
            letter = name_symbols([index], names)[index]
            names |= {index: f"(INR {letter})", sp.Tuple(index): letter}
        return names

    def run(self) -> sp.Expr:
        """Return the closed form, and keep its text and its proof."""
        value = _put(self.total.function, self.proof.values)
        text = write_term(self.total.function, self.names)
        levels: list[list[str]] = []
        for depth, (index, end) in enumerate(zip(self.indices, self.ends, strict=True)):
            terms = list(self._split(value, index, self.indices))
            is_last = depth == len(self.indices) - 1
            form = self._settle if is_last else self._write_inner
            results = [form(term, index, end) for term in terms]
            summands = _join([self._write_summand(term, index) for term in terms])
            levels.append(self._show(index, end, summands))
            value = sp.Add(*(result for result, _ in results))
            text = _join([written for _, written in results])
            if not is_last:
                outer, limit = self.indices[depth + 1], self.ends[depth + 1]
                levels.append([self._sum(outer, limit, text)])
        self.text = text
        self.lines = _nest(levels, [self.names[sp.Tuple(i)] for i in self.indices])
        return value

    def _split(self, value: sp.Expr, index: sp.Symbol, bound: list[sp.Symbol]) -> Iterator[_Term]:
        """Yield the products of a value, each with its factors free of indices in front."""
        atoms = find_parts(value, sp.Sum, sp.KroneckerDelta)
        hidden = {atom: sp.Dummy() for atom in sorted(atoms, key=sp.default_sort_key)}
        back = {letter: atom for atom, letter in hidden.items()}
        for product in sp.Add.make_args(sp.expand(value.xreplace(hidden))):
            factors = [f.xreplace(back) for f in sp.Mul.make_args(product)]
            moved = [f for f in factors if find_free(f) & set(bound)]
            number = sp.Mul(*(f for f in factors if f not in moved))
            yield self._pin(number, moved, index)

    def _pin(self, number: sp.Expr, factors: list[sp.Expr], index: sp.Symbol) -> _Term:
        signs = [_take_sign(f) for f in factors]
        pinned = [s for s in signs if s is not None and index in s.args]
        rest = [s or f for s, f in zip(signs, factors, strict=True)]
        if not pinned:
            body = sp.Mul(*rest)
            if index in find_free(body):
                return _Term(number, body)
            return _Term(number * body, sp.S.One)
        (other,) = set(pinned[0].args) - {index}
        rest.remove(pinned[0])
        return _Term(number, sp.Mul(*rest), other)

    def _write_summand(self, term: _Term, index: sp.Symbol) -> str:
        number, body = (write_term(part, self._all) for part in (term.number, term.body))
        if term.picked is None:
            return f"({number} * {body})"
        at = f"{self.names[sp.Tuple(index)]} {self.names[sp.Tuple(term.picked)]}"
        return f"({number} * (kronecker {at} * {body}))"

    @property
    def _all(self) -> Names:
        return {**self.names, **self.proof._texts}

    def _write_inner(self, term: _Term, index: sp.Symbol, end: sp.Symbol) -> tuple[sp.Expr, str]:
        """Return the value of the sum of a term over an inner index, and its text."""
        return self._multiply(term, self._add_up(term, index, end))

    def _multiply(self, term: _Term, result: sp.Expr) -> tuple[sp.Expr, str]:
        """Return a term's sum times the number in front, and its text."""
        number, written = (write_term(part, self._all) for part in (term.number, result))
        return term.number * result, f"({number} * {written})"

    def _add_up(self, term: _Term, index: sp.Symbol, end: sp.Symbol) -> sp.Expr:
        if term.picked is not None:
            return term.body.subs(index, term.picked)
        if term.body == 1:
            return end
        return sp.Sum(term.body, (index, 1, end))

    def _settle(self, term: _Term, index: sp.Symbol, end: sp.Symbol) -> tuple[sp.Expr, str]:
        """Return the same for the outermost index, with a letter for a sum that remains."""
        result = self._add_up(term, index, end)
        if isinstance(result, sp.Sum):
            result = self.proof.name(_find_form(result), write_term(result, self._all))
        return self._multiply(term, result)

    def _show(self, index: sp.Symbol, end: sp.Symbol, summands: str) -> list[str]:
        letter = self.names[sp.Tuple(index)]
        return [
            f"transitivity ({self._sum(index, end, summands)}).",
            f"{{ apply sum_alike. intros {letter} W0. same_terms. }}",
            "add_up.",
        ]

    def _sum(self, index: sp.Symbol, end: sp.Symbol, text: str) -> str:
        whole, letter = (self.names[sp.Tuple(s)] for s in (end, index))
        return f"sum_to {whole} (fun {letter} : nat => {text})"


def _nest(levels: list[list[str]], letters: list[str]) -> list[str]:
    """Nest the proof of each inner level in the proof of the next level outwards."""
    lines = levels[0]
    for place in range(1, len(levels), 2):
        (text,), outer = levels[place], levels[place + 1]
        letter = letters[(place + 1) // 2]
        inner = [f"  {line}" for line in lines]
        start = f"{{ apply sum_alike. intros {letter} W{(place + 1) // 2}."
        lines = [f"transitivity ({text}).", start, *inner, "}", *outer]
    return lines


def _join(texts: list[str]) -> str:
    return f"({' + '.join(texts or ['0'])})"


def _take_sign(factor: sp.Expr) -> sp.KroneckerDelta | None:
    """Return the Kronecker delta of which a factor is a power, or None."""
    base = factor.base if isinstance(factor, sp.Pow) else factor
    return base if isinstance(base, sp.KroneckerDelta) else None


def _put(node: sp.Basic, values: Mapping[sp.Basic, sp.Expr]) -> sp.Expr:
    """Replace parts by values and leave all else unchanged, also the parts under roots."""
    if node in values:
        return values[node]
    parts = [_put(part, values) for part in node.args]
    if all(new is old for new, old in zip(parts, node.args, strict=True)):
        return node
    is_plain = isinstance(node, sp.Add | sp.Mul | sp.Pow)
    return node.func(*parts, evaluate=False) if is_plain else node.func(*parts)


def _list_sums(whole: sp.Basic) -> list[sp.Sum]:
    """List the sums, inner ones first. Raises `UnwritableError`."""
    sums = sorted(find_parts(whole, sp.Sum), key=lambda s: (_measure(s), str(s)))
    bound = {limit[0] for total in sums for limit in total.limits}
    if any(isinstance(s, sp.Symbol) and s in bound for t in sums for s in find_free(t)):
        raise UnwritableError("a sum that depends on the index of another is not added up")
    return sums


def _measure(expression: sp.Basic) -> int:
    """Return how deeply sums are nested."""
    inner = [_measure(part) for part in expression.args]
    return max(inner, default=0) + isinstance(expression, sp.Sum)


def _find_form(total: sp.Sum) -> sp.Basic:
    """Return a sum with its indices in one order and under fixed names."""
    body: sp.Basic = total
    limits = []
    while isinstance(body, sp.Sum):
        limits += [(limit[0], limit[2]) for limit in reversed(body.limits)]
        body = body.function
    forms = []
    for order in permutations(limits):
        new = {index: sp.Symbol(f"index{k}") for k, (index, _) in enumerate(order)}
        sums = [(new[index], 1, end) for index, end in order]
        forms.append(sp.Sum(body.xreplace(new), *reversed(sums)))
    return min(forms, key=sp.default_sort_key)
