"""Whoever looks on at a broadcast."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

#: Takes a frame that was not sent and the one after it; returns the latter, with what was seen for both.
Combine = Callable[[bytes, bytes], bytes]


class Audience(Protocol):
    """Whoever looks on: pages behind a server."""

    @property
    def size(self) -> int:
        """How many look on."""

    def show(self, number: int, frame: bytes, combine: Combine | None = None) -> None:
        """Show a frame to all."""

    def tell(self, message: dict[str, Any]) -> None:
        """Send a message to all."""


class Nobody:
    """An audience of none."""

    size = 0

    def show(self, number: int, frame: bytes, combine: Combine | None = None) -> None:
        """Show a frame to nobody."""

    def tell(self, message: dict[str, Any]) -> None:
        """Tell nobody."""
