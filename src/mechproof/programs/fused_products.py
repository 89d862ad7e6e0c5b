"""Fused products: in, a program; out, one that rounds products together with the sums they enter.

Of two products, the first is fused.
"""

from __future__ import annotations

from dataclasses import replace

from mechproof.programs.program import TEMPORARY, Operand, Operation, Program, is_unnamed

PRODUCTS, SUMS = ("multiply", "square"), ("add", "subtract")


def fuse_products(program: Program) -> Program:
    """Return a program that computes each sum of an unnamed product by an fma."""
    made = {step.result: step for step in program.operations}
    operations: list[Operation] = []
    for step in program.operations:
        if step.kind in SUMS:
            one, other = (made.get(str(o)) if is_unnamed(o) else None for o in step.operands)
            if one and one.kind in PRODUCTS:
                operations += _fuse_first(step, one)
                continue
            if other and other.kind in PRODUCTS:
                operations += _fuse_second(step, other)
                continue
        operations.append(step)
    used = {operand for step in operations for operand in step.operands}.union(program.outputs)
    needed = (s for s in operations if s.result in used or not is_unnamed(s.result))
    return replace(program, operations=tuple(needed)).normal_form()


def _fuse_first(total: Operation, product: Operation) -> list[Operation]:
    """Return the operations of a*b + c or a*b - c."""
    rest, steps = total.operands[1], list[Operation]()
    if total.kind == "subtract":
        rest = _negate(rest, total, steps)
    return [*steps, Operation(total.result, "fma", (*_list_factors(product), rest))]


def _fuse_second(total: Operation, product: Operation) -> list[Operation]:
    """Return the operations of c + a*b or c - a*b."""
    (one, other), steps = _list_factors(product), list[Operation]()
    if total.kind == "subtract":
        one = _negate(one, total, steps)
    return [*steps, Operation(total.result, "fma", (one, other, total.operands[0]))]


def _list_factors(product: Operation) -> tuple[Operand, Operand]:
    return product.operands[0], product.operands[-1]


def _negate(operand: Operand, total: Operation, steps: list[Operation]) -> Operand:
    if not isinstance(operand, str):
        return -operand
    steps.append(Operation(f"{TEMPORARY}minus{total.result}", "negate", (operand,)))
    return steps[-1].result
