"""Where an expression has a value: what of it is not shown on a domain."""

from __future__ import annotations

import sympy as sp

from mechproof.proof.domain import Domain
from mechproof.proof.signs import find_sign
from mechproof.record import list_needs, list_partial


def list_unshown(expression: sp.Basic, domain: Domain) -> list[str]:
    """List what roots, logarithms and so on need to have values, as far as it is not shown."""
    found: dict[str, None] = {}
    for node in list_partial(domain.resolve(expression)):
        for needed, strict in list_needs(node):
            sign = find_sign(needed, domain)
            if sign is None or sign.direction < 0 or (strict and not sign.strict):
                found[f"{needed} {'>' if strict else '>='} 0"] = None
    return list(found)
