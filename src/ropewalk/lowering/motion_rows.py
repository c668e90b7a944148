"""Anchors and their motions as rows of parameters for the kernels."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Anchors, Floats, Ints
from ropewalk.motions.rows import motion_rows
from ropewalk.scene import Anchor


def anchor_tables(
    anchors: tuple[Anchor, ...], origins: Floats, nodes: Ints, alike: Ints
) -> Anchors:
    """Return the anchors' tables; `origins` are the held nodes' initial places (a, 3) [m].

    For `alike` see `going_alike`.
    """
    release = [math.inf if a.release_time is None else a.release_time for a in anchors]
    return Anchors(
        release=np.array(release, dtype=np.float64),
        first_release=min(release, default=math.inf),
        above_ground=np.array([a.above_ground for a in anchors], dtype=np.int64),
        order=np.argsort(nodes, kind="stable"),
        alike=alike,
        **motion_rows([anchor.motion for anchor in anchors], origins)._asdict(),
    )
