"""What is broken about a state: in words, with the place and the numbers."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import State, System
from ropewalk.core.status import HONEST, TAKEN, ZERO
from ropewalk.engine.no_room import no_room
from ropewalk.engine.too_near import fault_of, finer, one_of
from ropewalk.laws.slides.sliding import lost
from ropewalk.lowering import Layout, Plan
from ropewalk.methods.verdict import energy_now
from ropewalk.scene import Scene

#: Ends a reason where the numbers are right: a rope was stretched beyond what is one.
ACCOUNTED = "its energy is accounted for"


_DOUBT = 1.5  # [1] energy over what was there to turn over that is called made up


def off_rope(state: State, layout: Layout, system: System, plan: Plan) -> str:
    """Say which node has come off the rope that it slides along; "" where none has."""
    row = lost(state)
    if row is None:
        return ""
    table = system.node.slide
    rope, node = layout.rope_of(int(table.node[row]))
    line, _ = layout.rope_of(int(table.first[row]))
    return (
        f"node {node} of rope {rope!r} has been pulled off rope {line!r}, along which it slides, by more "
        f"than half a segment of it: take {one_of(*finer(plan), 'a stiffer slide (its compliance)')}"
    )


def reason(system: System, state: State, layout: Layout, scene: Scene, plan: Plan) -> str:
    """Say what `methods.verdict` found wrong with a state."""
    bad = np.flatnonzero(~(np.isfinite(state.x) & np.isfinite(state.v)).all(axis=0))
    if bad.size:
        rope, node = layout.rope_of(int(bad[0]))
        return f"node {node} of rope {rope!r} has no finite place or speed any more"
    if fault := no_room(system, state, layout, scene) or fault_of(state, layout, scene, plan):
        return fault
    if fault := off_rope(state, layout, system, plan):
        return fault
    size = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0))
    live = (state.rest_length > 0.0) & (state.stiffness > 0.0)
    stretch = np.divide(size, state.rest_length, out=np.zeros_like(size), where=live)
    longest = int(np.argmax(stretch))
    balance = state.balance
    more, taken = energy_now(system, state) - float(balance[ZERO]), float(balance[TAKEN])
    gain, given = max(more + max(taken, 0.0), -taken), float(balance[HONEST] + state.most.sum())
    did = "taken" if taken > 0.0 else "put in"
    limiter = f", the limiter has {did} {abs(taken):.4g} J" if abs(taken) > abs(more) else ""
    energy = (
        f"the ropes have {more:.4g} J more than at the start{limiter}, and all that was there to turn over, "
        f"what anchors and winches gave included, is {given:.4g} J"
    )
    if stretch[longest] > system.break_stretch:
        rope, segment = layout.rope_of(longest)
        made_up = f"; {energy}" if gain > _DOUBT * given else f"; {ACCOUNTED}"
        return f"segment {segment} of rope {rope!r} is {stretch[longest]:.4g} times its rest length{made_up}"
    return energy
