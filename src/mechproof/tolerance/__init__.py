"""Tolerance analysis of any vectorised function of named sizes.

A function is called as `function(inputs, **sizes)` with arrays that broadcast against each
other; it must work point by point. All ranges are given at every input:

- `corner_range`: smallest and largest value over all combinations of limits, and which
  combination gives them;
- `contributions`: first-order effect of every size, and `root_sum_square` of them;
- `monte_carlo_range`: the range of given probability for stated laws of the sizes, which a `Size`
  makes from its limits (`Size.uniform`, `Size.normal`, `Size.truncated_normal`);
- `certified_range`: proved bounds of a derived quantity over the whole box of limits;
- `allocate_tolerances`: the inverse, tolerances that keep a quantity within a wanted width.

The ranges take any executor of `concurrent.futures`; no result depends on it.

The mechanisms and users may import it; it imports NumPy, and the layers of the `derive` extra
inside `certified_range`.
"""

from mechproof.laws import Law, Normal, TruncatedNormal, Uniform
from mechproof.tolerance.certified import CertifiedRange, certified_range
from mechproof.tolerance.corners import CornerRange, corner_range
from mechproof.tolerance.scatter import MonteCarloRange, Scatter, monte_carlo_range
from mechproof.tolerance.sensitivity import (
    Allocation,
    Contributions,
    allocate_tolerances,
    contributions,
    root_sum_square,
)
from mechproof.tolerance.sizes import Size

__all__ = [
    "Allocation",
    "CertifiedRange",
    "Contributions",
    "CornerRange",
    "Law",
    "MonteCarloRange",
    "Normal",
    "Scatter",
    "Size",
    "TruncatedNormal",
    "Uniform",
    "allocate_tolerances",
    "certified_range",
    "contributions",
    "corner_range",
    "monte_carlo_range",
    "root_sum_square",
]
