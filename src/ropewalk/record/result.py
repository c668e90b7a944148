"""The result of a run: what was recorded, in memory or in a run folder."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.lowering import Layout, Plan
from ropewalk.lowering.layout import make_layout
from ropewalk.record.balances import balance_residual, energy_error
from ropewalk.record.beyond import Beyond
from ropewalk.record.beyond import load as load_beyond
from ropewalk.record.body_energies import turning_of
from ropewalk.record.books import told
from ropewalk.record.ends import End
from ropewalk.record.errors import RunError
from ropewalk.record.facts import Facts
from ropewalk.record.folder import open_parts, save_result
from ropewalk.record.good import good_part
from ropewalk.record.outlets import Outlets
from ropewalk.record.parted import Parting, fault_of_partings, partings_of
from ropewalk.record.place import EVENTS
from ropewalk.record.point_forces import PointForces
from ropewalk.record.quantities import has_rope, labels, rest_length_at_start
from ropewalk.record.rope_view import RopeView
from ropewalk.record.source import Source
from ropewalk.record.summary import in_words, summary
from ropewalk.scene import Scene
from ropewalk.words.annotations import unquoted

Bools = np.ndarray[Any, np.dtype[np.bool_]]


@unquoted
class Result(PointForces, Outlets):
    """What a run recorded. All SI; frame 0 is the initial state.

    Arrays hold all ropes one after another, `rope(name)` gives one rope's own. The segment between two
    ropes and the segments on a winch's drum carry no force: their tension is 0 (`live` tells them).
    A result opened from a run folder reads a quantity when it is first used.
    """

    def __init__(
        self,
        scene: Scene,
        layout: Layout,
        source: Source,
        facts: Facts,
        folder: Path | None = None,
        beyond: Beyond | None = None,
    ) -> None:
        self._beyond = beyond
        self.scene, self.layout, self.source, self.facts = scene, layout, source, facts
        self.folder = folder
        self._cache: dict[str, Floats] = {}

    @classmethod
    def open(cls, folder: str | Path) -> Result:
        """Open a run folder, finished or not.

        Raises RunError when it is none, or damaged.
        """
        scene, facts, stored = open_parts(Path(folder))
        return cls(scene, make_layout(scene), stored, facts, Path(folder))

    def save(self, folder: str | Path, *, overwrite: bool = False) -> Result:
        """Write the result as a run folder and return it as opened from there.

        Raises RunError when the folder exists (unless `overwrite` and it is a run folder) or cannot
        be written.
        """
        save_result(self, Path(folder), overwrite)
        return type(self).open(folder)

    # -- what was recorded ---------------------------------------------------------------

    def read(self, name: str, start: int = 0, stop: int | None = None) -> Floats:
        """Return a recorded quantity in its SI unit, of some frames only, (frames, ...).

        `name` is that of the property, as "positions" [m], (frames, nodes, 3), or "tension" [N]; the
        frames are those from `start` to before `stop` (default: all).

        Raises KeyError for a quantity that this run did not record.
        """
        if name != "time" and name not in self.source.names:
            raise KeyError(f"no {name!r} in this run; there is {', '.join(self.source.names)}")
        if name in self._cache:
            return self._cache[name][start:stop]
        return self.source.read(name, start, stop)

    def _all(self, name: str) -> Floats:
        if name not in self._cache:
            self._cache[name] = self.read(name)
        return self._cache[name]

    @property
    def time(self) -> Floats:
        """Time of every frame [s], (frames,)."""
        return self._all("time")

    @property
    def positions(self) -> Floats:
        """Positions [m], (frames, nodes, 3)."""
        return self._all("positions")

    @property
    def velocities(self) -> Floats:
        """Velocities [m/s], (frames, nodes, 3)."""
        return self._all("velocities")

    @property
    def tension(self) -> Floats:
        """What the rope carries along each segment [N], (frames, segments); 0 where no rope is.

        Elastic tension, internal friction (of vector friction its part along the segment) and the bound of
        a limiter; of a rigid link what keeps its length. In a run folder of format 2, which recorded no
        more, the elastic tension alone: see `tension_name`.
        """
        return self._all("tension")

    @property
    def elastic_tension(self) -> Floats:
        """The springs' share of the tension [N], (frames, segments); of a rigid link all of it."""
        return self._all("elastic_tension" if self.has_total_tension else "tension")

    @property
    def has_total_tension(self) -> bool:
        """Whether `tension` is all that a segment carries; False for run folders of format 2."""
        return "elastic_tension" in self.source.names

    @property
    def tension_name(self) -> str:
        """What `tension` is: "tension", or "elastic tension" in a run folder of format 2."""
        return "tension" if self.has_total_tension else "elastic tension"

    @property
    def has_extremes(self) -> bool:
        """Whether every step was looked at: unless `run.extremes` is off, or the folder older than that."""
        return "extremes" in self.source.names

    @property
    def greatest_tension(self) -> Floats:
        """Greatest tension of all steps since the frame before [N], (frames, segments); both frames count.

        Of a run that kept no extremes the tension of the frame itself; so `least_tension`.
        """
        return self._all("greatest_tension" if self.has_extremes else "tension")

    @property
    def least_tension(self) -> Floats:
        """Least tension of all steps since the frame before [N], (frames, segments)."""
        return self._all("least_tension" if self.has_extremes else "tension")

    @property
    def greatest_height(self) -> Floats:
        """Greatest height of all steps since the frame before [m], (frames, nodes).

        Raises KeyError where a run kept no extremes, see `has_extremes`; so `least_height`, and
        `greatest_speed` [m/s], `greatest_stretch` [1] in `read`.
        """
        return self._all("greatest_height")

    @property
    def least_height(self) -> Floats:
        """Least height of all steps since the frame before [m], (frames, nodes)."""
        return self._all("least_height")

    @property
    def rest_length(self) -> Floats:
        """Unstretched length of the segments [m], (frames, segments); 0 where no rope is, nor any more."""
        if "rest_length" in self.source.names:
            return self._all("rest_length")
        fixed = rest_length_at_start(
            self.layout, [rope.segment_length for rope in self.scene.ropes]
        )
        return np.broadcast_to(fixed, (self.frames, fixed.size))

    @property
    def live(self) -> Bools:
        """Whether there is rope in a segment, (frames, segments)."""
        lengths = [rope.segment_length for rope in self.scene.ropes]
        return has_rope(self.layout, self.rest_length, lengths)

    @cached_property
    def energy(self) -> Mapping[str, Floats]:
        """Energies [J], each (frames,): kinetic, gravity, elastic, total; with any EI also bending.

        The total is the sum of these. What all other laws store (ground, obstacles, touching ropes, slides,
        added laws) is not in it: it is in their `work`, as a loss while it is stored, so that the total less
        all works tells of the method alone (`energy_error`).
        Gravity's is 0 in the scene's own shape, from which a run starts unless it starts at rest.
        """
        array = self._all("energy")
        parts = {name: array[:, i] for i, name in enumerate(labels(self.layout)["form"])}
        return parts | {"total": array.sum(axis=1)}

    @cached_property
    def work(self) -> Mapping[str, Floats]:
        """Work done on the rope since the start [J], each (frames,), by law and anchor:<name>.

        NaN without a ledger.
        """
        array = told(self, "work", self._all("work"))
        return {name: array[:, i] for i, name in enumerate(labels(self.layout)["law"])}

    @property
    def reactions(self) -> Floats:
        """Force of each anchor on the rope [N], (frames, anchors, 3), mean over the last step."""
        if "reactions" not in self.source.names:
            return np.zeros((self.frames, 0, 3))
        return self._all("reactions")

    @property
    def moments(self) -> Floats:
        """Moment of each clamp on the rope [N m], (frames, anchors, 3); 0 of other anchors."""
        if "moments" not in self.source.names:
            return np.zeros((self.frames, len(self.layout.anchor_names), 3))
        return self._all("moments")

    @property
    def momentum(self) -> Floats:
        """Momentum [kg m/s], (frames, 3)."""
        return self._all("momentum")

    @property
    def angular_momentum(self) -> Floats:
        """Angular momentum about the origin [kg m^2/s], (frames, 3)."""
        return self._all("angular_momentum")

    @cached_property
    def energy_error(self) -> Floats:
        """Energy that no law accounts for [J], (frames,): the error of method and step.

        total - total[0] - the works of all that has no potential: friction, air, ground, applied forces,
        limiter, winch, anchors, the turning of clamps, obstacles, contact of ropes, slides, parting.
        What the ledgers of bodies that their weight turns lack (`pulley`) is in it.
        NaN when the run kept no ledger, and in broken frames whose numbers are not finite.
        """
        bodies, error = turning_of(self), energy_error(self.energy, self.work, self.facts.ledger)
        return error + bodies.error if bodies else error

    @property
    def energy_errors(self) -> Floats:
        """Least and greatest energy error of all steps since the frame before [J], (frames, 2).

        Of ropes that move by themselves the sums, which bound that of all together. Of a run that kept no
        extremes those of the frames; NaN without a ledger.
        """
        if "energy_errors" in self.source.names:
            return self._all("energy_errors")
        return np.stack((self.energy_error, self.energy_error), axis=1)

    @cached_property
    def balance_residual(self) -> Floats:
        """Change of the kinetic energy minus all works on nodes [J], (frames,): round-off only.

        Left out are works that go into stored energy: those of winch and limiter, but for speeds that they
        change at once, of turning clamps and of parting.

        NaN when the run kept no ledger, and in broken frames whose numbers are not finite.
        """
        return balance_residual(self.energy, self.work, self._all("jump"), self.facts.ledger)

    # -- about the run -------------------------------------------------------------------

    @property
    def frames(self) -> int:
        """Number of frames, the initial one included."""
        return self.source.frames

    @property
    def good_frames(self) -> int:
        """Number of frames before a break; fewer than `frames` where a run was recorded on into it.

        Tables tell of these frames only.
        """
        return good_part(self)

    @cached_property
    def beyond(self) -> Beyond | None:
        """Single steps past the last good frame of a run that broke: `time` (k,), `positions` (k, nodes, 3).

        Figures show them in orange; no number is taken from them. None of a sound run, and of one recorded
        on into its break. Raises RunError when the run folder's copy is damaged.
        """
        if self.folder is None:
            return self._beyond
        found = load_beyond(self.folder)
        self.source.refuse_another()
        return found

    @property
    def nodes(self) -> int:
        """Number of nodes of all ropes, those on drums included."""
        return self.layout.nodes

    @property
    def plan(self) -> Plan:
        """Method, step length [s], steps per frame and planned frames."""
        return self.facts.plan

    @property
    def status(self) -> str:
        """How the run ended: finished, broke, interrupted; or running."""
        return self.facts.status

    @property
    def residual(self) -> float:
        """Largest force that is left on a free node of an equilibrium [N]; NaN for a run."""
        return float(self.facts.provenance.get("statics", {}).get("residual", math.nan))

    @property
    def diagnosis(self) -> str:
        """Why the run broke, in one or two sentences; empty otherwise."""
        return self.facts.diagnosis

    @property
    def ends(self) -> tuple[End, ...]:
        """Which ropes broke, after which frame and why, in this order; () for a sound run.

        Where others went on, a broken rope lies in later frames as it lay in its last good one; all other
        numbers of it are NaN there, and in sums over all ropes (energy, work, momentum) it counts as it was.
        With `[contact]` a rope that comes within its reach ends there, too.
        """
        return self.facts.ends

    @property
    def broke_at(self) -> float:
        """Time of the last good frame before the first break [s]; NaN for a sound run."""
        if self.ends:
            return self.ends[0].time
        return float(self.time[self.good_frames - 1]) if self.diagnosis else math.nan

    @property
    def events(self) -> tuple[dict[str, Any], ...]:
        """What happened, in order: anchors that let go, winches that stopped, a break, ...

        Each has `event`, and `time` [s] where it concerns the scene. See `docs/concepts/run-folder`.
        """
        return self.facts.events

    @property
    def partings(self) -> tuple[Parting, ...]:
        """Which segments parted: `time` [s], `rope`, `segment`, `tension` [N] each, in order of time.

        From then on a segment has no `rest_length`, no tension and is not `live`. Raises RunError where the
        folder's log is damaged.
        """
        if self.scene.parts and self.folder and (fault := fault_of_partings(self)):
            raise RunError(self.folder / EVENTS, fault)
        return partings_of(self.events)

    @property
    def table(self) -> dict[str, Any]:
        """The numbers that people want first, by name; see `summary.summary`."""
        return self._summary

    @cached_property
    def _summary(self) -> dict[str, Any]:
        return summary(self)

    # -- parts ---------------------------------------------------------------------------

    def rope(self, name: str | None = None) -> RopeView:
        """Return one rope of the result (without a name, the only one).

        Raises KeyError for an unknown name, or for no name with several ropes.
        """
        return RopeView(self, self.layout.span(name))

    def node(self, node: int, rope: str | None = None) -> dict[str, Floats]:
        """Return `time` [s] (f,), `position` [m], `velocity` [m/s] (f, 3), `height` [m] (f,) of a node.

        Negative nodes count from the rope's end. Raises KeyError for the rope, IndexError for the node.
        """
        index = self.layout.node(node, rope)
        position = self.positions[:, index]
        return {
            "time": self.time,
            "position": position,
            "velocity": self.velocities[:, index],
            "height": position @ np.asarray(self.scene.up),
        }

    def frame_at(self, time: float) -> int:
        """Return the frame nearest to a time [s]; outside the first or last one. ValueError for NaN."""
        if math.isnan(time):
            raise ValueError(f"time: {time!r} - must be a number of seconds")
        return int(np.argmin(np.abs(self.time - time)))

    # -- in words -------------------------------------------------------------------------

    def __repr__(self) -> str:
        return in_words(self)
