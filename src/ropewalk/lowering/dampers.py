"""Dampers of obstacles at joints: what presses there stops all that is tied to it.

The thickest nodes of a joint press, each for an even part of what it ties. Bodies that throw back have
dampers for just that. Of others a damper is left as the rope's own nodes have it, unless what it stops is
more than twice as heavy: steps of explicit methods, whose plan counts every node by itself, hang on it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ropewalk.core.arrays import Floats, Ints
from ropewalk.laws.obstacle import DAMPING, Obstacles, radius_of
from ropewalk.laws.striking import striking
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Scene

OFF = (
    2.0  # [1] masses that differ by less: a rope's ends have half of what its dampers are made for
)


def joined_nodes(scene: Scene, layout: Layout) -> Iterator[tuple[Ints, Ints]]:
    """Yield the nodes of every joint, and the thickest of them."""
    for joint in scene.joints:
        nodes = np.array([layout.node(tie.node, tie.rope) for tie in joint.points])
        thick = np.array([radius_of(scene.rope_named(tie.rope)) for tie in joint.points])
        yield nodes, nodes[thick == thick.max()]


def masses_to_stop(scene: Scene, layout: Layout, mass: Floats, tied: Ints | None = None) -> Floats:
    """Return what a contact of every node stops [kg], (n,): of a joint all that it ties, of these masses.

    In even parts, one for each of its thickest nodes. Joints that are 0 in `tied` have let go.
    """
    found = mass.copy()
    for j, (nodes, thickest) in enumerate(joined_nodes(scene, layout)):
        if tied is None or tied[j] != 0:
            found[nodes] = mass[nodes].sum() / len(thickest)
    return found


def suited(
    table: Obstacles, scene: Scene, layout: Layout, mass: Floats, tied: Ints | None = None
) -> Floats:
    """Return the table's dampers for what joints tie to nodes of a `mass`, (n,) [kg], (k, n) [N s/m]."""
    stops, damping = masses_to_stop(scene, layout, mass, tied), table.damping.copy()
    back = table.ratio < 1.0
    damping[back] = np.where(stops > 0.0, _critical(table, stops), damping)[back]
    strikes = mass.copy()
    for rope, span in zip(scene.ropes, layout.ropes, strict=True):
        here = slice(span.start, span.end + 1)
        strikes[here] = striking(rope, mass[here])
    strikes = np.maximum(strikes, stops)
    made_for = (0.5 * damping / DAMPING) ** 2 / table.stiffness
    for _, thickest in joined_nodes(scene, layout):
        made, heavy = made_for[:, thickest].sum(axis=1), strikes[thickest].sum()
        off = ~back & ((heavy > OFF * made) | (OFF * heavy < made))
        damping[np.ix_(off, thickest)] = _critical(table, strikes)[np.ix_(off, thickest)]
    return damping


def _critical(table: Obstacles, mass: Floats) -> Floats:
    """Return dampers with which nodes of a mass [kg] do not ring [N s/m], (k, n)."""
    found: Floats = 2.0 * DAMPING * np.sqrt(table.stiffness * mass)
    return found
