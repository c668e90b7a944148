"""The report's figures 1 to 3, drawn anew from runs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ropewalk.core.arrays import Floats
from ropewalk.report import draw
from ropewalk.report.claims_rates import section_scene
from ropewalk.report.runs import Run, changed, record
from ropewalk.statics import static_shape

ANCHORS = (0, 20, 40)


@dataclass(frozen=True)
class Picture:
    """One of the report's figures."""

    id: str
    title: str
    figure: Figure
    caption: str


def pictures() -> list[Picture]:
    """Run the scenes and draw the three figures."""
    main = record(changed("r4", "duration=60"))
    return [_after_the_move(main), _coming_to_rest(main), _broken()]


def _rope(ax: Axes, x: Floats, colour: str = draw.BLUE, name: str | None = None) -> None:
    ax.plot(x[:, 0], x[:, 1], ".-", color=colour, ms=5, lw=1.3, label=name)
    held = x[list(ANCHORS)]
    ax.plot(held[:, 0], held[:, 1], "s", color="black", ms=6, zorder=5)


def _after_the_move(run: Run) -> Picture:
    figure, ax = draw.axes(height=2.7)
    start, now = run.x[0], run.x[run.at(6.0)]
    ax.plot(start[:, 0], start[:, 1], color=draw.GREY, lw=1.0, ls="--", label="at the start")
    _rope(ax, now, name="rope, 6 s after the start")
    ax.plot([], [], "ks", label="anchors")
    ax.annotate("", (now[0, 0] - 0.3, 0.9), (start[0, 0], 0.9),
                arrowprops={"arrowstyle": "->", "color": draw.ORANGE, "lw": 1.5})  # fmt: skip
    moved = now[0, 0] - start[0, 0]
    ax.text(start[0, 0], 1.3, f"left anchor moved {moved:.1f} m", color=draw.ORANGE)
    ax.set_aspect("equal")
    ax.set_ylim(top=2.8)
    draw.label(ax, "x (m)", "height (m)")
    draw.below(ax)
    return Picture(
        "figure-1",
        "The rope some seconds after the left anchor was moved",
        figure,
        "Figure 1 of the report: the rope on three anchors, 2.5 s after the left one stopped. The "
        "left section hangs in a deep loop with waves on it, the taut right one in a shallow one.",
    )


def _coming_to_rest(run: Run) -> Picture:
    times = (20.0, 60.0)
    figure, axes = draw.axes(1, 2, 4.0, sharex=True, sharey=True)
    rest = _rest(run)
    for ax, time in zip(axes, times, strict=True):
        frame = run.at(time)
        ax.plot(rest[:, 0], rest[:, 1], color=draw.ORANGE, lw=5, alpha=0.35, label="rest shape")
        _rope(ax, run.x[frame], name="rope")
        fastest = float(run.speed[frame - 60 : frame + 1].max())
        ax.set_aspect("equal")
        draw.label(ax, "", "height (m)", f"{time:g} s: fastest node {fastest:.2f} m/s in a second")
    axes[-1].set_xlabel("x (m)")
    draw.below(axes[-1], 2)
    return Picture(
        "figure-2",
        "The sections coming to rest",
        figure,
        "Figure 2 of the report: two later moments, over the shape in which the rope rests. What "
        "is left is the slow swing of the deep loop.",
    )


def _rest(run: Run) -> Floats:
    """Rest shape with the left anchor where it stopped."""
    place = run.x[-1, 0].tolist()
    sections = []
    for first, last in ((place, [20.0, 0.0, 0.0]), ([20.0, 0.0, 0.0], [40.0, 0.0, 0.0])):
        part = changed("r3", "rope.shape.kind=slack", f"rope.shape.start={first}",
                       f"rope.shape.end={last}")  # fmt: skip
        sections.append(static_shape(part).positions)
    return np.concatenate(sections)


def _broken() -> Picture:
    scene = section_scene(200.0, 20, 1.3)
    run = record(scene, keep_going=True)
    figure, axes = draw.axes(1, 3, 5.6)
    for ax, time in zip(axes, (0.30, 0.43, 0.90), strict=True):
        frame = run.at(time)
        stretch = float(run.stretch[frame].max())
        _rope(ax, run.x[frame], draw.RED if stretch > 1.1 else draw.BLUE)
        title = f"{run.time[frame]:.2f} s, longest spring {stretch:.2f} times its length"
        draw.label(ax, "", "height (m)", title)
    axes[-1].set_xlabel("x (m)")
    return Picture(
        "figure-3",
        "The broken rope: 200 N/m at 60 steps a second",
        figure,
        "Figure 3 of the report: recorded on into the break. First the rope falls as it should; "
        "then neighbouring masses slide to and fro along it, swapping at every step; in the end "
        "nothing of a rope is left. Each picture has its own scale.",
    )
