"""Rows of paper 4 on the structure of its mechanism: elements, links, groups."""

from __future__ import annotations

import sympy as sp

from mechproof.record import Claim, Datum, Definition, Equality

from .symbols import elements

GROUPS, LINKS_OF_GROUP, PAIRS_OF_GROUP = 4, 2, 3


def mobility(links: int, pairs: int) -> sp.Integer:
    """Degrees of freedom of a plane linkage with lower pairs only (Chebyshev)."""
    return sp.Integer(3 * links - 2 * pairs)


STRUCTURE_ROWS = (
    Datum(
        "five elements",
        r"\text{pusher, accelerating lever, rod, lever with rollers, wedge: 5 elements}",
        Definition(elements, sp.Integer(5)),
        note="Of Fig. 1.",
    ),
    Claim(
        "links 1 to 9",
        r"\text{links }1\text{ to }9\text{: the pusher and four Assur groups}",
        Equality(sp.Integer(9), sp.Integer(1 + GROUPS * LINKS_OF_GROUP)),
        note="Of Fig. 2, a group having two links and three lower pairs. The link 5', behind the "
        "clearance, is counted with the rod 5.",
        marks=("inferred",),
    ),
    Claim(
        "Assur groups, zero mobility",
        r"W=3\cdot2-2\cdot3=0",
        Equality(sp.S.Zero, mobility(LINKS_OF_GROUP, PAIRS_OF_GROUP)),
        note="What makes two links with three lower pairs a group of Assur.",
        marks=("ours", "inferred"),
    ),
    Claim(
        "linkage, mobility",
        r"W=3\cdot9-2(1+4\cdot3)=1",
        Equality(
            sp.S.One,
            mobility(1 + GROUPS * LINKS_OF_GROUP, 1 + GROUPS * PAIRS_OF_GROUP),
        ),
        note="In contact: the pusher's guide and four groups, one input. Before contact the link "
        "5' is a tenth link in a guide of its own, and W = 3*10 - 2*14 = 2.",
        marks=("ours", "inferred"),
    ),
)
