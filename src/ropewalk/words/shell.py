"""Paths as a command that people are told to type has them."""

from __future__ import annotations

import os
import shlex
from pathlib import Path


def typed(path: str | Path | None) -> str:
    """Return a path as it is typed in a shell: in quotes where it has spaces, or signs of the shell's own."""
    text = str(path or "")
    if os.name != "nt":
        return shlex.quote(text)
    return f'"{text}"' if set(text) & set(" &()^;,") else text
