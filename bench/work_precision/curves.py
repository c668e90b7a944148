"""What the points say: the time to a given error, and the targets."""

from __future__ import annotations

import math
from collections.abc import Iterable

from bench.row import Row
from bench.work_precision.measure import Point

EXPLICIT = ("semi-implicit-euler", "verlet", "heun", "rk4")


def points_of(points: Iterable[Point], case: str, family: str, name: str) -> list[Point]:
    """Return one contestant's points of a case that did not break, the largest step first."""
    own = [p for p in points if (p.case, p.family, p.name) == (case, family, name)]
    return sorted((p for p in own if math.isfinite(p.error)), key=lambda p: -p.setting)


def contestants(points: Iterable[Point], case: str) -> list[tuple[str, str]]:
    """Return family and name of those that took part in a case, in order."""
    return list(dict.fromkeys((p.family, p.name) for p in points if p.case == case))


def time_at(points: list[Point], error: float) -> float:
    """Return the shortest time [s] in which a contestant gets below an error [m].

    That of its cheapest point below it, or less where the line from the point of the next larger step
    crosses the error, both axes logarithmic. NaN when it never gets there. `points` as `points_of` has
    them.
    """
    good = [i for i, point in enumerate(points) if point.error <= error]
    if not good:
        return math.nan
    place = min(good, key=lambda i: points[i].seconds)
    best, worse = points[place], points[max(place - 1, 0)]
    if worse.error <= error or worse.seconds >= best.seconds or best.error == 0.0:
        return best.seconds
    share = math.log(worse.error / error) / math.log(worse.error / best.error)
    return worse.seconds * (best.seconds / worse.seconds) ** share


def targets(points: list[Point], cost: float) -> list[Row]:
    """Return the targets of what was measured; `cost` is that of an explicit segment step [s]."""
    rows = []
    for case, error, share in (("dropped-1e5", 1e-3, 0.5), ("dropped-1e7", 1e-3, 0.1)):
        own = time_at(points_of(points, case, "ropewalk", "sdirk2"), error)
        for rival in ("semi-implicit-euler", "verlet"):
            other = time_at(points_of(points, case, "ropewalk", rival), error)
            label = f"{case}: sdirk2 / {rival} at 1 mm"
            rows.append(Row(label, own / other, "1", f"<= {share}"))
    rows += _frame_step(points, cost) + _against_scipy(points, 1e-4)
    return [row for row in rows if math.isfinite(row.value)]


def _frame_step(points: list[Point], cost: float) -> list[Row]:
    """Rate the step of one frame of 1/60 s: error, and speed where an explicit step costs 2.5 ns."""
    own = points_of(points, "dropped-1e5", "ropewalk", "sdirk2")
    frame = [p for p in own if math.isclose(p.setting, 1.0 / 60.0, rel_tol=1e-6)]
    if not frame:
        return []
    speed = 1.0 / frame[0].seconds
    return [
        Row("dropped-1e5: sdirk2 at 1/60 s, error", 1e3 * frame[0].error, "mm", "<= 3"),
        Row("the same, times real time", speed, "1", ""),
        Row("the same, at 2.5 ns per segment", speed * cost / 2.5e-9, "1", ">= 300"),
    ]


def _against_scipy(points: list[Point], error: float) -> list[Row]:
    rows = []
    for case in dict.fromkeys(p.case for p in points):
        times: dict[str, dict[str, float]] = {"ropewalk": {}, "scipy": {}, "numpy": {}}
        for family, name in contestants(points, case):
            found = time_at(points_of(points, case, family, name), error)
            if math.isfinite(found):
                times[family][name] = found
        if not times["ropewalk"] or not times["scipy"]:
            continue
        rival = min(times["scipy"], key=lambda name: times["scipy"][name])
        label = f"{case}: {rival} (scipy's fastest) / "
        shown = [name for name in ("sdirk2", "adaptive") if name in times["ropewalk"]]
        fastest = min(times["ropewalk"], key=lambda name: times["ropewalk"][name])
        for name in dict.fromkeys([*shown, fastest]):
            words = f"{name}, our fastest, at 0.1 mm" if name == fastest else f"{name} at 0.1 mm"
            ratio = times["scipy"][rival] / times["ropewalk"][name]
            rows.append(Row(label + words, ratio, "1", ">= 60"))
    return rows
