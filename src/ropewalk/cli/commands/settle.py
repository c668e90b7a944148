"""`ropewalk settle`: where a scene is at rest."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.commands.run import refuse_run
from ropewalk.cli.console import print_json, print_table, say, warn
from ropewalk.cli.progress import telling_of_compiling
from ropewalk.cli.results_table import print_results
from ropewalk.cli.scene_argument import json_option, load_scene, set_option
from ropewalk.cli.startup import without_scipy
from ropewalk.words.prefixes import prefix_of, prefixed

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ropewalk.core.arrays import Floats
    from ropewalk.record.result import Result
    from ropewalk.statics import RestSpan, Statics


@click.command()
@click.argument("scene")
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Write the equilibrium as a run folder of one frame.",
)
@set_option
@click.option("--overwrite", is_flag=True, help="Replace a run that is in DIR.")
@json_option
def settle(
    scene: str, output: Path | None, overrides: tuple[str, ...], overwrite: bool, as_json: bool
) -> None:
    """Find the shape in which a scene is at rest, without running it.

    Prints sag, tension, the force of every anchor, and what is left of the forces on the nodes. With
    weight, stretch, ground, wind and bending; inner friction does not matter at rest. Where ropes touch
    obstacles or each other, or slide, with friction, it is one of many shapes: that to which the scene's
    own creeps. The folder can be
    plotted and exported like a run. A run begins from this shape with: run.start = "at-rest".
    """
    loaded = load_scene(scene, overrides)
    with without_scipy():
        if output is not None:
            refuse_run(output, overwrite)
        from ropewalk.lowering import build
        from ropewalk.record.rest import rest_and_result
        from ropewalk.rigging.held_places import in_words
        from ropewalk.statics import rest_spans
        from ropewalk.statics.wraps import MANY, coarse_words

        with telling_of_compiling():
            model = build(loaded, stepped=False)
            rest, result = rest_and_result(model)
            spans = rest_spans(model, result.positions[0], result.tension[0], rest.left)
        if output is not None:
            result = result.save(output, overwrite=overwrite)
    if note := result.table.get("about the stretch limiter"):
        warn(f"the stretch limiter takes no part in the equilibrium; {note}")
    elif loaded.limiter is not None and not all(rope.rigid for rope in loaded.ropes):
        warn("the stretch limiter takes no part in the equilibrium")
    if as_json:
        print_json(_facts(result, spans, rest))
        return
    print_results(result, f"{result.scene.name}: {result.status}")
    _print_spans(spans)
    held = _held(result, rest)
    for place in (*rest.wraps, *rest.touches, *rest.seats, *rest.pulleys):
        say(str(place))
    for seat, places in zip(rest.seats, held, strict=True):
        if words := in_words(seat, places):
            say(words)
    if rest.by_friction:
        say(f"note: {MANY}")
    for coarse in coarse_words(rest.wraps):
        warn(coarse)
    _print_anchors(result)
    if output is not None:
        say(f"run folder: {output}")


def _held(result: Result, rest: Statics) -> list[tuple[float, float] | None]:
    """Return between which places everything that slides is held, None where no closed form says it."""
    from ropewalk.rigging.held_places import held_places

    spans = result.layout.ropes
    ropes = {span.name: result.positions[0, span.first : span.last + 1] for span in spans}
    return [held_places(result.scene, ropes, seat) for seat in rest.seats]


def _print_spans(spans: tuple[RestSpan, ...]) -> None:
    columns = ("rope", "nodes", "", "length", "ends apart", "sag", "H", "largest tension")
    rows = [
        (
            span.rope,
            f"{span.first} to {span.last}",
            "span" if span.kind == "span" else "free end",
            f"{span.length:.6g} m",
            f"{span.distance:.6g} m",
            span.sag_words(6),
            prefixed(span.horizontal, "N", 6) if span.kind == "span" else "",
            span.pull_words(6),
        )
        for span in spans
    ]
    if rows:
        print_table(columns, rows, right=range(3, len(columns)))


def _print_anchors(result: Result) -> None:
    anchors = range(len(result.layout.anchor_names))
    _print_vectors(result, "anchor's force", "N", result.reactions[0], anchors)
    if result.layout.clamped:
        clamped = [i for i in anchors if result.scene.anchors[i].clamp is not None]
        _print_vectors(result, "clamp's moment", "N m", result.moments[0], clamped)


def _print_vectors(
    result: Result, what: str, unit: str, vectors: Floats, anchors: Iterable[int]
) -> None:
    """Print what some anchors, by number, exert on ropes; `vectors` has those of all, (a, 3)."""
    rows = []
    sizes = (vectors**2).sum(axis=1) ** 0.5
    factor, prefix = prefix_of(float(sizes.max(initial=1.0)))
    for number in anchors:
        parts = (*vectors[number], sizes[number])
        name = result.layout.anchor_names[number]
        rows.append((name, *(f"{part / factor:.6g}" for part in parts)))
    if rows:
        columns = (f"{what} [{prefix}{unit}]", "x", "y", "z", "size")
        print_table(columns, rows, right=range(1, 5))


def _facts(result: Result, spans: tuple[RestSpan, ...], rest: Statics) -> dict[str, Any]:
    names = result.layout.anchor_names
    return {
        "name": result.scene.name,
        "folder": str(result.folder) if result.folder else None,
        "status": result.status,
        "results": {name: value for name, value in result.table.items() if name != "status"},
        "residual": result.residual,
        "spans": [span.as_dict() for span in spans],
        "wraps": [wrap.as_dict() for wrap in rest.wraps],
        "touches": [touch.as_dict() for touch in rest.touches],
        "seats": [
            seat.as_dict() | {"held": places}
            for seat, places in zip(rest.seats, _held(result, rest), strict=True)
        ],
        "pulleys": [pulley.as_dict() for pulley in rest.pulleys],
        "anchors": {
            name: list(force) for name, force in zip(names, result.reactions[0], strict=True)
        },
        "moments": {
            anchor.name: list(moment)
            for anchor, moment in zip(result.scene.anchors, result.moments[0], strict=True)
            if anchor.clamp is not None
        },
    }
