"""Constraints between the letters of a paper: what follows from them, and where they hold."""
