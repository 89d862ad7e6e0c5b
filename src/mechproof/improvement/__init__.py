"""Improvement: in, a quantity; out, the named rewrites with which its definition keeps its digits.

`candidates` computes a form that is not emitted, and says what it loses and costs; `form_search`
tries the rewrites one after the other and keeps the best; `offers` proves what was found and
compares it with the shipped kernel. Herbie (Panchekha et al. 2015) searches rules for single
expressions in a graph of equal ones; here a rule is a named rewrite of a whole form, so that what
is found is a form as a person would write it, which is emitted, read back and proved like any
other.
"""
