"""Theorems -> scripts of Coq: the statement in the paper's letters, and its proof by the rung."""

from __future__ import annotations

import re
from collections.abc import Sequence

import sympy as sp

from mechproof.coq.families import has_families, name_letters, write_binders, write_value
from mechproof.coq.libraries import find_library
from mechproof.coq.proofs import is_the_same, prove, prove_at_point
from mechproof.coq.shared import settle, share_parts, write_definitions
from mechproof.coq.sum_proofs import SumProof
from mechproof.coq.terms import Names, UnwritableError, name_symbols, write_relation
from mechproof.coq.theorems import Theorem

# Statements of numbers share their parts in longer scripts.
PLAIN = 32_000
# Work limits: Coq reads long statements for minutes, but of definitions many in seconds.
_LONGEST, _LONGEST_SHARED = 60_000, 240_000


def write_script(title: str, theorems: Sequence[Theorem], plain: int = PLAIN) -> str:
    """Write the file of one row: `title` is a comment, each theorem has its number.

    Statements of numbers that would be longer than `plain` characters share their parts. Its
    `all_parts` is what must not assume more than is published. Raises `UnwritableError`.
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
    """Write the file that has Coq print what all parts of some scripts assume."""
    requires = "".join(f"Require {module}.\n" for module in modules)
    parts = ", ".join(f"{module}.all_parts" for module in modules)
    return f"{requires}\nDefinition all_rows := ({parts}).\nPrint Assumptions all_rows.\n"


def write_theorem(theorem: Theorem, name: str, shared: Names) -> str:
    """Write a theorem with its proof, and the witness of its hypotheses as a lemma before it.

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
    """Write the fact about numbers to which an equality with sums comes, and what leads there."""
    proof = SumProof(theorem)
    plain = proof.plain
    names = name_symbols(plain.symbols)
    implied = "".join(f"{write_relation(h, names)} -> " for h in plain.hypotheses)
    said = (
        f"forall {' '.join(names.values())} : R, {implied}{write_relation(plain.conclusion, names)}"
    )
    shown = _indent(prove(plain, names))
    return f"Fact {name} : {said}.\nProof.\n{shown}\nQed.\n", list(proof.write(name))
