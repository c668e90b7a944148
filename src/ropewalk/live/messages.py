"""Messages about faults, the same for every kind of broadcast."""

from __future__ import annotations

from typing import Any

from ropewalk.analysis.json_values import plain
from ropewalk.live.parameters import PARAMETERS
from ropewalk.record.errors import RunError
from ropewalk.scene import Fault, SceneError
from ropewalk.scene.faults import NO_VALUE, show

_VERBS = {
    "are",
    "can",
    "cannot",
    "has",
    "have",
    "holds",
    "is",
    "lies",
    "may",
    "must",
    "names",
    "needs",
}
_VERBS |= {"takes", "would"}
_OF_PARAMETERS = {"set", "compare", "scene"}  # commands whose faults may be about parameters
_SUBJECTS = {"node": "This point", "nodes": "The two points", "type": "This command"}


def sentence(fault: Fault) -> str:
    """Return a fault as a sentence for the page; what it is about in the code follows in brackets."""
    rule = fault.rule.strip()
    words = rule.split(maxsplit=1)
    if words and words[0] in _VERBS:
        rule = f"{_subject(fault.path)} {rule}"
    rule = rule[:1].upper() + rule[1:]
    about = [fault.path] if fault.path else []
    if fault.value is not NO_VALUE and fault.value is not None:
        about.append(show(fault.value))
    return f"{rule} ({': '.join(about)})" if about else rule


def _subject(path: str) -> str:
    """Return what a fault is about, in words: the parameter's label, or the last key of the path."""
    if path in PARAMETERS:
        return PARAMETERS[path].label
    if path in _SUBJECTS:
        return _SUBJECTS[path]
    *above, key = (one.split("[", 1)[0] for one in path.split("."))
    if above and above[-1] != "rope":
        return f'The {above[-1]}\'s "{key}"'  # as it stands in the scene: "at", "brake_from"
    return f"The {key.replace('_', ' ')}" if key else "This"


def error_message(
    command: str | None, number: int | None, error: SceneError | RunError
) -> dict[str, Any]:
    """Return the `error` message for what was refused, with what is allowed."""
    faults = []
    for fault in error.faults[:20] if isinstance(error, SceneError) else ():
        known = PARAMETERS.get(fault.path) if command in _OF_PARAMETERS else None
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
    told = map(sentence, error.faults) if isinstance(error, SceneError) else [str(error)]
    text = "\n".join(told)[:2000]
    return {"type": "error", "id": number, "command": command, "text": text, "faults": faults}
