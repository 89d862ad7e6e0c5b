"""What paper 2 states, and what of ours stands beside it."""

from . import dwells, equations, pairs, readings, variants

ROWS = (*equations.ROWS, *pairs.ROWS, *variants.ROWS, *readings.ROWS, *dwells.ROWS)
