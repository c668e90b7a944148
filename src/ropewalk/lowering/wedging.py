"""What several surfaces carry together of what presses a node between them, as in a groove."""

from __future__ import annotations

import numpy as np

from ropewalk.core.arrays import Floats


def pressing(normals: Floats, force: Floats) -> Floats:
    """Return normal forces, none below 0, (c,) [N], that come as near as they can to a force (3,) [N].

    Along `normals` (c, 3): by least squares, without those that would pull.
    """
    found, left = np.zeros(len(normals)), np.arange(len(normals))
    while left.size:
        tried = np.linalg.lstsq(normals[left].T, force, rcond=None)[0]
        if tried.min() >= 0.0:
            found[left] = tried
            break
        left = np.delete(left, tried.argmin())
    return found


def held_along(normals: Floats, friction: Floats, turn: Floats, aside: Floats) -> float:
    """Return by how much ln T may rise over a node of a rope without weight on c surfaces at once [1].

    Args:
        normals: (c, 3) of the surfaces [1].
        friction: (c,) coefficients [1].
        turn: (c,) angles by which the rope turns towards each, n_i . k of one vector k, n_i normals [rad].
        aside: (c,) ... within each [rad].

    The rope presses with T k, of which R_i n_i carry what they can; across the rest has friction to do, of
    mu_i R_i in all. In a groove whose sides are at an angle b to its bottom that is mu |k| / cos b, Euler's
    of a V-belt. Of one surface it is sqrt((mu turn)^2 - aside^2).
    """
    way = np.linalg.pinv(normals, 1e-9) @ turn
    pushes = pressing(normals, way)
    beyond = max(float((turn**2 + aside**2).max() - way @ way), 0.0)
    across = beyond + float(((way - pushes @ normals) ** 2).sum())
    return float(np.sqrt(max(float(pushes @ friction) ** 2 - across, 0.0)))
