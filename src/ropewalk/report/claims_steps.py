"""C8, C9 and C14 to C17: time steps, stability and breaking."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from ropewalk.analysis.stability import stability
from ropewalk.core.arrays import Floats
from ropewalk.report import draw
from ropewalk.report.claims_model import C, G, K, L, M
from ropewalk.report.claims_shape import STILL
from ropewalk.report.outcome import Number, Outcome, Part
from ropewalk.report.runs import Run, bisect, changed, log_growth, record
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation

SCREEN = 60.0  # [1/s]
FRAME = f"time_step={1 / SCREEN!r}"


def better_than_euler() -> Outcome:
    """C8. Where small zigzags begin to grow, by bisection, and one mass against the exact swing."""
    found, theory = [], []
    for method, low, high, steps in (
        ("semi-implicit-euler", 0.0015, 0.0035, 4000),
        ("euler", 2e-6, 2e-5, 200000),
    ):
        scene = changed("r3", f"method={method}", "steps=exact")
        theory.append(1e3 * stability(scene).largest_step[method])

        def grows(dt: float, scene: Scene = scene, steps: int = steps) -> bool:
            return log_growth(_step(scene, dt), steps) > 0.0

        found.append(1e3 * bisect(grows, low, high, 1e-4))
    broken = record(changed("r3", "method=euler", "steps=exact", "time_step=0.002",
                            "frame_rate=500"))  # fmt: skip
    dt = 1e-4
    errors, swings = {}, {}
    for method in ("semi-implicit-euler", "euler"):
        run = record(changed("r1", f"method={method}", f"time_step={dt}", "frame_rate=10000",
                             "duration=0.05"))  # fmt: skip
        swings[method] = run
        errors[method] = float(np.abs(run.x[:, 1, 1] - _exact(run)).max() / (M * G / K))
    figure = _draw_methods(swings, found)
    ratio = found[0] / found[1]
    broken_at = break_time(broken)
    return Outcome(
        measured=f"Small zigzags begin to grow at steps of {found[0]:.4f} ms with semi-implicit "
        f"and {found[1]:.5f} ms with plain Euler, a factor of {ratio:.0f}. At 2 ms plain Euler "
        f"has stretched a spring tenfold after {broken_at:.2f} s. At 0.1 ms it is off by "
        f"{100 * errors['euler']:.0f} % of the swing after 50 ms, semi-implicit Euler by "
        f"{100 * errors['semi-implicit-euler']:.1f} %.",
        theory=f"The bounds are {theory[0]:.4f} ms, from k μ dt² / m + 2 c μ dt / m < 4 of 19 "
        f"free masses (a long chain's is k dt² + 2 c dt < m), and {theory[1]:.5f} ms = c / k.",
        parts=(
            Part("it stands longer steps", ratio > 2.0, (
                Number("largest step, semi-implicit Euler", found[0], theory[0], "ms", 2e-3, True,
                       "k μ dt² / m + 2 c μ dt / m < 4"),
                Number("largest step, Euler", found[1], theory[1], "ms", 0.01, True, "c / k"))),
            Part("it stays closer to the exact motion",
                 errors["semi-implicit-euler"] < 0.5 * errors["euler"]),
            Part("plain Euler breaks at the report's step", broken.broke),
        ),
        figure=figure,
        caption="Left: one mass on a spring with both methods. Right: largest stable steps of the "
        "taut section (log scale).",
        note="Plain Euler owes even its small step to friction; without friction no step is "
        "stable.",
    )  # fmt: skip


def _draw_methods(swings: dict[str, Run], found: list[float]) -> Figure:
    figure, (left, right) = draw.axes(2, 1, 3.2)
    for method, colour in (("euler", draw.ORANGE), ("semi-implicit-euler", draw.BLUE)):
        run = swings[method]
        left.plot(1e3 * run.time, 1e6 * (run.x[:, 1, 1] + L + M * G / K), color=colour,
                  label=method, lw=1.1)  # fmt: skip
    run = swings["euler"]
    left.plot(1e3 * run.time, 1e6 * (_exact(run) + L + M * G / K), "k--", lw=0.9, label="exact")
    left.set_ylim(top=145.0)
    draw.legend(left, fontsize=8, loc="upper left")
    draw.label(left, "time (ms)", "about the place of rest (µm)", "One mass, steps of 0.1 ms")
    names = ["semi-implicit\nEuler", "Euler"]
    right.bar(names, found, color=[draw.BLUE, draw.ORANGE], width=0.5)
    for i, value in enumerate(found):
        right.text(i, value * 1.25, f"{value:.4g} ms", ha="center")
    right.set_yscale("log")
    right.set_ylim(1e-3, 20.0)
    right.grid(axis="x", visible=False)
    draw.label(right, "", "largest stable step (ms)", "Bisected in runs")
    return figure


def _step(scene: Scene, dt: float) -> Scene:
    return changed(scene, f"time_step={dt!r}", f"frame_rate={1 / dt!r}", f"duration={dt * 10!r}")


def _exact(run: Run) -> Floats:
    """Height of one mass let go at rest length, exact damped swing [m], (f,)."""
    still, rate = M * G / K, C / (2 * M)
    omega = math.sqrt(K / M - rate * rate)
    t = run.time
    swing = np.cos(omega * t) + rate / omega * np.sin(omega * t)
    return np.asarray(-L - still + still * np.exp(-rate * t) * swing)


def break_time(run: Run) -> float:
    """Time at which a run's first spring is ten times its length [s]; inf if none is.

    In one frame after its last good one.
    """
    return float(run.time[-1] + run.dt) if run.broke else math.inf


def substeps() -> Outcome:
    """C9. Steps a frame for frames of 15 to 21 ms, with NeHe's rule and with even division."""
    frames = np.arange(15.0, 21.01, 0.1)  # [ms]
    nehe = [_steps_in_frame(ms, "nehe") for ms in frames]
    even = [_steps_in_frame(ms, "divide") for ms in frames]
    at_60 = _steps_in_frame(1000.0 / SCREEN, "nehe")
    found = {c: frames[np.array(nehe) == c] for c in (9, 10)}
    by_count = {c: part if part.size else np.array([math.nan]) for c, part in found.items()}
    figure, ax = draw.axes(height=2.8)
    ax.step(frames, nehe, where="mid", color=draw.BLUE, label="int(frame / 2 ms) + 1")
    ax.step(frames, even, where="mid", color=draw.ORANGE, ls="--", label="ceil(frame / 2 ms)")
    ax.axvline(1000 / SCREEN, color=draw.GREY, lw=1.0)
    ax.text(1000 / SCREEN + 0.05, 10.6, "60 Hz", color=draw.GREY)
    ax.set_yticks([8, 9, 10, 11])
    draw.label(ax, "length of a frame (ms)", "steps a frame (1)")
    draw.below(ax)
    return Outcome(
        measured=f"A frame at 60 Hz is run in {at_60} steps; frames of {by_count[9].min():.1f} to "
        f"{by_count[9].max():.1f} ms in 9, of {by_count[10].min():.1f} to "
        f"{by_count[10].max():.1f} ms in 10.",
        theory=f"int(frame / 2 ms) + 1 = {int(1000 / SCREEN / 2.0) + 1} at 60 Hz (the plain ratio "
        f"is {1000 / SCREEN / 2:.2f}); 9 from 16 ms on and 10 from 18 ms on.",
        parts=(
            Part("9 steps a frame at 60 Hz", at_60 == 9, (
                Number("steps at 60 Hz", at_60, int(1 / SCREEN / 0.002) + 1, "1", 0.0, False,
                       "int(frame / dt) + 1"),)),
            Part("10 when a frame takes a little longer", by_count[10].min() < 18.2, (
                Number("longest frame with 9", float(by_count[9].max()), 18.0, "ms", 0.11, False,
                       "9 dt"),
                Number("longest frame with 10", float(by_count[10].max()), 20.0, "ms", 0.11,
                       False, "10 dt"))),
        ),
        figure=figure,
        caption="Steps a frame against the length of a frame.",
    )  # fmt: skip


def _steps_in_frame(milliseconds: float, rule: str) -> int:
    """Steps that a frame really takes: its simulated time over the length of a step."""
    sim = Simulation(changed("r4", f"steps={rule}", f"frame_rate={float(1000.0 / milliseconds)!r}"))
    sim.advance_frames(1)
    return round(sim.time / sim.plan.dt)


def breaks_at_once(scene: Scene | None = None) -> Outcome:
    """C14. R6, recorded step by step on into the break."""
    scene = changed(scene or "r6", *STILL, "duration=0.2")
    run = record(scene, keep_going=True)
    stretch = run.stretch.max(axis=1)
    over = np.flatnonzero(stretch > 10.0)
    stood = int(over[0]) - 1 if over.size else len(stretch) - 1
    predicted = stability(scene)
    growth = float((stretch[6] - 1.0) / (stretch[5] - 1.0)) if len(stretch) > 6 else math.nan
    dt = run.dt
    # After one step only the springs at anchors are longer, by the fall g dt^2 of their one end;
    # each further step multiplies this by the growth of the fastest wave.
    seed = 0.5 * (G * dt * dt / L) ** 2
    expected = 1.0 + math.log(9.0 / seed) / math.log(max(predicted.growth_per_step, 1.0001))
    figure, ax = draw.axes()
    ax.semilogy(np.arange(len(stretch)), np.maximum(stretch - 1.0, 1e-9), "o-", color=draw.BLUE)
    ax.axhline(9.0, color=draw.RED, ls="--", lw=1.0)
    ax.text(7.5, 20.0, "ten times its length: broken", color=draw.RED)
    draw.label(ax, "step of 1/60 s", "largest strain (1)")
    return Outcome(
        measured=f"For {stood} steps ({1e3 * stood * dt:.0f} ms) no spring is ten times its length; "
        f"after one more the longest is {stretch[min(stood + 1, len(stretch) - 1)]:.3g} times its "
        f"length. In the break the stretch grows {growth:.0f}-fold a step.",
        theory=f"k dt²/m + 2 c dt/m is {K * dt * dt / M + 2 * C * dt / M:.1f}, far above 1: the "
        f"shortest wave grows {predicted.growth_per_step:.0f}-fold a step. From the first fall of "
        f"g dt² it reaches ten times a spring's length after {expected:.1f} steps.",
        parts=(
            Part("at one step a frame, 10 kN/m break quickly (within half a second)",
                 over.size > 0 and stood * dt < 0.5, (
                Number("steps that it stands", stood, expected, "1", 1.0, False,
                       "1 + ln(9 / ((g dt² / L)² / 2)) / ln(growth)"),
                Number("growth a step", growth, predicted.growth_per_step, "1", 0.25, True,
                       "largest root of z² - (2 - a - b) z + 1 - b"))),
        ),
        figure=figure,
        caption="Largest strain of any spring, step by step.",
    )  # fmt: skip
