"""A replay inside a cell of a notebook: the page to share, in a frame, without a server."""

from __future__ import annotations

from html import escape

from ropewalk.live.packed_run import record
from ropewalk.live.share import page
from ropewalk.record.result import Result
from ropewalk.words.annotations import unquoted

_LEAST = 100  # pixels


@unquoted
class Replay:
    """A run's replay; as the last line of a notebook's cell it shows itself."""

    def __init__(self, text: str, title: str, height: int) -> None:
        self._text, self._title, self._height = text, title, height

    @property
    def page(self) -> str:
        """The page as HTML, as `Result.share` writes it."""
        return self._text

    def _repr_html_(self) -> str:
        # The frame may run the page's one script, and has no access to the notebook around it.
        return (
            f'<iframe srcdoc="{escape(self._text, quote=True)}" sandbox="allow-scripts" '
            f'title="{escape(self._title, quote=True)}" width="100%" height="{self._height}" '
            'style="border: 1px solid #8884; border-radius: 6px" allow="fullscreen"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<Replay of {self._title!r}, {len(self._text) / 1e6:.2g} MB>"


def replay(result: Result, frame_rate: float, height: int) -> Replay:
    """Return a result's replay; see `Result.replay`."""
    if not height >= _LEAST:
        raise ValueError(f"height: {height!r} - must be at least {_LEAST} pixels")
    recording = record(result.folder or result, frame_rate)
    return Replay(page(recording), str(recording.header["title"]), int(height))
