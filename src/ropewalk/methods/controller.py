"""Step-size control: the length of the next step from the estimated error of the last.

The error of a step is the largest distance of any node between the method's result and that of the embedded
method, e = h |sum (b_s - b'_s) V_s| [m], that of the inner strain of any segment that remembers, as a length,
and that of the angle of what turns freely, times how far it reaches from its axle. It goes as h^3, so
that with r = e / tolerance
    h' = 0.9 h r^(-0.7/3) r_before^(0.4/3)    after an accepted step,
    h' = 0.9 h r^(-1/3)                       after a rejected one.
Source: Gustafsson 1991, ACM Trans. Math. Softw. 17:533; Hairer & Wanner, Solving Ordinary Differential
Equations II, IV.2 and IV.8.
"""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats, System
from ropewalk.core.jit import kernel
from ropewalk.laws.wheel_rows import RATES
from ropewalk.laws.winch import WINCH_SHARE
from ropewalk.methods.kinks import in_order

#: Longest step where the scene names none [s]: what happens and is over within one goes unseen.
LONGEST_STEP = 0.1
#: A run that needs steps shorter than this is stopped [s].
SHORTEST_STEP = 1e-9
#: Steps as short as this are not cut again for an event [s].
EVENT_STEP = 1e-7
SAFETY = 0.9
UNSOLVED_SHARE = 0.25  # of a step whose equations have no solution, for the next try

# Places in the array `control`. BEGIN and END [s] are those of the last step, WISH [s] the next one's
# length (0: none yet), BEFORE the last error over the tolerance; then counts and extremes of accepted
# steps, and error [m] and node, or -1 - segment, or -1 - segments - wheel, of the last step tried (inf: its
# equations have no solution).
BEGIN, END, WISH, BEFORE, ACCEPTED, REJECTED, SHORTEST, LONGEST, ERROR, NODE, BEGUN = range(11)


def make_control() -> Floats:
    """Return the controller's numbers before the first step."""
    control = np.zeros(11)
    control[SHORTEST] = math.inf
    return control


def break_times(system: System) -> Floats:
    """Return the times at which a step must end [s], sorted: the scene's own sudden changes.

    Its kinks, releases, and starts and stops of winches.
    """
    anchors, winches = system.anchors, system.winches
    return in_order([system.kinks, anchors.release, winches.start, winches.stop])


@kernel
def largest_error(u, b, embedded, dt, inverse_mass, control):
    """Write the largest estimated error of a step [m] and its node; `u` (stages, 3, n) [m/s]."""
    worst, node = 0.0, 0
    for i in range(inverse_mass.shape[0]):
        if inverse_mass[i] == 0.0:
            continue
        square = 0.0
        for k in range(3):
            error = 0.0
            for s in range(b.shape[0]):
                error += (b[s] - embedded[s]) * u[s, k, i]
            square += error * error
        if not square <= worst:
            worst, node = square, i
    control[ERROR], control[NODE] = dt * math.sqrt(worst), node


@kernel
def largest_inner_error(rates, b, embedded, dt, rest_length, control):
    """Raise the error of a step to the largest of what segments remember [m], and its place to -1 - theirs.

    `rates` (stages, s) [1/s] of inner strains; (stages, 0) where nothing remembers.
    """
    for j in range(rates.shape[1]):
        error = 0.0
        for s in range(b.shape[0]):
            error += (b[s] - embedded[s]) * rates[s, j]
        error = dt * abs(error) * rest_length[j]
        if not error <= control[ERROR]:
            control[ERROR], control[NODE] = error, -1 - j


@kernel
def largest_turning_error(wheel, b, embedded, dt, reach, segments, control):
    """Raise the error of a step to the largest of what turns freely [m], and its place to -1 - segments - w.

    `wheel` (w, WIDTH) see `wheel_rows`, `reach` (w,) [m].
    """
    for w in range(wheel.shape[0]):
        error = 0.0
        for s in range(b.shape[0]):
            error += (b[s] - embedded[s]) * wheel[w, RATES + s]
        error = dt * abs(error) * reach[w]
        if not error <= control[ERROR]:
            control[ERROR], control[NODE] = error, -1 - segments - w


@kernel
def first_step(a, gravity, tolerance, longest):
    """Return the time in which the largest acceleration moves a node by the tolerance [s]."""
    square = gravity[0] ** 2 + gravity[1] ** 2 + gravity[2] ** 2
    for i in range(a.shape[1]):
        square = max(square, a[0, i] ** 2 + a[1, i] ** 2 + a[2, i] ** 2)
    guess = math.sqrt(2.0 * tolerance / math.sqrt(square)) if square > 0.0 else longest
    return min(guess, longest) if guess > 0.0 else longest


@kernel
def longest_step(winches, longest):
    """Return `longest` [s], or less where a winch would wind too much in it."""
    for row in range(winches.speed.shape[0]):
        speed = abs(winches.speed[row])
        if speed > 0.0:
            longest = min(longest, WINCH_SHARE * winches.segment[row] / speed)
    return longest


@kernel
def longer(ratio, before):
    """Return the factor on the step after an accepted one; `ratio` and `before` are e / tolerance."""
    ratio, before = max(ratio, 1e-8), max(before, 1e-8)
    return min(max(SAFETY * ratio ** (-0.7 / 3.0) * before ** (0.4 / 3.0), 0.2), 5.0)


@kernel
def shorter(ratio):
    """Return the factor on a rejected step; `ratio` is e / tolerance."""
    if not ratio < np.inf:
        return 0.1
    return min(max(SAFETY * ratio ** (-1.0 / 3.0), 0.1), 0.9)


@kernel
def count_step(control, dt, ratio, cut, retried):
    """Count an accepted step and wish for the next; one that was cut says little about it."""
    wish = dt * longer(ratio, control[BEFORE] if control[BEFORE] > 0.0 else ratio)
    if retried:
        wish = min(wish, dt)
    control[WISH] = max(control[WISH], wish) if cut else wish
    control[BEFORE] = ratio
    control[ACCEPTED] += 1.0
    control[SHORTEST], control[LONGEST] = min(control[SHORTEST], dt), max(control[LONGEST], dt)
