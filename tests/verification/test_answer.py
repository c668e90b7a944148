"""The report page's last section: its stiff springs at one step a frame."""

from __future__ import annotations

import math
from functools import cache

import numpy as np

import ropewalk as rw
from ropewalk.analysis.stability import stability
from ropewalk.report.outcome import Answer
from ropewalk.report.runs import changed, record
from ropewalk.report.stiff_rope import FINE, answer


@cache
def found() -> Answer:
    return answer()


def test_what_stands_and_what_breaks() -> None:
    """Explicit at one step a frame breaks (the twin); nine steps, and every implicit method, stand."""
    first, nine, *implicit = found().rows
    assert (first.steps, first.places) == (1, math.inf)
    told = rw.simulate("r6", on_failure="return").diagnosis
    assert told.startswith("Broke after t = 0.05 s")  # the page says the same as the run itself
    assert first.end == "breaks after 0.05 s"
    assert "R6 breaks after 0.05 s" in found().text
    limit = stability(changed("r6")).largest_spring_constant
    assert f"softer than {limit:.0f} N/m" in found().text
    assert nine.steps == 9
    assert [row.name for row in implicit] == ["sdirk2", "bdf2", "esdirk3"]
    for row in (nine, *implicit):
        assert row.end == "stands all 5 s"
        assert row.places < 0.2  # of a rope of 40 m
        assert row.tension < 0.15
    assert all(row.steps == 1 for row in implicit)


def test_the_fine_run_is_right() -> None:
    """Another method in steps a quarter as long differs by less than 0.3 % of what is compared."""
    own = record(changed("r6", "method=esdirk3", f"time_step={FINE!r}"))
    other = record(changed("r6", "method=verlet", f"time_step={FINE / 4!r}"))
    apart = np.linalg.norm(own.x - other.x, axis=2)
    assert apart.max() < 3e-3 * min(row.places for row in found().rows)


def test_the_text_says_the_numbers() -> None:
    rows, text = found().rows, found().text
    assert f"sdirk2 is off by up to {1e3 * rows[2].places:.0f} mm" in text
    assert f"{1e3 * rows[1].places:.0f} mm" in text
    best = min(rows[2:], key=lambda row: row.tension)
    assert f"{best.name} has the truest tension" in text
