"""Commands and environments by what becomes of their arguments."""

# Numbers with units, and units, of siunitx.
QUANTITIES = (r"\SI", r"\qty", r"\si", r"\unit")
# What marks its argument, but says nothing of it.
MARKS = (r"\cancel", r"\bcancel", r"\xcancel", r"\boxed")
# What marks its argument with a brace, and names it behind that sign.
BRACES = {r"\underbrace": "_", r"\overbrace": "^", r"\underbracket": "_", r"\overbracket": "^"}
# What writes something above or below a sign; a question is none.
STACKS = (r"\overset", r"\underset", r"\stackrel")
QUESTION = "?"
# What takes the place of its argument and shows nothing.
UNSEEN = (r"\phantom", r"\hphantom", r"\vphantom")
COLOURS = (r"\color", r"\textcolor")
# Matrices and cases of packages; those with a star may say how their columns stand.
ENVIRONMENTS = {
    f"{kind}{name}": f"{kind}matrix"
    for kind in ("", "p", "b", "B", "v")
    for name in ("matrix*", "smallmatrix", "smallmatrix*", "NiceMatrix", "NiceArray")
} | {"array": "matrix", "cases*": "cases", "dcases*": "dcases"}
# Those that say behind their name what their columns are.
WITH_COLUMNS = ("array", *(f"{kind}NiceArray" for kind in ("", "p", "b", "B", "v")))
