"""Nodes that an anchor or a drum holds: no obstacle touches them.

Where such a node is, its anchor says, however deep in a body that may be: a stake at the height of a floor
lies half a diameter in it. What a surface would push on it with moves nothing, and would but be in the
anchor's reaction, which no rope asks for. So contacts leave out what is held, as steps begin:
what gets held loses what its contacts had stored, which counts as taken by the surface, and what is let go
inside a body has stored there what its depth asks for, which the body has given, as one that moves gives.
Neither is a force's work: those go on from there.
"""

from __future__ import annotations

from ropewalk.core.jit import deferred, kernel
from ropewalk.laws.contact_books import GAP, MOTOR, PRESS, PRESSED, RUBBED
from ropewalk.laws.contact_frame import PUSH
from ropewalk.laws.hardening import squeezed
from ropewalk.laws.obstacle_pose import body_of, pose_of, probe_turned
from ropewalk.laws.wheel_rows import surface_now


@deferred()
def follow_held(x, obstacles, memory, inverse_mass, now):
    """Note which nodes at places `x` (3, n) [m] something holds, and book what that changes."""
    for i in range(inverse_mass.shape[0]):
        held = 1 if inverse_mass[i] == 0.0 else 0
        if held == memory.held[i]:
            continue
        memory.held[i] = held
        for o in range(obstacles.kind.shape[0]):
            if held == 1:
                leave(memory, o, i)
            else:
                find(x, obstacles, memory, o, i, now)
        if held == 0:
            for k in range(3):
                memory.place[k, i] = x[k, i]


@kernel
def leave(memory, o, i):
    """Forget what node i, which is held from now on, has in its contact with obstacle o."""
    grip, books = memory.grip[o], memory.books[o]
    grip[0, i], grip[1, i], grip[2, i], grip[PUSH, i] = 0.0, 0.0, 0.0, 0.0
    books[PRESSED, i], books[RUBBED, i] = 0.0, 0.0


@kernel
def find(x, obstacles, memory, o, i, now):
    """Book what obstacle o has stored under node i, which nothing holds from now on."""
    mx, my, mz, _, _, _, angle, _ = surface_now(obstacles, memory.wheel, o, now)
    px, py, pz = x[0, i] - mx, x[1, i] - my, x[2, i] - mz
    gap = probe_turned(body_of(obstacles, o), pose_of(obstacles, o, angle), px, py, pz)[0]
    stored = squeezed(obstacles, o, i, obstacles.thickness[i] - gap)[2]
    books = memory.books[o]
    books[MOTOR, i] += stored
    books[PRESS, i] -= stored
    books[PRESSED, i], books[GAP, i] = stored, gap
    memory.given[i] += stored
