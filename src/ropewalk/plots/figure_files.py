"""Figures as files: PNG, SVG, PDF, the same bytes for the same figure."""

from __future__ import annotations

import os
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure

FORMATS = ("png", "svg", "pdf")

# Dates and random identifiers are left out, so that equal figures make equal files.
_METADATA: dict[str, dict[str, str | None]] = {
    "png": {"Software": "ropewalk"},
    "svg": {"Date": None, "Creator": "ropewalk"},
    "pdf": {"CreationDate": None, "Creator": "ropewalk", "Producer": "ropewalk"},
}
_SETTINGS = {"svg.hashsalt": "ropewalk", "svg.fonttype": "path", "pdf.fonttype": 42}


def save(figure: Figure, path: str | Path, *, dpi: float = 160.0) -> Path:
    """Write a figure in the format of the path's ending and return the path.

    The file is written beside its place and then moved there, so nothing half written is left.

    Raises ValueError for another ending, OSError when it cannot be written.
    """
    path = Path(path)
    kind = path.suffix.lower().removeprefix(".")
    if kind not in FORMATS:
        raise ValueError(f"{path}: {path.suffix!r} - must end in .png, .svg or .pdf")
    part = path.with_name(f".{path.name}.part")
    try:
        with matplotlib.rc_context(_SETTINGS):  # type: ignore[arg-type]
            figure.savefig(part, format=kind, dpi=dpi, metadata=_METADATA[kind])
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)
    return path
