"""What the words in front of a display announce: another case, a special one, a reversed sense.

Words are matched, not understood. Prose that announces no consequence may lead to anything. A
sentence may turn to something else even if it calls it a consequence: "The parallel arrangement has
k. Consequently, the series arrangement has k" states two different k, and so does "Turned by 90
degrees we obtain".
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from mechproof.sources.examples import NO_EXAMPLE, Example

# Words for another case, but not for the second root of an equation; words that may mean either;
# and the number of characters in front of a display in which they are sought.
_OTHERS = (
    r"other|otherwise|another|alternative(?:ly)?|second(?! (?:derivative|time|order|law)\b)|else"
)
_OTHER = re.compile(rf"\b(?:{_OTHERS})\b", re.IGNORECASE)
_ALTERNATIVE = re.compile(
    rf"\b(?:{_OTHERS}|or|oder|ou|или|respectively|elbow|"
    r"solutions?|roots?|branch(?:es)?|cases?|configurations?|if|when"
    r"|(?<!\bsolve\s)(?<!\bsolved\s)(?<!\bsolving\s)(?<!\bexpression\s)(?<!\bformula\s)for)\b",
    re.IGNORECASE,
)
_NEAR = 200
# Words for what holds approximately, or for some motions only.
_SPECIAL = re.compile(
    r"\b(?:neglect|small|approximat|lineari[sz]|first[- ]order|uniform|constant)"
    r"|\b(?:cases?|if|when)\b"
    r"|vernachl\xe4ssig|\b(?:klein|konstant|gleichf\xf6rmig)|n\xe9glige|\b(?:petit|constant)"
    r"|пренебрег|\b(?:мал|постоянн|равномерн)",
    re.IGNORECASE,
)
# Words for what holds at a special position, or as long as something is held.
_POSITION = re.compile(
    r"\bdead[- ](?:cent(?:re|er)|position)|\b(?:special|limiting) cases?\b|\bremains? at rest\b"
    r"|\b(?:extreme|limit|limiting|end|special|initial) positions?\b"
    r"|\b(?:at|in) (?:this|that) (?:position|instant|moment)\b"
    r"|\b(?:reached|attained) (?:at|for|if|when|where)\b"
    r"|\bwith the (?:\w+ ){1,2}(?:fixed|held|locked|braked|at rest)\b"
    r"|\b(?:is|are) (?:held|locked|braked|stationary|at rest|fixed)\b(?! (?:to|on|in|at|by)\b)"
    r"|\b(?:totlage|totpunkt|festgehalten|festgebremst|steht still)|\bpoints? morts?\b"
    r"|м[её]ртв\w+ (?:точк|положен)|остановлен|заторможен",
    re.IGNORECASE,
)
# Words that may make letters equal that differ elsewhere.
_EQUATING = re.compile(
    r"\bfor an? \w+|\b(?:coincide|vanish|aligned|collinear|in line)\b|\bare equal\b(?! to\b)"
    r"|\bin an? \w+ (?:one|case|impact|collision)\b|\blet (?:it|them|(?:the|both|all) \w+)\b"
    r"|\bf\xfcr (?:ein|eine|einen)\b|\b(?:zusammenfallen|fallen zusammen|sind gleich|fluchten)\b"
    r"|\bpour une?\b|\bco\xefncident|совпадают",
    re.IGNORECASE,
)
# Words that reverse the sense in which something is counted (mostly counter-clockwise) from there
# on. A sentence that continues after a display with "where" explains what letters meant all along.
_TURNING = re.compile(
    r"(?<!counter)(?<!anti)(?<!counter-)(?<!anti-)clockwise|counter-?rotat|opposed|crossed|mirror"
    r"|revers(?:e|al|ing)|redefin|backwards|downwards|\b(?:left|right)-hand|\bsign convention"
    r"|\b(?:opposite|negative|other|contrary)(?:\s+\w+)?\s+(?:direction|sense|sign|way|side)"
    r"|\bnow\s+(?:\w+\s+)?(?:counted|measured|reckoned|taken)\b"
    r"|\bin (?:the|an?|another)(?: (?!same|present|above|given)\w+)?"
    r" (?:arrangement|configuration|variant|version|layout)\b"
    r"|\bin der (?:\w+ )?(?:anordnung|ausf\xfchrung|variante)\b|\bdans la (?:\w+ )?disposition\b"
    r"|\bв (?:\w+ )?(?:исполнении|варианте)\b"
    r"|\b(?:interchang|exchang|swapp)|\bfrom (?:now|here) on\b|\b(?:henceforth|hereafter)\b"
    r"|(?<!gegen den )uhrzeigersinn|entgegengesetzt|umgekehrt|\b(?:von nun an|ab jetzt)\b"
    r"|\bsens (?:horaire|inverse|contraire|oppos\xe9)|\bd\xe9sormais\b"
    r"|(?<!против )часовой|противополож|обратн|\b(?:теперь|впредь)\b",
    re.IGNORECASE,
)
_MEANING = r"where|in which|wobei|o\xf9|где"
_CLAUSE = re.compile(rf"[\s.,;]*(?:{_MEANING}|with|mit|avec)\b", re.IGNORECASE)
_WHERE = re.compile(rf"[\s.,;]*(?:{_MEANING})\b[^.;]*", re.IGNORECASE)
# Words by which a display follows from those before it, or means the same.
_CONSEQUENCE = re.compile(
    r"\b(?:hence|therefore|thus|so|this|which|these|consequently|accordingly|again|that is|i\.e"
    r"|namely|whence|(?:is|be) written|daher|folglich|somit|damit|also|daraus|woraus"
    r"|donc|ainsi|soit|следовательно|тогда|отсюда)\b"
    r"|\bthe same (?:equation|expression|relation|result)|\b(?:squar|substitut)(?:ing|ed|ion)\b"
    r"|\bdifferentiat|\b(?:multiply|divid|integrat)ing\b|\b(?:multiplica|integra)tion\b"
    r"|\bfollows?\b|\b(?:we|one) obtains?\b|\bobtaining\b"
    r"|\b(?:insert|eliminat|combin|solv|simplif|expan|rearrang|transform"
    r"|rewrit|equivalent|identical|einsetz|folgt|d'o\xf9|получ|подстав)",
    re.IGNORECASE,
)
_END = re.compile(r"(?<!\b[Ff]ig)(?<!\b[Ee]q)(?<!\b[Ee]qs)(?<!\bcf)(?<!\b[Ss]ec)[.;!?]\s")
# A heading: nothing after it follows from what precedes it.
_HEADING = re.compile(r"\\(?:chapter|(?:sub)*section|paragraph)(?![A-Za-z])")
# Words that turn to something else, as a heading does.
_CONTRAST = re.compile(
    r"\bin contrast\b|\bon the other hand\b|\bin place of\b|\b(?:whereas|instead|unlike|next)\b"
    r"|\b(?:of|in) fig(?:ure\b|\.)"
    r"|\b(?:dagegen|hingegen|anstelle)\b|\ben revanche\b|\bв отличие\b",
    re.IGNORECASE,
)
# A law with a name: the cycloidal law, but not "the velocity law", which belongs to the law before.
_LAW = re.compile(
    r"\b(?!(?:the|an?|this|that|these|its|same|such|our|of|and|each|every|any|above|basic|general"
    r"|motion|displacement|position|lift|velocity|speed|acceleration|follower|cam)\b)"
    r"([^\W\d_]{3,}) (?:laws?|curves?|profiles?|motions?|programs?|programmes?)\b",
    re.IGNORECASE,
)
# Another item of a list, which may have no words: \item[(b)], \textbf{B}, 2. in Markdown.
_ITEM = re.compile(
    r"\\item(?![A-Za-z])|\\(?:textbf|textit|emph)\{[^{}]{1,3}\}"
    r"|^[ \t]*(?:\$?\(?\$?(?:\\[A-Za-z]+|[A-Za-z\d]{1,2})\$?[.)]\$?|[-*\u2013]{1,3})[ \t]*$",
    re.MULTILINE,
)
# Words for what holds in all cases.
_GENERAL = re.compile(
    r"\b(?:in general|generally|in every case|in all cases|otherwise|elsewhere)\b"
    r"|\boutside (?:this|these|that)\b|\bim allgemeinen\b"
    r"|\ben g\xe9n\xe9ral\b|\bв общем\b",
    re.IGNORECASE,
)
_NO_PROSE = re.compile(
    r"%[^\n]*|\$[^$]*\$|\\\(.*?\\\)|\\(?:label|tag|c?ref|eqref|cite)\{[^{}]*\}|\\\w+|\{|\}"
)
_PROSE = re.compile(r"[^\W\d_]{2,}")
_JOINING = frozenset(("and", "und", "et", "as", "well"))
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
# Stems of verbs for operations on equations, and of words that only look like such verbs.
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


@dataclass(frozen=True)
class Announced:
    """What is announced of a display: another case or a special one, or something new.

    `is_clause`: the sentence continues and explains what letters mean; `is_position`: it may hold
    only at a special position, or while something is held; `is_equating`: letters that differ
    elsewhere may be equal there; `is_general`: it holds in all cases; `is_other`: it is another
    case than the one before, not another root of the same.

    `passage` counts the passages of prose so far; `scope` is the last one that says something new
    or may be special; `turns` counts those with words that reverse the sense in which something is
    counted or introduce another arrangement, `subjects` those that turn to something else. `law` is
    the name of the law last mentioned, `general` the last passage about all cases, `sides` which
    opposites were named last; `example` is the worked example that contains the display.
    """

    is_case: bool = False
    is_special: bool = False
    is_new: bool = False
    is_clause: bool = False
    is_position: bool = False
    is_equating: bool = False
    is_general: bool = False
    is_other: bool = False
    passage: int = 0
    scope: int = 0
    turns: int = 0
    subjects: int = 0
    law: str = ""
    general: int = 0
    sides: Mapping[int, int] = field(default_factory=dict)
    example: Example = NO_EXAMPLE

    def is_apart(self, other: Announced) -> bool:
        """Return whether the text between turns to something else, or reverses a sense."""
        return (self.turns, self.subjects) != (other.turns, other.subjects)

    def is_of_other(self, other: Announced) -> bool:
        """Return whether it is announced anew, for the opposite of what the other is about."""
        return self.is_new and _are_opposed(self.sides, other.sides)

    def go_on(self, words: str, offsets: Sequence[int] = ()) -> Announced:
        """Return the announcement of the next display; without prose of its own most of it is kept.

        `offsets` are the places of the characters of `words`.
        """
        said = _WHERE.match(words) if self.passage else None
        turns = self.turns + bool(_TURNING.search(words, said.end() if said else 0))
        is_other = bool(_HEADING.search(words))
        laws = [name.lower() for name in _LAW.findall(words)]
        is_next = bool(self.law and laws and laws[-1] != self.law)
        near = words[-_NEAR:]
        sides = {**self.sides, **_find_sides(near)}
        is_opposite = _are_opposed(self.sides, sides)
        subjects = self.subjects + (is_other or is_next or bool(_CONTRAST.search(words)))
        if not (_has_prose(words) or _ITEM.search(words)):
            example = self.example.go_on(words, offsets, is_new=False)
            return replace(self, turns=turns, subjects=subjects, example=example)
        is_new = is_other or is_opposite or not _follows(words)
        is_special, is_position = bool(_SPECIAL.search(near)), bool(_POSITION.search(near))
        is_equating = is_special or is_position or bool(_EQUATING.search(near))
        is_general = bool(_GENERAL.search(near))
        return Announced(
            is_case=bool(_ALTERNATIVE.search(near)),
            is_special=is_special,
            is_new=is_new,
            is_clause=bool(_CLAUSE.match(words)) and not is_position,
            is_position=is_position,
            is_equating=is_equating,
            is_general=is_general,
            is_other=bool(_OTHER.search(near)),
            passage=self.passage + 1,
            scope=self.passage + 1 if is_new or is_equating or is_general else self.scope,
            turns=turns,
            subjects=subjects,
            law=laws[-1] if laws else self.law,
            general=self.passage + 1 if is_general else self.general,
            sides=sides,
            example=self.example.go_on(words, offsets, is_new=is_new),
        )


def _follows(words: str) -> bool:
    """Return whether words announce a consequence before they say anything else.

    A sentence after the preceding display that explains letters is not counted.
    """
    sentences = [one for one in _END.split(words) if _has_prose(one) and not _WHERE.match(one)]
    return any(_CONSEQUENCE.search(one) and not _is_about_another(one) for one in sentences[:1])


def _has_prose(words: str) -> bool:
    found = {word.lower() for word in _PROSE.findall(_NO_PROSE.sub(" ", words))}
    return bool(found - _JOINING)


NOTHING = Announced()


def _find_sides(words: str) -> Mapping[int, int]:
    """Return the pairs of opposites of which words name just one, with the index of that one."""
    found = {}
    for pair, (one, other) in enumerate(_SIDES):
        said = bool(one.search(words)), bool(other.search(words))
        if any(said) and not all(said):
            found[pair] = said.index(True)
    return found


def _are_opposed(one: Mapping[int, int], other: Mapping[int, int]) -> bool:
    """Return whether two passages name opposite sides of a pair."""
    return any(other.get(pair, side) != side for pair, side in one.items())


def _is_about_another(sentence: str) -> bool:
    """Return whether a sentence starts with an action other than a calculation, or another thing.

    "Moving down, …", "Hence a thin ring has".
    """
    return bool(_DEED.match(sentence) or _ANOTHER.match(sentence))
