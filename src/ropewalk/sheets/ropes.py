"""What a sheet says of the ropes themselves, and of what is taken for granted."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.library import names
from ropewalk.library import rope as library_rope
from ropewalk.library.catalogue import sources
from ropewalk.library.entry import UNITS
from ropewalk.record.margins import breaking_load
from ropewalk.scene import Material, Rope, Scene, Springs
from ropewalk.scene.curve_words import curve_words
from ropewalk.scene.from_library import origin, origin_words
from ropewalk.scene.guess import guesses_of
from ropewalk.scene.obstacles import Obstacle
from ropewalk.scene.slide import Slide
from ropewalk.scene.spin import Spin
from ropewalk.scene.winch import Winch
from ropewalk.sheets.content import Item, Section, Table, Text
from ropewalk.sheets.frictions import friction_between, friction_on
from ropewalk.words.counts import counted
from ropewalk.words.prefixes import prefixed

_MOST = 6  # kinds of ropes that have a table, and names of ropes alike
_NAMES = {
    "EA": "axial stiffness EA",
    "mass_per_length": "mass per length",
    "axial_damping": "axial damping",
    "relaxing_EA": "EA that relaxes",
    "relaxation_time": "relaxation time",
    "EI": "bending stiffness EI",
    "breaking_load": "breaking load",
    "diameter": "diameter",
}


NO_DRAG = "the wind of {:.4g} m/s: it blows on nothing without air.density or air.node_drag"
_MOST_NAMED = 8  # joints of which each has a sentence


def rope_section(scene: Scene) -> Section:
    """Return a table per rope, with the source of every number that is the library's; one of ropes alike."""
    kinds: list[tuple[list[tuple[str, str]], list[Item], list[str]]] = []
    more = 0
    for rope in scene.ropes:
        rows, about = _rope_rows(rope), _sources(rope)
        like = next((names for known, told, names in kinds if (known, told) == (rows, about)), None)
        if like is not None:
            like.append(rope.name)
        elif len(kinds) < _MOST:
            kinds.append((rows, about, [rope.name]))
        else:
            more += 1
    items: list[Item] = []
    for rows, about, names_of in kinds:
        items += [Table((_heading(names_of), ""), rows, numbers=False), *about]
    if more:
        are = f"{counted(more, 'more rope')} {'is' if more == 1 else 'are'}"
        items.append(Text(f"{are} in the scene at the end of this sheet."))
    return Section("Ropes", tuple(items))


def _heading(names_of: list[str]) -> str:
    """Return what a table of one rope, or of several alike, is headed by."""
    if len(names_of) == 1:
        return f"rope {names_of[0]!r}"
    more = len(names_of) - _MOST
    told = ", ".join(map(repr, names_of[:_MOST])) + (f" and {more} more" if more > 0 else "")
    return f"ropes {told}, each"


def _rope_rows(rope: Rope) -> list[tuple[str, str]]:
    made_of, load = rope.made_of, breaking_load(rope)
    rows = [
        ("what it is", origin_words(made_of) or _kind(rope)),
        ("unstretched length", f"{rope.length_unstretched:.6g} m"),
        ("computed as", f"{rope.segments} straight segments of {rope.segment_length:.4g} m"),
        ("mass, loads left out", f"{rope.own_mass:.5g} kg"),
    ]
    if isinstance(made_of, Springs):
        rows += [
            ("spring constant of a segment", f"{made_of.spring_constant:.5g} N/m"),
            ("friction of a segment", f"{made_of.spring_friction:.5g} N s/m ({made_of.friction})"),
        ]
    else:
        rows += [
            (
                _NAMES["EA"],
                "infinite: it does not stretch" if rope.rigid else prefixed(made_of.EA, "N", 5),
            ),
            *([("tension", curve_words(made_of.curve))] if made_of.curve is not None else []),
            (_NAMES["mass_per_length"], f"{made_of.mass_per_length:.5g} kg/m"),
            (_NAMES["axial_damping"], f"{made_of.axial_damping:.5g} N s"),
            *_relaxing(made_of),
            (
                _NAMES["EI"],
                f"{made_of.EI:.4g} N m²" if made_of.EI else "none: it bends freely",
            ),
            (_NAMES["diameter"], _thickness(rope)),
        ]
    known = _unknown_load(rope) if load is None else prefixed(load, "N", 5)
    rows.append((_NAMES["breaking_load"], known))
    guesses = {_NAMES[name]: mark.span for name, mark in guesses_of(made_of).items()}
    rows = [
        (name, f"{text}, a guess: {guesses[name]}" if name in guesses else text)
        for name, text in rows
    ]
    rows += [(f"load at {_at(rope, part.node)}", f"{part.mass:.5g} kg") for part in rope.loads]
    rows += [
        (f"force at {_at(rope, part.node)}", f"({', '.join(f'{c:.4g}' for c in part.force)}) N")
        for part in rope.forces
    ]
    if rope.submerged_weight is not None:
        rows.append(("weight in water", f"{rope.submerged_weight:.5g} N/m"))
    return rows


def _thickness(rope: Rope) -> str:
    """Say how thick a rope is; one whose diameter is not given is a line to what it touches."""
    thick = f"{1e3 * rope.diameter:.4g} mm"
    if "diameter" in rope.model_fields_set:
        return thick
    return f"not given: none to obstacles, {thick} to quadratic air drag"


def _relaxing(made_of: Material) -> list[tuple[str, str]]:
    if made_of.relaxing_EA is None or made_of.relaxation_time is None:
        return []
    return [
        (_NAMES["relaxing_EA"], prefixed(made_of.relaxing_EA, "N", 5)),
        (_NAMES["relaxation_time"], f"{made_of.relaxation_time:.4g} s"),
    ]


def _unknown_load(rope: Rope) -> str:
    """Say that no breaking load is given, and which one the library guesses."""
    known = "not given: no utilisation can be told"
    name = getattr(rope.made_of, "library", "").partition(":")[0]
    guess = library_rope(name).numbers.get("breaking_load") if name in names() else None
    if guess is None or guess.low is None or guess.high is None:
        return known
    return f"{known}; the library guesses {prefixed(guess.low, 'N')} to {prefixed(guess.high, 'N')}"


def _kind(rope: Rope) -> str:
    return (
        "given spring by spring"
        if isinstance(rope.made_of, Springs)
        else "given by its numbers, not from the library"
    )


def _at(rope: Rope, node: int) -> str:
    index = rope.node_index(node)
    return f"node {index}, {index * rope.segment_length:.5g} m of rope from its start"


def _sources(rope: Rope) -> list[Item]:
    """Return where the library has a rope's numbers from, and a warning of those that are guesses."""
    about = origin(rope.made_of) or {}
    rows = []
    for field, number in about.get("numbers", {}).items():
        span = ""
        if "low" in number and "high" in number:
            low, high = (prefixed(number[end], str(UNITS[field])) for end in ("low", "high"))
            span = f"{low} to {high}"
        source = _told(str(number["source"]))
        rows.append((_NAMES.get(field, field), number["quality"], span, source))
    items: list[Item] = []
    if rows:
        head = ("number of the library", "quality", "range", "source")
        items.append(Table(head, rows, numbers=False))
    if guessed := [_NAMES[name] for name in guesses_of(rope.made_of)]:
        items.append(Text(f"Guessed, not measured: {', '.join(guessed)}.", warning=True))
    return items


def _told(source: str) -> str:
    """Return the sources of a number in words: "A1 A12" are two; what is no tag stays as it is."""
    known = sources()
    return " ".join(known.get(tag, tag) for tag in source.replace(",", " ").split())


def assumption_section(scene: Scene) -> Section:
    """Return what the computation takes for granted, and what it leaves out."""
    size = float(np.linalg.norm(scene.gravity))
    weight = (
        f"Weight acts with {size:.6g} m/s² against ({', '.join(f'{c:.3g}' for c in scene.up)})."
        if size
        else "There is no weight."
    )
    texts = [
        "Every rope is a chain of straight segments with its mass in the nodes between them.",
        _tension(scene),
        weight,
        _push(scene),
        _bends(scene),
        _air(scene),
        _ground(scene),
        _anchors(scene),
        _joints(scene),
        *map(_winch, scene.winches),
        *map(_slide, scene.slides),
        *(_obstacle(scene, body) for body in scene.obstacles),
        _touching(scene),
        _parting(scene),
    ]
    if scene.limiter is not None:
        low, high = scene.limiter.min_stretch, scene.limiter.max_stretch
        texts.append(f"A limiter keeps every segment between {low:g} and {high:g} of its length.")
    others = "" if scene.contact else ", other ropes and itself"
    left_out = (
        f"Left out: contact with {'anything else' if scene.obstacles else 'edges, pulleys'}{others}; "
        "twist; creep, temperature, moisture, wear and age; the strength of knots, splices and "
        "terminations; the give of anchors and structures; any load that is not in the scene."
    )
    claim = (
        "This is a computation of one load case. It claims conformity with no standard. Who signs for the "
        "job must check that loads, rope, anchors and safety factors are those of the job."
    )
    items = (Text(" ".join(text for text in texts if text)), Text(left_out), Text(claim))
    return Section("Assumptions", items)


def _tension(scene: Scene) -> str:
    """Say how tension goes with strain, of every kind of rope that the scene has."""
    materials = [rope.made_of for rope in scene.ropes if isinstance(rope.made_of, Material)]
    texts = []
    if any(not rope.rigid and getattr(rope.made_of, "curve", None) is None for rope in scene.ropes):
        texts.append("Tension is proportional to strain")
    if any(made_of.curve is not None for made_of in materials):
        texts.append("where a rope has a curve, tension follows it, up and down alike")
    if any(made_of.relaxing_EA is not None for made_of in materials):
        texts.append("a part of the stiffness relaxes, with one relaxation time")
    if any(rope.rigid for rope in scene.ropes):
        texts.append("a rope of infinite EA does not stretch")
    if any(rope.segment_friction > 0.0 for rope in scene.ropes):
        texts.append("friction along a segment is proportional to the rate of strain")
    words = "; ".join(texts)
    return f"{words[:1].upper()}{words[1:]}."


def _push(scene: Scene) -> str:
    pushing = [rope.name for rope in scene.ropes if not rope.made_of.tension_only]
    if not pushing:
        damped = any(rope.segment_friction > 0.0 for rope in scene.ropes)
        brake = (
            " A stretched one that shortens fast is held back by its friction, below zero tension."
        )
        return "Slack segments carry nothing." + (brake if damped else "")
    more = f" and {len(pushing) - 4} more" if len(pushing) > 4 else ""
    named = f"Segments of {', '.join(pushing[:4])}{more}"
    which = "Segments" if len(pushing) == len(scene.ropes) else named
    return f"{which} that are shorter than unstretched push back, as springs do."


def _bends(scene: Scene) -> str:
    if any(rope.bending_stiffness for rope in scene.ropes):
        return "Bending stiffness counts where a rope's table has one."
    return "Bending stiffness is left out."


def _air(scene: Scene) -> str:
    if scene.air is None:
        return "Air is left out."
    wind = math.hypot(*scene.air.wind)
    if not scene.air.drags:
        return f"Air is left out{', and so is ' + NO_DRAG.format(wind) if wind else ''}."
    air = f"Air of {scene.air.density:.4g} kg/m³" if scene.air.density else "Air"
    return f"{air} drags" + (f", with a wind of {wind:.4g} m/s." if wind else ", without wind.")


def _ground(scene: Scene) -> str:
    if scene.ground is None:
        return "There is no ground."
    return f"The ground is at a height of {scene.ground.height:.4g} m and yields as a spring."


def _joints(scene: Scene) -> str:
    if not scene.joints:
        return ""
    many = f"{len(scene.joints)} joints tie nodes of ropes, by their names in the scene below."
    named = " ".join(map(str, scene.joints)) if len(scene.joints) <= _MOST_NAMED else many
    return f"{named} Joints weigh nothing, hold no direction and do not give."


def _slide(slide: Slide) -> str:
    brake = f", and a brake of {slide.brake:g} N" if slide.brake else ""
    place = f" from {slide.brake_from:g} m on" if slide.brake_from else ""
    return f"{slide} Its coefficient of friction is {slide.friction:g}{brake}{place}."


def _winch(winch: Winch) -> str:
    low, high = winch.min_length, winch.max_length
    least = f", to {low:g} m of rope at least" if low is not None else ""
    most = f", to {high:g} m of rope at most" if high is not None else ""
    return f"{str(winch).removesuffix('.')}{_times(winch)}{least}{most}."


def _times(one: Winch | Spin) -> str:
    until = f" until {one.stop:g} s" if math.isfinite(one.stop) else ""
    return (f" from {one.start:g} s" if one.start else "") + until


def _obstacle(scene: Scene, body: Obstacle) -> str:
    touched = (
        f"Nodes of ropes touch the {body.kind} {body.name!r} with {friction_on(body, scene.ropes)}"
    )
    moves = [] if body.motion.kind == "fixed" else [f"moves ({body.motion.kind})"]
    return f"{touched}{'; it ' if (moves := moves + _turns(body)) else ''}{' and '.join(moves)}."


def _turns(body: Obstacle) -> list[str]:
    """Say how an obstacle turns, or nothing of one that does not."""
    spin = body.spin
    if spin is None:
        return []
    if not spin.free:
        by_table = spin.rate is None
        return ["turns by a table" if by_table else f"turns at {spin.rate:g} rad/s{_times(spin)}"]
    bearing = (
        f", a bearing of {spin.bearing:g} N m" if spin.bearing else ", a bearing without friction"
    )
    viscous = f" and {spin.viscous:g} N m s" if spin.viscous else ""
    return [f"turns freely, with a moment of inertia of {spin.inertia:g} kg m²{bearing}{viscous}"]


def _touching(scene: Scene) -> str:
    if scene.contact is None:
        return ""
    return f"Ropes touch each other and themselves with {friction_between(scene.contact, scene.ropes)}."


def _parting(scene: Scene) -> str:
    names = [rope.name for rope in scene.ropes if rope.made_of.parts]
    if not names:
        return ""
    return f"{_do(names, 'parts', 'part')} where a segment carries more than the breaking load."


def _anchors(scene: Scene) -> str:
    if not scene.anchors:
        return "Nothing is anchored."
    moving = [one.name for one in scene.anchors if one.motion.kind != "fixed"]
    released = [one.name for one in scene.anchors if one.release_time is not None]
    text = (
        f"Anchors do not give; {_do(moving, 'moves', 'move')}."
        if moving
        else "Anchors do not give."
    )
    return text + (f" {_do(released, 'lets go', 'let go')}." if released else "")


def _do(names: list[str], one: str, many: str) -> str:
    more = f" and {len(names) - 6} more" if len(names) > 6 else ""
    return f"{', '.join(names[:6])}{more} {one if len(names) == 1 else many}"
