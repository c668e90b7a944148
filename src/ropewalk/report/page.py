"""The report page: every claim run, judged and written as HTML and Markdown."""

from __future__ import annotations

import csv
import platform
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import date
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from ropewalk.report import draw
from ropewalk.report.claims import CLAIMS
from ropewalk.report.figures import pictures
from ropewalk.report.html import html_page
from ropewalk.report.markdown import markdown_page
from ropewalk.report.outcome import Answer, Claim, Outcome
from ropewalk.report.stiff_rope import answer


@dataclass(frozen=True)
class Shown:
    """A figure ready for a page."""

    id: str
    title: str
    caption: str
    picture: bytes  # SVG


@dataclass(frozen=True)
class Judged:
    """A claim with its outcome and its figure."""

    claim: Claim
    outcome: Outcome
    shown: Shown


@dataclass(frozen=True)
class Answered:
    """The last section with its figure."""

    answer: Answer
    shown: Shown


def write_report(
    out: Path,
    progress: Callable[[int, int, str], None] | None = None,
    claims: Sequence[Claim] = CLAIMS,
) -> dict[str, Path]:
    """Run the claims and write the page into a folder, which is made when it is not there.

    Args:
        out: folder; files of an earlier report in it are written over.
        progress: called with the steps done, those in all, and what comes, before each claim is run.
        claims: which ones; all of them by default.

    Returns:
        The paths: html, markdown, numbers (CSV) and figures (the folder of SVG files).
        Raises OSError when the folder cannot be written.
    """
    out = Path(out)
    folder = out / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    tell = progress or (lambda done, planned, line: None)
    steps = len(claims) + 2
    tell(0, steps, "figures 1 to 3")
    figures = [Shown(one.id, one.title, one.caption, draw.svg(one.figure)) for one in pictures()]
    judged = []
    for number, one in enumerate(claims, start=1):
        tell(number, steps, f"{one.id} {one.title}")
        outcome = one.run()
        picture = draw.svg(outcome.figure)
        shown = Shown(one.id.lower(), one.title, outcome.caption, picture)
        judged.append(Judged(one, outcome, shown))
    tell(steps - 1, steps, "10 kN/m at 60 steps a second")
    made = answer()
    last = Answered(made, Shown(made.id, made.title, made.caption, draw.svg(made.figure)))
    tell(steps, steps, "")
    for shown in [*figures, *(one.shown for one in judged), last.shown]:
        (folder / f"{shown.id}.svg").write_bytes(shown.picture)
    paths = {
        "html": out / "report.html",
        "markdown": out / "report.md",
        "numbers": out / "numbers.csv",
        "figures": folder,
    }
    foot = f"Written on {date.today().isoformat()} with {versions()}."
    paths["html"].write_text(html_page(figures, judged, last, foot), encoding="utf-8")
    paths["markdown"].write_text(markdown_page(figures, judged, last, foot), encoding="utf-8")
    _write_numbers(paths["numbers"], judged)
    return paths


def _write_numbers(path: Path, judged: Sequence[Judged]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["claim", "quantity", "measured", "theory", "unit", "tolerance",
                       "tolerance_is", "agrees"])  # fmt: skip
        for one in judged:
            for n in one.outcome.numbers:
                kind = "relative" if n.relative else "absolute"
                rows.writerow([one.claim.id, n.label, repr(float(n.measured)),
                               repr(float(n.theory)), n.unit, n.tolerance, kind,
                               str(n.agrees).lower()])  # fmt: skip


def versions() -> str:
    """Versions of what the numbers come from, in words."""
    found = []
    for name in ("ropewalk", "numpy", "numba", "matplotlib"):
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            found.append(f"{name} (not installed as a package)")
    return ", ".join([*found, f"Python {platform.python_version()} on {platform.machine()}"])
