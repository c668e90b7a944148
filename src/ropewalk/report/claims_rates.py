"""C15 to C18: soft springs, frame rates and drawing."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from ropewalk.analysis.stability import stability
from ropewalk.core.arrays import Floats
from ropewalk.report import draw, formulas
from ropewalk.report.claims_model import C, G, K, L, M
from ropewalk.report.claims_shape import STILL
from ropewalk.report.claims_steps import break_time
from ropewalk.report.outcome import Number, Outcome, Part
from ropewalk.report.runs import Run, bisect, changed, log_growth, record
from ropewalk.scene import Scene
from ropewalk.statics import static_shape

SCREEN = 60.0  # [1/s]
FRAME = f"time_step={1 / SCREEN!r}"
SECTIONS = (3, 4, 5, 6, 7, 8, 10, 15, 20, 40)


def breaks_after_swings(k: float = 200.0) -> Outcome:
    """C15. Three anchors, k = 200, one step a frame, for several numbers of springs a section."""
    times, limits, swings = [], [], []
    for n in SECTIONS:
        scene = section_scene(k, n)
        times.append(break_time(record(scene)))
        limits.append(stability(scene).largest_spring_constant or math.nan)
        pull = static_shape(scene).spans[0].horizontal
        swings.append(formulas.swing_period(pull, M, L, float(n)))
    broke = [math.isfinite(t) for t in times]
    foreseen = [k > limit for limit in limits]
    fewest = next((n for n, b in zip(SECTIONS, broke, strict=True) if b), 0)
    predicted = next((n for n, b in zip(SECTIONS, foreseen, strict=True) if b), 0)
    count = {n: t / p for n, t, p in zip(SECTIONS, times, swings, strict=True)}
    stops = record(section_scene(k, 20), verdict=True).time[-1]
    run = record(section_scene(k, 20, 0.6), keep_going=True)
    growth, theory = _zigzag_growth(run), stability(section_scene(k, 20)).growth_per_step
    figure, (left, right) = draw.axes(2, 1, 3.2)
    shown = [(n, t) for n, t in zip(SECTIONS, times, strict=True) if math.isfinite(t)]
    left.plot([n for n, _ in shown], [t for _, t in shown], "o", color=draw.BLUE, label="breaks")
    never = [n for n, b in zip(SECTIONS, broke, strict=True) if not b]
    left.plot(never, [4.5] * len(never), "^", color=draw.GREEN, label="never in 30 s")
    left.plot(SECTIONS, swings, "--", color=draw.GREY, lw=1.0, label="one swing")
    left.set_ylim(0.0, 6.8)
    left.set_xlim(0.0, 42.0)
    draw.legend(left, fontsize=8, loc="upper right")
    draw.label(left, "springs a section", "time of the break (s)", f"k = {k:g} N/m, 60 Hz")
    strain = run.stretch.max(axis=1) - 1.0
    right.semilogy(run.time, strain, ".-", color=draw.BLUE)
    draw.label(right, "time (s)", "largest strain (1)", "20 springs a section")
    few = [n for n in SECTIONS if 2.0 <= count[n] < 100.0]
    return Outcome(
        measured=f"With 20 springs a section one is ten times its length, and the rope broken, after "
        f"{times[SECTIONS.index(20)]:.2f} s, {count[20]:.1f} of a swing. It takes a swing or more with "
        f"{_listed([n for n in SECTIONS if 1.0 <= count[n] < 100])} springs a section, two or more "
        f"with {_listed(few)}, and never breaks below {fewest}. The zigzag grows "
        f"{growth:.2f}-fold a step.",
        theory=f"{k:g} N/m is above the limit at 60 steps a second from {predicted} springs a "
        f"section on (20: {limits[SECTIONS.index(20)]:.1f} N/m). The shortest wave grows "
        f"{theory:.3f}-fold a step.",
        parts=(
            Part(f"{k:g} N/m at one step a frame breaks", broke[SECTIONS.index(20)], (
                Number("fewest springs a section that break", fewest, predicted, "1", 0.0, False,
                       "m f² (4/μ_max) - 2 c f < k"),
                Number("growth a step, 20 springs", growth, theory, "1", 0.1, True,
                       "largest root of z² - (2 - a - b) z + 1 - b"))),
            Part("not right away (after more than ten steps)",
                 all(t > 10 / SCREEN for t in times)),
            Part("after a few swings (two or more), with 20 springs a section",
                 2.0 <= count[20] < 100.0),
        ),
        figure=figure,
        caption="Left: time of the break against the number of springs between two anchors, with "
        "the period of a swing. Right: how the break grows.",
        note="The report does not say how many masses it has. A few swings mean a short rope, or "
        "a frame rate that stayed just below 64 Hz. Times of a break depend on round-off. Theory "
        "is that of the straight rope; in the sagging one the zigzag grows a little slower. A run of "
        f"Ropewalk stops at {stops:.2f} s already, before its springs are ten times their length: "
        "its energy is made up.",
    )  # fmt: skip


def section_scene(k: float, springs: int, duration: float = 30.0) -> Scene:
    """The main scene without moving its anchor, one step a frame, `springs` a section."""
    return changed(
        "r7", *STILL, f"rope.segments={2 * springs}", f"anchor.middle.node={springs}",
        "anchor.right.node=-1", f"rope.made_of.spring_constant={k!r}", FRAME,
        f"duration={duration!r}",
    )  # fmt: skip


def _listed(numbers: list[int]) -> str:
    return ", ".join(str(n) for n in numbers) or "none"


def _zigzag_growth(run: Run) -> float:
    """Growth a step of the zigzag of velocities along the rope, once it stands out [1]."""
    tangent = run.x[:, 2:] - run.x[:, :-2]
    tangent /= np.linalg.norm(tangent, axis=2)[:, :, None]
    along = (run.v[:, 1:-1] * tangent).sum(axis=2)
    size = np.sqrt((np.diff(along, n=2, axis=1) ** 2).mean(axis=1)) / 4.0
    # Below, the fall itself shows; above, springs are stretched far and the theory is left.
    good = np.flatnonzero((size > 0.1) & (size < 10.0))
    if len(good) < 3:
        return math.nan
    return math.exp(float(np.polyfit(good, np.log(size[good]), 1)[0]))


def stable_but_bouncy(scene: Scene | None = None) -> Outcome:
    """C16. R8 for its minute, and the stretch of the same rope with and without stiff springs."""
    base = scene or changed("r8")
    run = record(base)
    soft = record(changed(base, *STILL))
    stiff = record(changed("r4", *STILL, "duration=30"))
    predicted = stability(base)
    limit = predicted.largest_spring_constant or math.nan
    a, b = soft.largest_stretch, stiff.largest_stretch
    expected = 1.0 + formulas.bounce_strain(100.0, M, L, G, 20.0)
    figure, ax = draw.axes()
    for one, colour, name in ((soft, draw.ORANGE, "100 N/m, steps of 16.7 ms"),
                              (stiff, draw.BLUE, "10 kN/m, steps of 1.9 ms")):  # fmt: skip
        shown = one.time <= 30.0
        ax.plot(one.time[shown], one.stretch[shown].max(axis=1), color=colour, lw=0.8, label=name)
    draw.label(ax, "time (s)", "largest stretch (1)")
    draw.below(ax)
    return Outcome(
        measured=f"With 100 N/m at one step a frame the rope runs for {run.time[-1]:.0f} s "
        f"{'and breaks' if run.broke else 'without a break'}. Its springs stretch to {a:.3f}, those "
        f"of 10 kN/m to {b:.3f}.",
        theory=f"The limit at 60 steps a second is {limit:.1f} N/m. The fall stretches the soft "
        f"springs to {expected:.2f} (energy balance).",
        parts=(
            Part("100 N/m at 60 steps a second is stable", not run.broke, (
                Number("stands the minute", float(not run.broke), float(predicted.stable), "1",
                       0.0, False, "k < m f² (4/μ_max) - 2 c f"),)),
            Part("it bounces more", a - 1.0 > 5.0 * (b - 1.0), (
                Number("largest strain", 100 * (a - 1), 100 * (expected - 1), "%", 0.25, True,
                       "one-arch energy balance"),)),
        ),
        figure=figure,
        caption="Largest stretch of any spring of the dropped rope.",
    )  # fmt: skip


RATES = (30.0, 50.0, 60.0, 75.0, 90.0, 120.0, 144.0, 500.0)


def tradeoff(rates: tuple[float, ...] = RATES) -> Outcome:
    """C17. The largest spring constant at each rate, by bisection of runs with 20 springs."""
    found, theory = [], []
    for rate in rates:
        scene = changed("r3", "steps=exact", f"time_step={1 / rate!r}", f"frame_rate={rate!r}")
        long = formulas.largest_spring(M, C, rate)
        theory.append(stability(scene).largest_spring_constant or math.nan)

        def grows(k: float, scene: Scene = scene) -> bool:
            return log_growth(changed(scene, f"rope.made_of.spring_constant={k!r}"), 4000) > 0.0

        found.append(bisect(grows, 0.8 * long, 1.25 * long, 2e-5))
    drops = [
        record(changed("r3", FRAME, "duration=60",
                       f"rope.made_of.spring_constant={(1 + part) * theory[rates.index(60.0)]!r}"))
        for part in (-0.01, 0.01)
    ]  # fmt: skip
    numbers = tuple(
        Number(f"largest k at {rate:g} Hz", a, b, "N/m", 2e-3, True,
               "m f² (4/μ_max) - 2 c f, 19 free masses")
        for rate, a, b in zip(rates, found, theory, strict=True)
    )  # fmt: skip
    figure = _draw_tradeoff(rates, found)
    at_60 = found[rates.index(60.0)]
    return Outcome(
        measured="Runs begin to grow at "
        + ", ".join(f"{k:.5g}" for k in found)
        + " N/m for "
        + ", ".join(f"{f:g}" for f in rates)
        + " steps a second. Dropped for a minute at 60 Hz, the rope "
        + ("stands" if not drops[0].broke else "breaks at")
        + " 1 % below that and "
        + ("breaks" if drops[1].broke else "stands")
        + " 1 % above.",
        theory="k_max = m f² - 2 c f for a long chain, "
        + ", ".join(f"{formulas.largest_spring(M, C, f):.5g}" for f in rates)
        + " N/m; with 19 free masses up to 1 % more.",
        parts=(
            Part("a lower rate of steps allows only softer springs",
                 bool(np.all(np.diff(found) > 0.0)), numbers),
            Part("at 60 Hz the springs must come down from 10 kN/m to below 200 N/m",
                 100.0 < at_60 < 200.0, (
                Number("the long chain's rule at 60 Hz", at_60,
                       formulas.largest_spring(M, C, 60.0), "N/m", 0.01, True, "m f² - 2 c f"),)),
            Part("the limit is sharp: 1 % below stands, 1 % above breaks",
                 not drops[0].broke and drops[1].broke),
        ),
        figure=figure,
        caption="Largest stable spring constant against the rate of steps; crosses mark what the "
        "report tried at 60 Hz.",
    )  # fmt: skip


def _draw_tradeoff(rates: tuple[float, ...], found: list[float]) -> Figure:
    figure, ax = draw.axes()
    fine = np.geomspace(min(rates), max(rates), 60)
    ax.loglog(fine, [formulas.largest_spring(M, C, f) for f in fine], "k--", lw=0.9,
              label="m f² - 2 c f")  # fmt: skip
    ax.loglog(rates, found, "o", color=draw.BLUE, label="bisected in runs")
    for k, name in ((100.0, "100"), (200.0, "200"), (K, "10 000")):
        ax.plot([60.0], [k], "x", color=draw.ORANGE if k > 174 else draw.GREEN, ms=7, mew=2)
        ax.annotate(
            f"report: {name} N/m",
            (60.0, k),
            xytext=(8, -9) if k < 174 else (-8, 4),  # clear of the line
            textcoords="offset points",
            fontsize=8,
            ha="left" if k < 174 else "right",
        )
    draw.label(ax, "steps a second (1/s)", "largest stable\nspring constant (N/m)")
    ax.set_xticks(list(rates), [f"{f:g}" for f in rates])
    ax.minorticks_off()
    draw.below(ax)
    return figure


def same_bits(duration: float = 10.0) -> Outcome:
    """C18. One scene recorded at several frame rates with the same fixed step."""
    rates = (5.0, 10.0, 25.0, 50.0, 60.0, 100.0, 250.0, 500.0)
    base = changed("r4", "steps=exact", "time_step=0.002", f"duration={duration!r}")
    runs = [record(changed(base, f"frame_rate={rate!r}")) for rate in rates]
    ends = [_state_at(run, duration) for run in runs]
    apart = [float(np.abs(end - ends[0]).max()) for end in ends]
    equal = all(np.array_equal(end, ends[0]) for end in ends)
    screens = (30.0, 50.0, 60.0, 75.0, 100.0, 144.0)
    divided = [record(changed("r4", f"frame_rate={rate!r}", f"duration={duration!r}"))
               for rate in screens]  # fmt: skip
    spread = [float(np.linalg.norm(_state_at(r, duration)[0] - ends[-1][0], axis=1).max())
              for r in divided]  # fmt: skip
    figure, ax = draw.axes()
    ax.plot(rates, apart, "o", color=draw.BLUE, label="fixed step of 2 ms: the same bits")
    ax.plot(screens, spread, "s", color=draw.ORANGE, label="each frame divided evenly")
    ax.set_xscale("log")
    ax.set_yscale("symlog", linthresh=1e-6)
    ax.set_ylim(-5e-7, 10.0)
    draw.label(ax, "frames a second (1/s)", "largest distance at 10 s (m)")
    draw.below(ax)
    return Outcome(
        measured=f"Recorded at {len(rates)} rates from {rates[0]:g} to {rates[-1]:g} frames a second "
        f"with a fixed step of 2 ms, positions and velocities after {duration:g} s "
        f"{'are the same to the last bit' if equal else 'differ'}.",
        theory="The physics never reads a frame: with a fixed step the same steps are done in the "
        "same order, so the difference is exactly 0.",
        parts=(
            Part("the physics does not depend on the drawing", equal, (
                Number("largest difference", max(apart), 0.0, "m", 0.0, False, "same steps"),)),
        ),
        figure=figure,
        caption="Distance between runs at different frame rates.",
        note="The report divides each frame into steps, so that its step, and with it the motion, "
        f"depends a little on the frame rate: by up to {max(spread):.2g} m here after "
        f"{duration:g} s.",
    )  # fmt: skip


def _state_at(run: Run, time: float) -> Floats:
    """Positions [m] and velocities [m/s] at a time, (2, n, 3)."""
    i = run.at(time)
    return np.stack([run.x[i], run.v[i]])
