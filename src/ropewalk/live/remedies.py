"""After a break: where to go back to, and what to change."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ropewalk.analysis.stability import STIFF
from ropewalk.build import Layout
from ropewalk.build.plan import predicted_step
from ropewalk.live.history import Moment
from ropewalk.simulation import Simulation

if TYPE_CHECKING:
    from ropewalk.live.session import Session

_BEFORE = 1.0  # [s] before a break that no bound predicted
_MARGIN = 0.9  # of the largest stable step


def largest_step(simulation: Simulation) -> float:
    """Return the largest stable step of a simulation's method [s]."""
    model = simulation.model
    return predicted_step(model.system, model.state, simulation.plan.method)


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


def as_messages(session: Session) -> list[dict[str, Any]]:
    """Return the remedies that a page offers."""
    if session.broken is None:
        return []
    track = session.tracks[session.broken.variant]
    step, method = suggested_step(track.simulation), implicit_method(track.simulation)
    return [
        {"id": "back", "label": "Back to before", "value": None},
        {"id": "step", "label": f"Use a step of {1e3 * step:g} ms", "value": step},
        {"id": "implicit", "label": f"Use {method}", "value": method},
    ]
