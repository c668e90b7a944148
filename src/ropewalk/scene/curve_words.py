"""What a curve of tension against strain is, in words."""

from __future__ import annotations

from ropewalk.scene.tension_curves import CurveModel
from ropewalk.words.prefixes import prefixed


def curve_words(curve: CurveModel) -> str:
    """Return a sentence without its full stop: slopes, and where it ends."""
    start, least, largest = (prefixed(slope, "N", 4) for slope in curve.slopes)
    return (
        f"a curve ({curve.kind}) whose slope is {start} at rest, {least} to {largest} in all; "
        f"straight beyond {end_words(curve)}"
    )


def end_words(curve: CurveModel) -> str:
    """Return where the curve ends, as "40 % (9 kN)"."""
    strain, tension = curve.end
    return f"{100.0 * strain:.4g} % ({prefixed(tension, 'N', 4)})"
