"""Rungs: the names of the methods that decide rows, each explained in one sentence."""

from __future__ import annotations

from collections.abc import Iterable

RUNGS = {
    "identical": "both sides are the same expression, though they come from different sources",
    "rational field": "the difference is zero as a fraction of polynomials",
    "trigonometric field": "the difference is zero as a fraction of polynomials in sines and "
    "cosines whose squares add up to one",
    "radicals": "as in the rational field, with each square root as a number whose square is "
    "known and whose sign is proved",
    "symbolic sum": "sums with a symbolic number of terms agree in a canonical form",
    "separation bound": "two algebraic numbers differ by less than the smallest distance that "
    "their degrees and the sizes of their conjugates allow between different numbers",
    "arguments of vectors": "angles are equal as directions of plane vectors, and no turn is lost",
    "derivative": "both sides have the same derivative",
    "constant": "both sides have the same value at one point",
    "continuity": "both sides are continuous over the whole domain, so no branch is lost",
    "antiderivative": "the integral is the difference of an antiderivative, which is proved to be "
    "one and to be continuous up to both limits; or it is the same integral taken from the other "
    "end",
    "known integral": "the definite integral is in a table, and its letters lie where it converges",
    "integration by parts to the next number": "the integral has the stated value for the first "
    "whole number, and from each number to the next both change by the same factor, up to a "
    "derivative that adds nothing between the limits",
    "derivative of the derivative": "the derivative of order n has the stated value for the first "
    "n, and the derivative of each value is the next value",
    "logarithms and powers": "both sides are the same once powers of positive bases are written "
    "as exponentials and logarithms of products as sums",
    "induction": "both sides are equal for one term, and each further term adds the same to both, "
    "or multiplies both by the same factor",
    "sign in positive coordinates": "the sign of the difference is read from its coefficients "
    "after a change to coordinates that are positive exactly on the domain",
    "sign of the integrand": "an inequality of integrals over one interval follows from the sign "
    "of the integrand",
    "bisection and derivatives": "an inequality on a closed interval is enclosed on ever smaller "
    "parts, and decided by derivatives at an end where it becomes an equality",
    "Taylor series with its remainder in balls": "a function that is small near 0 is bounded by "
    "its series: the first coefficients vanish exactly, and the others and the remainder add up "
    "to no more than the bound",
    "Newton's method in balls": "the bracket has one root for all sizes, and Newton's steps from "
    "the start end within the bound of it: shown on parts of the domain by the signs at the ends, "
    "the sign of the derivative, and Kantorovich's bound",
    "inverse function: value and range": "the inverse function has this value, since the value "
    "lies in its range and the original function takes it to the argument",
    "sum of angles within a turn": "inverse sines, cosines and tangents add up to an angle that "
    "lies within a turn and points along the first axis",
    "product under one logarithm": "the logarithms cancel, since the product of their arguments "
    "is one",
    "square of a root and its sign": "a side has the sign of the root, and the square of the side "
    "is the square of the root",
    "squares of roots and moduli": "an inequality between terms of known sign follows from that "
    "between their squares",
    "signs of moduli": "one sum of moduli is at least another: with any signs, the contents of "
    "the latter add up to the contents of the former times factors of at most one",
    "mean value theorem": "|f(x) - f(y)| is at most a bound of the slope of f times |x - y|",
    "order of inverse functions": "an inverse function compares with a number in its range as its "
    "argument compares with the original function of that number, or the other way round if the "
    "function falls",
    "sum of binomial squares": "with the nonnegative numbers written as squares, the difference "
    "of the sides is a sum of squares of one or two terms",
    "signs in half-angle tangents": "the inequality is decided as one in the tangents of half "
    "angles and in exponentials, on the intervals in which these lie",
    "every order of the numbers": "for every order of the numbers, each is written as the one "
    "below it plus a gap, and the coefficients show the sign",
    "gaps of linear relations": "the numbers are written in terms of the gaps of given relations "
    "such as a < b + c, and the coefficients show the sign",
    "monotonicity": "an inequality holds at one place, or in the limit at an end, and the "
    "difference of its sides grows from there; or at both ends of an interval on which the "
    "difference is concave; or where the slope of a convex difference is zero",
    "induction of an inequality": "an inequality holds for the first whole number, and for each "
    "next one if for the one before: the difference of its sides is at least a positive multiple "
    "of the previous difference",
    "limit of partial sums": "an infinite sum is the limit of its partial sums, whose value is "
    "proved by induction, or that of a geometric series",
    "known series": "the first term and the quotients of successive terms of an infinite sum are "
    "those of the series of an elementary function, where it converges, or of a value of zeta",
    "Fourier series": "an infinite sum of sines or cosines of all or of the odd multiples of an "
    "angle, divided by a power of the multiple, is that of a sawtooth, a square wave or the like, "
    "within its period",
    "Wilf-Zeilberger pair": "the terms of a sum change from n to n + 1 by differences that "
    "telescope, which is checked as an identity of fractions",
    "angles that rise by the same step": "times the sine of half the step, each term of a sum of "
    "sines or cosines is a difference of neighbours, so all but the ends cancel",
    "multiple of a constraint": "the difference of the sides is a multiple of the difference of "
    "the sides of a constraint printed before",
    "values of any functions": "nothing is assumed of the named functions except that they are "
    "smooth: their values are treated as arbitrary numbers, and integrals are worked out where "
    "the integrand is a derivative",
    "steps of floors": "the floors of one number cancel at each step within a period, and between "
    "the steps",
    "evaluation": "no free symbol is left; the numbers are compared by enclosures",
    "limits from both sides": "the limits from above and from below differ, so there is no limit",
    "divergence": "a number is printed for an integral, a sum or a limit that has none: an "
    "integrand is at least 1/x or an antiderivative infinite at a pole or an end, the terms do "
    "not tend to zero, or an oscillation tends to several numbers",
    "recomputation": "the printed number is the exact value rounded to its last place, or is not",
    "separating balls": "at one exact point the enclosures of both sides have nothing in common",
    "enclosure": "no proof is found; the enclosures of both sides meet at every point tried",
    "entrywise": "a matrix is decided entry by entry, by the rungs that follow",
    "two completions": "a missing datum is completed in two ways, with opposite answers",
    "nothing to compare with": "nothing that is printed decides what the print says",
    "definition": "the print introduces a symbol, so there is nothing to prove",
    "well-formedness": "the print has no value: a differential, an index or an argument is missing",
    "dimensions": "quantities of different dimensions are added, so the value changes with the "
    "units",
    "case by case": "a side has pieces, or a symbol has few values: both sides are equal in each "
    "case",
    "none": "no rung can read the statement",
}


def name_rungs(rungs: Iterable[str]) -> list[str]:
    """List the distinct rungs of the ledger's rows in the order of `RUNGS`.

    Each text may join several rungs by commas. Raises `KeyError` for a rung without an explanation.
    """
    met = {name for joined in rungs for name in joined.split(", ")}
    if unknown := sorted(met - RUNGS.keys()):
        raise KeyError(f"rungs without an explanation: {', '.join(unknown)}")
    return [name for name in RUNGS if name in met]
