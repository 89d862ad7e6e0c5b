"""Command line: verify papers, regenerate kernels and ledger, measure what they lose and cost."""

from mechproof.cli.commands import app

__all__ = ["app"]
