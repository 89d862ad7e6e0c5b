"""From a row of a paper to its verdict; imports SymPy, flint and the records.

`wellformed` and `dimensions` look whether a statement can be evaluated, `domain` where it is meant,
`ladder` tries the rungs (`algebra`, `signs`, `sums`, `antiderivative`, ...) and `refutation` the
counterexamples in `balls`; `judge` makes one line of the `ledger` of it.
"""
