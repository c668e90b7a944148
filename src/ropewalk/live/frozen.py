"""The scene as it stands now, as one that can be written to a file: places and velocities in its shapes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.parameters import initial
from ropewalk.live.session import Session
from ropewalk.lowering import Layout
from ropewalk.scene import Kick, Points, Scene, SceneError


@dataclass(frozen=True)
class Frozen:
    """A copy of what a scene is made of: quickly taken, and made into a scene by any thread."""

    scene: Scene
    loaded: Scene
    changes: dict[Any, Any]
    layout: Layout
    places: Floats  # (3, n) [m]
    speeds: Floats  # (3, n) [m/s]
    fresh: bool

    @classmethod
    def of(cls, session: Session, *, fresh: bool = False) -> Frozen:
        """Take the first variant of a session; see `scene_now`."""
        track = session.main
        state = track.simulation.arrays
        return cls(
            track.scene,
            session.loaded,
            dict(session.changes),
            track.simulation.layout,
            state.x.copy(),
            state.v.copy(),
            fresh or bool(track.scene.winches),
        )

    def thaw(self) -> Scene:
        """Return the scene."""
        if self.fresh:
            try:
                return initial(self.loaded, self.changes)
            except SceneError:
                return self.scene
        ropes = []
        for rope, span in zip(self.scene.ropes, self.layout.ropes, strict=True):
            nodes = slice(span.start, span.end + 1)
            places, speeds = self.places[:, nodes].T, self.speeds[:, nodes].T
            try:
                shape = Points(points=_triples(places))
                kicks = [
                    Kick(node=i, velocity=tuple(float(u) for u in speed))
                    for i, speed in enumerate(speeds)
                    if speed.any()
                ]
                ropes.append(rope.replace(shape=shape, kicks=kicks))
            except SceneError:  # two nodes in one place
                ropes.append(rope)
        return self.scene.replace(ropes=ropes)


def scene_now(session: Session, *, fresh: bool = False) -> Scene:
    """Return the scene of the first variant as it stands, to begin a run with.

    With `fresh`, or with winches (whose rope on the drum no shape can tell), the scene as it was at time
    zero. Motions of anchors are those of the scene, counted from time zero again.
    """
    return Frozen.of(session, fresh=fresh).thaw()


def _triples(array: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> list[tuple[float, ...]]:
    return [(float(x), float(y), float(z)) for x, y, z in array]
