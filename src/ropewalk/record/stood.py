"""Whether bodies stood in a saved equilibrium: older versions let them press and rub by their speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ropewalk.record.facts import AT_REST
from ropewalk.scene.obstacles import name_of

if TYPE_CHECKING:
    from ropewalk.record.result import Result

#: In the provenance of an equilibrium, among its statics: its bodies stand. Older versions have not said so.
STAND = "bodies_stand"


def stood_note(result: Result) -> str:
    """Say that forces of an equilibrium may be those of bodies that move, of an older version; else ""."""
    if result.status != AT_REST or result.facts.provenance["statics"].get(STAND):
        return ""
    moving = [
        repr(name_of(body, row))
        for row, body in enumerate(result.scene.obstacles)
        if body.motion.kind != "fixed" or body.spin is not None
    ]
    if not moving:
        return ""
    return (
        f"an older version saved this equilibrium, in which {', '.join(moving)} did not stand: what they do "
        "to ropes may be by their speed; compute it anew, rw.equilibrium(result.scene)"
    )
