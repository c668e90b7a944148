"""Pages of a sheet in PDF: no heading, and no sentence that leads to a table, ends one."""

from __future__ import annotations

from typing import Any

import pytest

from ropewalk.sheets.content import Section, Table, Text
from ropewalk.sheets.pdf import pdf_pages


def test_a_table_stays_on_one_page_with_what_leads_to_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """Above it are 20 to 60 lines: at some the page ends between any two of its rows."""
    paragraph = pytest.importorskip("reportlab.platypus").Paragraph
    draw, pages = paragraph.draw, dict[str, int]()

    def drawn(self: Any) -> None:
        pages[self.getPlainText()] = self.canv.getPageNumber()
        draw(self)

    monkeypatch.setattr(paragraph, "draw", drawn)
    ends = set()
    for lines in range(20, 60):
        above = Section("above", tuple(Text(f"line {k}") for k in range(lines)))
        table = Table(("head", "value"), [(f"row {k}", "1") for k in range(8)])
        pages.clear()
        pdf_pages("title", "lead", [above, Section("heading", (Text("leads to it"), table))])
        told = {pages[text] for text in ("heading", "leads to it", "head", "row 0", "row 7")}
        assert len(told) == 1, lines
        ends |= told
    assert ends == {1, 2}
