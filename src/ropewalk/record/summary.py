"""A result in a dozen numbers, and in a sentence."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.balances import energy_note, lost_note
from ropewalk.record.coarse_note import coarse_note
from ropewalk.record.deep_note import deep_note
from ropewalk.record.ends import shortly
from ropewalk.record.extremes import (
    SEEN,
    UTILISATION,
    Extreme,
    extremes,
    margin,
    margin_of_others,
    place_of,
)
from ropewalk.record.facts import AT_REST, BROKE
from ropewalk.record.landings import landings_of
from ropewalk.record.limiter_at_rest import rest_limiter_note
from ropewalk.record.limiter_note import limiter_note
from ropewalk.record.margins import margin_rows
from ropewalk.record.moving_rows import APART, moving_rows
from ropewalk.record.note_kinds import (
    HARD,
    Note,
    less_rounding,
    notes_at_rest,
    notes_of_extremes,
)
from ropewalk.record.parted import parting_rows
from ropewalk.record.pressed_rows import pressed_rows, pressed_rows_at_rest
from ropewalk.record.reach_note import reach_note
from ropewalk.record.seen_along import along_note
from ropewalk.record.stood import stood_note
from ropewalk.record.turnover import own_errors, share_turned, steady_note, sudden_note
from ropewalk.words.counts import counted
from ropewalk.words.prefixes import prefixed

if TYPE_CHECKING:
    from ropewalk.record.result import Result

ZERO = "gravity's is 0 in the scene's own shape"
BURST = "a run that broke: up to its last good frame the burst grows, and is in the extremes and errors here"
AS_THEY_WERE = "broken ropes count as they broke"


def summary(result: Result) -> dict[str, Any]:
    """Return the numbers that people want first, by name with unit.

    Extremes are those of every step, with place and time; of a run that kept only those of its frames, they
    say so. Only what came before a break counts. NaN stands for what there is none of: a stretch where
    nothing has a rest length, an energy error without a ledger. Reads the run in pieces, so that memory does
    not grow with its length.
    """
    found = extremes(result)
    if result.status == AT_REST:
        return _at_rest(result, found)
    time, good = result.time, result.good_frames
    energy = {name: part[:good] for name, part in result.energy.items()}
    error, errors = result.energy_error[:good], result.energy_errors[:good]
    share, own = share_turned(result), own_errors(result)
    seconds, broken, landings = result.facts.seconds, _broken(result), landings_of(result)
    notes = notes_of_extremes(result, found, landings)
    whose = [APART] * bool(result.layout.pulleys) + [AS_THEY_WERE] * bool(broken)
    return {
        "status": result.status,
        "simulated time [s]": float(time[-1]),
        "frames": result.frames,
        **({"frames before the break": good} if good < result.frames else {}),
        **broken,
        **({"about these numbers": BURST} if result.status == BROKE else {}),
        **_steps(result),
        **_told(result, found, notes),
        **_margins(result, found, notes),
        **moving_rows(result),
        **pressed_rows(result, found["greatest tension"], landings),
        **(parting_rows(result.partings) if result.scene.parts else {}),
        "largest energy error [J]": _largest(errors),
        **({"largest energy error at": at} if (at := _error_at(result, errors)) else {}),
        "largest energy error, share of the energy turned over [%]": share,
        **(
            {"about the energy": note}
            if (
                note := lost_note(result)
                or steady_note(result, _largest(own), share)
                or energy_note(result, own.ravel(), share)
                or sudden_note(result, share)
                or along_note(result, _largest(errors))
            )
            else {}
        ),
        **({"about the stretch limiter": note} if (note := limiter_note(result)) else {}),
        **({"about the obstacles": note} if (note := deep_note(result)) else {}),
        **({"about the contacts": note} if (note := reach_note(result)) else {}),
        **({"about the wraps": note} if (note := coarse_note(result)) else {}),
        "final energy error [J]": float(error[-1]),
        "largest balance residual [J]": _largest(result.balance_residual[:good]),
        "final kinetic energy [J]": float(energy["kinetic"][-1]),
        "final kinetic energy at": "; ".join(whose),
        "final total energy [J]": float(energy["total"][-1]),
        "final total energy at": "; ".join([ZERO] * any(result.scene.gravity) + whose),
        "wall time [s]": seconds,
        "simulated time over wall time [1]": float(time[-1]) / seconds if seconds > 0 else math.nan,
    }


def in_words(result: Result) -> str:
    """Return what a result is, in a sentence."""
    names = ", ".join(repr(span.name) for span in result.layout.ropes[:3])
    more = len(result.layout.ropes) - 3
    ropes = ("rope " if len(result.layout.ropes) == 1 else "ropes ") + names
    ropes += f" and {more} more" if more > 0 else ""
    segments = sum(rope.segments for rope in result.scene.ropes)
    where = f" in {result.folder}" if result.folder else ""
    if result.status == AT_REST:
        return (
            f"Equilibrium of {result.scene.name!r}{where}: {ropes} with {counted(segments, 'segment')}, "
            f"largest tension {prefixed(result.table[f'largest {result.tension_name} [N]'], 'N', 6)}, "
            f"at most {result.residual:.2g} N left on a node."
        )
    said = (
        f"Result of {result.scene.name!r}{where}: {ropes} with {counted(segments, 'segment')}, "
        f"{result.time[-1]:.6g} s in {counted(result.frames, 'frame')} by {result.plan.method} "
        f"in {_pace(result)}, {_drift(result)}; {result.status}."
    )
    return f"{said} {result.diagnosis}".rstrip()


def _pace(result: Result) -> str:
    counts = result.facts.step_counts
    if not counts:
        return f"steps of {result.plan.dt:.4g} s"
    return f"{counts['accepted']} {result.plan.pace} and {counts['rejected']} rejected"


def _drift(result: Result) -> str:
    errors = np.abs(result.energy_errors[: result.good_frames])
    if not result.facts.ledger or not np.isfinite(errors).any():
        return "no energy ledger"
    return f"energy error at most {np.max(errors, where=np.isfinite(errors), initial=0.0):.3g} J"


def _broken(result: Result) -> dict[str, Any]:
    """Return which ropes broke and when, where others went on."""
    went_on = len(result.scene.ropes) - sum(len(end.ropes) for end in result.ends)
    last = max((end.frames for end in result.ends), default=result.frames)
    if went_on == 0 and last == result.ends[0].frames:
        return {}
    return {"broken ropes": shortly(result.ends)} if result.ends else {}


def _margins(result: Result, found: dict[str, Extreme], notes: dict[str, Note]) -> dict[str, Any]:
    """Return how near to breaking it comes; nothing where no breaking load is known."""
    extreme = found.get(UTILISATION)
    if extreme is None:
        return {}
    place = place_of(result, UTILISATION, extreme)
    place = place.partition(",")[0] if result.status == AT_REST else place
    near = margin(result, found)
    note = notes.get(UTILISATION, ("", ""))[1]
    if near is not None:
        return margin_rows(near, place, result.scene, note)
    others = margin_of_others(result, found)
    return {"about the largest utilisation of the breaking load": others} if others else {}


def _steps(result: Result) -> dict[str, Any]:
    """Return number and length of the steps."""
    plan, counts = result.plan, result.facts.step_counts
    if plan.tolerance is None:
        count = (result.frames - 1) * plan.steps_per_frame
        return {"steps": count, "time step [s]": plan.dt}
    return {
        "steps": counts.get("accepted", 0),
        "rejected steps": counts.get("rejected", 0),
        "shortest step [s]": counts.get("shortest", math.nan),
        "longest step [s]": counts.get("longest", math.nan),
        "tolerance [m]": plan.tolerance,
    }


def _told(result: Result, found: dict[str, Extreme], notes: dict[str, Note]) -> dict[str, Any]:
    """Return the extremes with their places and times, those of anchors and clamps where there are any."""
    told: dict[str, Any] = {}
    for name, title in _titles(result).items():
        anchors = name in ("greatest anchor force", "greatest clamp moment")
        if not (anchors and math.isnan(found[name].value)):
            told[title] = found[name].value
            told[f"{title.partition(' [')[0]} at"] = place_of(result, name, found[name])
        if name in notes:
            told[f"about the {title.partition(' [')[0]}"] = notes[name][1]
    return told | ({"about hard stops": notes[HARD][1]} if HARD in notes else {})


def _titles(result: Result) -> dict[str, str]:
    """Return what a table calls the extremes, by their names."""
    return {
        "greatest tension": f"largest {result.tension_name} [N]",
        "least tension": f"least {result.tension_name} [N]",
        "greatest stretch": "largest stretch [1]",
        "greatest speed": "largest speed [m/s]",
        "highest point": "highest point [m]",
        "lowest point": "lowest point [m]",
        "greatest anchor force": "largest anchor force [N]",
        "greatest clamp moment": "largest clamp moment [N m]",
    }


def _moment_at_rest(
    result: Result, found: dict[str, Extreme], notes: dict[str, Note]
) -> dict[str, Any]:
    """Return the largest moment on a clamp, and what is to be said of it, where there is one."""
    moment = found["greatest clamp moment"]
    if math.isnan(moment.value):
        return {}
    place = place_of(result, "greatest clamp moment", moment).partition(",")[0]
    told = {"largest clamp moment [N m]": moment.value, "largest clamp moment at": place}
    if "greatest clamp moment" in notes:
        told["about the largest clamp moment"] = notes["greatest clamp moment"][1]
    return told


def _at_rest(result: Result, found: dict[str, Extreme]) -> dict[str, Any]:
    """Return the numbers of an equilibrium, without those of a motion."""
    about = result.facts.provenance["statics"]
    found = less_rounding(result, found)
    table: dict[str, Any] = {"status": result.status}
    notes = notes_at_rest(result, found)
    for name in ("greatest tension", "least tension", "greatest stretch", "lowest point"):
        if name == "least tension" and name not in notes:
            continue  # nothing pushes
        title, extreme = _titles(result)[name], found[name]
        table[title] = extreme.value
        place = place_of(result, name, extreme).partition(",")[0]
        table[f"{title.partition(' [')[0]} at"] = place
        if name in notes:
            table[f"about the {title.partition(' [')[0]}"] = notes[name][1]
    table |= _moment_at_rest(result, found, notes)
    table |= pressed_rows_at_rest(result)
    if note := stood_note(result):
        table["about the obstacles"] = note
    if note := rest_limiter_note(result, found):
        table["about the stretch limiter"] = note
    return (
        table
        | _margins(result, found, notes)
        | {
            "potential energy [J]": float(result.energy["total"][0]),
            "potential energy at": ZERO if any(result.scene.gravity) else "",
            "largest force left [N]": result.residual,
            "largest gap left [m]": float(about["gap"]),
            "Newton steps": int(about["steps"]),
            "wall time [s]": result.facts.seconds,
        }
    )


def _error_at(result: Result, errors: Floats) -> str:
    """Return when the energy error of every step, (frames, 2) [J], was largest, in words; "" without any."""
    sizes = np.where(np.isfinite(errors), np.abs(errors), -1.0)
    frame, bound = divmod(int(np.argmax(sizes)), 2)
    if sizes[frame, bound] <= 0.0:
        return ""
    if "energy_error_times" not in result.source.names:
        return f"t = {result.time[frame]:.6g} s, {SEEN}"
    when = float(result.read("energy_error_times", frame, frame + 1)[0, bound])
    if math.isnan(when):  # sums of what ropes err that move by themselves
        first = float(result.time[max(frame - 1, 0)])
        return f"t from {first:.6g} to {result.time[frame]:.6g} s, the errors of all ropes added up"
    return f"t = {when:.6g} s"


def _largest(values: Floats) -> float:
    sound = np.abs(values[np.isfinite(values)])
    return float(sound.max()) if sound.size else math.nan
