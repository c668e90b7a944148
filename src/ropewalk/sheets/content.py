"""What sheets are made of: sections of sentences, tables, figures and listings."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

_DPI = 170.0


@dataclass(frozen=True)
class Text:
    """A sentence or a few; a warning is set apart."""

    words: str
    warning: bool = False


@dataclass(frozen=True)
class Table:
    """Rows under a head; all but the first column are numbers where `numbers` says so."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: bool = True
    note: str = ""


@dataclass(frozen=True)
class Picture:
    """A figure as PNG, with its size and what it shows."""

    png: bytes
    width: float  # [inch]
    height: float  # [inch]
    shows: str


@dataclass(frozen=True)
class Listing:
    """Lines to be read as they stand."""

    lines: str


Item = Text | Table | Picture | Listing


@dataclass(frozen=True)
class Section:
    """A heading and what stands under it."""

    title: str
    items: tuple[Item, ...]


def picture(figure: Any, shows: str) -> Picture:
    """Return a matplotlib figure as a picture."""
    out = io.BytesIO()
    figure.savefig(out, format="png", dpi=_DPI, metadata={"Software": "ropewalk"})
    width, height = figure.get_size_inches()
    return Picture(out.getvalue(), float(width), float(height), shows)
