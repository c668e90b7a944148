"""What a run of a scene comes to in steps that resolve it: converged numbers, to hold others against."""

from __future__ import annotations

import math
from typing import Any

import ropewalk as rw
from ropewalk.record.tension_notes import wave_time
from verification.working_scenes import as_run

#: Rows of forces, which may not be too low without a note.
FORCES = (
    "largest tension [N]",
    "largest anchor force [N]",
    "largest utilisation of the breaking load [%]",
    "largest clamp moment [N m]",
    "largest force on an obstacle [N]",
    "largest load on the axle of a pulley [N]",
    "largest load of a slide on its rope [N]",
)
#: Rows that say of all forces that they are not to be trusted.
OF_ALL = ("about the energy", "about hard stops", "about the stretch limiter")
#: Words of notes that say that a number may be too low, or not right.
DOUBTS = ("too low", "wrong", "see the largest", "far more", "far too high")
_CONVERGED = 0.03  # [1] by which two fine runs may differ
_MOST = 60_000  # steps of the finer one: of more it is no test


def fine_step(scene: rw.Scene) -> float:
    """A step in which waves get through a segment in a half of it, and hits on obstacles are resolved [s]."""
    waves = [wave_time(rope) for rope in scene.ropes if not rope.rigid]
    hits = [5e-4] if scene.obstacles or scene.slides else []
    return min([*waves, *hits, 1e-3])


def too_long(scene: rw.Scene) -> bool:
    return 4.0 * scene.run.duration > _MOST * fine_step(scene)


def fine_numbers(scene: rw.Scene) -> dict[str, float] | None:
    """The rows that steps of esdirk3 and a fourth of them agree on; None where a run breaks."""
    tables = []
    for part in (1.0, 0.25):
        run = rw.simulate(as_run(scene, "esdirk3", part * fine_step(scene)), on_failure="return")
        if run.status != "finished":
            return None
        tables.append(run.table)
    coarse, fine = tables
    return {
        row: fine[row]
        for row in (*FORCES, "largest speed [m/s]")
        if row in fine and math.isclose(coarse[row], fine[row], rel_tol=_CONVERGED)
    }


def note_of(table: dict[str, Any], row: str) -> str:
    """What a table says of a row that a number of it may be too low; "" where it says nothing."""
    own = str(table.get(f"about the {row.partition(' [')[0]}", ""))
    texts = [own if any(word in own for word in DOUBTS) else ""]
    texts += [str(table[name]) for name in OF_ALL if name in table]
    return "; ".join(text for text in texts if text)
