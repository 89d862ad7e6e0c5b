"""Coq scripts of what the ledger proves: theorems of rows, their proofs, and their check.

A row's record and verdict go in, but nothing of how it was proved here. `terms` writes expressions,
`theorems` states what a verdict says, `proofs` has the tactics (`sum_proofs`: those of sums),
`scripts` assembles a file, `coq_reading` and `script_comparison` read it back from its text,
`folder` has the files of papers, those withheld and the outcome, `checker` runs Coq.
"""
