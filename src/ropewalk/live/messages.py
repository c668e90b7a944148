"""Messages about faults, the same for every kind of stage."""

from __future__ import annotations

from typing import Any

from ropewalk.analysis.json_values import plain
from ropewalk.live.parameters import PARAMETERS
from ropewalk.record.errors import RunError
from ropewalk.scene import SceneError


def error_message(
    command: str | None, number: int | None, error: SceneError | RunError
) -> dict[str, Any]:
    """Return the `error` message for what was refused, with what is allowed."""
    faults = []
    for fault in error.faults[:20] if isinstance(error, SceneError) else ():
        known = PARAMETERS.get(fault.path)
        value = fault.value if fault.value.__class__ in (int, float, str, bool) else None
        faults.append(
            {
                "path": fault.path,
                "value": plain(value) if not isinstance(value, str) else value[:200],
                "rule": fault.rule,
                "low": known.minimum if known else None,
                "high": known.maximum if known else None,
            }
        )
    text = str(error)[:2000]
    return {"type": "error", "id": number, "command": command, "text": text, "faults": faults}
