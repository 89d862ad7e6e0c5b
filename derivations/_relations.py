"""Relations of numbers that the ladder is to decide: SymPy is kept from deciding them by itself."""

from sympy import Expr, Le, Lt

from mechproof.record import Holds


def less(left: Expr, right: Expr) -> Holds:
    """State left < right."""
    return Holds(Lt(left, right, evaluate=False))


def not_above(left: Expr, right: Expr) -> Holds:
    """State left <= right."""
    return Holds(Le(left, right, evaluate=False))
