"""What to say of a name that is not known."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from itertools import islice

_MOST_LISTED = 30
_MOST_COMPARED = 300  # comparing takes a fraction of a millisecond each


def nearest(name: str, known: Iterable[str]) -> str:
    """Return which known name may be meant, else what names there are (of very many the first)."""
    names = list(known)
    close = close_name(name, names)
    if close:
        return f'did you mean "{close}"?'
    if not names:
        return "there is none"
    more = f" and {len(names) - _MOST_LISTED} more" if len(names) > _MOST_LISTED else ""
    return "known: " + ", ".join(names[:_MOST_LISTED]) + more


def close_name(name: str, known: Iterable[str], cutoff: float = 0.5) -> str:
    """Return the known name that is most like `name`, or "" when none is; `cutoff` is from 0 to 1."""
    names = list(islice(known, _MOST_COMPARED))
    return next(iter(difflib.get_close_matches(str(name).lower(), names, n=1, cutoff=cutoff)), "")
