"""What runs of a sweep are noted for, as remarks below its figures."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.note_kinds import kinds_in, noted

if TYPE_CHECKING:
    import xarray as xr


def notes_of_runs(data: xr.Dataset) -> list[str]:
    """Return a sentence for each kind of what tables of these runs warn of; none where none was kept."""
    if "notes" not in data:
        return []
    texts = [str(text) for text in np.ravel(data.notes.values).tolist()]
    ends = [str(end) for end in np.ravel(data.status.values).tolist()]  # of a store's own kind
    good = sum(end in ("finished", "at rest") for end in ends)
    counts = Counter(kind for text in texts for kind in kinds_in(text))
    return [f"{words}." for _, words in noted(counts, good)]
