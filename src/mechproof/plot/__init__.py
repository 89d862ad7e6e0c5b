"""Pictures of mechanisms, of their tolerances and inspections, and the figures of papers.

Everything draws on matplotlib's `Axes` and returns them; nothing global is changed, and pyplot is
not used. Needs the `plot` extra (matplotlib).
"""

from mechproof.plot.figures import Figure

__all__ = ["Figure"]
