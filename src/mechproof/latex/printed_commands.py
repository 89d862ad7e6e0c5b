"""Commands and environments, grouped by what becomes of their arguments."""

# Numbers with units, and units, of siunitx.
MEASURES = (r"\SI", r"\qty")
QUANTITIES = (*MEASURES, r"\si", r"\unit")
# Commands that mark their argument without changing what it says.
MARKS = (r"\cancel", r"\bcancel", r"\xcancel", r"\boxed")
# Commands that put a brace over or under their argument -> the script that labels it.
BRACES = {r"\underbrace": "_", r"\overbrace": "^", r"\underbracket": "_", r"\overbracket": "^"}
# Commands that put something above or below a sign; with a question mark they are not read.
STACKS = (r"\overset", r"\underset", r"\stackrel")
QUESTION = "?"
# Commands that leave a blank space of the size of their argument.
UNSEEN = (r"\phantom", r"\hphantom", r"\vphantom")
COLOURS = (r"\color", r"\textcolor")
# Matrices and cases of packages -> the environment as which they are read; those with a star may
# have an option that aligns their columns.
ENVIRONMENTS = {
    f"{kind}{name}": f"{kind}matrix"
    for kind in ("", "p", "b", "B", "v")
    for name in ("matrix*", "smallmatrix", "smallmatrix*", "NiceMatrix", "NiceArray")
} | {"array": "matrix", "cases*": "cases", "dcases*": "dcases"}
# Environments with an argument for their columns.
WITH_COLUMNS = ("array", *(f"{kind}NiceArray" for kind in ("", "p", "b", "B", "v")))
# Accents and typefaces of vectors and matrices.
VECTORS = (r"\vec", r"\vect", r"\mathbf", r"\boldsymbol", r"\bm", r"\pmb", r"\underline")
# Accents for derivatives with respect to time, and all accents and typefaces.
DOTTED = (r"\dot", r"\ddot", r"\dddot")
ACCENTS = (
    *(*DOTTED, r"\bar", r"\overline", r"\hat", r"\tilde"),
    *(r"\widehat", r"\widetilde"),
    *(r"\mathcal", r"\mathscr", r"\mathfrak"),
    *VECTORS,
)
# Commands for upright letters, and for words.
UPRIGHT = (
    *(r"\textrm", r"\textup", r"\mathsf", r"\mathrm", r"\operatorname", r"\operatorname*"),
    *(r"\mathop", r"\mathit"),
)
TEXT = (r"\text", r"\mbox", r"\textnormal", r"\hbox")
