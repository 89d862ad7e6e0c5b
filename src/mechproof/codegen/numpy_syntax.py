"""NumPy syntax: in, a program; out, its text. Nothing is decided here but brackets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from mechproof.codegen.program import TEMPORARY, Operand, Operation, Program

ATOM, POWER, SIGN, PRODUCT, SUM, BOTH, EITHER, COMPARISON = range(9, 1, -1)
# Sign and level of operations between two operands, the left one taken first.
INFIX: Mapping[str, tuple[str, int]] = MappingProxyType(
    {
        "add": ("+", SUM),
        "subtract": ("-", SUM),
        "multiply": ("*", PRODUCT),
        "divide": ("/", PRODUCT),
        "both": ("&", BOTH),
        "either": ("|", EITHER),
        "less": ("<", COMPARISON),
        "less_equal": ("<=", COMPARISON),
        "greater": (">", COMPARISON),
        "greater_equal": (">=", COMPARISON),
        "equal": ("==", COMPARISON),
    }
)
CALLS: Mapping[str, str] = MappingProxyType(
    {
        **{
            name: f"np.{name}"
            for name in (
                "sqrt", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "exp", "log",
                "hypot", "floor", "sign", "maximum",
            )
        },
        "absolute": "np.abs",
        "choose": "choose_where",
        **{
            name: name
            for name in (
                "is_finite", "product_rest", "sum_rest", "quotient_rest", "small_tangent",
                "tangent_quotient", "small_arctan", "single", "whole_turns_off",
            )
        },
    }
)  # fmt: skip
# The constants of the module that a function takes as its last argument.
FITTED: Mapping[str, str] = MappingProxyType(
    {"small_arctan": "ARCTANGENT", "tangent_quotient": "TANGENT"}
)
CONSTANTS: Mapping[str, str] = MappingProxyType(
    {"#pi": "np.pi", "#e": "np.e", "#inf": "np.inf", "#nan": "np.nan"}
)
VIEWS: Mapping[str, str] = MappingProxyType(
    {
        "along_first": "{}[..., :, np.newaxis]",
        "along_last": "{}[..., np.newaxis, :]",
        "transpose": "np.swapaxes({}, -1, -2)",
        "diagonal": "np.diagonal({}, axis1=-2, axis2=-1)",
    }
)
REDUCTIONS: Mapping[str, str] = MappingProxyType({"sum": "np.sum", "every": "np.all"})


@dataclass(frozen=True)
class Text:
    """The text of a program: an assignment for each named result, and the outputs."""

    steps: tuple[tuple[str, str], ...]
    outputs: tuple[str, ...]


def write_program(program: Program) -> Text:
    """Write a program; what has no name stands where it is used."""
    written: dict[str, tuple[str, int]] = {}
    steps = []
    for operation in program.operations:
        text, level = _write(operation, written)
        if operation.result.startswith(TEMPORARY):
            written[operation.result] = text, level
        else:
            steps.append((operation.result, text))
    outputs = tuple(_show(output, written)[0] for output in program.outputs)
    return Text(tuple(steps), outputs)


def _show(operand: Operand, written: Mapping[str, tuple[str, int]]) -> tuple[str, int]:
    if isinstance(operand, str):
        return written.get(operand, (CONSTANTS.get(operand, operand), ATOM))
    return repr(operand), ATOM if operand >= 0 else SIGN


def _enclose(operand: Operand, level: int, written: Mapping[str, tuple[str, int]]) -> str:
    """Show an operand, in brackets if it binds less than `level`."""
    text, own = _show(operand, written)
    return text if own >= level else f"({text})"


def _write(operation: Operation, written: Mapping[str, tuple[str, int]]) -> tuple[str, int]:
    kind, operands = operation.kind, operation.operands
    if kind in INFIX:
        sign, level = INFIX[kind]
        # Comparisons do not chain: both sides bind more.
        left = level + 1 if level == COMPARISON else level
        one, other = operands
        text = f"{_enclose(one, left, written)} {sign} {_enclose(other, level + 1, written)}"
        return text, level
    if kind == "negate":
        return f"-{_enclose(operands[0], SIGN, written)}", SIGN
    if kind == "square":
        return f"{_enclose(operands[0], ATOM, written)} ** 2", POWER
    if kind == "power":
        base, exponent = (_enclose(operand, ATOM, written) for operand in operands)
        return f"{base} ** {exponent}", POWER
    if kind == "copy":
        return _show(operands[0], written)
    if kind in VIEWS:
        return VIEWS[kind].format(operands[0]), ATOM
    if kind in REDUCTIONS:
        value, axes = operands
        assert isinstance(axes, int)
        where = "-1" if axes == 1 else str(tuple(range(-axes, 0)))
        return f"{REDUCTIONS[kind]}({_show(value, written)[0]}, axis={where})", ATOM
    arguments = [_show(operand, written)[0] for operand in operands]
    arguments += [FITTED[kind]] if kind in FITTED else []
    return f"{CALLS[kind]}({', '.join(arguments)})", ATOM
