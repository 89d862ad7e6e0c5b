"""Numbers of a paper: sizes, units, calculations and tables, and formulas evaluated at sizes."""
