"""The rows of paper 1: what it states, and our own results."""

from . import design, peaks, position, readings

ROWS = (*position.ROWS, *readings.ROWS, *peaks.ROWS, *design.ROWS)
