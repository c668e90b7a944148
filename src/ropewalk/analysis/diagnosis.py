"""Why a run broke: when, where, the sign of it, the bound it violated, and what to change.

The input is a history of single steps that ends in the break and begins before it shows (`retrace`
takes it from a simulation). Three measures are made of it. Zigzag: in an explicit method's
instability neighbouring segments stretch and shrink in turn, so the changes of length of neighbours
have the correlation -1 (+1 in a smooth motion, -1/2 where nodes move at random). A break so fast that
springs turn over in a step shows it in the changes of segments as vectors, not in those of lengths.
Flip: the pattern changes sign from step to step (a root of the step below -1), so successive changes
have the correlation -1 too. Growth: the factor by which the energy of the zigzag rises per step, the
square of the mode's growth.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ropewalk.analysis.json_values import plain
from ropewalk.analysis.stability import Stability, milliseconds, stability
from ropewalk.core.status import OK
from ropewalk.engine.broken import ACCOUNTED
from ropewalk.engine.unsolved import CALMER
from ropewalk.lowering import Layout
from ropewalk.simulation import Broken, Simulation
from ropewalk.words.safe_side import longest_step

Floats = NDArray[np.float64]

NO_SIGN = "no zigzag"  # where nothing shows how it broke
_CLEAR = -0.55  # a correlation below this is a zigzag; nodes that move at random have -0.5
_SEEN = 1e-10  # changes of this part of a segment's length are more than rounding
_RISING = 1.02  # growth of amplitude per step that counts as the break's own
_RISING_STEPS = 12
_HISTORY = 400  # steps before the last good frame that show how the break began
_MOST_WORK = 2e9  # steps times nodes taken again, some ten seconds
_KEPT_NUMBERS = 12_000_000  # coordinates in a history


@dataclass(frozen=True)
class Diagnosis:
    """What broke a run."""

    time: float  # of the last good frame [s]
    step: int  # of the last good frame, counted from the run's start
    rope: str
    node: int  # in its rope: where the break is worst first
    zigzag: float  # correlation of neighbouring segments' changes, -1 to 1; nan: none
    flip: float  # correlation of a step's changes with the next step's; nan: none
    energy_growth: float  # of the zigzag, factor per step [1]; nan where it cannot be told
    predicted: bool  # whether the bound was violated
    bound: float  # largest stable step of the method [s]
    advice: tuple[str, ...]
    text: str

    @property
    def sign(self) -> str:
        """What the break looks like, in words."""
        return _sign(self.zigzag, self.flip, self.energy_growth, self.predicted)

    def as_dict(self) -> dict[str, object]:
        """Plain values for JSON; None stands for what is not finite."""
        return {key: plain(value) for key, value in vars(self).items()} | {"sign": self.sign}

    def __str__(self) -> str:
        return self.text


def diagnose(
    theory: Stability,
    layout: Layout,
    positions: Floats,
    time: float,
    step: int,
    reason: str = "",
    parted: NDArray[np.bool_] | None = None,
) -> Diagnosis:
    """Say why a run broke, in one or two sentences.

    Args:
        theory: the stability of the run's model.
        layout: of the run's model.
        positions: of single steps up to the break [m], (steps, n, 3), from some time before it on;
            the last ones may be infinite or NaN. Fewer than three finite ones show no sign.
        time: of the last good frame [s].
        step: number of steps from the start of the run to the last good frame.
        reason: what the simulation found broken, `Simulation.reason`.
        parted: segments that are no more, (s,); see `parted_segments`.
    """
    segments, lengths = _while_finite(positions)
    alive = _alive(layout, lengths)
    if parted is not None:
        alive &= ~parted
    changes = np.where(alive, np.diff(lengths, axis=0), 0.0)
    growth = _growth(changes, lengths, alive)
    least = _SEEN * float(np.median(lengths[0][alive])) if len(lengths) else 0.0
    clearest, zigzag = _zigzag(changes, alive, least)
    if not zigzag < _CLEAR:
        turned = np.where(alive[:, None], np.diff(segments, axis=0), 0.0)
        row, value = _zigzag(turned, alive, least)
        if value < _CLEAR:
            changes, clearest, zigzag = turned, row, value
    flip = _flip(changes, clearest)
    worst = _worst_node(changes, clearest, layout)
    if not zigzag < _CLEAR:
        worst = _longest(lengths, alive)
    rope, node = layout.rope_of(worst)
    advice = theory.remedies
    if theory.stable and theory.rings:
        advice = f"method = {CALMER}", "a shorter time_step"
    text = _text(theory, rope, node, time, zigzag, flip, growth, reason)
    return Diagnosis(
        time=time,
        step=step,
        rope=rope,
        node=node,
        zigzag=zigzag,
        flip=flip,
        energy_growth=growth,
        predicted=not theory.stable,
        bound=theory.bound,
        advice=advice,
        text=text,
    )


def retrace(simulation: Simulation, steps: int, keep: int = 2 * _HISTORY) -> Floats:
    """Step a simulation one by one up to its break; return the positions of these steps.

    Args:
        simulation: at a state before the break shows, e.g. restored from a snapshot.
        steps: stop after so many steps even without a break.
        keep: steps to return at most, the last ones; fewer where nodes are very many.

    Returns:
        Positions [m], (kept, n, 3), the broken step included.
    """
    keep = max(4, min(keep, _KEPT_NUMBERS // (3 * simulation.layout.nodes)))
    positions: deque[Floats] = deque([simulation.positions.copy()], maxlen=keep)
    for _ in range(steps):
        broken = False
        try:
            simulation.step(simulation.plan.dt)
        except Broken:
            broken = True
        positions.append(simulation.positions.copy())
        if broken:
            break
    return np.array(positions)


def explain(simulation: Simulation) -> Diagnosis:
    """Diagnose a run from a simulation that stands at its last good frame; it is left as it is.

    The steps before the break are taken again from the start by a second simulation, at the cost of
    one more run; where that would take too long, or the second one comes out elsewhere (it was moved by
    hand), only the steps after the last good frame are looked at.
    """
    model, plan, reason = simulation.model, simulation.plan, simulation.reason
    step = round(simulation.time / plan.dt)
    frames = step // plan.steps_per_frame
    back = min(frames, -(-_HISTORY // plan.steps_per_frame))
    positions = None
    if step * simulation.layout.nodes <= _MOST_WORK:
        again = Simulation(model, ledger=False)
        _skip(again, frames - back)
        steps = (back + 1) * plan.steps_per_frame
        positions = retrace(again, steps, keep=steps + 1)
        good = back * plan.steps_per_frame
        if len(positions) <= good or not np.array_equal(positions[good], simulation.positions):
            positions = None
    if positions is None:
        here = simulation.state
        positions = retrace(simulation, plan.steps_per_frame)
        simulation.restore(here)
    theory, layout = stability(model), simulation.layout
    parted = parted_segments(simulation)
    return diagnose(theory, layout, positions, simulation.time, step, reason, parted)


def _while_finite(positions: Floats) -> tuple[Floats, Floats]:
    """Return segments, (steps, s, 3), and lengths, (steps, s) [m], of all steps before the first wild one."""
    finite = np.isfinite(positions).all(axis=(1, 2))
    good = int(np.argmin(finite)) if not finite.all() else len(positions)
    with np.errstate(over="ignore", invalid="ignore"):
        segments = np.diff(positions[:good], axis=1)
        lengths = np.linalg.norm(segments, axis=2)
    sound = np.isfinite(lengths).all(axis=1)
    good = int(np.argmin(sound)) if not sound.all() else len(lengths)
    return segments[:good], lengths[:good]


def parted_segments(simulation: Simulation) -> NDArray[np.bool_]:
    """Return which segments have parted, (s,)."""
    found = np.zeros(simulation.layout.segments, bool)
    times = simulation.state.state.memory.parting.time  # by a segment's first node
    if len(times):
        found |= np.isfinite(times[: len(found)])
    return found


def _skip(simulation: Simulation, frames: int) -> None:
    while frames > 0:
        block = simulation.advance_frames(min(frames, simulation.block_frames))
        if block.status != OK:
            return
        frames -= block.frames


def _alive(layout: Layout, lengths: Floats) -> NDArray[np.bool_]:
    """Return in which segments there is rope at any time; on a drum all nodes lie at one place."""
    alive = np.zeros(layout.segments, dtype=bool)
    for span in layout.ropes:
        alive[span.first : span.last] = True
    return alive & lengths.any(axis=0) if len(lengths) else alive


def _correlation(a: Floats, b: Floats) -> float:
    size = max(float(np.abs(a).max(initial=0.0)), float(np.abs(b).max(initial=0.0)))
    if size == 0.0:
        return math.nan
    a, b = a / size, b / size
    norm = math.sqrt(float((a * a).sum()) * float((b * b).sum()))
    return float((a * b).sum()) / norm if norm > 0.0 else math.nan


def _zigzag(changes: Floats, alive: NDArray[np.bool_], least: float) -> tuple[int, float]:
    """The step in which the changes of neighbouring segments are most opposed, and by how much.

    Not the last step: that one may already be the tangle that follows. Changes below `least` [m] do
    not count.
    """
    pairs = np.flatnonzero(alive[:-1] & alive[1:])
    found = [
        (_correlation(row[pairs], row[pairs + 1]), i)
        for i, row in enumerate(changes)
        if float(np.abs(row).max(initial=0.0)) > least
    ]
    found = [(value, i) for value, i in found if not math.isnan(value)]
    if not pairs.size or not found:
        return max(len(changes) - 1, 0), math.nan
    value, i = min(found)
    return i, value


def _flip(changes: Floats, step: int) -> float:
    """Correlation of the changes of a step with those of the next, or of the one before."""
    if len(changes) < 2:
        return math.nan
    other = step + 1 if step + 1 < len(changes) else step - 1
    return _correlation(changes[step], changes[other])


def _growth(changes: Floats, lengths: Floats, alive: NDArray[np.bool_]) -> float:
    """Median factor per step of the zigzag's energy, while it grows and is still small.

    Its amplitude is how much the changes of neighbouring segments differ; beyond a third of the
    segments' length the springs turn over, and linear growth ends.
    """
    pairs = np.flatnonzero(alive[:-1] & alive[1:])
    columns = (changes[:, pairs + 1] - changes[:, pairs]) if pairs.size else changes[:, alive]
    with np.errstate(over="ignore"):
        amplitude = np.sqrt((columns * columns).mean(axis=1)) if columns.size else np.zeros(0)
    if amplitude.size < 2:
        return math.nan
    scale = float(np.median(lengths[0][alive]))
    before, after = amplitude[:-1], amplitude[1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = after / before
    rising = ratios > _RISING
    linear = np.flatnonzero(rising & (after < scale / 3.0))
    chosen = ratios[linear[-_RISING_STEPS:]] if linear.size else ratios[rising][:1]
    return float(np.median(chosen)) ** 2 if chosen.size else math.nan


def _worst_node(changes: Floats, step: int, layout: Layout) -> int:
    """The node between the two segments that change most, in opposite senses, in that step."""
    if not len(changes):
        return layout.ropes[0].start
    last = changes[step] / max(float(np.abs(changes[step]).max(initial=0.0)), 1e-300)
    last = last.reshape(len(last), -1)
    pull = np.zeros((len(last) + 1, last.shape[1]))
    pull[:-1] += last
    pull[1:] -= last
    return int(np.argmax((pull * pull).sum(axis=1)))


def _longest(lengths: Floats, alive: NDArray[np.bool_]) -> int:
    """The node at the end of the longest segment of the last sound step."""
    return int(np.argmax(np.where(alive, lengths[-1], -1.0))) + 1 if len(lengths) else 0


def _sign(zigzag: float, flip: float, growth: float, predicted: bool) -> str:
    """The sign in words; that there is no zigzag is said only where none was to come."""
    signs = []
    if zigzag < _CLEAR:
        signs.append(f"neighbouring segments zigzag (correlation {zigzag:.2f})")
    if flip < _CLEAR:
        pattern = "the pattern flips" if signs else "segments stretch and shrink in turn"
        signs.append(f"{pattern} at every step")
    if signs and growth > 1.0:  # without a pattern it is of no energy
        signs.append(f"its energy grows {growth:.3g}-fold per step")
    none = "it burst too fast to show how" if predicted else NO_SIGN
    return " and ".join(signs) or none


def _text(
    theory: Stability,
    rope: str,
    node: int,
    time: float,
    zigzag: float,
    flip: float,
    growth: float,
    reason: str,
) -> str:
    sign = _sign(zigzag, flip, growth, not theory.stable)
    if sign == NO_SIGN and reason and not reason.endswith(ACCOUNTED):
        sign, reason = reason, ""
    head = f"Broke after t = {time:.6g} s at node {node} of rope {rope!r}: {sign}."
    if not theory.stable:
        if theory.bound > 0.0:
            law = (
                f"The step of {milliseconds(theory.step)} is above the largest stable one of "
                f"{theory.method}, {longest_step(theory.bound)}"
            )
        else:
            law = f"{theory.method} has no stable step here"
        return f"{head} {law}; change to {', or '.join(theory.remedies)}."
    if theory.rings:
        return (
            f"{head} {theory.method} has no limit for small motions only: it keeps stiff segments "
            f"ringing; change to {CALMER}, or a shorter step."
        )
    found = f": {reason}" if reason else ""
    shorter = f"time_step = {0.5 * theory.step:.3g} s"
    stable = f"The step is stable ({milliseconds(theory.step)} of {longest_step(theory.bound)})"
    if math.isinf(theory.bound):
        stable = f"{theory.method} is stable at any step"
    # of what a limiter gives the ledger cannot tell whether it was its to give
    if reason.endswith(ACCOUNTED) and "limiter" not in theory.uncovered:
        return (
            f"{head} {stable} and {reason}, so this is not the method; look for anchors that move apart, a "
            "rope too soft for its load, or places and lengths in different units."
        )
    if theory.uncovered:
        return (
            f"{head} No bound holds for {theory.method} here{found}: {theory.uncovered}. Change to method = "
            f"auto or {CALMER}, or to {shorter}."
        )
    if zigzag < _CLEAR and growth > 1.0:
        return (
            f"{head} {stable} for ropes at their length, so a segment was pressed or thrown far from "
            f"it{found}; try {shorter}."
        )
    return (
        f"{head} {stable} for ropes at their length{found}; try {shorter}, or look for jerked anchors, "
        "a rope too soft for its load, or places and lengths in different units."
    )
