"""Joints in the arrays: which nodes they tie, at one place and velocity at the start."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats, Ints, Joints, State
from ropewalk.lowering.layout import Layout
from ropewalk.scene import Joint, Rope, Scene, SceneError, Tie
from ropewalk.scene.faults import Fault

TOGETHER = (
    1e-9  # [1] nodes of a joint lie together, over the length of a rope or the size of a place
)


def joint_tables(joints: tuple[Joint, ...], layout: Layout) -> Joints:
    """Return the tables of the joints."""
    members = [[layout.node(tie.node, tie.rope) for tie in joint.points] for joint in joints]
    first = np.cumsum([0] + [len(nodes) for nodes in members])
    joint_of = {node: j for j, nodes in enumerate(members) for node in nodes}
    held = [joint_of.get(node, -1) for node in layout.anchor_nodes]
    member = [node for nodes in members for node in nodes]
    return Joints(*(np.array(part, np.int64) for part in (first, member, held)))


def join(scene: Scene, layout: Layout, state: State) -> None:
    """Put the nodes of every joint at one place, with one velocity, to the last bit.

    Raises SceneError where they lie apart, or begin to move apart.
    """
    faults = []
    for j, joint in enumerate(scene.joints):
        nodes = np.array([layout.node(tie.node, tie.rope) for tie in joint.points])
        x = state.x[:, nodes]
        lengths = [scene.rope_named(tie.rope).length_unstretched for tie in joint.points]
        allowed = TOGETHER * max(*lengths, float(np.abs(x).max()))
        apart = np.sqrt(((x - x[:, :1]) ** 2).sum(axis=0))
        for k in np.flatnonzero(apart > allowed).tolist():
            rule = (
                f"lies at {_place(x[:, k])} m at the start, {apart[k]:.6g} m from points[0] at "
                f"{_place(x[:, 0])} m; draw the ropes so that what is tied lies at one place"
            )
            faults.append(Fault(f"joint[{j}].points[{k}]", _name(joint.points[k]), rule))
        velocity, why = _velocity(scene, joint, state.v[:, nodes])
        if why is not None:
            faults.append(Fault(f"joint[{j}].points[{why}]", _name(joint.points[why]), _APART))
        state.x[:, nodes], state.v[:, nodes] = x[:, :1], velocity[:, None]
    if faults:
        raise SceneError(faults)


_APART = (
    "begins with another velocity than what it is tied to; give the ropes one velocity, or one kick"
)


def _velocity(scene: Scene, joint: Joint, v: Floats) -> tuple[Floats, int | None]:
    """Return the velocity of a joint and the first point that begins with another one.

    `v` (3, p) are those of the nodes by themselves. A kick counts for all nodes that are tied.
    """
    kicked = [
        k for k, tie in enumerate(joint.points) if _is_kicked(scene.rope_named(tie.rope), tie)
    ]
    asked = kicked or list(range(len(joint.points)))
    first = v[:, asked[0]].copy()
    for k in asked[1:]:
        if (v[:, k] != first).any():
            return first, k
    return first, None


def _is_kicked(rope: Rope, tie: Tie) -> bool:
    node = rope.node_index(tie.node)
    return any(rope.node_index(kick.node) == node for kick in rope.kicks)


def _name(tie: Tie) -> str:
    return f"node {tie.node} of {tie.rope}"


def _place(x: Floats) -> str:
    return f"({x[0]:.6g}, {x[1]:.6g}, {x[2]:.6g})"


def tied_with(joints: Joints, tied: Ints, node: int) -> Ints:
    """Return the nodes that are tied to one now, itself included, as indices of the arrays."""
    for j in np.flatnonzero(tied):
        member = joints.member[joints.first[j] : joints.first[j + 1]]
        if node in member:
            return member
    return np.array([node])
