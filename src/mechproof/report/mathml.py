"""MathML: takes a formula of a paper in LaTeX, returns an element that all browsers show alike.

Written formulas are cached from one run to the next.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cached_property
from hashlib import sha256
from html import unescape
from itertools import pairwise
from pathlib import Path
from typing import Literal
from xml.etree.ElementTree import Element, SubElement, tostring

from latex2mathml.converter import convert_to_element
from markupsafe import Markup

from mechproof.latex.package_commands import write_out
from mechproof.tools.cache import Store, make_key

# Files that write formulas: an entry depends on them besides its LaTeX.
WRITERS = tuple(map(Path(__file__).with_name, ("mathml.py", "breaks.py", "formulas.py")))
PACKAGES = ("latex2mathml", "sympy")
# The most entries that are kept; the oldest, of old papers, are dropped.
MOST_KEPT = 10_000
Display = Literal["block", "inline"]
# Attributes that elements may keep; all others, such as links and styles, are dropped.
ATTRIBUTES = frozenset({
    "accent", "columnalign", "display", "displaystyle", "fence", "form", "largeop", "linethickness",
    "lspace", "mathvariant", "maxsize", "minsize", "movablelimits", "rspace", "scriptlevel",
    "separator", "stretchy", "width", "xmlns",
})  # fmt: skip
MICROMETRE = re.compile(r"\\mu\s*\\mathrm\s*(?:\{m\}|m(?![A-Za-z]))")
UPRIGHT = re.compile(r"\\mathrm\s*(?:\{([^\W\d_]+)\}|([^\W\d_]))")
ESCAPED = re.compile(r"\\([_%#&$ ])")
# A colon after a name, as opposed to that of a quotient.
COLON = (r"\colon", r"\text{:}\;")
# SymPy's name for the angle of a vector, and the usual one.
TWO_ARGUMENTS = (r"\operatorname{atan}_{2}", r"\text{atan2}")
# Colours that mark what a correction removes and adds -> classes of the stylesheet.
MARKS = {"red": "taken", "green": "put", "gray": "kept"}
TALL = frozenset({"mfrac", "mtable", "munderover", "munder", "msqrt", "mroot", "mover"})
NAMESPACE = "http://www.w3.org/1998/Math/MathML"
OPENING, CLOSING = "([{|⟨⌈⌊", ")]}⟩⌉⌋"
# Signs that may belong to a number, and the signs in front of such a sign.
SIGNS, BEFORE_SIGNS = "+-−±∓", f"{OPENING},;:=<>≤≥⩽⩾≈→·"
PRIMES = {"′": 1, "″": 2, "‴": 3}


class KeptFormulas:
    """A cache of written formulas, by the digest of their LaTeX and of the code writing them."""

    def __init__(self, store: Store) -> None:
        self.store = store
        self.new: dict[str, str] = {}

    @cached_property
    def known(self) -> dict[str, str]:
        """Return the cached formulas, read once, without damaged entries, which are not text."""
        return {k: text for k, text in self.store.read().items() if isinstance(text, str)}

    @cached_property
    def version(self) -> str:
        """Return the digest of the code that writes formulas."""
        return make_key(WRITERS, PACKAGES)

    def find(self, latex: str, display: str, write: Callable[[str, str], str]) -> str:
        """Return the cached text of a formula, or have it written and cached."""
        key = sha256("\n".join((self.version, display, latex)).encode()).hexdigest()
        if key not in self.known:
            self.new[key] = self.known[key] = write(latex, display)
        return self.known[key]

    def keep(self) -> None:
        """Store new formulas for the next run."""
        if self.new:
            self.store.write(dict(list({**self.store.read(), **self.new}.items())[-MOST_KEPT:]))
            self.new = {}


FORMULAS = KeptFormulas(Store("formulas.json"))


def write_formula(latex: str, display: Display = "inline") -> Markup:
    """Write a formula as MathML with its LaTeX for copying; as code if it cannot be converted."""
    return Markup(FORMULAS.find(latex, display, _convert))


def _convert(latex: str, display: str) -> str:
    upright = UPRIGHT.sub(r"\\text{\1\2}", MICROMETRE.sub(r"\\mathrm{µm}", write_out(latex)))
    plain = upright.replace(*TWO_ARGUMENTS).replace(*COLON)
    try:
        math = convert_to_element(plain, display=display)
    except Exception:  # The library raises many kinds, which the user's own paper may meet.
        return str(Markup('<code class="latex">{}</code>').format(latex))
    _mend(math)
    row = math[0]
    math.remove(row)
    meaning = SubElement(math, "semantics")
    meaning.append(row)
    source = SubElement(meaning, "annotation", {"encoding": "application/x-tex"})
    source.text = latex
    written: str = tostring(math, encoding="unicode")
    return written


def _mend(element: Element) -> None:
    """Read entities, drop attributes that are not allowed, and add what the library leaves out."""
    element.text = unescape(element.text) if element.text else element.text
    colour = element.attrib.get("mathcolor", "")
    element.attrib = {k: v for k, v in element.attrib.items() if k in ATTRIBUTES}
    if colour in MARKS:
        element.set("class", MARKS[colour])
    if element.tag == "mtext" and element.text:
        element.text = read_text(element.text)
    if element.tag == "mover" and element[-1].tag == "mo":
        element.set("accent", "true")
    if element.tag == "mo" and (element.text or "").isalpha() and len(element.text or "") > 1:
        element.tag, element.attrib = "mi", {}
    if element.tag == "mi" and element.text:
        _mend_name(element, element.text)
    if element.tag == "mo" and element.text == "∞":
        element.tag = "mi"
    for child in element:
        _mend(child)
    _space_functions(element)
    _keep_low(element)
    _close_numbers(element)
    _pair_bars(element)
    _tie_signs(element)
    _join_primes(element)
    _raise_degrees(element)


def _tie_signs(row: Element) -> None:
    """Set the sign of a number close to it unless something in front could be added to it."""
    before = None
    for part in row:
        if part.tag == "mo" and (part.text or "x") in SIGNS and _awaits_number(before):
            part.set("form", "prefix")
        if not _is_blank(part):
            before = part


def _awaits_number(before: Element | None) -> bool:
    if before is None:
        return True
    is_met = before.tag == "mo" and (before.text or "x") in BEFORE_SIGNS
    return is_met and before.get("form") != "postfix"


def _pair_bars(row: Element) -> None:
    """Set the bars of an absolute value close to it: the first of two opens, the second closes."""
    bars = [part for part in row if part.tag == "mo" and part.text == "|"]
    for place, bar in enumerate(bars if len(bars) % 2 == 0 else []):
        bar.set("form", "postfix" if place % 2 else "prefix")


def _join_primes(element: Element) -> None:
    """Join the primes over an index into one sign: the library puts a power on the first."""
    if element.tag != "msup" or element[0].tag != "msubsup":
        return
    (base, index, prime), more = element[0], element[1]
    count = PRIMES.get(prime.text or "", 9) + PRIMES.get(more.text or "", 9)
    if joined := next((sign for sign, number in PRIMES.items() if number == count), None):
        element.tag, more.text = "msubsup", joined
        element[:] = [base, index, more]


def _raise_degrees(element: Element) -> None:
    """Write degrees with their own sign: a raised ring is too small."""
    if element.tag == "msup" and "".join(element[1].itertext()) == "∘":
        element.tag = "mrow"
        for ring in element[1].iter("mo"):
            ring.tag, ring.text = "mi", "°"


def _keep_low(row: Element) -> None:
    """Keep brackets around low contents unstretched, as some fonts set stretched ones apart."""
    fences = [child for child in row if child.get("fence") == "true"]
    if fences and not any(part.tag in TALL for part in row.iter()):
        for fence in fences:
            fence.set("stretchy", "false")


def _close_numbers(row: Element) -> None:
    """Close the gap in front of a decimal point that is an operator, as in marked decimals."""
    for number, point in pairwise(list(row)):
        if number.tag == "mn" and point.tag == "mo" and point.text == ".":
            point.tag, point.attrib = "mn", {}


def _mend_name(element: Element, text: str) -> None:
    if len(text) == 1 and not (text.isalnum() or text in "∂∇∞∅ℓ′″‴%°ℝℕℤ…"):
        element.tag = "mo"
    elif len(text) == 1 and "Α" <= text <= "Ω":
        element.set("mathvariant", "normal")


def _space_functions(row: Element) -> None:
    """Put a gap between the name of a function and its argument or the factor before it."""
    if row.tag not in ("mrow", "math", "mtd", "mstyle", "msqrt"):
        return
    parts = list(row)
    # After a blank comes a unit: 66 mm.
    units = {id(b) for a, b in pairwise(parts) if a.tag == "mtext" and _is_blank(a)}
    for left, right in pairwise(parts):
        after = _is_function(left) and id(left) not in units and not _opens(right)
        if after or (_is_function(right) and _multiplies(left)):
            row.insert(list(row).index(right), Element("mspace", {"width": "0.167em"}))


def _is_blank(element: Element) -> bool:
    return element.tag == "mspace" or (element.tag == "mtext" and not (element.text or "").strip())


def _is_function(element: Element) -> bool:
    base = element[0] if element.tag in ("msup", "msub", "msubsup") and len(element) else element
    name = (base.text or "") if base.tag in ("mi", "mtext") else ""
    return name.isalnum() and name.islower() and len(name) > 1


def _opens(element: Element) -> bool:
    first = element
    while first.tag in ("mrow", "mstyle") and len(first):
        first = first[0]
    return _is_blank(first) or (first.tag == "mo" and (first.text or "") in OPENING)


def _multiplies(element: Element) -> bool:
    if element.tag == "mo":
        return (element.text or "") in CLOSING
    return not _is_blank(element)


def read_text(text: str) -> str:
    """Read the escapes of LaTeX in words."""
    return ESCAPED.sub(r"\1", text).replace(r"\^{}", "^").replace("~", "\N{NO-BREAK SPACE}")
