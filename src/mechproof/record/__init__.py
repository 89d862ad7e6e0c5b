"""The words every layer shares: paper, row, statement, quantity, form.

A derivation module fills these records and binds one `Paper` to the name `PAPER`.
Nothing here decides anything: verdicts come from `mechproof.proof`, source code from
`mechproof.codegen`.
"""

from mechproof.record.dimensions import ANGLE, FREQUENCY, LENGTH, NUMBER, SPEED, Dimension, Power
from mechproof.record.exactness import RecordError
from mechproof.record.expressions import (
    DerivativeWhere,
    FunctionWithoutArgument,
    IntegralWithoutDifferential,
    NthDerivative,
    ValueWhere,
    sum_distinct,
)
from mechproof.record.findings import Check, Cost, Finding, FollowingRow, Weight
from mechproof.record.forms import Chart, EmittedForm, Form, Peer
from mechproof.record.implicit import Root
from mechproof.record.needs import list_divisors, list_needs, list_partial
from mechproof.record.papers import RESERVED, Paper, PublishedSizes, Toleranced
from mechproof.record.quantities import (
    SLOPES,
    Accuracy,
    Argument,
    OnePass,
    Periodicity,
    Quantity,
    Scale,
    Singular,
)
from mechproof.record.relations import Slack
from mechproof.record.rows import (
    MARKS,
    ChainLink,
    Claim,
    Correction,
    Datum,
    Derived,
    Equation,
    Reading,
    Row,
    ours,
)
from mechproof.record.statements import (
    Completion,
    Completions,
    Conjunction,
    Definition,
    Distinct,
    Equality,
    Holds,
    NotCheckable,
    PrintedNumber,
    Statement,
    Unwritten,
    all_of,
    find_last_place,
    less,
    not_above,
    rounded,
)
from mechproof.record.variables import Notation, Part, Scope, Variable, family_of, list_given

__all__ = [
    "ANGLE",
    "FREQUENCY",
    "LENGTH",
    "MARKS",
    "NUMBER",
    "RESERVED",
    "SLOPES",
    "SPEED",
    "Accuracy",
    "Argument",
    "ChainLink",
    "Chart",
    "Check",
    "Claim",
    "Completion",
    "Completions",
    "Conjunction",
    "Correction",
    "Cost",
    "Datum",
    "Definition",
    "DerivativeWhere",
    "Derived",
    "Dimension",
    "Distinct",
    "EmittedForm",
    "Equality",
    "Equation",
    "Finding",
    "FollowingRow",
    "Form",
    "FunctionWithoutArgument",
    "Holds",
    "IntegralWithoutDifferential",
    "NotCheckable",
    "Notation",
    "NthDerivative",
    "OnePass",
    "Paper",
    "Part",
    "Peer",
    "Periodicity",
    "Power",
    "PrintedNumber",
    "PublishedSizes",
    "Quantity",
    "Reading",
    "RecordError",
    "Root",
    "Row",
    "Scale",
    "Scope",
    "Singular",
    "Slack",
    "Statement",
    "Toleranced",
    "Unwritten",
    "ValueWhere",
    "Variable",
    "Weight",
    "all_of",
    "family_of",
    "find_last_place",
    "less",
    "list_divisors",
    "list_given",
    "list_needs",
    "list_partial",
    "not_above",
    "ours",
    "rounded",
    "sum_distinct",
]
