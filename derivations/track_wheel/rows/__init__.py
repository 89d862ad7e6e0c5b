"""What paper 5 states, and what of ours stands beside it."""

from . import curves, design, equations, table

ROWS = (
    *equations.ROWS,
    *curves.CURVE_ROWS,
    *table.TABLE_ROWS,
    *curves.FIGURE_ROWS,
    *table.CONSEQUENCES,
    *design.ROWS,
)
