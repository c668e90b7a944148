"""C10 to C13: bounce, loops and waves."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.report import draw, formulas, words
from ropewalk.report.claims_model import G, K, L, M
from ropewalk.report.outcome import Number, Outcome, Part
from ropewalk.report.runs import Run, at_rest, changed, record
from ropewalk.scene import Scene
from ropewalk.statics import Statics, static_shape

SPAN = 20.0  # [m] and springs between two anchors
STILL = ("anchor.left.motion.kind=fixed",)


def bounce(constants: tuple[float, ...] = (K, 200.0, 100.0, 50.0)) -> Outcome:
    """C10. The three-anchor rope dropped from the horizontal, at the report's step."""
    runs = [
        record(changed("r4", *STILL, "duration=30", "steps=exact", "frame_rate=250",
                       f"rope.made_of.spring_constant={k}"))
        for k in constants
    ]  # fmt: skip
    found = [run.largest_stretch for run in runs]
    theory = [1.0 + formulas.bounce_strain(k, M, L, G, SPAN) for k in constants]
    numbers = tuple(
        Number(f"largest strain at {k:g} N/m", 100 * (a - 1), 100 * (b - 1), "%", 0.25, True,
               "one-arch energy balance, k (e L)² / 2 = (2/3) m g d")
        for k, a, b in zip(constants, found, theory, strict=True)
    )  # fmt: skip
    figure, (left, right) = draw.axes(2, 1, 3.2)
    left.loglog(constants, [100 * (a - 1) for a in found], "o", color=draw.BLUE, label="run")
    fine = np.geomspace(min(constants) * 0.8, max(constants) * 1.25, 50)
    left.loglog(fine, [100 * formulas.bounce_strain(k, M, L, G, SPAN) for k in fine], "k--",
                lw=0.9, label="energy balance")  # fmt: skip
    draw.legend(left)
    draw.label(left, "spring constant (N/m)", "largest strain (%)", "Largest stretch in the fall")
    for run, k, colour in zip(runs, constants, draw.SERIES, strict=False):
        shown = run.time <= 12.0
        right.plot(run.time[shown], run.x[shown, 10, 1], color=colour, lw=1.1, label=f"{k:g} N/m")
    right.set_ylim(top=5.2)
    draw.legend(right, ncols=2, loc="upper right", fontsize=8)
    draw.label(right, "time (s)", "height of the middle (m)", "Middle of a section")
    order = np.argsort(constants)
    return Outcome(
        measured="Dropped from the horizontal, the springs stretch to at most "
        + ", ".join(f"{a:.3f}" for a in found)
        + " of their length for "
        + ", ".join(f"{k:g}" for k in constants)
        + " N/m.",
        theory="The weight's work in the fall goes into the springs. For one arch this gives "
        "strains that fall with k, nearly as k^(-2/3): "
        + ", ".join(f"{100 * (b - 1):.2g} %" for b in theory)
        + ".",
        parts=(Part("stiffer springs bounce less",
                    bool(np.all(np.diff(np.array(found)[order]) < 0.0)), numbers),
               Part("with 10 kN/m the rope hardly stretches (less than 2 %)", found[0] < 1.02)),
        figure=figure,
        caption="Left: largest strain of any spring. Right: the middle of a section as it falls "
        "and bounces.",
        note="The energy balance takes one arch and even strain; a quarter is allowed between it "
        "and the run.",
    )  # fmt: skip


def settled(k: float, friction: float = 1.0) -> Run:
    """Let R3 come to rest under a friction that does it in a minute and a half."""
    return record(changed("r3", "duration=100", "frame_rate=10", f"rope.made_of.spring_constant={k}",
                          f"rope.made_of.spring_friction={friction}"))  # fmt: skip


def sag(run: Run) -> float:
    """Depth of the lowest node below the pins in the last frame [m]."""
    return float(-run.x[-1, :, 1].min())


def shallow_loop(scene_constant: float = K) -> Outcome:
    """C11. The taut section settles under 20 times the report's friction."""
    run = settled(scene_constant)
    statics = static_shape(changed("r3"))
    depth, pull = formulas.shallow_sag(K, M, L, G, SPAN)
    found, horizontal = sag(run), _horizontal(run)
    figure, ax = draw.axes()
    x = statics.positions
    ax.plot(x[:, 0], x[:, 1], "-", color="#9ec8e6", lw=5, label="static shape")
    ax.plot(run.x[-1, :, 0], run.x[-1, :, 1], "o", color=draw.BLUE, ms=3.5, label="run at rest")
    fine = np.linspace(0.0, SPAN, 200)
    ax.plot(fine, -4 * depth * fine * (SPAN - fine) / SPAN**2, "k--", lw=0.9, label="parabola")
    draw.label(ax, "x (m)", "height (m), stretched", "")
    draw.below(ax)
    return Outcome(
        measured=f"The section of {SPAN:g} springs over {SPAN:g} m settles {found:.4f} m deep, "
        f"{100 * found / SPAN:.1f} % of its span, under a horizontal pull of {horizontal:.2f} N.",
        theory=f"The exact chain of masses and springs hangs {statics.sag[0]:.4f} m deep under "
        f"{statics.spans[0].horizontal:.2f} N; the parabola gives {depth:.3f} m and {pull:.2f} N.",
        parts=(
            Part("the taut section forms a loop", found > 0.0, (
                Number("sag", found, statics.sag[0], "m", 1e-5, True, "exact elastic chain"),
                Number("horizontal pull", horizontal, statics.spans[0].horizontal, "N", 1e-5, True,
                       "exact elastic chain"))),
            Part("the loop is shallow (below a tenth of the span)", found < 0.1 * SPAN, (
                Number("sag", found, depth, "m", 0.01, True,
                       "(m g / L) S² / (8 H), H³ = k L (m g / L)² S² / 24"),)),
        ),
        figure=figure,
        caption="The taut section at rest; heights are drawn larger than lengths.",
    )  # fmt: skip


def _horizontal(run: Run) -> float:
    """Horizontal pull in the first spring of the last frame [N]."""
    d = run.x[-1, 1] - run.x[-1, 0]
    return float(run.tension[-1, 0] * d[0] / np.linalg.norm(d))


def curvature(constants: tuple[float, ...] = (K, 3000.0, 1000.0, 300.0, 100.0)) -> Outcome:
    """C12. The same section with several spring constants; curvature = w / H at the bottom."""
    runs = [settled(k) for k in constants]
    sags = [sag(run) for run in runs]
    bends = [M * G / L / _horizontal(run) for run in runs]
    theory = [static_shape(changed("r3", f"rope.made_of.spring_constant={k}")) for k in constants]
    slope = float(np.polyfit(np.log(constants[:3]), np.log(sags[:3]), 1)[0])
    bend_slope = float(np.polyfit(np.log(constants[:3]), np.log(bends[:3]), 1)[0])
    figure, (left, right) = draw.axes(2, 1, 3.2)
    for run, k, colour in zip(runs, constants, draw.SERIES, strict=False):
        left.plot(run.x[-1, :, 0], run.x[-1, :, 1], color=colour, label=f"{k:g} N/m")
    draw.legend(left, loc="upper center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    left.set_ylim(top=1.6)
    draw.label(left, "x (m)", "height (m)", "At rest")
    right.loglog(constants, sags, "o", color=draw.BLUE, label="run")
    line = np.geomspace(min(constants), max(constants), 20)
    right.loglog(line, [formulas.shallow_sag(k, M, L, G, SPAN)[0] for k in line], "k--", lw=0.9,
                 label="∝ k^(-1/3)")  # fmt: skip
    draw.legend(right)
    draw.label(right, "spring constant (N/m)", "sag (m)", "Sag")
    return Outcome(
        measured="The section sags "
        + ", ".join(f"{depth:.3f}" for depth in sags)
        + " m for "
        + ", ".join(f"{k:g}" for k in constants)
        + f" N/m: as k to the power {slope:.3f} from 1 to 10 kN/m; its curvature at the bottom as "
        f"k to the power {bend_slope:.3f}.",
        theory="The chain's exact rest shapes; for shallow loops sag and curvature go as "
        "k^(-1/3).",
        parts=(
            Part("the curvature depends on the spring constant",
                 bool(np.all(np.diff(np.array(bends)[np.argsort(constants)]) < 0.0)), (
                *(Number(f"sag at {k:g} N/m", depth, exact.sag[0], "m", 1e-4, True,
                         "exact elastic chain")
                  for k, depth, exact in zip(constants, sags, theory, strict=True)),
                Number("exponent of the sag", slope, -1 / 3, "1", 0.01, False, "-1/3"),
                Number("exponent of the curvature", bend_slope, -1 / 3, "1", 0.01, False,
                       "-1/3"))),
        ),
        figure=figure,
        caption="Left: rest shapes, heights drawn larger than lengths. Right: sag against spring constant.",
    )  # fmt: skip


def waves(scene: Scene | None = None) -> Outcome:
    """C13. A sideways tug at the taut section's end, and the moved loop of the main scene."""
    run, statics = _tugged()
    near, far = 4, 14
    lag = _lag(run, near, far)
    speeds = np.sqrt(statics.tension * statics.stretch * L / M)  # along the stretched rope
    expected = float((statics.stretch[near:far] * L / speeds[near:far]).sum())
    main = record(scene or at_rest(changed("r4", "duration=120"))[0])
    size = [_wave_energy(main, 3.5, 5.5), _wave_energy(main, 0.0, 0.5)]
    later = _wave_energy(main, 60.0, 62.0)
    last = _wave_energy(main, 118.0, 120.0)
    figure, (left, right) = draw.axes(2, 1, 3.4)
    for node, offset in ((4, 0), (9, 1), (14, 2)):
        left.plot(run.time, 100 * run.x[:, node, 2] + 4 * offset, color=draw.SERIES[offset],
                  label=f"node {node}")  # fmt: skip
    left.set_ylim(-4.0, 16.0)
    draw.legend(left, loc="upper center", ncols=3, fontsize=8)
    draw.label(left, "time (s)", "sideways (cm), nodes set apart", "A tug runs along the rope")
    grid = np.arange(0.0, min(main.time[-1], 119.0), 1.0)
    right.semilogy(grid, [_wave_energy(main, t, t + 1.0) for t in grid], color=draw.BLUE)
    right.axvspan(0.5, 3.5, color="#f3e3d3")
    right.text(5.0, 0.94, "left anchor moves in the shaded time", fontsize=8,
               transform=right.get_xaxis_transform(), va="top")  # fmt: skip
    draw.label(right, "time (s)", "kinetic energy of the left loop (J)", "Main scene, 1 s means")
    return Outcome(
        measured=f"A sideways tug passes the {far - near} springs from node {near} to {far} in "
        f"{1e3 * lag:.0f} ms. In the main scene, started at rest, the left loop moves with "
        f"{words.value(size[1], 'J')} before its anchor moves, {size[0]:.2f} J in the two seconds "
        f"after it stops, {later:.3f} J after one minute and {last:.4f} J after two.",
        theory=f"Waves run at √(T/μ), {float(speeds[near:far].mean()):.1f} m/s here: "
        f"{1e3 * expected:.0f} ms. They fall by 1/e in 2 m / (c μ_j) each (C5).",
        parts=(
            Part("moving the left point makes waves that run along the rope", size[0] > 0.01 + 2 * size[1],
                 (Number("time from node to node", 1e3 * lag, 1e3 * expected, "ms", 0.05, True,
                         "sum of length / √(T/μ)"),)),
            Part("the waves die down slowly", last < later < 0.5 * size[0]),
        ),
        figure=figure,
        caption="Left: a tug at the left end of the taut section at three nodes. Right: motion of "
        "the left loop.",
    )  # fmt: skip


def _tugged() -> tuple[Run, Statics]:
    """R3 at rest, its left pin pulled 2 cm sideways and back in 0.24 s."""
    scene, statics = at_rest(changed("r3", "steps=exact", "frame_rate=500", "duration=1.2"))
    times = np.linspace(0.0, 0.24, 13)
    side = 0.02 * np.sin(np.pi * times / 0.24) ** 2
    table = scene.table()
    table["anchor"][0]["motion"] = {
        "kind": "table",
        "times": times.tolist(),
        "positions": [[0.0, 0.0, float(z)] for z in side],
        "interpolation": "cubic",
    }
    return record(Scene.model_validate(table)), statics


def _lag(run: Run, near: int, far: int) -> float:
    """Delay of the tug between two nodes, from the largest correlation before it comes back [s]."""
    dt = float(run.time[1] - run.time[0])
    first = run.x[: run.at(0.5), near, 2]
    best = [float((first * run.x[shift : shift + len(first), far, 2]).sum())
            for shift in range(run.at(0.5))]  # fmt: skip
    i = int(np.argmax(best))
    a, b, c = best[i - 1], best[i], best[i + 1]
    return dt * (i + 0.5 * (a - c) / (a - 2 * b + c))


def _wave_energy(run: Run, start: float, end: float) -> float:
    """Mean kinetic energy of the left loop's free nodes between two times [J]."""
    part: Floats = run.v[run.at(start) : run.at(end), 1:20]
    return float(0.5 * M * (part**2).sum() / max(len(part), 1)) if len(part) else math.nan
