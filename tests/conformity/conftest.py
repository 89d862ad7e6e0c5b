"""The two ways to find exact shares, which run through the same tests."""

from __future__ import annotations

from typing import Any

import pytest
from cases import GROUP

from mechproof import conformity


def find_compiled(*arguments: Any) -> conformity.Shares:
    from mechproof.conformity.compiled import shares

    return shares(*arguments)


@pytest.fixture(
    params=[
        pytest.param(conformity.shares, id="NumPy"),
        pytest.param(find_compiled, id="compiled", marks=pytest.mark.xdist_group(GROUP)),
    ]
)
def find(request: pytest.FixtureRequest) -> Any:
    """Return a function that finds shares, in NumPy or compiled."""
    return request.param
