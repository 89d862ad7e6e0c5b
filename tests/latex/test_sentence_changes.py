"""A correction's changes to a sentence are marked word by word, and in its formulas too."""

from __future__ import annotations

import pytest

from mechproof.latex.changes import Style
from mechproof.latex.sentence_changes import mark_sentences

TAKEN = Style("⟦{}⟧".format, "⟧{}⟦".format)
PUT = Style("⟪{}⟫".format, "⟫{}⟪".format)

CHANGES = [
    # The print, its correction, and both with their marks.
    (
        r"\text{the interval of the errors is }\bar q\pm2u",
        r"\text{the interval of the mean of the errors is }\bar q\pm2u",
        r"\text{the interval of the errors is }\bar q\pm2u",
        r"\text{the interval }⟪\text{of the mean }⟫\text{of the errors is }\bar q\pm2u",
    ),
    (
        r"\text{grades 6 and 7 can be recommended, and not 8}",
        r"\text{grades 7 and 8 can be recommended}",
        r"\text{grades }⟦\text{6 }⟧\text{and }⟦\text{7 }⟧\text{can be recommended}"
        r"⟦\text{, and not 8}⟧",
        r"\text{grades }⟪\text{7 }⟫\text{and }⟪\text{8 }⟫\text{can be recommended}",
    ),
    (
        r"\text{good: }E-T<x<E",
        r"\text{good: }-E-T<x<-E",
        r"\text{good: }E-T<x<E",
        r"\text{good: }⟪-⟫E-T<x<⟪-⟫E",
    ),
    (
        r"0.68\pm0.28^\circ",
        r"0.68\pm0.56^\circ\text{, or less}",
        r"0.68\pm0.⟦28^{\circ}⟧",
        r"0.68\pm0.⟪56^{\circ}⟫⟪\text{, or less}⟫",
    ),
]


@pytest.mark.parametrize(("printed", "mend", "left", "right"), CHANGES)
def test_changes_are_marked_in_both(printed: str, mend: str, left: str, right: str) -> None:
    assert mark_sentences(printed, mend, TAKEN, PUT) == (left, right)


@pytest.mark.parametrize(
    "mend", [r"K=CBA", r"\text{something else altogether}", r"\text{the product of }x"]
)
def test_what_has_little_in_common_stays_as_it_is(mend: str) -> None:
    pair = (r"\text{the matrix may be represented by the product of the matrices }A,B,C", mend)
    assert mark_sentences(*pair, TAKEN, PUT) == pair


def test_what_is_the_same_has_no_marks() -> None:
    same = r"\text{the product of }A,B\text{ and }C"
    assert mark_sentences(same, same, TAKEN, PUT) == (same, same)
