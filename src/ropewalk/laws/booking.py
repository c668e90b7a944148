"""Books that laws of nodes keep of their own, see `NodeLaw.book`, folded into one part."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import part
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.nodes import fold
from ropewalk.laws.rare import acts


@part
def _nothing_to_book(system, state, forces, middle, dt):
    pass


def _booking(law: NodeLaw, k: int, rest: Any) -> Any:
    book = law.book

    @part
    def _book(system, state, forces, middle, dt):
        if acts(system, k):
            book(system.node[k], state, forces.node[k], middle, dt)
        rest(system, state, forces, middle, dt)

    return _book


book_nodes = fold(_booking, _nothing_to_book, "book")
"""book_nodes(system, state, forces, middle, dt): let laws with books of their own keep them."""
