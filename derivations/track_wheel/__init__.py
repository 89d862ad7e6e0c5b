"""Paper 5: the machining error of a wheel with a multi-period track.

Part one propagates the errors of machining, (1)-(7); part two turns and shifts the frame of
the part, (8)-(15); part three is the track and what the displacement does to it, (16)-(18),
Table 1 and the figures. Rows of `ours` are not printed in the paper.
"""

from collections.abc import Mapping

from sympy import Abs, Le, Rational

from mechproof.record import Paper

from .kernels import QUANTITIES
from .mechanics import *
from .rows import ROWS
from .rows.findings import FINDINGS
from .rows.table import TABLE_1

PURPOSE = "says what the method is for"
MOTIVE = "says why the subject matters, without a number"
SCHEME = "describes the gear or the set-up"
TEXTS: Mapping[str, tuple[str, ...]] = {
    "title, authors, keywords": ("S1", "S7"),
    MOTIVE: ("S2", "S11", "S12"),
    SCHEME: ("S8", "S9", "S10", "S50"),
    PURPOSE: ("S13", "S24"),
    "tells of the method, which the rows of its formulas judge": ("S4", "S14"),
    "a principle for any part, before a formula is given": ("S15",),
    "leads over to the matrices: blanks may be turned, too": ("S29",),
    "recommends the methods; costs are in none of the formulas": ("S68",),
}
ASIDE = {name: reason for reason, names in TEXTS.items() for name in names}


PAPER = Paper(
    system="track_wheel",
    citation="Kapitonov, Yakubovsky 2022, machining error of a wheel with a multi-period track",
    doi="10.24412/2079-7958-2022-1-43-52",
    variables=VARIABLES,
    notation=NOTATION,
    print=PRINT.file,
    rows=ROWS,
    transcription="2",
    sentences=68,
    aside=ASIDE,
    quantities=QUANTITIES,
    derivatives=True,
    published=(TABLE_1,),
    # Roughly the share of the total in Table 1, all K = 1.
    usual={thermal: Rational(11, 1000)},
    findings=FINDINGS,
    where=(Le(Abs(amplitude), radius),),
    conventions="Lengths in mm, angles in radians, turns counter-clockwise positive. The matrices "
    "give coordinates in the turned frame. Letters that the paper uses twice are kept apart: K "
    "(scatter coefficient) and the matrix K, A (amplitude) and the matrix A, z (number of "
    "periods) and the coordinate, varphi (polar angle) and the rotation vector.",
)
