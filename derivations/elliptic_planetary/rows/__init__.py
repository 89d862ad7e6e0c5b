"""What paper 1 states, and what of ours stands beside it."""

from . import design, peaks, position, readings

ROWS = (*position.ROWS, *readings.ROWS, *peaks.ROWS, *design.ROWS)
