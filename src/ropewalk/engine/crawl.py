"""Steps to a tolerance that crawl: so short that a run seems to stand still. It is said, once."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ropewalk.laws.registry import NODE_LAWS

if TYPE_CHECKING:
    from ropewalk.scene import Scene

MANY = 5000  # tries of a step that are looked at together
SHORT = 2e-5  # [s] a try that comes this far on average crawls


def ends_of(scene: Scene, *, slack: bool) -> list[str]:
    """Return what may end steps, or make them short, in a scene whose segments may go `slack` or not."""
    may = {
        "segments go slack and taut": slack,
        "segments reach the limiter's bounds": scene.limiter is not None,
        **{
            f"nodes reach and leave the {law.section}": bool(getattr(scene, law.section))
            for law in NODE_LAWS
            if law.crossings is not None and law.section != "contact"
        },
        "ropes strike each other": scene.contact is not None,
    }
    return [what for what, there in may.items() if there]


class CrawlWarning(UserWarning):
    """Steps to a tolerance are so short that a run seems to stand still."""


class Crawl:
    """How far the tries of steps come, at the tolerance of a run."""

    def __init__(self, tolerance: float | None, ends: Sequence[str] = ()) -> None:
        """Watch steps to a `tolerance` [m] that end, or are short, where this may happen; see `ends_of`."""
        self._tolerance, self._ends = tolerance, tuple(ends)
        self._tries, self._since, self.told = 0, 0.0, False

    def note(self, tries: int, time: float) -> None:
        """Take up that so many more tries have come to `time` [s]; warn where they crawl."""
        self._tries += tries
        if time < self._since:  # the simulation went back
            self._tries, self._since = 0, time
        if self.told or self._tries < MANY:
            return
        mean = (time - self._since) / self._tries
        self._tries, self._since = 0, time
        if mean < SHORT:
            self.told = True
            warnings.warn(self._text(time, mean), CrawlWarning, stacklevel=2)

    def _text(self, time: float, mean: float) -> str:
        many = f"{1.0 / mean:.2g} of them" if mean > 0.0 else "for ever"
        *more, last = self._ends or ("",)
        where = (", ".join(f"where {one}" for one in more) + ", and ") if more else ""
        why = f" Steps end {where}where {last}." if last else ""
        return (
            f"adaptive crawls at t = {time:.4g} s: steps of {1e6 * mean:.3g} us on average, so that a second "
            f"takes {many}.{why} Take a larger tolerance than {self._tolerance:g} m, give the rope the "
            "friction that it has, or take method = esdirk3"
        )
