"""The rope library: real ropes, with a source for every number, and guesses marked as such.

It knows of no scenes. `rope("dynamic-single-9.8")` is an entry; `names()` are all.
"""

from ropewalk.library.catalogue import UnknownRope, families, names, rope, search, sources
from ropewalk.library.entry import LibraryRope, Number

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
