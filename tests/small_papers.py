"""Papers of a few lines, with their letters declared."""

from __future__ import annotations

from mechproof.document.checked_rows import CheckedRow
from mechproof.document.checking import CheckedPaper, check
from mechproof.document.drafts.draft import draft_block
from mechproof.sources.paper_files import read_source

LETTERS = r"""%% mechproof
%% r ; l : crank and rod [mm] {r>0}
%% \lambda : their ratio [1]
%% x(t) : position [mm]
%% \varphi(t) : angle of the crank [rad]
%% s(\psi) : lift [mm]
%% \psi : angle of the cam [rad]
%% a ; b ; c ; h : lengths of the links [mm] {a>0}
%% \alpha ; \beta ; \gamma : angles [rad]
%% k ; m ; n ; u : numbers
%% \sigma : branch
%% R 2x2 : rotation
%% Q(\alpha) 2x2 : shear
%% factor a, \dot\varphi
%% branch \sigma=\pm1
"""


def paper(*equations: str, block: str = "") -> str:
    lines = "".join(f"\\begin{{equation}}{latex}\\end{{equation}}\n" for latex in equations)
    return f"{LETTERS}{block}%% end\n{lines}"


def outcomes(*equations: str, block: str = "") -> list[str]:
    return [row.outcome for row in run(*equations, block=block).rows]


def run(*equations: str, block: str = "") -> CheckedPaper:
    return check("paper.tex", paper(*equations, block=block))


def draft(text: str, name: str = "paper.tex") -> str:
    return draft_block(read_source(name, text))


def judge_rows(block: str, *parts: str) -> tuple[CheckedRow, ...]:
    """Return the rows of the displays in `parts`; a part starting with # is text between them."""
    shown = (
        f"{part[1:]}\n" if part.startswith("#") else f"\\begin{{equation}}{part}\\end{{equation}}\n"
        for part in parts
    )
    return check("paper.tex", block + "".join(shown)).rows


def judge_parts(block: str, *parts: str) -> list[str]:
    """Return the outcomes of `judge_rows`."""
    return [row.outcome for row in judge_rows(block, *parts)]


ROD = r"x=r\cos\varphi"
