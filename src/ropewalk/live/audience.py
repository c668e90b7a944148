"""Whoever looks on at a stage."""

from __future__ import annotations

from typing import Any, Protocol


class Audience(Protocol):
    """Whoever looks on: pages behind a server."""

    @property
    def size(self) -> int:
        """How many look on."""

    def show(self, number: int, frame: bytes) -> None:
        """Show a frame to all."""

    def tell(self, message: dict[str, Any]) -> None:
        """Send a message to all."""


class Nobody:
    """An audience of none."""

    size = 0

    def show(self, number: int, frame: bytes) -> None:
        """Show a frame to nobody."""

    def tell(self, message: dict[str, Any]) -> None:
        """Tell nobody."""
