"""Tables of specimens: one module for each system or statistic, each binding a `Table`.

A module is named like its derivation and found by looking into this folder.
"""
