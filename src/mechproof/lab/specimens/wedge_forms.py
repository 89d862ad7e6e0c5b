"""The linkage as others compute it: hand-written NumPy, after the print and a little better."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from mechproof.lab.specimen import Array

# Of a central difference, mm or rad: its own error and that of rounding are alike.
STEP = 1e-4
Lever = Callable[[Array, Array, Array, Array], Array]
Roller = Callable[[Array, Array, Array], Array]


def fraction_of_1(x1: Array, l_ab: Array, l_bc: Array, l_cd: Array) -> tuple[Array, Array]:
    """Return what stands over and under the line of equation (1)."""
    q = np.sqrt(l_bc**4 + x1 * l_bc**2 * (2 * l_cd + 2 * l_ab + x1))
    over = -(x1 + l_ab) * q + l_cd * (l_bc**2 - q) + l_bc**2 * l_ab
    return over, l_bc * ((l_ab + l_cd) * (l_ab + l_cd + x1) + q)


def printed_lever(x1: Array, l_ab: Array, l_bc: Array, l_cd: Array) -> Array:
    """Compute equation (1) as printed."""
    over, under = fraction_of_1(x1, l_ab, l_bc, l_cd)
    return np.asarray(np.arctan(over / under))


def full_lever(x1: Array, l_ab: Array, l_bc: Array, l_cd: Array) -> Array:
    """Compute equation (1) with the arctangent of two arguments."""
    return np.asarray(np.arctan2(*fraction_of_1(x1, l_ab, l_bc, l_cd)))


def printed_roller(x5: Array, l_kl: Array, alpha_kl: Array) -> Array:
    """Choose between equations (7) and (8) as printed: R = 0 is in neither."""
    r = l_kl * np.cos(alpha_kl) - x5
    angle = np.arctan(np.sqrt(l_kl**2 - r**2) / r) - alpha_kl
    return np.asarray(np.select([r > 0, r < 0], [angle, np.pi + angle], np.nan))


def hasty_roller(x5: Array, l_kl: Array, alpha_kl: Array) -> Array:
    """Choose between (7) and (8) by one condition, as one writes it."""
    r = l_kl * np.cos(alpha_kl) - x5
    angle = np.arctan(np.sqrt(l_kl**2 - r**2) / r) - alpha_kl
    return np.asarray(np.where(r > 0, angle, np.pi + angle))


def full_roller(x5: Array, l_kl: Array, alpha_kl: Array) -> Array:
    """Compute (7) and (8) by the arctangent of two arguments."""
    r = l_kl * np.cos(alpha_kl) - x5
    return np.asarray(np.arctan2(np.sqrt(l_kl**2 - r**2), r) - alpha_kl)


def arccosine_roller(x5: Array, l_kl: Array, alpha_kl: Array) -> Array:
    """Compute (7) and (8) by the arccosine."""
    return np.asarray(np.arccos(np.cos(alpha_kl) - x5 / l_kl) - alpha_kl)


def chain_of(lever: Lever, roller: Roller) -> Callable[..., Array]:
    """Join the stages (1), (3), (4), (7)/(8) and (10)."""

    def compute(x1: Array, *sizes: Array) -> Array:
        l_ab, l_bc, l_cd, l_de, l_gh, l_kl, l_lm, alpha_de, alpha_kl, alpha_lm = sizes
        phi3 = lever(x1, l_ab, l_bc, l_cd)
        x5 = l_de * (np.cos(alpha_de + phi3) - np.cos(alpha_de))
        phi7 = roller(np.where(x5 < l_gh, 0, x5 - l_gh), l_kl, alpha_kl)
        return np.asarray(l_lm * (np.sin(phi7 + alpha_lm) - np.sin(alpha_lm)))

    return compute


printed_chain = chain_of(printed_lever, printed_roller)
full_chain = chain_of(full_lever, full_roller)


def stage_slopes(x1: Array, *sizes: Array) -> Array:
    """Multiply the slopes of the stages at the angles of the chain."""
    l_ab, l_bc, l_cd, l_de, l_gh, l_kl, l_lm, alpha_de, alpha_kl, alpha_lm = sizes
    phi3 = full_lever(x1, l_ab, l_bc, l_cd)
    x5 = l_de * (np.cos(alpha_de + phi3) - np.cos(alpha_de))
    phi7 = full_roller(np.maximum(x5 - l_gh, 0), l_kl, alpha_kl)
    guide = np.sqrt(l_bc**2 + x1 * (2 * (l_ab + l_cd) + x1))
    rod = l_de * np.sin(alpha_de + phi3) * np.cos(phi3) / guide
    wedge = l_lm * np.cos(alpha_lm + phi7) / (l_kl * np.sin(alpha_kl + phi7))
    return np.asarray(np.where(x5 < l_gh, 0, rod * wedge))


def difference(index: int, *arguments: Array) -> Array:
    """Take the central difference of the chain by one argument."""
    before, at, after = arguments[:index], arguments[index], arguments[index + 1 :]
    low, high = (full_chain(*before, at + step, *after) for step in (-STEP, STEP))
    return np.asarray((high - low) / (2 * STEP))


def speed_difference(*arguments: Array) -> Array:
    """Take the central difference by x1."""
    return difference(0, *arguments)


def size_differences(*arguments: Array) -> Array:
    """Take the central differences by all ten sizes."""
    columns = (difference(index, *arguments) for index in range(1, len(arguments)))
    return np.stack(np.broadcast_arrays(*columns), axis=-1)
