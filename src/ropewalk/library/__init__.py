"""The rope library: real ropes, with a source for every number, and guesses marked as such.

It knows of no scenes. `rope("dynamic-single-9.8")` is an entry; `names()` are all.
"""

from ropewalk.library.entry import LibraryRope, Number
from ropewalk.library.store import UnknownRope, families, names, rope, search, sources

__all__ = [
    "LibraryRope",
    "Number",
    "UnknownRope",
    "families",
    "names",
    "rope",
    "search",
    "sources",
]
