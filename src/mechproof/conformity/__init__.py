"""Conformity of parts decided on a measured value: exact shares, risks and simulation.

A part has a true deviation Y; the gauge adds an independent error E. The part is accepted if the
measured value Y + E lies strictly between the acceptance limits, and conforms if Y lies strictly
between the tolerance limits (paper on tooth thickness, steps 2 and 9). The four shares of parts
(step 10) are, in the words of JCGM 106:2012,

- wrongly accepted: the global consumer's risk, the probability that a part does not conform and
  is accepted;
- wrongly rejected: the global producer's risk, the probability that a part conforms and is
  rejected;
- rightly accepted and rightly rejected: the remaining accepted and rejected parts.

The *specific* risks belong to one measured value: `conformance_probability`. A guard band is an
acceptance limit other than the tolerance limit. All shares are fractions of one.

`conformity.compiled.shares` is `shares` as one loop by numba; nothing else here needs numba.

The mechanisms, the laboratory and users may import it; it imports NumPy, and SciPy inside the
functions that need it.
"""

from mechproof.conformity.risks import (
    Shares,
    SimulatedShares,
    conformance_probability,
    shares,
    simulate_shares,
)
from mechproof.laws import Law, Normal, TruncatedNormal, Uniform

__all__ = [
    "Law",
    "Normal",
    "Shares",
    "SimulatedShares",
    "TruncatedNormal",
    "Uniform",
    "conformance_probability",
    "shares",
    "simulate_shares",
]
