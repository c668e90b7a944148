"""What `check` says of a shape of rest that is none, or one of many, or that a limiter carries."""

from __future__ import annotations

import numpy as np

from ropewalk.lowering import Model
from ropewalk.statics import Statics
from ropewalk.statics.wraps import MANY

_ROUNDING = 1e-9


def limiter_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for weights that the springs carry only far beyond the limiter's length."""
    limiter = model.system.limiter
    bounded = (model.state.stiffness > 0.0) & np.isfinite(model.state.stiffness)
    stretch = statics.stretch[bounded & (model.state.rest_length > 0.0)]
    if not limiter.active or not stretch.size:
        return []
    over = int((stretch > limiter.longest * (1.0 + _ROUNDING)).sum())
    if over == 0 or limiter.longest <= 1.0:
        return []
    return [
        f"the stretch limiter (at most {limiter.longest:g}) acts even at rest, on {over} segments: "
        f"the springs alone would stretch to {stretch.max():.3g}; the limiter, not the spring "
        "constant, carries the rope"
    ]


def may_say_nothing(model: Model) -> bool:
    """Tell whether a shape that was not found to be at rest says nothing of one that is."""
    return model.layout.touches or bool(model.scene.slides)


def rest_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence where what is said of rest is not of a shape at rest, or of one among many."""
    if statics.solved:
        return [MANY] if statics.by_friction else []
    if may_say_nothing(model):
        return [f"{statics.trouble}. What is said of tensions at rest is left out"]
    if not statics.searched:
        return [
            "the shape of rest was not looked for, as more than its weight acts on more than 100000 nodes: "
            "sag and tension given here are those under weight alone. ropewalk settle looks for it"
        ]
    return [
        f"no shape of rest was found ({statics.residual:.2g} N are left on a node): sag and tension "
        "given here are those of a shape near to it"
    ]
