"""The scene as it stands now, as one that can be written to a file: places and velocities in its shapes."""

from __future__ import annotations

import numpy as np

from ropewalk.live.session import Session
from ropewalk.scene import Kick, Points, Scene, SceneError


def scene_now(session: Session, *, fresh: bool = False) -> Scene:
    """Return the scene of the first variant as it stands, to begin a run with.

    With `fresh`, or with winches (whose rope on the drum no shape can tell), the scene as it was at time
    zero. Motions of anchors are those of the scene, counted from time zero again.
    """
    track = session.main
    if fresh or track.scene.winches:
        try:
            return session.initial(original=False)
        except SceneError:
            return track.scene
    layout, state = track.simulation.layout, track.simulation.arrays
    ropes = []
    for rope, span in zip(track.scene.ropes, layout.ropes, strict=True):
        nodes = slice(span.start, span.end + 1)
        places, speeds = state.x[:, nodes].T, state.v[:, nodes].T
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
    return track.scene.replace(ropes=ropes)


def _triples(array: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> list[tuple[float, ...]]:
    return [(float(x), float(y), float(z)) for x, y, z in array]
