"""A body that turns freely as it stands now: turned as far as it has come, for it begins at no angle."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ropewalk.laws.obstacle_rows import axle_of, hub_of, sweeps

PLACES = ("center", "point", "start", "end", "position")  # of a body, whichever it has
_DIRECTIONS = ("axis", "normal", "open_to")


def turned(body: Any, angle: float) -> Any:
    """Return a body turned by an angle [rad] about its axle, with its centre of mass.

    One that turns about a pivot while a table or an orbit moves its middle is left as it is.
    """
    spin = body.spin
    if spin.pivot is not None and body.motion.kind in ("table", "orbit"):
        return body
    turn, hub = Rotation.from_rotvec(angle * axle_of(body)), hub_of(body)
    changes = dict[str, Any]()
    if spin.center_of_mass is not None:
        there = hub + turn.apply(np.subtract(spin.center_of_mass, hub))
        changes["spin"] = spin.replace(center_of_mass=tuple(map(float, there)))
    if sweeps(body):
        for name in (*PLACES, *_DIRECTIONS):
            if (old := getattr(body, name, None)) is not None:
                zero = hub if name in PLACES else np.zeros(3)
                changes[name] = tuple(map(float, zero + turn.apply(np.subtract(old, zero))))
        if (old := getattr(body, "rotation", None)) is not None:
            changes["rotation"] = tuple(map(float, (turn * Rotation.from_rotvec(old)).as_rotvec()))
    return body.replace(**changes) if changes else body
