"""One table of a result as a pandas DataFrame."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.errors import InputError, RunError
from ropewalk.record.selection import EXPORTED, select
from ropewalk.record.tables import tables
from ropewalk.words.nearest import nearest

if TYPE_CHECKING:
    import pandas as pd

    from ropewalk.record.result import Result

NAMES = ("nodes", "segments", "anchors", "run")


def to_pandas(
    result: Result,
    table: str,
    nodes: Sequence[int] | None,
    times: Sequence[float] | None,
    every: int | None,
    rope: str | None,
) -> pd.DataFrame:
    """Return a table of a result; see `Result.to_pandas`."""
    if table not in NAMES:
        raise InputError("table", table, f"no such table; {nearest(table, NAMES)}")
    try:
        import pandas
    except ImportError:
        raise RunError("to_pandas", "needs one package more: pip install pandas") from None
    chosen = select(result, EXPORTED, nodes, times, every, rope)
    found = {made.name: made for made in tables(result, chosen, "long")}
    if table not in found:
        raise InputError("table", table, f"this run has none; there is {', '.join(found)}")
    pieces = list(found[table].pieces())
    columns = [np.concatenate(parts) for parts in zip(*pieces, strict=True)]
    return pandas.DataFrame(dict(zip(found[table].headers, columns, strict=True)))
