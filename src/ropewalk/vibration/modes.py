"""Natural modes of a scene: frequencies, shapes, damping, and what each of them is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from ropewalk.build import Layout, Model, build
from ropewalk.core.arrays import BENDING, Floats
from ropewalk.scene import Scene
from ropewalk.statics import checked_shape
from ropewalk.vibration.drawing import ModePlots
from ropewalk.vibration.linear import linearise
from ropewalk.vibration.motion import Motion, motions, plane_normal
from ropewalk.vibration.solve import Complex, highest, solve, untangle

About = Literal["equilibrium", "start"]


@dataclass(frozen=True)
class Modes:
    """Modes of a scene about a shape, the slowest first. Angular rates in 1/s, frequencies in Hz."""

    scene: Scene
    layout: Layout
    about: str  # "equilibrium" or "start"
    positions: Floats  # (n, 3) the shape they are about [m]
    eigenvalues: Complex  # (m,) l of u ~ exp(l t) [1/s], imaginary part not negative
    shapes: Complex  # (m, n, 3) displacements, the largest of a mode 1 and real
    motions: tuple[Motion, ...]  # what moves how

    @property
    def count(self) -> int:
        """Number of modes."""
        return len(self.eigenvalues)

    @property
    def frequencies(self) -> Floats:
        """Frequencies at which the modes ring [Hz], (m,), damped; 0 for one that does not."""
        return np.asarray(self.eigenvalues.imag / (2.0 * np.pi))

    @property
    def natural_frequencies(self) -> Floats:
        """Undamped frequencies, the size of l over 2 pi [Hz], (m,)."""
        return np.asarray(np.abs(self.eigenvalues) / (2.0 * np.pi))

    @property
    def decay_rates(self) -> Floats:
        """Rates at which the modes die down [1/s], (m,); negative for one that grows."""
        return np.asarray(0.0 - self.eigenvalues.real)

    @property
    def damping_ratios(self) -> Floats:
        """Decay rate over the size of l [1], (m,); 1 for a mode that creeps without ringing."""
        size = np.abs(self.eigenvalues)
        return np.divide(self.decay_rates, size, out=np.zeros_like(size), where=size > 0.0)

    @cached_property
    def table(self) -> list[dict[str, Any]]:
        """One row for each mode: number, frequency [Hz], damping, decay, motion."""
        rows = []
        for i, motion in enumerate(self.motions):
            rows.append(
                {
                    "mode": i + 1,
                    "frequency [Hz]": float(self.frequencies[i]),
                    "natural frequency [Hz]": float(self.natural_frequencies[i]),
                    "damping ratio [1]": float(self.damping_ratios[i]),
                    "decay rate [1/s]": float(self.decay_rates[i]),
                    "motion": motion.name,
                    "half waves": motion.half_waves,
                    "rope": motion.rope,
                }
            )
        return rows

    @property
    def plot(self) -> ModePlots:
        """Figures: `modes.plot.mode_shapes()`."""
        return ModePlots(self)

    def __repr__(self) -> str:
        shown = ", ".join(f"{f:.4g}" for f in self.frequencies[:5])
        more = ", ..." if self.count > 5 else ""
        return f"Modes of {self.scene.name!r} about its {self.about}: {shown}{more} Hz."


def modes(source: Scene | Model, about: About = "equilibrium", count: int = 10) -> Modes:
    """Return the slowest modes of a scene or a built model.

    Raises SceneError for a scene that has no rest shape (about "equilibrium"), ValueError for another
    word and for a count below 1.
    """
    if about not in ("equilibrium", "start"):
        raise ValueError(f'about: {about!r} - must be "equilibrium" or "start"')
    if count < 1:
        raise ValueError(f"count: {count!r} - must be at least 1")
    model = source if isinstance(source, Model) else build(source)
    x, tension = shape_about(model, about)
    linear = linearise(model, x, tension)
    values, flat = solve(linear, count)
    normal = plane_normal(model, x)
    if linear.symmetric and not linear.has_friction:
        squares = np.where(values.imag > 0.0, values.imag**2, -(values.real**2))
        aside = np.tile(normal, linear.nodes.size)
        flat = untangle(squares, flat.real, linear.mass, aside).astype(complex)
    shapes = np.zeros((len(values), x.shape[1], 3), dtype=complex)
    shapes[:, linear.nodes] = flat.reshape(len(values), linear.nodes.size, 3)
    return Modes(
        scene=model.scene,
        layout=model.layout,
        about=about,
        positions=np.ascontiguousarray(x.T),
        eigenvalues=values,
        shapes=_scaled(shapes),
        motions=motions(model, x, _scaled(shapes), normal),
    )


def highest_frequency(model: Model, x: Floats, tension: Floats) -> float | None:
    """Return the highest frequency of the springs about places (3, n) [m] under tensions (s,) [N].

    In rad/s. None where other laws stiffen the ropes, too: ground and bending.
    """
    if model.system.ground.active or model.system.flags[BENDING]:
        return None
    linear = linearise(model, x, tension, springs_only=True)
    return highest(linear) if linear.nodes.size else 0.0


def shape_about(model: Model, about: About) -> tuple[Floats, Floats]:
    """Return the places (3, n) [m] and tensions (s,) [N] of the shape that modes are about."""
    if about == "equilibrium":
        statics = checked_shape(model)
        return np.ascontiguousarray(statics.positions.T), statics.tension
    state = model.state
    r = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0))
    k = np.where(np.isinf(state.stiffness), 0.0, state.stiffness)
    return state.x.copy(), np.maximum(k * (r - state.rest_length), model.system.slack_floor)


def _scaled(shapes: Complex) -> Complex:
    """Scale every mode so that its largest displacement is 1, real, and positive in its largest part."""
    out = shapes.copy()
    for shape in out:
        sizes = np.sqrt((np.abs(shape) ** 2).sum(axis=1))
        node = int(np.argmax(sizes > (1.0 - 1e-6) * sizes.max()))
        part = shape[node, int(np.argmax(np.abs(shape[node])))]
        if part != 0.0:
            shape *= abs(part) / part / sizes[node]
    return out
