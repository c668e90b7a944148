"""What guesses make of a line: the same one at the ends of their ranges."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ropewalk.rigging.words import force, most_used
from ropewalk.scene import SceneError
from ropewalk.scene.guess import guesses_of

if TYPE_CHECKING:
    from ropewalk.rigging.lines import Line
    from ropewalk.rigging.rolling import Rolling


def between(line: Line, number: str = "EA") -> tuple[Line, Line] | None:
    """Return the line with the least and with the greatest EA (or mass) of a guess, set up alike.

    `number`: "EA" or "mass_per_length". None where it is no guess, or a line with such a one cannot be.
    """
    guess = guesses_of(line.material).get(number)
    if guess is None:
        return None
    with_it = line.with_EA if number == "EA" else line.with_mass
    try:
        return with_it(guess.low), with_it(guess.high)
    except (SceneError, ArithmeticError):
        return None


def line_notes(line: Line) -> list[str]:
    """Return what is to be known of the numbers of a line's rope, one a line."""
    notes = []
    known = {} if line.rope is None else line.rope.numbers
    if "EA" in guesses_of(line.material):
        notes.append(_of_guess(line, "EA"))
    elif line.rope is not None and "EA_static" not in known and line.rope.label:
        notes.append(f"EA {force(line.material.EA)} is that of a fall: at rest the rope is softer")
    if "mass_per_length" in guesses_of(line.material):
        notes.append(_of_guess(line, "mass_per_length"))
    if both := _with_both(line):
        most = max(both.tensions)
        notes.append(f"{_BOTH}{force(most)}{most_used(most, line.material)}")
    load = known.get("breaking_load")
    if line.material.breaking_load is None and load is not None and load.low is not None:
        notes.append(
            f"breaking load not known, so no utilisation; guessed {force(load.value)}, "
            f"at least {force(load.low)}"
        )
    return notes


def rolling_notes(rolling: Rolling) -> list[str]:
    """Return the largest tension and utilisation under the load at the ends of what is guessed."""
    line, notes = rolling.line, []
    for number, (name, words) in _NUMBERS.items():
        if number not in guesses_of(line.material):
            continue
        pulls = _pulls(rolling, number)
        if pulls is None:
            rule = "at an end of its range no such line, or no rest of it, was found"
            notes.append(f"{name} is a guess: {rule}")
            continue
        guess = guesses_of(line.material)[number]
        notes.append(
            f"with {name} {words(guess.low)} to {words(guess.high)} the largest is "
            f"{force(min(pulls))} to {force(max(pulls))}{most_used(max(pulls), line.material)}"
        )
    if (both := _with_both(line)) and (pull := _pull(rolling, both)) is not None:
        notes.append(f"{_BOTH}{force(pull)}{most_used(pull, line.material)}")
    return notes


def _pulls(rolling: Rolling, number: str) -> list[float] | None:
    """Return the largest tension under the load at both ends of a guess [N]; None where there is none."""
    found = [_pull(rolling, one) for one in between(rolling.line, number) or ()]
    pulls = [pull for pull in found if pull is not None]
    return pulls if pulls and len(pulls) == len(found) else None


def _pull(rolling: Rolling, line: Line) -> float | None:
    """Return the largest tension of a line under the same load [N]; None where it has no rest."""
    try:
        found = line.rolling(rolling.mass, held=rolling.held, at=rolling.place)
    except ArithmeticError:
        return None
    return float(found.largest_tension.max())


def _with_both(line: Line) -> Line | None:
    """Return the line with the greatest EA and the greatest mass, where both are guesses."""
    stiff, heavy = between(line), between(line, "mass_per_length")
    if stiff is None or heavy is None:
        return None
    try:
        return stiff[1].with_mass(heavy[1].material.mass_per_length)
    except (SceneError, ArithmeticError):
        return None


def _of_guess(line: Line, number: str) -> str:
    """Return what the range of a guess makes of a line's length and tension."""
    guess, ends = guesses_of(line.material)[number], between(line, number)
    name, words = _NUMBERS[number]
    head = (
        f"{name} {words(guess.value)} is a guess, from {words(guess.low)} to {words(guess.high)}: "
    )
    if ends is None:
        rule = "with an end of that range no line can be set up like this"
        return f"{head}{rule}, so length and tensions are guesses, too"
    pulls, lengths = [max(one.tensions) for one in ends], [one.length for one in ends]
    cut = f"length to cut {min(lengths):.6g} to {max(lengths):.6g} m, "
    if line.set_up[0] == "length":
        cut = ""
    return (
        f"{head}{cut}largest tension {force(min(pulls))} to {force(max(pulls))}"
        f"{most_used(max(pulls), line.material)}"
    )


def _mass(mass_per_length: float) -> str:
    return f"{1e3 * mass_per_length:.4g} g/m"


_BOTH = "with the greatest of both guesses, EA and mass, the largest tension is "
_NUMBERS = {"EA": ("EA", force), "mass_per_length": ("mass", _mass)}
