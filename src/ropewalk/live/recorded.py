"""A recorded run as pictures, one for each of its frames."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.live.carried_pieces import carried_of
from ropewalk.live.energy_off import Balance, Now, step_of
from ropewalk.live.frame import Picture, Shape, turns_of
from ropewalk.live.losses import losses_and_gifts
from ropewalk.live.recorded_touch import GIVEN, PUT_IN, RecordedTouch
from ropewalk.live.recorded_touch import NAMES as TOUCHED
from ropewalk.live.seen import Seen
from ropewalk.lowering.masses import line, masses
from ropewalk.record.beyond import until_torn
from ropewalk.record.body_energies import unaccounted, weight_turns
from ropewalk.record.extremes import had_rope
from ropewalk.record.quantities import PULLEYS
from ropewalk.record.result import Result
from ropewalk.scene import Material

_PIECE = 64  # frames read at once
_NAMES = ("time", "positions", "velocities", "tension", "energy", "work")
_MORE = ("elastic_tension", "reactions", *TOUCHED)
_ROPE = "had_rope"  # (frames, s) since the frame before; all where nothing parts or is wound
_SEEN = {name: "greatest_reactions" if name == "greatest_force" else name for name in Seen._fields}


class Recorded:
    """One recorded run, read a few frames at a time."""

    def __init__(self, result: Result) -> None:
        self.result = result
        past = until_torn(result)
        self.past = past if past is not None and past.last == result.frames - 1 else None
        self._weight_turns = weight_turns(result.scene) and PULLEYS in result.source.names
        begun = float(result.facts.provenance.get(GIVEN) or 0.0)
        told = [
            (one["time"], one["energy"] - begun) for one in result.events if one["event"] == PUT_IN
        ]
        self._changed = np.array(told, dtype=np.float64).reshape(
            -1, 2
        )  # what changes put in [s, J]
        self.first_energy, self._first_gravity = 0.0, float(self._energy(0)[0][1])
        self.first_energy = self._error(0)
        #: What a session has to add to the run's own energy of gravity, and to its energy error [J].
        self.carried_gravity, self.carried_error = 0.0, 0.0
        self._given = 0.0  # what changes have put in until it began [J]
        self._begin: Balance | None = None  # that it goes on from
        self._up = np.array(result.scene.up)
        lets_go = {one.name: one.release_time for one in result.scene.anchors}
        #: When each anchor lets go [s], None: never.
        self.until = [lets_go.get(name) for name in result.layout.anchor_names]
        self.touched = RecordedTouch(result, _PIECE)
        self._no_force = np.zeros((_PIECE, len(result.layout.anchor_names), 3))
        self._piece = -1
        self._data: dict[str, Floats] = {}

    @property
    def shape(self) -> Shape:
        """What its frames hold."""
        layout = self.result.layout
        return Shape(layout.nodes, len(layout.anchor_names), self.touched.room)

    @property
    def frames(self) -> int:
        """Number of frames, the single steps past a break included."""
        return self.result.frames + (0 if self.past is None else len(self.past.time))

    @property
    def good(self) -> int:
        """Number of frames before a break."""
        return self.result.good_frames

    @property
    def time(self) -> Floats:
        """Time of every frame [s]."""
        own = self.result.time
        return own if self.past is None else np.concatenate([own, self.past.time])

    def again(self) -> Recorded:
        """Return another reader of the same run, for another thread."""
        made = Recorded(self.result)
        made.past = self.past
        made.first_energy, made._first_gravity = self.first_energy, self._first_gravity
        made.touched.since, made._given = self.touched.since, self._given
        made.balances = self.balances
        return made

    def follow(self, before: Recorded) -> None:
        """Count energies on from a part that this one goes on from, or from a time within it."""
        frame = int(np.searchsorted(before.result.time, self.time[0], side="right")) - 1
        if self.result.scene.winches:  # what is on the drum is not known
            shift = float(self._energy(0)[0][1] - before._energy(frame)[0][1])
        else:
            shift = self._gravity_zero() - before._gravity_zero()
        self._first_gravity = before._first_gravity + shift
        self.carried_gravity = before.carried_gravity - shift
        given, error = self.result.facts.provenance.get(GIVEN), before._error(frame)
        jump = self.first_energy - before.first_energy - error
        if given is None:  # in folders of older versions
            self._given, change = before._given, jump
        elif self.result.scene.winches:
            self._given, change = before._given + jump - shift, jump
        else:
            self._given, change = float(given), float(given) - before._given + shift
        self.carried_error = self.first_energy - (before.first_energy + change)
        self.first_energy = before.first_energy + change
        self.touched.follow(before.touched, frame)
        begin, plans = before.balances[frame], (before.result.plan, self.result.plan)
        if step_of(plans[0]) != step_of(plans[1]):
            begin = begin._replace(last=self._error(0) - begin.carried.fallen).again()
        self._begin = begin

    @cached_property
    def balances(self) -> list[Balance]:
        """How far its energy is off, frame by frame."""
        energy, layout = self.result.read("energy"), self.result.layout
        work = np.nan_to_num(self.result.read("work"))
        if not self.result.facts.ledger:
            return [Balance.begun(0.0)] * len(energy)
        given = np.array([sum(losses_and_gifts(row, layout.bends, layout.more)) for row in work])
        given += self.given(self.result.read("time"))
        if self._weight_turns:
            given -= unaccounted(self.result.read(PULLEYS))
        begin = self._begin or Balance.begun(float(energy[0, 2:].sum()))
        forms = np.column_stack(
            (
                energy[:, 0],
                energy[:, 1] - self._first_gravity,
                energy[:, 2:].sum(axis=1),
                self.touched.taken_until_each(),
            )
        )
        errors, found = energy.sum(axis=1) - self.first_energy - given, []
        carried = carried_of(self.result, begin.carried, self._given + self.given(self.result.time))
        for row, error, one in zip(forms, errors, carried, strict=True):
            begin = begin.later(Now(row[0], row[1], row[2], row[3], one), float(error))
            found.append(begin)
        return found

    def _energy(self, frame: int) -> tuple[Floats, Floats]:
        """Return a frame's energies, and its work by laws and anchors [J]."""
        read = self.result.read
        work = np.nan_to_num(read("work", frame, frame + 1)[0])  # NaN without a ledger
        return read("energy", frame, frame + 1)[0], work

    def _error(self, frame: int) -> float:
        """Return what no law accounts for in a frame's energy [J]."""
        energy, work = self._energy(frame)
        losses, gifts = losses_and_gifts(work, self.result.layout.bends, self.result.layout.more)
        turned = self.result.read(PULLEYS, frame, frame + 1)[0] if self._weight_turns else None
        given = float(self.given(self.result.read("time", frame, frame + 1))[0])
        total = float(energy.sum()) + self._of_bodies(turned)
        return total - self.first_energy - losses - gifts - given

    def given(self, time: Floats) -> Floats:
        """Return what kicks and the like have put in since the part began until some times [s] [J]."""
        number = np.searchsorted(self._changed[:, 0], time + 1e-9, side="right")
        found: Floats = np.concatenate(([0.0], self._changed[:, 1]))[number]
        return found

    def _of_bodies(self, wheels: Floats | None) -> float:
        """Return what no law accounts for in bodies' energies [J], of `wheels` (w, 7), up to a constant."""
        return 0.0 if wheels is None or not self._weight_turns else float(unaccounted(wheels))

    def _gravity_zero(self) -> float:
        """Return the energy of gravity as it is counted, less that over the origin [J]."""
        scene, layout = self.result.scene, self.result.layout
        mass, _ = masses(layout, tuple(map(line, scene.ropes)))
        fall = self.result.read("positions", 0, 1)[0] @ np.array(scene.gravity)
        return float(self._energy(0)[0][1] + mass @ fall)

    def picture(self, frame: int, after: int | None = None) -> Picture:
        """Return what a frame shows; of a step past a break only shape, tension and speed are its own.

        It shows, too, what was seen since the frame before; or since frame `after`, where those between
        are not shown.
        """
        if frame >= self.result.frames:
            return self._broken(frame - self.result.frames)
        data, row = self._read(frame)
        result = self.result
        positions, velocities = data["positions"][row], data["velocities"][row]
        energy, work = data["energy"][row], data["work"][row]
        driven, layout = self.touched.works_at(data, row).driven, result.layout
        driven = 0.0 if np.isnan(driven) else driven
        losses, gifts = losses_and_gifts(work, layout.bends, layout.more, driven)
        total = float(energy.sum()) + self._of_bodies(
            data[PULLEYS][row] if PULLEYS in data else None
        )
        heights = positions @ np.array(result.scene.up)
        tension = data["tension"][row]
        ground = result.scene.ground
        with np.errstate(over="ignore", invalid="ignore"):  # recorded on into a break
            speed = np.linalg.norm(velocities, axis=1)
        nodes = list(result.layout.anchor_nodes)
        anchors = np.zeros((len(nodes), 10))
        time = float(data["time"][row])
        given = float(self.given(data["time"][row : row + 1])[0])
        anchors[:, :3], anchors[:, 3:6] = positions[nodes], velocities[nodes]
        anchors[:, 9] = [until is None or time < until for until in self.until]
        if "reactions" in data:
            anchors[:, 6:9] = data["reactions"][row]
        pull = np.full_like(tension, np.nan)  # in the frame's row, where there was rope
        seen = Seen.instant(pull, speed, heights, anchors[:, 6:9]).joined(
            self._seen(frame, frame - 1 if after is None else after)
        )
        scalars = {
            "time": time,
            "dt": result.plan.dt,
            "kinetic": float(energy[0]),
            "gravity": float(energy[1]) - self._first_gravity,
            "elastic": float(energy[2:].sum()),
            "lost": -losses,
            "put_in": gifts + self._given + given,
            "energy_error": total - self.first_energy - losses - gifts - given,
            **self.balances[frame].scalars,
            "tension_max": float(seen.greatest_tension.max(initial=0.0)),
            "strain_max": self._strain(data.get("elastic_tension", data["tension"])[row]),
            "low": float(seen.least_height.min()),
            "high": float(seen.greatest_height.max()),
            "touching": float(np.count_nonzero(heights < ground.height)) if ground else 0.0,
            **(turns_of(data[PULLEYS][row]) if PULLEYS in data else {}),
        }
        touch = self.touched.of(data, row, frame)
        return Picture(scalars, positions, tension, speed, anchors, [], seen, touch)

    def _seen(self, frame: int, after: int) -> Seen:
        """Return what was seen after frame `after`, or since it where that was recorded, until `frame`."""
        found: Seen | None = None
        first = max(after + 1, 0)
        while first <= frame:
            data, row = self._read(first)
            rows = slice(row, min(row + frame - first + 1, len(data["time"])))
            here = self._of_rows(data, rows)
            found = here if found is None else found.joined(here)
            first += rows.stop - rows.start
        assert found is not None
        low, high = (np.where(np.isnan(pull), 0.0, pull) for pull in found[:2])
        return found._replace(least_tension=low, greatest_tension=high)

    def _of_rows(self, data: dict[str, Floats], rows: slice) -> Seen:
        """Return what some frames of a piece have seen; the frames themselves where that was not kept.

        Tensions are NaN where there was no rope in any of them: zeros stand there, and count for nothing.
        """
        if all(name in data for name in _SEEN.values()):
            values = [data[name][rows] for name in _SEEN.values()]
        else:
            tension, heights = data["tension"][rows], data["positions"][rows] @ self._up
            with np.errstate(over="ignore", invalid="ignore"):
                speed = np.linalg.norm(data["velocities"][rows], axis=2)
                force = np.linalg.norm(data.get("reactions", self._no_force)[rows], axis=2)
            values = list(Seen(tension, tension, speed, heights, heights, force))
        if _ROPE in data:
            values[:2] = [np.where(data[_ROPE][rows] > 0.0, pull, np.nan) for pull in values[:2]]
        return Seen(
            *(
                (np.fmin if name.startswith("least") else np.fmax).reduce(value, axis=0)
                for name, value in zip(Seen._fields, values, strict=True)
            )
        )

    def _broken(self, step: int) -> Picture:
        assert self.past is not None
        last = self.picture(self.result.frames - 1)
        positions = self.past.positions[step]
        before = self.past.positions[step - 1] if step else last.positions
        speed = np.linalg.norm(positions - before, axis=1) / self.result.plan.dt
        tension = last.tension if self.past.tension is None else self.past.tension[step]
        anchors = last.anchors.copy()
        anchors[:, 3:9] = 0.0  # neither velocity nor force is known
        anchors[:, :3] = positions[list(self.result.layout.anchor_nodes)]
        force = np.zeros((len(anchors), 3))
        seen = Seen.instant(tension, speed, positions @ self._up, force)
        return last._replace(
            positions=positions,
            tension=tension,
            speed=speed,
            anchors=anchors,
            seen=seen,
            touch=self.touched.none,
        )

    def _strain(self, tension: Floats) -> float:
        found = 0.0
        for rope, span in zip(self.result.scene.ropes, self.result.layout.ropes, strict=True):
            stiff = rope.segment_stiffness * rope.segment_length
            most = float(tension[span.first : span.last].max(initial=0.0))
            if isinstance(rope.made_of, Material) and rope.made_of.curve is not None:
                found = max(found, float(rope.made_of.curve.strain_at(most)))
            elif stiff > 0.0:
                found = max(found, most / stiff)
        return found

    def _read(self, frame: int) -> tuple[dict[str, Floats], int]:
        piece = frame // _PIECE
        if piece != self._piece:
            names = [*_NAMES]
            more = (*_MORE, *_SEEN.values())
            names += [name for name in more if name in self.result.source.names]
            start, stop = piece * _PIECE, (piece + 1) * _PIECE
            found = {name: self.result.source.read(name, start, stop) for name in names}
            if self.result.ends:  # a rope that broke lies still, and carries nothing that is known
                still = ("velocities", "tension", "elastic_tension", "reactions")
                found |= {name: np.nan_to_num(found[name]) for name in still if name in found}
            if self.result.scene.parts or self.result.scene.winches:
                found[_ROPE] = had_rope(self.result, start, stop).astype(float)
            found["work"] = np.nan_to_num(found["work"])  # NaN without a ledger
            self._data = found
            self._piece = piece
        return self._data, frame - piece * _PIECE


def followed(results: Sequence[Result]) -> list[Recorded]:
    """Return the parts of a session, each with its energies counted on from that which it goes on from."""
    found = [Recorded(result) for result in results]
    for part in found[:-1]:
        part.past = None  # it was gone on from
    for number, part in enumerate(found):
        begun = [one for one in found[:number] if one.time[0] <= part.time[0]]
        known = [one for one in begun if part.time[0] <= _latest(one)] or begun
        if known and part.time[0] > 0.0:
            part.follow(known[-1])
    return found


def _latest(part: Recorded) -> float:
    """Return the latest time [s] at which another part may go on from one: its next frame's."""
    last = part.time[-2:]
    return float(last[-1] + max(last[-1] - last[0], part.result.plan.frame_interval)) + 1e-9
