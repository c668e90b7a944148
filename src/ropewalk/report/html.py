"""The report page in HTML: one file that needs nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from ropewalk.report import draw, words
from ropewalk.report.outcome import Number, Verdict

if TYPE_CHECKING:
    from ropewalk.report.page import Answered, Judged, Shown


def html_page(figures: Sequence[Shown], judged: Sequence[Judged], last: Answered, foot: str) -> str:
    """Return the whole page, figures included."""
    style = (files("ropewalk.report") / "style.css").read_text(encoding="utf-8")
    pictures = "\n".join(
        f'<section id="{escape(shown.id)}"><h3>{escape(shown.title)}</h3>{_figure(shown)}</section>'
        for shown in figures
    )
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{escape(words.TITLE)}</title>
<style>
{style}</style>
</head>
<body>
<header><h1>{escape(words.TITLE)}</h1><p>{escape(words.LEAD)}</p></header>
<main>
<section id="summary"><h2>Summary</h2>{_summary(judged)}</section>
<section id="figures"><h2>The report’s figures</h2>{pictures}</section>
{_groups(judged)}
{_answer(last)}
</main>
<footer><p>{escape(foot)}</p></footer>
</body>
</html>
"""


def _summary(judged: Sequence[Judged]) -> str:
    rows = "\n".join(
        f'<tr><th scope="row"><a href="#{one.claim.id.lower()}">{one.claim.id}</a></th>'
        f"<td>{escape(one.claim.text)}</td><td>{_badge(one.outcome.verdict)}</td></tr>"
        for one in judged
    )
    verdicts = [one.outcome.verdict for one in judged]
    return (
        f'<p>{escape(words.counts(verdicts))}</p><div class="wide"><table>'
        '<thead><tr><th scope="col">Claim</th><th scope="col">What it says</th>'
        f'<th scope="col">Verdict</th></tr></thead><tbody>{rows}</tbody></table></div>'
    )


def _groups(judged: Sequence[Judged]) -> str:
    names = list(dict.fromkeys(one.claim.group for one in judged))
    return "\n".join(
        f"<section><h2>{escape(name)}</h2>"
        + "\n".join(_claim(one) for one in judged if one.claim.group == name)
        + "</section>"
        for name in names
    )


def _answer(last: Answered) -> str:
    made = last.answer
    heads = "".join(f'<th scope="col">{escape(head)}</th>' for head in words.ANSWER_HEADS)
    rows = "\n".join(
        f'<tr><th scope="row">{escape(cells[0])}</th>'
        + "".join(f'<td class="n">{escape(cell)}</td>' for cell in cells[1:])
        + "</tr>"
        for cells in map(words.answer_cells, made.rows)
    )
    return f"""<section><h2>{escape(words.ANSWER)}</h2><article id="{escape(made.id)}">
<h3>{escape(made.title)}</h3><p>{escape(made.text)}</p>
{_figure(last.shown)}
<div class="wide"><table class="numbers"><thead><tr>{heads}</tr></thead>
<tbody>{rows}</tbody></table></div></article></section>"""


def _claim(one: Judged) -> str:
    claim, outcome = one.claim, one.outcome
    parts = "".join(
        f'<li class="{"yes" if part.accepted else "no"}">{escape(part.statement)}</li>'
        for part in outcome.parts
    )
    note = f"<dt>Note</dt><dd>{escape(outcome.note)}</dd>" if outcome.note else ""
    return f"""<article id="{claim.id.lower()}">
<h3>{claim.id} · {escape(claim.title)} {_badge(outcome.verdict)}</h3>
<dl><dt>Claim</dt><dd>{escape(claim.text)}</dd>
<dt>Measured</dt><dd>{escape(outcome.measured)}</dd>
<dt>Theory</dt><dd>{escape(outcome.theory)}</dd>
<dt>Verdict</dt><dd><ul class="parts">{parts}</ul></dd>{note}</dl>
{_figure(one.shown)}
{_numbers(outcome.numbers)}
</article>"""


def _numbers(numbers: Sequence[Number]) -> str:
    if not numbers:
        return ""
    heads = "".join(
        f'<th scope="col">{head}</th>'
        for head in ("Quantity", "Measured", "Theory", "Allowed", "Agrees", "Formula")
    )
    rows = "\n".join(_row(number) for number in numbers)
    return (
        f'<div class="wide"><table class="numbers"><thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table></div>"
    )


def _row(n: Number) -> str:
    values = [words.value(n.measured, n.unit), words.value(n.theory, n.unit), words.tolerance(n)]
    cells = "".join(f'<td class="n">{escape(text)}</td>' for text in values)
    agrees = '<td class="yes">yes</td>' if n.agrees else '<td class="no">no</td>'
    return (
        f'<tr><th scope="row">{escape(n.label)}</th>{cells}{agrees}'
        f"<td>{escape(n.formula)}</td></tr>"
    )


def _badge(verdict: Verdict) -> str:
    return f'<span class="badge {words.CLASS[verdict]}">{words.MARK[verdict]} {verdict}</span>'


def _figure(shown: Shown) -> str:
    caption = escape(shown.caption)
    return (
        f'<figure><img src="{draw.data_uri(shown.picture)}" alt="{caption}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )
