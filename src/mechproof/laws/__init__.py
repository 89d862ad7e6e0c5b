"""Probability laws: of a part's deviation, of a measurement error, of a size between its limits.

A law is chosen, never assumed: the papers print no law, only a ratio of a tolerance field or of
an interval of uncertainty to the standard deviation (`Normal.from_width`). Parameters are
array-likes that broadcast against each other and against the argument of every method.

Every package of the runtime may import it; it imports NumPy, and SciPy inside the functions that
need it.
"""

from mechproof.laws.kinds import Law, Normal, TruncatedNormal, Uniform

__all__ = ["Law", "Normal", "TruncatedNormal", "Uniform"]
