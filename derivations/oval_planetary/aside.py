"""The sentences of paper 2 that no row judges, by their numbers in its transcription, and why."""

ASIDE = {
    "S1": "title, authors and dates",
    "S2": "why such transmissions are used; no number",
    "S5": "names the stand and the four variants",
    "S6": "how the position function was measured",
    "S8": "keywords",
    "S9": "history",
    "S10": "history, and a comparison with linkages without a number",
    "S11": "why such devices are used",
    "S12": "what others hold",
    "S13": "works of others",
    "S15": "follows from S14 and S32: reciprocating rotation, which fixed axes do not give",
    "S16": "the aim",
    "S17": "caption of Fig. 1: names the links and the points, which the mechanics take over",
    "S33": "caption of Fig. 2, whose curves are not at hand",
    "S35": "announces the experiment",
    "S36": "how the prototype was made",
    "S38": "captions of Fig. 3 and Fig. 4",
    "S39": "how the data were taken; no number",
    "S40": "caption of Fig. 5, of which only tick labels of no variant survive",
    "S42": "announces (12) to (15)",
}
