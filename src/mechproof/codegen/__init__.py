"""From quantities to kernel source, in one direction; imports SymPy, Jinja2 and the records.

`Form` -> `evaluation` (named steps and an output) -> `rewrites` (named, exact; what exists for its
rounding alone is in `error_free`) -> `subexpressions` (what occurs twice gets a name) ->
`lowering` (a `program` of single operations in a fixed order) -> `syntax` (text in one of the
`languages`) -> `backends` (template and formatter) -> `regenerate` (files). `elementary` functions
are programs, too. And back: `reading` (the emitted text as a program) -> `raising` (its
mathematics) -> `forms` (rows of the ledger).
"""
