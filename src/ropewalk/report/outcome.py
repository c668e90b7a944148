"""What came of looking at one claim: numbers, parts that hold or do not, a verdict, a figure."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from enum import StrEnum

from matplotlib.figure import Figure


class Verdict(StrEnum):
    """Whether what the report says is so."""

    CONFIRMED = "confirmed"
    IN_PART = "confirmed in part"
    REFUTED = "refuted"


@dataclass(frozen=True)
class Number:
    """One quantity, measured in a run and computed from a formula."""

    label: str
    measured: float
    theory: float
    unit: str  # "1" for a pure number
    tolerance: float  # allowed departure, relative to theory or in `unit`
    relative: bool = True
    formula: str = ""  # where the theory comes from

    @property
    def allowed(self) -> float:
        """Largest departure that still agrees, in the number's own unit."""
        return self.tolerance * (abs(self.theory) if self.relative else 1.0)

    @property
    def agrees(self) -> bool:
        """Whether measurement and theory agree within the tolerance; never for NaN."""
        if math.isinf(self.theory):
            return self.measured == self.theory
        return abs(self.measured - self.theory) <= self.allowed


@dataclass(frozen=True)
class Part:
    """One statement of a claim, and whether the run bears it out.

    `holds` is decided from measured values. A part whose numbers disagree with theory is not
    accepted: one of the two must be wrong.
    """

    statement: str
    holds: bool
    numbers: tuple[Number, ...] = ()

    @property
    def accepted(self) -> bool:
        """Whether the part holds and its numbers agree with theory."""
        return bool(self.holds) and all(number.agrees for number in self.numbers)


@dataclass(frozen=True)
class Outcome:
    """What was measured, what theory says, and what follows for the claim."""

    measured: str
    theory: str
    parts: tuple[Part, ...]
    figure: Figure
    caption: str
    note: str = ""
    checks: tuple[Number, ...] = field(default=())  # numbers beside the claim's own

    @property
    def numbers(self) -> tuple[Number, ...]:
        """All numbers: those of the parts, then the others."""
        return tuple(number for part in self.parts for number in part.numbers) + self.checks

    @property
    def sound(self) -> bool:
        """Whether measurement and theory agree in every number."""
        return all(number.agrees for number in self.numbers)

    @property
    def verdict(self) -> Verdict:
        """Confirmed when all parts are accepted, refuted when none is, else confirmed in part."""
        accepted = [part.accepted for part in self.parts]
        if all(accepted):
            return Verdict.CONFIRMED
        return Verdict.IN_PART if any(accepted) else Verdict.REFUTED


@dataclass(frozen=True)
class Claim:
    """One claim of the report."""

    id: str  # "C1" ...
    title: str
    text: str  # the claim, in our words
    group: str
    run: Callable[[], Outcome]


@dataclass(frozen=True)
class Row:
    """One run against the fine one."""

    name: str
    steps: float  # per frame
    places: float  # largest over the frames of the rms error over the nodes [m]; inf: broken
    tension: float  # rms error of the tension at the middle anchor over its mean [1]
    end: str


@dataclass(frozen=True)
class Answer:
    """A section of the page: text, a figure and a table."""

    id: str
    title: str
    text: str
    rows: tuple[Row, ...]
    figure: Figure
    caption: str
