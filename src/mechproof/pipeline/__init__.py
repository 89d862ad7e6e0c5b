"""The pipeline: what commands call, from papers to verdicts, certificates and generated files."""
