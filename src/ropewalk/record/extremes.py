"""The greatest and least of a whole run, with place and time."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ropewalk.core.arrays import Floats
from ropewalk.core.peaks import EXTREMES
from ropewalk.record.borne import Borne, borne_at
from ropewalk.record.drums import rope_place
from ropewalk.record.facts import AT_REST
from ropewalk.record.joined_ropes import joined_ropes
from ropewalk.record.limiter_at_rest import rests_beyond
from ropewalk.record.margins import (
    Margin,
    breaking_load,
    breaking_loads,
    doubt_words,
    guessed_worst,
    margin_of,
    margin_words,
    utilisations,
)
from ropewalk.record.quantities import has_rope, rest_length_at_start
from ropewalk.scene.knotted import knotted_worst, least_worst

if TYPE_CHECKING:
    from ropewalk.record.result import Result

SEEN = "of the recorded frames"  # between two of them there may be more
_VALUES = 2_000_000  # numbers of one quantity looked at together
UTILISATION = "greatest utilisation"  # of the breaking load [1]
GUESSED = "utilisation nearest with the least of guesses"  # of the breaking load as given [1]
KNOTTED = "utilisation nearest with the least of knots"  # of the breaking load without the knot [1]
DOUBTED = "utilisation nearest with the least of both"  # as KNOTTED, of the load as given [1]
LEAST = ("least tension", "lowest point")
_SIGNS = np.array([-1.0 if name in LEAST else 1.0 for name in EXTREMES])
_COLUMNS = np.arange(len(EXTREMES))
_NOUNS = {"speed": "node", "point": "node", "force": "anchor", "moment": "anchor"}


class Extreme(NamedTuple):
    """One extreme of a run: NaN where there is none."""

    value: float
    place: int  # segment, node or anchor in the arrays
    since: float  # [s] it was reached after this time (or at it, where both are one) ...
    until: float  # [s] ... and not after this one
    every_step: bool  # or of the recorded frames alone

    @property
    def when(self) -> str:
        """The time in words: an instant, or after one and not after the other."""
        if self.since == self.until:
            return f"t = {self.until:.6g} s"
        return f"t from {self.since:.6g} to {self.until:.6g} s"


def place_of(result: Result, name: str, extreme: Extreme) -> str:
    """Return place and time of an extreme in words, and of what it is one; empty where there is none."""
    if math.isnan(extreme.value):
        return ""
    seen = "" if extreme.every_step else f", {SEEN}"
    noun = _NOUNS.get(name.split()[-1], "segment")
    if noun == "anchor":
        return f"anchor {result.layout.anchor_names[extreme.place]!r}, {extreme.when}{seen}"
    place = rope_place(result, noun, extreme.place, extreme.until)
    if name == UTILISATION and result.status == AT_REST:
        ends = _borne(result, extreme.place)
        if ends.anchor is not None and ends.most > ends.tension:
            place = f"anchor {result.layout.anchor_names[ends.anchor]!r} beside {place}"
    return f"{place}, {extreme.when}{seen}"


def extremes(result: Result) -> dict[str, Extreme]:
    """Return the extremes before a break by their names in `core.peaks.EXTREMES`.

    Of every step where the run has kept them, else of the recorded frames. Units: N, N, 1, m/s, m, m, N, N m.
    Besides UTILISATION, GUESSED, KNOTTED and DOUBTED, where a breaking load is known.
    """
    found = _of_steps(result) if result.has_extremes else _of_frames(result)
    return found | _utilisation(result, found["greatest tension"])


def had_rope(result: Result, start: int = 0, stop: int | None = None) -> NDArray[np.bool_]:
    """Tell where there was rope at any step since the frame before, (frames, segments).

    What has parted since, or been reeled in, is not `live` in the frame itself. Zeros stand where a run that
    keeps extremes has seen no rope: slack rope has at least its stretch. Of any other run the frames tell.
    """
    if "rest_length" in result.source.names:
        rest = result.read("rest_length", start, stop)
    else:
        rest = result.rest_length[start:stop]
    found = has_rope(result.layout, rest, [rope.segment_length for rope in result.scene.ropes])
    if result.has_extremes and not found.all():
        found |= result.read("greatest_stretch", start, stop) > 0.0
        for name in ("least_tension", "greatest_tension"):
            found |= result.read(name, start, stop) != 0.0
    return found


def _of_steps(result: Result) -> dict[str, Extreme]:
    """Return the extremes of every step."""
    good = result.good_frames
    values, places = result.read("extremes", 0, good), result.read("extreme_places", 0, good)
    since, until = result.read("extreme_since", 0, good), result.read("extreme_until", 0, good)
    signed = _SIGNS * values
    sound = np.isfinite(signed)
    signed[~sound] = -np.inf
    at = signed.argmax(axis=0), _COLUMNS
    columns = (sound[at], values[at], places[at], since[at], until[at])
    found = {}
    for name, there, *about in zip(EXTREMES, *(part.tolist() for part in columns), strict=True):
        value, place, first, last = about if there else (math.nan, 0, math.nan, math.nan)
        found[name] = Extreme(value, int(place), first, last, True)
    return found


def _utilisation(result: Result, pull: Extreme) -> dict[str, Extreme]:
    """Return the greatest tension over breaking load; `pull` is the greatest tension, often the same.

    At rest what the anchor beside it bears counts, as in a check. And of the ropes that come nearest with
    the least of guessed breaking loads, with the least that knots leave, and with both, over their own as
    given.
    """
    loads = breaking_loads(result.scene, result.layout)
    if loads is None:
        return {}
    use = _greatest_share(result, loads, pull)
    found, seen = {UTILISATION: use}, [(loads, use)]
    worsts = {GUESSED: guessed_worst, KNOTTED: knotted_worst, DOUBTED: least_worst}
    for name, worst in worsts.items():
        least = breaking_loads(result.scene, result.layout, worst=worst)
        same = [one for other, one in seen if least is None or np.array_equal(other, least)]
        if least is not None and not same:
            most = _greatest_share(result, least, pull)
            as_given = float(least[most.place] / loads[most.place])
            same.append(most._replace(value=most.value * as_given))
            seen.append((least, same[0]))
        found[name] = same[0]
    return found


def margin(result: Result, found: dict[str, Extreme]) -> Margin | None:
    """Return how near a run comes to breaking by its extremes; None where that is not known.

    Nor is it at rest where a stretch limiter would carry, which takes no part in that: a rope may be far
    nearer. What comes beyond its breaking load without it, or may, is told: it is the least.
    """
    near = [found[name] for name in (UTILISATION, GUESSED, KNOTTED, DOUBTED) if name in found]
    if not near or math.isnan(near[0].value):
        return None
    use, guess, knot, both = ((result.layout.rope_of(one.place)[0], one.value) for one in near)
    told, scene = Margin(*use, *guess, *knot, *both), result.scene
    beyond, changed = _limited(result, found)
    if all(breaking_load(rope) is None for rope in scene.ropes if rope.name in changed):
        return told
    if least_worst(scene.rope_named(told.doubted), told.as_given) <= 1.0:
        return None
    return told._replace(least=told.name not in changed - beyond)  # what is joined may be relieved


def margin_of_others(result: Result, found: dict[str, Extreme]) -> str:
    """Return whose margin at rest a stretch limiter leaves open, and what the other ropes' is; else ""."""
    changed, scene = _limited(result, found)[1], result.scene
    loads = breaking_loads(scene, result.layout)
    if loads is None or not changed or margin(result, found) is not None:
        return ""
    names = [
        repr(rope.name)
        for rope in scene.ropes
        if rope.name in changed and breaking_load(rope) is not None
    ]
    whose = f"rope {names[0]}" if len(names) == 1 else f"ropes {', '.join(names)}"
    told = f"not known at rest of {whose}, for the stretch limiter"
    shares = {
        name: _borne(result, segment).most / float(loads[segment])
        for segment in _pulled_most(result)
        if (name := result.layout.rope_of(segment)[0]) not in changed
        and math.isfinite(loads[segment])
    }
    if not shares:
        return told
    near = margin_of(scene, shares)
    told += f"; of the others rope {near.name!r} comes nearest, {margin_words(near.utilisation)}"
    doubt = doubt_words(scene, near)
    return f"{told}; {doubt}" if doubt else told


def _limited(result: Result, found: dict[str, Extreme]) -> tuple[set[str], set[str]]:
    """Return the ropes that rest beyond their limiter, and those with what is joined to them."""
    beyond = rests_beyond(result, found)
    return beyond, joined_ropes(result.scene, result.layout, beyond) if beyond else set()


def _greatest_share(result: Result, loads: Floats, pull: Extreme) -> Extreme:
    """Return the greatest tension over these loads, (segments,) [N]; at rest what is borne there."""
    if result.status == AT_REST:
        return _share_at_rest(result, loads)
    name = "greatest_tension" if result.has_extremes else "tension"
    best, at, step = -math.inf, (0, 0), _pieces(result)
    for start in range(0, result.good_frames, step):
        tension = result.read(name, start, min(start + step, result.good_frames))
        shares = utilisations(tension, loads)
        shares = np.where(np.isfinite(shares), shares, -np.inf)
        frame, column = divmod(int(np.argmax(shares)), shares.shape[1])
        if shares[frame, column] > best:
            best, at = float(shares[frame, column]), (start + frame, column)
    if best == -math.inf:
        return Extreme(math.nan, 0, math.nan, math.nan, result.has_extremes)
    if pull.place == at[1] and pull.value / loads[at[1]] == best:
        return pull._replace(value=best)
    last = float(result.time[at[0]])
    first = float(result.time[max(at[0] - 1, 0)]) if result.has_extremes else last
    return Extreme(best, at[1], first, last, result.has_extremes)


def shares(result: Result, tension: Floats) -> Floats:
    """Return tensions over breaking loads, (frames, segments) [1]; NaN where none is known.

    At rest of what ropes or the anchors beside them bear, as in the table. There it is NaN of ropes that a
    stretch limiter would hold below their breaking load, and of all where such a one may come nearest, see
    `margin`. Raises LookupError without a load.
    """
    loads = breaking_loads(result.scene, result.layout)
    if loads is None:
        raise LookupError("no rope has a breaking_load")
    found = np.where(np.isfinite(loads), utilisations(tension, loads), np.nan)
    if result.status == AT_REST:
        for segment in filter(lambda one: math.isfinite(loads[one]), _pulled_most(result)):
            found[0, segment] = _borne(result, segment).most / float(loads[segment])
    if result.status == AT_REST and result.scene.limiter:
        seen = extremes(result)
        if margin(result, seen) is None:
            found[:] = math.nan
        for name in _limited(result, seen)[1]:
            span, rope = result.layout.span(name), result.scene.rope_named(name)
            of_rope = found[:, span.first : span.last]
            if not least_worst(rope, float(np.nan_to_num(of_rope).max())) > 1.0:
                of_rope[:] = math.nan
    return found


def _pulled_most(result: Result) -> list[int]:
    """Return the segment with the largest tension of every rope of an equilibrium."""
    tension = np.nan_to_num(result.read("tension", 0, 1)[0], nan=-math.inf)
    spans = result.layout.ropes
    return [span.start + int(np.argmax(tension[span.start : span.end])) for span in spans]


def _share_at_rest(result: Result, loads: Floats) -> Extreme:
    """Return the greatest of what ropes or the anchors beside them bear over these loads, (segments,) [N]."""
    best, at = math.nan, 0
    for segment in _pulled_most(result):
        share = _borne(result, segment).most / float(loads[segment])
        if math.isfinite(loads[segment]) and not share <= best:
            best, at = share, segment
    return Extreme(best, at, 0.0, 0.0, result.has_extremes)


def _borne(result: Result, segment: int) -> Borne:
    """Return what is borne at rest at the segment of a rope's largest tension."""
    frame = {name: result.read(name, 0, 1)[0] for name in ("tension", "reactions", "positions")}
    about, pull = (result.scene, result.layout), float(frame["tension"][segment])
    return borne_at(about, segment, pull, frame["reactions"], frame["positions"])


def _pieces(result: Result) -> int:
    """Return how many frames to look at together."""
    step = max(1, _VALUES // (3 * result.nodes))
    if result.source.chunk < result.frames:
        step = max(1, step // result.source.chunk) * result.source.chunk
    return step


def _of_frames(result: Result) -> dict[str, Extreme]:
    """Return the extremes of the recorded frames. Reads them in pieces."""
    best: dict[str, tuple[float, int, int]] = {}
    step = _pieces(result)
    for start in range(0, result.good_frames, step):
        stop = min(start + step, result.good_frames)
        for name, values in _measures(result, start, stop).items():
            sign = -1.0 if name in LEAST else 1.0
            signed = np.where(np.isfinite(values), sign * values, -np.inf)
            if not signed.size:
                continue
            frame, column = divmod(int(np.argmax(signed)), values.shape[1])
            if signed[frame, column] > best.get(name, (-math.inf, 0, 0))[0]:
                best[name] = (float(signed[frame, column]), start + frame, column)
    found = {name: Extreme(math.nan, 0, math.nan, math.nan, False) for name in EXTREMES}
    for name, (signed_value, frame, column) in best.items():
        time, sign = float(result.time[frame]), -1.0 if name in LEAST else 1.0
        found[name] = Extreme(sign * signed_value, column, time, time, False)
    return found


def _measures(result: Result, start: int, stop: int) -> dict[str, Floats]:
    """Return what the frames themselves say by the name of its extreme; NaN where there is no rope."""
    positions = result.read("positions", start, stop)
    lengths = [rope.segment_length for rope in result.scene.ropes]
    if "rest_length" in result.source.names:
        rest = result.read("rest_length", start, stop)
    else:
        rest = rest_length_at_start(result.layout, lengths)
    live = has_rope(result.layout, rest, lengths)
    with np.errstate(invalid="ignore", over="ignore"):
        length = np.linalg.norm(np.diff(positions, axis=1), axis=2)
        stretch = np.divide(
            length, rest, out=np.full(length.shape, np.nan), where=live & (rest > 0.0)
        )
        speed = np.linalg.norm(result.read("velocities", start, stop), axis=2)
        heights = positions @ np.asarray(result.scene.up)
        sizes = {
            name: np.linalg.norm(result.read(name, start, stop), axis=2)
            for name in ("reactions", "moments")
            if name in result.source.names
        }
    tension = np.where(live, result.read("tension", start, stop), np.nan)
    none = np.zeros((stop - start, 0))
    values = (
        *(tension, tension, stretch, speed, heights, heights),
        *(sizes.get("reactions", none), sizes.get("moments", none)),
    )
    return dict(zip(EXTREMES, values, strict=True))
