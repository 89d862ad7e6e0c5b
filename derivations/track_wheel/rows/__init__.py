"""The rows of paper 5: what it states, and our own results."""

from . import curves, design, equations, table

ROWS = (
    *equations.ROWS,
    *curves.CURVE_ROWS,
    *table.TABLE_ROWS,
    *curves.FIGURE_ROWS,
    *table.CONSEQUENCES,
    *design.ROWS,
)
