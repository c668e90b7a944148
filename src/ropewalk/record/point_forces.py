"""What joints, obstacles and other ropes do to nodes, as a part of every result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.laws.contact_books import ENTRIES
from ropewalk.record.books import told
from ropewalk.record.quantities import CONTACT_WORK, OBSTACLE_FORCE, PULLEYS

if TYPE_CHECKING:
    from ropewalk.record.contacts import WrapHistory
    from ropewalk.record.moving_rows import SlideMotion
    from ropewalk.record.result import Result


class PulleyMotion(NamedTuple):
    """How an obstacle turned that turns freely, one row a frame; works since the start."""

    angle: Floats  # (frames,) [rad]
    speed: Floats  # (frames,) [rad/s]
    energy: Floats  # (frames,) kinetic [J]
    rope_work: Floats  # (frames,) of the ropes on it [J]
    bearing_work: Floats  # (frames,) of its bearing on it [J]
    rope_torque: Floats  # (frames,) of the ropes in the last step [N m]
    weight_work: Floats  # (frames,) of its own weight on it [J], 0 where it has no mass


class PointForces:
    """The forces of joints and contacts; part of every Result."""

    @property
    def joint_forces(self) -> Floats:
        """Force of a joint on each node that it ties [N], (frames, ties, 3), mean over the last step.

        In the order of the scene's joints and their points, as in `layout.ties`; `joint_force` gives one
        joint's. Of the steps between two frames nothing is kept.
        """
        result = cast("Result", self)
        if "joint_forces" not in result.source.names:
            return np.zeros((result.frames, 0, 3))
        return result.read("joint_forces")

    def joint_force(self, name: str) -> Floats:
        """Force of one joint on each node that it ties [N], (frames, points, 3), mean over the last step.

        Over the points it adds up to nothing, or to the force of the anchor that holds the joint.

        Raises KeyError where the scene has no joint of that name.
        """
        scene, first = cast("Result", self).scene, 0
        wanted = scene.joint_named(name)
        for joint in scene.joints:
            if joint.name == wanted.name:
                break
            first += len(joint.points)
        return self.joint_forces[:, first : first + len(wanted.points)]

    @property
    def contact_force(self) -> Floats:
        """Force of all contacts on each node at each frame [N], (frames, nodes, 3); 0 without contact."""
        result = cast("Result", self)
        if "contact_force" not in result.source.names:
            return np.zeros((result.frames, result.layout.nodes, 3))
        return result.read("contact_force")

    @property
    def obstacle_force(self) -> Floats:
        """Force of obstacles alone on each node at each frame [N], (frames, nodes, 3).

        NaN in runs that were recorded before it was kept apart from that of ropes, where both can touch.
        """
        result = cast("Result", self)
        if OBSTACLE_FORCE in result.source.names:
            return result.read(OBSTACLE_FORCE)
        if result.scene.contact is None:
            return self.contact_force
        shape = (result.frames, result.layout.nodes, 3)
        return np.full(shape, np.nan if result.scene.obstacles else 0.0)

    def pulley(self, name: str) -> PulleyMotion:
        """How an obstacle turned that turns freely: angle, speed, energy, works, torque.

        What ropes, bearing and its own weight have done on it is the change of its energy, to rounding.

        Raises KeyError where no obstacle of that name turns freely.
        """
        result = cast("Result", self)
        names = result.layout.pulleys
        if name not in names:
            known = ", ".join(names) or "(none)"
            raise KeyError(f"name one of the obstacles that turn freely, {known}, not {name!r}")
        columns = result.read("pulleys")[:, names.index(name)]
        return PulleyMotion(*columns.T)

    @property
    def contact_work(self) -> Mapping[str, Mapping[str, Floats]]:
        """Work on the ropes of what they touch since the start [J], (frames,) each, by surface and entry.

        Surfaces are obstacles by name, and "ropes on ropes". Of each the entries add up to its work: motor,
        by what moves or turns it (force times way, torque times angle), of ropes what presses up those that
        lie still in each other's skin; normal, taken where contacts close; friction, taken where they slip;
        stored, less what contacts have stored; method, the part in the error of the steps. NaN without a
        ledger; empty where there is nothing to touch, and in runs that were recorded before there were
        entries.
        """
        result = cast("Result", self)
        if CONTACT_WORK not in result.source.names:
            return {}
        array = told(result, CONTACT_WORK, result.read(CONTACT_WORK))
        return {
            surface: {entry: array[:, k, e] for e, entry in enumerate(ENTRIES)}
            for k, surface in enumerate(result.layout.surfaces)
        }

    def slide(self, name: str) -> SlideMotion:
        """How a node slid along its rope: place [m], speed, load, and the speed of its rope's centre of mass.

        Raises KeyError where the scene has no slide of that name.
        """
        from ropewalk.record.moving_rows import slide_motion

        return slide_motion(cast("Result", self), name)

    def obstacle_positions(self, frames: slice = slice(None)) -> Floats:
        """Where obstacles are at some frames [m], (frames, obstacles, 3): their middles; planes: a point."""
        from ropewalk.record.obstacle_table import obstacle_places

        result = cast("Result", self)
        times, angles = result.time[frames], self.obstacle_angles(frames)
        return obstacle_places(result.scene, result.layout, times, angles)

    def obstacle_angles(self, frames: slice = slice(None)) -> Floats:
        """How far obstacles have turned about their axes at some frames [rad], (frames, obstacles)."""
        from ropewalk.record.obstacle_table import obstacle_angles

        result = cast("Result", self)
        found = obstacle_angles(result.scene, result.layout, result.time[frames])
        if result.layout.pulleys:
            names = [body.name for body in result.scene.obstacles]
            free = [names.index(name) for name in result.layout.pulleys]
            rows = np.arange(result.frames)[frames]
            start = int(rows.min(initial=result.frames))
            read = result.read(PULLEYS, start, int(rows.max(initial=-1)) + 1)
            found[:, free] = read[rows - start, :, 0]
        return found

    @property
    def contact_modes(self) -> NDArray[np.int8]:
        """What every node does on obstacles at each frame, (frames, nodes).

        0 open, 1 sticks, 2 slips; 3 unknown: it touches a rope as well, in a run that was recorded before
        the force of obstacles was kept apart. -1 of a rope that broke, where others went on after that.
        """
        from ropewalk.record.contacts import contact_modes

        return contact_modes(cast("Result", self))

    def wrap(self, obstacle: str, rope: str | None = None) -> WrapHistory:
        """How a rope lies on an obstacle at each frame: nodes, angle [rad], tensions before and after [N].

        Of a rope that comes back to it, as in a tackle, the angle is that of all stretches there, and the
        ratio NaN: the table "wraps" has them one by one.

        Raises KeyError for an unknown name, or for no rope's name with several ropes.
        """
        from ropewalk.record.contacts import wrap_history

        return wrap_history(cast("Result", self), rope, obstacle)
