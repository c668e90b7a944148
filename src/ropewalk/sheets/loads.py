"""What a sheet says of forces: at rest, and the greatest of a run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropewalk.record.extremes import (
    UTILISATION,
    Extreme,
    extremes,
    margin,
    margin_of_others,
    place_of,
)
from ropewalk.record.hard_stops import hard_note
from ropewalk.record.landings import Landing, landings_of
from ropewalk.record.margins import Margin, doubt_words, margin_bounds
from ropewalk.record.moment_notes import moment_note
from ropewalk.record.moving_rows import moving_rows
from ropewalk.record.note_kinds import HARD, notes_of_extremes
from ropewalk.record.pressed_rows import pressed_rows
from ropewalk.record.tension_notes import anchor_bears
from ropewalk.record.too_low import margin_too_low, tension_too_low
from ropewalk.scene.guess import COMPUTE
from ropewalk.sheets.content import Item, Section, Table, Text
from ropewalk.sheets.ropes import NO_DRAG
from ropewalk.statics.wraps import MANY, coarse_words
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.core.arrays import Floats
    from ropewalk.record.result import Result
    from ropewalk.statics import RestSpan, Statics

_TITLES = {
    "greatest tension": ("largest tension", "N"),
    "least tension": ("least tension", "N"),
    "greatest stretch": ("largest length over unstretched", ""),
    "greatest speed": ("largest speed", "m/s"),
    "highest point": ("highest point", "m"),
    "lowest point": ("lowest point", "m"),
    "greatest anchor force": ("largest force on an anchor", "N"),
    "greatest clamp moment": ("largest moment on a clamp", "N m"),
}
#: What a run's notes are of.
_PEAKS = {
    "greatest tension": "tension",
    "greatest anchor force": "force on an anchor",
    "greatest clamp moment": "moment on a clamp",
    UTILISATION: "utilisation",
}
_NAMED = 3  # partings that are told one by one
_ROUNDING = 1e-9  # [1] of a force: components below are nothing
_SIGN = "Forces of the ropes on the anchors; components along x, y and z."


def summary_section(
    rest: Result | None, run: Result | None, more: tuple[Item, ...] = (), then: str = COMPUTE
) -> Section:
    """Return the numbers that a job is decided by, of the shape of rest and of the run, and their doubts.

    `more`: what is to be said of convergence and of guessed stiffnesses; `then`: what was done about these
    (`doubt_words`).
    """
    rows, doubts = [], dict[str, list[str]]()
    for title, result in (("at rest", rest), ("in the run", run)):
        if result is not None:
            found = extremes(result)
            force = found["greatest anchor force"].value
            if result.status == "at rest" and result.layout.anchor_names:
                force = float(np.linalg.norm(result.reactions[0], axis=1).max())
            near = margin(result, found)
            rows.append(
                (
                    title,
                    _value(found["greatest tension"].value, "N"),
                    "none" if math.isnan(force) else _value(force, "N"),
                    *_margin_cells(result, near),
                )
            )
            if near is not None and (doubt := doubt_words(result.scene, near, then)):
                doubts.setdefault(doubt, []).append(title)
    head = ("", "largest tension", "largest force on an anchor", "utilisation", "safety factor")
    items: list[Item] = [Table(head, rows)]
    items += [] if rest is None else _limited(rest)
    for doubt, titles in doubts.items():
        items.append(Text(f"{' and '.join(titles).capitalize()}: {doubt}.", warning=True))
    items += [] if run is None else _of_the_run(run)
    items += more
    if run is not None and run.diagnosis:
        items.append(Text("The run broke: see below. Its numbers end there.", warning=True))
    if run is not None and run.partings:
        items.append(_parted(run))
    return Section("Summary", tuple(items))


def _limited(rest: Result) -> list[Item]:
    """Return what is to be said of an equilibrium that a stretch limiter would not let be."""
    note = rest.table.get("about the stretch limiter")
    return (
        [Text(f"The stretch limiter takes no part in rest; {note}.", warning=True)] if note else []
    )


def _of_the_run(run: Result) -> list[Item]:
    """Return what is to be said where the numbers of a run stand first."""
    found = extremes(run)
    most = found["greatest tension"]
    items: list[Item] = []
    if hard := hard_note(run, found):
        items.append(Text(f"Hard stops in the run: {hard}.", warning=True))
        return items + _of_energy(run)
    if note := tension_too_low(run, most)[1]:
        items.append(Text(f"The largest tension in the run: {note}.", warning=True))
    if UTILISATION in found and (note := margin_too_low(run, found[UTILISATION], most)[1]):
        items.append(Text(f"The largest utilisation in the run: {note}.", warning=True))
    if note := anchor_bears(run, most):
        said = f"The largest tension in the run is that of a segment: {note}."
        items.append(Text(said, warning=True))
    return items + _of_energy(run)


def _of_energy(run: Result) -> list[Item]:
    if not run.table.get("about the energy"):
        return []
    said = "Before numbers of the run are used, see what is said of its energy under Method."
    return [Text(said, warning=True)]


def rest_section(
    result: Result, spans: tuple[RestSpan, ...], rest: Statics | None = None, then: str = COMPUTE
) -> Section:
    """Return spans, tensions and anchor forces of an equilibrium, and what `rest` says of its contacts."""
    rows = [
        (
            f"{span.rope}, nodes {span.first} to {span.last}",
            f"{span.distance:.5g} m",
            span.sag_words(4) or _tail_words(span),
            prefixed(span.horizontal, "N") if span.kind == "span" else "",
            span.pull_words(4),
        )
        for span in spans
    ]
    head = ("span", "ends apart", "sag", "horizontal force", "largest tension")
    items: list[Item] = [Table(head, rows)] if rows else []
    items += _anchor_table(result, result.reactions[0]) + _clamp_table(result)
    items += _utilisation(result, then)
    if note := result.table.get("about the largest tension"):
        items.append(Text(f"The largest tension at rest is that of a segment: {note}."))
    if note := result.table.get("about the least tension"):
        least = _value(float(np.nanmin(result.tension[0])), "N")
        items.append(Text(f"The least tension at rest is {least}, {note}.", warning=True))
    if rest is not None:
        items += _contacts(rest)
    if limited := _limited(result):
        items += limited
    elif result.scene.limiter is not None and not all(rope.rigid for rope in result.scene.ropes):
        items.append(Text("The limiter takes no part in rest."))
    air = result.scene.air
    wind, blows = 0.0 if air is None else math.hypot(*air.wind), ""
    if air is not None and wind > 0.0:
        if air.drags:
            blows = f"in the wind of {wind:.4g} m/s, "
        else:
            items.append(Text(f"Left out is {NO_DRAG.format(wind)}.", warning=True))
    about = f"This is rest {blows}with all anchors where they are at time zero."
    about += f" The forces balance to {result.residual:.1e} N on every node."
    return Section("At rest", (*items, Text(about)))


def _tail_words(span: RestSpan) -> str:
    """Return how what is held at one end is at rest."""
    if span.stands:
        return "stands or hangs"
    return "hangs free" if span.straight else "hangs or lies"


def _contacts(rest: Statics) -> list[Item]:
    """Say how ropes lie on obstacles and on each other, where what slides rests, and what turns pulleys."""
    lie = sorted({one.rope for one in rest.wraps} - {one.rope for one in rest.spans})
    names = ", ".join(map(repr, lie[:_NAMED])) + (" and others" if len(lie) > _NAMED else "")
    items: list[Item] = []
    if lie:
        on = "as it lies on an obstacle" if len(lie) == 1 else "as they lie on obstacles"
        items.append(
            Text(f"No spans are told of {names}, {on}: what is carried on both sides is said here.")
        )
    items += [Text(f"{_sentence(str(one))}.") for one in (*rest.wraps, *rest.touches)]
    items += [Text(f"{_sentence(str(one))}.", warning=one.uneven > 0.0) for one in rest.seats]
    items += [Text(f"{_sentence(str(one))}.", warning=not one.stands) for one in rest.pulleys]
    items += [Text(f"{_sentence(MANY)}.")] if rest.by_friction else []
    return items + [Text(f"{_sentence(one)}.", warning=True) for one in coarse_words(rest.wraps)]


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:]


def loose_pulleys(rest: Statics) -> tuple[Item, ...]:
    """Return what the summary says of pulleys that are held still at rest, and by nothing."""
    held = [one.obstacle for one in rest.pulleys if not one.stands]
    if not held:
        return ()
    names = ", ".join(map(repr, held))
    said = (
        f"At rest {names} {'is' if len(held) == 1 else 'are'} held still, which no bearing does: it is no "
        "rest, and once that turns, anchors may carry more."
    )
    return (Text(said, warning=True),)


def run_section(result: Result, then: str = COMPUTE) -> Section:
    """Return the extremes of every step of a run, those of what turns and slides, and of every anchor."""
    found = extremes(result)
    rows = []
    for name, (title, unit) in _TITLES.items():
        one = found[name]
        if not math.isnan(one.value):
            rows.append((title, _value(one.value, unit), place_of(result, name, one)))
    moving = moving_rows(result)
    landings = landings_of(result)
    pressed = pressed_rows(result, found["greatest tension"], landings)
    for title, value in (moving | pressed).items():
        bare, _, unit = title.removesuffix("]").partition(" [")
        if unit:
            rows.append((bare, _value(value, unit), (moving | pressed)[f"{bare} at"]))
    items: list[Item] = []
    if result.diagnosis:
        items.append(Text(f"THE RUN BROKE: {result.diagnosis}", warning=True))
    if result.partings:
        items.append(_parted(result))
    how = "of every step" if result.has_extremes else "of the recorded frames only"
    until = float(result.time[result.good_frames - 1])
    items.append(Text(f"Greatest and least values {how}, from 0 to {until:.6g} s."))
    items.append(Table(("", "value", "where and when"), rows, numbers=False))
    if "about the slides" in moving:
        items.append(Text(moving["about the slides"], warning=True))
    items += _about_peaks(result, found, landings)
    items += [
        Text(f"{title.removeprefix('about ').capitalize()}: {told}.", warning=True)
        for title, told in pressed.items()
        if title.startswith("about ")
    ]
    items += _anchor_peaks(result) + _utilisation(result, then)
    return Section("The run", tuple(items))


def _about_peaks(
    result: Result, found: dict[str, Extreme], landings: Sequence[Landing]
) -> list[Item]:
    """Return what is to be said of the largest forces, and of how near to breaking they come, of a run."""
    notes = notes_of_extremes(result, found, landings)
    if HARD in notes:
        return [Text(f"Hard stops: {notes[HARD][1]}.", warning=True)]
    return [
        Text(f"The largest {what}: {notes[name][1]}.", warning=True)
        for name, what in _PEAKS.items()
        if name in notes
    ]


def _parted(result: Result) -> Text:
    """Say which ropes parted, where, when and at what."""
    told, more = result.partings[:_NAMED], len(result.partings) - _NAMED
    which = "; ".join(str(one) for one in told) + (f"; and {more} more" if more > 0 else "")
    then = "Forces from then on are those of what is left, not of a rope that holds."
    return Text(f"A ROPE PARTED: {which}. {then}", warning=True)


def _value(value: float, unit: str) -> str:
    if unit in ("N", "N m"):
        return prefixed(value, unit, 5)
    return f"{value:.5g} {unit}".rstrip()


def _anchor_table(result: Result, reactions: Floats) -> list[Item]:
    """Return the forces on the anchors at rest; `reactions` (a, 3) are those on the ropes [N]."""
    rows = [
        (name, *_components(-force, result))
        for name, force in zip(result.layout.anchor_names, reactions, strict=True)
    ]
    head = ("anchor", "x", "y", "z", "size", "direction")
    return [Table(head, rows, note=_SIGN)] if rows else []


def _clamp_table(result: Result) -> list[Item]:
    """Return the moments on the clamps at rest, and what is to be said of the largest."""
    rows = [
        (anchor.name, prefixed(float(np.linalg.norm(moment)), "N m"))
        for anchor, moment in zip(result.scene.anchors, result.moments[0], strict=True)
        if anchor.clamp is not None
    ]
    if not rows:
        return []
    note = moment_note(result, extremes(result)["greatest clamp moment"])
    said = [Text(f"The largest moment on a clamp: {note}.", warning=True)] if note else []
    return [Table(("clamp", "moment"), rows), *said]


def _anchor_peaks(result: Result) -> list[Item]:
    """Return the greatest force on every anchor, and its components where it was recorded greatest."""
    names = result.layout.anchor_names
    if not names:
        return []
    good = result.good_frames
    reactions = result.read("reactions", 0, good)
    sizes = np.linalg.norm(reactions, axis=2)
    peaks = result.read("greatest_reactions", 0, good) if result.has_extremes else sizes
    rows = []
    for k, name in enumerate(names):
        if not np.isfinite(peaks[:, k]).any():
            continue
        frame = int(np.nanargmax(sizes[:, k]))
        greatest = float(np.nanmax(peaks[:, k]))
        when = f"{result.time[frame]:.5g} s"
        rows.append(
            (name, prefixed(greatest, "N", 5), *_components(-reactions[frame, k], result), when)
        )
    head = ("anchor", "greatest", "x", "y", "z", "size", "direction", "at")
    note = (
        f"{_SIGN} Greatest: of every step; the rest is of the recorded frame in which it was largest."
        if result.has_extremes
        else _SIGN
    )
    return [Table(head, rows, note=note)]


def _components(force: Floats, result: Result) -> tuple[str, ...]:
    """Return x, y, z, size and direction of a force [N] as text."""
    size = float(np.linalg.norm(force))
    parts = (float(c) if abs(c) > _ROUNDING * size else 0.0 for c in force)
    return (*(prefixed(c, "N") for c in parts), prefixed(size, "N"), _way(force, result))


def _way(force: Floats, result: Result) -> str:
    """Return how steeply a force points up or down; nothing where there is no weight, or no force."""
    size = float(np.linalg.norm(force))
    if size == 0.0 or not any(result.scene.gravity):
        return ""
    angle = math.degrees(math.asin(np.clip(force @ np.asarray(result.scene.up) / size, -1.0, 1.0)))
    return f"{abs(angle):.1f}° {'up' if angle >= 0.0 else 'down'}"


def _margin_cells(result: Result, near: Margin | None) -> tuple[str, str]:
    """Return utilisation and safety factor as text; of several ropes with whose it is."""
    if near is None:
        return "not known", ""
    whose = f", rope {near.name!r}" if len(result.scene.ropes) > 1 else ""
    used, factor = margin_bounds(near.utilisation, least=near.least)
    return f"{used}{whose}", factor


def _utilisation(result: Result, then: str) -> list[Item]:
    found = extremes(result)
    near = margin(result, found)
    if near is None and (others := margin_of_others(result, found)):
        return [Text(f"How near to breaking is {others}.", warning=True)]
    if near is None:
        return [Text("No breaking load is given: how near to breaking is not known.", warning=True)]
    place = place_of(result, UTILISATION, found[UTILISATION])
    if result.status == "at rest":
        place = place.partition(",")[0]
    used, factor = margin_bounds(near.utilisation, least=near.least)
    factor = f"safety factor {factor}" if factor else "unloaded"
    text = f"Largest utilisation of the breaking load: {used} ({factor}), {place}."
    doubt = doubt_words(result.scene, near, then)
    text += f" {doubt[0].upper()}{doubt[1:]}." if doubt else ""
    if near.utilisation <= 1.0:
        return [Text(text, warning=bool(doubt))]
    named = any(f"rope {p.rope!r}" in place for p in result.partings)
    return [Text(f"{text} {'IT PARTED' if named else 'IT WOULD HAVE PARTED'}.", warning=True)]
