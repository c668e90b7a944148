"""Reading a scene that a page sends, in a process of its own: at most so long, in so much memory.

A few kilobytes of TOML can take minutes and gigabytes to read (a key of 12 000 parts, 40 000 misspelt
ones). The process is ended then, and nothing else waits for it or pays for it.
`python -m ropewalk.live.reading` is that process: TOML comes in, a pickled scene or SceneError goes out.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

from ropewalk.live.commands import LONGEST_TEXT
from ropewalk.live.parameters import refusal
from ropewalk.live.sources import from_toml
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE

SECONDS = 5  # of computing
PATIENCE = 20.0  # [s] on the clock, where the computer is busy or knows no limits
BYTES = 1_000_000_000
MOST_FAULTS = 20  # that a page is told of
_ROOT = Path(__file__).parents[2]


def read_apart(text: str) -> Scene:
    """Return the scene of a TOML text that names no files. Raises SceneError, also where it is too much."""
    if len(text) > LONGEST_TEXT:
        raise refusal("toml", f"{len(text)} characters", f"must be at most {LONGEST_TEXT}")
    paths = (str(_ROOT), os.environ.get("PYTHONPATH", ""))
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    command = [sys.executable, "-m", __name__]
    try:
        done = subprocess.run(
            command, input=text.encode(), capture_output=True, env=environment, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        raise _too_much() from None
    except OSError as error:
        raise refusal("toml", NO_VALUE, f"cannot be read here: {error}") from None
    if done.returncode != 0 or not done.stdout:
        raise _too_much()
    found = pickle.loads(done.stdout)
    if isinstance(found, SceneError):
        raise found
    scene: Scene = found
    return scene


def _too_much() -> SceneError:
    rule = (
        f"takes more than {SECONDS} s or {BYTES / 1e9:g} GB to read; "
        "save it as a file and give that to ropewalk view"
    )
    return refusal("toml", NO_VALUE, rule)


def _read(text: str) -> Scene | SceneError:
    try:
        return from_toml(text)
    except SceneError as error:
        return SceneError(error.faults[:MOST_FAULTS], error.source)
    except (ValueError, ArithmeticError, RecursionError) as error:
        return refusal("toml", NO_VALUE, f"cannot be read: {error}")


def _main() -> None:
    with suppress(ImportError, ValueError, OSError):  # not on every system
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
    found = _read(sys.stdin.buffer.read().decode())
    sys.stdout.buffer.write(pickle.dumps(found))


if __name__ == "__main__":
    _main()
