"""From quantities to programs and back; imports SymPy and the records.

`Form` -> `evaluation` (named steps and an output) -> `rewrites` (named, exact; what exists for its
rounding alone is in `rounding_functions`) -> `step_names` (what occurs twice gets a name) ->
`lowering` (a `program` of single `operations` in a fixed order) -> `kernel`. `elementary` functions
are programs, too. And back: `raising` (the mathematics of a program).
"""
