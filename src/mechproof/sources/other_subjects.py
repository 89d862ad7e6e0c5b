"""Words of a sentence that goes on to something else, although it may call it a consequence.

"The parallel arrangement has k. Consequently, the series arrangement has k" says two things of k,
and so does "Turned by 90 degrees we obtain". Words are matched, not understood.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

_OPPOSITES = (
    (r"series|reihen\w*|en s\xe9rie|последовательн\w*", r"parallel\w*|parall\xe8le|параллельн\w*"),
    (r"external\w*|au\xdfen\w*|ext\xe9rieure?s?|внешн\w*", r"internal\w*|innen\w*|внутренн\w*"),
    (r"outer|\xe4u\xdfere\w*", r"inner\w*"),
    (r"up|upwards?|uphill|aufw\xe4rts", r"down|downwards?|downhill|to lower|abw\xe4rts"),
    (r"lift(?:ed|ing)|rais(?:ed|ing)|hoist\w*|heben", r"lower(?:ed|ing)|senken"),
    (r"rises?|anstieg|mont\xe9e|подъ[её]м\w*", r"returns?|falls?|r\xfcckgang|descente|опускан\w*"),
    (r"loading|belastung", r"unloading|entlastung"),
    (r"driver|driving|action", r"driven|reaction"),
    (r"open", r"crossed"),
    (r"tensile|tension|zug\w*", r"compress\w+|druck\w*"),
    (r"upper", r"lower"),
    (r"leading", r"trailing"),
    (r"forwards?", r"backwards?|back"),
    (r"tight", r"slack"),
    (r"solid|full|massiv\w*", r"hollow|thin|ring|hohl\w*"),
    (r"left(?! ?-?hand| sides?\b)", r"right(?! ?-?hand| sides?\b)"),
)
_SIDES = tuple(
    tuple(re.compile(rf"\b(?:{words})\b", re.IGNORECASE) for words in pair) for pair in _OPPOSITES
)
# Stems of what is done to equations, and of words that look like a deed and are none.
_CALCULATIONS = (
    "abbreviat|accord|account|appl|approximat|assum|bas|be|bear|bring|calculat|cancel|clear|collect"
    "|combin|compar|comput|consider|deduc|denot|deriv|develop|differentiat|divid|dur|eliminat"
    "|employ|equat|evaluat|expand|exploit|express|extract|factor|follow|giv|group|inde|insert"
    "|integrat|introduc|invert|isolat|lett|linear|mak|measur|multipl|nam|neglect|normali|not|observ"
    "|omit|order|perform|plac|plugg|proceed|project|putt|r|rearrang|recall|reduc|regard|relat"
    "|remember|replac|resolv|rewrit|scal|sett|simplif|solv|sort|spr|squar|start|str|substitut"
    "|subtract|summ|tak|th|transform|transpos|us|utili|work|writ"
)
_LEADING = r"\W*(?:(?:now|then|finally|next|hence|thus|by|on|upon|after)\W+)?"
_ANOTHER = re.compile(
    rf"{_LEADING}(?:therefore|so|consequently|it follows(?: \w+){{0,2}} that)?,?\s*"
    r"an?\s+(?:[\w-]+\s+){1,4}(?:has|needs|carries)\b",
    re.IGNORECASE,
)
_SUM = r"add(?:ing|ed)\W+(?:\\(?:eq)?ref|\d|eq\w*|both|the two|these|them|up)\b"
_DEED = re.compile(
    rf"{_LEADING}(?!(?:{_CALCULATIONS})\w{{0,2}}(?:ing|ed)\b|{_SUM})\w+(?:ing|ed)\b", re.IGNORECASE
)


def find_sides(words: str) -> Mapping[int, int]:
    """Return of which pairs of opposites one is said and the other is not, and which."""
    found = {}
    for pair, (one, other) in enumerate(_SIDES):
        said = bool(one.search(words)), bool(other.search(words))
        if any(said) and not all(said):
            found[pair] = said.index(True)
    return found


def are_opposed(one: Mapping[int, int], other: Mapping[int, int]) -> bool:
    """Return whether of a pair one is said here and the other there."""
    return any(other.get(pair, side) != side for pair, side in one.items())


def tells_of_another(sentence: str) -> bool:
    """Return whether a sentence starts with a deed that is no calculation, or with another thing.

    "Moving down, …", "Hence a thin ring has".
    """
    return bool(_DEED.match(sentence) or _ANOTHER.match(sentence))
