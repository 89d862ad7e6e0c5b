"""Elementary functions in plain arithmetic, for compiled kernels.

The errors of their approximations are enclosed in balls over the whole interval.
Angles up to 67108864.0 rad are reduced here. Beyond that the C library's functions
are used if `exact` is true; if it is None the result is NaN.

Compiled with them: `compiled_support` fa39b2599650.

Regenerate with `mechproof regenerate`, which refuses to overwrite edits.
"""

import math as _math
from builtins import abs as _abs

import numpy as _np

from mechproof.compiled_support import (
    choose as _choose,
    copysign as _copysign,
    floor as _floor,
    fma as _fma,
    maximum as _maximum,
    power_of_two as _power_of_two,
    rint as _rint,
    scalar as _scalar,
)

__all__ = [
    "arctan",
    "arctan2",
    "arctan_quotient",
    "cos",
    "exp",
    "hypot",
    "minimum",
    "mod",
    "nonnegative",
    "normal_tail",
    "product_rest",
    "quotient_rest",
    "sign",
    "sin",
    "sinc",
    "small_arctan",
    "small_tangent",
    "sum_rest",
    "tan",
    "tangent_above",
    "tangent_below",
    "tangent_quotient",
    "total_rest",
]

_LARGEST = 67108864.0


# tan(r)/r in powers of r**2, |r| <= pi/4: the whole is off by at most 0.232 eps
@_scalar
def tan(y, _exact):
    """Return tan(y)."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = _fma(
        v2 * v3,
        _fma(v3, _fma(v3, -7.482425926557501e-06, 0.00280579332473998), -0.1282823491413398),
        v2,
    )
    v5 = _fma(
        v3,
        _fma(v3, _fma(v3, -0.00020843011349081395, 0.023344354149567717), -0.46161568247467066),
        1.0,
    )
    v6 = v1 * 0.5
    v7 = _rint(v6) == v6
    _value = _choose(v7, v4, -v5) / _choose(v7, v5, v4)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return _math.tan(y)


# tan(r)/r in powers of r**2, |r| <= pi/4: the whole is off by at most 0.232 eps
@_scalar
def tangent_quotient(y, c, a, r, b, _exact):
    """Return c*t/(a + r + b*t**2), t = tan(y), r being the rest of a."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = _fma(
        v2 * v3,
        _fma(v3, _fma(v3, -7.482425926557501e-06, 0.00280579332473998), -0.1282823491413398),
        v2,
    )
    v5 = _fma(
        v3,
        _fma(v3, _fma(v3, -0.00020843011349081395, 0.023344354149567717), -0.46161568247467066),
        1.0,
    )
    v6 = v1 * 0.5
    v7 = _rint(v6) == v6
    v8 = _choose(v7, v4, -v5)
    v9 = _choose(v7, v5, v4)
    v10 = c / a
    _value = (
        _fma(v10, v8, (_fma(-v10, a, c) - v10 * r) / a * v8) * v9 / _fma(v9, v9, b / a * v8 * v8)
    )
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    v1 = _math.tan(y)
    return c * v1 / (a + (r + b * v1 * v1))


# tan(r)/r in powers of r**2, |r| <= pi/4: the whole is off by at most 0.232 eps
@_scalar
def tangent_above(y, _exact):
    """Return tan(y) times what `tangent_below` returns."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = _fma(
        v2 * v3,
        _fma(v3, _fma(v3, -7.482425926557501e-06, 0.00280579332473998), -0.1282823491413398),
        v2,
    )
    v5 = _fma(
        v3,
        _fma(v3, _fma(v3, -0.00020843011349081395, 0.023344354149567717), -0.46161568247467066),
        1.0,
    )
    v6 = v1 * 0.5
    v7 = _rint(v6) == v6
    _value = _choose(v7, v4, -v5)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return _math.tan(y)


# tan(r)/r in powers of r**2, |r| <= pi/4: the whole is off by at most 0.232 eps
@_scalar
def tangent_below(y, _exact):
    """Return what tan(y) is to be multiplied by: it vanishes where cos(y) does."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = _fma(
        v2 * v3,
        _fma(v3, _fma(v3, -7.482425926557501e-06, 0.00280579332473998), -0.1282823491413398),
        v2,
    )
    v5 = _fma(
        v3,
        _fma(v3, _fma(v3, -0.00020843011349081395, 0.023344354149567717), -0.46161568247467066),
        1.0,
    )
    v6 = v1 * 0.5
    v7 = _rint(v6) == v6
    _value = _choose(v7, v5, v4)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return 1.0


# (sin(r)/r - 1)/r**2 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.104 eps
# (cos(r) - 1 + r**2/2)/r**4 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.006 eps
@_scalar
def sin(y, _exact):
    """Return sin(y)."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = v3 * 0.5
    v5 = 1.0 - v4
    v6 = v1 * 0.5
    v7 = _choose(
        _rint(v6) == v6,
        _fma(
            v2 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, 1.5918129027234826e-10, -2.505113184128889e-08),
                            2.7557316102534617e-06,
                        ),
                        -0.0001984126983675854,
                    ),
                    0.008333333333330948,
                ),
                -0.16666666666666666,
            ),
            v2,
        ),
        v5
        + _fma(
            v3 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, -1.1382632258093615e-11, 2.087614626607931e-09),
                            -2.7557317271718644e-07,
                        ),
                        2.4801587298765665e-05,
                    ),
                    -0.0013888888888887398,
                ),
                0.041666666666666664,
            ),
            1.0 - v5 - v4,
        ),
    )
    v8 = _floor(v6) * 0.5
    _value = _choose(_floor(v8) == v8, v7, -v7)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return _math.sin(y)


# (sin(r)/r - 1)/r**2 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.104 eps
# (cos(r) - 1 + r**2/2)/r**4 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.006 eps
@_scalar
def cos(y, _exact):
    """Return cos(y)."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = v3 * 0.5
    v5 = 1.0 - v4
    v6 = v1 * 0.5
    v7 = _choose(
        _rint(v6) == v6,
        v5
        + _fma(
            v3 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, -1.1382632258093615e-11, 2.087614626607931e-09),
                            -2.7557317271718644e-07,
                        ),
                        2.4801587298765665e-05,
                    ),
                    -0.0013888888888887398,
                ),
                0.041666666666666664,
            ),
            1.0 - v5 - v4,
        ),
        _fma(
            v2 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, 1.5918129027234826e-10, -2.505113184128889e-08),
                            2.7557316102534617e-06,
                        ),
                        -0.0001984126983675854,
                    ),
                    0.008333333333330948,
                ),
                -0.16666666666666666,
            ),
            v2,
        ),
    )
    v8 = _floor((v1 + 1.0) * 0.5) * 0.5
    _value = _choose(_floor(v8) == v8, v7, -v7)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return _math.cos(y)


# (atan(y)/y - 1)/y**2 in powers of y**2, |y| <= 1: the whole is off by at most 0.068 eps
@_scalar
def arctan(y):
    """Return atan(y)."""
    v1 = _abs(y)
    v2 = v1 > 1.0
    v3 = _choose(v2, 1.0 / v1, v1)
    v4 = v3 * v3
    v5 = v4 * v4
    v6 = _fma(
        v3 * v4,
        _fma(
            v5,
            _fma(
                v5,
                _fma(
                    v5,
                    _fma(
                        v5,
                        _fma(
                            v5,
                            _fma(
                                v5,
                                _fma(
                                    v5,
                                    _fma(
                                        v5,
                                        _fma(
                                            v5,
                                            _fma(
                                                v5,
                                                _fma(
                                                    v4,
                                                    7.767532298566822e-06,
                                                    -9.371091633560781e-05,
                                                ),
                                                _fma(
                                                    v4, 0.0005376794060869381, -0.001961242117363609
                                                ),
                                            ),
                                            _fma(v4, 0.005140885854032265, -0.010412113196030874),
                                        ),
                                        _fma(v4, 0.01718393672751917, -0.02419130675591347),
                                    ),
                                    _fma(v4, 0.030330692745374102, -0.03527131689273554),
                                ),
                                _fma(v4, 0.039386869439826874, -0.04330653645791128),
                            ),
                            _fma(v4, 0.04758080032858198, -0.05262492218979753),
                        ),
                        _fma(v4, 0.05882264415278073, -0.06666657934409811),
                    ),
                    _fma(v4, 0.07692307078814367, -0.09090909061934628),
                ),
                _fma(v4, 0.11111111110268276, -0.14285714285701234),
            ),
            _fma(v4, 0.1999999999999992, -0.3333333333333333),
        ),
        v3,
    )
    return _copysign(_choose(v2, 1.5707963267948966 - (v6 - 6.123233995736766e-17), v6), y)


# (atan(y)/y - 1)/y**2 in powers of y**2, |y| <= 1: the whole is off by at most 0.068 eps
@_scalar
def arctan_quotient(a, b):
    """Return atan(a/b)."""
    v1 = _abs(a)
    v2 = _abs(b)
    v3 = v1 > v2
    v4 = _choose(v3, v2, v1) / _choose(v3, v1, v2)
    v5 = v4 * v4
    v6 = v5 * v5
    v7 = _fma(
        v4 * v5,
        _fma(
            v6,
            _fma(
                v6,
                _fma(
                    v6,
                    _fma(
                        v6,
                        _fma(
                            v6,
                            _fma(
                                v6,
                                _fma(
                                    v6,
                                    _fma(
                                        v6,
                                        _fma(
                                            v6,
                                            _fma(
                                                v6,
                                                _fma(
                                                    v5,
                                                    7.767532298566822e-06,
                                                    -9.371091633560781e-05,
                                                ),
                                                _fma(
                                                    v5, 0.0005376794060869381, -0.001961242117363609
                                                ),
                                            ),
                                            _fma(v5, 0.005140885854032265, -0.010412113196030874),
                                        ),
                                        _fma(v5, 0.01718393672751917, -0.02419130675591347),
                                    ),
                                    _fma(v5, 0.030330692745374102, -0.03527131689273554),
                                ),
                                _fma(v5, 0.039386869439826874, -0.04330653645791128),
                            ),
                            _fma(v5, 0.04758080032858198, -0.05262492218979753),
                        ),
                        _fma(v5, 0.05882264415278073, -0.06666657934409811),
                    ),
                    _fma(v5, 0.07692307078814367, -0.09090909061934628),
                ),
                _fma(v5, 0.11111111110268276, -0.14285714285701234),
            ),
            _fma(v5, 0.1999999999999992, -0.3333333333333333),
        ),
        v4,
    )
    return _copysign(1.0, b) * _copysign(
        _choose(v3, 1.5707963267948966 - (v7 - 6.123233995736766e-17), v7), a
    )


# (atan(y)/y - 1)/y**2 in powers of y**2, |y| <= 1: the whole is off by at most 0.068 eps
@_scalar
def arctan2(a, b):
    """Return atan2(a, b)."""
    v1 = _abs(a)
    v2 = _abs(b)
    v3 = v1 > v2
    v4 = _choose(v3, v1, v2)
    v5 = _choose(v3, v2, v1) / _choose(v4 == 0.0, 1.0, v4)
    v6 = v5 * v5
    v7 = v6 * v6
    v8 = _fma(
        v5 * v6,
        _fma(
            v7,
            _fma(
                v7,
                _fma(
                    v7,
                    _fma(
                        v7,
                        _fma(
                            v7,
                            _fma(
                                v7,
                                _fma(
                                    v7,
                                    _fma(
                                        v7,
                                        _fma(
                                            v7,
                                            _fma(
                                                v7,
                                                _fma(
                                                    v6,
                                                    7.767532298566822e-06,
                                                    -9.371091633560781e-05,
                                                ),
                                                _fma(
                                                    v6, 0.0005376794060869381, -0.001961242117363609
                                                ),
                                            ),
                                            _fma(v6, 0.005140885854032265, -0.010412113196030874),
                                        ),
                                        _fma(v6, 0.01718393672751917, -0.02419130675591347),
                                    ),
                                    _fma(v6, 0.030330692745374102, -0.03527131689273554),
                                ),
                                _fma(v6, 0.039386869439826874, -0.04330653645791128),
                            ),
                            _fma(v6, 0.04758080032858198, -0.05262492218979753),
                        ),
                        _fma(v6, 0.05882264415278073, -0.06666657934409811),
                    ),
                    _fma(v6, 0.07692307078814367, -0.09090909061934628),
                ),
                _fma(v6, 0.11111111110268276, -0.14285714285701234),
            ),
            _fma(v6, 0.1999999999999992, -0.3333333333333333),
        ),
        v5,
    )
    v9 = _copysign(1.0, b) < 0.0
    return _copysign(
        _choose(v3, 1.5707963267948966, _choose(v9, 3.141592653589793, 0.0))
        + (
            _choose(v3, 6.123233995736766e-17, _choose(v9, 1.2246467991473532e-16, 0.0))
            + _choose(v3, _choose(v9, v8, -v8), _choose(v9, -v8, v8))
        ),
        a,
    )


# (atan(y)/y - 1)/y**2 in powers of y**2: the whole is off by at most 0.039 eps
@_scalar
def small_arctan(y):
    """Return atan(y) for |y| <= 1/sqrt(3)."""
    v1 = y * y
    v2 = v1 * v1
    return _fma(
        y * v1,
        _fma(
            v2,
            _fma(
                v2,
                _fma(
                    v2,
                    _fma(
                        v2,
                        _fma(
                            v2,
                            _fma(
                                v2,
                                _fma(v1, 0.004874344370582316, -0.016659150283803603),
                                _fma(v1, 0.029952645730746047, -0.0399373154528896),
                            ),
                            _fma(v1, 0.04672178312032516, -0.05246779764226303),
                        ),
                        _fma(v1, 0.05880212501481828, -0.06666469622709092),
                    ),
                    _fma(v1, 0.07692295286707518, -0.09090908582071015),
                ),
                _fma(v1, 0.11111111098553708, -0.14285714285551976),
            ),
            _fma(v1, 0.1999999999999917, -0.3333333333333333),
        ),
        y,
    )


@_scalar
def small_tangent(y):
    """Return tan(y) for y the half of a low word."""
    return _choose(y < -1.0, -1.0, _choose(y > 1.0, 1.0, y))


# (sinh(r)/r - 1)/r**2 in powers of r**2, |r| <= log(2)/2: the whole is off by at most 0.009 eps
# (cosh(r) - 1)/r**2 in powers of r**2, |r| <= log(2)/2: the whole is off by at most 0.056 eps
@_scalar
def exp(y):
    """Return exp(y).

    The first fma is exact, as for angles. The power of two is a product of two, of which the
    second alone rounds: where the result is subnormal.
    """
    v1 = _choose(y > 710.0, 710.0, _choose(y < -746.0, -746.0, y))
    v2 = _rint(v1 * 1.4426950408889634)
    v3 = _fma(v2, -2.3190468138462996e-17, _fma(v2, -0.6931471805599453, v1))
    v4 = v3 * v3
    v5 = _floor(v2 * 0.5)
    return (
        (
            1.0
            + _fma(
                v4,
                _fma(
                    v3,
                    _fma(
                        v4,
                        _fma(
                            v4,
                            _fma(
                                v4,
                                _fma(v4, 2.5100375924709717e-08, 2.7557268480116333e-06),
                                0.0001984126986304067,
                            ),
                            0.008333333333330065,
                        ),
                        0.16666666666666669,
                    ),
                    _fma(
                        v4,
                        _fma(
                            v4,
                            _fma(
                                v4,
                                _fma(v4, 2.762007599981065e-07, 2.4801521322116825e-05),
                                0.0013888888917196881,
                            ),
                            0.041666666666624164,
                        ),
                        0.5000000000000001,
                    ),
                ),
                v3,
            )
        )
        * _power_of_two(v5)
        * _power_of_two(v2 - v5)
    )


# (1 + x)*exp(x**2/2)*tail by (x - 6)/(x + 6), x <= 39: the whole is off by at most 0.194 eps
# (sinh(r)/r - 1)/r**2 in powers of r**2, |r| <= log(2)/2: the whole is off by at most 0.009 eps
# (cosh(r) - 1)/r**2 in powers of r**2, |r| <= log(2)/2: the whole is off by at most 0.056 eps
@_scalar
def normal_tail(y):
    """Return the mass of the standard normal law beyond |y|.

    The square of |y| is taken with the rest of its rounding: the tail is as exact far out.
    """
    v1 = _abs(y)
    v2 = _choose(v1 > 39.0, 39.0, v1)
    v3 = (v2 - 6.0) / (v2 + 6.0)
    v4 = v3 * v3
    v5 = _fma(
        v4,
        _fma(
            v4,
            _fma(
                v4,
                _fma(
                    v4,
                    _fma(
                        v4,
                        _fma(
                            v4,
                            _fma(
                                v4,
                                _fma(
                                    v4,
                                    _fma(
                                        v4,
                                        _fma(
                                            v4,
                                            _fma(
                                                v4,
                                                1.565901307919276e-09,
                                                _fma(
                                                    v3,
                                                    2.9330992736293062e-09,
                                                    -1.563563975580134e-08,
                                                ),
                                            ),
                                            _fma(
                                                v3, -1.9999357197391986e-08, 1.3237526176866645e-07
                                            ),
                                        ),
                                        _fma(v3, -4.649629632929167e-10, -9.99608288663403e-07),
                                    ),
                                    _fma(v3, 1.78383623414682e-06, 4.412420988465129e-06),
                                ),
                                _fma(v3, -2.6353403713200724e-05, 3.7794893704466745e-05),
                            ),
                            _fma(v3, 0.0001194896582852616, -0.0008689946633225784),
                        ),
                        _fma(v3, 0.002935655517518445, -0.007059819421462764),
                    ),
                    _fma(v3, 0.013246864154047862, -0.019766479219931785),
                ),
                _fma(v3, 0.022592467062781275, -0.01614151733219927),
            ),
            _fma(v3, -0.004373386779593186, 0.03981142456242986),
        ),
        _fma(v3, -0.08502536230577072, 0.45345520027112796),
    ) / (1.0 + v2)
    v6 = v2 * v2
    v7 = v6 * -0.5
    v8 = _choose(v7 > 710.0, 710.0, _choose(v7 < -746.0, -746.0, v7))
    v9 = _rint(v8 * 1.4426950408889634)
    v10 = _fma(v9, -2.3190468138462996e-17, _fma(v9, -0.6931471805599453, v8))
    v11 = v10 * v10
    v12 = _floor(v9 * 0.5)
    return (
        (
            1.0
            + _fma(
                v11,
                _fma(
                    v10,
                    _fma(
                        v11,
                        _fma(
                            v11,
                            _fma(
                                v11,
                                _fma(v11, 2.5100375924709717e-08, 2.7557268480116333e-06),
                                0.0001984126986304067,
                            ),
                            0.008333333333330065,
                        ),
                        0.16666666666666669,
                    ),
                    _fma(
                        v11,
                        _fma(
                            v11,
                            _fma(
                                v11,
                                _fma(v11, 2.762007599981065e-07, 2.4801521322116825e-05),
                                0.0013888888917196881,
                            ),
                            0.041666666666624164,
                        ),
                        0.5000000000000001,
                    ),
                ),
                v10,
            )
        )
        * _power_of_two(v12)
        * _power_of_two(v9 - v12)
        * _fma(_fma(v2, v2, -v6) * -0.5, v5, v5)
    )


@_scalar
def hypot(a, b):
    """Return sqrt(a**2 + b**2), scaled where squares would leave the range."""
    v1 = _abs(a)
    v2 = _abs(b)
    v3 = _choose(v1 > v2, v1, v2)
    v4 = _choose(
        v3 > 3.273390607896142e150,
        2.409919865102884e-181,
        _choose(v3 < 3.054936363499605e-151, 4.149515568880993e180, 1.0),
    )
    v5 = v1 * v4
    v6 = v2 * v4
    return _np.sqrt(_fma(v5, v5, v6 * v6)) / v4


@_scalar
def sign(y):
    """Return 1 for y > 0, -1 for y < 0, else y."""
    return _choose(y > 0.0, 1.0, _choose(y < 0.0, -1.0, y))


@_scalar
def minimum(a, b):
    """Return the smaller number, NaN if one is."""
    return -_maximum(-a, -b)


@_scalar
def mod(a, b):
    """Return a less a whole multiple of b, between 0 and b."""
    v1 = _np.fmod(a, b)
    return _choose(v1 * _copysign(1.0, b) < 0.0, v1 + b, v1)


# (sin(r)/r - 1)/r**2 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.104 eps
# (cos(r) - 1 + r**2/2)/r**4 in powers of r**2, |r| <= pi/4: the whole is off by at most 0.006 eps
@_scalar
def sinc(y, _exact):
    """Return sin(y)/y, 1 at 0."""
    v1 = _rint(y * 0.6366197723675814)
    v2 = _fma(
        v1,
        1.4973849048591698e-33,
        _fma(v1, -6.123233995736766e-17, _fma(v1, -1.5707963267948966, y)),
    )
    v3 = v2 * v2
    v4 = v3 * 0.5
    v5 = 1.0 - v4
    v6 = v1 * 0.5
    v7 = _choose(
        _rint(v6) == v6,
        _fma(
            v2 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, 1.5918129027234826e-10, -2.505113184128889e-08),
                            2.7557316102534617e-06,
                        ),
                        -0.0001984126983675854,
                    ),
                    0.008333333333330948,
                ),
                -0.16666666666666666,
            ),
            v2,
        ),
        v5
        + _fma(
            v3 * v3,
            _fma(
                v3,
                _fma(
                    v3,
                    _fma(
                        v3,
                        _fma(
                            v3,
                            _fma(v3, -1.1382632258093615e-11, 2.087614626607931e-09),
                            -2.7557317271718644e-07,
                        ),
                        2.4801587298765665e-05,
                    ),
                    -0.0013888888888887398,
                ),
                0.041666666666666664,
            ),
            1.0 - v5 - v4,
        ),
    )
    v8 = _floor(v6) * 0.5
    _value = _choose(y == 0.0, 1.0, _choose(_floor(v8) == v8, v7, -v7) / y)
    if _abs(y) <= _LARGEST:
        return _value
    if _exact is None:
        return _math.nan
    return _math.sin(y) / y


@_scalar
def product_rest(a, b, p):
    """Return a*b - p."""
    return _fma(a, b, -p)


@_scalar
def quotient_rest(a, b, q):
    """Return a/b - q."""
    return _fma(-q, b, a) / b


@_scalar
def sum_rest(a, b, s):
    """Return a + b - s."""
    return b - (s - a)


@_scalar
def total_rest(a, b, s):
    """Return a + b - s, whichever of both is larger."""
    v1 = s - a
    return a - (s - v1) + (b - v1)


@_scalar
def nonnegative(total, size):
    """Return a sum, 0 where it is negative by no more than terms of that size are rounded."""
    return _maximum(total, 0.0 - _maximum(-total - 8.881784197001252e-16 * size, 0.0))
