"""The fields of a rope that relaxes, the standard linear solid; see `laws.relaxing`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ropewalk.scene.base import positive
from ropewalk.scene.faults import MISSING, Fault

if TYPE_CHECKING:
    from ropewalk.scene.rope import Material


def relaxing_EA() -> Any:
    """Return the field of the arm's stiffness."""
    use = "Axial stiffness beside EA that relaxes: a spring and a damper in series; needs relaxation_time"
    return positive(use, "N", default=None)


def relaxation_time() -> Any:
    """Return the field of the arm's time."""
    use = "Time in which the tension of relaxing_EA falls to its e-th part at a held length"
    return positive(use, "s", default=None)


def solid_faults(made_of: Material) -> list[Fault]:
    """What a material that relaxes lacks, or cannot have besides."""
    EA, time = made_of.relaxing_EA, made_of.relaxation_time
    if EA is None and time is None:
        return []
    faults = []
    if EA is None:
        faults.append(
            Fault("relaxing_EA", MISSING, "relaxation_time needs the stiffness that relaxes (N)")
        )
    elif time is None:
        faults.append(
            Fault("relaxation_time", MISSING, "relaxing_EA needs the time in which it relaxes (s)")
        )
    if math.isinf(made_of.EA):
        rule = "leave it out: rigid links (EA = inf) do not stretch, so nothing relaxes"
        faults.append(Fault("relaxing_EA", EA, rule))
    if made_of.tension_only and made_of.axial_damping > 0.0:
        rule = "leave it out beside relaxing_EA with tension_only: the loss of such a rope is its relaxation"
        faults.append(Fault("axial_damping", made_of.axial_damping, rule))
    return faults
