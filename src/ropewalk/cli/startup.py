"""What a process of the command line leaves out in order to start, and to end, sooner."""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def without_scipy() -> Iterator[None]:
    """Keep numba from importing scipy, where it is installed, while the kernels are loaded.

    numba looks for scipy's BLAS in order to compile products of matrices, of which no kernel here
    has any; the import takes as long as everything else that numba loads.
    """
    if "scipy" in sys.modules or "numba.np.arraymath" in sys.modules:
        yield
        return
    sys.modules["scipy"] = None  # type: ignore[assignment]
    try:
        yield
    finally:
        if sys.modules.get("scipy", 0) is None:  # else it was needed after all
            del sys.modules["scipy"]


def without_last_rites() -> None:
    """Have nothing collected at the process's end, whose memory goes back as a whole.

    Python's last search for garbage takes apart what numba and LLVM have made: 0.6 s of processor time,
    for which who had pressed Ctrl-C waited.
    """
    atexit.register(gc.freeze)
