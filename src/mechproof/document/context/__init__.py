"""Rows beside the others of their paper: which are excused, doubted, or misprints."""
