"""What paper 4 states, and what of ours stands beside it."""

from . import boundaries, sizes, tolerances, transfer

ROWS = (*transfer.ROWS, *sizes.ROWS, *tolerances.ROWS, *boundaries.ROWS)
VARIABLES = sizes.VARIABLES
