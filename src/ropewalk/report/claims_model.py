"""C1 to C3: the model of masses and springs."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.report import draw, formulas, words
from ropewalk.report.outcome import Number, Outcome, Part
from ropewalk.report.runs import Run, changed, record
from ropewalk.scene import Scene
from ropewalk.simulation import Simulation

K, M, C, L, G = 10000.0, 0.05, 0.05, 1.0, 9.81  # the report's table, and gravity


def one_spring(scene: Scene | None = None) -> Outcome:
    """C1. From three frames in a row: y[i+1] = p y[i] - q y[i-1] + r, fitted over the run."""
    run = record(scene or changed("r1"))
    y, dt = run.x[:, 1, 1], run.dt
    p, q, middle = _recurrence(y)
    factor = math.sqrt(q)
    omega = math.acos(p / (2.0 * factor)) / dt
    stretch = -middle - float(run.rest[0])
    exact = formulas.scheme_frequency(K, M, C, dt)
    natural = math.sqrt(K / M)
    frequency = Number(
        "frequency of the run", omega, exact, "rad/s", 1e-6, True,
        "cos(ω dt) = (2 - a - b) / (2 √(1 - b)), a = k dt²/m, b = c dt/m",
    )  # fmt: skip
    decay = Number(
        "swing left after a step", factor, formulas.scheme_factor(M, C, dt), "1", 1e-7, True,
        "√(1 - c dt/m)",
    )  # fmt: skip
    rest = Number("stretch at rest", 1e6 * stretch, 1e6 * M * G / K, "µm", 1e-4, True, "m g / k")
    figure, ax = draw.axes()
    shown = run.time <= 0.06
    fine = np.linspace(0.0, 0.06, 600)
    still = M * G / K
    ax.plot(
        1e3 * fine,
        -1e6 * still * (1.0 - np.exp(-C * fine / (2 * M)) * np.cos(natural * fine)),
        color=draw.GREY,
        lw=1.0,
        label="exact motion, 447.2 rad/s",
    )
    ax.plot(
        1e3 * run.time[shown], 1e6 * (y[shown] + L), ".-", color=draw.BLUE, lw=0.8,
        label=f"run, {omega:.2f} rad/s",
    )  # fmt: skip
    ax.axhline(-1e6 * still, color=draw.ORANGE, ls="--", label="at rest, m g / k")
    draw.label(ax, "time (ms)", "height above rest length (µm)")
    draw.below(ax)
    return Outcome(
        measured=f"One mass of 50 g on one spring swings at {omega:.2f} rad/s about a stretch of "
        f"{1e6 * stretch:.2f} µm and keeps {factor:.6f} of its swing from step to step.",
        theory=f"The exact motion has √(k/m) = {natural:.2f} rad/s. At a step of "
        f"{1e3 * dt:g} ms the scheme itself swings at {exact:.2f} rad/s, "
        f"{100 * (exact / natural - 1):.1f} % faster.",
        parts=(
            Part("one mass on a spring swings, at the frequency of the scheme",
                 abs(omega / natural - 1.0) < 0.05, (frequency,)),
            Part("friction takes the swing away", factor < 1.0, (decay,)),
            Part("it comes to rest where spring and weight balance", stretch > 0.0, (rest,)),
        ),
        figure=figure,
        caption="One mass on a spring: the run's steps, the exact motion and the place of rest.",
        note="The step of 2 ms sees this motion with only 6.8 steps a period; hence the 3.7 %.",
    )  # fmt: skip


def _recurrence(y: Floats) -> tuple[float, float, float]:
    """Fit y[i+1] = p y[i] - q y[i-1] + r and return p, q and the fixed point."""
    scale = float(np.ptp(y))
    z = (y - y.mean()) / scale
    columns = np.stack([z[1:-1], -z[:-2], np.ones(len(z) - 2)], axis=1)
    p, q, r = np.linalg.lstsq(columns, z[2:], rcond=None)[0]
    return float(p), float(q), float(y.mean() + scale * r / (1.0 - p + q))


def two_springs(friction: float = 20.0) -> Outcome:
    """C2. A rope of 20 springs hangs; the friction is raised so that it settles in seconds."""
    base = changed(
        "r2", "rope.shape.kind=hanging", f"rope.made_of.spring_friction={friction}",
        "time_step=0.0005", "duration=25",
    )  # fmt: skip
    stiff, soft = (record(changed(base, f"rope.made_of.spring_constant={k}")) for k in (K, 100.0))
    n = 20
    longer = [-(run.x[-1, -1, 1]) - n * L for run in (stiff, soft)]
    each = 1e3 * (run_lengths(stiff) - L)
    below = np.arange(n, 0, -1)
    expected = 1e3 * below * M * G / K
    worst = float(np.abs(each - expected).max())
    left_over = _net_force_left_over()
    figure, ax = draw.axes()
    ax.barh(below, expected, color="#cfe3f1", height=0.8, label="theory, j m g / k")
    ax.plot(each, below, "o", color=draw.BLUE, ms=4, label="run")
    ax.grid(axis="y", visible=False)
    ax.set_yticks([1, 5, 10, 15, 20])
    draw.label(ax, "stretch of the spring (mm)", "spring, counted from below")
    draw.below(ax)
    return Outcome(
        measured=f"Hanging still, 20 springs of 10 kN/m are {1e3 * longer[0]:.2f} mm longer than "
        f"at rest length; 20 of 100 N/m are {longer[1]:.3f} m longer. In motion, mass times "
        "acceleration equals weight plus both springs to "
        f"{words.value(left_over, '1')} of the weight.",
        theory="Spring j from below carries j masses, so it stretches by j m g / k and the rope by "
        f"m g n (n + 1) / (2 k): {1e3 * formulas.hanging_stretch(n, K, M, G):.2f} mm and "
        f"{formulas.hanging_stretch(n, 100.0, M, G):.3f} m.",
        parts=(
            Part("the net force is weight plus the two neighbouring springs (and their friction)",
                 left_over < 1e-6,
                 (Number("force left over, of the weight", left_over, 0.0, "1", 1e-6, False,
                         "m a - m g - springs - friction = 0"),)),
            Part("at rest every spring carries what hangs below it", worst < 1e-3,
                 (Number("longer by, 10 kN/m", 1e3 * longer[0],
                         1e3 * formulas.hanging_stretch(n, K, M, G), "mm", 1e-5, True,
                         "m g n (n + 1) / (2 k)"),
                  Number("longer by, 100 N/m", longer[1],
                         formulas.hanging_stretch(n, 100.0, M, G), "m", 1e-5, True,
                         "m g n (n + 1) / (2 k)"),
                  Number("worst spring of 20", worst, 0.0, "mm", 1e-4, False, "j m g / k"))),
        ),
        figure=figure,
        caption="Stretch of each spring of a rope of 20 that hangs still (10 kN/m).",
        note="The report lists no friction of 20 N s/m; it only hastens the rest, which does not "
        "depend on it.",
    )  # fmt: skip


def run_lengths(run: Run) -> Floats:
    """Lengths of the springs in the last frame [m]."""
    return np.asarray(np.linalg.norm(np.diff(run.x[-1], axis=0), axis=1))


def _net_force_left_over() -> float:
    """Largest |m dv/dt - m g - springs - friction| over m g in one step of a swinging rope [1]."""
    sim = Simulation(changed("r2"), ledger=False)
    sim.step(1.0)
    x, v = sim.positions.copy(), sim.velocities.copy()
    dt = sim.plan.dt
    sim.step(dt)
    d, dv = np.diff(x, axis=0), np.diff(v, axis=0)
    r = np.linalg.norm(d, axis=1)[:, None]
    pull = K * (r - L) * d / r + C * dv
    net = M * np.array([0.0, -G, 0.0]) + np.zeros_like(x)
    net[:-1] += pull
    net[1:] -= pull
    change = M * (sim.velocities - v) / dt
    return float(np.abs(change - net)[1:].max() / (M * G))


def only_gravity(scene: Scene | None = None) -> Outcome:
    """C3. The first step of the main scene."""
    run = record(changed(scene or "r4", "steps=exact", "frame_rate=500", "duration=0.1"))
    held = [0, 20, 40]
    free = np.setdiff1d(np.arange(run.x.shape[1]), held)
    first = run.v[1] / run.dt
    down, sideways = first[free, 1], np.abs(first[free][:, [0, 2]]).max()
    figure, ax = draw.axes()
    for step, colour in ((1, draw.BLUE), (10, draw.ORANGE), (40, draw.GREEN)):
        acceleration = (run.v[step, :, 1] - run.v[step - 1, :, 1]) / run.dt
        ax.plot(acceleration, ".-", color=colour, lw=0.9, label=f"step {step}")
    ax.axhline(-G, color=draw.GREY, ls="--", lw=1.0, label="-g")
    draw.label(ax, "node", "vertical acceleration (m/s²)")
    draw.below(ax, 4)
    return Outcome(
        measured=f"In the first step all {len(free)} free masses accelerate by "
        f"{down.min():.6f} to {down.max():.6f} m/s², sideways by at most "
        f"{words.value(float(sideways), 'm/s²')}.",
        theory="At rest length no spring pulls and nothing moves: the acceleration is -g alone, "
        "and the step gives it exactly.",
        parts=(
            Part("only gravity acts at the start", sideways < 1e-12, (
                Number("least acceleration", float(down.min()), -G, "m/s²", 1e-12, True, "-g"),
                Number("largest acceleration", float(down.max()), -G, "m/s²", 1e-12, True, "-g"),
                Number("sideways", float(sideways), 0.0, "m/s²", 1e-12, False, "0"))),
        ),
        figure=figure,
        caption="Acceleration along the rope: -g everywhere at first, then the pull of the "
        "anchors travels inward.",
    )  # fmt: skip
