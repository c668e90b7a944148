"""What slides are made from, and what they remember."""

from __future__ import annotations

from typing import NamedTuple

from ropewalk.core.arrays import Floats, Ints

# Columns of `Memory.grip`: place on the rope [1], force of the friction spring [N].
PLACE, SPRING = range(2)
# Columns of `Memory.sight`, see `rail.look`: place on the rope and on its piece [1], distance [m], slope
# of the condition for the nearest point [m^2], 1 where that is inside the rope; the shares of the four
# nodes in r and its derivatives; r, r', r'' [m]; the gradient of the place [1/m], three for each node;
# way past the rope per place [m], see `slide_force`; how |r'| changes with the place, over |r'| [1]; and
# 1 / |r'|^2 [1/m^2], these two 0 in a fold so sharp that the way per place is held.
AT, APART, SLOPE, INSIDE, SHARE, RATE, BEND, R, R1, R2, GRADIENT, PER_PLACE, STRETCHES, TURNS = (
    0,
    1,
    2,
    3,
    4,
    8,
    12,
    16,
    19,
    22,
    25,
    37,
    38,
    39,
)
WIDTH = 40
LOST = 1  # fault
FAULT, WHICH, ASKED = range(3)  # places in `Memory.tally`
# Columns of `Memory.ends`, nodes counted from `Slides.first`: those between which there is rope to slide
# along, and the first and last there ever is; 1 at a broken end, where what slides runs off; then the nodes
# of the arrays at which drums stand, -1: there is none.
LOW, HIGH, LOWEST, HIGHEST, LOOSE, DRUM = 0, 1, 2, 3, 4, 6
ENDS = 8
NEAREST = 2.25  # [1] segments, stretched, from a drum: there a slide is stopped, see `slide_force`
CLEAR = 2.12  # [1] the same: from 2.1 on no node that bears it goes on to the drum or off it
GIVEN = 2  # column of `Memory.stops`
ROOM = 0.75  # [1] segments that winches leave besides


class Slides(NamedTuple):
    """Slides, one row each; k of them."""

    node: Ints  # (k,) what slides
    first: Ints  # (k,) first node of the rope that it slides along
    last: Ints  # (k,) its last one
    length: Floats  # (k,) of its segments [m]
    stiffness: Floats  # (k,) across [N/m]
    hold: Floats  # (k,) the same along where it sticks [N/m]
    damping: Floats  # (k,) along [N s/m]; 0 without friction
    friction: Floats  # (k,) [1]
    brake: Floats  # (k,) [N]
    brake_from: Floats  # (k,) place from which it brakes [m]
    lowest: Ints  # (k,) first node of the rope, those on a drum included
    highest: Ints  # (k,) last one
    winch: Ints  # (k, 2) winches at its start and at its end, -1: there is none


class Memory(NamedTuple):
    """What slides remember of the last accepted step, and working space."""

    grip: Floats  # (k, 2), see PLACE
    group: Ints  # (k, 4) the node, and the three of the rope that carry it
    sight: Floats  # (k, WIDTH) working space, see AT
    tally: Ints  # (3,) fault, the slide that has it, and its first row in the network
    ends: Ints  # (k, ENDS), see LOW
    off: Floats  # (k,) when it has run off a broken rope [s], inf: it is on it
    stops: Floats  # (k, 3) how far from the drums stops stand [m], and what they gave as they moved [J]


def room_of(drums: int) -> float:
    """Return how much rope winches leave for what slides, of so many drums [1], in segments."""
    return NEAREST * drums + ROOM
