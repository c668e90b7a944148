"""A sheet in HTML: one file that needs nothing else, for the screen and for A4."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from html import escape
from importlib.resources import files

from ropewalk.sheets.content import Item, Listing, Picture, Section, Table, Text

_WHOLE = 7.2  # [inch] of a figure that is as wide as the page


def html_page(title: str, lead: str, sections: Sequence[Section], *, whole: bool = True) -> str:
    """Return the page; not `whole`: what stands between the tags of its body."""
    parts = "\n".join(
        f"<section><h2>{escape(one.title)}</h2>\n{''.join(map(_item, one.items))}</section>"
        for one in sections
    )
    body = f"<header><h1>{escape(title)}</h1><p>{escape(lead)}</p></header>\n<main>{parts}</main>"
    style = (files("ropewalk.sheets") / "style.css").read_text(encoding="utf-8")
    if not whole:
        return f'<div class="sheet">{body}</div>'
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title>
<style>
{style}</style>
</head>
<body class="sheet">
{body}
</body>
</html>
"""


def _item(item: Item) -> str:
    match item:
        case Text():
            kind = ' class="warning"' if item.warning else ""
            return f"<p{kind}>{escape(item.words)}</p>\n"
        case Table():
            return _table(item)
        case Picture():
            source = base64.b64encode(item.png).decode("ascii")
            shows = escape(item.shows)
            share = 100.0 * min(
                item.width / _WHOLE, 1.0
            )  # narrow ones are no larger than the others
            look = f'alt="{shows}" style="width: {share:.0f}%"'
            return f'<figure><img {look} src="data:image/png;base64,{source}"></figure>\n'
        case Listing():
            return f"<pre>{escape(item.lines)}</pre>\n"


def _table(table: Table) -> str:
    kind = ' class="numbers"' if table.numbers else ""
    heads = "".join(f'<th scope="col">{escape(head)}</th>' for head in table.head)
    head = f"<thead><tr>{heads}</tr></thead>" if any(table.head) else ""
    rows = "".join(
        f'<tr><th scope="row">{escape(row[0])}</th>'
        + "".join(f"<td>{escape(cell)}</td>" for cell in row[1:])
        + "</tr>\n"
        for row in table.rows
    )
    note = f'<p class="note">{escape(table.note)}</p>' if table.note else ""
    return f'<div class="wide"><table{kind}>{head}<tbody>{rows}</tbody></table></div>{note}\n'
