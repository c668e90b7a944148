"""C4 to C7: spring friction."""

from __future__ import annotations

import math

import numpy as np

from ropewalk.core.arrays import Floats
from ropewalk.report import draw, formulas
from ropewalk.report.claims_model import C, G, M
from ropewalk.report.outcome import Number, Outcome, Part
from ropewalk.report.ringing import ring, short_wave_share
from ropewalk.report.runs import Run, changed, record
from ropewalk.scene import Scene, Springs

_FREE = 19  # free masses between two pins 20 springs apart


def never_rests(scene: Scene | None = None) -> Outcome:
    """C4. R3 without friction for two minutes; the report's own friction beside it."""
    base = changed("r3", "duration=120")
    run = record(scene or changed(base, "rope.made_of.spring_friction=0"))
    damped = record(base)
    quarter = len(run.time) // 4
    drift = float(run.total[-quarter:].mean() - run.total[:quarter].mean())
    # The scheme keeps H + (dt/2) F.v to the next order (Hairer, Lubich and Wanner, ch. IX), so the
    # energy itself goes up and down by (dt/2) F.v, and F.v is the rate of the kinetic energy.
    kept = run.total + 0.5 * run.dt * _power(run)
    ripple = float(np.abs(run.total).max())
    expected = float(0.5 * run.dt * np.abs(_power(run)).max())
    late = float(run.speed[-quarter:].max())
    early = float(run.speed[:quarter].max())
    fall = float(-run.energy[:, 1].min())
    figure, (top, bottom) = draw.axes(1, 2, 4.2, sharex=True)
    for one, colour, name in ((run, draw.BLUE, "no friction"), (damped, draw.ORANGE, "c = 0.05")):
        top.plot(one.time, one.energy[:, 0], color=colour, lw=0.6, label=name)
    draw.legend(top, loc="upper right", ncols=2)
    top.set_ylim(0.0, 1.35 * float(run.energy[:, 0].max()))
    draw.label(top, "", "kinetic energy (J)")
    bottom.plot(run.time, run.total, color=draw.BLUE, lw=0.5)
    draw.label(bottom, "time (s)", "total energy, no friction (J)")
    return Outcome(
        measured=f"Without friction the rope still moves at up to {late:.2f} m/s after 90 to 120 s "
        f"({early:.2f} m/s in the first 30 s). Its total energy strays by at most "
        f"{1e3 * ripple:.0f} mJ of the {fall:.1f} J of the fall and drifts by "
        f"{1e3 * drift:.2f} mJ.",
        theory="Without friction energy is conserved. Semi-implicit Euler conserves a neighbouring "
        "energy, so the true one goes up and down by dt/2 times the rate of the kinetic energy, "
        "without a trend.",
        parts=(
            Part("without friction the rope does not come to rest", late > 0.5 * early,
                 (Number("drift of the mean energy", drift, 0.0, "J", 0.002 * fall, False,
                         "last quarter less first; 0"),)),
        ),
        figure=figure,
        caption="Kinetic energy of the dropped rope with and without friction, and total energy "
        "without.",
        checks=(Number("largest stray of the energy", ripple, expected, "J", 0.2, True,
                       "dt/2 max |F·v|, leading order"),
                Number("stray of the neighbouring energy", float(np.abs(kept).max()), 0.0, "J",
                       0.2 * ripple, False, "H + (dt/2) F·v, to the next order"),),
    )  # fmt: skip


def _power(run: Run) -> Floats:
    """Power of weight and springs on the moving masses [W], (f,)."""
    made_of = run.scene.ropes[0].made_of
    k = made_of.spring_constant if isinstance(made_of, Springs) else math.nan
    d, dv = np.diff(run.x, axis=1), np.diff(run.v, axis=1)
    r = np.linalg.norm(d, axis=2)
    springs = -(k * (r - run.rest) / r * (d * dv).sum(axis=2)).sum(axis=1)
    weight = (run.mass * (run.v @ np.array(run.scene.gravity))).sum(axis=1)
    return np.asarray(springs + weight)


def comes_to_rest(friction: float = C) -> Outcome:
    """C5. Decay of single waves, then the whole main scene for ten minutes."""
    ringing = ring(friction, 60.0)
    times = 1.0 / ringing.rates
    numbers = tuple(
        Number(f"decay time of wave {j}", float(times[j - 1]),
               formulas.decay_time(j, _FREE, M, C), "s", 0.02, True,
               "2 m / (c μ), μ = 4 sin²(j π / (2 (n + 1)))")
        for j in (1, 2, 3)
    )  # fmt: skip
    long = record(changed("r4", "duration=600", "frame_rate=10",
                          f"rope.made_of.spring_friction={friction}"))  # fmt: skip
    speeds = [float(long.speed[long.at(t) : long.at(t + 10)].max()) for t in (10, 60, 300, 590)]
    figure, (left, right) = draw.axes(2, 1, 3.2)
    for j, colour in ((1, draw.BLUE), (2, draw.ORANGE), (3, draw.GREEN)):
        left.plot(ringing.run.time, 1e3 * ringing.amplitude[:, j - 1] + 30 * (2 - j),
                  color=colour, lw=0.6, label=f"wave {j}")  # fmt: skip
        envelope = 10 * np.exp(-ringing.run.time / formulas.decay_time(j, _FREE, M, C))
        left.plot(ringing.run.time, envelope + 30 * (2 - j), "--", color="black", lw=0.8)
    left.set_yticks([30, 0, -30], ["wave 1", "wave 2", "wave 3"])
    draw.label(left, "time (s)", "10 mm at the start", "Single waves, theory dashed")
    peaks = _peaks(long, 5.0)
    right.semilogy(peaks[0], peaks[1], color=draw.BLUE)
    draw.label(right, "time (s)", "fastest node (m/s)", "Main scene, 5 s windows")
    return Outcome(
        measured=f"Sideways waves of the taut section die down in {times[0]:.1f}, {times[1]:.1f} "
        f"and {times[2]:.2f} s (to 1/e). The fastest node of the main scene does "
        f"{speeds[0]:.2f} m/s after 10 s, {speeds[1]:.2f} after a minute, {speeds[2]:.3f} after "
        f"five minutes and {speeds[3]:.4f} after ten.",
        theory="A wave of j half loops on n free masses falls as exp(-c μ t / (2 m)): "
        + ", ".join(f"{n.theory:.2f}" for n in numbers)
        + " s for the three longest here; short waves go first.",
        parts=(
            Part("spring friction takes the waves away", bool(np.all(ringing.rates > 0.0)),
                 numbers),
            Part("in the end the rope rests (below 1 cm/s after ten minutes)", speeds[3] < 0.01),
        ),
        figure=figure,
        caption="Left: three waves of the taut section, with the predicted envelopes. Right: the "
        "main scene.",
        note="At the report's friction the slowest waves take minutes: a picture after a few "
        "seconds shows a rope that is still moving.",
    )  # fmt: skip


def _peaks(run: Run, window: float) -> tuple[list[float], list[float]]:
    """Fastest node in windows of `window` seconds: times [s] and speeds [m/s]."""
    edges = np.arange(0.0, run.time[-1], window)
    speeds = [float(run.speed[run.at(t) : run.at(t + window)].max()) for t in edges]
    return [float(t + window / 2) for t in edges], speeds


def like_air() -> Outcome:
    """C6. A rope that falls freely, and a pair of masses that turns freely."""
    fall = changed("r2", "duration=1", "rope.made_of.spring_friction=1")
    free = _without_anchors(fall)
    air = _without_anchors(changed(fall, "rope.made_of.spring_friction=0", "air.node_drag=0.05"))
    in_springs, in_air = record(free), record(air)
    speed, air_speed = (-float(run.v[-1, 0, 1]) for run in (in_springs, in_air))
    air_theory = M * G / 0.05 * -math.expm1(-0.05 / M)
    turning = {name: record(_pair(name)) for name in ("vector", "axial")}
    spin = {name: _spin(run) for name, run in turning.items()}
    kept = float(spin["vector"][-1])
    expected = math.exp(-2.0 * C / M)
    figure, (left, right) = draw.axes(2, 1, 3.2)
    left.plot(in_springs.time, -in_springs.v[:, 0, 1], color=draw.BLUE, lw=3, alpha=0.5,
              label="spring friction, 1 N s/m")  # fmt: skip
    left.plot(in_air.time, -in_air.v[:, 0, 1], color=draw.ORANGE, label="air, 0.05 N s/m")
    left.plot(in_springs.time, G * in_springs.time, "k--", lw=0.9, label="g t")
    draw.legend(left, loc="upper left")
    draw.label(left, "time (s)", "speed of fall (m/s)", "Falling")
    time = turning["vector"].time
    right.plot(time, spin["vector"], color=draw.BLUE, label="the report's friction")
    right.plot(time, spin["axial"], color=draw.GREEN, label="friction along the spring only")
    right.plot(time, np.exp(-2 * C * time / M), "k--", lw=0.9, label="exp(-2 c t / m)")
    right.set_ylim(0.0, 1.55)
    draw.legend(right, loc="upper right")
    draw.label(right, "time (s)", "angular momentum left (1)", "Turning")
    return Outcome(
        measured=f"A rope that nothing holds falls at {speed:.3f} m/s after 1 s, with twenty times "
        f"the report's spring friction; with air instead at {air_speed:.2f} m/s. A pair of masses "
        f"on one spring keeps {kept:.4f} of its turning after 1 s.",
        theory="Spring friction acts between masses: where all move alike it is zero and the rope "
        f"falls at g t = {G:.2f} m/s. Written with the whole difference of velocities it also "
        f"slows turning, as exp(-2 c t / m) = {expected:.4f}. Air would slow both.",
        parts=(
            Part("like air, it slows a fall", speed < 0.99 * G, (
                Number("speed with spring friction", speed, G, "m/s", 1e-9, True, "g t"),)),
            Part("like air, it slows turning", kept < 0.9, (
                Number("turning left", kept, expected, "1", 0.01, True, "exp(-2 c t / m)"),)),
        ),
        figure=figure,
        caption="Left: free fall with spring friction and with air. Right: a pair of masses that "
        "turns freely.",
        note="Friction projected on the spring, as other programs have it, keeps all of the "
        "turning.",
        checks=(
            Number("speed with air", air_speed, air_theory, "m/s", 0.005, True,
                   "(m g / c)(1 - exp(-c t / m))"),
            Number("turning left, axial friction", float(spin["axial"][-1]), 1.0, "1", 1e-9, True,
                   "conserved"),
        ),
    )  # fmt: skip


def _without_anchors(scene: Scene) -> Scene:
    return scene.model_copy(update={"anchors": ()})


def _pair(friction: str) -> Scene:
    """Two masses on one spring, turning about their middle at 2 rad/s, without weight."""
    base = changed(
        "r2", "rope.segments=1", "duration=1", "gravity=[0.0, 0.0, 0.0]",
        f"rope.made_of.friction={friction}",
    )  # fmt: skip
    data = base.model_dump(by_alias=True)
    data["rope"][0]["kick"] = [
        {"node": 0, "velocity": (0.0, -1.0, 0.0)},
        {"node": 1, "velocity": (0.0, 1.0, 0.0)},
    ]
    return _without_anchors(Scene.model_validate(data))


def _spin(run: Run) -> Floats:
    """Angular momentum about z over its first value [1], (f,)."""
    spin = (M * (run.x[..., 0] * run.v[..., 1] - run.x[..., 1] * run.v[..., 0])).sum(axis=1)
    return np.asarray(spin / spin[0])


def smaller_friction(frictions: tuple[float, ...] = (0.01, 0.05, 0.2, 1.0)) -> Outcome:
    """C7. The longest wave under four frictions, and how smooth the main scene moves."""
    rates = [float(ring(c, 60.0 if c < 0.5 else 20.0, modes=1).rates[0]) for c in frictions]
    numbers = tuple(
        Number(f"decay rate at c = {c:g}", rate, 1.0 / formulas.decay_time(1, _FREE, M, c), "1/s",
               0.02, True, "c μ / (2 m)")
        for c, rate in zip(frictions, rates, strict=True)
    )  # fmt: skip
    shares = []
    runs = []
    for c in frictions:
        run = record(changed("r4", "duration=30", f"rope.made_of.spring_friction={c}"))
        late = slice(run.at(10.0), None)
        runs.append(run)
        shares.append(short_wave_share(run.v[late], 20, 40))
    figure, (left, right) = draw.axes(2, 1, 3.2)
    left.loglog(frictions, rates, "o", color=draw.BLUE, label="run")
    line = np.array([frictions[0], frictions[-1]])
    left.loglog(line, line * formulas.mode(1, _FREE) / (2 * M), "k--", lw=0.9, label="c μ / (2 m)")
    draw.legend(left, loc="upper left")
    draw.label(left, "spring friction c (N s/m)", "decay rate (1/s)", "Longest wave")
    for run, c, colour in zip(runs, frictions, draw.SERIES, strict=False):
        peaks = _peaks(run, 1.0)
        right.semilogy(*peaks, color=colour, label=f"c = {c:g}")
    draw.legend(right, loc="lower left", ncols=2)
    draw.label(right, "time (s)", "fastest node (m/s)", "Main scene, 1 s windows")
    return Outcome(
        measured="The longest wave decays at "
        + ", ".join(f"{rate:.4g}" for rate in rates)
        + " per second for c = "
        + ", ".join(f"{c:g}" for c in frictions)
        + f" N s/m. From 10 to 30 s the short waves carry {100 * shares[0]:.2g} % of the motion at "
        f"c = {frictions[0]:g} and {100 * shares[1]:.2g} % at c = {frictions[1]:g}.",
        theory="The decay rate c μ / (2 m) is proportional to c, and μ makes short waves decay "
        "up to 160 times faster than the longest: less friction leaves more of them.",
        parts=(
            Part("less friction, much less decay", rates[0] < 0.5 * rates[1], numbers),
            Part("with less friction the motion is less smooth", shares[0] > 1.2 * shares[1]),
        ),
        figure=figure,
        caption="Left: decay rate against friction. Right: the main scene with four frictions.",
    )
