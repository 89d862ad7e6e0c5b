"""Coq scripts of what the ledger proves: theorems of rows, their proofs, and their check.

A row goes in as its record and its verdict; of how it was proved here nothing is taken over.
`terms` writes expressions, `theorems` states what a verdict says, `proofs` has the tactics
(`sum_proofs`: those of sums), `scripts` puts a file together, `coq_reading` and `script_comparison`
read it back from its text, `folder` has the files of papers, what is withheld and the outcome,
`checker` runs Coq.
"""
