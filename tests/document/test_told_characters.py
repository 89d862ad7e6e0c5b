"""Characters of a paper: those read as other signs are reported once, as are look-alike letters.

Equations with such a letter are unread only if the paper also has the letter that it looks like.
"""

# ruff: noqa: RUF001
from __future__ import annotations

from mechproof.document.checking import CheckedPaper, check

READ = "not read"


def check_displays(*displays: str) -> CheckedPaper:
    return check("paper.md", "\n".join(f"$${one}$$" for one in displays))


def test_what_is_read_as_another_sign_is_told_once() -> None:
    found = check_displays("u−v=−v+u", "u−v=v−u+1", "u·v=v⋅u", "u≤u+1", r"\alpha+α^2=α+α²")
    assert [row.outcome for row in found.rows][:1] == ["PROVED"]
    ((place, reason),) = found.told
    assert (place.line, place.column) == (1, 4)
    signs = r"− (U+2212) as -, · (U+00B7) as \cdot, ⋅ (U+22C5) as \cdot, ≤ (U+2264) as \le"
    assert reason == f"read as other signs: {signs}"


def test_plain_signs_are_not_told() -> None:
    assert not check_displays("u-v=-v+u", r"α\le α+1").told


def test_words_in_displays_are_no_letters() -> None:
    assert not check_displays(r"F_{\mathrm{а}}=ku\quad\text{größer, для а}").told
    ((place, _),) = check_displays(r"F=\text{а}+а").told
    assert place.column == 14


def test_a_letter_alone_that_looks_like_another_is_told() -> None:
    found = check_displays("(а+b)^2=а^2+2аb+b^2", "(а+b)^2=а^2+2аb+b^3")
    assert found.rows[0].outcome == "PROVED"
    assert found.rows[1].outcome != "PROVED"
    ((place, reason),) = found.told
    assert place.line == 1
    assert reason == "letters that look like others: а (U+0430, cyrillic small letter a) like a"


def test_only_what_has_such_a_letter_is_not_read() -> None:
    found = check_displays(
        r"\lambda=\frac{r}{l}", r"\lambda=\frac{l}{r}", "a=2b", "(а+b)^2=b", "a=3b"
    )
    assert [row.outcome for row in found.rows] == [
        "DEFINITION",
        "REFUTED",
        "DEFINITION",
        READ,
        "REFUTED",
    ]


def test_what_is_not_read_may_define_the_letter_that_is_meant() -> None:
    found = check_displays("a=2b", "c=a+b", "а=b", "c=3b", "c=2b", "d=2c")
    outcomes = [row.outcome for row in found.rows]
    assert outcomes[2] == READ
    assert not {"PROVED", "REFUTED"} & {*outcomes[3:5]}
    assert "may redefine one of its letters" in found.rows[4].reason
