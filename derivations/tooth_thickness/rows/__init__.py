"""The rows of paper 3: what it states, and our own results."""

from . import algorithm, claims, design

ROWS = (*design.ROWS, *algorithm.ROWS, *claims.ROWS)
