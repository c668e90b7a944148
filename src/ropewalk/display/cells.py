"""Pieces of HTML for the cells of notebooks: pictures and tables."""

from __future__ import annotations

import base64
import html
from collections.abc import Callable, Iterable, Sequence
from io import BytesIO
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LEFT = "style='text-align:left'"


def png(draw: Callable[[], Figure]) -> bytes | None:
    """Return a figure as PNG; None where figures cannot be drawn."""
    try:
        buffer = BytesIO()
        draw().savefig(buffer, format="png", dpi=100)
    except ImportError:
        return None
    return buffer.getvalue()


def picture(image: bytes | None, about: str) -> str:
    """Return a picture with what it shows in words; nothing where there is none."""
    if image is None:
        return ""
    data = base64.b64encode(image).decode("ascii")
    return f"<img alt='{html.escape(about, quote=True)}' src='data:image/png;base64,{data}'>"


def paragraph(text: str) -> str:
    """Return a text as a paragraph."""
    return f"<p>{html.escape(text)}</p>"


def table(rows: Iterable[Sequence[object]], heads: Sequence[str] = ()) -> str:
    """Return a table; floats with six digits, the first column to the left."""
    top = "".join(f"<th>{html.escape(head)}</th>" for head in heads)
    body = "".join(f"<tr>{_cells(row)}</tr>" for row in rows)
    return f"<table>{f'<tr>{top}</tr>' if heads else ''}{body}</table>"


def _cells(row: Sequence[object]) -> str:
    texts = [f"{cell:.6g}" if isinstance(cell, float) else str(cell) for cell in row]
    first, *others = (html.escape(text) for text in texts)
    return f"<td {_LEFT}>{first}</td>" + "".join(f"<td>{text}</td>" for text in others)
