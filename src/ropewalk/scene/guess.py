"""Guessed numbers of a material: marks that go with it wherever it goes, and what they do to a margin."""

from __future__ import annotations

import math
from typing import Any, Literal

from pydantic import Field, model_validator

from ropewalk.library.entry import UNITS
from ropewalk.scene.base import Model, Number, refuse
from ropewalk.scene.faults import Fault
from ropewalk.scene.limits import HUGE
from ropewalk.words.prefixes import prefixed
from ropewalk.words.safe_side import percent_up, safety_factor

Guessable = Literal[
    "EA",
    "mass_per_length",
    "axial_damping",
    "relaxing_EA",
    "relaxation_time",
    "EI",
    "breaking_load",
]
STIFF = ("EA", "relaxing_EA")
COMPUTE = "compute both ends of it"


class Guess(Model):
    """Says that a number of the material is a guess. Counts while that number has this `value`."""

    of: Guessable = Field(description="Which number of the material")
    value: Number = Field(
        gt=0, le=HUGE, description="As it was guessed, in the number's own SI unit"
    )
    low: Number = Field(ge=0, le=HUGE, description="Least that it may be, in the same unit")
    high: Number = Field(gt=0, le=HUGE, description="Most that it may be, in the same unit")

    @model_validator(mode="after")
    def _check(self) -> Guess:
        if self.of == "breaking_load" and self.low == 0.0:  # all is told from the least of it
            refuse([Fault("low", self.low, "must be greater than 0")])
        if not self.low <= self.value <= self.high:
            refuse([Fault("value", self.value, f"must be from {self.low:g} to {self.high:g}")])
        return self

    @property
    def span(self) -> str:
        """The range in words."""
        unit = UNITS[self.of]
        return f"{prefixed(self.low, unit)} to {prefixed(self.high, unit)}"


def guesses_of(made_of: Any) -> dict[str, Guess]:
    """Return the guesses among a material's numbers, by the names of these."""
    marks = getattr(made_of, "guessed", ())
    return {mark.of: mark for mark in marks if getattr(made_of, mark.of) == mark.value}


def guess_words(made_of: Any) -> str:
    """Return which of a material's numbers are guesses, with their ranges; "" for none."""
    marks = guesses_of(made_of).items()
    return ", ".join(f"{name.replace('_', ' ')} ({mark.span})" for name, mark in marks)


def doubt_of(made_of: Any, utilisation: float, then: str = COMPUTE) -> str:
    """Return what guesses make of a utilisation [1]: of the load on the safe side; of EA, what `then`."""
    marks = guesses_of(made_of)
    stiff = [f"{name} is a guess, {marks[name].span}" for name in STIFF if name in marks]
    if stiff:
        stiff.append(f"so that tensions that stretch makes are, too: {then}")
    load = load_doubt(made_of, utilisation)
    return "; ".join(text for text in (load, ", ".join(stiff)) if text)


def worst_of(made_of: Any, utilisation: float) -> float:
    """Return the utilisation [1] with the least that a guessed breaking load may be; as it is of no guess."""
    mark = guesses_of(made_of).get("breaking_load")
    return utilisation if mark is None else utilisation * mark.value / mark.low


def load_doubt(made_of: Any, utilisation: float) -> str:
    """Return what a guessed breaking load makes of a utilisation [1], on the safe side; "" of no guess."""
    mark = guesses_of(made_of).get("breaking_load")
    if mark is None or math.isnan(utilisation):
        return ""
    share = worst_of(made_of, utilisation)
    text = f"the breaking load is a guess, {mark.span}: with the least of it {percent_up(100.0 * share, 3)}"
    return text + (f", safety factor {safety_factor(share)}" if share > 0.0 else "")
