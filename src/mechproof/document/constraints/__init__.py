"""Constraints between the letters of a paper: their consequences, and where they hold."""
