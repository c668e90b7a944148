"""What moves a model: one engine, or those of islands."""

from __future__ import annotations

from ropewalk.core.litter import kept_for_later
from ropewalk.engine.engine import Engine, controls_of
from ropewalk.engine.islands import Islands
from ropewalk.engine.meetings import Meetings
from ropewalk.engine.partition import partition
from ropewalk.engine.spare import Spare
from ropewalk.engine.start import started
from ropewalk.lowering import Model
from ropewalk.scene.obstacles import is_free


def make_engine(
    model: Model, ledger: bool, apart: bool = False, spare: Spare | None = None
) -> Engine | Islands:
    """Return what moves a model as its run starts, in the arrays of `spare` where they fit.

    `apart`: see `partition`.

    Raises SceneError and NoRest as `start.started` does.
    """
    touching = model.scene.contact is not None or any(map(is_free, model.scene.obstacles))
    if touching and model.scene.run.start == "at-rest":
        model = started(model)  # ropes at rest may lie on each other, and hold wheels together
    groups = partition(model, apart)
    if len(groups) > 1:
        with kept_for_later():
            return (Meetings if touching else Islands)(model, groups, ledger=ledger)
    model = started(model)
    room = None if spare is None else spare.filled(model.state)
    return Engine(model, controls_of(model.system), ledger=ledger, room=room)
