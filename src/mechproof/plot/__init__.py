"""Pictures of mechanisms, of their tolerances and inspections, and the figures of papers.

Everything draws on matplotlib's `Axes` and returns them; nothing global is changed, and pyplot is
not used. Needs the `plot` extra (matplotlib); the figures of papers need the `derive` extra.

- `motion`: position, ratio and acceleration over one period, with extremes and rests;
- `pitch_curves`: the wheels in mesh at an angle of the carrier, to scale;
- `tolerance`: the range of a quantity within the tolerances of its sizes;
- `shares`: shares of accepted and rejected parts, exact and simulated;
- `figures`: the figures that a paper's folder defines, and files of them.

>>> from mechproof import EllipticPlanetary, plot
>>> position, ratio, acceleration = plot.motion(EllipticPlanetary.published(2))
>>> ratio.get_ylabel()
'ratio dφ₃/dφ₁'
"""

from mechproof.plot.figures import Figure
from mechproof.plot.motion_plot import motion, pitch_curves
from mechproof.plot.tolerance_plot import shares, tolerance

__all__ = ["Figure", "motion", "pitch_curves", "shares", "tolerance"]
