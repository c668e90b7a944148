"""Draw docs/images/three-anchors.png: the report's rope, as it runs and as it breaks.

.venv/bin/python docs/images/three_anchors.py
"""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import ropewalk as rw

TIMES = (0.0, 0.6, 1.2, 2.0, 3.0, 20.0)  # s
BROKEN = (0.3, 0.45, 0.55, 0.6)  # s


def draw(axes: Axes, result: rw.Result, times: tuple[float, ...], title: str) -> None:
    """Draw the rope at some times, early ones pale."""
    colours = mpl.colormaps["viridis_r"]
    for i, time in enumerate(times):
        frame = result.frame_at(time)
        points = result.positions[frame]
        colour = colours(0.15 + 0.85 * i / (len(times) - 1))
        label = f"{result.time[frame]:.3g} s"
        axes.plot(points[:, 0], points[:, 1], "-o", color=colour, lw=1.6, ms=2.6, label=label)
        held = points[list(result.layout.anchor_nodes)]
        axes.plot(held[:, 0], held[:, 1], "s", color=colour, mec="black", mew=0.8, ms=6, zorder=3)
    axes.set_aspect("equal", adjustable="box")
    axes.set_ylabel("y [m]")
    axes.set_title(title, loc="left", fontsize=10)
    axes.grid(color="#e6e6e6", lw=0.7)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.03), frameon=False, fontsize=9)


def main() -> None:
    """Run the two scenes and draw them."""
    runs = rw.simulate("r4")
    breaks = rw.simulate("r7", keep_going=True, on_failure="return")
    figure = Figure(figsize=(9.0, 4.3), layout="compressed")
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(7.6, 4.4))
    said = rw.check(breaks.scene).stability
    draw(
        upper, runs, TIMES, "The report's rope: 10 000 N/m, 9 steps a frame. The left anchor moves."
    )
    draw(
        lower,
        breaks,
        BROKEN,
        f"200 N/m, 1 step a frame ({1e3 * said.step:.1f} ms): beyond the predicted largest "
        f"step of {1e3 * said.largest_step[said.method]:.1f} ms, it breaks (recorded on).",
    )
    upper.set_ylim(-6.9, 0.7)
    lower.set_ylim(-3.2, 1.2)
    lower.set_xlabel("x [m]")
    figure.savefig(Path(__file__).with_name("three-anchors.png"), dpi=110, bbox_inches="tight")


if __name__ == "__main__":
    main()
