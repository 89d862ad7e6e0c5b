"""Theorems -> scripts of Coq: the statement in the paper's letters, and its proof by the rung."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import sympy as sp

from mechproof.coq.proofs import prove
from mechproof.coq.terms import Names, write_relation, write_term
from mechproof.coq.theorems import Theorem

HEADER = "Require Import Mechproof.\nOpen Scope R_scope.\n"
# Names that a letter of a paper must not take.
_TAKEN = re.compile(
    "R|PI|sin|cos|tan|atan|atan2|asin|acos|exp|ln|sqrt|Rabs|Rmin|Rmax|sinh|cosh|tanh|forall|exists|fun|"
    "in|let|match|with|end|as|return|if|then|else|Set|Prop|Type|at|using|where|fix|cofix|IF|E|F|"
    "[HSQNM][0-9]+"
)


def write_script(title: str, theorems: Sequence[Theorem]) -> str:
    """Write the file of one row: `title` is a comment, each theorem has its number."""
    parts = [f"(* {title} *)", HEADER]
    for number, theorem in enumerate(theorems, start=1):
        parts.append(write_theorem(theorem, f"part_{number}"))
    names = re.findall(r"^(?:Theorem|Lemma) (\w+)", "\n".join(parts), re.MULTILINE)
    parts.append(f"Definition all_parts := ({', '.join(names)}).\nPrint Assumptions all_parts.\n")
    return "\n".join(parts)


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
        return f"Theorem {name} : {exists}{facts}.\nProof. {reach}at_point. Qed.\n"
    inhabited = ""
    if hypotheses:
        facts = " /\\ ".join(hypotheses)
        inhabited = f"Lemma {name}_inhabited : {exists}{facts}.\nProof. {reach}at_point. Qed.\n\n"
    variables = f"forall {binders} : R, " if binders else ""
    implied = "".join(f"{h} -> " for h in hypotheses)
    proof = "\n".join(f"  {line}" for line in prove(theorem, names))
    return f"{inhabited}Theorem {name} : {variables}{implied}{conclusion}.\nProof.\n{proof}\nQed.\n"


def name_symbols(symbols: Iterable[sp.Basic]) -> Names:
    """Give every symbol an identifier, none twice."""
    names: dict[sp.Basic, str] = {}
    for symbol in symbols:
        plain = re.sub(r"\W+", "_", str(symbol), flags=re.ASCII).strip("_") or "x"
        plain = f"{plain}_" if _TAKEN.fullmatch(plain) or plain[0].isdigit() else plain
        while plain in names.values():
            plain += "_"
        names[symbol] = plain
    return names
