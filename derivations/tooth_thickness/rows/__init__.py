"""What paper 3 states, and what of ours stands beside it."""

from . import algorithm, claims, design

ROWS = (*design.ROWS, *algorithm.ROWS, *claims.ROWS)
