"""What words before a display announce: another case, a special one, another sense of counting.

Words are matched, not understood. Prose that announces no consequence may lead to anything.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

# Words that may tell of another case, and how far before a display they are looked for.
_ALTERNATIVE = re.compile(
    r"\b(?:or|oder|ou|или|other|otherwise|second|another|alternative(?:ly)?|respectively|elbow|"
    r"solutions?|roots?|branch(?:es)?|cases?|configurations?|if|when|for|else)\b",
    re.IGNORECASE,
)
_NEAR = 200
# What holds nearly, or for some motions only.
_SPECIAL = re.compile(
    r"\b(?:neglect|small|approximat|lineari[sz]|first[- ]order|uniform|constant)"
    r"|\b(?:cases?|if|when)\b"
    r"|vernachl\xe4ssig|\b(?:klein|konstant|gleichf\xf6rmig)|n\xe9glige|\b(?:petit|constant)"
    r"|пренебрег|\b(?:мал|постоянн|равномерн)",
    re.IGNORECASE,
)
# What turns the sense in which something is counted, from there on: mostly counter-clockwise. A
# sentence that goes on with "where" behind a display says what letters meant all along.
_TURNING = re.compile(
    r"(?<!counter)(?<!anti)(?<!counter-)(?<!anti-)clockwise|counter-?rotat|opposed|crossed|mirror"
    r"|revers(?:e|al|ing)|redefin|backwards|downwards|\b(?:left|right)-hand|\bsign convention"
    r"|\b(?:opposite|negative|other|contrary)(?:\s+\w+)?\s+(?:direction|sense|sign|way|side)"
    r"|\bnow\s+(?:\w+\s+)?(?:counted|measured|reckoned|taken)\b"
    r"|\b(?:interchang|exchang|swapp)|\bfrom (?:now|here) on\b|\b(?:henceforth|hereafter)\b"
    r"|(?<!gegen den )uhrzeigersinn|entgegengesetzt|umgekehrt|\b(?:von nun an|ab jetzt)\b"
    r"|\bsens (?:horaire|inverse|contraire|oppos\xe9)|\bd\xe9sormais\b"
    r"|(?<!против )часовой|противополож|обратн|\b(?:теперь|впредь)\b",
    re.IGNORECASE,
)
_WHERE = re.compile(r"[\s.,;]*(?:where|in which|wobei|o\xf9|где)\b[^.;]*", re.IGNORECASE)
# What tells that a display follows from those before it, or says the same.
_CONSEQUENCE = re.compile(
    r"\b(?:hence|therefore|thus|so|this|which|these|consequently|accordingly|again|that is|i\.e"
    r"|namely|the same|(?:is|be) written|daher|folglich|somit|damit|also|daraus|donc|ainsi|soit"
    r"|следовательно|тогда|отсюда)\b"
    r"|\b(?:substitut|insert|eliminat|combin|solv|follow|obtain|simplif|expan|rearrang|transform"
    r"|rewrit|equivalent|identical|squar|einsetz|folgt|d'o\xf9|получ|подстав)",
    re.IGNORECASE,
)
_NO_PROSE = re.compile(
    r"%[^\n]*|\$[^$]*\$|\\\(.*?\\\)|\\(?:label|tag|c?ref|eqref|cite)\{[^{}]*\}|\\\w+|\{|\}"
)
_PROSE = re.compile(r"[^\W\d_]{2,}")
_JOINING = frozenset(("and", "und", "et", "as", "well"))


@dataclass(frozen=True)
class Announced:
    """What is announced of a display: another case or a special one, or that it says something new.

    `passage` counts the passages of prose so far, `turns` those with words that turn the sense in
    which something is counted.
    """

    is_case: bool = False
    is_special: bool = False
    is_new: bool = False
    passage: int = 0
    turns: int = 0

    def go_on(self, words: str) -> Announced:
        """Return what is announced of the next display; without words of its own as before."""
        said = _WHERE.match(words) if self.passage else None
        turns = self.turns + bool(_TURNING.search(words, said.end() if said else 0))
        if not _has_prose(words):
            return replace(self, turns=turns)
        near = words[-_NEAR:]
        return Announced(
            is_case=bool(_ALTERNATIVE.search(near)),
            is_special=bool(_SPECIAL.search(near)),
            is_new=not _CONSEQUENCE.search(words),
            passage=self.passage + 1,
            turns=turns,
        )


def _has_prose(words: str) -> bool:
    found = {word.lower() for word in _PROSE.findall(_NO_PROSE.sub(" ", words))}
    return bool(found - _JOINING)


NOTHING = Announced()
