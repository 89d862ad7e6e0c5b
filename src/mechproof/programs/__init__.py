"""From quantities to programs and back; imports SymPy and the records.

`Form` -> `evaluation` (named steps and an output) -> `rewrites` (named, exact; functions that exist
for their rounding alone are in `rounding_functions`) -> `step_names` (repeated subexpressions get
names) -> `lowering` (a `program` of single `operations` in a fixed order) -> `kernel`. `elementary`
functions are programs too. And back: `raising` (the mathematics of a program).
"""
