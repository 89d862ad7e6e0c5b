"""The rows of paper 4: what it states, and our own results."""

from . import boundaries, sizes, tolerances, transfer

ROWS = (*transfer.ROWS, *sizes.ROWS, *tolerances.ROWS, *boundaries.ROWS)
VARIABLES = sizes.VARIABLES
