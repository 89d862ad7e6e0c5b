"""From a row of a paper to its verdict; imports SymPy, flint and the records.

`judge` turns a row into a line of the ledger. `statement_checks` refuses statements whose side of
ours is meaningless; `wellformed` checks whether the printed side can be evaluated. The `ladder`
then tries the rungs for inequalities (`signs`, `inequalities`, ...), `equation_ladder` those for
equations (`algebra`, `canonical_sums`, `continuity`, ...), and `refutation` looks for
counterexamples in balls.

A computer algebra system simplifies by rules that hold almost everywhere. Here a rung is a
procedure that either decides on a stated domain or says that it does not; and whatever it proves
is cross-examined at points by balls, which know nothing of its steps.
"""
