"""Status codes that kernels return; the host turns them into sentences."""

from __future__ import annotations

OK = 0
BROKEN = 1  # not finite, stretched beyond BREAK_STRETCH, or with energy that was MADE_UP
UNSOLVED = 2  # an implicit method found no solution of a step
HIT = 4  # a step of an implicit method has hit something and is to be taken anew by implicit Euler
GAINED = 5  # such a step makes up energy, and is to be taken in parts
PAUSED = 3  # the adaptive method has taken as many steps as one call may

# A segment this many times its rest length [1] counts as broken simulation, not as rope; three times
# what all weight would stretch the softest segment by comes on top of it.
BREAK_STRETCH = 10.0
# Places in `State.balance` [J]: the energy from which gains count, what there can honestly be, the energy
# when the last call ended, the time of the last verdict [s], what a limiter has taken after explicit steps.
ZERO, HONEST, LAST, SEEN, TAKEN = range(5)
# Energy that nothing gave the ropes, over all that they can honestly have [1], which tells a broken one.
MADE_UP = 3.0
