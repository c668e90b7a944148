"""A scene made into a sheet: checked, settled, run, run again to see what holds, and written down."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from ropewalk import __version__
from ropewalk.api import SceneLike, as_scene, simulate, told_of
from ropewalk.plots.dimensions import dimensions
from ropewalk.record.rest import rest_and_result
from ropewalk.record.result import Result
from ropewalk.scene import Scene, SceneError, dumps
from ropewalk.scene.as_given import as_given
from ropewalk.scene.guess import COMPUTE
from ropewalk.sheets.content import Item, Listing, Section, Table, Text, picture
from ropewalk.sheets.document import Sheet
from ropewalk.sheets.loads import loose_pulleys, rest_section, run_section, summary_section
from ropewalk.sheets.ropes import assumption_section, rope_section
from ropewalk.sheets.stiffness_ends import SEE, at_ends, stiffness_ends
from ropewalk.sheets.trust import NOT_LOOKED_AT, convergence_section, doubts, method_section
from ropewalk.statics import NoRest

_SEED = 1  # of the samples of what is not known: a sheet made again has the same numbers


def sheet(
    scene: SceneLike,
    *,
    run: bool = True,
    convergence: bool = True,
    uncertain: Mapping[str, Any] | None = None,
    samples: int = 64,
    file: str | Path | None = None,
    flags: Sequence[str] = (),
    progress: Callable[[str], None] | None = None,
) -> Sheet:
    """Make the sheet of a job: what a scene is, what it carries at rest and in its run, and how sure that is.

    Args:
        scene: scene, preset's name, or scene file.
        run: run it; without, the sheet has the scene at rest alone.
        convergence: compute it again with half the segments and half the step, and with both ends of guessed
            stiffnesses.
        uncertain: values that are not known, as for `uncertain`: paths to ranges or distributions.
        samples: base samples of these.
        file: that the scene was read from, whose quantities are shown as they stand there; by default
            `scene`, where that is one.
        flags: "path=value" that changed it since, whose quantities are shown, too.
        progress: called with what is done next, in words.

    Returns:
        The sheet; `save` writes it as HTML or PDF.

    Raises SceneError for a faulty scene, and without a run for one that has no shape of rest; NoRest when
    that is not found.
    """
    made, tell = as_scene(scene), progress or (lambda words: None)
    again = SEE if convergence and at_ends(made) else COMPUTE
    with told_of(scene):
        if uncertain:  # refused now, not after all runs
            from ropewalk.sweeps.uncertainty import spread_parameters

            spread_parameters(made, uncertain)
        tell("at rest")
        rest, at_rest, held = _rest(made, again, needed=not run)
        if run:
            tell("the run")
        ran = simulate(made, on_failure="return") if run else None
    result = ran or rest
    assert result is not None
    ends = stiffness_ends(made, rest, ran, tell) if convergence else None
    trust = _converged(made, result, tell if convergence else None)
    told = doubts(trust) + held + (ends.summary if ends else ())
    sections = [summary_section(rest, ran, told, again)]
    sections += [_drawing(rest or result), rope_section(made), *_given(file or scene, made, flags)]
    sections += [assumption_section(made), at_rest]
    if run:
        sections += [run_section(result, again), _courses(result), method_section(result)]
    sections += [one for one in (trust, ends.section if ends else None) if one and one.items]
    if uncertain:
        tell("what is not known")
        sections.append(_uncertain(made, uncertain, samples, "run" if run else "rest"))
    sections.append(_identity(made, result))
    lead = f"Computed by Ropewalk {__version__} on {datetime.now(UTC):%Y-%m-%d %H:%M} UTC."
    return Sheet(made.name, " ".join((made.description, lead)).strip(), tuple(sections), result)


def _rest(
    scene: Scene, again: str, *, needed: bool
) -> tuple[Result | None, Section, tuple[Item, ...]]:
    """Return the equilibrium, what is told of it, and what of that belongs in the summary.

    None where there is none, if that is not `needed`.
    """
    try:
        statics, rest = rest_and_result(scene)
    except (SceneError, NoRest) as error:
        if needed:
            raise
        reason = str(error).splitlines()[-1].strip()
        return None, Section("At rest", (Text(f"There is no shape of rest: {reason}"),)), ()
    return rest, rest_section(rest, statics.spans, statics, again), loose_pulleys(statics)


def _converged(scene: Scene, result: Result, tell: Callable[[str], None] | None) -> Section:
    """Return how the numbers converge, if there is whom to `tell`; nothing of a run that broke."""
    if result.diagnosis:
        return Section("Convergence", ())
    return NOT_LOOKED_AT if tell is None else convergence_section(scene, result, tell)


def _drawing(result: Result) -> Section:
    shown = "at rest" if result.status == "at rest" else "at time zero"
    return Section("Drawing", (picture(dimensions(result), f"The scene {shown}, with dimensions"),))


def _given(file: SceneLike, scene: Scene, flags: Sequence[str]) -> list[Section]:
    """Return the quantities that a file and flags give in units of their own, as they stand there."""
    found = as_given(file if isinstance(file, str | Path) else "", scene, flags)
    if not found:
        return []
    return [
        Section("As given", (Table(("where", "given", "computed with"), found, numbers=False),))
    ]


def _courses(result: Result) -> Section:
    """Return the figures of a run: shape, tension, anchor forces, energy."""
    items: list[Item] = [
        picture(result.plot.shape(), "The ropes at some times of the run"),
        picture(result.plot.tension(), "Tension over time and along the ropes"),
    ]
    if result.layout.anchor_names:
        figure = result.plot.reactions(on_anchors=True)  # as in the tables
        items.append(picture(figure, "Forces of the ropes on the anchors over time"))
    if result.facts.ledger:
        items.append(picture(result.plot.energy(), "Energies over time"))
    return Section("Figures of the run", tuple(items))


def _uncertain(scene: Scene, spreads: Mapping[str, Any], samples: int, what: str) -> Section:
    from ropewalk.sweeps.uncertainty import text_rows, uncertain

    found = uncertain(scene, spreads, samples=samples, what=what, seed=_SEED)
    head = ("result", "5 %", "50 %", "95 %", "unit", "follows (total Sobol index)")
    given = "; ".join(f"{path}: {_spread(value)}" for path, value in spreads.items())
    made = f"{len(found.runs.run)} computations, {samples} samples, seed {_SEED}"
    items: list[Item] = [
        Text(f"Not known exactly: {given}. {made}."),
        Table(head, text_rows(found), numbers=False),
        picture(found.plot(), "Bands of what is not known exactly"),
    ]
    if found.note:
        items.append(Text(found.note, warning=found.broken > 0 or found.few))
    return Section("What is not known", tuple(items))


def _spread(value: Any) -> str:
    """Return per cents, a range or a distribution in words."""
    if isinstance(value, str):
        return f"±{value.strip().lstrip('±').strip()} of what the scene has"
    if isinstance(value, tuple):
        low, high = (one if isinstance(one, str) else f"{one:.6g}" for one in value)
        return f"{low} to {high}"
    from ropewalk.sweeps.parameters import spread_in_words

    return spread_in_words(value)


def _identity(scene: Scene, result: Result) -> Section:
    """Return versions, hashes, and the scene itself, so that the sheet can be computed again."""
    text, about = dumps(scene), result.facts.provenance
    rows = [
        ("Ropewalk", f"{about['ropewalk']}, sources {about['source_hash']}"),
        ("Python, numpy, numba", f"{about['python']}, {about['numpy']}, {about['numba']}"),
        ("machine", f"{about['platform']}, {about['machine']}"),
        ("SHA-256 of the scene below", hashlib.sha256(text.encode("utf-8")).hexdigest()),
    ]
    again = "The scene, complete: saved as a file it gives this sheet again."
    items = (Table(("", ""), rows, numbers=False), Text(again), Listing(text))
    return Section("To compute it again", items)
