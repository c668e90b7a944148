"""All kinds of motion, and their codes in the rows of kernels: places in this list."""

from __future__ import annotations

from ropewalk.motions.kind import Motion
from ropewalk.motions.orbit import ORBIT
from ropewalk.motions.shake import SHAKE
from ropewalk.motions.tabulated import TABLE
from ropewalk.motions.velocity import VELOCITY

MOTIONS = (
    Motion("fixed"),
    VELOCITY,
    TABLE,
    SHAKE,
    ORBIT,
    Motion("hand"),  # the host sets the velocity; the place is its sum over the steps
)
CODES = {motion.name: code for code, motion in enumerate(MOTIONS)}
FIXED, HAND = CODES["fixed"], CODES["hand"]
