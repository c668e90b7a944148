"""Who moves with whom: up to a register's width of equal ropes that nothing ties together, see `abreast`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ropewalk.core.addresses import Kept, handed
from ropewalk.core.arrays import Floats
from ropewalk.core.cache import is_compiled
from ropewalk.core.deferred import clock
from ropewalk.core.jit import PLAIN
from ropewalk.core.lane_rows import MOST_NODES
from ropewalk.core.lanes import WIDTH
from ropewalk.core.status import OK, PAUSED
from ropewalk.engine.engine import Asked, Engine, Fall, Moved
from ropewalk.engine.slices import Edges, Slices
from ropewalk.methods.recording import Recording
from ropewalk.methods.registry import Method
from ropewalk.methods.side_by_side import FEWEST_NODES, advance_beside, goes_beside
from ropewalk.scene import Rope, Scene

FEWEST = 5  # ropes that go abreast: fewer would be slower, and a kernel more to compile


class Mate:
    """An engine, and what it has by address."""

    def __init__(self, engine: Engine) -> None:
        self.engine, self._kept = engine, tuple[Kept, ...]()
        self._out: tuple[Kept, int] | None = None  # what it recorded in last
        self._last: Recording | None = None  # the same, as `buffers` was given it
        self._block: Any = None
        self.kind = _kind(engine)

    def __reduce__(self) -> tuple[Any, ...]:
        """Let a copy have addresses of its own."""
        return type(self), (self.engine,)

    def kept(self) -> tuple[Kept, ...]:
        """Return system, state and scratch by address; a rope so short has no windows."""
        if not self._kept:
            engine = self.engine
            scratch = engine.scratch._replace(windows=None)
            self._kept = tuple(map(Kept, (engine.system, engine.state, scratch)))
        return self._kept

    def keep(self, out: Recording, size: int) -> tuple[Kept, int]:
        """Return what it records in by address, and that; `size` is how many words others have taken."""
        if self._out is None or self._out[0].value is not out:
            kept = Kept(out, size)
            self._out = kept, kept.address
        return self._out

    def buffers(self, out: Recording) -> Any:
        """Return what to hand to a kernel to record in: by address, where it comes again."""
        if self._last is not out:
            self._last, self._block = out, None
            return out
        if self._block is None:
            (self._block,) = handed(out)
        return self._block

    @cached_property
    def types(self) -> tuple[int, ...]:
        """What the types of these are told apart by."""
        return tuple(one.mark for one in self.kept())

    @cached_property
    def addresses(self) -> tuple[int, ...]:
        """Where these are."""
        return tuple(one.address for one in self.kept())


def _kind(engine: Engine) -> Hashable:
    """Return what is the same of all that can move side by side; None: this one moves by itself."""
    nodes = engine.state.x.shape[1]
    goes = engine.is_plain() and goes_beside(engine.kernel, engine.tableau)
    return (nodes, id(engine.tableau)) if goes and _fits(nodes) else None


def _fits(nodes: int) -> bool:
    return not PLAIN and FEWEST_NODES <= nodes <= MOST_NODES


class Crew(NamedTuple):
    """Islands that move in one go, by their numbers."""

    numbers: list[int]
    abreast: bool  # as `go_abreast` moves them


def crews_of(mates: Sequence[Mate], ended: Floats) -> list[Crew]:
    """Return who moves with whom: up to WIDTH equal ones of FEWEST or more, else one.

    `ended` (m,) is 1 for those that do not move any more. What is left over of equal ones, at last one
    of them, moves as they did: a kernel less to compile.
    """
    kinds: dict[Hashable, list[int]] = {}
    for k, mate in enumerate(mates):
        kinds.setdefault(k if mate.kind is None else mate.kind, []).append(k)
    crews = []
    for group in kinds.values():
        abreast = len(group) >= FEWEST
        crews += [Crew([k], False) for k in group if ended[k] or not abreast]
        going: dict[tuple[int, ...], list[int]] = {}
        for k in group if abreast else ():
            if not ended[k]:
                going.setdefault(mates[k].types, []).append(k)
        for those in going.values():
            crews += [Crew(those[k : k + WIDTH], True) for k in range(0, len(those), WIDTH)]
    return crews


def batches(crews: Sequence[Crew]) -> Iterator[list[Crew]]:
    """Yield crews together that have as many islands as a register holds ropes, or a few more."""
    batch, count = list[Crew](), 0
    for crew in crews:
        batch.append(crew)
        count += len(crew.numbers)
        if count >= WIDTH:
            yield batch
            batch, count = [], 0
    if batch:
        yield batch


def go_alone(
    mates: Sequence[Mate],
    slices: Slices,
    now: Floats,
    frames: int,
    outs: Sequence[Recording],
    stop: bool,
    asked: Asked,
) -> list[Moved]:
    """Move one island by so many frames; PAUSED where it was asked to stop."""
    falls: tuple[Fall, ...] = ()
    begun, unfinished = now[4:]  # of the call for all islands

    def call(
        steps: int, count: int, found: Recording, halt: bool, edges: Edges
    ) -> tuple[int, int, int]:
        nonlocal falls
        now[3:] = steps, begun or edges[0], unfinished or edges[1]
        moved = mates[0].engine.call(now, count, slices.most, found, halt)
        falls = moved.falls
        return moved.status, moved.good, moved.taken

    slices.asked = asked
    status, good = slices.run(call, lambda: lambda: None, int(now[3]), frames, outs[0], stop)
    return [Moved(PAUSED if status == OK and good < frames else status, good, 0, falls)]


def go_once(mate: Mate, slices: Slices, now: Floats, out: Recording, stop: bool) -> list[Moved]:
    """Move one island by a frame whose steps a call may have: as `go_alone`, with less about it."""
    begun = clock()
    moved = mate.engine.call(now, 1, slices.most, mate.buffers(out), stop)
    slices.note(moved.taken, clock() - begun)
    return [moved]


class Crews:
    """Who of some engines moves with whom, and how their calls are cut."""

    def __init__(self, engines: Sequence[Engine]) -> None:
        self.mates = [Mate(engine) for engine in engines]
        self._found, self._for = list[Crew](), b""  # for those who have ended
        self._slices: dict[int, Slices] = {}  # of crews, by the first in each

    def now(self, ended: Floats) -> list[Crew]:
        """Return who moves with whom, see `crews_of`."""
        known = ended.tobytes()
        if known != self._for:
            self._found, self._for = crews_of(self.mates, ended), known
        return self._found

    def slices(self, crew: Crew) -> Slices:
        """Return how to cut a crew's calls."""
        first, ropes = crew.numbers[0], len(crew.numbers)
        if first not in self._slices:
            self._slices[first] = self.mates[first].engine.make_slices(ropes)
        return self._slices[first]


def are_compiled(method: Method, rare: int | None, scene: Scene) -> bool:
    """Tell whether there is machine code of what moves a scene's ropes, in this process or on disk."""
    alone, beside = _ways(method, rare, scene)
    ready = not alone or is_compiled(method.advance, rare)
    return ready and (not beside or is_compiled(advance_beside, rare))


def _ways(method: Method, rare: int | None, scene: Scene) -> tuple[bool, bool]:
    """Tell whether some of a scene's ropes move by themselves, and whether some go abreast."""
    tableau = method.coefficients(scene.run.spectral_radius)
    if rare is not None or not method.fixed or not goes_beside(method.advance, tableau):
        return True, False
    equal = Counter(
        rope.segments + 1 if _is_plain(rope) and _fits(rope.segments + 1) else 0
        for rope in scene.ropes
    )
    alone = any(nodes == 0 or count < FEWEST for nodes, count in equal.items())
    return alone, any(nodes > 0 and count >= FEWEST for nodes, count in equal.items())


def _is_plain(rope: Rope) -> bool:
    made_of = rope.made_of
    rubs = made_of.friction == "axial" and rope.segment_friction > 0.0 and not rope.rigid
    pushed = rope.submerged_weight is not None or _is_pushed(rope)
    return not (made_of.tension_only or rubs or pushed)


def _is_pushed(rope: Rope) -> bool:
    """Tell whether constant forces act on a node: they may be zero, or cancel."""
    total = np.zeros((rope.nodes, 3))
    for force in rope.forces:
        total[rope.node_index(force.node)] += force.force
    return bool(total.any())
