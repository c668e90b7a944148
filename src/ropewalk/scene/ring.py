"""A mode to ring at the start of a run."""

from __future__ import annotations

from pydantic import Field

from ropewalk.scene.base import Model, Number, Whole, positive


class Ring(Model):
    """Starts a rope at rest in one of its natural modes, with the mode's shape as velocity."""

    mode: Whole = Field(
        ge=1,
        le=1000,
        description="Number of the mode, as `ropewalk modes` counts it",
        json_schema_extra={"unit": "1"},
    )
    speed: Number = positive("Initial speed of the node that moves most", "m/s")
