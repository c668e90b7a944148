"""After a break: where to go back to, and what to change."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ropewalk.analysis.stability import STIFF
from ropewalk.live.history import Moment
from ropewalk.lowering import Layout, Model
from ropewalk.lowering.steps import predicted_step, step_cases
from ropewalk.simulation import Simulation
from ropewalk.words.prefixes import prefix_of

if TYPE_CHECKING:
    from ropewalk.live.session import Session

_BEFORE = 1.0  # [s] before a break that no bound predicted
_MARGIN = 0.9  # of the largest stable step


def largest_step(simulation: Simulation) -> float:
    """Return the largest stable step of a simulation's method [s]."""
    model, plan = simulation.model, simulation.plan
    return predicted_step(model.system, model.state, plan.method, plan.duration)


def holds_without_friction(model: Model) -> bool:
    """Tell whether the step is stable for the same ropes without friction of their own."""
    cases = step_cases(model.system, model.state, model.plan.duration)
    smooth = {
        name: chain._replace(
            damping_vector=np.zeros_like(chain.damping_vector),
            damping_axial=np.zeros_like(chain.damping_axial),
            damping_bending=0.0,
        )
        for name, chain in cases.chains.items()
    }
    steps = cases._replace(chains=smooth).largest(model.plan.method)
    return model.plan.dt <= min(steps.values())


def suggested_step(simulation: Simulation) -> float:
    """Return a step to take instead of one that broke [s], with two digits."""
    dt, bound = simulation.plan.dt, largest_step(simulation)
    wanted = _MARGIN * bound if 0.0 < bound < dt else 0.5 * dt
    unit = 10.0 ** (math.floor(math.log10(wanted)) - 1)
    return float(f"{math.floor(wanted / unit + 1e-9) * unit:.2g}")


def implicit_method(simulation: Simulation) -> str:
    """Return the implicit method to recommend in place of a simulation's own."""
    return STIFF if simulation.plan.method != STIFF else "implicit-euler"


def calm_moment(session: Session, layout: Layout | None = None) -> Moment:
    """Return the newest moment whose step was stable; else one some time before the break.

    With `layout` only moments of such a layout count, where there is any.
    """
    moments = session.history.newest_first()
    if layout is not None:
        alike = [one for one in moments if one.tracks[0].simulation.layout == layout]
        moments = alike or moments
    bounds: dict[int, bool] = {}
    for moment in moments:
        simulations = [saved.simulation for saved in moment.tracks]
        if all(_is_stable(one, bounds) for one in simulations) and not _near(session, moment):
            return moment
    early = [one for one in moments if one.time <= session.time - _BEFORE]
    return early[0] if early else moments[-1]


def _near(session: Session, moment: Moment) -> bool:
    """Whether a moment with the very simulations that broke is too near to the break."""
    same = [saved.simulation for saved in moment.tracks] == [
        track.simulation for track in session.tracks
    ]
    return same and moment.time > session.time - _BEFORE


def _is_stable(simulation: Simulation, known: dict[int, bool]) -> bool:
    key = id(simulation)
    if key not in known:
        known[key] = simulation.plan.dt <= largest_step(simulation)
    return known[key]


def as_messages(simulation: Simulation | None, changed: bool) -> list[dict[str, Any]]:
    """Return the remedies that a page offers for the simulation that broke; None: not looked at yet.

    When constants were `changed` since the break, one is to go on with them.
    """
    found: list[dict[str, Any]] = [{"id": "back", "label": "Back to before", "value": None}]
    if simulation is None:
        found += [{"id": one, "label": "", "value": None} for one in ("step", "implicit")]
    else:
        step, method = suggested_step(simulation), implicit_method(simulation)
        unit, prefix = prefix_of(step)  # as the meter beside it writes its own
        words = f"Use {method}" if "implicit" in method else f"Use {method}, implicit"
        found += [
            {"id": "step", "label": f"Use a step of {step / unit:g} {prefix}s", "value": step},
            {"id": "implicit", "label": words, "value": method},
        ]
    if changed:
        on = {"id": "on", "label": "Go on with these values", "value": None}
        stable = simulation is not None and simulation.plan.dt <= largest_step(simulation)
        found.insert(0 if stable else len(found), on)
    return found
