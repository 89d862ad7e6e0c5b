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
    "or multiplies both by the same",
    "sign in positive coordinates": "an inequality whose sign is read from the coefficients after "
    "a change to coordinates that are positive exactly on the domain",
    "sign of the integrand": "an inequality of integrals over one interval, by the sign of what is "
    "integrated between its ends",
    "bisection and derivatives": "an inequality on a finite interval, enclosed on ever smaller "
    "parts, and by its derivatives where it becomes an equality",
    "Taylor series with its remainder in balls": "what is small near 0 is bounded by its series: "
    "the first coefficients vanish exactly, the others and the remainder add up to no more than "
    "the bound",
    "Newton's method in balls": "a bracket has one root for all sizes, and Newton's steps from the "
    "start end within the bound of it: shown on parts of the domain, by the signs at the ends, the "
    "sign of the derivative, and Kantorovich's bound",
    "inverse function: value and range": "an inverse function has the value at which what it is "
    "inverse to gives its argument, if that lies in its range",
    "sum of angles within a turn": "inverse sines, cosines and tangents add up to an angle that "
    "lies within a turn and points along the first axis",
    "product under one logarithm": "logarithms add up to nothing, for the product of their "
    "arguments is one",
    "square of a root and its sign": "a side has the sign of a root, and its square is that of it",
    "squares of roots and moduli": "an inequality, by those of the squares of what has a sign",
    "signs of moduli": "moduli are no less than others: for all signs of what is in these, "
    "multiples of what is in the first, by no more than one, add up to it",
    "mean value theorem": "|f(x) - f(y)| is no more than a bound of the slope of f times |x - y|",
    "order of inverse functions": "an inverse function and another number, within its range, are "
    "in the order, or the opposite one, of what it is the inverse of",
    "sum of binomial squares": "an inequality: the difference of the sides, by real numbers whose "
    "squares are those that are not negative, is a sum of squares of one or two terms",
    "signs in half-angle tangents": "an inequality in the tangents of half angles and in "
    "exponentials, on the intervals in which these lie",
    "difference of two angles": "an inequality of two angles with a bounded sum: it is "
    "linear in the cosine of their difference, and holds at both ends of its range",
    "every order of the numbers": "an inequality, by the coefficients for every order of the "
    "numbers, each written as the one below and a gap",
    "gaps of linear relations": "an inequality, with the numbers written by the gaps of relations "
    "that are said of them, such as a < b + c",
    "monotonicity": "an inequality that holds at one place, or in the limit at an end, from which "
    "the difference of its sides grows; at both ends of an interval on which that is concave; or "
    "where its slope is zero and it is convex",
    "induction of an inequality": "an inequality that holds for the first whole number, and for "
    "each next one if for the one before: the difference of its sides is at least a positive "
    "multiple of what it was",
    "descent to a limit": "an inequality for whole numbers: the difference of its sides falls from "
    "each number to the next, and its limit is not negative",
    "limit of partial sums": "a sum without end is the limit of its partial sums, whose value is "
    "proved by induction, or that of a geometric series",
    "known series": "a sum without end whose first term and quotients of terms are those of the "
    "series of an elementary function, where it converges, or of a value of zeta",
    "Fourier series": "a sum without end of sines or cosines of all or odd multiples of an angle, "
    "divided by a power of these, is that of a saw, a square wave or the like, within its period",
    "partial fractions": "an infinite sum or product of fractions of its index, alone or times a "
    "wave, is found from the residues at their poles, or from the digamma or gamma function",
    "Wilf-Zeilberger pair": "the terms of a sum change from n to n + 1 by differences that "
    "telescope, which is checked as an identity of fractions",
    "angles that rise by the same step": "each term of a sum of sines and cosines is a difference "
    "by sines of half the step, so all but the ends cancel",
    "binomial sum of waves": "a sum of sines or cosines times binomial coefficients is the real "
    "or imaginary part of a power of 1 + exp(i*x), turned by an angle",
    "multiple of a constraint": "the difference of the sides is a multiple of that of a constraint "
    "that is printed before",
    "values of any functions": "of functions that are named nothing is known but that they are "
    "smooth: their values are numbers of which nothing is known, and those of antiderivatives are "
    "found where what is integrated is a derivative",
    "steps of floors": "floors of one number add up to nothing at each step within a period, and "
    "between the steps",
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
