"""From a row of a paper to its verdict; imports SymPy, flint and the records.

`judge` makes one line of the ledger of a row. `statement_checks` refuses what our own side of a
statement cannot mean; `wellformed` looks whether the printed side can be evaluated. The `ladder`
then tries the rungs of inequalities (`signs`, `inequalities`, ...), `equation_ladder` those of
equations (`algebra`, `canonical_sums`, `continuity`, ...), and `refutation` looks for
counterexamples in balls.

A computer algebra system simplifies by rules that hold almost everywhere. Here a rung is a
procedure that decides, on a stated domain, or says that it does not; and what it proves is
cross-examined at points by balls, which know nothing of its steps.
"""
