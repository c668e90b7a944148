"""The report page in Markdown; figures lie beside it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ropewalk.report import words
from ropewalk.report.outcome import Number

if TYPE_CHECKING:
    from ropewalk.report.page import Answered, Judged, Shown


def markdown_page(
    figures: Sequence[Shown], judged: Sequence[Judged], last: Answered, foot: str
) -> str:
    """Return the whole page."""
    verdicts = [one.outcome.verdict for one in judged]
    lines = [f"# {words.TITLE}", "", words.LEAD, "", words.counts(verdicts), ""]
    lines += ["| claim | what it says | verdict |", "|---|---|---|"]
    lines += [
        f"| [{one.claim.id}](#{one.claim.id.lower()}) | {_cell(one.claim.text)} "
        f"| {words.MARK[verdict]} {verdict} |"
        for one, verdict in zip(judged, verdicts, strict=True)
    ]
    lines += ["", "## The report's figures", ""]
    for shown in figures:
        lines += [f"### {shown.title}", "", *_figure(shown)]
    group = ""
    for one in sorted(judged, key=lambda item: _order(judged, item)):
        if one.claim.group != group:
            group = one.claim.group
            lines += [f"## {group}", ""]
        lines += _claim(one)
    lines += [*_answer(last), "---", "", foot, ""]
    return "\n".join(lines)


def _answer(last: Answered) -> list[str]:
    made, heads = last.answer, words.ANSWER_HEADS
    lines = [f"## {words.ANSWER}", "", f"### {made.title}", "", made.text, "", *_figure(last.shown)]
    lines += ["| " + " | ".join(heads) + " |", "|---|" + "--:|" * (len(heads) - 1)]
    lines += ["| " + " | ".join(words.answer_cells(row)) + " |" for row in made.rows]
    return [*lines, ""]


def _order(judged: Sequence[Judged], one: Judged) -> int:
    """Groups in the order in which they first come."""
    return next(i for i, other in enumerate(judged) if other.claim.group == one.claim.group)


def _claim(one: Judged) -> list[str]:
    claim, outcome = one.claim, one.outcome
    lines = [f'<a id="{claim.id.lower()}"></a>', "", f"### {claim.id} · {claim.title}", ""]
    lines += [f"**Claim.** {claim.text}", ""]
    lines += [f"**Verdict: {words.MARK[outcome.verdict]} {outcome.verdict}.**", ""]
    lines += [f"- {'✓' if part.accepted else '✗'} {part.statement}" for part in outcome.parts]
    lines += ["", f"**Measured.** {outcome.measured}", "", f"**Theory.** {outcome.theory}", ""]
    if outcome.note:
        lines += [f"**Note.** {outcome.note}", ""]
    if outcome.numbers:
        lines += ["| quantity | measured | theory | allowed | agrees | formula |"]
        lines += ["|---|--:|--:|--:|:-:|---|"]
        lines += [_row(number) for number in outcome.numbers]
        lines += [""]
    return lines + _figure(one.shown)


def _row(n: Number) -> str:
    cells = [n.label, words.value(n.measured, n.unit), words.value(n.theory, n.unit),
             words.tolerance(n), "yes" if n.agrees else "**no**", n.formula]  # fmt: skip
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def _figure(shown: Shown) -> list[str]:
    return [f"![{shown.caption}](figures/{shown.id}.svg)", "", f"*{shown.caption}*", ""]
