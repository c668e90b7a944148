"""Steps to a tolerance that crawl: so short that a run seems to stand still. It is said, once."""

from __future__ import annotations

import warnings

MANY = 5000  # tries of a step that are looked at together
SHORT = 2e-5  # [s] a try that comes this far on average crawls


class CrawlWarning(UserWarning):
    """Steps to a tolerance are so short that a run seems to stand still."""


class Crawl:
    """How far the tries of steps come, at the tolerance of a run."""

    def __init__(self, tolerance: float | None, slack: bool) -> None:
        """Watch steps to a `tolerance` [m]; `slack` says whether segments may go slack and taut."""
        self._tolerance, self._slack = tolerance, slack
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
        why = " Steps end where segments go slack and taut." if self._slack else ""
        return (
            f"adaptive crawls at t = {time:.4g} s: steps of {1e6 * mean:.3g} us on average, so that a second "
            f"takes {many}.{why} Take a larger tolerance than {self._tolerance:g} m, give the rope the "
            "friction that it has, or take method = esdirk3"
        )
