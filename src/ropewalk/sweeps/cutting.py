"""What the cutting into segments does to a fit: the fitted scene once more, cut anew.

An interval comes from the errors of the measurement and knows nothing of the model's own, of which this is
the one that can be seen by one more run.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import build
from ropewalk.scene import Scene
from ropewalk.scene.recut import recut
from ropewalk.scene.rope import Springs
from ropewalk.sweeps.batch import REST, RUN, result_of
from ropewalk.sweeps.fit_residuals import Residuals
from ropewalk.sweeps.keep import parse
from ropewalk.sweeps.measurements import Measurement
from ropewalk.sweeps.parameters import short_names

# Errors fall with the square of the segments' length, so of the shift that other segments make a fit has a
# share: a third of that by half of them, four thirds of that by twice as many, the other way.
_SHARE = {0.5: 1.0 / 3.0, 2.0: -4.0 / 3.0}
_WORDS = {0.5: "half the segments", 2.0: "twice as many segments"}
_TOLD = 0.2  # of half an interval: an error that is told
_WIDE = 0.35  # half of an interval, as a share of the range, by which nothing is determined anyway
_NODE = re.compile(r"\[[^,\]]*,\s*(-?\d+)")  # in what is kept: at a time, of a node


class Unknown(Exception):  # noqa: N818 - what is not known, no mistake
    """The scene cannot be cut anew, or it tells nothing then."""


def cut_words(
    residuals: Residuals,
    scene: Scene,
    share: Floats,
    predicted: Floats,
    jacobian: Floats,
    ends: Sequence[tuple[float, float]],
) -> tuple[str, ...]:
    """Say how far the cutting puts the values off, where that is a part of their intervals.

    Args:
        residuals: with what was measured.
        scene: as fitted.
        share: of the ranges, the fit, (D,).
        predicted: of the fit, (m,).
        jacobian: of the residuals by the shares, (m, D).
        ends: of the intervals, as shares of the ranges; NaN: not known.
    """
    half = np.array([0.5 * (high - low) for low, high in ends])
    ropes = scene.ropes
    if not np.isfinite(half).any() or any(isinstance(rope.made_of, Springs) for rope in ropes):
        return ()  # given spring by spring the segments are the rope
    try:
        again, factor = _predicted(scene, residuals.measurements)
    except Unknown as error:
        return (f"What the cutting into segments does to the values is not known: {error}.",)
    # To first order; what the measurement does not tell at all does not shift either.
    change = (predicted - again) * residuals.weights
    off = _SHARE[factor] * np.linalg.lstsq(jacobian, change, rcond=1e-9)[0]
    true = residuals.values(np.clip(share - off, 0.0, 1.0)[None])[0]
    away = residuals.values(share[None])[0] - true
    told = []
    for i, name in enumerate(short_names(residuals.paths)):
        if half[i] <= _WIDE and abs(off[i]) > max(_TOLD * half[i], 1e-6):
            size, way = abs(away[i]), "large" if away[i] > 0.0 else "small"
            part = f"{abs(off[i]) / half[i]:.2g} times" if half[i] > 1e-9 else "far more than"
            told.append(
                f"The cutting into segments makes {name} about {size:.2g} {residuals.units[i]} too {way}, as "
                f"{_WORDS[factor]} show: {part} half the width of its interval, which leaves that out. Take "
                "more segments."
            )
    return tuple(told)


def _predicted(scene: Scene, found: Sequence[Measurement]) -> tuple[Floats, float]:
    """Return what a scene predicts when it is cut anew, and its segments over those it has.

    Raises Unknown.
    """
    for measured in found:
        texts = (*measured.keep, *measured.rest)
        nodes = [int(n) for text in texts for n in _NODE.findall(text)]
        nodes += [getattr(measured, "node", -1)]
        if set(nodes) - {0, -1}:
            raise Unknown(f"{measured.name} is of a node, which is another one then")
    other = recut(scene)
    if other.scene is None:
        raise Unknown(other.why_not)
    kept: dict[str, dict[str, Floats]] = {RUN: {}, REST: {}}
    try:
        for what in (RUN, REST):
            asked = [text for m in found for text in (m.keep if what == RUN else m.rest)]
            if asked:
                result = result_of(build(other.scene, stepped=what != REST), what)
                kept[what] = {
                    one.name: one.of(result)[0] for one in map(parse, dict.fromkeys(asked))
                }
        parts = [m.predicted(kept[RUN], kept[REST], other.scene) for m in found]
    except (ArithmeticError, LookupError, RuntimeError, ValueError) as error:
        raise Unknown(str(error)) from None
    again = np.concatenate(parts)
    if not np.isfinite(again).all():
        raise Unknown(f"with {_WORDS[other.factor]} the run breaks")
    return again, other.factor
