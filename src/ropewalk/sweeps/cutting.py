"""What the cutting into segments does to a fit: the fitted scene once more, cut anew.

An interval comes from the errors of the measurement and knows nothing of the model's own, of which this is
the one that can be seen by a run or two more.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import build
from ropewalk.scene import Scene
from ropewalk.scene.recut import recut
from ropewalk.scene.rope import Springs
from ropewalk.sweeps.batch import GOOD, REST, RUN, result_of
from ropewalk.sweeps.fit_residuals import Residuals
from ropewalk.sweeps.keep import parse
from ropewalk.sweeps.measurements import Measurement
from ropewalk.sweeps.parameters import short_names

# An error of order p falls to 2^-p of it by twice as many segments. No more than first order is taken for
# granted: a tension is of the middle of a segment, half of one away from where it is largest.
_ORDERS = (1.6, 5.0)  # errors over those of twice as many segments, between which an order is seen
_SECOND = 4.0  # of second order: no more is counted on
_ROOM = 1.5  # the bound that is told over what was estimated: to first order in the values
_TOLD = 0.2  # of half an interval: an error that is told
_WORDS = {0.5: "half", 2.0: "twice as many"}
_WIDE = 0.35  # half of an interval, as a share of the range, by which nothing is determined anyway
_NODE = re.compile(r"\[[^,\]]*,\s*(-?\d+)")  # in what is kept: at a time, of a node


class Unknown(Exception):  # noqa: N818 - what is not known, no mistake
    """The scene cannot be cut anew, or it tells nothing then."""


@dataclass(frozen=True)
class Cut:
    """What the cutting does to the values, in words; `beyond`: it may put one out of its interval."""

    words: tuple[str, ...] = ()
    beyond: bool = False


def cut_words(
    residuals: Residuals,
    scene: Scene,
    share: Floats,
    predicted: Floats,
    jacobian: Floats,
    ends: Sequence[tuple[float, float]],
) -> Cut:
    """Say how far the cutting may put the values off, where that is a part of their intervals.

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
        return Cut()  # given spring by spring the segments are the rope
    try:
        cuts = _cuts(scene, residuals.measurements)
    except Unknown as error:
        return Cut((f"What the cutting into segments does to the values is not known: {error}.",))
    # To first order; what the measurement does not tell at all does not shift either.
    shifts = {
        factor: np.linalg.lstsq(jacobian, (predicted - again) * residuals.weights, rcond=1e-9)[0]
        for factor, again in cuts.items()
    }
    bounds = [
        _bound(*(float(shifts[f][i]) if f in shifts else None for f in (0.5, 2.0)))
        for i in range(len(share))
    ]
    off = np.array([size for size, _ in bounds])
    aside = np.clip(off, -2.0, 2.0)  # of the ranges: enough is told
    here, away, back = residuals.values(np.stack([share, share - aside, share + aside]))
    shown = " and ".join(_WORDS[factor] for factor in cuts)
    told, beyond = [], False
    for i, name in enumerate(short_names(residuals.paths)):
        if half[i] <= _WIDE and abs(off[i]) > max(_TOLD * half[i], 1e-6):
            size, way = abs(here[i] - away[i]), "large" if here[i] > away[i] else "small"
            what = f"{size:.2g} {residuals.units[i]}".rstrip()
            does = f"makes {name} too {way}, by up to about {what}"
            if not bounds[i][1]:
                what = f"{max(size, abs(back[i] - here[i])):.2g} {residuals.units[i]}".rstrip()
                does = f"may put {name} off by up to about {what}, either way"
            part = f"{abs(off[i]) / half[i]:.2g} times" if half[i] > 1e-9 else "far more than"
            told.append(
                f"The cutting into segments {does}, as {shown} segments show: {part} half the width of its "
                "interval, which knows nothing of it. Take more segments."
            )
            beyond |= bool(abs(off[i]) > half[i])
    return Cut(tuple(told), beyond)


def _bound(coarse: float | None, fine: float | None) -> tuple[float, bool]:
    """Return how far a value may be off, and whether an order is seen: then it is so in that direction.

    Args:
        coarse: how much less half the segments would be off, taken with its sign; None: not known.
        fine: the same of twice as many.
    """
    change = 0.0 if coarse is None else coarse
    rest = 0.0 if fine is None else -fine
    falls = change / rest if rest else 0.0
    if _ORDERS[0] <= falls <= _ORDERS[1]:
        return _ROOM * rest / (1.0 - 1.0 / min(falls, _SECOND)), True
    if fine is not None:  # half the segments err more than those of the fit
        change *= 0.5
    return _ROOM * max(abs(change), 2.0 * abs(rest)), False


def _cuts(scene: Scene, found: Sequence[Measurement]) -> dict[float, Floats]:
    """Return what a scene predicts when it is cut anew, by its segments over those it has.

    Half the segments, and twice as many; or one of them, where the other cannot be. Raises Unknown.
    """
    for measured in found:
        texts = (*measured.keep, *measured.rest)
        nodes = [int(n) for text in texts for n in _NODE.findall(text)]
        nodes += [getattr(measured, "node", -1)]
        if set(nodes) - {0, -1}:
            raise Unknown(f"{measured.name} is of a node or segment, which is another one then")
    first = recut(scene)
    if first.scene is None:
        raise Unknown(first.why_not)
    made: dict[float, Floats] = {}
    why: Unknown | None = None
    for other in (first, *([recut(scene, finer=True)] if first.factor < 1.0 else [])):
        assert other.scene is not None
        try:
            made[other.factor] = _predicted(other.scene, other.factor, found)
        except Unknown as error:
            why = why or error
    if not made and why is not None:
        raise why
    return made


def _predicted(scene: Scene, factor: float, found: Sequence[Measurement]) -> Floats:
    """Return what a scene that was cut anew predicts. Raises Unknown."""
    run = scene.run
    if factor > 1.0 and not isinstance(run.time_step, str):
        # A step that was stable is no longer so for segments half as long.
        scene = scene.replace(run=run.replace(time_step=run.time_step / factor))
    kept: dict[str, dict[str, Floats]] = {RUN: {}, REST: {}}
    try:
        for what in (RUN, REST):
            asked = [text for m in found for text in (m.keep if what == RUN else m.rest)]
            if asked:
                result = result_of(build(scene, stepped=what != REST), what)
                if result.status not in GOOD:
                    raise Unknown(f"with {_WORDS[factor]} segments the run breaks")
                kept[what] = {
                    one.name: one.of(result)[0] for one in map(parse, dict.fromkeys(asked))
                }
        parts = [m.predicted(kept[RUN], kept[REST], scene) for m in found]
    except (ArithmeticError, LookupError, RuntimeError, ValueError) as error:
        raise Unknown(str(error)) from None
    again = np.concatenate(parts)
    if not np.isfinite(again).all():
        raise Unknown(f"with {_WORDS[factor]} segments the run breaks")
    return again
