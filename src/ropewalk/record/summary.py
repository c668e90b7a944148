"""A result in a dozen numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.record.energy_note import energy_note
from ropewalk.record.facts import AT_REST
from ropewalk.record.ledger import turned_over
from ropewalk.record.margins import breaking_loads, margin_rows, utilisations
from ropewalk.record.quantities import has_rope, rest_length_at_start

if TYPE_CHECKING:
    from ropewalk.record.result import Result

SEEN = "of the recorded frames"  # between two of them there may be more
ZERO = "gravity's is 0 in the scene's own shape"
_VALUES = 2_000_000  # numbers of one quantity looked at together


def summary(result: Result) -> dict[str, Any]:
    """Return the numbers that people want first, by name with unit.

    Segments and nodes are named as `rope:number`. Extremes are those of the recorded frames, and say so:
    what steps between two frames reach is not in them. Only frames before a break count. NaN stands for what
    there is none of: a stretch where nothing has a rest length, an energy error without a ledger. Reads the
    run in pieces, so that memory does not grow with its length.
    """
    found = _extremes(result)
    if result.status == AT_REST:
        return _at_rest(result, found)
    layout, time, good = result.layout, result.time, result.good_frames
    energy = {name: part[:good] for name, part in result.energy.items()}
    error = result.energy_error[:good]
    tension, frame, segment = found["tension"]
    stretch, stretch_frame, stretch_segment = found["stretch"]
    speed, speed_frame, speed_node = found["speed"]
    lowest, low_frame, low_node = found["lowest"]
    seconds = result.facts.seconds
    return {
        "status": result.status,
        "simulated time [s]": float(time[-1]),
        "frames": result.frames,
        **({"frames before the break": good} if good < result.frames else {}),
        **_steps(result),
        f"largest {result.tension_name} [N]": tension,
        f"largest {result.tension_name} at": _place(
            layout, segment, "segment", time[frame], tension
        ),
        **_margins(layout, found, time),
        "largest stretch [1]": stretch,
        "largest stretch at": _place(
            layout, stretch_segment, "segment", time[stretch_frame], stretch
        ),
        "largest speed [m/s]": speed,
        "largest speed at": _place(layout, speed_node, "node", time[speed_frame], speed),
        "lowest point [m]": -lowest,
        "lowest point at": _place(layout, low_node, "node", time[low_frame], lowest),
        "largest energy error [J]": _largest(error),
        "largest energy error, share of the energy turned over [%]": _share(energy, error),
        **({"about the energy": note} if (note := energy_note(result, error)) else {}),
        "final energy error [J]": float(error[-1]),
        "largest balance residual [J]": _largest(result.balance_residual[:good]),
        "final kinetic energy [J]": float(energy["kinetic"][-1]),
        "final total energy [J]": float(energy["total"][-1]),
        "final total energy at": ZERO if any(result.scene.gravity) else "",
        "wall time [s]": seconds,
        "simulated time over wall time [1]": float(time[-1]) / seconds if seconds > 0 else math.nan,
    }


def _margins(
    layout: Any, found: dict[str, tuple[float, int, int]], time: Floats | None
) -> dict[str, Any]:
    """Return how near to breaking it comes; nothing where no breaking load is known."""
    if "utilisation" not in found:
        return {}
    value, frame, segment = found["utilisation"]
    if time is not None:
        return margin_rows(value, _place(layout, segment, "segment", time[frame], value))
    rope, number = layout.rope_of(segment)
    return margin_rows(value, f"segment {number} of rope {rope!r}")


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


def _at_rest(result: Result, found: dict[str, tuple[float, int, int]]) -> dict[str, Any]:
    """Return the numbers of an equilibrium, without those of a motion."""
    layout = result.layout
    about = result.facts.provenance["statics"]
    table: dict[str, Any] = {"status": result.status}
    for name, title, noun, sign in (
        ("tension", f"largest {result.tension_name} [N]", "segment", 1.0),
        ("stretch", "largest stretch [1]", "segment", 1.0),
        ("lowest", "lowest point [m]", "node", -1.0),
    ):
        value, _, index = found[name]
        rope, number = layout.rope_of(index)
        table[title] = sign * value
        place = f"{noun} {number} of rope {rope!r}" if math.isfinite(value) else ""
        table[f"{title.partition(' [')[0]} at"] = place
    return (
        table
        | _margins(layout, found, None)
        | {
            "potential energy [J]": float(result.energy["total"][0]),
            "potential energy at": ZERO if any(result.scene.gravity) else "",
            "largest force left [N]": result.residual,
            "largest gap left [m]": float(about["gap"]),
            "Newton steps": int(about["steps"]),
            "wall time [s]": result.facts.seconds,
        }
    )


def _extremes(result: Result) -> dict[str, tuple[float, int, int]]:
    """Return the largest value, its frame and its column, of tension, stretch, speed and depth."""
    loads = breaking_loads(result.scene, result.layout)
    names = [
        "tension",
        "stretch",
        "speed",
        "lowest",
        *(["utilisation"] if loads is not None else []),
    ]
    best = dict.fromkeys(names, (-math.inf, 0, 0))
    step = max(1, _VALUES // (3 * result.nodes))
    if result.source.chunk < result.frames:
        step = max(1, step // result.source.chunk) * result.source.chunk
    for start in range(0, result.good_frames, step):
        stop = min(start + step, result.good_frames)
        measures = _measures(result, start, stop)
        if loads is not None:
            measures["utilisation"] = utilisations(measures["tension"], loads)
        for name, values in measures.items():
            values = np.where(np.isfinite(values), values, -np.inf)
            at = int(np.argmax(values))
            frame, column = divmod(at, values.shape[1])
            if values[frame, column] > best[name][0]:
                best[name] = (float(values[frame, column]), start + frame, column)
    none = [name for name, (value, _, _) in best.items() if value == -math.inf]
    return best | dict.fromkeys(none, (math.nan, 0, 0))


def _measures(result: Result, start: int, stop: int) -> dict[str, Floats]:
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
            length, rest, out=np.full(length.shape, -np.inf), where=live & (rest > 0.0)
        )
        speed = np.linalg.norm(result.read("velocities", start, stop), axis=2)
        lowest = -(positions @ np.asarray(result.scene.up))
    tension = np.where(live, result.read("tension", start, stop), -np.inf)
    return {"tension": tension, "stretch": stretch, "speed": speed, "lowest": lowest}


def _share(energy: Mapping[str, Floats], error: Floats) -> float:
    """Return the largest energy error over the largest change of one form of energy [%]."""
    turned = turned_over(energy)
    return 100.0 * _largest(error) / turned if turned > 0.0 else math.nan


def _largest(values: Floats) -> float:
    sound = np.abs(values[np.isfinite(values)])
    return float(sound.max()) if sound.size else math.nan


def _place(layout: Any, index: int, noun: str, time: float, value: float) -> str:
    if math.isnan(value):
        return ""
    rope, number = layout.rope_of(index)
    return f"{noun} {number} of rope {rope!r}, t = {time:.6g} s, {SEEN}"
