"""How numbers and verdicts are written, alike in HTML and Markdown."""

from __future__ import annotations

import math

from ropewalk.report.outcome import Number, Row, Verdict

TITLE = "The rope of the report, claim by claim"
LEAD = (
    "A student report on a simulated rope makes eighteen claims that a number can check. Each is "
    "run here on the simulator, computed from theory, and judged by comparing the two. A part of "
    "a claim is accepted when the run bears it out and every number of it agrees with theory "
    "within its tolerance; a claim is confirmed when all of its parts are, refuted when none is. "
    "Masses are 50 g, springs 1 m and 10 kN/m with a friction of 0.05 N s/m, steps of 2 ms and "
    "gravity 9.81 m/s², unless a claim says otherwise."
)
ANSWER = "Beyond the report"
ANSWER_HEADS = (
    "Method", "Steps a frame", "Outcome", "Places off by (rms)", "Tension off by (rms)",
)  # fmt: skip
MARK = {Verdict.CONFIRMED: "✓", Verdict.IN_PART: "◐", Verdict.REFUTED: "✗"}
CLASS = {Verdict.CONFIRMED: "yes", Verdict.IN_PART: "part", Verdict.REFUTED: "no"}


def value(number: float, unit: str) -> str:
    """Write a value with its unit; very small and large ones as powers of ten."""
    if math.isnan(number):
        return "none"
    if number != 0.0 and not 1e-4 <= abs(number) < 1e6:
        base, power = f"{number:.2e}".split("e")
        raised = str(int(power)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        text = f"{base} × 10{raised}"
    else:
        text = f"{number:.6g}"
    text = text.replace("-", "−")
    return text if unit == "1" else f"{text} {unit}"


def tolerance(number: Number) -> str:
    """Write the allowed departure."""
    if number.tolerance == 0.0:
        return "exact"
    if number.relative:
        return f"± {value(100.0 * number.tolerance, '%')}"
    return f"± {value(number.tolerance, number.unit)}"


def counts(verdicts: list[Verdict]) -> str:
    """Sum up the verdicts in one sentence."""
    parts = [f"{verdicts.count(one)} {one.value}" for one in Verdict]
    return f"Of {len(verdicts)} claims: {', '.join(parts)}."


def answer_cells(row: Row) -> tuple[str, ...]:
    """Write one run of the last section."""
    places = f"{1e3 * row.places:.0f} mm" if math.isfinite(row.places) else "–"
    tension = f"{100 * row.tension:.2g} %" if math.isfinite(row.tension) else "–"
    return row.name, f"{row.steps:g}", row.end, places, tension
