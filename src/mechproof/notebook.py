"""Notebooks: papers, their ledgers, rows and mechanisms show themselves there as in a report."""

from __future__ import annotations


class Displayed:
    """What a notebook shows as a piece of a report; as text without the `derive` extra."""

    __slots__ = ()

    def _repr_html_(self) -> str | None:
        try:
            from mechproof.report.fragments import show
        except ModuleNotFoundError as error:
            if (error.name or "").startswith("mechproof"):
                raise
            return None
        return show(self)
