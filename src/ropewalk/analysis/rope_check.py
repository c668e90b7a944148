"""One rope as a check says it: its waves, and what it carries at rest."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ropewalk.analysis.rest_notes import may_say_nothing, ropes_beyond_limiter
from ropewalk.analysis.strains import softer_words, strain_words, words_of_curve
from ropewalk.core.arrays import Floats
from ropewalk.lowering import Model
from ropewalk.lowering.elastic_tables import slopes_at_rest
from ropewalk.record.borne import borne_at
from ropewalk.record.end_weight import MORE
from ropewalk.record.margins import breaking_load, margin_words
from ropewalk.scene import Rope
from ropewalk.scene.from_library import origin_words
from ropewalk.scene.guess import doubt_of
from ropewalk.scene.knotted import both_doubt, knot_doubt, least_worst
from ropewalk.scene.rope import mass_words
from ropewalk.statics import Statics
from ropewalk.words.counts import counted
from ropewalk.words.prefixes import prefixed
from ropewalk.words.pushes import largest_push, pull_told

_OF_REST = (  # None where it is not at rest
    "transverse",
    "largest_tension",
    "largest_strain",
    "slack",
    "utilisation",
    "worst",
    "largest_push",
    "largest_anchor_force",
    "anchor_bears",
    "parts_at_rest",
)
_OF_MARGIN = ("utilisation", "worst", "doubt")  # None where a limiter would act
_SHORT = 0.01  # a curve's chords are a little shorter than its arcs


@dataclass(frozen=True)
class RopeCheck:
    """One rope's waves and state at rest."""

    name: str
    segments: int
    length: float  # unstretched [m]
    mass: float  # with loads [kg]
    own_mass: float  # without loads [kg]
    longitudinal: tuple[float, float]  # slowest and fastest wave along the rope at rest [m/s]
    transverse: tuple[float, float] | None  # slowest and fastest sideways wave at rest [m/s]
    largest_tension: float  # at rest [N]
    largest_strain: (
        float | None
    )  # at rest, length over rest length less 1 [1]; None without a rest length
    slack: int  # segments without tension at rest
    short: int  # segments that start more than 1 % shorter than their rest length
    made_of: str = ""  # which rope of the library it is, and what was changed
    curve: str = ""  # of its tension against strain, in words
    # At rest, the largest tension, or what the anchor beside it bears, over the breaking load [1];
    # None if not known.
    utilisation: float | None = None
    rests: bool = True  # whether it is at rest in that shape, or near to it
    parts: bool = False  # whether it parts at its breaking load
    doubt: str = ""  # what guesses and knots make of the utilisation
    worst: float | None = (
        None  # utilisation with the least that a knot leaves of the least of a guess [1]
    )
    softer: str = ""  # why the rope itself stretches more at rest
    largest_push: float = 0.0  # at rest, of a segment that is pressed [N]; 0 where none is
    largest_anchor_force: float | None = (
        None  # beside the largest tension, where it is half a segment's weight more [N]
    )
    anchor_bears: float | None = None  # there, where this makes the utilisation [N]
    parts_at_rest: bool = (
        False  # whether a segment does; an anchor may bear more than that beside it
    )
    limited: bool = False  # whether it, or what is joined to it, rests beyond a stretch limiter
    at_least: bool = False  # whether itself does: rest is without the limiter, so it carries more

    @property
    def unknown(self) -> bool:
        """Whether a limiter leaves open how near to breaking it comes: it may not, as far as is known."""
        return self.limited and (self.worst is None or self.worst <= 1.0)

    def lines(self) -> list[str]:
        """What it is, and what it carries at rest; one fact a line."""
        masses = mass_words(self.own_mass, self.mass, ".6g")
        text = [
            f"rope {self.name!r}: {counted(self.segments, 'segment')}, {self.length:.6g} m, {masses}"
        ]
        text += [f"  {one}" for one in (self.made_of, self.curve) if one]
        if not self.rests:
            return text
        strain = (
            "" if self.largest_strain is None else f", strain {strain_words(self.largest_strain)}"
        )
        text.append(f"  at rest: largest tension {prefixed(self.largest_tension, 'N', 5)}{strain}")
        text += [f"  at rest: {self.softer}"] if self.softer and self.largest_tension > 0.0 else []
        text += self._anchor_line()
        if self.largest_push > 0.0:
            text.append(f"  at rest: largest push {prefixed(self.largest_push, 'N', 5)}")
        if self.utilisation is not None and self.unknown:
            text.append("  at rest: how near to breaking is not known, for the stretch limiter")
        elif self.utilisation is not None:
            beyond = "it would have parted"
            if self.parts:
                beyond = "it parts" if self.parts_at_rest else "with more segments it parts"
            doubt = f"; {self.doubt}" if self.doubt else ""
            near = margin_words(self.utilisation, beyond, least=self.at_least)
            text.append(f"  at rest: {near}{doubt}")
        if self.slack or self.short:
            text.append(f"  segments slack at rest {self.slack}, started too short {self.short}")
        return text

    def _anchor_line(self) -> list[str]:
        """Return what its anchor bears, where that is more than the segments carry."""
        by_weight = self.largest_anchor_force is not None
        more = (self.largest_anchor_force if by_weight else self.anchor_bears) or 0.0
        if not more > (1.0 + MORE) * self.largest_tension:
            return []
        why = "half a segment's weight more"
        if not by_weight:
            why = "with what else acts on its node, as wind and bending do"
        return [f"  at rest: its anchor bears {prefixed(more, 'N', 5)}, {why}"]

    def as_dict(self) -> dict[str, object]:
        """Plain values; None for all that is said of rest where it is not at rest.

        And for how near to breaking it comes where a limiter would carry it, and it is not beyond already.
        """
        unknown = _OF_REST if not self.rests else _OF_MARGIN if self.unknown else ()
        return vars(self) | dict.fromkeys(unknown)

    def waves(self) -> str:
        """The speeds of its waves."""
        slow, fast = (f"{speed:.4g}" for speed in self.longitudinal)
        waves = f"rope {self.name!r}: waves along it {slow} m/s"
        if slow != fast:
            waves = f"rope {self.name!r}: waves along it {slow} to {fast} m/s at rest"
        if math.isinf(self.longitudinal[1]):
            waves = f"rope {self.name!r}: rigid links: a pull runs along it at once"
        if self.transverse:
            low, high = self.transverse
            waves += f", sideways {low:.4g} to {high:.4g} m/s at rest"
        return waves


def rope_check(model: Model, statics: Statics, name: str) -> RopeCheck:
    """Return what a check says of the rope of this name."""
    rope, span = model.scene.rope_named(name), model.layout.span(name)
    segments = slice(span.start, span.end)
    own = rope.own_mass / max(rope.nodes - (0 if rope.made_of.kind == "springs" else 1), 1)
    rest, tension = model.state.rest_length[segments], statics.tension[segments]
    rests = statics.solved or not may_say_nothing(model)
    load = breaking_load(rope) if rests else None
    beyond, limited = ropes_beyond_limiter(model, statics)
    size = np.linalg.norm(np.diff(model.state.x[:, span.start : span.end + 1], axis=1), axis=0)
    over = float(statics.left[span.start])
    left = over if statics.solved else 0.0  # else it is no rounding
    taut = (tension > 0.0) & ~statics.slack[segments]
    largest = pull_told(float(tension.max(initial=0.0)), left)
    about, tightest = (model.scene, model.layout), span.start + int(np.argmax(tension))
    pull = float(statics.tension[tightest])
    ends = borne_at(about, tightest, pull, statics.reactions, statics.positions)
    bears = ends.force if load is not None and ends.counts and ends.force > largest else None
    use = None if load is None else (bears or largest) / load
    # A sideways wave runs sqrt(T l / m), l the stretched length of a segment and m a node's mass.
    stretched = np.linalg.norm(
        np.diff(statics.positions[span.start : span.end + 1], axis=0), axis=1
    )
    speed = np.sqrt(np.maximum(tension[taut] * stretched[taut], 0.0) / own)
    return RopeCheck(
        name=name,
        segments=rope.segments,
        length=rope.length_unstretched,
        mass=rope.total_mass,
        own_mass=rope.own_mass,
        longitudinal=_speeds_along(model, rope, segments, own, statics.stretch, stretched),
        transverse=(float(speed.min()), float(speed.max())) if speed.size else None,
        largest_tension=largest,
        largest_strain=_strain(rest, statics.stretch[segments]),
        slack=int(statics.slack[segments].sum()),
        short=int((size < rest * (1.0 - _SHORT)).sum()),
        made_of=origin_words(rope.made_of),
        curve=words_of_curve(rope),
        softer=softer_words(rope.made_of),
        utilisation=use,
        rests=rests,
        parts=rope.strength < math.inf,
        doubt=""
        if use is None
        else "; ".join(
            filter(
                None,
                (doubt_of(rope.made_of, use), knot_doubt(rope, use), both_doubt(rope, use)),
            )
        ),
        worst=None if use is None else least_worst(rope, use),
        largest_push=largest_push(tension, over),
        largest_anchor_force=ends.force
        if ends.by_weight and pull_told(ends.force, left) > 0.0
        else None,
        anchor_bears=bears,
        parts_at_rest=rope.strength < math.inf and load is not None and largest > load,
        limited=name in limited,
        at_least=name in beyond,
    )


def _speeds_along(
    model: Model, rope: Rope, segments: slice, node_mass: float, stretch: Floats, stretched: Floats
) -> tuple[float, float]:
    """Return the slowest and the fastest wave along a rope [m/s]; `stretch` [1], (s,), of all segments.

    Where a part of the stiffness relaxes slow waves do without it, and fast ones have it. Along springs
    without a rest length they run as far as these have been `stretched` at rest [m].
    """
    length = rope.segment_length
    if length == 0.0:
        rate = math.sqrt(rope.segment_stiffness / node_mass)
        return float(stretched.min()) * rate, float(stretched.max()) * rate
    if not model.system.elastic.time.size or (model.system.elastic.of[segments] < 0).all():
        speed = length * math.sqrt(rope.segment_stiffness / node_mass)
        return speed, speed
    slow, fast = slopes_at_rest(model.system, model.state, stretch - 1.0)
    least, most = float(slow[segments].min()), float(fast[segments].max())
    return length * math.sqrt(least / node_mass), length * math.sqrt(most / node_mass)


def _strain(rest: Floats, stretch: Floats) -> float | None:
    """Return the largest strain [1] of segments of a rest length, 0 where all are slack."""
    strains = stretch[rest > 0.0] - 1.0
    return max(float(strains.max()), 0.0) if strains.size else None
