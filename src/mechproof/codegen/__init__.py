"""From quantities to kernel source, in one direction.

`Quantity` -> `evaluation` (named steps and an output) -> `rewrites` (named, exact; what exists
for its rounding alone is in `error_free`, exact there as well) ->
`subexpressions` (what occurs twice gets a name) -> `numpy_printer` (text of expressions) ->
`kernel` (pure data) -> `backend` (template and formatter) -> `regenerate` (files).
"""
