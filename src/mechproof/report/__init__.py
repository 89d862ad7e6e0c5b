"""The report: what was read, judged, proved and measured of papers, as pages for a browser.

A static site with one stylesheet: a start page, a page for each paper and one for each quantity; or
a single file that contains them all. It needs no network and no script. In a notebook a paper, its
ledger, a row and a mechanism show themselves with the same templates. Needs the `derive` extra.
"""

from mechproof.report.pages import check_file, join_pages
from mechproof.report.site import (
    Site,
    build_site,
    check_folder,
    keep_shares,
    key_shares,
    load_shares,
    write_folder,
)

__all__ = [
    "Site",
    "build_site",
    "check_file",
    "check_folder",
    "join_pages",
    "keep_shares",
    "key_shares",
    "load_shares",
    "write_folder",
]
