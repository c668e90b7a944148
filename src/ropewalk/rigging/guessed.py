"""What guesses make of a line: the same one at the ends of their ranges."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ropewalk.rigging.words import force, most_used
from ropewalk.scene import SceneError
from ropewalk.scene.guess import guesses_of

if TYPE_CHECKING:
    from ropewalk.rigging.lines import Line
    from ropewalk.rigging.rolling import Rolling

_NO_END = "EA is a guess: at an end of its range no such line, or no rest of it, was found"


def between(line: Line) -> tuple[Line, Line] | None:
    """Return the line with the least and with the greatest EA of a guess, set up alike.

    None where EA is no guess, or a line with such an EA cannot be.
    """
    guess = guesses_of(line.material).get("EA")
    if guess is None:
        return None
    try:
        return line.with_EA(guess.low), line.with_EA(guess.high)
    except SceneError:
        return None


def line_notes(line: Line) -> list[str]:
    """Return what is to be known of the numbers of a line's rope, one a line."""
    notes = []
    known = {} if line.rope is None else line.rope.numbers
    guess, ends = guesses_of(line.material).get("EA"), between(line)
    if ends is not None:
        soft, stiff = ends
        pulls = [max(one.tensions) for one in ends]
        notes.append(
            f"EA {force(line.material.EA)} is a guess, from {force(soft.material.EA)} to "
            f"{force(stiff.material.EA)}: length to cut {soft.length:.6g} to {stiff.length:.6g} m, "
            f"largest tension {force(min(pulls))} to {force(max(pulls))}"
            f"{most_used(max(pulls), line.material)}"
        )
    elif guess is not None:
        notes.append(
            f"EA {force(guess.value)} is a guess, from {force(guess.low)} to {force(guess.high)}: with an "
            "end of that range no line can be set up like this, so length and tensions are guesses, too"
        )
    elif line.rope is not None and "EA_static" not in known and line.rope.label:
        notes.append(f"EA {force(line.material.EA)} is that of a fall: at rest the rope is softer")
    mass = guesses_of(line.material).get("mass_per_length")
    if mass is not None:
        low, high = 1e3 * mass.low, 1e3 * mass.high
        notes.append(
            f"mass {1e3 * mass.value:.4g} g/m is a guess, from {low:.4g} to {high:.4g} g/m"
        )
    load = known.get("breaking_load")
    if line.material.breaking_load is None and load is not None and load.low is not None:
        notes.append(
            f"breaking load not known, so no utilisation; guessed {force(load.value)}, "
            f"at least {force(load.low)}"
        )
    return notes


def rolling_notes(rolling: Rolling) -> list[str]:
    """Return the largest tension and utilisation under the load at the ends of a guessed EA's range."""
    ends = between(rolling.line)
    if ends is None:
        return [_NO_END] if "EA" in guesses_of(rolling.line.material) else []
    try:
        pulls = [
            float(
                one.rolling(rolling.mass, held=rolling.held, at=rolling.place).largest_tension.max()
            )
            for one in ends
        ]
    except ArithmeticError:
        return [_NO_END]
    EAs = [force(one.material.EA) for one in ends]
    return [
        f"with EA {EAs[0]} to {EAs[1]} the largest is {force(min(pulls))} to {force(max(pulls))}"
        f"{most_used(max(pulls), rolling.line.material)}"
    ]
