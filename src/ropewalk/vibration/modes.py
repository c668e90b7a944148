"""Natural modes of a scene: frequencies, shapes, damping, and what each of them is."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from ropewalk.core import arrays
from ropewalk.core.arrays import BENDING, Floats
from ropewalk.core.elimination import tied_network
from ropewalk.core.saddle import make_saddle
from ropewalk.display import cells
from ropewalk.laws.acting import at_rest, relaxed
from ropewalk.laws.node_law import Rest
from ropewalk.lowering import Layout, Model, build
from ropewalk.lowering.elastic_tables import put_tension
from ropewalk.lowering.limiter_bounds import beyond_bounds
from ropewalk.lowering.link_lengths import has_links
from ropewalk.methods.loop import prepare_links
from ropewalk.scene import Scene, SceneError
from ropewalk.scene.faults import NO_VALUE, Fault
from ropewalk.scene.obstacles import is_free
from ropewalk.statics import Statics, checked_shape
from ropewalk.statics.coupled import NoRoom
from ropewalk.statics.standing import standing
from ropewalk.vibration.bumps import bump_notes, wheel_notes
from ropewalk.vibration.drawing import ModePlots
from ropewalk.vibration.flexibility import NoModes
from ropewalk.vibration.holding import full, full_note, held, slip_note, slipping
from ropewalk.vibration.linear import Linear, linearise
from ropewalk.vibration.motion import TURNS, Motion, motions, turnings
from ropewalk.vibration.plane import Plane, plane_of
from ropewalk.vibration.round_bumps import slid_notes
from ropewalk.vibration.solve import Complex, highest, solve, untangle
from ropewalk.vibration.turned_bends import turning_notes
from ropewalk.vibration.turning import Turns, with_wheels
from ropewalk.vibration.unrelaxed import relaxing_notes

About = Literal["equilibrium", "start"]

_ALIKE = 1e-4  # of the highest frequency [1]: fallen by less, nobody asks why
_BY_NATURAL = (
    "modes stand in the order of their natural frequencies, without damping; one that is damped rings "
    "slower, and may stand behind one that rings faster"
)
_ROUNDING = 8.0 * float(np.finfo(np.float64).eps)  # of the largest coordinate: no stretch [1]


@dataclass(frozen=True)
class Modes:
    """Modes of a scene about a shape, by their natural frequencies. Rates in 1/s, frequencies in Hz."""

    scene: Scene
    layout: Layout
    about: str  # "equilibrium" or "start"
    positions: Floats  # (n, 3) the shape they are about [m]
    eigenvalues: Complex  # (m,) l of u ~ exp(l t) [1/s], imaginary part not negative
    # (m, n, 3) displacements, the largest of a mode 1 and real; where a body turns, it or a rope
    shapes: Complex
    motions: tuple[Motion, ...]  # what moves how
    normal: Floats | None = None  # (3,) unit normal of every rope's plane; None: there is no such
    # contacts with friction that carry nearly all they can at rest, and all that have any; slides, too
    at_limit: tuple[int, int] = (0, 0)
    slips_on: tuple[str, ...] = ()  # obstacles whose surface moves along under what touches it
    bumps: tuple[str, ...] = ()  # sentences on wheels, and ropes on bodies, that corners hold

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
        """Undamped frequencies, the size of l over 2 pi [Hz], (m,).

        NaN for one that creeps or grows without ringing: the two rates of what is damped so much have the
        frequency between them.
        """
        size = np.abs(self.eigenvalues) / (2.0 * np.pi)
        return np.asarray(np.where((self.eigenvalues.imag == 0.0) & (size > 0.0), np.nan, size))

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
    def notes(self) -> list[str]:
        """What to know of the numbers: where they are known to be off."""
        stands = [
            f"pulley {body.name!r} stands: dry friction of its bearing holds it in small motions"
            for body in self.scene.obstacles
            if is_free(body) and body.spin.bearing > 0.0  # type: ignore[union-attr]
        ]
        slips = [slip_note(self.slips_on)] if self.slips_on else []
        slips += [full_note(*self.at_limit)] if self.at_limit[0] else []
        rings = self.frequencies[self.frequencies > 0.0]
        falls = bool(np.any(np.diff(rings) < -_ALIKE * rings.max(initial=0.0)))
        order = [_BY_NATURAL] if falls else []
        laws = [*bump_notes(self), *relaxing_notes(self), *turning_notes(self)]
        return [*stands, *slips, *self.bumps, *laws, *order]

    @property
    def plot(self) -> ModePlots:
        """Figures: `modes.plot.mode_shapes()`."""
        return ModePlots(self)

    def _repr_html_(self) -> str:
        image = cells.png(self.plot.mode_shapes) if self.count else None
        heads = list(self.table[0]) if self.count else []
        rows = [list(row.values()) for row in self.table]
        shown = cells.picture(image, "the shapes of the modes")
        return cells.paragraph(repr(self)) + shown + cells.table(rows, heads)

    def __repr__(self) -> str:
        shown = ", ".join(f"{f:.4g}" for f in self.frequencies[:5])
        more = ", ..." if self.count > 5 else ""
        told = f"{shown}{more} Hz" if self.count else "none"
        return f"Modes of {self.scene.name!r} about its {self.about}: {told}."


def modes(source: Scene | Model, about: About = "equilibrium", count: int = 10) -> Modes:
    """Return the slowest modes of a scene or a built model.

    Raises SceneError for a scene that has no rest shape (about "equilibrium") or in whose shape nothing
    is taut (about "start"), ValueError for another word and for a count below 1, `NoModes` when a
    large model's are not found.
    """
    if about not in ("equilibrium", "start"):
        raise ValueError(f'about: {about!r} - must be "equilibrium" or "start"')
    if count < 1:
        raise ValueError(f"count: {count!r} - must be at least 1")
    model = source if isinstance(source, Model) else build(source, stepped=False)
    wheels = [row for row, body in enumerate(model.scene.obstacles) if is_free(body)]
    if wheels and about == "start":
        rule = (
            "with it modes are about the equilibrium, in which contacts are known; leave out spin"
        )
        raise SceneError([Fault(f"obstacle[{wheels[0]}].spin.free", True, rule)])
    built, bodies = model, tuple[Turns, ...]()
    x, tension, model = shape_about(model, about)
    _refuse_bounds(model, x, about)
    model, slips_on = slipping(model, built, x)
    at_limit, model = full(model), held(model)
    try:
        linear = linearise(replace(model, system=relaxed(model.system)), x, tension)
        if wheels:
            linear, bodies = with_wheels(linear, built, model.state.memory.obstacle, x, tension)
    except NoRoom as error:
        raise NoModes(str(error)) from None
    if linear.loose:
        _refuse_loose(model, about)
    more = 2 * len(model.layout.ropes)  # so that none of equal frequency is cut off
    try:
        values, flat = solve(linear, count + more)
    except NoModes as error:
        raise NoModes(f"{error}{_on_a_bump(model)}") from None
    plane = plane_of(model, x)
    flat = _untangled(values, flat, linear, plane.normal)[:count]
    names = tuple(body.name for body in bodies)
    shapes, found = _told(model, x, linear, flat, names, plane)
    return Modes(
        scene=model.scene,
        layout=model.layout,
        about=about,
        positions=np.ascontiguousarray(x.T),
        eigenvalues=values[:count],
        shapes=shapes,
        motions=found,
        normal=plane.normal if plane.flat else None,
        at_limit=at_limit,
        slips_on=slips_on,
        bumps=(
            *wheel_notes(values[:count], flat, linear.mass, bodies),
            *slid_notes(values[:count], flat, linear, model, x, tension),
        ),
    )


def _told(
    model: Model, x: Floats, linear: Linear, flat: Complex, names: tuple[str, ...], plane: Plane
) -> tuple[Complex, tuple[Motion, ...]]:
    """Return the shapes (m, n, 3) of modes (m, 3 f + b) of f nodes and b bodies, scaled, and what each is."""
    places, free = 3 * linear.nodes.size, linear.follows >= 0
    shapes = np.zeros((len(flat), x.shape[1], 3), dtype=complex)
    shapes[:, free] = flat[:, :places].reshape(len(flat), linear.nodes.size, 3)[
        :, linear.follows[free]
    ]
    scaled = _scaled(shapes)
    found = motions(model, x, scaled, plane)
    if not names:
        return scaled, found
    energy = linear.mass * np.abs(flat) ** 2
    found = turnings(found, energy[:, places:], energy[:, :places].sum(axis=1), names)
    for i, turn in enumerate(flat[:, places:]):
        if found[i].name == TURNS:
            lead = turn[int(np.argmax(np.abs(turn)))]
            largest = max(abs(lead), float(np.sqrt((np.abs(shapes[i]) ** 2).sum(axis=1)).max()))
            scaled[i] = shapes[i] * (abs(lead) / lead / largest)
    return scaled, found


def _untangled(values: Complex, flat: Any, linear: Linear, normal: Floats) -> Complex:
    """Untangle the shapes (m, 3 f + b) of f nodes and b bodies: these are like nodes that move to no side."""
    nodes, places = linear.nodes.size, 3 * linear.nodes.size
    turns = np.zeros((len(flat), flat.shape[1] - places, 3), dtype=flat.dtype)
    turns[:, :, 0] = flat[:, places:]
    mass = np.append(linear.mass[:places], np.repeat(linear.mass[places:], 3))
    aside = np.append(np.tile(normal, nodes), np.zeros(3 * turns.shape[1]))
    shapes = np.hstack([flat[:, :places], turns.reshape(len(flat), 3 * turns.shape[1])])
    found = untangle(values, shapes, mass, aside)
    return np.hstack([found[:, :places], found[:, places::3]])


def _on_a_bump(model: Model) -> str:
    """Say what may be the matter where something rolls freely."""
    free = [slide.name for slide in model.scene.slides if slide.friction == slide.brake == 0.0]
    if not free:
        return ""
    return (
        f". Slide {free[0]!r} may stand on a bump between two segments, from which it would roll down: "
        "change the line's segments by one, or take fewer"
    )


def _refuse_bounds(model: Model, x: Floats, about: About) -> None:
    """Raise SceneError for places (3, n) [m] that a stretch limiter would not have."""
    if far := beyond_bounds(model, x):
        where = "its start" if about == "start" else "rest"
        rule = (
            f"modes know springs only, and {where} is beyond the bounds: {far}; take a wider bound, or "
            "leave the limiter out"
        )
        raise SceneError([Fault("limiter", NO_VALUE, rule)])


def _refuse_loose(model: Model, about: About) -> None:
    """Raise SceneError for ropes that nothing would bring back."""
    where = "where it starts" if about == "start" else "at rest"
    rule = f"has no modes: {where} all its segments are slack, and nothing else brings it back"
    if about == "start":
        rule += '; take them about the "equilibrium", or a shape that stretches it'
    names = enumerate(rope.name for rope in model.scene.ropes)
    raise SceneError([Fault(f"rope[{number}]", name, rule) for number, name in names])


def highest_frequency(model: Model, x: Floats, tension: Floats) -> float | None:
    """Return the highest frequency of the springs about places (3, n) [m] under tensions (s,) [N].

    In rad/s. None where other laws stiffen the ropes, too: bending, and those that bear or hold nodes.
    """
    stiffens = at_rest(model.system) - {Rest.CARRIES} or model.system.flags[BENDING]
    if stiffens or model.scene.slides:
        return None
    linear = linearise(model, x, tension, springs_only=True)
    return highest(linear) if linear.nodes.size else 0.0


def shape_about(model: Model, about: About) -> tuple[Floats, Floats, Model]:
    """Return the places (3, n) [m] and tensions (s,) [N] of the shape that modes are about, and the model.

    At rest its contacts, and what slides, carry what they do there.
    """
    if about == "equilibrium":
        statics = checked_shape(model)
        x = np.ascontiguousarray(statics.positions.T)
        return x, statics.elastic_tension, _at_rest(model, statics)
    state, rigid = model.state, np.isinf(model.state.stiffness)
    stretch = np.sqrt((np.diff(state.x, axis=1) ** 2).sum(axis=0)) - state.rest_length
    stretch[np.abs(stretch) <= _ROUNDING * np.abs(state.x).max()] = 0.0
    tension = np.where(rigid, 0.0, state.stiffness) * stretch
    put_tension(model.system, state, stretch, tension)
    tension = np.maximum(tension, model.system.slack_floor)
    if has_links(state):
        tension = np.where(rigid, _held_tension(model), tension)
    return state.x.copy(), tension, model


def _at_rest(model: Model, statics: Statics) -> Model:
    """Return the model with what contacts and slides carry at rest, bodies as they stand there."""
    if statics.memory is None:
        return model
    state = arrays.copy(model.state)
    arrays.assign(state.memory, statics.memory)
    return replace(model, system=standing(model.system, state.memory), state=state)


def _held_tension(model: Model) -> Floats:
    """Return the tensions (s,) [N] that keep rigid links at their lengths as they let go, at rest."""
    state = arrays.copy(model.state)
    state.v[...] = 0.0
    network = tied_network(model.system.joints, state.tied, state.stiffness > 0.0, second=False)
    saddle = make_saddle(state.x.shape[1])._replace(network=network)
    prepare_links(model.system, state, 0.0, saddle)
    return np.asarray(state.tension)


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
