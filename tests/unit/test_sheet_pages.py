"""Pages of a sheet in PDF: no heading, and no sentence that leads to a table, ends one."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest

from ropewalk.sheets.content import Listing, Section, Table, Text
from ropewalk.sheets.paper import on_paper
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


LONG = [
    "start = [" + ", ".join(f"{k / 7}" for k in range(30)) + "]",
    "    [" + ", ".join(f"{k / 7}" for k in range(9)) + "],",
    'note = "' + 'back\\\\slash, \\"quoted\\", two  spaces ' * 9 + '"',
    '    "' + "an entry of an array " * 8 + '",',
]


def test_a_scene_on_paper_is_the_scene_yet(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines of more than 100 letters were cut hard, and a sheet's scene could not be computed again."""
    first, row, note, entry = LONG
    text = "\n".join((first, note, "rows = [", row, row, "]", "texts = [", entry, entry, "]", ""))
    broken, said = on_paper(text, 100)
    assert tomllib.loads(broken) == tomllib.loads(text)
    assert max(map(len, broken.split("\n"))) <= 100
    assert "the scene is the same" in said
    assert on_paper(broken, 100) == (broken, "")
    kept = f'path = "{"x" * 120}"\n'
    assert "is not the scene" in on_paper(kept, 100)[1]

    listed = pytest.importorskip("reportlab.platypus").Preformatted
    shown = list[str]()
    wrap = listed.wrap

    def seen(self: Any, *room: float) -> Any:
        shown[:] = self.lines
        return wrap(self, *room)

    monkeypatch.setattr(listed, "wrap", seen)
    pdf_pages("title", "lead", [Section("again", (Listing(text),))])
    assert tomllib.loads("\n".join(shown)) == tomllib.loads(text)


def test_arrays_of_texts_are_broken_after_their_commas() -> None:
    """A line with texts in an array was cut anywhere."""
    names = ", ".join(f'"part {k}, {{of}} [many]"' for k in range(20))
    places = ", ".join(f"[0.0, 0.0, {k}.5]" for k in range(20))
    table = f'motion = {{ kind = "table", positions = [{places}] }}'
    text = "\n".join((f"keep = [{names}]", table, ""))
    broken, said = on_paper(text, 100)
    assert tomllib.loads(broken) == tomllib.loads(text)
    assert max(map(len, broken.split("\n"))) <= 100
    assert "the scene is the same" in said
    many = "{ " + ", ".join(f"key{k} = {k}" for k in range(30)) + " }"
    kept = f"at = {many}\n"
    assert on_paper(kept, 100)[0] == kept
