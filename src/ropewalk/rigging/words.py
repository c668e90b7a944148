"""Forces, and how near to breaking, in words."""

from __future__ import annotations

from ropewalk.scene import Material
from ropewalk.scene.guess import load_doubt, worst_of
from ropewalk.words.safe_side import percent_up, safety_factor


def force(newtons: float) -> str:
    """Return a force as people write it: 12.3 kN."""
    for size, unit in ((1e6, "MN"), (1e3, "kN")):
        if abs(newtons) >= size:
            return f"{newtons / size:.4g} {unit}"
    return f"{newtons:.4g} N"


def margins(tension: float, material: Material) -> list[str]:
    """Return utilisation and safety factor in words: nothing where no breaking load is known."""
    breaking_load = material.breaking_load
    if breaking_load is None:
        return []
    share = tension / breaking_load
    text = (
        f"utilisation {percent_up(100.0 * share, 3)} of the breaking load of {force(breaking_load)}"
    )
    if tension > 0.0:
        text += f", safety factor {safety_factor(share)}"
    if share > 1.0:
        text += ": it would have parted"
    doubt = load_doubt(material, share)  # of a guessed EA notes of the line tell
    return [f"{text}; {doubt}" if doubt else text]


def most_used(tension: float, material: Material) -> str:
    """Return how near to breaking a tension [N] brings at most, after a comma; "" of no breaking load."""
    if material.breaking_load is None:
        return ""
    share = tension / material.breaking_load
    worst = worst_of(material, share)
    text = f", utilisation up to {percent_up(100.0 * share, 3)}"
    least = f", with the least of the guessed breaking load {percent_up(100.0 * worst, 3)}"
    return text + (least if worst > share else "")
