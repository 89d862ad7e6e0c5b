"""Rows judged in the context of their paper: which are excused, doubted, or misprints."""
