"""scipy's sparse matrices, for whoever needs them."""

from __future__ import annotations

import sys
from importlib import import_module


def load_scipy() -> None:
    """Import scipy, also where the command line keeps numba from doing so (`cli.startup`)."""
    if sys.modules.get("scipy", 0) is None:
        del sys.modules["scipy"]
    import_module("scipy.sparse.linalg")
