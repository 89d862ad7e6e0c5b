"""Tolerance analysis of any vectorised function of named sizes.

A function is called as `function(inputs, **sizes)` with arrays that broadcast against each
other; it must work point by point. All ranges are given at every input:

- `corner_range`: smallest and largest value over all combinations of limits, and which
  combination gives them;
- `contributions`: first-order effect of every size, and `root_sum_square` of them;
- `monte_carlo_range`: the range of given probability for stated laws of the sizes.
"""

from mechproof.tolerance_corners import CornerRange, corner_range
from mechproof.tolerance_scatter import (
    Law,
    MonteCarloRange,
    Normal,
    TruncatedNormal,
    Uniform,
    monte_carlo_range,
)
from mechproof.tolerance_sensitivity import Contributions, contributions, root_sum_square
from mechproof.tolerance_sizes import Size

__all__ = [
    "Contributions",
    "CornerRange",
    "Law",
    "MonteCarloRange",
    "Normal",
    "Size",
    "TruncatedNormal",
    "Uniform",
    "contributions",
    "corner_range",
    "monte_carlo_range",
    "root_sum_square",
]
