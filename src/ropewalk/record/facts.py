"""What is known of a run besides its numbers: how it was run, how it ended, with what."""

from __future__ import annotations

import platform
import sys
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import cache
from typing import Any

from ropewalk.lowering import Plan
from ropewalk.record.ends import End
from ropewalk.record.identity import source_hash

FINISHED, BROKE, INTERRUPTED, RUNNING = "finished", "broke", "interrupted", "running"
ROPE_BROKE = "rope broke"  # an event: others went on
AT_REST = "at rest"  # no run: the one frame of an equilibrium


@dataclass(frozen=True)
class Facts:
    """How a run was made and how it ended."""

    plan: Plan
    ledger: bool = True
    keep_going: bool = False
    status: str = FINISHED
    diagnosis: str = ""
    seconds: float = 0.0  # wall time spent in the run [s], over all its parts
    provenance: dict[str, Any] = field(default_factory=dict)
    events: tuple[dict[str, Any], ...] = ()
    step_counts: dict[str, float] = field(
        default_factory=dict
    )  # of varying steps; see `Simulation`
    ends: tuple[End, ...] = ()  # what broke, in this order
    log_fault: str = ""  # what is wrong with the log that the events are from

    def but(self, **changes: Any) -> Facts:
        """Return a copy with some facts changed."""
        return replace(self, **changes)


def now() -> str:
    """Return the time as ISO 8601 text, in UTC."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def provenance(plan: Plan, ledger: bool, keep_going: bool) -> dict[str, Any]:
    """Return what made a run: versions, machine, method, steps, start time."""
    run = {"plan": dict(vars(plan)), "ledger": ledger, "keep_going": keep_going, "started": now()}
    return _made_with() | run


@cache
def _made_with() -> dict[str, Any]:
    """What all runs of a process are made with."""
    import numba
    import numpy as np

    from ropewalk import __version__

    return {
        "ropewalk": __version__,
        "source_hash": source_hash(),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "numba": numba.__version__,
        "platform": platform.platform(),
        "machine": platform.machine(),
        "byte_order": sys.byteorder,
    }
