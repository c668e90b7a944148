"""What `check` says of a shape of rest that is none, or one of many, or that a limiter carries."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ropewalk.lowering import Model
from ropewalk.record.joined_ropes import joined_ropes
from ropewalk.record.limiter_at_rest import WITHOUT, stretches_apart, stretches_beyond
from ropewalk.scene.joint import tied_ropes
from ropewalk.statics import Statics
from ropewalk.statics.refusal import weight_left
from ropewalk.statics.wraps import MANY, coarse_words
from ropewalk.words.counts import counted

_NAMED = 3  # ropes that one sentence names


def unheld_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for ropes that no anchor holds, but those that were found to lie on something.

    Where there is what they may fall on, and no rest was found or looked for, it is not said that they fall.
    """
    lying = _lying(model, statics) if statics.solved else set()
    names = [name for name in statics.unheld if name not in lying]
    if not names:
        return []
    one = len(names) == 1
    ropes = f"rope{'' if one else 's'} " + ", ".join(map(repr, names[:_NAMED]))
    if len(names) > _NAMED:
        ropes = f"{ropes} and {len(names) - _NAMED} more"
    them = "it" if one else "them"
    down = {np.sign(weight_left(model, model.layout.span(name))) for name in names}
    if not np.any(model.system.gravity) or len(down) > 1 or 0.0 in down:
        return [f"{ropes}: nothing holds {them}"]
    below = bool(model.scene.obstacles) or model.scene.ground is not None
    beside = model.layout.touches and len(statics.unheld) < len(model.layout.ropes)
    if not statics.solved and (below or beside):
        return [f"{ropes}: no anchor holds {them}"]
    they = "it rises" if one else "they rise"
    if 1.0 in down:
        they = "it falls" if one else "they fall"
    return [f"{ropes}: nothing holds {them}; {they}"]


def _lying(model: Model, statics: Statics) -> set[str]:
    """Return the names of ropes that lie on something at rest, and of those that are tied to them."""
    on, ropes = {wrap.rope for wrap in statics.wraps}, model.scene.ropes
    on |= {model.layout.rope_of(int(node))[0] for node in np.flatnonzero(statics.grounded)}
    groups = [{ropes[i].name for i in one} for one in tied_ropes(ropes, model.scene.joints)]
    return {name for group in groups if group & on for name in group}


def beyond_limiter(model: Model, statics: Statics) -> NDArray[np.bool_]:
    """Tell which segments stretch at rest as a stretch limiter would not let them, (s,)."""
    limiter, stiffness = model.system.limiter, model.state.stiffness
    if not limiter.active:
        return np.zeros(stiffness.size, dtype=bool)
    bounded = np.isfinite(stiffness) & (stiffness > 0.0) & (model.state.rest_length > 0.0)
    return bounded & stretches_beyond(limiter.longest, statics.stretch)


def ropes_beyond_limiter(model: Model, statics: Statics) -> tuple[set[str], set[str]]:
    """Return the ropes that rest beyond a stretch limiter, and with them those that are joined to them."""
    over = np.flatnonzero(beyond_limiter(model, statics))
    beyond = {model.layout.rope_of(int(segment))[0] for segment in over}
    return beyond, joined_ropes(model.scene, model.layout, beyond)


def limiter_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence for weights that the springs carry only beyond the limiter's length."""
    over = statics.stretch[beyond_limiter(model, statics)]
    if not over.size:
        return []
    most, allowed = stretches_apart(float(over.max()), model.system.limiter.longest)
    return [
        f"the stretch limiter (at most {allowed}) acts even at rest, on "
        f"{counted(over.size, 'segment')}: the springs alone would stretch to {most}; the "
        f"limiter, not the spring constant, carries the rope. {WITHOUT[:1].upper()}{WITHOUT[1:]}"
    ]


def may_say_nothing(model: Model) -> bool:
    """Tell whether a shape that was not found to be at rest says nothing of one that is."""
    return model.layout.touches or bool(model.scene.slides)


def rest_warnings(model: Model, statics: Statics) -> list[str]:
    """Return a sentence where what is said of rest is not of a shape at rest, or of one among many."""
    if statics.solved:
        turned = [str(body) for body in statics.pulleys if not body.stands]
        return turned + ([MANY] if statics.by_friction else []) + coarse_words(statics.wraps)
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
