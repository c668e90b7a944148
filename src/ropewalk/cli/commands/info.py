"""`ropewalk info`: what is in a run folder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ropewalk.cli.console import print_json, print_table, say, tell
from ropewalk.cli.failures import Refusal
from ropewalk.cli.results_table import print_results
from ropewalk.cli.run_argument import is_sweep, open_run, run_argument
from ropewalk.cli.scene_argument import json_option
from ropewalk.words.shell import typed

if TYPE_CHECKING:
    from ropewalk.lowering import Plan
    from ropewalk.record.result import Result

MOST_NAMED = 20  # damaged files
_PROVENANCE = ("started", "ended", "ropewalk", "python", "numpy", "numba", "platform")


@click.command()
@run_argument
@click.option(
    "--verify",
    "checked",
    is_flag=True,
    help="Compare all that the folder holds with its checksums first; exit status 2 if any is damaged.",
)
@json_option
def info(folder: Path, checked: bool, as_json: bool) -> None:
    """Say what is in the run folder DIR: scene, state, numbers, where it came from.

    Of a sweep: how its runs ended, and why those that broke did.
    """
    if is_sweep(folder):
        from ropewalk.cli.commands.sweep import info_folder

        info_folder(folder, as_json=as_json, checked=checked)
        return
    result = open_run(folder)
    if checked:
        tell(_verified(folder))
    if as_json:
        print_json(_facts(result))
        return
    say(f"{folder}: {result.scene.name}")
    if result.scene.description:
        say(f"  {result.scene.description}")
    rows = [(name, text) for name, text in _rows(result) if text]
    print_table(("", ""), rows)
    print_results(result)
    arrays = [
        (name, " x ".join(map(str, array["shape"])), array["unit"])
        for name, array in _arrays(result).items()
    ]
    print_table(("recorded", "shape", "unit"), arrays)
    print_table(("event", "at", "what"), [_event(event) for event in result.events])
    if result.diagnosis:
        say(result.diagnosis)
    if how := _going_on(result, folder):
        say(f"go on with: ropewalk {how}")


def _going_on(result: Result, folder: Path) -> str:
    """Return the command that goes on with what was interrupted, "" where nothing was."""
    if not result.facts.provenance.get("live"):
        return f"resume {typed(folder)}" if _resumes(result, folder) else ""
    from ropewalk.live.keeper import parts
    from ropewalk.record.place import session_folder
    from ropewalk.record.result import Result

    whole = session_folder(folder)
    interrupted = Result.open(parts(whole)[-1]).status == "interrupted"
    return f"view {typed(whole)} --continue" if interrupted else ""


def _resumes(result: Result, folder: Path) -> bool:
    """Tell whether an interrupted run can go on: a copy that was saved has nothing to go on from."""
    from ropewalk.record.place import CHECKPOINT
    from ropewalk.record.store import FORMAT

    new = result.facts.provenance.get("format") == FORMAT
    return result.status == "interrupted" and new and (folder / CHECKPOINT).exists()


def _verified(folder: Path) -> str:
    """Return what was compared with its checksums and is sound. Raises Refusal that names what is not."""
    from ropewalk.record.folder import verify

    verdict = verify(folder)
    if verdict.faults:
        named = [str(fault) for fault in verdict.faults[:MOST_NAMED]]
        if len(verdict.faults) > MOST_NAMED:
            named.append(f"and {len(verdict.faults) - MOST_NAMED} more, of {verdict.chunks} chunks")
        raise Refusal("\n".join(named))
    if verdict.sealed:
        return f"{verdict.chunks} chunks of numbers and all beside them, as they were written"
    return (
        f"{verdict.chunks} chunks of numbers, as they were written; provenance, status and events of this "
        "older format have no checksums"
    )


def _rows(result: Result) -> list[tuple[str, str]]:
    plan, known = result.plan, result.facts.provenance
    state = result.status
    if result.frames < plan.frames + 1:
        state += f" at {result.time[-1]:.6g} of {plan.duration:.6g} s"
    rows = [
        ("state", state),
        ("scene", str(result.scene)),
        ("method", _method(plan)),
        ("chosen", plan.why),
        ("anchors", ", ".join(result.layout.anchor_names)),
    ]
    return rows + [(key, str(known.get(key, ""))) for key in _PROVENANCE]


def _method(plan: Plan) -> str:
    if plan.tolerance is not None:
        return f"{plan.method}, {plan.pace}"
    return f"{plan.method}, steps of {plan.dt:.6g} s, {plan.steps_per_frame} a frame"


def _event(event: dict[str, Any]) -> tuple[str, str, str]:
    """Return an event's name, its time in the scene or else by the clock, and what else is known."""
    time = event.get("time")
    at = f"t = {time:.6g} s" if isinstance(time, (int, float)) else str(event.get("at", ""))
    known = {"event", "at", "time", "diagnosis"}
    more = [
        f"{key} {', '.join(value) if isinstance(value, list) else value}"
        for key, value in event.items()
        if key not in known
    ]
    return event["event"], at, ", ".join(more)


def _arrays(result: Result) -> dict[str, dict[str, Any]]:
    """Return shape and unit of every recorded quantity, by name."""
    from ropewalk.record.quantities import BY_NAME, sizes

    lengths = sizes(result.layout) | {"time": result.frames}
    found = {"time": {"shape": [result.frames], "unit": "s"}}
    for name in result.source.names:
        quantity = BY_NAME[name]
        shape = [lengths[dim] for dim in quantity.dims]
        found[name] = {"shape": shape, "unit": quantity.unit}
    return found


def _facts(result: Result) -> dict[str, Any]:
    return {
        "folder": str(result.folder),
        "name": result.scene.name,
        "description": result.scene.description,
        "status": result.status,
        "diagnosis": result.diagnosis or None,
        "provenance": result.facts.provenance,
        "events": result.events,
        "results": result.table,
        "arrays": _arrays(result),
    }
