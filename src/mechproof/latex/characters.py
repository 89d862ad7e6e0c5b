"""Characters beyond ASCII -> the signs that they print like, or what to print instead of them.

A Greek letter becomes its command, a full-width or slanted letter the plain one, a raised or
lowered one a script. Letters of two alphabets that print alike cannot be told apart.
"""

# ruff: noqa: RUF001
from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Mapping

_GREEK = (
    *("alpha", "beta", "gamma", "delta", "varepsilon", "zeta", "eta", "theta", "iota", "kappa"),
    *("lambda", "mu", "nu", "xi", "", "pi", "rho", "varsigma", "sigma", "tau", "upsilon"),
    *("varphi", "chi", "psi", "omega"),
)
_CAPITALS = ("gamma", "delta", "theta", "lambda", "xi", "pi", "sigma", "varphi", "psi", "omega")
_LETTERS: Mapping[str, str] = {
    **{chr(0x3B1 + n): f"\\{name}" for n, name in enumerate(_GREEK) if name},
    **{
        chr(0x391 + n): rf"\{name.removeprefix('var').title()}"
        for n, name in enumerate(_GREEK)
        if name in _CAPITALS
    },
    **{"ϑ": r"\vartheta", "ϕ": r"\phi", "ϖ": r"\varpi", "ϰ": r"\varkappa", "ϱ": r"\varrho"},
    **{"ϵ": r"\epsilon", "µ": r"\mu", "\u2126": r"\Omega", "∆": r"\Delta", "ℓ": r"\ell"},
}
_SIGNS: Mapping[str, str] = {
    **_LETTERS,
    **{"−": "-", "×": r"\times", "·": r"\cdot", "⋅": r"\cdot", "∙": r"\cdot"},
    **{"±": r"\pm", "∓": r"\mp", "∞": r"\infty", "∑": r"\sum", "∏": r"\prod", "∫": r"\int"},
    **dict.fromkeys("≤⩽≦", r"\le"),
    **dict.fromkeys("≥⩾≧", r"\ge"),
    **{"≠": r"\ne", "≈": r"\approx", "≡": r"\equiv", "→": r"\to", "∈": r"\in", "∀": r"\forall"},
    **{"⌊": r"\lfloor", "⌋": r"\rfloor", "⌈": r"\lceil", "⌉": r"\rceil"},
    **{"′": "'", "∣": "|", "…": r"\dots", "⋯": r"\dots", "\u2044": "/", "\u2215": "/"},
}
# Names of the commands of Greek letters.
_NAMES = {*(command[1:] for command in _LETTERS.values()), "Upsilon"}
GREEK = frozenset(_NAMES | {f"var{name}" for name in _NAMES if name.istitle()})
# Characters that are copied in place of the right sign -> advice on what to print.
_INSTEAD: Mapping[str, str] = {
    **dict.fromkeys("‐‑‒–—―\u00ad⁃➖", "Print - for a minus."),
    **dict.fromkeys('’‘`´ʹʼˈ"”“', "Print ' for a prime."),
    **dict.fromkeys("º˚ª", "Print ° or ^\\circ for degrees."),
    **dict.fromkeys("√∛∜", r"Print \sqrt{…} or \sqrt[3]{…}."),
    **dict.fromkeys("÷∶", r"Print \frac{…}{…}."),
    "≔": "Print = for a definition.",
    **dict.fromkeys("•∗✕⨯✖∘", r"Print \cdot for a product."),
}
_KINDS = ("MATHEMATICAL ITALIC ", "FULLWIDTH ", "SMALL HYPHEN-MINUS", "PLANCK CONSTANT")
_ALPHABETS = ("LATIN ", "GREEK ", "CYRILLIC ", "CJK ")
_SCRIPTS = {"<super>": "^", "<sub>": "_"}
# Characters for which some fonts show one command and others another.
EITHER = "φε"
# Each letter -> the Latin (or Greek) one that it prints like.
_ALIKE = {
    **dict(
        zip(
            "аеорсухіјѕһԁԛԝӏАВЕКМНОРСТУХІЈЅЗГПФфßɑɡıΑΒΕΖΗΙΚΜΝΟΡΤΥΧο",
            "aeopcyxijshdqwlABEKMHOPCTYXIJS3ΓΠΦφβαgiABEZHIKMNOPTYXo",
            strict=True,
        )
    ),
    **{"φ": r"\phi", "ε": r"\epsilon"},
}


def spell(character: str) -> tuple[str, ...]:
    """Return the signs that a character prints like, or the character itself if none are known."""
    if character.isascii() or len(character) > 1:
        return (character,)
    if character in _SIGNS:
        return (_SIGNS[character],)
    if set(plain := unicodedata.normalize("NFKC", character)) == {"′"}:
        return ("'",) * len(plain)
    is_kind = unicodedata.name(character, "").startswith(_KINDS)
    if is_kind and plain != character and len(plain) == 1:
        return spell(plain)
    return (character,)


def read_script(character: str) -> tuple[str, str]:
    """Return "^" or "_", and the plain sign, for a raised or lowered character, else ("", "")."""
    if len(character) != 1:
        return "", ""
    kind, _, codes = unicodedata.decomposition(character).partition(" ")
    if kind not in _SCRIPTS or character in _INSTEAD or " " in codes:
        return "", ""
    return _SCRIPTS[kind], spell(chr(int(codes, 16)))[0]


def is_letter(text: str) -> bool:
    """Return whether a sign is one letter of an alphabet, not a styled or accented variant."""
    if text.isascii():
        return text.isalpha()
    return (
        len(text) == 1
        and unicodedata.name(text, "").startswith(_ALPHABETS)
        and unicodedata.category(text) in ("Ll", "Lu", "Lo")
        and unicodedata.normalize("NFKC", text) == text
        and not _has_accent(text)
    )


def is_digit(text: str) -> bool:
    """Return whether a sign is an ASCII digit, not a raised, circled or foreign one."""
    return text.isascii() and text.isdigit()


def name_character(text: str) -> str:
    """Return a sign as a message shows it; one beyond ASCII with its code point and name."""
    if len(text) > 1 or (text.isascii() and text.isprintable()):
        return text
    code = f"U+{ord(text[0]):04X}"
    name = unicodedata.name(text[0], "")
    shown = f"{text} " if text.isprintable() and not unicodedata.combining(text[0]) else ""
    return f"{shown}({code}, {name.lower()})" if name else f"the character {code}"


def advise(text: str) -> str:
    """Return advice on what to print instead of a sign, or "" if there is none."""
    if len(text) != 1:
        is_command = text.startswith("\\") and text[1:].isalpha()
        return (
            rf"If it is a macro, print its \newcommand{{{text}}} in the text." if is_command else ""
        )
    if text in _INSTEAD:
        return _INSTEAD[text]
    if unicodedata.combining(text) or _has_accent(text):
        return r"Print the accent with its command: \dot x."
    is_dressed = unicodedata.normalize("NFKC", text)[:1].isalnum()
    return "Print the plain sign, or its command." if is_dressed else ""


def find_alike(signs: Iterable[str], others: Iterable[str] = ()) -> tuple[str, str] | None:
    """Return two different letters that print alike: one from `signs`, the other from either.

    Returns None if only `others` contain the letter of another alphabet.
    """
    own = {*signs}
    met: dict[str, str] = {}
    for sign in sorted(own.union(others)):
        other = met.setdefault(_show_plain(sign), sign)
        if other != sign and not own.isdisjoint(x for x in (other, sign) if not x.isascii()):
            return other, sign
    return None


def _show_plain(sign: str) -> str:
    return spell(_ALIKE.get(sign, sign))[0]


def write_plain(text: str) -> str:
    """Return a text with each letter replaced by the Latin, or Greek, one that it prints like."""
    return "".join(_show_plain(sign) if sign in _ALIKE else sign for sign in text)


def find_replaced(text: str) -> dict[str, str]:
    r"""Return the characters of a text that are read as other signs: ≤ as \le.

    Greek letters and raised digits are left out: the former are read as their own commands, the
    latter as scripts.
    """
    others = (
        x for x in dict.fromkeys(text) if not unicodedata.name(x, "GREEK").startswith("GREEK")
    )
    return {x: " ".join(read) for x in others if (read := spell(x)) != (x,)}


def find_disguised(text: str) -> dict[str, str]:
    """Return each letter of a text that prints like one of another alphabet, with that letter."""
    return {x: _ALIKE[x] for x in dict.fromkeys(text) if x in _ALIKE and x not in EITHER}


def _has_accent(text: str) -> bool:
    """Return whether a Latin letter carries an accent, for which there is a command."""
    is_latin = unicodedata.name(text, "").startswith("LATIN ")
    return is_latin and len(unicodedata.normalize("NFD", text)) > 1
