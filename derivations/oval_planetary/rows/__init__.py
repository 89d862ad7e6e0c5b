"""The rows of paper 2: what it states, and our own results."""

from . import dwells, equations, pairs, readings, variants

ROWS = (*equations.ROWS, *pairs.ROWS, *variants.ROWS, *readings.ROWS, *dwells.ROWS)
