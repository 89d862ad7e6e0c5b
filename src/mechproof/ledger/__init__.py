"""The ledger: the judgements of a paper and its findings, as records and pages, and their cache."""
