"""Parts of scipy, for whoever needs them."""

from __future__ import annotations

import sys
from importlib import import_module


def load_scipy(part: str = "sparse.linalg") -> None:
    """Import a part of scipy, also where the command line keeps numba from doing so (`cli.startup`)."""
    if sys.modules.get("scipy", 0) is None:
        del sys.modules["scipy"]
    import_module(f"scipy.{part}")
