"""A sheet as PDF on A4, by reportlab (the extra `ropewalk[sheet]`)."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

from ropewalk.sheets.content import Item, Listing, Picture, Section, Table, Text
from ropewalk.sheets.paper import on_paper

_MISSING = "a PDF needs reportlab: pip install 'ropewalk[sheet]', or write .html and print it"
_INK, _SOFT, _LINE, _WARN, _BACK = "#1c2430", "#566070", "#d5dae0", "#8a2b00", "#fff4e8"
_MARGIN = 16.0  # [mm]
_PADDING = 6.0  # [pt] of reportlab's frames
_LISTED = 100  # letters of a line of a listing
_WHOLE = 16  # rows of a table that stay on one page


def pdf_pages(title: str, lead: str, sections: Sequence[Section]) -> bytes:
    """Return the pages. Raises ImportError without reportlab."""
    try:
        from reportlab.lib.pagesizes import A4
        from reportlab.lib.units import mm
        from reportlab.platypus import KeepTogether, Paragraph, SimpleDocTemplate, Spacer
    except ImportError:
        raise ImportError(_MISSING) from None
    look = _Look()
    out = io.BytesIO()
    document = SimpleDocTemplate(
        out,
        pagesize=A4,
        leftMargin=_MARGIN * mm,
        rightMargin=_MARGIN * mm,
        topMargin=_MARGIN * mm,
        bottomMargin=1.2 * _MARGIN * mm,
        title=title,
        author="Ropewalk",
        subject=lead,
    )
    story: list[Any] = [
        Paragraph(escape(title), look.style("title")),
        Paragraph(escape(lead), look.style("note")),
    ]
    for one in sections:
        held: list[Any] = [Paragraph(escape(one.title), look.style("head"))]
        for number, item in enumerate(one.items):
            held += [*look.flow(item, document.width - 2.0 * _PADDING), Spacer(1, 2.0 * mm)]
            after = one.items[number + 1] if number + 1 < len(one.items) else None
            if isinstance(item, Text) and isinstance(after, Table):
                continue  # what leads to a table stays with it
            story += [KeepTogether(held)] if _is_whole(item) else held
            held = []
        story += held
    foot = _footer(title)
    document.build(story, onFirstPage=foot, onLaterPages=foot)
    return out.getvalue()


def _footer(title: str) -> Any:
    """Return what writes title and page number at the foot of every page."""

    def write(canvas: Any, document: Any) -> None:
        canvas.saveState()
        canvas.setFont("Sheet", 7.5)
        canvas.setFillColor(_SOFT)
        canvas.drawString(document.leftMargin + _PADDING, 26.0, title[:90])
        right = document.pagesize[0] - document.rightMargin - _PADDING
        canvas.drawRightString(right, 26.0, f"page {document.page}")
        canvas.restoreState()

    return write


class _Look:
    """Fonts and styles; every kind of item as reportlab's flowables."""

    def __init__(self) -> None:
        import matplotlib
        from reportlab.lib.fonts import addMapping
        from reportlab.pdfbase import pdfmetrics
        from reportlab.pdfbase.ttfonts import TTFont

        folder = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
        for name, file in (
            ("Sheet", "DejaVuSans.ttf"),
            ("Sheet-Bold", "DejaVuSans-Bold.ttf"),
            ("Sheet-Mono", "DejaVuSansMono.ttf"),
        ):
            pdfmetrics.registerFont(TTFont(name, folder / file))
        addMapping("Sheet", 1, 0, "Sheet-Bold")

    def style(self, kind: str) -> Any:
        """Return the style of a paragraph."""
        from reportlab.lib.styles import ParagraphStyle

        size = {"title": 16.0, "head": 11.5, "text": 8.6, "cell": 7.8, "right": 7.8, "note": 7.4}
        points = size.get(kind, 8.6)
        more: dict[str, Any] = {}
        if kind in ("title", "head"):
            more = {
                "fontName": "Sheet-Bold",
                "spaceBefore": 9.0,
                "spaceAfter": 4.0,
                "keepWithNext": 1,
            }
        elif kind == "note":
            more = {"textColor": _SOFT}
        elif kind == "right":
            more = {"alignment": 2}
        elif kind == "warning":
            more = {
                "textColor": _WARN,
                "backColor": _BACK,
                "borderPadding": 4.0,
                "fontName": "Sheet-Bold",
            }
        options = {"fontName": "Sheet", "textColor": _INK} | more
        return ParagraphStyle(kind, fontSize=points, leading=1.35 * points, **options)

    def flow(self, item: Item, width: float) -> list[Any]:
        """Return the flowables of an item; `width` is that of the page's text [pt]."""
        from reportlab.platypus import Image, Paragraph, Preformatted

        match item:
            case Text():
                kind = "warning" if item.warning else "text"
                return [Paragraph(escape(item.words), self.style(kind))]
            case Picture():
                share = min(width / (72.0 * item.width), 1.0)
                size = (72.0 * share * item.width, 72.0 * share * item.height)
                return [Image(io.BytesIO(item.png), *size)]
            case Listing():
                style = self.style("note").clone("listing", fontName="Sheet-Mono", fontSize=6.6)
                lines, note = on_paper(item.lines, _LISTED)
                said = [Paragraph(escape(note), self.style("note"))] if note else []
                return [*said, Preformatted(lines, style, maxLineLength=_LISTED)]
            case Table():
                return self._table(item, width)

    def _table(self, table: Table, width: float) -> list[Any]:
        from reportlab.platypus import Paragraph, TableStyle
        from reportlab.platypus import Table as Grid

        rows = [*([table.head] if any(table.head) else []), *table.rows]
        cells = [
            [
                Paragraph(escape(cell), self.style("right" if table.numbers and k else "cell"))
                for k, cell in enumerate(row)
            ]
            for row in rows
        ]
        look = [
            ("LINEBELOW", (0, 0), (-1, -1), 0.4, _LINE),
            ("VALIGN", (0, 0), (-1, -1), "TOP"),
            ("LEFTPADDING", (0, 0), (0, -1), 0),
            ("TOPPADDING", (0, 0), (-1, -1), 1.6),
            ("BOTTOMPADDING", (0, 0), (-1, -1), 1.8),
        ]
        repeat = 1 if any(table.head) else 0
        grid = Grid(
            cells,
            colWidths=_widths(rows, width),
            style=TableStyle(look),
            repeatRows=repeat,
            hAlign="LEFT",
        )
        note = [Paragraph(escape(table.note), self.style("note"))] if table.note else []
        return [grid, *note]


def _is_whole(item: Item) -> bool:
    """Tell whether an item stays on one page, with its heading."""
    return not isinstance(item, Listing) and not (
        isinstance(item, Table) and len(item.rows) > _WHOLE
    )


def _widths(rows: Sequence[Sequence[str]], width: float) -> list[float]:
    """Share the width by what the columns hold: by the longest cell, long ones counting less [pt]."""
    columns = list(zip(*rows, strict=True))
    weights = [min(max(max(map(len, column)), 4), 44) + 2.0 for column in columns]
    return [width * weight / sum(weights) for weight in weights]
