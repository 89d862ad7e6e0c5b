"""Numbers of a paper: sizes, units, calculations and tables, and what formulas give there."""
