"""Theorems -> Coq scripts: statements in the paper's letters, with their proofs.

A script requires libraries of lemmas and tactics, each of which requires those before it. Numbers
that occur in several statements are written once: every definition comes with a fact, an enclosure
between decimal fractions, that Coq derives from those of the definitions before it; statements in
terms of the definitions are then small.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from hashlib import sha256
from importlib.resources import files
from math import floor

import flint
import sympy as sp

from mechproof.arithmetic import balls
from mechproof.coq.proofs import is_the_same, prove, prove_at_point
from mechproof.coq.sum_proofs import SumProof
from mechproof.coq.terms import (
    Names,
    UnwritableError,
    has_families,
    name_letters,
    name_symbols,
    write_binders,
    write_relation,
    write_term,
    write_value,
)
from mechproof.coq.theorems import Theorem
from mechproof.record.parts import find_free

# From the library that all scripts require to the one that few do.
LIBRARIES = ("Mechproof", "Calculus", "Sums")
# The only library that scripts on bounds of roundings require.
ROUNDINGS = "Roundings"
_NAMED = re.compile(r"^(?:Definition|Fixpoint|Lemma|Ltac) (\w+)", re.MULTILINE)
# Names that a library takes from elsewhere and that scripts use.
_EXPORTED = {"Calculus": ("RInt", "is_derive")}
# Terms shorter than this, in characters, are written out wherever they occur.
_SHORTEST = 30
# Decimal places of enclosures, which have fewer if those of their parts are wider.
_PLACES = 30
_BITS = 128
# Proves relations of two numbers by the enclosed sign of their difference.
_SETTLE = f"""Ltac settle :=
  let lies := interval with (i_prec {_BITS}) in
  intros;
  repeat match goal with |- _ /\\ _ => split end;
  first
    [ lies
    | apply Rminus_lt; lies
    | apply Rminus_gt; lies
    | apply Rminus_le; lies
    | apply Rminus_ge; lies
    | apply Rlt_not_eq, Rminus_lt; lies
    | apply Rgt_not_eq, Rminus_gt; lies
    | at_point ].
"""
# Scripts of numbers that are longer than this, in characters, share parts.
PLAIN = 32_000
# Work limits, in characters: Coq reads long statements for minutes, but many definitions in
# seconds.
_LONGEST, _LONGEST_SHARED = 60_000, 240_000


@cache
def read_library(name: str) -> str:
    """Return the text of a library."""
    return files(__package__).joinpath(f"{name}.v").read_text(encoding="utf-8")


def find_library(text: str) -> str:
    """Return the last library of which a text uses a name; it requires all before it."""
    words = set(re.findall(r"\w+", text))
    used = [name for name in LIBRARIES if words & _list_names(name)]
    return used[-1] if used else LIBRARIES[0]


def list_required(text: str) -> tuple[str, ...]:
    """Return the libraries that a script requires, read from its own text."""
    found = re.search(r"^Require Import (\w+)\.", text, re.MULTILINE)
    if found and found[1] == ROUNDINGS:
        return (ROUNDINGS,)
    return LIBRARIES[: LIBRARIES.index(found[1]) + 1] if found else ()


def digest_required(text: str) -> str:
    """Return the SHA-256 of a script together with all that it requires."""
    whole = "".join((*map(read_library, list_required(text)), text))
    return sha256(whole.encode()).hexdigest()


def digest_libraries() -> str:
    """Return the SHA-256 of the libraries that scripts of rows require."""
    return sha256("".join(map(read_library, LIBRARIES)).encode()).hexdigest()


@cache
def _list_names(library: str) -> frozenset[str]:
    return frozenset((*_NAMED.findall(read_library(library)), *_EXPORTED.get(library, ())))


def share_parts(relations: Sequence[sp.Basic]) -> Names:
    """Name both sides and numbers that occur more than once, in order of construction.

    The sides have no free symbols.
    """
    found = _Parts()
    sides = {side for relation in relations for side in relation.args}
    for relation in relations:
        found.visit(relation)
    names: dict[sp.Basic, str] = {}
    for part in found.order:
        if (found.counts[part] > 1 or part in sides) and len(write_term(part, names)) >= _SHORTEST:
            names[part] = f"shared_{len(names) + 1}"
    return names


class _Parts:
    """The parts of terms, inner ones first, and how often each is written if all have names."""

    def __init__(self) -> None:
        self.counts: Counter[sp.Basic] = Counter()
        self.order: list[sp.Expr] = []

    def visit(self, node: sp.Basic) -> None:
        """Count a part, and on its first occurrence the parts that it is made of."""
        is_inverse = isinstance(node, sp.Pow) and node.exp.is_negative
        if not is_inverse:
            self.counts[node] += 1
        if self.counts[node] > 1 or not node.args or isinstance(node, sp.Integral):
            return
        for part in node.args:
            self.visit(part)
        if isinstance(node, sp.Expr) and not is_inverse and not find_free(node):
            self.order.append(node)


def write_definitions(names: Names) -> Iterator[str]:
    """Yield a tactic, then each part's definition and the fact that encloses it.

    Raises `UnwritableError`.
    """
    if names:
        yield _SETTLE
    known: dict[sp.Basic, str] = {}
    values: dict[sp.Basic, flint.arb] = {}
    for part, name in names.items():
        term = write_term(part, known)
        letters = {other: sp.Symbol(known[other]) for other in known}
        low, high, places = _enclose(part.xreplace(letters), values)
        turn = "turn_vectors; " if "atan2" in term else ""
        yield (
            f"Definition {name} : R := {term}.\n"
            f"Fact {name}_lies : ({low} / 10 ^ {places}) <= {name} <= ({high} / 10 ^ {places}).\n"
            f"Proof. {_recall(term)}unfold {name}; {turn}interval with (i_prec {_BITS}). Qed.\n"
        )
        known[part] = name
        with balls.working_precision(_BITS):
            ends = flint.arb(low + high, high - low) / 2
            values[sp.Symbol(name)] = ends / flint.arb(10) ** places


def settle(text: str) -> str:
    """Write the tactics that prove relations from the enclosures of the definitions they use."""
    return f"{_recall(text)}settle."


def _recall(text: str) -> str:
    """Write the tactics that recall the enclosures of the definitions that a text uses."""
    used = dict.fromkeys(re.findall(r"\bshared_\d+\b", text))
    return "".join(f"pose proof {name}_lies. " for name in used)


def _enclose(part: sp.Expr, values: Mapping[sp.Basic, flint.arb]) -> tuple[int, int, int]:
    """Return whole numbers below and above a number times a power of ten, and the exponent."""
    ball = balls.evaluate(part, values, _BITS)
    if not ball.is_finite():
        raise UnwritableError("a number in it could not be enclosed")
    exact = (end.fmpq() for end in (ball.mid(), ball.rad()))
    middle, radius = (Fraction(int(end.p), int(end.q)) for end in exact)
    places = next(n for n in range(_PLACES, -_PLACES, -1) if radius * Fraction(10) ** n < 1)
    near = floor(middle * Fraction(10) ** places)
    return near - 2, near + 3, places


def write_script(title: str, theorems: Sequence[Theorem], plain: int = PLAIN) -> str:
    """Write the file of one row: `title` is a comment, each theorem has its number.

    Statements of numbers that would be longer than `plain` characters share their parts. The file's
    `all_parts` must rest on no more than the published assumptions. Raises `UnwritableError`.
    """
    text, longest = _write(title, theorems, {}), _LONGEST
    if len(text) > plain and not any(theorem.symbols for theorem in theorems):
        text = _write(title, theorems, share_parts([r for t in theorems for r in _list(t)]))
        longest = _LONGEST_SHARED
    if len(text) > longest:
        raise UnwritableError(f"its script is longer than {longest} characters")
    return text


def _list(theorem: Theorem) -> tuple[sp.Basic, ...]:
    return *theorem.hypotheses, theorem.conclusion


def _write(title: str, theorems: Sequence[Theorem], shared: Names) -> str:
    numbered = enumerate(theorems, start=1)
    parts = [write_theorem(theorem, f"part_{n}", shared) for n, theorem in numbered]
    parts = [*write_definitions(shared), *parts]
    library = find_library("\n".join(parts))
    parts = [f"(* {title} *)", f"Require Import {library}.\nOpen Scope R_scope.\n", *parts]
    names = re.findall(r"^(?:Theorem|Lemma) (\w+)", "\n".join(parts), re.MULTILINE)
    parts.append(f"Definition all_parts := ({', '.join(names)}).\n")
    return "\n".join(parts)


def write_assumptions(modules: Sequence[str]) -> str:
    """Write the file that has Coq print the assumptions of all parts of the given scripts."""
    requires = "".join(f"Require {module}.\n" for module in modules)
    parts = ", ".join(f"{module}.all_parts" for module in modules)
    return f"{requires}\nDefinition all_rows := ({parts}).\nPrint Assumptions all_rows.\n"


def write_theorem(theorem: Theorem, name: str, shared: Names) -> str:
    """Write a theorem with its proof, preceded by a lemma with the witness of its hypotheses.

    Numbers that are `shared` are written by their names.
    """
    listed = _list(theorem)
    names = {**shared, **name_letters(theorem.symbols, *listed)} if theorem.symbols else shared
    hypotheses = [write_relation(h, names) for h in theorem.hypotheses]
    conclusion = write_relation(theorem.conclusion, names)
    values = [write_value(s, theorem.witness[s], names) for s in theorem.symbols]
    binders = write_binders(theorem.symbols, names, *listed)
    exists = f"exists {binders}, " if binders else ""
    reach = "".join(f"exists {value}. " for value in values)
    if not theorem.of_all:
        facts = " /\\ ".join([*hypotheses, conclusion])
        shown = settle(facts) if shared else prove_at_point(_list(theorem))
        return f"Theorem {name} : {exists}{facts}.\nProof. {reach}{shown} Qed.\n"
    inhabited = ""
    if hypotheses:
        facts = " /\\ ".join(hypotheses)
        shown = settle(facts) if shared else prove_at_point(theorem.hypotheses)
        inhabited = f"Lemma {name}_inhabited : {exists}{facts}.\nProof. {reach}{shown} Qed.\n\n"
    variables = f"forall {binders}, " if binders else ""
    implied = "".join(f"{h} -> " for h in hypotheses)
    if shared:
        lines = [settle(f"{implied}{conclusion}")]
    elif has_families(*listed) and not is_the_same(theorem.conclusion, names):
        plain, lines = _prove_sums(theorem, f"{name}_plain")
        inhabited = f"{inhabited}{plain}\n"
    else:
        lines = prove(theorem, names)
    said = f"Theorem {name} : {variables}{implied}{conclusion}"
    return f"{inhabited}{said}.\nProof.\n{_indent(lines)}\nQed.\n"


def _indent(lines: Sequence[str]) -> str:
    return "\n".join(f"  {line}" for line in lines)


def _prove_sums(theorem: Theorem, name: str) -> tuple[str, list[str]]:
    """Write the fact about numbers that an equality with sums reduces to, and the reduction."""
    proof = SumProof(theorem)
    plain = proof.plain
    names = name_symbols(plain.symbols)
    implied = "".join(f"{write_relation(h, names)} -> " for h in plain.hypotheses)
    said = (
        f"forall {' '.join(names.values())} : R, {implied}{write_relation(plain.conclusion, names)}"
    )
    shown = _indent(prove(plain, names))
    return f"Fact {name} : {said}.\nProof.\n{shown}\nQed.\n", list(proof.write(name))
