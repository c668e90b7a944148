"""Ropes that winches wind, carried over into another scene: as far out as they are, of what it is made of.

What a winch has changed is in the state alone: rest lengths, and with them stiffness and friction, which are
those of the material over them, and masses of nodes. The mass of all rope that is off drums is its mass per
length times its unstretched length, debts included, wherever that is; so another material changes all of it
alike. Loads are the scene's, and stay where they hang: at a drum, where it is.
"""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, State
from ropewalk.laws.winch import set_segment
from ropewalk.live.parameters import refusal
from ropewalk.lowering import Model
from ropewalk.lowering.layout import Span
from ropewalk.scene import Scene, Winch
from ropewalk.simulation import Simulation

# What would be another number of nodes, or other pieces on the drum.
WOUND_FIXED = {"length", "segments"}
WHILE_WOUND = "while a winch winds the rope: what is on its drum is in segments of one length"

_OF_WINCHES = ("winch_rate", "winch_debt", "winch_paid")
_MATERIAL = ("EA", "vector", "axial")  # columns of the table that segments follow from
_OF_SEGMENTS = ("stiffness", "damping_vector", "damping_axial")
_set_segments = getattr(set_segment, "py_func", set_segment)  # of many segments at once


def is_wound(scene: Scene, rope: str) -> bool:
    """Tell whether a winch winds this rope."""
    return any(winch.rope == rope for winch in scene.winches)


def _end(span: Span, winch: Winch) -> int:
    """Return the node of the scene's end at which a winch stands, which a load there goes by."""
    return span.start if winch.end == "start" else span.end


def carry_winches(old: Simulation, model: Model) -> None:
    """Let the wound ropes of a new model be out as they are in `old`, which has the same winches and names.

    Sets rest lengths, stiffnesses, frictions and masses of their spans, the drums' exits and the nodes of
    their anchors. Where a rope is what it was, and bears what it bore, all keeps its bits. Raises SceneError
    for another load on what is on a drum.
    """
    before, state, winches = old.arrays, model.state, model.system.winches
    for name in _OF_WINCHES:
        getattr(state, name)[...] = getattr(before, name)
    for row, winch in enumerate(model.scene.winches):
        there, here = old.layout.span(winch.rope), model.layout.span(winch.rope)
        state.winch_exit[row] = before.winch_exit[row] + here.first - there.first
        state.anchor_node[winches.anchor[row]] = state.winch_exit[row]
    for row, winch in enumerate(model.scene.winches):
        there, here = old.layout.span(winch.rope), model.layout.span(winch.rope)
        _carry_segments(old, model, row, there, here)
        _carry_masses(old, model, row, there, here)


def _carry_segments(old: Simulation, model: Model, row: int, there: Span, here: Span) -> None:
    """Carry rest lengths, and what follows from them: as it is, or by the new material."""
    before, state = old.arrays, model.state
    was, now = slice(there.first, there.last), slice(here.first, here.last)
    state.rest_length[now] = before.rest_length[was]
    for name in _OF_SEGMENTS:
        getattr(state, name)[now] = getattr(before, name)[was]
    tables = old.system.winches, model.system.winches
    if any(getattr(tables[0], one)[row] != getattr(tables[1], one)[row] for one in _MATERIAL):
        alive = here.first + np.flatnonzero(state.rest_length[now])  # neither on a drum nor parted
        _set_segments(tables[1], state, row, alive, state.rest_length[alive])


def _carry_masses(old: Simulation, model: Model, row: int, there: Span, here: Span) -> None:
    """Carry the masses of nodes: the rope's own by its mass per length, and loads by the scene."""
    was, now = slice(there.first, there.last + 1), slice(here.first, here.last + 1)
    hung = _loads(old.scene, old.arrays, there)
    hangs = _loads(model.scene, model.state, here)
    ratio = float(model.system.winches.line[row] / old.system.winches.line[row])
    mass = old.arrays.mass[was]
    for i in np.flatnonzero(hung != hangs):
        _refuse_on_drum(model.scene, model.state, here, here.first + int(i))
    new = np.maximum(mass - hung, 0.0) * ratio + hangs
    same = (hung == hangs) & (ratio == 1.0)
    model.state.mass[now] = np.where(same, mass, new)


def _refuse_on_drum(scene: Scene, state: State, span: Span, index: int) -> None:
    """Raise SceneError where no load can be hung, or taken off: on a drum, or at an end that has left it."""
    for row, winch in enumerate(scene.winches):
        drum, end = int(state.winch_exit[row]), _end(span, winch)
        beyond = index <= drum if winch.end == "start" else index >= drum
        if winch.rope == span.name and beyond and not index == drum == end:
            rule = (
                "is on a winch's drum, or came off it since the start: choose a point farther out"
            )
            raise refusal("node", index - span.start, rule)


def _loads(scene: Scene, state: State, span: Span) -> Floats:
    """Return what hangs on the nodes of a wound rope [kg], (nodes,); loads of an end are on its drum."""
    rope, loads = scene.rope_named(span.name), np.zeros(span.nodes)
    drums = {
        _end(span, winch): int(state.winch_exit[row])
        for row, winch in enumerate(scene.winches)
        if winch.rope == rope.name
    }
    for one in rope.loads:
        node = span.start + rope.node_index(one.node)
        loads[drums.get(node, node) - span.first] += one.mass
    return loads
