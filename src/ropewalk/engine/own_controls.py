"""What hands change of a whole scene, in the tables of an island."""

from __future__ import annotations

from ropewalk.engine.engine import Bodies, Controls
from ropewalk.engine.shares import Share


def own_controls(whole: Controls, share: Share, clamps: int) -> Controls:
    """Return the controls of a share; `clamps` is how many anchors have rows of `turns`, all or none."""
    kinds, drive, turns, bodies = whole
    return Controls(
        kinds[share.anchors],
        drive[:, share.winches],
        turns[:, share.anchors[:clamps]],
        Bodies._make(part[share.bodies] for part in bodies),
    )


def take_controls(own: Controls, whole: Controls, share: Share) -> None:
    """Take up in a share's controls what hands have changed."""
    found = own_controls(whole, share, own.turns.shape[1])
    own.kinds[:], own.drive[:], own.turns[:] = found.kinds, found.drive, found.turns
    for to, part in zip(own.bodies, found.bodies, strict=True):
        to[:] = part
