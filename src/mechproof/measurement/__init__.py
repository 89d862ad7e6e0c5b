"""Measured positions, evaluated as in the GUM (JCGM 100).

Type A evaluation of readings, type B parts, the combined standard uncertainty with its
effective degrees of freedom, coverage intervals, the propagation of uncertainties through any
function, the fit of a mechanism to readings, and the two usual ways to print a result:

>>> result = Estimate(0.68, 0.28, degrees_of_freedom=191, unit="°")
>>> print(result)
0.68(28)°
>>> print(result.expand(2))
0.68° ± 0.56° (k = 2)

Any code with readings may import it; it imports NumPy and the kernels, and SciPy inside the
functions that need it.
"""

from mechproof.measurement.estimate import CoverageInterval, Estimate
from mechproof.measurement.fit import Fit, fit
from mechproof.measurement.propagation import Propagation, propagate, to_ufloat
from mechproof.measurement.uncertainty import (
    Mechanism,
    TypeA,
    TypeB,
    combine,
    evaluate_position_errors,
    evaluate_type_a,
    position_errors,
    wrap_angle,
)

__all__ = [
    "CoverageInterval",
    "Estimate",
    "Fit",
    "Mechanism",
    "Propagation",
    "TypeA",
    "TypeB",
    "combine",
    "evaluate_position_errors",
    "evaluate_type_a",
    "fit",
    "position_errors",
    "propagate",
    "to_ufloat",
    "wrap_angle",
]
