"""What an elastic law is: how the tension of a segment follows from its strain, if by no straight line.

It is one file that ends in an `ElasticLaw`, and an entry in `registry`; `elastic` and `inner` fold the parts
of all laws into one function each. All else follows from these: methods, rest, modes, books, recorded
tensions, extremes and the bound of the step. Segments of which no law says anything obey Hooke's.

    T = EA g(e, d),   e = (r - L) / L,   EA = k L,   U = EA L G(e, d)

EA is the rope's stiffness as its scene has it, the largest slope that there is: dg/de is at most 1, so that k
bounds every slope. g rises everywhere and g(0, 0) = 0, as methods ask for the strain of a tension, too.

d is what a law remembers, an inner strain; at rest it is e. It changes with a rate of its own, d' = f(e, d).
Who asks for g or its inverse says how far d follows: d is `inner` + `c` d', with c = 0 [s] where it is what
it was, c the stage's coefficient in an implicit method, and c = inf at rest. A law that remembers nothing
takes no notice of `inner` and `c`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from ropewalk.core.arrays import Floats


class ElasticLaw(NamedTuple):
    """An elastic law; parts are compiled (`core.jit.part`), j is a segment's number."""

    name: str
    says: Callable[[Any], Any]  # (rope of a scene): what it says of this law; None: nothing
    # (what each rope says, layout): its table, a named tuple; see `segment_law.along`
    lower: Callable[[tuple[Any, ...], Any], Any]
    # part (table, j, strain, inner, c): g, dg/de where d follows so, and G [1]
    pull: Any
    # part (table, j, g, inner, c): the strain that pulls so, and dg/de there [1]: the inverse of `pull`
    strain: Any
    least: Callable[[Any], Floats]  # (table): least dg/de that there is, (s,) [1], above 0

    # Of a law with a memory.
    time: Callable[[Any], Floats] | None = None  # (table): the time in which it forgets, (s,) [s]
    rate: Any = None  # part (table, j, strain, inner, c): d' [1/s]
    # part (table, j, inner, first, last, dt): d after a step in which the strain went from `first` to `last`;
    # None: by its rate in the middle
    move: Any = None
    # part (table, j, change, dt): what is lost in a step in which d changes so, over EA and L [1]
    heat: Any = None
