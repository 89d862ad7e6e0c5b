"""Notebooks: papers, their ledgers, rows and mechanisms show themselves there as in a report."""

from __future__ import annotations

from collections.abc import Callable


def _show_nothing(shown: object) -> str | None:
    return None


class Displayed:
    """What a notebook shows as a piece of a report; as text without the `derive` extra.

    The package, which knows the report, says how: what is shown does not.
    """

    __slots__ = ()
    _show: Callable[[object], str | None] = staticmethod(_show_nothing)

    def _repr_html_(self) -> str | None:
        return type(self)._show(self)
