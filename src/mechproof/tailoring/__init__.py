"""Tailored kernels: in, a quantity, its parameters and an error; out, the cheapest loop for them.

`request` checks what is asked for, `design` guesses pieces and degrees, `build` finds coefficients,
`enclosure` proves the error of the program that `model` writes, `tailored` prints and loads it,
`receiving` reads one that was pickled.

Metalibm (Brunie et al. 2015) makes functions of a library for an interval and an accuracy so, with
bounds from Sollya. What differs is that any quantity of a paper is taken, its parameters put in.
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
        system.quantity, a number that depends on numbers alone.
    error : float
        The largest error permitted, absolute, in the unit of the quantity (rad, mm).
    derivations : path, optional
        The folder of derivations that has the system, whose kernels lie in `generated` beside it;
        left out: those of the package.
    arguments : float
        The parameters, by name. Of the running variable, the first argument of the quantity, the
        range as a pair (lowest, highest). Where the quantity repeats in it, the range may be left
        out: it is then symmetric about 0, up to a power of two, and as long as roundings take no
        more than a quarter of the error, 2**23 periods at most.

    Returns
    -------
    Tailored
        A function of the running variable that shows its proved bound, its degrees and its range.
        With numba (the extra fast) a compiled loop, else NumPy's operations. `write_c` writes it
        in C99, with the same bits as numba's where contractions are forbidden. It can be pickled,
        for processes that have the same extras.

    Raises
    ------
    TypeError, ValueError
        An argument is missing, unknown or outside of its domain; doubles do not reach the error on
        this range.
    ImportError
        The extra derive is not installed.

    Notes
    -----
    Polynomials of pieces, as few operations as such need; of each the lowest degree whose error,
    enclosed by ball arithmetic over the whole range, meets what is asked. The bound holds with and
    without fma.

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

    # Precision and length of series belong to the process.
    with BALLS:
        request = read_request(name, error, arguments, derivations)
        return make_kernel(request, build(request))
