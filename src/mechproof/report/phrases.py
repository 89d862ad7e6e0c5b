"""Wording: how a verdict is named and shown to a reader, and how the text of evidence is set."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from markupsafe import Markup, escape

from mechproof.proof.verdict import MEANINGS, State, Verdict


@dataclass(frozen=True)
class VerdictStyle:
    """A verdict for a reader: a word, a sign to go with its colour, and its meaning."""

    key: str
    word: str
    sign: str
    meaning: str


# The key of a style, a word and a sign for each verdict, in the order in which reports count them.
_SHOWN = (
    (Verdict.REFUTED, "refuted", "refuted", "✗"),
    (Verdict.ILL_FORMED, "ill-formed", "ill-formed", "∅"),
    (Verdict.UNDECIDED, "undecided", "undecided", "?"),
    (Verdict.UNDERDETERMINED, "underdetermined", "underdetermined", "…"),
    (Verdict.NOT_CHECKABLE, "not-checkable", "not checkable", "⊘"),
    (Verdict.CONDITIONAL, "conditional", "true in part", "◐"),
    (Verdict.CONVENTION, "convention", "convention", "⇄"),
    (Verdict.ENCLOSED, "enclosed", "enclosed", "≈"),
    (Verdict.PROVED, "proved", "proved", "✓"),
    (Verdict.DEFINITION, "definition", "definition", "≔"),
)
LOOKS: Mapping[str, VerdictStyle] = {
    verdict: VerdictStyle(key, word, sign, MEANINGS[verdict]) for verdict, key, word, sign in _SHOWN
}
MEASURED = VerdictStyle(
    "measured", "measured", "∿", "nothing is proved about this code; it is measured"
)
NOT_JUDGED = VerdictStyle(
    "failed", "not judged", "!", "the row could not be judged; the failure is shown"
)
LEFT: Mapping[State, VerdictStyle] = {
    state: VerdictStyle("undecided", state.value, "!", meaning)
    for state, meaning in (
        (State.NOT_READ, "the print could not be read; the reason and what would help are shown"),
        (State.NOT_JUDGED, "it was read but could not be judged, for the reason shown"),
        (State.SKIPPED, "the block of letters excludes it from judgement"),
    )
}

# A minus sign of a number or a term: it follows no letter, digit or bracket, and is not an
# option's.
SIGNED = re.compile(r"(?<![\w)\]\-.^])-(?=[\w.(|])")
MINUS = " \N{MINUS SIGN} "
BALL = re.compile(r"\[([^\[\]]+?) \+/- ([^\[\]]+?)\]")
EXPONENT = re.compile(r"(?<=[\w)\]])\*\*(-?\d+)\b")
POWER = re.compile(r"(\d)e([+-]?\d+)\b")
RAISED_NAME = re.compile(r"(?<=[\w)])(?:\*\*|\^)([A-Za-z]+[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*)(?![A-Za-z0-9_])")
GREEK = {
    name: unicodedata.lookup(f"GREEK {case} LETTER {name.upper().replace('LAMBDA', 'LAMDA')}")
    for case, names in (
        ("SMALL", "alpha beta gamma delta epsilon eta theta kappa lambda mu nu rho sigma tau phi "
         "chi psi omega pi"),
        ("CAPITAL", "Gamma Delta Theta Sigma Phi Psi Omega"),
    )
    for name in names.split()
} | {"varphi": "φ", "varepsilon": "ε"}  # fmt: skip
RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
SUPERSCRIPTS = str.maketrans("-0123456789", RAISED)
# Matches a Greek letter by its name, or a letter with an index, which ends before a power.
SIGN = rf"[^\W{RAISED}]"
NAME = re.compile(
    rf"(?<![\w&#.])(d(?=(?:{'|'.join(GREEK)}|[^\W\d_])\d))?(?:({'|'.join(GREEK)}|[^\W\d_](?=_\w|\d(?!{SIGN})))(?:_({SIGN}+)|(\d+))?)(?!{SIGN})"
)


def _raise(power: re.Match[str]) -> str:
    return power[1].translate(SUPERSCRIPTS)


# Accents of letters as they are typed in a paper's source.
ACCENTS = {
    name: unicodedata.lookup(f"COMBINING {mark}")
    for name, mark in (
        *(("dot", "DOT ABOVE"), ("ddot", "DIAERESIS"), ("hat", "CIRCUMFLEX ACCENT")),
        *(("bar", "OVERLINE"), ("tilde", "TILDE"), ("vec", "RIGHT ARROW ABOVE")),
    )
}
ACCENTED = re.compile(rf"\\({'|'.join(ACCENTS)})\{{\\?([A-Za-z]+)\}}")
MACRO = re.compile(rf"\\(?=(?:{'|'.join(GREEK)})(?![A-Za-z]))")
BRACED = re.compile(r"_\{(\w+)\}")
# What is typed within a sentence and how it is set, applied in this order.
SET: tuple[tuple[re.Pattern[str], str | Callable[[re.Match[str]], str]], ...] = tuple(
    (re.compile(pattern), written)
    for pattern, written in (
        # A member of a family: K_i[2] is set K_2.
        (r"\b([A-Z])_[a-z]\[(\w+)\]", r"\1_\2"),
        (r"(?<=[\w)])\^(-?\d+)\b", _raise),
        (r"(?<=\d )um\b", "\N{MICRO SIGN}m"),
        (rf"(?<=[\w)\]{''.join(ACCENTS.values())}]) ?\* ?(?=[\w(|])", "\N{MIDDLE DOT}"),
        (r"(?<=\d) deg\b", "\N{DEGREE SIGN}"),
        (r"\bM(ax|in)\(", r"m\1("),
        (r"\bAbs\(([^()|]+)\)", r"|\1|"),
        (r"\bd (?=(?:phi|φ)_?\d)", "d"),
        (r"\bsqrt\((\w+)\)|\bsqrt(?=\()", r"√\1"),
        (r"(?<=\))-(?=\()", "\N{EN DASH}"),
        # Straight quotes around and in words; after a number it is a prime.
        (r"(?<=[A-Za-z])'(?=[a-z])", "\N{RIGHT SINGLE QUOTATION MARK}"),
        (r'"([^"]+)"', "\N{LEFT DOUBLE QUOTATION MARK}\\1\N{RIGHT DOUBLE QUOTATION MARK}"),
        (
            r"(?<![\w)])'(?=[\w(])([^']*[\w).%?])'(?!\w)",
            "\N{LEFT SINGLE QUOTATION MARK}\\1\N{RIGHT SINGLE QUOTATION MARK}",
        ),
        (r"(?<=\d)'(?![\w'])", "\N{PRIME}"),
        # Tied, so that a line begins neither with an equals sign nor with the value after it.
        (
            r"(?<![^\s(])([^\W\d]\w{0,4}) = (?=[\w\N{MINUS SIGN}.]{1,8}(?:[\s,;:.)]|$))",
            "\\1\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}",
        ),
        # Tied, so that a line begins neither with the sign of a relation, a sum or a product nor
        # with an index.
        (r"(?<=[\w)\]|²³°]) (?=(?:[=<>≤≥≈+·±]|\N{MINUS SIGN}) )", "\N{NO-BREAK SPACE}"),
        (r"(?<=_\w) (?=[^\W\d_]+_\w)", "\N{NO-BREAK SPACE}"),
        (r"(?<=[ (]\d) (?=[^\W\d_Aa]\b)", "\N{NO-BREAK SPACE}"),
        # Tied, so that a line begins neither with the unit of a number nor with a function's
        # argument.
        (r"(?<=\d) (?=%|(?:mm|µm|rad|eps|ns|sigma)\b)", "\N{NO-BREAK SPACE}"),
        (r"\b(tg|sin|cos) (?=\d)", "\\1\N{NO-BREAK SPACE}"),
    )
)


def look_of(verdict: str) -> VerdictStyle:
    """Return how a verdict is shown; anything measured is shown as a verdict of its own."""
    return LOOKS.get(verdict, MEASURED)


def set_numbers(text: str) -> str:
    """Set balls and powers as people write them: [1.5 +/- 2e-9] is 1.5 ± 2·10⁻⁹."""
    apart = BALL.sub(r"\1 ± \2", text).replace("<=", "≤").replace(">=", "≥").replace(" - ", MINUS)
    raised = POWER.sub(_raise_ten, EXPONENT.sub(_raise, apart))
    return SIGNED.sub("\N{MINUS SIGN}", raised)


def _raise_ten(power: re.Match[str]) -> str:
    """Set a power of ten, leaving out a factor that is the digit one alone."""
    before = power.string[power.start() - 1 : power.start()]
    alone = power[1] == "1" and not (before.isdigit() or before == ".")
    factor = "" if alone else f"{power[1]}·"
    return f"{factor}10{str(int(power[2])).translate(SUPERSCRIPTS)}"


def set_prose(text: str) -> Markup:
    """Set the names within a sentence as formulas have them: x_5 with an index, phi1 as a letter.

    The text is escaped first.
    """
    plain = set_numbers(_set_letters(text).replace("+-", "±"))
    for pattern, written in SET:
        plain = pattern.sub(written, plain)
    raised = RAISED_NAME.sub(r"<sup>\1</sup>", str(escape(plain)))
    return Markup(NAME.sub(_set_name, raised))


def _set_letters(text: str) -> str:
    r"""Replace letters of LaTeX by their characters: \dot{\beta} is a letter with a dot."""
    signs = ACCENTED.sub(lambda one: GREEK.get(one[2], one[2]) + ACCENTS[one[1]], text)
    return BRACED.sub(r"_\1", MACRO.sub("", signs))


def _set_name(name: re.Match[str]) -> str:
    index = name[3] or name[4] or ""
    letter, index = GREEK.get(name[2], name[2]), GREEK.get(index, index)
    return f"{name[1] or ''}{letter}<sub>{index}</sub>" if index else letter


def set_reason(text: str) -> Markup:
    """Set a reason as a sentence with a capital, unless it begins with a letter of a formula."""
    is_word = re.match(r"[a-z]{2,}(?=[ .;]|$)|a (?=[a-z]{2})", text)
    begun = text[:1].upper() + text[1:] if is_word else text
    return set_prose(begun if begun.endswith((".", "?", "!")) or not begun else f"{begun}.")


def set_value(text: str) -> str:
    """Set a coordinate of a point: as a number, with pi as its letter."""
    return set_numbers(re.sub(r"\bpi\b", "π", text)).replace("*", "·")
