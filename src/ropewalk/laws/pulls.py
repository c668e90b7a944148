"""What laws of segments add to the tension, folded as in `nodes`; all else of them is a law of nodes'."""

from __future__ import annotations

from typing import Any

from ropewalk.core.jit import kernel, part
from ropewalk.laws.node_law import NodeLaw
from ropewalk.laws.nodes import fold, whether
from ropewalk.laws.rare import acts


@part
def _no_pulls(system, state, x, v, tension):
    pass


def _pulling(law: NodeLaw, k: int, rest: Any) -> Any:
    carried = law.carried

    @part
    def _add_pulls(system, state, x, v, tension):
        if acts(system, k):
            carried(system.node[k], state, x, v, tension)
        rest(system, state, x, v, tension)

    return _add_pulls


add_pulls = fold(_pulling, _no_pulls, "carried")
"""add_pulls(system, state, x, v, tension): add what laws of segments carry along each [N], (s,)."""

pulls = whether("carried")
"""pulls(system): tell whether a law of segments acts."""


@kernel
def pulls_of_laws(system, state, x, v, tension):
    """Add what laws of segments carry at places `x` and velocities `v` [N], (s,); for the host."""
    add_pulls(system, state, x, v, tension)
