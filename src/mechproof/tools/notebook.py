"""Notebooks: papers, their ledgers, rows and mechanisms are displayed there as in a report."""

from __future__ import annotations

from collections.abc import Callable


def _show_nothing(shown: object) -> str | None:
    return None


class Displayed:
    """An object that notebooks show as a piece of a report, or as text without the `derive` extra.

    The package, which knows the report, sets how it is shown; the object itself does not know.
    """

    __slots__ = ()
    _show: Callable[[object], str | None] = staticmethod(_show_nothing)

    def _repr_html_(self) -> str | None:
        return type(self)._show(self)
