"""Tailored kernels: in, a quantity, its parameters and an error; out, the cheapest loop for them.

`request` checks the request, `design` guesses pieces and degrees, `build` finds coefficients,
`enclosure` proves the error of the program that `model` writes, `tailored` prints and loads it,
`receiving` reads a pickled kernel.

Metalibm (Brunie et al. 2015) likewise makes library functions for an interval and an accuracy, with
bounds from Sollya. Here, any quantity of a paper can be used, with its parameters substituted.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from mechproof.executors import BALLS
from mechproof.tailoring.receiving import NEEDED
from mechproof.tools.extras import require_modules

if TYPE_CHECKING:
    from mechproof.tailoring.tailored import Tailored

__all__ = ["tailor"]


def tailor(
    name: str,
    *,
    error: float,
    derivations: str | os.PathLike[str] | None = None,
    **arguments: Any,
) -> Tailored:
    """Return a kernel for fixed parameters and a stated error.

    Parameters
    ----------
    name : str
        system.quantity, a scalar function of scalars.
    error : float
        Largest absolute error permitted, in the unit of the quantity (rad, mm).
    derivations : path, optional
        The folder of derivations that has the system, with its kernels in the folder `generated`
        next to it; by default, the package's derivations and kernels.
    arguments : float
        The parameters by name, and the range of the running variable (the first argument of the
        quantity) as a pair (lowest, highest). If the quantity repeats, the range may be left out:
        it is then symmetric about 0, up to a power of two, and as long as rounding takes no more
        than a quarter of the error, at most 2**23 periods.

    Returns
    -------
    Tailored
        A function of the running variable that shows its proved bound, degrees and range. It is a
        compiled loop with numba (the extra fast), and uses NumPy otherwise. `write_c` writes it in
        C99, with the same bits as numba if contractions are forbidden. It can be pickled for
        processes with the same extras.

    Raises
    ------
    TypeError, ValueError
        If an argument is missing, unknown or outside its domain, or doubles cannot reach the error
        on this range.
    ImportError
        If the extra derive is not installed.

    Notes
    -----
    The kernel evaluates piecewise polynomials with as few operations as these need. Each has the
    lowest degree whose error, enclosed by ball arithmetic over the whole range, meets the request.
    The bound holds with and without fma.

    >>> import mechproof
    >>> sizes = {"R1": 66, "R2": 16, "e": 0.475}
    >>> position = mechproof.tailor("elliptic_planetary.position", error=1e-9, **sizes)
    >>> position.bound <= 1e-9, position.degrees
    (True, (23, 23))
    >>> print(f"{position(50.0):.9f}")
    255.260270569

    """
    require_modules("mechproof.tailor", "derive", NEEDED)
    from mechproof.tailoring.build import build
    from mechproof.tailoring.request import read_request
    from mechproof.tailoring.tailored import make_kernel

    # Precision and series length are global to the process.
    with BALLS:
        request = read_request(name, error, arguments, derivations)
        return make_kernel(request, build(request))
