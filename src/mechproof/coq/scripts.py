"""Theorems -> scripts of Coq: the statement in the paper's letters, and its proof by the rung."""

from __future__ import annotations

import re
from collections.abc import Sequence

from mechproof.coq.libraries import find_library
from mechproof.coq.proofs import prove, prove_at_point
from mechproof.coq.terms import UnwritableError, name_symbols, write_relation, write_term
from mechproof.coq.theorems import Theorem

# Work limit: Coq reads longer scripts for minutes; the longest that it accepts has half of it.
_LONGEST = 60_000


def write_script(title: str, theorems: Sequence[Theorem]) -> str:
    """Write the file of one row: `title` is a comment, each theorem has its number.

    Its `all_parts` is what must not assume more than is published. Raises `UnwritableError`.
    """
    parts = [write_theorem(theorem, f"part_{n}") for n, theorem in enumerate(theorems, start=1)]
    library = find_library("\n".join(parts))
    parts = [f"(* {title} *)", f"Require Import {library}.\nOpen Scope R_scope.\n", *parts]
    names = re.findall(r"^(?:Theorem|Lemma) (\w+)", "\n".join(parts), re.MULTILINE)
    parts.append(f"Definition all_parts := ({', '.join(names)}).\n")
    text = "\n".join(parts)
    if len(text) > _LONGEST:
        raise UnwritableError(f"its script is longer than {_LONGEST} characters")
    return text


def write_assumptions(modules: Sequence[str]) -> str:
    """Write the file that has Coq print what all parts of some scripts assume."""
    requires = "".join(f"Require {module}.\n" for module in modules)
    parts = ", ".join(f"{module}.all_parts" for module in modules)
    return f"{requires}\nDefinition all_rows := ({parts}).\nPrint Assumptions all_rows.\n"


def write_theorem(theorem: Theorem, name: str) -> str:
    """Write a theorem with its proof, and the witness of its hypotheses as a lemma before it."""
    names = name_symbols(theorem.symbols)
    hypotheses = [write_relation(h, names) for h in theorem.hypotheses]
    conclusion = write_relation(theorem.conclusion, names)
    values = [write_term(theorem.witness[s], {}) for s in theorem.symbols]
    binders = " ".join(names[s] for s in theorem.symbols)
    exists = f"exists {binders} : R, " if binders else ""
    reach = "".join(f"exists {value}. " for value in values)
    if not theorem.of_all:
        facts = " /\\ ".join([*hypotheses, conclusion])
        shown = prove_at_point((*theorem.hypotheses, theorem.conclusion))
        return f"Theorem {name} : {exists}{facts}.\nProof. {reach}{shown} Qed.\n"
    inhabited = ""
    if hypotheses:
        facts = " /\\ ".join(hypotheses)
        shown = prove_at_point(theorem.hypotheses)
        inhabited = f"Lemma {name}_inhabited : {exists}{facts}.\nProof. {reach}{shown} Qed.\n\n"
    variables = f"forall {binders} : R, " if binders else ""
    implied = "".join(f"{h} -> " for h in hypotheses)
    proof = "\n".join(f"  {line}" for line in prove(theorem, names))
    return f"{inhabited}Theorem {name} : {variables}{implied}{conclusion}.\nProof.\n{proof}\nQed.\n"
